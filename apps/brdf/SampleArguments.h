#pragma once
#include <brdf/fit/Fit.h>

#include <string>

namespace brdf::app {

class Arguments;

/// Which samples of a target count and how much: the options that `fit`, `batch` and `compare` share.
class SampleArguments {
 public:
  /// Declares --sampling, --samples and --weights, which keep their values here: this object must outlive the parsing.
  /// `noise`: with weights by the errors of the samples.
  void declare(Arguments& arguments, bool noise = false);

  /// After parsing. Throws Error::Kind::Usage for options that exclude each other.
  SampleChoice choice(std::uint64_t seed) const;
  /// The options as they would be typed.
  std::string words() const;

 private:
  std::string sampling_ = "automatic", weights_ = "none";
  std::size_t count_ = 0;
};

}  // namespace brdf::app
