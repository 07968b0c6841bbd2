#pragma once
#include <brdf/brdf_export.h>

#include <chrono>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// Another program, run with pipes on its standard input, output and error. No shell: the words are the argument vector
/// as it is, the first looked for along PATH. The child is of our process group, so that Ctrl-C on the terminal ends it
/// too; it is killed when this object goes before it has ended.
///
/// Nothing here waits for ever on a full pipe: what is written and what is read go on together. A child that no longer
/// reads costs no SIGPIPE. One thread at a time.
class BRDF_EXPORT ChildProcess {
 public:
  /// Throws Error::Kind::File when the program cannot be started, with the system's reason.
  /// `endsWithCaller`: on Linux the child is killed when the calling thread ends, however that comes about; else a
  /// child learns of it by the end of its input.
  ChildProcess(std::vector<std::string> words, bool endsWithCaller);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  enum class End {
    Stopped,   ///< `line` had enough
    Finished,  ///< the child closed its output
    TooSlow,   ///< it neither read nor wrote anything for `patience`
    TooLong    ///< a line without an end, of more than a mebibyte
  };
  using Feed = std::function<bool(std::string& text)>;
  using Line = std::function<bool(std::string_view line)>;
  /// Feeds the child and reads its lines until one of the above. `feed` replaces `text` by what comes next and returns
  /// false after the last; `line` is given each line without its end and returns false for enough. With `closeInput`
  /// the input is closed after the last text. `patience` in seconds, 0 for ever.
  End exchange(const Feed& feed, const Line& line, bool closeInput, double patience);

  /// Closes its input, gives it `seconds` to end by itself, then ends it: SIGTERM, and SIGKILL a second later. True
  /// when it ended by itself with exit code 0.
  bool finish(double seconds);

  /// After finish(): "ended with exit code 3", "was ended by signal 11 (Segmentation fault)".
  std::string ending() const;
  /// The last line that it wrote to its standard error and that is not blank, at most 200 characters.
  std::string lastComplaint() const;

 private:
  bool waitFor(std::chrono::duration<double> time);
  bool write(std::string_view& text);
  bool readErrors();
  void close(int& pipe);

  int input_ = -1, output_ = -1, error_ = -1;
  int process_ = -1;
  int status_ = 0;
  bool ended_ = false, killed_ = false;
  std::string unread_;  // of its output: what came after the last whole line
  std::string errors_;  // the end of what it wrote to its standard error
};

}  // namespace brdf
