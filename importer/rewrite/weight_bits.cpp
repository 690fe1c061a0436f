// SPDX-License-Identifier: MIT
#include "importer/rewrite/weight_bits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <vector>

#include "importer/read/accessor.h"
#include "runtime/animation/truth_pose.h"
#include "runtime/math/affine.h"

namespace sinew::rewrite {
namespace {

constexpr std::size_t kPoses = 64;

std::uint32_t index_of(const Json& number) { return static_cast<std::uint32_t>(number.get<double>()); }

/// A skinned primitive with one set of weights, as floats.
struct Skinned {
  std::uint32_t weights_accessor = 0, skin = 0;
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> joints;
  std::vector<float> weights;
};

bool is_float(const gltf::Document& document, const Json& accessor) {
  return index_of(accessor) < document.accessors.size() &&
         document.accessors[index_of(accessor)].component_type == gltf::ComponentType::f32;
}

std::vector<Skinned> skinned_primitives(const gltf::Document& document, const Scene& scene, Draft& draft) {
  std::vector<Skinned> out;
  for (const Json& node : list_of(draft, "nodes")) {
    if (!node.contains("skin") || !node.contains("mesh") || index_of(node["skin"]) >= scene.skins.size()) continue;
    for (const Json& primitive : draft.json["meshes"][index_of(node["mesh"])]["primitives"]) {
      const Json& names = primitive["attributes"];
      if (!names.contains("JOINTS_0") || !names.contains("WEIGHTS_0") || !names.contains("POSITION") ||
          names.contains("WEIGHTS_1") || !is_float(document, names["WEIGHTS_0"]) ||
          !is_float(document, names["POSITION"]))
        continue;
      Skinned& added = out.emplace_back();
      added.weights_accessor = index_of(names["WEIGHTS_0"]);
      added.skin = index_of(node["skin"]);
      added.positions = read_vectors<glm::vec3>(document, index_of(names["POSITION"]));
      added.joints = read_unsigned(document, index_of(names["JOINTS_0"]));
      added.weights = read_floats(document, added.weights_accessor);
      const std::size_t joint_count = scene.skins[added.skin].joints.size();
      const bool whole =
          added.joints.size() == 4 * added.positions.size() && added.weights.size() == added.joints.size();
      if (!whole || std::any_of(added.joints.begin(), added.joints.end(), [&](auto j) { return j >= joint_count; }))
        out.pop_back();
    }
  }
  return out;
}

/// The rest pose, then poses spread over all clips.
std::vector<std::vector<Affined>> model_poses(const Scene& scene) {
  std::vector<std::vector<Affined>> poses;
  TruthPose pose;
  const auto add = [&](const Animation& animation, double time_s) {
    evaluate_truth(animation, scene.skeleton, time_s, pose);
    poses.push_back(pose.model);
  };
  add({}, 0.0);
  const std::size_t clips = scene.animations.size();
  for (std::size_t i = 1; clips > 0 && i < kPoses; ++i) {
    const Animation& animation = scene.animations[i * clips / kPoses];
    const double place = static_cast<double>(i * clips % kPoses) / static_cast<double>(kPoses - 1);
    add(animation, animation.duration_s * place);
  }
  return poses;
}

std::array<float, 4> four(const std::vector<float>& values, std::size_t vertex) {
  return {values[4 * vertex], values[4 * vertex + 1], values[4 * vertex + 2], values[4 * vertex + 3]};
}

/// The change of the weights of each vertex by rounding to 8 bits.
std::vector<double> changes_of(const Skinned& skinned) {
  std::vector<double> out;
  for (std::size_t v = 0; v < skinned.positions.size(); ++v) {
    const std::array<float, 4> before = four(skinned.weights, v);
    const std::array<double, 4> after = rounded_weights(before, 255.0);
    const double sum = std::accumulate(before.begin(), before.end(), 0.0);
    for (std::size_t i = 0; i < 4; ++i)
      out.push_back(sum > 0.0 ? after[i] / 255.0 - static_cast<double>(before[i]) / sum : 0.0);
  }
  return out;
}

/// Adds the vertices of one pose to the box.
/// out  the largest distance by which rounded weights move a vertex
double move_of(const Skinned& skinned, const Skin& skin, const std::vector<double>& changes,
               const std::vector<Affined>& model, Aabb* box) {
  std::vector<Affined> palette;
  for (std::size_t i = 0; i < skin.joints.size(); ++i)
    palette.push_back(model[skin.joints[i]] * affine_cast<double>(skin.inverse_bind[i]));
  double most = 0.0;
  for (std::size_t v = 0; v < skinned.positions.size(); ++v) {
    Vec3<double> moved(0.0), place(0.0);
    for (std::size_t i = 4 * v; i < 4 * v + 4; ++i) {
      if (skinned.weights[i] == 0.0f && changes[i] == 0.0) continue;
      const Vec3<double> at = transform_point(palette[skinned.joints[i]], Vec3<double>(skinned.positions[v]));
      moved += changes[i] * at;
      place += static_cast<double>(skinned.weights[i]) * at;
    }
    most = std::max(most, std::sqrt(moved.x * moved.x + moved.y * moved.y + moved.z * moved.z));
    if (box != nullptr) box->add(glm::vec3(place));
  }
  return most;
}

}  // namespace

std::array<double, 4> rounded_weights(const std::array<float, 4>& weights, double most) {
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  std::array<double, 4> out{};
  if (!(sum > 0.0)) return out;
  double left = most;
  std::array<double, 4> exact{};
  for (std::size_t i = 0; i < 4; ++i) {
    exact[i] = static_cast<double>(weights[i]) / sum * most;
    out[i] = std::round(exact[i]);
    left -= out[i];
  }
  while (left != 0.0) {
    const double step = left > 0.0 ? 1.0 : -1.0;
    std::size_t best = 0;
    double farthest = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 4; ++i) {
      const double missing = step * (exact[i] - out[i]);
      if ((step < 0.0 && out[i] == 0.0) || exact[i] == 0.0 || missing <= farthest) continue;
      best = i;
      farthest = missing;
    }
    out[best] += step;
    left -= step;
  }
  return out;
}

std::set<std::uint32_t> weights_of_16_bits(const gltf::Document& document, const Scene& scene, Draft& draft) {
  const std::vector<Skinned> primitives = skinned_primitives(document, scene, draft);
  if (primitives.empty()) return {};
  std::map<std::uint32_t, double> moved;
  Aabb box;
  std::vector<std::vector<double>> changes;
  for (const Skinned& skinned : primitives) changes.push_back(changes_of(skinned));
  bool rest = true;
  for (const std::vector<Affined>& model : model_poses(scene)) {
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      double& most = moved[primitives[i].weights_accessor];
      most = std::max(
          most, move_of(primitives[i], scene.skins[primitives[i].skin], changes[i], model, rest ? &box : nullptr));
    }
    rest = false;
  }
  const glm::vec3 sides = box.upper - box.lower;
  const double size = static_cast<double>(std::max({sides.x, sides.y, sides.z}));
  std::set<std::uint32_t> out;
  for (const auto& [accessor, most] : moved)
    if (most > kWeightsMove * size) out.insert(accessor);
  return out;
}

}  // namespace sinew::rewrite
