#include "Arguments.h"

#include <brdf/base/Error.h>
#include <brdf/base/Text.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

namespace brdf::app {
namespace {

std::string rangeText(const Range& range) {
  const bool below = std::isinf(range.minimum), above = std::isinf(range.maximum);
  if (below && above) return "any number";
  if (above) return "a number of at least " + formatNumber(range.minimum);
  if (below) return "a number of at most " + formatNumber(range.maximum);
  return formatNumber(range.minimum) + " to " + formatNumber(range.maximum);
}

}  // namespace

double numberOption(const std::string& option, const std::string& text, const Range& range) {
  const auto number = parseNumber(text);
  if (!number) throw Error(Error::Kind::Usage, {"not a number", option, "'" + text + "'", rangeText(range)});
  if (!(*number >= range.minimum && *number <= range.maximum) || !std::isfinite(*number))
    throw Error(Error::Kind::Usage, {"number out of range", option, text, rangeText(range)});
  return *number;
}

std::vector<double> numberListOption(const std::string& option, std::string_view text, std::size_t count,
                                     const std::string& form) {
  std::vector<double> numbers;
  for (const auto piece : split(text, ',')) {
    const auto number = parseNumber(piece);
    if (!number || !std::isfinite(*number)) break;
    numbers.push_back(*number);
  }
  if (numbers.size() != count || split(text, ',').size() != count)
    throw Error(Error::Kind::Usage, {"malformed value", option, "'" + std::string(text) + "'",
                                     std::to_string(count) + " numbers as in " + form});
  return numbers;
}

struct Arguments::Implementation {
  CLI::App app;
  std::string command;
  CLI::Option* last = nullptr;
  std::vector<std::string> names;

  CLI::Option* keep(CLI::Option* option, const std::string& name, const std::string& value) {
    option->type_name(value)->allow_extra_args(false);
    names.push_back(name);
    return last = option;
  }
};

Arguments::Arguments(const std::string& command, const std::string& summary, const std::string& examples)
    : implementation_(std::make_unique<Implementation>()) {
  implementation_->command = "brdf " + command;
  auto& app = implementation_->app;
  app.name("brdf " + command);
  app.description(summary);
  app.footer("\nExample:\n" + examples);
  app.allow_extras();
  app.set_help_flag("-h,--help", "Show this help");
  app.get_formatter()->column_width(34);
}

Arguments::~Arguments() = default;

void Arguments::positional(const std::string& name, std::string& target, const std::string& help) {
  implementation_->last = implementation_->app.add_option(name, target, help)->required()->type_name("");
}

void Arguments::positionals(const std::string& name, std::vector<std::string>& target, const std::string& help) {
  implementation_->last = implementation_->app.add_option(name, target, help)->required()->type_name("");
}

void Arguments::option(const std::string& name, std::string& target, const std::string& value,
                       const std::string& help) {
  implementation_->keep(implementation_->app.add_option(name, target, help), name, value);
}

void Arguments::option(const std::string& name, std::vector<std::string>& target, const std::string& value,
                       const std::string& help) {
  implementation_->keep(implementation_->app.add_option(name, target, help), name, value);
}

void Arguments::option(const std::string& name, double& target, const Range& range, const std::string& value,
                       const std::string& help) {
  implementation_->keep(
      implementation_->app.add_option_function<std::string>(
          name, [&target, name, range](const std::string& text) { target = numberOption(name, text, range); },
          help + " [" + formatNumber(target) + "]"),
      name, value);
}

void Arguments::option(const std::string& name, std::optional<double>& target, const Range& range,
                       const std::string& value, const std::string& help) {
  const auto read = [&target, name, range](const std::string& text) { target = numberOption(name, text, range); };
  implementation_->keep(implementation_->app.add_option_function<std::string>(name, read, help), name, value);
}

void Arguments::option(const std::string& name, std::size_t& target, const Range& range, const std::string& help) {
  const auto read = [&target, name, range](const std::string& text) {
    const double number = numberOption(name, text, range);
    if (number != std::floor(number) || number < 0 || number > 9007199254740992.0)
      throw Error(Error::Kind::Usage, {"not a whole number", name, text, rangeText(range)});
    target = static_cast<std::size_t>(number);
  };
  implementation_->keep(
      implementation_->app.add_option_function<std::string>(name, read, help + " [" + std::to_string(target) + "]"),
      name, "N");
}

void Arguments::optionWithOptionalValue(const std::string& name, bool& given, std::string& target,
                                        const std::string& value, const std::string& help) {
  const auto read = [&given, &target](const std::string& text) {
    given = true;
    target = text;
  };
  implementation_->keep(implementation_->app.add_option_function<std::string>(name, read, help), name, value)
      ->expected(0, 1);
}

void Arguments::choice(const std::string& name, std::string& target, const std::vector<std::string>& allowed,
                       const std::string& help) {
  const auto read = [&target, name, allowed](const std::string& text) {
    if (std::find(allowed.begin(), allowed.end(), text) == allowed.end())
      throw Error(Error::Kind::Usage, {"unknown value", name, "'" + text + "'", joined(allowed)});
    target = text;
  };
  implementation_->keep(implementation_->app.add_option_function<std::string>(
                            name, read, help + ": " + joined(allowed) + " [" + target + "]"),
                        name, "NAME");
}

void Arguments::flag(const std::string& name, bool& target, const std::string& help) {
  implementation_->last = implementation_->app.add_flag(name, target, help);
  implementation_->names.push_back(name);
}

void Arguments::required() { implementation_->last->required(); }
void Arguments::optional() { implementation_->last->required(false); }

bool Arguments::parse(const std::vector<std::string>& words) {
  const std::string& command = implementation_->command;
  try {
    implementation_->app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::CallForHelp&) {
    return false;
  } catch (const CLI::RequiredError& error) {
    throw Error(Error::Kind::Usage, {error.what(), command, "", "see " + command + " --help"});
  } catch (const CLI::ParseError& error) {
    throw Error(Error::Kind::Usage, {error.what(), command, "", "see " + command + " --help"});
  }
  if (const auto extras = implementation_->app.remaining(); !extras.empty()) {
    const bool option = extras.front().starts_with("-");
    const std::string nearest = option ? closestName(extras.front(), implementation_->names) : std::string();
    throw Error(Error::Kind::Usage,
                {option ? "unknown option" : "unexpected argument", command, "'" + extras.front() + "'",
                 nearest.empty() ? "what " + command + " --help lists" : nearest + " (nearest), see --help"});
  }
  return true;
}

std::string Arguments::help() const { return implementation_->app.help(); }

}  // namespace brdf::app
