// SPDX-License-Identifier: MIT
#include "tests/scenes/random_scene.h"

#include <algorithm>
#include <numeric>

#include "runtime/base/contract.h"
#include "tests/scenes/pose_samples.h"
#include "tests/support/fixed_random.h"

namespace sinew::test {
namespace {

class Maker {
 public:
  Maker(std::uint64_t seed, const RandomSceneOptions& options) : random_(seed), options_(options) {}

  Scene make() {
    make_skeleton();
    for (std::uint32_t s = 0; s < options_.skins; ++s) scene_.skins.push_back(make_skin());
    for (std::uint32_t m = 0; m < options_.meshes; ++m) scene_.meshes.push_back(make_mesh());
    make_instances();
    for (std::uint32_t c = 0; c < options_.clips; ++c) scene_.animations.push_back(make_animation());
    finish_scene(scene_);
    for (std::uint32_t c = 0; c < options_.correctives; ++c) scene_.correctives.push_back(make_corrective());
    CONTRACT(check(scene_) == ErrorCode::ok);
    return std::move(scene_);
  }

 private:
  /// Parents never decrease from joint to joint: that is breadth-first order.
  void make_skeleton() {
    Skeleton& skeleton = scene_.skeleton;
    std::vector<std::uint32_t> depth;
    for (std::uint32_t j = 0; j < options_.joints; ++j) {
      const std::uint32_t least = j < 2 ? 0 : skeleton.parents[j - 1];
      const std::uint32_t parent = j == 0 ? kNone : least + random_.below(std::min(j - least, 3u));
      skeleton.parents.push_back(parent);
      depth.push_back(parent == kNone ? 0 : depth[parent] + 1);
      if (depth[j] == skeleton.level_begin.size()) skeleton.level_begin.push_back(j);
      Transform rest{random_.vec3(-1, 1), random_.rotation(), random_.vec3(0.8, 1.25)};
      if (options_.mirrored_joints && j % 3 == 1) rest.scale.x = -rest.scale.x;
      const bool fixed = j % 5 == 4;
      skeleton.rest.push_back(fixed ? Transform{} : rest);
      skeleton.fixed_matrix_of.push_back(fixed ? static_cast<std::uint32_t>(skeleton.fixed_matrices.size()) : kNone);
      if (fixed) skeleton.fixed_matrices.push_back(affine_from_transform(rest));
      skeleton.names.push_back("joint " + std::to_string(j));
    }
    skeleton.level_begin.push_back(options_.joints);
    skeleton.node_of_joint.resize(options_.joints);
    std::iota(skeleton.node_of_joint.begin(), skeleton.node_of_joint.end(), 0u);
    skeleton.joint_of_node = skeleton.node_of_joint;
  }

  Skin make_skin() {
    Skin skin;
    const std::uint32_t count = std::max(1u, options_.joints / 2);
    for (std::uint32_t i = 0; i < count; ++i) {
      skin.joints.push_back((i * 5 + random_.below(3)) % options_.joints);
      skin.inverse_bind.push_back(affine_from_transform(random_.transform(0.7, 1.4)));
    }
    return skin;
  }

  Mesh make_mesh() {
    Mesh mesh;
    for (int p = 0; p < 2; ++p) mesh.primitives.push_back(make_primitive(options_.flat_normals && p == 1));
    for (std::uint32_t t = 0; t < options_.targets; ++t)
      mesh.default_weights.push_back(static_cast<float>(random_.in(-0.5, 1.5)));
    return mesh;
  }

  Primitive make_primitive(bool flat) {
    Primitive primitive;
    const std::uint32_t count = 3 * options_.triangles;
    for (std::uint32_t v = 0; v < count; ++v) {
      primitive.indices.push_back(v);
      primitive.positions.push_back(random_.vec3(-1, 1));
      primitive.bounds.add(primitive.positions.back());
      if (options_.normals) primitive.normals.push_back(random_.direction());
      if (options_.tangents) primitive.tangents.push_back(glm::vec4(random_.direction(), v % 2 ? 1.0f : -1.0f));
      if (options_.colors) primitive.colors.push_back(glm::vec4(random_.vec3(0, 1), 1.0f));
    }
    primitive.flat_normals = flat;
    if (options_.skins > 0) primitive.influences = make_influences(count);
    for (std::uint32_t v = 0; v < count && options_.centers && options_.skins > 0; ++v)
      primitive.centers_of_rotation.push_back(random_.vec3(-1, 1));
    for (std::uint32_t t = 0; t < options_.targets; ++t) primitive.morphs.targets.push_back(make_target(primitive));
    return primitive;
  }

