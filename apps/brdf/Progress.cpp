#include "Progress.h"

#include <brdf/base/File.h>

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <thread>

namespace brdf::app {
namespace {

using Clock = std::chrono::steady_clock;

std::atomic<int> askers{0};  // commands that look at interrupted()
std::atomic<bool> stopWanted{false};
/// One wish to stop may arrive twice: `timeout` signals the program and then its group, with the program in it.
constexpr auto sameWish = std::chrono::milliseconds(500);

void waitForInterrupts(sigset_t signals) {
  Clock::time_point first;
  while (true) {
    int signal = 0;
    if (sigwait(&signals, &signal) != 0) return;
    if (stopWanted && Clock::now() - first < sameWish) continue;
    if (askers > 0 && !stopWanted.exchange(true)) {
      first = Clock::now();
      continue;
    }
    removeTemporaryFiles();
    std::fputs(isatty(STDERR_FILENO) ? "\nbrdf: interrupted\n" : "brdf: interrupted\n", stderr);
    std::_Exit(1);
  }
}

}  // namespace

Interruptible::Interruptible() { ++askers; }
Interruptible::~Interruptible() { --askers; }

Progress::Progress(const Output& output, std::string title)
    : output_(output),
      title_(std::move(title)),
      terminal_(isatty(STDERR_FILENO) != 0),
      next_(Clock::now() + std::chrono::milliseconds(terminal_ ? 200 : 2000)) {}

Progress::~Progress() {
  if (shown_ && terminal_) std::fputs("\r\033[K", stderr);
}

void Progress::update(std::size_t done, std::size_t total, const std::string& remark) {
  if (output_.quiet) return;
  const auto now = Clock::now();
  if (now < next_) return;
  next_ = now + std::chrono::milliseconds(terminal_ ? 100 : 2000);
  std::string text = title_;
  if (total > 0) {
    if (terminal_) {
      constexpr std::size_t width = 30;
      const std::size_t filled = width * done / total;
      text += " [" + std::string(filled, '#') + std::string(width - filled, ' ') + "]";
    }
    text += " " + std::to_string(100 * done / total) + " %";
  } else {
    text += " " + std::to_string(done);
  }
  if (!remark.empty()) text += "  " + remark;
  shown_ = true;
  if (terminal_)
    std::fputs(("\r\033[K" + text).c_str(), stderr);
  else
    output_.line(text);
}

void handleInterrupts() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);  // threads made later inherit it: one thread takes the signals
  std::thread(waitForInterrupts, signals).detach();
}

bool interrupted() { return stopWanted; }

}  // namespace brdf::app
