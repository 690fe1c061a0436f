// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "runtime/pose/add_pose.h"
#include "runtime/pose_program/pose_op.h"

namespace sinew {

/// A pose program as its JSON file states it: operations name clips and masks. program_schema.h lists the JSON keys.
struct ProgramDocument {
  /// An operation. `op` selects the members that are used; all others keep their defaults.
  struct Operation {
    PoseOpKind op = PoseOpKind::rest;
    float weight = 1.0f;
    std::string mask;
    std::string clip;  // samples
    double time_s = 0.0;
    std::int32_t operands = 2;  // mean
    double threshold = 1.0;
    DeltaFrame frame = DeltaFrame::parent;  // additions
    std::int32_t index = 0;                 // what the caller gives
    double share = 1.0;
    double progress = 0.0;  // transitions
    std::int32_t steps = 1;
  };

  /// Joint names of each mask; a joint stands for itself and all its descendants.
  std::map<std::string, std::vector<std::string>> masks;
  std::vector<Operation> operations;
};

}  // namespace sinew
