#include <brdf/simulate/surfaces/BuiltInSurfaces.h>

namespace brdf {

std::vector<SurfaceKind> builtInSurfaceKinds() {
  return {flatSurface(),     groovedSurface(),     lamellarSurface(), sinusoidalSurface(), blazedSurface(),
          gaussianSurface(), exponentialSurface(), spectrumSurface(), brushedSurface(),    scratchedSurface(),
          triangleSurface(), heightFieldSurface(), meshSurface(),     sphereSurface()};
}

Parameter lengthParameter(std::string name, std::string label, double defaultValue, std::string description,
                          double minimum, double maximum) {
  Parameter parameter =
      numberParameter(std::move(name), std::move(label), defaultValue, minimum, maximum, std::move(description));
  parameter.unit = "um";
  return parameter;
}

Parameter angleParameter(std::string name, std::string label, double defaultValue, double minimum, double maximum,
                         std::string description) {
  Parameter parameter =
      numberParameter(std::move(name), std::move(label), defaultValue, minimum, maximum, std::move(description));
  parameter.unit = "deg";
  return parameter;
}

Parameter numberParameter(std::string name, std::string label, double defaultValue, double minimum, double maximum,
                          std::string description) {
  Parameter parameter;
  parameter.symbol = name;
  parameter.name = std::move(name);
  parameter.label = std::move(label);
  parameter.unit = "1";
  parameter.description = std::move(description);
  parameter.defaultValue = defaultValue;
  parameter.minimum = parameter.softMinimum = minimum;
  parameter.maximum = parameter.softMaximum = maximum;
  return parameter;
}

Parameter seedParameter() {
  return numberParameter("seed", "seed", 1, 0, 0x1p53, "whole number: another one is another surface of the same kind");
}

}  // namespace brdf
