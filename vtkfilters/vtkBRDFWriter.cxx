#include "vtkBRDFWriter.h"

#include "vtkBRDF.h"
#include "vtkObjectFactory.h"

#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/io/SaveMaterial.h>

vtkStandardNewMacro(vtkBRDFWriter);

vtkBRDFWriter::vtkBRDFWriter()
{
  this->SetNumberOfOutputPorts(0);
}

vtkBRDFWriter::~vtkBRDFWriter() = default;

int vtkBRDFWriter::Write()
{
  this->Modified(); // the file may be gone, or another's by now
  return this->UpdateAndCheck();
}

int vtkBRDFWriter::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  this->Losses.clear();
  if (this->FileName.empty())
  {
    throw brdf::Error(brdf::Error::Kind::Usage, { "no file to write", "FileName", {}, {} });
  }
  brdf::LoadedMaterial material;
  material.brdf = GetInputBrdf(inputs);
  material.kind = "pipeline";
  const brdf::WriteReport report = brdf::saveMaterial(material, this->FileName, this->Format, "vtkBRDFWriter");
  this->Losses = brdf::joined(report.losses, "\n");
  return 1;
}

void vtkBRDFWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
  os << indent << "Format: " << this->Format << "\n";
  os << indent << "Losses: " << this->Losses << "\n";
}
