#include "vtkBRDFEXRWriter.h"

#include "vtkBRDFImageConversion.h"

#include "vtkInformation.h"
#include "vtkObjectFactory.h"

#include <brdf/io/ImageFile.h>

vtkStandardNewMacro(vtkBRDFEXRWriter);

int vtkBRDFEXRWriter::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkBRDFEXRWriter::Write()
{
  this->ErrorText.clear();
  return this->Superclass::Write() && this->ErrorText.empty();
}

void vtkBRDFEXRWriter::WriteData()
{
  try
  {
    auto* picture = vtkImageData::SafeDownCast(this->GetInput());
    brdf::writeExr(vtkBRDFImageConversion::FromVtk(picture), this->FileName);
  }
  catch (const std::exception& error)
  {
    this->ErrorText = error.what();
    vtkErrorMacro(<< this->ErrorText);
  }
}

void vtkBRDFEXRWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n" << indent << "ErrorText: " << this->ErrorText << "\n";
}
