#ifndef vtkBRDFLobePlan_h
#define vtkBRDFLobePlan_h
// What vtkBRDFLobeView knows while it builds a picture. For its .cxx files only.

#include "vtkBRDF.h"
#include "vtkBRDFColorScale.h"
#include "vtkBRDFDrawing.h"
#include "vtkBRDFLobe.h"
#include "vtkBRDFLobeSamples.h"
#include "vtkBRDFLobeView.h"

#include <brdf/geometry/Directions.h>

struct vtkBRDFLobeView::Input
{
  std::string Name;
  vtkSmartPointer<vtkBRDFLobe> Lobe;

  vtkBRDF* Data() const { return vtkBRDF::SafeDownCast(this->Lobe->GetInputDataObject(0, 0)); }
};

/** Where things stand in the picture: pixels from the lower left corner. */
struct vtkBRDFLobeView::Frame
{
  double Width, Height;
  int Text;
  std::size_t Columns = 1, Rows = 1; // of stages
  double Low, Top, Right;            // of the room for them, which begins at x = 0
  double NameHeight = 0;             // under each stage
  std::size_t LegendColumns = 1, LegendRows = 0;
  double PixelsPerRadius;
  brdf::Direction RightWard, UpWard; // of the camera, in the scene
  double Middle;                     // height over the disc's centre of the middle of a stage, along UpWard

  double StageWidth() const { return this->Right / this->Columns; }
  double StageHeight() const { return (this->Top - this->Low) / this->Rows; }
  vtkBRDFDrawing::Point Corner(std::size_t stage) const
  {
    return { (stage % this->Columns) * this->StageWidth(),
             this->Top - (stage / this->Columns + 1.0) * this->StageHeight() };
  }
  // The middle of a stage above its name.
  vtkBRDFDrawing::Point Center(std::size_t stage) const
  {
    const vtkBRDFDrawing::Point corner = this->Corner(stage);
    return { corner[0] + this->StageWidth() / 2,
             corner[1] + this->NameHeight + (this->StageHeight() - this->NameHeight) / 2 };
  }
  // The centre of a stage's disc; the first one is the origin of the scene.
  brdf::Direction Origin(std::size_t stage) const
  {
    const vtkBRDFDrawing::Point first = this->Center(0), at = this->Center(stage);
    const double x = (at[0] - first[0]) / this->PixelsPerRadius, y = (at[1] - first[1]) / this->PixelsPerRadius;
    brdf::Direction origin{};
    for (int k = 0; k < 3; ++k)
    {
      origin[k] = x * this->RightWard[k] + y * this->UpWard[k];
    }
    return origin;
  }
};

/** The samples that are shown. */
struct vtkBRDFLobeView::Points
{
  static constexpr std::size_t None = static_cast<std::size_t>(-1);
  std::size_t Measured = None, Model = None; // inputs
  vtkSmartPointer<vtkBRDFLobeSamples> Samples;

  bool HasResiduals() const { return this->Samples && this->Model != None && this->Samples->GetNumberFound() > 0; }
  // Whether points stand in place of this input's lobe.
  bool Replace(std::size_t input) const { return this->HasResiduals() && input == this->Measured; }
};

/** What the picture shows. */
struct vtkBRDFLobeView::Plan
{
  Frame Room;
  Points Shown;
  std::vector<std::size_t> Drawn; // inputs whose lobes are drawn
  double Length = 1;              // that the disc's rim stands for
  bool HasBar = false;
  vtkBRDFDrawing::ColorScale Scale;
  std::string BarTitle;

  bool IsSideBySide() const { return this->Room.Columns * this->Room.Rows > 1; }
};

#endif
