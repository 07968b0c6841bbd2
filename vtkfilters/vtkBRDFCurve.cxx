#include "vtkBRDFCurve.h"

#include "vtkBRDFAngles.h"
#include "vtkBRDFArrays.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include <brdf/base/Error.h>
#include <brdf/view/ChannelChoice.h>
#include <brdf/view/Curve.h>

#include <algorithm>
#include <limits>

using namespace vtkBRDFArrays;

vtkStandardNewMacro(vtkBRDFCurve);
vtkBRDFCurve::vtkBRDFCurve()
{
  this->SetNumberOfOutputPorts(2);
}
vtkBRDFCurve::~vtkBRDFCurve() = default;

int vtkBRDFCurve::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkTable");
  return 1;
}

vtkTable* vtkBRDFCurve::GetOutput(int port)
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(port));
}

namespace
{
// A column of each channel, times the factors.
void AddColumns(vtkTable* table,
                const std::string& prefix,
                const std::vector<std::string>& names,
                const std::vector<double>& planes,
                const std::vector<double>& factors)
{
  for (std::size_t c = 0; c < names.size() && !planes.empty(); ++c)
  {
    std::vector<double> column(factors.size());
    for (std::size_t i = 0; i < factors.size(); ++i)
    {
      column[i] = planes[c * factors.size() + i] * factors[i];
    }
    table->AddColumn(Numbers(prefix + names[c], column));
  }
}
}

int vtkBRDFCurve::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (this->Quantity != "f" && this->Quantity != "f_cos")
  {
    throw brdf::Error(brdf::Error::Kind::Value, { "unknown quantity", "curve", this->Quantity, "f, f_cos" });
  }
  const bool cosine = this->Quantity == "f_cos";
  brdf::CurveOptions options = vtkBRDFAngles::CurveOptions(this, this->Angle);
  options.intervals = static_cast<std::size_t>(std::max(this->Intervals, 0));
  this->FixedAngles = brdf::fixedAngles(options);
  const brdf::ChannelChoice choice = this->ChosenChannels(inputs);
  const std::vector<std::string> names = brdf::channelNames(choice.brdf->channels());

  const brdf::Curve curve = brdf::makeCurve(*choice.brdf, options);
  std::fill(std::begin(this->Counts), std::end(this->Counts), 0);
  std::vector<double> factors(curve.count(), 1);
  for (std::size_t i = 0; i < curve.count(); ++i)
  {
    ++this->Counts[curve.states[i]];
    const bool known = curve.states[i] == 1 || curve.states[i] == 2;
    factors[i] = known ? (cosine ? curve.cosThetaO[i] : 1) : std::numeric_limits<double>::quiet_NaN();
  }
  vtkTable* table = vtkTable::GetData(outputs, 0);
  table->AddColumn(Numbers("angle", InDegrees(curve.angle)));
  AddColumns(table, "", names, curve.values, factors);
  AddColumns(table, "standard error of ", names, curve.standardErrors, factors);
  table->AddColumn(Bytes("state", curve.states));

  brdf::CurveSamples samples;
  if (this->SampleTolerance > 0)
  {
    samples = brdf::samplesByCurve(*choice.brdf, options, brdf::radians(this->SampleTolerance));
  }
  this->LeftOut = static_cast<vtkIdType>(samples.leftOut);
  const std::vector<double> weights = cosine ? samples.cosThetaO : std::vector<double>(samples.count(), 1);
  vtkTable* points = vtkTable::GetData(outputs, 1);
  points->AddColumn(Numbers("angle", InDegrees(samples.angle)));
  AddColumns(points, "", names, samples.values, weights);
  AddColumns(points, "standard error of ", names, samples.standardErrors, weights);
  points->AddColumn(Numbers("distance", InDegrees(samples.distance)));
  return 1;
}

void vtkBRDFCurve::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Angle: " << this->Angle << "\n"
     << indent << "ThetaI: " << this->ThetaI << "\n"
     << indent << "PhiI: " << this->PhiI << "\n"
     << indent << "ThetaO: " << this->ThetaO << "\n"
     << indent << "Phi: " << this->Phi << "\n"
     << indent << "ThetaH: " << this->ThetaH << "\n"
     << indent << "PhiH: " << this->PhiH << "\n"
     << indent << "ThetaD: " << this->ThetaD << "\n"
     << indent << "PhiD: " << this->PhiD << "\n"
     << indent << "Intervals: " << this->Intervals << "\n"
     << indent << "Quantity: " << this->Quantity << "\n"
     << indent << "SampleTolerance: " << this->SampleTolerance << "\n";
}
