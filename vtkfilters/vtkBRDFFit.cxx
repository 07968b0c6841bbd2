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
#include <brdf/fit/LobeRequests.h>

#include <limits>

vtkStandardNewMacro(vtkBRDFFit);

vtkBRDFFit::vtkBRDFFit()
{
  this->SetNumberOfOutputPorts(2);
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
}

template<class Array, class Value>
void AddColumn(vtkTable* table, const char* name, const brdf::FitReport& report, const Value& value)
{
  vtkNew<Array> column;
  column->SetName(name);
  for (const brdf::FittedParameter& parameter : report.parameters)
  {
    column->InsertNextValue(value(parameter));
  }
  table->AddColumn(column);
}

void FillTable(const brdf::FitReport& report, vtkTable* table)
{
  using Parameter = brdf::FittedParameter;
  AddColumn<vtkStringArray>(table, "lobe", report, [](const Parameter& p) { return p.lobe; });
  AddColumn<vtkStringArray>(table, "parameter", report, [](const Parameter& p) { return p.name; });
  AddColumn<vtkIntArray>(
    table, "channel", report, [](const Parameter& p) { return p.channel ? static_cast<int>(*p.channel) : -1; });
  AddColumn<vtkDoubleArray>(table, "value", report, [](const Parameter& p) { return p.value; });
  AddColumn<vtkDoubleArray>(table,
                            "standardError",
                            report,
                            [](const Parameter& p)
                            { return p.standardError.value_or(std::numeric_limits<double>::quiet_NaN()); });
  AddColumn<vtkDoubleArray>(table, "minimum", report, [](const Parameter& p) { return p.minimum; });
  AddColumn<vtkDoubleArray>(table, "maximum", report, [](const Parameter& p) { return p.maximum; });
  AddColumn<vtkIntArray>(table, "atBound", report, [](const Parameter& p) { return p.atBound ? 1 : 0; });
  AddColumn<vtkIntArray>(table, "fixed", report, [](const Parameter& p) { return p.fixed ? 1 : 0; });
}
}

vtkTable* vtkBRDFFit::GetParameters()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(1));
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
  const brdf::FitReport report = brdf::fit(*GetInputBrdf(inputs), brdf::parseLobeRequests(this->Lobes), options);
  vtkBRDF* output = vtkBRDF::GetData(outputs);
  output->SetBrdf(report.material);
  DescribeFit(report, output->GetFieldData());
  FillTable(report, vtkTable::GetData(outputs, 1));
  return 1;
}

void vtkBRDFFit::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Lobes: " << this->Lobes << "\n"
     << indent << "Metric: " << this->Metric << "\n"
     << indent << "Optimizer: " << this->Optimizer << "\n"
     << indent << "Channels: " << this->Channels << "\n"
     << indent << "PerChannel: " << this->PerChannel << "\n"
     << indent << "MaximumTheta: " << this->MaximumTheta << " degrees\n"
     << indent << "Tolerance: " << this->Tolerance << "\n"
     << indent << "Starts: " << this->Starts << "\n"
     << indent << "Seed: " << this->Seed << "\n";
}
