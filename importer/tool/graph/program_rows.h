// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "importer/tool/graph/program_files.h"
#include "importer/tool/json.h"
#include "runtime/plan/compile_plan.h"

namespace sinew::tool {

/// One operation of a program, as `sinew plan --program` lists it.
struct ProgramRow {
  std::string operation;      ///< "sample Walk at 0.3 s"
  bool needed = true;         ///< false: the pose is the same without it
  std::string reason;         ///< what takes its pose, or why it is not needed
  float share = 0.0f;         ///< of its pose in the final pose, where masks are 1
  std::uint64_t count = 0;    ///< tracks sampled, poses mixed, joints set
  double microseconds = 0.0;  ///< median of several runs; 0 if it was not measured
};

/// Prepares the needs for a program and its masks.
void add_program(const ProgramOfModel& loaded, const Scene& scene, Needs& needs);

/// Runs a program operation by operation. For what a caller gives, the rest pose, no joints and an empty procedure
/// stand in.
/// in   plan  of the scene that `loaded` was checked against;   measure  also take the time of each operation
std::vector<ProgramRow> program_rows(const Plan& plan, const ProgramOfModel& loaded, bool measure);

Json program_json(const std::vector<ProgramRow>& rows, bool measured);
std::string program_text(const std::vector<ProgramRow>& rows, bool measured);

}  // namespace sinew::tool
