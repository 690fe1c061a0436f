// SPDX-License-Identifier: MIT
#include "runtime/clip/clip_rest.h"

#include <cstdint>
#include <limits>

#include "runtime/base/contract.h"
#include "runtime/base/same_bits.h"
#include "runtime/clip/clip_layout.h"

namespace sinew {
namespace {

/// Sorts by `at`, keeps the last value for each `at`, and drops those equal to the rest value.
void sort_and_prune(std::vector<BaseNumbers::Override>& overrides, const std::vector<float>& rest) {
  const auto earlier = [](const auto& a, const auto& b) { return a.at < b.at; };
  if (!std::is_sorted(overrides.begin(), overrides.end(), earlier))
    std::stable_sort(overrides.begin(), overrides.end(), earlier);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < overrides.size(); ++i) {
    const bool is_last = i + 1 == overrides.size() || overrides[i + 1].at != overrides[i].at;
    if (is_last && !same_bits(overrides[i].value, rest[overrides[i].at])) overrides[kept++] = overrides[i];
  }
  overrides.resize(kept);
}

}  // namespace

BaseNumbers::BaseNumbers(RestNumbers rest, std::vector<Override> overrides)
    : rest_(std::move(rest)), overrides_(std::move(overrides)) {
  CONTRACT(rest_ != nullptr && rest_->size() <= std::numeric_limits<std::uint32_t>::max());
  sort_and_prune(overrides_, *rest_);
  if (overrides_.size() * kOverrideShare > rest_->size()) {
    std::vector<float> all = *rest_;
    for (const Override& number : overrides_) all[number.at] = number.value;
    rest_ = rest_numbers(std::move(all));
    overrides_.clear();
    is_copy_ = true;
  }
  overrides_.shrink_to_fit();
  first_ = rest_->data();
  size_ = rest_->size();
}

BaseNumbers BaseNumbers::over(const RestNumbers& rest, std::span<const float> numbers) {
  CONTRACT(rest != nullptr && rest->size() == numbers.size());
  std::vector<Override> overrides;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (!same_bits(numbers[i], (*rest)[i])) overrides.push_back({static_cast<std::uint32_t>(i), numbers[i]});
  return BaseNumbers(rest, std::move(overrides));
}

float BaseNumbers::operator[](std::size_t at) const noexcept {
  const auto found = std::lower_bound(overrides_.begin(), overrides_.end(), at,
                                      [](const Override& o, std::size_t i) { return o.at < i; });
  return found != overrides_.end() && found->at == at ? found->value : first_[at];
}

ClipRest clip_rest(const Skeleton& skeleton, std::span<const float> rest_weights, const PropertyTable& properties) {
  return {skeleton.joint_count(), rest_numbers(BasePose(skeleton.rest).planes),
          rest_numbers({rest_weights.begin(), rest_weights.end()}), rest_numbers(properties.rest)};
}

void share_rest(const Clip& clip, ClipRest& rest) {
  const auto share = [](const BaseNumbers& theirs, RestNumbers& ours) {
    if (theirs.rest() != nullptr && same_bits<float>(*theirs.rest(), *ours)) ours = theirs.rest();
  };
  share(clip.layout().base_pose, rest.pose);
  share(clip.layout().base_weights, rest.weights);
  share(clip.layout().base_properties, rest.properties);
}

}  // namespace sinew
