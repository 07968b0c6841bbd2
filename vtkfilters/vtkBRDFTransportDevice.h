#ifndef vtkBRDFTransportDevice_h
#define vtkBRDFTransportDevice_h
// What the "gpu" backend keeps on the graphics device. For .cxx files only.

#include "vtkBRDFTransportProgram.h"
#include "vtkBRDFTransportStates.h"

#include "vtkNew.h" // For vtkNew

#include <brdf/simulate/Transport.h>
#include <brdf/simulate/gpu/TracedRays.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

class vtkBRDFHeadlessRenderWindow;

// Programs and textures of one scene. Every call in the thread whose context `window` is.
class vtkBRDFTransportDevice
{
public:
  // Throws brdf::Error (kind Device) where there is no headless OpenGL 3.2 context.
  explicit vtkBRDFTransportDevice(const vtkBRDFTransportScene& scene);
  ~vtkBRDFTransportDevice();
  vtkBRDFTransportDevice(const vtkBRDFTransportDevice&) = delete;
  void operator=(const vtkBRDFTransportDevice&) = delete;

  void Trace(const brdf::RayBatch& batch, const brdf::OutgoingBins& bins, brdf::Tally& tally);

private:
  void SetBatch(const brdf::RayBatch& batch, const brdf::OutgoingBins& bins);
  void TraceChunk(std::uint64_t first, std::size_t rays);
  void Draw(bool begin, std::size_t count);
  void TakeEnded(std::size_t count);

  const vtkBRDFTransportScene& Scene;
  vtkNew<vtkBRDFHeadlessRenderWindow> Window; // first: its context holds the rest
  std::optional<vtkBRDFTransportProgram> Program;
  std::optional<vtkBRDFDeviceName> Vertices;
  std::array<std::unique_ptr<vtkBRDFTransportStates>, 2> Sets; // drawn, and drawn from; they take turns
  GLsizei Rows = 0;                                            // of the states
  brdf::TracedRays Traced;
  brdf::TracedRays Read;                                // of one draw
  std::vector<std::array<std::uint32_t, 2>> Alive;      // rays that go on: their texels, and their numbers in Traced
  std::optional<vtkBRDFDeviceName> SourceData, Sources; // the same on the device
  std::size_t Jobs = 4096;                              // of a draw: as many as the device takes quickly
};

#endif
