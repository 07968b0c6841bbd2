#pragma once
#include <brdf/brdf_export.h>
#include <brdf/material/GridBrdf.h>

#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// The look-up of a grid as GLSL 3.30 core, the same as GridBrdf::evaluate in float: its coordinates are printed from
/// the formula that the processor runs.
struct GridShader {
  /// vec3 NAME(vec3 wi, vec3 wo): f_r by channel (monochrome grids: three times the same), 1/sr; 0 below the horizon
  /// and where no cell is valid. Reads the samplerBuffer NAME_cells, which it declares; needs formula::glslPrelude().
  /// vec3 NAME_drawn(vec3 wi, vec3 wo, vec4 u): of the cells that the look-up interpolates one, drawn by four numbers in
  /// [0, 1) with its weight: the mean over u is NAME, but that invalid cells count as 0. One fetch instead of up to 16.
  /// The text depends on the layout and the kind of look-up alone.
  std::string glsl;
  /// Texels of NAME_cells, four floats each: for every cell its channels and 1, or 0 four times where it is invalid;
  /// then the points of axes that are not equally spaced.
  std::vector<float> texels;
};

/// Texels that gridShader() makes of a grid of this layout, without making them.
BRDF_EXPORT std::size_t gridShaderTexels(const GridLayout& layout);

/// Throws Error::Kind::Value for other channels than monochrome and RGB.
BRDF_EXPORT GridShader gridShader(const GridBrdf& grid, std::string_view name);

}  // namespace brdf
