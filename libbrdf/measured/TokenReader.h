#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// The tokens of a text: what stands between blanks, over lines of any ending; a leading byte order mark is skipped.
/// Every failure is an Error::Kind::Format that names the file and the line of the token read last.
class TokenReader {
 public:
  /// `comment` starts a comment that ends with the line.
  TokenReader(std::string_view text, std::filesystem::path path, char comment);

  /// Whether a token is left.
  bool more();
  /// The next token, not taken; empty at the end.
  std::string_view peek();
  /// Takes the next token; fails at the end. `what` names it in the message.
  std::string_view next(std::string_view what);
  /// Takes the next token if it is `word`, upper and lower case alike.
  bool accept(std::string_view word);
  /// Whether the next token is a number.
  bool numberNext();

  double number(std::string_view what);
  /// A finite number from low to high.
  double number(std::string_view what, double low, double high);
  /// A number of things that the file lists after it: at least 1, and no more than the rest of the file can hold.
  std::size_t count(std::string_view what);
  /// A counted list: how many, then as many finite numbers from low to high, each greater than the one before. Fails
  /// where `into` has numbers already: the key `what` stands twice.
  void list(std::vector<double>& into, std::string_view what, double low, double high);
  /// Fails unless the rest of the file can hold `factors` multiplied numbers: call before making room for them. Returns
  /// the product.
  std::size_t room(const std::vector<std::size_t>& factors, std::string_view what) const;

  [[noreturn]] void fail(std::string what, std::string found, std::string allowed) const;
  /// Fails about a token, unless it is one of `allowed` (upper and lower case alike); returns its index.
  std::size_t oneOf(std::string_view what, const std::vector<std::string>& allowed);

 private:
  void skip();

  std::string_view text_;
  std::filesystem::path path_;
  char comment_;
  std::size_t position_ = 0;
  std::size_t line_ = 1, tokenLine_ = 1;
};

/// Whether two words are the same, upper and lower case (ASCII) alike.
bool sameWord(std::string_view a, std::string_view b);
/// Whether `word` is among the tokens of `head`, a text, comments left out, upper and lower case alike.
bool hasWord(std::string_view head, char comment, std::string_view word);
/// The product, or the largest number where it overflows.
std::size_t boundedProduct(const std::vector<std::size_t>& factors);

}  // namespace brdf
