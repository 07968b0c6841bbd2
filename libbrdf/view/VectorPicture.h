#pragma once
#include <brdf/brdf_export.h>

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace brdf {

/// A picture of lines, areas and text in drawing order, to be written as SVG or PDF: what stays sharp at any size and
/// whose text can be searched and edited. Lengths in points (1/72 inch; SVG: user units), from the lower left corner.
struct VectorPicture {
  using Point = std::array<double, 2>;
  /// sRGB, and opacity, 0 to 1.
  struct Color {
    double red = 0, green = 0, blue = 0, alpha = 1;
  };
  struct Rectangle {
    double x = 0, y = 0, width = 0, height = 0;
  };

  struct Line {
    std::vector<Point> points;  ///< one line through all of them
    Color color{};
    double width = 1;
    std::vector<double> dashes{};  ///< drawn and empty lengths by turns; none: drawn through
  };
  struct Area {
    std::vector<Point> points;  ///< corners of a polygon
    Color color{};
  };
  enum class Align { Low, Middle, High };
  struct Text {
    std::string text;  ///< UTF-8; PDF has the characters of Latin-1, and '?' for others
    Point at{};
    double size = 12;
    Align horizontal = Align::Low, vertical = Align::Low;
    double angle = 0;  ///< degrees, counter-clockwise
    bool bold = false;
    Color color{};
  };
  struct Image {
    std::size_t width = 0, height = 0;  ///< pixels
    std::vector<std::uint8_t> rgb;      ///< sRGB, first row at the top
    std::string png;                    ///< the same as a PNG file, for SVG
    Rectangle place;
  };
  struct Element {
    template <class Shape>
    explicit Element(Shape drawn, std::optional<Rectangle> inside = {})
        : shape(std::in_place_type<Shape>, std::move(drawn)), clip(inside) {}

    std::variant<Line, Area, Text, Image> shape;
    std::optional<Rectangle> clip;  ///< nothing is drawn outside
  };

  double width = 0, height = 0;
  std::string title;
  std::deque<Element> elements;
};

/// The picture as a file of SVG 1.1: text as <text> in Helvetica, Arial or the viewer's sans-serif.
BRDF_EXPORT std::string svgText(const VectorPicture& picture);

/// The picture as a file of PDF 1.4 (ISO 32000-1) of one page: text in the standard font Helvetica.
BRDF_EXPORT std::string pdfText(const VectorPicture& picture);

/// Width of `text` in Helvetica of size 1: the advance widths of Adobe's metrics for ASCII and the degree sign; other
/// characters count as a digit.
BRDF_EXPORT double helveticaWidth(const std::string& text, bool bold);

}  // namespace brdf
