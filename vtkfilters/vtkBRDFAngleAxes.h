#ifndef vtkBRDFAngleAxes_h
#define vtkBRDFAngleAxes_h
// Square maps over two axes, beside each other: their places, axes, hatches and colour bar. For .cxx files only.

#include "vtkBRDFDrawing.h"

#include <functional>
#include <string>
#include <vector>

namespace vtkBRDFDrawing
{
class PlotScale;

/** An axis of a map. */
struct AngleAxis
{
  std::string Title;                      ///< quantity and unit
  std::vector<double> Ticks;              ///< what they say
  std::string Unit;                       ///< behind a tick's number
  std::function<double(double)> Position; ///< of a value: 0 to 1

  /** An angle from 0 to 90 degrees in equal steps of (angle / 90)^(1 / warp). */
  static AngleAxis OfSlice(const std::string& angle, double warp);
  /** An angle of vtkBRDFCurve, which for theta_o starts at -90 degrees and for azimuths spans a turn. */
  static AngleAxis OfCurve(const std::string& angle);
  static AngleAxis Plain(const std::string& title, double low, double high);
  /** "theta_h and theta_d". */
  static std::string NameOf(const AngleAxis& x, const AngleAxis& y);
};

struct PanelPlace
{
  Point Low;
  double Side;
};

/** Squares in rows that fill an area; each has room for its axes at the left and below, and its name above, for text of
 * a size. */
class PanelGrid
{
public:
  PanelGrid(std::size_t count, double width, double height, int text);
  PanelPlace Place(std::size_t index, double left, double low) const;
  double GetSide() const { return this->Side; }

private:
  std::size_t Count, Columns = 1;
  double Width, Height, RoomLeft, RoomBelow, RoomAbove, Side = 0;
};

/** Frame, ticks and titles. Fewer ticks where the square is small. */
void AddAngleAxes(vtkRenderer* renderer, const AngleAxis& x, const AngleAxis& y, const PanelPlace& place, int text);

/** Diagonals over pixels of state 3 (below the horizon), and both ways over those of state 0 (no value). */
void AddHatches(vtkRenderer* renderer,
                const int size[2],
                const std::vector<unsigned char>& states,
                const PanelPlace& place,
                int text);

/** White lines between pixels of state 2 (filled or extrapolated) and of state 1. */
void AddDataEdges(vtkRenderer* renderer,
                  const int size[2],
                  const std::vector<unsigned char>& states,
                  const PanelPlace& place,
                  int text);

/** A bar of viridis between two corners, with the scale's ticks to its right and a title above. */
void AddValueBar(vtkRenderer* renderer,
                 const PlotScale& scale,
                 const std::string& title,
                 Point low,
                 Point high,
                 int text);
}

#endif
