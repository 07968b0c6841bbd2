#ifndef vtkBRDFDrawing_h
#define vtkBRDFDrawing_h
// What the views draw with: text, lines and coloured rectangles in pixels of a renderer, colour maps, tick marks. All
// is drawn through vtkContext2D, so that a file of vectors (SVG, PDF) holds text and lines. For .cxx files only.

#include <array>
#include <string>
#include <vector>

class vtkContextScene;
class vtkImageData;
class vtkRenderer;

namespace vtkBRDFDrawing
{
using Color = std::array<double, 3>; ///< sRGB, 0 to 1
using Point = std::array<double, 2>; ///< pixels from the lower left corner

constexpr Color Ink = { 0.13, 0.13, 0.15 };
constexpr Color Faint = { 0.45, 0.45, 0.48 };
constexpr Color Hatch = { 0.7, 0.7, 0.72 };

enum class Align
{
  Low,
  Center,
  High
};

/** Pixels of a thin line beside text of this size. */
inline double LineWidth(int text)
{
  return text / 15.0;
}

/** The scene on top of the renderer's props that the functions below draw on, for charts and items of VTK's own. */
vtkContextScene* GetScene(vtkRenderer* renderer);

struct TextStyle
{
  int Size = 15; ///< pixels
  Align Horizontal = Align::Low;
  Align Vertical = Align::Low;
  Color Foreground = Ink;
  bool Bold = false;
  double Angle = 0; ///< degrees, counter-clockwise
};
void AddText(vtkRenderer* renderer, const std::string& text, Point at, const TextStyle& style);

/** A title with its top at `top`, pixels from below, and a note under it, in as many lines as it needs, parted at "; ".
 * Returns how far down they reach. */
double AddHeading(vtkRenderer* renderer, const std::string& title, const std::string& note, double top, int text);

struct Line
{
  Point From;
  Point To;
};
void AddLines(vtkRenderer* renderer, const std::vector<Line>& lines, const Color& color, double width = 1);

struct Rectangle
{
  Point Low;
  Point High;
  Color Fill;
};
void AddRectangles(vtkRenderer* renderer, const std::vector<Rectangle>& rectangles);

/** A picture (RGB, 8 bits) in a rectangle. */
void AddImage(vtkRenderer* renderer, vtkImageData* image, Point low, Point high);

/** Filled circles. */
void AddDots(vtkRenderer* renderer, const std::vector<Point>& centers, double radius, const Color& color);

/** Material number `index` of an overlay: seven colours that the colour-blind tell apart (Okabe and Ito 2008, "Color
 * Universal Design", without black), then grey, a dark violet and a dark brown, then again from the first. */
Color PaletteColor(std::size_t index);

/** Viridis (van der Walt and Smith, matplotlib 2015; CC0) at t in [0, 1]: lightness grows evenly. */
Color Sequential(double t);
/** Blue, white, red (Moreland 2009, "Diverging Color Maps for Scientific Visualization") at t in [0, 1], white at 0.5.
 */
Color Diverging(double t);

/** Round numbers (1, 2, 5 times a power of ten) in [low, high], about `count` of them. */
std::vector<double> LinearTicks(double low, double high, int count);
/** Powers of ten in [low, high]; with 2 and 5 times them where there would be fewer than three. */
std::vector<double> LogarithmicTicks(double low, double high);
/** A number for people: `digits` significant digits, no locale. */
std::string NumberText(double value, int digits = 3);
/** `text` with each of its numbers rounded to `digits` significant digits, for legends. */
std::string Rounded(const std::string& text, int digits = 4);
/** `text` cut to `length` characters, with "..." in its middle where something was left out. */
std::string Shortened(const std::string& text, std::size_t length);
}

#endif
