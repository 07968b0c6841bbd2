#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/color/Colorimetry.h>
#include <brdf/material/ChannelView.h>
#include <brdf/view/ChannelChoice.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

[[noreturn]] void refuse(const Brdf& brdf, std::string_view choice) {
  const Channels& channels = brdf.channels();
  std::string allowed = "luminance, rgb, all, a channel from 0 to " + std::to_string(channels.count() - 1);
  if (channels.kind == Channels::Kind::Spectral)
    allowed += ", a wavelength from " + formatNumber(channels.wavelengths.front()) + "nm to " +
               formatNumber(channels.wavelengths.back()) + "nm";
  throw Error(Error::Kind::Value, {"unknown channel", "channel", std::string(choice), allowed});
}

ChannelChoice single(BrdfPointer brdf, std::size_t index) {
  std::string label = "channel " + std::to_string(index);
  if (brdf->channels().kind == Channels::Kind::Spectral)
    label = formatNumber(brdf->channels().wavelengths[index]) + " nm";
  return {selectedChannels(std::move(brdf), std::vector<std::size_t>{index}), {1.0}, label};
}

}  // namespace

std::vector<std::string> channelNames(const Channels& channels) {
  if (channels.kind == Channels::Kind::Rgb) return {"red", "green", "blue"};
  if (channels.kind == Channels::Kind::Monochrome) return {"value"};
  std::vector<std::string> names;
  for (const double wavelength : channels.wavelengths) names.push_back(formatNumber(wavelength) + " nm");
  return names;
}

ChannelChoice chooseChannels(BrdfPointer brdf, std::string_view choice, const ColourSettings& settings) {
  if (choice == "luminance") return {asLuminance(std::move(brdf), settings), {1.0}, "luminance"};
  if (choice == "rgb")
    return {
        asRgb(std::move(brdf), settings), {kRgbLuminanceWeights.begin(), kRgbLuminanceWeights.end()}, "linear sRGB"};
  const Channels& channels = brdf->channels();
  if (choice == "all") {
    const std::size_t count = channels.count();
    return {std::move(brdf), std::vector<double>(count, 1.0 / static_cast<double>(count)),
            count == 1 ? "its only channel" : "all " + std::to_string(count) + " channels"};
  }
  if (choice.size() > 2 && choice.substr(choice.size() - 2) == "nm") {
    const auto& known = channels.wavelengths;
    const auto wanted = parseNumber(trimmed(choice.substr(0, choice.size() - 2)));
    if (!wanted || known.empty() || !(*wanted >= known.front() && *wanted <= known.back())) refuse(*brdf, choice);
    const auto nearest = std::min_element(
        known.begin(), known.end(), [&](double a, double b) { return std::abs(a - *wanted) < std::abs(b - *wanted); });
    const auto index = static_cast<std::size_t>(nearest - known.begin());
    return single(std::move(brdf), index);
  }
  const auto index = parseNumber(choice);
  if (!index || !(*index >= 0) || *index != std::floor(*index) || *index >= static_cast<double>(channels.count()))
    refuse(*brdf, choice);
  return single(std::move(brdf), static_cast<std::size_t>(*index));
}

}  // namespace brdf
