#include "vtkBRDFGonioreflectometer.h"

#include "vtkBRDF.h"
#include "vtkBRDFMicrosurface.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/simulate/FacetExpression.h>
#include <brdf/simulate/Gonioreflectometer.h>
#include <brdf/simulate/LayoutChoice.h>
#include <brdf/simulate/SurfaceKinds.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>

vtkStandardNewMacro(vtkBRDFGonioreflectometer);

struct vtkBRDFGonioreflectometer::Session
{
  std::string Key;                                 // what the simulation is of
  std::shared_ptr<const brdf::MadeSurface> Source; // the input that Key cannot tell apart
  brdf::LayoutChoice Choice;
  std::unique_ptr<brdf::LobeSimulation> Lobe;
  double Seconds = 0;
  bool Finished = false;
};

namespace
{
std::vector<double> Angles(const std::string& what, const std::string& text)
{
  std::vector<double> angles;
  for (const std::string_view word : brdf::split(text, ','))
  {
    const std::optional<double> degrees = brdf::parseNumber(word);
    if (!degrees)
    {
      throw brdf::Error(brdf::Error::Kind::Value,
                        { "not a list of angles", what, text, "degrees separated by commas" });
    }
    angles.push_back(brdf::radians(*degrees));
  }
  return angles;
}

/// One of the words allowed, as its number.
std::size_t Choice(const char* what, const std::string& name, const std::vector<std::string>& allowed)
{
  const auto found = std::find(allowed.begin(), allowed.end(), name);
  if (found == allowed.end())
  {
    throw brdf::Error(brdf::Error::Kind::Value,
                      { std::string("unknown ") + what, "simulation", name, brdf::joined(allowed) });
  }
  return static_cast<std::size_t>(found - allowed.begin());
}

template<class Array, class Value>
void AddField(vtkFieldData* fields, const char* name, const Value& value)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->InsertNextValue(value);
  fields->AddArray(array);
}

template<class Array>
Array* Column(vtkTable* table, const std::string& name)
{
  vtkNew<Array> column;
  column->SetName(name.c_str());
  table->AddColumn(column);
  return column;
}

void FillBalance(const std::vector<brdf::EnergyBalance>& list, vtkTable* table)
{
  auto* thetaI = Column<vtkDoubleArray>(table, "theta_i");
  auto* phiI = Column<vtkDoubleArray>(table, "phi_i");
  auto* channel = Column<vtkIntArray>(table, "channel");
  auto* rays = Column<vtkIdTypeArray>(table, "rays");
  using Part = std::vector<brdf::Estimate> brdf::EnergyBalance::*;
  const std::pair<const char*, Part> parts[] = { { "reflected", &brdf::EnergyBalance::reflected },
                                                 { "transmitted", &brdf::EnergyBalance::transmitted },
                                                 { "absorbed", &brdf::EnergyBalance::absorbed },
                                                 { "lost", &brdf::EnergyBalance::lost },
                                                 { "sum", &brdf::EnergyBalance::sum },
                                                 { "specularReflected", &brdf::EnergyBalance::specularReflected },
                                                 { "specularTransmitted", &brdf::EnergyBalance::specularTransmitted } };
  for (const auto& [name, part] : parts)
  {
    auto* value = Column<vtkDoubleArray>(table, name);
    auto* error = Column<vtkDoubleArray>(table, std::string(name) + "Error");
    for (const brdf::EnergyBalance& balance : list)
    {
      for (const brdf::Estimate& estimate : balance.*part)
      {
        value->InsertNextValue(estimate.value);
        error->InsertNextValue(estimate.error);
      }
    }
  }
  auto* noise = Column<vtkDoubleArray>(table, "noise");
  auto* converged = Column<vtkIntArray>(table, "converged");
  for (const brdf::EnergyBalance& balance : list)
  {
    for (std::size_t c = 0; c < balance.reflected.size(); ++c)
    {
      thetaI->InsertNextValue(brdf::degrees(balance.thetaI));
      phiI->InsertNextValue(brdf::degrees(balance.phiI));
      channel->InsertNextValue(static_cast<int>(c));
      rays->InsertNextValue(static_cast<vtkIdType>(balance.rays));
      noise->InsertNextValue(balance.noise);
      converged->InsertNextValue(balance.converged ? 1 : 0);
    }
  }
}

