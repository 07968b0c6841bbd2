#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/measured/GridFile.h>
#include <brdf/measured/GridReading.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

constexpr double kHorizon = 1e-9;  // radians: listed angles rounded to 6 decimals of a degree are as near

ComponentKind otherSide(ComponentKind kind) {
  switch (kind) {
    case ComponentKind::FrontReflection:
      return ComponentKind::BackReflection;
    case ComponentKind::BackReflection:
      return ComponentKind::FrontReflection;
    case ComponentKind::FrontTransmission:
      return ComponentKind::BackTransmission;
    default:
      return ComponentKind::FrontTransmission;
  }
}

/// Valid nowhere.
BrdfPointer nothing() {
  GridData data{{Parametrisation::Spherical, {{AxisQuantity::ThetaI, {0}}}}, Channels::monochrome(), {0}, {}};
  data.states = {stateByte(CellState::Invalid)};
  return std::make_shared<GridBrdf>(std::move(data), "no distribution");
}

}  // namespace

GridAxis polarAxis(AxisQuantity quantity, const std::vector<double>& degrees) {
  GridAxis axis = GridAxis::listedDegrees(quantity, degrees);
  if (quantity != AxisQuantity::ThetaI) axis.outside = Outside::Invalid;
  return axis;
}

bool fullTurn(const std::vector<double>& degrees) {
  double step = 0;
  for (std::size_t i = 1; i < degrees.size(); ++i) step = std::max(step, degrees[i] - degrees[i - 1]);
  const double gap = 360 - (degrees.back() - degrees.front());
  return gap > -1e-6 && gap <= step * (1 + 1e-6);
}

GridAxis azimuthAxis(AxisQuantity quantity, const std::vector<double>& degrees, bool mirrored, ReadReport& report) {
  GridAxis axis = GridAxis::listedDegrees(quantity, degrees);
  if (!mirrored && degrees.size() > 1 && fullTurn(degrees)) return std::move(axis).periodic();
  axis.outside = Outside::Invalid;
  const bool complete = degrees.size() == 1 || (mirrored && degrees.front() < 1e-6 && degrees.back() > 180 - 1e-6);
  if (!complete)
    report.warnings.push_back(std::string(axisName(quantity)) + " from " + formatNumber(degrees.front(), 6) + " to " +
                              formatNumber(degrees.back(), 6) + " degrees only: no value beyond");
  return axis;
}

void mirrorAzimuth(GridData& data, AxisQuantity quantity) {
  const std::size_t which = data.layout.find(quantity);
  std::size_t stride = 1;
  for (std::size_t a = 0; a < which; ++a) stride *= data.layout.axes[a].size();
  GridAxis& axis = data.layout.axes[which];
  std::vector<double> nodes = axis.nodes;
  std::vector<std::size_t> from(nodes.size());
  for (std::size_t i = 0; i < from.size(); ++i) from[i] = i;
  for (std::size_t i = axis.size(); i-- > 0;) {
    if (axis.nodes[i] > kPi - kHorizon || axis.nodes[i] < kHorizon) continue;
    nodes.push_back(2 * kPi - axis.nodes[i]);
    from.push_back(i);
  }
  const std::size_t rows = data.values.size() / (stride * axis.size());
  std::vector<double> values;
  values.reserve(rows * nodes.size() * stride);
  for (std::size_t row = 0; row < rows; ++row)
    for (const std::size_t i : from) {
      const auto first = data.values.begin() + static_cast<std::ptrdiff_t>((row * axis.size() + i) * stride);
      values.insert(values.end(), first, first + static_cast<std::ptrdiff_t>(stride));
    }
  axis.nodes = std::move(nodes);
  axis.period = 2 * kPi;
  data.values = std::move(values);
}

const std::vector<std::string>& gridOptions() {
  static const std::vector<std::string> keys{"quantity", "symmetry", "colour", "invalid", "sides"};
  return keys;
}

