#include <brdf/base/Error.h>
#include <brdf/simulate/wave/ScatterModel.h>

namespace brdf::wave {

ScatterModel::~ScatterModel() = default;

void ScatterModel::jones(const Geometry*, std::size_t, Jones*) const {
  throw Error(Error::Kind::Value, {"depolarises: it has Mueller matrices, no Jones matrices", "wave model", {}, {}});
}

void ScatterModel::mueller(const Geometry* geometry, std::size_t count, Mueller* values) const {
  constexpr std::size_t block = 64;
  Jones part[block];
  for (std::size_t first = 0; first < count; first += block) {
    const std::size_t length = std::min(block, count - first);
    jones(geometry + first, length, part);
    for (std::size_t k = 0; k < length; ++k) values[first + k] = muellerOf(part[k]);
  }
}

void ScatterModel::unpolarized(const Geometry* geometry, std::size_t count, double* values) const {
  constexpr std::size_t block = 64;
  if (!deterministic()) {
    Mueller part[block];
    for (std::size_t first = 0; first < count; first += block) {
      const std::size_t length = std::min(block, count - first);
      mueller(geometry + first, length, part);
      for (std::size_t k = 0; k < length; ++k) values[first + k] = part[k].m[0];
    }
    return;
  }
  Jones part[block];
  for (std::size_t first = 0; first < count; first += block) {
    const std::size_t length = std::min(block, count - first);
    jones(geometry + first, length, part);
    for (std::size_t k = 0; k < length; ++k) values[first + k] = wave::unpolarized(part[k]);
  }
}

double ScatterModel::specular(double) const { return 0; }

}  // namespace brdf::wave
