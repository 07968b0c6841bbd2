#include "Arguments.h"
#include "Commands.h"
#include "Output.h"
#include "Pictures.h"
#include "Progress.h"

#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/io/SaveMaterial.h>
#include <brdf/simulate/FacetExpression.h>
#include <brdf/simulate/Gonioreflectometer.h>
#include <brdf/simulate/LayoutChoice.h>
#include <brdf/simulate/SurfaceKinds.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace brdf::app {
namespace {

using Json = nlohmann::ordered_json;

struct Values {
  std::string surface, out;
  std::vector<std::string> facets;
  std::string thetaI = "0,15,30,45,60,75", phiI;
  std::string bins = "auto", toleranceOf = "bins", backend = "cpu", nextEvent = "auto";
  double resolution = 5, tolerance = 0.05;
  std::size_t rays = 1 << 24, bounces = 1000, seed = 1;
};

/// "0,15,30" as radians.
std::vector<double> anglesOption(const std::string& option, const std::string& text, const Range& range) {
  std::vector<double> angles;
  for (const std::string_view word : split(text, ','))
    angles.push_back(radians(numberOption(option, std::string(word), range)));
  return angles;
}

MadeSurface surfaceOf(const Values& values) {
  MadeSurface made = surfaceOption(values.surface);
  Microsurface& surface = made.surface;
  if (!values.facets.empty()) {
    surface.facets.clear();
    for (const std::string& text : values.facets) surface.facets.push_back(parseFacet(text));
    while (surface.facets.size() < surface.facetsNeeded()) surface.facets.push_back(surface.facets.back());
  }
  surface.channels = facetChannels(surface.facets);
  return made;
}

Json listOf(const std::vector<Estimate>& estimates) {
  Json list = Json::array();
  for (const Estimate& estimate : estimates) list.push_back({{"value", estimate.value}, {"error", estimate.error}});
  return list;
}

Json balanceJson(const EnergyBalance& balance) {
  return {{"theta_i", degrees(balance.thetaI)},
          {"phi_i", degrees(balance.phiI)},
          {"rays", balance.rays},
          {"noise", balance.noise},
          {"converged", balance.converged},
          {"reflected", listOf(balance.reflected)},
          {"transmitted", listOf(balance.transmitted)},
          {"absorbed", listOf(balance.absorbed)},
          {"lost", listOf(balance.lost)},
          {"sum", listOf(balance.sum)},
          {"specular_reflected", listOf(balance.specularReflected)},
          {"specular_transmitted", listOf(balance.specularTransmitted)}};
}

double meanOf(const std::vector<Estimate>& estimates) {
  double sum = 0;
  for (const Estimate& estimate : estimates) sum += estimate.value;
  return sum / static_cast<double>(estimates.size());
}

double worstOf(const std::vector<Estimate>& estimates) {
  double worst = 0;
  for (const Estimate& estimate : estimates) worst = std::max(worst, estimate.error);
  return worst;
}

std::string balanceTable(const GonioreflectometerResult& result, bool azimuths) {
  std::vector<std::string> head{"theta_i"};
  if (azimuths) head.emplace_back("phi_i");
  for (const char* name : {"rays", "noise", "reflected", "+-", "specular", "transmitted", "absorbed", "lost"})
    head.emplace_back(name);
  TextTable table(head);
  for (const EnergyBalance& b : result.balance) {
    std::vector<std::string> row{number(degrees(b.thetaI))};
    if (azimuths) row.push_back(number(degrees(b.phiI)));
    for (const std::string& cell :
         {std::to_string(b.rays), formatNumber(b.noise, 2), formatNumber(meanOf(b.reflected), 5),
          formatNumber(worstOf(b.reflected), 2), formatNumber(meanOf(b.specularReflected), 5),
          formatNumber(meanOf(b.transmitted), 5), formatNumber(meanOf(b.absorbed), 5), formatNumber(meanOf(b.lost), 2)})
      row.push_back(cell);
    table.row(row);
  }
  return table.text();
}

LayoutRequest layoutRequest(const Values& values) {
  LayoutRequest request;
  request.thetaI = anglesOption("--theta-i", values.thetaI, {0, kMostThetaI});
  if (!values.phiI.empty()) request.phiI = anglesOption("--phi-i", values.phiI, {-360, 360});
  request.step = radians(values.resolution);
  request.bins = values.bins == "auto"        ? LayoutRequest::Bins::Automatic
                 : values.bins == "spherical" ? LayoutRequest::Bins::Spherical
                 : values.bins == "specular"  ? LayoutRequest::Bins::Specular
                                              : LayoutRequest::Bins::Retro;
  request.seed = values.seed;
  return request;
}

/// What the file says of its making.
ReadReport reportOf(const Values& values, const MadeSurface& made, const GonioreflectometerResult& result) {
  ReadReport report;
  report.format = "simulated";
  report.source = made.surface.description;
  report.samples = result.brdf->layout().cells();
  report.assumptions = {"geometrical optics, unpolarised at every facet",
                        "f_r of a cell is its mean over the cell's projected solid angle"};
  for (std::size_t k = 0; k < made.surface.facets.size(); ++k)
    report.metadata["facet " + std::to_string(k)] = facetText(made.surface.facets[k]);
  for (const SurfaceFact& fact : made.facts)
    report.metadata[fact.name] = number(fact.value) + (fact.unit == "1" ? "" : " " + fact.unit);
  report.metadata["rays"] = std::to_string(result.rays);
  report.metadata["seed"] = std::to_string(values.seed);
  report.metadata["tolerance"] = number(values.tolerance) + " of " + values.toleranceOf;
  report.metadata["backend"] = values.backend;
  Json balance = Json::array();
  for (const EnergyBalance& b : result.balance) balance.push_back(balanceJson(b));
  report.metadata["energy balance"] = balance.dump();
  return report;
}

void run(const Output& output, const Values& values) {
  checkWritable(values.out);
  const MadeSurface made = surfaceOf(values);
  GonioreflectometerOptions options;
  options.tolerance = values.tolerance;
  options.toleranceOf = values.toleranceOf == "albedo" ? ToleranceOf::Albedo : ToleranceOf::Bins;
  options.maximumRays = values.rays;
  options.minimumRays = std::min<std::uint64_t>(options.minimumRays, values.rays);
  options.transport.bounces = values.bounces;
  options.transport.nextEvent = values.nextEvent == "on"    ? NextEvent::On
                                : values.nextEvent == "off" ? NextEvent::Off
                                                            : NextEvent::Automatic;
  options.seed = values.seed;
  options.backend = values.backend;
  if (values.backend != "cpu") pictures();  // the module that knows OpenGL, and its backend
  const Interruptible untilSaved;
  const LayoutChoice choice = chooseLayout(*makeTransport(values.backend, made.surface, options.transport),
                                           made.surface.channels.count(), layoutRequest(values));
  options.layout = choice.layout;
  GonioreflectometerResult result;
  {
    Progress progress(output, "simulate: direction");
    options.progress = [&](const GonioreflectometerProgress& at) {
      progress.update(at.done, at.directions, std::to_string(at.rays) + " rays, error " + number(at.noise));
      return !interrupted();
    };
    result = simulateBrdf(made.surface, options);
  }
  if (result.balance.empty())
    throw Error(Error::Kind::Value,
                {"interrupted before the first incident direction was done", "brdf simulate", "", ""});
  if (!values.out.empty()) {
    LoadedMaterial material{result.brdf, "simulated", reportOf(values, made, result), result.components};
    saveMaterial(material, values.out, "", "simulate");
  }

  const bool azimuths = !values.phiI.empty();
  const double seconds = std::max(result.seconds, 1e-9);
  std::string text = made.surface.description + "\n";
  for (const SurfaceFact& fact : made.facts)
    text += "  " + fact.name + ": " + number(fact.value) + (fact.unit == "1" ? "" : " " + fact.unit) + "\n";
  text += "bins: " + choice.layout.text() + " (" + choice.reason + ")\n" + balanceTable(result, azimuths) + "\n" +
          std::to_string(result.rays) + " rays, " + number(static_cast<double>(result.rays) / seconds) + " a second" +
          (values.out.empty() ? "" : "\n" + values.out);
  if (!result.converged)
    text += "\nnot all directions reached the tolerance: see the columns noise and lost, or give more --rays";
  output.line(text);

  Json facts = Json::array(), directions = Json::array(), facets = Json::array();
  for (const SurfaceFact& fact : made.facts)
    facts.push_back({{"name", fact.name}, {"value", fact.value}, {"unit", fact.unit}});
  for (const EnergyBalance& balance : result.balance) directions.push_back(balanceJson(balance));
  for (const Facet& facet : made.surface.facets) facets.push_back(facetText(facet));
  output.report({{"surface", made.surface.description},
                 {"facets", facets},
                 {"facts", facts},
                 {"backend", values.backend},
                 {"layout", choice.layout.text()},
                 {"layout_reason", choice.reason},
                 {"next_event", result.connects},
                 {"tolerance", values.tolerance},
                 {"tolerance_of", values.toleranceOf},
                 {"rays", result.rays},
                 {"queries", result.segments},
                 {"seconds", result.seconds},
                 {"rays_per_second", static_cast<double>(result.rays) / seconds},
                 {"complete", result.complete},
                 {"converged", result.converged},
                 {"directions", directions},
                 {"out", values.out}});
  if (!result.complete)
    throw Error(Error::Kind::Value,
                {"interrupted; the incident directions that were done are kept", "brdf simulate",
                 std::to_string(result.balance.size()) + " of " +
                     std::to_string(choice.layout.axes[2].size() * (azimuths ? choice.layout.axes[3].size() : 1)),
                 ""});
}

std::string kindsHelp() {
  std::vector<std::string> names;
  for (const SurfaceKind& kind : surfaceKinds()) names.push_back(kind.name);
  return "KIND(parameter=value, ...), lengths in micrometres: " + joined(names);
}

}  // namespace

