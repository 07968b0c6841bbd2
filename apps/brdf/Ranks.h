#pragma once
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>

/// Work shared among the processes (ranks) that `mpirun` started. The part that speaks MPI, through VTK's controller,
/// is a module of its own (brdf_ranks), loaded only where mpirun started the program: without it nothing of MPI is
/// loaded.
namespace brdf::app {

/// What rank 0 hands out: numbered tasks, each once.
class WorkSource {
 public:
  virtual ~WorkSource() = default;
  /// The next task, or nothing more.
  virtual std::optional<std::size_t> next() = 0;
  /// What became of a task, in the words of who did it.
  virtual void done(std::size_t task, const std::string& message) = 0;
};

/// The ranks of this run, seen from one of them. One thread of the process uses it. Ends MPI when destroyed, which all
/// ranks do together.
class Ranks {
 public:
  virtual ~Ranks() = default;
  virtual std::size_t rank() const = 0;
  virtual std::size_t size() const = 0;
  /// How many ranks, this one among them, run on the processor cores that this one may use.
  virtual std::size_t sharingCores() = 0;
  /// Rank 0's text, on all ranks; all call it together.
  virtual std::string broadcast(const std::string& text) = 0;
  /// On rank 0: answers the ranks that have asked by now, and returns how many have yet to be told that nothing is
  /// left.
  virtual std::size_t answer(WorkSource& work) = 0;
  /// On the others: the next task from rank 0, or nothing more; hands in what became of the last one (no words: this
  /// rank was told to stop, and gets nothing more).
  virtual std::optional<std::size_t> ask(std::optional<std::size_t> done, const std::string& message) = 0;
  /// Ends all ranks at once.
  [[noreturn]] virtual void abort(int exitCode) = 0;
};

/// The ranks where mpirun started this process among several; null where it is alone. Throws Error::Kind::Device when
/// this build has no MPI.
std::unique_ptr<Ranks> joinRanks();

}  // namespace brdf::app
