#include "vtkBRDFVectorDevice.h"

#include "vtkBrush.h"
#include "vtkContext2D.h"
#include "vtkContextDevice2D.h"
#include "vtkContextScene.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPNGWriter.h"
#include "vtkPen.h"
#include "vtkRect.h"
#include "vtkStdString.h"
#include "vtkTextProperty.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVersionMacros.h"

#include <brdf/geometry/Directions.h>

#include <algorithm>
#include <cmath>

namespace
{
using Picture = brdf::VectorPicture;

class Device : public vtkContextDevice2D
{
public:
  static Device* New();
  vtkTypeMacro(Device, vtkContextDevice2D);

  Picture Result;

  void SetSize(int width, int height)
  {
    this->Geometry[0] = width;
    this->Geometry[1] = height;
    this->Result.width = width;
    this->Result.height = height;
  }

  void DrawPoly(float* points, int n, unsigned char*, int) override
  {
    if (this->Pen->GetLineType() == vtkPen::NO_PEN)
    {
      return;
    }
    // A number that is none ends a line, and the next one starts anew.
    std::vector<Picture::Point> line;
    for (int i = 0; i <= n; ++i)
    {
      if (i < n && std::isfinite(points[2 * i]) && std::isfinite(points[2 * i + 1]))
      {
        line.push_back(this->Transformed(points[2 * i], points[2 * i + 1]));
        continue;
      }
      if (line.size() > 1)
      {
        this->Add(Picture::Line{ line, this->PenColor(), this->Pen->GetWidth(), this->Dashes() });
      }
      line.clear();
    }
  }
  void DrawLines(float* points, int n, unsigned char* colors, int components) override
  {
    for (int i = 0; i + 1 < n; i += 2)
    {
      this->DrawPoly(points + 2 * i, 2, colors, components);
    }
  }
  void DrawPoints(float* points, int n, unsigned char*, int) override
  {
    this->DrawMarkers(0, false, points, n, nullptr, 0);
  }
  void DrawPointSprites(vtkImageData*, float* points, int n, unsigned char*, int) override
  {
    this->DrawPoints(points, n, nullptr, 0);
  }
  /** Every shape is a disk: the views of this library mark with nothing else. */
  void DrawMarkers(int, bool, float* points, int n, unsigned char*, int) override
  {
    for (int i = 0; i < n; ++i)
    {
      const Picture::Point center = this->Transformed(points[2 * i], points[2 * i + 1]);
      this->Add(Picture::Area{ Round(center, this->Pen->GetWidth() / 2, 0, 360), this->PenColor() });
    }
  }
  void DrawQuad(float* points, int n) override { this->DrawPolygon(points, n); }
  void DrawQuadStrip(float* points, int n) override
  {
    for (int i = 0; i + 3 < n; i += 2)
    {
      const float* p = points + 2 * i;
      float quad[8] = { p[0], p[1], p[2], p[3], p[6], p[7], p[4], p[5] };
      this->DrawPolygon(quad, 4);
    }
  }
  void DrawColoredPolygon(float* points, int n, unsigned char* colors, int components) override
  {
    std::vector<Picture::Point> corners;
    for (int i = 0; i < n; ++i)
    {
      corners.push_back(this->Transformed(points[2 * i], points[2 * i + 1]));
    }
    Picture::Color color = this->BrushColor();
    if (colors && components >= 3)
    {
      color = { colors[0] / 255.0, colors[1] / 255.0, colors[2] / 255.0, components > 3 ? colors[3] / 255.0 : 1 };
    }
    if (color.alpha > 0 && corners.size() > 2)
    {
      this->Add(Picture::Area{ corners, color });
    }
  }
  void DrawEllipseWedge(float x, float y, float outer, float, float inner, float, float start, float stop) override
  {
    std::vector<Picture::Point> corners = Round({ x, y }, outer, start, stop);
    std::vector<Picture::Point> back = inner > 0 ? Round({ x, y }, inner, start, stop) : corners;
    if (inner > 0)
    {
      corners.insert(corners.end(), back.rbegin(), back.rend());
    }
    for (Picture::Point& corner : corners)
    {
      corner = this->Transformed(corner[0], corner[1]);
    }
    this->Add(Picture::Area{ corners, this->BrushColor() });
  }
  void DrawEllipticArc(float x, float y, float radius, float, float start, float stop) override
  {
    std::vector<Picture::Point> points = Round({ x, y }, radius, start, stop);
    for (Picture::Point& point : points)
    {
      point = this->Transformed(point[0], point[1]);
    }
    this->Add(Picture::Line{ points, this->PenColor(), this->Pen->GetWidth(), this->Dashes() });
  }
  void DrawString(float* point, const vtkStdString& string) override
  {
    vtkTextProperty* property = this->TextProp;
    Picture::Text text;
    text.text = string;
    text.at = this->Transformed(point[0], point[1]);
    text.size = property->GetFontSize();
    text.horizontal = static_cast<Picture::Align>(property->GetJustification());
    text.vertical = static_cast<Picture::Align>(property->GetVerticalJustification());
    text.angle = property->GetOrientation();
    text.bold = property->GetBold() != 0;
    const double* color = property->GetColor();
    text.color = { color[0], color[1], color[2], property->GetOpacity() };
    this->Add(text);
  }
  void ComputeStringBounds(const vtkStdString& string, float bounds[4]) override
  {
    const double size = this->TextProp->GetFontSize();
    const double width = brdf::helveticaWidth(string, this->TextProp->GetBold() != 0) * size;
    const double turn = brdf::radians(this->TextProp->GetOrientation());
    const double c = std::abs(std::cos(turn)), s = std::abs(std::sin(turn));
    bounds[0] = bounds[1] = 0;
    bounds[2] = static_cast<float>(c * width + s * size);
    bounds[3] = static_cast<float>(s * width + c * size);
  }
  void ComputeJustifiedStringBounds(const char* string, float bounds[4]) override
  {
    this->ComputeStringBounds(vtkStdString(string), bounds);
  }
  void DrawMathTextString(float* point, const vtkStdString& string) override { this->DrawString(point, string); }
#if VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION < 2
  // Deprecated, yet pure.
  void DrawString(float*, const vtkUnicodeString&) override {}
  void ComputeStringBounds(const vtkUnicodeString&, float bounds[4]) override
  {
    std::fill_n(bounds, 4, 0.0F);
  }
#endif
  void DrawImage(float at[2], float scale, vtkImageData* image) override
  {
    const int* size = image->GetDimensions();
    const auto extent = [scale](int pixels) { return scale * static_cast<float>(pixels); };
    this->DrawImage(vtkRectf(at[0], at[1], extent(size[0]), extent(size[1])), image);
  }
  void DrawImage(const vtkRectf& place, vtkImageData* image) override
  {
    const int* size = image->GetDimensions();
    const Picture::Point low = this->Transformed(place.GetX(), place.GetY());
    Picture::Image result;
    result.width = static_cast<std::size_t>(size[0]);
    result.height = static_cast<std::size_t>(size[1]);
    result.place = { low[0], low[1], place.GetWidth(), place.GetHeight() };
    for (int y = size[1] - 1; y >= 0; --y)
    {
      const auto* row = static_cast<const unsigned char*>(image->GetScalarPointer(0, y, 0));
      result.rgb.insert(result.rgb.end(), row, row + 3 * result.width);
    }
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(image);
    writer->WriteToMemoryOn();
    writer->Write();
    const vtkUnsignedCharArray* bytes = writer->GetResult();
    result.png.assign(const_cast<vtkUnsignedCharArray*>(bytes)->GetPointer(0),
                      const_cast<vtkUnsignedCharArray*>(bytes)->GetPointer(0) + bytes->GetNumberOfValues());
    this->Add(result);
  }

