// SPDX-License-Identifier: MIT
#pragma once
/// The evaluation plan: which stages the frames of a scene run, for the needs of a consumer. It is compiled once, when
/// a scene is loaded. All characters that show the scene share it. Frames run it (frame.h).
///
///     const sinew::Plan plan = compile_plan(share(std::move(scene)), sinew::Needs{.out = {.bounds = true}});
///     for (const sinew::PlanStage& stage : plan.stages()) log(stage.stage, stage.runs, stage.reason);
#include "runtime/plan/check_needs.h"
#include "runtime/plan/compile_plan.h"
#include "runtime/plan/needs.h"
#include "runtime/plan/plan_stages.h"
#include "runtime/plan/run_plan.h"
