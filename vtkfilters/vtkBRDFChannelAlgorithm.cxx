#include "vtkBRDFChannelAlgorithm.h"

#include "vtkBRDFColourSettings.h"

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
  vtkBRDFColourSettings::Copy(other, this);
}

void vtkBRDFChannelAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Channel: " << this->Channel << "\n"
     << indent << "Illuminant: " << this->Illuminant << "\n"
     << indent << "Observer: " << this->Observer << "\n"
     << indent << "Adaptation: " << this->Adaptation << "\n";
}