bool chooseMirror(const ReadOptions& options, bool stated, bool turns, const std::filesystem::path& path,
                  ReadReport& report) {
  if (!options.symmetry) return stated;
  const Symmetry byFormat = turns ? Symmetry::Anisotropic : stated ? Symmetry::Isotropic : Symmetry::Bilateral;
  const Symmetry symmetry = choose(options, byFormat, "the file's azimuths and symmetry", report);
  if (symmetry != byFormat && !(byFormat == Symmetry::Bilateral && symmetry == Symmetry::Isotropic))
    throw Error(Error::Kind::Value, {"the file contradicts the symmetry given", path.string() + ", option symmetry",
                                     turns    ? "several azimuths of the light"
                                     : stated ? "one azimuth, mirrored"
                                              : "one azimuth of the light",
                                     turns    ? "anisotropic"
                                     : stated ? "isotropic"
                                              : "bilateral, isotropic"});
  return stated || symmetry == Symmetry::Isotropic;
}

GridConventions chooseConventions(const ReadOptions& options, Quantity quantity, std::string_view quantityEvidence,
                                  std::optional<ColourSpace> colour, std::string_view colourEvidence,
                                  ReadReport& report) {
  GridConventions conventions;
  conventions.quantity = choose(options, quantity, quantityEvidence, report);
  conventions.invalid = choose(options, InvalidRule::NotFinite, "the format marks none", report);
  conventions.sides = choose(options, Sides::AsStated, "the format's definition", report);
  if (colour)
    conventions.colour = choose(options, *colour, colourEvidence, report);
  else if (options.colour)
    throw Error(Error::Kind::Value, {"the file's values are no colours", "option colour", {}, "no such option"});
  return conventions;
}

std::shared_ptr<const GridBrdf> finishPart(GridData data, const GridConventions& conventions,
                                           const std::filesystem::path& path, ReadReport& report) {
  try {
    data.layout.check(path.string());
  } catch (const Error& error) {
    throw Error(Error::Kind::Format, error.details());
  }
  if (data.layout.surfaceSymmetry() != Symmetry::Anisotropic) {
    const std::string sentence = std::string("symmetry: the surface may be turned about its normal") +
                                 (data.layout.symmetry.mirror ? " and mirrored in the plane of incidence" : "") +
                                 " (the file has one azimuth of the light)";
    if (std::find(report.assumptions.begin(), report.assumptions.end(), sentence) == report.assumptions.end())
      report.assumptions.push_back(sentence);
  }
  const std::size_t cells = data.layout.cells(), channelCount = data.channels.count();
  const auto invalidCells = [&] {
    return static_cast<std::uint64_t>(
        std::count(data.states.begin(), data.states.end(), stateByte(CellState::Invalid)));
  };
  data.states.assign(cells, stateByte(CellState::Measured));
  std::vector<std::uint8_t> above(cells);
  DirectionPairBuffer<double> pairs;
  constexpr std::size_t block = 65536;
  for (std::size_t first = 0; first < cells; first += block) {
    const std::size_t length = std::min(block, cells - first);
    data.layout.directions(first, length, pairs);
    for (std::size_t k = 0; k < length; ++k) {
      bool filler = true;
      for (std::size_t c = 0; c < channelCount; ++c) filler = filler && data.values[c * cells + first + k] == 0;
      const double lowest = std::min(pairs.wi[2][k], pairs.wo[2][k]);
      above[first + k] = !(lowest < -kHorizon || (lowest < kHorizon && filler));
      if (!above[first + k]) data.states[first + k] = stateByte(CellState::Invalid);
    }
  }
  inspectCells(
      data.values, data.states, conventions.invalid,
      [&](std::size_t first, std::size_t count, std::uint8_t* flags) { std::copy_n(&above[first], count, flags); },
      report);
  const std::uint64_t before = invalidCells();
  if (data.channels.kind == Channels::Kind::Rgb) toLinearSrgb(data.values, conventions.colour);
  convertQuantity(data, conventions.quantity);
  report.invalid += invalidCells() - before;
  return std::make_shared<GridBrdf>(std::move(data), path.filename().string());
}

