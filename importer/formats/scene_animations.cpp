// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "importer/formats/scene_draft.h"
#include "runtime/math/decompose.h"
#include "runtime/math/interpolate.h"

namespace sinew::formats {
namespace {

/// Ticks of an animation as seconds. Keys before 0 and behind the end of the clip are no part of it: takes of FBX are
/// ranges of one time line.
struct Clock {
  double last_ticks = 0.0, ticks_per_s = 1.0;

  /// The times that lie in the clip, and its ends where others lie beyond.
  /// in    ticks   ascending
  std::vector<double> cut(const std::vector<double>& ticks) const {
    std::vector<double> out;
    for (const double time : ticks) {
      const double inside = std::clamp(time, 0.0, last_ticks);
      if (out.empty() || inside != out.back()) out.push_back(inside);
    }
    return out;
  }

  /// Key times of glTF: increasing floats. Of keys at one time the last counts.
  /// in    ticks   ascending
  /// out   for each time that is kept its index in `ticks`
  std::vector<float> seconds(const std::vector<double>& ticks, std::vector<std::size_t>& kept) const {
    std::vector<float> out;
    for (std::size_t i = 0; i < ticks.size(); ++i) {
      const float time = static_cast<float>(ticks[i] / ticks_per_s);
      if (!out.empty() && time <= out.back()) {
        kept.back() = i;
      } else {
        out.push_back(time);
        kept.push_back(i);
      }
    }
    return out;
  }
};

template <class Key>
std::vector<double> ticks_of(const Key* keys, unsigned count) {
  std::vector<double> out;
  for (unsigned i = 0; i < count; ++i) out.push_back(keys[i].mTime);
  return out;
}

/// Tracks of one joint at the same or at their own times.
class JointKeys {
 public:
  JointKeys(SceneDraft& scene, std::size_t joint, const Clock& clock)
      : scene_(scene),
        node_(scene.node_of_joint[joint]),
        rest_(decompose_trs(product_of(scene.joints[joint].links)).transform),
        clock_(clock) {}

  template <class Value>
  void add_translations(const std::vector<double>& ticks, Value value_at) {
    const auto [times, values] =
        keys<glm::vec3>(ticks, [&](std::size_t i) { return glm::vec3(value_at(i) * scene_.metres_per_unit); });
    if (tells(values, glm::vec3(rest_.translation * scene_.metres_per_unit)))
      scene_.draft.add_translations(node_, times, values);
  }

  template <class Value>
  void add_rotations(const std::vector<double>& ticks, Value value_at) {
    glm::dquat before(1.0, 0.0, 0.0, 0.0);
    const auto [times, values] = keys<glm::quat>(ticks, [&](std::size_t i) {
      const glm::dquat value = value_at(i);
      before = glm::dot(before, value) < 0.0 ? -value : value;
      return glm::quat(before);
    });
    if (!values.empty()) scene_.draft.add_rotations(node_, times, values);
  }

  template <class Value>
  void add_scales(const std::vector<double>& ticks, Value value_at) {
    const auto [times, values] = keys<glm::vec3>(ticks, [&](std::size_t i) { return glm::vec3(value_at(i)); });
    if (tells(values, glm::vec3(rest_.scale))) scene_.draft.add_scales(node_, times, values);
  }

 private:
  template <class V>
  struct Keys {
    std::vector<float> times_s;
    std::vector<V> values;
  };

  template <class V, class Value>
  Keys<V> keys(const std::vector<double>& ticks, Value value_at) const {
    Keys<V> out;
    std::vector<std::size_t> kept;
    out.times_s = clock_.seconds(ticks, kept);
    for (const std::size_t i : kept) out.values.push_back(value_at(i));
    return out;
  }

  /// False for tracks that assimp makes up: they stay at rest.
  static bool tells(const std::vector<glm::vec3>& values, const glm::vec3& rest) {
    const float near = 1e-5f * (1.0f + glm::length(rest));
    return std::any_of(values.begin(), values.end(),
                       [&](const glm::vec3& value) { return !(glm::distance(value, rest) <= near); });
  }

