#pragma once
#include <brdf/fit/Fit.h>

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace brdf::app {

/// The report of a fit as the JSON that the command line promises.
nlohmann::ordered_json fitReportJson(const FitReport& report);
/// The same for people: parameters with standard errors, errors by every metric beside the zero model's, notes.
std::string fitReportText(const FitReport& report);
/// "metric, this, zero model, ratio" lines shared with `compare`.
std::string metricTable(const std::map<std::string, double>& metrics, const std::map<std::string, double>& zeroModel);

/// The help of an option --metric: what it does, the names, the default.
std::string metricHelp(const std::string& what, const std::string& byDefault);
/// Throws Error::Kind::Usage unless `text` is a metric (brdf::findMetric), empty being none.
void checkMetric(const std::string& text);

/// "luminance", "rgb", "spectral" (the data's own channels) or a list of channel numbers "0,3,5". Throws
/// Error::Kind::Usage.
FitChannels channelsOption(const std::string& text);

}  // namespace brdf::app