Command simulateCommand() {
  const auto values = std::make_shared<Values>();
  return {
      "simulate", "Trace light through a microsurface: its BRDF as a table with standard errors",
      "  brdf simulate \"grooves(width=4, spacing=10, angle=120)\" --phi-i 0,90 --theta-i 30 --tolerance 0.1 --out "
      "grooves.vtkhdf\n"
      "  brdf simulate \"gaussian(rms=0.2, correlation=2)\" --facet \"conductor(eta=0.2 0.9 1.1, k=3.9 2.4 2.2)\" "
      "--theta-i 0,45 --tolerance 0.1 --out gold.vtkhdf",
      [values](Arguments& arguments) {
        arguments.positional("SURFACE", values->surface, kindsHelp());
        arguments.option("--facet", values->facets, "FACET",
                         "What the surface is made of [mirror]; of spheres a second one is the plane's; lists are one "
                         "number a channel: " +
                             joined(facetForms(), "; "));
        arguments.option("--theta-i", values->thetaI, "DEGREES", "Incident polar angles, ascending [0,15,30,45,60,75]");
        arguments.option(
            "--phi-i", values->phiI, "DEGREES",
            "Incident azimuths, ascending: an anisotropic table of four dimensions; without, the mean over "
            "azimuths is isotropic");
        arguments.option("--resolution", values->resolution, {0.05, 45}, "DEGREES", "Width of the outgoing bins");
        arguments.choice(
            "--bins", values->bins, {"auto", "spherical", "specular", "retro"},
            "theta_o by phi_o; or rings about the mirror direction, or about the direction back to the "
            "light, narrow where a pilot run finds peaks; auto: theta_o by phi_o, and if that would flatten "
            "peaks those of the three that do not, narrow where the peaks are");
        arguments.option("--tolerance", values->tolerance, {1e-6, 10}, "SHARE",
                         "Rays are added to each incident direction until its standard error is below this");
        arguments.choice("--tolerance-of", values->toleranceOf, {"bins", "albedo"},
                         "bins: root mean square error over the bins, divided by their root mean square value; albedo: "
                         "error of the share that is reflected or transmitted");
        arguments.option("--rays", values->rays, {2, 1e15}, "Most rays for one incident direction");
        arguments.option("--bounces", values->bounces, {1, 1e6},
                         "After so many facets the rest of a ray counts as lost");
        arguments.choice("--next-event", values->nextEvent, {"auto", "on", "off"},
                         "Connect every meeting with a lambertian facet with every bin: fewer, costlier rays; auto: "
                         "where all facets are lambertian; not with dielectrics, nor with --backend gpu");
        arguments.option("--seed", values->seed, {0, 1e12}, "The same seed gives the same table");
        arguments.option("--backend", values->backend, "NAME", "cpu (Embree, all threads) or gpu (OpenGL 3.2) [cpu]");
        arguments.option("--out", values->out, "FILE", "table.vtkhdf, or any format that holds a table");
      },
      [values](const Output& output) { run(output, *values); }};
}

}  // namespace brdf::app
