// SPDX-License-Identifier: MIT
#include "importer/file/check_references.h"

#include <string>
#include <vector>

#include "importer/file/json_pointer.h"

namespace sinew {
namespace {

using gltf::Document;

class ReferenceCheck {
 public:
  ReferenceCheck(const Document& document, IssueLog& log, ReferencedEntries* referenced)
      : d_(document), log_(log), referenced_(referenced) {}

  void run() {
    check_data();
    check_meshes();
    check_nodes();
    check_skins();
    check_animations();
    check_materials();
    check_scenes();
  }

 private:
  /// kNone (absent) is allowed here, because check_shape() has verified that required indices exist.
  template <class List, class... Part>
  void index(std::uint32_t value, const List& list, const Part&... place) {
    if (referenced_ != nullptr && value < list.size()) referenced_->mark(&list, value);
    if (value != kNone && value >= list.size())
      log_.report(Rule::reference, pointer(place...),
                  "index " + std::to_string(value) + " of " + std::to_string(list.size()) + " entries");
  }

  void check_data() {
    for (std::size_t i = 0; i < d_.buffer_views.size(); ++i)
      index(d_.buffer_views[i].buffer, d_.buffers, "bufferViews", i, "buffer");
    for (std::size_t i = 0; i < d_.images.size(); ++i)
      index(d_.images[i].buffer_view, d_.buffer_views, "images", i, "bufferView");
    for (std::size_t i = 0; i < d_.accessors.size(); ++i) {
      const auto& accessor = d_.accessors[i];
      index(accessor.buffer_view, d_.buffer_views, "accessors", i, "bufferView");
      index(accessor.sparse.indices_view, d_.buffer_views, "accessors", i, "sparse", "indices", "bufferView");
      index(accessor.sparse.values_view, d_.buffer_views, "accessors", i, "sparse", "values", "bufferView");
      if (accessor.count == 0)
        log_.report(Rule::accessor_empty, pointer("accessors", i, "count"),
                    "has no elements; what uses it is left out");
      if (accessor.sparse.count == 0 && accessor.sparse.indices_view != kNone)
        log_.report(Rule::accessor_empty, pointer("accessors", i, "sparse", "count"), "has no replacements");
    }
  }

  void check_meshes() {
    for (std::size_t m = 0; m < d_.meshes.size(); ++m)
      for (std::size_t p = 0; p < d_.meshes[m].primitives.size(); ++p) {
        const auto& primitive = d_.meshes[m].primitives[p];
        const std::string place = pointer("meshes", m, "primitives", p);
        index(primitive.indices, d_.accessors, place, "indices");
        index(primitive.material, d_.materials, place, "material");
        for (const auto& [name, accessor] : primitive.attributes)
          index(accessor, d_.accessors, place, "attributes", pointer_token(name));
        for (std::size_t t = 0; t < primitive.targets.size(); ++t)
          for (const auto& [name, accessor] : primitive.targets[t])
            index(accessor, d_.accessors, place, "targets", t, pointer_token(name));
      }
  }

  void check_nodes() {
    std::vector<std::uint32_t> parent(d_.nodes.size(), kNone);
    for (std::size_t n = 0; n < d_.nodes.size(); ++n) {
      const auto& node = d_.nodes[n];
      index(node.mesh, d_.meshes, "nodes", n, "mesh");
      index(node.skin, d_.skins, "nodes", n, "skin");
      index(node.camera, d_.cameras, "nodes", n, "camera");
      for (std::size_t c = 0; c < node.children.size(); ++c) {
        const std::uint32_t child = node.children[c];
        index(child, d_.nodes, "nodes", n, "children", c);
        if (child >= d_.nodes.size()) continue;
        if (parent[child] == kNone)
          parent[child] = static_cast<std::uint32_t>(n);
        else
          log_.report(
              Rule::node_parents, pointer("nodes", n, "children", c),
              "node " + std::to_string(child) + " is a child of node " + std::to_string(parent[child]) + " already");
      }
    }
    check_cycles(parent);
    is_child_.assign(parent.size(), false);
    for (std::size_t n = 0; n < parent.size(); ++n) is_child_[n] = parent[n] != kNone;
  }

