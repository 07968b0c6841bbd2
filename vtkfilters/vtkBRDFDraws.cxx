#include "vtkBRDFDraws.h"

#include "vtkBRDFTextureBuffer.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <brdf/sampling/ViewerDraws.h>

#include <algorithm>
#include <cstdint>

void vtkBRDFDraws::SetTerms(std::vector<brdf::BrdfPointer> terms)
{
  this->Release();
  this->Terms = std::move(terms);
}

void vtkBRDFDraws::Release()
{
  this->Current = nullptr;
  this->Buffers.clear();
  this->Window = nullptr;
}

vtkBRDFDraws::Buffer vtkBRDFDraws::Make(vtkOpenGLRenderWindow* window, const std::vector<int>& samples) const
{
  Buffer buffer;
  std::vector<std::uint32_t> words;
  for (std::size_t term = 0; term < this->Terms.size(); ++term)
  {
    brdf::ViewerDraws draws;
    const auto count = static_cast<std::size_t>(samples[term]);
    if (this->Terms[term] && count > 0)
    {
      // Few neighbouring pixels have the same noise where there is much of it, and many samples still take their time.
      const std::size_t sets = std::max<std::size_t>(512 / count, std::clamp<std::size_t>(8192 / count, 2, 16));
      draws = brdf::viewerDraws(*this->Terms[term], count, sets);
    }
    buffer.Shapes.insert(buffer.Shapes.end(), { static_cast<int>(words.size() / 4), static_cast<int>(draws.sets) });
    buffer.Units.push_back(draws.unit);
    words.insert(words.end(), draws.words.begin(), draws.words.end());
  }
  words.resize(words.size() + 4); // never empty
  buffer.Texture = vtkBRDFTextureBuffer::Make(window, "the draws of the samples", words.data(), words.size() / 4, 4);
  return buffer;
}

void vtkBRDFDraws::Activate(vtkOpenGLRenderWindow* window, const std::vector<int>& samples)
{
  constexpr std::size_t most = 12; // numbers of samples: AdaptSamples halves them
  if (this->Window != window || this->Buffers.size() > most)
  {
    this->Release();
    this->Window = window;
  }
  const auto found = this->Buffers.find(samples);
  this->Current =
    found != this->Buffers.end() ? &found->second : &(this->Buffers[samples] = this->Make(window, samples));
  this->Current->Texture->Activate();
}

void vtkBRDFDraws::SetUniforms(vtkShaderProgram* program) const
{
  const Buffer& buffer = *this->Current;
  program->SetUniformi("brdfDraws", buffer.Texture->GetTextureUnit());
  program->SetUniform1iv("brdfDrawShapes", static_cast<int>(buffer.Shapes.size()), buffer.Shapes.data());
  program->SetUniform1fv("brdfDrawUnits", static_cast<int>(buffer.Units.size()), buffer.Units.data());
}

void vtkBRDFDraws::Deactivate()
{
  this->Current->Texture->Deactivate();
}
