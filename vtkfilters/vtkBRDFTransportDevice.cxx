#include "vtkBRDFTransportDevice.h"

#include "vtkBRDFHeadlessRenderWindow.h"

#include <brdf/base/Error.h>

#include <algorithm>
#include <chrono>

namespace
{
using brdf::Error;
using States = vtkBRDFTransportStates;

constexpr std::size_t kMostJobs = std::size_t{ 1 } << 18; // 50 MB of textures
constexpr GLint kSteps = 256;      // of a ray in its first draw, twice as many in each one after it,
constexpr GLint kMostSteps = 4096; // and at most so many, whose loops some software devices still allow
}

vtkBRDFTransportDevice::vtkBRDFTransportDevice(const vtkBRDFTransportScene& scene)
  : Scene(scene)
{
  if (!this->Window->IsAvailable())
  {
    throw Error(Error::Kind::Device, { this->Window->GetErrorText(), "gpu backend", {}, {} });
  }
  this->Window->Initialize();
  this->Window->MakeCurrent();
  while (glGetError() != GL_NO_ERROR)
  {
  }
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_CULL_FACE);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  this->Program.emplace(scene);
  this->Vertices.emplace(vtkBRDFDeviceName::VertexArray());
  this->SourceData.emplace(vtkBRDFDeviceName::Buffer());
  this->Sources.emplace(vtkBRDFDeviceName::Texture());
  glBindBuffer(GL_TEXTURE_BUFFER, this->SourceData->Name());
  glBindTexture(GL_TEXTURE_BUFFER, this->Sources->Name());
  glTexBuffer(GL_TEXTURE_BUFFER, GL_RG32UI, this->SourceData->Name());
  glBindTexture(GL_TEXTURE_BUFFER, 0);
  glBindBuffer(GL_TEXTURE_BUFFER, 0);
  this->Traced.parts = scene.Splits ? 2 : 1;
}

vtkBRDFTransportDevice::~vtkBRDFTransportDevice()
{
  this->Window->MakeCurrent();
  this->Sets = {};
  this->Sources.reset();
  this->SourceData.reset();
  this->Vertices.reset();
  this->Program.reset();
}

void vtkBRDFTransportDevice::SetBatch(const brdf::RayBatch& batch, const brdf::OutgoingBins& bins)
{
  const vtkBRDFTransportProgram& program = *this->Program;
  const brdf::Direction wi = bins.wi();
  glUniform3f(program.Uniform("brdfIncident"),
              static_cast<float>(-wi[0]),
              static_cast<float>(-wi[1]),
              static_cast<float>(-wi[2]));
  glUniform1i(program.Uniform("brdfTurning"), batch.turning);
  glUniform2ui(program.Uniform("brdfSeed"), static_cast<GLuint>(batch.seed), static_cast<GLuint>(batch.seed >> 32));
}

