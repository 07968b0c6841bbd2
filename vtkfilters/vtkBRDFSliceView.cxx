#include "vtkBRDFSliceView.h"

#include "vtkAlgorithmOutput.h"
#include "vtkBRDF.h"
#include "vtkBRDFAngleAxes.h"
#include "vtkBRDFArrays.h"
#include "vtkBRDFPlotData.h"
#include "vtkBRDFSlice.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"

#include <brdf/base/Error.h>
#include <brdf/color/Colorimetry.h>
#include <brdf/geometry/Directions.h>

#include <algorithm>
#include <cmath>

using namespace vtkBRDFDrawing;

vtkStandardNewMacro(vtkBRDFSliceView);
vtkBRDFSliceView::vtkBRDFSliceView() = default;
vtkBRDFSliceView::~vtkBRDFSliceView() = default;

namespace
{
/** A slice, ready to be drawn: a pixel a cell, or 512 rows where rows are wavelengths. */
struct Panel
{
  vtkSmartPointer<vtkImageData> Picture; // RGB, 8 bits
  std::vector<unsigned char> States;     // of its pixels
  std::string Name;
  AngleAxis X, Y;
};

std::vector<std::size_t> RowsOf(const std::vector<double>& y, bool wavelengths)
{
  std::vector<std::size_t> rows;
  if (!wavelengths || y.size() < 2)
  {
    for (std::size_t k = 0; k < y.size(); ++k)
    {
      rows.push_back(k);
    }
    return rows;
  }
  constexpr int count = 512;
  for (int k = 0; k < count; ++k)
  {
    const double at = y.front() + (y.back() - y.front()) * (k + 0.5) / count;
    const auto above = std::lower_bound(y.begin(), y.end(), at);
    const auto index = static_cast<std::size_t>(above - y.begin());
    rows.push_back(index > 0 && at - y[index - 1] < y[index] - at ? index - 1 : index);
  }
  return rows;
}

PlotCurve KnownValues(vtkImageData* slice)
{
  PlotCurve known;
  vtkDataArray* values = slice->GetPointData()->GetArray("value");
  vtkDataArray* states = slice->GetPointData()->GetArray("state");
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    if (states->GetTuple1(i) == 1 || states->GetTuple1(i) == 2)
    {
      known.Y.push_back(values->GetComponent(i, 0));
    }
  }
  return known;
}
}

vtkBRDFSlice* vtkBRDFSliceView::GetSettings()
{
  return this->Settings;
}

vtkBRDFSlice* vtkBRDFSliceView::GetSlice(int index)
{
  return index >= 0 && index < this->GetNumberOfInputs() ? this->Inputs[static_cast<std::size_t>(index)].Slice.Get()
                                                         : nullptr;
}

void vtkBRDFSliceView::AddInputConnection(vtkAlgorithmOutput* brdf, const std::string& name)
{
  this->Inputs.push_back({ vtkSmartPointer<vtkBRDFSlice>::New(), name });
  this->Inputs.back().Slice->SetInputConnection(brdf);
  this->Modified();
}

void vtkBRDFSliceView::AddInputData(vtkDataObject* brdf, const std::string& name)
{
  this->Inputs.push_back({ vtkSmartPointer<vtkBRDFSlice>::New(), name });
  this->Inputs.back().Slice->SetInputData(brdf);
  this->Modified();
}

void vtkBRDFSliceView::RemoveAllInputs()
{
  this->Inputs.clear();
  this->Modified();
}

