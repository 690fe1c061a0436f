// SPDX-License-Identifier: MIT
#include "importer/file/data_uri.h"

#include "importer/file/base64.h"

namespace sinew {

bool is_data_uri(std::string_view uri) noexcept { return uri.starts_with("data:"); }

std::optional<DataUri> decode_data_uri(std::string_view uri) {
  if (!is_data_uri(uri)) return std::nullopt;
  uri.remove_prefix(5);
  const auto comma = uri.find(',');
  if (comma == uri.npos) return std::nullopt;
  std::string_view media = uri.substr(0, comma);
  if (!media.ends_with(";base64")) return std::nullopt;
  media.remove_suffix(7);
  auto bytes = decode_base64(uri.substr(comma + 1));
  if (!bytes) return std::nullopt;
  return DataUri{std::string(media.substr(0, media.find(';'))), std::move(*bytes)};
}

}  // namespace sinew
