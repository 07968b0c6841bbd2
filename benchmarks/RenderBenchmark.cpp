// Frames at 512 x 512 of a sphere by the shaders, and the same sums by a plain loop over pixels on one thread.
#include <brdf/geometry/Directions.h>
#include <brdf/io/EnvironmentMap.h>
#include <brdf/io/LoadMaterial.h>
#include <brdf/material/GridBrdf.h>
#include <brdf/material/LobeSum.h>
#include <brdf/material/Resample.h>
#include <brdf/material/TableBrdf.h>
#include <brdf/sampling/SampledBrdf.h>
#include <brdf/sampling/Sequence.h>

#include <benchmark/benchmark.h>
#include <vtkBRDF.h>
#include <vtkBRDFEnvironment.h>
#include <vtkBRDFRender.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace {

using namespace brdf;

constexpr int kSize = 512;
const std::string kMap = std::string(BRDF_SOURCE_DIR) + "/datasets/environments/venice.exr";

BrdfPointer lobes() { return parseMaterialExpression("(0.3,0.2,0.1)*Lambertian + 0.5*GGX(alpha=0.2)"); }
BrdfPointer merl() {
  static const BrdfPointer table =
      TableBrdf::tabulate(*parseMaterialExpression("(0.3,0.2,0.1)*Lambertian + (0.5,0.4,0.3)*GGX(alpha=0.1)"));
  return table;
}

/// Four axes, 5 degrees.
BrdfPointer anisotropicTable() {
  const BrdfPointer source = parseMaterialExpression("(0.3,0.2,0.1)*Lambertian + 0.5*GGX(alpha=0.2, alpha_y=0.4)");
  return GridBrdf::tabulate(*source, gridFor(*source, Parametrisation::HalfDifference, 5));
}

/// A sphere drawn over and over, the picture read back; the first one, which compiles, is not measured. Processor time
/// is that of all threads.
void draw(benchmark::State& state, const BrdfPointer& material, int samples) {
  vtkNew<vtkBRDFRender> render;
  vtkNew<vtkBRDF> input;
  input->SetBrdf(material);
  render->SetInputData(input);
  render->SetSize(kSize, kSize);
  render->SetEdgeSamples(1);
  vtkNew<vtkBRDFEnvironment> environment;
  if (samples > 0) {
    if (!environment->ReadFile(kMap)) return state.SkipWithError("no environment map");
    render->SetEnvironment(environment);
    render->SetNumberOfSamples(samples);
  } else {
    render->AddPointLight(2, 2, 3, 50, 50, 50);
  }
  render->SetBackground(vtkBRDFRender::BACKGROUND_COLOR);
  render->Update();
  if (!render->GetErrorText().empty()) return state.SkipWithError(render->GetErrorText().c_str());
  for (auto _ : state) {
    render->Modified();
    render->Update();
  }
  state.SetLabel(render->GetDeviceDescription());
  state.counters["frames/s"] = benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

/// The same sum for every pixel, one after the other: the library's batches of `samples` draws, densities and values,
/// and bilinear look-ups in the level that each sample's solid angle asks for. One row in 16, which stands for all.
void loop(benchmark::State& state, const BrdfPointer& material, std::size_t samples) {
  constexpr int step = 16;
  const BrdfPointer brdf = withSampler(material);
  const EnvironmentMap map = EnvironmentMap::read(kMap);
  const OctahedralMap radiance = map.radianceMap(map.mapSize(8192));
  const std::size_t count = std::max<std::size_t>(samples, 1);
  std::vector<double> u[2], wo[3], wi[3], density(count), values(3 * count);
  for (auto& numbers : u) numbers.resize(count);
  for (std::size_t axis = 0; axis < 3; ++axis) wo[axis].resize(count), wi[axis].resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    u[0][i] = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    u[1][i] = std::fmod(0.6180339887 * static_cast<double>(i), 1);
  }
  for (auto _ : state) {
    double sum = 0;
    for (int y = step / 2; y < kSize; y += step)
      for (int x = 0; x < kSize; ++x) {
        const double a = 1.08 * (2 * (x + 0.5) / kSize - 1), b = 1.08 * (2 * (y + 0.5) / kSize - 1), r = a * a + b * b;
        if (r >= 1) continue;  // seen from far away: the same number of pixels within a hundredth
        const Direction normal{a, b, std::sqrt(1 - r)}, viewer = fromSpherical(std::acos(normal[2]), 0.0);
        for (std::size_t i = 0; i < count; ++i)
          for (std::size_t axis = 0; axis < 3; ++axis) wo[axis][i] = viewer[axis];
        DirectionPairs<double> pairs{
            {wi[0].data(), wi[1].data(), wi[2].data()}, {wo[0].data(), wo[1].data(), wo[2].data()}, count};
        if (samples == 0) {
          for (std::size_t axis = 0; axis < 3; ++axis) wi[axis][0] = normalized({0.3, 0.2, 1})[axis];
          brdf->evaluate(pairs, values.data(), nullptr);
          sum += values[0] + values[1] + values[2];
          continue;
        }
        brdf->sample({wo[0].data(), wo[1].data(), wo[2].data()}, {u[0].data(), u[1].data()},
                     {wi[0].data(), wi[1].data(), wi[2].data()}, count);
        brdf->pdf(pairs, density.data());
        brdf->evaluate(pairs, values.data(), nullptr);
        for (std::size_t i = 0; i < count; ++i) {
          if (!(wi[2][i] > 0 && density[i] > 0)) continue;
          const double solid = 1 / (density[i] * static_cast<double>(count));
          const double texels = solid * static_cast<double>(radiance.size() * radiance.size()) / 8;
          const auto level = std::min<std::size_t>(static_cast<std::size_t>(std::max(0.0, 0.5 * std::log2(texels))),
                                                   radiance.levels() - 1);
          const auto light = radiance.radiance({wi[0][i], wi[2][i], wi[1][i]}, level);
          for (std::size_t c = 0; c < 3; ++c) sum += values[c * count + i] * light[c] * wi[2][i] * solid;
        }
      }
    benchmark::DoNotOptimize(sum);
  }
  state.counters["frames/s"] =
      benchmark::Counter(static_cast<double>(state.iterations()) / step, benchmark::Counter::kIsRate);
}

#define DRAW(name, ...) \
  BENCHMARK_CAPTURE(draw, name, __VA_ARGS__)->UseRealTime()->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond)
#define LOOP(name, ...) BENCHMARK_CAPTURE(loop, name, __VA_ARGS__)->Unit(benchmark::kMillisecond)
DRAW(lobes_point_light, lobes(), 0);
LOOP(lobes_point_light, lobes(), 0);
DRAW(lobes_environment_100, lobes(), 100);
LOOP(lobes_environment_100, lobes(), 100);
DRAW(lobes_environment_8, lobes(), 8);
DRAW(merl_point_light, merl(), 0);
DRAW(merl_environment_100, merl(), 100);
LOOP(merl_environment_100, merl(), 100);
DRAW(merl_environment_4, merl(), 4);
// What may not be turned about the normal is drawn, evaluated and weighed by the shader, sample by sample.
DRAW(anisotropic_lobes_environment_100,
     parseMaterialExpression("(0.3,0.2,0.1)*Lambertian + 0.5*GGX(alpha=0.1, alpha_y=0.4)"), 100);
DRAW(anisotropic_table_environment_100, anisotropicTable(), 100);
DRAW(openpbr_environment_100, loadMaterial("OpenPBR").brdf, 100);

}  // namespace
