#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/color/Colorimetry.h>
#include <brdf/measured/RadianceData.h>

#include <algorithm>
#include <cmath>

namespace brdf::radiance {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\v\f";
constexpr std::string_view kNumberEnds = " \t\r\n\v\f,{}";

bool isBlank(char c) { return kBlanks.find(c) != std::string_view::npos; }
char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// Reads the text of one element from its beginning.
class Scanner {
 public:
  Scanner(const Source& source, const pugi::xml_node& element, Counts& counts)
      : source_(source), element_(element), text_(element.text().get()), counts_(counts) {}

  std::string_view text() const { return text_; }
  /// The next character that is no blank, without taking it; 0 at the end.
  char peek() {
    while (position_ < text_.size() && isBlank(text_[position_])) ++position_;
    return position_ < text_.size() ? text_[position_] : '\0';
  }
  bool take(char c) {
    if (peek() != c) return false;
    ++position_;
    return true;
  }
  /// The next number and a comma after it; negative ones and those that are not finite are counted and made 0.
  double number() {
    peek();
    const std::size_t end = std::min(text_.find_first_of(kNumberEnds, position_), text_.size());
    const auto value = parseNumber(text_.substr(position_, end - position_));
    if (!value) fail("no number in ScatteringData", shown(), "a number");
    position_ = end;
    take(',');
    if (!std::isfinite(*value)) {
      ++counts_.notFinite;
      return 0;
    }
    counts_.negative += *value < 0;
    return std::max(*value, 0.0);
  }
  [[noreturn]] void fail(std::string what, std::string found, std::string allowed) const {
    const auto newlines = std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(position_), '\n');
    const std::ptrdiff_t offset = element_.text().data().offset_debug();
    const std::size_t line = source_.lineAt(offset >= 0 ? offset : element_.offset_debug());
    throw Error(Error::Kind::Format,
                {std::move(what),
                 source_.path.string() +
                     (line > 0 ? ", line " + std::to_string(line + static_cast<std::size_t>(newlines)) : ""),
                 std::move(found), std::move(allowed)});
  }
  std::string shown() const {
    if (position_ >= text_.size()) return "its end";
    std::string part;
    for (const char c : text_.substr(position_, 20)) part += (c >= ' ' && c < 127) ? c : ' ';
    return "\"" + std::string(trimmed(part)) + "\"";
  }

 private:
  const Source& source_;
  pugi::xml_node element_;
  std::string_view text_;
  Counts& counts_;
  std::size_t position_ = 0;
};

class TreeReader {
 public:
  TreeReader(Scanner& scanner, int rank) : scanner_(scanner), tree_(rank, 1) {}

  TensorTree read() {
    node(0, 0);
    if (scanner_.peek() != '\0') scanner_.fail("something follows the tensor tree", scanner_.shown(), "nothing");
    return std::move(tree_);
  }

 private:
  void node(TensorTree::Node at, int depth) {
    if (!scanner_.take('{')) scanner_.fail("a node of the tensor tree is missing", scanner_.shown(), "'{'");
    if (scanner_.peek() == '{') {
      if (depth == TensorTree::kMaximumDepth)
        scanner_.fail("the tensor tree is too deep", std::to_string(depth + 1) + " levels",
                      std::to_string(TensorTree::kMaximumDepth));
      const TensorTree::Node first = tree_.divide(at);
      for (std::size_t c = 0; c < tree_.children(); ++c) node(first + static_cast<TensorTree::Node>(c), depth + 1);
    } else {
      grid(at, depth);
    }
    if (!scanner_.take('}')) scanner_.fail("a node of the tensor tree does not end", scanner_.shown(), "'}'");
    scanner_.take(',');
  }

  void grid(TensorTree::Node at, int depth) {
    numbers_.clear();
    while (scanner_.peek() != '}') numbers_.push_back(scanner_.number());
    int levels = 0;
    while (std::size_t{1} << (tree_.rank() * levels) < numbers_.size()) ++levels;
    if (std::size_t{1} << (tree_.rank() * levels) != numbers_.size())
      scanner_.fail("wrong number of values in a node of the tensor tree", std::to_string(numbers_.size()),
                    "1 or a power of " + std::to_string(tree_.children()));
    if (depth + levels > TensorTree::kMaximumDepth)
      scanner_.fail("the tensor tree is too deep", std::to_string(depth + levels) + " levels",
                    std::to_string(TensorTree::kMaximumDepth));
    tree_.divideIntoGrid(at, levels, numbers_);
  }

  Scanner& scanner_;
  TensorTree tree_;
  std::vector<double> numbers_;
};

}  // namespace

std::size_t Source::lineAt(std::ptrdiff_t offset) const {
  if (offset < 0) return 0;
  const auto end = std::min(bytes.size(), static_cast<std::size_t>(offset));
  return 1 +
         static_cast<std::size_t>(std::count(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
}

void Source::fail(const pugi::xml_node& node, std::string what, std::string found, std::string allowed) const {
  const std::size_t line = lineAt(node.offset_debug());
  throw Error(Error::Kind::Format, {std::move(what), path.string() + (line > 0 ? ", line " + std::to_string(line) : ""),
                                    std::move(found), std::move(allowed)});
}

bool sameText(std::string_view a, std::string_view b) {
  a = trimmed(a);
  b = trimmed(b);
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return lower(x) == lower(y); });
}

