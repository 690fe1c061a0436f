// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "importer/file/document.h"
#include "importer/file/json_tree.h"
#include "importer/issue_log.h"

namespace sinew {

/// Lets an import continue after errors: without the broken animation channels, or to report as many errors as possible
/// in one run. Empties broken entries, so that later steps can rely on the rest. Mutes reports about these entries and
/// about entries that depend on them.
class Quarantine {
 public:
  /// Call after check_shape(): replaces each malformed list entry by the smallest valid one. Of meshes only the
  /// malformed primitives are replaced, of animations only the malformed channels and samplers.
  /// out   false if the document as a whole is broken (the root, a list that is not an array) or there were too many
  ///       errors; the import must end
  bool isolate(JsonTree& document, IssueLog& log);

  /// Call after any later step: mark() and then empty_marked().
  bool isolate(gltf::Document& document, IssueLog& log) {
    if (!mark(log)) return false;
    empty_marked(document, log);
    return true;
  }

  /// Takes the places of the errors since the last call.
  /// out   false if the document as a whole is broken, or there were too many errors
  bool mark(IssueLog& log);
  void empty_marked(gltf::Document& document, IssueLog& log);

  /// True if nothing is broken so far.
  bool empty() const noexcept;

  /// True if only animations and data (buffers, views, accessors) are broken. Other parts may read the same data.
  bool holds_only_animations_and_data() const noexcept;

  /// True if the scene is sound without the animation channels that are broken or read broken data. Call between mark()
  /// and empty_marked(), which then removes these channels.
  bool touches_only_animations(const gltf::Document& document);

  enum List : std::size_t {
    accessors,
    animations,
    buffers,
    buffer_views,
    cameras,
    images,
    materials,
    meshes,
    nodes,
    samplers,
    scenes,
    skins,
    textures
  };
  static constexpr std::size_t kLists = 13;

  /// Parts of entries: index of the entry, index of the part in it.
  using Parts = std::set<std::pair<std::uint32_t, std::uint32_t>>;
  struct Broken {
    std::array<std::set<std::uint32_t>, kLists> entries;
    Parts primitives, channels, samplers;
    bool asset = false;     ///< the document's `asset` is missing or malformed
    bool scene = false;     ///< the document's `scene` index is broken
    bool too_deep = false;  ///< the tree of nodes is too deep to show; it can still be read
  };

 private:
  /// in   replaces_asset   errors of the root object are about its `asset`, the only member that it must have
  bool mark(IssueLog& log, bool replaces_asset);
  void replace_asset(JsonTree& document) const;
  void replace_entries(JsonTree& document, IssueLog& log) const;
  void replace_parts(JsonTree& document, IssueLog& log) const;

  Broken broken_;
  bool others_emptied_ = false;  ///< earlier steps emptied entries that read broken data
};

}  // namespace sinew
