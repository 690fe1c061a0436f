// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

#include "importer/platform/files.h"

namespace sinew::platform {

int open_to_read(const std::filesystem::path& path) noexcept {
  return ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
}

int create_new(const std::filesystem::path& path) noexcept {
  return ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
}

int open_to_write(const std::filesystem::path& path) noexcept { return ::open(path.c_str(), O_WRONLY | O_CLOEXEC); }

int open_temporary() {
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::temp_directory_path(error);
  std::string name = ((error ? std::filesystem::path("/tmp") : folder) / "sinew.XXXXXX").string();
  const int descriptor = ::mkostemp(name.data(), O_CLOEXEC);
  if (descriptor >= 0) ::unlink(name.c_str());
  return descriptor;
}

int duplicate(int descriptor) noexcept { return ::fcntl(descriptor, F_DUPFD_CLOEXEC, 0); }

void close(int descriptor) noexcept { ::close(descriptor); }

std::optional<std::uint64_t> regular_size(int descriptor) noexcept {
  struct stat status {};
  if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return static_cast<std::uint64_t>(status.st_size);
}

FileIdentity identity_of(int descriptor) noexcept {
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) return {};
  return {static_cast<std::uint64_t>(status.st_dev), static_cast<std::uint64_t>(status.st_ino)};
}

std::optional<FileIdentity> identity_at(const std::filesystem::path& path) noexcept {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return std::nullopt;
  return FileIdentity{static_cast<std::uint64_t>(status.st_dev), static_cast<std::uint64_t>(status.st_ino)};
}

std::optional<std::size_t> read_some(int descriptor, std::span<std::byte> out) noexcept {
  for (;;) {
    const ssize_t count = ::read(descriptor, out.data(), out.size());
    if (count >= 0) return static_cast<std::size_t>(count);
    if (errno != EINTR) return std::nullopt;
  }
}

bool read_all(int descriptor, std::span<std::byte> out) noexcept {
  while (!out.empty()) {
    const auto count = read_some(descriptor, out);
    if (!count || *count == 0) return false;
    out = out.subspan(*count);
  }
  return true;
}

bool write_all(int descriptor, std::span<const std::byte> bytes) noexcept {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return true;
}

bool flush_to_disk(int descriptor) noexcept { return ::fsync(descriptor) == 0; }

bool seek(int descriptor, std::uint64_t place) noexcept {
  return ::lseek(descriptor, static_cast<off_t>(place), SEEK_SET) >= 0;
}

bool remove(const std::filesystem::path& path) noexcept { return ::unlink(path.c_str()) == 0; }

bool rename_over(const std::filesystem::path& from, const std::filesystem::path& to) noexcept {
  return ::rename(from.c_str(), to.c_str()) == 0;
}

std::filesystem::path temporary_beside(const std::filesystem::path& path) {
  std::filesystem::path out = path;
  out += ".";
  out += std::to_string(::getpid());
  out += ".tmp";
  return out;
}

}  // namespace sinew::platform
