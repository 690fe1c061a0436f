// SPDX-License-Identifier: MIT
#pragma once
/// Motion graphs. A GraphDefinition says how a character moves; all characters that move alike share it. The state of a
/// character is one block of bytes: a copy of it is a save, and writing it back restores the character. An update plays
/// the graph on and writes a short pose program, which a frame runs (FrameInput::program).
///
///     sinew::GraphBuilder b;
///     const auto speed = b.number("speed");
///     const auto body = b.machine("body");
///     const auto idle = b.state(body, "idle", b.clip("idle"));
///     const auto walk = b.state(body, "walk", b.clip("walk"));
///     b.transition(body, idle, {.duration_s = 0.2f, .to = walk}, {sinew::when_above(speed, 0.1f)});
///     b.transition(body, walk, {.duration_s = 0.3f, .to = idle}, {sinew::when_below(speed, 0.1f)});
///     const auto graph = b.build(body);
///
///     run(sinew::UpdateGraphJob{.graph = &*graph, .clips = &clips, .parameters = values, .state = character,
///                               .dt_s = dt_s, .program = &program, .events = events, .step = &step});
///     frame.program = program.ops();
#include "runtime/graph/carry_state.h"
#include "runtime/graph/graph_builder.h"
#include "runtime/graph/graph_bytes.h"
#include "runtime/graph/graph_clips.h"
#include "runtime/graph/graph_definition.h"
#include "runtime/graph/graph_masks.h"
#include "runtime/graph/read_graph_state.h"
#include "runtime/graph/update_graph.h"
