#pragma once
// The parts that audits of models and materials share. Internal to libbrdf/check.
#include <brdf/check/Cases.h>
#include <brdf/check/Check.h>

#include <cmath>
#include <limits>

namespace brdf {

constexpr double kAnything = std::numeric_limits<double>::infinity();

/// Keeps the worst case of one check.
class Tally {
 public:
  Tally(std::string name, double allowed, std::string note = {})
      : check_{std::move(name), true, 0, allowed, {}, std::move(note)} {}
  /// What a model declares instead of `allowed`, where it does.
  Tally(std::string name, double allowed, const Declaration* declaration)
      : check_{std::move(name),
               true,
               0,
               declaration ? declaration->allowed : allowed,
               {},
               declaration ? declaration->reason : "",
               declaration != nullptr} {}

  /// `at` makes the text of a case; it is called for a new worst one only.
  template <class Text>
  void offer(double value, Text&& at) {
    if (value <= check_.worst) return;
    check_.worst = std::isnan(value) ? kAnything : value;
    check_.at = at();
  }
  /// Counts a case that none is allowed of; the first one is shown.
  template <class Text>
  void count(Text&& at) {
    if (check_.worst++ == 0) check_.at = at();
  }
  /// Counts `cases` of them at once.
  void count(std::size_t cases, const std::string& at) {
    if (cases == 0) return;
    if (check_.worst == 0) check_.at = at;
    check_.worst += static_cast<double>(cases);
  }
  Check result() const {
    Check check = check_;
    check.passed = check.worst <= check.allowed;
    return check;
  }

 private:
  Check check_;
};

/// One lobe at fixed parameters as a monochrome BRDF; `model` must outlive it.
class OneLobe : public Brdf {
 public:
  OneLobe(const Model& model, std::vector<double> parameters) : model_(model), parameters_(std::move(parameters)) {}

  const Channels& channels() const override { return channels_; }
  Symmetry symmetry() const override { return model_.isotropic() ? Symmetry::Isotropic : Symmetry::Anisotropic; }
  bool reciprocal() const override { return model_.reciprocal(); }
  std::string description() const override { return parameterText(model_, parameters_); }
  void evaluate(const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const override;
  void evaluate(const DirectionPairs<float>& pairs, float* values, std::uint8_t* valid) const override;
  using Brdf::evaluate;
  void sample(const std::array<const double*, 3>& wo, const std::array<const double*, 2>& u,
              const std::array<double*, 3>& wi, std::size_t count) const override;
  void pdf(const DirectionPairs<double>& pairs, double* density) const override;

 private:
  const Model& model_;
  std::vector<double> parameters_;
  Channels channels_;
};

/// Values in double and float: not finite, and negative.
void tallyExtremes(const Brdf& brdf, const CheckPairs& pairs, const std::string& label, Tally& finite, Tally& negative);

/// Relative change when light and viewer change places; values below `floor` of the largest, or
/// among the last that double has (1e-290), are left out.
void tallyReciprocity(const Brdf& brdf, const CheckPairs& pairs, const std::string& label, double floor, Tally& tally);

/// What drawing and integrating show.
struct SamplerTallies {
  Tally energy, directions, surprise, integral, efficiency;

  /// `cases`: how many times tallySampler will be called. `energy`: what is declared about the albedo, or null.
  SamplerTallies(std::size_t cases, const Declaration* energy);
  void into(std::vector<Check>& checks) const;
};

/// Over five polar angles. `reflecting`: the BRDF itself, or some of its channels, whose albedo is taken.
void tallySampler(const Brdf& brdf, const Brdf& reflecting, const std::string& label, const CheckOptions& options,
                  SamplerTallies& tallies);

/// All checks of a model but "glsl", for the given parameters.
std::vector<Check> checkCases(const Model& model, const std::vector<ParameterCase>& cases, const CheckOptions& options);

/// The lobe at each channel's own parameters, once where the channels share them.
std::vector<ParameterCase> channelCases(const Lobe& lobe, std::size_t channels);

/// `count` times the effort, at least `least`.
inline std::size_t scaled(double count, const CheckOptions& options, std::size_t least = 1) {
  return std::max(least, static_cast<std::size_t>(count * options.effort));
}

}  // namespace brdf
