#include <brdf/fit/Fit.h>
#include <brdf/io/LoadMaterial.h>

#include <iostream>

int main() {
  const auto target = brdf::loadMaterial("gold.binary").brdf;
  brdf::FitOptions options;
  options.maximumTheta = 80;
  const auto report = brdf::fit(*target, {{brdf::findModel("Lambertian")}, {brdf::findModel("GGX")}}, options);
  std::cout << report.material->description() << "\nrms " << report.error << " 1/sr\n";
}
