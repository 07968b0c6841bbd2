// Where things stand in a picture of vtkBRDFLobeView, and the camera.
#include "vtkBRDFDirectionWidget.h"
#include "vtkBRDFLobePlan.h"
#include "vtkBRDFLobeScene.h"
#include "vtkCamera.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

using namespace vtkBRDFDrawing;
using brdf::Direction;
using brdf::radians;
using vtkBRDFLobeScene::Stage;

namespace
{
// Room around a stage's centre, in radii of its disc: for the arrows' labels.
constexpr double HalfWidth = 1.55;
constexpr double HalfWidthWithoutNames = 1.2;
}

vtkBRDFLobeView::Frame vtkBRDFLobeView::MakeFrame(int width, int height, std::size_t stages, bool bar) const
{
  Frame frame{};
  frame.Width = width;
  frame.Height = height;
  frame.Text = TextSize(width, height);
  frame.Right = bar ? width - 8.0 * frame.Text : width;
  frame.Top = height - 4.6 * frame.Text;
  frame.Low = 0.6 * frame.Text;
  if (stages > 1)
  {
    frame.NameHeight = 3.2 * frame.Text;
  }
  else
  {
    frame.LegendColumns = this->Inputs->size() > 4 ? 2 : 1;
    frame.LegendRows = (this->Inputs->size() + frame.LegendColumns - 1) / frame.LegendColumns;
    frame.Low += 1.5 * frame.Text * static_cast<double>(frame.LegendRows);
  }
  const double elevation = radians(this->CameraElevation);
  const Direction from = brdf::fromSpherical(radians(90) - elevation, radians(this->PhiI + this->CameraAzimuth));
  const double bottom = -1.2 * std::abs(std::sin(elevation));
  const double top = std::max(1.45 * std::cos(elevation), -bottom);
  frame.Middle = (bottom + top) / 2;
  frame.RightWard = brdf::normalized({ -from[1], from[0], 0 });
  frame.UpWard = brdf::cross(from, frame.RightWard);
  // The numbers of columns that leaves the discs largest.
  for (std::size_t columns = 1; columns <= stages; ++columns)
  {
    Frame tried = frame;
    tried.Columns = columns;
    tried.Rows = (stages + columns - 1) / columns;
    const double high = (tried.StageHeight() - tried.NameHeight) / (top - bottom);
    const double named = std::min(tried.StageWidth() / (2 * HalfWidth), high);
    const double bare = std::min(tried.StageWidth() / (2 * HalfWidthWithoutNames), high);
    const Stage stage = { nullptr, {}, frame.Text, named };
    tried.PixelsPerRadius = std::max(1.0, stage.HasRoomForNames() ? named : std::min(bare, 4.0 * frame.Text));
    if (columns == 1 || tried.PixelsPerRadius > frame.PixelsPerRadius * 1.001)
    {
      frame = tried;
    }
  }
  return frame;
}

void vtkBRDFLobeView::PlaceCamera(const Frame& frame)
{
  if (this->Widget && this->CameraPlaced)
  {
    return; // the user looks from where he likes
  }
  this->CameraPlaced = true;
  const Point center = frame.Center(0);
  const double x = (frame.Width / 2 - center[0]) / frame.PixelsPerRadius;
  const double y = (frame.Height / 2 - center[1]) / frame.PixelsPerRadius + frame.Middle;
  const Direction from = brdf::cross(frame.RightWard, frame.UpWard);
  vtkCamera* camera = this->GetRenderer()->GetActiveCamera();
  Direction focus{}, position{};
  const double distance = 20;
  for (int k = 0; k < 3; ++k)
  {
    focus[k] = x * frame.RightWard[k] + y * frame.UpWard[k];
    position[k] = focus[k] + distance * from[k];
  }
  camera->SetParallelProjection(1);
  camera->SetParallelScale(frame.Height / 2 / frame.PixelsPerRadius);
  camera->SetFocalPoint(focus.data());
  camera->SetPosition(position.data());
  camera->SetViewUp(frame.UpWard.data());
  camera->SetClippingRange(0.1, 2 * distance);
}
