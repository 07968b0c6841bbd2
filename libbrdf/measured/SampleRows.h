#pragma once
#include <brdf/material/ScatteredBrdf.h>
#include <brdf/measured/ReadOptions.h>

#include <span>
#include <string_view>
#include <vector>

namespace brdf {

/// Collects scattered samples in the order in which most files list them: all values of a sample together.
class SampleRows {
 public:
  explicit SampleRows(std::size_t channels) : channels_(channels) {}

  /// Adds a sample with one value a channel, and uncertainties (one a channel, or none; the same for every sample).
  /// Directions that are not finite become (0, 0, 0), which counts as below the horizon.
  void add(DirectionPair pair, std::span<const double> values, std::span<const double> uncertainty = {});

  std::size_t size() const { return pairs_.size(); }
  bool empty() const { return size() == 0; }

  /// The samples, planar. `channels` has as many channels as a row.
  ScatteredSamples samples(Channels channels, bool isotropic) const;

 private:
  std::size_t channels_;
  DirectionPairBuffer<double> pairs_;
  std::vector<double> values_, uncertainty_;  ///< row after row
};

/// Wavelengths in ascending order and the row's column of each; the order that spectral channels must have. Throws
/// Error::Kind::Format with `where` when a wavelength stands twice or is not 10 nm to 1 mm.
struct WavelengthOrder {
  std::vector<double> wavelengths;   ///< nanometres, ascending
  std::vector<std::size_t> columns;  ///< columns[c] is the column of wavelengths[c]
};
WavelengthOrder orderWavelengths(std::span<const double> nanometres, const std::string& where);

/// Makes colour triples linear sRGB, from the space that the options or else the format say; uncertainties are dropped
/// where that mixes the components or is not linear, and a warning says so. Samples without colour are left alone;
/// Error::Kind::Value when the options give their colour all the same.
void toLinearSrgb(ScatteredSamples& samples, const ReadOptions& options, ColourSpace byFormat,
                  std::string_view evidence, ReadReport& report);

}  // namespace brdf
