#include "vtkBRDFChannelAlgorithm.h"

#include <brdf/view/ChannelChoice.h>

brdf::ColourSettings vtkBRDFChannelAlgorithm::ChosenColours() const
{
  return brdf::colourSettings({ this->Illuminant, this->Observer, this->Adaptation });
}

brdf::ChannelChoice vtkBRDFChannelAlgorithm::ChosenChannels(vtkInformationVector** inputs, int port)
{
  brdf::ChannelChoice choice = brdf::chooseChannels(GetInputBrdf(inputs, port), this->Channel, this->ChosenColours());
  this->ChannelLabel = choice.label;
  return choice;
}

void vtkBRDFChannelAlgorithm::CopyChannelSettings(vtkBRDFChannelAlgorithm* other)
{
  this->SetChannel(other->Channel);
  this->SetIlluminant(other->Illuminant);
  this->SetObserver(other->Observer);
  this->SetAdaptation(other->Adaptation);
}

void vtkBRDFChannelAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Channel: " << this->Channel << "\n"
     << indent << "Illuminant: " << this->Illuminant << "\n"
     << indent << "Observer: " << this->Observer << "\n"
     << indent << "Adaptation: " << this->Adaptation << "\n";
}
