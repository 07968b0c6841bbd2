// The GLSL of single terms: see vtkBRDFShaderText.h.
#include "vtkBRDFShaderText.h"

#include <regex>

namespace
{
// ", brdfParameter3, brdfParameter4": arguments after the directions.
std::string Arguments(std::size_t count, std::size_t first)
{
  std::string text;
  for (std::size_t i = 0; i < count; ++i)
  {
    text += ", brdfParameter" + std::to_string(first + i);
  }
  return text;
}

// Each line once for every sample of a turn, whose number stands for #: on processors a sample is one long chain of
// dependent operations, and chains side by side overlap.
std::string SideBySide(const std::vector<std::string>& lines, int together)
{
  std::string text;
  for (const std::string& line : lines)
  {
    for (int k = 0; k < together; ++k)
    {
      text += "    " + std::regex_replace(line, std::regex("#"), std::to_string(k));
    }
  }
  return text;
}
}

// The functions of one term: value and, where they are wanted, draw and density.
std::string vtkBRDFShaderText::TermText(std::size_t index, bool draws) const
{
  const Term& term = this->Terms[index];
  const std::string name = "brdfTerm" + std::to_string(index);
  std::string text, arguments;
  if (term.Model)
  {
    arguments = Arguments(term.Model->parameters().size(), term.Offset) + ");\n}\n";
    text = "float " + name + "_shape(vec3 wi, vec3 wo)\n{\n  return brdf_" + term.Model->name() + "(wi, wo" + arguments;
  }
  else
  {
    text = "vec3 " + name + "_shape(vec3 wi, vec3 wo)\n{\n  return brdfTable(wi, wo);\n}\n";
  }
  text += "vec3 " + name + "_value(vec3 wi, vec3 wo)\n{\n  return brdfScales[" + std::to_string(index) + "] * " + name +
          "_shape(wi, wo);\n}\n";
  if (!draws)
  {
    return text;
  }
  if (term.Sampler >= 0)
  {
    return text + this->SamplerText(index);
  }
  const std::string model = "brdf_" + term.Model->name();
  return text + "vec3 " + name + "_sample(vec3 wo, vec2 u)\n{\n  return " + model + "_sample(wo, u" + arguments +
         "float " + name + "_pdf(vec3 wi, vec3 wo)\n{\n  return " + model + "_pdf(wi, wo" + arguments;
}

// Draw and density by importance tables: NAME_draw and NAME_density for a viewer at hand, and the two that every term
// has.
std::string vtkBRDFShaderText::SamplerText(std::size_t index) const
{
  using Kind = brdf::TabulatedSampler::Kind;
  const int number = this->Terms[index].Sampler;
  const auto& [kind, turning, search] = this->Samplers[static_cast<std::size_t>(number)];
  const std::string first = kind == Kind::Light ? "Light" : "Half";
  const std::string draw = kind == Kind::HalfAndRetro ? "part == 2 ? brdfFromRetro(v, point) : brdfFromHalf(v, point)"
                                                      : "brdfFrom" + first + "(v, point)";
  const std::string retro =
    kind == Kind::HalfAndRetro ? "    density += brdfChartDensity(S, v, TURNING, 1, brdfToRetro(v, wi));\n" : "";
  // By warps: the solid angle that a draw stands for.
  const bool two = kind == Kind::HalfAndRetro;
  std::string passes = "  vec3 wi = brdfFrom" + first + "(w.viewer, at.xy);\n";
  if (two)
  {
    passes =
      "  vec3 wi = retro ? brdfFromRetro(w.viewer, at.xy) : brdfFromHalf(w.viewer, at.xy);\n"
      "  float part = brdfHalfPart(wi, w.viewer.wo);\n"
      "  solid = at.z * (retro ? (1.0 - part) / (1.0 - share) : 2.0 * length(wi + w.viewer.wo) * part / share);\n";
  }
  else
  {
    passes += kind == Kind::Half ? "  solid = 2.0 * at.z * length(wi + w.viewer.wo);\n" : "  solid = at.z;\n";
  }
  std::string text =
    "brdfSampler S = brdfSampler(brdfSamplerShapes[A], brdfSamplerShapes[B], brdfSamplerShapes[C], "
    "D, E);\n"
    "vec3 NAME_draw(brdfViewer v, vec2 u)\n"
    "{\n"
    "  ivec3 table;\n"
    "  int part = brdfPart(v, TURNING, u.x, table);\n"
    "  vec2 point = brdfTableDraw(table, S.search, u);\n"
    "  vec3 wi = part == 0 ? brdfCosineDraw(u) : " +
    draw +
    ";\n"
    "  return wi.z > 0.0 && v.wo.z > 0.0 ? wi : vec3(0.0);\n"
    "}\n"
    "brdfWarpViewer NAME_warps(vec3 wo)\n{\n  return brdfWarpViewerOf(S, wo, TURNING, CHARTS);\n}\n"
    "vec3 NAME_warped(brdfWarpViewer w, vec2 u, out float solid)\n"
    "{\n"
    "  float share;\n"
    "  int number = brdfWarpNeighbour(w, TURNING, u.x, share);\n" +
    std::string(two ? "  bool retro = u.x >= share;\n"
                      "  u.x = clamp(retro ? (u.x - share) / (1.0 - share) : u.x / share, 0.0, 0.99999994);\n"
                      "  number = 2 * number + (retro ? 1 : 0);\n"
                    : "") +
    "  vec3 at = brdfWarped(S, number, u);\n" + passes +
    "  return wi.z > 0.0 && w.viewer.wo.z > 0.0 ? wi : vec3(0.0);\n"
    "}\n"
    "float NAME_density(brdfViewer v, vec3 wi)\n"
    "{\n"
    "  float density = brdfCosineDensity(v, TURNING, wi);\n"
    "  density += brdfChartDensity(S, v, TURNING, 0, brdfTo" +
    first + "(v, wi));\n" + retro +
    "  return wi.z > 0.0 && v.wo.z > 0.0 ? density : 0.0;\n"
    "}\n"
    "vec3 NAME_sample(vec3 wo, vec2 u)\n{\n  return NAME_draw(brdfViewerOf(S, wo, TURNING), u);\n}\n"
    "float NAME_pdf(vec3 wi, vec3 wo)\n{\n  return NAME_density(brdfViewerOf(S, wo, TURNING), wi);\n}\n";
  const std::pair<const char*, std::string> names[] = { { "NAME", "brdfTerm" + std::to_string(index) },
                                                        { "TURNING", turning ? "true" : "false" },
                                                        { "\\bS\\b", "brdfSampler" + std::to_string(number) },
                                                        { "CHARTS", two ? "true" : "false" },
                                                        { "\\bA\\b", std::to_string(4 * number) },
                                                        { "\\bB\\b", std::to_string(4 * number + 1) },
                                                        { "\\bC\\b", std::to_string(4 * number + 2) },
                                                        { "\\bE\\b",
                                                          "brdfSamplerShapes[" + std::to_string(4 * number + 3) + "]" },
                                                        { "\\bD\\b", std::to_string(search) } };
  for (const auto& [from, to] : names)
  {
    text = std::regex_replace(text, std::regex(from), to);
  }
  return text;
}

