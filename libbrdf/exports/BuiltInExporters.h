#pragma once
#include <brdf/exports/Exporter.h>

namespace brdf {

// The exporters that ship, one function a file; Exporter.cpp lists them.
Exporter glslExporter();  ///< GlslExporter.cpp

}  // namespace brdf
