// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "importer/file/regular_file.h"

namespace sinew {

/// Decodes percent-encoding such as "%20"; empty if a "%" is not followed by two hexadecimal digits.
std::optional<std::string> percent_decode(std::string_view text);

/// Why a file cannot be read. `forbidden`: the URI itself is not allowed, independent of the disk.
struct FileFault {
  enum class Kind : std::uint8_t { forbidden, missing, too_large };
  Kind kind = Kind::missing;
  std::string detail;
};

/// Reads the files of one import: only below one folder, and within a limit of total bytes.
class SandboxedFiles {
 public:
  /// in   folder  empty = refuse every URI, for a document in memory
  SandboxedFiles(std::optional<std::filesystem::path> folder, std::uint64_t max_total_bytes)
      : folder_(std::move(folder)), left_(max_total_bytes) {}

  /// Reads a relative URI, percent-decoded and taken as UTF-8. Schemes, absolute paths, and paths that leave the folder
  /// by ".." or by symbolic links are refused. Only regular files are opened. A file that several URIs name is read
  /// once.
  /// in,out  storage   receives the bytes of files not read before; pass the same object in every call
  tl::expected<std::span<const std::byte>, FileFault> read(std::string_view uri,
                                                           std::deque<std::vector<std::byte>>& storage);

  /// Reads any regular file; used for the document itself.
  tl::expected<std::vector<std::byte>, FileFault> read_path(const std::filesystem::path& path);

  /// Counts other bytes (data URIs, the document in memory) against the same limit. False if the limit is exceeded.
  bool take(std::uint64_t bytes) noexcept;

  std::uint64_t bytes_read() const noexcept { return read_; }

  /// Adds a file to paths() that the document refers to but that is not read. Ignores forbidden URIs and missing files.
  void note(std::string_view uri);

  /// The files that were read or noted.
  const std::set<std::filesystem::path>& paths() const noexcept { return paths_; }

 private:
  tl::expected<std::vector<std::byte>, FileFault> read_all(const RegularFile& file);
  tl::expected<std::filesystem::path, FileFault> resolve(std::string_view uri) const;

  std::optional<std::filesystem::path> folder_;
  std::uint64_t left_ = 0;
  std::uint64_t read_ = 0;
  std::map<RegularFile::Identity, std::span<const std::byte>> contents_;
  std::set<std::filesystem::path> paths_;
};

}  // namespace sinew
