#include "vtkBRDFAlgorithm.h"

#include "vtkBRDF.h"
#include "vtkBRDFMicrosurface.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <brdf/base/Error.h>

#include <cstring>

using vtkSDDP = vtkStreamingDemandDrivenPipeline;

namespace
{
// What every rank has whole.
bool IsShared(vtkDataObject* data)
{
  return vtkBRDF::SafeDownCast(data) || vtkBRDFMicrosurface::SafeDownCast(data);
}
}

vtkBRDFAlgorithm::vtkBRDFAlgorithm()
{
  this->SetNumberOfInputPorts(1);
  this->SetNumberOfOutputPorts(1);
}

vtkBRDFAlgorithm::~vtkBRDFAlgorithm() = default;

vtkBRDF* vtkBRDFAlgorithm::GetOutput()
{
  return vtkBRDF::SafeDownCast(this->GetOutputDataObject(0));
}

bool vtkBRDFAlgorithm::UpdateAndCheck()
{
  return this->GetExecutive()->Update() != 0;
}

std::string vtkBRDFAlgorithm::GetPipelineErrorText()
{
  if (!this->ErrorText.empty())
  {
    return this->ErrorText;
  }
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    for (int connection = 0; connection < this->GetNumberOfInputConnections(port); ++connection)
    {
      if (auto* upstream = vtkBRDFAlgorithm::SafeDownCast(this->GetInputAlgorithm(port, connection)))
      {
        std::string text = upstream->GetPipelineErrorText();
        if (!text.empty())
        {
          return text;
        }
      }
    }
  }
  return {};
}

int vtkBRDFAlgorithm::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkBRDF");
  return 1;
}

int vtkBRDFAlgorithm::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkBRDF");
  return 1;
}

int vtkBRDFAlgorithm::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*)
{
  return 1;
}

std::shared_ptr<const brdf::Brdf> vtkBRDFAlgorithm::GetInputBrdf(vtkInformationVector** inputs, int port)
{
  vtkBRDF* input = vtkBRDF::GetData(inputs[port]);
  if (!input || !input->GetBrdf())
  {
    throw brdf::Error(
      brdf::Error::Kind::Value,
      { "no BRDF", "input port " + std::to_string(port), input ? "an empty vtkBRDF" : "nothing", "a vtkBRDF" });
  }
  return input->GetBrdf();
}

int vtkBRDFAlgorithm::CreateOutputs(vtkInformationVector* outputs)
{
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    // Types that VTK knows are made by the executive itself.
    vtkInformation* info = outputs->GetInformationObject(port);
    const char* type = this->GetOutputPortInformation(port)->Get(vtkDataObject::DATA_TYPE_NAME());
    if (type && std::strcmp(type, "vtkBRDF") == 0 && !vtkBRDF::GetData(info))
    {
      vtkNew<vtkBRDF> output;
      info->Set(vtkDataObject::DATA_OBJECT(), output);
    }
    if (type && std::strcmp(type, "vtkBRDFMicrosurface") == 0 && !vtkBRDFMicrosurface::GetData(info))
    {
      vtkNew<vtkBRDFMicrosurface> output;
      info->Set(vtkDataObject::DATA_OBJECT(), output);
    }
  }
  return 1;
}

int vtkBRDFAlgorithm::AskForWholeInputs(vtkInformationVector** inputs)
{
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    for (int connection = 0; connection < this->GetNumberOfInputConnections(port); ++connection)
    {
      vtkInformation* info = inputs[port]->GetInformationObject(connection);
      info->Set(vtkSDDP::UPDATE_PIECE_NUMBER(), 0);
      info->Set(vtkSDDP::UPDATE_NUMBER_OF_PIECES(), 1);
      info->Set(vtkSDDP::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
      if (info->Has(vtkSDDP::WHOLE_EXTENT()))
      {
        info->Set(vtkSDDP::UPDATE_EXTENT(), info->Get(vtkSDDP::WHOLE_EXTENT()), 6);
      }
    }
  }
  return 1;
}

int vtkBRDFAlgorithm::Execute(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  bool makesShared = false;
  bool otherRank = false;
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    makesShared = makesShared || IsShared(vtkDataObject::GetData(outputs, port));
    otherRank = otherRank || outputs->GetInformationObject(port)->Get(vtkSDDP::UPDATE_PIECE_NUMBER()) > 0;
  }
  const int result = otherRank && !makesShared ? 1 : this->RequestData(request, inputs, outputs);
  for (int port = 0; port < outputs->GetNumberOfInformationObjects() && otherRank; ++port)
  {
    vtkDataObject* output = vtkDataObject::GetData(outputs, port);
    if (output && !IsShared(output))
    {
      output->Initialize();
    }
  }
  return result;
}

vtkTypeBool vtkBRDFAlgorithm::ProcessRequest(vtkInformation* request,
                                             vtkInformationVector** inputs,
                                             vtkInformationVector* outputs)
{
  try
  {
    if (request->Has(vtkSDDP::REQUEST_DATA_OBJECT()))
    {
      return this->CreateOutputs(outputs);
    }
    if (request->Has(vtkSDDP::REQUEST_INFORMATION()))
    {
      for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
      {
        outputs->GetInformationObject(port)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
      }
      return this->RequestInformation(request, inputs, outputs);
    }
    if (request->Has(vtkSDDP::REQUEST_UPDATE_EXTENT()))
    {
      return this->AskForWholeInputs(inputs);
    }
    if (request->Has(vtkSDDP::REQUEST_DATA()))
    {
      this->ErrorText.clear();
      return this->Execute(request, inputs, outputs);
    }
  }
  catch (const std::exception& error)
  {
    this->ErrorText = error.what();
    for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
    {
      if (vtkDataObject* output = vtkDataObject::GetData(outputs, port))
      {
        output->Initialize();
      }
    }
    vtkErrorMacro(<< this->ErrorText);
    return 0;
  }
  return this->Superclass::ProcessRequest(request, inputs, outputs);
}

void vtkBRDFAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ErrorText: " << this->ErrorText << "\n";
}
