#include "vtkBRDFDotPlotView.h"

#include "vtkBRDFDrawing.h"
#include "vtkDataArray.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <brdf/base/Error.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

using namespace vtkBRDFDrawing;

vtkStandardNewMacro(vtkBRDFDotPlotView);
vtkBRDFDotPlotView::vtkBRDFDotPlotView() = default;
vtkBRDFDotPlotView::~vtkBRDFDotPlotView() = default;

/** Where the rows of the table lie in the picture. */
struct vtkBRDFDotPlotView::Rows
{
  std::vector<double> Y;           ///< middle of each row of the table, pixels
  std::vector<std::size_t> Group;  ///< of each row
  std::vector<std::size_t> Series; ///< of each row
  std::size_t Groups = 0;
  double Low = 0;
  double High = 0;
  int Text = 0;
};

namespace
{
constexpr Color Grid = { 0.88, 0.88, 0.90 };

std::string Cell(vtkTable* table, vtkIdType row, const char* column)
{
  return table->GetValueByName(row, column).ToString();
}

bool Drawable(double value)
{
  return std::isfinite(value) && value > 0;
}

std::size_t IndexOf(std::vector<std::string>& names, const std::string& name)
{
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end())
  {
    return static_cast<std::size_t>(found - names.begin());
  }
  names.push_back(name);
  return names.size() - 1;
}
}

void vtkBRDFDotPlotView::SetTable(vtkTable* table)
{
  this->Table = table;
  this->Modified();
}

vtkTable* vtkBRDFDotPlotView::GetTable()
{
  return this->Table;
}

void vtkBRDFDotPlotView::AddPanel(const Rows& rows, vtkIdType column, double left, double right)
{
  vtkTable* table = this->Table;
  const double text = rows.Text;
  double low = std::numeric_limits<double>::infinity(), high = 0;
  std::vector<double> values(rows.Y.size()), smallest(rows.Groups, low);
  for (std::size_t row = 0; row < values.size(); ++row)
  {
    values[row] = table->GetValue(static_cast<vtkIdType>(row), column).ToDouble();
    if (Drawable(values[row]))
    {
      low = std::min(low, values[row]);
      high = std::max(high, values[row]);
      smallest[rows.Group[row]] = std::min(smallest[rows.Group[row]], values[row]);
    }
  }
  if (high == 0)
  {
    low = high = 1;
  }
  // At least a factor of two each way, so that equal numbers look equal, and nothing beyond what a double holds.
  const double range = std::log(high) - std::log(low);
  const double margin = std::max(0.14, (std::log(4) - range) / 2);
  const double from = std::max(std::log(low) - margin, std::log(1e-307));
  const double to = std::min(std::log(high) + margin, std::log(1e308));
  // The right margin is for the number beside the rightmost dot.
  const double end = right - 5 * text;
  const auto x = [&](double value)
  { return left + std::clamp((std::log(value) - from) / (to - from), 0.0, 1.0) * (end - left); };

  std::vector<Line> grid;
  const std::vector<double> ticks = LogarithmicTicks(std::exp(from), std::exp(to));
  for (std::size_t k = 0; k < ticks.size(); k += 1 + ticks.size() / 10)
  {
    const double tick = ticks[k];
    grid.push_back({ { x(tick), rows.Low }, { x(tick), rows.High } });
    AddText(this->GetRenderer(),
            NumberText(tick),
            { x(tick), rows.Low - text / 3 },
            { .Size = rows.Text, .Horizontal = Align::Center, .Vertical = Align::High });
  }
  // A guide leads from the name to the dot and stops there.
  for (std::size_t row = 0; row < values.size(); ++row)
  {
    if (Drawable(values[row]))
    {
      grid.push_back({ { left, rows.Y[row] }, { x(values[row]) - 0.4 * text, rows.Y[row] } });
    }
  }
  AddLines(this->GetRenderer(), grid, Grid, LineWidth(rows.Text));
  AddLines(this->GetRenderer(), { { { left, rows.Low }, { end, rows.Low } } }, Ink, LineWidth(rows.Text));
  AddText(this->GetRenderer(),
          table->GetColumnName(column),
          { (left + end) / 2, rows.Low - 1.8 * text },
          { .Size = rows.Text, .Horizontal = Align::Center, .Vertical = Align::High });

  std::map<std::size_t, std::vector<Point>> dots;
  for (std::size_t row = 0; row < values.size(); ++row)
  {
    const double value = values[row];
    const bool drawn = Drawable(value);
    const double at = drawn ? x(value) : left;
    if (drawn)
    {
      dots[rows.Series[row]].push_back({ at, rows.Y[row] });
    }
    AddText(this->GetRenderer(),
            drawn || value == 0 ? NumberText(value) : "\u2013",
            { at + 0.7 * text, rows.Y[row] },
            { .Size = rows.Text * 4 / 5,
              .Vertical = Align::Center,
              .Foreground = Ink,
              .Bold = drawn && NumberText(value) == NumberText(smallest[rows.Group[row]]) });
  }
  for (const auto& [series, points] : dots)
  {
    AddDots(this->GetRenderer(), points, 0.36 * text, PaletteColor(series));
  }
}

