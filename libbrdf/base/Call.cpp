#include <brdf/base/Call.h>
#include <brdf/base/Error.h>
#include <brdf/base/Text.h>

#include <algorithm>

namespace brdf {
namespace {

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool isNameCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}
bool isName(std::string_view text) {
  return !text.empty() && !(text[0] >= '0' && text[0] <= '9') && std::ranges::all_of(text, isNameCharacter);
}

class CallSplitter {
 public:
  CallSplitter(std::string_view text, const std::string& what, std::size_t column)
      : text_(text), call_{{}, column, what, {}}, first_(column) {}

  Call call() {
    skipBlanks();
    call_.column = first_ + at_;
    const std::size_t start = at_;
    while (at_ < text_.size() && isNameCharacter(text_[at_])) ++at_;
    call_.name = text_.substr(start, at_ - start);
    if (!isName(call_.name)) fail("expected a name", start);
    skipBlanks();
    if (at_ < text_.size() && text_[at_] == '(') arguments();
    skipBlanks();
    if (at_ < text_.size()) fail("expected the end", at_);
    return std::move(call_);
  }

 private:
  [[noreturn]] void fail(std::string message, std::size_t at) const {
    throw Error(Error::Kind::Formula, {std::move(message),
                                       call_.where(first_ + at),
                                       at < text_.size() ? "'" + std::string(text_.substr(at, 12)) + "'" : "the end",
                                       {}});
  }

  void skipBlanks() {
    while (at_ < text_.size() && isBlank(text_[at_])) ++at_;
  }

  void arguments() {
    const std::size_t open = at_++;
    skipBlanks();
    if (at_ < text_.size() && text_[at_] == ')') {
      ++at_;
      return;
    }
    for (;;) {
      const std::size_t start = at_;
      skipArgument(open);
      argument(start, at_);
      if (text_[at_++] == ')') return;
    }
  }

  /// To the comma or parenthesis that ends the argument.
  void skipArgument(std::size_t open) {
    int depth = 0;
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '"') {
        const std::size_t close = text_.find('"', at_ + 1);
        if (close == std::string_view::npos) fail("quote not closed", at_);
        at_ = close;
      } else if (depth == 0 && (c == ',' || c == ')')) {
        return;
      } else if (c == '(') {
        ++depth;
      } else if (c == ')') {
        --depth;
      }
    }
    fail("parenthesis not closed", open);
  }

  void argument(std::size_t start, std::size_t end) {
    while (start < end && isBlank(text_[start])) ++start;
    Call::Argument argument;
    argument.keyColumn = first_ + start;
    const std::size_t equals = text_.find('=', start);
    if (equals < end) {
      const std::string_view key = trimmed(text_.substr(start, equals - start));
      if (isName(key)) {
        argument.key = key;
        const auto same = [&](const Call::Argument& other) { return other.key == argument.key; };
        if (std::ranges::any_of(call_.arguments, same)) fail("parameter given twice", start);
        start = equals + 1;
        while (start < end && isBlank(text_[start])) ++start;
      }
    }
    std::string_view text = trimmed(text_.substr(start, end - start));
    if (text.empty()) fail("expected a value", start);
    argument.column = first_ + start;
    if (text.size() >= 2 && text.front() == '"' && text.find('"', 1) == text.size() - 1)
      text = text.substr(1, text.size() - 2);
    argument.text = text;
    call_.arguments.push_back(std::move(argument));
  }

  std::string_view text_;
  Call call_;
  std::size_t first_;
  std::size_t at_ = 0;
};

}  // namespace

Call parseCall(std::string_view text, const std::string& what, std::size_t column) {
  return CallSplitter(text, what, column).call();
}

std::vector<double> numbersOf(const Call& call, const Call::Argument& argument) {
  std::string_view text = argument.text;
  const bool list = text.size() >= 2 && text.front() == '(' && text.back() == ')';
  if (list) text = text.substr(1, text.size() - 2);
  std::vector<double> numbers;
  for (std::size_t at = 0; at <= text.size();) {
    while (at < text.size() && isBlank(text[at])) ++at;
    std::size_t end = at;
    while (end < text.size() && !isBlank(text[end]) && !(list && text[end] == ',')) ++end;
    const auto number = parseNumber(text.substr(at, end - at));
    if (!number)
      throw Error(Error::Kind::Formula, {"expected a number", call.where(argument.column), "'" + argument.text + "'",
                                         "a number, or a list of numbers such as (0.1, 0.2, 0.3)"});
    numbers.push_back(*number);
    at = end;
    while (at < text.size() && isBlank(text[at])) ++at;
    if (at == text.size()) break;
    if (list && text[at] == ',') ++at;
  }
  return numbers;
}

}  // namespace brdf
