// SPDX-License-Identifier: MIT
#include "runtime/compress/fit_joints.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "runtime/animation/track_sample.h"
#include "runtime/compress/fit_track.h"
#include "runtime/math/affine.h"

namespace sinew {
namespace {

/// Most moving joints times times in memory at once, at 272 bytes each, and the fewest times of a part.
constexpr std::size_t kMostHeld = std::size_t{1} << 18, kFewestTimes = 256;
/// A track that kept this fraction of its keys will keep all of them, and needs hardly any share.
constexpr double kNeedsAll = 0.9, kWeightOfWhole = 0.01;

/// True if all values are equal. Such a track needs hardly any share, either.
template <class Value>
bool has_one_value(const std::vector<Value>& values) {
  return std::all_of(values.begin(), values.end(), [&](const Value& value) { return value == values.front(); });
}

double key_time(const std::vector<float>& times_s, std::size_t key) { return static_cast<double>(times_s[key]); }

/// Times that the search examines: all keys, the last moments before jumps, and the middle between keys. If a track is
/// cubic, also the quarters between keys.
std::vector<double> times_to_look_at(const Animation& animation) {
  std::vector<double> times_s{0.0, animation.duration_s};
  bool cubic = false;
  for (std::size_t t = 0; t < 3 * animation.bones.size(); ++t)
    with_track(animation, t, [&](const auto& track) {
      cubic |= !track.empty() && track.interpolation == Interpolation::cubic_spline;
      for (std::size_t key = 0; key < track.key_count(); ++key) {
        times_s.push_back(key_time(track.times_s, key));
        if (track.interpolation == Interpolation::step || (key > 0 && !(track.times_s[key] > track.times_s[key - 1])))
          times_s.push_back(
              static_cast<double>(std::nextafter(track.times_s[key], -std::numeric_limits<float>::infinity())));
      }
    });
  std::sort(times_s.begin(), times_s.end());
  times_s.erase(std::unique(times_s.begin(), times_s.end()), times_s.end());
  const std::size_t between = cubic ? 3 : 1;
  std::vector<double> out;
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    out.push_back(times_s[i]);
    if (i + 1 == times_s.size() || times_s[i + 1] - times_s[i] < 1e-6) continue;
    for (std::size_t k = 1; k <= between; ++k)
      out.push_back(times_s[i] +
                    (times_s[i + 1] - times_s[i]) * static_cast<double>(k) / static_cast<double>(between + 1));
  }
  return out;
}

}  // namespace

JointFit::JointFit(const Skeleton& skeleton, const Animation& truth, const Animation& stored,
                   const VirtualVertices& vertices)
    : skeleton_(skeleton), truth_(truth), stored_(stored), joints_(moving_joints(truth, skeleton, vertices)) {
  constexpr std::array<std::size_t, 3> kNumber{0, 2, 1};  // bone_of has the rotation last, with_track() in the middle
  for (std::uint32_t j = 0; j < joints_.size(); ++j)
    for (std::uint32_t p = 0; p < 3; ++p) {
      if (joints_[j].bone_of[p] == kNone) continue;
      const std::size_t number = 3 * joints_[j].bone_of[p] + kNumber[p];
      const bool fits = with_track(truth, number, [](const auto& track) {
        return !track.empty() && track.interpolation != Interpolation::squad;
      });
      if (!fits) continue;
      stages_.push_back({j, p, {.track = number}});
      if (with_track(truth, number, [](const auto& track) { return has_one_value(track.values); }))
        stages_.back().weight = kWeightOfWhole;
    }
  times_s_ = times_to_look_at(truth);
  times_per_part_ = std::max(kFewestTimes, kMostHeld / std::max<std::size_t>(joints_.size(), 1));
  if (times_s_.size() <= times_per_part_ && !empty()) kept_parts_.push_back(make_part(0, times_s_.size()));
}

std::vector<KeptKeys> JointFit::fit(double budget_m) {
  set_shares();
  for (Stage& stage : stages_) {
    stage.kept = {.track = stage.kept.track};
  }
  for (std::size_t begin = 0; begin < times_s_.size() && !empty(); begin += times_per_part_) {
    if (!kept_parts_.empty())
      fit_part(kept_parts_.front(), budget_m);
    else
      fit_part(make_part(begin, std::min(begin + times_per_part_, times_s_.size())), budget_m);
  }
  std::vector<KeptKeys> out;
  for (const Stage& stage : stages_) out.push_back(stage.kept);
  return out;
}

