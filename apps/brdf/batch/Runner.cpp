#include "Runner.h"

#include "Progress.h"
#include "Records.h"

#include <brdf/base/Error.h>
#include <brdf/base/Journal.h>
#include <brdf/base/Text.h>

#include <atomic>
#include <chrono>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>

namespace brdf::app {
namespace {

constexpr auto kPause = std::chrono::milliseconds(2);

/// Does tasks one after the other; keeps the last target, which the next task most often shares.
class Worker {
 public:
  Worker(const BatchJob& job, Journal journal) : job_(job), journal_(std::move(journal)) {}

  /// Returns when the outcome is on the disk, with the outcome in words; empty when interrupted.
  std::string perform(std::size_t index) {
    const BatchTask& task = *job_.tasks[index];
    const BatchTarget& target = job_.targets[task.target];
    std::string record, words;
    try {
      const FitReport report = fit(task, target);
      if (stopped_) return {};
      record = fittedRecord(task, target, report, provenance_);
      words = "error " + number(report.error) + " in " + formatNumber(report.seconds, 3) + " s" +
              (report.converged ? "" : ", not converged");
    } catch (const std::bad_alloc&) {
      words = "failed: not enough memory";
    } catch (const std::exception& error) {
      words = std::string("failed: ") + error.what();
    }
    if (record.empty()) record = failedRecord(task, target, words.substr(std::string_view("failed: ").size()));
    journal_.append(record);
    return words;
  }

 private:
  FitReport fit(const BatchTask& task, const BatchTarget& target) {
    if (loaded_ != &target) {
      loaded_ = nullptr;
      brdf_ = nullptr;
      const LoadedMaterial material = loadTarget(target.material);
      brdf_ = material.brdf;
      provenance_ = makeProvenance(material.report);
      loaded_ = &target;
    }
    return task.fit.run(*brdf_, [this](std::size_t, double) {
      stopped_ = stopped_ || interrupted();
      return !stopped_;
    });
  }

  const BatchJob& job_;
  Journal journal_;
  const BatchTarget* loaded_ = nullptr;
  BrdfPointer brdf_;
  Provenance provenance_;
  bool stopped_ = false;
};

/// What rank 0 hands out, to its own worker thread and to other ranks.
class Queue final : public WorkSource {
 public:
  explicit Queue(const std::vector<std::size_t>& open) : open_(open.begin(), open.end()) {}

  std::optional<std::size_t> next() override {
    const std::lock_guard lock(mutex_);
    if (open_.empty() || interrupted()) return std::nullopt;
    const std::size_t task = open_.front();
    open_.pop_front();
    return task;
  }

  void done(std::size_t task, const std::string& words) override {
    if (words.empty()) return;  // interrupted
    const std::lock_guard lock(mutex_);
    done_.emplace_back(task, words);
  }

  /// Tells of what was done since the last call.
  void tell(const std::function<void(std::size_t, const std::string&)>& told) {
    std::deque<std::pair<std::size_t, std::string>> news;
    {
      const std::lock_guard lock(mutex_);
      news.swap(done_);
    }
    for (const auto& [task, words] : news) told(task, words);
  }

 private:
  std::mutex mutex_;
  std::deque<std::size_t> open_;
  std::deque<std::pair<std::size_t, std::string>> done_;
};

/// On another rank than 0.
void workForRankZero(Worker& worker, Ranks& ranks) {
  std::optional<std::size_t> task = ranks.ask(std::nullopt, "");
  while (task) {
    const std::string words = worker.perform(*task);
    task = ranks.ask(task, words);
  }
}

}  // namespace

void runTasks(const BatchJob& job, const std::vector<std::size_t>& open, const std::filesystem::path& folder,
              Ranks* ranks, const std::function<void(std::size_t, const std::string&)>& told,
              const std::function<void()>& idle) {
  Worker worker(job, openJournal(folder, ranks ? ranks->rank() : 0, ranks ? ranks->size() : 1));
  if (ranks && ranks->rank() != 0) return workForRankZero(worker, *ranks);

  Queue queue(open);
  std::exception_ptr failure;
  std::atomic<bool> working{true};
  std::jthread local([&] {
    try {
      while (const auto task = queue.next()) queue.done(*task, worker.perform(*task));
    } catch (...) {
      failure = std::current_exception();
    }
    working = false;
  });
  for (std::size_t others = ranks ? ranks->size() - 1 : 0; working || others > 0;) {
    if (ranks) others = ranks->answer(queue);
    if (!working && failure) break;
    queue.tell(told);
    idle();
    std::this_thread::sleep_for(kPause);
  }
  local.join();
  queue.tell(told);
  if (failure) std::rethrow_exception(failure);
}

}  // namespace brdf::app
