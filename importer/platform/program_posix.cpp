// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <spawn.h>
#include <sys/utsname.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "importer/platform/program.h"

extern char** environ;

namespace sinew::platform {
namespace {

std::string read_to_end(int from) {
  std::string text;
  char part[4096];
  for (ssize_t count = 1; count > 0 || (count < 0 && errno == EINTR);) {
    count = ::read(from, part, sizeof(part));
    if (count > 0) text.append(part, static_cast<std::size_t>(count));
  }
  return text;
}

/// Starts a program with its stdout going to `out`, and its stderr too or nowhere; false when that fails.
bool start(const std::string& path, const std::vector<std::string>& arguments, int out, bool with_messages,
           pid_t& process) {
  std::vector<std::string> words{path};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, out, STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  if (with_messages)
    posix_spawn_file_actions_adddup2(&actions, out, STDERR_FILENO);
  else
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  const bool started = posix_spawn(&process, path.c_str(), &actions, nullptr, argv.data(), environ) == 0;
  posix_spawn_file_actions_destroy(&actions);
  return started;
}

}  // namespace

void prepare_standard_streams() {}

std::vector<std::string> arguments_of(int argc, const char* const* argv) { return {argv, argv + argc}; }

std::string environment_variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string() : std::string(value);
}

bool is_terminal(int descriptor) noexcept { return ::isatty(descriptor) == 1; }

std::uint64_t process_number() noexcept { return static_cast<std::uint64_t>(::getpid()); }

std::filesystem::path user_cache_folder() {
  if (const std::string folder = environment_variable("XDG_CACHE_HOME"); !folder.empty()) return folder;
  const std::string home = environment_variable("HOME");
  return home.empty() ? std::filesystem::path() : std::filesystem::path(home) / ".cache";
}

std::filesystem::path program_folder() {
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
}

std::string program_file(const std::string& name) { return name; }

tl::expected<EndedProgram, std::string> run_program(const std::filesystem::path& program,
                                                    const std::vector<std::string>& arguments, bool with_messages) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return tl::unexpected(std::string("there are too many open files"));
  pid_t process = 0;
  const bool started = start(program.string(), arguments, ends[1], with_messages, process);
  ::close(ends[1]);
  std::string text = started ? read_to_end(ends[0]) : std::string();
  ::close(ends[0]);
  if (!started) return tl::unexpected(program.string() + " cannot be started");
  int status = 0;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return EndedProgram{WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status), std::move(text)};
}

std::string processor_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

std::string system_name() {
  utsname name{};
  if (::uname(&name) != 0) return "unknown";
  return std::string(name.sysname) + ' ' + name.release + ' ' + name.machine;
}

std::string load_average() {
  double load = 0.0;
  char text[32];
  if (::getloadavg(&load, 1) != 1) return "unknown";
  std::snprintf(text, sizeof text, "%.1f", load);
  return text;
}

}  // namespace sinew::platform
