#include "vtkBRDFMaterialShader.h"

#include "vtkBRDFTextureBuffer.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <brdf/base/Error.h>
#include <brdf/material/ChannelView.h>
#include <brdf/material/LobeSum.h>

#include <algorithm>

void vtkBRDFMaterialShader::Update(const brdf::BrdfPointer& brdf, const brdf::ColourNames& colours, double tolerance)
{
  if (brdf && brdf == this->Brdf && colours == this->Colours && this->Shader && tolerance == this->Tolerance)
  {
    return;
  }
  this->Brdf = brdf;
  this->Colours = colours;
  this->Tolerance = tolerance;
  const std::optional<vtkBRDFShaderText> before = std::move(this->Shader);
  this->Shader.reset();
  this->Drawn = {};
  this->Release();
  this->Draws.SetTerms({});
  if (!brdf)
  {
    throw brdf::Error(brdf::Error::Kind::Value, { "no BRDF to draw with", {}, {}, {} });
  }
  auto lobes = std::dynamic_pointer_cast<const brdf::LobeSum>(brdf);
  if (lobes && lobes->channels().kind == brdf::Channels::Kind::Spectral)
  {
    // Null where its colours are no sum of lobes: then it is drawn as a table.
    lobes = brdf::lobesAsRgb(*lobes, brdf::colourSettings(colours));
  }
  if (lobes)
  {
    this->Shader.emplace(*lobes, before ? &*before : nullptr);
  }
  else
  {
    brdf::DrawnTableOptions options;
    options.tolerance = tolerance;
    options.maximumTexels = std::min(options.maximumTexels, vtkBRDFTextureBuffer::LargestSize());
    this->Drawn = brdf::drawnTable(brdf::reducedToRgb(brdf, brdf::colourSettings(colours)), options);
    this->Shader.emplace(this->Drawn, brdf::TabulatedSampler(*this->Drawn.grid));
  }
  if (!before || this->Shader->Structure() != before->Structure())
  {
    this->Structure.Modified();
  }
}

void vtkBRDFMaterialShader::Activate(vtkOpenGLRenderWindow* window, Environment environment, int samples)
{
  if (this->Window != window)
  {
    this->Release();
    for (const vtkBRDFShaderText::Buffer& buffer : this->Shader->Buffers())
    {
      this->Buffers.push_back(
        vtkBRDFTextureBuffer::Make(window, "the table", buffer.Texels.data(), buffer.Texels.size() / 4));
    }
    this->Window = window;
  }
  this->Light = environment;
  this->Samples = this->Shader->Samples(samples);
  if (environment == Environment::Filtered)
  {
    if (!this->Draws.HasTerms())
    {
      this->Draws.SetTerms(this->Shader->DrawnTerms());
    }
    this->Draws.Activate(window, this->Samples);
  }
  for (const auto& buffer : this->Buffers)
  {
    buffer->Activate();
  }
}

void vtkBRDFMaterialShader::SetUniforms(vtkShaderProgram* program) const
{
  const vtkBRDFShaderText& shader = *this->Shader;
  const auto& parameters = shader.Parameters();
  if (!parameters.empty())
  {
    program->SetUniform1fv("brdfParameters", static_cast<int>(parameters.size()), parameters.data());
  }
  program->SetUniform3f("brdfTableBase", shader.TableBase().data());
  const auto& shapes = shader.SamplerShapes();
  if (!shapes.empty())
  {
    program->SetUniform1iv("brdfSamplerShapes", static_cast<int>(shapes.size()), shapes.data());
  }
  for (std::size_t i = 0; i < this->Buffers.size(); ++i)
  {
    program->SetUniformi(shader.Buffers()[i].Name.c_str(), this->Buffers[i]->GetTextureUnit());
  }
  if (shader.NumberOfTerms() > 0)
  {
    program->SetUniform3fv("brdfScales", shader.NumberOfTerms(), shader.Scales().data());
    program->SetUniform1iv("brdfSamples", shader.NumberOfTerms(), this->Samples.data());
    if (this->Light == Environment::Unfiltered)
    {
      program->SetUniform1fv("brdfShares", shader.NumberOfTerms(), shader.Shares().data());
    }
    if (this->Light == Environment::Filtered)
    {
      this->Draws.SetUniforms(program);
    }
  }
}

void vtkBRDFMaterialShader::Deactivate()
{
  for (const auto& buffer : this->Buffers)
  {
    buffer->Deactivate();
  }
  if (this->Light == Environment::Filtered)
  {
    this->Draws.Deactivate();
  }
}

void vtkBRDFMaterialShader::Release()
{
  this->Buffers.clear();
  this->Window = nullptr;
  this->Draws.Release();
}

void vtkBRDFMaterialShader::Release(vtkOpenGLRenderWindow* window)
{
  if (this->Window == window)
  {
    this->Release();
  }
}
