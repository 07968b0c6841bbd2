#include "vtkBRDFLobeSamples.h"

#include "vtkBRDF.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <brdf/view/ChannelChoice.h>
#include <brdf/view/LobeSamples.h>

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkBRDFLobeSamples);

vtkBRDFLobeSamples::vtkBRDFLobeSamples()
{
  this->SetNumberOfInputPorts(2);
}

vtkBRDFLobeSamples::~vtkBRDFLobeSamples() = default;

namespace
{
void AddArray(vtkPolyData* output, const char* name, const std::vector<double>& numbers)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(numbers.size()));
  std::copy(numbers.begin(), numbers.end(), array->GetPointer(0));
  output->GetPointData()->AddArray(array);
  output->GetPointData()->SetActiveScalars(name);
}

double Largest(const std::vector<double>& numbers)
{
  double largest = 0;
  for (double number : numbers)
  {
    largest = std::max(largest, std::abs(number));
  }
  return largest;
}
}

vtkPolyData* vtkBRDFLobeSamples::GetOutput()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(0));
}

int vtkBRDFLobeSamples::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return this->Superclass::FillInputPortInformation(port, info);
}

int vtkBRDFLobeSamples::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPolyData");
  return 1;
}

int vtkBRDFLobeSamples::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const brdf::ChannelChoice measured = this->ChosenChannels(inputs);
  brdf::LobeSampleOptions options;
  options.thetaI = brdf::radians(this->ThetaI);
  options.phiI = brdf::radians(this->PhiI);
  options.within = brdf::radians(this->Within);
  options.scale = { brdf::parseLobeTransform(this->Transform), this->Floor };
  options.weights = measured.weights;
  options.maximum = static_cast<std::size_t>(this->MaximumPoints);
  brdf::BrdfPointer model;
  if (inputs[1]->GetNumberOfInformationObjects() > 0)
  {
    model = this->ChosenChannels(inputs, 1).brdf;
  }
  const brdf::LobeSamples samples = brdf::lobeSamples(*measured.brdf, options, model.get());
  this->NumberFound = static_cast<vtkIdType>(samples.found);
  this->Nearest = brdf::degrees(samples.nearest);
  this->MaximumLength = Largest(samples.lengths);
  this->MaximumResidual = Largest(samples.residuals);

  vtkPolyData* output = vtkPolyData::GetData(outputs);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  for (std::size_t i = 0; i < samples.directions.size(); ++i)
  {
    const brdf::Direction& wo = samples.directions[i];
    const double length = samples.lengths[i];
    vertices->InsertNextCell({ points->InsertNextPoint(length * wo[0], length * wo[1], length * wo[2]) });
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  AddArray(output, "value", samples.values);
  AddArray(output, "transformed", samples.lengths);
  if (model)
  {
    AddArray(output, "residual", samples.residuals);
  }
  return 1;
}

void vtkBRDFLobeSamples::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ThetaI: " << this->ThetaI << " degrees\n"
     << indent << "PhiI: " << this->PhiI << " degrees\n"
     << indent << "Within: " << this->Within << " degrees\n"
     << indent << "MaximumPoints: " << this->MaximumPoints << "\n"
     << indent << "Transform: " << this->Transform << "\n"
     << indent << "Floor: " << this->Floor << "/sr\n";
}
