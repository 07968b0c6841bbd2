#include "FitReportJson.h"

#include "Output.h"

#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/fit/Metric.h>
#include <brdf/geometry/Directions.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace brdf::app {
namespace {

constexpr std::size_t kShownCorrelations = 10, kShownWorst = 3;

}  // namespace

nlohmann::ordered_json fitReportJson(const FitReport& report) {
  using Json = nlohmann::ordered_json;
  Json parameters = Json::array();
  for (const FittedParameter& p : report.parameters) {
    Json entry = {{"name", p.name}, {"lobe", p.lobe}, {"lobe_index", p.lobeIndex}};
    entry["channel"] = p.channel ? Json(*p.channel) : Json();
    entry["value"] = p.value;
    entry["std_error"] = p.standardError ? Json(*p.standardError) : Json();
    entry["min"] = p.minimum;
    entry["max"] = std::isfinite(p.maximum) ? Json(p.maximum) : Json();
    entry["at_bound"] = p.atBound;
    entry["fixed"] = p.fixed;
    parameters.push_back(std::move(entry));
  }
  Json covarianceOf = Json::array(), history = Json::array(), regions = Json::array(), worst = Json::array();
  for (const std::size_t k : report.covariance.parameters) covarianceOf.push_back(k);
  for (const FitStep& step : report.history)
    history.push_back({{"run", step.run}, {"iteration", step.iteration}, {"error", step.error}});
  for (const RegionResidual& r : report.regions)
    regions.push_back({{"region", r.region},
                       {"samples", r.samples},
                       {"error", r.error},
                       {"share", r.share},
                       {"mean_difference", r.meanDifference},
                       {"relative_mean", r.relativeMean}});
  for (const WorstSample& sample : report.worst) {
    const Spherical wi = toSpherical(sample.wi), wo = toSpherical(sample.wo);
    worst.push_back({{"theta_i", degrees(wi.theta)},
                     {"phi_i", degrees(wi.phi)},
                     {"theta_o", degrees(wo.theta)},
                     {"phi_o", degrees(wo.phi)},
                     {"channel", sample.channel},
                     {"target", sample.target},
                     {"fit", sample.fitted},
                     {"share", sample.share}});
  }
  const auto finite = [](double value) { return std::isfinite(value) ? Json(value) : Json(); };
  Json validation;
  if (report.crossValidation)
    validation = {{"parts", report.crossValidation->partErrors.size()},
                  {"error", report.crossValidation->error},
                  {"std_error", report.crossValidation->standardError},
                  {"part_errors", report.crossValidation->partErrors}};
  Json candidates = Json::array();
  for (const FitCandidate& candidate : report.candidates)
    candidates.push_back({{"lobes", candidate.lobes},
                          {"error", candidate.error},
                          {"degrees", candidate.degrees},
                          {"aic", finite(candidate.aic)},
                          {"bic", finite(candidate.bic)},
                          {"cross_validation", candidate.crossValidation ? Json(*candidate.crossValidation) : Json()},
                          {"converged", candidate.converged}});
  return {{"material", report.material->description()},
          {"metric", report.metric},
          {"metric_formula", report.metricFormula},
          {"error", report.error},
          {"metrics", report.metrics},
          {"zero_model", report.zeroModel},
          {"constant_model", {{"error", report.constantError}, {"values", report.constantModel}}},
          {"target",
           {{"sampling", report.sampling},
            {"weights", report.weights},
            {"max_theta", report.maximumTheta},
            {"samples_offered", report.offered},
            {"channels", report.channelNames}}},
          {"seconds", report.seconds},
          {"evaluations", report.evaluations},
          {"iterations", report.iterations},
          {"samples", report.samples},
          {"channels", report.channels},
          {"converged", report.converged},
          {"termination", report.termination},
          {"optimizer", report.optimizer},
          {"strategy", report.strategy},
          {"parameters", std::move(parameters)},
          {"covariance",
           {{"parameters", std::move(covarianceOf)},
            {"matrix", report.covariance.matrix},
            {"correlations", report.covariance.correlations()}}},
          {"history", std::move(history)},
          {"regions", std::move(regions)},
          {"worst_samples", std::move(worst)},
          {"degrees", report.degrees},
          {"aic", finite(report.aic)},
          {"bic", finite(report.bic)},
          {"cross_validation", std::move(validation)},
          {"candidates", std::move(candidates)},
          {"notes", report.notes}};
}

