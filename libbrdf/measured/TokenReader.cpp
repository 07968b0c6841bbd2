#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/measured/ScatteredText.h>
#include <brdf/measured/TokenReader.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace brdf {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\v\f";

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

std::string quoted(std::string_view token) { return "\"" + std::string(token.substr(0, 40)) + "\""; }

}  // namespace

TokenReader::TokenReader(std::string_view text, std::filesystem::path path, char comment)
    : text_(withoutByteOrderMark(text)), path_(std::move(path)), comment_(comment) {}

void TokenReader::skip() {
  while (position_ < text_.size()) {
    const char c = text_[position_];
    if (c == comment_) {
      position_ = std::min(text_.find('\n', position_), text_.size());
    } else if (kBlanks.find(c) != std::string_view::npos) {
      line_ += c == '\n';
      ++position_;
    } else {
      return;
    }
  }
}

bool TokenReader::more() {
  skip();
  return position_ < text_.size();
}

std::string_view TokenReader::peek() {
  skip();
  std::size_t end = position_;
  while (end < text_.size() && text_[end] != comment_ && kBlanks.find(text_[end]) == std::string_view::npos) ++end;
  return text_.substr(position_, end - position_);
}

std::string_view TokenReader::next(std::string_view what) {
  const std::string_view token = peek();
  tokenLine_ = line_;
  if (token.empty()) fail("the file ends where " + std::string(what) + " should be", {}, {});
  position_ += token.size();
  return token;
}

bool TokenReader::accept(std::string_view word) {
  if (!sameWord(peek(), word)) return false;
  next(word);
  return true;
}

bool TokenReader::numberNext() { return parseNumber(peek()).has_value(); }

double TokenReader::number(std::string_view what) {
  const std::string_view token = next(what);
  const auto value = parseNumber(token);
  if (!value) fail("no number where " + std::string(what) + " should be", quoted(token), {});
  return *value;
}

double TokenReader::number(std::string_view what, double low, double high) {
  const double value = number(what);
  if (!(value >= low && value <= high))
    fail("out of range: " + std::string(what), formatNumber(value), formatNumber(low) + " to " + formatNumber(high));
  return value;
}

std::size_t TokenReader::count(std::string_view what) {
  const double value = number(what);
  const std::size_t most = (text_.size() - position_ + 1) / 2;  // a number and a blank each
  if (!(value >= 1 && value <= static_cast<double>(most) && value == std::floor(value)))
    fail("wrong " + std::string(what), formatNumber(value),
         "a whole number, at least 1, at most the " + std::to_string(most) + " that the rest of the file can hold");
  return static_cast<std::size_t>(value);
}

void TokenReader::list(std::vector<double>& into, std::string_view what, double low, double high) {
  if (!into.empty()) fail("a key stands twice", std::string(what), "once");
  const std::size_t size = count("number of " + std::string(what));
  into.reserve(room({size}, what));
  while (into.size() < size) {
    const double value = number(what, low, high);
    if (!into.empty() && !(value > into.back()))
      fail("not ascending: " + std::string(what), formatNumber(value) + " after " + formatNumber(into.back()),
           "ascending numbers");
    into.push_back(value);
  }
}

std::size_t TokenReader::room(const std::vector<std::size_t>& factors, std::string_view what) const {
  const std::size_t needed = boundedProduct(factors), most = (text_.size() - position_ + 1) / 2;
  if (needed > most)
    throw Error(Error::Kind::Format,
                {"the file is too short for " + std::string(what), path_.string() + ", line " + std::to_string(line_),
                 std::to_string(needed) + " announced", "at most " + std::to_string(most) + " in what is left of it"});
  return needed;
}

void TokenReader::fail(std::string what, std::string found, std::string allowed) const {
  throw Error(Error::Kind::Format, {std::move(what), path_.string() + ", line " + std::to_string(tokenLine_),
                                    std::move(found), std::move(allowed)});
}

std::size_t TokenReader::oneOf(std::string_view what, const std::vector<std::string>& allowed) {
  const std::string_view token = next(what);
  for (std::size_t i = 0; i < allowed.size(); ++i)
    if (sameWord(token, allowed[i])) return i;
  fail("unknown " + std::string(what), quoted(token), joined(allowed));
}

bool sameWord(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return lower(x) == lower(y); });
}

bool hasWord(std::string_view head, char comment, std::string_view word) {
  if (head.find('\0') != std::string_view::npos) return false;
  TokenReader reader(head, {}, comment);
  while (reader.more())
    if (sameWord(reader.next({}), word)) return true;
  return false;
}

std::size_t boundedProduct(const std::vector<std::size_t>& factors) {
  std::size_t product = 1;
  for (const std::size_t factor : factors) {
    if (factor != 0 && product > std::numeric_limits<std::size_t>::max() / factor)
      return std::numeric_limits<std::size_t>::max();
    product *= factor;
  }
  return product;
}

}  // namespace brdf