ReadResult assemble(std::vector<ScatterComponent> parts, Components others, Sides sides, ReadReport report) {
  ReadResult result{nullptr, std::move(report), std::move(others)};
  const auto turn = [&](auto& list) {
    if (sides == Sides::Swapped)
      for (auto& component : list) component.kind = otherSide(component.kind);
  };
  turn(parts);
  turn(result.components.specular);
  turn(result.components.totals);
  for (const SpecularComponent& specular : result.components.specular) specular.check();
  for (ScatterComponent& part : parts)
    if (part.kind == ComponentKind::FrontReflection)
      result.brdf = std::move(part.brdf);
    else
      result.components.scatter.push_back(std::move(part));
  std::vector<std::string>& warnings = result.report.warnings;
  result.components.front = result.brdf != nullptr;
  if (!result.brdf && !result.components.scatter.empty()) {
    result.brdf = result.components.scatter.front().brdf;
    warnings.push_back("the file has no front reflection: what stands for it is its " +
                       std::string(componentName(result.components.scatter.front().kind)));
  } else if (!result.brdf) {
    result.brdf = nothing();
    warnings.push_back("the file has no distribution, only specular fractions: its BRDF is valid nowhere");
  }
  if (result.report.negative > 0)
    warnings.push_back(std::to_string(result.report.negative) + " cells have a negative value");
  if (result.report.samples > 0)
    result.report.assumptions.push_back(
        "between the listed angles: linear; beyond the first and the last incidence: as there; cells below the "
        "horizon: fillers");
  return result;
}

std::vector<double> directionalReflectance(const Brdf& brdf, const Direction& wi, const Direction& pole,
                                           const std::vector<double>& polarNodes) {
  // M. Abramowitz and I. Stegun 1964, Handbook of Mathematical Functions, table 25.4, n = 4.
  constexpr std::array<double, 4> abscissa{-0.861136311594052575, -0.339981043584856265, 0.339981043584856265,
                                           0.861136311594052575};
  constexpr std::array<double, 4> weight{0.347854845137453857, 0.652145154862546143, 0.652145154862546143,
                                         0.347854845137453857};
  constexpr int around = 120;
  // Towards the normal from the pole; from the normal itself, towards the light.
  Direction first{-pole[2] * pole[0], -pole[2] * pole[1], 1 - pole[2] * pole[2]};
  if (dot(first, first) < 1e-24) {
    const double length = std::hypot(wi[0], wi[1]);
    first = length > 0 ? Direction{wi[0] / length, wi[1] / length, 0} : Direction{1, 0, 0};
  }
  first = normalized(first);
  const Direction second = cross(pole, first);
  std::vector<DirectionPair> pairs;
  std::vector<double> weights;
  for (std::size_t k = 0; k + 1 < polarNodes.size(); ++k) {
    const double from = polarNodes[k], span = polarNodes[k + 1] - from;
    const int stretches = std::max(1, static_cast<int>(std::ceil(degrees(span) / 5 - 1e-9)));
    const double half = span / stretches / 2;
    for (int stretch = 0; stretch < stretches; ++stretch)
      for (std::size_t g = 0; g < 4; ++g) {
        const double theta = from + half * (2 * stretch + 1 + abscissa[g]);
        for (int a = 0; a < around; ++a) {
          const Direction local = fromSpherical(theta, radians((a + 0.5) * 360 / around));
          Direction wo;
          for (std::size_t x = 0; x < 3; ++x) wo[x] = local[0] * first[x] + local[1] * second[x] + local[2] * pole[x];
          if (!(wo[2] > 0)) continue;
          pairs.push_back({wi, wo});
          weights.push_back(weight[g] * half * radians(360.0 / around) * std::sin(theta) * wo[2]);
        }
      }
  }
  DirectionPairBuffer<double> buffer(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) buffer.set(i, pairs[i].wi, pairs[i].wo);
  const std::size_t channelCount = brdf.channels().count();
  std::vector<double> values(channelCount * pairs.size()), sums(channelCount, 0);
  brdf.evaluateParallel(buffer.view(), values.data(), nullptr);
  for (std::size_t c = 0; c < channelCount; ++c)
    for (std::size_t i = 0; i < pairs.size(); ++i) sums[c] += weights[i] * values[c * pairs.size() + i];
  return sums;
}

}  // namespace brdf
