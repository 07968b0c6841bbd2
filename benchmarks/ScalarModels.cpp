// Compiled with -O3 -march=native, see CMakeLists.txt.
#include "ScalarModels.h"

#include <algorithm>
#include <cmath>

namespace scalar {
namespace {

template <class T>
constexpr T kPi = T(3.14159265358979323846);

template <class T>
struct Half {
  T x, y, z, d;  // unit half vector, cosine to either direction
};

template <class T>
Half<T> halfVector(const Pairs<T>& p, std::size_t i) {
  T x = p.wix[i] + p.wox[i], y = p.wiy[i] + p.woy[i], z = p.wiz[i] + p.woz[i];
  const T length = std::sqrt(x * x + y * y + z * z);
  x /= length, y /= length, z /= length;
  return {x, y, z, x * p.wix[i] + y * p.wiy[i] + z * p.wiz[i]};
}

template <class T>
T dielectric(T c, T n) {
  const T g = std::sqrt(n * n - 1 + c * c);
  const T a = (g - c) / (g + c), b = (c * (g + c) - 1) / (c * (g - c) + 1);
  return T(0.5) * a * a * (1 + b * b);
}

/// Calls f(i, half) above the horizon and stores its value times the scale in each channel.
template <class T, class F>
void forEach(const Pairs<T>& p, const T* scale, T* out, F f) {
  for (std::size_t i = 0; i < p.count; ++i) {
    const T value = p.wiz[i] > 0 && p.woz[i] > 0 ? f(i, halfVector(p, i)) : T(0);
    for (std::size_t c = 0; c < 3; ++c) out[c * p.count + i] = scale[c] * value;
  }
}

}  // namespace

template <class T>
void ggx(const Pairs<T>& p, T alpha, T ior, const T* scale, T* out) {
  forEach(p, scale, out, [&](std::size_t i, const Half<T>& h) {
    const T a2 = alpha * alpha, k = h.z * h.z * (a2 - 1) + 1;
    const T d = a2 / (kPi<T> * k * k), ci = p.wiz[i], co = p.woz[i];
    const T v = T(0.5) / (co * std::sqrt(ci * ci * (1 - a2) + a2) + ci * std::sqrt(co * co * (1 - a2) + a2));
    return d * v * dielectric(h.d, ior);
  });
}

template <class T>
void ward(const Pairs<T>& p, T ax, T ay, const T* scale, T* out) {
  forEach(p, scale, out, [&](std::size_t i, const Half<T>& h) {
    const T e = (h.x * h.x / (ax * ax) + h.y * h.y / (ay * ay)) / (h.z * h.z);
    return std::exp(-e) / (4 * kPi<T> * ax * ay * std::sqrt(p.wiz[i] * p.woz[i]));
  });
}

template <class T>
void cookTorrance(const Pairs<T>& p, T m, T ior, const T* scale, T* out) {
  forEach(p, scale, out, [&](std::size_t i, const Half<T>& h) {
    const T z2 = h.z * h.z, ci = p.wiz[i], co = p.woz[i];
    const T d = std::exp((z2 - 1) / (m * m * z2)) / (kPi<T> * m * m * z2 * z2);
    const T g = std::min(T(1), std::min(2 * h.z * ci / h.d, 2 * h.z * co / h.d));
    return d * g * dielectric(h.d, ior) / (4 * ci * co);
  });
}

template <class T>
void ashikhminShirley(const Pairs<T>& p, T nu, T nv, T f0, const T* scale, T* out) {
  const T norm = std::sqrt((nu + 1) * (nv + 1)) / (8 * kPi<T>);
  forEach(p, scale, out, [&](std::size_t i, const Half<T>& h) {
    const T s2 = 1 - h.z * h.z;
    const T e = s2 > 0 ? (nu * h.x * h.x + nv * h.y * h.y) / s2 : T(0);
    const T f = f0 + (1 - f0) * std::pow(1 - h.d, T(5));
    return norm * std::pow(h.z, e) * f / (h.d * std::max(p.wiz[i], p.woz[i]));
  });
}

template <class T>
void sgd(const Pairs<T>& p, const T* parameters, const T* scale, T* out) {
  for (std::size_t i = 0; i < p.count; ++i) {
    const bool above = p.wiz[i] > 0 && p.woz[i] > 0;
    const Half<T> h = halfVector(p, i);
    const T ti = std::acos(p.wiz[i]), to = std::acos(p.woz[i]), z2 = h.z * h.z;
    for (std::size_t c = 0; c < 3; ++c) {
      const T* q = parameters + 9 * c;
      const T x = q[0] + (1 - z2) / z2 / q[0];
      const T d = q[4] * std::exp(-x) / (std::pow(x, q[1]) * kPi<T> * z2 * z2);
      const T f = q[2] + (1 - q[2]) * std::pow(1 - h.d, T(5)) - q[3] * h.d;
      const auto g1 = [&](T theta) {
        return theta > q[8] ? std::max(T(0), 1 + q[5] * (1 - std::exp(q[6] * std::pow(theta - q[8], q[7])))) : T(1);
      };
      out[c * p.count + i] =
          above ? scale[c] * d * std::max(T(0), f) * g1(ti) * g1(to) / (kPi<T> * p.wiz[i] * p.woz[i]) : T(0);
    }
  }
}

#define INSTANTIATE(T)                                                    \
  template void ggx(const Pairs<T>&, T, T, const T*, T*);                 \
  template void ward(const Pairs<T>&, T, T, const T*, T*);                \
  template void cookTorrance(const Pairs<T>&, T, T, const T*, T*);        \
  template void ashikhminShirley(const Pairs<T>&, T, T, T, const T*, T*); \
  template void sgd(const Pairs<T>&, const T*, const T*, T*);
INSTANTIATE(float)
INSTANTIATE(double)

}  // namespace scalar
