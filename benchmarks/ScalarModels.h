#pragma once
#include <cstddef>

/// The same formulas as a straightforward programmer writes them: one pair at a time, std:: functions, normalised half
/// vector, RGB scale. What the block evaluator is measured against.
namespace scalar {

template <class T>
struct Pairs {
  const T *wix, *wiy, *wiz, *wox, *woy, *woz;
  std::size_t count;
};

/// `out` is planar: three channels of `count` values. Parameters as in models/lobes.
template <class T>
void ggx(const Pairs<T>& pairs, T alpha, T ior, const T* scale, T* out);
template <class T>
void ward(const Pairs<T>& pairs, T ax, T ay, const T* scale, T* out);
template <class T>
void cookTorrance(const Pairs<T>& pairs, T m, T ior, const T* scale, T* out);
template <class T>
void ashikhminShirley(const Pairs<T>& pairs, T nu, T nv, T f0, const T* scale, T* out);
/// alpha, p, F0, F1, K, Lambda, c, k, theta0 in that order, one set for each channel.
template <class T>
void sgd(const Pairs<T>& pairs, const T* parameters, const T* scale, T* out);

}  // namespace scalar
