#include "vtkBRDFHoleMap.h"

#include "vtkBRDF.h"
#include "vtkBRDFArrays.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTypeInt64Array.h"

#include <brdf/view/HoleMap.h>

using namespace vtkBRDFArrays;

vtkStandardNewMacro(vtkBRDFHoleMap);
vtkBRDFHoleMap::vtkBRDFHoleMap() = default;
vtkBRDFHoleMap::~vtkBRDFHoleMap() = default;

int vtkBRDFHoleMap::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkImageData");
  return 1;
}

vtkImageData* vtkBRDFHoleMap::GetOutput()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(0));
}

// An image announces its extent, and only the data know it: upstream is updated here, which costs nothing, as it is
// asked for the same whole BRDF afterwards.
int vtkBRDFHoleMap::RequestInformation(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (vtkAlgorithm* upstream = this->GetInputAlgorithm(0, 0))
  {
    upstream->Update();
  }
  int extent[6] = { 0, -1, 0, -1, 0, -1 };
  if (const vtkBRDF* input = vtkBRDF::GetData(inputs[0]); input && input->GetBrdf())
  {
    const brdf::HoleMap map = brdf::makeHoleMap(*input->GetBrdf(), this->XAxis, this->YAxis);
    extent[1] = static_cast<int>(map.x.nodes.size()) - 1;
    extent[3] = static_cast<int>(map.y.nodes.size()) - 1;
    extent[5] = 0;
  }
  outputs->GetInformationObject(0)->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  return 1;
}

int vtkBRDFHoleMap::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const brdf::HoleMap map = brdf::makeHoleMap(*GetInputBrdf(inputs), this->XAxis, this->YAxis);
  vtkImageData* output = vtkImageData::GetData(outputs);
  output->SetDimensions(static_cast<int>(map.x.nodes.size()), static_cast<int>(map.y.nodes.size()), 1);
  for (std::size_t kind = 0; kind < map.total.size(); ++kind)
  {
    this->Counts[kind] = static_cast<vtkIdType>(map.total[kind]);
    vtkNew<vtkTypeInt64Array> counts;
    counts->SetName(std::string(brdf::HoleMap::kNames[kind]).c_str());
    for (const brdf::HoleMap::Counts& place : map.counts)
    {
      counts->InsertNextValue(static_cast<vtkTypeInt64>(place[kind]));
    }
    output->GetPointData()->AddArray(counts);
  }
  output->GetPointData()->SetActiveScalars(std::string(brdf::HoleMap::kNames[0]).c_str());
  vtkFieldData* fields = output->GetFieldData();
  AddTexts(fields, "axes", { map.x.name, map.y.name });
  AddTexts(fields, "layout", { map.layout });
  fields->AddArray(Numbers("x", map.x.nodes));
  fields->AddArray(Numbers("y", map.y.nodes));
  fields->AddArray(Numbers("x edges", map.x.edges));
  fields->AddArray(Numbers("y edges", map.y.edges));
  return 1;
}

void vtkBRDFHoleMap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "XAxis: " << this->XAxis << "\n" << indent << "YAxis: " << this->YAxis << "\n";
}
