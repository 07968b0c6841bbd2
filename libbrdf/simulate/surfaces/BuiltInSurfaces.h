#pragma once
#include <brdf/simulate/SurfaceKinds.h>

#include <string>
#include <vector>

namespace brdf {

/// The kinds of this folder.
SurfaceKind flatSurface();
SurfaceKind groovedSurface();
SurfaceKind lamellarSurface();  // Gratings.cpp
SurfaceKind sinusoidalSurface();
SurfaceKind blazedSurface();
SurfaceKind gaussianSurface();  // RandomSurface.cpp
SurfaceKind exponentialSurface();
SurfaceKind spectrumSurface();
SurfaceKind brushedSurface();  // Scratches.cpp
SurfaceKind scratchedSurface();
SurfaceKind triangleSurface();
SurfaceKind heightFieldSurface();  // FileSurfaces.cpp
SurfaceKind meshSurface();
SurfaceKind sphereSurface();

std::vector<SurfaceKind> builtInSurfaceKinds();

/// Largest height field that is generated: 64 MiB of heights.
constexpr std::size_t kMaximumGeneratedNodes = std::size_t{1} << 24;

/// Records of parameters that several kinds have.
Parameter lengthParameter(std::string name, std::string label, double defaultValue, std::string description,
                          double minimum = 1e-6, double maximum = 1e6);
Parameter angleParameter(std::string name, std::string label, double defaultValue, double minimum, double maximum,
                         std::string description);
Parameter numberParameter(std::string name, std::string label, double defaultValue, double minimum, double maximum,
                          std::string description);
Parameter seedParameter();

}  // namespace brdf
