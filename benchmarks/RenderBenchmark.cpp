// Frames at 512 x 512, a sphere, OpenGL in a headless window without a picture being read back.
#include <brdf/geometry/Directions.h>
#include <brdf/material/LobeSum.h>
#include <brdf/material/TableBrdf.h>

#include <benchmark/benchmark.h>
#include <vtkBRDF.h>
#include <vtkBRDFEnvironment.h>
#include <vtkBRDFRender.h>
#include <vtkNew.h>

#include <string>

namespace {

using namespace brdf;

/// A sphere drawn over and over; the first picture, which compiles, is not measured.
void draw(benchmark::State& state, const BrdfPointer& material, int samples) {
  vtkNew<vtkBRDFRender> render;
  vtkNew<vtkBRDF> input;
  input->SetBrdf(material);
  render->SetInputData(input);
  render->SetEdgeSamples(1);
  vtkNew<vtkBRDFEnvironment> environment;
  if (samples > 0) {
    if (!environment->ReadFile(std::string(BRDF_SOURCE_DIR) + "/datasets/environments/venice.exr"))
      return state.SkipWithError("no environment map");
    render->SetEnvironment(environment);
    render->SetNumberOfSamples(samples);
  } else {
    render->AddPointLight(2, 2, 3, 50, 50, 50);
  }
  render->SetBackground(1);
  render->Update();
  if (!render->GetErrorText().empty()) return state.SkipWithError(render->GetErrorText().c_str());
  for (auto _ : state) {
    render->Modified();
    render->Update();
  }
  state.SetLabel(render->GetDeviceDescription());
  state.counters["frames/s"] = benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

BrdfPointer lobes() { return parseMaterialExpression("(0.3,0.2,0.1)*Lambertian + 0.5*GGX(alpha=0.2)"); }

BENCHMARK_CAPTURE(draw, point_light, lobes(), 0)->UseRealTime()->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BrdfPointer merl() {
  return TableBrdf::tabulate(*parseMaterialExpression("(0.3,0.2,0.1)*Lambertian + (0.5,0.4,0.3)*GGX(alpha=0.1)"));
}

BENCHMARK_CAPTURE(draw, merl_100, merl(), 100)->UseRealTime()->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(draw, merl_point, merl(), 0)->UseRealTime()->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(draw, environment_100, lobes(), 100)
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
