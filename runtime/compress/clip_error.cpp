// SPDX-License-Identifier: MIT
#include "runtime/compress/clip_error.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

#include "runtime/animation/track_sample.h"
#include "runtime/animation/truth_pose.h"
#include "runtime/math/stretch.h"
#include "runtime/pose/pose_memory.h"
#include "runtime/pose/sample_clip.h"

namespace sinew {
namespace {

/// A parabola over the interval, as cubics differ, is at its top within 1/12 of one of these: 3 percent above what is
/// seen there.
constexpr double kBetween[] = {1.0 / 6, 2.0 / 6, 3.0 / 6, 4.0 / 6, 5.0 / 6};

/// Calls `visit(track)` for each track of joints and weights.
template <class Visit>
void each_track(const Animation& truth, const Visit& visit) {
  for (const BoneAnimation& bone : truth.bones) {
    visit(bone.translation);
    visit(bone.rotation);
    visit(bone.scale);
  }
  for (const WeightAnimation& animated : truth.weights) visit(animated.weights);
}

void sort_out(std::vector<float>& times) {
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
}

/// Times at which a track has one value and right before them another: keys of steps, and keys that share a time.
std::vector<float> jump_times(const Animation& truth) {
  std::vector<float> times;
  each_track(truth, [&](const auto& track) {
    for (std::size_t k = 1; k < track.times_s.size(); ++k)
      if (track.interpolation == Interpolation::step || track.times_s[k] == track.times_s[k - 1])
        times.push_back(track.times_s[k]);
  });
  sort_out(times);
  return times;
}

class Meter {
 public:
  Meter(const Scene& scene, const Animation& truth, const VirtualVertices& vertices)
      : scene_(scene),
        truth_(truth),
        vertices_(vertices),
        memory_(scene.skeleton.joint_count()),
        local_(scene.skeleton.joint_count()),
        model_(local_.size()),
        weights_(truth.weights.empty() ? 0 : scene.weight_count()) {
    error_.of_joint_m.assign(local_.size(), 0.0);
  }

  void look_at(double time_s, std::span<const Clip* const> forms) {
    evaluate_truth(truth_, scene_.skeleton, time_s, pose_);
    for (const Clip* clip : forms) compare(*clip, time_s);
  }

  ClipError take() noexcept { return std::move(error_); }

 private:
  struct Worst {
    std::uint32_t joint = kNone;
    double error_m = 0.0;
  };

  void compare(const Clip& clip, double time_s) {
    run(SampleClipJob{.clip = &clip, .time_s = time_s, .pose = memory_.span(), .weights = weights_});
    for (std::size_t j = 0; j < local_.size(); ++j) local_[j] = in_double(memory_.span().get(j));
    model_from_local(scene_.skeleton, local_, model_);
    const auto [joint, joints_m] = compare_joints();
    const double weights_m = weights_.empty() ? 0.0 : compare_weights(time_s);
    error_.weights_m = std::max(error_.weights_m, weights_m);
    if (!(joints_m + weights_m <= error_.worst_m)) {
      error_.worst_m = joints_m + weights_m;
      error_.worst_time_s = time_s;
      error_.worst_joint = joint;
    }
  }

  Worst compare_joints() {
    Worst worst;
    for (std::uint32_t j = 0; j < local_.size(); ++j) {
      double largest = 0.0;  // squared
      for (const Vec3<double>& corner : corners_of(vertices_.boxes[j])) {
        const Vec3<double> d = transform_point(model_[j], corner) - transform_point(pose_.model[j], corner);
        largest = std::max(largest, square_of(d));
      }
      const double error_m = std::sqrt(largest);
      error_.of_joint_m[j] = std::max(error_.of_joint_m[j], error_m);
      if (error_m > worst.error_m) worst = {j, error_m};
    }
    return worst;
  }

  double compare_weights(double time_s) {
    std::vector<double> displaced_m(scene_.instances.size(), 0.0), value;
    for (const WeightAnimation& animated : truth_.weights) {
      if (animated.weights.empty()) continue;
      value.resize(animated.weights.target_count);
      sample_track<double>(animated.weights, time_s, value);
      const std::size_t first = scene_.first_weight[animated.instance] + animated.first_target;
      double& sum = displaced_m[animated.instance];
      for (std::size_t i = 0; i < value.size(); ++i)
        sum += std::abs(static_cast<double>(weights_[first + i]) - value[i]) *
               static_cast<double>(vertices_.metres_per_weight[first + i]);
    }
    double worst = 0.0;
    for (std::size_t i = 0; i < displaced_m.size(); ++i)
      if (displaced_m[i] > 0.0) worst = std::max(worst, displaced_m[i] * stretch_of(scene_.instances[i]));
    return worst;
  }

  /// From mesh space to model space, whichever joint moves a vertex.
  double stretch_of(const MeshInstance& instance) const {
    double stretch = 0.0;
    if (instance.skin == kNone) {
      stretch = instance.copies.empty() ? 1.0 : 0.0;
      for (const Transform& copy : instance.copies)
        stretch = std::max(stretch, largest_stretch(affine_cast<double>(affine_from_transform(copy))));
      return stretch * largest_stretch(pose_.model[instance.joint]);
    }
    const Skin& skin = scene_.skins[instance.skin];
    for (std::size_t i = 0; i < skin.joints.size(); ++i)
      stretch =
          std::max(stretch, largest_stretch(pose_.model[skin.joints[i]] * affine_cast<double>(skin.inverse_bind[i])));
    return stretch;
  }

  const Scene& scene_;
  const Animation& truth_;
  const VirtualVertices& vertices_;
  PoseMemory memory_;
  std::vector<Transformd> local_;
  std::vector<Affined> model_;
  std::vector<float> weights_;
  TruthPose pose_;
  ClipError error_;
};

}  // namespace

std::vector<float> key_times(const Animation& truth) {
  std::vector<float> times{0.0f, static_cast<float>(truth.duration_s)};
  each_track(truth, [&](const auto& track) { times.insert(times.end(), track.times_s.begin(), track.times_s.end()); });
  sort_out(times);
  return times;
}

std::vector<double> times_to_check(const Animation& truth, std::size_t joint_count) {
  std::vector<double> times;
  const std::vector<float> keys = key_times(truth), jumps = jump_times(truth);
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const double key = static_cast<double>(keys[k]);
    if (std::binary_search(jumps.begin(), jumps.end(), keys[k]))
      times.push_back(static_cast<double>(std::nextafter(keys[k], -std::numeric_limits<float>::infinity())));
    times.push_back(key);
    if (k + 1 == keys.size()) break;
    for (const double f : kBetween) times.push_back(key + f * (static_cast<double>(keys[k + 1]) - key));
  }
  std::size_t step = times.size() * joint_count / kMostJointTimes + 1;
  if (step == 1) return times;
  while (std::gcd(step, std::size(kBetween) + 1) > 1)
    ++step;  // else it would never meet some of the places between keys, or none
  std::vector<double> some;
  for (std::size_t i = 0; i < times.size(); i += step) some.push_back(times[i]);
  return some;
}

ClipError measure_clip(const Scene& scene, const Animation& truth, const VirtualVertices& vertices,
                       std::span<const Clip* const> forms, std::span<const double> times_s) {
  Meter meter(scene, truth, vertices);
  for (const double time_s : times_s) meter.look_at(time_s, forms);
  return meter.take();
}

}  // namespace sinew
