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
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <brdf/base/Error.h>
#include <brdf/color/Colorimetry.h>
#include <brdf/view/ChannelChoice.h>
#include <brdf/view/LobeMesh.h>

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkBRDFLobe);

vtkBRDFLobe::vtkBRDFLobe()
{
  this->SetNumberOfInputPorts(2);
}

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
    transformed->SetValue(i, mesh.lengths[i]);
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

// Linear sRGB at full brightness, as a display has it; grey where there is none.
vtkSmartPointer<vtkUnsignedCharArray> TrueColors(const std::vector<double>& planar, vtkIdType count)
{
  auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colors->SetName("rgb");
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double rgb[3] = { planar[i], planar[count + i], planar[2 * count + i] };
    const double largest = std::max({ rgb[0], rgb[1], rgb[2] });
    for (int c = 0; c < 3; ++c)
    {
      const double encoded = largest > 0 ? brdf::encodeSrgb(rgb[c] / largest) : 0.5;
      colors->SetTypedComponent(i, c, static_cast<unsigned char>(std::lround(255 * std::clamp(encoded, 0.0, 1.0))));
    }
  }
  return colors;
}

brdf::LobeShape ParseShape(const std::string& name)
{
  if (name == "value")
  {
    return brdf::LobeShape::Value;
  }
  if (name == "difference")
  {
    return brdf::LobeShape::Difference;
  }
  if (name == "displaced")
  {
    return brdf::LobeShape::Displaced;
  }
  throw brdf::Error(brdf::Error::Kind::Value, { "unknown shape", "lobe", name, "value, difference, displaced" });
}
}

vtkPolyData* vtkBRDFLobe::GetOutput()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(0));
}

int vtkBRDFLobe::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return this->Superclass::FillInputPortInformation(port, info);
}

int vtkBRDFLobe::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPolyData");
  return 1;
}

int vtkBRDFLobe::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const brdf::BrdfPointer brdf = GetInputBrdf(inputs);
  const brdf::ChannelChoice choice = this->ChosenChannels(inputs);
  brdf::LobeMeshOptions options;
  options.thetaI = brdf::radians(this->ThetaI);
  options.phiI = brdf::radians(this->PhiI);
  options.scale = { brdf::parseLobeTransform(this->Transform), this->Floor };
  options.weights = choice.weights;
  options.subdivisions = static_cast<unsigned>(this->Resolution); // a negative one is too large, and refused
  options.tolerance = this->Tolerance;
  options.maximumTriangles = static_cast<std::size_t>(this->MaximumTriangles);
  options.shape = ParseShape(this->Shape);
  brdf::BrdfPointer other;
  if (options.shape != brdf::LobeShape::Value)
  {
    other = this->ChosenChannels(inputs, 1).brdf;
  }
  const brdf::LobeMesh mesh = brdf::makeLobeMesh(*choice.brdf, options, other.get());
  this->MaximumLength = mesh.maximumLength;
  this->ReferenceRadius = mesh.referenceRadius;
  this->ChordError = mesh.chordError;
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  Fill(output, mesh);
  if (!this->Colour.empty())
  {
    const brdf::ChannelChoice seen =
      brdf::chooseChannels(brdf, this->Colour == "true" ? "rgb" : this->Colour, this->ChosenColours());
    std::vector<std::uint8_t> valid;
    const std::vector<double> values =
      brdf::valuesOverHemisphere(*seen.brdf, brdf::fromSpherical(options.thetaI, options.phiI), mesh.directions, valid);
    const auto count = static_cast<vtkIdType>(mesh.vertexCount());
    if (this->Colour == "true")
    {
      output->GetPointData()->AddArray(TrueColors(values, count));
    }
    else
    {
      vtkNew<vtkDoubleArray> colour;
      colour->SetName("colour");
      colour->SetNumberOfTuples(count);
      for (vtkIdType i = 0; i < count; ++i)
      {
        double sum = 0;
        for (std::size_t c = 0; c < seen.weights.size(); ++c)
        {
          sum += seen.weights[c] * values[c * count + i];
        }
        colour->SetValue(i, sum);
      }
      output->GetPointData()->AddArray(colour);
    }
  }
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
     << indent << "MaximumTriangles: " << this->MaximumTriangles << "\n"
     << indent << "Shape: " << this->Shape << "\n"
     << indent << "Transform: " << this->Transform << "\n"
     << indent << "Floor: " << this->Floor << "/sr\n"
     << indent << "Colour: " << this->Colour << "\n";
}
