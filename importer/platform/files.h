// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

/// Calls of the operating system about files, in files_posix.cpp and files_windows.cpp. Files are descriptors of the C
/// library, as zlib takes them. No call translates line ends. If a call fails, errno says why.
namespace sinew::platform {

/// Convert between paths and texts in UTF-8. std::filesystem::path reads a std::string in the code page of Windows,
/// which loses other letters.
inline std::filesystem::path path_of(std::string_view text) { return std::u8string(text.begin(), text.end()); }
inline std::string text_of(const std::filesystem::path& path) {
  const std::u8string text = path.u8string();
  return {text.begin(), text.end()};
}

/// Identifies a file on the disk, whatever its path: the numbers of its device and of its entry there.
using FileIdentity = std::pair<std::uint64_t, std::uint64_t>;

/// Opens a file to read. Does not wait for the other end of a pipe and does not take over a terminal.   out   a
/// descriptor, or -1
int open_to_read(const std::filesystem::path& path) noexcept;

/// Creates a file to write. Fails if the file exists.   out   a descriptor, or -1
int create_new(const std::filesystem::path& path) noexcept;
/// Opens an existing pipe, terminal or device to write.   out   a descriptor, or -1
int open_to_write(const std::filesystem::path& path) noexcept;
/// Creates a temporary file, which is deleted when its descriptor is closed.   out   a descriptor, or -1
int open_temporary();
/// Duplicates a descriptor. Both share the position in the file.   out   a descriptor, or -1
int duplicate(int descriptor) noexcept;
void close(int descriptor) noexcept;

/// Returns the size of a regular file; empty for folders, pipes and devices.
std::optional<std::uint64_t> regular_size(int descriptor) noexcept;
FileIdentity identity_of(int descriptor) noexcept;
/// Returns the identity of the file with this name; empty if there is none.
std::optional<FileIdentity> identity_at(const std::filesystem::path& path) noexcept;

/// Fills `out` with the next bytes of the file.   out   false if the file ends before `out` is full
bool read_all(int descriptor, std::span<std::byte> out) noexcept;
/// Reads once, up to the size of `out`.   out   number of bytes, 0 at the end, empty on failure
std::optional<std::size_t> read_some(int descriptor, std::span<std::byte> out) noexcept;
bool write_all(int descriptor, std::span<const std::byte> bytes) noexcept;
/// Waits until the disk has all bytes that were written.
bool flush_to_disk(int descriptor) noexcept;
/// Sets the position at which the next call reads or writes.
bool seek(int descriptor, std::uint64_t place) noexcept;

bool remove(const std::filesystem::path& path) noexcept;
/// Renames a file, and replaces the file that has the new name.
bool rename_over(const std::filesystem::path& from, const std::filesystem::path& to) noexcept;

/// Makes a name in the folder of `path` that no other process uses at this time.
std::filesystem::path temporary_beside(const std::filesystem::path& path);

}  // namespace sinew::platform