  SceneDraft& scene_;
  int node_;
  Transformd rest_;
  const Clock& clock_;
};

/// Adds the keys of a channel at their own times.
void add_whole(const aiNodeAnim& channel, const Clock& clock, JointKeys& keys) {
  const auto positions = clock.cut(ticks_of(channel.mPositionKeys, channel.mNumPositionKeys));
  const auto rotations = clock.cut(ticks_of(channel.mRotationKeys, channel.mNumRotationKeys));
  const auto scales = clock.cut(ticks_of(channel.mScalingKeys, channel.mNumScalingKeys));
  keys.add_translations(positions, [&](std::size_t i) { return sample_channel(channel, positions[i]).translation; });
  keys.add_rotations(rotations, [&](std::size_t i) { return sample_channel(channel, rotations[i]).rotation; });
  keys.add_scales(scales, [&](std::size_t i) { return sample_channel(channel, scales[i]).scale; });
}

/// Transforms of a chain at the keys of its links, and at times between them where the way is not straight.
class ChainSampler {
 public:
  ChainSampler(const FoldedJoint& joint, const Channels& channels, const Clock& clock)
      : joint_(joint), channels_(channels) {
    std::vector<double> keys;
    for (const aiNode* link : joint.links)
      if (const auto found = channels.find({link->mName.data, link->mName.length}); found != channels.end())
        for (const auto& times : {ticks_of(found->second->mPositionKeys, found->second->mNumPositionKeys),
                                  ticks_of(found->second->mRotationKeys, found->second->mNumRotationKeys),
                                  ticks_of(found->second->mScalingKeys, found->second->mNumScalingKeys)})
          keys.insert(keys.end(), times.begin(), times.end());
    std::sort(keys.begin(), keys.end());
    keys = clock.cut(keys);
    for (std::size_t i = 0; i < keys.size(); ++i) {
      const Transformd next = at(keys[i]);
      if (i != 0) split(keys[i - 1], poses.back(), keys[i], next, kMostHalvings);
      add(keys[i], next);
    }
  }

  std::vector<double> ticks;
  std::vector<Transformd> poses;

 private:
  static constexpr int kMostHalvings = 5;
  static constexpr double kBend = 1e-4;  ///< of the translation, and as an angle: less is not worth a key

  Transformd at(double time) const { return decompose_trs(local_at(joint_, channels_, time)).transform; }

  void add(double time, const Transformd& pose) {
    ticks.push_back(time);
    poses.push_back(pose);
  }

  /// Adds keys between two times until the middle of each pair is where a player will put it.
  void split(double t0, const Transformd& a, double t1, const Transformd& b, int halvings) {
    const double middle = 0.5 * (t0 + t1);
    const Transformd exact = at(middle);
    const double size = glm::length(exact.translation) + glm::distance(a.translation, b.translation);
    const bool straight =
        glm::distance(exact.translation, 0.5 * (a.translation + b.translation)) <= kBend * size &&
        1.0 - std::abs(glm::dot(exact.rotation, slerp_short_arc(a.rotation, b.rotation, 0.5))) <= kBend * kBend &&
        glm::distance(exact.scale, 0.5 * (a.scale + b.scale)) <= kBend * glm::length(exact.scale);
    if (straight || halvings == 0) return;
    split(t0, a, middle, exact, halvings - 1);
    add(middle, exact);
    split(middle, exact, t1, b, halvings - 1);
  }

