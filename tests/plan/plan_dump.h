// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "runtime/plan/compile_plan.h"

namespace sinew::test {

/// A plan as text for golden files: one line per stage.
inline std::string dump(const Plan& plan) {
  std::string text;
  for (const PlanStage& stage : plan.stages())
    text += (stage.runs ? "+ " : "- ") + stage.stage + " [" + std::to_string(stage.count) + ", " +
            std::to_string(stage.bytes) + " B]: " + stage.reason + "\n";
  return text;
}

inline PlanStage stage(const Plan& plan, const std::string& name) {
  for (const PlanStage& candidate : plan.stages())
    if (candidate.stage == name) return candidate;
  return {"no such stage", false, "", 0, 0};
}

}  // namespace sinew::test
