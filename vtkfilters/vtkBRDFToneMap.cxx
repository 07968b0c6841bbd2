#include "vtkBRDFToneMap.h"

#include "vtkBRDFImageConversion.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <brdf/io/ToneMap.h>

#include <algorithm>

vtkStandardNewMacro(vtkBRDFToneMap);

int vtkBRDFToneMap::RequestInformation(vtkInformation*,
                                       vtkInformationVector** vtkNotUsed(inputs),
                                       vtkInformationVector* outputs)
{
  vtkDataObject::SetPointDataActiveScalarInfo(outputs->GetInformationObject(0), VTK_UNSIGNED_CHAR, -1);
  return 1;
}

int vtkBRDFToneMap::RequestUpdateExtent(vtkInformation*,
                                        vtkInformationVector** inputs,
                                        vtkInformationVector* vtkNotUsed(outputs))
{
  vtkInformation* input = inputs[0]->GetInformationObject(0);
  input->Set(
    vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), input->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()), 6);
  return 1;
}

int vtkBRDFToneMap::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* input = vtkImageData::GetData(inputs[0]);
  vtkImageData* output = vtkImageData::GetData(outputs);
  try
  {
    const brdf::Image image = vtkBRDFImageConversion::FromVtk(input);
    const auto codes = brdf::toneMapped(image, this->Exposure, static_cast<brdf::ToneCurve>(this->Curve));
    output->SetExtent(input->GetExtent());
    output->SetSpacing(input->GetSpacing());
    output->SetOrigin(input->GetOrigin());
    output->AllocateScalars(VTK_UNSIGNED_CHAR, static_cast<int>(image.channels));
    auto* to = static_cast<unsigned char*>(output->GetScalarPointer());
    const std::size_t row = image.width * image.channels;
    for (std::size_t y = 0; y < image.height; ++y)
    {
      std::copy_n(codes.data() + (image.height - 1 - y) * row, row, to + y * row);
    }
    return 1;
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    output->Initialize();
    return 0;
  }
}

void vtkBRDFToneMap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Curve: " << this->Curve << "\n" << indent << "Exposure: " << this->Exposure << "\n";
}
