#pragma once
#include <brdf/material/Channels.h>

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace brdf {

/// Reads what a program prints for a batch of direction pairs: one line of numbers a pair, separated by commas or
/// blanks. Lines that start with '#' mean nothing, but "# wavelengths_nm: 450 550" before the first values; a header
/// "value_0,value_1,..." may come first.
class AnswerReader {
 public:
  /// `channels` empty: one number is monochrome, three are linear sRGB, and others need their wavelengths.
  AnswerReader(std::optional<Channels> channels, std::size_t pairs);

  /// A line that is not blank. Throws Error::Kind::Value with the line's number in `where`.
  void take(std::string_view line);

  std::size_t rows() const { return rows_; }
  bool complete() const { return rows_ == pairs_; }
  /// After the first row.
  const Channels& channels() const { return *channels_; }
  /// One number a channel for row `row`; not a number: there is no value.
  const double* row(std::size_t row) const { return values_.data() + row * channels_->count(); }

 private:
  void takeWavelengths(std::string_view list);
  void learnChannels(std::size_t columns);

  std::optional<Channels> channels_;
  std::vector<double> announced_;  // wavelengths in nm
  std::vector<double> values_, numbers_;
  std::size_t pairs_, rows_ = 0, line_ = 0;
};

}  // namespace brdf
