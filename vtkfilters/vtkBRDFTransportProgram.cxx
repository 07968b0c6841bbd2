#include "vtkBRDFTransportProgram.h"

#include "vtkBRDFTransportStates.h"

#include <brdf/base/Error.h>

#include <algorithm>

namespace
{
using brdf::Error;

// Texture units besides those of the states.
enum Unit : GLint
{
  FacetsUnit = vtkBRDFTransportProgram::SourcesUnit + 1,
  FirstShapeUnit,
  SecondShapeUnit,
  FirstScatteringUnit
};

std::string FragmentSource(const vtkBRDFTransportScene& scene)
{
  const auto file = [](const char* name) { return std::string(vtkBRDFShaderText::File(name)); };
  // OpenGL 3.2; formulas need the bits of floats, of 3.3.
  std::string text = scene.Scattering ? "#version 330 core\n" : "#version 150 core\n";
  text += file("brdf_transport_path.glsl");
  if (std::holds_alternative<brdf::FieldTexels>(scene.Shape))
  {
    text += file("brdf_transport_field.glsl");
  }
  else
  {
    text += (scene.Spheres ? "#define BRDF_SPHERES\n" : "") + file("brdf_transport_tree.glsl");
  }
  if (scene.Scattering)
  {
    text += "#define BRDF_SCATTERING\n" + scene.Scattering->MaterialText() +
            "uniform int brdfChannel;  // of the values, -1: all side by side\n"
            "vec4 brdfMaterialValue(vec3 wi, vec3 wo)\n{\n"
            "  vec3 value = brdfValue(wi, wo);\n"
            "  return brdfChannel < 0 ? vec4(value, 0.0) : vec4(value[brdfChannel]);\n}\n";
  }
  return text + file("brdf_transport.glsl");
}

std::vector<std::string> Outputs()
{
  std::vector<std::string> names;
  for (const auto& state : vtkBRDFTransportStates::Textures)
  {
    names.emplace_back(state.Output);
  }
  return names;
}

float At(const std::vector<double>& numbers, std::size_t channel, double otherwise)
{
  return static_cast<float>(numbers.empty()            ? otherwise
                            : numbers.size() == 1      ? numbers[0]
                            : channel < numbers.size() ? numbers[channel]
                                                       : otherwise);
}
}

vtkBRDFTransportProgram::vtkBRDFTransportProgram(const vtkBRDFTransportScene& scene)
  : Program(FragmentSource(scene), Outputs())
{
  this->Program.Use();
  for (std::size_t k = 0; k < vtkBRDFTransportStates::Textures.size(); ++k)
  {
    glUniform1i(this->Program.Uniform(vtkBRDFTransportStates::Textures[k].Input), static_cast<GLint>(k));
  }
  glUniform1i(this->Program.Uniform("brdfSources"), SourcesUnit);
  glUniform1i(this->Program.Uniform("brdfFacets"), FacetsUnit);
  glUniform1i(this->Program.Uniform("brdfWidth"), vtkBRDFTransportStates::Width);
  glUniform1i(this->Program.Uniform("brdfParts"), scene.Splits ? 2 : 1);
  glUniform1i(this->Program.Uniform("brdfBounces"), static_cast<GLint>(scene.Bounces));
  glUniform1i(this->Program.Uniform("brdfBelow"), scene.BelowMedium);
  std::visit([&](const auto& shape) { this->Upload(shape, scene); }, scene.Shape);
  if (scene.Scattering)
  {
    this->Upload(*scene.Scattering);
  }
}

std::array<double, brdf::kMostDielectrics> vtkBRDFTransportProgram::SetChannels(const vtkBRDFTransportScene& scene,
                                                                                std::size_t firstChannel,
                                                                                std::size_t channels)
{
  using Texel = std::array<float, 4>;
  const auto byChannel = [&](const std::vector<double>& numbers, double otherwise)
  {
    Texel texel;
    for (std::size_t c = 0; c < 4; ++c)
    {
      texel[c] = At(numbers, std::min(firstChannel + c, firstChannel + channels - 1), otherwise);
    }
    return texel;
  };
  std::vector<Texel> facets;
  std::array<double, brdf::kMostDielectrics> first{};
  std::array<Texel, brdf::kMostDielectrics> index{}, absorption{};
  for (std::size_t k = 0; k < scene.Facets.size(); ++k)
  {
    const brdf::Facet& facet = scene.Facets[k];
    const bool white = facet.kind == brdf::Facet::Kind::Lambertian;
    facets.push_back({ static_cast<float>(facet.kind), static_cast<float>(scene.MediumOf[k]), 0, 0 });
    facets.push_back(byChannel(white ? facet.albedo : facet.eta, 1));
    facets.push_back(byChannel(facet.k, 0));
    if (const int medium = scene.MediumOf[k]; medium >= 0)
    {
      const auto slot = static_cast<std::size_t>(medium);
      index[slot] = byChannel(facet.eta, 1);
      absorption[slot] = byChannel(facet.absorption, 0);
      for (float& a : absorption[slot])
      {
        a = static_cast<float>(double(a) * scene.Unit());
      }
      first[slot] = double(index[slot][0]);
    }
  }
  this->Facets.emplace(facets.front().data(), facets.size(), "facets");
  const auto count = static_cast<GLsizei>(index.size());
  glUniform4fv(this->Program.Uniform("brdfMediumIndex"), count, index.front().data());
  glUniform4fv(this->Program.Uniform("brdfMediumAbsorption"), count, absorption.front().data());
  Texel brought{};
  std::fill_n(brought.begin(), channels, 1.0f);
  glUniform4fv(this->Program.Uniform("brdfBrought"), 1, brought.data());
  const bool alone = !scene.ScattersRgb || channels == 1;
  glUniform1i(this->Program.Uniform("brdfChannel"),
              !alone              ? -1
              : scene.ScattersRgb ? static_cast<GLint>(firstChannel)
                                  : 0);
  return first;
}

