#include "FitArguments.h"

#include "Arguments.h"
#include "Assumptions.h"
#include "Progress.h"
#include "commands/FitReportJson.h"

#include <brdf/base/Error.h>
#include <brdf/base/Text.h>

namespace brdf::app {
namespace {

constexpr const char* kLobes = "Lambertian + GGX";

/// Applies what `text` says to the candidates that have such parameters; throws when none has.
void forSome(std::vector<CandidateLobes>& candidates, void (*apply)(std::vector<LobeRequest>&, std::string_view),
             const std::string& text) {
  std::size_t refused = 0;
  for (CandidateLobes& candidate : candidates) {
    try {
      apply(candidate.lobes, text);
    } catch (const Error&) {
      if (++refused == candidates.size()) throw;
    }
  }
}

/// Starting values of each lobe from the first of its model that was not taken.
void takeStarts(std::vector<LobeRequest> from, std::vector<LobeRequest>& requests) {
  for (LobeRequest& request : requests)
    for (LobeRequest& known : from) {
      if (!known.model || known.model->name() != request.model->name()) continue;
      for (const auto& [name, value] : known.start) request.start.try_emplace(name, value);
      known.model = nullptr;
      break;
    }
}

/// Runs `read`; an error names the option first.
template <class Read>
auto fromOption(const char* option, Read read) {
  try {
    return read();
  } catch (const Error& error) {
    Error::Details details = error.details();
    details.where = details.where.empty() ? option : std::string(option) + ", " + details.where;
    throw Error(error.kind(), std::move(details));
  }
}

}  // namespace

void FitArguments::declare(Arguments& arguments) {
  arguments.option("--lobes", lobes_, "SUM",
                   "Lobes to fit; parameters written there are starting values; several times: all are fitted, and "
                   "the best by cross-validation or BIC is kept [" +
                       std::string(kLobes) + "]");
  arguments.option("--from", from_, "FILE", "Continue from this fit: its lobes, or its values for those of --lobes");
  arguments.choice("--optimizer", options_.optimizer, optimizerNames(), "How the shape parameters are searched");
  arguments.option("--metric", options_.metric, "NAME", metricHelp("What is minimised", options_.metric));
  arguments.option("--channels", channels_, "LIST",
                   "luminance, rgb, spectral (the data's own) or numbers from 0 as in 0,3,5 [spectral]");
  arguments.choice("--strategy", strategy_, {"automatic", "separable", "joint"},
                   "Scale factors by linear least squares inside, or searched with the rest");
  arguments.choice("--combination", combination_, {"shared", "per-channel"}, "One shape for all channels, or one each");
  arguments.flag("--progressive", progressive_, "Fit one lobe more at a time, in the order given");
  arguments.option("--starts", options_.starts, {0, 100000}, "Random starts besides the scan");
  arguments.option("--seed", seed_, {0, 9e15}, "Of random starts and optimizers, and of --sampling importance");
  arguments.flag("--data-start", options_.dataStart, "Start from shapes read off the data, too");
  arguments.flag("--no-scan", noScan_, "Start from the defaults instead of scanning the shapes");
  arguments.option("--tolerance", options_.tolerance, {0, 1}, "NUMBER", "Relative: stop when steps gain less");
  arguments.option("--max-iterations", options_.maximumIterations, {1, 1000000}, "Of each start");
  arguments.option("--max-theta", options_.maximumTheta, {0, 90}, "DEGREES",
                   "Leave out samples with theta_i or theta_o above");
  samples_.declare(arguments, true);
  arguments.option("--cross-validate", options_.crossValidation, {0, 100},
                   "Judge on parts left out, each whole blocks of directions; so many of them, each another fit [0]");
  arguments.option("--fix", fixed_, "NAME=VALUE",
                   "Hold a parameter, in every lobe or as in GGX.ior=1.5; several times");
  arguments.option(
      "--tie", tied_, "NAME=NAME",
      "Keep two parameters equal, as in ay=ax, Ward.ay=ax or, of two lobes, GGX#2.ior=GGX#1.ior; several times");
}

void FitArguments::resolve() {
  options_.seed = seed_;
  options_.scan = !noScan_;
  options_.samples = samples_.choice(seed_);
  options_.channels = channelsOption(channels_);
  options_.strategy = strategy_ == "separable" ? Strategy::Separable
                      : strategy_ == "joint"   ? Strategy::Joint
                                               : Strategy::Automatic;
  options_.combination = combination_ == "shared" ? Combination::Shared : Combination::PerChannel;
  checkMetric(options_.metric);
  candidates_.clear();
  std::vector<LobeRequest> from;
  if (!from_.empty())
    from = fromOption("--from", [&] {
      const auto sum = std::dynamic_pointer_cast<const LobeSum>(loadMaterial(from_).brdf);
      if (!sum) throw Error(Error::Kind::Value, {"not a sum of lobes", "", from_, "a fit, or a material expression"});
      return requestsFrom(*sum);
    });
  std::vector<std::string> texts = lobes_;
  if (texts.empty() && from.empty()) texts.push_back(kLobes);
  for (const std::string& text : texts)
    candidates_.push_back({text, fromOption("--lobes", [&] { return parseLobeRequests(text); })});
  if (texts.empty()) candidates_.push_back({from_, from});
  if (progressive_ && candidates_.size() > 1)
    throw Error(Error::Kind::Usage, {"one sum of lobes is fitted progressively", "--progressive",
                                     std::to_string(candidates_.size()) + " times --lobes", "--lobes once"});
  if (!texts.empty())
    for (CandidateLobes& candidate : candidates_) takeStarts(from, candidate.lobes);
  for (const std::string& text : tied_) fromOption("--tie", [&] { forSome(candidates_, tieParameter, text); });
  for (const std::string& text : fixed_) fromOption("--fix", [&] { forSome(candidates_, holdParameter, text); });
  if (!from.empty()) options_.scan = false;
}

FitReport FitArguments::run(const Brdf& target, std::function<bool(std::size_t, double)> progress) const {
  FitOptions options = options_;
  options.progress = std::move(progress);
  return progressive_ ? fitProgressively(target, candidates_.front().lobes, options)
                      : fitBest(target, candidates_, options);
}

std::string FitArguments::lobes() const {
  std::string text;
  for (const CandidateLobes& candidate : candidates_) text += (text.empty() ? "" : " or ") + candidate.name;
  return text;
}

std::string FitArguments::words() const {
  std::string lobes;
  for (const CandidateLobes& candidate : candidates_) lobes += " --lobes \"" + candidate.name + "\"";
  return "fit" + lobes + " --metric " + options_.metric + " --optimizer " + options_.optimizer + " --channels " +
         channels_ + " --combination " + combination_ + " --max-theta " + formatNumber(options_.maximumTheta) + " " +
         samples_.words();
}

std::string FitArguments::modelDefinitions() const {
  std::string text;
  for (const CandidateLobes& candidate : candidates_)
    for (const LobeRequest& request : candidate.lobes) {
      text += request.model->name() + "\n" + request.model->equation() + "\n";
      for (const Parameter& p : request.model->parameters()) {
        text += p.name + " " + p.follows + (p.scale == Parameter::Scale::Logarithmic ? " log" : " linear");
        for (const double number : {p.defaultValue, p.minimum, p.maximum, p.softMinimum, p.softMaximum})
          text += " " + formatNumber(number);
        text += "\n";
      }
    }
  return text;
}

LoadedMaterial loadTarget(const std::string& spec) { return loadMaterial(spec, assumptions()); }

}  // namespace brdf::app
