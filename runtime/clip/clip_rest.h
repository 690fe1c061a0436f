// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "runtime/base/api.h"
#include "runtime/clip/clip.h"

namespace sinew {

/// Rest values that several clips share. Null only in default-constructed objects.
using RestNumbers = std::shared_ptr<const std::vector<float>>;

/// The values that sampling starts from. A value that a constant track of the clip sets comes from that track, all
/// others are rest values. The clips of a scene share the rest values, so a clip takes memory only for the joints that
/// it changes.
class SINEW_API BaseNumbers {
 public:
  struct Override {
    std::uint32_t at;
    float value;
  };
  /// A clip that changes more than 1 / kOverrideShare of the values keeps its own copy of all values.
  static constexpr std::size_t kOverrideShare = 16;

  BaseNumbers() = default;
  /// Rest values with some of them overridden.
  /// in   rest  fewer than 2^32 values
  ///      overrides   in any order; if several have the same `at`, the last one counts; those equal to `rest` are
  ///      dropped
  /// cost O(overrides log overrides); O(rest) if there are more than rest / kOverrideShare
  explicit BaseNumbers(RestNumbers rest, std::vector<Override> overrides = {});

  /// The given values. A value equal to that in `rest` is not stored again.
  /// in   numbers  as many as in rest    cost O(numbers)
  static BaseNumbers over(const RestNumbers& rest, std::span<const float> numbers);

  std::size_t size() const noexcept { return size_; }
  const RestNumbers& rest() const noexcept { return rest_; }
  /// The values that differ from the rest values, sorted by `at`; empty for a clip with its own copy.
  std::span<const Override> overrides() const noexcept { return overrides_; }
  float operator[](std::size_t at) const noexcept;

  void copy_to(float* out) const noexcept {
    std::copy_n(first_, size_, out);
    for (const Override& number : overrides_) out[number.at] = number.value;
  }
  std::vector<float> all() const {
    std::vector<float> numbers(size_);
    copy_to(numbers.data());
    return numbers;
  }
  /// Bytes that are not shared with other clips.
  std::size_t byte_size() const noexcept {
    return overrides_.size() * sizeof(Override) + (is_copy_ ? size_ * sizeof(float) : 0);
  }

 private:
  const float* first_ = nullptr;  ///< data of `rest_`
  std::size_t size_ = 0;
  RestNumbers rest_;
  std::vector<Override> overrides_;
  bool is_copy_ = false;  ///< `rest_` belongs to this clip alone
};

inline RestNumbers rest_numbers(std::vector<float> numbers) {
  return std::make_shared<const std::vector<float>>(std::move(numbers));
}

/// Rest values of joints, morph weights and properties. Clips that are compiled with the same ClipRest share them.
struct ClipRest {
  std::size_t joint_count = 0;
  RestNumbers pose;  ///< rest transforms, in the order of BasePose::planes
  RestNumbers weights, properties;
};

/// Makes the rest values of a skeleton, its morph weights and its properties.
/// cost O(joints + weights + properties), allocates
SINEW_API ClipRest clip_rest(const Skeleton& skeleton, std::span<const float> rest_weights,
                             const PropertyTable& properties);

/// Replaces arrays of `rest` by those of the clip if they have the same bits, so that they exist once.
/// cost O(joints + weights + properties)
SINEW_API void share_rest(const Clip& clip, ClipRest& rest);

/// As compile_clip in clip.h, for clips that share rest values.
/// in   rest  clip_rest() of the same skeleton, weights and properties
/// cost O(total keys), whatever the number of joints; allocates the clip
SINEW_API Clip compile_clip(const Animation& animation, const ClipRest& rest,
                            std::span<const std::uint32_t> first_weight, const PropertyTable& properties = {},
                            const KeyTolerances& rounding = {});

}  // namespace sinew
