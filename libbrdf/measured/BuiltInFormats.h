#pragma once
#include <brdf/measured/Format.h>

namespace brdf {

// The formats that ship, one function a file; Format.cpp lists them.
Format merlFormat();             ///< MerlFormat.cpp
Format cornellFormat();          ///< CornellFormat.cpp
Format csvFormat();              ///< CsvFormat.cpp
Format utiaFormat();             ///< UtiaFormat.cpp
Format utiaExrFormat();          ///< UtiaFormat.cpp
Format csailFormat();            ///< CsailFormat.cpp
Format carPaintFormat();         ///< CarPaintFormat.cpp
Format altaFormat();             ///< AltaFormat.cpp
Format altaBinaryFormat();       ///< AltaFormat.cpp
Format astmFormat();             ///< AstmFormat.cpp
Format pabFormat();              ///< PabFormat.cpp
Format birdFormat();             ///< BirdFormat.cpp
Format brdfLabTextFormat();      ///< BrdfLabText.cpp
Format brdfLabExportFormat();    ///< BrdfLabText.cpp
Format integraFormat();          ///< IntegraFormat.cpp
Format integraSpecularFormat();  ///< IntegraFormat.cpp
Format lightToolsFormat();       ///< LightToolsFormat.cpp
Format zemaxFormat();            ///< ZemaxFormat.cpp
Format ssddFormat();             ///< SsddFormat.cpp
Format rglFormat();              ///< RglFormat.cpp
Format kaistFormat();            ///< RglFormat.cpp
Format radianceFormat();         ///< RadianceFormat.cpp
Format radianceKlemsFormat();    ///< RadianceFormat.cpp: for writing
Format radianceTreeFormat();     ///< RadianceFormat.cpp: for writing

}  // namespace brdf
