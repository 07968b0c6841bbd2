#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/fit/SpherePicture.h>
#include <brdf/view/ErrorMeasure.h>

#include <array>
#include <cctype>

namespace brdf {
namespace {

constexpr std::array<std::pair<std::string_view, ErrorAverage>, 3> kAverages{
    {{"rms", ErrorAverage::RootMeanSquare}, {"absolute", ErrorAverage::Absolute}, {"signed", ErrorAverage::Signed}}};

/// The formula with f_A for f and f_B for t.
std::string inNames(const std::string& formula) {
  const auto partOfWord = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
  std::string text;
  for (std::size_t i = 0; i < formula.size(); ++i) {
    const bool alone = (i == 0 || !partOfWord(formula[i - 1])) &&
                       (i + 1 == formula.size() || !(partOfWord(formula[i + 1]) || formula[i + 1] == '('));
    text += formula[i] == 'f' && alone ? "f_A" : formula[i] == 't' && alone ? "f_B" : std::string(1, formula[i]);
  }
  return text;
}

std::string unitOf(const ErrorMeasure& measure) {
  return measure.metric->unit().empty() ? "" : " (" + measure.metric->unit() + ")";
}

}  // namespace

ErrorMeasure parseErrorMeasure(std::string_view measure, std::string_view average) {
  ErrorMeasure result{nullptr, ErrorAverage::RootMeanSquare};
  if (measure == "difference" || measure == "absolute") {
    result = {findMetric("rms"), measure == "difference" ? ErrorAverage::Signed : ErrorAverage::Absolute};
  } else {
    result.metric = findMetric(measure);
    if (std::dynamic_pointer_cast<const SphereMetric>(result.metric))
      throw Error(Error::Kind::Value,
                  {"this metric judges pixels of a picture, not pairs of directions", "error map", std::string(measure),
                   "difference, absolute, or a metric of `brdf compare` over directions"});
  }
  if (average == "automatic") return result;
  for (const auto& [name, known] : kAverages) {
    if (name != average) continue;
    result.average = known;
    return result;
  }
  throw Error(Error::Kind::Value, {"unknown average", "error map", std::string(average), joined(errorAverageNames())});
}

std::vector<std::string> errorAverageNames() {
  std::vector<std::string> names{"automatic"};
  for (const auto& [name, average] : kAverages) names.emplace_back(name);
  return names;
}

std::string errorMeasureLabel(const ErrorMeasure& measure) {
  const std::string r = inNames(measure.metric->formula());
  switch (measure.average) {
    case ErrorAverage::RootMeanSquare:
      return "rms of " + r + unitOf(measure);
    case ErrorAverage::Absolute:
      return "mean of |" + r + "|" + unitOf(measure);
    default:
      return "mean of " + r + unitOf(measure);
  }
}

std::string errorTermLabel(const ErrorMeasure& measure) {
  const std::string r = inNames(measure.metric->formula());
  return (measure.average == ErrorAverage::Signed ? r : "|" + r + "|") + unitOf(measure);
}

}  // namespace brdf
