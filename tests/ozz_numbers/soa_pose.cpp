// SPDX-License-Identifier: MIT
#include "tests/ozz_numbers/soa_pose.h"

#include <cstdlib>
#include <memory>

#include "runtime/pose_program/run_pose_program.h"
#include "tests/support/tiny_assets.h"

namespace sinew::ozz {
namespace {

Transform transform_of(const SoaPose& pose, std::size_t lane) {
  const auto vector = [&](const Axes& axes) { return glm::vec3(axes[0][lane], axes[1][lane], axes[2][lane]); };
  const auto& q = pose.rotation;
  return {vector(pose.translation), quat_xyzw(q[0][lane], q[1][lane], q[2][lane], q[3][lane]), vector(pose.scale)};
}

void put(const Transform& t, std::size_t lane, SoaPose& pose) {
  for (int axis = 0; axis < 3; ++axis) {
    pose.translation[std::size_t(axis)][lane] = t.translation[axis];
    pose.scale[std::size_t(axis)][lane] = t.scale[axis];
  }
  const float numbers[] = {t.rotation.x, t.rotation.y, t.rotation.z, t.rotation.w};
  for (std::size_t c = 0; c < 4; ++c) pose.rotation[c][lane] = numbers[c];
}

test::PoseBuffer buffer_of(std::span<const SoaPose> pose) {
  test::PoseBuffer buffer(4 * pose.size());
  for (std::size_t j = 0; j < 4 * pose.size(); ++j) buffer.span().set(j, transform_of(pose[j / 4], j % 4));
  return buffer;
}

/// A program with the poses and masks that it names.
class BlendProgram {
 public:
  explicit BlendProgram(const SoaBlend& blend) {
    for (const SoaLayer& layer : blend.layers) push(layer);
    program.mean(static_cast<std::uint32_t>(blend.layers.size()), 1.0f, blend.threshold);
    for (const SoaLayer& layer : blend.additive) {
      push(layer);
      push({.pose = std::vector<SoaPose>(blend.rest.size())});
      program.add(1.0f, DeltaFrame::joint);
    }
    for (test::PoseBuffer& pose : poses_) externals.push_back({.pose = pose.span()});
    for (const std::vector<float>& weights : mask_weights_) masks.push_back({.joints = weights});
  }
  BlendProgram(const BlendProgram&) = delete;

  PoseProgram program;
  std::vector<ExternalPose> externals;
  std::vector<PoseMask> masks;

 private:
  void push(const SoaLayer& layer) {
    std::uint8_t mask = PoseOp::kNoMask;
    if (!layer.joint_weights.empty()) {
      mask = static_cast<std::uint8_t>(mask_weights_.size());
      mask_weights_.push_back(layer.joint_weights);
    }
    program.external(static_cast<std::uint32_t>(poses_.size()), layer.weight, mask);
    poses_.push_back(buffer_of(layer.pose));
  }

  std::vector<test::PoseBuffer> poses_;
  std::vector<std::vector<float>> mask_weights_;
};

}  // namespace

Axes rising(float first, float step) {
  Axes axes{};
  for (std::size_t i = 0; i < 12; ++i) axes[i / 4][i % 4] = first + step * static_cast<float>(i);
  return axes;
}

ErrorCode run(const SoaBlend& blend, std::vector<SoaPose>& out) {
  BlendProgram made(blend);
  const std::size_t joints = 4 * blend.rest.size();
  const Skeleton skeleton = test::skeleton_of(std::vector<std::uint32_t>(joints, kNone));
  test::PoseBuffer rest = buffer_of(blend.rest), result(joints);
  const PoseProgramAssets assets{.skeleton = &skeleton, .rest = rest.span()};
  const std::size_t bytes = pose_program_bytes(assets, room_of(made.program.ops()));
  const std::unique_ptr<std::byte[], decltype(&std::free)> memory(
      static_cast<std::byte*>(std::aligned_alloc(64, bytes)), std::free);
  const ErrorCode code = sinew::run(PoseProgramJob{.program = made.program.ops(),
                                                   .assets = &assets,
                                                   .inputs = {.externals = made.externals, .masks = made.masks},
                                                   .memory = {memory.get(), bytes},
                                                   .pose = result.span()});
  out.resize(blend.rest.size());
  for (std::size_t j = 0; j < joints; ++j) put(result.span().get(j), j % 4, out[j / 4]);
  return code;
}

Tally tally_of(const SoaBlend& blend, const SoaNumbers& expected) {
  Tally tally;
  std::vector<SoaPose> found;
  EXPECT_EQ(run(blend, found), ErrorCode::ok);
  const auto compare_axes = [&](const Axes& a, const Axes& b) {
    for (std::size_t i = 0; i < 12; ++i) compare(double(a[i / 4][i % 4]), double(b[i / 4][i % 4]), kTolerance, tally);
  };
  for (std::size_t s = 0; s < expected.translation.size(); ++s)
    compare_axes(found[s].translation, expected.translation[s]);
  for (std::size_t s = 0; s < expected.scale.size(); ++s) compare_axes(found[s].scale, expected.scale[s]);
  for (std::size_t s = 0; s < expected.rotation.size(); ++s)
    for (std::size_t lane = 0; lane < 4; ++lane) {
      SoaPose pose;
      pose.rotation = expected.rotation[s];
      compare_rotation(transform_of(found[s], lane).rotation, transform_of(pose, lane).rotation, tally);
    }
  return tally;
}

}  // namespace sinew::ozz
