#include <brdf/base/ChildProcess.h>
#include <brdf/base/Error.h>
#include <brdf/base/Parallel.h>
#include <brdf/base/Text.h>
#include <brdf/io/BuiltInKinds.h>
#include <brdf/simulate/external/AnswerReader.h>
#include <brdf/simulate/external/ProgramBrdf.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <condition_variable>
#include <memory>
#include <mutex>

namespace brdf {
namespace {

constexpr std::string_view kHeader = "wi_x,wi_y,wi_z,wo_x,wo_y,wo_z\n";
constexpr std::size_t kRowsAtOnce = 512;  // text of that many is held before it is written
constexpr double kGoodbye = 2;            // seconds that a program which stays is given to end by itself
constexpr std::size_t kMostShown = 120;   // characters of the command in an error

using Process = std::unique_ptr<ChildProcess>;

/// The processes of one BRDF: at most `limit` in use, those that stay kept for the next batch.
class Pool {
 public:
  explicit Pool(std::size_t limit) : limit_(limit) {}
  ~Pool() {
    for (const Process& process : idle_) process->finish(kGoodbye);
  }

  /// Waits for a turn; null: the caller is to start one.
  Process take() {
    std::unique_lock lock(mutex_);
    turn_.wait(lock, [&] { return used_ < (limit_ ? limit_ : threadCount()); });
    ++used_;
    if (idle_.empty()) return nullptr;
    Process process = std::move(idle_.back());
    idle_.pop_back();
    return process;
  }
  /// Ends a turn; null: the process is gone.
  void give(Process process) {
    const std::lock_guard lock(mutex_);
    --used_;
    if (process) idle_.push_back(std::move(process));
    turn_.notify_one();
  }

 private:
  std::mutex mutex_;
  std::condition_variable turn_;
  std::vector<Process> idle_;
  std::size_t limit_, used_ = 0;
};

/// A turn of the pool, ended by its end.
class Turn {
 public:
  explicit Turn(Pool& pool) : process(pool.take()), pool_(pool) {}
  ~Turn() { pool_.give(std::move(process)); }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;

  Process process;

 private:
  Pool& pool_;
};

void appendRow(std::string& text, const DirectionPairs<double>& pairs, std::size_t i) {
  char buffer[32];
  for (const auto* w : {&pairs.wi, &pairs.wo})
    for (std::size_t axis = 0; axis < 3; ++axis) {
      text.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, (*w)[axis][i]).ptr);
      text += w == &pairs.wo && axis == 2 ? '\n' : ',';
    }
}

class ProgramBrdf final : public Brdf {
 public:
  explicit ProgramBrdf(ProgramOptions options)
      : options_(std::move(options)),
        channels_(options_.channels.value_or(Channels())),
        pool_(std::make_unique<Pool>(options_.processes)) {
    if (options_.command.empty() || options_.command[0].empty())
      throw Error(Error::Kind::Value, {"no program given", "program", {}, "a program and its arguments"});
    if (options_.channels && options_.channels->count() == 0)
      throw Error(Error::Kind::Value, {"no channels", name(), "no wavelengths", "at least one"});
    if (!(options_.timeLimit >= 0))
      throw Error(Error::Kind::Value,
                  {"unusable time limit", name(), formatNumber(options_.timeLimit), "0 or more seconds"});
    if (!options_.channels) learnChannels();
  }

  const Channels& channels() const override { return channels_; }
  Symmetry symmetry() const override { return options_.symmetry; }
  bool reciprocal() const override { return options_.reciprocal; }
  std::string description() const override { return "program:" + programText(options_); }