void vtkBRDFDotPlotView::Build(int width, int height)
{
  vtkTable* table = this->Table;
  if (!table || table->GetNumberOfRows() == 0)
  {
    throw brdf::Error(brdf::Error::Kind::Value, { "nothing to draw", "dot plot", "", "a table with one row a dot" });
  }
  for (const char* name : { "group", "series" })
  {
    if (!table->GetColumnByName(name))
    {
      throw brdf::Error(brdf::Error::Kind::Value, { "missing column", "dot plot", "", name });
    }
  }
  std::vector<vtkIdType> panels;
  for (vtkIdType column = 0; column < table->GetNumberOfColumns(); ++column)
  {
    if (vtkDataArray::SafeDownCast(table->GetColumn(column)))
    {
      panels.push_back(column);
    }
  }
  if (panels.empty())
  {
    throw brdf::Error(brdf::Error::Kind::Value, { "no numbers", "dot plot", "", "a column of numbers for each panel" });
  }

  const int text = SmallTextSize(width, height);
  const double top = height - 0.6 * text;
  AddHeading(this->GetRenderer(), this->GetTitle(), this->Note, top, text);

  Rows rows;
  std::vector<std::string> groups, series;
  const auto count = static_cast<std::size_t>(table->GetNumberOfRows());
  for (std::size_t row = 0; row < count; ++row)
  {
    rows.Group.push_back(IndexOf(groups, Cell(table, static_cast<vtkIdType>(row), "group")));
    rows.Series.push_back(IndexOf(series, Cell(table, static_cast<vtkIdType>(row), "series")));
  }
  rows.Groups = groups.size();
  rows.High = top - 3.6 * text;
  rows.Low = 4.2 * text;
  // Every group has a heading, and half a row of air.
  const double rowHeight =
    (rows.High - rows.Low) / (static_cast<double>(count) + 1.5 * static_cast<double>(groups.size()));
  rows.Text = std::max(6, static_cast<int>(std::min<double>(text, 0.85 * rowHeight)));
  std::size_t letters = 0;
  for (const std::vector<std::string>* names : { &groups, &series })
  {
    for (const std::string& name : *names)
    {
      letters = std::max(letters, name.size());
    }
  }
  letters = std::min<std::size_t>(letters, 44);
  const double left = 2 * text + 0.52 * rows.Text * static_cast<double>(letters + 2);

  rows.Y.resize(count);
  double y = rows.High;
  for (std::size_t group = 0; group < groups.size(); ++group)
  {
    AddText(this->GetRenderer(),
            Shortened(groups[group], letters + 2),
            { 1.0 * text, y - rowHeight / 2 },
            { .Size = rows.Text, .Vertical = Align::Center, .Bold = true });
    y -= rowHeight;
    for (std::size_t row = 0; row < count; ++row)
    {
      if (rows.Group[row] != group)
      {
        continue;
      }
      rows.Y[row] = y - rowHeight / 2;
      AddText(this->GetRenderer(),
              Shortened(series[rows.Series[row]], letters),
              { 2.0 * text, rows.Y[row] },
              { .Size = rows.Text, .Vertical = Align::Center });
      y -= rowHeight;
    }
    y -= rowHeight / 2;
  }
  const double panelWidth = (width - left - text) / static_cast<double>(panels.size());
  for (std::size_t panel = 0; panel < panels.size(); ++panel)
  {
    const double start = left + panelWidth * static_cast<double>(panel);
    this->AddPanel(rows, panels[panel], start, start + panelWidth);
  }
}

void vtkBRDFDotPlotView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Table: " << this->Table.GetPointer() << "\n" << indent << "Note: " << this->Note << "\n";
}
