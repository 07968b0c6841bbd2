#include <brdf/fit/Gram.h>

// One source for several instruction sets; the dynamic linker picks.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && defined(__linux__)
#define BRDF_CLONES __attribute__((target_clones("default", "arch=haswell")))
#else
#define BRDF_CLONES
#endif

namespace brdf {
namespace {

// Four sums of four: enough to hide the latency of an addition, and the same order of summation on every machine.
constexpr std::size_t kLanes = 16;

}  // namespace

BRDF_CLONES void addProducts(const double* data, std::size_t columns, const double* other, std::size_t count,
                             double* products) {
  for (std::size_t k = 0; k < columns; ++k) {
    const double* column = data + k * count;
    double sums[kLanes] = {};
    std::size_t i = 0;
    for (; i + kLanes <= count; i += kLanes)
      for (std::size_t lane = 0; lane < kLanes; ++lane) sums[lane] += column[i + lane] * other[i + lane];
    double total = 0;
    for (; i < count; ++i) total += column[i] * other[i];
    for (std::size_t lane = 0; lane < kLanes; ++lane) total += sums[lane];
    products[k] += total;
  }
}

void addGram(const double* data, std::size_t columns, std::size_t count, double* gram) {
  for (std::size_t row = 0; row < columns; ++row)
    addProducts(data + row * count, columns - row, data + row * count, count, gram + row * columns + row);
}

}  // namespace brdf
