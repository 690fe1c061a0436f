// SPDX-License-Identifier: MIT
#include "runtime/plan/clip_error.h"

#include <algorithm>
#include <cmath>

#include "runtime/assets/track_sample.h"
#include "runtime/jobs/sample_clip.h"
#include "runtime/math/stretch.h"
#include "runtime/plan/truth_pose.h"

namespace sinew {
namespace {

constexpr double kBetween[] = {0.2, 0.4, 0.6, 0.8};

std::vector<float> key_times(const Animation& truth) {
  std::vector<float> times{0.0f, static_cast<float>(truth.duration_s)};
  const auto add = [&](const auto& track) { times.insert(times.end(), track.times_s.begin(), track.times_s.end()); };
  for (const BoneAnimation& bone : truth.bones) add(bone.translation), add(bone.rotation), add(bone.scale);
  for (const WeightAnimation& animated : truth.weights) add(animated.weights);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

class Meter {
 public:
  Meter(const Scene& scene, const Animation& truth, const VirtualVertices& vertices, const Clip& clip)
      : scene_(scene), truth_(truth), vertices_(vertices), clip_(clip), blocks_(PoseSpan::floats_for(scene.skeleton.joint_count()) / 16 + 1),
        local_(scene.skeleton.joint_count()), model_(local_.size()), weights_(truth.weights.empty() ? 0 : clip.weight_count()) {
    error_.of_joint_m.assign(local_.size(), 0.0);
  }

  void look_at(double time_s) {
    const PoseSpan pose = pose_over({blocks_.front().floats, PoseSpan::floats_for(local_.size())}, local_.size());
    run(SampleClipJob{.clip = &clip_, .time_s = time_s, .pose = pose, .weights = weights_});
    for (std::size_t j = 0; j < local_.size(); ++j) local_[j] = in_double(pose.get(j));
    model_from_local(scene_.skeleton, local_, model_);
    evaluate_truth(truth_, scene_.skeleton, time_s, pose_);
    const auto [joint, joints_m] = compare_joints();
    const double weights_m = weights_.empty() ? 0.0 : compare_weights(time_s);
    error_.weights_m = std::max(error_.weights_m, weights_m);
    if (!(joints_m + weights_m <= error_.worst_m)) {
      error_.worst_m = joints_m + weights_m;
      error_.worst_time_s = time_s, error_.worst_joint = joint;
    }
  }

  ClipError take() noexcept { return std::move(error_); }

 private:
  struct Worst {
    std::uint32_t joint = kNone;
    double error_m = 0.0;
  };
  struct alignas(64) Block {
    float floats[16];
  };

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
        sum += std::abs(static_cast<double>(weights_[first + i]) - value[i]) * static_cast<double>(vertices_.metres_per_weight[first + i]);
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
      for (const Transform& copy : instance.copies) stretch = std::max(stretch, largest_stretch(affine_cast<double>(affine_from_transform(copy))));
      return stretch * largest_stretch(pose_.model[instance.joint]);
    }
    const Skin& skin = scene_.skins[instance.skin];
    for (std::size_t i = 0; i < skin.joints.size(); ++i)
      stretch = std::max(stretch, largest_stretch(pose_.model[skin.joints[i]] * affine_cast<double>(skin.inverse_bind[i])));
    return stretch;
  }

  const Scene& scene_;
  const Animation& truth_;
  const VirtualVertices& vertices_;
  const Clip& clip_;
  std::vector<Block> blocks_;
  std::vector<Transformd> local_;
  std::vector<Affined> model_;
  std::vector<float> weights_;
  TruthPose pose_;
  ClipError error_;
};

}  // namespace

std::vector<double> times_to_check(const Animation& truth, std::size_t joint_count) {
  std::vector<double> times;
  const std::vector<float> keys = key_times(truth);
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const double key = static_cast<double>(keys[k]);
    times.push_back(key);
    if (k + 1 == keys.size()) break;
    for (const double f : kBetween) times.push_back(key + f * (static_cast<double>(keys[k + 1]) - key));
  }
  const std::size_t step = times.size() * std::max<std::size_t>(joint_count, 1) / kMostJointTimes + 1;
  if (step == 1) return times;
  std::vector<double> some;
  for (std::size_t i = 0; i < times.size(); i += step) some.push_back(times[i]);
  return some;
}

ClipError measure_clip(const Scene& scene, const Animation& truth, const VirtualVertices& vertices, const Clip& clip,
                       std::span<const double> times_s) {
  Meter meter(scene, truth, vertices, clip);
  for (const double time_s : times_s) meter.look_at(time_s);
  return meter.take();
}

}  // namespace sinew
