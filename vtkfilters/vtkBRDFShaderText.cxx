#include "vtkBRDFShaderText.h"

#include "brdfShaders.h"

#include <brdf/base/Error.h>
#include <brdf/material/GridShader.h>
#include <brdf/sampling/PolarWarp.h>
#include <brdf/sampling/SampledBrdf.h>
#include <brdf/sampling/ViewerDraws.h>

#include <algorithm>
#include <cmath>

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
      if (!lobe.model->constant())
      {
        this->AddShape(this->Terms.back(), lobe, term, before);
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
  this->Table = table;
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
  this->Terms.back().Turns = table.grid->symmetry() != brdf::Symmetry::Anisotropic;
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

// How light is drawn from a lobe at one channel's parameters.
void vtkBRDFShaderText::AddShape(Term& term,
                                 const brdf::Lobe& lobe,
                                 std::size_t channel,
                                 const vtkBRDFShaderText* before)
{
  brdf::Lobe alone{ lobe.model, {}, { 1.0 } };
  for (const double value : lobe.parametersOf(channel))
  {
    alone.parameters.push_back({ value });
  }
  term.Shape = std::make_shared<const brdf::LobeSum>(std::vector{ alone }, brdf::Channels::monochrome());
  if (!lobe.model->namesSampler())
  {
    brdf::SamplerOptions options;
    options.tolerance = 0.2; // a fifth more samples' worth of noise, for tables made anew whenever a slider moves
    const auto known = before ? before->SamplerKinds.find(lobe.model) : this->SamplerKinds.end();
    const bool keep = before && known != before->SamplerKinds.end();
    brdf::TabulatedSampler sampler =
      keep ? brdf::TabulatedSampler(*term.Shape, known->second, options) : brdf::TabulatedSampler(*term.Shape, options);
    this->SamplerKinds[lobe.model] = sampler.report().kind;
    term.Sampler = this->AddSampler(sampler, false, 0);
    term.Shape = std::make_shared<const brdf::SampledBrdf>(term.Shape, std::move(sampler));
  }
  term.Turns =
    term.Shape->symmetry() != brdf::Symmetry::Anisotropic && !(before && before->FixedModels.count(lobe.model));
  if (!term.Turns)
  {
    this->FixedModels.insert(lobe.model);
    this->StructureText += "fixed ";
  }
}

std::vector<brdf::BrdfPointer> vtkBRDFShaderText::DrawnTerms() const
{
  std::vector<brdf::BrdfPointer> drawn;
  for (const Term& term : this->Terms)
  {
    drawn.push_back(!term.Turns ? nullptr : term.Model ? term.Shape : brdf::aboveBase(this->Table));
  }
  return drawn;
}

bool vtkBRDFShaderText::NeedsTangents() const
{
  return std::any_of(
    this->Terms.begin(), this->Terms.end(), [](const Term& term) { return !term.Turns && !term.Constant(); });
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
                     "uniform int brdfDrawShapes" + length(2 * this->Terms.size()) + "uniform float brdfDrawUnits" +
                     length(this->Terms.size()) + "uniform vec3 brdfTableBase;\nuniform int brdfSamplerShapes" +
                     length(this->SamplerShapeValues.size());
  // Read once a fragment: software devices fetch a uniform anew at every use, a tenth of the time of a loop of samples.
  for (std::size_t i = 0; i < this->ParameterValues.size(); ++i)
  {
    const std::string number = std::to_string(i);
    text += "float brdfParameter" + number + " = brdfParameters[" + number + "];\n";
  }
  return text;
}

std::vector<vtkBRDFShaderText::Piece> vtkBRDFShaderText::Pieces(Environment environment, bool draws) const
{
  std::vector<Piece> pieces;
  const bool filtered = environment == Environment::Filtered, unfiltered = environment == Environment::Unfiltered;
  const auto inAdvance = [filtered](const Term& term) { return filtered && term.Turns; };
  const bool readsDraws = std::any_of(this->Terms.begin(), this->Terms.end(), inAdvance);
  pieces.push_back({ "formula prelude", brdf::Model::glslPrelude() });
  pieces.push_back({ "uniforms of the material", this->UniformText() });
  if (std::any_of(this->Terms.begin(),
                  this->Terms.end(),
                  [&](const Term& term) { return term.Sampler >= 0 && !inAdvance(term); }))
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
  if (filtered || unfiltered)
  {
    add("brdf_points.glsl", "#define BRDF_ENVIRONMENT\n");
    add("brdf_map.glsl");
  }
  if (filtered)
  {
    add("brdf_environment.glsl");
  }
  if (readsDraws)
  {
    add("brdf_draws.glsl", "const float BRDF_VIEWERS = " + std::to_string(brdf::ViewerDraws::kViewers) + ".0;\n");
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
    const bool drawn = inAdvance(this->Terms[i]);
    pieces.push_back({ "term " + std::to_string(i), this->TermText(i, !drawn) });
    if (filtered && !this->Terms[i].Constant())
    {
      pieces.push_back(
        { "environment light on term " + std::to_string(i), drawn ? this->DrawnText(i) : this->ReflectedText(i) });
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
