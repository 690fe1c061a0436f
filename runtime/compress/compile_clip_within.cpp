// SPDX-License-Identifier: MIT
#include "runtime/compress/compile_clip_within.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

#include "runtime/base/contract.h"
#include "runtime/clip/clip_file.h"
#include "runtime/clip/clip_rest.h"
#include "runtime/clip/unpack_clip.h"
#include "runtime/compress/animation_counts.h"
#include "runtime/compress/clip_error.h"
#include "runtime/compress/joint_reach.h"
#include "runtime/compress/remove_keys.h"

namespace sinew {
namespace {

/// Fraction of the budget to use; the rest covers times between the measured ones.
constexpr double kUsed = 0.97;
/// Number of rounds that change the shares after a clip was found.
constexpr int kLoosened = 9;
constexpr double kMaxLoosened = 2.0;
/// First guess for the part of the budget that morph weights get.
constexpr double kOfWeights = 0.25;
/// Fraction of a track's tolerance for rounding its keys; the rest is for dropping keys. The better split depends on
/// the clip, so each part of the search tries one split.
constexpr std::array<double, ClipSearch::kParts> kOfRounding = {0.25, 0.97};

/// Steps between keys whose deviation is remembered, of all tracks together: 32 MB.
constexpr std::size_t kMostKnownSteps = std::size_t{1} << 21;

Clip compile(const Scene& scene, const Animation& animation, const KeyTolerances& rounding = {}) {
  ClipRest rest = clip_rest(scene.skeleton, rest_weights_of(scene), scene.properties);
  if (!scene.clips.empty()) share_rest(scene.clips.front(), rest);
  return compile_clip(animation, rest, scene.first_weight, scene.properties, rounding);
}

/// The part of the budget of each joint, and of all weights together.
class Shares {
 public:
  Shares(const Scene& scene, double budget_m)
      : parents_(scene.skeleton.parents), budget_m_(budget_m), of_joint_(parents_.size(), 1.0) {}

  double joint_m(std::uint32_t joint) const { return of_joint_[joint] * kUsed * budget_m_; }
  double weights_m() const { return of_weights_ * kOfWeights * budget_m_; }

  /// Reduces the shares of all joints and weights that moved vertices too far. False if none did.
  bool tighten(const ClipError& error) {
    if (error.worst_m <= kUsed * budget_m_) return false;
    const double weights_m = error.weights_m, left_m = std::max(kUsed * budget_m_ - weights_m, 0.25 * budget_m_);
    std::vector<double> factor(of_joint_.size(), 1.0);
    for (std::size_t j = factor.size(); j-- > 0;) {
      if (error.of_joint_m[j] > left_m)
        factor[j] = std::min(factor[j], std::clamp(left_m / error.of_joint_m[j], 0.2, 0.9));
      if (parents_[j] != kNone) factor[parents_[j]] = std::min(factor[parents_[j]], factor[j]);
      of_joint_[j] *= factor[j];
    }
    if (weights_m > kOfWeights * budget_m_) of_weights_ *= std::clamp(kOfWeights * budget_m_ / weights_m, 0.01, 0.9);
    return true;
  }

  /// Raises the share of each joint as far as the errors below it allow. Raises the share of the weights in the same
  /// way.
  void loosen(const ClipError& error) {
    const double left_m = std::max(kUsed * budget_m_ - error.weights_m, 0.25 * budget_m_);
    std::vector<double> factor(of_joint_.size(), kMaxLoosened);
    for (std::size_t j = factor.size(); j-- > 0;) {
      factor[j] = std::min(factor[j], std::max(left_m / std::max(error.of_joint_m[j], 0.01 * budget_m_), 1.0));
      if (parents_[j] != kNone) factor[parents_[j]] = std::min(factor[parents_[j]], factor[j]);
      of_joint_[j] *= factor[j];
    }
    of_weights_ *= std::min(kUsed * budget_m_ / std::max(error.worst_m, 0.01 * budget_m_), kMaxLoosened);
  }

