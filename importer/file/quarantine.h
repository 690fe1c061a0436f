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

/// Lets an import continue after errors, to report as many as possible in one run. Empties broken entries, so that
/// later steps can rely on the rest. Mutes reports about these entries and about entries that depend on them.
class Quarantine {
 public:
  /// Call after check_shape(): replaces each malformed list entry by the smallest valid one.
  /// out   false if the document as a whole is broken (root, asset, a list that is not an array) or there were too many
  ///       errors; the import must end
  bool isolate(JsonTree& document, IssueLog& log);

  /// Call after any later step: empties broken entries of the document that was read.
  bool isolate(gltf::Document& document, IssueLog& log);

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

 private:
  bool mark_errors(IssueLog& log, std::string_view harmless = {});

  std::array<std::set<std::uint32_t>, kLists> broken_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> broken_primitives_;  ///< mesh, primitive
  bool broken_scene_ = false;                                            ///< the document's `scene` index is broken
};

}  // namespace sinew
