#include "Arguments.h"
#include "Commands.h"
#include "Output.h"
#include "Progress.h"
#include "Ranks.h"
#include "batch/Job.h"
#include "batch/Records.h"
#include "batch/Report.h"
#include "batch/Results.h"
#include "batch/Runner.h"

#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/base/FileLock.h>
#include <brdf/base/Parallel.h>

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

namespace fs = std::filesystem;

namespace brdf::app {
namespace {

using Json = nlohmann::ordered_json;

// A batch that was killed frees its lock when its last process has gone.
constexpr auto kLockPatience = std::chrono::seconds(10);

struct Values {
  std::string job, out, report, example;
  bool retry = false, plan = false;
};

FileLock lockFolder(const fs::path& folder) {
  const auto end = std::chrono::steady_clock::now() + kLockPatience;
  do {
    if (auto lock = FileLock::tryAcquire(folder / "lock")) return std::move(*lock);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  } while (std::chrono::steady_clock::now() < end && !interrupted());
  throw Error(Error::Kind::File, {"another batch is at work in the folder", folder.string(), "", "another --out"});
}

/// The job with the hashes of its targets, as rank 0 read it: what all ranks work from.
std::string jobMessage(const std::string& text, const BatchJob& job) {
  Json hashes = Json::array();
  for (const BatchTarget& target : job.targets) hashes.push_back(target.hash);
  return Json{{"job", text}, {"hashes", hashes}}.dump();
}

BatchJob jobOfMessage(const std::string& message, const fs::path& path) {
  const Json json = Json::parse(message);
  std::size_t next = 0;
  return parseBatchJob(json["job"].get<std::string>(), path,
                       [&](const std::string&) { return json["hashes"].at(next++).get<std::string>(); });
}

std::string summary(const BatchCounts& counts) {
  return std::to_string(counts.fits) + " fits: " + std::to_string(counts.fitted) + " done, " +
         std::to_string(counts.failed) + " failed, " + std::to_string(counts.open()) + " open";
}

/// All that rank 0 does.
class Batch {
 public:
  Batch(const Output& output, const Values& values, const fs::path& folder)
      : output_(output), values_(values), folder_(folder) {}

  void run(Ranks* ranks) {
    const Interruptible untilKept;
    std::string message;
    try {
      prepare(message);
    } catch (...) {
      if (ranks) ranks->broadcast("");
      throw;
    }
    if (ranks) ranks->broadcast(values_.plan ? "" : message);
    if (values_.plan) return;
    shareCores(ranks);
    {
      Progress progress(output_, "batch");
      const bool terminal = isatty(STDERR_FILENO) != 0;
      runTasks(
          job_, open_, folder_, ranks,
          [&](std::size_t task, const std::string& words) {
            last_ = titleOf(task) + ": " + words;
            ++done_;
            if (!terminal) output_.line(position() + " " + last_ + " (" + job_.tasks[task]->key + ")");
          },
          [&] {
            if (terminal) progress.update(done_, different_, last_);
          });
    }
    finish();
  }

  static void shareCores(Ranks* ranks) {
    if (!ranks) return;
    const std::size_t sharing = ranks->sharingCores();
    if (sharing > 1) setThreadCount(std::max<std::size_t>(1, threadCount() / sharing));
  }

 private:
  std::string titleOf(std::size_t task) const {
    return job_.tasks[task]->title(job_.targets[job_.tasks[task]->target].name);
  }
  std::string position() const { return "[" + std::to_string(done_) + "/" + std::to_string(different_) + "]"; }

  void prepare(std::string& message) {
    const std::string text = readFile(values_.job, 64 << 20);
    job_ = parseBatchJob(text, values_.job, targetContentHash);
    message = jobMessage(text, job_);
    if (!values_.plan) takeFolder();
    const BatchRecords records(folder_);
    std::set<std::string> keys, openKeys;
    for (std::size_t task = 0; task < job_.tasks.size(); ++task) {
      const std::string& key = job_.tasks[task]->key;
      const auto state = records.state(key);
      keys.insert(key);
      if (state == BatchRecords::State::Open || (values_.retry && state == BatchRecords::State::Failed))
        if (openKeys.insert(key).second) open_.push_back(task);
    }
    different_ = keys.size();
    done_ = different_ - open_.size();
    output_.line(job_.title + ": " + summary(countBatch(job_, records)) + "; results in " + folder_.string());
    if (records.damagedLines() > 0)
      output_.line(
          "  note: " + std::to_string(records.damagedLines()) +
          " lines of the journals are not whole (a fit that was being written when its process ended): done anew");
    if (!values_.plan) return;
    for (const std::size_t task : open_) output_.line("  " + titleOf(task) + " (" + job_.tasks[task]->key + ")");
    output_.report(batchJson(job_, records));
  }

