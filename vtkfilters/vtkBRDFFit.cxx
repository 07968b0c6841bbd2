#include "vtkBRDFFit.h"

#include "vtkBRDF.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/fit/LobeRequests.h>
#include <brdf/fit/ModelChoice.h>

#include <initializer_list>
#include <limits>
#include <string_view>
#include <utility>

vtkStandardNewMacro(vtkBRDFFit);

vtkBRDFFit::vtkBRDFFit()
{
  this->SetNumberOfOutputPorts(3);
}

vtkBRDFFit::~vtkBRDFFit() = default;

namespace
{
brdf::FitChannels::Kind ChannelsNamed(const std::string& name)
{
  if (name == "native")
  {
    return brdf::FitChannels::Kind::Native;
  }
  if (name == "luminance")
  {
    return brdf::FitChannels::Kind::Luminance;
  }
  if (name == "rgb")
  {
    return brdf::FitChannels::Kind::Rgb;
  }
  throw brdf::Error(brdf::Error::Kind::Value, { "unknown channels", "fit", name, "native, luminance, rgb" });
}

/// The value that `name` stands for in a list; throws with the names allowed.
template<class Value>
Value Named(const char* what, const std::string& name, std::initializer_list<std::pair<const char*, Value>> known)
{
  std::string allowed;
  for (const auto& [text, value] : known)
  {
    if (name == text)
    {
      return value;
    }
    allowed += (allowed.empty() ? "" : ", ") + std::string(text);
  }
  throw brdf::Error(brdf::Error::Kind::Value, { std::string("unknown ") + what, "fit", name, allowed });
}

std::vector<brdf::LobeRequest> Requests(const std::string& lobes, const std::string& constraints)
{
  std::vector<brdf::LobeRequest> requests = brdf::parseLobeRequests(lobes);
  for (const std::string_view text : brdf::split(constraints, ';'))
  {
    if (text.empty())
    {
      continue;
    }
    const bool number = brdf::parseNumber(brdf::trimmed(text.substr(text.find('=') + 1))).has_value();
    number ? brdf::holdParameter(requests, text) : brdf::tieParameter(requests, text);
  }
  return requests;
}

template<class Array, class Value>
void AddField(vtkFieldData* fields, const char* name, const Value& value)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->InsertNextValue(value);
  fields->AddArray(array);
}

void DescribeFit(const brdf::FitReport& report, vtkFieldData* fields)
{
  AddField<vtkDoubleArray>(fields, "error", report.error);
  const auto zero = report.zeroModel.find(report.metric);
  if (zero != report.zeroModel.end())
  {
    AddField<vtkDoubleArray>(fields, "zeroModelError", zero->second);
  }
  AddField<vtkDoubleArray>(fields, "seconds", report.seconds);
  AddField<vtkDoubleArray>(fields, "samples", static_cast<double>(report.samples));
  AddField<vtkIntArray>(fields, "converged", report.converged ? 1 : 0);
  AddField<vtkStringArray>(fields, "termination", report.termination);
  AddField<vtkDoubleArray>(fields, "constantModelError", report.constantError);
  AddField<vtkStringArray>(fields, "metricFormula", report.metricFormula);
  AddField<vtkStringArray>(fields, "sampling", report.sampling);
  AddField<vtkDoubleArray>(fields, "degrees", static_cast<double>(report.degrees));
  AddField<vtkDoubleArray>(fields, "AIC", report.aic);
  AddField<vtkDoubleArray>(fields, "BIC", report.bic);
  if (report.crossValidation)
  {
    AddField<vtkDoubleArray>(fields, "crossValidationError", report.crossValidation->error);
  }
  vtkNew<vtkStringArray> notes;
  notes->SetName("notes");
  for (const std::string& note : report.notes)
  {
    notes->InsertNextValue(note);
  }
  fields->AddArray(notes);
}

template<class Array, class Row, class Value>
void AddColumn(vtkTable* table, const char* name, const std::vector<Row>& rows, const Value& value)
{
  vtkNew<Array> column;
  column->SetName(name);
  for (const Row& row : rows)
  {
    column->InsertNextValue(value(row));
  }
  table->AddColumn(column);
}

void FillRegions(const std::vector<brdf::RegionResidual>& regions, vtkTable* table)
{
  using Region = brdf::RegionResidual;
  AddColumn<vtkStringArray>(table, "region", regions, [](const Region& r) { return r.region; });
  AddColumn<vtkDoubleArray>(table, "samples", regions, [](const Region& r) { return static_cast<double>(r.samples); });
  AddColumn<vtkDoubleArray>(table, "error", regions, [](const Region& r) { return r.error; });
  AddColumn<vtkDoubleArray>(table, "share", regions, [](const Region& r) { return r.share; });
  AddColumn<vtkDoubleArray>(table, "meanDifference", regions, [](const Region& r) { return r.meanDifference; });
  AddColumn<vtkDoubleArray>(table, "relativeMean", regions, [](const Region& r) { return r.relativeMean; });
}

