// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "runtime/asset_file/asset_format.h"
#include "runtime/asset_file/asset_kinds.h"

namespace sinew {

/// Writes assets into a block. Numbers are stored as in memory, flags and enumerations as one byte. Texts and arrays
/// are an eight-byte count and their elements; other types are stored field by field (asset_fields.h). Arrays of
/// numbers begin at multiples of kArrayAlignment. A SharedName is the index of a name; a new name is followed by its
/// text.
class AssetWriter {
 public:
  template <class T>
  void add(const T& value) {
    if constexpr (kIsPlain<T>)
      add_bytes(&value, sizeof(T));
    else if constexpr (std::is_same_v<T, bool> || std::is_enum_v<T>)
      add(static_cast<std::uint8_t>(value));
    else
      std::apply([this](const auto&... field) { (this->add(field), ...); }, fields(value));
  }
  void add(const std::string& text) {
    add(static_cast<std::uint64_t>(text.size()));
    add_bytes(text.data(), text.size());
  }
  void add(const SharedName& name) {
    const auto [known, is_new] = names_.try_emplace(name.str(), static_cast<std::uint32_t>(names_.size()));
    add(known->second);
    if (is_new) add(name.str());
  }
  template <class T>
  void add(const std::vector<T>& values) {
    add(static_cast<std::uint64_t>(values.size()));
    if constexpr (kIsPlain<T>) {
      if (!values.empty()) bytes_.resize((bytes_.size() + kArrayAlignment - 1) / kArrayAlignment * kArrayAlignment);
      add_bytes(values.data(), values.size() * sizeof(T));
    } else {
      for (const T& value : values) add(value);
    }
  }

  std::vector<std::byte>& bytes() noexcept { return bytes_; }

 private:
  void add_bytes(const void* data, std::size_t size) {
    const auto* first = static_cast<const std::byte*>(data);
    bytes_.insert(bytes_.end(), first, first + size);
  }

  std::vector<std::byte> bytes_;
  std::map<std::string, std::uint32_t> names_;
};

}  // namespace sinew
