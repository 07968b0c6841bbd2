#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/material/LobeSum.h>

#include <algorithm>
#include <cctype>

namespace brdf {
namespace {

class ExpressionReader {
 public:
  explicit ExpressionReader(std::string_view text) : text_(text) {}

  std::vector<Lobe> lobes() {
    std::vector<Lobe> result;
    do result.push_back(term());
    while (accept('+'));
    if (skipBlanks(); at_ < text_.size()) fail("expected '+' or the end", at_);
    return result;
  }

  /// Length of the lists seen, 1 when there was none; throws when two differ.
  std::size_t listLength() const { return listLength_; }

 private:
  [[noreturn]] void fail(std::string what, std::size_t at, std::string allowed = {}) const {
    const std::string found = at < text_.size() ? "'" + std::string(text_.substr(at, 12)) + "'" : "the end";
    throw Error(Error::Kind::Formula,
                {std::move(what), "material expression, column " + std::to_string(at + 1), found, std::move(allowed)});
  }

  void skipBlanks() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
  }
  char peek() {
    skipBlanks();
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool accept(char c) {
    if (peek() != c) return false;
    ++at_;
    return true;
  }
  void expect(char c) {
    if (!accept(c)) fail(std::string("expected '") + c + "'", at_);
  }
  bool atName() { return std::isalpha(static_cast<unsigned char>(peek())) || peek() == '_'; }

  std::string name() {
    skipBlanks();
    const std::size_t start = at_;
    while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) || text_[at_] == '_')) ++at_;
    return std::string(text_.substr(start, at_ - start));
  }

  double number() {
    skipBlanks();
    std::size_t end = at_;
    while (end < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[end])) || text_[end] == '.' ||
                                  ((text_[end] == '+' || text_[end] == '-') &&
                                   (end == at_ || text_[end - 1] == 'e' || text_[end - 1] == 'E'))))
      ++end;
    const auto value = parseNumber(text_.substr(at_, end - at_));
    if (!value) fail("expected a number", at_);
    at_ = end;
    return *value;
  }

  std::vector<double> numbers() {
    if (!accept('(')) return {number()};
    const std::size_t start = at_;
    std::vector<double> values;
    do values.push_back(number());
    while (accept(','));
    expect(')');
    if (values.size() > 1) {
      if (listLength_ != 1 && listLength_ != values.size())
        fail("lists of different lengths (" + std::to_string(listLength_) + " and " + std::to_string(values.size()) +
                 ")",
             start);
      listLength_ = values.size();
    }
    return values;
  }

  Lobe term() {
    Lobe lobe;
    while (!atName()) {
      if (peek() == '\0') fail("expected a lobe", at_, joined(modelNames()));
      scaleBy(lobe.scale, numbers());
      expect('*');
    }
    const std::size_t start = at_;
    const std::string modelName = name();
    const std::vector<std::string> known = modelNames();
    if (std::find(known.begin(), known.end(), modelName) == known.end()) {
      const std::string nearest = closestName(modelName, known);
      fail("unknown lobe", start, joined(known) + (nearest.empty() ? "" : " (did you mean " + nearest + "?)"));
    }
    lobe.model = findModel(modelName);
    lobe.parameters.resize(lobe.model->parameters().size());
    if (accept('(') && !accept(')')) {
      do argument(lobe);
      while (accept(','));
      expect(')');
    }
    for (std::size_t k = 0; k < lobe.parameters.size(); ++k) {
      if (!lobe.parameters[k].empty()) continue;
      const Parameter& parameter = lobe.model->parameters()[k];
      lobe.parameters[k] = parameter.follows.empty() ? std::vector{parameter.defaultValue}
                                                     : lobe.parameters[lobe.model->parameterIndex(parameter.follows)];
    }
    return lobe;
  }

  void argument(Lobe& lobe) {
    if (!atName()) fail("expected a parameter of " + lobe.model->name(), at_, parameterNames(*lobe.model));
    const std::size_t start = at_;
    const std::string parameter = name();
    const auto& parameters = lobe.model->parameters();
    const auto it =
        std::find_if(parameters.begin(), parameters.end(), [&](const Parameter& p) { return p.name == parameter; });
    if (it == parameters.end()) fail("unknown parameter of " + lobe.model->name(), start, parameterNames(*lobe.model));
    auto& values = lobe.parameters[static_cast<std::size_t>(it - parameters.begin())];
    if (!values.empty()) fail("parameter given twice", start);
    expect('=');
    values = numbers();
  }

  static void scaleBy(std::vector<double>& scale, const std::vector<double>& factors) {
    std::vector<double> product(std::max(scale.size(), factors.size()));
    for (std::size_t k = 0; k < product.size(); ++k)
      product[k] = scale[scale.size() == 1 ? 0 : k] * factors[factors.size() == 1 ? 0 : k];
    scale = std::move(product);
  }

  static std::vector<std::string> modelNames() {
    std::vector<std::string> names;
    for (const ModelPointer& model : allModels()) names.push_back(model->name());
    return names;
  }
  static std::string parameterNames(const Model& model) {
    std::vector<std::string> names;
    for (const Parameter& parameter : model.parameters()) names.push_back(parameter.name);
    return names.empty() ? "none" : joined(names);
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t listLength_ = 1;
};

}  // namespace

std::shared_ptr<const LobeSum> parseMaterialExpression(std::string_view text, std::optional<Channels> channels) {
  ExpressionReader reader(text);
  std::vector<Lobe> lobes = reader.lobes();
  if (!channels) {
    if (reader.listLength() != 1 && reader.listLength() != 3)
      throw Error(Error::Kind::Formula, {"lists of values must have one value a channel", "material expression",
                                         std::to_string(reader.listLength()) + " values", "3 (RGB)"});
    channels = reader.listLength() == 3 ? Channels::rgb() : Channels::monochrome();
  }
  return std::make_shared<LobeSum>(std::move(lobes), std::move(*channels));
}

}  // namespace brdf