void vtkBRDFSliceView::Build(int width, int height)
{
  if (this->Inputs.empty())
  {
    throw brdf::Error(brdf::Error::Kind::Value, { "nothing to draw", "slice view", "no input", "a BRDF" });
  }
  if (this->Scale != "linear" && this->Scale != "log" && this->Scale != "cuberoot")
  {
    throw brdf::Error(brdf::Error::Kind::Value,
                      { "unknown scale", "slice view", this->Scale, "linear, log, cuberoot" });
  }
  if (!std::isfinite(this->Exposure))
  {
    throw brdf::Error(brdf::Error::Kind::Value, { "out of range", "exposure", "not finite", "a number of stops" });
  }
  vtkRenderer* renderer = this->GetRenderer();
  const int text = TextSize(width, height);
  std::vector<PlotCurve> known;
  for (const Input& input : this->Inputs)
  {
    input.Slice->CopySettings(this->Settings);
    UpdateOrThrow(input.Slice);
    known.push_back(KnownValues(input.Slice->GetOutput()));
  }
  std::vector<const PlotCurve*> curves;
  for (const PlotCurve& curve : known)
  {
    curves.push_back(&curve);
  }
  const PlotScale scale = this->Range[0] < this->Range[1]
                            ? PlotScale(PlotScale::Parse(this->Scale), this->Range[0], this->Range[1])
                            : PlotScale::OfMap(PlotScale::Parse(this->Scale), curves, this->Decades);
  const bool wavelengths = this->Settings->GetAxes().find(",wavelength") != std::string::npos;
  const bool colours = this->Settings->GetChannel() == "rgb" && !wavelengths;

  std::vector<Panel> panels;
  bool below = false, missing = false, beyond = false;
  for (const Input& input : this->Inputs)
  {
    vtkImageData* slice = input.Slice->GetOutput();
    vtkDataArray* values = slice->GetPointData()->GetArray("value");
    vtkDataArray* states = slice->GetPointData()->GetArray("state");
    const std::vector<double> x = vtkBRDFArrays::FieldNumbers(slice->GetFieldData(), "x"),
                              y = vtkBRDFArrays::FieldNumbers(slice->GetFieldData(), "y");
    const std::vector<std::size_t> rows = RowsOf(y, wavelengths);
    Panel panel;
    panel.Name = !input.Name.empty()
                   ? input.Name
                   : Rounded(vtkBRDF::SafeDownCast(input.Slice->GetInputDataObject(0, 0))->GetDescription());
    const std::string axes = input.Slice->GetAxes();
    const std::string angle = axes.substr(0, axes.find(','));
    panel.X = wavelengths ? AngleAxis::OfCurve(angle) : AngleAxis::OfSlice(angle, input.Slice->GetWarp());
    panel.Y = wavelengths ? AngleAxis::Plain("wavelength (nm)", y.front(), y.size() > 1 ? y.back() : y.front() + 1)
                          : AngleAxis::OfSlice(axes.substr(axes.find(',') + 1), 1);
    panel.Picture = vtkSmartPointer<vtkImageData>::New();
    panel.Picture->SetDimensions(static_cast<int>(x.size()), static_cast<int>(rows.size()), 1);
    panel.Picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    panel.States.resize(x.size() * rows.size());
    auto* pixel = static_cast<unsigned char*>(panel.Picture->GetScalarPointer());
    const double gain = brdf::kPi * std::exp2(this->Exposure);
    for (std::size_t row = 0; row < rows.size(); ++row)
    {
      for (std::size_t column = 0; column < x.size(); ++column, pixel += 3)
      {
        const auto i = static_cast<vtkIdType>(rows[row] * x.size() + column);
        const auto state = static_cast<unsigned char>(states->GetTuple1(i));
        panel.States[row * x.size() + column] = state;
        Color color = { 1, 1, 1 };
        if (state == 1 || state == 2)
        {
          if (colours)
          {
            for (int c = 0; c < 3; ++c)
            {
              color[c] = brdf::encodeSrgb(gain * values->GetComponent(i, c));
            }
          }
          else
          {
            color = Sequential(scale.Position(values->GetComponent(i, 0)));
          }
        }
        below = below || state == 3;
        missing = missing || state == 0;
        beyond = beyond || state == 2;
        for (int c = 0; c < 3; ++c)
        {
          pixel[c] = static_cast<unsigned char>(std::lround(255 * color[c]));
        }
      }
    }
    panels.push_back(std::move(panel));
  }

  vtkBRDFSlice* first = this->Inputs.front().Slice;
  std::string note = wavelengths ? "" : first->GetChannelLabel() + "; ";
  note += first->GetFixedAngles();
  if (!colours)
  {
    note += this->Scale == "log" ? "; logarithmic scale" : this->Scale == "cuberoot" ? "; cube-root scale" : "";
    double largest = 0;
    for (const PlotCurve& curve : known)
    {
      for (const double value : curve.Y)
      {
        largest = std::max(largest, value);
      }
    }
    note +=
      largest > scale.GetHigh() ? "; brightest: " + NumberText(scale.GetHigh()) + " to " + NumberText(largest) : "";
  }
  else
  {
    note += "; shown: pi f_r" + (this->Exposure == 0 ? std::string() : ", " + NumberText(this->Exposure) + " stops");
  }
  // Over the wavelength the state changes with the angle only: lines would hide the values.
  const bool edges = beyond && !wavelengths;
  note += edges ? "; beyond white lines: filled or extrapolated" : "";
  note += below ? "; hatched: below the horizon" : "";
  note += missing ? "; crossed: no value" : "";
  const double top = AddHeading(
    renderer,
    this->GetTitle().empty() ? "Slice of f_r over " + AngleAxis::NameOf(panels[0].X, panels[0].Y) : this->GetTitle(),
    note,
    height - 0.7 * text,
    text);
  const double bar = colours ? 1.0 * text : 8.5 * text;
  // Names that do not fit above their pictures stand at the bottom, by letters.
  std::vector<std::string> lettered;
  const auto lettersOf = [text](double side) { return static_cast<std::size_t>((side + 3 * text) / (0.56 * text)); };
  const PanelGrid wide(panels.size(), width - bar - 0.5 * text, height - 6.0 * text, text);
  if (std::any_of(panels.begin(),
                  panels.end(),
                  [&](const Panel& panel) { return panel.Name.size() > lettersOf(wide.GetSide()); }))
  {
    for (std::size_t k = 0; k < panels.size(); ++k)
    {
      lettered.push_back(k < 26 ? std::string(1, static_cast<char>('A' + k)) : std::to_string(k + 1));
    }
  }
  const double low = 0.8 * text + 1.4 * text * static_cast<double>(lettered.size()), left = 0.5 * text,
               right = width - bar;
  const PanelGrid grid(panels.size(), right - left, top - low, text);
  for (std::size_t k = 0; k < panels.size(); ++k)
  {
    const Panel& panel = panels[k];
    const PanelPlace place = grid.Place(k, left, low);
    AddImage(renderer, panel.Picture, place.Low, { place.Low[0] + place.Side, place.Low[1] + place.Side });
    AddHatches(renderer, panel.Picture->GetDimensions(), panel.States, place, text);
    if (edges)
    {
      AddDataEdges(renderer, panel.Picture->GetDimensions(), panel.States, place, text);
    }
    AddAngleAxes(renderer, panel.X, panel.Y, place, text);
    AddText(renderer,
            lettered.empty() ? panel.Name : lettered[k],
            { place.Low[0] + place.Side / 2, place.Low[1] + place.Side + 0.5 * text },
            { .Size = text, .Horizontal = Align::Center });
  }
  if (!colours)
  {
    AddValueBar(
      renderer, scale, "f_r (1/sr)", { right, low + 0.5 * text }, { right + 1.4 * text, top - 2.5 * text }, text);
  }
  if (!lettered.empty())
  {
    for (std::size_t k = 0; k < panels.size(); ++k)
    {
      const auto fitting = static_cast<std::size_t>((width - 2 * text) / (0.56 * text));
      AddText(renderer,
              Shortened(lettered[k] + ": " + panels[k].Name, fitting),
              { 1.0 * text, text * (0.6 + 1.4 * static_cast<double>(panels.size() - 1 - k)) },
              { .Size = text });
    }
  }
}

void vtkBRDFSliceView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Inputs: " << this->Inputs.size() << "\n"
     << indent << "Scale: " << this->Scale << "\n"
     << indent << "Decades: " << this->Decades << "\n"
     << indent << "Range: " << this->Range[0] << " " << this->Range[1] << "\n"
     << indent << "Exposure: " << this->Exposure << "\n";
}