  void evaluate(const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const override {
    const std::size_t count = pairs.count, channelCount = channels_.count();
    std::fill_n(values, channelCount * count, 0.0);
    if (valid) std::fill_n(valid, count, std::uint8_t{1});
    std::vector<std::size_t> above;
    for (std::size_t i = 0; i < count; ++i)
      if (pairs.wi[2][i] > 0 && pairs.wo[2][i] > 0) above.push_back(i);
    if (above.empty()) return;
    const AnswerReader answers = ask(pairs, above, channels_);
    for (std::size_t k = 0; k < above.size(); ++k) {
      const double* row = answers.row(k);
      if (std::any_of(row, row + channelCount, [](double value) { return std::isnan(value); })) {
        if (valid) valid[above[k]] = 0;
        continue;
      }
      for (std::size_t c = 0; c < channelCount; ++c) values[c * count + above[k]] = row[c];
    }
  }
  using Brdf::evaluate;

 private:
  std::string name() const {
    const std::string text = "program:" + joined(options_.command, " ");
    return text.size() <= kMostShown ? text : text.substr(0, kMostShown) + "...";
  }

  void learnChannels() {
    DirectionPairBuffer<double> mirror(1);
    mirror.set(0, {0, 0, 1}, {0, 0, 1});
    channels_ = ask(mirror.view(), {0}, std::nullopt).channels();
  }

  [[noreturn]] void fail(ChildProcess& process, const std::string& what, const std::string& found,
                         const std::string& allowed) const {
    process.finish(0);
    const std::string complaint = process.lastComplaint();
    throw Error(Error::Kind::Value,
                {what + (complaint.empty() ? "" : " (it said: " + complaint + ")"), name(), found, allowed});
  }

  AnswerReader ask(const DirectionPairs<double>& pairs, const std::vector<std::size_t>& rows,
                   const std::optional<Channels>& channels) const {
    Turn turn(*pool_);
    Process process = std::move(turn.process);
    const bool fresh = !process;
    if (fresh) process = std::make_unique<ChildProcess>(options_.command, !options_.stays);

    std::size_t next = 0;
    const auto feed = [&](std::string& text) {
      if (next == 0 && fresh) text = kHeader;
      const std::size_t last = std::min(rows.size(), next + kRowsAtOnce);
      for (; next < last; ++next) appendRow(text, pairs, rows[next]);
      if (next < rows.size()) return true;
      if (options_.stays) text += '\n';
      return false;
    };
    AnswerReader answers(channels, rows.size());
    bool ended = false;  // by the blank line of a program that stays
    const auto line = [&](std::string_view text) {
      ended = options_.stays && trimmed(text).empty();
      if (!trimmed(text).empty()) answers.take(trimmed(text));
      return !ended;
    };
    ChildProcess::End end{};
    try {
      end = process->exchange(feed, line, !options_.stays, options_.timeLimit);
    } catch (const Error& error) {
      fail(*process, error.details().what + ", " + error.details().where, error.details().found,
           error.details().allowed);
    }
    const std::string answered = std::to_string(answers.rows()) + " of " + std::to_string(rows.size()) + " values";
    if (end == ChildProcess::End::TooSlow)
      fail(*process, "no sign of it for " + formatNumber(options_.timeLimit) + " s, so it was ended", answered,
           std::string("--time-limit SECONDS for more") +
               (options_.stays ? "; a program that stays flushes its output when it reads an empty line" : ""));
    if (end == ChildProcess::End::TooLong) fail(*process, "a line without an end", "over 1 MiB", "one line a pair");
    if (!options_.stays || !ended) {
      const bool good = process->finish(options_.timeLimit > 0 ? options_.timeLimit : 1e9);
      if (!good) fail(*process, "it " + process->ending(), answered, "exit code 0");
      if (!answers.complete() || options_.stays)
        fail(*process, "it ended too early", answered,
             options_.stays ? "a program that stays answers an empty line by an empty line, and goes on"
                            : "one line a pair of directions");
    }
    if (!answers.complete()) fail(*process, "too few lines of values", answered, "one line a pair of directions");
    if (options_.stays) turn.process = std::move(process);
    return answers;
  }

  ProgramOptions options_;
  Channels channels_;
  std::unique_ptr<Pool> pool_;
};

}  // namespace

BrdfPointer programBrdf(ProgramOptions options) { return std::make_shared<ProgramBrdf>(std::move(options)); }

MaterialKind programKind() {
  return {"program",
          "program:[OPTION...] COMMAND [ARGUMENT...], values that another program computes (docs/external-programs.md)",
          [](std::string_view arguments) { return programBrdf(parseProgram(arguments)); }};
}

}  // namespace brdf
