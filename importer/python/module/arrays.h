// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <initializer_list>
#include <utility>
#include <vector>

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include "importer/python/module/block_pool.h"

namespace sinew::python {

/// A NumPy array that C++ made: it owns its memory, in C order.
template <class T>
using NumPyArray = nanobind::ndarray<nanobind::numpy, T, nanobind::c_contig>;

/// An array of the caller. nanobind converts lists, other number types and other orders to this form before the call.
template <class T>
using Numbers = nanobind::ndarray<const T, nanobind::c_contig, nanobind::device::cpu>;

/// Memory for an array, filled without the interpreter's lock and handed to NumPy without a copy. Its maker writes
/// every element.
template <class T>
class ArrayMemory {
 public:
  explicit ArrayMemory(std::initializer_list<std::size_t> shape) : shape_(shape), count_(1) {
    for (const std::size_t length : shape_) count_ *= length;
    block_ = BlockPool::shared().take(count_ * sizeof(T));
  }
  ~ArrayMemory() {
    if (block_.memory != nullptr) BlockPool::shared().give_back(block_);
  }
  ArrayMemory(ArrayMemory&& other) noexcept
      : shape_(std::move(other.shape_)), count_(other.count_), block_(std::exchange(other.block_, {})) {}
  ArrayMemory& operator=(ArrayMemory&&) = delete;

  T* data() noexcept { return static_cast<T*>(block_.memory); }
  std::size_t size() const noexcept { return count_; }

  /// Gives the memory to a NumPy array. Needs the interpreter's lock.
  NumPyArray<T> release() {
    T* const values = data();
    auto* const owned = new BlockPool::Block(std::exchange(block_, {}));
    nanobind::capsule owner(owned, [](void* block) noexcept {
      BlockPool::shared().give_back(*static_cast<BlockPool::Block*>(block));
      delete static_cast<BlockPool::Block*>(block);
    });
    return NumPyArray<T>(values, shape_.size(), shape_.data(), owner);
  }

 private:
  std::vector<std::size_t> shape_;
  std::size_t count_;
  BlockPool::Block block_;
};

}  // namespace sinew::python
