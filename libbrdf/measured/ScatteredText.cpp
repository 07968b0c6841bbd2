#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/ChannelView.h>
#include <brdf/measured/ScatteredText.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>

namespace brdf {
namespace {

/// Polar angles 0 to 85 degrees and azimuth differences, both every 5 degrees; azimuths of the light every 30 degrees
/// when the BRDF is anisotropic.
DirectionPairBuffer<double> grid(Symmetry symmetry) {
  constexpr int step = 5, lastTheta = 85;
  const int lastPhi = symmetry == Symmetry::Isotropic ? 180 : 360 - step;
  const int lastTurn = symmetry == Symmetry::Anisotropic ? 330 : 0;
  std::vector<DirectionPair> all;
  for (int turn = 0; turn <= lastTurn; turn += 30)
    for (int thetaI = 0; thetaI <= lastTheta; thetaI += step)
      for (int thetaO = 0; thetaO <= lastTheta; thetaO += step)
        for (int phi = 0; phi <= lastPhi; phi += step)
          all.push_back(
              {fromSpherical(radians(thetaI), radians(turn)), fromSpherical(radians(thetaO), radians(turn + phi))});
  DirectionPairBuffer<double> pairs(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) pairs.set(i, all[i].wi, all[i].wo);
  return pairs;
}

}  // namespace

std::string_view withoutByteOrderMark(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  return text;
}

const std::vector<std::string>& scatteredOptions() {
  static const std::vector<std::string> keys{"quantity", "incident", "symmetry", "invalid"};
  return keys;
}

ReadResult finishScattered(ScatteredSamples samples, const std::filesystem::path& path, ReadReport report,
                           const ReadOptions& options, Quantity quantity, std::string_view quantityEvidence,
                           std::string_view symmetryEvidence) {
  constexpr std::string_view definition = "the format's definition";
  const std::size_t count = samples.pairs.size(), channelCount = samples.channels.count();
  quantity = choose(options, quantity, quantityEvidence, report);
  if (choose(options, Incident::AsStated, definition, report) == Incident::Swapped)
    std::swap(samples.pairs.wi, samples.pairs.wo);
  const Symmetry stated = samples.isotropic ? Symmetry::Isotropic : Symmetry::Anisotropic;
  samples.isotropic = choose(options, stated, symmetryEvidence, report) == Symmetry::Isotropic;
  const InvalidRule invalid = choose(options, InvalidRule::NotFinite, definition, report);
  report.samples = count;
  samples.valid.assign(count, 1);
  for (std::size_t i = 0; i < count; ++i) {
    bool finite = true, negative = false, zero = false;
    const double factor = toBrdfFactor(quantity, samples.pairs.wo[2][i]);
    for (std::size_t channel = 0; channel < channelCount; ++channel) {
      double& value = samples.values[channel * count + i];
      finite = finite && std::isfinite(value);
      negative = negative || value < 0;
      zero = zero || value == 0;
      if (quantity == Quantity::Brdf) continue;
      value *= factor;
      if (!samples.uncertainty.empty()) samples.uncertainty[channel * count + i] *= factor;
    }
    const bool missing =
        (negative && invalid != InvalidRule::NotFinite) || (zero && invalid == InvalidRule::NotPositive);
    // Two roundings of a right angle are not above the horizon.
    constexpr double horizon = 1e-15;
    const bool below = !(samples.pairs.wi[2][i] > horizon && samples.pairs.wo[2][i] > horizon);
    report.notFinite += !finite;
    report.negative += negative;
    report.belowHorizon += below;
    samples.valid[i] = finite && !below && !missing;
    report.invalid += !samples.valid[i];
  }
  if (report.negative > 0 && invalid == InvalidRule::NotFinite)
    report.warnings.push_back(std::to_string(report.negative) +
                              " samples have a negative value, kept as noise about zero");
  if (report.invalid == count && count > 0) report.warnings.push_back("no sample is valid");
  const std::string description = path.filename().string();
  return {std::make_shared<ScatteredBrdf>(std::move(samples), description), std::move(report)};
}

ScatteredSamples collectSamples(const Brdf& brdf, WriteReport& report) {
  const std::size_t channelCount = brdf.channels().count();
  DirectionPairBuffer<double> pairs;
  std::vector<double> values;
  std::vector<std::uint8_t> valid;
  if (const SampleSet* samples = brdf.samples()) {
    values.resize(channelCount * samples->count());
    valid.resize(samples->count());
    samples->read(0, samples->count(), &pairs, values.data(), valid.data());
  } else {
    pairs = grid(brdf.symmetry());
    values.resize(channelCount * pairs.size());
    valid.resize(pairs.size());
    brdf.evaluateParallel(pairs.view(), values.data(), valid.data());
    report.losses.push_back(
        "sampled on a grid: polar angles 0 to 85 degrees and azimuth differences every 5 degrees, " +
        std::to_string(pairs.size()) + " samples");
  }

  const auto* scattered = dynamic_cast<const ScatteredBrdf*>(&brdf);
  const bool uncertain = scattered && !scattered->data().uncertainty.empty();
  std::size_t kept = 0;
  const std::size_t count = pairs.size();
  for (const std::uint8_t flag : valid) kept += flag;
  ScatteredSamples result{
      brdf.channels(), DirectionPairBuffer<double>(kept), {}, {}, brdf.symmetry() != Symmetry::Anisotropic, {}};
  result.values.resize(channelCount * kept);
  if (uncertain) result.uncertainty.resize(channelCount * kept);
  for (std::size_t i = 0, to = 0; i < count; ++i) {
    if (!valid[i]) continue;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      result.pairs.wi[axis][to] = pairs.wi[axis][i];
      result.pairs.wo[axis][to] = pairs.wo[axis][i];
    }
    for (std::size_t channel = 0; channel < channelCount; ++channel) {
      result.values[channel * kept + to] = values[channel * count + i];
      if (uncertain) result.uncertainty[channel * kept + to] = scattered->data().uncertainty[channel * count + i];
    }
    ++to;
  }
  if (brdf.symmetry() == Symmetry::Bilateral)
    report.losses.push_back("symmetry: read back, pairs and their mirror images count as the same");
  if (kept < count) report.losses.push_back(std::to_string(count - kept) + " invalid samples left out");
  return result;
}