std::shared_ptr<const brdf::MadeSurface> InputSurface(vtkInformationVector** inputs)
{
  vtkBRDFMicrosurface* input = vtkBRDFMicrosurface::GetData(inputs[0]);
  if (!input || input->IsEmpty())
  {
    throw brdf::Error(brdf::Error::Kind::Value, { "no microsurface", "input", "", "a vtkBRDFMicrosurface" });
  }
  return input->GetSurface();
}
}

vtkBRDFGonioreflectometer::vtkBRDFGonioreflectometer()
{
  this->SetNumberOfOutputPorts(2);
}

vtkBRDFGonioreflectometer::~vtkBRDFGonioreflectometer() = default;

vtkTable* vtkBRDFGonioreflectometer::GetBalance()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(1));
}

void vtkBRDFGonioreflectometer::AddFacet(const std::string& facet)
{
  this->Facets.push_back(facet);
  this->Modified();
}

void vtkBRDFGonioreflectometer::RemoveAllFacets()
{
  this->Facets.clear();
  this->Modified();
}

std::string vtkBRDFGonioreflectometer::GetFacet(int index) const
{
  return index >= 0 && index < this->GetNumberOfFacets() ? this->Facets[static_cast<std::size_t>(index)] : "";
}

void vtkBRDFGonioreflectometer::GetFacetForms(vtkStringArray* forms)
{
  forms->Initialize();
  for (const std::string& form : brdf::facetForms())
  {
    forms->InsertNextValue(form);
  }
}

int vtkBRDFGonioreflectometer::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkBRDFMicrosurface");
  return 1;
}

int vtkBRDFGonioreflectometer::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkBRDF" : "vtkTable");
  return 1;
}

bool vtkBRDFGonioreflectometer::Refine()
{
  if (this->Current && this->Current->Finished)
  {
    return false;
  }
  this->Modified();
  return true;
}

int vtkBRDFGonioreflectometer::RequestData(vtkInformation*,
                                           vtkInformationVector** inputs,
                                           vtkInformationVector* outputs)
{
  const std::shared_ptr<const brdf::MadeSurface> source = InputSurface(inputs);
  brdf::Microsurface surface = source->surface;
  if (!this->Facets.empty())
  {
    surface.facets.clear();
    for (const std::string& facet : this->Facets)
    {
      surface.facets.push_back(brdf::parseFacet(facet));
    }
  }
  while (surface.facets.size() < surface.facetsNeeded())
  {
    surface.facets.push_back(surface.facets.back());
  }
  surface.channels = brdf::facetChannels(surface.facets);

  brdf::LayoutRequest request;
  request.thetaI = Angles("incident polar angles", this->ThetaI);
  if (!this->PhiI.empty())
  {
    request.phiI = Angles("incident azimuths", this->PhiI);
  }
  request.step = brdf::radians(this->Resolution);
  request.seed = static_cast<std::uint64_t>(this->Seed);
  using Kind = brdf::LayoutRequest::Bins;
  constexpr std::array kinds = { Kind::Automatic, Kind::Spherical, Kind::Specular, Kind::Retro };
  request.bins = kinds[Choice("bins", this->Bins, { "auto", "spherical", "specular", "retro" })];
  brdf::GonioreflectometerOptions options;
  options.toleranceOf = Choice("quantity of the tolerance", this->ToleranceOf, { "bins", "albedo" }) == 0
                          ? brdf::ToleranceOf::Bins
                          : brdf::ToleranceOf::Albedo;
  options.tolerance = this->Tolerance;
  options.maximumRays = static_cast<std::uint64_t>(this->MaximumRays);
  options.minimumRays = std::min(options.minimumRays, options.maximumRays);
  options.transport.bounces = static_cast<std::size_t>(this->Bounces);
  options.seed = request.seed;
  options.backend = this->Backend;

  vtkBRDF* output = vtkBRDF::GetData(outputs, 0);
  auto* table = vtkTable::GetData(outputs, 1);
  brdf::GonioreflectometerResult result;
  brdf::LayoutChoice choice;
  if (this->Progressive)
  {
    // An update is so many rays, in as much time whatever the facets.
    options.transport.nextEvent = brdf::NextEvent::Off;
    this->Advance(surface, source, request, options, result, choice);
  }
  else
  {
    this->Current.reset();
    choice = brdf::chooseLayout(
      *brdf::makeTransport(options.backend, surface, options.transport), surface.channels.count(), request);
    options.layout = choice.layout;
    options.progress = [this](const brdf::GonioreflectometerProgress& progress)
    {
      this->UpdateProgress(static_cast<double>(progress.done) / static_cast<double>(progress.directions));
      return !this->GetAbortExecute();
    };
    result = brdf::simulateBrdf(surface, options);
  }
  output->SetBrdf(result.brdf);
  vtkFieldData* fields = output->GetFieldData();
  AddField<vtkDoubleArray>(fields, "rays", static_cast<double>(result.rays));
  AddField<vtkDoubleArray>(fields, "seconds", result.seconds);
  AddField<vtkIntArray>(fields, "converged", result.converged ? 1 : 0);
  AddField<vtkStringArray>(fields, "layout", choice.layout.text());
  AddField<vtkStringArray>(fields, "layoutReason", choice.reason);
  FillBalance(result.balance, table);
  return 1;
}

