#include "vtkBRDFErrorMap.h"

#include "vtkBRDF.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"
#include "vtkTypeInt64Array.h"

#include <brdf/view/ChannelChoice.h>
#include <brdf/view/ErrorMap.h>
#include <brdf/view/Histogram.h>

#include <algorithm>

vtkStandardNewMacro(vtkBRDFErrorMap);

namespace
{
vtkSmartPointer<vtkDoubleArray> Numbers(const char* name, const std::vector<double>& numbers)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(numbers.size()));
  std::copy(numbers.begin(), numbers.end(), array->GetPointer(0));
  return array;
}
}

vtkBRDFErrorMap::vtkBRDFErrorMap()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
}

vtkBRDFErrorMap::~vtkBRDFErrorMap() = default;

vtkImageData* vtkBRDFErrorMap::GetOutput()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(0));
}

vtkTable* vtkBRDFErrorMap::GetHistogram()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(1));
}

vtkTable* vtkBRDFErrorMap::GetWorst()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(2));
}

int vtkBRDFErrorMap::GetNumberOfChannels() const
{
  return static_cast<int>(this->ChannelMeans.size());
}

double vtkBRDFErrorMap::GetChannelMean(int index) const
{
  return index >= 0 && index < this->GetNumberOfChannels() ? this->ChannelMeans[index] : 0;
}

double vtkBRDFErrorMap::GetQuantile(double share) const
{
  return this->Errors ? this->Errors->quantile(share) : 0;
}

int vtkBRDFErrorMap::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkImageData" : "vtkTable");
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
           ? static_cast<int>(brdf::automaticIntervals(*inputs[0]->GetBrdf(),
                                                       *inputs[1]->GetBrdf(),
                                                       brdf::parseErrorAxes(this->Axes),
                                                       brdf::parseErrorDirections(this->Directions)))
           : this->Intervals;
}

int vtkBRDFErrorMap::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  const int extent[6] = { 0, this->Intervals, 0, this->Intervals, 0, 0 };
  const auto [x, y] = brdf::ErrorGrid{ .axes = brdf::parseErrorAxes(this->Axes) }.ranges();
  const double spacing[3] = { (x.high - x.low) / this->Intervals, (y.high - y.low) / this->Intervals, 1 };
  const double origin[3] = { x.low, y.low, 0 };
  vtkInformation* info = outputs->GetInformationObject(0);
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(vtkDataObject::SPACING(), spacing, 3);
  info->Set(vtkDataObject::ORIGIN(), origin, 3);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_DOUBLE, 1);
  return 1;
}

int vtkBRDFErrorMap::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const brdf::ChannelChoice a = this->ChosenChannels(inputs, 0);
  const brdf::ChannelChoice b = this->ChosenChannels(inputs, 1);
  brdf::ErrorMapOptions options;
  options.measure = brdf::parseErrorMeasure(this->Measure, this->Average);
  options.grid.axes = brdf::parseErrorAxes(this->Axes);
  options.grid.intervals = static_cast<std::size_t>(this->Intervals);
  options.grid.thetaI = brdf::radians(this->ThetaI);
  options.grid.phiI = brdf::radians(this->PhiI);
  options.grid.projection = brdf::parseDiskProjection(this->Projection);
  options.grid.within = brdf::radians(this->SampleAngle);
  options.azimuths = static_cast<std::size_t>(std::max(this->Azimuths, 0));
  options.directions = brdf::parseErrorDirections(this->Directions);
  options.worst = static_cast<std::size_t>(this->NumberOfWorst);
  const brdf::ErrorMap map = brdf::makeErrorMap(*a.brdf, *b.brdf, options);
  this->OverallMean = map.overallMean;
  this->ChannelMeans = map.channelOverall;
  this->Largest = map.largest;
  this->Sampling = map.sampling;
  this->Quantity = brdf::errorMeasureLabel(options.measure);
  this->PairQuantity = brdf::errorTermLabel(options.measure);
  this->Signed = options.measure.average == brdf::ErrorAverage::Signed;
  this->NumberOfPairs = static_cast<vtkIdType>(map.errors.size());
  this->NumberLeftOut = static_cast<vtkIdType>(map.leftOut);
  this->FillImage(outputs, map);
  this->FillHistogram(outputs, map);
  this->FillWorst(outputs, map);
  return 1;
}

