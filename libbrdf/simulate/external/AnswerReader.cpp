#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/simulate/external/AnswerReader.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace brdf {
namespace {

constexpr std::string_view kWavelengths = "# wavelengths_nm:";
constexpr std::size_t kMostShown = 60;  // characters of a line in an error

bool isSeparator(char c) { return c == ' ' || c == '\t' || c == '\r' || c == ',' || c == ';'; }

/// Calls `word` for each piece between separators.
template <class Word>
void forEachWord(std::string_view text, Word&& word) {
  std::size_t i = 0;
  while (i < text.size()) {
    if (isSeparator(text[i])) {
      ++i;
      continue;
    }
    const std::size_t start = i;
    while (i < text.size() && !isSeparator(text[i])) ++i;
    word(text.substr(start, i - start));
  }
}

[[noreturn]] void fail(std::size_t line, const std::string& what, std::string_view found, const std::string& allowed) {
  std::string shown(found.substr(0, kMostShown));
  std::ranges::replace_if(
      shown, [](char c) { return static_cast<unsigned char>(c) < 32; }, ' ');
  throw Error(Error::Kind::Value,
              {what, "line " + std::to_string(line) + " of its output", "'" + shown + "'", allowed});
}

}  // namespace

AnswerReader::AnswerReader(std::optional<Channels> channels, std::size_t pairs)
    : channels_(std::move(channels)), pairs_(pairs) {}

void AnswerReader::takeWavelengths(std::string_view list) {
  std::vector<double> wavelengths;
  forEachWord(list, [&](std::string_view word) {
    const auto value = parseNumber(word);
    if (!value || !std::isfinite(*value) || *value <= 0 || (!wavelengths.empty() && *value <= wavelengths.back()))
      fail(line_, "unusable wavelength", word, "ascending wavelengths in nm");
    wavelengths.push_back(*value);
  });
  if (channels_ && *channels_ != Channels::spectral(wavelengths))
    fail(line_, "other wavelengths than before", list, "the same for every batch, and as --channels says");
  announced_ = std::move(wavelengths);
}

void AnswerReader::learnChannels(std::size_t columns) {
  if (!announced_.empty())
    channels_ = Channels::spectral(announced_);
  else if (columns == 1)
    channels_ = Channels::monochrome();
  else if (columns == 3)
    channels_ = Channels::rgb();
  else
    fail(line_, "what its columns mean is not known", std::to_string(columns) + " values",
         "1 (monochrome), 3 (linear sRGB), or a line \"# wavelengths_nm: 450 550 ...\" before the first");
}

void AnswerReader::take(std::string_view line) {
  ++line_;
  if (line.starts_with(kWavelengths)) return takeWavelengths(line.substr(kWavelengths.size()));
  if (line.starts_with('#') || (rows_ == 0 && line.starts_with("value"))) return;
  numbers_.clear();
  forEachWord(line, [&](std::string_view word) {
    const auto value = parseNumber(word);
    if (!value) fail(line_, "not a number", word, "values in 1/sr, or nan where there is none");
    if (std::isinf(*value) || *value < 0)
      fail(line_, "not a value of a BRDF", word, "finite values in 1/sr, not negative, or nan where there is none");
    numbers_.push_back(*value + 0.0);  // no negative zero
  });
  if (!channels_) learnChannels(numbers_.size());
  if (numbers_.size() != channels_->count())
    fail(line_, "wrong number of values", line, std::to_string(channels_->count()) + ", one a channel");
  if (complete())
    fail(line_, "more lines than directions", line,
         std::to_string(pairs_) + " lines of values, one a pair of directions");
  values_.insert(values_.end(), numbers_.begin(), numbers_.end());
  ++rows_;
}

}  // namespace brdf