  VertexInfluences make_influences(std::uint32_t vertex_count) {
    VertexInfluences influences;
    const std::uint32_t joints = std::max(1u, options_.joints / 2), most = std::min(joints, options_.most_influences);
    for (std::uint32_t first = 0, n = 1; first < vertex_count; ++n) {
      const bool last = n >= most;
      const std::uint32_t vertices =
          last ? vertex_count - first : std::min(vertex_count - first, 1 + random_.below(17));
      influences.groups.push_back(
          {first, vertices, std::min(n, most), static_cast<std::uint32_t>(influences.joints.size())});
      for (std::uint32_t v = 0; v < vertices; ++v) {
        if (options_.combinations == 0 || v < options_.combinations)
          add_vertex(influences, std::min(n, most), joints);
        else
          repeat_vertex(influences, random_.below(options_.combinations));
      }
      first += vertices;
    }
    return influences;
  }

  void add_vertex(VertexInfluences& influences, std::uint32_t count, std::uint32_t joints) {
    std::vector<double> weights(count);
    for (double& w : weights) w = random_.in(0.05, 1.0);
    std::sort(weights.rbegin(), weights.rend());
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    const std::uint32_t first = random_.below(joints);
    for (std::uint32_t i = 0; i < count; ++i) {
      influences.joints.push_back(static_cast<std::uint16_t>((first + i) % joints));
      influences.weights.push_back(static_cast<float>(weights[i] / sum));
    }
  }

  /// Adds a vertex with the same influences as vertex `index` of the last group.
  static void repeat_vertex(VertexInfluences& influences, std::uint32_t index) {
    const InfluenceGroup& group = influences.groups.back();
    for (std::uint32_t i = 0; i < group.influence_count; ++i) {
      const std::size_t at = group.first_influence + index * group.influence_count + i;
      influences.joints.push_back(influences.joints[at]);
      influences.weights.push_back(influences.weights[at]);
    }
  }

  MorphTarget make_target(const Primitive& primitive) {
    MorphTarget target;
    for (std::uint32_t v = 0; v < primitive.vertex_count(); ++v) {
      if (random_.below(3) == 0) continue;
      add(target.positions, v, random_.vec3(-0.3, 0.3));
      if (!primitive.normals.empty()) add(target.normals, v, random_.vec3(-0.3, 0.3));
      if (!primitive.tangents.empty()) add(target.tangents, v, random_.vec3(-0.3, 0.3));
      if (!primitive.colors.empty()) add(target.colors, v, glm::vec4(random_.vec3(-0.5, 0.5), 0.0f));
    }
    return target;
  }

  template <class V>
  static void add(SparseDeltas<V>& sparse, std::uint32_t vertex, const V& delta) {
    sparse.vertices.push_back(vertex);
    sparse.deltas.push_back(delta);
  }

  void make_instances() {
    for (std::uint32_t i = 0; i < options_.instances; ++i) {
      MeshInstance instance;
      instance.joint = random_.below(options_.joints);
      instance.mesh = i % options_.meshes;
      instance.skin = options_.skins > 0 && i % 2 == 0 ? (i / 2) % options_.skins : kNone;
      instance.rest_weights = scene_.meshes[instance.mesh].default_weights;
      scene_.instances.push_back(std::move(instance));
    }
  }

