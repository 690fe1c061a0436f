// SPDX-License-Identifier: MIT
#include "importer/tool/batch/read_input.h"

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <optional>
#include <span>
#include <vector>

#include "importer/platform/files.h"
#include "importer/platform/program.h"
#include "importer/tool/batch/input_list.h"

namespace sinew::tool {
namespace {

/// The bytes of the standard input, at most `most` + 1 of them; empty if it cannot be read.
std::optional<std::vector<std::byte>> read_standard_input(std::uint64_t most) {
  constexpr std::size_t kPiece = std::size_t{1} << 16;
  std::vector<std::byte> bytes;
  while (bytes.size() <= most) {
    const std::size_t before = bytes.size();
    bytes.resize(before + kPiece);
    const auto count = platform::read_some(platform::kStandardInput, std::span(bytes).subspan(before));
    bytes.resize(before + count.value_or(0));
    if (!count) return std::nullopt;
    if (*count == 0) break;
  }
  return bytes;
}

}  // namespace

ImportResult<ImportedFile> read_input(const std::string& file, const ImportOptions& options) {
  if (file != kStandardInput) return import_gltf(platform::path_of(file), options);
  const auto bytes = read_standard_input(options.max_file_bytes);
  if (bytes) return import_gltf(*bytes, file, options);
  return tl::unexpected(ImportError{file, {Severity::error, "file-unreadable", "", std::strerror(errno)}, {}, {}});
}

}  // namespace sinew::tool
