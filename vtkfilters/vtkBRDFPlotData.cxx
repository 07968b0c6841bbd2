#include "vtkBRDFPlotData.h"

#include "vtkDataArray.h"
#include "vtkTable.h"

#include <brdf/base/Error.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

namespace vtkBRDFDrawing
{
namespace
{
const std::string ErrorPrefix = "standard error of ";

std::vector<double> NumbersOf(vtkDataArray* array)
{
  std::vector<double> numbers(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    numbers[i] = array->GetComponent(static_cast<vtkIdType>(i), 0);
  }
  return numbers;
}
}

Color Pale(const Color& color)
{
  Color pale = color;
  for (double& component : pale)
  {
    component = 0.55 + 0.45 * component;
  }
  return pale;
}

std::vector<PlotCurve> CurvesOf(vtkTable* table)
{
  std::vector<PlotCurve> curves;
  std::map<std::string, std::vector<double>> errors;
  vtkDataArray* x = table ? vtkDataArray::SafeDownCast(table->GetColumn(0)) : nullptr;
  for (vtkIdType k = 1; x && k < table->GetNumberOfColumns(); ++k)
  {
    auto* column = vtkDataArray::SafeDownCast(table->GetColumn(k));
    const std::string name = table->GetColumnName(k) ? table->GetColumnName(k) : "";
    if (!column || name == "state" || name == "distance")
    {
      continue;
    }
    if (name.rfind(ErrorPrefix, 0) == 0)
    {
      errors[name.substr(ErrorPrefix.size())] = NumbersOf(column);
    }
    else
    {
      curves.push_back({ name, NumbersOf(x), NumbersOf(column), {}, {} });
    }
  }
  if (curves.empty())
  {
    throw brdf::Error(
      brdf::Error::Kind::Value,
      { "nothing to plot", "table", table ? "no curve" : "no table", "a column of x and columns of numbers" });
  }
  std::vector<bool> beyond;
  if (auto* states = vtkDataArray::SafeDownCast(table->GetColumnByName("state")))
  {
    for (const double state : NumbersOf(states))
    {
      beyond.push_back(state == 2);
    }
  }
  for (PlotCurve& curve : curves)
  {
    curve.Beyond = beyond;
    if (const auto found = errors.find(curve.Name); found != errors.end())
    {
      curve.Error = found->second;
    }
  }
  return curves;
}

PlotScale::Kind PlotScale::Parse(const std::string& name)
{
  const std::map<std::string, Kind> kinds = {
    { "linear", Kind::Linear }, { "log", Kind::Log }, { "cuberoot", Kind::CubeRoot }, { "log1p", Kind::Log1p }
  };
  const auto found = kinds.find(name);
  if (found == kinds.end())
  {
    throw brdf::Error(brdf::Error::Kind::Value, { "unknown scale", "plot", name, "linear, log, cuberoot, log1p" });
  }
  return found->second;
}

PlotScale::PlotScale(Kind kind,
                     const std::vector<const PlotCurve*>& curves,
                     const std::vector<double>& levels,
                     double decades)
  : ScaleKind(kind)
{
  const double infinity = std::numeric_limits<double>::infinity();
  double smallest = infinity, largest = -infinity, positive = infinity;
  const auto consider = [&](double value)
  {
    if (std::isfinite(value))
    {
      smallest = std::min(smallest, value);
      largest = std::max(largest, value);
      positive = value > 0 ? std::min(positive, value) : positive;
    }
  };
  for (const PlotCurve* curve : curves)
  {
    for (std::size_t i = 0; i < curve->Y.size(); ++i)
    {
      consider(curve->Y[i]);
      if (!curve->Error.empty() && std::isfinite(curve->Error[i]))
      {
        consider(curve->Y[i] + curve->Error[i]);
      }
    }
  }
  for (const double level : levels)
  {
    consider(level);
  }
  if (!(largest > 0) && !(smallest < 0))
  {
    smallest = 0;
    largest = positive = 1;
  }
  if (kind == Kind::Log)
  {
    this->High = largest > 0 ? largest : 1;
    this->Low = std::max(std::min(positive, this->High / 3), this->High * std::pow(10, -decades));
    this->Low = std::max(this->Low, std::numeric_limits<double>::min());
    const double room = 0.04 * (std::log10(this->High) - std::log10(this->Low));
    this->From = std::log10(this->Low) - room;
    this->To = std::log10(this->High) + room;
    return;
  }
  this->Low = std::min(smallest, 0.0);
  this->High = std::max(largest, 0.0);
  const double from = this->Transformed(this->Low), to = this->Transformed(this->High);
  this->From = from < 0 ? from - 0.05 * (to - from) : 0;
  this->To = to + 0.05 * (to - from);
}

PlotScale::PlotScale(Kind kind, double low, double high)
  : ScaleKind(kind)
  , Low(low)
  , High(high)
{
  this->From = this->Transformed(low);
  this->To = this->Transformed(high);
}

PlotScale PlotScale::OfMap(Kind kind, const std::vector<const PlotCurve*>& values, double decades)
{
  std::vector<double> all;
  for (const PlotCurve* curve : values)
  {
    std::copy_if(curve->Y.begin(),
                 curve->Y.end(),
                 std::back_inserter(all),
                 [kind](double value) { return std::isfinite(value) && (kind != Kind::Log || value > 0); });
  }
  if (all.empty())
  {
    return { kind, kind == Kind::Log ? 0.1 : 0, 1 };
  }
  const auto quantile = [&](double share)
  {
    const auto at = all.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(all.size() - 1));
    std::nth_element(all.begin(), at, all.end());
    return *at;
  };
  double high = quantile(0.99);
  if (kind != Kind::Log)
  {
    const double low = std::min(0.0, quantile(0.01));
    return { kind, low, high > low ? high : low + 1 };
  }
  double low = std::max({ quantile(0.01), high * std::pow(10, -decades), std::numeric_limits<double>::min() });
  if (!(high > 1.5 * low)) // as good as one value: in the middle
  {
    const double middle = std::clamp(std::sqrt(low) * std::sqrt(high), 1e-300, 1e300);
    low = middle / 2;
    high = middle * 2;
  }
  return { kind, low, high };
}

