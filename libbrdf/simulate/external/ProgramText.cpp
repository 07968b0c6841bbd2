#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/simulate/external/ProgramBrdf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace brdf {
namespace {

constexpr std::array<std::pair<std::string_view, Symmetry>, 3> kSymmetries = {
    {{"isotropic", Symmetry::Isotropic}, {"bilateral", Symmetry::Bilateral}, {"anisotropic", Symmetry::Anisotropic}}};
constexpr std::string_view kForm =
    "program:[--channels mono|rgb|NM,NM,...] [--symmetry isotropic|bilateral|anisotropic] [--reciprocal] [--stay] "
    "[--time-limit SECONDS] [--processes N] PROGRAM [ARGUMENT...]";
constexpr double kMostProcesses = 1024;

[[noreturn]] void malformed(const std::string& what, std::string_view found, std::string_view allowed = kForm) {
  throw Error(Error::Kind::Value, {what, "program", "'" + std::string(found) + "'", std::string(allowed)});
}

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

std::vector<std::string> wordsOf(std::string_view text) {
  std::vector<std::string> words;
  bool inWord = false;
  char quote = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (!quote && isBlank(c)) {
      inWord = false;
      continue;
    }
    if (!inWord) words.emplace_back();
    inWord = true;
    if (quote && c == quote)
      quote = 0;
    else if (!quote && (c == '\'' || c == '"'))
      quote = c;
    else if (c == '\\' && quote != '\'') {
      if (++i == text.size()) malformed("a backslash at the end", text, "a character after it");
      words.back() += text[i];
    } else
      words.back() += c;
  }
  if (quote) malformed("a quotation mark is not closed", text, std::string("a second ") + quote);
  return words;
}

Channels channelsOf(const std::string& text) {
  if (text == "mono") return Channels::monochrome();
  if (text == "rgb") return Channels::rgb();
  std::vector<double> wavelengths;
  for (const std::string_view piece : split(text, ',')) {
    const auto value = parseNumber(piece);
    if (!value || !std::isfinite(*value) || *value <= 0 || (!wavelengths.empty() && *value <= wavelengths.back()))
      malformed("unusable --channels", text, "mono, rgb, or ascending wavelengths in nm such as 450,550,650");
    wavelengths.push_back(*value);
  }
  return Channels::spectral(std::move(wavelengths));
}

double numberOf(const std::string& option, const std::string& text, double minimum, double maximum) {
  const auto value = parseNumber(text);
  if (!value || !(*value >= minimum && *value <= maximum))
    malformed("unusable " + option, text, formatNumber(minimum) + " to " + formatNumber(maximum));
  return *value;
}

/// `word` so that wordsOf gives it back.
std::string quoted(const std::string& word) {
  const bool plain = !word.empty() && std::ranges::none_of(word, [](char c) {
    return isBlank(c) || c == '\'' || c == '"' || c == '\\';
  });
  if (plain) return word;
  std::string text = "\"";
  for (const char c : word) {
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return text + "\"";
}

}  // namespace

ProgramOptions parseProgram(std::string_view text) {
  std::vector<std::string> words = wordsOf(text);
  ProgramOptions options;
  std::size_t i = 0;
  for (; i < words.size() && words[i].starts_with("--"); ++i) {
    const std::string option = words[i];
    if (option == "--") {
      ++i;
      break;
    }
    if (option == "--reciprocal") {
      options.reciprocal = true;
      continue;
    }
    if (option == "--stay") {
      options.stays = true;
      continue;
    }
    constexpr std::array<std::string_view, 4> withValue = {"--channels", "--symmetry", "--time-limit", "--processes"};
    if (std::ranges::find(withValue, option) == withValue.end()) malformed("unknown option", option);
    if (++i == words.size()) malformed("an option without its value", option);
    const std::string& value = words[i];
    if (option == "--channels") {
      options.channels = channelsOf(value);
    } else if (option == "--time-limit") {
      options.timeLimit = numberOf(option, value, 0, 1e9);
    } else if (option == "--processes") {
      options.processes = static_cast<std::size_t>(numberOf(option, value, 1, kMostProcesses));
    } else {
      const auto found = std::ranges::find(kSymmetries, value, [](const auto& pair) { return pair.first; });
      if (found == kSymmetries.end()) malformed("unusable --symmetry", value, "isotropic, bilateral, anisotropic");
      options.symmetry = found->second;
    }
  }
  options.command.assign(words.begin() + static_cast<std::ptrdiff_t>(i), words.end());
  if (options.command.empty()) malformed("no program given", text);
  return options;
}

std::string programText(const ProgramOptions& options) {
  std::string text;
  if (options.channels) {
    std::vector<std::string> names;
    for (const double wavelength : options.channels->wavelengths) names.push_back(formatNumber(wavelength));
    const bool rgb = options.channels->kind == Channels::Kind::Rgb;
    text += "--channels " + (names.empty() ? std::string(rgb ? "rgb" : "mono") : joined(names, ",")) + " ";
  }
  for (const auto& [name, symmetry] : kSymmetries)
    if (symmetry == options.symmetry && symmetry != ProgramOptions().symmetry)
      text += "--symmetry " + std::string(name) + " ";
  if (options.reciprocal) text += "--reciprocal ";
  if (options.stays) text += "--stay ";
  if (options.timeLimit != ProgramOptions().timeLimit) text += "--time-limit " + formatNumber(options.timeLimit) + " ";
  if (options.processes) text += "--processes " + std::to_string(options.processes) + " ";
  if (!options.command.empty() && options.command[0].starts_with("--")) text += "-- ";
  std::vector<std::string> words;
  for (const std::string& word : options.command) words.push_back(quoted(word));
  return text + joined(words, " ");
}

}  // namespace brdf
