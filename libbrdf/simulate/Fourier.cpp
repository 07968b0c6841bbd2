#include <brdf/base/Parallel.h>
#include <brdf/simulate/Fourier.h>

#include <unsupported/Eigen/FFT>

namespace brdf {
namespace {

using Complex = std::complex<double>;

/// Transforms lines `first` .. `last` - 1: elements of a line are `step` apart, lines `stride` apart.
void transformLines(std::vector<Complex>& values, std::size_t first, std::size_t last, std::size_t length,
                    std::size_t step, std::size_t stride, bool inverse) {
  Eigen::FFT<double> fft;
  std::vector<Complex> line(length), result(length);
  for (std::size_t k = first; k < last; ++k) {
    Complex* start = values.data() + k * stride;
    for (std::size_t i = 0; i < length; ++i) line[i] = start[i * step];
    if (inverse)
      fft.inv(result, line);
    else
      fft.fwd(result, line);
    for (std::size_t i = 0; i < length; ++i) start[i * step] = result[i];
  }
}

}  // namespace

void fourierTransform(std::vector<Complex>& values, std::size_t columns, std::size_t rows, bool inverse) {
  parallelFor(rows, 16, [&](std::size_t first, std::size_t last) {
    transformLines(values, first, last, columns, 1, columns, inverse);
  });
  parallelFor(columns, 16, [&](std::size_t first, std::size_t last) {
    transformLines(values, first, last, rows, columns, 1, inverse);
  });
}

std::size_t fastLength(std::size_t least) {
  for (std::size_t length = least < 2 ? 2 : least + least % 2;; length += 2) {
    std::size_t rest = length;
    for (const std::size_t prime : {2, 3, 5})
      while (rest % prime == 0) rest /= prime;
    if (rest == 1) return length;
  }
}

}  // namespace brdf
