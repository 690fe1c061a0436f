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

/// Lets an import go on after errors, so that one run finds all of them: what is broken is emptied, so that later steps
/// find nothing wrong to rely on, and reports about it, or about others that only suffer from it, are muted.
class Quarantine {
 public:
  /// After check_shape(): entries of lists that broke their shape become the smallest valid ones.
  /// out  false where the document as a whole is at fault (root, asset, a list that is none) or there are too many
  /// errors:
  ///      the import ends then
  bool isolate(JsonTree& document, IssueLog& log);

  /// After any later step, with the document read.
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
  bool broken_scene_ = false;                                            ///< the index of the scene to show
};

}  // namespace sinew
