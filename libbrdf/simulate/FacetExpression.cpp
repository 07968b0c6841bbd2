#include <brdf/base/Call.h>
#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/io/LoadMaterial.h>
#include <brdf/models/CallArguments.h>
#include <brdf/simulate/FacetExpression.h>

#include <algorithm>

namespace brdf {
namespace {

/// A list of numbers that a kind of facet has.
struct FacetNumbers {
  std::vector<double> Facet::*numbers;
  bool required;
  Parameter record;
};

struct FacetForm {
  Facet::Kind kind;
  std::string name;
  std::string form;
  std::vector<FacetNumbers> numbers{};
};

Parameter record(const char* name, const char* unit, double minimum, double maximum) {
  Parameter parameter;
  parameter.name = name;
  parameter.unit = unit;
  parameter.minimum = minimum;
  parameter.maximum = maximum;
  return parameter;
}

const std::vector<FacetForm>& forms() {
  using K = Facet::Kind;
  static const std::vector<FacetForm> list = {
      {K::Mirror, "mirror", "mirror: reflects everything"},
      {K::Conductor,
       "conductor",
       "conductor(eta=0.2 0.9 1.1, k=3.9 2.4 2.2): a metal of the index eta + i k, by Fresnel",
       {{&Facet::eta, true, record("eta", "1", 0, 1000)}, {&Facet::k, true, record("k", "1", 0, 1000)}}},
      {K::Dielectric,
       "dielectric",
       "dielectric(eta=1.5, absorption=0.01): reflects and refracts by Fresnel; absorbs inside, 1/um [0]",
       {{&Facet::eta, true, record("eta", "1", 0.01, 1000)},
        {&Facet::absorption, false, record("absorption", "1/um", 0, 1e6)}}},
      {K::Lambertian,
       "lambertian",
       "lambertian(albedo=0.5): reflects that share, cosine-distributed",
       {{&Facet::albedo, true, record("albedo", "1", 0, 1)}}},
      {K::Scattering, "scattering", "scattering(MATERIAL): any material expression, file or preset:NAME"}};
  return list;
}

std::string numbersText(const std::vector<double>& numbers) {
  std::vector<std::string> words;
  for (const double number : numbers) words.push_back(formatNumber(number));
  return joined(words, " ");
}

}  // namespace

Facet parseFacet(std::string_view text) {
  const Call call = parseCall(text, "facet");
  const auto form = std::ranges::find(forms(), call.name, &FacetForm::name);
  if (form == forms().end()) {
    std::vector<std::string> names;
    for (const FacetForm& known : forms()) names.push_back(known.name);
    throw Error(Error::Kind::Formula, {"no such facet", call.where(call.column), "'" + call.name + "'", joined(names)});
  }
  Facet facet;
  facet.kind = form->kind;
  if (facet.kind == Facet::Kind::Scattering) {
    // All between the parentheses, commas and equals signs included, is the material's.
    const std::size_t open = text.find('('), close = text.rfind(')');
    const std::string_view material =
        open == std::string_view::npos ? std::string_view() : trimmed(text.substr(open + 1, close - open - 1));
    if (material.empty())
      throw Error(Error::Kind::Formula, {"no material", call.where(call.column), "", "scattering(MATERIAL)"});
    facet.brdf = loadMaterial(material).brdf;
    return facet;
  }
  CallArguments arguments(call);
  for (const FacetNumbers& numbers : form->numbers) {
    const bool given = arguments.given(numbers.record.name);
    if (numbers.required && !given)
      arguments.fail(numbers.record.name, call.name + " without " + numbers.record.name, "", form->form);
    std::vector<double> values = arguments.numbers(numbers.record);
    if (given) facet.*(numbers.numbers) = std::move(values);
  }
  arguments.finish();
  return facet;
}

std::string facetText(const Facet& facet) {
  const auto form = std::ranges::find(forms(), facet.kind, &FacetForm::kind);
  if (facet.kind == Facet::Kind::Scattering)
    return "scattering(" + (facet.brdf ? facet.brdf->description() : std::string()) + ")";
  std::vector<std::string> parts;
  for (const FacetNumbers& numbers : form->numbers)
    if (!(facet.*(numbers.numbers)).empty())
      parts.push_back(numbers.record.name + "=" + numbersText(facet.*(numbers.numbers)));
  return parts.empty() ? form->name : form->name + "(" + joined(parts) + ")";
}

Channels facetChannels(const std::vector<Facet>& facets) {
  Channels channels;
  const auto refuse = [&](const Facet& facet, std::size_t found) {
    throw Error(Error::Kind::Value,
                {"wrong number of channels", "facet " + facetText(facet), std::to_string(found),
                 channels.count() > 1 ? "1 or " + std::to_string(channels.count()) : "1, or 3 for RGB"});
  };
  for (const Facet& facet : facets) {
    if (facet.kind != Facet::Kind::Scattering || !facet.brdf || facet.brdf->channels().count() == 1) continue;
    if (channels.count() > 1 && !(channels == facet.brdf->channels())) refuse(facet, facet.brdf->channels().count());
    channels = facet.brdf->channels();
  }
  for (const Facet& facet : facets)
    for (const auto* numbers : {&facet.eta, &facet.k, &facet.albedo, &facet.absorption}) {
      if (numbers->size() < 2 || numbers->size() == channels.count()) continue;
      if (numbers->size() != 3 || channels.count() > 1) refuse(facet, numbers->size());
      channels = Channels::rgb();
    }
  return channels;
}

const std::vector<std::string>& facetForms() {
  static const std::vector<std::string> list = [] {
    std::vector<std::string> lines;
    for (const FacetForm& form : forms()) lines.push_back(form.form);
    return lines;
  }();
  return list;
}

}  // namespace brdf
