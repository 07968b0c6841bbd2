#include "Runs.h"

#include <brdf/base/Error.h>
#include <brdf/base/File.h>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>

#include <cerrno>
#include <cstring>

extern char** environ;

namespace brdf::app {

std::string runThisProgram(const std::vector<std::string>& words, const std::filesystem::path& folder,
                           const std::filesystem::path& log) {
  const std::string program = std::filesystem::read_symlink("/proc/self/exe");
  std::vector<char*> arguments = {const_cast<char*>(program.c_str())};  // posix_spawn's signature; it reads only
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.empty() ? "." : folder.c_str());
  posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 2, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  pid_t process = 0;
  const int failure = posix_spawn(&process, program.c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) throw Error(Error::Kind::Device, {"cannot be run", program, std::strerror(failure), ""});
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  std::string text = std::filesystem::exists(log) ? readFile(log, 1 << 20) : "";
  std::filesystem::remove(log);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return "";
  while (text.ends_with('\n')) text.pop_back();
  if (!text.empty()) return text;
  return WIFEXITED(status) ? "exit code " + std::to_string(WEXITSTATUS(status))
                           : "ended by signal " + std::to_string(WTERMSIG(status));
}

}  // namespace brdf::app
