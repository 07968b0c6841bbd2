#include "Ranks.h"

#include <brdf/base/Error.h>

#include <mpi.h>
#include <sched.h>
#include <unistd.h>
#include <vtkMPIController.h>
#include <vtkNew.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <thread>
#include <vector>

namespace brdf::app {
namespace {

constexpr int kRequest = 101, kAnswer = 102;
constexpr vtkIdType kNothing = -1;
// MPI waits by spinning, which would take a core from the fits: look, and sleep.
constexpr auto kPause = std::chrono::milliseconds(2);

class MpiRanks final : public Ranks {
 public:
  MpiRanks() {
    // Other threads of the process fit meanwhile; this one alone speaks MPI.
    int provided = 0;
    if (MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided) != MPI_SUCCESS ||
        provided < MPI_THREAD_FUNNELED)
      throw Error(Error::Kind::Device, {"MPI cannot be started with threads", "MPI_Init_thread", "", ""});
    controller_->Initialize(nullptr, nullptr, 1);
    unanswered_ = size() - 1;
  }
  ~MpiRanks() override {
    controller_->Finalize(1);
    MPI_Finalize();
  }

  std::size_t rank() const override { return static_cast<std::size_t>(controller_->GetLocalProcessId()); }
  std::size_t size() const override { return static_cast<std::size_t>(controller_->GetNumberOfProcesses()); }

  std::size_t sharingCores() override {
    char host[256] = {};
    ::gethostname(host, sizeof host - 1);
    cpu_set_t cores;
    CPU_ZERO(&cores);
    ::sched_getaffinity(0, sizeof cores, &cores);
    std::string identity(host);
    for (int core = 0; core < CPU_SETSIZE; ++core) identity += CPU_ISSET(core, &cores) ? '1' : '0';
    const auto own = static_cast<vtkIdType>(std::hash<std::string>()(identity) >> 1);
    std::vector<vtkIdType> all(size());
    controller_->AllGather(&own, all.data(), 1);
    return static_cast<std::size_t>(std::count(all.begin(), all.end(), own));
  }

  std::string broadcast(const std::string& text) override {
    auto length = static_cast<vtkIdType>(text.size());
    controller_->Broadcast(&length, 1, 0);
    std::string all = rank() == 0 ? text : std::string(static_cast<std::size_t>(length), '\0');
    if (length > 0) controller_->Broadcast(all.data(), length, 0);
    return all;
  }

  std::size_t answer(WorkSource& work) override {
    while (unanswered_ > 0) {
      int waiting = 0, from = 0, length = 0;
      controller_->Iprobe(vtkMultiProcessController::ANY_SOURCE, kRequest, &waiting, &from, "", &length);
      if (!waiting) break;
      std::string message(static_cast<std::size_t>(length), '\0');
      controller_->Receive(message.data(), length, from, kRequest);
      // "TASK WORDS", or "-" from a rank that has done none yet. Without words the rank was told to stop.
      bool stopped = false;
      if (message != "-") {
        const std::string words = message.substr(message.find(' ') + 1);
        stopped = words.empty();
        if (!stopped) work.done(std::stoull(message), words);
      }
      const auto next = stopped ? std::nullopt : work.next();
      const vtkIdType reply = next ? static_cast<vtkIdType>(*next) : kNothing;
      if (!next) --unanswered_;
      controller_->Send(&reply, 1, from, kAnswer);
    }
    return unanswered_;
  }

  std::optional<std::size_t> ask(std::optional<std::size_t> done, const std::string& message) override {
    const std::string request = done ? std::to_string(*done) + " " + message : "-";
    controller_->Send(request.data(), static_cast<vtkIdType>(request.size()), 0, kRequest);
    int waiting = 0, from = 0;
    while (controller_->Iprobe(0, kAnswer, &waiting, &from), !waiting) std::this_thread::sleep_for(kPause);
    vtkIdType reply = kNothing;
    controller_->Receive(&reply, 1, 0, kAnswer);
    return reply == kNothing ? std::nullopt : std::optional(static_cast<std::size_t>(reply));
  }

  [[noreturn]] void abort(int exitCode) override {
    MPI_Abort(MPI_COMM_WORLD, exitCode);
    std::_Exit(exitCode);
  }

 private:
  vtkNew<vtkMPIController> controller_;
  std::size_t unanswered_ = 0;
};

}  // namespace
}  // namespace brdf::app

extern "C" __attribute__((visibility("default"))) brdf::app::Ranks* brdfJoinRanks() { return new brdf::app::MpiRanks; }
