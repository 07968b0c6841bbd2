#pragma once
#include <complex>
#include <cstddef>
#include <vector>

namespace brdf {

/// The discrete Fourier transform of `rows` times `columns` numbers, in place, on all threads:
/// F[n, m] = sum over j, i of f[j, i] exp(-2 pi i (m i / columns + n j / rows)). Inverse: with the other sign, divided
/// by rows * columns. Fast where both have small prime factors only.
void fourierTransform(std::vector<std::complex<double>>& values, std::size_t columns, std::size_t rows, bool inverse);

/// The least even number, at least `least` and 2, with no prime factor above 5.
std::size_t fastLength(std::size_t least);

/// The frequency of index `m` of `count`, in cycles a `period`: negative ones in the upper half.
inline double frequencyOf(std::size_t m, std::size_t count, double period) {
  const auto index = static_cast<double>(m);
  return (m <= count / 2 ? index : index - static_cast<double>(count)) / period;
}

}  // namespace brdf