void FillTable(const std::vector<brdf::FittedParameter>& parameters, vtkTable* table)
{
  using Parameter = brdf::FittedParameter;
  AddColumn<vtkStringArray>(table, "lobe", parameters, [](const Parameter& p) { return p.lobe; });
  AddColumn<vtkStringArray>(table, "parameter", parameters, [](const Parameter& p) { return p.name; });
  AddColumn<vtkIntArray>(
    table, "channel", parameters, [](const Parameter& p) { return p.channel ? static_cast<int>(*p.channel) : -1; });
  AddColumn<vtkDoubleArray>(table, "value", parameters, [](const Parameter& p) { return p.value; });
  AddColumn<vtkDoubleArray>(table,
                            "standardError",
                            parameters,
                            [](const Parameter& p)
                            { return p.standardError.value_or(std::numeric_limits<double>::quiet_NaN()); });
  AddColumn<vtkDoubleArray>(table, "minimum", parameters, [](const Parameter& p) { return p.minimum; });
  AddColumn<vtkDoubleArray>(table, "maximum", parameters, [](const Parameter& p) { return p.maximum; });
  AddColumn<vtkIntArray>(table, "atBound", parameters, [](const Parameter& p) { return p.atBound ? 1 : 0; });
  AddColumn<vtkIntArray>(table, "fixed", parameters, [](const Parameter& p) { return p.fixed ? 1 : 0; });
}
}

vtkTable* vtkBRDFFit::GetParameters()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(1));
}

vtkTable* vtkBRDFFit::GetRegions()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(2));
}

int vtkBRDFFit::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkBRDF" : "vtkTable");
  return 1;
}

int vtkBRDFFit::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  brdf::FitOptions options;
  options.metric = this->Metric;
  options.optimizer = this->Optimizer;
  options.channels.kind = ChannelsNamed(this->Channels);
  options.combination = this->PerChannel ? brdf::Combination::PerChannel : brdf::Combination::Shared;
  options.maximumTheta = this->MaximumTheta;
  options.tolerance = this->Tolerance;
  options.starts = static_cast<std::size_t>(this->Starts);
  options.seed = static_cast<std::uint64_t>(this->Seed);
  options.progress = [this, &options](std::size_t iteration, double)
  {
    this->UpdateProgress(static_cast<double>(iteration) / static_cast<double>(options.maximumIterations));
    return !this->GetAbortExecute();
  };
  options.samples.sampling = Named<brdf::Sampling>("sampling",
                                                   this->Sampling,
                                                   { { "automatic", brdf::Sampling::Automatic },
                                                     { "all", brdf::Sampling::All },
                                                     { "hemisphere", brdf::Sampling::Hemisphere },
                                                     { "importance", brdf::Sampling::Importance } });
  options.samples.count = static_cast<std::size_t>(this->NumberOfSamples);
  options.samples.seed = options.seed;
  options.samples.solidAngles = this->SolidAngleWeights;
  options.samples.noise = this->NoiseWeights;
  options.strategy = Named<brdf::Strategy>("strategy",
                                           this->Strategy,
                                           { { "automatic", brdf::Strategy::Automatic },
                                             { "separable", brdf::Strategy::Separable },
                                             { "joint", brdf::Strategy::Joint } });
  options.crossValidation = static_cast<std::size_t>(this->CrossValidation);
  const std::vector<brdf::LobeRequest> requests = Requests(this->Lobes, this->Constraints);
  const brdf::FitReport report = this->Progressive ? brdf::fitProgressively(*GetInputBrdf(inputs), requests, options)
                                                   : brdf::fit(*GetInputBrdf(inputs), requests, options);
  vtkBRDF* output = vtkBRDF::GetData(outputs);
  output->SetBrdf(report.material);
  DescribeFit(report, output->GetFieldData());
  FillTable(report.parameters, vtkTable::GetData(outputs, 1));
  FillRegions(report.regions, vtkTable::GetData(outputs, 2));
  return 1;
}

void vtkBRDFFit::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Lobes: " << this->Lobes << "\n"
     << indent << "Metric: " << this->Metric << "\n"
     << indent << "Optimizer: " << this->Optimizer << "\n"
     << indent << "Sampling: " << this->Sampling << "\n"
     << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n"
     << indent << "SolidAngleWeights: " << this->SolidAngleWeights << "\n"
     << indent << "NoiseWeights: " << this->NoiseWeights << "\n"
     << indent << "Strategy: " << this->Strategy << "\n"
     << indent << "Constraints: " << this->Constraints << "\n"
     << indent << "Progressive: " << this->Progressive << "\n"
     << indent << "CrossValidation: " << this->CrossValidation << "\n"
     << indent << "Channels: " << this->Channels << "\n"
     << indent << "PerChannel: " << this->PerChannel << "\n"
     << indent << "MaximumTheta: " << this->MaximumTheta << " degrees\n"
     << indent << "Tolerance: " << this->Tolerance << "\n"
     << indent << "Starts: " << this->Starts << "\n"
     << indent << "Seed: " << this->Seed << "\n";
}
