#include <brdf/io/StoredValues.h>

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>

namespace brdf::stored {
namespace {

constexpr std::array<std::string_view, 3> kChannelKinds = {"monochrome", "rgb", "spectral"};
constexpr std::uint64_t kMaximumValues = std::uint64_t{1} << 29;  // 4 GiB

std::uint64_t product(const Sizes& shape) {
  return std::accumulate(shape.begin(), shape.end(), std::uint64_t{1}, std::multiplies<>());
}

std::string text(const Sizes& shape) {
  std::string result;
  for (const std::uint64_t size : shape) result += (result.empty() ? "" : " x ") + std::to_string(size);
  return result;
}

}  // namespace

std::string valueName(std::size_t channel) { return "value_" + std::to_string(channel); }
std::string errorName(std::size_t channel) { return "error_" + std::to_string(channel); }

void broken(const h5::Group& group, std::string what, std::string found, std::string allowed) {
  throw Error(Error::Kind::Format, {std::move(what), group.where(), std::move(found), std::move(allowed)});
}

void storeChannels(const h5::Group& group, const Channels& channels) {
  group.setText("Channels", kChannelKinds[static_cast<std::size_t>(channels.kind)]);
  group.setNumbers("Wavelengths_nm", channels.wavelengths);
}

Channels restoreChannels(const h5::Group& group) {
  Channels channels{restoreChoice<Channels::Kind>(group, "Channels", kChannelKinds), group.numbers("Wavelengths_nm")};
  const bool ascending = std::adjacent_find(channels.wavelengths.begin(), channels.wavelengths.end(),
                                            [](double a, double b) { return !(a < b); }) == channels.wavelengths.end();
  if ((channels.kind == Channels::Kind::Spectral) == channels.wavelengths.empty() || !ascending)
    broken(group, "wavelengths do not fit the channels", std::to_string(channels.wavelengths.size()) + " wavelengths",
           "ascending ones for spectral channels, none otherwise");
  return channels;
}

void storeValues(const h5::Group& group, const double* values, const std::uint8_t* valid, std::size_t channels,
                 const Sizes& shape) {
  const std::uint64_t count = product(shape);
  for (std::size_t c = 0; c < channels; ++c) group.writeArray(valueName(c), values + c * count, shape);
  group.writeArray("valid", valid, shape);
}

std::vector<double> restoreChannelArrays(const h5::Group& group, std::string (*name)(std::size_t), std::size_t channels,
                                         const Sizes& shape) {
  const std::uint64_t count = product(shape);
  if (channels > kMaximumValues / std::max<std::uint64_t>(count, 1))
    broken(group, "too many values", std::to_string(channels) + " channels of " + std::to_string(count),
           "at most " + std::to_string(kMaximumValues));
  for (std::size_t c = 0; c < channels; ++c)
    if (const Sizes found = group.dimensions(name(c)); found != shape)
      broken(group, name(c) + " is of the wrong shape", text(found), text(shape));
  std::vector<double> values(channels * count);
  for (std::size_t c = 0; c < channels; ++c) group.readArray(name(c), values.data() + c * count, shape);
  return values;
}

void restoreValues(const h5::Group& group, std::size_t channels, const Sizes& shape, std::vector<double>& values,
                   std::vector<std::uint8_t>& valid) {
  values = restoreChannelArrays(group, valueName, channels, shape);
  valid.resize(product(shape));
  group.readArray("valid", valid.data(), shape);
}

}  // namespace brdf::stored