  void SetColor4(unsigned char*) override {}
  void SetTexture(vtkImageData*, int) override {}
  void SetPointSize(float size) override
  {
    this->Pen->SetWidth(size);
  }
  void SetLineWidth(float width) override
  {
    this->Pen->SetWidth(width);
  }
  void SetLineType(int type) override
  {
    this->Pen->SetLineType(type);
  }
  void SetMatrix(vtkMatrix3x3* matrix) override
  {
    this->Matrix->DeepCopy(matrix);
  }
  void GetMatrix(vtkMatrix3x3* matrix) override
  {
    matrix->DeepCopy(this->Matrix);
  }
  void MultiplyMatrix(vtkMatrix3x3* matrix) override
  {
    vtkMatrix3x3::Multiply3x3(this->Matrix, matrix, this->Matrix);
  }
  void PushMatrix() override
  {
    vtkNew<vtkMatrix3x3> copy;
    copy->DeepCopy(this->Matrix);
    this->Stack.emplace_back(copy);
  }
  void PopMatrix() override
  {
    this->Matrix->DeepCopy(this->Stack.back());
    this->Stack.pop_back();
  }
  void SetClipping(int* box) override
  {
    this->Clip = { 1.0 * box[0], 1.0 * box[1], 1.0 * box[2], 1.0 * box[3] };
  }
  void EnableClipping(bool enable) override
  {
    this->Clipping = enable;
  }

protected:
  Device()
  {
    this->Geometry[0] = this->Geometry[1] = 0;
  }
  ~Device() override = default;

private:
  static std::vector<Picture::Point> Round(Picture::Point center, double radius, double start, double stop)
  {
    const int steps = std::max(2, static_cast<int>(std::ceil(std::abs(stop - start) / 6)));
    std::vector<Picture::Point> points;
    for (int k = 0; k <= steps; ++k)
    {
      const double angle = brdf::radians(start + (stop - start) * k / steps);
      points.push_back({ center[0] + radius * std::cos(angle), center[1] + radius * std::sin(angle) });
    }
    return points;
  }
  Picture::Point Transformed(double x, double y)
  {
    const double in[3] = { x, y, 1 };
    double out[3];
    this->Matrix->MultiplyPoint(in, out);
    return { out[0] / out[2], out[1] / out[2] };
  }
  static Picture::Color Color(const unsigned char* color, int alpha)
  {
    return { color[0] / 255.0, color[1] / 255.0, color[2] / 255.0, alpha / 255.0 };
  }
  Picture::Color PenColor()
  {
    return Color(this->Pen->GetColor(), this->Pen->GetOpacity());
  }
  Picture::Color BrushColor()
  {
    return Color(this->Brush->GetColor(), this->Brush->GetOpacity());
  }
  std::vector<double> Dashes()
  {
    const double w = std::max(this->Pen->GetWidth(), 1.0F);
    switch (this->Pen->GetLineType())
    {
      case vtkPen::DASH_LINE:
        return { 6 * w, 3 * w };
      case vtkPen::DOT_LINE:
        return { w, 3 * w };
      case vtkPen::DASH_DOT_LINE:
        return { 6 * w, 3 * w, w, 3 * w };
      case vtkPen::DASH_DOT_DOT_LINE:
        return { 6 * w, 3 * w, w, 3 * w, w, 3 * w };
      default:
        return {};
    }
  }
  template<class Shape>
  void Add(Shape shape)
  {
    this->Result.elements.emplace_back(std::move(shape),
                                       this->Clipping ? std::optional<Picture::Rectangle>(this->Clip) : std::nullopt);
  }

  vtkNew<vtkMatrix3x3> Matrix;
  std::vector<vtkSmartPointer<vtkMatrix3x3>> Stack;
  Picture::Rectangle Clip;
  bool Clipping = false;
};
vtkStandardNewMacro(Device);
}

brdf::VectorPicture vtkBRDFDrawing::PaintedVectors(vtkContextScene* scene, int width, int height)
{
  vtkNew<Device> device;
  device->SetSize(width, height);
  vtkNew<vtkContext2D> painter;
  painter->Begin(device);
  scene->SetGeometry(width, height);
  scene->Paint(painter);
  painter->End();
  return std::move(device->Result);
}
