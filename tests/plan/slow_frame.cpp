// SPDX-License-Identifier: MIT
#include "tests/plan/slow_frame.h"

#include <algorithm>
#include <cmath>

#include "runtime/math/decompose.h"
#include "runtime/math/normal_transform.h"
#include "tests/plan/slow_mirror.h"
#include "tests/reference/mirror_rows.h"
#include "tests/reference/pose_corrective.h"
#include "tests/reference/sampling.h"
#include "tests/reference/skinning.h"
#include "tests/reference/surface.h"

namespace sinew::test {
namespace {

using Vec3d = Vec3<double>;

Transformd to_double(const Transform& t) {
  return {Vec3d(t.translation), quat_cast<double>(t.rotation), Vec3d(t.scale)};
}

Transformd sampled(const BoneAnimation& bone, double time_s, const Transformd& rest) {
  Transformd out = rest;
  if (!bone.translation.empty()) out.translation = reference::vec3_of(reference::sample(bone.translation, time_s));
  if (!bone.scale.empty()) out.scale = reference::vec3_of(reference::sample(bone.scale, time_s));
  if (!bone.rotation.empty()) out.rotation = reference::quat_of(reference::sample(bone.rotation, time_s));
  return out;
}

Transformd unmirrored_joint_at(const Scene& scene, const ClipLayer& layer, std::uint32_t joint) {
  const Transformd rest = to_double(scene.skeleton.rest[joint]);
  for (const BoneAnimation& bone : scene.animations[layer.clip].bones)
    if (bone.joint == joint) return sampled(bone, layer.time_s, rest);
  return rest;
}

Transformd joint_at(const Scene& scene, const Needs& needs, const ClipLayer& layer, std::uint32_t joint) {
  if (!layer.mirrored) return unmirrored_joint_at(scene, layer, joint);
  const MirroredJoint& to = needs.in.mirror->joints[joint];
  return reference::mirrored_plainly(to, unmirrored_joint_at(scene, layer, to.source));
}

void sample_into(const WeightTrack& track, double time_s, std::span<double> out) {
  const reference::Numbers numbers = reference::sample(track, time_s);
  std::transform(numbers.begin(), numbers.end(), out.begin(), [](reference::Real x) { return double(x); });
}

bool blends(const ClipLayer& layer) { return layer.kind == LayerKind::blend; }

double weight_of(const Needs& needs, const ClipLayer& layer, std::uint32_t joint) {
  const double mask = layer.mask == kNone ? 1.0 : static_cast<double>(needs.in.masks[layer.mask][joint]);
  return mask * static_cast<double>(layer.weight);
}

double total_weight(const FrameInput& input) {
  double total = 0.0;
  for (const ClipLayer& layer : input.layers) total += blends(layer) ? static_cast<double>(layer.weight) : 0.0;
  return total;
}

/// eq   mean over the layers, the rest pose with weight max(0, 1 - total); rotations by normalised sum, aligned to the
///      rest
Transformd blended_joint(const Scene& scene, const Needs& needs, const FrameInput& input, std::uint32_t joint) {
  const Transformd rest = to_double(scene.skeleton.rest[joint]);
  double total = 0.0;
  for (const ClipLayer& layer : input.layers) total += blends(layer) ? weight_of(needs, layer, joint) : 0.0;
  const double fill = std::max(0.0, 1.0 - total);
  Transformd sum{rest.translation * fill, rest.rotation * fill, rest.scale * fill};
  for (const ClipLayer& layer : input.layers) {
    const double w = blends(layer) ? weight_of(needs, layer, joint) : 0.0;
    if (w == total && fill == 0.0) return joint_at(scene, needs, layer, joint);
    const Transformd pose = joint_at(scene, needs, layer, joint);
    sum.translation += pose.translation * w;
    sum.rotation = sum.rotation + aligned_with(rest.rotation, pose.rotation) * w;
    sum.scale += pose.scale * w;
  }
  const double share = 1.0 / (total + fill);
  return {sum.translation * share, normalised(sum.rotation), sum.scale * share};
}

ClipLayer start_of(const ClipLayer& layer) { return {.clip = layer.clip, .mirrored = layer.mirrored}; }

/// Adds additive layers to the blended joint by the equations of add_pose.h.
Transformd posed_joint(const Scene& scene, const Needs& needs, const FrameInput& input, std::uint32_t joint) {
  Transformd sum = blended_joint(scene, needs, input, joint);
  for (const ClipLayer& layer : input.layers) {
    const double w = weight_of(needs, layer, joint);
    if (blends(layer) || w == 0.0) continue;
    const Transformd added = joint_at(scene, needs, layer, joint);
    const Transformd reference = layer.kind == LayerKind::add_to_rest ? to_double(scene.skeleton.rest[joint])
                                                                      : joint_at(scene, needs, start_of(layer), joint);
    const Quat<double> one = quat_xyzw(0.0, 0.0, 0.0, 1.0),
                       turn = aligned_with(one, added.rotation * quat_conjugate(reference.rotation));
    sum.translation += w * (added.translation - reference.translation);
    const double size = std::fabs(w);
    const Quat<double> part = one * (1.0 - size) + turn * size;
    const Vec3<double> factor = 1.0 + size * (added.scale / reference.scale - 1.0);
    sum.rotation = normalised((w < 0.0 ? quat_conjugate(part) : part) * sum.rotation);
    sum.scale = w < 0.0 ? sum.scale / factor : sum.scale * factor;
  }
  return sum;
}

FrameInput at_next_update(const FrameInput& input) {
  FrameInput next = input;
  next.layers = input.next_layers;
  return next;
}

/// eq   (1 - f) a + f b of a joint's numbers at both updates; rotations on the short side, normalised
Transformd joint_between(const Scene& scene, const Needs& needs, const FrameInput& input, std::uint32_t joint) {
  const Transformd a = posed_joint(scene, needs, input, joint);
  const double f = static_cast<double>(input.interpolation_factor);
  if (f == 0.0) return a;
  const Transformd b = posed_joint(scene, needs, at_next_update(input), joint);
  return {(1.0 - f) * a.translation + f * b.translation,
          normalised(a.rotation * (1.0 - f) + aligned_with(a.rotation, b.rotation) * f),
          (1.0 - f) * a.scale + f * b.scale};
}

/// `numbers(input)` at both updates, interpolated.
template <class Numbers>
std::vector<double> numbers_between(const FrameInput& input, const Numbers& numbers) {
  std::vector<double> sum = numbers(input);
  const double f = static_cast<double>(input.interpolation_factor);
  if (f == 0.0) return sum;
  const std::vector<double> next = numbers(at_next_update(input));
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = (1.0 - f) * sum[i] + f * next[i];
  return sum;
}

std::vector<double> properties_at(const Scene& scene, const ClipLayer& layer) {
  std::vector<double> values(scene.properties.rest.begin(), scene.properties.rest.end());
  for (const PropertyTrack& track : scene.animations[layer.clip].properties)
    for (const PropertyTable::Entry& entry : scene.properties.entries)
      if (entry.target == track.target)
        sample_into(track.values, layer.time_s, std::span(values).subspan(entry.first, entry.count));
  return values;
}

/// Mean over the blend layers, plus the rest values if their weights are below 1. Additive layers do not count.
std::vector<double> all_properties(const Scene& scene, const FrameInput& input) {
  const double total = total_weight(input), fill = std::max(0.0, 1.0 - total);
  std::vector<double> sum(scene.properties.rest.begin(), scene.properties.rest.end());
  for (double& value : sum) value *= fill;
  for (const ClipLayer& layer : input.layers) {
    if (!blends(layer)) continue;
    const std::vector<double> values = properties_at(scene, layer);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += static_cast<double>(layer.weight) * values[i];
  }
  for (double& value : sum) value /= total + fill;
  return sum;
}

std::vector<double> weights_at(const Scene& scene, const Needs& needs, const ClipLayer& layer,
                               const std::vector<double>& rest) {
  std::vector<double> weights = rest;
  for (const WeightAnimation& animated : scene.animations[layer.clip].weights) {
    const std::span<double> own(weights.data() + scene.first_weight[animated.instance], animated.weights.target_count);
    sample_into(animated.weights, layer.time_s, own);
  }
  return on_side(needs, layer, weights);
}

std::vector<double> all_weights(const Scene& scene, const Needs& needs, const FrameInput& input) {
  if (!input.weights.empty()) return {input.weights.begin(), input.weights.end()};
  const std::vector<float> flattened = rest_weights_of(scene);
  const std::vector<double> rest(flattened.begin(), flattened.end());
  const double total = total_weight(input), fill = std::max(0.0, 1.0 - total);
  std::vector<double> sum(rest.size());
  for (std::size_t i = 0; i < rest.size(); ++i) sum[i] = fill * rest[i];
  for (const ClipLayer& layer : input.layers) {
    if (!blends(layer)) continue;
    const std::vector<double> weights = weights_at(scene, needs, layer, rest);
    for (std::size_t i = 0; i < rest.size(); ++i) sum[i] += static_cast<double>(layer.weight) * weights[i];
  }
  for (double& w : sum) w /= total + fill;
  for (const ClipLayer& layer : input.layers) {
    if (blends(layer)) continue;
    const std::vector<double> weights = weights_at(scene, needs, layer, rest);
    const std::vector<double> reference = layer.kind == LayerKind::add_to_rest
                                              ? on_side(needs, layer, rest)
                                              : weights_at(scene, needs, start_of(layer), rest);
    for (std::size_t i = 0; i < rest.size(); ++i)
      sum[i] += static_cast<double>(layer.weight) * (weights[i] - reference[i]);
  }
  return sum;
}

/// Adds the correctives' weights to the given or sampled weights.
void correct_weights(const Scene& scene, const Needs& needs, const FrameInput& input, std::vector<double>& weights) {
  for (const PoseCorrective& corrective : scene.correctives) {
    reference::Pose pose;
    for (const PoseDriver& driver : corrective.samples.drivers)
      pose.push_back(reference::rotation_of(joint_between(scene, needs, input, driver.joint).rotation));
    const reference::Row added = reference::correct_pose(corrective.samples, pose);
    for (std::size_t i = 0; i < added.size(); ++i)
      weights[corrective.samples.weights[i]] += static_cast<double>(added[i]);
  }
}

std::vector<Affined> world_matrices(const Scene& scene, const Needs& needs, const FrameInput& input) {
  std::vector<Affined> model;
  const Skeleton& skeleton = scene.skeleton;
  for (std::uint32_t j = 0; j < skeleton.joint_count(); ++j) {
    const Affined above = skeleton.parents[j] == kNone ? affine_cast<double>(input.root) : model[skeleton.parents[j]];
    const std::uint32_t fixed = skeleton.fixed_matrix_of[j];
    model.push_back(above * (fixed == kNone ? affine_from_transform(joint_between(scene, needs, input, j))
                                            : affine_cast<double>(skeleton.fixed_matrices[fixed])));
  }
  return model;
}

template <class To, class V>
void add_deltas(std::vector<To>& sums, const SparseDeltas<V>& sparse, double weight) {
  for (std::size_t i = 0; i < sparse.vertices.size(); ++i) sums[sparse.vertices[i]] += weight * To(sparse.deltas[i]);
}

/// eq   v' = v + sum(w delta); not normalised yet
SlowPrimitive morphed(const Primitive& primitive, std::span<const double> weights) {
  SlowPrimitive out{{primitive.positions.begin(), primitive.positions.end()},
                    {primitive.normals.begin(), primitive.normals.end()},
                    {},
                    {primitive.colors.begin(), primitive.colors.end()}};
  for (const glm::vec4& t : primitive.tangents) out.tangents.emplace_back(t.x, t.y, t.z);
  for (std::size_t t = 0; t < primitive.morphs.targets.size(); ++t) {
    const MorphTarget& target = primitive.morphs.targets[t];
    add_deltas(out.positions, target.positions, weights[t]);
    add_deltas(out.normals, target.normals, weights[t]);
    add_deltas(out.tangents, target.tangents, weights[t]);
    add_deltas(out.colors, target.colors, weights[t]);
  }
  for (auto& color : out.colors) color = glm::clamp(color, 0.0, 1.0);
  return out;
}

struct VertexJoint {
  std::vector<Affined> matrices;
  std::vector<double> weights;
};

VertexJoint joints_of(const VertexInfluences& influences, const std::vector<Affined>& palette, std::uint32_t vertex) {
  VertexJoint out;
  for (const InfluenceGroup& group : influences.groups) {
    if (vertex < group.first_vertex || vertex >= group.first_vertex + group.vertex_count) continue;
    const std::size_t at = group.first_influence + std::size_t{vertex - group.first_vertex} * group.influence_count;
    for (std::uint32_t i = 0; i < group.influence_count; ++i) {
      out.matrices.push_back(palette[influences.joints[at + i]]);
      out.weights.push_back(static_cast<double>(influences.weights[at + i]));
    }
  }
  return out;
}

void skin_linear(SlowPrimitive& shape, std::size_t v, const VertexJoint& joint, NormalRule rule) {
  const Affined m = reference::blend_matrices<double>(joint.matrices, joint.weights);
  shape.positions[v] = transform_point(m, shape.positions[v]);
  if (!shape.normals.empty())
    shape.normals[v] = rule == NormalRule::cofactor ? transform_normal_outward(linear_part(m), shape.normals[v])
                                                    : transform_vector(m, shape.normals[v]);
  if (!shape.tangents.empty()) shape.tangents[v] = transform_vector(m, shape.tangents[v]);
}

/// The matrices of a vertex, split into rigid motions and stretches.
struct SplitJoint {
  explicit SplitJoint(const VertexJoint& joint) {
    for (const Affined& m : joint.matrices) {
      const auto polar = decompose_polar(linear_part(m));
      motions.push_back(dual_quat_from(polar.quat, translation_of(m)));
      stretches.push_back(matrix_from_stretch(polar.stretch));
    }
  }
  std::vector<DualQuatd> motions;
  std::vector<Mat3<double>> stretches;
};

/// Skins a vertex with `skin(split, position, normal)`, which returns a reference::SkinnedT.
template <class Skin>
void skin_turned(SlowPrimitive& shape, std::size_t v, const VertexJoint& joint, const Skin& skin) {
  const SplitJoint split(joint);
  const Vec3d normal = shape.normals.empty() ? Vec3d(0, 1, 0) : shape.normals[v];
  const reference::SkinnedT<double> skinned = skin(split, shape.positions[v], normal);
  shape.positions[v] = skinned.position;
  if (!shape.normals.empty()) shape.normals[v] = skinned.normal;
  if (!shape.tangents.empty())
    shape.tangents[v] = rotate_vector(
        skinned.rotation, reference::blend_stretches<double>(split.stretches, joint.weights) * shape.tangents[v]);
}

void skin_dual_quaternion(SlowPrimitive& shape, std::size_t v, const VertexJoint& joint) {
  skin_turned(shape, v, joint, [&](const SplitJoint& split, const Vec3d& p, const Vec3d& n) {
    return reference::skin_dual_quaternion<double>(split.motions, split.stretches, joint.weights, p, n);
  });
}

void skin_center_of_rotation(SlowPrimitive& shape, std::size_t v, const VertexJoint& joint, const Vec3d& center) {
  skin_turned(shape, v, joint, [&](const SplitJoint& split, const Vec3d& p, const Vec3d& n) {
    return reference::skin_center_of_rotation<double>(split.motions, joint.matrices, joint.weights, p, n, center,
                                                      split.stretches);
  });
}

/// eq   n = (b - a) x (c - a), pointing outwards
void flatten(SlowPrimitive& shape, const Primitive& primitive, double sign) {
  for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
    const std::uint32_t a = primitive.indices[i], b = primitive.indices[i + 1], c = primitive.indices[i + 2];
    const Vec3d n = sign * glm::cross(shape.positions[b] - shape.positions[a], shape.positions[c] - shape.positions[a]);
    shape.normals[a] = shape.normals[b] = shape.normals[c] = n;
  }
}

SlowPrimitive deformed(const Scene& scene, const Needs& needs, std::size_t i, const Primitive& primitive,
                       const SlowFrame& frame) {
  const MeshInstance& instance = scene.instances[i];
  SlowPrimitive shape =
      morphed(primitive, std::span(frame.weights).subspan(scene.first_weight[i], instance.rest_weights.size()));
  const bool skinned = instance.skin != kNone && !primitive.influences.empty();
  const Skinning kind = needs.skin.kind_of(i);
  if (skinned) {
    const Skin& skin = scene.skins[instance.skin];
    std::vector<Affined> palette;
    for (std::size_t k = 0; k < skin.joints.size(); ++k)
      palette.push_back(frame.model[skin.joints[k]] * affine_cast<double>(skin.inverse_bind[k]));
    for (std::uint32_t v = 0; v < primitive.vertex_count(); ++v) {
      const VertexJoint joint = joints_of(primitive.influences, palette, v);
      if (kind == Skinning::dual_quaternion)
        skin_dual_quaternion(shape, v, joint);
      else if (kind == Skinning::center_of_rotation)
        skin_center_of_rotation(shape, v, joint, Vec3d(primitive.centers_of_rotation[v]));
      else
        skin_linear(shape, v, joint, needs.skin.normal_rule);
    }
  }
  const bool moved =
      skinned || std::any_of(frame.weights.begin(), frame.weights.end(), [](double w) { return w != 0.0; });
  if (primitive.flat_normals && moved) flatten(shape, primitive, skinned && frame.mirrored[i] ? -1.0 : 1.0);
  for (Vec3d& n : shape.normals) n = normalised_or(n, n);
  for (Vec3d& t : shape.tangents) t = normalised_or(t, t);
  return shape;
}

/// The geometry input of an instance, if it is in view and plays; else null.
const GeometryInput* playing(const Needs& needs, const FrameInput& input, std::uint32_t instance) {
  if (!input.out_of_view.empty() && input.out_of_view[instance] != 0) return nullptr;
  for (std::size_t slot = 0; slot < input.geometry.size(); ++slot)
    if (needs.in.cached_instances[slot] == instance && input.geometry[slot].plays()) return &input.geometry[slot];
  return nullptr;
}

/// Vertices of a primitive from its source. Missing normals and tangents are computed.
SlowPrimitive sourced(const GeometryInput& input, std::uint32_t instance, std::uint32_t p, const Primitive& primitive,
                      bool turned) {
  const VertexSource& source = input.source;
  std::vector<glm::vec3> positions(primitive.vertex_count()), normals(primitive.normals.size());
  source.show(source.context, instance, input.time_s);
  const bool has_normals = source.write(source.context, instance, p, positions, normals);
  SlowPrimitive out;
  out.positions.assign(positions.begin(), positions.end());
  out.colors.assign(primitive.colors.begin(), primitive.colors.end());
  if (has_normals && !primitive.flat_normals)
    out.normals.assign(normals.begin(), normals.end());
  else if (!primitive.normals.empty())
    out.normals = reference::surface_normals(primitive, out.positions, turned);
  if (!primitive.tangents.empty()) out.tangents = reference::surface_tangents(primitive, out.positions);
  return out;
}

/// eq   (1 - w) A x + w B y; directions are normalised before and after
SlowPrimitive blended(const SlowPrimitive& pose, const Affined& a, const SlowPrimitive& source, const Affined& b,
                      double w) {
  SlowPrimitive out = pose;
  const auto mixed = [&](const Vec3d& x, const Vec3d& y) { return (1.0 - w) * x + w * y; };
  const auto unit = [](const Vec3d& v) { return normalised_or(v, v); };
  for (std::size_t v = 0; v < out.positions.size(); ++v)
    out.positions[v] = mixed(transform_point(a, pose.positions[v]), transform_point(b, source.positions[v]));
  for (std::size_t v = 0; v < out.normals.size(); ++v)
    out.normals[v] = unit(mixed(transform_normal_outward(linear_part(a), pose.normals[v]),
                                transform_normal_outward(linear_part(b), source.normals[v])));
  for (std::size_t v = 0; v < out.tangents.size(); ++v)
    out.tangents[v] =
        unit(mixed(unit(transform_vector(a, pose.tangents[v])), unit(transform_vector(b, source.tangents[v]))));
  return out;
}

/// Replaces the posed vertices of an instance by those of its source.
void play(const Scene& scene, const FrameInput& input, const GeometryInput& geometry, std::uint32_t i,
          std::size_t first_primitive, SlowFrame& frame) {
  const MeshInstance& instance = scene.instances[i];
  const Affined root = affine_cast<double>(input.root), joint = frame.model[instance.joint];
  const bool in_scene = geometry.source.space == VertexSpace::scene, full = geometry.weight == 1.0f;
  const bool in_mesh = !in_scene && instance.skin == kNone;
  const bool turned = in_scene && frame.mirrored[i] != (determinant(root) < 0.0);
  const Affined pose_placed = in_mesh ? Affined{} : frame.world_from_mesh[i], source_placed = in_mesh    ? Affined{}
                                                                                              : in_scene ? root
                                                                                                         : joint;
  const auto& primitives = scene.meshes[instance.mesh].primitives;
  for (std::uint32_t p = 0; p < primitives.size(); ++p) {
    SlowPrimitive& shape = frame.primitives[first_primitive + p];
    const SlowPrimitive source = sourced(geometry, i, p, primitives[p], turned);
    shape = full ? source : blended(shape, pose_placed, source, source_placed, static_cast<double>(geometry.weight));
    const bool flips = full ? turned : !in_mesh && frame.mirrored[i];
    if (primitives[p].flat_normals) flatten(shape, primitives[p], flips ? -1.0 : 1.0);
    for (Vec3d& n : shape.normals) n = normalised_or(n, n);
  }
  if (full && !in_scene) frame.mirrored[i] = determinant(joint) < 0.0;
  if (full || !in_mesh) frame.world_from_mesh[i] = full ? (in_scene ? root : joint) : Affined{};
}

}  // namespace

