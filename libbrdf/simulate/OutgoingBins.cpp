#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/simulate/OutgoingBins.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

using Q = AxisQuantity;

/// Edges of the cells of an axis that counts, or of one cell of its whole range where the layout leaves it out.
std::vector<double> edgesOf(const GridLayout& layout, std::size_t axis, double last, const std::string& where) {
  if (axis == layout.axes.size()) return {0, last};
  const GridAxis& found = layout.axes[axis];
  if (found.edges.empty())
    throw Error(Error::Kind::Value, {"the axis " + std::string(axisName(found.quantity)) + " has no cells to count in",
                                     where, "node-centred", "cell-centred"});
  return found.edges;
}

/// At the polar angle of the light, linear between the nodes.
double offsetAt(const GridLayout& layout, double thetaI) {
  if (layout.specularOffsets.empty()) return 0;
  const std::vector<double>& nodes = layout.axes[layout.find(Q::ThetaI)].nodes;
  const auto above = std::ranges::upper_bound(nodes, thetaI);
  if (above == nodes.begin()) return layout.specularOffsets.front();
  if (above == nodes.end()) return layout.specularOffsets.back();
  const auto k = static_cast<std::size_t>(above - nodes.begin());
  const double share = (thetaI - nodes[k - 1]) / (nodes[k] - nodes[k - 1]);
  return (1 - share) * layout.specularOffsets[k - 1] + share * layout.specularOffsets[k];
}

}  // namespace

OutgoingBins::OutgoingBins(const GridLayout& layout, double thetaI, double phiI, const std::string& where)
    : thetaI_(thetaI), phiI_(phiI), specular_(layout.parametrisation == Parametrisation::Specular) {
  layout.check(where);
  if (layout.parametrisation == Parametrisation::HalfDifference)
    throw Error(Error::Kind::Value,
                {"this parametrisation cannot count light", where, "half_difference", "spherical, specular"});
  if (layout.symmetry.reciprocal)
    throw Error(Error::Kind::Value, {"reciprocity cannot be assumed of what is counted", where, "reciprocal", "none"});
  const std::size_t none = layout.axes.size();
  const std::size_t polar = layout.find(specular_ ? Q::SpecularTheta : Q::ThetaO);
  std::size_t azimuth = layout.find(specular_ ? Q::SpecularPhi : Q::PhiO);
  const bool absolute = !specular_ && azimuth < none;
  if (!specular_ && !absolute) azimuth = layout.find(Q::PhiDifference);

  polar_.edges = edgesOf(layout, polar, specular_ ? kPi : kPi / 2, where);
  azimuth_.edges = edgesOf(layout, azimuth, 2 * kPi, where);
  if (azimuth < none && layout.axes[azimuth].period > 0) period_ = layout.axes[azimuth].period;
  folded_ = layout.symmetry.mirror && azimuth < none && layout.find(Q::PhiI) == none;
  const bool azimuthFirst = azimuth < polar;
  polar_.stride = azimuthFirst ? azimuth_.edges.size() - 1 : 1;
  azimuth_.stride = azimuthFirst ? 1 : polar_.edges.size() - 1;
  count_ = (polar_.edges.size() - 1) * (azimuth_.edges.size() - 1);

  reference_ = absolute || specular_ ? 0 : phiI;
  poleTheta_ = specular_ ? thetaI + offsetAt(layout, thetaI) : 0;
  const double c = std::cos(poleTheta_), s = std::sin(poleTheta_), ci = std::cos(phiI), si = std::sin(phiI);
  pole_ = {-s * ci, -s * si, c};
  towardsNormal_ = {c * ci, c * si, s};
  across_ = {-si, ci, 0};

  measures_.resize(count_);
  for (std::size_t p = 0; p + 1 < polar_.edges.size(); ++p)
    for (std::size_t a = 0; a + 1 < azimuth_.edges.size(); ++a)
      measures_[p * polar_.stride + a * azimuth_.stride] =
          measure(polar_.edges[p], polar_.edges[p + 1], azimuth_.edges[a], azimuth_.edges[a + 1]) *
          (folded_ ? 2 : std::round(2 * kPi / period_));
  for (const double edge : polar_.edges) cosines_.push_back(std::cos(edge));
  // From here on polar edges are what find() compares: no trigonometry a ray.
  for (double& edge : polar_.edges) {
    const double root = std::sin(specular_ ? edge / 2 : edge);
    edge = root * root;
  }
  // A direction at the end of the range is within it, however it rounds.
  if (polar_.edges.front() < 1e-14) polar_.edges.front() = -1;
  if (polar_.edges.back() > 1 - 1e-12) polar_.edges.back() = 2;
  polar_.prepare();
  azimuth_.prepare();
}

