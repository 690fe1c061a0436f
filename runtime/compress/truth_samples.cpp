// SPDX-License-Identifier: MIT
#include "runtime/compress/truth_samples.h"

#include <algorithm>

#include "runtime/animation/track_sample.h"
#include "runtime/math/affine.h"

namespace sinew {
namespace {

/// The largest scale from mesh space to model space over all joints that move the instance.
double stretch_of(const Scene& scene, const MeshInstance& instance, std::span<const Affined> model) {
  double stretch = 0.0;
  if (instance.skin == kNone) {
    stretch = instance.copies.empty() ? 1.0 : 0.0;
    for (const Transform& copy : instance.copies)
      stretch = std::max(stretch, largest_stretch(affine_cast<double>(affine_from_transform(copy))));
    return stretch * largest_stretch(model[instance.joint]);
  }
  const Skin& skin = scene.skins[instance.skin];
  for (std::size_t i = 0; i < skin.joints.size(); ++i)
    stretch = std::max(stretch, largest_stretch(model[skin.joints[i]] * affine_cast<double>(skin.inverse_bind[i])));
  return stretch;
}

std::size_t bytes_of_sample(const Scene& scene, const Animation& truth) {
  std::size_t numbers = truth.weights.empty() ? 0 : scene.instances.size();
  for (const WeightAnimation& animated : truth.weights) numbers += animated.weights.target_count;
  return sizeof(TruthSample) + scene.skeleton.joint_count() * sizeof(BoxCorners) + numbers * sizeof(double);
}

}  // namespace

BoxCorners corners_in_model(const Affined& model, const Aabb& box) noexcept {
  const Vec3<double> lower(box.lower), upper(box.upper);
  BoxCorners out;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Vec4<double>& row = model.row[axis];
    const double x[] = {row.x * lower.x, row.x * upper.x}, y[] = {row.y * lower.y, row.y * upper.y};
    const double z[] = {row.z * lower.z, row.z * upper.z};
    const double xy[] = {x[0] + y[0], x[1] + y[0], x[0] + y[1], x[1] + y[1]};
    for (std::size_t i = 0; i < 4; ++i) out[axis][i] = xy[i] + z[0] + row.w;
    for (std::size_t i = 0; i < 4; ++i) out[axis][4 + i] = xy[i] + z[1] + row.w;
  }
  return out;
}

TruthSamples::TruthSamples(const Scene& scene, const Animation& truth, const VirtualVertices& vertices,
                           std::span<const double> times_s, std::size_t kept_bytes)
    : scene_(scene), truth_(truth), vertices_(vertices), times_s_(times_s) {
  kept_.resize(std::min(times_s.size(), kept_bytes / bytes_of_sample(scene, truth)));
  TruthPose pose;
  TruthCursor cursor(truth, scene.skeleton);
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    cursor.evaluate(times_s[i], pose);
    fill(times_s[i], pose, kept_[i]);
  }
}

const TruthSample& TruthSamples::at(std::size_t time, Scratch& scratch) const {
  if (time < kept_.size()) return kept_[time];
  evaluate_truth(truth_, scene_.skeleton, times_s_[time], scratch.pose);
  fill(times_s_[time], scratch.pose, scratch.sample);
  ++scratch.evaluated;
  return scratch.sample;
}

void TruthSamples::fill(double time_s, const TruthPose& pose, TruthSample& out) const {
  out.corners.resize(pose.model.size());
  for (std::size_t j = 0; j < pose.model.size(); ++j)
    out.corners[j] = corners_in_model(pose.model[j], vertices_.boxes[j]);
  if (truth_.weights.empty()) return;
  out.weights.clear();
  out.stretch.assign(scene_.instances.size(), 0.0);
  for (const WeightAnimation& animated : truth_.weights) {
    if (animated.weights.empty()) continue;
    out.weights.resize(out.weights.size() + animated.weights.target_count);
    sample_track<double>(animated.weights, time_s, std::span(out.weights).last(animated.weights.target_count));
    out.stretch[animated.instance] = stretch_of(scene_, scene_.instances[animated.instance], pose.model);
  }
}

}  // namespace sinew
