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

/// Lets an import go on after errors, so that one run finds all of them. Broken entries are emptied, so that later
/// steps can rely on what is left. Reports about these entries, and about entries that only suffer from them, are
/// muted.
class Quarantine {
 public:
  /// After check_shape(): replaces each list entry of the wrong shape by the smallest valid one.
  /// out   false when the document as a whole is broken (root, asset, a list that is no array) or there were too many
  ///       errors to remember; the import then ends
  bool isolate(JsonTree& document, IssueLog& log);

  /// The same after any later step, on the document that was read.
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
  bool broken_scene_ = false;                                            ///< the document's own `scene` index is broken
};

}  // namespace sinew
