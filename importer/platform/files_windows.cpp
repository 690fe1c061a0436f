// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <io.h>
#include <process.h>
#include <sys/stat.h>
#include <windows.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "importer/platform/files.h"

namespace sinew::platform {
namespace {
constexpr std::size_t kMostAtOnce = std::size_t{1} << 30;  // the C library counts in int

FileIdentity identity_of(HANDLE file) noexcept {
  BY_HANDLE_FILE_INFORMATION status{};
  if (!::GetFileInformationByHandle(file, &status)) return {};
  return {status.dwVolumeSerialNumber, std::uint64_t{status.nFileIndexHigh} << 32 | status.nFileIndexLow};
}

}  // namespace

int open_to_read(const std::filesystem::path& path) noexcept {
  return ::_wopen(path.c_str(), _O_RDONLY | _O_BINARY | _O_NOINHERIT);
}

int create_new(const std::filesystem::path& path) noexcept {
  return ::_wopen(path.c_str(), _O_WRONLY | _O_CREAT | _O_EXCL | _O_BINARY | _O_NOINHERIT, _S_IREAD | _S_IWRITE);
}

int open_to_write(const std::filesystem::path& path) noexcept {
  return ::_wopen(path.c_str(), _O_WRONLY | _O_BINARY | _O_NOINHERIT);
}

int open_temporary() {
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::temp_directory_path(error);
  if (error) {
    errno = ENOENT;
    return -1;
  }
  wchar_t name[MAX_PATH + 1];
  if (::GetTempFileNameW(folder.c_str(), L"sin", 0, name) == 0) {
    errno = EACCES;
    return -1;
  }
  return ::_wopen(name, _O_RDWR | _O_BINARY | _O_NOINHERIT | _O_TEMPORARY | _O_SHORT_LIVED);
}

int duplicate(int descriptor) noexcept { return ::_dup(descriptor); }

void close(int descriptor) noexcept { ::_close(descriptor); }

std::optional<std::uint64_t> regular_size(int descriptor) noexcept {
  struct _stat64 status {};
  if (::_fstat64(descriptor, &status) != 0 || (status.st_mode & _S_IFMT) != _S_IFREG) return std::nullopt;
  return static_cast<std::uint64_t>(status.st_size);
}

FileIdentity identity_of(int descriptor) noexcept {
  return identity_of(reinterpret_cast<HANDLE>(::_get_osfhandle(descriptor)));
}

std::optional<FileIdentity> identity_at(const std::filesystem::path& path) noexcept {
  constexpr DWORD kShared = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
  const HANDLE file =
      ::CreateFileW(path.c_str(), 0, kShared, nullptr, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, nullptr);
  if (file == INVALID_HANDLE_VALUE) return std::nullopt;
  const FileIdentity identity = identity_of(file);
  ::CloseHandle(file);
  return identity;
}

std::optional<std::size_t> read_some(int descriptor, std::span<std::byte> out) noexcept {
  const int count = ::_read(descriptor, out.data(), static_cast<unsigned>(std::min(out.size(), kMostAtOnce)));
  if (count < 0) return std::nullopt;
  return static_cast<std::size_t>(count);
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
    const int written = ::_write(descriptor, bytes.data(), static_cast<unsigned>(std::min(bytes.size(), kMostAtOnce)));
    if (written <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return true;
}

bool flush_to_disk(int descriptor) noexcept { return ::_commit(descriptor) == 0; }

bool seek(int descriptor, std::uint64_t place) noexcept {
  return ::_lseeki64(descriptor, static_cast<__int64>(place), SEEK_SET) >= 0;
}

bool remove(const std::filesystem::path& path) noexcept { return ::_wunlink(path.c_str()) == 0; }

bool rename_over(const std::filesystem::path& from, const std::filesystem::path& to) noexcept {
  if (::MoveFileExW(from.c_str(), to.c_str(), MOVEFILE_REPLACE_EXISTING)) return true;
  errno = EACCES;  // errno is what callers read
  return false;
}

std::filesystem::path temporary_beside(const std::filesystem::path& path) {
  std::filesystem::path out = path;
  out += ".";
  out += std::to_string(::_getpid());
  out += ".tmp";
  return out;
}

}  // namespace sinew::platform
