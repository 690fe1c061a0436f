// SPDX-License-Identifier: MIT
#include <map>
#include <string>
#include <utility>

#include "importer/read/annotations.h"
#include "importer/read/property_pointer.h"
#include "importer/write/write_scene.h"

namespace sinew::write {
namespace {

const char* name_of(Interpolation interpolation) {
  switch (interpolation) {
    case Interpolation::step: return "STEP";
    case Interpolation::linear: return "LINEAR";
    case Interpolation::cubic_spline: return "CUBICSPLINE";
    case Interpolation::squad: break;
  }
  return nullptr;
}

/// Writes the channels of one animation. Key times shared by several tracks are written once.
class AnimationWriter {
 public:
  explicit AnimationWriter(GlbBuffer& buffer) : buffer_(buffer) {}

  bool add(int node, const char* path, Interpolation interpolation, const std::vector<float>& times_s, int values) {
    tinygltf::AnimationChannel channel;
    channel.target_node = node;
    channel.target_path = path;
    return add(std::move(channel), interpolation, times_s, values);
  }

  /// Adds a channel with a KHR_animation_pointer target.
  bool add(const std::string& pointer, Interpolation interpolation, const std::vector<float>& times_s, int values) {
    tinygltf::AnimationChannel channel;
    has_pointers_ = true;
    channel.target_path = "pointer";
    channel.target_extensions["KHR_animation_pointer"] =
        tinygltf::Value(tinygltf::Value::Object{{"pointer", tinygltf::Value(pointer)}});
    return add(std::move(channel), interpolation, times_s, values);
  }

  /// Adds a channel without a node, which readers ignore: glTF forbids animations without channels.
  void add_nothing() {
    const std::vector<glm::vec3> value(1);
    add(-1, "translation", Interpolation::step, {0.0f},
        buffer_.add(std::span<const glm::vec3>(value), false, ViewUse::other));
  }

  bool has_pointers() const noexcept { return has_pointers_; }

  tinygltf::Animation out;

 private:
  bool add(tinygltf::AnimationChannel channel, Interpolation interpolation, const std::vector<float>& times_s,
           int values) {
    const char* name = name_of(interpolation);
    if (!name) return false;
    auto [found, is_new] = times_.try_emplace(times_s, -1);
    if (is_new) found->second = buffer_.add(std::span<const float>(times_s), true);
    tinygltf::AnimationSampler sampler;
    sampler.input = found->second;
    sampler.output = values;
    sampler.interpolation = name;
    channel.sampler = static_cast<int>(out.samplers.size());
    out.samplers.push_back(std::move(sampler));
    out.channels.push_back(std::move(channel));
    return true;
  }

  GlbBuffer& buffer_;
  std::map<std::vector<float>, int> times_;
  bool has_pointers_ = false;
};

bool add_bone(const BoneAnimation& bone, int node, AnimationWriter& writer, GlbBuffer& buffer) {
  bool ok = true;
  if (const auto& t = bone.translation; !t.empty())
    ok &= writer.add(node, "translation", t.interpolation, t.times_s,
                     buffer.add(std::span<const glm::vec3>(t.values), false, ViewUse::other));
  if (const auto& r = bone.rotation; !r.empty())
    ok &= writer.add(node, "rotation", r.interpolation, r.times_s, buffer.add_rotations(r.values));
  if (const auto& s = bone.scale; !s.empty())
    ok &= writer.add(node, "scale", s.interpolation, s.times_s,
                     buffer.add(std::span<const glm::vec3>(s.values), false, ViewUse::other));
  return ok;
}

/// Writes the channel of all weights of a node, or of a single one.
bool add_weights(const WeightAnimation& animated, const Scene& scene, int node, AnimationWriter& writer,
                 GlbBuffer& buffer) {
  const WeightTrack& track = animated.weights;
  const int values = buffer.add(std::span<const float>(track.values));
  if (track.target_count == scene.instances[animated.instance].rest_weights.size())
    return writer.add(node, "weights", track.interpolation, track.times_s, values);
  if (track.target_count != 1) return false;
  return writer.add("/nodes/" + std::to_string(node) + "/weights/" + std::to_string(animated.first_target),
                    track.interpolation, track.times_s, values);
}

bool add_property(const PropertyTrack& track, const Scene& scene, AnimationWriter& writer, GlbBuffer& buffer) {
  const WeightTrack& values = track.values;
  const int accessor = is_flag(track.target.kind) ? buffer.add_flags(values.values)
                                                  : buffer.add_numbers(values.values, values.target_count);
  return writer.add(property_pointer(track.target, scene), values.interpolation, values.times_s, accessor);
}

tinygltf::Value value_of(const gltf::Json& json) {
  if (json.is_boolean()) return tinygltf::Value(json.get<bool>());
  if (json.is_number()) return tinygltf::Value(json.get<double>());
  if (json.is_string()) return tinygltf::Value(json.get<std::string>());
  if (json.is_array()) {
    tinygltf::Value::Array list;
    for (const gltf::Json& entry : json) list.push_back(value_of(entry));
    return tinygltf::Value(std::move(list));
  }
  tinygltf::Value::Object object;
  for (const auto& [name, entry] : json.items()) object[name] = value_of(entry);
  return tinygltf::Value(std::move(object));
}

tinygltf::Value extras_of(const Annotations& annotations) {
  gltf::Json animation = gltf::Json::object();
  set_annotations(annotations, animation);
  return animation.empty() ? tinygltf::Value() : value_of(animation["extras"]);
}

}  // namespace

std::optional<ImportIssue> write_animations(const Scene& scene, const std::vector<int>& node_of_instance,
                                            tinygltf::Model& model, GlbBuffer& buffer) {
  for (std::size_t a = 0; a < scene.animations.size(); ++a) {
    const auto& animation = scene.animations[a];
    AnimationWriter writer(buffer);
    writer.out.name = animation.name;
    writer.out.extras = extras_of(animation.annotations);
    bool ok = true;
    for (const auto& bone : animation.bones)
      ok &= add_bone(bone, static_cast<int>(scene.skeleton.node_of_joint[bone.joint]), writer, buffer);
    for (const auto& w : animation.weights) ok &= add_weights(w, scene, node_of_instance[w.instance], writer, buffer);
    for (const auto& property : animation.properties) ok &= add_property(property, scene, writer, buffer);
    if (writer.has_pointers()) declare_extension(model, "KHR_animation_pointer");
    if (ok && writer.out.channels.empty()) writer.add_nothing();
    if (!ok)
      return ImportIssue{Severity::error, "squad-in-gltf", "/animations/" + std::to_string(a),
                         "glTF has no squad interpolation; resample the track to LINEAR keys first"};
    model.animations.push_back(std::move(writer.out));
  }
  return std::nullopt;
}

}  // namespace sinew::write
