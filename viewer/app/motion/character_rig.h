// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "importer/graph/graph_files.h"
#include "importer/graph/graph_setting.h"
#include "runtime/math/affine.h"
#include "runtime/procedures/constraints/node_constraints.h"
#include "runtime/procedures/expressions/expressions.h"
#include "runtime/procedures/springs/springs.h"
#include "viewer/app/motion/motion_settings.h"

namespace sinew {
struct VrmCharacter;
}  // namespace sinew

namespace sinew::viewer {

/// The joint whose motion carries a character, and the parts of it that do.
struct RootJoint {
  std::uint32_t joint = kNone;  ///< kNone = no clip moves the character
  RootMotionParts parts;        ///< in the space of the joint's parent
  Affined parent;               ///< world matrix of the parent at rest
};

/// Finds the root joint: the first one, from the root down, that some clip moves along the ground. Heights stay in the
/// pose, and so do turns if the joint's parent is not upright.
RootJoint find_root_joint(const Scene& scene);

/// A motion graph that drives a character.
struct GraphOnScene : GraphOfModel {
  std::vector<GraphSetting> script;  ///< in the order of time
};

/// All that moves a character besides its clips.
struct CharacterRig {
  RootJoint root;
  std::optional<Springs> springs;
  std::optional<NodeConstraints> constraints;
  std::vector<Expression> expressions;
  std::shared_ptr<const GraphOnScene> graph;  ///< null = clips play

  bool has_procedures() const noexcept { return springs || constraints; }
};

/// Prepares the rig of a scene.
/// in   vrm  null = the file has none
/// out  left_out  a sentence for each spring or constraint that cannot be used
CharacterRig make_rig(const Scene& scene, const VrmCharacter* vrm, std::vector<std::string>& left_out);

/// Reads a motion graph (JSON, importer/graph/README.md) for a scene, and checks that its clips and joints exist.
/// in   script  changes of parameters in any order
/// err  "FILE: POINTER: sentence"; a parameter of the script that the graph lacks
tl::expected<std::shared_ptr<const GraphOnScene>, std::string> read_graph_for(const std::string& file,
                                                                              const Scene& scene, const RootJoint& root,
                                                                              std::vector<GraphSetting> script);

}  // namespace sinew::viewer
