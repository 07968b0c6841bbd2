#pragma once
#include <brdf/brdf_export.h>

#include <cstddef>
#include <functional>

namespace brdf {

/// Calls `body(first, last)` over disjoint ranges that cover [0, count), on all threads that the process may use.
/// Every range starts at a multiple of `grain` and has `grain` items (the last may have fewer), so that results kept by
/// `first / grain` do not depend on the number of threads. An exception in a body ends the loop and is rethrown.
BRDF_EXPORT void parallelFor(std::size_t count, std::size_t grain,
                             const std::function<void(std::size_t first, std::size_t last)>& body);

/// Number of threads that parallelFor may use; setting it to 0 restores the default (all cores).
BRDF_EXPORT std::size_t threadCount();
BRDF_EXPORT void setThreadCount(std::size_t count);

}  // namespace brdf
