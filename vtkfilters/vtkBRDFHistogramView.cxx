#include "vtkBRDFHistogramView.h"

#include "vtkBRDF.h"
#include "vtkBRDFDrawing.h"
#include "vtkBRDFErrorMap.h"
#include "vtkBRDFErrorMapText.h"
#include "vtkDataArray.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"
#include "vtkTable.h"

#include <brdf/base/Error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace vtkBRDFDrawing;

vtkStandardNewMacro(vtkBRDFHistogramView);
vtkBRDFHistogramView::vtkBRDFHistogramView() = default;
vtkBRDFHistogramView::~vtkBRDFHistogramView() = default;

struct vtkBRDFHistogramView::Axes
{
  int Text;
  Point Low, High;                  // of the plot, pixels
  std::vector<double> Edges;        // of bins
  std::vector<double> Counts;       // of bins: pairs, or shares
  bool Logarithmic = false;         // along x
  bool Shares = false;              // heights are shares, not numbers
  double First = 0, Last = 1;       // along x
  double Smallest = 1, Largest = 1; // along y

  double X(double error) const
  {
    const double t = this->Logarithmic
                       ? std::log(std::max(error, this->First) / this->First) / std::log(this->Last / this->First)
                       : (error - this->First) / (this->Last - this->First);
    return this->Low[0] + std::clamp(t, 0.0, 1.0) * (this->High[0] - this->Low[0]);
  }
  double Y(double count) const
  {
    const double t =
      std::log(std::max(count, this->Smallest) / this->Smallest) / std::log(this->Largest / this->Smallest);
    return this->Low[1] + std::clamp(t, 0.0, 1.0) * (this->High[1] - this->Low[1]);
  }
};

namespace
{
constexpr std::array<double, 5> Shares = { 0.05, 0.5, 0.9, 0.99, 1 };
constexpr std::array<double, 5> SignedShares = { 0, 0.05, 0.5, 0.95, 1 };
constexpr Color QuantileColor = { 0.80, 0.40, 0.00 };

std::vector<double> ColumnNumbers(vtkTable* table, const char* name)
{
  vtkDataArray* column = vtkDataArray::SafeDownCast(table->GetColumnByName(name));
  std::vector<double> numbers;
  for (vtkIdType row = 0; column && row < column->GetNumberOfTuples(); ++row)
  {
    numbers.push_back(column->GetTuple1(row));
  }
  return numbers;
}

std::string Percent(double share)
{
  return share == 0 ? "smallest" : share == 0.5 ? "median" : share == 1 ? "largest" : NumberText(100 * share, 4) + " %";
}
}

void vtkBRDFHistogramView::SetErrorMap(vtkBRDFErrorMap* map)
{
  this->ErrorMap = map;
  this->Modified();
}

vtkBRDFErrorMap* vtkBRDFHistogramView::GetErrorMap()
{
  return this->ErrorMap;
}

vtkBRDFHistogramView::Axes vtkBRDFHistogramView::MakeAxes(int width, int height, double top)
{
  vtkTable* table = this->ErrorMap->GetHistogram();
  Axes axes{};
  axes.Text = TextSize(width, height);
  axes.Low = { 6.5 * axes.Text, 8.2 * axes.Text };
  axes.High = { width - 2.5 * axes.Text, top - 3.6 * axes.Text };
  axes.Edges = ColumnNumbers(table, "low");
  const std::vector<double> ends = ColumnNumbers(table, "high");
  if (!ends.empty())
  {
    axes.Edges.push_back(ends.back());
  }
  axes.Counts = ColumnNumbers(table, "count");
  const std::vector<double> shares = ColumnNumbers(table, "share");
  double total = 0;
  for (double count : axes.Counts)
  {
    total += count;
  }
  for (std::size_t k = 0; k < shares.size(); ++k)
  {
    axes.Shares = axes.Shares || std::abs(shares[k] - axes.Counts[k] / total) > 1e-9;
  }
  if (axes.Shares)
  {
    axes.Counts = shares;
  }
  if (axes.Edges.size() > 1)
  {
    const std::size_t last = axes.Edges.size() - 1;
    axes.First = axes.Edges.front();
    axes.Last = axes.Edges.back();
    axes.Logarithmic = last > 1 && axes.First > 0 &&
                       std::abs(axes.Edges[1] * axes.Edges[last - 1] / (axes.First * axes.Last) - 1) < 1e-6;
  }
  if (!(axes.Last > axes.First)) // one number
  {
    const double middle = axes.First, half = middle != 0 ? std::abs(middle) / 2 : 0.5;
    axes.First = middle - half;
    axes.Last = middle + half;
    axes.Edges = { middle - half / 20, middle + half / 20 };
  }
  axes.Largest = 0;
  axes.Smallest = axes.Shares ? 1 : 0.5; // a bar of one pair is seen
  for (double count : axes.Counts)
  {
    axes.Largest = std::max(axes.Largest, count);
    if (axes.Shares && count > 0)
    {
      axes.Smallest = std::min(axes.Smallest, count / 2);
    }
  }
  axes.Smallest = std::max(axes.Smallest, 1e-8 * axes.Largest);
  axes.Largest = std::max(2 * axes.Largest, 2 * axes.Smallest);
  return axes;
}

void vtkBRDFHistogramView::AddBars(const Axes& axes)
{
  std::vector<Rectangle> bars;
  for (std::size_t k = 0; k + 1 < axes.Edges.size() && k < axes.Counts.size(); ++k)
  {
    if (axes.Counts[k] > 0)
    {
      const double gap = axes.X(axes.Edges[k + 1]) - axes.X(axes.Edges[k]) > 6 ? 0.5 : 0;
      bars.push_back({ { axes.X(axes.Edges[k]) + gap, axes.Low[1] },
                       { axes.X(axes.Edges[k + 1]) - gap, axes.Y(axes.Counts[k]) },
                       PaletteColor(0) });
    }
  }
  AddRectangles(this->GetRenderer(), bars);
}

