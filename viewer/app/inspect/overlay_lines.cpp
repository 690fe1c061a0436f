// SPDX-License-Identifier: MIT
#include "viewer/app/inspect/overlay_lines.h"

#include <algorithm>
#include <cmath>

#include "viewer/app/inspect/frame_vertices.h"
#include "viewer/app/inspect/pick.h"

namespace sinew::viewer {
namespace {

constexpr std::uint32_t kWire = 0x70ffa050u, kBox = 0xffff9040u, kTrail = 0xff40b0ffu, kVertex = 0xffff60ffu;
constexpr std::uint32_t kBefore = 0x00ff8040u, kAfter = 0x0040c0ffu;  // without alpha
constexpr float kLargeAxis = 4.0f;                                    // of the inspected joint, to those of others

glm::vec3 point(const Affine& m, const glm::vec3& p) { return transform_point(m, p); }

}  // namespace

std::span<const LineVertex> OverlayLines::make(const FrameResult& frame, const Inspected& inspected, bool skeleton,
                                               const Moment& moment, const Aabb& size) {
  const float axis_m = skeleton_.axis_length_m(size);
  if (!inspected.draws_lines()) return skeleton ? skeleton_.make(frame.model, axis_m) : std::span<const LineVertex>();
  lines_.clear();
  if (skeleton) {
    const auto bones = skeleton_.make(frame.model, axis_m);
    lines_.assign(bones.begin(), bones.end());
  }
  const bool has_joint = inspected.joint < frame.model.size();
  if (inspected.wireframe) add_wireframe(frame);
  if (inspected.boxes) add_boxes(frame);
  if (has_joint) add_joint(frame.model, inspected.joint, kLargeAxis * axis_m);
  if (inspected.vertex.instance < frame.instances.size()) add_vertex(frame, inspected.vertex, axis_m);
  if ((inspected.trail && has_joint) || inspected.ghosts) evaluate_poses(moment);
  if (inspected.trail && has_joint) add_trail(inspected.joint);
  if (inspected.ghosts) add_ghosts(moment.time_s, axis_m);
  return lines_;
}

void OverlayLines::add_wireframe(const FrameResult& frame) {
  const Scene& scene = loaded_.scene;
  edges_.resize(scene.meshes.size());
  for_each_primitive(scene, frame, [&](std::size_t index, const Primitive& primitive, std::size_t instance) {
    if (primitive.topology != Topology::triangles) return;
    auto& of_mesh = edges_[scene.instances[instance].mesh];
    of_mesh.resize(std::max(of_mesh.size(), index - frame.instances[instance].first_primitive + 1));
    std::vector<Edge>& edges = of_mesh[index - frame.instances[instance].first_primitive];
    if (edges.empty()) {
      for (std::size_t t = 0; t + 2 < primitive.indices.size(); t += 3)
        for (std::size_t c = 0; c < 3; ++c) {
          const auto [a, b] = std::minmax(primitive.indices[t + c], primitive.indices[t + (c + 1) % 3]);
          edges.push_back({a, b});
        }
      std::sort(edges.begin(), edges.end());
      edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    }
    const auto positions = positions_of(frame, index, primitive);
    for_each_copy(scene.instances[instance], frame.instances[instance].world_from_mesh, [&](const Affine& world) {
      for (const Edge& edge : edges)
        for (const std::uint32_t v : {edge.a, edge.b}) lines_.push_back({point(world, positions[v]), kWire});
    });
  });
}

void OverlayLines::add_boxes(const FrameResult& frame) {
  for (const InstanceResult& instance : frame.instances) {
    const Aabb& box = instance.bounds;
    if (!instance.visible || box.empty()) continue;
    for (int corner = 0; corner < 8; ++corner)
      for (int axis = 0; axis < 3; ++axis) {
        if (corner >> axis & 1) continue;
        for (const int end : {corner, corner | 1 << axis})
          lines_.push_back({{(end & 1 ? box.upper : box.lower).x, (end & 2 ? box.upper : box.lower).y,
                             (end & 4 ? box.upper : box.lower).z},
                            kBox});
      }
  }
}

void OverlayLines::add_joint(std::span<const Affine> model, std::uint32_t joint, float axis_m) {
  const auto axes = SkeletonLines::axes_of(model[joint], axis_m);
  lines_.insert(lines_.end(), axes.begin(), axes.end());
}

void OverlayLines::add_vertex(const FrameResult& frame, const VertexPlace& vertex, float axis_m) {
  const glm::vec3 at(position_of(loaded_.scene, frame, vertex));
  for (int axis = 0; axis < 3; ++axis) {
    glm::vec3 half(0.0f);
    half[axis] = axis_m;
    lines_.push_back({at - half, kVertex});
    lines_.push_back({at + half, kVertex});
  }
}

void OverlayLines::add_trail(std::uint32_t joint) {
  for (std::size_t i = 1; i < poses_.size(); ++i) {
    lines_.push_back({translation_of(poses_[i - 1][joint]), kTrail});
    lines_.push_back({translation_of(poses_[i][joint]), kTrail});
  }
}

/// The three evaluated poses before a time, and those after it, the fainter the farther away.
void OverlayLines::add_ghosts(double time_s, float axis_m) {
  constexpr std::ptrdiff_t kGhosts = 3, kApart = 4;
  const auto next = std::lower_bound(pose_times_s_.begin(), pose_times_s_.end(), time_s) - pose_times_s_.begin();
  for (std::ptrdiff_t ghost = 1; ghost <= kGhosts; ++ghost)
    for (const bool after : {false, true}) {
      const std::ptrdiff_t pose = after ? next + kApart * ghost - 1 : next - kApart * ghost;
      if (pose < 0 || pose >= static_cast<std::ptrdiff_t>(poses_.size())) continue;
      const auto alpha = static_cast<std::uint32_t>(200 / ghost) << 24;
      for (LineVertex vertex : skeleton_.make(poses_[static_cast<std::size_t>(pose)], axis_m)) {
        vertex.rgba = (after ? kAfter : kBefore) | alpha;
        lines_.push_back(vertex);
      }
    }
}

void OverlayLines::evaluate_poses(const Moment& moment) {
  constexpr std::size_t kPoses = 64;
  const Scene& scene = loaded_.scene;
  const MotionSettings settings = moment.moved ? moment.moved->settings : MotionSettings();
  if (!poses_.empty() && poses_clip_ == moment.clip && poses_moved_by_ == settings) return;
  poses_.clear();
  pose_times_s_.clear();
  poses_clip_ = moment.clip;
  poses_moved_by_ = settings;
  const double duration_s = pose_times(scene, moment.clip, loaded_.cache.get(), moment.moved).back();
  for (std::size_t i = 0; i < kPoses; ++i)
    pose_times_s_.push_back(duration_s * static_cast<double>(i) / static_cast<double>(kPoses - 1));
  for_each_pose(
      scene, moment.clip, nullptr, pose_times_s_,
      [&](const FrameResult& pose) { poses_.emplace_back(pose.model.begin(), pose.model.end()); }, moment.moved);
}

}  // namespace sinew::viewer
