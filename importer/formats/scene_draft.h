// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "importer/formats/import_format.h"
#include "importer/formats/joint_chain.h"
#include "importer/formats/model_draft.h"

namespace sinew::formats {

/// A node of the draft that shows a mesh with morph targets.
struct MorphedNode {
  int node = -1;
  unsigned mesh = 0;      ///< Index of the mesh in assimp's scene.
  std::size_t joint = 0;  ///< Index of the joint that holds the mesh.
};

/// A scene of assimp on its way into a draft. Each step reads what the steps before it have filled.
struct SceneDraft {
  const aiScene& scene;
  ModelDraft& draft;
  ImportedFormat& out;
  bool is_fbx = false;
  double metres_per_unit = 1.0;
  std::vector<FoldedJoint> joints;
  std::vector<int> node_of_joint;           ///< [joints]
  std::map<std::string, int> node_of_name;  ///< If several nodes share a name, the first.
  std::vector<MorphedNode> morphed;
  std::map<unsigned, int> material_of_source;  ///< those that a mesh uses
};

/// The material of an index of assimp's scene, added when it is first asked for; -1 for an index out of range.
int material_of(unsigned index, SceneDraft& scene);

/// Adds meshes, skins and morph targets.
void add_meshes(SceneDraft& scene);

/// Adds every animation that has a key.
void add_animations(SceneDraft& scene);

inline std::string text_of(const aiString& text) { return {text.data, text.length}; }

}  // namespace sinew::formats
