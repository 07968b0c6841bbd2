#include "vtkBRDFSource.h"

#include "vtkBRDF.h"
#include "vtkObjectFactory.h"

#include <brdf/io/LoadMaterial.h>

vtkStandardNewMacro(vtkBRDFSource);

vtkBRDFSource::vtkBRDFSource()
{
  this->SetNumberOfInputPorts(0);
}

vtkBRDFSource::~vtkBRDFSource() = default;

int vtkBRDFSource::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkBRDF::GetData(outputs)->SetBrdf(brdf::loadMaterial(this->Material).brdf);
  return 1;
}

void vtkBRDFSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Material: " << this->Material << "\n";
}
