// The virtual gonioreflectometer on the CPU: ray queries a second on one thread beside a bare Embree loop over the same
// triangles (a ray to the surface, mirror reflection, again, until it leaves; no tile without end, no energy, no bins),
// over two threads, and error against rays.
#include <brdf/base/Parallel.h>
#include <brdf/simulate/FacetExpression.h>
#include <brdf/simulate/Gonioreflectometer.h>
#include <brdf/simulate/SurfaceKinds.h>

#include <benchmark/benchmark.h>
#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>

#include "Measuring.h"

namespace {

using namespace brdf;

constexpr std::uint64_t kRays = 200'000;
constexpr double kThetaI = 40;  // degrees

/// What is measured: tiles of ten thousand to half a million triangles (smaller ones are repeated, and are not the same
/// scene), with one reflection and with several.
const std::vector<std::pair<const char*, const char*>> kSurfaces = {
    {"grooves", "grooves(width=10, spacing=10, angle=70, jitter=0.2, grooves=32)"},
    {"gaussian_128", "gaussian(rms=0.5, correlation=2, period=32)"},
    {"gaussian_512", "gaussian(rms=0.5, correlation=2)"},
    {"steep_512", "gaussian(rms=2, correlation=2)"}};

Microsurface surfaceOf(const std::string& expression, const std::string& facet) {
  Microsurface surface = makeSurface(expression).surface;
  surface.facets.assign(surface.facetsNeeded(), parseFacet(facet));
  surface.channels = facetChannels(surface.facets);
  return surface;
}

GridLayout layout() {
  using Q = AxisQuantity;
  return {
      Parametrisation::Spherical,
      {GridAxis::uniformCells(Q::ThetaO, 0, kPi / 2, 18), GridAxis::uniformCells(Q::PhiO, 0, 2 * kPi, 72).periodic(),
       GridAxis::listedDegrees(Q::ThetaI, {kThetaI}), GridAxis::listedDegrees(Q::PhiI, {30})}};
}

/// One tile of a height field as Embree's own triangles, and nothing else.
class BareTile {
 public:
  explicit BareTile(const HeightField& field)
      : width_(static_cast<float>(field.periodX())),
        depth_(static_cast<float>(field.periodY())),
        top_(*std::ranges::max_element(field.heights) * 1.001F + 1e-3F) {
    device_ = rtcNewDevice(nullptr);
    scene_ = rtcNewScene(device_);
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    const std::size_t columns = field.columns, rows = field.rows;
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                               12, (columns + 1) * (rows + 1)));
    for (std::size_t j = 0; j <= rows; ++j)
      for (std::size_t i = 0; i <= columns; ++i) {
        *points++ = static_cast<float>(static_cast<double>(i) * field.spacingX);
        *points++ = static_cast<float>(static_cast<double>(j) * field.spacingY);
        *points++ = field.height(i % columns, j % rows);
      }
    auto* corners = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, 2 * columns * rows));
    for (std::size_t j = 0; j < rows; ++j)
      for (std::size_t i = 0; i < columns; ++i) {
        const auto a = static_cast<unsigned>(j * (columns + 1) + i), d = static_cast<unsigned>(a + columns + 1);
        for (const unsigned corner : {a, a + 1, d + 1, a, d + 1, d}) *corners++ = corner;
      }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
  }
  ~BareTile() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }

  /// Queries that the rays took.
  std::uint64_t trace(std::uint64_t rays) const {
    std::uint64_t queries = 0;
    std::uint32_t state = 12345;
    const auto next = [&] {
      state ^= state << 13, state ^= state >> 17, state ^= state << 5;
      return static_cast<float>(state >> 8) * 0x1p-24F;
    };
    const Direction wi = fromSpherical(radians(kThetaI), radians(30.0));
    for (std::uint64_t r = 0; r < rays; ++r) {
      float o[3] = {next() * width_, next() * depth_, top_};
      float d[3] = {static_cast<float>(-wi[0]), static_cast<float>(-wi[1]), static_cast<float>(-wi[2])};
      for (int bounce = 0; bounce < 100; ++bounce) {
        RTCRayHit hit;
        hit.ray = {o[0], o[1], o[2], 1e-4F, d[0], d[1], d[2], 0, std::numeric_limits<float>::infinity(), ~0u, 0, 0};
        hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        ++queries;
#if RTC_VERSION_MAJOR >= 4
        rtcIntersect1(scene_, &hit, nullptr);
#else
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcIntersect1(scene_, &context, &hit);
#endif
        if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) break;
        const float n[3] = {hit.hit.Ng_x, hit.hit.Ng_y, hit.hit.Ng_z};
        const float scale = 2 * (n[0] * d[0] + n[1] * d[1] + n[2] * d[2]) / (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        for (int k = 0; k < 3; ++k) {
          o[k] += hit.ray.tfar * d[k];
          d[k] -= scale * n[k];
        }
      }
    }
    return queries;
  }

 private:
  float width_, depth_, top_;
  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
};