  void takeFolder() {
    std::error_code code;
    fs::create_directories(folder_, code);
    if (!fs::is_directory(folder_))
      throw Error(Error::Kind::File, {"cannot be made", folder_.string(), code.message(), "a folder"});
    lock_.emplace(lockFolder(folder_));
    removeUnfinishedResults(folder_);
  }

  void finish() {
    const BatchRecords records(folder_);
    writeResults(job_, records, folder_);
    const BatchCounts counts = countBatch(job_, records);
    output_.line(summary(counts));
    if (!values_.report.empty()) {
      const std::string noPictures = writeBatchReport(job_, records, folder_, values_.report);
      output_.line((fs::path(values_.report) / "report.md").string() +
                   (noPictures.empty() ? "" : ", without pictures: " + noPictures));
    }
    output_.report(batchJson(job_, records));
    if (counts.open() > 0)
      throw Error(Error::Kind::Value, {"interrupted; what is done was kept, the same command goes on", folder_.string(),
                                       summary(counts), ""});
    if (counts.failed > 0)
      throw Error(Error::Kind::Value, {"fits failed; results.csv says why, --retry tries them again",
                                       (folder_ / "results.csv").string(), summary(counts), ""});
  }

  const Output& output_;
  const Values& values_;
  const fs::path folder_;
  BatchJob job_;
  std::optional<FileLock> lock_;
  std::vector<std::size_t> open_;
  std::size_t different_ = 0;  ///< fits, of which several rows of the job may be one
  std::size_t done_ = 0;       ///< of those
  std::string last_;
};

/// All that another rank does.
void help(Ranks& ranks, const Values& values, const fs::path& folder) {
  const Interruptible untilKept;
  const std::string message = ranks.broadcast("");
  if (message.empty()) return;  // rank 0 says why
  const BatchJob job = jobOfMessage(message, values.job);
  Batch::shareCores(&ranks);
  runTasks(job, {}, folder, &ranks, {}, {});
}

void run(const Output& output, const Values& values) {
  if (!values.example.empty()) {
    writeFile(values.example, exampleBatchJob());
    output.line(values.example + ": a job to start from; it fits sample.binary beside it");
    output.report({{"example", values.example}});
    return;
  }
  if (values.job.empty())
    throw Error(Error::Kind::Usage, {"no job given", "brdf batch", "", "a job file, or --example FILE to write one"});
  const fs::path path = values.job;
  const fs::path folder =
      values.out.empty() ? path.parent_path() / (path.stem().string() + "-results") : fs::path(values.out);
  const std::unique_ptr<Ranks> ranks = joinRanks();
  try {
    if (ranks && ranks->rank() > 0)
      help(*ranks, values, folder);
    else
      Batch(output, values, folder).run(ranks.get());
  } catch (const std::exception& error) {
    // Ranks that wait for this one would wait for ever.
    if (!ranks || ranks->size() == 1) throw;
    std::fprintf(stderr, "brdf: %s\n", error.what());
    std::fflush(nullptr);
    ranks->abort(1);
  }
}

void declare(Arguments& arguments, Values& values) {
  arguments.positional("JOB", values.job, "A job file: JSON with targets and fits (docs/batch.md)");
  arguments.optional();
  arguments.option("--out", values.out, "DIR",
                   "Journals and results: results.csv and results.vtkhdf [JOB's name with -results]");
  arguments.option("--report", values.report, "DIR", "Write report.md there, with tables and pictures");
  arguments.flag("--retry", values.retry, "Try the fits again that failed");
  arguments.flag("--plan", values.plan, "Say what is open, and fit nothing");
  arguments.option("--example", values.example, "FILE.json", "Write a job to start from, and end");
}

}  // namespace

Command batchCommand() {
  const auto values = std::make_shared<Values>();
  return {"batch", "Many fits, in any number of processes (mpirun), that survive being killed",
          "  brdf convert \"0.3*Lambertian + 0.04*GGX(alpha=0.2, ior=1.5)\" sample.binary\n"
          "  brdf batch --example job.json\n"
          "  brdf batch job.json --out results",
          [values](Arguments& arguments) { declare(arguments, *values); },
          [values](const Output& output) { run(output, *values); }};
}

}  // namespace brdf::app