 private:
  const std::vector<std::uint32_t>& parents_;
  double budget_m_;
  std::vector<double> of_joint_;
  double of_weights_ = 1.0;
};

double per_unit(double metres, double reach) noexcept { return reach > 0.0 ? metres / reach : 0.0; }

/// The joint and weight tracks that change over time, each with its part of the budget.
std::vector<LooseTrack> moving_tracks(Animation& animation, const Scene& scene, const VirtualVertices& vertices,
                                      const std::vector<JointReach>& reach, const Shares& shares) {
  std::vector<LooseTrack> tracks;
  const auto add = [&](auto& track, double tolerance) {
    if (track.key_count() > 1 && track.interpolation != Interpolation::squad &&
        !flatten_to_constant(LooseTrack{&track, 0.0}))
      tracks.push_back({&track, tolerance});
  };
  for (BoneAnimation& bone : animation.bones) {
    const std::size_t first = tracks.size();
    const JointReach& r = reach[bone.joint];
    const double metres = shares.joint_m(bone.joint);
    add(bone.translation, per_unit(metres, r.translation));
    add(bone.rotation, per_unit(metres, r.rotation));
    add(bone.scale, per_unit(metres, r.scale));
    for (std::size_t i = first; i < tracks.size(); ++i)
      tracks[i].tolerance /= static_cast<double>(tracks.size() - first);
  }
  for (WeightAnimation& animated : animation.weights) {
    if (animated.weights.key_count() < 2) continue;
    const std::size_t at = scene.first_weight[animated.instance] + animated.first_target;
    tracks.push_back({&animated.weights, shares.weights_m(),
                      std::span(vertices.metres_per_weight).subspan(at, animated.weights.target_count)});
  }
  return tracks;
}

/// How far the keys of each track may be rounded: a fraction `part` of its tolerance.
KeyTolerances roundings(const Animation& animation, std::span<const LooseTrack> tracks, double part) {
  std::map<const void*, const LooseTrack*> loose;
  for (const LooseTrack& track : tracks)
    loose[std::visit([](const auto* t) -> const void* { return t; }, track.track)] = &track;
  const auto tolerance_of = [&](const auto& track) {
    const auto found = loose.find(&track);
    return found == loose.end() ? 0.0 : part * found->second->tolerance;
  };
  KeyTolerances out;
  for (const BoneAnimation& bone : animation.bones)
    out.bones.push_back({tolerance_of(bone.translation), tolerance_of(bone.rotation), tolerance_of(bone.scale)});
  for (const WeightAnimation& animated : animation.weights) {
    std::vector<double>& targets = out.weights.emplace_back();
    if (const double metres = tolerance_of(animated.weights) / animated.weights.target_count; metres > 0.0)
      for (const float per_weight : loose[&animated.weights]->metres_per_weight)
        targets.push_back(metres / static_cast<double>(per_weight));
  }
  return out;
}

void reduce(std::vector<LooseTrack> tracks) {
  std::erase_if(tracks, [](const LooseTrack& track) { return flatten_to_constant(track); });
  std::map<std::vector<float>, std::vector<LooseTrack>> groups;
  for (const LooseTrack& track : tracks) groups[track.times_s()].push_back(track);
  for (auto& [times_s, group] : groups)
    for (const std::vector<LooseTrack>& part : split_into_time_groups(std::move(group))) {
      const std::vector<std::uint32_t> keys = keys_needed(part, times_s.size());
      for (const LooseTrack& track : part) keep_keys(track, keys);
    }
}

ClipCertificate certificate_of(const TruthSamples& truth, const Animation& keys, const Clip& clip,
                               std::uint64_t source_bytes, const ClipError& error, double asked_m) {
  return {.asked_m = asked_m,
          .measured_m = error.worst_m,
          .weights_m = error.weights_m,
          .worst_time_s = error.worst_time_s,
          .worst_joint = error.worst_joint,
          .times_checked = static_cast<std::uint32_t>(truth.times_s().size()),
          .animated_joints = animated_joints(truth.truth()),
          .source_keys = key_count(truth.truth()),
          .kept_keys = key_count(keys),
          .source_bytes = source_bytes,
          .bytes = saved_bytes(clip)};
}

/// Inputs that stay the same in all rounds.
struct Task {
  const Scene& scene;
  const Animation& truth;
  const VirtualVertices& vertices;
  double budget_m;
  std::vector<double> times_s = times_to_check(truth, scene.skeleton.joint_count());
  TruthSamples samples{scene, truth, vertices, times_s};
  std::vector<JointReach> reach = joint_reach(truth, scene.skeleton, vertices);
  std::uint64_t source_bytes = saved_bytes(compile(scene, truth));  // of the clip with every key
};

struct Attempt {
  ClipWithin within;
  ClipError error;
};

Attempt try_shares(const Task& task, const Shares& shares, double of_rounding, std::vector<StepDeviations>& known) {
  Attempt out{{task.truth, {}}, {}};
  Animation& keys = out.within.keys;
  std::vector<LooseTrack> tracks = moving_tracks(keys, task.scene, task.vertices, task.reach, shares);
  const KeyTolerances rounding = roundings(keys, tracks, of_rounding);
  if (known.empty() && !tracks.empty())  // every round has the same tracks
    known.assign(tracks.size(), StepDeviations(kMostKnownSteps / tracks.size()));
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    tracks[i].tolerance *= 1.0 - of_rounding;
    tracks[i].known = &known[i];
  }
  reduce(std::move(tracks));
  Clip clip = compile(task.scene, keys, rounding);
  const Clip full = unpacked(clip);
  const Clip* const forms[] = {&clip, &full};
  out.error = measure_clip(task.samples, forms);
  out.within.clip =
      with_certificate(clip, certificate_of(task.samples, keys, clip, task.source_bytes, out.error, task.budget_m));
  return out;
}

bool is_smaller(const ClipWithin& a, const std::optional<ClipWithin>& b) {
  return !b || a.clip.certificate()->bytes < b->clip.certificate()->bytes;
}

/// The result of one search, and the number of poses that it evaluated.
struct Found {
  std::optional<ClipWithin> smallest;
  std::uint64_t truth_poses = 0;
};

/// Tightens the shares until the clip is within the budget. Then loosens and tightens a few more times to make it
/// smaller. Finds nothing if no clip is within the budget in kMaxRounds rounds.
Found fit(const Task& task, double of_rounding) {
  Shares shares(task.scene, task.budget_m);
  Found found;
  std::vector<StepDeviations> known;
  for (int round = 0, more = 0; round < kMaxRounds && more <= kLoosened; ++round, more += found.smallest.has_value()) {
    Attempt attempt = try_shares(task, shares, of_rounding, known);
    found.truth_poses += attempt.error.truth_poses;
    if (shares.tighten(attempt.error)) continue;
    if (is_smaller(attempt.within, found.smallest)) found.smallest = std::move(attempt.within);
    shares.loosen(attempt.error);
  }
  return found;
}

/// Compiles all keys and attaches a certificate.
Clip measured(const TruthSamples& truth, const Animation& keys, double asked_m) {
  const Clip clip = compile(truth.scene(), keys);
  const Clip* const forms[] = {&clip};
  const ClipError error = measure_clip(truth, forms);
  const std::uint64_t source_bytes = saved_bytes(compile(truth.scene(), truth.truth()));
  return with_certificate(clip, certificate_of(truth, keys, clip, source_bytes, error, asked_m));
}

}  // namespace