/// Queries a second on one thread, beside the bare loop's; both by turns, the best of each counts.
void beside(benchmark::State& state, const char* expression, const char* facet) {
  const Microsurface surface = surfaceOf(expression, facet);
  const BareTile bare(std::get<HeightField>(surface.shape));
  setThreadCount(1);
  LobeSimulation lobe(makeTransport("cpu", surface), surface.channels, layout(), radians(kThetaI), radians(30.0), 1);
  lobe.add(1000);
  double ours = 0, theirs = 0, rays = 0;
  for (auto _ : state) {
    const std::uint64_t before = lobe.tally().segments;
    const double seconds = secondsOf([&] { lobe.add(kRays); });
    state.SetIterationTime(seconds);
    ours = std::max(ours, static_cast<double>(lobe.tally().segments - before) / seconds);
    rays = std::max(rays, static_cast<double>(kRays) / seconds);
    std::uint64_t queries = 0;
    const double bareSeconds = secondsOf([&] { queries = bare.trace(kRays); });
    theirs = std::max(theirs, static_cast<double>(queries) / bareSeconds);
  }
  setThreadCount(0);
  state.counters["Mrays/s"] = rays * 1e-6;
  state.counters["Mqueries/s"] = ours * 1e-6;
  state.counters["Embree Mqueries/s"] = theirs * 1e-6;
  state.counters["share of Embree"] = ours / theirs;
}

/// Wall-clock time of the same rays on one thread and on two.
void threads(benchmark::State& state) {
  const Microsurface surface = surfaceOf("gaussian(rms=0.5, correlation=2)", "mirror");
  LobeSimulation lobe(makeTransport("cpu", surface), surface.channels, layout(), radians(kThetaI), radians(30.0), 1);
  double best[2] = {1e30, 1e30};
  for (auto _ : state) {
    double total = 0;
    for (std::size_t count : {1, 2}) {
      setThreadCount(count);
      const auto start = std::chrono::steady_clock::now();
      lobe.add(2 * kRays);
      const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      best[count - 1] = std::min(best[count - 1], seconds);
      total += seconds;
    }
    state.SetIterationTime(total);
  }
  setThreadCount(0);
  state.counters["speed-up of two threads"] = best[0] / best[1];
}

/// Noise of the bins after `rays` rays: it halves when they quadruple.
void cost(benchmark::State& state) {
  const Microsurface surface = surfaceOf("gaussian(rms=0.5, correlation=2)", "conductor(eta=0.2, k=3.9)");
  const auto transport = std::shared_ptr<Transport>(makeTransport("cpu", surface));
  const auto rays = static_cast<std::uint64_t>(state.range(0));
  setThreadCount(1);
  for (auto _ : state) {
    LobeSimulation lobe(transport, surface.channels, layout(), radians(kThetaI), radians(30.0), 1);
    state.SetIterationTime(secondsOf([&] { lobe.add(rays); }));
    state.counters["noise"] = lobe.noise();
    state.counters["albedo error"] = lobe.balance().reflected[0].error;
  }
  setThreadCount(0);
}

const int registered = [] {
  for (const auto& [name, expression] : kSurfaces)
    for (const auto& [facetName, facet] :
         {std::pair{"mirror", "mirror"}, std::pair{"metal", "conductor(eta=0.2 0.9 1.1, k=3.9 2.4 2.2)"}})
      benchmark::RegisterBenchmark((std::string("beside_embree/") + name + "/" + facetName).c_str(), beside, expression,
                                   facet)
          ->UseManualTime()
          ->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("threads", threads)->UseManualTime()->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("cost", cost)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond)
      ->RangeMultiplier(4)
      ->Range(1 << 14, 1 << 20);
  return 0;
}();

}  // namespace