void OutgoingBins::Axis::prepare() {
  const std::size_t inner = edges.size() - 1;
  // The end edges may have been moved outwards for rounding: steps span what lies within.
  first = std::max(edges.front(), -kPi * 4);
  const double last = std::min(edges.back(), kPi * 4);
  guide.resize(8 * inner + 1);
  steps = static_cast<double>(guide.size() - 1) / (last - first);
  for (std::size_t g = 0; g < guide.size(); ++g)
    guide[g] = static_cast<std::uint32_t>(
        std::upper_bound(edges.begin(), edges.end(), first + static_cast<double>(g) / steps) - edges.begin());
}

std::size_t OutgoingBins::Axis::find(double value) const {
  if (!(value >= edges.front() && value < edges.back())) return edges.size();
  // Within the step of the value there is seldom more than one edge; rounding may take the neighbouring step.
  const double at = std::clamp((value - first) * steps, 0.0, static_cast<double>(guide.size() - 2));
  const auto step = static_cast<std::size_t>(at);
  std::size_t above = guide[step];
  if (const std::size_t most = guide[step + 1]; most - above > 8)
    above = static_cast<std::size_t>(std::upper_bound(edges.begin() + static_cast<std::ptrdiff_t>(above),
                                                      edges.begin() + static_cast<std::ptrdiff_t>(most), value) -
                                     edges.begin());
  while (above < edges.size() - 1 && edges[above] <= value) ++above;
  while (above > 1 && edges[above - 1] > value) --above;
  return above - 1;
}

std::array<double, 2> OutgoingBins::place(const Direction& wo) const {
  double polar, phi;
  if (specular_) {
    const Direction off{wo[0] - pole_[0], wo[1] - pole_[1], wo[2] - pole_[2]};
    polar = dot(off, off) / 4;
    phi = std::atan2(dot(off, across_), dot(off, towardsNormal_));
  } else {
    polar = wo[0] * wo[0] + wo[1] * wo[1];
    phi = std::atan2(wo[1], wo[0]) - reference_;
  }
  const double first = azimuth_.edges.front(), last = azimuth_.edges.back();
  if (folded_) return {polar, std::clamp(std::abs(std::remainder(phi, 2 * kPi)), first, std::nextafter(last, 0))};
  const double turns = (phi - first) / period_;
  phi = first + (turns - std::floor(turns)) * period_;
  // At the seam rounding may reach the far end of a full turn.
  if (phi >= last && last >= first + period_ - 1e-9) phi = first;
  return {polar, phi};
}

std::size_t OutgoingBins::find(const Direction& wo) const {
  const auto [polar, phi] = place(wo);
  const std::size_t p = polar_.find(polar);
  if (p == polar_.edges.size()) return count_;
  const std::size_t a = azimuth_.find(phi);
  if (a == azimuth_.edges.size()) return count_;
  return p * polar_.stride + a * azimuth_.stride;
}

std::array<double, 2> OutgoingBins::coordinates(const Direction& wo) const {
  const auto [polar, phi] = place(wo);
  return {std::asin(std::sqrt(std::min(polar, 1.0))) * (specular_ ? 2 : 1), phi};
}

