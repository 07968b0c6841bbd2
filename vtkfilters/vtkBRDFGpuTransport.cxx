// The "gpu" backend of the virtual gonioreflectometer, registered when this library is loaded.
#include "vtkBRDFDeviceThread.h"
#include "vtkBRDFTransportDevice.h"

#include <brdf/base/Error.h>

#include <memory>

namespace
{
class GpuTransport : public brdf::Transport
{
public:
  GpuTransport(const brdf::Microsurface& surface, const brdf::TransportOptions& options)
    : Scene(surface, options.bounces)
  {
    if (options.nextEvent == brdf::NextEvent::On)
    {
      throw brdf::Error(brdf::Error::Kind::Value,
                        { "no next-event estimation on the graphics device", "backend", "gpu", "cpu, or off" });
    }
    this->Thread.Run([this] { this->Device = std::make_unique<vtkBRDFTransportDevice>(this->Scene); });
  }
  ~GpuTransport() override
  {
    this->Thread.Run([this] { this->Device.reset(); });
  }
  void trace(const brdf::RayBatch& batch, const brdf::OutgoingBins& bins, brdf::Tally& tally) override
  {
    this->Thread.Run([&] { this->Device->Trace(batch, bins, tally); });
  }

private:
  vtkBRDFTransportScene Scene;
  std::unique_ptr<vtkBRDFTransportDevice> Device; // made, used and destroyed on the thread
  vtkBRDFDeviceThread Thread;
};

[[maybe_unused]] const bool registered = []
{
  brdf::registerTransport({ "gpu",
                            "OpenGL 3.2 fragment shaders, hardware or Mesa's software device",
                            [](const brdf::Microsurface& surface, const brdf::TransportOptions& options) {
                              return std::unique_ptr<brdf::Transport>(std::make_unique<GpuTransport>(surface, options));
                            } });
  return true;
}();
}
