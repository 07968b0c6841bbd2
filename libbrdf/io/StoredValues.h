#pragma once
// What the kinds of stored BRDFs share. Internal to libbrdf/io.
#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/io/Hdf5.h>
#include <brdf/material/Channels.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace brdf::stored {

using Sizes = std::vector<std::uint64_t>;

/// "value_3": the array of a channel's values; "error_3": of its standard errors.
std::string valueName(std::size_t channel);
std::string errorName(std::size_t channel);

[[noreturn]] void broken(const h5::Group& group, std::string what, std::string found, std::string allowed);

/// The attribute `name` as one of an enumeration, whose texts are `names` in its order.
template <class Enum>
Enum restoreChoice(const h5::Group& group, const char* name, std::span<const std::string_view> names) {
  const std::string text = group.text(name);
  const auto found = std::find(names.begin(), names.end(), text);
  if (found == names.end()) broken(group, std::string("unknown ") + name, text, joined(names));
  return static_cast<Enum>(found - names.begin());
}

void storeChannels(const h5::Group& group, const Channels& channels);
Channels restoreChannels(const h5::Group& group);

/// Planar values a channel an array, and the flags "valid".
void storeValues(const h5::Group& group, const double* values, const std::uint8_t* valid, std::size_t channels,
                 const Sizes& shape);
/// One array a channel, called `name`(channel) and of that shape, as planar values. The sizes of all are checked before
/// memory is taken.
std::vector<double> restoreChannelArrays(const h5::Group& group, std::string (*name)(std::size_t), std::size_t channels,
                                         const Sizes& shape);
void restoreValues(const h5::Group& group, std::size_t channels, const Sizes& shape, std::vector<double>& values,
                   std::vector<std::uint8_t>& valid);

}  // namespace brdf::stored
