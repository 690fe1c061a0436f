// SPDX-License-Identifier: MIT
#include "importer/tool/poses/pose_sampler.h"

#include <cmath>
#include <limits>
#include <span>

#include <fmt/core.h>

#include "runtime/plan/frame_hash.h"

namespace sinew::tool {
namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();
using Vec3d = Vec3<double>;

/// Appends a vector as the floats of a pose file.
template <int N, class T>
void append(std::vector<double>& out, const glm::vec<N, T, glm::defaultp>& v) {
  for (int i = 0; i < N; ++i) out.push_back(static_cast<double>(static_cast<float>(v[i])));
}

template <class V>
void append_chosen(std::vector<double>& out, const VertexChoice& choice, std::span<const V> values) {
  out.reserve(choice.in_primitive.size() * static_cast<std::size_t>(V::length()));
  for (const std::uint32_t v : choice.in_primitive) append(out, values[v]);
}

/// The deformed values of an attribute, or the primitive's own values if the plan does not deform it.
template <class V>
std::span<const V> deformed_or_own(std::span<const V> deformed, const std::vector<V>& own) {
  return deformed.empty() ? std::span<const V>(own) : deformed;
}

/// Matrix that transforms normals: the cofactor matrix times the sign of the determinant. It turns normals like the
/// inverse transpose but needs no division.
/// eq   cof(M) has the cross products of M's columns;  cof(M) = det(M) * transpose(inverse(M))
Mat3<double> normal_matrix(const Affined& m) {
  const Mat3<double> a = linear_part(m);
  const double sign = determinant(m) < 0.0 ? -1.0 : 1.0;
  return {sign * glm::cross(a[1], a[2]), sign * glm::cross(a[2], a[0]), sign * glm::cross(a[0], a[1])};
}

/// Unit vector along v; `fallback` if v is zero.
Vec3d direction(const Vec3d& v, const Vec3d& fallback) {
  const double largest = std::fmax(std::fabs(v.x), std::fmax(std::fabs(v.y), std::fabs(v.z)));
  if (!(largest > 0.0)) return fallback;
  const Vec3d scaled = v / largest;
  return scaled / std::sqrt(glm::dot(scaled, scaled));
}

/// True if a palette matrix mirrors or flattens space, so that no rotation represents it.
bool has_no_rotation(const Affined& j) {
  const Mat3<double> a = linear_part(j);
  const double volume = glm::length(a[0]) * glm::length(a[1]) * glm::length(a[2]);
  constexpr double kFlat = 1e-12;  // as a fraction of the volume of the box that the columns span
  return !(determinant(j) > kFlat * volume);
}

std::vector<bool> entries_without_rotation(const Skin& skin, std::span<const Affine> model) {
  std::vector<bool> broken(skin.joints.size());
  for (std::size_t i = 0; i < broken.size(); ++i)
    broken[i] = has_no_rotation(affine_cast<double>(model[skin.joints[i]]) * affine_cast<double>(skin.inverse_bind[i]));
  return broken;
}

}  // namespace

PoseSampler::Method::Method(const Scene& scene, Skinning skinning, bool with_vertices)
    : plan(compile_plan(lend(scene), Needs{.out = {.positions = with_vertices,
                                                   .normals = with_vertices,
                                                   .tangents = with_vertices,
                                                   .tangents_of_all = with_vertices,
                                                   .properties = false,
                                                   .hidden_meshes = true},
                                           .in = {.max_layers = 1},
                                           .skin = {.kind = skinning}})),
      frame(plan) {}

