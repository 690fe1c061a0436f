// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>
#include <type_traits>

namespace sinew {

/// A view of `size()` elements that lie `stride` bytes apart, for example one attribute of interleaved vertices.
/// Every element must be aligned for T. Owns nothing.
template <class T>
class StridedSpan {
 public:
  using Byte = std::conditional_t<std::is_const_v<T>, const std::byte, std::byte>;

  constexpr StridedSpan() = default;
  constexpr StridedSpan(T* first, std::size_t count, std::size_t stride_bytes = sizeof(T)) noexcept
      : first_(first), count_(count), stride_(stride_bytes) {}
  constexpr StridedSpan(std::span<T> tight) noexcept : StridedSpan(tight.data(), tight.size()) {}

  constexpr std::size_t size() const noexcept { return count_; }
  constexpr std::size_t stride_bytes() const noexcept { return stride_; }
  constexpr bool empty() const noexcept { return count_ == 0; }
  T& operator[](std::size_t i) const noexcept {
    return *reinterpret_cast<T*>(reinterpret_cast<Byte*>(first_) + i * stride_);
  }

 private:
  T* first_ = nullptr;
  std::size_t count_ = 0;
  std::size_t stride_ = sizeof(T);
};

}  // namespace sinew
