#include <brdf/base/Base64.h>
#include <brdf/base/Text.h>
#include <brdf/view/VectorPicture.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

using Picture = VectorPicture;

std::string number(double value) {
  std::string text = formatNumber(std::round(value * 1000) / 1000);
  return text == "-0" ? "0" : text;
}

std::string hex(const Picture::Color& color) {
  std::string text = "#";
  for (const double component : {color.red, color.green, color.blue}) {
    const auto byte = static_cast<unsigned>(std::lround(255 * std::clamp(component, 0.0, 1.0)));
    for (const unsigned digit : {byte / 16, byte % 16}) text += "0123456789abcdef"[digit];
  }
  return text;
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else if (c == '"') {
      result += "&quot;";
    } else if (static_cast<unsigned char>(c) >= 0x20 || c == '\t') {
      result += c;
    }
  }
  return result;
}

class Writer {
 public:
  explicit Writer(const Picture& picture) : picture_(picture) {}

  std::string write() {
    const std::string size = number(picture_.width) + "\" height=\"" + number(picture_.height);
    text_ =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
        "xmlns:xlink=\"http://www.w3.org/1999/xlink\" version=\"1.1\" width=\"" +
        size + "\" viewBox=\"0 0 " + number(picture_.width) + " " + number(picture_.height) + "\">\n<title>" +
        escaped(picture_.title) + "</title>\n<rect width=\"" + size + "\" fill=\"#ffffff\"/>\n" +
        "<g font-family=\"Helvetica, Arial, sans-serif\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
    for (const Picture::Element& element : picture_.elements) {
      if (element.clip) {
        const std::string id = "clip" + std::to_string(++clips_);
        text_ += "<clipPath id=\"" + id + "\">" + rectangle(*element.clip) + "/></clipPath><g clip-path=\"url(#" + id +
                 ")\">";
      }
      std::visit([this](const auto& shape) { add(shape); }, element.shape);
      text_ += element.clip ? "</g>\n" : "\n";
    }
    return std::move(text_) + "</g>\n</svg>\n";
  }

 private:
  double up(double y) const { return picture_.height - y; }
  std::string rectangle(const Picture::Rectangle& r) const {
    return "<rect x=\"" + number(r.x) + "\" y=\"" + number(up(r.y + r.height)) + "\" width=\"" + number(r.width) +
           "\" height=\"" + number(r.height) + "\"";
  }
  void path(const std::vector<Picture::Point>& points) {
    text_ += "<path d=\"M";
    for (const auto& [x, y] : points) text_ += number(x) + " " + number(up(y)) + " ";
    text_.back() = '"';
  }
  void opacity(const char* name, double alpha) {
    if (alpha < 1) text_ += std::string(" ") + name + "=\"" + number(alpha) + "\"";
  }

  void add(const Picture::Line& line) {
    path(line.points);
    text_ += " fill=\"none\" stroke=\"" + hex(line.color) + "\" stroke-width=\"" + number(line.width) + "\"";
    opacity("stroke-opacity", line.color.alpha);
    if (!line.dashes.empty()) {
      text_ += " stroke-linecap=\"butt\" stroke-dasharray=\"";
      for (const double dash : line.dashes) text_ += number(dash) + " ";
      text_.back() = '"';
    }
    text_ += "/>";
  }
  void add(const Picture::Area& area) {
    path(area.points);
    // Neighbouring areas of one opacity would show their seams where edges are smoothed.
    text_.insert(text_.size() - 1, "Z");
    text_ += " fill=\"" + hex(area.color) + "\"";
    if (area.color.alpha == 1) text_ += " shape-rendering=\"crispEdges\"";
    opacity("fill-opacity", area.color.alpha);
    text_ += "/>";
  }
  void add(const Picture::Text& text) {
    // Offsets of the baseline in sizes of the font: capitals are 0.72 high, descenders 0.21 deep. Viewers disagree on
    // SVG's own words for that.
    const double down = text.vertical == Picture::Align::High     ? 0.72
                        : text.vertical == Picture::Align::Middle ? 0.36
                                                                  : -0.21;
    const char* anchor = text.horizontal == Picture::Align::High     ? "end"
                         : text.horizontal == Picture::Align::Middle ? "middle"
                                                                     : "start";
    text_ += "<text transform=\"translate(" + number(text.at[0]) + " " + number(up(text.at[1])) + ")";
    if (text.angle != 0) text_ += " rotate(" + number(-text.angle) + ")";
    text_ += "\" y=\"" + number(down * text.size) + "\" font-size=\"" + number(text.size) + "\" text-anchor=\"" +
             anchor + "\" fill=\"" + hex(text.color) + "\"";
    if (text.bold) text_ += " font-weight=\"bold\"";
    opacity("fill-opacity", text.color.alpha);
    text_ += ">" + escaped(text.text) + "</text>";
  }
  void add(const Picture::Image& image) {
    std::string place = rectangle(image.place);
    place.replace(1, 4, "image");
    text_ += place + " preserveAspectRatio=\"none\" image-rendering=\"pixelated\" xlink:href=\"data:image/png;base64," +
             toBase64(image.png) + "\"/>";
  }

  const Picture& picture_;
  std::string text_;
  std::size_t clips_ = 0;
};

}  // namespace

std::string svgText(const VectorPicture& picture) { return Writer(picture).write(); }

}  // namespace brdf
