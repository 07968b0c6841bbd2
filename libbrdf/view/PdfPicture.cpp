#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/view/VectorPicture.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace brdf {
namespace {

using Picture = VectorPicture;

// Advance widths of the characters from ' ' to '~', thousandths of the size: Adobe Core 14 font metrics.
constexpr std::array<int, 95> kHelvetica{
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333,  278, 278, 556, 556, 556,
    556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667,
    611, 778, 722, 278, 500, 667, 556, 833, 722, 778, 667, 778, 722, 667,  611, 722, 667, 944, 667,
    667, 611, 278, 278, 278, 469, 556, 333, 556, 556, 500, 556, 556, 278,  556, 556, 222, 222, 500,
    222, 833, 556, 556, 556, 556, 333, 500, 278, 556, 500, 722, 500, 500,  500, 334, 260, 334, 584};
constexpr std::array<int, 95> kHelveticaBold{
    278, 333, 474, 556, 556, 889, 722, 238, 333, 333, 389, 584, 278, 333, 278, 278, 556, 556, 556,
    556, 556, 556, 556, 556, 556, 556, 333, 333, 584, 584, 584, 611, 975, 722, 722, 722, 722, 667,
    611, 778, 722, 278, 556, 722, 611, 833, 722, 778, 667, 778, 722, 667, 611, 722, 667, 944, 667,
    667, 611, 333, 278, 333, 584, 556, 333, 556, 611, 556, 611, 556, 333, 611, 611, 278, 278, 556,
    278, 889, 611, 611, 611, 611, 389, 556, 333, 611, 556, 778, 556, 556, 500, 389, 280, 389, 584};
constexpr unsigned char kDegree = 0xB0;

/// UTF-8 as Latin-1, '?' for what that lacks; an en dash as a hyphen.
std::string latin(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const auto first = static_cast<unsigned char>(text[i]);
    const std::size_t length = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    const std::string character = text.substr(i, length);
    if (length == 1)
      result += first >= 0x20 ? text[i] : ' ';
    else if (length == 2 && character.size() == 2 && first <= 0xC3)
      result += static_cast<char>(((first & 3) << 6) | (static_cast<unsigned char>(character[1]) & 0x3F));
    else
      result += character == "\u2013" ? '-' : '?';
    i += length;
  }
  return result;
}

double widthOfLatin(const std::string& text, bool bold) {
  int width = 0;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    width += code >= 0x20 && code < 0x7F ? (bold ? kHelveticaBold : kHelvetica)[code - 0x20]
             : code == kDegree           ? 400
                                         : 556;
  }
  return width / 1000.0;
}

std::string number(double value) {
  // PDF knows no exponents.
  const double rounded = std::round(value * 1000) / 1000;
  if (!(std::abs(rounded) < 1e9)) return "0";
  const auto thousandths = static_cast<long long>(std::llround(std::abs(rounded) * 1000));
  std::string text = (rounded < 0 && thousandths > 0 ? "-" : "") + std::to_string(thousandths / 1000);
  if (const long long rest = thousandths % 1000; rest != 0) text += "." + std::to_string(1000 + rest).substr(1);
  return text;
}

std::string numbers(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) text += number(value) + " ";
  return text;
}

class Writer {
 public:
  explicit Writer(const Picture& picture) : picture_(picture) {}

  std::string write() {
    for (const Picture::Element& element : picture_.elements) {
      if (element.clip) {
        const Picture::Rectangle& r = *element.clip;
        content_ += "q " + numbers({r.x, r.y, r.width, r.height}) + "re W n\n";
      }
      std::visit([this](const auto& shape) { add(shape); }, element.shape);
      if (element.clip) content_ += "Q\n";
    }
    std::string states, images;
    for (const auto& [alpha, name] : states_)
      states += "/" + name + " << /CA " + number(alpha / 1000.0) + " /ca " + number(alpha / 1000.0) + " >> ";
    for (std::size_t k = 0; k < images_.size(); ++k)
      images += "/I" + std::to_string(k) + " " + std::to_string(kFirstImage + k) + " 0 R ";
    const auto font = [](const char* name) {
      return std::string("<< /Type /Font /Subtype /Type1 /BaseFont /") + name + " /Encoding /WinAnsiEncoding >>";
    };
    object("<< /Type /Catalog /Pages 2 0 R >>");
    object("<< /Type /Pages /Kids [3 0 R] /Count 1 >>");
    object("<< /Type /Page /Parent 2 0 R /MediaBox [0 0 " + numbers({picture_.width, picture_.height}) +
           "] /Contents 4 0 R /Resources << /Font << /F0 5 0 R /F1 6 0 R >> /ExtGState << " + states +
           ">> /XObject << " + images + ">> >> >>");
    stream("", content_);
    object(font("Helvetica"));
    object(font("Helvetica-Bold"));
    object("<< /Title " + literal(latin(picture_.title)) + " /Producer (BRDFLab) >>");
    for (const Picture::Image* image : images_)
      stream("/Type /XObject /Subtype /Image /ColorSpace /DeviceRGB /BitsPerComponent 8 /Width " +
                 std::to_string(image->width) + " /Height " + std::to_string(image->height),
             std::string(image->rgb.begin(), image->rgb.end()));
    const std::size_t table = file_.size(), count = offsets_.size() + 1;
    file_ += "xref\n0 " + std::to_string(count) + "\n0000000000 65535 f \n";
    for (const std::size_t offset : offsets_) {
      const std::string digits = std::to_string(offset);
      file_ += std::string(10 - digits.size(), '0') + digits + " 00000 n \n";
    }
    file_ += "trailer\n<< /Size " + std::to_string(count) + " /Root 1 0 R /Info 7 0 R >>\nstartxref\n" +
             std::to_string(table) + "\n%%EOF\n";
    return std::move(file_);
  }

