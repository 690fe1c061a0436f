// SPDX-License-Identifier: MIT
#include "runtime/compress/fit_keys.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "runtime/animation/track_sample.h"
#include "runtime/base/contract.h"
#include "runtime/compress/animation_counts.h"
#include "runtime/compress/clip_error.h"
#include "runtime/compress/drop_rows.h"
#include "runtime/compress/fit_joints.h"
#include "runtime/compress/key_lists.h"
#include "runtime/compress/remove_keys.h"

namespace sinew {
namespace {

/// Fraction of the budget that the search uses. The rest covers times that it does not examine.
constexpr double kSearchedPart = 0.98;
/// Number of searches with other shares. Then the number of searches with a smaller budget, if the measured error is
/// too large.
constexpr int kLooks = 3, kSmaller = 4;
/// The part of the budget of morph weights, if joints move as well.
constexpr double kWeightsPart = 0.25;
/// Number of poses in which the size of morph displacements in model space is measured.
constexpr int kMorphPoses = 12;

std::uint64_t value_bytes(const Animation& animation, std::set<std::vector<float>>& times) {
  std::uint64_t bytes = 0;
  for (std::size_t t = 0; t < track_count(animation); ++t)
    with_track(animation, t, [&](const auto& track) {
      if (track.empty()) return;
      bytes += FileBytes::kValues + track.values.size() * sizeof(track.values[0]);
      times.insert(track.times_s);
    });
  for (const PropertyTrack& property : animation.properties) {
    bytes += FileBytes::kValues + property.values.values.size() * sizeof(float);
    times.insert(property.values.times_s);
  }
  return bytes;
}

/// [instances] The largest stretch (truth_samples.h) of each instance over the animation.
std::vector<double> stretches(const Scene& scene, const Animation& truth, const VirtualVertices& vertices) {
  std::vector<double> largest(scene.instances.size(), 0.0), times_s;
  for (int i = 0; i < kMorphPoses; ++i) times_s.push_back(truth.duration_s * i / (kMorphPoses - 1));
  const TruthSamples samples(scene, truth, vertices, times_s, 0);
  TruthSamples::Scratch scratch;
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    const TruthSample& sample = samples.at(i, scratch);
    for (std::size_t k = 0; k < largest.size(); ++k) largest[k] = std::max(largest[k], sample.stretch[k]);
  }
  return largest;
}

bool can_change(const WeightTrack& track) { return !track.empty() && track.interpolation != Interpolation::squad; }

/// Sum of displacements between two keys.
double apart_m(const WeightTrack& track, std::size_t a, std::size_t b, std::span<const float> metres) {
  const auto value = [&](std::size_t key, std::size_t i) {
    return static_cast<double>(track.values[value_row(track.interpolation, key) * track.target_count + i]);
  };
  double sum = 0.0;
  for (std::size_t i = 0; i < track.target_count; ++i)
    sum += std::abs(value(a, i) - value(b, i)) * static_cast<double>(metres[i]);
  return sum;
}

/// The key that is nearest to the first key, the last key and the one in the middle. kNone if another key is farther
/// from it than the tolerance.
std::uint32_t resting_key(const WeightTrack& track, const LooseTrack& loose) {
  const std::size_t count = track.key_count();
  std::uint32_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t key = 0; key < count; ++key) {
    double most = 0.0;
    for (const std::size_t other : {std::size_t{0}, count / 2, count - 1})
      most = std::max(most, apart_m(track, key, other, loose.metres_per_weight));
    if (most < least) best = key;
    least = std::min(least, most);
  }
  for (std::size_t key = 0; key < count; ++key)
    if (apart_m(track, best, key, loose.metres_per_weight) > loose.tolerance) return kNone;
  return best;
}

/// True if the weights that the target has without a track may stand for all keys.
bool can_leave_out(const WeightTrack& track, const LooseTrack& loose, std::span<const float> without) {
  for (std::size_t key = 0; key < track.key_count(); ++key) {
    double sum = 0.0;
    for (std::size_t i = 0; i < track.target_count; ++i) {
      const float value = track.values[value_row(track.interpolation, key) * track.target_count + i];
      sum += std::abs(static_cast<double>(value) - static_cast<double>(without[i])) *
             static_cast<double>(loose.metres_per_weight[i]);
    }
    if (!(sum <= loose.tolerance)) return false;
  }
  return true;
}