// Environment light on one term by filtered importance sampling, without its scale.
std::string vtkBRDFShaderText::ReflectedText(std::size_t index) const
{
  const Term& term = this->Terms[index];
  const bool tables = term.Sampler >= 0;
  const int together = tables ? 4 : 3;
  const std::string name = "brdfTerm" + std::to_string(index);
  const std::string type = term.Model ? "float" : "vec3";
  std::string text = "vec3 " + name +
                     "_reflected(vec3 wo, mat3 frame, uvec2 shift, int samples)\n"
                     "{\n"
                     "  vec3 sum = vec3(0.0);\n"
                     "  float share = 1.0 / float(max(samples, 1));\n";
  if (tables)
  {
    text += "  brdfWarpViewer viewer = " + name + "_warps(wo);\n";
  }
  text += "  for (int i = 0; i < samples; i += " + std::to_string(together) + ")\n  {\n";
  const std::vector<std::string> lines = {
    tables ? "float solid#;\n    vec3 wi# = " + name + "_warped(viewer, brdfPoint(i + #, share, shift), solid#);\n"
           : "vec3 wi# = " + name + "_sample(wo, brdfPoint(i + #, share, shift));\n",
    tables ? "" : "float density# = " + name + "_pdf(wi#, wo);\n",
    tables ? "float inverse# = share * solid#;\n" : "float inverse# = share / density#;\n",
    type + " weight# = " +
      (term.Model ? name + "_shape(wi#, wo)"
                  : std::string("(brdfTable_drawn(wi#, wo, brdfFour(i + #, shift)) - brdfTableBase)")) +
      " * (wi#.z * inverse#);\n",
    std::string("bool counts# = i + # < samples && wi#.z > 0.0") + (tables ? "" : " && density# > 0.0") + ";\n",
    "vec3 light# = brdfRadiance(frame * wi#, inverse#);\n",
    "sum += counts# ? light# * weight# : vec3(0.0);\n"
  };
  text += SideBySide(lines, together);
  // Light on the constant that the samples leave out; where the table is below it a bright lamp drawn too often would
  // leave less than nothing.
  return text + "  }\n  return " +
         (term.Model ? "sum" : "max(sum + 3.14159265 * brdfTableBase * brdfDiffuse(frame[2]), 0.0)") + ";\n}\n";
}

// The same by draws made in advance.
std::string vtkBRDFShaderText::DrawnText(std::size_t index) const
{
  constexpr int together = 4;
  const Term& term = this->Terms[index];
  const bool table = !term.Model;
  const bool coloured = table && this->Table.base.size() > 1;
  const std::string name = "brdfTerm" + std::to_string(index), shape = "brdfDrawShapes[" + std::to_string(2 * index);
  std::string text = "vec3 " + name +
                     "_reflected(vec3 wo, mat3 frame, uvec2 shift, int samples)\n"
                     "{\n"
                     "  vec3 sum = vec3(0.0);\n"
                     "  float share = 1.0 / float(max(samples, 1));\n"
                     "  brdfDrawer drawer = brdfDrawerOf(wo, frame, shift, " +
                     shape + "], (samples + 3) / 4 * 4, " + shape + " + 1], " + (table ? "false" : "true") +
                     ");\n  for (int i = 0; i < samples; i += " + std::to_string(together) + ")\n  {\n";
  const std::vector<std::string> lines = {
    "uvec4 draw# = brdfDrawAt(drawer, i + #);\n",
    "bool above#;\n    vec3 wi# = brdfDrawnLight(drawer, i + #, draw#, above#);\n",
    "vec3 light# = brdfRadiance(wi#, share * abs(uintBitsToFloat(draw#.w)));\n",
    coloured ? "sum += above# ? light# * brdfDrawnWeights(draw#.z) : vec3(0.0);\n"
             : "sum += light# * (above# ? uintBitsToFloat(draw#.z) : 0.0);\n"
  };
  text += SideBySide(lines, together);
  text += "  }\n  sum *= share" +
          (coloured ? " * brdfDrawUnits[" + std::to_string(index) + "] / 8388608.0" : std::string()) + ";\n  return ";
  return text + (table ? "max(sum + 3.14159265 * brdfTableBase * brdfDiffuse(frame[2]), 0.0)" : "sum") + ";\n}\n";
}
