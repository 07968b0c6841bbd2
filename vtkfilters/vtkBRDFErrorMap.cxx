#include "vtkBRDFErrorMap.h"

#include "vtkBRDF.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTypeInt64Array.h"

#include <brdf/view/ChannelChoice.h>
#include <brdf/view/ErrorMap.h>

#include <algorithm>

vtkStandardNewMacro(vtkBRDFErrorMap);

vtkBRDFErrorMap::vtkBRDFErrorMap()
{
  this->SetNumberOfInputPorts(2);
}

vtkBRDFErrorMap::~vtkBRDFErrorMap() = default;

vtkImageData* vtkBRDFErrorMap::GetOutput()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(0));
}

int vtkBRDFErrorMap::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkImageData");
  return 1;
}

int vtkBRDFErrorMap::SuggestIntervals()
{
  vtkBRDF* inputs[2] = { nullptr, nullptr };
  for (int port = 0; port < 2; ++port)
  {
    if (vtkAlgorithm* source = this->GetInputAlgorithm(port, 0))
    {
      source->Update();
      inputs[port] = vtkBRDF::SafeDownCast(this->GetInputDataObject(port, 0));
    }
  }
  return inputs[0] && inputs[1] && inputs[0]->GetBrdf() && inputs[1]->GetBrdf()
           ? static_cast<int>(brdf::automaticIntervals(*inputs[0]->GetBrdf(), *inputs[1]->GetBrdf(), this->OnSamples))
           : this->Intervals;
}

int vtkBRDFErrorMap::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  const int extent[6] = { 0, this->Intervals, 0, this->Intervals, 0, 0 };
  const double spacing[3] = { 90.0 / this->Intervals, 90.0 / this->Intervals, 1 };
  const double origin[3] = { 0, 0, 0 };
  vtkInformation* info = outputs->GetInformationObject(0);
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(vtkDataObject::SPACING(), spacing, 3);
  info->Set(vtkDataObject::ORIGIN(), origin, 3);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_DOUBLE, 1);
  return 1;
}

int vtkBRDFErrorMap::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const brdf::ColourSettings colour = brdf::colourSettings({ this->Illuminant, this->Observer, this->Adaptation });
  const brdf::ChannelChoice a = brdf::chooseChannels(GetInputBrdf(inputs, 0), this->Channel, colour);
  const brdf::ChannelChoice b = brdf::chooseChannels(GetInputBrdf(inputs, 1), this->Channel, colour);
  brdf::ErrorMapOptions options;
  options.measure = brdf::parseErrorMeasure(this->Measure);
  options.axes = brdf::parseErrorAxes(this->Axes);
  options.intervals = static_cast<std::size_t>(this->Intervals);
  options.azimuths = static_cast<std::size_t>(std::max(this->Azimuths, 0));
  options.onSamples = this->OnSamples;
  const brdf::ErrorMap map = brdf::makeErrorMap(*a.brdf, *b.brdf, options);
  this->OverallMean = map.overallMean;
  this->Largest = map.largest;
  this->Sampling = map.sampling;
  this->Quantity = brdf::errorMeasureLabel(options.measure);

  vtkImageData* output = vtkImageData::GetData(outputs);
  output->SetExtent(0, this->Intervals, 0, this->Intervals, 0, 0);
  output->SetSpacing(90.0 / this->Intervals, 90.0 / this->Intervals, 1);
  vtkNew<vtkDoubleArray> error;
  error->SetName("error");
  error->SetNumberOfTuples(static_cast<vtkIdType>(map.mean.size()));
  std::copy(map.mean.begin(), map.mean.end(), error->GetPointer(0));
  vtkNew<vtkTypeInt64Array> count;
  count->SetName("count");
  count->SetNumberOfTuples(static_cast<vtkIdType>(map.count.size()));
  std::copy(map.count.begin(), map.count.end(), count->GetPointer(0));
  output->GetPointData()->SetScalars(error);
  output->GetPointData()->AddArray(count);
  return 1;
}

void vtkBRDFErrorMap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Measure: " << this->Measure << "\n"
     << indent << "Axes: " << this->Axes << "\n"
     << indent << "Illuminant: " << this->Illuminant << "\n"
     << indent << "Observer: " << this->Observer << "\n"
     << indent << "Adaptation: " << this->Adaptation << "\n"
     << indent << "Channel: " << this->Channel << "\n"
     << indent << "Intervals: " << this->Intervals << "\n"
     << indent << "Azimuths: " << this->Azimuths << "\n"
     << indent << "OnSamples: " << this->OnSamples << "\n";
}
