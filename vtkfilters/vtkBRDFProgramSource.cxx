#include "vtkBRDFProgramSource.h"

#include "vtkBRDF.h"
#include "vtkObjectFactory.h"

#include <brdf/simulate/external/ProgramBrdf.h>

vtkStandardNewMacro(vtkBRDFProgramSource);

vtkBRDFProgramSource::vtkBRDFProgramSource()
{
  this->SetNumberOfInputPorts(0);
}

vtkBRDFProgramSource::~vtkBRDFProgramSource() = default;

int vtkBRDFProgramSource::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  // The options' own reader, so that a word means here what it means in a material. The command follows by itself: one
  // that began with "--" would be taken for an option.
  const std::string channels = this->Channels.empty() ? "" : "--channels '" + this->Channels + "' ";
  brdf::ProgramOptions options = brdf::parseProgram(channels + "--symmetry '" + this->Symmetry + "' program");
  options.command = brdf::parseProgram("-- " + this->Command).command;
  options.reciprocal = this->Reciprocal;
  options.stays = this->Stay;
  options.timeLimit = this->TimeLimit;
  options.processes = static_cast<std::size_t>(this->Processes);
  vtkBRDF::GetData(outputs)->SetBrdf(brdf::programBrdf(std::move(options)));
  return 1;
}

void vtkBRDFProgramSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Command: " << this->Command << "\n";
  os << indent << "Channels: " << this->Channels << "\n";
  os << indent << "Symmetry: " << this->Symmetry << "\n";
  os << indent << "Reciprocal: " << this->Reciprocal << "\n";
  os << indent << "Stay: " << this->Stay << "\n";
  os << indent << "TimeLimit: " << this->TimeLimit << "\n";
  os << indent << "Processes: " << this->Processes << "\n";
}
