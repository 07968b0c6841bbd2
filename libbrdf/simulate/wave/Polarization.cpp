#include <brdf/simulate/wave/Polarization.h>

#include <Eigen/Eigenvalues>

namespace brdf::wave {

Mueller operator*(const Mueller& a, const Mueller& b) {
  Mueller c;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t k = 0; k < 4; ++k) c.m[4 * i + j] += a(i, k) * b(k, j);
  return c;
}

Mueller operator*(double factor, const Mueller& a) {
  Mueller b = a;
  for (double& element : b.m) element *= factor;
  return b;
}

Mueller operator+(const Mueller& a, const Mueller& b) {
  Mueller c;
  for (std::size_t k = 0; k < 16; ++k) c.m[k] = a.m[k] + b.m[k];
  return c;
}

// M_ij = tr(sigma_i J sigma_j J*) / 2 with sigma_0 = 1, sigma_1 = diag(1, -1), sigma_2 = [0 1; 1 0],
// sigma_3 = [0 -i; i 0] in the order s, p (Bohren and Huffman 1983, section 3.3, for their basis).
Mueller muellerOf(const Jones& j) {
  const Complex a = j.ss, b = j.pToS, c = j.sToP, d = j.pp;
  const double aa = std::norm(a), bb = std::norm(b), cc = std::norm(c), dd = std::norm(d);
  const Complex ab = a * std::conj(b), cd = c * std::conj(d), ac = a * std::conj(c), bd = b * std::conj(d),
                ad = a * std::conj(d), bc = b * std::conj(c);
  return {{(aa + bb + cc + dd) / 2, (aa - bb + cc - dd) / 2, ab.real() + cd.real(), ab.imag() + cd.imag(),
           (aa + bb - cc - dd) / 2, (aa - bb - cc + dd) / 2, ab.real() - cd.real(), ab.imag() - cd.imag(),
           ac.real() + bd.real(), ac.real() - bd.real(), ad.real() + bc.real(), ad.imag() - bc.imag(),
           -ac.imag() - bd.imag(), bd.imag() - ac.imag(), -ad.imag() - bc.imag(), ad.real() - bc.real()}};
}

double leastCoherency(const Mueller& m) {
  // H = sum m_ij (sigma_i x conj(sigma_j)) / 4.
  using Matrix2 = Eigen::Matrix2cd;
  const Complex i(0, 1);
  std::array<Matrix2, 4> sigma;
  sigma[0] << 1, 0, 0, 1;
  sigma[1] << 1, 0, 0, -1;
  sigma[2] << 0, 1, 1, 0;
  sigma[3] << 0, -i, i, 0;
  Eigen::Matrix4cd coherency = Eigen::Matrix4cd::Zero();
  for (std::size_t r = 0; r < 4; ++r)
    for (std::size_t c = 0; c < 4; ++c)
      for (Eigen::Index p = 0; p < 2; ++p)
        for (Eigen::Index q = 0; q < 2; ++q)
          coherency.block<2, 2>(2 * p, 2 * q) += m(r, c) / 4 * sigma[r](p, q) * sigma[c].conjugate();
  const double trace = coherency.trace().real();
  if (!(trace > 0)) return 0;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4cd> solver(coherency / trace, Eigen::EigenvaluesOnly);
  return solver.eigenvalues()[0];
}

const std::vector<PolarizationState>& polarizationStates() {
  static const std::vector<PolarizationState> states{
      {"unpolarized", {1, 0, 0, 0}}, {"s", {1, 1, 0, 0}},   {"p", {1, -1, 0, 0}},  {"s+p", {1, 0, 1, 0}},
      {"s-p", {1, 0, -1, 0}},        {"lcp", {1, 0, 0, 1}}, {"rcp", {1, 0, 0, -1}}};
  return states;
}

}  // namespace brdf::wave
