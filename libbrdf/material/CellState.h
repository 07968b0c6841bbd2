#pragma once
#include <cstdint>

namespace brdf {

/// What a cell of a table holds. Tables keep one byte a cell; where only "valid or not" is asked, any but Invalid is
/// valid: it can be looked up. Only Measured cells are samples (SampleSet).
enum class CellState : std::uint8_t {
  Invalid = 0,      ///< no value; kept as 0
  Measured = 1,     ///< as the data give it
  Extrapolated = 2  ///< filled by a named method (material/FillHoles.h), or by the data's author
};

constexpr std::uint8_t stateByte(CellState state) { return static_cast<std::uint8_t>(state); }

}  // namespace brdf