/// Chooses the keys of morph weights, which no other track depends on.
void fit_weights(const Scene& scene, const Animation& truth, const Animation& stored, const VirtualVertices& vertices,
                 double budget_m, std::vector<KeptKeys>& out) {
  const std::vector<double> stretch = stretches(scene, truth, vertices);
  const std::vector<float> rest_weights = rest_weights_of(scene);
  for (std::size_t w = 0; w < truth.weights.size(); ++w) {
    const WeightAnimation& animated = truth.weights[w];
    if (!can_change(animated.weights)) continue;
    const std::size_t at = scene.first_weight[animated.instance] + animated.first_target;
    const auto metres = std::span(vertices.metres_per_weight).subspan(at, animated.weights.target_count);
    const double by_stretch = stretch[animated.instance];
    WeightTrack copy = stored.weights[w].weights;
    const LooseTrack loose{&copy, by_stretch > 0.0 ? budget_m / by_stretch : 0.0, metres};
    const std::uint32_t resting = resting_key(copy, loose);
    const auto without = std::span(rest_weights).subspan(at, copy.target_count);
    out.push_back({3 * truth.bones.size() + w,
                   resting != kNone ? std::vector{resting} : keys_needed({&loose, 1}, copy.key_count()),
                   resting != kNone, resting != kNone && can_leave_out(copy, loose, without)});
  }
}

struct Form {
  std::vector<KeptKeys> tracks;
  std::uint64_t bytes = std::numeric_limits<std::uint64_t>::max();
};

/// The smallest form that the search finds, before it is measured.
Form search(const Scene& scene, const Animation& truth, const Animation& stored, const VirtualVertices& vertices,
            JointFit& joints, double budget_m) {
  const bool has_weights = std::any_of(truth.weights.begin(), truth.weights.end(),
                                       [](const WeightAnimation& w) { return can_change(w.weights); });
  const double weights_m = !has_weights ? 0.0 : (joints.empty() ? 1.0 : kWeightsPart) * budget_m;
  std::vector<KeptKeys> weights;
  if (has_weights) fit_weights(scene, truth, stored, vertices, weights_m, weights);
  Form best;
  for (int look = 0; look < kLooks; ++look) {
    Form form{joints.fit(budget_m - weights_m), 0};
    form.tracks.insert(form.tracks.end(), weights.begin(), weights.end());
    share_key_times(truth, form.tracks);
    form.bytes = bytes_in_file(with_keys(truth, form.tracks));
    const bool hardly_smaller = form.bytes >= best.bytes - best.bytes / 100;
    if (form.bytes < best.bytes) best = std::move(form);
    if (joints.empty() || hardly_smaller) break;
    joints.share_by_need();
  }
  return best;
}

/// The keys of a form that is within the budget, and after drop_rows().
Animation with_fewer_rows(const Animation& truth, const Animation& stored, const TruthSamples& samples, double budget_m,
                          std::vector<KeptKeys> tracks) {
  Animation kept = with_keys(truth, tracks);
  drop_rows(stored, samples, kSearchedPart * budget_m, tracks);
  // The ends that with_keys() adds, and keys that no time of the search showed, may still have an effect.
  if (measure_animation(samples, with_keys(stored, tracks)).worst_m <= budget_m) kept = with_keys(truth, tracks);
  return kept;
}

}  // namespace

std::uint64_t bytes_in_file(const Animation& animation) {
  std::set<std::vector<float>> times;
  std::uint64_t bytes = value_bytes(animation, times);
  for (const std::vector<float>& list : times) bytes += FileBytes::kTimes + list.size() * sizeof(float);
  return bytes;
}

Animation fit_keys(const Scene& scene, const Animation& truth, const Animation& stored, const VirtualVertices& vertices,
                   double budget_m) {
  CONTRACT(budget_m >= 0.0 && vertices.boxes.size() == scene.skeleton.joint_count());
  CONTRACT(track_count(truth) == track_count(stored));
  if (budget_m == 0.0) return truth;
  const std::vector<double> times_s = times_to_check(truth, scene.skeleton.joint_count());
  const TruthSamples samples(scene, truth, vertices, times_s);
  JointFit joints(scene.skeleton, truth, stored, vertices);
  double used = kSearchedPart;
  for (int i = 0; i < kSmaller; ++i) {
    Form form = search(scene, truth, stored, vertices, joints, used * budget_m);
    if (form.bytes >= bytes_in_file(truth)) break;
    const double error_m = measure_animation(samples, with_keys(stored, form.tracks)).worst_m;
    if (error_m <= budget_m) return with_fewer_rows(truth, stored, samples, budget_m, std::move(form.tracks));
    used *= kSearchedPart * budget_m / error_m;
  }
  return truth;
}

ClipCertificate measure_keys(const Scene& scene, const Animation& written, const Animation& truth,
                             const VirtualVertices& vertices, double asked_m) {
  const std::vector<double> times_s = times_to_check(truth, scene.skeleton.joint_count());
  const ClipError error = measure_animation(TruthSamples(scene, truth, vertices, times_s, 0), written);
  return {.asked_m = asked_m,
          .measured_m = error.worst_m,
          .weights_m = error.weights_m,
          .worst_time_s = error.worst_time_s,
          .worst_joint = error.worst_joint,
          .times_checked = static_cast<std::uint32_t>(times_s.size()),
          .animated_joints = animated_joints(truth),
          .source_keys = key_count(truth),
          .kept_keys = key_count(written),
          .source_bytes = bytes_in_file(truth),
          .bytes = bytes_in_file(written)};
}

}  // namespace sinew
