#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/models/CallArguments.h>
#include <brdf/simulate/SurfaceArguments.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace brdf {
namespace {

/// Whether a value reads back only in quotation marks.
bool needsQuotes(const std::string& text) {
  return text.empty() || trimmed(text).size() != text.size() || text.find_first_of(",()") != std::string::npos;
}

}  // namespace

SurfaceArguments::SurfaceArguments(const Call& call, const std::vector<Parameter>& parameters,
                                   const std::vector<TextParameter>& texts)
    : name_(call.name), where_("surface " + call.name) {
  CallArguments arguments(call);
  for (const TextParameter& text : texts) {
    Value value{text.name, 0, {}, true, arguments.given(text.name)};
    value.text =
        text.choices.empty() ? arguments.text(text.name).value_or("") : arguments.choice(text.name, text.choices);
    if (text.required && !value.given)
      throw Error(Error::Kind::Value,
                  {"must be given", where_ + ", " + text.name, "nothing", text.name + "=...: " + text.description});
    values_.push_back(std::move(value));
  }
  for (const Parameter& parameter : parameters)
    values_.push_back({parameter.name, arguments.number(parameter), {}, false, arguments.given(parameter.name)});
  arguments.finish();
  for (const Parameter& parameter : parameters)
    if (!parameter.follows.empty() && !given(parameter.name))
      std::ranges::find(values_, parameter.name, &Value::name)->number = number(parameter.follows);
}

const SurfaceArguments::Value& SurfaceArguments::value(std::string_view name, bool isText) const {
  const auto found = std::ranges::find(values_, name, &Value::name);
  if (found == values_.end() || found->isText != isText)
    throw std::out_of_range(where_ + " has no parameter " + std::string(name));
  return *found;
}

double SurfaceArguments::number(std::string_view name) const { return value(name, false).number; }

std::size_t SurfaceArguments::whole(std::string_view name) const {
  const double number = value(name, false).number;
  if (number != std::floor(number) || number < 0 || number > 0x1p53) refuse(name, "not a whole number", "0, 1, 2, ...");
  return static_cast<std::size_t>(number);
}

const std::string& SurfaceArguments::text(std::string_view name) const { return value(name, true).text; }

bool SurfaceArguments::given(std::string_view name) const {
  const auto found = std::ranges::find(values_, name, &Value::name);
  return found != values_.end() && found->given;
}

void SurfaceArguments::refuse(std::string_view name, std::string what, std::string allowed) const {
  const auto found = std::ranges::find(values_, name, &Value::name);
  std::string text;
  if (found != values_.end()) text = found->isText ? "'" + found->text + "'" : formatNumber(found->number);
  throw Error(Error::Kind::Value,
              {std::move(what), where_ + ", " + std::string(name), std::move(text), std::move(allowed)});
}

std::string SurfaceArguments::expression() const {
  std::string list;
  for (const Value& value : values_) {
    if (value.isText && value.text.empty()) continue;
    list += (list.empty() ? "" : ", ") + value.name + "=";
    if (value.isText)
      list += needsQuotes(value.text) ? "\"" + value.text + "\"" : value.text;
    else
      list += formatNumber(value.number);
  }
  return name_ + (list.empty() ? "" : "(" + list + ")");
}

}  // namespace brdf