SlowFrame evaluate_slowly(const Scene& scene, const Needs& needs, const FrameInput& input) {
  SlowFrame frame;
  frame.model = world_matrices(scene, needs, input);
  frame.weights = numbers_between(input, [&](const FrameInput& at) { return all_weights(scene, needs, at); });
  frame.properties = numbers_between(input, [&](const FrameInput& at) { return all_properties(scene, at); });
  correct_weights(scene, needs, input, frame.weights);
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const MeshInstance& instance = scene.instances[i];
    Affined placed = frame.model[instance.joint];
    if (instance.skin != kNone) {
      const Skin& skin = scene.skins[instance.skin];
      placed = frame.model[skin.joints[0]] * affine_cast<double>(skin.inverse_bind[0]);
    }
    frame.mirrored.push_back(determinant(placed) < 0.0);
    frame.world_from_mesh.push_back(instance.skin != kNone ? Affined{} : frame.model[instance.joint]);
    const std::size_t first = frame.primitives.size();
    for (const Primitive& primitive : scene.meshes[instance.mesh].primitives)
      frame.primitives.push_back(deformed(scene, needs, i, primitive, frame));
    const auto index = static_cast<std::uint32_t>(i);
    if (const GeometryInput* geometry = playing(needs, input, index))
      play(scene, input, *geometry, index, first, frame);
  }
  return frame;
}

}  // namespace sinew::test
