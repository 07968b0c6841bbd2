#include "vtkBRDFAuditView.h"

#include "vtkBRDFAlbedoPlot.h"
#include "vtkBRDFDrawing.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <brdf/base/Error.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

using namespace vtkBRDFDrawing;

vtkStandardNewMacro(vtkBRDFAuditView);
vtkBRDFAuditView::vtkBRDFAuditView() = default;
vtkBRDFAuditView::~vtkBRDFAuditView() = default;

/** A part of the picture, in pixels. */
struct vtkBRDFAuditView::Frame
{
  Point Low;
  Point High;
  int Text;

  double Width() const { return this->High[0] - this->Low[0]; }
  double Height() const { return this->High[1] - this->Low[1]; }
};

namespace
{
struct State
{
  const char* Name;
  Color Fill;
};
// Told apart by lightness too, for the colour-blind.
constexpr State States[] = { { "passed", { 0.80, 0.91, 0.84 } },
                             { "declared", { 0.98, 0.87, 0.55 } },
                             { "failed", { 0.84, 0.37, 0.0 } },
                             { "skipped", { 0.90, 0.90, 0.91 } } };

Color FillOf(const std::string& name)
{
  for (const State& state : States)
  {
    if (name == state.Name)
    {
      return state.Fill;
    }
  }
  return { 1, 1, 1 };
}

std::string Text(vtkTable* table, vtkIdType row, const char* column)
{
  return table->GetValueByName(row, column).ToString();
}

double Number(vtkTable* table, vtkIdType row, const char* column)
{
  return table->GetValueByName(row, column).ToDouble();
}

std::string Limit(double value)
{
  return std::isinf(value) ? "any" : NumberText(value, 4);
}

/** The values of a column, each once, in order of first appearance. */
std::vector<std::string> Distinct(vtkTable* table, const char* column)
{
  std::vector<std::string> values;
  std::set<std::string> seen;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    if (seen.insert(Text(table, row, column)).second)
    {
      values.push_back(Text(table, row, column));
    }
  }
  return values;
}

/** The checks in the order of the model that has most of them, then the others. */
std::vector<std::string> ChecksInOrder(vtkTable* table)
{
  std::map<std::string, std::vector<std::string>> ofModel;
  std::vector<std::string> checks;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    std::vector<std::string>& own = ofModel[Text(table, row, "model")];
    own.push_back(Text(table, row, "check"));
    if (own.size() > checks.size())
    {
      checks = own;
    }
  }
  for (const std::string& check : Distinct(table, "check"))
  {
    if (std::find(checks.begin(), checks.end(), check) == checks.end())
    {
      checks.push_back(check);
    }
  }
  return checks;
}

void CheckColumns(vtkTable* table, std::initializer_list<const char*> names)
{
  for (const char* name : names)
  {
    if (!table->GetColumnByName(name))
    {
      throw brdf::Error(brdf::Error::Kind::Value, { "missing column", "audit table", "", name });
    }
  }
}
}

void vtkBRDFAuditView::SetChecks(vtkTable* checks)
{
  this->Checks = checks;
  this->Modified();
}

vtkTable* vtkBRDFAuditView::GetChecks()
{
  return this->Checks;
}

void vtkBRDFAuditView::SetAlbedo(vtkTable* albedo)
{
  this->Albedo = albedo;
  this->Modified();
}

vtkTable* vtkBRDFAuditView::GetAlbedo()
{
  return this->Albedo;
}

