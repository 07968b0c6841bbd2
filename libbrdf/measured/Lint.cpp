#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/SampleSet.h>
#include <brdf/measured/Lint.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

namespace brdf {
namespace {

constexpr std::size_t kBlock = 16, kBlocks = 1024;  // samples looked at: blocks of neighbours, evenly spaced
constexpr double kMostAlbedo = 1.05, kSteep = 0.7, kAsymmetry = 0.2, kMended = 0.5;
constexpr std::size_t kFewest = 20;  // samples or cells below which nothing is concluded

/// One valid sample: its directions and the mean over its channels.
struct Sample {
  Direction wi, wo;
  double value;
};

std::vector<Sample> draw(const SampleSet& set) {
  std::vector<Sample> samples;
  const std::size_t count = set.count(), channels = set.channels().count();
  const std::size_t blocks = std::min(kBlocks, (count + kBlock - 1) / kBlock);
  DirectionPairBuffer<double> pairs;
  std::vector<double> values(channels * kBlock);
  std::vector<std::uint8_t> valid(kBlock);
  for (std::size_t block = 0; block < blocks; ++block) {
    const std::size_t first = blocks == kBlocks ? block * (count / kBlocks) : block * kBlock;
    const std::size_t length = std::min(kBlock, count - first);
    set.read(first, length, &pairs, values.data(), valid.data());
    for (std::size_t i = 0; i < length; ++i) {
      if (!valid[i]) continue;
      double mean = 0;
      for (std::size_t c = 0; c < channels; ++c) mean += values[c * length + i] / static_cast<double>(channels);
      samples.push_back(
          {{pairs.wi[0][i], pairs.wi[1][i], pairs.wi[2][i]}, {pairs.wo[0][i], pairs.wo[1][i], pairs.wo[2][i]}, mean});
    }
  }
  return samples;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double medianMagnitude(const std::vector<Sample>& samples) {
  std::vector<double> values;
  for (const Sample& sample : samples)
    if (sample.value != 0) values.push_back(std::abs(sample.value));
  return values.empty() ? 0 : median(std::move(values));
}

double angle(const Direction& a, const Direction& b) { return degrees(std::acos(std::clamp(dot(a, b), -1.0, 1.0))); }
Direction mirrored(const Direction& w) { return {-w[0], -w[1], w[2]}; }

std::string text(double value) { return formatNumber(value, 3); }

// ----- the checks ----------------------------------------------------------------------------------------------------

void checkEnergy(const Brdf& brdf, std::vector<LintFinding>& findings) {
  constexpr int kRings = 12, kSectors = 24;
  const std::size_t channels = brdf.channels().count();
  DirectionPairBuffer<double> pairs(kRings * kSectors);
  std::vector<double> values(channels * pairs.size());
  std::vector<std::uint8_t> valid(pairs.size());
  double worst = 0, at = 0;
  for (const double thetaI : {0.0, 30.0, 60.0}) {
    // Equal parts of the projected solid angle, the viewer in the middle of each.
    for (int ring = 0; ring < kRings; ++ring)
      for (int sector = 0; sector < kSectors; ++sector)
        pairs.set(static_cast<std::size_t>(ring * kSectors + sector), fromSpherical(radians(thetaI), 0),
                  fromSpherical(std::asin(std::sqrt((ring + 0.5) / kRings)), 2 * kPi * (sector + 0.5) / kSectors));
    brdf.evaluate(pairs.view(), values.data(), valid.data());
    for (std::size_t c = 0; c < channels; ++c) {
      double sum = 0;
      for (std::size_t i = 0; i < pairs.size(); ++i) sum += values[c * pairs.size() + i];
      const double albedo = kPi * sum / static_cast<double>(pairs.size());
      if (albedo > worst) {
        worst = albedo;
        at = thetaI;
      }
    }
  }
  if (worst <= kMostAlbedo) return;
  const bool factor = worst / kPi <= kMostAlbedo;
  findings.push_back({"energy",
                      "a directional albedo of " + text(worst) + " at theta_i = " + text(at) + " degrees" +
                          (factor ? ", " + text(worst / kPi) + " if the values are pi f" : ""),
                      factor ? "quantity=reflectance_factor" : ""});
}

/// Exponent of cos(theta_o) that the values follow away from the highlight, by the medians of bins; 0 when there are
/// few.
void checkGrazing(const std::vector<Sample>& samples, std::vector<LintFinding>& findings) {
  constexpr std::size_t kBins = 8, kFull = 5;
  constexpr double kLow = 0.08, kHigh = 0.88, kOffMirror = 35, kOffRetro = 15;
  std::array<std::vector<double>, kBins> values;
  std::array<double, kBins> cosines{};
  for (const Sample& sample : samples) {
    const double c = sample.wo[2];
    if (!(c > kLow && c < kHigh && sample.value > 0)) continue;
    if (angle(sample.wo, mirrored(sample.wi)) < kOffMirror || angle(sample.wo, sample.wi) < kOffRetro) continue;
    const auto bin = static_cast<std::size_t>((c - kLow) / (kHigh - kLow) * kBins);
    values[bin].push_back(sample.value);
    cosines[bin] += c;
  }
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    if (values[bin].size() < kFewest) continue;
    const double x = std::log(cosines[bin] / static_cast<double>(values[bin].size())),
                 y = std::log(median(values[bin]));
    n += 1;
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  if (n < kFull) return;
  const double slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
  if (std::abs(slope) < kSteep) return;
  findings.push_back({"grazing",
                      "off the highlight the values follow cos(theta_o)^" + text(slope) + " (medians of " + text(n) +
                          " bins)" +
                          (slope > 0 ? ", as f cos(theta_o) of a diffuse surface does"
                                     : ", as values divided by cos(theta_o) once too often do"),
                      slope > 0 ? "quantity=brdf_cos" : "quantity=brdf"});
}

using Weight = std::function<double(const Sample&)>;

/// Median relative asymmetry of cells of 3 degrees and of those with light and viewer exchanged; negative when few
/// match.
double asymmetry(const std::vector<Sample>& samples, bool isotropic, const Weight& weight, std::size_t& matched) {
  constexpr double kCell = 3;
  using Key = std::array<int, 4>;
  std::map<Key, std::pair<double, double>> cells;  // sum and count
  const auto key = [&](const Direction& a, const Direction& b) {
    const auto cell = [](double degree) { return static_cast<int>(std::floor(degree / kCell + 0.5)); };
    const Spherical first = toSpherical(a), second = toSpherical(b);
    if (isotropic) return Key{cell(degrees(first.theta)), cell(degrees(second.theta)), cell(angle(a, b)), 0};
    return Key{cell(degrees(first.theta)), cell(degrees(second.theta)), cell(degrees(first.phi)),
               cell(degrees(second.phi))};
  };
  for (const Sample& sample : samples) {
    auto& cell = cells[key(sample.wi, sample.wo)];
    cell.first += sample.value * weight(sample);
    cell.second += 1;
  }
  std::vector<double> differences;
  for (const auto& [at, cell] : cells) {
    const Key swapped = isotropic ? Key{at[1], at[0], at[2], 0} : Key{at[1], at[0], at[3], at[2]};
    if (!(at < swapped)) continue;
    const auto found = cells.find(swapped);
    if (found == cells.end()) continue;
    const double a = cell.first / cell.second, b = found->second.first / found->second.second;
    if (a > 0 && b > 0) differences.push_back(2 * std::abs(a - b) / (a + b));
  }
  matched = differences.size();
  return matched < kFewest ? -1 : median(std::move(differences));
}

void checkReciprocity(const std::vector<Sample>& samples, bool isotropic, std::vector<LintFinding>& findings) {
  std::size_t matched = 0;
  const double found = asymmetry(
      samples, isotropic, [](const Sample&) { return 1.0; }, matched);
  if (found < kAsymmetry) return;
  const double divided = asymmetry(
      samples, isotropic, [](const Sample& s) { return 1 / s.wo[2]; }, matched);
  const double multiplied = asymmetry(
      samples, isotropic, [](const Sample& s) { return s.wo[2]; }, matched);
  std::string evidence = "light and viewer exchanged, the values differ by " + text(found) + " (median of " +
                         std::to_string(matched) + " cells, relative)";
  std::string option;
  if (divided < kMended * found && divided <= multiplied) {
    evidence += "; divided by cos(theta_o) by " + text(divided);
    option = "quantity=brdf_cos";
  } else if (multiplied < kMended * found) {
    evidence += "; multiplied by cos(theta_o) by " + text(multiplied);
    option = "quantity=brdf";
  }
  findings.push_back({"reciprocity", std::move(evidence), std::move(option)});
}

void checkAngles(const std::vector<Sample>& samples, std::vector<LintFinding>& findings) {
  double largest = 0;
  for (const Sample& sample : samples)
    largest = std::max({largest, toSpherical(sample.wi).theta, toSpherical(sample.wo).theta});
  if (samples.size() >= kFewest && largest < radians(1.6))
    findings.push_back({"angles", "no polar angle is above " + text(degrees(largest)) + " degrees", "angles=radians"});
}

void checkMarks(const std::vector<Sample>& samples, std::vector<LintFinding>& findings) {
  std::map<double, std::size_t> negatives;
  std::size_t negative = 0, zero = 0;
  double smallest = HUGE_VAL;
  for (const Sample& sample : samples) {
    if (sample.value < 0) {
      ++negatives[sample.value];
      ++negative;
    } else if (sample.value == 0) {
      ++zero;
    } else {
      smallest = std::min(smallest, sample.value);
    }
  }
  for (const auto& [value, count] : negatives)
    if (count >= 3 && 2 * count > negative)
      findings.push_back({"negative",
                          "the value " + text(value) + " stands " + std::to_string(count) + " times among " +
                              std::to_string(negative) + " negative ones",
                          "invalid=negative"});
  // Zeros next to values that never come near them.
  const double typical = medianMagnitude(samples);
  if (zero >= kFewest && 100 * zero > samples.size() && smallest > 1e-3 * typical && typical > 0)
    findings.push_back({"zero",
                        std::to_string(zero) + " of " + std::to_string(samples.size()) +
                            " samples are 0, the smallest other value is " + text(smallest),
                        "invalid=not_positive"});
}

void checkHighlight(const std::vector<Sample>& samples, std::vector<LintFinding>& findings) {
  constexpr double kTilted = 20, kContrast = 5, kFar = 30, kGrazing = 75;
  constexpr std::size_t kPeak = 5;
  std::vector<Sample> tilted;
  for (const Sample& sample : samples)
    if (sample.wi[2] < std::cos(radians(kTilted)) && sample.wi[2] > std::cos(radians(kGrazing)) &&
        sample.wo[2] > std::cos(radians(kGrazing)))
      tilted.push_back(sample);
  if (tilted.size() < kFewest) return;
  // Without samples near the mirror direction nothing is known of a peak there.
  const auto near = [&](const Sample& sample) { return angle(sample.wo, mirrored(sample.wi)) < 10; };
  if (std::none_of(tilted.begin(), tilted.end(), near)) return;
  std::partial_sort(tilted.begin(), tilted.begin() + kPeak, tilted.end(),
                    [](const Sample& a, const Sample& b) { return a.value > b.value; });
  if (!(tilted[kPeak - 1].value > kContrast * medianMagnitude(samples))) return;
  std::vector<double> fromMirror, fromLight;
  for (std::size_t i = 0; i < kPeak; ++i) {
    fromMirror.push_back(angle(tilted[i].wo, mirrored(tilted[i].wi)));
    fromLight.push_back(angle(tilted[i].wo, tilted[i].wi));
  }
  const double mirror = median(std::move(fromMirror)), light = median(std::move(fromLight));
  if (mirror <= kFar) return;
  findings.push_back({"highlight",
                      "the largest values lie " + text(mirror) + " degrees from the mirror direction and " +
                          text(light) + " from the light: " +
                          (light < 10 ? "a retro-reflector, or azimuths that count from the other side"
                                      : "azimuths of light and viewer may count from different directions"),
                      ""});
}

}  // namespace

std::string LintFinding::sentence() const {
  return check + ": " + evidence + (option.empty() ? "" : " (option " + option + ")");
}

std::vector<LintFinding> lint(const Brdf& brdf) {
  std::vector<LintFinding> findings;
  const SampleSet* set = brdf.samples();
  if (!set) return findings;
  const std::vector<Sample> samples = draw(*set);
  if (samples.empty()) return findings;
  checkEnergy(brdf, findings);
  checkGrazing(samples, findings);
  checkReciprocity(samples, brdf.symmetry() != Symmetry::Anisotropic, findings);
  checkAngles(samples, findings);
  checkMarks(samples, findings);
  checkHighlight(samples, findings);
  return findings;
}

}  // namespace brdf
