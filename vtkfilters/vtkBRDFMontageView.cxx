#include "vtkBRDFMontageView.h"

#include "vtkBRDFDrawing.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"

#include <brdf/base/Error.h>

#include <algorithm>
#include <cmath>

using namespace vtkBRDFDrawing;

vtkStandardNewMacro(vtkBRDFMontageView);
vtkBRDFMontageView::vtkBRDFMontageView() = default;
vtkBRDFMontageView::~vtkBRDFMontageView() = default;

void vtkBRDFMontageView::AddImage(vtkImageData* image, const std::string& caption)
{
  this->Items.push_back({ image, caption });
  this->Modified();
}

void vtkBRDFMontageView::RemoveAllImages()
{
  this->Items.clear();
  this->Modified();
}

void vtkBRDFMontageView::Build(int width, int height)
{
  if (this->Items.empty())
  {
    throw brdf::Error(brdf::Error::Kind::Value, { "nothing to draw", "montage", "", "at least one picture" });
  }
  const int text = SmallTextSize(width, height);
  const double top = height - 0.6 * text;
  AddHeading(this->GetRenderer(), this->GetTitle(), this->Note, top, text);
  const int columns = this->Columns;
  const int rows = (static_cast<int>(this->Items.size()) + columns - 1) / columns;
  const double cellWidth = (width - 1.0 * text) / columns;
  const double cellHeight = (top - 3.8 * text - 0.5 * text) / rows;
  for (std::size_t k = 0; k < this->Items.size(); ++k)
  {
    const Item& item = this->Items[k];
    const int* size = item.Image->GetDimensions();
    if (size[0] < 1 || size[1] < 1 || item.Image->GetScalarType() != VTK_UNSIGNED_CHAR)
    {
      throw brdf::Error(brdf::Error::Kind::Value, { "not a picture", "montage", item.Caption, "RGB with 8 bits" });
    }
    const double left = 0.5 * text + cellWidth * static_cast<double>(static_cast<int>(k) % columns);
    const double low = top - 3.8 * text - cellHeight * static_cast<double>(static_cast<int>(k) / columns + 1);
    const double scale = std::min((cellWidth - 0.5 * text) / size[0], (cellHeight - 1.9 * text) / size[1]);
    if (scale <= 0)
    {
      throw brdf::Error(brdf::Error::Kind::Value, { "no room for the pictures", "montage", "", "a larger size" });
    }
    const double shownWidth = std::round(scale * size[0]), shownHeight = std::round(scale * size[1]);
    const double x = std::round(left + (cellWidth - shownWidth) / 2), y = std::round(low + 1.7 * text);
    vtkBRDFDrawing::AddImage(this->GetRenderer(), item.Image, { x, y }, { x + shownWidth, y + shownHeight });
    const auto letters = static_cast<std::size_t>(cellWidth / (0.52 * text));
    AddText(this->GetRenderer(),
            Shortened(item.Caption, std::max<std::size_t>(letters, 8)),
            { left + cellWidth / 2, low + 1.4 * text },
            { .Size = text, .Horizontal = Align::Center, .Vertical = Align::High });
  }
}

void vtkBRDFMontageView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Images: " << this->Items.size() << "\n"
     << indent << "Columns: " << this->Columns << "\n"
     << indent << "Note: " << this->Note << "\n";
}