void vtkBRDFTransportProgram::Use() const
{
  this->Program.Use();
  for (const auto& [unit, texture] : this->Flat)
  {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, texture.Name());
  }
  for (const auto& [unit, buffer] : this->Buffers)
  {
    buffer.Bind(GL_TEXTURE0 + static_cast<GLenum>(unit));
  }
  if (this->Facets)
  {
    this->Facets->Bind(GL_TEXTURE0 + FacetsUnit);
  }
}

void vtkBRDFTransportProgram::Upload(const brdf::FieldTexels& field, const vtkBRDFTransportScene&)
{
  const std::size_t texelRows = field.texels.size() / field.columns;
  this->UploadFlat(FirstShapeUnit, "brdfHeights", field.columns, texelRows, field.texels.data());
  std::array<GLint, 28> rows{};
  std::copy(field.levelRows.begin(), field.levelRows.end(), rows.begin());
  glUniform1iv(this->Program.Uniform("brdfLevelRows"), static_cast<GLsizei>(rows.size()), rows.data());
  glUniform1i(this->Program.Uniform("brdfTop"), static_cast<GLint>(field.levelRows.size()) - 1);
  glUniform2i(this->Program.Uniform("brdfSize"), static_cast<GLint>(field.columns), static_cast<GLint>(field.rows));
  glUniform3f(this->Program.Uniform("brdfLattice"),
              static_cast<float>(field.cellsPerUnit[0]),
              static_cast<float>(field.cellsPerUnit[1]),
              1.0f);
  glUniform2f(this->Program.Uniform("brdfEnds"), static_cast<float>(field.lowest), static_cast<float>(field.highest));
}

void vtkBRDFTransportProgram::Upload(const brdf::TileTree& tree, const vtkBRDFTransportScene& scene)
{
  this->UploadBuffer(FirstShapeUnit, "brdfNodes", tree.nodes.front().data(), tree.nodes.size());
  this->UploadBuffer(SecondShapeUnit, "brdfPrimitives", tree.primitives.front().data(), tree.primitives.size());
  glUniform2f(this->Program.Uniform("brdfHalf"), static_cast<float>(tree.half[0]), static_cast<float>(tree.half[1]));
  glUniform2f(this->Program.Uniform("brdfEnds"), static_cast<float>(tree.lowest), static_cast<float>(tree.highest));
  glUniform1f(this->Program.Uniform("brdfRounding"), static_cast<float>(tree.rounding));
  glUniform1f(this->Program.Uniform("brdfPlane"), static_cast<float>(tree.plane));
  glUniform1i(this->Program.Uniform("brdfPlaneMedium"), scene.PlaneMedium);
  glUniform1i(this->Program.Uniform("brdfSphereMedium"), scene.MediumOf[0]);
}

void vtkBRDFTransportProgram::Upload(const vtkBRDFShaderText& material)
{
  GLint unit = FirstScatteringUnit;
  for (const auto& buffer : material.Buffers())
  {
    this->UploadBuffer(unit++, buffer.Name.c_str(), buffer.Texels.data(), buffer.Texels.size() / 4);
  }
  const auto& parameters = material.Parameters();
  const auto& shapes = material.SamplerShapes();
  glUniform1fv(this->Program.Uniform("brdfParameters"), static_cast<GLsizei>(parameters.size()), parameters.data());
  glUniform3fv(this->Program.Uniform("brdfScales"), material.NumberOfTerms(), material.Scales().data());
  glUniform1fv(this->Program.Uniform("brdfShares"), material.NumberOfTerms(), material.Shares().data());
  glUniform1iv(this->Program.Uniform("brdfSamplerShapes"), static_cast<GLsizei>(shapes.size()), shapes.data());
}

void vtkBRDFTransportProgram::UploadFlat(GLint unit,
                                         const char* name,
                                         std::size_t width,
                                         std::size_t height,
                                         const void* texels)
{
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
  if (std::max(width, height) > static_cast<std::size_t>(most))
  {
    throw Error(Error::Kind::Device,
                { "height field too large for the graphics device",
                  "gpu backend",
                  std::to_string(width) + " x " + std::to_string(height),
                  "at most " + std::to_string(most) + " along an axis" });
  }
  const auto& texture = this->Flat.emplace_back(unit, vtkBRDFDeviceName::Texture()).second;
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture.Name());
  vtkBRDFDescribeTexture(GL_TEXTURE_2D);
  const auto columns = static_cast<GLsizei>(width), rows = static_cast<GLsizei>(height);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, columns, rows, 0, GL_RGBA, GL_FLOAT, texels);
  glBindTexture(GL_TEXTURE_2D, 0);
  glUniform1i(this->Program.Uniform(name), unit);
}

void vtkBRDFTransportProgram::UploadBuffer(GLint unit, const char* name, const float* texels, std::size_t count)
{
  this->Buffers.emplace_back(unit, vtkBRDFDeviceBuffer(texels, count, name));
  glUniform1i(this->Program.Uniform(name), unit);
}