void vtkBRDFAuditView::AddMatrix(const Frame& frame)
{
  vtkTable* table = this->Checks;
  const std::vector<std::string> models = Distinct(table, "model"), checks = ChecksInOrder(table);
  std::map<std::string, std::size_t> modelOf, checkOf;
  for (std::size_t k = 0; k < models.size(); ++k)
  {
    modelOf[models[k]] = k;
  }
  for (std::size_t k = 0; k < checks.size(); ++k)
  {
    checkOf[checks[k]] = k;
  }
  const double text = frame.Text, left = 15 * text, above = 11 * text;
  const double cellWidth = (frame.Width() - left) / static_cast<double>(checks.size());
  const double cellHeight = (frame.Height() - above) / static_cast<double>(models.size());
  const int small = std::max(6, static_cast<int>(std::min({ text, 0.72 * cellHeight, cellWidth / 4.4 })));
  const auto x = [&](std::size_t column) { return frame.Low[0] + left + cellWidth * static_cast<double>(column); };
  const auto y = [&](std::size_t row) { return frame.High[1] - above - cellHeight * static_cast<double>(row); };
  std::vector<Rectangle> cells; // what comes later is drawn on top
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    const std::size_t column = checkOf[Text(table, row, "check")], line = modelOf[Text(table, row, "model")];
    cells.push_back({ { x(column) + 1, y(line + 1) + 1 },
                      { x(column + 1) - 1, y(line) - 1 },
                      FillOf(Text(table, row, "state")) });
  }
  AddRectangles(this->GetRenderer(), cells);
  std::vector<std::vector<double>> allowed(checks.size());
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    const std::size_t column = checkOf[Text(table, row, "check")], line = modelOf[Text(table, row, "model")];
    const std::string state = Text(table, row, "state");
    if (state != "declared")
    {
      allowed[column].push_back(Number(table, row, "allowed"));
    }
    AddText(this->GetRenderer(),
            state == "skipped" ? "-" : NumberText(Number(table, row, "worst"), 3),
            { (x(column) + x(column + 1)) / 2, (y(line) + y(line + 1)) / 2 },
            { .Size = small,
              .Horizontal = Align::Center,
              .Vertical = Align::Center,
              .Foreground = state == "failed" ? Color{ 1, 1, 1 } : Ink,
              .Bold = state == "failed" });
  }
  for (std::size_t line = 0; line < models.size(); ++line)
  {
    AddText(this->GetRenderer(),
            Shortened(models[line], 26),
            { frame.Low[0] + left - text / 2, (y(line) + y(line + 1)) / 2 },
            { .Size = std::min(frame.Text, static_cast<int>(0.85 * cellHeight)),
              .Horizontal = Align::High,
              .Vertical = Align::Center });
  }
  for (std::size_t column = 0; column < checks.size(); ++column)
  {
    const Point at = { (x(column) + x(column + 1)) / 2, y(0) + text / 2 };
    std::vector<double>& limits = allowed[column];
    std::string limit = "any";
    if (!limits.empty())
    {
      const auto [low, high] = std::minmax_element(limits.begin(), limits.end());
      limit = Limit(*low) + (*low < *high ? " to " + Limit(*high) : "");
    }
    AddText(this->GetRenderer(),
            checks[column],
            { at[0] - 0.6 * text, at[1] },
            { .Size = frame.Text, .Horizontal = Align::Low, .Vertical = Align::Center, .Angle = 90 });
    AddText(this->GetRenderer(),
            "allowed: " + limit,
            { at[0] + 0.7 * text, at[1] },
            { .Size = frame.Text * 4 / 5,
              .Horizontal = Align::Low,
              .Vertical = Align::Center,
              .Foreground = Faint,
              .Angle = 90 });
  }
}

void vtkBRDFAuditView::AddList(const Frame& frame)
{
  vtkTable* table = this->Checks;
  const vtkIdType rows = table->GetNumberOfRows();
  const double height = std::min(1.7 * frame.Text, frame.Height() / static_cast<double>(rows + 1));
  const int size = std::max(6, static_cast<int>(0.62 * height));
  const double em = size;
  const double columns[] = {
    frame.Low[0] + 1.2 * em, frame.Low[0] + 20 * em, frame.Low[0] + 26 * em, frame.Low[0] + 32 * em
  };
  const auto line = [&](vtkIdType row) { return frame.High[1] - height * (static_cast<double>(row) + 0.5); };
  const char* const heads[] = { "check", "worst", "allowed", "where" };
  for (std::size_t k = 0; k < 4; ++k)
  {
    AddText(this->GetRenderer(),
            heads[k],
            { columns[k], line(0) },
            { .Size = size, .Vertical = Align::Center, .Foreground = Faint });
  }
  std::vector<Rectangle> chips; // what comes later is drawn on top
  for (vtkIdType row = 0; row < rows; ++row)
  {
    const double y = line(row + 1);
    chips.push_back(
      { { frame.Low[0], y - 0.45 * height }, { frame.High[0], y + 0.45 * height }, FillOf(Text(table, row, "state")) });
  }
  AddRectangles(this->GetRenderer(), chips);
  const auto letters = static_cast<std::size_t>(std::max(8.0, 1.8 * (frame.High[0] - columns[3]) / em));
  for (vtkIdType row = 0; row < rows; ++row)
  {
    const double y = line(row + 1);
    const std::string state = Text(table, row, "state");
    const TextStyle style = { .Size = size,
                              .Vertical = Align::Center,
                              .Foreground = state == "failed" ? Color{ 1, 1, 1 } : Ink };
    AddText(this->GetRenderer(), Text(table, row, "check"), { columns[0], y }, style);
    AddText(this->GetRenderer(),
            state == "skipped" ? "skipped" : NumberText(Number(table, row, "worst"), 3),
            { columns[1], y },
            style);
    AddText(this->GetRenderer(), Limit(Number(table, row, "allowed")), { columns[2], y }, style);
    AddText(this->GetRenderer(), Shortened(Text(table, row, "at"), letters), { columns[3], y }, style);
  }
}

