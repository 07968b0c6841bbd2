#include "vtkBRDFShaderText.h"

#include "brdfShaders.h"

#include <brdf/base/Error.h>
#include <brdf/material/GridShader.h>
#include <brdf/sampling/PolarWarp.h>

#include <algorithm>
#include <cmath>
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
}

vtkBRDFShaderText::vtkBRDFShaderText(const brdf::LobeSum& material, const vtkBRDFShaderText* before)
{
  const brdf::Channels& channels = material.channels();
  if (channels.kind == brdf::Channels::Kind::Spectral)
  {
    throw brdf::Error(
      brdf::Error::Kind::Value,
      { "a spectral material whose parameters depend on the wavelength, or with a colour outside sRGB, cannot be drawn",
        {},
        std::to_string(channels.count()) + " wavelengths",
        "monochrome, RGB" });
  }
  const auto& lobes = material.lobes();
  for (std::size_t index = 0; index < lobes.size(); ++index)
  {
    const brdf::Lobe& lobe = lobes[index];
    if (std::find(this->Models.begin(), this->Models.end(), lobe.model) == this->Models.end())
    {
      this->Models.push_back(lobe.model);
    }
    const bool shared = lobe.channelIndependent() || channels.count() == 1;
    const std::size_t terms = shared ? 1 : channels.count();
    for (std::size_t term = 0; term < terms; ++term)
    {
      this->Terms.push_back({ lobe.model.get(),
                              this->ParameterValues.size(),
                              material.samplingWeights()[index] / static_cast<double>(terms) });
      if (!lobe.model->namesSampler() && !lobe.model->constant())
      {
        this->Terms.back().Sampler = this->AddSamplerOf(lobe, term, before);
      }
      const auto& values = lobe.parametersOf(term);
      for (std::size_t k = 0; k < values.size(); ++k)
      {
        this->ParameterValues.push_back(lobe.model->parameters()[k].shaderValue(values[k]));
      }
      for (std::size_t channel = 0; channel < 3; ++channel)
      {
        const double scale = lobe.scaleOf(channels.count() == 1 ? 0 : channel);
        this->ScaleValues.push_back(shared || channel == term ? static_cast<float>(scale) : 0.0f);
      }
      this->StructureText += lobe.model->name() + "\n";
    }
  }
}

vtkBRDFShaderText::vtkBRDFShaderText(const brdf::DrawnTable& table, const brdf::TabulatedSampler& sampler)
{
  brdf::GridShader shader = brdf::gridShader(*table.grid, "brdfTable");
  this->TableText = std::move(shader.glsl);
  this->StructureText = this->TableText;
  this->BufferValues.push_back({ "brdfTable_cells", std::move(shader.texels) });
  double base = 0;
  for (const double value : table.base)
  {
    base += value / static_cast<double>(table.base.size());
  }
  this->Terms.push_back({ nullptr, 0, 1.0, this->AddSampler(sampler, true, base) });
  this->ScaleValues = { 1.0f, 1.0f, 1.0f };
  for (std::size_t channel = 0; channel < 3; ++channel)
  {
    this->TableBaseValues[channel] = static_cast<float>(table.base.at(table.base.size() == 1 ? 0 : channel));
  }
}

// Takes the importance tables of a term; their number. Where they are not final, the structure leaves room for larger
// ones.
int vtkBRDFShaderText::AddSampler(const brdf::TabulatedSampler& sampler, bool final, double base)
{
  const brdf::TabulatedSampler::Texels texels = sampler.texels();
  const auto found = std::find_if(this->BufferValues.begin(),
                                  this->BufferValues.end(),
                                  [](const Buffer& buffer) { return buffer.Name == "brdfSamplers"; });
  Buffer& buffer =
    found == this->BufferValues.end() ? this->BufferValues.emplace_back(Buffer{ "brdfSamplers", {} }) : *found;
  const int first = static_cast<int>(buffer.Texels.size() / 4);
  buffer.Texels.insert(buffer.Texels.end(), texels.numbers.begin(), texels.numbers.end());
  this->SamplerShapeValues.insert(this->SamplerShapeValues.end(),
                                  { first, texels.thetas, texels.phis, static_cast<int>(buffer.Texels.size() / 4) });
  const brdf::TabulatedSampler::Warps warps = sampler.warps(base);
  buffer.Texels.insert(buffer.Texels.end(), warps.shares.begin(), warps.shares.end());
  buffer.Texels.insert(buffer.Texels.end(), warps.texels.begin(), warps.texels.end());
  this->Samplers.push_back({ texels.kind, texels.turning, final ? texels.search : 128 });
  this->StructureText += std::string(brdf::name(texels.kind)) + (texels.turning ? ", turning, " : ", ") +
                         std::to_string(this->Samplers.back().Search) + "\n";
  return static_cast<int>(this->Samplers.size()) - 1;
}

