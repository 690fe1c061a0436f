// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <memory>
#include <type_traits>

namespace sinew {

/// An array on the stack whose elements are not initialised before put(), since most updates use few of them. Internal
/// to graph/.
template <class T, std::size_t N>
class RawArray {
  static_assert(std::is_trivially_destructible_v<T>);

 public:
  /// Constructs an element from `value`, or replaces it.
  T& put(std::size_t index, const T& value) noexcept { return *std::construct_at(data() + index, value); }
  T& operator[](std::size_t index) noexcept { return data()[index]; }
  const T& operator[](std::size_t index) const noexcept { return data()[index]; }
  T* data() noexcept { return reinterpret_cast<T*>(bytes_); }
  const T* data() const noexcept { return reinterpret_cast<const T*>(bytes_); }

 private:
  alignas(T) std::byte bytes_[N * sizeof(T)];
};

}  // namespace sinew
