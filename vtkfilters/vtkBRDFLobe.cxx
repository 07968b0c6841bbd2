#include "vtkBRDFLobe.h"

#include "vtkBRDF.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <brdf/base/Error.h>
#include <brdf/view/ChannelChoice.h>
#include <brdf/view/LobeMesh.h>

#include <algorithm>

vtkStandardNewMacro(vtkBRDFLobe);
vtkBRDFLobe::vtkBRDFLobe() = default;
vtkBRDFLobe::~vtkBRDFLobe() = default;

namespace
{
void Fill(vtkPolyData* output, const brdf::LobeMesh& mesh)
{
  const auto count = static_cast<vtkIdType>(mesh.vertexCount());
  const auto channels = static_cast<int>(mesh.values.size() / std::max<std::size_t>(mesh.vertexCount(), 1));
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  vtkNew<vtkDoubleArray> value;
  value->SetName("value");
  value->SetNumberOfComponents(channels);
  value->SetNumberOfTuples(count);
  vtkNew<vtkDoubleArray> transformed;
  transformed->SetName("transformed");
  transformed->SetNumberOfTuples(count);
  vtkNew<vtkUnsignedCharArray> valid;
  valid->SetName("valid");
  valid->SetNumberOfTuples(count);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    points->SetPoint(i, mesh.position(i).data());
    for (int c = 0; c < channels; ++c)
    {
      value->SetTypedComponent(i, c, mesh.values[c * count + i]);
    }
    transformed->SetValue(i, mesh.radii[i]);
    valid->SetValue(i, mesh.valid[i]);
    normals->SetTuple(i, mesh.normals[i].data());
  }
  vtkNew<vtkCellArray> triangles;
  triangles->AllocateExact(mesh.triangles.size(), 3 * mesh.triangles.size());
  for (const auto& triangle : mesh.triangles)
  {
    triangles->InsertNextCell({ triangle[0], triangle[1], triangle[2] });
  }
  output->SetPoints(points);
  output->SetPolys(triangles);
  output->GetPointData()->AddArray(value);
  output->GetPointData()->AddArray(valid);
  output->GetPointData()->SetScalars(transformed);
  output->GetPointData()->SetNormals(normals);
}
}

vtkPolyData* vtkBRDFLobe::GetOutput()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(0));
}

int vtkBRDFLobe::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPolyData");
  return 1;
}

int vtkBRDFLobe::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const brdf::ChannelChoice choice = brdf::chooseChannels(
    GetInputBrdf(inputs), this->Channel, brdf::colourSettings({ this->Illuminant, this->Observer, this->Adaptation }));
  brdf::LobeMeshOptions options;
  options.thetaI = brdf::radians(this->ThetaI);
  options.phiI = brdf::radians(this->PhiI);
  options.transform = brdf::parseLobeTransform(this->Transform);
  options.weights = choice.weights;
  options.subdivisions = static_cast<unsigned>(this->Resolution); // a negative one is too large, and refused
  options.tolerance = this->Tolerance;
  const brdf::LobeMesh mesh = brdf::makeLobeMesh(*choice.brdf, options);
  this->MaximumLength = mesh.maximumRadius;
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  Fill(output, mesh);
  output->GetFieldData()->ShallowCopy(vtkBRDF::GetData(inputs[0])->GetFieldData());
  return 1;
}

void vtkBRDFLobe::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ThetaI: " << this->ThetaI << " degrees\n"
     << indent << "PhiI: " << this->PhiI << " degrees\n"
     << indent << "Resolution: " << this->Resolution << "\n"
     << indent << "Tolerance: " << this->Tolerance << "\n"
     << indent << "Transform: " << this->Transform << "\n"
     << indent << "Illuminant: " << this->Illuminant << "\n"
     << indent << "Observer: " << this->Observer << "\n"
     << indent << "Adaptation: " << this->Adaptation << "\n"
     << indent << "Channel: " << this->Channel << "\n";
}