PoseSampler::PoseSampler(const Scene& scene, const PoseContent& content) : scene_(scene), with_bits_(content.bits) {
  const bool turned = content.dual_quaternion || content.center_of_rotation;
  const bool with_vertices = content.vertices_per_primitive > 0 || content.bits;
  const auto method = [&](Skinning skinning) { return std::make_unique<Method>(scene, skinning, with_vertices); };
  if (content.linear || !turned) linear_ = method(Skinning::linear);
  if (content.dual_quaternion) dual_quaternion_ = method(Skinning::dual_quaternion);
  if (content.center_of_rotation) center_of_rotation_ = method(Skinning::center_of_rotation);
  std::vector<std::size_t> first_choice;
  for (const Mesh& mesh : scene.meshes) {
    first_choice.push_back(choices_.size());
    for (const Primitive& primitive : mesh.primitives)
      choices_.push_back(choose_vertices(primitive, content.vertices_per_primitive));
  }
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    const std::uint32_t mesh = scene.instances[i].mesh;
    for (std::uint32_t p = 0; p < scene.meshes[mesh].primitives.size(); ++p)
      drawn_.push_back({i, p, first_choice[mesh] + p});
  }
}

const FrameResult& PoseSampler::any_frame() const {
  const auto& turned = dual_quaternion_ ? dual_quaternion_ : center_of_rotation_;
  return (linear_ ? linear_ : turned)->frame.result();
}

ErrorCode PoseSampler::run(std::uint32_t clip, double time_s) {
  const ClipLayer layer{clip, time_s, 1.0f};
  const FrameInput input{clip == kNone ? std::span<const ClipLayer>{} : std::span(&layer, 1), {}, {}};
  time_s_ = time_s;
  for (Method* method : {linear_.get(), dual_quaternion_.get(), center_of_rotation_.get()})
    if (method)
      if (const ErrorCode code = run_plan(method->plan, input, method->frame); code != ErrorCode::ok) return code;
  return ErrorCode::ok;
}

Result<Pose> PoseSampler::sample(std::uint32_t clip, double time_s) {
  if (const ErrorCode code = run(clip, time_s); code != ErrorCode::ok) return tl::unexpected(code);
  Pose out = pose();
  for (std::size_t i = 0; i < drawn_.size(); ++i) out.primitives.push_back(primitive(i));
  return out;
}

std::map<std::string, std::string> PoseSampler::bits() const {
  const auto text = [](std::uint64_t hash) { return fmt::format("{:016x}", hash); };
  std::map<std::string, std::string> out{{"pose", text(hash_pose(any_frame()))}};
  if (linear_) out["linear"] = text(hash_vertices(linear_->frame.result()));
  if (dual_quaternion_) out["dualQuaternion"] = text(hash_vertices(dual_quaternion_->frame.result()));
  if (center_of_rotation_) out["centerOfRotation"] = text(hash_vertices(center_of_rotation_->frame.result()));
  return out;
}

Pose PoseSampler::pose() const {
  const FrameResult& frame = any_frame();
  Pose pose;
  pose.time_s = time_s_;
  if (with_bits_) pose.bits = bits();
  pose.nodes.resize(frame.model.size());
  for (std::uint32_t n = 0; n < pose.nodes.size(); ++n) {
    pose.nodes[n].node = n;
    const Affine& world = frame.model[scene_.skeleton.joint_of_node[n]];
    const glm::mat4 columns = mat4_from_affine(world);
    for (int i = 0; i < 16; ++i) pose.nodes[n].world[static_cast<std::size_t>(i)] = columns[i / 4][i % 4];
  }
  for (std::size_t i = 0; i < scene_.instances.size(); ++i) {
    const auto weights =
        frame.weights.subspan(scene_.first_weight[i], scene_.first_weight[i + 1] - scene_.first_weight[i]);
    if (!weights.empty())
      pose.weights.push_back(
          {scene_.skeleton.node_of_joint[scene_.instances[i].joint], {weights.begin(), weights.end()}});
  }
  return pose;
}

PrimitivePose PoseSampler::primitive(std::size_t i) const {
  const Drawn& drawn = drawn_[i];
  const MeshInstance& instance = scene_.instances[drawn.instance];
  PrimitivePose out;
  out.node = scene_.skeleton.node_of_joint[instance.joint];
  out.mesh = instance.mesh;
  out.primitive = drawn.primitive;
  out.vertices = choice_of(drawn).in_file;
  const bool skinned = instance.skin != kNone && !choice_of(drawn).influences.empty();
  if (!skinned) add_rigid(drawn, out);
  if (skinned && linear_) add_linear(drawn, out);
  if (skinned && dual_quaternion_) add_turned(*dual_quaternion_, drawn, VertexKind::dqs, VertexKind::dqs_normals, out);
  if (skinned && center_of_rotation_)
    add_turned(*center_of_rotation_, drawn, VertexKind::cors, VertexKind::cor_normals, out);
  return out;
}

