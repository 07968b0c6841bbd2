#ifndef vtkBRDFTableImage_h
#define vtkBRDFTableImage_h
// The image that a half/difference table is: shared by the filters to and from it. For .cxx files only.

#include <brdf/base/Error.h>
#include <brdf/material/TableLayout.h>

#include <algorithm>
#include <string>

namespace vtkBRDFTableImage
{
/** Extent, spacing and origin of a table's cell centres. */
struct Grid
{
  explicit Grid(const brdf::TableLayout& layout)
    : Extent{ 0, static_cast<int>(layout.phiD) - 1,  0, static_cast<int>(layout.thetaD) - 1,
              0, static_cast<int>(layout.thetaH) - 1 }
    , Spacing{ (layout.reciprocal ? 180.0 : 360.0) / layout.phiD, 90.0 / layout.thetaD, 1.0 / layout.thetaH }
    , Origin{ this->Spacing[0] / 2, this->Spacing[1] / 2, this->Spacing[2] / 2 }
  {
  }
  int Extent[6]; // vtkImageData::SetExtent wants it writable
  double Spacing[3];
  double Origin[3];
};

/** Throws brdf::Error for numbers of cells out of 2 to 1024. */
inline brdf::TableLayout LayoutFor(const int cells[3], bool reciprocal)
{
  if (std::min({ cells[0], cells[1], cells[2] }) < 2 || std::max({ cells[0], cells[1], cells[2] }) > 1024)
  {
    throw brdf::Error(brdf::Error::Kind::Value,
                      { "out of range",
                        "table cells",
                        std::to_string(cells[0]) + " x " + std::to_string(cells[1]) + " x " + std::to_string(cells[2]),
                        "2 to 1024 each" });
  }
  brdf::TableLayout layout;
  layout.phiD = static_cast<std::size_t>(cells[0]);
  layout.thetaD = static_cast<std::size_t>(cells[1]);
  layout.thetaH = static_cast<std::size_t>(cells[2]);
  layout.reciprocal = reciprocal;
  return layout;
}
}
#endif