double OutgoingBins::solidAngle(std::size_t bin) const {
  const std::size_t p = ring(bin), a = bin / azimuth_.stride % (azimuth_.edges.size() - 1);
  return (cosines_[p] - cosines_[p + 1]) * (azimuth_.edges[a + 1] - azimuth_.edges[a]) *
         (folded_ ? 2 : std::round(2 * kPi / period_));
}

Direction OutgoingBins::direction(std::size_t bin, double u, double v, double image) const {
  const std::size_t p = ring(bin), a = bin / azimuth_.stride % (azimuth_.edges.size() - 1);
  double phi = std::lerp(azimuth_.edges[a], azimuth_.edges[a + 1], v);
  if (folded_)
    phi = image < 0.5 ? phi : -phi;
  else
    phi += period_ * std::floor(image * std::round(2 * kPi / period_));
  const double z = std::lerp(cosines_[p], cosines_[p + 1], u), s = std::sqrt(std::max(1 - z * z, 0.0));
  const double x = s * std::cos(specular_ ? phi : phi + reference_),
               y = s * std::sin(specular_ ? phi : phi + reference_);
  if (!specular_) return {x, y, z};
  Direction wo;
  for (std::size_t k = 0; k < 3; ++k) wo[k] = x * towardsNormal_[k] + y * across_[k] + z * pole_[k];
  return wo;
}

double OutgoingBins::measure(double polar0, double polar1, double azimuth0, double azimuth1) const {
  const auto halfSquare = [](double angle) { return 0.5 * std::sin(angle) * std::sin(angle); };
  const double turn = azimuth1 - azimuth0;
  if (!specular_) return (halfSquare(polar1) - halfSquare(polar0)) * turn;
  // A pole on the light's side is one on the other side with azimuths that differ by half a turn.
  if (poleTheta_ < 0) {
    azimuth0 += kPi;
    azimuth1 += kPi;
  }
  // cos theta_o = cos(theta) cos(pole) + sin(theta) cos(phi) sin(pole), in the angles about the pole.
  const double c = std::cos(poleTheta_), s = std::sin(std::abs(poleTheta_));
  const auto leastCosine = [&] {
    if (std::floor((azimuth1 - kPi) / (2 * kPi)) != std::floor((azimuth0 - kPi) / (2 * kPi))) return -1.0;
    return std::min(std::cos(azimuth0), std::cos(azimuth1));
  }();
  const auto least = [&](double theta) { return std::cos(theta) * c + std::sin(theta) * s * leastCosine; };
  const double sines = std::sin(azimuth1) - std::sin(azimuth0);
  if (least(polar0) >= 0 && least(polar1) >= 0) {
    const auto cubic = [](double theta) { return 0.5 * (theta - std::sin(theta) * std::cos(theta)); };
    return c * (halfSquare(polar1) - halfSquare(polar0)) * turn + s * (cubic(polar1) - cubic(polar0)) * sines;
  }
  // The horizon cuts the cell: over phi exactly, over theta by midpoints, 0.02 degrees apart or more.
  const int steps = static_cast<int>(std::clamp((polar1 - polar0) / radians(0.02), 16.0, 256.0));
  double total = 0;
  for (int k = 0; k < steps; ++k) {
    const double theta = polar0 + (polar1 - polar0) * (k + 0.5) / steps;
    const double a = std::cos(theta) * c, b = std::sin(theta) * s;
    const double cut = b > 0 ? -a / b : (a > 0 ? -2 : 2);  // above the horizon where cos(phi) > cut
    if (cut >= 1) continue;
    const double half = cut <= -1 ? kPi : std::acos(cut);
    // The parts of [azimuth0, azimuth1] within `half` of a multiple of 2 pi.
    for (double middle = 2 * kPi * std::round(azimuth0 / (2 * kPi)); middle - half < azimuth1; middle += 2 * kPi) {
      const double from = std::max(azimuth0, middle - half), to = std::min(azimuth1, middle + half);
      if (to > from) total += (a * (to - from) + b * (std::sin(to) - std::sin(from))) * std::sin(theta);
    }
  }
  return total * (polar1 - polar0) / steps;
}

}  // namespace brdf
