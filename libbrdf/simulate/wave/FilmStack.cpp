#include <brdf/simulate/wave/FilmStack.h>

#include <numbers>

namespace brdf::wave {
namespace {

/// Amplitudes of the boundary between two media, normal components q1 and q2 of the wave vectors over 2 pi/wavelength.
FilmStack::Amplitudes boundary(Complex n1, Complex q1, Complex n2, Complex q2) {
  const Complex s = q1 + q2, p = n2 * n2 * q1 + n1 * n1 * q2;
  if (s == 0.0 || p == 0.0) return {-1, -1, 0, 0};  // both media the same, at grazing incidence
  return {(q1 - q2) / s, (n2 * n2 * q1 - n1 * n1 * q2) / p, 2.0 * q1 / s, 2.0 * n1 * n2 * q1 / p};
}

}  // namespace

FilmStack::FilmStack(std::vector<Film> films, Complex substrate, double wavelength)
    : films_(std::move(films)), substrate_(substrate), waveNumber_(2 * std::numbers::pi / wavelength) {}

FilmStack::Amplitudes FilmStack::at(double sine, double cosine) const {
  Complex n2 = substrate_, q2 = normalComponent(substrate_, sine);
  Amplitudes below{};
  Complex decay = 1;  // across the film above the boundary that was last added
  for (std::size_t k = films_.size() + 1; k-- > 0;) {
    const Complex n1 = k > 0 ? films_[k - 1].index : 1;
    const Complex q1 = k > 0 ? normalComponent(n1, sine) : cosine;
    const Amplitudes own = boundary(n1, q1, n2, q2);
    if (k == films_.size()) {
      below = own;
    } else {
      const Complex twice = decay * decay;
      below = {(own.rs + below.rs * twice) / (1.0 + own.rs * below.rs * twice),
               (own.rp + below.rp * twice) / (1.0 + own.rp * below.rp * twice),
               own.ts * below.ts * decay / (1.0 + own.rs * below.rs * twice),
               own.tp * below.tp * decay / (1.0 + own.rp * below.rp * twice)};
    }
    if (k > 0) decay = std::exp(Complex(0, 1) * (waveNumber_ * films_[k - 1].thickness) * q1);
    n2 = n1;
    q2 = q1;
  }
  return below;
}

void FilmStack::reflection(double sine, double cosine, Complex& rs, Complex& rp) const {
  if (films_.empty()) {
    const Complex q = normalComponent(substrate_, sine), e = substrate_ * substrate_;
    const Complex s = cosine + q, p = e * cosine + q;
    rs = s == 0.0 ? -1 : (cosine - q) / s;
    rp = p == 0.0 ? -1 : (e * cosine - q) / p;
    return;
  }
  const Amplitudes amplitudes = at(sine, cosine);
  rs = amplitudes.rs;
  rp = amplitudes.rp;
}

FilmStack::Powers FilmStack::powers(double sine, double cosine) const {
  const Amplitudes a = at(sine, cosine);
  const Complex q = normalComponent(substrate_, sine);
  if (!(cosine > 0)) return {1, 1, 0, 0};
  return {std::norm(a.rs), std::norm(a.rp), q.real() / cosine * std::norm(a.ts),
          (substrate_ * std::conj(q / substrate_)).real() / cosine * std::norm(a.tp)};
}

}  // namespace brdf::wave
