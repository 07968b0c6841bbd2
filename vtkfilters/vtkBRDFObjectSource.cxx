#include "vtkBRDFObjectSource.h"

#include "vtkBRDFParametricShapes.h"
#include "vtkBRDFSurface.h"
#include "vtkBRDFSurfaceFiles.h"

#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/render/Shapes.h>

#include <algorithm>
#include <vector>

vtkStandardNewMacro(vtkBRDFObjectSource);

namespace
{
std::vector<std::string> ShapeNames()
{
  std::vector<std::string> names{ "sphere" };
  for (const brdf::ShapeName& shape : brdf::shapeNames())
  {
    names.emplace_back(shape.name);
  }
  for (const std::string& name : vtkBRDFParametricShapes::Names())
  {
    names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

vtkSmartPointer<vtkPolyData> Make(const std::string& object)
{
  if (object.find('.') != std::string::npos)
  {
    return vtkBRDFSurface::Complete(vtkBRDFSurfaceFiles::Read(object));
  }
  if (object == "sphere")
  {
    return vtkBRDFSurface::UnitSphere();
  }
  if (const auto mesh = brdf::makeShape(object))
  {
    return vtkBRDFSurface::FromMesh(*mesh);
  }
  if (const auto mesh = vtkBRDFParametricShapes::Make(object))
  {
    return vtkBRDFSurface::FromMesh(*mesh);
  }
  throw brdf::Error(brdf::Error::Kind::Value,
                    { "unknown object",
                      {},
                      "'" + object + "'",
                      brdf::joined(ShapeNames()) + ", or a file: " + vtkBRDFSurfaceFiles::Endings() });
}
}

vtkBRDFObjectSource::vtkBRDFObjectSource()
{
  this->SetNumberOfInputPorts(0);
}

std::string vtkBRDFObjectSource::GetShapeNames()
{
  std::string text;
  for (const std::string& name : ShapeNames())
  {
    text += (text.empty() ? "" : " ") + name;
  }
  return text;
}

int vtkBRDFObjectSource::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  this->ErrorText.clear();
  try
  {
    output->ShallowCopy(Make(this->Object));
    return 1;
  }
  catch (const std::exception& error)
  {
    this->ErrorText = error.what();
    output->Initialize();
    vtkErrorMacro(<< this->ErrorText);
    return 0;
  }
}

void vtkBRDFObjectSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Object: " << this->Object << "\n" << indent << "ErrorText: " << this->ErrorText << "\n";
}