// Importance tables of a lobe at one channel's parameters.
int vtkBRDFShaderText::AddSamplerOf(const brdf::Lobe& lobe, std::size_t channel, const vtkBRDFShaderText* before)
{
  brdf::Lobe alone{ lobe.model, {}, { 1.0 } };
  for (const double value : lobe.parametersOf(channel))
  {
    alone.parameters.push_back({ value });
  }
  const brdf::LobeSum shape({ alone }, brdf::Channels::monochrome());
  brdf::SamplerOptions options;
  options.tolerance = 0.2; // a fifth more samples' worth of noise, for tables made anew whenever a slider moves
  const auto known = before ? before->SamplerKinds.find(lobe.model) : this->SamplerKinds.end();
  const bool keep = before && known != before->SamplerKinds.end();
  const brdf::TabulatedSampler sampler =
    keep ? brdf::TabulatedSampler(shape, known->second, options) : brdf::TabulatedSampler(shape, options);
  this->SamplerKinds[lobe.model] = sampler.report().kind;
  return this->AddSampler(sampler, false, 0);
}

std::vector<int> vtkBRDFShaderText::Samples(int samples) const
{
  // Constant terms need none: what they would get goes to the others.
  double total = 0;
  for (const Term& term : this->Terms)
  {
    total += term.Constant() ? 0 : term.Weight;
  }
  std::vector<int> counts;
  for (const Term& term : this->Terms)
  {
    const bool needed = !term.Constant() && term.Weight > 0;
    const double share = needed ? term.Weight / total : 0;
    counts.push_back(needed ? std::max(std::min(samples, 8), static_cast<int>(std::lround(share * samples))) : 0);
  }
  return counts;
}

std::vector<float> vtkBRDFShaderText::Shares() const
{
  double total = 0;
  for (const Term& term : this->Terms)
  {
    total += term.Weight;
  }
  std::vector<float> shares;
  for (const Term& term : this->Terms)
  {
    shares.push_back(total > 0 ? static_cast<float>(term.Weight / total) : 0.0f);
  }
  return shares;
}

// The functions of one term, which every way of drawing is written with: value, draw and density.
std::string vtkBRDFShaderText::TermText(std::size_t index) const
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

// Environment light on one term by filtered importance sampling, without its scale. Several samples a turn, each step
// for all of them: on processors a sample is one long chain of dependent operations, and chains side by side overlap.
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
  const std::string lines[] = {
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
  for (const std::string& line : lines)
  {
    for (int k = 0; k < together; ++k)
    {
      text += "    " + std::regex_replace(line, std::regex("#"), std::to_string(k));
    }
  }
  // Light on the constant that the samples leave out; where the table is below it a bright lamp drawn too often would
  // leave less than nothing.
  return text + "  }\n  return " +
         (term.Model ? "sum" : "max(sum + 3.14159265 * brdfTableBase * brdfDiffuse(frame[2]), 0.0)") + ";\n}\n";
}

std::string vtkBRDFShaderText::ValueText() const
{
  std::string text = "vec3 brdfValue(vec3 wi, vec3 wo)\n{\n  vec3 value = vec3(0.0);\n";
  for (std::size_t i = 0; i < this->Terms.size(); ++i)
  {
    text += "  value += brdfTerm" + std::to_string(i) + "_value(wi, wo);\n";
  }
  return text + "  return value;\n}\n";
}

std::string vtkBRDFShaderText::EnvironmentText() const
{
  std::string text = "vec3 brdfEnvironment(vec3 wo, mat3 frame, uvec2 pixel)\n{\n  vec3 radiance = vec3(0.0);\n";
  for (std::size_t i = 0; i < this->Terms.size(); ++i)
  {
    const std::string index = std::to_string(i), name = "brdfTerm" + index;
    text += "  radiance += brdfScales[" + index + "] * ";
    if (this->Terms[i].Constant())
    {
      // Any direction gives its value; pi turns irradiance / pi into irradiance.
      text += "(3.14159265 * " + name + "_shape(vec3(0.0, 0.0, 1.0), vec3(0.0, 0.0, 1.0))) * brdfDiffuse(frame[2]);\n";
    }
    else
    {
      // Terms differ in their shift, so that their samples are independent.
      text += name + "_reflected(wo, frame, brdfHash(pixel + uvec2(" + std::to_string(7919 * i) + "u)), brdfSamples[" +
              index + "]);\n";
    }
  }
  return text + "  return radiance;\n}\n";
}

// Drawing from all terms together, each with its share: the first number chooses the term, and what is left of it
// serves the draw.
std::string vtkBRDFShaderText::MixtureText() const
{
  std::string sample = "vec3 brdfMaterialSample(vec3 wo, vec2 u)\n{\n";
  std::string density = "float brdfMaterialPdf(vec3 wi, vec3 wo)\n{\n  float density = 0.0;\n";
  for (std::size_t i = 0; i < this->Terms.size(); ++i)
  {
    const std::string index = std::to_string(i), name = "brdfTerm" + index, share = "brdfShares[" + index + "]";
    sample += "  if (u.x < " + share + ")\n  {\n    return " + name + "_sample(wo, vec2(min(u.x / " + share +
              ", 0.99999994), u.y));\n  }\n  u.x -= " + share + ";\n";
    density += "  if (" + share + " > 0.0)\n  {\n    density += " + share + " * " + name + "_pdf(wi, wo);\n  }\n";
  }
  // What rounding leaves beyond the last share draws nothing.
  return sample + "  return vec3(0.0);\n}\n" + density + "  return density;\n}\n";
}

