#include "vtkBRDFShaderText.h"

#include "brdfShaders.h"

#include <brdf/base/Error.h>

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

vtkBRDFShaderText::vtkBRDFShaderText(const brdf::LobeSum& material)
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
  // An array of length zero is not GLSL: keep one number when no lobe has parameters.
  if (this->ParameterValues.empty())
  {
    this->ParameterValues.push_back(0.0f);
  }
}

std::vector<int> vtkBRDFShaderText::Samples(int samples) const
{
  // Constant terms need none: what they would get goes to the others.
  double total = 0;
  for (const Term& term : this->Terms)
  {
    total += term.Model->constant() ? 0 : term.Weight;
  }
  std::vector<int> counts;
  for (std::size_t i = 0; i < this->Terms.size(); ++i)
  {
    const bool needed = !this->Terms[i].Model->constant() && this->Terms[i].Weight > 0;
    const double share = needed ? this->Terms[i].Weight / total : 0;
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

// The functions of one term, which every way of drawing is written with: value with its scale, draw and density.
std::string vtkBRDFShaderText::TermText(std::size_t index) const
{
  const Term& term = this->Terms[index];
  const std::string name = "brdfTerm" + std::to_string(index), model = "brdf_" + term.Model->name();
  const std::string arguments = Arguments(term.Model->parameters().size(), term.Offset) + ");\n}\n";
  return "float " + name + "_shape(vec3 wi, vec3 wo)\n{\n  return " + model + "(wi, wo" + arguments + "vec3 " + name +
         "_value(vec3 wi, vec3 wo)\n{\n  return brdfScales[" + std::to_string(index) + "] * " + name +
         "_shape(wi, wo);\n}\nvec3 " + name + "_sample(vec3 wo, vec2 u)\n{\n  return " + model + "_sample(wo, u" +
         arguments + "float " + name + "_pdf(vec3 wi, vec3 wo)\n{\n  return " + model + "_pdf(wi, wo" + arguments;
}

// Environment light on one term by filtered importance sampling, without its scale. Several samples a turn, each step
// for all of them: on processors a sample is one long chain of dependent operations, and chains side by side overlap.
std::string vtkBRDFShaderText::ReflectedText(std::size_t index) const
{
  constexpr int together = 3;
  const std::string name = "brdfTerm" + std::to_string(index);
  std::string text = "vec3 " + name +
                     "_reflected(vec3 wo, mat3 frame, uvec2 shift, int samples)\n"
                     "{\n"
                     "  vec3 sum = vec3(0.0);\n"
                     "  float share = 1.0 / float(max(samples, 1));\n"
                     "  for (int i = 0; i < samples; i += " +
                     std::to_string(together) + ")\n  {\n";
  const std::string lines[] = { "vec3 wi# = " + name + "_sample(wo, brdfPoint(i + #, share, shift));\n",
                                "float density# = " + name + "_pdf(wi#, wo);\n",
                                "float inverse# = share / density#;\n",
                                "float weight# = " + name + "_shape(wi#, wo) * wi#.z * inverse#;\n",
                                "bool counts# = i + # < samples && wi#.z > 0.0 && density# > 0.0;\n",
                                "vec3 light# = brdfRadiance(frame * wi#, inverse#);\n",
                                "sum += counts# ? light# * weight# : vec3(0.0);\n" };
  for (const std::string& line : lines)
  {
    for (int k = 0; k < together; ++k)
    {
      text += "    " + std::regex_replace(line, std::regex("#"), std::to_string(k));
    }
  }
  return text + "  }\n  return sum;\n}\n";
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
    if (this->Terms[i].Model->constant())
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

std::vector<vtkBRDFShaderText::Piece> vtkBRDFShaderText::Pieces(Environment environment) const
{
  const std::string terms = std::to_string(std::max<std::size_t>(this->Terms.size(), 1));
  std::vector<Piece> pieces;
  pieces.push_back({ "formula prelude", brdf::Model::glslPrelude() });
  std::string uniforms = "uniform float brdfParameters[" + std::to_string(this->ParameterValues.size()) +
                         "];\nuniform vec3 brdfScales[" + terms + "];\nuniform int brdfSamples[" + terms + "];\n";
  // Read once a fragment: software devices fetch a uniform anew at every use, a tenth of the time of a loop of samples.
  for (std::size_t i = 0; i < this->ParameterValues.size(); ++i)
  {
    const std::string number = std::to_string(i);
    uniforms += "float brdfParameter" + number + " = brdfParameters[" + number + "];\n";
  }
  pieces.push_back({ "uniforms of the material", uniforms });
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
    add("brdf_converging.glsl", "#define BRDF_TERMS " + terms + "\n");
  }
  for (const auto& model : this->Models)
  {
    pieces.push_back({ "model " + model->name(), model->glsl() });
  }
  for (std::size_t i = 0; i < this->Terms.size(); ++i)
  {
    pieces.push_back({ "term " + std::to_string(i), this->TermText(i) });
    if (filtered && !this->Terms[i].Model->constant())
    {
      pieces.push_back({ "environment light on term " + std::to_string(i), this->ReflectedText(i) });
    }
  }
  pieces.push_back({ "value of the material", this->ValueText() });
  if (filtered)
  {
    pieces.push_back({ "environment light on the material", this->EnvironmentText() });
  }
  if (unfiltered)
  {
    pieces.push_back({ "drawing from the material", this->MixtureText() });
  }
  add("brdf_surface.glsl");
  return pieces;
}

std::string vtkBRDFShaderText::Text(Environment environment) const
{
  std::string text;
  int number = 0;
  for (const Piece& piece : this->Pieces(environment))
  {
    text += "// " + piece.Name + "\n#line 1 " + std::to_string(number++) + "\n" + piece.Text + "\n";
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