void vtkBRDFAuditView::AddLegend(int width, int text)
{
  double x = text;
  std::vector<Rectangle> chips;
  const char* const meanings[] = {
    "passed", "declared: measured, the record says why it is not kept", "FAILED", "skipped"
  };
  for (std::size_t k = 0; k < std::size(States); ++k)
  {
    chips.push_back({ { x, 0.7 * text }, { x + 1.4 * text, 1.9 * text }, States[k].Fill });
    AddText(
      this->GetRenderer(), meanings[k], { x + 1.9 * text, 1.3 * text }, { .Size = text, .Vertical = Align::Center });
    x += (3.6 + 0.58 * static_cast<double>(std::string(meanings[k]).size())) * text;
  }
  AddRectangles(this->GetRenderer(), chips);
  if (x + 22 * text < width)
  {
    AddText(this->GetRenderer(),
            "numbers: the worst case of each check",
            { width - text * 1.0, 1.3 * text },
            { .Size = text, .Horizontal = Align::High, .Vertical = Align::Center, .Foreground = Faint });
  }
}

void vtkBRDFAuditView::Build(int width, int height)
{
  if (!this->Checks || this->Checks->GetNumberOfRows() == 0)
  {
    throw brdf::Error(brdf::Error::Kind::Value, { "no checks", "audit view", "", "a table with one row a check" });
  }
  CheckColumns(this->Checks, { "model", "check", "state", "worst", "allowed", "at" });
  const int text =
    TextSize(std::min(width, 900), std::min(height, 700)) * (width > 1300 ? 2 : 1) * 3 / (width > 1300 ? 5 : 3);
  std::map<std::string, std::size_t> count;
  for (vtkIdType row = 0; row < this->Checks->GetNumberOfRows(); ++row)
  {
    ++count[Text(this->Checks, row, "state")];
  }
  const std::vector<std::string> models = Distinct(this->Checks, "model");
  std::string summary = std::to_string(this->Checks->GetNumberOfRows()) + " checks: ";
  for (const State& state : States)
  {
    if (count[state.Name] > 0)
    {
      summary += (summary.ends_with(": ") ? "" : ", ") + std::to_string(count[state.Name]) + " " + state.Name;
    }
  }
  const double top = height - 0.6 * text;
  AddText(this->GetRenderer(),
          !this->GetTitle().empty() ? this->GetTitle()
          : models.size() == 1      ? "Audit of " + Shortened(models[0], 60)
                                    : "Audit of " + std::to_string(models.size()) + " models",
          { 1.0 * text, top },
          { .Size = text * 6 / 5, .Vertical = Align::High, .Bold = true });
  AddText(this->GetRenderer(),
          summary,
          { 1.0 * text, top - 1.8 * text },
          { .Size = text, .Vertical = Align::High, .Foreground = Faint });
  this->AddLegend(width, text);
  Frame frame{ { 1.0 * text, 2.8 * text }, { width - 1.0 * text, top - 3.8 * text }, text };
  if (models.size() > 1)
  {
    this->AddMatrix(frame);
    return;
  }
  if (this->Albedo)
  {
    Frame plot = frame;
    plot.Low[1] = frame.Low[1] + 0.5 * frame.Height();
    frame.High[1] = plot.Low[1] - 0.5 * text;
    CheckColumns(this->Albedo, { "theta" });
    AddAlbedoPlot(this->GetRenderer(), this->Albedo, plot.Low, plot.High, plot.Text, FillOf("failed"));
  }
  this->AddList(frame);
}

void vtkBRDFAuditView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Checks: " << this->Checks.GetPointer() << "\n"
     << indent << "Albedo: " << this->Albedo.GetPointer() << "\n";
}
