#pragma once
#include <brdf/simulate/Microsurface.h>

#include <array>
#include <cstdint>

namespace brdf {

/// Which dielectrics a ray is within: how many times it entered each more often than it left it. Where several overlap,
/// the first is there.
struct Media {
  static constexpr int kNone = -1;  ///< outside of all, where the index is 1
  std::array<std::uint8_t, kMostDielectrics> entered{};

  int current() const {
    for (std::size_t k = 0; k < entered.size(); ++k)
      if (entered[k] > 0) return static_cast<int>(k);
    return kNone;
  }
  bool within(int medium) const { return medium != kNone && entered[static_cast<std::size_t>(medium)] > 0; }
  Media entering(int medium) const { return changed(medium, 1); }
  Media leaving(int medium) const { return changed(medium, -1); }

 private:
  Media changed(int medium, int by) const {
    Media media = *this;
    auto& count = media.entered[static_cast<std::size_t>(medium)];
    if (by < 0 || count < 255) count = static_cast<std::uint8_t>(count + by);
    return media;
  }
};

}  // namespace brdf
