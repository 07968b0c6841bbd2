#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/formula/Syntax.h>

#include <cctype>

namespace brdf::formula {
namespace {

constexpr int kMaximumDepth = 200;  // of nested parentheses and calls: bounds the stack

struct Token {
  enum class Kind { Number, Name, Symbol, End };
  Kind kind = Kind::End;
  std::string text;
  double number = 0;
  Position position;
};

bool isNameStart(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; }
bool isDigit(char c) { return std::isdigit(static_cast<unsigned char>(c)); }

class Lexer {
 public:
  Lexer(std::string_view text, const std::string& where, Position start)
      : text_(text), where_(where), position_(start) {}

  Token next() {
    skipBlanks();
    Token token;
    token.position = position_;
    if (at_ >= text_.size()) return token;
    const char c = text_[at_];
    if (text_.substr(at_, 7) == "U+003C=") return symbol(token, "<=", 7);
    if (text_.substr(at_, 6) == "U+003C") return symbol(token, "<", 6);
    if (isDigit(c) || (c == '.' && at_ + 1 < text_.size() && isDigit(text_[at_ + 1]))) return number(token);
    if (isNameStart(c)) {
      std::size_t end = at_;
      while (end < text_.size() && (isNameStart(text_[end]) || isDigit(text_[end]))) ++end;
      token.kind = Token::Kind::Name;
      token.text = std::string(text_.substr(at_, end - at_));
      advance(end - at_);
      return token;
    }
    for (const std::string_view two : {"<=", ">=", "==", "!=", "&&", "||"})
      if (text_.substr(at_, 2) == two) return symbol(token, two, 2);
    if (std::string_view("+-*/^()=,;<>!?:").find(c) != std::string_view::npos)
      return symbol(token, text_.substr(at_, 1), 1);
    std::size_t length = 1;  // all bytes of a character in UTF-8
    while (at_ + length < text_.size() && (static_cast<unsigned char>(text_[at_ + length]) & 0xC0) == 0x80) ++length;
    formulaError(where_, position_, "unexpected character", "'" + std::string(text_.substr(at_, length)) + "'");
  }

 private:
  void advance(std::size_t count) {
    for (; count > 0; --count, ++at_) {
      if (text_[at_] == '\n') {
        ++position_.line;
        position_.column = 1;
      } else {
        ++position_.column;
      }
    }
  }

  void skipBlanks() {
    while (at_ < text_.size()) {
      if (std::isspace(static_cast<unsigned char>(text_[at_]))) {
        advance(1);
      } else if (text_[at_] == '#' || text_.substr(at_, 2) == "//") {
        while (at_ < text_.size() && text_[at_] != '\n') advance(1);
      } else {
        return;
      }
    }
  }

  Token symbol(Token token, std::string_view text, std::size_t length) {
    token.kind = Token::Kind::Symbol;
    token.text = std::string(text);
    advance(length);
    return token;
  }

  Token number(Token token) {
    std::size_t end = at_;
    while (end < text_.size() && isDigit(text_[end])) ++end;
    if (end < text_.size() && text_[end] == '.') ++end;
    while (end < text_.size() && isDigit(text_[end])) ++end;
    if (end < text_.size() && (text_[end] == 'e' || text_[end] == 'E')) {
      std::size_t exponent = end + 1;
      if (exponent < text_.size() && (text_[exponent] == '+' || text_[exponent] == '-')) ++exponent;
      if (exponent < text_.size() && isDigit(text_[exponent])) {
        while (exponent < text_.size() && isDigit(text_[exponent])) ++exponent;
        end = exponent;
      }
    }
    const std::string_view digits = text_.substr(at_, end - at_);
    const auto value = parseNumber(digits);
    if (!value) formulaError(where_, position_, "not a number", "'" + std::string(digits) + "'");
    token.kind = Token::Kind::Number;
    token.number = *value;
    token.text = std::string(digits);
    advance(end - at_);
    return token;
  }

  std::string_view text_;
  const std::string& where_;
  std::size_t at_ = 0;
  Position position_;
};

class Parser {
 public:
  Parser(std::string_view text, const std::string& where, Position start) : where_(where) {
    Lexer lexer(text, where, start);
    do tokens_.push_back(lexer.next());
    while (tokens_.back().kind != Token::Kind::End);
  }

  std::vector<Statement> statements() {
    std::vector<Statement> result;
    while (true) {
      while (accept(";")) {
      }
      if (peek().kind == Token::Kind::End) break;
      result.push_back(statement());
      if (peek().kind != Token::Kind::End && !isSymbol(";")) unexpected("';' or an operator");
    }
    if (result.empty()) formulaError(where_, {}, "empty formula", {}, "at least one expression");
    return result;
  }

 private:
  using Pointer = std::unique_ptr<Expression>;

