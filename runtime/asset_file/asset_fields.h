// SPDX-License-Identifier: MIT
// Fields of each asset in file order. A new member does not compile until added here; then raise kAssetBlockVersion.
#pragma once
#include <tuple>
#include <type_traits>

#include "runtime/model/scene.h"
#include "runtime/model/skeleton_lod.h"
#include "runtime/paging/page_table.h"

namespace sinew {

template <class T, class Asset>
concept Is = std::is_same_v<std::remove_const_t<T>, Asset>;

auto fields(Is<Skeleton> auto& s) {
  auto& [parents, rest, fixed_matrices, fixed_matrix_of, names, node_of_joint, joint_of_node, level_begin] = s;
  return std::tie(parents, rest, fixed_matrices, fixed_matrix_of, names, node_of_joint, joint_of_node, level_begin);
}

auto fields(Is<Skin> auto& s) {
  auto& [name, joints, inverse_bind, skeleton_root] = s;
  return std::tie(name, joints, inverse_bind, skeleton_root);
}

auto fields(Is<VertexInfluences> auto& v) {
  auto& [groups, joints, weights] = v;
  return std::tie(groups, joints, weights);
}

template <class T>
concept IsDeltas = Is<T, SparseDeltas<glm::vec2>> || Is<T, SparseDeltas<glm::vec3>> || Is<T, SparseDeltas<glm::vec4>>;

auto fields(IsDeltas auto& s) {
  auto& [vertices, deltas] = s;
  return std::tie(vertices, deltas);
}

auto fields(Is<MorphTarget> auto& t) {
  auto& [positions, normals, tangents, colors, texcoords] = t;
  return std::tie(positions, normals, tangents, colors, texcoords);
}

auto fields(Is<MorphSet> auto& m) {
  auto& [targets] = m;
  return std::tie(targets);
}

auto fields(Is<Primitive> auto& p) {
  auto& [topology, indices, positions, normals, tangents, texcoords, colors, influences, centers, morphs, material,
         variant_materials, source_vertex, flat_normals, bounds] = p;
  return std::tie(topology, indices, positions, normals, tangents, texcoords, colors, influences, centers, morphs,
                  material, variant_materials, source_vertex, flat_normals, bounds);
}

auto fields(Is<Mesh> auto& m) {
  auto& [name, primitives, default_weights, target_names] = m;
  return std::tie(name, primitives, default_weights, target_names);
}

auto fields(Is<MeshInstance> auto& i) {
  auto& [joint, mesh, skin, rest_weights, copies] = i;
  return std::tie(joint, mesh, skin, rest_weights, copies);
}

auto fields(Is<PoseDriver> auto& d) {
  auto& [joint, weight, measure, axis] = d;
  return std::tie(joint, weight, measure, axis);
}

auto fields(Is<PoseSamples> auto& s) {
  auto& [name, drivers, rotations, weights, values, kernel, radius_rad, tail, regularisation, partition, clamp] = s;
  return std::tie(name, drivers, rotations, weights, values, kernel, radius_rad, tail, regularisation, partition,
                  clamp);
}

auto fields(Is<PoseCorrective> auto& c) {
  auto& [samples, coefficients, lower, upper] = c;
  return std::tie(samples, coefficients, lower, upper);
}

auto fields(Is<PropertyTarget> auto& t) {
  auto& [kind, index, slot] = t;
  return std::tie(kind, index, slot);
}

auto fields(Is<PropertyTable::Entry> auto& e) {
  auto& [target, first, count] = e;
  return std::tie(target, first, count);
}

auto fields(Is<PropertyTable> auto& t) {
  auto& [entries, rest] = t;
  return std::tie(entries, rest);
}

auto fields(Is<SceneRoots> auto& r) {
  auto& [name, joints] = r;
  return std::tie(name, joints);
}

template <class T>
concept IsTrack = Is<T, Vec3Track> || Is<T, QuatTrack>;

auto fields(IsTrack auto& t) {
  auto& [interpolation, times_s, values] = t;
  return std::tie(interpolation, times_s, values);
}

auto fields(Is<WeightTrack> auto& t) {
  auto& [interpolation, times_s, values, target_count] = t;
  return std::tie(interpolation, times_s, values, target_count);
}

auto fields(Is<BoneAnimation> auto& b) {
  auto& [joint, translation, rotation, scale] = b;
  return std::tie(joint, translation, rotation, scale);
}

auto fields(Is<WeightAnimation> auto& a) {
  auto& [instance, weights, first_target] = a;
  return std::tie(instance, weights, first_target);
}

auto fields(Is<PropertyTrack> auto& t) {
  auto& [target, values] = t;
  return std::tie(target, values);
}

auto fields(Is<Animation> auto& a) {
  [[maybe_unused]] auto& [name, duration_s, bones, weights, properties, in_the_compiled_clip] = a;
  return std::tie(name, duration_s, bones, weights, properties);
}

/// A skeleton LOD; `kept` has its flags for kept joints as bytes, 0 or 1.
struct StoredSkeletonLod {
  CompiledSkeletonLod lod;
  std::vector<std::uint8_t> kept;
};

auto fields(Is<StoredSkeletonLod> auto& s) {
  auto& [detail, tolerance_m, left_out, measured_m, worst_joint] = s.lod;
  return std::tie(s.kept, detail.held, tolerance_m, left_out, measured_m, worst_joint);
}

auto fields(Is<PageTable> auto& t) {
  auto& [page_s, offsets] = t;
  return std::tie(page_s, offsets);
}
}  // namespace sinew
