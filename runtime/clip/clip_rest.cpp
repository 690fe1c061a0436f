// SPDX-License-Identifier: MIT
#include "runtime/clip/clip_rest.h"

#include "runtime/base/contract.h"
#include "runtime/base/same_bits.h"
#include "runtime/clip/clip_layout.h"

namespace sinew {
namespace {

/// Sorts by `at`, keeps the last value for each `at`, and drops those equal to the rest value.
void tidy(std::vector<BaseNumbers::Own>& own, const std::vector<float>& rest) {
  std::stable_sort(own.begin(), own.end(), [](const auto& a, const auto& b) { return a.at < b.at; });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const bool is_last = i + 1 == own.size() || own[i + 1].at != own[i].at;
    if (is_last && !same_bits(own[i].value, rest[own[i].at])) own[kept++] = own[i];
  }
  own.resize(kept);
}

}  // namespace

BaseNumbers::BaseNumbers(RestNumbers rest, std::vector<Own> own) : rest_(std::move(rest)), own_(std::move(own)) {
  CONTRACT(rest_ != nullptr && rest_->size() < std::size_t{1} << 32);
  tidy(own_, *rest_);
  if (own_.size() * kFewOwn > rest_->size()) {
    std::vector<float> all = *rest_;
    for (const Own& number : own_) all[number.at] = number.value;
    rest_ = rest_numbers(std::move(all));
    own_.clear();
    is_copy_ = true;
  }
  own_.shrink_to_fit();
  first_ = rest_->data();
  size_ = rest_->size();
}

BaseNumbers BaseNumbers::over(const RestNumbers& rest, std::span<const float> numbers) {
  CONTRACT(rest != nullptr && rest->size() == numbers.size());
  std::vector<Own> own;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (!same_bits(numbers[i], (*rest)[i])) own.push_back({static_cast<std::uint32_t>(i), numbers[i]});
  return BaseNumbers(rest, std::move(own));
}

float BaseNumbers::operator[](std::size_t at) const noexcept {
  const auto found =
      std::lower_bound(own_.begin(), own_.end(), at, [](const Own& o, std::size_t i) { return o.at < i; });
  return found != own_.end() && found->at == at ? found->value : first_[at];
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