Clip compile_and_measure(const Scene& scene, const Animation& keys, const Animation& truth,
                         const VirtualVertices& vertices, double asked_m) {
  const std::vector<double> times_s = times_to_check(truth, scene.skeleton.joint_count());
  return measured(TruthSamples(scene, truth, vertices, times_s, 0), keys, asked_m);
}

struct ClipSearch::State {
  Task task;
  std::array<Found, kParts> found;
};

ClipSearch::ClipSearch(const Scene& scene, const Animation& truth, const VirtualVertices& vertices, double budget_m) {
  CONTRACT(budget_m > 0.0 && vertices.boxes.size() == scene.skeleton.joint_count());
  state_.reset(new State{{scene, truth, vertices, budget_m}, {}});
}

ClipSearch::~ClipSearch() = default;

void ClipSearch::run(std::size_t part) { state_->found[part] = fit(state_->task, kOfRounding[part]); }

ClipWithin ClipSearch::take() {
  const Task& task = state_->task;
  std::optional<ClipWithin> smallest;
  std::uint64_t truth_poses = task.samples.kept_count();
  for (Found& found : state_->found) {
    truth_poses += found.truth_poses;
    if (found.smallest && is_smaller(*found.smallest, smallest)) smallest = std::move(found.smallest);
  }
  if (!smallest) smallest = {task.truth, measured(task.samples, task.truth, task.budget_m)};
  smallest->truth_poses = truth_poses;
  return *std::move(smallest);
}

ClipWithin compile_clip_within(const Scene& scene, const Animation& truth, const VirtualVertices& vertices,
                               double budget_m) {
  CONTRACT(budget_m >= 0.0 && vertices.boxes.size() == scene.skeleton.joint_count());
  if (budget_m == 0.0) return {truth, compile_and_measure(scene, truth, truth, vertices, budget_m)};
  ClipSearch search(scene, truth, vertices, budget_m);
  for (std::size_t part = 0; part < ClipSearch::kParts; ++part) search.run(part);
  return search.take();
}

}  // namespace sinew
