#pragma once
#include <brdf/brdf_export.h>
#include <brdf/color/ColourSettings.h>
#include <brdf/material/Brdf.h>

#include <string_view>
#include <vector>

namespace brdf {

/// What a picture shows of a BRDF's channels.
struct ChannelChoice {
  BrdfPointer brdf;             ///< the BRDF through the channels chosen
  std::vector<double> weights;  ///< one a channel of `brdf`: their weighted sum is the single value that is drawn
  std::string label;            ///< in words, e.g. "luminance", "channel 2", "550 nm"
};

/// Names of channels for tables and legends: "red", "green", "blue"; "550 nm"; "value" of a monochrome BRDF.
BRDF_EXPORT std::vector<std::string> channelNames(const Channels& channels);

/// `choice` is "luminance", "rgb" (three channels, drawn by their luminance), "all" (its own, drawn by their mean), a
/// channel number from 0, or a wavelength with its unit such as "550nm" (the nearest one of spectral data, inside their
/// range). Colours and luminance of spectral data follow `settings`. Throws Error::Kind::Value naming what is allowed.
BRDF_EXPORT ChannelChoice chooseChannels(BrdfPointer brdf, std::string_view choice,
                                         const ColourSettings& settings = {});

}  // namespace brdf