std::string metricTable(const std::map<std::string, double>& metrics, const std::map<std::string, double>& zeroModel) {
  TextTable table({"  metric", "error", "zero model", "ratio"});
  for (const auto& [name, value] : metrics) {
    const auto zero = zeroModel.find(name);
    if (zero == zeroModel.end())
      table.row({"  " + name, number(value), "-", "-"});
    else
      table.row({"  " + name, number(value), number(zero->second), formatNumber(value / zero->second, 3)});
  }
  return table.text();
}

namespace {

/// The lobe's name, and which one (from 1) where the material has several of that name, as in the report's notes.
std::string lobeLabel(const FitReport& report, const FittedParameter& p) {
  const auto& lobes = report.material->lobes();
  std::size_t same = 0, number = 0;
  for (std::size_t i = 0; i < lobes.size(); ++i) {
    same += lobes[i].model->name() == p.lobe;
    if (i == p.lobeIndex) number = same;
  }
  return same > 1 ? p.lobe + "#" + std::to_string(number) : p.lobe;
}

}  // namespace

namespace {

/// "theta, phi" in degrees.
std::string angles(const Direction& w) {
  const Spherical s = toSpherical(w);
  return formatNumber(degrees(s.theta), 4) + ", " + formatNumber(degrees(s.phi), 4);
}

/// Correlations of few parameters; more are in the JSON.
std::string correlationTable(const FitReport& report) {
  const std::vector<std::size_t>& which = report.covariance.parameters;
  const std::size_t n = which.size();
  if (n < 2 || n > kShownCorrelations) return {};
  const std::vector<double> correlations = report.covariance.correlations();
  std::vector<std::string> header{"  correlations"};
  for (std::size_t j = 0; j < n; ++j) header.push_back("(" + std::to_string(j + 1) + ")");
  TextTable table(header);
  for (std::size_t i = 0; i < n; ++i) {
    const FittedParameter& p = report.parameters[which[i]];
    std::vector<std::string> row{"  (" + std::to_string(i + 1) + ") " + lobeLabel(report, p) + " " + p.name +
                                 (p.channel ? " " + std::to_string(*p.channel) : "")};
    for (std::size_t j = 0; j < n; ++j) row.push_back(j > i ? "" : formatNumber(correlations[i * n + j], 3));
    table.row(row);
  }
  return table.text() + "\n\n";
}

std::string candidateTable(const FitReport& report) {
  if (report.candidates.size() < 2) return {};
  TextTable table({"  lobes", report.metric, "K", "AIC", "BIC", "cross-validation", ""});
  for (const FitCandidate& c : report.candidates)
    table.row({"  " + c.lobes, number(c.error), std::to_string(c.degrees), number(c.aic), number(c.bic),
               c.crossValidation ? number(*c.crossValidation) : "-", c.converged ? "" : "not converged"});
  return table.text() + "\n\n";
}

std::string residualTables(const FitReport& report) {
  if (report.regions.empty()) return {};
  TextTable regions({"  region", "samples", "error", "share of squares", "mean of f - t", "mean |f - t| / mean |t|"});
  for (const RegionResidual& r : report.regions)
    regions.row({"  " + r.region, std::to_string(r.samples), number(r.error), formatNumber(100 * r.share, 3) + " %",
                 number(r.meanDifference), formatNumber(r.relativeMean, 3)});
  std::string text = regions.text() + "\n\n";
  if (report.worst.empty()) return text;
  TextTable worst({"  worst samples: light", "viewer (theta, phi)", "channel", "target", "fit", "share of squares"});
  for (std::size_t k = 0; k < std::min(kShownWorst, report.worst.size()); ++k) {
    const WorstSample& sample = report.worst[k];
    worst.row({"  " + angles(sample.wi), angles(sample.wo), std::to_string(sample.channel), number(sample.target),
               number(sample.fitted), formatNumber(100 * sample.share, 3) + " %"});
  }
  return text + worst.text() + "\n\n";
}

}  // namespace