void vtkBRDFTransportDevice::Draw(bool begin, std::size_t count)
{
  std::swap(this->Sets[0], this->Sets[1]);
  this->Sets[1]->BindTextures();
  this->Sets[0]->BindForDrawing();
  if (!begin)
  {
    const auto bytes = static_cast<GLsizeiptr>(count * sizeof(this->Alive[0]));
    glBindBuffer(GL_TEXTURE_BUFFER, this->SourceData->Name());
    glBufferData(GL_TEXTURE_BUFFER, bytes, this->Alive.data(), GL_STREAM_DRAW);
    glBindBuffer(GL_TEXTURE_BUFFER, 0);
  }
  glViewport(0, 0, States::Width, States::RowsOf(count));
  glUniform1i(this->Program->Uniform("brdfBegin"), begin);
  glUniform1i(this->Program->Uniform("brdfJobs"), static_cast<GLint>(count));
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

// Takes what has ended of the rays of the last draw; the others are left in Alive.
void vtkBRDFTransportDevice::TakeEnded(std::size_t count)
{
  const GLsizei rows = States::RowsOf(count);
  States::Read(States::States, rows, this->Read.states);
  States::Read(States::Directions, rows, this->Read.directions);
  States::Read(States::Weights, rows, this->Read.weights);
  States::Read(States::Absorbed, rows, this->Read.absorbed);
  std::size_t left = 0;
  for (std::size_t texel = 0; texel < count; ++texel)
  {
    const std::uint32_t job = this->Alive[texel][1];
    if ((this->Read.states[texel][0] & brdf::TracedRays::kEnded) == 0)
    {
      this->Alive[left++] = { static_cast<std::uint32_t>(texel), job };
      continue;
    }
    this->Traced.states[job] = this->Read.states[texel];
    this->Traced.directions[job] = this->Read.directions[texel];
    this->Traced.weights[job] = this->Read.weights[texel];
    this->Traced.absorbed[job] = this->Read.absorbed[texel];
  }
  this->Alive.resize(left);
}

void vtkBRDFTransportDevice::TraceChunk(std::uint64_t first, std::size_t rays)
{
  using Clock = std::chrono::steady_clock;
  const std::size_t jobs = rays * this->Traced.parts;
  if (const GLsizei rows = States::RowsOf(jobs); rows > this->Rows)
  {
    this->Sets = {};
    this->Rows = rows;
    for (auto& set : this->Sets)
    {
      set = std::make_unique<vtkBRDFTransportStates>(rows);
    }
  }
  this->Traced.states.resize(jobs);
  this->Traced.directions.resize(jobs);
  this->Traced.weights.resize(jobs);
  this->Traced.absorbed.resize(jobs);
  this->Alive.resize(jobs);
  for (std::size_t job = 0; job < jobs; ++job)
  {
    this->Alive[job] = { static_cast<std::uint32_t>(job), static_cast<std::uint32_t>(job) };
  }
  glUniform2ui(this->Program->Uniform("brdfFirst"), static_cast<GLuint>(first), static_cast<GLuint>(first >> 32));
  double slowest = 0;
  // The steps go by the number of the draw alone, so that rays do not depend on how many are traced together.
  for (GLint draw = 0; !this->Alive.empty(); ++draw)
  {
    const std::size_t count = this->Alive.size();
    const auto start = Clock::now();
    glUniform1i(this->Program->Uniform("brdfSteps"), std::min(kSteps << std::min(draw, 8), kMostSteps));
    this->Draw(draw == 0, count);
    this->TakeEnded(count);
    slowest = std::max(slowest, std::chrono::duration<double>(Clock::now() - start).count());
  }
  // Draws of 25 to 50 ms: short enough beside others that use the device, long enough that starting one costs little.
  if (slowest > 0.05)
  {
    this->Jobs = std::max<std::size_t>(this->Jobs / 2, static_cast<std::size_t>(States::Width));
  }
  else if (slowest < 0.025 && jobs >= this->Jobs)
  {
    this->Jobs = std::min(this->Jobs * 2, kMostJobs);
  }
}

void vtkBRDFTransportDevice::Trace(const brdf::RayBatch& batch, const brdf::OutgoingBins& bins, brdf::Tally& tally)
{
  this->Window->MakeCurrent();
  glBindVertexArray(this->Vertices->Name());
  this->Program->Use();
  this->SetBatch(batch, bins);
  // Channels share a ray, four at a time, unless they go different ways.
  const std::size_t together = this->Scene.Dispersive ? 1 : this->Scene.ScattersRgb ? 3 : 4;
  for (std::size_t channel = 0; channel < this->Scene.Channels; channel += together)
  {
    this->Traced.firstChannel = channel;
    this->Traced.channels = std::min(together, this->Scene.Channels - channel);
    const auto index = this->Program->SetChannels(this->Scene, channel, this->Traced.channels);
    std::copy(index.begin(), index.end(), this->Traced.index.begin() + 1);
    this->Program->Use();
    glActiveTexture(GL_TEXTURE0 + vtkBRDFTransportProgram::SourcesUnit);
    glBindTexture(GL_TEXTURE_BUFFER, this->Sources->Name());
    for (std::uint64_t done = 0; done < batch.count;)
    {
      const auto rays =
        static_cast<std::size_t>(std::min<std::uint64_t>(batch.count - done, this->Jobs / this->Traced.parts));
      this->TraceChunk(batch.first + done, rays);
      this->Traced.addTo(tally, bins, rays);
      done += rays;
    }
  }
  tally.rays += batch.count;
  glUseProgram(0);
  glBindVertexArray(0);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  if (const GLenum error = glGetError(); error != GL_NO_ERROR)
  {
    throw Error(Error::Kind::Device, { "OpenGL error " + std::to_string(error), "gpu backend", {}, {} });
  }
}
