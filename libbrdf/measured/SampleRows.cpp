#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/color/Colorimetry.h>
#include <brdf/geometry/Directions.h>
#include <brdf/measured/Format.h>
#include <brdf/measured/SampleRows.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace brdf {
namespace {

bool finite(const Direction& w) { return std::isfinite(w[0]) && std::isfinite(w[1]) && std::isfinite(w[2]); }

/// Rows of `channels` numbers as planes.
std::vector<double> planar(const std::vector<double>& rows, std::size_t channels) {
  std::vector<double> planes(rows.size());
  const std::size_t count = rows.size() / channels;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t channel = 0; channel < channels; ++channel)
      planes[channel * count + i] = rows[i * channels + channel];
  return planes;
}

}  // namespace

void SampleRows::add(DirectionPair pair, std::span<const double> values, std::span<const double> uncertainty) {
  if (!finite(pair.wi) || !finite(pair.wo)) pair = {};
  pairs_.push(pair.wi, pair.wo);
  values_.insert(values_.end(), values.begin(), values.end());
  uncertainty_.insert(uncertainty_.end(), uncertainty.begin(), uncertainty.end());
}

ScatteredSamples SampleRows::samples(Channels channels, bool isotropic) const {
  ScatteredSamples result;
  result.channels = std::move(channels);
  result.pairs = pairs_;
  result.values = planar(values_, channels_);
  result.uncertainty = planar(uncertainty_, channels_);
  result.isotropic = isotropic;
  return result;
}

WavelengthOrder orderWavelengths(std::span<const double> nanometres, const std::string& where) {
  WavelengthOrder order;
  order.columns.resize(nanometres.size());
  std::iota(order.columns.begin(), order.columns.end(), std::size_t{0});
  for (const double wavelength : nanometres)
    if (!(wavelength >= 10 && wavelength <= 1e6))
      throw Error(Error::Kind::Format,
                  {"wrong wavelength", where, formatNumber(wavelength) + " nm", "10 to 1000000 nm"});
  std::sort(order.columns.begin(), order.columns.end(),
            [&](std::size_t a, std::size_t b) { return nanometres[a] < nanometres[b]; });
  for (const std::size_t column : order.columns) {
    if (!order.wavelengths.empty() && order.wavelengths.back() == nanometres[column])
      throw Error(Error::Kind::Format,
                  {"a wavelength stands twice", where, formatNumber(nanometres[column]) + " nm", {}});
    order.wavelengths.push_back(nanometres[column]);
  }
  return order;
}

void toLinearSrgb(ScatteredSamples& samples, const ReadOptions& options, ColourSpace byFormat,
                  std::string_view evidence, ReadReport& report) {
  if (samples.channels.kind != Channels::Kind::Rgb) {
    if (options.colour)
      throw Error(Error::Kind::Value,
                  {"the file's values are no colours", "option colour",
                   std::to_string(samples.channels.count()) + " values a sample", "no such option"});
    return;
  }
  const ColourSpace space = choose(options, byFormat, evidence, report);
  if (space == ColourSpace::LinearSrgb) return;
  const std::size_t count = samples.pairs.size();
  const Matrix3 matrix = xyzToLinearSrgb();
  for (std::size_t i = 0; i < count; ++i) {
    std::array<double, 3> in{}, out{};
    for (std::size_t c = 0; c < 3; ++c) in[c] = samples.values[c * count + i];
    for (std::size_t c = 0; c < 3; ++c)
      out[c] = space == ColourSpace::EncodedSrgb ? decodeSrgb(in[c])
                                                 : matrix[c][0] * in[0] + matrix[c][1] * in[1] + matrix[c][2] * in[2];
    for (std::size_t c = 0; c < 3; ++c) samples.values[c * count + i] = out[c];
  }
  if (!samples.uncertainty.empty()) {
    samples.uncertainty.clear();
    report.warnings.push_back("uncertainties are dropped: they are of other colour components");
  }
}

}  // namespace brdf
