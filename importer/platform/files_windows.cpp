// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <io.h>
#include <process.h>
#include <sys/stat.h>
#include <windows.h>

#include <algorithm>
#include <cerrno>

#include "importer/platform/files.h"

namespace sinew::platform {
namespace {
constexpr std::size_t kMostAtOnce = std::size_t{1} << 30;  // the C library counts in int
}

int open_to_read(const std::filesystem::path& path) noexcept {
  return ::_wopen(path.c_str(), _O_RDONLY | _O_BINARY | _O_NOINHERIT);
}

int create_new(const std::filesystem::path& path) noexcept {
  return ::_wopen(path.c_str(), _O_WRONLY | _O_CREAT | _O_EXCL | _O_BINARY | _O_NOINHERIT, _S_IREAD | _S_IWRITE);
}

void close(int descriptor) noexcept { ::_close(descriptor); }

std::optional<std::uint64_t> regular_size(int descriptor) noexcept {
  struct _stat64 status {};
  if (::_fstat64(descriptor, &status) != 0 || (status.st_mode & _S_IFMT) != _S_IFREG) return std::nullopt;
  return static_cast<std::uint64_t>(status.st_size);
}

FileIdentity identity_of(int descriptor) noexcept {
  BY_HANDLE_FILE_INFORMATION status{};
  const auto handle = reinterpret_cast<HANDLE>(::_get_osfhandle(descriptor));
  if (!::GetFileInformationByHandle(handle, &status)) return {};
  return {status.dwVolumeSerialNumber, std::uint64_t{status.nFileIndexHigh} << 32 | status.nFileIndexLow};
}

bool read_all(int descriptor, std::span<std::byte> out) noexcept {
  while (!out.empty()) {
    const int count = ::_read(descriptor, out.data(), static_cast<unsigned>(std::min(out.size(), kMostAtOnce)));
    if (count <= 0) return false;
    out = out.subspan(static_cast<std::size_t>(count));
  }
  return true;
}

bool write_to_disk(int descriptor, std::span<const std::byte> bytes) noexcept {
  while (!bytes.empty()) {
    const int written = ::_write(descriptor, bytes.data(), static_cast<unsigned>(std::min(bytes.size(), kMostAtOnce)));
    if (written <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return ::_commit(descriptor) == 0;
}

bool remove(const std::filesystem::path& path) noexcept { return ::_wunlink(path.c_str()) == 0; }

bool rename_over(const std::filesystem::path& from, const std::filesystem::path& to) noexcept {
  if (::MoveFileExW(from.c_str(), to.c_str(), MOVEFILE_REPLACE_EXISTING)) return true;
  errno = EACCES;  // callers read errno
  return false;
}

std::filesystem::path temporary_beside(const std::filesystem::path& path) {
  return path.string() + "." + std::to_string(::_getpid()) + ".tmp";
}

}  // namespace sinew::platform
