// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace sinew {

/// An array whose copies share its elements (copy on write), for data that is written once and has many owners.
/// Reading costs the same as for std::vector. A move is a copy, so the source of a move keeps its elements.
/// owns  the elements, together with its copies;  cost  of a copy O(1), allocates nothing
template <class T>
class SharedArray {
 public:
  SharedArray() = default;
  SharedArray(std::vector<T> elements) : elements_(std::make_shared<std::vector<T>>(std::move(elements))) { look(); }
  SharedArray(const SharedArray&) = default;
  SharedArray& operator=(const SharedArray&) = default;

  const T* data() const noexcept { return first_; }
  std::size_t size() const noexcept { return size_; }
  bool empty() const noexcept { return size_ == 0; }
  const T* begin() const noexcept { return first_; }
  const T* end() const noexcept { return first_ + size_; }
  const T& front() const noexcept { return first_[0]; }
  const T& back() const noexcept { return first_[size_ - 1]; }
  const T& operator[](std::size_t i) const noexcept { return first_[i]; }

  void assign(std::size_t count, const T& value) { *this = SharedArray(std::vector<T>(count, value)); }
  void resize(std::size_t count, const T& value) {
    own();
    if (elements_ == nullptr) elements_ = std::make_shared<std::vector<T>>();
    elements_->resize(count, value);
    look();
  }

  /// The elements for writing. If copies share the elements, they are copied first.
  T* own() {
    if (elements_.use_count() > 1) *this = SharedArray(std::vector<T>(*elements_));
    return elements_ == nullptr ? nullptr : elements_->data();
  }

  /// True if both arrays refer to the same memory.
  bool shares_with(const SharedArray& other) const noexcept { return elements_ == other.elements_; }

  friend bool operator==(const SharedArray& a, const SharedArray& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  }

 private:
  void look() noexcept {
    first_ = elements_->data();
    size_ = elements_->size();
  }

  const T* first_ = nullptr;
  std::size_t size_ = 0;
  std::shared_ptr<std::vector<T>> elements_;
};

}  // namespace sinew
