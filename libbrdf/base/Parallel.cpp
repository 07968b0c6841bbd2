#include <brdf/base/Parallel.h>

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <memory>
#include <mutex>

namespace brdf {
namespace {

std::mutex controlMutex;
std::unique_ptr<tbb::global_control> control;

}  // namespace

void parallelFor(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body) {
  if (count == 0) return;
  grain = std::max<std::size_t>(grain, 1);
  if (count <= grain) return body(0, count);
  // Chunks are multiples of the grain, so that results summed by chunk do not depend on the number of threads.
  const std::size_t chunks = (count + grain - 1) / grain;
  tbb::parallel_for(std::size_t{0}, chunks,
                    [&](std::size_t chunk) { body(chunk * grain, std::min(count, (chunk + 1) * grain)); });
}

std::size_t threadCount() { return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism); }

void setThreadCount(std::size_t count) {
  const std::lock_guard lock(controlMutex);
  control.reset();
  if (count > 0) control = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, count);
}

}  // namespace brdf
