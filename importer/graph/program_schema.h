// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include "importer/graph/program_document.h"

// Lists every member of a program file, as graph_schema.h does for graphs.
namespace sinew::graph_schema {

inline constexpr int kProgramVersion = 1;

constexpr auto words_of(PoseOpKind) {
  return std::array{"rest",        "sample",        "sample_mirrored", "rest_mirrored", "external",        "mean",
                    "overlay",     "overlay_model", "add_to_rest",     "add",           "override_joints", "procedure",
                    "inertialize", "dead_blend",    "cached"};
}
constexpr auto words_of(DeltaFrame) { return std::array{"parent", "joint"}; }

template <class V, class D>
void describe(V& v, D& d, const ProgramDocument::Operation*) {
  v.required("op", d.op, "kind of the operation; other members depend on it");
  v.optional("weight", d.weight, "in the operation that takes this pose");
  v.optional("mask", d.mask, "name of a mask; without it all joints");
  switch (d.op) {
    case PoseOpKind::sample:
    case PoseOpKind::sample_mirrored:
      v.required("clip", d.clip, "name of the clip");
      v.optional("time_s", d.time_s, "seconds in the clip");
      return;
    case PoseOpKind::mean:
      v.optional("operands", d.operands, "number of topmost poses");
      v.optional("threshold", d.threshold, "smaller sums of weights are filled up with the rest pose");
      return;
    case PoseOpKind::add:
    case PoseOpKind::add_to_rest: v.optional("frame", d.frame, "the space of differences between rotations"); return;
    case PoseOpKind::external: v.optional("index", d.index, "of the caller's pose"); return;
    case PoseOpKind::override_joints:
    case PoseOpKind::procedure:
      v.optional("index", d.index, "of the caller's override or procedure");
      v.optional("share", d.share, "how much of it applies");
      return;
    case PoseOpKind::inertialize:
    case PoseOpKind::dead_blend:
      v.required("progress", d.progress, "share of the duration that has passed");
      v.required("steps", d.steps, "steps in the duration");
      return;
    default: return;
  }
}

template <class V, class D>
void describe(V& v, D& d, const ProgramDocument*) {
  v.optional("masks", d.masks, "lists of joints by name; each joint counts with all below it");
  v.required("operations", d.operations, "in postfix order");
}

}  // namespace sinew::graph_schema
