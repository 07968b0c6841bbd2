#include "vtkBRDFSlice.h"

#include "vtkBRDF.h"
#include "vtkBRDFAngles.h"
#include "vtkBRDFArrays.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <brdf/base/Error.h>
#include <brdf/view/ChannelChoice.h>
#include <brdf/view/Slice.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace vtkBRDFArrays;

vtkStandardNewMacro(vtkBRDFSlice);
vtkBRDFSlice::vtkBRDFSlice() = default;
vtkBRDFSlice::~vtkBRDFSlice() = default;

struct vtkBRDFSlice::Result
{
  std::string AxisNames[2], Units[2];
  std::vector<double> X, Y; // degrees or nanometres
  std::vector<std::string> Channels;
  std::vector<double> Values; // planar
  std::vector<std::uint8_t> States;
};

namespace
{
constexpr const char* WavelengthAxis = ",wavelength";

bool OverWavelength(const std::string& axes)
{
  const std::string tail = WavelengthAxis;
  return axes.size() > tail.size() && axes.compare(axes.size() - tail.size(), tail.size(), tail) == 0;
}

// Whether the numbers are equally spaced, to a millionth of a step.
bool Even(const std::vector<double>& numbers)
{
  const double step = numbers.size() > 1 ? (numbers.back() - numbers.front()) / (numbers.size() - 1.0) : 1;
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    if (std::abs(numbers[i] - numbers.front() - step * static_cast<double>(i)) > 1e-6 * std::abs(step))
    {
      return false;
    }
  }
  return true;
}

// Spectral values over an angle: rows are the channels.
brdf::Curve AngleCurve(const brdf::Brdf& spectral, const brdf::CurveOptions& options, std::size_t columns)
{
  brdf::CurveOptions middles = options;
  middles.intervals = columns;
  middles.middles = true;
  return brdf::makeCurve(spectral, middles);
}
}

vtkImageData* vtkBRDFSlice::GetOutput()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(0));
}

void vtkBRDFSlice::CopySettings(vtkBRDFSlice* other)
{
  this->CopyChannelSettings(other);
  this->SetAxes(other->Axes);
  this->SetCells(other->Cells);
  this->SetWarp(other->Warp);
  this->SetPhiD(other->PhiD);
  this->SetPhiH(other->PhiH);
  this->SetPhiI(other->PhiI);
  this->SetPhi(other->Phi);
  this->SetThetaI(other->ThetaI);
  this->SetThetaO(other->ThetaO);
  this->SetThetaH(other->ThetaH);
  this->SetThetaD(other->ThetaD);
}

int vtkBRDFSlice::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkImageData");
  return 1;
}

// The rows of a wavelength slice are known by the data only: upstream is updated here, which costs nothing, as it is
// asked for the same whole BRDF afterwards.
int vtkBRDFSlice::RequestInformation(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  int rows = this->Cells[1];
  if (OverWavelength(this->Axes))
  {
    if (vtkAlgorithm* upstream = this->GetInputAlgorithm(0, 0))
    {
      upstream->Update();
    }
    const vtkBRDF* input = vtkBRDF::GetData(inputs[0]);
    rows = input && input->GetBrdf() ? static_cast<int>(input->GetBrdf()->channels().count()) : 1;
  }
  const int extent[6] = { 0, this->Cells[0] - 1, 0, rows - 1, 0, 0 };
  vtkInformation* info = outputs->GetInformationObject(0);
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_DOUBLE, -1);
  return 1;
}

