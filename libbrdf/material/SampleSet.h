#pragma once
#include <brdf/brdf_export.h>
#include <brdf/geometry/DirectionPairs.h>
#include <brdf/material/Channels.h>

#include <cstdint>

namespace brdf {

/// The samples of measured data in their own order: scattered points, or the cells of a table. Read block by block, so
/// that a table's directions are made on the fly and never stored. Safe to read from several threads.
class BRDF_EXPORT SampleSet {
 public:
  virtual ~SampleSet();

  virtual std::size_t count() const = 0;
  virtual const Channels& channels() const = 0;

  /// Samples first .. first + length - 1 into the buffers (each any of them null to leave out):
  /// `pairs` is resized to `length`; `values` is planar, channel c of sample i at `values[c * length + i]`;
  /// `valid[i]` is 1 where the sample is a measurement: finite, not marked invalid, both directions above the horizon.
  /// The values of an invalid sample are 0.
  virtual void read(std::size_t first, std::size_t length, DirectionPairBuffer<double>* pairs, double* values,
                    std::uint8_t* valid) const = 0;

  /// What the samples stand for: the measure d omega_i d omega_o of each one's cell, up to a factor common to the set.
  /// Returns false, leaving `measures` alone, when they have no cells (scattered points).
  virtual bool solidAngles(std::size_t first, std::size_t length, double* measures) const;

  /// The standard errors of the values, planar as they are, 1/sr; NaN where unknown. Returns false, leaving `errors`
  /// alone, when none is known.
  virtual bool standardErrors(std::size_t first, std::size_t length, double* errors) const;
};

}  // namespace brdf