  Animation make_animation() {
    Animation animation;
    animation.duration_s = 2.0;
    for (std::uint32_t j = 0; j < options_.joints; ++j) {
      if (j % 4 == 3 || scene_.skeleton.fixed_matrix_of[j] != kNone) continue;
      BoneAnimation bone;
      bone.joint = j;
      const Transform& rest = scene_.skeleton.rest[j];
      if (j % 2 == 0)
        bone.translation = make_track<Vec3Track>([&] { return rest.translation + random_.vec3(-0.2, 0.2); });
      bone.rotation =
          make_track<QuatTrack>([&] { return normalised(rest.rotation * random_.rotation_by(random_.in(0, 0.5))); });
      if (j % 3 == 0) bone.scale = make_track<Vec3Track>([&] { return rest.scale * random_.vec3(0.8, 1.25); });
      animation.bones.push_back(std::move(bone));
    }
    for (std::uint32_t i = 0; i < options_.instances; i += 2)
      if (options_.targets > 0) animation.weights.push_back({i, make_weights()});
    return animation;
  }

  /// A corrective whose drivers are joints that clips turn, with samples around their rest poses.
  PoseCorrective make_corrective() {
    PoseSamples samples = random_samples(random_, 1 + random_.below(3), 6, 2);
    for (PoseDriver& driver : samples.drivers) driver.joint = random_.below(options_.joints);
    for (std::size_t i = 0; i < samples.rotations.size(); ++i)
      samples.rotations[i] =
          normalised(scene_.skeleton.rest[samples.drivers[i % samples.drivers.size()].joint].rotation *
                     random_.rotation_by(random_.in(0, 0.8)));
    for (std::uint32_t& weight : samples.weights)
      weight = random_.below(static_cast<std::uint32_t>(scene_.weight_count()));
    samples.radius_rad = 0.5f;
    Result<PoseCorrective> solved = solve_corrective(std::move(samples));
    CONTRACT(solved.has_value());
    return *std::move(solved);
  }

  std::vector<float> key_times() {
    std::vector<float> times = {0.0f};
    while (times.back() < 1.9f) times.push_back(times.back() + static_cast<float>(random_.in(0.05, 0.4)));
    times.back() = 2.0f;
    return times;
  }

  /// Interpolation is step, linear and cubic in turn. Cubic keys have zero in-tangents, and out-tangents of a tenth of
  /// their value.
  template <class T, class Value>
  T make_track(Value value) {
    T track;
    track.times_s = key_times();
    track.interpolation = static_cast<Interpolation>(kind_++ % 3);
    const auto none = value() * 0.0f;
    for (std::size_t k = 0; k < track.times_s.size(); ++k) {
      const auto v = value();
      if (track.interpolation == Interpolation::cubic_spline)
        track.values.insert(track.values.end(), {none, v, v * 0.1f});
      else
        track.values.push_back(v);
    }
    return track;
  }

  WeightTrack make_weights() {
    WeightTrack track;
    track.times_s = key_times();
    track.interpolation = static_cast<Interpolation>(kind_++ % 3);
    track.target_count = options_.targets;
    const std::size_t rows = track.times_s.size() * (track.interpolation == Interpolation::cubic_spline ? 3 : 1);
    for (std::size_t i = 0; i < rows * options_.targets; ++i)
      track.values.push_back(static_cast<float>(random_.in(-1, 2)));
    return track;
  }

  FixedRandom random_;
  RandomSceneOptions options_;
  Scene scene_;
  std::uint32_t kind_ = 0;
};

}  // namespace

Scene random_scene(std::uint64_t seed, const RandomSceneOptions& options) { return Maker(seed, options).make(); }

void move_few_joints(Scene& scene) {
  for (Animation& animation : scene.animations)
    std::erase_if(animation.bones, [](const BoneAnimation& bone) { return bone.joint % 3 != 2; });
  for (std::uint32_t j = 1; j < scene.skeleton.joint_count(); j += 6) {
    BoneAnimation held;
    held.joint = j;
    held.translation = {Interpolation::linear, {0.0f, 1.0f}, {glm::vec3(1), glm::vec3(1)}};
    scene.animations[0].bones.push_back(held);
  }
  scene.clips.clear();
  finish_scene(scene);
}

}  // namespace sinew::test
