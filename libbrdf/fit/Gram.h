#pragma once
#include <cstddef>

namespace brdf {

/// Adds to `gram` (columns x columns, row-major, the upper triangle) the products of all pairs of `columns` arrays of
/// `count` numbers, the first at `data`, each `count` after the one before.
void addGram(const double* data, std::size_t columns, std::size_t count, double* gram);

/// Adds to products[k] the product of column k with `other`.
void addProducts(const double* data, std::size_t columns, const double* other, std::size_t count, double* products);

}  // namespace brdf
