#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/simulate/Transport.h>
#include <brdf/simulate/cpu/CpuTransport.h>

#include <algorithm>

namespace brdf {
namespace {

std::vector<TransportBackend>& registry() {
  static std::vector<TransportBackend> list = {
      {"cpu", "Embree, all threads", [](const Microsurface& surface, const TransportOptions& options) {
         return std::unique_ptr<Transport>(std::make_unique<CpuTransport>(surface, options));
       }}};
  return list;
}

}  // namespace

Transport::~Transport() = default;

void registerTransport(TransportBackend backend) {
  auto& list = registry();
  const auto same = std::ranges::find(list, backend.name, &TransportBackend::name);
  if (same != list.end())
    *same = std::move(backend);
  else
    list.push_back(std::move(backend));
}

const std::vector<TransportBackend>& transportBackends() { return registry(); }

std::unique_ptr<Transport> makeTransport(const std::string& backend, const Microsurface& surface,
                                         const TransportOptions& options) {
  const auto found = std::ranges::find(registry(), backend, &TransportBackend::name);
  if (found == registry().end()) {
    std::vector<std::string> names;
    for (const TransportBackend& known : registry()) names.push_back(known.name);
    throw Error(Error::Kind::Value, {"no such backend here", "backend", backend, joined(names)});
  }
  if (options.bounces < 1 || options.bounces > 1'000'000)
    throw Error(Error::Kind::Value, {"out of range", "bounces", std::to_string(options.bounces), "1 to 1000000"});
  surface.check(surface.description.empty() ? "microsurface" : surface.description);
  return found->make(surface, options);
}

}  // namespace brdf