ScatteredSamples collectRgbSamples(const Brdf& brdf, WriteReport& report) {
  const BrdfPointer borrowed(BrdfPointer{}, &brdf);
  return collectSamples(*asRgb(borrowed), report);
}

ScatteredSamples collectLuminanceSamples(const Brdf& brdf, WriteReport& report) {
  const BrdfPointer borrowed(BrdfPointer{}, &brdf);
  if (brdf.channels().count() > 1) report.losses.push_back("colour: reduced to luminance");
  return collectSamples(*asLuminance(borrowed), report);
}

SpectralColumns spectralColumns(const Channels& channels, WriteReport& report) {
  if (channels.kind == Channels::Kind::Rgb) {
    report.losses.push_back("colour: blue, green and red are written as values at 464.2, 549.1 and 611.4 nm");
    return {{464.2, 549.1, 611.4}, {2, 1, 0}};
  }
  if (channels.kind == Channels::Kind::Monochrome) {
    report.losses.push_back("the one channel is written as values at 555 nm");
    return {{555}, {0}};
  }
  SpectralColumns columns{channels.wavelengths, {}};
  for (std::size_t channel = 0; channel < channels.count(); ++channel) columns.channels.push_back(channel);
  return columns;
}

SampleAngles sampleAngles(const ScatteredSamples& samples, std::size_t i) {
  const auto& [wi, wo] = samples.pairs;
  const Spherical light = toSpherical({wi[0][i], wi[1][i], wi[2][i]});
  const Spherical view = toSpherical({wo[0][i], wo[1][i], wo[2][i]});
  if (!samples.isotropic) return {light.theta, light.phi, view.theta, view.phi};
  return {light.theta, 0, view.theta, std::remainder(view.phi - light.phi, 2 * kPi)};
}

std::string_view azimuthEvidence(bool one) {
  return one ? "all samples have one phi_i" : "the samples have several phi_i";
}

bool oneIncidentAzimuth(const ScatteredSamples& samples) {
  constexpr double tolerance = 1e-6;
  const auto& wi = samples.pairs.wi;
  Direction first{};
  for (std::size_t i = 0; i < samples.pairs.size(); ++i) {
    const Direction horizontal = normalized({wi[0][i], wi[1][i], 0});
    if (std::hypot(wi[0][i], wi[1][i]) < tolerance) continue;
    if (dot(first, first) == 0) first = horizontal;
    if (dot(first, horizontal) < 1 - tolerance) return false;
  }
  return true;
}

void writeBytes(const std::filesystem::path& path, std::string_view bytes) {
  std::ofstream out(path, std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) throw Error(Error::Kind::File, {"cannot be written", path.string(), std::strerror(errno), {}});
}

}  // namespace brdf
