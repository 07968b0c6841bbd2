#pragma once
#include <brdf/exports/Exporter.h>

namespace brdf {

// The exporters that ship, one function a file; Exporter.cpp lists them.
Exporter glslExporter();             ///< GlslExporter.cpp
Exporter gltfExporter();             ///< GltfExporter.cpp
Exporter materialXExporter();        ///< MaterialXExporter.cpp
Exporter mitsubaExporter();          ///< MitsubaExporter.cpp
Exporter openPbrExporter();          ///< OpenPbrExporter.cpp
Exporter oslExporter();              ///< OslExporter.cpp
Exporter pbrtExporter();             ///< PbrtExporter.cpp
Exporter standardSurfaceExporter();  ///< StandardSurfaceExporter.cpp

}  // namespace brdf
