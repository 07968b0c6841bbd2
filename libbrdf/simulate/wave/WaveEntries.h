#pragma once
// Internal to libbrdf/simulate/wave: how models are listed and made.
#include <brdf/simulate/wave/WaveArguments.h>

#include <functional>
#include <vector>

namespace brdf::wave {

using Models = std::vector<ScatterModelPointer>;

/// A model, and how it is made for every wavelength.
struct Entry {
  WaveKind kind;
  std::function<Models(WaveReader&)> make;
};

inline const Parameter kEta = numberRecord(
    "eta", "1", "Real part of the substrate's refractive index, or one a wavelength.", 1.5, 1e-6, 1e4, 0.1, 5, true);
inline const Parameter kK = numberRecord(
    "k", "1", "Imaginary part of the substrate's refractive index, or one a wavelength.", 0, 0, 1e9, 0, 10);

inline const WaveArgument kIndexArgument{
    "index", "index", "The substrate's refractive index by wavelength, in place of eta and k.", "", {}};
inline const WaveArgument kFilmsArgument{"films", "films", "Films on the substrate.", "", {}};

/// Rough surfaces and facets.
std::vector<Entry> surfaceEntries();

}  // namespace brdf::wave
