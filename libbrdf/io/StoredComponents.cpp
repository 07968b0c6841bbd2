#include <brdf/io/StoredBrdf.h>
#include <brdf/io/StoredComponents.h>
#include <brdf/io/StoredValues.h>

#include <array>

namespace brdf {
namespace {

using stored::restoreChoice;
using stored::Sizes;

const std::array<std::string_view, 4> kKinds = {
    componentName(ComponentKind::FrontReflection), componentName(ComponentKind::BackReflection),
    componentName(ComponentKind::FrontTransmission), componentName(ComponentKind::BackTransmission)};

std::vector<double> list(const h5::Group& group, const char* name) {
  const Sizes shape = group.dimensions(name);
  if (shape.size() != 1)
    stored::broken(group, std::string("not a list: ") + name, std::to_string(shape.size()) + " axes", "1");
  std::vector<double> values(shape[0]);
  group.readArray(name, values.data(), shape);
  return values;
}

void storeList(const h5::Group& group, const char* name, const std::vector<double>& values) {
  group.writeArray(name, values.data(), Sizes{values.size()});
}

constexpr const char* kNoFront = "NoFrontReflection";  ///< a group whose presence says so

/// Calls body(group) for each of parent/name/0, 1, ...
template <class Body>
void forEach(const h5::Group& parent, const char* name, const Body& body) {
  if (!parent.hasObject(name)) return;
  const h5::Group all = parent.group(name);
  for (std::size_t i = 0; all.hasObject(std::to_string(i)); ++i) body(all.group(std::to_string(i)));
}

}  // namespace

void storeComponents(const h5::Group& entry, const Components& components) {
  if (components.empty()) return;
  const h5::Group home = entry.createGroup("Components");
  const h5::Group scatter = home.createGroup("Scatter"), specular = home.createGroup("Specular"),
                  totals = home.createGroup("Totals");
  if (!components.front) home.createGroup(kNoFront);
  for (std::size_t i = 0; i < components.scatter.size(); ++i) {
    const h5::Group part = scatter.createGroup(std::to_string(i));
    part.setText("Component", componentName(components.scatter[i].kind));
    part.setText("Description", components.scatter[i].brdf->description());
    part.setText("Kind", storeBrdf(part, *components.scatter[i].brdf));
  }
  for (std::size_t i = 0; i < components.specular.size(); ++i) {
    const h5::Group part = specular.createGroup(std::to_string(i));
    part.setText("Component", componentName(components.specular[i].kind));
    stored::storeChannels(part, components.specular[i].channels);
    storeList(part, "theta_i", components.specular[i].thetaI);
    storeList(part, "values", components.specular[i].values);
  }
  for (std::size_t i = 0; i < components.totals.size(); ++i) {
    const h5::Group part = totals.createGroup(std::to_string(i));
    part.setText("Component", componentName(components.totals[i].kind));
    storeList(part, "theta_i", components.totals[i].thetaI);
    storeList(part, "values", components.totals[i].values);
  }
}

Components restoreComponents(const h5::Group& entry) {
  Components components;
  if (!entry.hasObject("Components")) return components;
  const h5::Group home = entry.group("Components");
  components.front = !home.hasObject(kNoFront);
  const auto kindOf = [](const h5::Group& part) { return restoreChoice<ComponentKind>(part, "Component", kKinds); };
  forEach(home, "Scatter", [&](const h5::Group& part) {
    components.scatter.push_back({kindOf(part), restoreBrdf(part, part.text("Kind"), part.text("Description"))});
  });
  forEach(home, "Specular", [&](const h5::Group& part) {
    components.specular.push_back(
        {kindOf(part), stored::restoreChannels(part), list(part, "theta_i"), list(part, "values")});
    components.specular.back().check();
  });
  forEach(home, "Totals", [&](const h5::Group& part) {
    components.totals.push_back({kindOf(part), list(part, "theta_i"), list(part, "values")});
    if (components.totals.back().thetaI.size() != components.totals.back().values.size())
      stored::broken(part, "angles and values disagree", std::to_string(components.totals.back().thetaI.size()),
                     std::to_string(components.totals.back().values.size()));
  });
  return components;
}

}  // namespace brdf