std::string fitReportText(const FitReport& report) {
  std::string text = report.material->description() + "\n\n";
  TextTable table({"  lobe", "parameter", "channel", "value", "std. error", "bounds", ""});
  for (const FittedParameter& p : report.parameters)
    table.row({"  " + lobeLabel(report, p), p.name, p.channel ? std::to_string(*p.channel) : "all", number(p.value),
               p.standardError ? formatNumber(*p.standardError, 2) : "-",
               number(p.minimum) + " to " + number(p.maximum),
               p.fixed     ? "held"
               : p.atBound ? "at a bound"
                           : ""});
  text += table.text() + "\n\n" + metricTable(report.metrics, report.zeroModel) + "\n\n";
  text += candidateTable(report) + correlationTable(report) + residualTables(report);
  std::string constant;
  for (const double value : report.constantModel) constant += (constant.empty() ? "" : ", ") + formatNumber(value, 4);
  text += "  best constant BRDF: " + report.metric + " " + number(report.constantError) + ", at " + constant + " /sr\n";
  text += "  target: " + report.sampling + ", " + std::to_string(report.samples) + " of " +
          std::to_string(report.offered) + " used (theta up to " + formatNumber(report.maximumTheta) +
          " degrees), weights " + report.weights + ", channels " + report.channelNames + "\n";
  text += "  K = " + std::to_string(report.degrees) + ", AIC " + number(report.aic) + ", BIC " + number(report.bic);
  if (report.crossValidation)
    text += "; cross-validation in " + std::to_string(report.crossValidation->partErrors.size()) +
            " parts: " + number(report.crossValidation->error) + " +- " +
            formatNumber(report.crossValidation->standardError, 2);
  text += "\n  metric: root mean square of " + report.metricFormula + "\n";
  text += "  " + std::string(report.converged ? "converged" : "not converged") + ": " + report.termination + "\n  " +
          std::to_string(report.samples) + " samples, " + std::to_string(report.channels) + " channels, " +
          report.metric + ", " + report.optimizer + ", " + report.strategy + ", " + std::to_string(report.evaluations) +
          " passes, " + formatNumber(report.seconds, 3) + " s";
  for (const std::string& note : report.notes) text += "\n  note: " + note;
  return text;
}

std::string metricHelp(const std::string& what, const std::string& byDefault) {
  return what + ": " + joined(metricNames()) +
         ", relative:FLOOR and huber:DELTA (1/sr), sphere or sphere:MAP (the picture of a sphere under a map), or "
         "formula:TEXT, as in \"formula:cbrt(f*cos_i)\"" +
         (byDefault.empty() ? "" : " [" + byDefault + "]");
}

void checkMetric(const std::string& text) {
  try {
    if (!text.empty()) findMetric(text);
  } catch (const Error& error) {
    Error::Details details = error.details();
    details.where = "--metric";
    throw Error(Error::Kind::Usage, std::move(details));
  }
}

FitChannels channelsOption(const std::string& text) {
  FitChannels channels;
  if (text == "luminance") {
    channels.kind = FitChannels::Kind::Luminance;
  } else if (text == "rgb") {
    channels.kind = FitChannels::Kind::Rgb;
  } else if (text != "spectral") {
    channels.kind = FitChannels::Kind::List;
    for (const auto piece : split(text, ',')) {
      const auto index = parseNumber(piece);
      if (!index || *index < 0 || *index > 1e6 || *index != std::floor(*index))
        throw Error(Error::Kind::Usage, {"unknown channels", "--channels", "'" + text + "'",
                                         "luminance, rgb, spectral, or numbers from 0 as in 0,3,5"});
      channels.list.push_back(static_cast<std::size_t>(*index));
    }
  }
  return channels;
}

}  // namespace brdf::app
