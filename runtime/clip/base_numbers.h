// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace sinew {

/// Numbers at rest that several clips refer to. Never null where there are any.
using RestNumbers = std::shared_ptr<const std::vector<float>>;

/// The numbers that a sample starts from: those at rest, and what constant tracks of the clip put in their place. The
/// clips of a scene share the numbers at rest, so that a clip takes memory for what it moves and not for all joints.
class BaseNumbers {
 public:
  struct Own {
    std::uint32_t at;
    float value;
  };
  /// A clip that sets more than one number in kFewOwn has a copy of all, which is written as one block.
  static constexpr std::size_t kFewOwn = 16;

  BaseNumbers() = default;
  /// in   rest  fewer than 2^32 numbers
  ///      own   in any order; of several for one number the last one counts. Those with the bits at rest take no memory
  /// cost O(own log own); O(rest) where they are many
  explicit BaseNumbers(RestNumbers rest, std::vector<Own> own = {});

  /// Numbers as given, of which those at rest are shared.    in   numbers  as many as at rest    cost O(numbers)
  static BaseNumbers over(const RestNumbers& rest, std::span<const float> numbers);

  std::size_t size() const noexcept { return size_; }
  const RestNumbers& rest() const noexcept { return rest_; }
  /// Those of this clip alone, rising.
  std::span<const Own> own() const noexcept { return own_; }
  float operator[](std::size_t at) const noexcept;

  void copy_to(float* out) const noexcept {
    std::copy_n(first_, size_, out);
    for (const Own& number : own_) out[number.at] = number.value;
  }
  std::vector<float> all() const {
    std::vector<float> numbers(size_);
    copy_to(numbers.data());
    return numbers;
  }
  /// Of this clip alone.
  std::size_t byte_size() const noexcept { return own_.size() * sizeof(Own) + (is_copy_ ? size_ * sizeof(float) : 0); }

 private:
  const float* first_ = nullptr;  ///< of `rest_`
  std::size_t size_ = 0;
  RestNumbers rest_;
  std::vector<Own> own_;
  bool is_copy_ = false;  ///< `rest_` is of this clip alone
};

inline RestNumbers rest_numbers(std::vector<float> numbers) {
  return std::make_shared<const std::vector<float>>(std::move(numbers));
}

}  // namespace sinew
