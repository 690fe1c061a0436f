// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace sinew {

/// Decodes "%20" and the like to bytes; nothing where a "%" is not followed by two hexadecimal digits.
std::optional<std::string> percent_decode(std::string_view text);

/// Why a file cannot be read. `forbidden` means that the URI itself is not allowed, whatever is on the disk.
struct FileFault {
  enum class Kind : std::uint8_t { forbidden, missing, too_large };
  Kind kind = Kind::missing;
  std::string detail;
};

/// Reads the files of one import: only below one folder, and in total no more bytes than allowed (G63, G64, G67).
class SandboxedFiles {
 public:
  /// Without a folder every URI is refused: a document in memory has no folder.
  SandboxedFiles(std::optional<std::filesystem::path> folder, std::uint64_t max_total_bytes)
      : folder_(std::move(folder)), left_(max_total_bytes) {}

  /// Reads a relative URI, percent-decoded and taken as UTF-8. Schemes, absolute paths, and paths that leave the folder
  /// by
  /// ".." or by symbolic links are refused. Only regular files are opened.
  tl::expected<std::vector<std::byte>, FileFault> read(std::string_view uri);

  /// Reads any regular file. It is for the document itself.
  tl::expected<std::vector<std::byte>, FileFault> read_path(const std::filesystem::path& path);

  /// Counts bytes from elsewhere (data URIs, the document in memory) against the same limit. False: not so many are
  /// left.
  bool take(std::uint64_t bytes) noexcept;

  std::uint64_t bytes_read() const noexcept { return read_; }

 private:
  tl::expected<std::filesystem::path, FileFault> resolve(std::string_view uri) const;

  std::optional<std::filesystem::path> folder_;
  std::uint64_t left_ = 0;
  std::uint64_t read_ = 0;
};

}  // namespace sinew
