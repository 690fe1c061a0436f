// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "importer/python/module/errors.h"
#include "importer/python/module/evaluate.h"
#include "importer/python/module/parallel_frames.h"
#include "runtime/plan/run_plan.h"
#include "runtime/pose/pose_memory.h"

namespace sinew::python {
namespace {

/// The plan of a scene whose pose comes from the caller.
Plan plan_of_poses(const SceneHandle& scene, Skinning kind, bool normals) {
  PoseProgram pose;
  pose.external(0);
  Needs needs{.out = {.joints = true,
                      .local_pose = false,
                      .positions = true,
                      .normals = normals,
                      .tangents = false,
                      .properties = false,
                      .hidden_meshes = true},
              .in = {.max_layers = 1, .program = room_of(pose.ops())},
              .skin = {.kind = kind}};
  return compile_plan(scene.scene, needs);
}

/// Transforms directions like the inverse transpose of a matrix, then makes them unit.
glm::vec3 turned_normal(const Affine& matrix, const glm::vec3& normal) {
  const Mat3<double> m = linear_part(affine_cast<double>(matrix));
  const double sign = glm::dot(m[0], glm::cross(m[1], m[2])) < 0.0 ? -1.0 : 1.0;
  const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
  const glm::dvec3 turned = sign * (cofactors * glm::dvec3(normal));
  const double length = glm::length(turned);
  return length > 0.0 ? glm::vec3(turned / length) : normal;
}

/// Copies vertices to their places in the file, in world space.
/// in   vertices  in the order of the primitive;   world_of  brings one of them into world space
template <class WorldOf>
void store_vertices(const Primitive& primitive, std::span<const glm::vec3> vertices, float* to,
                    const WorldOf& world_of) {
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const std::size_t place = primitive.source_vertex.empty() ? v : primitive.source_vertex[v];
    const glm::vec3 world = world_of(vertices[v]);
    std::copy_n(&world.x, 3, to + place * 3);
  }
}

/// Number of vertices of the file's primitive; those that no triangle uses may be missing in the scene.
std::size_t vertices_in_file(const Primitive& primitive) {
  if (primitive.source_vertex.empty()) return primitive.positions.size();
  return std::size_t{1} + *std::max_element(primitive.source_vertex.begin(), primitive.source_vertex.end());
}

void store_frame(const Scene& scene, const FrameResult& result, std::size_t frame, std::vector<SkinnedPrimitive>& out,
                 bool normals) {
  for (std::size_t i = 0; i < out.size(); ++i) {
    const DeformedPrimitive& deformed = result.primitives[i];
    const Affine& world = result.instances[deformed.instance].world_from_mesh;
    const Primitive& primitive = scene.meshes[scene.instances[deformed.instance].mesh].primitives[deformed.primitive];
    const std::size_t row = vertices_in_file(primitive) * 3;
    const auto own_or = [](const auto& changed, const auto& own) {
      return changed.empty() ? std::span<const glm::vec3>(own) : changed;
    };
    store_vertices(primitive, own_or(deformed.positions, primitive.positions), out[i].positions.data() + frame * row,
                   [&](const glm::vec3& p) { return transform_point(world, p); });
    if (normals && out[i].normals.size() > 0)
      store_vertices(primitive, own_or(deformed.normals, primitive.normals), out[i].normals.data() + frame * row,
                     [&](const glm::vec3& n) { return turned_normal(world, n); });
  }
}

}  // namespace

std::vector<SkinnedPrimitive> skin(const SceneHandle& scene, const PoseViews& poses, Skinning kind, bool normals,
                                   std::size_t threads) {
  const Plan plan = plan_of_poses(scene, kind, normals);
  std::vector<SkinnedPrimitive> out;
  for (const MeshInstance& instance : scene.scene->instances) {
    const Mesh& mesh = scene.scene->meshes[instance.mesh];
    for (std::uint32_t p = 0; p < mesh.primitives.size(); ++p) {
      const std::size_t vertices = vertices_in_file(mesh.primitives[p]);
      const bool has_normals = normals && !mesh.primitives[p].normals.empty();
      out.push_back({scene.scene->skeleton.node_of_joint[instance.joint], instance.mesh, p,
                     ArrayMemory<float>({poses.frames, vertices, 3}),
                     ArrayMemory<float>({poses.frames, has_normals ? vertices : 0, 3})});
      std::fill_n(out.back().positions.data(), out.back().positions.size(), 0.0f);  // vertices that no triangle uses
      std::fill_n(out.back().normals.data(), out.back().normals.size(), 0.0f);
    }
  }
  parallel_frames(poses.frames, threads, [&](std::size_t first, std::size_t last) {
    FrameBuffer frame(plan);
    PoseMemory memory(poses.joints);
    PoseProgram program;
    program.external(0);
    for (std::size_t f = first; f < last; ++f) {
      load_pose(poses, f, memory.span());
      const ExternalPose pose{
          .pose = memory.span(), .weights = {poses.morph_weights + f * poses.weights, poses.weights}, .properties = {}};
      FrameInput input;
      input.program = program.ops();
      input.program_inputs.externals = {&pose, 1};
      if (const ErrorCode code = run_plan(plan, input, frame); code != ErrorCode::ok)
        throw std::invalid_argument("skin: frame " + std::to_string(f) + ": " + why_refused(plan, input, frame));
      store_frame(*scene.scene, frame.result(), f, out, normals);
    }
  });
  return out;
}

}  // namespace sinew::python
