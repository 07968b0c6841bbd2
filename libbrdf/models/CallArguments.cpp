#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/models/CallArguments.h>

#include <algorithm>

namespace brdf {

bool CallArguments::given(const std::string& key) const {
  return std::ranges::find(call_.arguments, key, &Call::Argument::key) != call_.arguments.end();
}

const Call::Argument* CallArguments::take(const std::string& key) {
  if (std::ranges::find(declared_, key) == declared_.end()) declared_.push_back(key);
  for (std::size_t k = 0; k < call_.arguments.size(); ++k) {
    if (call_.arguments[k].key != key) continue;
    taken_[k] = true;
    return &call_.arguments[k];
  }
  return nullptr;
}

void CallArguments::fail(const std::string& key, std::string what, std::string found, std::string allowed) const {
  const auto at = std::ranges::find(call_.arguments, key, &Call::Argument::key);
  const std::size_t column = at != call_.arguments.end() ? at->column : call_.column;
  throw Error(Error::Kind::Value, {std::move(what), call_.where(column), std::move(found), std::move(allowed)});
}

double CallArguments::checked(const Parameter& parameter, double value) const {
  if (!(value >= parameter.minimum && value <= parameter.maximum))
    fail(parameter.name, parameter.name + " of " + call_.name + " out of bounds", formatNumber(value),
         "[" + formatNumber(parameter.minimum) + ", " + formatNumber(parameter.maximum) + "]" +
             (parameter.unit == "1" || parameter.unit.empty() ? "" : " " + parameter.unit));
  return value;
}

double CallArguments::number(const Parameter& parameter) {
  const Call::Argument* argument = take(parameter.name);
  if (!argument) return parameter.defaultValue;
  const std::vector<double> values = numbersOf(call_, *argument);
  if (values.size() != 1)
    fail(parameter.name, parameter.name + " of " + call_.name + " is one number",
         std::to_string(values.size()) + " numbers", "1");
  return checked(parameter, values[0]);
}

std::vector<double> CallArguments::numbers(const Parameter& parameter) {
  const Call::Argument* argument = take(parameter.name);
  if (!argument) return {parameter.defaultValue};
  std::vector<double> values = numbersOf(call_, *argument);
  for (const double value : values) checked(parameter, value);
  return values;
}

std::optional<std::string> CallArguments::text(const std::string& key) {
  const Call::Argument* argument = take(key);
  if (!argument) return {};
  return argument->text;
}

std::string CallArguments::choice(const std::string& key, const std::vector<std::string>& allowed) {
  const Call::Argument* argument = take(key);
  if (!argument) return allowed.front();
  if (std::ranges::find(allowed, argument->text) == allowed.end())
    fail(key, "unknown " + key + " of " + call_.name, "'" + argument->text + "'", joined(allowed));
  return argument->text;
}

std::optional<Call> CallArguments::nested(const std::string& key) {
  const Call::Argument* argument = take(key);
  if (!argument) return {};
  return parseCall(argument->text, call_.what, argument->column);
}

std::vector<Call::Argument> CallArguments::unnamed() {
  std::vector<Call::Argument> arguments;
  for (std::size_t k = 0; k < call_.arguments.size(); ++k) {
    if (!call_.arguments[k].key.empty()) continue;
    taken_[k] = true;
    arguments.push_back(call_.arguments[k]);
  }
  return arguments;
}

void CallArguments::finish() const {
  for (std::size_t k = 0; k < taken_.size(); ++k) {
    if (taken_[k]) continue;
    const Call::Argument& argument = call_.arguments[k];
    const std::string nearest = argument.key.empty() ? std::string() : closestName(argument.key, declared_);
    throw Error(Error::Kind::Value,
                {argument.key.empty() ? "value without a name, of " + call_.name : "unknown parameter of " + call_.name,
                 call_.where(argument.keyColumn), "'" + (argument.key.empty() ? argument.text : argument.key) + "'",
                 (declared_.empty() ? "none" : joined(declared_)) +
                     (nearest.empty() ? "" : " (did you mean " + nearest + "?)")});
  }
}

}  // namespace brdf
