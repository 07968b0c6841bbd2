#include "Progress.h"

#include <unistd.h>

#include <csignal>
#include <cstdio>

namespace brdf::app {
namespace {

volatile std::sig_atomic_t interruptCount = 0;

void onInterrupt(int signal) {
  interruptCount = interruptCount + 1;
  if (interruptCount > 1) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

}  // namespace

Progress::Progress(const Output& output, std::string title)
    : output_(output),
      title_(std::move(title)),
      terminal_(isatty(STDERR_FILENO) != 0),
      next_(std::chrono::steady_clock::now() + std::chrono::milliseconds(terminal_ ? 200 : 2000)) {}

Progress::~Progress() {
  if (shown_ && terminal_) std::fputs("\r\033[K", stderr);
}

void Progress::update(std::size_t done, std::size_t total, const std::string& remark) {
  if (output_.quiet) return;
  const auto now = std::chrono::steady_clock::now();
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

void installInterruptHandler() { std::signal(SIGINT, onInterrupt); }

bool interrupted() { return interruptCount > 0; }

}  // namespace brdf::app
