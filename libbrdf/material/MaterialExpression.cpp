#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/material/LobeSum.h>
#include <brdf/models/Microfacet.h>

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
    if (modelName == "Microfacet") {
      microfacet(lobe);
    } else {
      lobe.model = model(modelName, start);
      lobe.parameters.resize(lobe.model->parameters().size());
      arguments(lobe);
    }
    for (std::size_t k = 0; k < lobe.parameters.size(); ++k) {
      if (!lobe.parameters[k].empty()) continue;
      const Parameter& parameter = lobe.model->parameters()[k];
      lobe.parameters[k] = parameter.follows.empty() ? std::vector{parameter.defaultValue}
                                                     : lobe.parameters[lobe.model->parameterIndex(parameter.follows)];
    }
    return lobe;
  }

  ModelPointer model(const std::string& modelName, std::size_t start) const {
    const std::vector<std::string> known = modelNames();
    const bool composed = modelName.rfind("Microfacet_", 0) == 0;
    if (!composed && std::find(known.begin(), known.end(), modelName) == known.end()) {
      const std::string nearest = closestName(modelName, known);
      fail("unknown lobe", start, joined(known) + (nearest.empty() ? "" : " (did you mean " + nearest + "?)"));
    }
    return findModel(modelName);
  }

  void arguments(Lobe& lobe) {
    if (!accept('(') || accept(')')) return;
    do argument(lobe);
    while (accept(','));
    expect(')');
  }

  /// Microfacet(D=GGX(alpha=0.2), F=Dielectric(ior=1.5), G=Smith): each term once, in any order, its parameters in its
  /// own parentheses.
  void microfacet(Lobe& lobe) {
    struct Term {
      char key;
      const std::vector<std::string>& names;
      std::string name;
      std::size_t argumentsAt = 0;  ///< where its '(' stands, or 0
    };
    const MicrofacetTerms& known = microfacetTerms();
    Term terms[] = {{'D', known.distributions, {}}, {'F', known.fresnels, {}}, {'G', known.shadowings, {}}};
    expect('(');
    do {
      skipBlanks();
      const std::size_t start = at_;
      const std::string key = name();
      Term* term = nullptr;
      for (Term& candidate : terms)
        if (key.size() == 1 && key[0] == candidate.key) term = &candidate;
      if (term == nullptr) fail("expected a term of Microfacet", start, "D=..., F=..., G=...");
      if (!term->name.empty()) fail("term given twice", start);
      expect('=');
      skipBlanks();
      const std::size_t termStart = at_;
      term->name = name();
      if (std::find(term->names.begin(), term->names.end(), term->name) == term->names.end())
        fail("unknown " + key, termStart, joined(term->names));
      if (peek() != '(') continue;
      term->argumentsAt = at_;
      skipParentheses();
    } while (accept(','));
    expect(')');
    const std::size_t end = at_;
    for (const Term& term : terms)
      if (term.name.empty()) fail(std::string("Microfacet lacks its ") + term.key, end - 1, joined(term.names));
    lobe.model = composeMicrofacet(terms[0].name, terms[1].name, terms[2].name);
    lobe.parameters.resize(lobe.model->parameters().size());
    for (const Term& term : terms) {
      if (term.argumentsAt == 0) continue;
      at_ = term.argumentsAt;
      arguments(lobe);
    }
    at_ = end;
  }

  void skipParentheses() {
    const std::size_t start = at_;
    int depth = 0;
    do {
      if (at_ >= text_.size()) fail("parenthesis not closed", start);
      if (text_[at_] == '(') ++depth;
      if (text_[at_] == ')') --depth;
      ++at_;
    } while (depth > 0);
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
    for (const ModelPointer& known : allModels()) names.push_back(known->name());
    names.emplace_back("Microfacet");
    return names;
  }
  static std::string parameterNames(const Model& owner) {
    std::vector<std::string> names;
    for (const Parameter& parameter : owner.parameters()) names.push_back(parameter.name);
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