  const Token& peek(std::size_t ahead = 0) const { return tokens_[std::min(at_ + ahead, tokens_.size() - 1)]; }
  bool isSymbol(std::string_view text, std::size_t ahead = 0) const {
    return peek(ahead).kind == Token::Kind::Symbol && peek(ahead).text == text;
  }
  bool accept(std::string_view text) {
    if (!isSymbol(text)) return false;
    ++at_;
    return true;
  }
  void expect(std::string_view text) {
    if (!accept(text)) unexpected("'" + std::string(text) + "'");
  }
  [[noreturn]] void unexpected(const std::string& expected) const {
    const Token& token = peek();
    formulaError(where_, token.position, "expected " + expected,
                 token.kind == Token::Kind::End ? "the end of the formula" : "'" + token.text + "'");
  }

  Statement statement() {
    Statement result;
    result.position = peek().position;
    if (peek().kind == Token::Kind::Name && isSymbol("=", 1)) {
      result.target = peek().text;
      at_ += 2;
    } else if (const std::size_t end = definitionEnd(); end != 0) {
      result.target = peek().text;
      result.isFunction = true;
      for (std::size_t k = at_ + 2; k < end; k += 2) result.arguments.push_back(tokens_[k].text);
      at_ = end + 2;
    }
    result.value = ternary();
    return result;
  }

  /// Index of the ')' when the tokens from here read `name(a, b) =`, else 0.
  std::size_t definitionEnd() const {
    if (peek().kind != Token::Kind::Name || !isSymbol("(", 1)) return 0;
    std::size_t k = at_ + 2;
    while (tokens_[k].kind == Token::Kind::Name) {
      if (k + 2 >= tokens_.size() || tokens_[k + 1].kind != Token::Kind::Symbol) return 0;
      if (tokens_[k + 1].text == ")") {
        const bool assigned = tokens_[k + 2].kind == Token::Kind::Symbol && tokens_[k + 2].text == "=";
        return assigned ? k + 1 : 0;
      }
      if (tokens_[k + 1].text != ",") return 0;
      k += 2;
    }
    return 0;
  }

  static Pointer call(std::string name, Position position, Pointer a, Pointer b = nullptr, Pointer c = nullptr) {
    auto result = std::make_unique<Expression>();
    result->kind = Expression::Kind::Call;
    result->name = std::move(name);
    result->position = position;
    for (Pointer* argument : {&a, &b, &c})
      if (*argument) result->arguments.push_back(std::move(*argument));
    return result;
  }

  struct Depth {
    explicit Depth(Parser& parser) : parser_(parser) {
      if (++parser_.depth_ > kMaximumDepth)
        formulaError(parser_.where_, parser_.peek().position, "nested too deeply", {},
                     "at most " + std::to_string(kMaximumDepth) + " levels");
    }
    ~Depth() { --parser_.depth_; }
    Parser& parser_;
  };

  Pointer ternary() {
    const Depth depth(*this);
    Pointer condition = binary(0);
    const Position position = peek().position;
    if (!accept("?")) return condition;
    Pointer yes = ternary();
    expect(":");
    Pointer no = ternary();
    return call("select", position, std::move(condition), std::move(yes), std::move(no));
  }

  /// Left-associative binary operators, loosest first.
  Pointer binary(std::size_t level) {
    static const std::vector<std::vector<std::string_view>> levels = {
        {"||"}, {"&&"}, {"==", "!="}, {"<=", ">=", "<", ">"}, {"+", "-"}, {"*", "/"}};
    if (level == levels.size()) return unary();
    Pointer left = binary(level + 1);
    while (true) {
      std::string_view found;
      for (const std::string_view symbol : levels[level])
        if (isSymbol(symbol)) found = symbol;
      if (found.empty()) return left;
      const Position position = peek().position;
      ++at_;
      left = call(std::string(found), position, std::move(left), binary(level + 1));
    }
  }

  Pointer unary() {
    const Depth depth(*this);
    const Position position = peek().position;
    if (accept("-")) return call("neg", position, unary());
    if (accept("+")) return unary();
    if (accept("!")) return call("!", position, unary());
    Pointer base = primary();
    const Position at = peek().position;
    if (accept("^")) return call("pow", at, std::move(base), unary());
    return base;
  }

  Pointer primary() {
    const Token token = peek();
    if (accept("(")) {
      Pointer inside = ternary();
      expect(")");
      return inside;
    }
    auto result = std::make_unique<Expression>();
    result->position = token.position;
    if (token.kind == Token::Kind::Number) {
      result->number = token.number;
      ++at_;
      return result;
    }
    if (token.kind != Token::Kind::Name) unexpected("a number, a name or '('");
    ++at_;
    result->kind = Expression::Kind::Name;
    result->name = token.text;
    if (!accept("(")) return result;
    result->kind = Expression::Kind::Call;
    if (accept(")")) return result;
    do result->arguments.push_back(ternary());
    while (accept(","));
    if (!accept(")")) unexpected("',' or ')'");
    return result;
  }

  const std::string& where_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

void formulaError(const std::string& where, Position position, std::string what, std::string found,
                  std::string allowed) {
  throw Error(Error::Kind::Formula,
              {std::move(what),
               where + ", line " + std::to_string(position.line) + ", column " + std::to_string(position.column),
               std::move(found), std::move(allowed)});
}

std::vector<Statement> parseStatements(std::string_view text, const std::string& where, Position start) {
  return Parser(text, where, start).statements();
}

}  // namespace brdf::formula