  const FoldedJoint& joint_;
  const Channels& channels_;
};

void add_joint(SceneDraft& scene, std::size_t index, const Channels& channels, const Clock& clock) {
  const FoldedJoint& joint = scene.joints[index];
  JointKeys keys(scene, index, clock);
  if (const aiNodeAnim* whole = whole_channel(joint, channels)) return add_whole(*whole, clock, keys);
  const ChainSampler chain(joint, channels, clock);
  keys.add_translations(chain.ticks, [&](std::size_t i) { return chain.poses[i].translation; });
  keys.add_rotations(chain.ticks, [&](std::size_t i) { return chain.poses[i].rotation; });
  keys.add_scales(chain.ticks, [&](std::size_t i) { return chain.poses[i].scale; });
}

/// True if a channel of morph weights is for a mesh: assimp names the node or the mesh, with "*0" and the like behind.
bool is_for(const aiMeshMorphAnim& channel, const SceneDraft& scene, const MorphedNode& morphed) {
  std::string name = text_of(channel.mName);
  if (const std::size_t star = name.rfind('*'); star != name.npos) name.resize(star);
  return name == text_of(scene.joints[morphed.joint].node->mName) ||
         name == text_of(scene.scene.mMeshes[morphed.mesh]->mName);
}

/// Adds a key's weights, times `factor`.
void add_key(const aiMeshMorphKey& key, double factor, std::span<float> weights) {
  for (unsigned i = 0; i < key.mNumValuesAndWeights; ++i)
    if (key.mValues[i] < weights.size()) weights[key.mValues[i]] += static_cast<float>(factor * key.mWeights[i]);
}

void add_weights(SceneDraft& scene, const aiMeshMorphAnim& channel, const MorphedNode& morphed, const Clock& clock) {
  const std::size_t targets = scene.scene.mMeshes[morphed.mesh]->mNumAnimMeshes;
  const auto ticks = clock.cut(ticks_of(channel.mKeys, channel.mNumKeys));
  std::vector<std::size_t> kept;
  const auto times_s = clock.seconds(ticks, kept);
  std::vector<float> values(kept.size() * targets, 0.0f);
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const auto at = keys_around(channel.mKeys, channel.mNumKeys, ticks[kept[k]]);
    const auto weights = std::span(values).subspan(k * targets, targets);
    add_key(*at.before, 1.0 - at.factor, weights);
    if (at.factor != 0.0) add_key(*at.after, at.factor, weights);
  }
  if (!times_s.empty()) scene.draft.add_weights(morphed.node, times_s, values);
}

void add_morph_channel(SceneDraft& scene, const aiMeshMorphAnim& channel, const Clock& clock) {
  bool is_used = false;
  for (const MorphedNode& morphed : scene.morphed)
    if (is_for(channel, scene, morphed)) {
      add_weights(scene, channel, morphed, clock);
      is_used = true;
    }
  if (!is_used)
    scene.out.left_out.push_back("morph weights of '" + text_of(channel.mName) +
                                 "', whose targets assimp has not read");
}

}  // namespace

void add_animations(SceneDraft& scene) {
  for (unsigned a = 0; a < scene.scene.mNumAnimations; ++a) {
    const aiAnimation& animation = *scene.scene.mAnimations[a];
    constexpr double kDefaultTicks = 25.0;  // what assimp's other users take where a file has none
    const bool has_end = scene.is_fbx && animation.mDuration > 0.0;
    const Clock clock{has_end ? animation.mDuration : std::numeric_limits<double>::max(),
                      animation.mTicksPerSecond > 0.0 ? animation.mTicksPerSecond : kDefaultTicks};
    const Channels channels = channels_of(animation);
    scene.draft.begin_animation(text_of(animation.mName));
    for (std::size_t j = 0; j < scene.joints.size(); ++j)
      if (is_animated(scene.joints[j], channels)) add_joint(scene, j, channels, clock);
    for (unsigned i = 0; i < animation.mNumMorphMeshChannels; ++i)
      add_morph_channel(scene, *animation.mMorphMeshChannels[i], clock);
    if (animation.mNumMeshChannels != 0) scene.out.left_out.push_back("an animation of whole meshes (vertex cache)");
  }
}

}  // namespace sinew::formats
