// SPDX-License-Identifier: MIT
#include "importer/tool/files/output.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>

#include "importer/platform/files.h"
#include "importer/tool/messages.h"
#include "importer/write/replace_file.h"

namespace sinew::tool {
namespace fs = std::filesystem;
namespace {

/// Writes a stream from begin to end.
/// out   empty, or the error
std::optional<std::string> write_stream(const fs::path& output, std::span<const std::byte> bytes) {
  errno = 0;
  if (is_standard_output(output)) {
    if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) == bytes.size() && std::fflush(stdout) == 0)
      return std::nullopt;
    return std::strerror(errno);
  }
  const int file = platform::open_to_write(output);
  if (file < 0) return std::strerror(errno);
  const std::optional<std::string> fault =
      platform::write_all(file, bytes) ? std::nullopt : std::optional<std::string>(std::strerror(errno));
  platform::close(file);
  return fault;
}

}  // namespace

bool is_standard_output(const fs::path& output) {
  return output == "-" || output == "/dev/stdout" || output == "/dev/fd/1" || output == "/proc/self/fd/1";
}

bool is_stream(const fs::path& output) {
  std::error_code error;
  const fs::file_type type = fs::status(output, error).type();
  return is_standard_output(output) || type == fs::file_type::fifo || type == fs::file_type::character;
}

std::optional<std::string> find_output_error(const fs::path& output, std::span<const fs::path> inputs) {
  std::error_code error;
  const auto is_output = [&](const fs::path& input) { return fs::equivalent(input, output, error); };
  if (std::any_of(inputs.begin(), inputs.end(), is_output))
    return platform::text_of(output) + " is read; it is left as it is";
  if (is_stream(output)) return std::nullopt;
  if (fs::exists(output, error) && !fs::is_regular_file(output, error))
    return platform::text_of(output) + " exists and is not a regular file";
  const fs::path folder = output.has_parent_path() ? output.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error)) return "there is no folder " + platform::text_of(folder);
  return std::nullopt;
}

ExitCode write_output(const fs::path& output, std::span<const std::byte> bytes) {
  const auto error = is_stream(output) ? write_stream(output, bytes) : write::replace_file(output, bytes);
  if (!error) return ExitCode::done;
  return fail_with(ExitCode::machine_lacks, platform::text_of(output), {Severity::error, "write-file", "", *error});
}

}  // namespace sinew::tool
