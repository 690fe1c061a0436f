// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "importer/file/tinygltf.h"
#include "importer/import_error.h"
#include "importer/write/glb_buffer.h"
#include "runtime/base/index.h"

namespace sinew::formats {

/// A glTF file that a reader of another format fills. The members of `model` may be set directly.
class ModelDraft {
 public:
  ModelDraft();

  /// Adds a node below `parent`, or as a root of the scene.
  /// in    parent   a node, or -1
  /// out   its index
  int add_node(const std::string& name, int parent, const glm::dvec3& translation,
               const glm::dquat& rotation = glm::dquat(1.0, 0.0, 0.0, 0.0), const glm::dvec3& scale = glm::dvec3(1.0));

  void begin_animation(const std::string& name);

  /// Adds a channel of linear keys to the last animation. Channels with equal times share them.
  /// in    times_s  increasing
  void add_translations(int node, const std::vector<float>& times_s, std::span<const glm::vec3> values);
  void add_rotations(int node, const std::vector<float>& times_s, std::span<const glm::quat> values);
  void add_scales(int node, const std::vector<float>& times_s, std::span<const glm::vec3> values);
  void add_weights(int node, const std::vector<float>& times_s, std::span<const float> values);

  /// The file, held to every rule of glTF that the importer knows.
  /// in    file   name of the source in messages
  /// out   bytes of a .glb
  /// err   the rules that the draft breaks, for example with numbers that are not finite; "glb-size"
  ImportResult<std::vector<std::byte>> finish(const std::string& file, std::vector<ImportIssue>& warnings);

  tinygltf::Model model;
  write::GlbBuffer buffer;

 private:
  void add_channel(int node, const char* path, const std::vector<float>& times_s, int values);

  std::map<std::vector<float>, int> times_;
};

}  // namespace sinew::formats