 private:
  static constexpr std::size_t kFirstImage = 8;

  void object(const std::string& body) {
    offsets_.push_back(file_.size());
    file_ += std::to_string(offsets_.size()) + " 0 obj\n" + body + "\nendobj\n";
  }
  void stream(const std::string& entries, const std::string& data) {
    object("<< " + entries + " /Length " + std::to_string(data.size()) + " >>\nstream\n" + data + "\nendstream");
  }
  static std::string literal(const std::string& text) {
    std::string result = "(";
    for (const char c : text) {
      if (c == '(' || c == ')' || c == '\\') result += '\\';
      result += c;
    }
    return result + ")";
  }
  static std::string color(const Picture::Color& c) { return numbers({c.red, c.green, c.blue}); }
  void path(const std::vector<Picture::Point>& points) {
    for (std::size_t k = 0; k < points.size(); ++k)
      content_ += numbers({points[k][0], points[k][1]}) + (k == 0 ? "m " : "l ");
  }
  void opacity(double alpha) {
    const int thousandths = static_cast<int>(std::lround(1000 * std::clamp(alpha, 0.0, 1.0)));
    const auto [found, isNew] = states_.try_emplace(thousandths, "S" + std::to_string(thousandths));
    content_ += "/" + found->second + " gs ";
  }

  void add(const Picture::Line& line) {
    content_ += "q ";
    opacity(line.color.alpha);
    content_ +=
        color(line.color) + "RG " + number(line.width) + " w " + (line.dashes.empty() ? "1 J 1 j " : "0 J 1 j ") + "[";
    for (const double dash : line.dashes) content_ += number(dash) + " ";
    content_ += "] 0 d ";
    path(line.points);
    content_ += "S Q\n";
  }
  void add(const Picture::Area& area) {
    content_ += "q ";
    opacity(area.color.alpha);
    content_ += color(area.color) + "rg ";
    path(area.points);
    content_ += "f Q\n";
  }
  void add(const Picture::Text& text) {
    const std::string letters = latin(text.text);
    const double width = widthOfLatin(letters, text.bold) * text.size;
    const double left = text.horizontal == Picture::Align::High     ? -width
                        : text.horizontal == Picture::Align::Middle ? -width / 2
                                                                    : 0;
    const double low = text.size * (text.vertical == Picture::Align::High     ? -0.72
                                    : text.vertical == Picture::Align::Middle ? -0.36
                                                                              : 0.21);
    const double c = std::cos(radians(text.angle)), s = std::sin(radians(text.angle));
    content_ += "q ";
    opacity(text.color.alpha);
    content_ += color(text.color) + "rg BT /F" + (text.bold ? "1 " : "0 ") + number(text.size) + " Tf " +
                numbers({c, s, -s, c, text.at[0] + c * left - s * low, text.at[1] + s * left + c * low}) + "Tm " +
                literal(letters) + " Tj ET Q\n";
  }
  void add(const Picture::Image& image) {
    const Picture::Rectangle& r = image.place;
    content_ +=
        "q " + numbers({r.width, 0, 0, r.height, r.x, r.y}) + "cm /I" + std::to_string(images_.size()) + " Do Q\n";
    images_.push_back(&image);
  }

  const Picture& picture_;
  std::string file_ = "%PDF-1.4\n%\xE2\xE3\xCF\xD3\n", content_;
  std::vector<std::size_t> offsets_;
  std::map<int, std::string> states_;  ///< by the opacity in thousandths
  std::vector<const Picture::Image*> images_;
};

}  // namespace

double helveticaWidth(const std::string& text, bool bold) { return widthOfLatin(latin(text), bold); }

std::string pdfText(const VectorPicture& picture) { return Writer(picture).write(); }

}  // namespace brdf
