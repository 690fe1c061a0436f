// SPDX-License-Identifier: MIT
#include "importer/vrm_animation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <span>

#include "importer/vrm_expressions.h"
#include "importer/vrm_look_at.h"
#include "runtime/animation/track_sample.h"
#include "runtime/procedures/expressions/expressions.h"

namespace sinew {
namespace {

/// An expression that a clip moves, and the character's expression of the same name.
struct PlayedExpression {
  const Vec3Track* track = nullptr;
  std::uint32_t expression = 0;
};

const Vec3Track* track_of(const Animation& clip, std::uint32_t joint) noexcept {
  for (const BoneAnimation& bone : clip.bones)
    if (bone.joint == joint && !bone.translation.empty()) return &bone.translation;
  return nullptr;
}

std::vector<PlayedExpression> played_expressions(const Animation& clip, const VrmCharacter& from,
                                                 const VrmCharacter& to, std::span<const Expression> expressions,
                                                 std::vector<std::string>& not_found) {
  std::vector<PlayedExpression> played;
  for (const VrmExpression& source : from.expressions) {
    const Vec3Track* const track = track_of(clip, source.value_joint);
    if (track == nullptr) continue;
    const auto same = std::find_if(to.expressions.begin(), to.expressions.end(), [&](const VrmExpression& own) {
      return own.name == source.name && own.is_preset == source.is_preset;
    });
    const auto index = static_cast<std::size_t>(same - to.expressions.begin());
    if (same == to.expressions.end() || expressions[index].binds.empty())
      not_found.push_back(source.name);
    else
      played.push_back({track, static_cast<std::uint32_t>(index)});
  }
  return played;
}

/// Times at which weights and rotations are computed.
std::vector<float> times_of(std::span<const PlayedExpression> played, const QuatTrack* gaze) {
  std::set<float> times;
  bool all_linear = true;
  const auto add = [&](const auto& track) {
    times.insert(track.times_s.begin(), track.times_s.end());
    all_linear = all_linear && track.interpolation == Interpolation::linear;
  };
  for (const PlayedExpression& one : played) add(*one.track);
  if (gaze != nullptr) add(*gaze);
  if (!all_linear && !times.empty()) {
    const double first = static_cast<double>(*times.begin()), last = static_cast<double>(*times.rbegin());
    for (double step = std::ceil(first * 60.0); step / 60.0 < last; ++step)
      times.insert(static_cast<float>(step / 60.0));
  }
  return {times.begin(), times.end()};
}

/// The eyes of a character, which follow the gaze of a clip.
class GazePlayer {
 public:
  GazePlayer(const Animation& clip, const VrmCharacter& from, const VrmCharacter& to, const Skeleton& skeleton)
      : look_(look_expressions_of(to)) {
    const auto setup = eyes_of(to);
    const auto eyes = setup ? prepare_eyes(skeleton, *setup) : tl::unexpected(ErrorCode::unsupported);
    if (!eyes) return;
    eyes_ = *eyes;
    for (const BoneAnimation& bone : clip.bones)
      if (bone.joint == from.look_at.gaze_joint && !bone.rotation.empty()) track_ = &bone.rotation;
  }

  /// Null if nothing looks.
  const QuatTrack* track() const noexcept { return track_; }
  const Eyes& eyes() const noexcept { return eyes_; }
  const LookExpressions& expressions() const noexcept { return look_; }
  bool moves(EyeKind kind) const noexcept { return track_ != nullptr && eyes_.setup.kind == kind; }

  EyeTurns look(float time_s) const noexcept {
    const Quat<double> turn = normalised(sample_track<double>(*track_, static_cast<double>(time_s)));
    const Vec3<double> ahead = rotate_vector(turn, Vec3<double>(0.0, 0.0, 1.0));
    return look_along(eyes_, std::atan2(ahead.x, ahead.z), std::atan2(-ahead.y, std::hypot(ahead.x, ahead.z)));
  }

 private:
  LookExpressions look_;
  Eyes eyes_;
  const QuatTrack* track_ = nullptr;
};

/// One track for each instance with a morph weight that changes.
std::vector<WeightAnimation> empty_tracks(const Scene& scene, const std::set<std::uint32_t>& moved,
                                          const std::vector<float>& times) {
  std::vector<WeightAnimation> out;
  for (std::uint32_t i = 0; i + 1 < scene.first_weight.size(); ++i) {
    const std::uint32_t first = scene.first_weight[i], end = scene.first_weight[i + 1];
    const auto own = moved.lower_bound(first);
    if (own == moved.end() || *own >= end) continue;
    out.push_back({i, {Interpolation::linear, times, {}, end - first}});
  }
  return out;
}

}  // namespace

FaceTracks face_tracks(const Animation& clip, const VrmCharacter& from, const VrmCharacter& to, const Scene& scene) {
  FaceTracks out;
  const std::vector<Expression> expressions = expressions_of(to, scene);
  const auto played = played_expressions(clip, from, to, expressions, out.not_found);
  const GazePlayer gaze(clip, from, to, scene.skeleton);
  const std::vector<float> times = times_of(played, gaze.track()), rest = rest_weights_of(scene);
  std::set<std::uint32_t> moved;
  const auto add_binds = [&](std::uint32_t expression) {
    if (expression == kNone) return;
    for (const ExpressionBind& bind : expressions[expression].binds) moved.insert(bind.weight);
  };
  for (const PlayedExpression& one : played) add_binds(one.expression);
  const LookExpressions& look = gaze.expressions();
  if (gaze.moves(EyeKind::weights))
    for (const std::uint32_t expression : {look.left, look.right, look.up, look.down}) add_binds(expression);
  out.weights = empty_tracks(scene, moved, times);
  const Eyes::Eye eyes[] = {gaze.eyes().left, gaze.eyes().right};
  for (const Eyes::Eye& eye : eyes) {
    if (!gaze.moves(EyeKind::joints) || eye.joint == kNone) continue;
    BoneAnimation& track = out.eyes.emplace_back();
    track.joint = eye.joint;
    track.rotation.times_s = times;
  }
  for (const float time_s : times) {
    std::vector<float> values(expressions.size(), 0.0f), weights = rest;
    for (const PlayedExpression& one : played)
      values[one.expression] = std::clamp(sample_track<float>(*one.track, static_cast<double>(time_s)).x, 0.0f, 1.0f);
    if (gaze.track() != nullptr) {
      const EyeTurns now = gaze.look(time_s);
      if (gaze.moves(EyeKind::weights)) set_look_values(look, now.gaze, values);
      for (BoneAnimation& eye : out.eyes)
        eye.rotation.values.push_back(quat_cast<float>(normalised(eye.joint == eyes[0].joint ? now.left : now.right)));
    }
    run_unchecked(ExpressionsJob{expressions, values, weights});
    for (WeightAnimation& track : out.weights) {
      const auto first = weights.begin() + scene.first_weight[track.instance];
      track.weights.values.insert(track.weights.values.end(), first, first + track.weights.target_count);
    }
  }
  return out;
}

}  // namespace sinew
