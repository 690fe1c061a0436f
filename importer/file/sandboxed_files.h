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

/// "%20" and the like to bytes; nothing where a "%" is not followed by two hexadecimal digits.
std::optional<std::string> percent_decode(std::string_view text);

/// Why a file cannot be had. `forbidden` says that the URI itself is at fault, not what is on the disk.
struct FileFault {
  enum class Kind : std::uint8_t { forbidden, missing, too_large };
  Kind kind = Kind::missing;
  std::string detail;
};

/// Reads files for one import: only below one folder, and not more bytes in all than allowed (G63, G64, G67).
class SandboxedFiles {
 public:
  /// Without a folder every URI is refused: a document in memory has no surroundings.
  SandboxedFiles(std::optional<std::filesystem::path> folder, std::uint64_t max_total_bytes)
      : folder_(std::move(folder)), left_(max_total_bytes) {}

  /// A relative URI, percent-decoded and taken as UTF-8. Schemes, absolute paths and paths that lead out of the folder,
  /// by ".." or by symbolic links, are refused. Only regular files are opened.
  tl::expected<std::vector<std::byte>, FileFault> read(std::string_view uri);

  /// Any regular file, for the document itself.
  tl::expected<std::vector<std::byte>, FileFault> read_path(const std::filesystem::path& path);

  /// Counts bytes that come from elsewhere (data URIs) against the same allowance.
  bool take(std::uint64_t bytes) noexcept;

  std::uint64_t bytes_read() const noexcept { return read_; }

 private:
  tl::expected<std::filesystem::path, FileFault> resolve(std::string_view uri) const;

  std::optional<std::filesystem::path> folder_;
  std::uint64_t left_ = 0;
  std::uint64_t read_ = 0;
};

}  // namespace sinew