/// Morphed vertices are in mesh space. The matrix of the node brings them into world space, as a shader would.
void PoseSampler::add_rigid(const Drawn& drawn, PrimitivePose& out) const {
  const MeshInstance& instance = scene_.instances[drawn.instance];
  const Primitive& own = scene_.meshes[instance.mesh].primitives[drawn.primitive];
  const FrameResult& frame = any_frame();
  const DeformedPrimitive& deformed =
      frame.primitives[frame.instances[drawn.instance].first_primitive + drawn.primitive];
  const auto positions = deformed_or_own(deformed.positions, own.positions);
  const auto normals = deformed_or_own(deformed.normals, own.normals);
  const auto tangents = deformed_or_own(deformed.tangents, own.tangents);
  const Affined world = affine_cast<double>(frame.model[instance.joint]);
  const Mat3<double> world_normal = normal_matrix(world);
  for (const std::uint32_t v : choice_of(drawn).in_primitive) {
    append(out.of(VertexKind::positions), transform_point(world, Vec3d(positions[v])));
    if (!normals.empty() && !own.flat_normals) {
      const Vec3d n(normals[v]);
      append(out.of(VertexKind::normals), direction(world_normal * n, n));
    }
    if (!tangents.empty()) {
      const Vec3d t(tangents[v]);
      append(out.of(VertexKind::tangents), direction(transform_vector(world, t), t));
      out.of(VertexKind::tangents).push_back(static_cast<double>(tangents[v].w));
    }
  }
}

void PoseSampler::add_linear(const Drawn& drawn, PrimitivePose& out) const {
  const FrameResult& frame = linear_->frame.result();
  const DeformedPrimitive& deformed =
      frame.primitives[frame.instances[drawn.instance].first_primitive + drawn.primitive];
  const bool flat = scene_.meshes[out.mesh].primitives[out.primitive].flat_normals;
  append_chosen(out.of(VertexKind::positions), choice_of(drawn), deformed.positions);
  if (!deformed.normals.empty() && !flat)
    append_chosen(out.of(VertexKind::normals), choice_of(drawn), deformed.normals);
  if (!deformed.tangents.empty()) append_chosen(out.of(VertexKind::tangents), choice_of(drawn), deformed.tangents);
}

/// Adds the values of a method that blends rotations. It gives no value if a joint's matrix has no rotation.
void PoseSampler::add_turned(const Method& method, const Drawn& drawn, VertexKind positions, VertexKind normals,
                             PrimitivePose& out) const {
  const MeshInstance& instance = scene_.instances[drawn.instance];
  const Primitive& own = scene_.meshes[out.mesh].primitives[out.primitive];
  const FrameResult& frame = method.frame.result();
  const DeformedPrimitive& deformed =
      frame.primitives[frame.instances[drawn.instance].first_primitive + drawn.primitive];
  const auto broken = entries_without_rotation(scene_.skins[instance.skin], frame.model);
  const bool with_normals = !deformed.normals.empty() && !own.flat_normals;
  for (std::size_t i = 0; i < choice_of(drawn).in_primitive.size(); ++i) {
    const auto [first, count] = choice_of(drawn).influences[i];
    bool usable = true;
    for (std::uint32_t k = first; k < first + count; ++k) usable = usable && !broken[own.influences.joints[k]];
    const std::uint32_t v = choice_of(drawn).in_primitive[i];
    append(out.of(positions), usable ? Vec3d(deformed.positions[v]) : Vec3d(kNoValue));
    if (with_normals) append(out.of(normals), usable ? Vec3d(deformed.normals[v]) : Vec3d(kNoValue));
  }
}

}  // namespace sinew::tool
