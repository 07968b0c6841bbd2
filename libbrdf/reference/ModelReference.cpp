// The pages around the models': the list, and what models and users compose them of.
#include <brdf/base/Parallel.h>
#include <brdf/base/Text.h>
#include <brdf/formula/Table.h>
#include <brdf/models/Microfacet.h>
#include <brdf/reference/Markdown.h>
#include <brdf/reference/ModelPage.h>

namespace brdf {
namespace {

using namespace markdown;

constexpr char kGenerated[] = "<!-- Written by scripts/update-docs.sh from libbrdf/models: change it there. -->\n";

std::string albedoCell(const MeasuredAlbedo& albedo) { return albedo.text("±"); }

std::string listPage(const std::vector<ModelPointer>& models, const std::vector<std::vector<MeasuredAlbedo>>& albedos) {
  std::string text = kGenerated;
  text +=
      "# The analytic lobes\n\n"
      "Each is one XML file in `libbrdf/models/lobes`, and everything on its page comes from that file or was measured "
      "on it. Values are f_r in 1/sr without the cosine; a material is a sum of lobes with scale factors. "
      "`brdf models NAME` prints a page on the terminal.\n\n"
      "- [Terms](models/terms.md) that compose: `Microfacet(D=..., F=..., G=...)`\n"
      "- [Functions](models/functions.md) and [samplers](models/samplers.md) that formulas may name\n"
      "- [The formula language](formula-language.md), [lobes of your own](own-lobes.md), "
      "[what `brdf check` demands](checks.md)\n\n"
      "The albedo is the share of light from 0 or 60 degrees that the lobe reflects at its defaults, measured, with "
      "three standard errors. Lobes without a normalisation of their own (their pages say so) may exceed 1.\n\n";
  text += header({"lobe", "what", "parameters", "albedo, 0°", "albedo, 60°"});
  for (std::size_t k = 0; k < models.size(); ++k) {
    std::vector<std::string> names;
    for (const Parameter& p : models[k]->parameters()) names.push_back("`" + p.name + "`");
    text += row({"[" + models[k]->name() + "](models/" + models[k]->name() + ".md)", escaped(models[k]->title()),
                 joined(names), albedoCell(albedos[k][0]), albedoCell(albedos[k][1])});
  }
  text += "\n## What some do not keep\n\nLobes that are not listed are held to every check.\n\n";
  for (const ModelPointer& model : models)
    for (const std::string& one : declaredBreaks(*model))
      text += "- [" + model->name() + "](models/" + model->name() + ".md): " + escaped(one) + "\n";
  return text;
}

std::string termSection(char kind, const std::string& title, const std::string& words) {
  std::string text = "## " + title + "\n\n" + words + "\n\n";
  for (const MicrofacetTerm& term : microfacetTermsOf(kind)) {
    text += "### " + std::string(1, kind) + "=" + term.name + "\n\n";
    text += "`" + term.call + "`";
    if (!term.smith.empty()) text += "; with G=Smith `" + term.smith + "`";
    if (!term.sampler.empty())
      text += "; sampler [`" + term.sampler + "(" + joined(term.samplerArguments) + ")`](samplers.md#" +
              anchor(term.sampler) + ")";
    text += "\n\n";
    if (!term.parameters.empty()) text += parameterTable(term.parameters) + "\n";
  }
  return text;
}

std::string termsPage() {
  std::string text = kGenerated;
  text +=
      "# Terms of microfacet lobes\n\n"
      "A lobe can be composed of a distribution D, a Fresnel term F and a shadowing term G:\n\n"
      "```sh\nbrdf eval \"0.5*Microfacet(D=Beckmann(alpha=0.1), F=Conductor(eta=0.2, k=3), G=Smith)\" --at "
      "30,0,30,180\n"
      "```\n\n"
      "Its value is D F G/(4 cos theta_i cos theta_o) (Walter and others 2007, (20)). The formulas below name "
      "[functions](functions.md) of the library; V is G/(4 cos theta_i cos theta_o).\n\n";
  text += termSection('D', "Distributions D", "In 1/sr; the integral of D cos theta_h over the hemisphere is 1.");
  text += termSection('F', "Fresnel terms F", "At the angle theta_d between either direction and the half vector.");
  text += termSection('G', "Shadowing terms G", "`smith` stands for the distribution's own, see above.");
  text +=
      "## What each pair reflects\n\n"
      "Directional albedo with F = 1 at the distributions' defaults, light at 0 and 60 degrees: what is short of 1 is "
      "lost to light that the model does not follow between facets, what is above 1 is the term's own error.\n\n";
  std::vector<std::string> titles{"D"};
  for (const MicrofacetTerm& g : microfacetTermsOf('G')) titles.push_back("G=" + g.name);
  text += header(titles);
  for (const MicrofacetTerm& d : microfacetTermsOf('D')) {
    std::vector<std::string> cells{"D=" + d.name};
    for (const MicrofacetTerm& g : microfacetTermsOf('G')) {
      const auto albedos = measuredAlbedos(composeMicrofacet(d.name, "Constant", g.name));
      cells.push_back(albedoCell(albedos[0]) + "<br>" + albedoCell(albedos[1]));
    }
    text += row(cells);
  }
  return text;
}

std::string references(const std::vector<Reference>& list) {
  std::string text;
  for (const Reference& reference : list) text += "- " + markdown::citation(reference) + "\n";
  return text.empty() ? text : text + "\n";
}

std::string functionsPage() {
  std::string text = kGenerated;
  text +=
      "# Functions of the library\n\n"
      "Formulas may call them; they see their arguments and the [variables](../formula-language.md) of the two "
      "directions. They are defined in `libbrdf/models/functions`.\n\n";
  for (const LibraryFunction& entry : libraryFunctions()) {
    const std::string& name = entry.function.name;
    text += "## " + name + "\n\n`" + name + "(" + joined(entry.function.arguments) + ")`: " + escaped(entry.title) +
            ".\n\n" + mathBlock(entry.function.body, functionHead(entry), usualSymbols(), name) + "\n" +
            codeBlock(entry.function.body) + "\n" + references(entry.references);
  }
  text += "# Tables\n\nFunctions that were computed beforehand, interpolated; they are called like functions.\n\n" +
          header({"table", "samples", "range"});
  for (const auto& [name, table] : tableMap()) {
    const bool two = table->ny > 1;
    text += row({"`" + name + (two ? "(x, y)`" : "(x)`"),
                 std::to_string(table->nx) + (two ? " by " + std::to_string(table->ny) : ""),
                 number(table->x0) + " to " + number(table->x1) +
                     (two ? ", " + number(table->y0) + " to " + number(table->y1) : "")});
  }
  return text;
}

std::string samplersPage() {
  std::string text = kGenerated;
  text +=
      "# Samplers\n\n"
      "How a lobe draws the light's direction w for a viewer v from two random numbers, and with which density (1/sr). "
      "A lobe's file names one: `<sampler name=\"...\" arguments=\"...\" cosine=\"...\"/>`. Those that draw a half "
      "vector "
      "reflect v at it. A lobe without a sampler is sampled by the cosine.\n\n";
  for (const Sampler& sampler : samplers()) {
    text += "## " + sampler.name + "\n\n`" + sampler.name + "(" + joined(sampler.arguments) +
            ")`: " + escaped(sampler.title) + ".\n\nDraw:\n\n" + codeBlock(sampler.draw) + "\nDensity:\n\n" +
            mathBlock(sampler.density, "p", usualSymbols(), sampler.name) + "\n" + references(sampler.references);
  }
  return text;
}

}  // namespace

std::map<std::string, std::string> modelReference() {
  const std::vector<ModelPointer> models = allModels();
  std::vector<std::string> pages(models.size());
  std::vector<std::vector<MeasuredAlbedo>> albedos(models.size());
  parallelFor(models.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      albedos[k] = measuredAlbedos(models[k]);
      pages[k] = kGenerated + page(*models[k], albedos[k]);
    }
  });
  std::map<std::string, std::string> files{{"models.md", listPage(models, albedos)},
                                           {"models/terms.md", termsPage()},
                                           {"models/functions.md", functionsPage()},
                                           {"models/samplers.md", samplersPage()}};
  for (std::size_t k = 0; k < models.size(); ++k) files["models/" + models[k]->name() + ".md"] = pages[k];
  return files;
}

}  // namespace brdf
