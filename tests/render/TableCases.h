#pragma once
// Materials that are not formulas: tables and scattered data.
#include "RenderScene.h"

#include <brdf/geometry/Directions.h>
#include <brdf/material/ChannelView.h>
#include <brdf/material/GridBrdf.h>
#include <brdf/material/Resample.h>
#include <brdf/material/ScatteredBrdf.h>
#include <brdf/material/TableBrdf.h>
#include <brdf/sampling/DrawnTable.h>
#include <brdf/sampling/Sequence.h>

#include <random>

#include "../sampling/FunctionBrdf.h"

namespace rendertest {

using brdf::BrdfPointer;

inline BrdfPointer formula(const char* text) { return brdf::parseMaterialExpression(text); }

inline BrdfPointer merl() {
  return brdf::TableBrdf::tabulate(*formula("(0.3,0.2,0.1)*Lambertian + (0.5,0.4,0.3)*GGX(alpha=0.15)"));
}

/// Samples of `source`: `uniform` of them uniform in projected solid angle, `near` with the light within `radius`
/// (in projection) of the viewer.
inline BrdfPointer samplesOf(const brdf::Brdf& source, int uniform, int near = 0, double radius = 0) {
  brdf::ScatteredSamples samples;
  samples.channels = source.channels();
  std::mt19937_64 random(4);
  const auto number = [&] { return std::uniform_real_distribution<double>(0, 1)(random); };
  const auto direction = [&] {
    const double u = number(), v = number();
    return brdf::cosineDirection(u, v);
  };
  while (static_cast<int>(samples.pairs.size()) < uniform) {
    const Direction wi = direction();
    samples.pairs.push(wi, direction());
  }
  while (static_cast<int>(samples.pairs.size()) < uniform + near) {
    const Direction wo = direction();
    const double distance = radius * std::sqrt(number()), phi = 2 * brdf::kPi * number();
    const double x = wo[0] + distance * std::cos(phi), y = wo[1] + distance * std::sin(phi);
    if (x * x + y * y < 1) samples.pairs.push({x, y, std::sqrt(1 - x * x - y * y)}, wo);
  }
  samples.values.resize(samples.channels.count() * samples.pairs.size());
  source.evaluate(samples.pairs.view(), samples.values.data(), nullptr);
  return std::make_shared<brdf::ScatteredBrdf>(std::move(samples), "scattered samples of the test");
}

inline BrdfPointer scattered() { return samplesOf(*formula("(0.3,0.2,0.1)*Lambertian + 0.5*GGX(alpha=0.4)"), 2000); }

inline BrdfPointer scatteredRetro() {
  return samplesOf(*formula("0.1*Lambertian + Lafortune(Cx=1, Cy=1, Cz=1, n=40)"), 1000, 1000, 0.4);
}

inline BrdfPointer retro() { return brdf::TableBrdf::tabulate(brdf::test::retroReflector()); }

/// Four axes: the azimuth of the half vector counts.
inline BrdfPointer anisotropic() {
  const BrdfPointer source = formula("(0.1,0.05,0.02)*Lambertian + 0.5*Ward(ax=0.2, ay=0.5)");
  return brdf::GridBrdf::tabulate(*source, brdf::gridFor(*source, brdf::Parametrisation::HalfDifference, 5));
}

struct TableCase {
  const char* name;
  BrdfPointer (*make)();
};
inline const TableCase kTableCases[] = {{"Merl", merl},
                                        {"Scattered", scattered},
                                        {"ScatteredRetro", scatteredRetro},
                                        {"Retro", retro},
                                        {"Anisotropic", anisotropic}};

/// What vtkBRDFRender looks up for a material in monochrome or RGB: the material itself, or the table made of it.
inline BrdfPointer drawnOf(const BrdfPointer& brdf) { return brdf::drawnTable(brdf).grid; }

}  // namespace rendertest
