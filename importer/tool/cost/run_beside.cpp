// SPDX-License-Identifier: MIT
#include "importer/tool/cost/run_beside.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

#include <fmt/format.h>

extern char** environ;

namespace sinew::cost {
namespace {

std::string read_all(int from) {
  std::string text;
  char part[4096];
  for (ssize_t count = 1; count > 0 || (count < 0 && errno == EINTR);) {
    count = ::read(from, part, sizeof(part));
    if (count > 0) text.append(part, static_cast<std::size_t>(count));
  }
  return text;
}

/// Starts a program with its stdout going to `out` and its stderr discarded; false when that fails.
bool start(const std::string& path, const std::vector<std::string>& arguments, int out, pid_t& process) {
  std::vector<std::string> words{path};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, out, STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  const bool started = posix_spawn(&process, path.c_str(), &actions, nullptr, argv.data(), environ) == 0;
  posix_spawn_file_actions_destroy(&actions);
  return started;
}

}  // namespace

tl::expected<std::string, std::string> output_of_program_beside(const std::string& program,
                                                                const std::vector<std::string>& arguments) {
  std::error_code error;
  const std::filesystem::path path = std::filesystem::read_symlink("/proc/self/exe", error).parent_path() / program;
  if (error || !std::filesystem::exists(path, error))
    return tl::unexpected(fmt::format("there is no program {} beside this one", program));
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return tl::unexpected(std::string("there are too many open files"));
  pid_t process = 0;
  const bool started = start(path.string(), arguments, ends[1], process);
  ::close(ends[1]);
  std::string text = started ? read_all(ends[0]) : std::string();
  ::close(ends[0]);
  if (!started) return tl::unexpected(fmt::format("{} cannot be started", path.string()));
  int status = 0;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status)) return tl::unexpected(fmt::format("{} was ended by signal {}", program, WTERMSIG(status)));
  if (WEXITSTATUS(status) != 0)
    return tl::unexpected(fmt::format("{} ended with status {}", program, WEXITSTATUS(status)));
  return text;
}

}  // namespace sinew::cost
