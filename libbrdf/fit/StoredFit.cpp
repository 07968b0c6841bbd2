#include <brdf/base/Error.h>
#include <brdf/fit/StoredFit.h>

#include <cmath>
#include <limits>

namespace brdf {
namespace {

void storeNumbers(const h5::Group& group, const std::map<std::string, double>& numbers) {
  for (const auto& [name, value] : numbers) group.setNumber(name, value);
}

std::map<std::string, double> restoreNumbers(const h5::Group& group) {
  std::map<std::string, double> numbers;
  for (const std::string& name : group.attributeNames()) numbers[name] = group.number(name);
  return numbers;
}

void storeParameters(const h5::Group& group, const std::vector<FittedParameter>& parameters) {
  std::vector<std::string> names, lobes;
  std::vector<std::int64_t> lobeIndices, channels, fixed, atBound;
  std::vector<double> values, standardErrors, minima, maxima;
  for (const FittedParameter& parameter : parameters) {
    names.push_back(parameter.name);
    lobes.push_back(parameter.lobe);
    lobeIndices.push_back(static_cast<std::int64_t>(parameter.lobeIndex));
    channels.push_back(parameter.channel ? static_cast<std::int64_t>(*parameter.channel) : -1);
    values.push_back(parameter.value);
    standardErrors.push_back(parameter.standardError.value_or(std::numeric_limits<double>::quiet_NaN()));
    minima.push_back(parameter.minimum);
    maxima.push_back(parameter.maximum);
    fixed.push_back(parameter.fixed);
    atBound.push_back(parameter.atBound);
  }
  group.setTexts("Name", names);
  group.setTexts("Lobe", lobes);
  group.setIntegers("LobeIndex", lobeIndices);
  group.setIntegers("Channel", channels);
  group.setNumbers("Value", values);
  group.setNumbers("StandardError", standardErrors);
  group.setNumbers("Minimum", minima);
  group.setNumbers("Maximum", maxima);
  group.setIntegers("Fixed", fixed);
  group.setIntegers("AtBound", atBound);
}

std::vector<FittedParameter> restoreParameters(const h5::Group& group) {
  const std::vector<std::string> names = group.texts("Name"), lobes = group.texts("Lobe");
  const std::size_t count = names.size();
  if (count == 0) return {};
  const auto numbers = [&](const char* name) {
    std::vector<double> list = group.numbers(name);
    if (list.size() != count || lobes.size() != count)
      throw Error(Error::Kind::Format, {"columns of parameters differ in length", group.where() + "/" + name,
                                        std::to_string(list.size()), std::to_string(count)});
    return list;
  };
  const auto lobeIndices = group.integers("LobeIndex", count), channels = group.integers("Channel", count),
             fixed = group.integers("Fixed", count), atBound = group.integers("AtBound", count);
  const auto values = numbers("Value"), standardErrors = numbers("StandardError"), minima = numbers("Minimum"),
             maxima = numbers("Maximum");
  std::vector<FittedParameter> parameters(count);
  for (std::size_t i = 0; i < count; ++i) {
    FittedParameter& parameter = parameters[i];
    parameter.name = names[i];
    parameter.lobe = lobes[i];
    parameter.lobeIndex = static_cast<std::size_t>(lobeIndices[i]);
    if (channels[i] >= 0) parameter.channel = static_cast<std::size_t>(channels[i]);
    parameter.value = values[i];
    if (!std::isnan(standardErrors[i])) parameter.standardError = standardErrors[i];
    parameter.minimum = minima[i];
    parameter.maximum = maxima[i];
    parameter.fixed = fixed[i] != 0;
    parameter.atBound = atBound[i] != 0;
  }
  return parameters;
}

void storeDiagnostics(const h5::Group& group, const FitReport& report) {
  const auto integers = [](const auto& list, auto field) {
    std::vector<std::int64_t> result;
    for (const auto& item : list) result.push_back(static_cast<std::int64_t>(item.*field));
    return result;
  };
  const auto numbers = [](const auto& list, auto field) {
    std::vector<double> result;
    for (const auto& item : list) result.push_back(item.*field);
    return result;
  };
  group.setInteger("Degrees", static_cast<std::int64_t>(report.degrees));
  group.setNumber("AIC", report.aic);
  group.setNumber("BIC", report.bic);
  const h5::Group covariance = group.createGroup("Covariance");
  const std::vector<std::int64_t> which(report.covariance.parameters.begin(), report.covariance.parameters.end());
  covariance.setIntegers("Parameters", which);
  covariance.setNumbers("Matrix", report.covariance.matrix);
  const h5::Group history = group.createGroup("History");
  history.setIntegers("Run", integers(report.history, &FitStep::run));
  history.setIntegers("Iteration", integers(report.history, &FitStep::iteration));
  history.setNumbers("Error", numbers(report.history, &FitStep::error));
  const h5::Group regions = group.createGroup("Regions");
  std::vector<std::string> names;
  for (const RegionResidual& region : report.regions) names.push_back(region.region);
  regions.setTexts("Region", names);
  regions.setIntegers("Samples", integers(report.regions, &RegionResidual::samples));
  regions.setNumbers("Error", numbers(report.regions, &RegionResidual::error));
  regions.setNumbers("Share", numbers(report.regions, &RegionResidual::share));
  regions.setNumbers("MeanDifference", numbers(report.regions, &RegionResidual::meanDifference));
  regions.setNumbers("RelativeMean", numbers(report.regions, &RegionResidual::relativeMean));
  const h5::Group worst = group.createGroup("WorstSamples");
  std::vector<double> directions;
  for (const WorstSample& sample : report.worst) {
    directions.insert(directions.end(), sample.wi.begin(), sample.wi.end());
    directions.insert(directions.end(), sample.wo.begin(), sample.wo.end());
  }
  worst.setNumbers("Directions", directions);
  worst.setIntegers("Channel", integers(report.worst, &WorstSample::channel));
  worst.setNumbers("Target", numbers(report.worst, &WorstSample::target));
  worst.setNumbers("Fitted", numbers(report.worst, &WorstSample::fitted));
  worst.setNumbers("Share", numbers(report.worst, &WorstSample::share));
  if (!report.crossValidation) return;
  const h5::Group validation = group.createGroup("CrossValidation");
  validation.setNumber("Error", report.crossValidation->error);
  validation.setNumber("StandardError", report.crossValidation->standardError);
  validation.setNumbers("PartErrors", report.crossValidation->partErrors);
}

/// Column `name` of a group, as long as the others.
std::vector<double> column(const h5::Group& group, const char* name, std::size_t count) {
  std::vector<double> list = group.numbers(name);
  if (list.size() != count)
    throw Error(Error::Kind::Format, {"columns differ in length", group.where() + "/" + name,
                                      std::to_string(list.size()), std::to_string(count)});
  return list;
}

/// The same for whole numbers; an empty list is not written.
std::vector<std::int64_t> wholes(const h5::Group& group, const char* name, std::size_t count) {
  return count > 0 ? group.integers(name, count) : std::vector<std::int64_t>();
}

void restoreDiagnostics(const h5::Group& group, FitReport& report) {
  report.degrees = static_cast<std::size_t>(group.integer("Degrees"));
  report.aic = group.number("AIC");
  report.bic = group.number("BIC");
  const h5::Group covariance = group.group("Covariance");
  report.covariance.matrix = covariance.numbers("Matrix");
  const auto side =
      static_cast<std::size_t>(std::llround(std::sqrt(static_cast<double>(report.covariance.matrix.size()))));
  column(covariance, "Matrix", side * side);
  for (const std::int64_t index : wholes(covariance, "Parameters", side)) {
    if (index < 0 || static_cast<std::size_t>(index) >= report.parameters.size())
      throw Error(Error::Kind::Format, {"no such parameter", covariance.where(), std::to_string(index),
                                        "0 to " + std::to_string(report.parameters.size() - 1)});
    report.covariance.parameters.push_back(static_cast<std::size_t>(index));
  }
  const h5::Group history = group.group("History");
  const std::vector<double> errors = history.numbers("Error");
  const auto runs = wholes(history, "Run", errors.size()), iterations = wholes(history, "Iteration", errors.size());
  for (std::size_t i = 0; i < errors.size(); ++i)
    report.history.push_back({static_cast<std::size_t>(runs[i]), static_cast<std::size_t>(iterations[i]), errors[i]});
  const h5::Group regions = group.group("Regions");
  const std::vector<std::string> names = regions.texts("Region");
  const std::size_t count = names.size();
  const auto samples = wholes(regions, "Samples", count);
  const auto regionErrors = column(regions, "Error", count), share = column(regions, "Share", count),
             difference = column(regions, "MeanDifference", count), relative = column(regions, "RelativeMean", count);
  for (std::size_t i = 0; i < count; ++i)
    report.regions.push_back(
        {names[i], static_cast<std::size_t>(samples[i]), regionErrors[i], share[i], difference[i], relative[i]});
  const h5::Group worst = group.group("WorstSamples");
  const std::vector<double> targets = worst.numbers("Target");
  const std::size_t n = targets.size();
  const auto directions = column(worst, "Directions", 6 * n), fitted = column(worst, "Fitted", n),
             shares = column(worst, "Share", n);
  const auto channels = wholes(worst, "Channel", n);
  for (std::size_t i = 0; i < n; ++i) {
    const double* d = directions.data() + 6 * i;
    report.worst.push_back({{d[0], d[1], d[2]},
                            {d[3], d[4], d[5]},
                            static_cast<std::size_t>(channels[i]),
                            targets[i],
                            fitted[i],
                            shares[i]});
  }
  if (!group.hasObject("CrossValidation")) return;
  const h5::Group validation = group.group("CrossValidation");
  report.crossValidation =
      CrossValidation{validation.number("Error"), validation.number("StandardError"), validation.numbers("PartErrors")};
}

}  // namespace

void storeFit(const h5::Group& entry, const FitReport& report) {
  const auto count = [](std::size_t n) { return static_cast<std::int64_t>(n); };
  const h5::Group group = entry.createGroup("Fit");
  group.setText("Metric", report.metric);
  group.setText("Optimizer", report.optimizer);
  group.setText("Strategy", report.strategy);
  group.setNumber("Error", report.error);
  group.setNumber("Seconds", report.seconds);
  group.setInteger("Evaluations", count(report.evaluations));
  group.setInteger("Iterations", count(report.iterations));
  group.setInteger("Samples", count(report.samples));
  group.setInteger("Channels", count(report.channels));
  group.setInteger("Converged", report.converged);
  group.setText("Termination", report.termination);
  group.setTexts("Notes", report.notes);
  group.setText("MetricFormula", report.metricFormula);
  group.setText("Sampling", report.sampling);
  group.setText("Weights", report.weights);
  group.setText("ChannelNames", report.channelNames);
  group.setNumber("MaximumTheta", report.maximumTheta);
  group.setInteger("SamplesOffered", count(report.offered));
  group.setNumber("ConstantError", report.constantError);
  group.setNumbers("ConstantModel", report.constantModel);
  storeNumbers(group.createGroup("Metrics"), report.metrics);
  storeNumbers(group.createGroup("ZeroModel"), report.zeroModel);
  storeParameters(group.createGroup("Parameters"), report.parameters);
  storeDiagnostics(group, report);
}

FitReport loadFit(const Container& container, std::size_t index) {
  const h5::Group& entry = container.group(index);
  if (!container.entries().at(index).isFit) throw Error(Error::Kind::Value, {"no fit", entry.where(), {}, {}});
  const h5::Group group = entry.group("Fit");
  const auto count = [&](const char* name) { return static_cast<std::size_t>(group.integer(name)); };
  FitReport report;
  report.material = std::dynamic_pointer_cast<const LobeSum>(container.load(index));
  if (!report.material)
    throw Error(Error::Kind::Format, {"a fit of something that is no sum of lobes", entry.where(),
                                      container.entries()[index].kind, "analytic"});
  report.metric = group.text("Metric");
  report.optimizer = group.text("Optimizer");
  report.strategy = group.text("Strategy");
  report.error = group.number("Error");
  report.seconds = group.number("Seconds");
  report.evaluations = count("Evaluations");
  report.iterations = count("Iterations");
  report.samples = count("Samples");
  report.channels = count("Channels");
  report.converged = group.integer("Converged") != 0;
  report.termination = group.text("Termination");
  report.notes = group.texts("Notes");
  report.metricFormula = group.text("MetricFormula");
  report.sampling = group.text("Sampling");
  report.weights = group.text("Weights");
  report.channelNames = group.text("ChannelNames");
  report.maximumTheta = group.number("MaximumTheta");
  report.offered = count("SamplesOffered");
  report.constantError = group.number("ConstantError");
  report.constantModel = group.numbers("ConstantModel");
  report.metrics = restoreNumbers(group.group("Metrics"));
  report.zeroModel = restoreNumbers(group.group("ZeroModel"));
  report.parameters = restoreParameters(group.group("Parameters"));
  restoreDiagnostics(group, report);
  return report;
}

}  // namespace brdf
