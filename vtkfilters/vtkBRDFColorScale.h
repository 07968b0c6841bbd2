#ifndef vtkBRDFColorScale_h
#define vtkBRDFColorScale_h
// Numbers as colours, and the bar that says which. For .cxx files only.

#include "vtkBRDFDrawing.h"

#include <functional>
#include <string>

namespace vtkBRDFDrawing
{
struct ColorScale
{
  double Low = 0;
  double High = 1;
  bool Signed = false;                     ///< blue, white, red about 0, Low being -High; else viridis
  std::function<double(double)> Transform; ///< rising; equal steps of it are equal steps of colour. None: the numbers

  double Transformed(double value) const { return this->Transform ? this->Transform(value) : value; }
  /** 0 at Low, 1 at High. */
  double Position(double value) const;
  Color At(double position) const { return this->Signed ? Diverging(position) : Sequential(position); }
  Color Of(double value) const { return this->At(this->Position(value)); }
};

/** From -high to high. */
ColorScale SignedScale(double high);
/** From low to high by powers of ten, both above 0. */
ColorScale LogarithmicScale(double low, double high);

/** A standing bar between two corners with ticks at round numbers on its right, as many as fit, and the title above,
 * or along it where it is long. */
void AddColorBar(vtkRenderer* renderer,
                 const ColorScale& scale,
                 Point low,
                 Point high,
                 int text,
                 const std::string& title = std::string());
}

#endif
