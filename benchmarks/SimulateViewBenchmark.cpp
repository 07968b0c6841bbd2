// The virtual gonioreflectometer by both backends, on all threads: rays a second, and updates a second of a picture in
// which a lobe grows (vtkBRDFSimulatedLobe drawn by vtkBRDFLobeView, 400 x 400 pixels; OpenGL on whatever device there
// is, which the label names).
#include "vtkBRDF.h"
#include "vtkBRDFHeadlessRenderWindow.h"
#include "vtkBRDFLobeView.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>

#include <brdf/simulate/FacetExpression.h>
#include <brdf/simulate/Gonioreflectometer.h>
#include <brdf/simulate/SurfaceKinds.h>

#include <benchmark/benchmark.h>

#include <string>
#include <utility>
#include <vector>

namespace {

using namespace brdf;

constexpr double kThetaI = 45, kPhiI = 30;  // degrees

struct Case {
  const char *name, *surface, *facet;
};
const std::vector<Case> kCases = {
    {"grooves", "grooves(width=10, spacing=10, angle=70)", "mirror"},
    {"gaussian_256", "gaussian(rms=0.5, correlation=2, period=64)", "mirror"},
    {"gaussian_256_metal", "gaussian(rms=0.5, correlation=2, period=64)", "conductor(eta=0.2 0.9 1.1, k=3.9 2.4 2.2)"},
    {"gaussian_256_glass", "gaussian(rms=0.5, correlation=2, period=64)", "dielectric(eta=1.5)"},
    {"gaussian_256_white", "gaussian(rms=0.5, correlation=2, period=64)", "lambertian(albedo=0.8)"},
    {"spheres", "spheres(count=200, radius=1)", "dielectric(eta=1.5)"},
    {"triangles", "triangles", "mirror"}};

const std::string& deviceName() {
  static const std::string name = [] {
    vtkNew<vtkBRDFHeadlessRenderWindow> window;
    return window->GetDeviceDescription();
  }();
  return name;
}

LobeSimulation simulationOf(const Case& made, const char* backend) {
  Microsurface surface = makeSurface(made.surface).surface;
  surface.facets.assign(surface.facetsNeeded(), parseFacet(made.facet));
  surface.channels = facetChannels(surface.facets);
  using Q = AxisQuantity;
  const GridLayout layout{
      Parametrisation::Spherical,
      {GridAxis::uniformCells(Q::ThetaO, 0, kPi / 2, 18), GridAxis::uniformCells(Q::PhiO, 0, 2 * kPi, 72).periodic(),
       GridAxis::listedDegrees(Q::ThetaI, {kThetaI}), GridAxis::listedDegrees(Q::PhiI, {kPhiI})}};
  return {makeTransport(backend, surface), surface.channels, layout, radians(kThetaI), radians(kPhiI), 1};
}

void rays(benchmark::State& state, const Case& made, const char* backend) {
  LobeSimulation lobe = simulationOf(made, backend);
  constexpr std::uint64_t kRays = 200'000;
  lobe.add(kRays);
  for (auto _ : state) lobe.add(kRays);
  state.counters["Mrays/s"] =
      benchmark::Counter(static_cast<double>(kRays) * 1e-6, benchmark::Counter::kIsIterationInvariantRate);
  if (std::string(backend) == "gpu") state.SetLabel(deviceName());
}

void updates(benchmark::State& state, const Case& made, const char* backend) {
  constexpr std::uint64_t kRays = 20'000;  // between two pictures
  LobeSimulation lobe = simulationOf(made, backend);
  vtkNew<vtkBRDF> data;
  vtkNew<vtkBRDFHeadlessRenderWindow> window;
  window->SetSize(400, 400);
  vtkNew<vtkBRDFLobeView> view;
  view->SetRenderWindow(window);
  view->AddInputData(data, "lobe");
  view->SetThetaI(kThetaI);
  view->SetPhiI(kPhiI);
  view->SetTolerance(0);
  const auto update = [&] {
    lobe.add(kRays);
    data->SetBrdf(lobe.lobe());
    data->Modified();
    view->Render();
  };
  update();
  const double noise = lobe.noise();
  for (auto _ : state) update();
  state.counters["updates/s"] = benchmark::Counter(1, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["noise of one"] = noise;
  state.SetLabel(deviceName());
}

const int registered = [] {
  const auto add = [](const char* what, const Case& made, const char* backend, auto run) {
    benchmark::RegisterBenchmark((std::string(what) + "/" + made.name + "/" + backend).c_str(), run, made, backend)
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
  };
  for (const char* backend : {"cpu", "gpu"}) {
    for (const Case& made : kCases) add("rays", made, backend, rays);
    for (const Case& made : {kCases[0], kCases[1]}) add("updates", made, backend, updates);
  }
  return 0;
}();

}  // namespace
