// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sinew {

struct DataUri {
  std::string mime_type;
  std::vector<std::byte> bytes;
};

bool is_data_uri(std::string_view uri) noexcept;

/// Decodes "data:TYPE;base64,..." with any media type; base64 padding is optional. Empty if the text is not base64.
/// cost  O(text); allocates 3/4 of the text's size
std::optional<DataUri> decode_data_uri(std::string_view uri);

}  // namespace sinew