void JointFit::share_by_need() {
  for (Stage& stage : stages_) {
    const double share = std::max(stage.to - stage.from, 1e-6);
    const double keys = stage.kept.rests ? 0.5 : static_cast<double>(stage.kept.keys.size());
    const double bytes = sizeof(float) * (stage.property == 2 ? 5.0 : 4.0);
    stage.weight = std::pow(bytes * keys * std::sqrt(share), 2.0 / 3.0);
    const std::size_t all = with_track(truth_, stage.kept.track, [](const auto& track) { return track.key_count(); });
    if (keys >= kNeedsAll * static_cast<double>(all)) stage.weight *= kWeightOfWhole;
  }
}

void JointFit::set_shares() {
  std::vector<double> own(joints_.size(), 0.0), below(joints_.size(), 0.0), used(joints_.size(), 0.0);
  for (const Stage& stage : stages_) own[stage.joint] += stage.weight;
  for (std::size_t j = joints_.size(); j-- > 0;)
    if (const std::uint32_t parent = joints_[j].parent; parent != kNone)
      below[parent] = std::max(below[parent], own[j] + below[j]);
  auto stage = stages_.begin();
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    used[j] = joints_[j].parent == kNone ? 0.0 : used[joints_[j].parent];
    double left = own[j] + below[j];
    for (; stage != stages_.end() && stage->joint == j; ++stage) {
      stage->from = used[j];
      used[j] += (1.0 - used[j]) * stage->weight / left;
      left -= stage->weight;
      stage->to = left <= 1e-9 * stage->weight ? 1.0 : used[j];
    }
  }
}

JointFit::Part JointFit::make_part(std::size_t begin, std::size_t end) const {
  Part part{
      {times_s_.begin() + static_cast<std::ptrdiff_t>(begin), times_s_.begin() + static_cast<std::ptrdiff_t>(end)},
      begin == 0,
      end == times_s_.size(),
      {},
      {}};
  for (const MovingJoint& joint : joints_) {
    std::vector<Transformd>& local = part.local.emplace_back(part.times_s.size());
    std::vector<Affined>& model = part.model.emplace_back(part.times_s.size());
    for (std::size_t t = 0; t < local.size(); ++t) {
      local[t] = local_at(joint, truth_, skeleton_, part.times_s[t]);
      model[t] = joint.from_parent * affine_from_transform(local[t]);
      if (joint.parent != kNone) model[t] = part.model[joint.parent][t] * model[t];
    }
  }
  return part;
}

void JointFit::fit_part(const Part& part, double budget_m) {
  std::vector<std::vector<Affined>> fitted(joints_.size());
  std::vector<Affined> parent(part.times_s.size());
  auto stage = stages_.begin();
  for (std::uint32_t j = 0; j < joints_.size(); ++j) {
    const MovingJoint& joint = joints_[j];
    for (std::size_t t = 0; t < parent.size(); ++t)
      parent[t] = joint.parent == kNone ? joint.from_parent : fitted[joint.parent][t] * joint.from_parent;
    std::vector<Transformd> local = part.local[j];
    for (; stage != stages_.end() && stage->joint == j; ++stage) {
      const double limit_m = stage->to * budget_m;
      const BoneAnimation& bone = stored_.bones[joint.bone_of[stage->property]];
      if (stage->property == 0)
        fit_track(part, *stage, bone.translation, parent, limit_m, &Transformd::translation, local);
      else if (stage->property == 1)
        fit_track(part, *stage, bone.scale, parent, limit_m, &Transformd::scale, local);
      else
        fit_track(part, *stage, bone.rotation, parent, limit_m, &Transformd::rotation, local);
    }
    fitted[j].resize(parent.size());
    for (std::size_t t = 0; t < parent.size(); ++t) fitted[j][t] = parent[t] * affine_from_transform(local[t]);
  }
}

template <class TrackType, class Property>
void JointFit::fit_track(const Part& part, Stage& stage, const TrackType& track, const std::vector<Affined>& parent,
                         double limit_m, Property property, std::vector<Transformd>& local) const {
  const std::vector<Affined>& model = part.model[stage.joint];
  const Aabb& box = joints_[stage.joint].below;
  const auto error_squared = [&](std::size_t t, const auto& value) {
    Transformd moved = local[t];
    moved.*property = value;
    Affined difference = parent[t] * affine_from_transform(moved);
    for (int r = 0; r < 3; ++r) difference.row[r] -= model[t].row[r];
    return longest_squared(difference, box);
  };
  const Transformd rest = in_double(skeleton_.rest[joints_[stage.joint].joint]);
  const TrackFit fit(track, rest.*property, std::span(part.times_s), part.first, part.last, limit_m, error_squared);
  fit.run(stage.kept);
  std::size_t segment = 0;
  for (std::size_t t = 0; t < local.size(); ++t) local[t].*property = fit.value_at(stage.kept, t, segment);
}

}  // namespace sinew