std::string vtkBRDFShaderText::UniformText() const
{
  // An array of length zero is not GLSL: keep one number.
  const auto length = [](std::size_t count) { return "[" + std::to_string(std::max<std::size_t>(count, 1)) + "];\n"; };
  std::string text = "uniform float brdfParameters" + length(this->ParameterValues.size()) + "uniform vec3 brdfScales" +
                     length(this->Terms.size()) + "uniform int brdfSamples" + length(this->Terms.size()) +
                     "uniform vec3 brdfTableBase;\nuniform int brdfSamplerShapes" +
                     length(this->SamplerShapeValues.size());
  // Read once a fragment: software devices fetch a uniform anew at every use, a tenth of the time of a loop of samples.
  for (std::size_t i = 0; i < this->ParameterValues.size(); ++i)
  {
    const std::string number = std::to_string(i);
    text += "float brdfParameter" + number + " = brdfParameters[" + number + "];\n";
  }
  return text;
}

std::vector<vtkBRDFShaderText::Piece> vtkBRDFShaderText::Pieces(
  Environment environment, bool draws) const
{
  std::vector<Piece> pieces;
  pieces.push_back({ "formula prelude", brdf::Model::glslPrelude() });
  pieces.push_back({ "uniforms of the material", this->UniformText() });
  if (!this->Samplers.empty())
  {
    pieces.push_back({ "brdf_sampler.glsl",
                       "const float BRDF_WARP_ROWS = " + std::to_string(brdf::PolarWarp::kRows) +
                         ".0, BRDF_WARP_COLUMNS = " + std::to_string(brdf::PolarWarp::kColumns) + ".0;\n#line 1\n" +
                         std::string(File("brdf_sampler.glsl")) });
  }
  if (!this->TableText.empty())
  {
    pieces.push_back({ "table", this->TableText });
  }
  const auto add = [&pieces](const char* file, const std::string& before = {}) {
    pieces.push_back({ file, before + (before.empty() ? "" : "#line 1\n") + std::string(File(file)) });
  };
  const bool filtered = environment == Environment::Filtered, unfiltered = environment == Environment::Unfiltered;
  if (filtered || unfiltered)
  {
    add("brdf_points.glsl", "#define BRDF_ENVIRONMENT\n");
    add("brdf_map.glsl");
  }
  if (filtered)
  {
    add("brdf_environment.glsl");
  }
  if (unfiltered)
  {
    add("brdf_light.glsl");
    add("brdf_converging.glsl",
        "#define BRDF_TERMS " + std::to_string(std::max<std::size_t>(this->Terms.size(), 1)) + "\n");
  }
  for (const auto& model : this->Models)
  {
    pieces.push_back({ "model " + model->name(), model->glsl() });
  }
  for (std::size_t i = 0; i < this->Terms.size(); ++i)
  {
    pieces.push_back({ "term " + std::to_string(i), this->TermText(i) });
    if (filtered && !this->Terms[i].Constant())
    {
      pieces.push_back({ "environment light on term " + std::to_string(i), this->ReflectedText(i) });
    }
  }
  pieces.push_back({ "value of the material", this->ValueText() });
  if (filtered)
  {
    pieces.push_back({ "environment light on the material", this->EnvironmentText() });
  }
  if (unfiltered || !draws)
  {
    pieces.push_back({ "drawing from the material", this->MixtureText() });
  }
  if (draws)
  {
    add("brdf_surface.glsl");
  }
  return pieces;
}

std::string vtkBRDFShaderText::Text(Environment environment) const
{
  std::string text;
  int number = 0;
  for (const Piece& piece : this->Pieces(environment, true))
  {
    text += "// " + piece.Name + "\n#line 1 " + std::to_string(number++) + "\n" + piece.Text + "\n";
  }
  return text;
}

std::string vtkBRDFShaderText::MaterialText() const
{
  std::string text =
    "uniform float brdfShares[" + std::to_string(std::max<std::size_t>(this->Terms.size(), 1)) + "];\n";
  for (const Piece& piece : this->Pieces(Environment::None, false))
  {
    text += "// " + piece.Name + "\n" + piece.Text + "\n";
  }
  return text;
}

std::string_view vtkBRDFShaderText::File(std::string_view name)
{
  for (const auto& file : brdf::brdfShaders())
  {
    if (file.name == name)
    {
      return file.text;
    }
  }
  throw brdf::Error(brdf::Error::Kind::Value, { "no such shader", {}, std::string(name), {} });
}