vtkBRDFSlice::Result vtkBRDFSlice::Compute(vtkInformationVector** inputs)
{
  Result result;
  const std::size_t comma = this->Axes.find(',');
  result.AxisNames[0] = this->Axes.substr(0, comma);
  result.AxisNames[1] = comma == std::string::npos ? "" : this->Axes.substr(comma + 1);
  result.Units[0] = result.Units[1] = "deg";
  if (OverWavelength(this->Axes))
  {
    const auto brdf = GetInputBrdf(inputs);
    if (brdf->channels().kind != brdf::Channels::Kind::Spectral)
    {
      throw brdf::Error(brdf::Error::Kind::Value,
                        { "a slice over the wavelength", "axes", brdf->description(), "spectral data" });
    }
    const brdf::CurveOptions options = vtkBRDFAngles::CurveOptions(this, result.AxisNames[0]);
    this->FixedAngles = brdf::fixedAngles(options);
    brdf::Curve curve = AngleCurve(*brdf, options, static_cast<std::size_t>(std::max(this->Cells[0], 0)));
    result.X = InDegrees(curve.angle);
    result.Y = brdf->channels().wavelengths;
    result.Units[1] = Even(result.Y) ? "nm" : "index";
    result.Channels = { "value" };
    result.Values = std::move(curve.values); // planes become rows
    for (std::size_t row = 0; row < result.Y.size(); ++row)
    {
      result.States.insert(result.States.end(), curve.states.begin(), curve.states.end());
    }
    return result;
  }
  brdf::SliceOptions options;
  options.axes = brdf::parseSliceAxes(this->Axes);
  options.phiD = brdf::radians(this->PhiD);
  options.phiH = brdf::radians(this->PhiH);
  options.phiI = brdf::radians(this->PhiI);
  options.phi = brdf::radians(this->Phi);
  options.warp = this->Warp;
  options.columns = static_cast<std::size_t>(std::max(this->Cells[0], 0));
  options.rows = static_cast<std::size_t>(std::max(this->Cells[1], 0));
  this->FixedAngles = brdf::fixedAngles(options);
  const brdf::ChannelChoice choice = this->ChosenChannels(inputs);
  brdf::Slice slice = brdf::makeSlice(*choice.brdf, options);
  if (this->Warp != 1)
  {
    result.Units[0] = "90 deg * (" + result.AxisNames[0] + " / 90 deg)^(1/warp)";
  }
  result.X = InDegrees(slice.x);
  result.Y = InDegrees(slice.y);
  result.Channels = brdf::channelNames(choice.brdf->channels());
  result.Values = std::move(slice.values);
  result.States = std::move(slice.states);
  return result;
}

int vtkBRDFSlice::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const Result result = this->Compute(inputs);
  const auto columns = static_cast<int>(result.X.size()), rows = static_cast<int>(result.Y.size());
  std::fill(std::begin(this->Counts), std::end(this->Counts), 0);
  this->Smallest = std::numeric_limits<double>::infinity();
  this->Largest = -this->Smallest;
  for (std::size_t i = 0; i < result.States.size(); ++i)
  {
    ++this->Counts[result.States[i]];
    for (std::size_t c = 0; c < result.Channels.size() && (result.States[i] == 1 || result.States[i] == 2); ++c)
    {
      this->Smallest = std::min(this->Smallest, result.Values[c * result.States.size() + i]);
      this->Largest = std::max(this->Largest, result.Values[c * result.States.size() + i]);
    }
  }
  if (!(this->Smallest <= this->Largest))
  {
    this->Smallest = this->Largest = 0;
  }
  vtkImageData* output = vtkImageData::GetData(outputs);
  output->SetExtent(0, columns - 1, 0, rows - 1, 0, 0);
  const bool angles = !OverWavelength(this->Axes);
  const double stepX = angles ? 90.0 / columns : (columns > 1 ? result.X[1] - result.X[0] : 1);
  const double stepY = angles ? 90.0 / rows : result.Units[1] == "index" ? 1 : rows > 1 ? result.Y[1] - result.Y[0] : 1;
  output->SetSpacing(stepX, stepY, 1);
  output->SetOrigin(
    angles ? stepX / 2 : result.X[0], angles ? stepY / 2 : (result.Units[1] == "index" ? 0 : result.Y[0]), 0);
  output->GetPointData()->SetScalars(Interleaved("value", result.Values, result.Channels.size()));
  output->GetPointData()->AddArray(Bytes("state", result.States));
  vtkFieldData* fields = output->GetFieldData();
  AddTexts(fields, "axes", { result.AxisNames[0], result.AxisNames[1] });
  AddTexts(fields, "units", { result.Units[0], result.Units[1] });
  AddTexts(fields, "channels", result.Channels);
  fields->AddArray(Numbers("x", result.X));
  fields->AddArray(Numbers("y", result.Y));
  return 1;
}

void vtkBRDFSlice::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Axes: " << this->Axes << "\n"
     << indent << "Cells: " << this->Cells[0] << " " << this->Cells[1] << "\n"
     << indent << "Warp: " << this->Warp << "\n"
     << indent << "PhiD: " << this->PhiD << "\n"
     << indent << "PhiH: " << this->PhiH << "\n"
     << indent << "PhiI: " << this->PhiI << "\n"
     << indent << "Phi: " << this->Phi << "\n"
     << indent << "ThetaI: " << this->ThetaI << "\n"
     << indent << "ThetaO: " << this->ThetaO << "\n"
     << indent << "ThetaH: " << this->ThetaH << "\n"
     << indent << "ThetaD: " << this->ThetaD << "\n";
}