  /// Finds cycles. Each node has at most one parent here. A walk upwards ends at a root, at a node of an earlier walk,
  /// or (in a cycle) at a node of this walk. Every node of a cycle is reported.
  void check_cycles(const std::vector<std::uint32_t>& parent) {
    std::vector<std::uint32_t> seen_by(parent.size(), kNone);
    for (std::uint32_t start = 0; start < parent.size(); ++start) {
      std::uint32_t node = start;
      while (node != kNone && seen_by[node] == kNone) {
        seen_by[node] = start;
        node = parent[node];
      }
      if (node == kNone || seen_by[node] != start) continue;
      const std::uint32_t first = node;
      do {
        log_.report(Rule::node_cycle, pointer("nodes", node), "the node is its own ancestor");
        node = parent[node];
      } while (node != first);
    }
  }

  void check_skins() {
    for (std::size_t s = 0; s < d_.skins.size(); ++s) {
      const auto& skin = d_.skins[s];
      index(skin.inverseBindMatrices, d_.accessors, "skins", s, "inverseBindMatrices");
      index(skin.skeleton, d_.nodes, "skins", s, "skeleton");
      for (std::size_t j = 0; j < skin.joints.size(); ++j) index(skin.joints[j], d_.nodes, "skins", s, "joints", j);
    }
  }

  void check_animations() {
    for (std::size_t a = 0; a < d_.animations.size(); ++a) {
      const auto& animation = d_.animations[a];
      for (std::size_t s = 0; s < animation.samplers.size(); ++s) {
        index(animation.samplers[s].input, d_.accessors, "animations", a, "samplers", s, "input");
        index(animation.samplers[s].output, d_.accessors, "animations", a, "samplers", s, "output");
      }
      for (std::size_t c = 0; c < animation.channels.size(); ++c) {
        index(animation.channels[c].sampler, animation.samplers, "animations", a, "channels", c, "sampler");
        index(animation.channels[c].node, d_.nodes, "animations", a, "channels", c, "target", "node");
      }
    }
  }

  void check_materials() {
    for (std::size_t m = 0; m < d_.materials.size(); ++m) {
      const auto& material = d_.materials[m];
      const std::string place = pointer("materials", m);
      const auto& surface = material.pbrMetallicRoughness;
      index(surface.baseColorTexture.index, d_.textures, place, "pbrMetallicRoughness", "baseColorTexture", "index");
      index(surface.metallicRoughnessTexture.index, d_.textures, place, "pbrMetallicRoughness",
            "metallicRoughnessTexture", "index");
      index(material.normalTexture.index, d_.textures, place, "normalTexture", "index");
      index(material.occlusionTexture.index, d_.textures, place, "occlusionTexture", "index");
      index(material.emissiveTexture.index, d_.textures, place, "emissiveTexture", "index");
    }
    for (std::size_t t = 0; t < d_.textures.size(); ++t) {
      index(d_.textures[t].source, d_.images, "textures", t, "source");
      index(d_.textures[t].sampler, d_.samplers, "textures", t, "sampler");
    }
  }

  void check_scenes() {
    index(d_.scene, d_.scenes, "scene");
    for (std::size_t s = 0; s < d_.scenes.size(); ++s)
      for (std::size_t n = 0; n < d_.scenes[s].nodes.size(); ++n) {
        const std::uint32_t node = d_.scenes[s].nodes[n];
        index(node, d_.nodes, "scenes", s, "nodes", n);
        if (node < is_child_.size() && is_child_[node])
          log_.report(Rule::scene_root, pointer("scenes", s, "nodes", n),
                      "node " + std::to_string(node) + " has a parent; its part of the tree is shown");
      }
  }

  const Document& d_;
  IssueLog& log_;
  ReferencedEntries* referenced_;
  std::vector<bool> is_child_;
};

}  // namespace

void check_references(const Document& document, IssueLog& log, ReferencedEntries* referenced) {
  ReferenceCheck(document, log, referenced).run();
}

}  // namespace sinew