std::vector<PatchBasis> readBases(const Source& source, const pugi::xml_node& definition) {
  std::vector<PatchBasis> bases;
  for (const pugi::xml_node basis : definition.children("AngleBasis")) {
    const std::string name(trimmed(basis.child("AngleBasisName").text().get()));
    if (name.empty()) source.fail(basis, "AngleBasis without AngleBasisName");
    const auto number = [&](const pugi::xml_node& node, const char* what) {
      const auto value = parseNumber(trimmed(node.text().get()));
      if (!value) source.fail(node ? node : basis, std::string("AngleBasis without ") + what, node.text().get());
      return *value;
    };
    std::vector<PatchBasis::Ring> rings;
    double upper = 0;
    for (const pugi::xml_node block : basis.children("AngleBasisBlock")) {
      const pugi::xml_node bounds = block.child("ThetaBounds");
      const double below = upper, lower = number(bounds.child("LowerTheta"), "LowerTheta");
      upper = number(bounds.child("UpperTheta"), "UpperTheta");
      const double count = number(block.child("nPhis"), "nPhis");
      // Radiance takes the first ring to begin at 0 whatever the file says, and others within a millionth.
      if (!rings.empty() && !(std::abs(lower - below) <= 1e-6 * below))
        source.fail(block, "rings of an AngleBasis do not meet", formatNumber(lower, 9) + " degrees",
                    formatNumber(below, 9) + " degrees");
      if (!(count >= 1 && count <= 1e6 && count == std::floor(count)))
        source.fail(block, "wrong nPhis", formatNumber(count, 9), "a whole number from 1");
      rings.push_back({radians(upper), static_cast<std::size_t>(count)});
    }
    try {
      bases.emplace_back(name, std::move(rings));
    } catch (const Error& error) {
      source.fail(basis, error.details().where + ": " + error.details().what, error.details().found,
                  error.details().allowed);
    }
  }
  return bases;
}

std::vector<double> readNumbers(const Source& source, const pugi::xml_node& data, std::size_t count, Counts& counts) {
  Scanner scanner(source, data, counts);
  std::vector<double> numbers;
  numbers.reserve(std::min(count, scanner.text().size() / 2 + 1));
  while (numbers.size() < count && scanner.peek() != '\0') numbers.push_back(scanner.number());
  std::size_t found = numbers.size();
  while (scanner.peek() != '\0') {
    scanner.number();
    ++found;
  }
  if (found != count)
    source.fail(data, "wrong number of values in ScatteringData", std::to_string(found), std::to_string(count));
  return numbers;
}

TensorTree readTree(const Source& source, const pugi::xml_node& data, int rank, Counts& counts) {
  Scanner scanner(source, data, counts);
  return TreeReader(scanner, rank).read();
}

// ----- text of a tree ----------------------------------------------------------------------------------------------

namespace {

class TreeWriter {
 public:
  TreeWriter(const TensorTree& tree, std::size_t channel, int digits)
      : tree_(tree), channel_(channel), digits_(digits) {}

  std::string text() {
    node(0);
    return std::move(text_);
  }

 private:
  std::string number(TensorTree::Node node) const { return number(tree_.cell(node)); }
  std::string number(std::size_t cell) const {
    const double value = tree_.values(cell)[channel_];
    return digits_ > 0 ? formatNumber(value, digits_) : formatNumber(value);
  }
  /// The one number of all cells below, or empty.
  std::string common(TensorTree::Node node) const {
    if (tree_.isCell(node)) return number(node);
    std::string first = common(tree_.child(node, 0));
    for (std::size_t c = 1; !first.empty() && c < tree_.children(); ++c)
      if (common(tree_.child(node, c)) != first) first.clear();
    return first;
  }

  void node(TensorTree::Node at) {
    text_ += '{';
    if (const std::string one = common(at); !one.empty()) {
      text_ += one;
    } else if (const int levels = tree_.uniformDepth(at); levels >= 0) {
      std::size_t column = 0;
      for (const std::size_t cell : tree_.gridCells(at, levels)) {
        if (column > 0) text_ += column % 8 == 0 ? '\n' : ' ';
        text_ += number(cell);
        ++column;
      }
    } else {
      text_ += '\n';
      for (std::size_t c = 0; c < tree_.children(); ++c) node(tree_.child(at, c));
    }
    text_ += "}\n";
  }

  const TensorTree& tree_;
  std::size_t channel_;
  int digits_;
  std::string text_;
};

}  // namespace

std::string treeText(const TensorTree& tree, std::size_t channel, int digits) {
  return TreeWriter(tree, channel, digits).text();
}

// ----- colour ------------------------------------------------------------------------------------------------------

namespace {

/// X, Y, Z of the white (1, 1, 1).
std::array<double, 3> white() {
  const Matrix3 toXyz = linearSrgbToXyz();
  return {toXyz[0][0] + toXyz[0][1] + toXyz[0][2], toXyz[1][0] + toXyz[1][1] + toXyz[1][2],
          toXyz[2][0] + toXyz[2][1] + toXyz[2][2]};
}

std::array<double, 3> product(const Matrix3& matrix, double a, double b, double c) {
  std::array<double, 3> result;
  for (std::size_t row = 0; row < 3; ++row) result[row] = matrix[row][0] * a + matrix[row][1] * b + matrix[row][2] * c;
  return result;
}

}  // namespace

std::array<double, 3> rgbFromTristimulus(double x, double y, double z) {
  static const Matrix3 matrix = xyzToLinearSrgb();
  static const std::array<double, 3> scale = white();
  return product(matrix, x * scale[0], y * scale[1], z * scale[2]);
}

std::array<double, 3> tristimulusFromRgb(double red, double green, double blue) {
  static const Matrix3 matrix = linearSrgbToXyz();
  static const std::array<double, 3> scale = white();
  const auto xyz = product(matrix, red, green, blue);
  return {xyz[0] / scale[0], xyz[1] / scale[1], xyz[2] / scale[2]};
}

}  // namespace brdf::radiance
