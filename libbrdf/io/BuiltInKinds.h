#pragma once
#include <brdf/io/LoadMaterial.h>

namespace brdf {

// The kinds of materials that ship; LoadMaterial.cpp lists them. Those that simulate stand in simulate/, which may use
// io: no more than these names goes the other way.
MaterialKind programKind();  ///< simulate/external/ProgramBrdf.cpp
MaterialKind waveKind();     ///< simulate/wave/WaveModels.cpp

}  // namespace brdf
