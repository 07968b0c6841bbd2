#pragma once
#include <brdf/simulate/SurfaceKinds.h>

#include <string>
#include <vector>

namespace brdf {

/// Of this folder, each in the file of its name.
SurfaceKind flatSurface();
SurfaceKind groovedSurface();

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
