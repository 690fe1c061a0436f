// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstring>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "runtime/asset_file/asset_file.h"
#include "runtime/asset_file/asset_format.h"
#include "runtime/asset_file/asset_kinds.h"

namespace sinew {

/// Reads what AssetWriter wrote. The first broken rule is kept, and everything after it reads as empty. Any bytes may
/// be passed. An array is never longer than the remaining bytes, so memory stays below a small multiple of the block.
/// Indices and finite numbers are not checked here: check(Scene) does that.
class AssetReader {
 public:
  AssetReader(std::span<const std::byte> block, AssetKind kind) : block_(block), kind_(kind) {}

  template <class T>
  void read(T& value) {
    if constexpr (kIsPlain<T>)
      read_bytes(&value, sizeof(T));
    else if constexpr (std::is_same_v<T, bool>)
      value = small(1, "a flag is neither 0 nor 1") != 0;
    else if constexpr (std::is_enum_v<T>)
      value = static_cast<T>(small(static_cast<std::uint8_t>(last_of(T{})), "there is no such kind"));
    else
      std::apply([this](auto&... field) { (this->read(field), ...); }, fields(value));
  }
  void read(std::string& text) {
    text.resize(count(1));
    read_bytes(text.data(), text.size());
  }
  void read(SharedName& name) {
    std::uint32_t number = 0;
    read_bytes(&number, sizeof number);
    require(number <= names_.size(), "asset-value", "a name is not among those before it");
    if (!ok()) return;
    if (number == names_.size()) {
      std::string text;
      read(text);
      names_.emplace_back(std::move(text));
    }
    name = names_[number];
  }
  template <class T>
  void read(std::vector<T>& values) {
    if constexpr (kIsPlain<T>) {
      const std::size_t size = count(sizeof(T));
      if (size > 0) skip_padding();
      require(size <= left() / sizeof(T), "asset-size", kTooShort);
      values.resize(ok() ? size : 0);
      read_bytes(values.data(), values.size() * sizeof(T));
    } else {
      for (std::size_t more = count(1); more > 0 && ok(); --more) read(values.emplace_back());
    }
  }

  /// True if the whole block was read and no rule was broken.
  bool finish() {
    require(left() == 0, "asset-size", "bytes follow the last field of the block");
    return ok();
  }
  bool ok() const noexcept { return error_.rule.empty(); }
  const AssetFileError& error() const noexcept { return error_; }

 private:
  static constexpr const char* kTooShort = "the block ends inside of an asset";

  std::size_t left() const noexcept { return block_.size() - at_; }
  void require(bool holds, const char* rule, const char* detail) {
    if (ok() && !holds) error_ = {rule, std::string(name_of(kind_)), at_, detail};
  }
  void read_bytes(void* out, std::size_t size) {
    require(size <= left(), "asset-size", kTooShort);
    if (!ok() || size == 0) return;
    std::memcpy(out, block_.data() + at_, size);
    at_ += size;
  }
  std::uint8_t small(std::uint8_t most, const char* detail) {
    std::uint8_t value = 0;
    read(value);
    require(value <= most, "asset-value", detail);
    return ok() ? value : std::uint8_t{0};
  }
  /// The length of the array that follows, whose elements take `bytes_each` or more; 0 if they cannot fit.
  std::size_t count(std::size_t bytes_each) {
    std::uint64_t number = 0;
    read(number);
    require(number <= left() / bytes_each, "asset-size", kTooShort);
    return ok() ? static_cast<std::size_t>(number) : 0;
  }
  void skip_padding() {
    const std::size_t end = std::min((at_ + kArrayAlignment - 1) / kArrayAlignment * kArrayAlignment, block_.size());
    for (; at_ < end && ok(); ++at_)
      require(block_[at_] == std::byte{0}, "asset-value", "bytes before an array are not 0");
  }

  std::span<const std::byte> block_;
  AssetKind kind_;
  std::size_t at_ = 0;
  std::vector<SharedName> names_;
  AssetFileError error_;
};

}  // namespace sinew