void vtkBRDFErrorMap::FillImage(vtkInformationVector* outputs, const brdf::ErrorMap& map)
{
  vtkImageData* output = vtkImageData::GetData(outputs, 0);
  const auto [x, y] = map.grid.ranges();
  output->SetExtent(0, this->Intervals, 0, this->Intervals, 0, 0);
  output->SetOrigin(x.low, y.low, 0);
  output->SetSpacing((x.high - x.low) / this->Intervals, (y.high - y.low) / this->Intervals, 1);
  output->GetPointData()->SetScalars(Numbers("error", map.mean));
  vtkNew<vtkTypeInt64Array> count;
  count->SetName("count");
  count->SetNumberOfTuples(static_cast<vtkIdType>(map.count.size()));
  std::copy(map.count.begin(), map.count.end(), count->GetPointer(0));
  output->GetPointData()->AddArray(count);
  if (map.channelMean.empty())
  {
    return;
  }
  const auto channels = static_cast<int>(map.channelOverall.size());
  const auto nodes = static_cast<vtkIdType>(map.mean.size());
  vtkNew<vtkDoubleArray> byChannel;
  byChannel->SetName("channel_error");
  byChannel->SetNumberOfComponents(channels);
  byChannel->SetNumberOfTuples(nodes);
  for (int c = 0; c < channels; ++c)
  {
    for (vtkIdType node = 0; node < nodes; ++node)
    {
      byChannel->SetTypedComponent(node, c, map.channelMean[c * nodes + node]);
    }
  }
  output->GetPointData()->AddArray(byChannel);
}

void vtkBRDFErrorMap::FillHistogram(vtkInformationVector* outputs, const brdf::ErrorMap& map)
{
  const brdf::Histogram histogram =
    brdf::makeHistogram(map.errors, map.weights, static_cast<std::size_t>(this->NumberOfBins));
  const std::size_t bins = histogram.count.size();
  vtkTable* table = vtkTable::GetData(outputs, 1);
  table->AddColumn(Numbers("low", { histogram.edges.begin(), histogram.edges.begin() + bins }));
  table->AddColumn(Numbers("high", { histogram.edges.end() - bins, histogram.edges.end() }));
  vtkNew<vtkTypeInt64Array> count;
  count->SetName("count");
  count->SetNumberOfTuples(static_cast<vtkIdType>(bins));
  std::copy(histogram.count.begin(), histogram.count.end(), count->GetPointer(0));
  table->AddColumn(count);
  table->AddColumn(Numbers("share", histogram.share));
  this->Errors = std::make_unique<brdf::Distribution>(map.errors, map.weights);
}

void vtkBRDFErrorMap::FillWorst(vtkInformationVector* outputs, const brdf::ErrorMap& map)
{
  const std::size_t channels = map.channelOverall.size(), rows = map.worst.size();
  vtkTable* table = vtkTable::GetData(outputs, 2);
  const auto add = [&](const std::string& name, const auto& number)
  {
    std::vector<double> column;
    for (const brdf::WorstPair& one : map.worst)
    {
      column.push_back(number(one));
    }
    table->AddColumn(Numbers(name.c_str(), column));
  };
  const auto theta = [](const brdf::Direction& w) { return brdf::degrees(brdf::toSpherical(w).theta); };
  const auto phi = [](const brdf::Direction& w) { return brdf::degrees(brdf::toSpherical(w).phi); };
  add("error", [](const brdf::WorstPair& one) { return one.error; });
  add("theta_i", [&](const brdf::WorstPair& one) { return theta(one.pair.wi); });
  add("phi_i", [&](const brdf::WorstPair& one) { return phi(one.pair.wi); });
  add("theta_o", [&](const brdf::WorstPair& one) { return theta(one.pair.wo); });
  add("phi_o", [&](const brdf::WorstPair& one) { return phi(one.pair.wo); });
  for (std::size_t c = 0; c < channels && rows > 0; ++c)
  {
    add("a_" + std::to_string(c), [&](const brdf::WorstPair& one) { return one.a[c]; });
  }
  for (std::size_t c = 0; c < channels && rows > 0; ++c)
  {
    add("b_" + std::to_string(c), [&](const brdf::WorstPair& one) { return one.b[c]; });
  }
  const auto [x, y] = map.grid.ranges();
  const std::size_t nodes = map.grid.nodes();
  const auto intervals = static_cast<double>(map.grid.intervals);
  add("x", [&](const brdf::WorstPair& one) { return x.low + (one.node % nodes) * (x.high - x.low) / intervals; });
  add("y", [&](const brdf::WorstPair& one) { return y.low + (one.node / nodes) * (y.high - y.low) / intervals; });
}

void vtkBRDFErrorMap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Measure: " << this->Measure << "\n"
     << indent << "Average: " << this->Average << "\n"
     << indent << "Axes: " << this->Axes << "\n"
     << indent << "ThetaI: " << this->ThetaI << " degrees\n"
     << indent << "PhiI: " << this->PhiI << " degrees\n"
     << indent << "Projection: " << this->Projection << "\n"
     << indent << "SampleAngle: " << this->SampleAngle << " degrees\n"
     << indent << "Intervals: " << this->Intervals << "\n"
     << indent << "Azimuths: " << this->Azimuths << "\n"
     << indent << "Directions: " << this->Directions << "\n"
     << indent << "NumberOfWorst: " << this->NumberOfWorst << "\n"
     << indent << "NumberOfBins: " << this->NumberOfBins << "\n";
}
