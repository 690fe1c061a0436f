// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <set>
#include <string>

#include "importer/tool/json.h"
#include "runtime/model/scene.h"

namespace sinew::tool {

/// The nodes of the file that an animation moves, shows or hides, or whose morph weights it changes.
std::set<std::uint32_t> animated_nodes(const Scene& scene, const Animation& animation);

/// All nodes by the file's numbers: name, parent, children, and what is attached to each node.
Json node_list_json(const Scene& scene);

/// The nodes as a tree, one line each, children below their parents.
/// in   list   result of node_list_json()
std::string node_tree_text(const Json& list);

}  // namespace sinew::tool
