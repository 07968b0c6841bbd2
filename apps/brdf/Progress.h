#pragma once
#include "Output.h"

#include <chrono>
#include <string>

namespace brdf::app {

/// While one lives, the command asks interrupted() now and then, and keeps what is done when it says so.
class Interruptible {
 public:
  Interruptible();
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;
};

/// Progress of long work: one line that renews itself on a terminal (standard error), plain lines every two seconds
/// otherwise (standard output, with the other text). Nothing with --quiet.
class Progress {
 public:
  Progress(const Output& output, std::string title);
  ~Progress();

  /// `done` of `total` with a remark; total 0 when it is not known. Cheap to call often; from one thread.
  void update(std::size_t done, std::size_t total, const std::string& remark = {});

 private:
  Interruptible interruptible_;
  const Output& output_;
  std::string title_;
  bool terminal_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point next_;
};

/// From now on Ctrl-C (or a request to terminate) asks an Interruptible command to stop at its next safe point and keep
/// what is done; any other command, or another Ctrl-C half a second later, ends at once with the half-written files
/// removed and exit code 1. To be called before the process has other threads.
void handleInterrupts();
bool interrupted();

}  // namespace brdf::app