double PlotScale::Transformed(double value) const
{
  switch (this->ScaleKind)
  {
    case Kind::Log:
      return std::log10(value);
    case Kind::CubeRoot:
      return std::cbrt(value);
    case Kind::Log1p:
      return std::copysign(std::log1p(std::abs(value)), value);
    default:
      return value;
  }
}

double PlotScale::Position(double value) const
{
  if (this->ScaleKind == Kind::Log && value <= 0)
  {
    return -0.1;
  }
  return std::max((this->Transformed(value) - this->From) / (this->To - this->From), -0.1);
}

std::vector<double> PlotScale::Ticks(double gap) const
{
  std::vector<double> candidates;
  if (this->ScaleKind == Kind::Linear)
  {
    return LinearTicks(this->Low, this->High, std::max(2, static_cast<int>(0.5 / gap)));
  }
  const double largest = std::max(std::abs(this->Low), std::abs(this->High));
  const int high = static_cast<int>(std::floor(std::log10(largest)));
  // Powers of ten come first: 2 and 5 times them only where there is room.
  for (const double factor : { 1.0, 5.0, 2.0 })
  {
    for (int decade = high; decade > high - 640; --decade)
    {
      const double value = factor * std::pow(10, decade);
      if (value < largest * 1e-7 && this->ScaleKind != Kind::Log)
      {
        break;
      }
      candidates.push_back(value);
      if (this->Low < 0)
      {
        candidates.push_back(-value);
      }
    }
  }
  std::vector<double> ticks;
  if (this->ScaleKind != Kind::Log)
  {
    candidates.insert(candidates.begin(), 0);
  }
  for (const double value : candidates)
  {
    const double at = this->Position(value);
    const bool inside = at >= 0 && at <= 1;
    if (inside && std::none_of(
                    ticks.begin(), ticks.end(), [&](double tick) { return std::abs(this->Position(tick) - at) < gap; }))
    {
      ticks.push_back(value);
    }
  }
  std::sort(ticks.begin(), ticks.end());
  return ticks;
}
}
