#include <brdf/base/Error.h>
#include <brdf/base/Parallel.h>
#include <brdf/formula/GlslPrinter.h>
#include <brdf/formula/Parser.h>
#include <brdf/material/GridLocator.h>
#include <brdf/material/GridShader.h>

#include <algorithm>
#include <bit>
#include <cstdio>

namespace brdf {
namespace {

std::string literal(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9e", static_cast<double>(static_cast<float>(value)));
  return text;
}

/// Where axis `a` puts a pair: its cell below, what leads to the next, and the weight of that.
std::string placeText(const GridLocator::Axis& axis, std::size_t a, const std::string& cells, std::size_t points) {
  const std::string n = std::to_string(a), x = "x" + n, position = "position" + n, cell = "cell" + n;
  const std::size_t last = axis.points.size() - 1;
  std::string text;
  if (axis.bounded)
    text += "  inside = inside && " + x + " >= " + literal(axis.low) + " && " + x + " <= " + literal(axis.high) + ";\n";
  if (axis.uniform) {
    text += "  float " + position + " = (" + x + " - " + literal(axis.origin) + ") * " + literal(axis.inverseStep) +
            ";\n  " + position + " = " + position + " > 0.0 ? min(" + position + ", " + literal(double(last)) +
            ") : 0.0;\n  int " + cell + " = min(int(" + position + "), " + std::to_string(last - 1) +
            ");\n  float weight" + n + " = " + position + " - float(" + cell + ");\n";
  } else {
    // Binary search for the last point not above, written out.
    const std::string start = std::to_string(points);
    text += "  int " + cell + " = 0;\n";
    for (std::size_t step = std::bit_floor(last); step > 0; step /= 2) {
      const std::string next = cell + " + " + std::to_string(step);
      text += "  " + cell + " = " + next + " < " + std::to_string(last) + " && texelFetch(" + cells + ", " + start +
              " + min(" + next + ", " + std::to_string(last) + ")).x <= " + x + " ? " + next + " : " + cell + ";\n";
    }
    text += "  vec2 between" + n + " = texelFetch(" + cells + ", " + start + " + " + cell + ").xy;\n  float weight" +
            n + " = (" + x + " - between" + n + ".x) / (between" + n + ".y - between" + n + ".x);\n  weight" + n +
            " = weight" + n + " > 0.0 ? min(weight" + n + ", 1.0) : 0.0;\n";
  }
  // Past the last cell, where the axis is periodic, comes the first.
  const auto lastCell = static_cast<long>(axis.count) - 1, stride = static_cast<long>(axis.stride);
  text += "  cell += " + cell + " * " + std::to_string(stride) + ";\n";
  text += "  int step" + n + " = " +
          (last - 1 < axis.count - 1 ? std::to_string(stride)
                                     : cell + " == " + std::to_string(lastCell) + " ? " +
                                           std::to_string(-lastCell * stride) + " : " + std::to_string(stride)) +
          ";\n";
  return text;
}

/// With angles to 1e-5: a drawn cell need not be exact to the last digit of its weight.
std::string coarse(std::string text) {
  const std::string exact = "brdf_atan2(", quick = "brdf_atan2Coarse(";
  for (std::size_t at = text.find(exact); at != std::string::npos; at = text.find(exact, at + quick.size()))
    text.replace(at, exact.size(), quick);
  return text;
}

/// The interpolant over the first `dimensions` axes of the corners at `offset`, one axis after the other.
std::string interpolantText(const std::string& cells, std::size_t dimensions, const std::string& offset) {
  if (dimensions == 0) return "texelFetch(" + cells + ", cell" + offset + ")";
  const std::string n = std::to_string(dimensions - 1);
  return "mix(" + interpolantText(cells, dimensions - 1, offset) + ", " +
         interpolantText(cells, dimensions - 1, offset + " + step" + n) + ", weight" + n + ")";
}

}  // namespace

std::size_t gridShaderTexels(const GridLayout& layout) {
  std::size_t count = layout.cells();
  for (const GridAxis& axis : layout.axes) count += axis.size() + 2;  // enough for points that lead around
  return count;
}

GridShader gridShader(const GridBrdf& grid, std::string_view nameView) {
  const GridData& data = grid.data();
  if (data.channels.kind == Channels::Kind::Spectral)
    throw Error(Error::Kind::Value, {"a table of spectra has no shader", grid.description(),
                                     std::to_string(data.channels.count()) + " wavelengths", "monochrome, RGB"});
  const std::string name(nameView), cells = name + "_cells";
  const bool nearest = grid.lookup() == GridBrdf::Lookup::Nearest;
  const GridLocator locator(grid.layout(), nearest);
  const std::size_t count = data.layout.cells(), channels = data.channels.count();

  GridShader shader;
  shader.texels.resize(4 * count);
  parallelFor(count, 65536, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      for (std::size_t k = 0; k < 4; ++k) {
        const double value = k == 3 ? 1 : data.values[(channels == 1 ? 0 : k) * count + i];
        shader.texels[4 * i + k] = data.states[i] ? static_cast<float>(value) : 0.0f;
      }
  });

  formula::Graph graph;
  formula::ParseOptions options;
  options.where = "coordinates of a grid";
  const std::vector<GridLocator::Axis>& axes = locator.axes();
  std::vector<formula::NodeId> outputs;
  if (!axes.empty()) {
    const formula::ParseResult parsed = formula::parse(graph, locator.coordinates(), options);
    for (std::size_t a = 0; a < axes.size(); ++a)
      outputs.push_back(parsed.variables.at("coordinate_" + std::to_string(a)));
  }
  const formula::GlslBody body = formula::printGlsl(graph, outputs, {});
  // Where the pair lies; the two functions differ in what they make of it.
  std::string place = body.statements + "  bool inside = wi.z > 0.0 && wo.z > 0.0;\n  int cell = 0;\n", choice;
  for (std::size_t a = 0; a < axes.size(); ++a) {
    const std::string n = std::to_string(a);
    place += "  float x" + n + " = " + body.outputs[a] + ";\n" + placeText(axes[a], a, cells, shader.texels.size() / 4);
    if (!nearest) choice += "  cell += u." + std::string(1, "xyzw"[a]) + " < weight" + n + " ? step" + n + " : 0;\n";
    if (axes[a].uniform) continue;
    for (std::size_t i = 0; i < axes[a].points.size(); ++i)
      for (const std::size_t at : {i, std::min(i + 1, axes[a].points.size() - 1), i, i})
        shader.texels.push_back(static_cast<float>(axes[a].points[at]));
  }
  std::string text = "uniform samplerBuffer " + cells + ";\n" + body.functions + "vec3 " + name +
                     "(vec3 wi, vec3 wo)\n{\n" + place +
                     "  vec4 sum = " + interpolantText(cells, nearest ? 0 : axes.size(), "") + ";\n" +
                     "  return inside && sum.a > 0.0 ? sum.rgb / sum.a : vec3(0.0);\n}\n";
  text += "vec3 " + name + "_drawn(vec3 wi, vec3 wo, vec4 u)\n{\n" + coarse(place) + choice +
          "  return inside ? texelFetch(" + cells + ", cell).rgb : vec3(0.0);\n}\n";
  shader.glsl = std::move(text);
  return shader;
}

}  // namespace brdf