void vtkBRDFGonioreflectometer::Advance(const brdf::Microsurface& surface,
                                        const std::shared_ptr<const brdf::MadeSurface>& source,
                                        const brdf::LayoutRequest& asked,
                                        const brdf::GonioreflectometerOptions& options,
                                        brdf::GonioreflectometerResult& result,
                                        brdf::LayoutChoice& choice)
{
  brdf::LayoutRequest request = asked;
  request.thetaI.resize(1);
  request.phiI.resize(std::min<std::size_t>(request.phiI.size(), 1));
  std::string key = brdf::joined(this->Facets, ";") + "|" + this->ThetaI + "|" + this->PhiI + "|" + this->Bins + "|" +
                    this->Backend + "|" + brdf::formatNumber(this->Resolution) + "|" + std::to_string(this->Bounces) +
                    "|" + std::to_string(this->Seed);
  const auto start = std::chrono::steady_clock::now();
  if (!this->Current || this->Current->Key != key || this->Current->Source != source)
  {
    auto session = std::make_unique<Session>();
    session->Key = std::move(key);
    session->Source = source;
    const std::shared_ptr<brdf::Transport> transport = brdf::makeTransport(options.backend, surface, options.transport);
    session->Choice = brdf::chooseLayout(*transport, surface.channels.count(), request);
    session->Lobe = std::make_unique<brdf::LobeSimulation>(transport,
                                                           surface.channels,
                                                           session->Choice.layout,
                                                           request.thetaI[0],
                                                           request.phiI.empty() ? 0 : request.phiI[0],
                                                           options.seed);
    this->Current = std::move(session);
  }
  Session& session = *this->Current;
  const std::uint64_t left = options.maximumRays - std::min(options.maximumRays, session.Lobe->tally().rays);
  session.Lobe->add(std::min(static_cast<std::uint64_t>(this->RaysPerUpdate), left));
  session.Seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  brdf::EnergyBalance balance = session.Lobe->balance();
  balance.converged = brdf::reachesTolerance(*session.Lobe, options);
  session.Finished = balance.converged || session.Lobe->tally().rays >= options.maximumRays;
  choice = session.Choice;
  result.brdf = session.Lobe->lobe();
  result.rays = session.Lobe->tally().rays;
  result.seconds = session.Seconds;
  result.converged = balance.converged;
  result.balance.push_back(std::move(balance));
}

void vtkBRDFGonioreflectometer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Facets: " << brdf::joined(this->Facets, "; ") << "\n"
     << indent << "ThetaI: " << this->ThetaI << "\n"
     << indent << "PhiI: " << this->PhiI << "\n"
     << indent << "Resolution: " << this->Resolution << "\n"
     << indent << "Bins: " << this->Bins << "\n"
     << indent << "Tolerance: " << this->Tolerance << "\n"
     << indent << "ToleranceOf: " << this->ToleranceOf << "\n"
     << indent << "MaximumRays: " << this->MaximumRays << "\n"
     << indent << "Bounces: " << this->Bounces << "\n"
     << indent << "Seed: " << this->Seed << "\n"
     << indent << "Backend: " << this->Backend << "\n"
     << indent << "Progressive: " << this->Progressive << "\n"
     << indent << "RaysPerUpdate: " << this->RaysPerUpdate << "\n";
}