void vtkBRDFHistogramView::AddAxes(const Axes& axes)
{
  vtkRenderer* renderer = this->GetRenderer();
  const double tick = axes.Text / 3.0;
  std::vector<Line> lines = { { axes.Low, { axes.High[0], axes.Low[1] } },
                              { axes.Low, { axes.Low[0], axes.High[1] } } };
  const int room = std::max(2, static_cast<int>((axes.High[0] - axes.Low[0]) / (5.0 * axes.Text)));
  std::vector<double> ticks =
    axes.Logarithmic ? LogarithmicTicks(axes.First, axes.Last) : LinearTicks(axes.First, axes.Last, room);
  for (double value : ticks)
  {
    const double x = axes.X(value);
    lines.push_back({ { x, axes.Low[1] - tick }, { x, axes.Low[1] } });
    AddText(renderer,
            NumberText(value),
            { x, axes.Low[1] - 1.6 * tick },
            { .Size = axes.Text, .Horizontal = Align::Center, .Vertical = Align::High });
  }
  double lastLabel = -1e9;
  for (double value : LogarithmicTicks(axes.Smallest, axes.Largest))
  {
    const double y = axes.Y(value);
    if ((!axes.Shares && value < 1) || y - lastLabel < 1.5 * axes.Text)
    {
      continue;
    }
    lastLabel = y;
    lines.push_back({ { axes.Low[0] - tick, y }, { axes.Low[0], y } });
    AddText(renderer,
            NumberText(value),
            { axes.Low[0] - 1.6 * tick, y },
            { .Size = axes.Text, .Horizontal = Align::High, .Vertical = Align::Center });
  }
  AddLines(renderer, lines, Ink, LineWidth(axes.Text));
  const auto letters = static_cast<std::size_t>(1.85 * (axes.High[0] - axes.Low[0]) / axes.Text);
  AddText(renderer,
          Shortened("error of a pair of directions: " + this->ErrorMap->GetPairQuantity(), letters),
          { (axes.Low[0] + axes.High[0]) / 2, axes.Low[1] - 2.2 * axes.Text },
          { .Size = axes.Text, .Horizontal = Align::Center, .Vertical = Align::High });
  AddText(renderer,
          axes.Shares ? "share of the pairs by solid angle" : "pairs of directions",
          { axes.Low[0] - 4.4 * axes.Text, (axes.Low[1] + axes.High[1]) / 2 },
          { .Size = axes.Text, .Horizontal = Align::Center, .Vertical = Align::Low, .Angle = 90 });
}

void vtkBRDFHistogramView::AddQuantiles(const Axes& axes)
{
  if (this->ErrorMap->GetNumberOfPairs() == 0)
  {
    AddText(this->GetRenderer(),
            "no pair of directions where both have a value",
            { (axes.Low[0] + axes.High[0]) / 2, (axes.Low[1] + axes.High[1]) / 2 },
            { .Size = axes.Text, .Horizontal = Align::Center });
    return;
  }
  std::vector<Line> lines;
  std::array<double, 2> labelEnd = { -1e9, -1e9 }; // of the last label in each of two rows
  for (double share : this->ErrorMap->IsSigned() ? SignedShares : Shares)
  {
    const double value = this->ErrorMap->GetQuantile(share), x = axes.X(value);
    const std::string label = Percent(share) + ": " + NumberText(value);
    const double half = 0.29 * axes.Text * static_cast<double>(label.size());
    const double at = std::clamp(x, axes.Low[0] + half, axes.High[0] - half);
    const int row = at - half > labelEnd[0] ? 0 : 1;
    lines.push_back({ { x, axes.Low[1] }, { x, axes.High[1] + (0.3 + 1.4 * row) * axes.Text } });
    if (at - half <= labelEnd[row])
    {
      continue; // no room: the line stays
    }
    labelEnd[row] = at + half;
    AddText(this->GetRenderer(),
            label,
            { at, axes.High[1] + (0.5 + 1.4 * row) * axes.Text },
            { .Size = axes.Text, .Horizontal = Align::Center, .Foreground = QuantileColor });
  }
  AddLines(this->GetRenderer(), lines, QuantileColor, 1.3 * LineWidth(axes.Text));
}

void vtkBRDFHistogramView::Build(int width, int height)
{
  if (!this->ErrorMap)
  {
    throw brdf::Error(brdf::Error::Kind::Value, { "nothing to draw", "histogram", "no error map", "one" });
  }
  UpdateOrThrow(this->ErrorMap);
  const int text = TextSize(width, height);
  const auto letters = static_cast<std::size_t>(1.85 * (width - 2 * text) / text);
  const double top = AddHeading(this->GetRenderer(),
                                this->GetTitle().empty() ? "How often A differs from B by how much" : this->GetTitle(),
                                vtkBRDFErrorMapText::Note(this->ErrorMap),
                                height - text,
                                text);
  vtkBRDFErrorMapText::AddNames(this->GetRenderer(), this->ErrorMap, this->NameA, this->NameB, text, letters);
  const Axes axes = this->MakeAxes(width, height, top);
  this->AddBars(axes);
  this->AddAxes(axes);
  this->AddQuantiles(axes);
}

void vtkBRDFHistogramView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NameA: " << this->NameA << "\n" << indent << "NameB: " << this->NameB << "\n";
}
