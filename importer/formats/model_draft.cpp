// SPDX-License-Identifier: MIT
#include "importer/formats/model_draft.h"

#include <algorithm>
#include <utility>

#include "importer/import_gltf.h"
#include "importer/write/glb_file.h"

namespace sinew::formats {

ModelDraft::ModelDraft() : buffer(model) {
  model.asset.version = "2.0";
  model.asset.generator = "sinew import";
  model.scenes.resize(1);
  model.defaultScene = 0;
}

int ModelDraft::add_node(const std::string& name, int parent, const glm::dvec3& t, const glm::dquat& q,
                         const glm::dvec3& s) {
  const int index = static_cast<int>(model.nodes.size());
  tinygltf::Node& node = model.nodes.emplace_back();
  node.name = name;
  if (t != glm::dvec3(0.0)) node.translation = {t.x, t.y, t.z};
  if (q != glm::dquat(1.0, 0.0, 0.0, 0.0)) node.rotation = {q.x, q.y, q.z, q.w};
  if (s != glm::dvec3(1.0)) node.scale = {s.x, s.y, s.z};
  std::vector<int>& siblings =
      parent < 0 ? model.scenes[0].nodes : model.nodes[static_cast<std::size_t>(parent)].children;
  siblings.push_back(index);
  return index;
}

void ModelDraft::begin_animation(const std::string& name) { model.animations.emplace_back().name = name; }

void ModelDraft::add_channel(int node, const char* path, const std::vector<float>& times_s, int values) {
  const auto [shared, is_new] = times_.try_emplace(times_s, -1);
  if (is_new) shared->second = buffer.add(std::span<const float>(times_s), true);
  tinygltf::Animation& animation = model.animations.back();
  tinygltf::AnimationSampler sampler;
  sampler.input = shared->second;
  sampler.output = values;
  sampler.interpolation = "LINEAR";
  tinygltf::AnimationChannel channel;
  channel.target_node = node;
  channel.target_path = path;
  channel.sampler = static_cast<int>(animation.samplers.size());
  animation.samplers.push_back(std::move(sampler));
  animation.channels.push_back(std::move(channel));
}

void ModelDraft::add_translations(int node, const std::vector<float>& times_s, std::span<const glm::vec3> values) {
  add_channel(node, "translation", times_s, buffer.add(values, false, write::ViewUse::other));
}

void ModelDraft::add_rotations(int node, const std::vector<float>& times_s, std::span<const glm::quat> values) {
  add_channel(node, "rotation", times_s, buffer.add_rotations(values));
}

void ModelDraft::add_scales(int node, const std::vector<float>& times_s, std::span<const glm::vec3> values) {
  add_channel(node, "scale", times_s, buffer.add(values, false, write::ViewUse::other));
}

void ModelDraft::add_weights(int node, const std::vector<float>& times_s, std::span<const float> values) {
  add_channel(node, "weights", times_s, buffer.add(values));
}

ImportResult<std::vector<std::byte>> ModelDraft::finish(const std::string& file, std::vector<ImportIssue>& warnings) {
  std::erase_if(model.animations, [](const tinygltf::Animation& animation) { return animation.channels.empty(); });
  if (model.buffers[0].data.empty()) model.buffers.clear();
  auto bytes = write::glb_file(model);
  if (!bytes)
    return tl::unexpected(ImportError{
        file, {Severity::error, "glb-size", "", "what is imported does not fit into a GLB of 4 GiB"}, {}, {}});
  ImportOptions options;
  options.decode_images = options.make_normals = options.make_tangents = false;
  auto imported = import_gltf(*bytes, file, options);
  if (!imported) return tl::unexpected(std::move(imported).error());
  warnings.insert(warnings.end(), imported->warnings.begin(), imported->warnings.end());
  return *std::move(bytes);
}

}  // namespace sinew::formats
