#include <brdf/base/ChildProcess.h>
#include <brdf/base/Error.h>
#include <brdf/base/Text.h>

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <thread>
#include <utility>

namespace brdf {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kLongestLine = 1 << 20;   // bytes
constexpr std::size_t kErrorsKept = 4096;       // bytes of standard error
constexpr std::size_t kLongestComplaint = 200;  // characters
constexpr std::size_t kChunk = 1 << 16;         // bytes read at once: a pipe holds as many

/// Keeps SIGPIPE from this thread while it lives: a write to a child that is gone is then an error like others.
class NoPipeSignal {
 public:
  NoPipeSignal() {
    sigemptyset(&pipe_);
    sigaddset(&pipe_, SIGPIPE);
    sigset_t pending;
    sigpending(&pending);
    wasPending_ = sigismember(&pending, SIGPIPE) == 1;
    pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  ~NoPipeSignal() {
    const timespec now{};
    if (!wasPending_)
      while (sigtimedwait(&pipe_, nullptr, &now) == -1 && errno == EINTR) {
      }
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  NoPipeSignal(const NoPipeSignal&) = delete;
  NoPipeSignal& operator=(const NoPipeSignal&) = delete;

 private:
  sigset_t pipe_{}, before_{};
  bool wasPending_ = false;
};

struct Pipe {
  std::array<int, 2> ends{-1, -1};

  /// Both ends above 2, where the child's own standard files go, and closed in every program started meanwhile.
  bool open() {
    std::array<int, 2> raw{};
    if (pipe2(raw.data(), O_CLOEXEC) != 0) return false;
    for (std::size_t i = 0; i < 2; ++i) {
      ends[i] = raw[i];
      if (raw[i] > 2) continue;
      ends[i] = fcntl(raw[i], F_DUPFD_CLOEXEC, 3);
      ::close(raw[i]);
    }
    return ends[0] >= 0 && ends[1] >= 0;
  }
  int take(std::size_t end) { return std::exchange(ends[end], -1); }
  ~Pipe() {
    for (const int end : ends)
      if (end >= 0) ::close(end);
  }
};

/// In the child, between fork and exec: only what may be called there.
[[noreturn]] void becomeProgram(char* const* words, int in, int out, int error, int report, bool endsWithCaller,
                                pid_t parent) {
  sigset_t none;
  sigemptyset(&none);
  std::signal(SIGPIPE, SIG_DFL);
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  sigprocmask(SIG_SETMASK, &none, nullptr);
#ifdef __linux__
  if (endsWithCaller) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(127);
  }
#else
  (void)endsWithCaller;
  (void)parent;
#endif
  if (dup2(in, 0) >= 0 && dup2(out, 1) >= 0 && dup2(error, 2) >= 0) execvp(words[0], words);
  const int reason = errno;
  [[maybe_unused]] const auto told = ::write(report, &reason, sizeof reason);
  _exit(127);
}

void setNonBlocking(int pipe) { fcntl(pipe, F_SETFL, fcntl(pipe, F_GETFL) | O_NONBLOCK); }

[[noreturn]] void cannotStart(const std::string& program, int reason) {
  throw Error(Error::Kind::File,
              {"the program cannot be started", program, std::strerror(reason), "a program on PATH, or its path"});
}

}  // namespace

ChildProcess::ChildProcess(std::vector<std::string> words, bool endsWithCaller) {
  if (words.empty() || words[0].empty())
    throw Error(Error::Kind::Value, {"no program given", {}, {}, "a program and its arguments"});
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  Pipe in, out, error, report;
  if (!in.open() || !out.open() || !error.open() || !report.open()) cannotStart(words[0], errno);
  const pid_t parent = getpid();
  process_ = fork();
  if (process_ == 0)
    becomeProgram(argv.data(), in.ends[0], out.ends[1], error.ends[1], report.ends[1], endsWithCaller, parent);
  if (process_ < 0) cannotStart(words[0], errno);
  ::close(report.take(1));
  int reason = 0;
  ssize_t length = 0;
  do length = ::read(report.ends[0], &reason, sizeof reason);
  while (length < 0 && errno == EINTR);
  if (length == sizeof reason) {
    while (waitpid(process_, &status_, 0) < 0 && errno == EINTR) {
    }
    cannotStart(words[0], reason);
  }
  input_ = in.take(1);
  output_ = out.take(0);
  error_ = error.take(0);
  for (const int pipe : {input_, output_, error_}) setNonBlocking(pipe);
}

ChildProcess::~ChildProcess() {
  if (!ended_) {
    kill(process_, SIGKILL);
    waitFor(std::chrono::seconds(1));
  }
  close(input_);
  close(output_);
  close(error_);
}

void ChildProcess::close(int& pipe) {
  if (pipe >= 0) ::close(std::exchange(pipe, -1));
}

/// Writes what the pipe takes; false when the child no longer reads.
bool ChildProcess::write(std::string_view& text) {
  const NoPipeSignal quiet;
  while (!text.empty()) {
    const ssize_t length = ::write(input_, text.data(), text.size());
    if (length > 0) {
      text.remove_prefix(static_cast<std::size_t>(length));
      continue;
    }
    if (length < 0 && errno == EINTR) continue;
    return length < 0 && (errno == EAGAIN || errno == EWOULDBLOCK);
  }
  return true;
}

/// Keeps the end of what is on standard error; false when it was closed.
bool ChildProcess::readErrors() {
  std::array<char, 1024> chunk;
  while (true) {
    const ssize_t length = ::read(error_, chunk.data(), chunk.size());
    if (length < 0 && errno == EINTR) continue;
    if (length < 0) return errno == EAGAIN || errno == EWOULDBLOCK;
    if (length == 0) return false;
    errors_.append(chunk.data(), static_cast<std::size_t>(length));
    if (errors_.size() > 2 * kErrorsKept) errors_.erase(0, errors_.size() - kErrorsKept);
  }
}

ChildProcess::End ChildProcess::exchange(const Feed& feed, const Line& line, bool closeInput, double patience) {
  std::string text;
  std::string_view toWrite;
  bool more = input_ >= 0;
  auto lastSign = Clock::now();
  std::vector<char> chunk(kChunk);
  while (true) {
    while (more && toWrite.empty()) {
      text.clear();
      more = feed(text);
      toWrite = text;
    }
    if (!more && toWrite.empty() && closeInput) close(input_);

    const int wait = patience > 0 ? 1 + static_cast<int>(1000 * std::min(patience, 3600.0)) : -1;
    std::array<pollfd, 3> pipes{
        {{output_, POLLIN, 0}, {error_, POLLIN, 0}, {toWrite.empty() ? -1 : input_, POLLOUT, 0}}};
    const int ready = poll(pipes.data(), pipes.size(), wait);
    if (ready < 0 && errno != EINTR) return End::Finished;
    if (ready <= 0) {
      if (patience > 0 && std::chrono::duration<double>(Clock::now() - lastSign).count() >= patience)
        return End::TooSlow;
      continue;
    }
    lastSign = Clock::now();
    if (pipes[1].revents && !readErrors()) close(error_);
    if (pipes[2].revents && !write(toWrite)) {
      close(input_);  // it may have heard enough; whether it answers all is seen by its lines
      toWrite = {};
      more = false;
    }
    if (!pipes[0].revents) continue;
    const ssize_t length = ::read(output_, chunk.data(), chunk.size());
    if (length < 0 && (errno == EINTR || errno == EAGAIN || errno == EWOULDBLOCK)) continue;
    if (length <= 0) {
      if (!unread_.empty()) line(std::exchange(unread_, {}));
      return End::Finished;
    }
    unread_.append(chunk.data(), static_cast<std::size_t>(length));
    std::size_t start = 0;
    for (std::size_t end; (end = unread_.find('\n', start)) != std::string::npos; start = end + 1)
      if (!line(std::string_view(unread_).substr(start, end - start))) {
        unread_.erase(0, end + 1);
        return End::Stopped;
      }
    unread_.erase(0, start);
    if (unread_.size() > kLongestLine) return End::TooLong;
  }
}

/// Whether it has ended within that time.
bool ChildProcess::waitFor(std::chrono::duration<double> time) {
  const auto last = Clock::now() + time;
  auto pause = std::chrono::microseconds(50);
  while (!ended_) {
    const pid_t got = waitpid(process_, &status_, WNOHANG);
    // A host program that ignores SIGCHLD leaves no status: then the child's lines have to speak for it.
    if (got < 0 && errno != EINTR) status_ = 0;
    ended_ = got == process_ || (got < 0 && errno != EINTR);
    if (ended_ || Clock::now() > last) break;
    if (error_ >= 0 && !readErrors()) close(error_);
    std::this_thread::sleep_for(pause);
    pause = std::min(2 * pause, std::chrono::microseconds(10000));
  }
  return ended_;
}

bool ChildProcess::finish(double seconds) {
  close(input_);
  if (!waitFor(std::chrono::duration<double>(seconds))) {
    killed_ = true;
    kill(process_, SIGTERM);
    if (!waitFor(std::chrono::seconds(1))) {
      kill(process_, SIGKILL);
      waitFor(std::chrono::seconds(1));
    }
  }
  if (error_ >= 0) readErrors();
  return !killed_ && WIFEXITED(status_) && WEXITSTATUS(status_) == 0;
}

std::string ChildProcess::ending() const {
  if (killed_) return "had to be ended";
  if (WIFSIGNALED(status_))
    return "was ended by signal " + std::to_string(WTERMSIG(status_)) + " (" + strsignal(WTERMSIG(status_)) + ")";
  return "ended with exit code " + std::to_string(WEXITSTATUS(status_));
}

std::string ChildProcess::lastComplaint() const {
  std::string_view last;
  for (const std::string_view text : split(errors_, '\n'))
    if (!text.empty()) last = text;
  std::string clean(last.substr(0, kLongestComplaint));
  std::ranges::replace_if(
      clean, [](char c) { return static_cast<unsigned char>(c) < 32; }, ' ');
  return clean;
}

}  // namespace brdf
