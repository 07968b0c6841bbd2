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
constexpr GLint kSteps = 1024;                            // of a ray in one draw
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
  this->Program.emplace(scene, kSteps);
  this->Vertices.emplace(vtkBRDFDeviceName::VertexArray());
  this->Traced.parts = scene.Splits ? 2 : 1;
}

vtkBRDFTransportDevice::~vtkBRDFTransportDevice()
{
  this->Window->MakeCurrent();
  this->Sets = {};
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

void vtkBRDFTransportDevice::Draw(bool begin, std::size_t jobs)
{
  std::swap(this->Sets[0], this->Sets[1]);
  this->Sets[1]->BindTextures();
  this->Sets[0]->BindForDrawing();
  glViewport(0, 0, States::Width, States::RowsOf(jobs));
  glUniform1i(this->Program->Uniform("brdfBegin"), begin);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

// Whether all jobs have ended.
bool vtkBRDFTransportDevice::ReadStates(std::size_t jobs)
{
  States::Read(States::States, States::RowsOf(jobs), this->Traced.states);
  return std::all_of(this->Traced.states.begin(),
                     this->Traced.states.begin() + static_cast<std::ptrdiff_t>(jobs),
                     [](const brdf::TracedRays::Words& state) { return (state[0] & brdf::TracedRays::kEnded) != 0; });
}

void vtkBRDFTransportDevice::ReadRest(std::size_t jobs)
{
  States::Read(States::Directions, States::RowsOf(jobs), this->Traced.directions);
  States::Read(States::Weights, States::RowsOf(jobs), this->Traced.weights);
  States::Read(States::Absorbed, States::RowsOf(jobs), this->Traced.absorbed);
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
  const vtkBRDFTransportProgram& program = *this->Program;
  glUniform2ui(program.Uniform("brdfFirst"), static_cast<GLuint>(first), static_cast<GLuint>(first >> 32));
  glUniform1i(program.Uniform("brdfJobs"), static_cast<GLint>(jobs));
  double slowest = 0;
  bool ended = false;
  for (bool begin = true; !ended; begin = false)
  {
    const auto start = Clock::now();
    this->Draw(begin, jobs);
    ended = this->ReadStates(jobs);
    slowest = std::max(slowest, std::chrono::duration<double>(Clock::now() - start).count());
  }
  this->ReadRest(jobs);
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
