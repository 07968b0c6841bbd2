#include "vtkBRDFWriter.h"

#include "vtkBRDF.h"
#include "vtkObjectFactory.h"

#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/io/Container.h>
#include <brdf/io/SaveMaterial.h>

#include <filesystem>

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
  if (!this->Entry.empty())
  {
    this->AddEntry(*GetInputBrdf(inputs));
    return 1;
  }
  brdf::LoadedMaterial material;
  material.brdf = GetInputBrdf(inputs);
  material.kind = "pipeline";
  const brdf::WriteReport report = brdf::saveMaterial(material, this->FileName, this->Format, "vtkBRDFWriter");
  this->Losses = brdf::joined(report.losses, "\n");
  return 1;
}

void vtkBRDFWriter::AddEntry(const brdf::Brdf& brdf)
{
  const bool byExtension = this->Format.empty() && std::filesystem::path(this->FileName).extension() == ".vtkhdf";
  if (!byExtension && this->Format != "vtkhdf")
  {
    throw brdf::Error(brdf::Error::Kind::Usage,
                      { "only a container has entries by name", this->FileName, this->Entry, "a .vtkhdf file" });
  }
  brdf::ContainerWriter writer(this->FileName, brdf::ContainerWriter::Mode::Append);
  writer.add(this->Entry, brdf, brdf::makeProvenance({}, "vtkBRDFWriter"));
  writer.commit();
}

void vtkBRDFWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
  os << indent << "Format: " << this->Format << "\n";
  os << indent << "Entry: " << this->Entry << "\n";
  os << indent << "Losses: " << this->Losses << "\n";
}
