// SPDX-License-Identifier: MIT
#include "runtime/c/graph/graph.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/c/glue/call.h"
#include "runtime/c/glue/convert.h"
#include "runtime/c/glue/struct_versions.h"
#include "runtime/c/glue/write_messages.h"
#include "runtime/c/graph/carry.h"
#include "runtime/c/graph/graph_handles.h"
#include "runtime/c/handles.h"
#include "runtime/c/program_room.h"
#include "runtime/graph/carry_state.h"
#include "runtime/graph/graph_bytes.h"
#include "runtime/graph/graph_masks.h"
#include "runtime/graph/update_graph.h"

using namespace sinew;

namespace {

/// Offset of the name of a thing, or null if there is none.
const std::uint32_t* name_of_thing(const GraphTables& t, std::uint32_t thing, std::size_t index) noexcept {
  const auto find = [&](const auto& table) { return index < table.size() ? &table[index].name : nullptr; };
  switch (thing) {
    case SINEW_GRAPH_PARAMETER: return find(t.parameters);
    case SINEW_GRAPH_CLIP: return index < t.clip_names.size() ? &t.clip_names[index] : nullptr;
    case SINEW_GRAPH_NODE: return find(t.nodes);
    case SINEW_GRAPH_MASK: return find(t.masks);
    default: return nullptr;
  }
}

std::uint32_t count_of(std::size_t size) noexcept { return static_cast<std::uint32_t>(size); }

/// The root motion of a handle as keys within 10 micrometres and microradians.
RootTrack keys_of(const sinew_root_track& track) {
  return RootTrack::make(track.animation, track.rest, track.parts, 1e-5);
}

sinew_error read_clip(const sinew_graph_clip& given, sinew_graph_clips& owner, std::vector<SyncBeat>& beats,
                      GraphClip& clip) {
  if (const sinew_error error = c::from_c(given.event_times_s, clip.event_times_s)) return error;
  if (given.beats == nullptr && given.beat_count > 0) return SINEW_NULL_ARGUMENT;
  for (std::size_t b = 0; b < given.beat_count; ++b) beats.push_back({given.beats[b].phase, given.beats[b].name});
  clip.clip = given.clip;
  clip.duration_s = given.duration_s;
  clip.beats = beats;
  clip.root_in_pose = given.root_in_pose != 0;
  if (given.root != nullptr) {
    owner.roots.push_back(std::make_unique<RootTrack>(keys_of(*given.root)));
    clip.root = owner.roots.back().get();
  }
  return SINEW_OK;
}

std::span<std::byte> bytes_of(void* state, std::size_t state_bytes) noexcept {
  return {static_cast<std::byte*>(state), state_bytes};
}

// Updates write their events into the memory of the caller, where each is then turned into an event of C.
static_assert(sizeof(sinew_graph_event) == sizeof(GraphEvent) && alignof(sinew_graph_event) == alignof(GraphEvent));

void turn_into_event_of_c(sinew_graph_event& event) noexcept {
  GraphEvent own;
  c::copy_bytes(event, own);
  event = {.time_s = seconds_of(own.at),
           .node = own.node,
           .clip = own.kind == GraphEventKind::state ? SINEW_NONE : own.clip,
           .index = own.index,
           .weight = own.weight};
}

GraphIndex graph_index(std::uint32_t index) noexcept {
  return static_cast<GraphIndex>(std::min<std::uint32_t>(index, kNoGraphIndex));
}

}  // namespace

sinew_error sinew_graph_create(const void* bytes, std::size_t byte_count, sinew_graph** out,
                               sinew_messages** messages) {
  return c::call(c::given(bytes, out), [&] {
    auto tables = read_graph_bytes({static_cast<const std::byte*>(bytes), byte_count});
    if (!tables) return c::bad_file("the bytes are no graph of this version", messages);
    auto graph = GraphDefinition::make(*tables);
    if (!graph) return c::bad_file(describe(graph.error(), *tables), messages);
    *out = new sinew_graph{std::move(*graph)};
    return SINEW_OK;
  });
}

void sinew_graph_destroy(sinew_graph* graph) { delete graph; }

std::size_t sinew_graph_write(const sinew_graph* graph, void* bytes, std::size_t room) {
  std::size_t size = 0;
  static_cast<void>(c::call(c::given(graph), [&] {
    const std::vector<std::byte> written = write_graph_bytes(graph->definition.tables());
    size = written.size();
    if (bytes != nullptr) std::memcpy(bytes, written.data(), std::min(room, size));
  }));
  return size;
}

sinew_error sinew_graph_get_info(const sinew_graph* graph, sinew_graph_info* out) {
  return c::call(c::given(graph, out), [&] {
    const GraphTables& t = graph->definition.tables();
    return c::write_struct(sinew_graph_info{.struct_size = sizeof(sinew_graph_info),
                                            .parameters = count_of(t.parameters.size()),
                                            .clips = count_of(t.clip_names.size()),
                                            .nodes = count_of(t.nodes.size()),
                                            .masks = count_of(t.masks.size()),
                                            .state_bytes = graph->definition.state_bytes(),
                                            .ops = graph->definition.room().ops},
                           out);
  });
}

sinew_error sinew_graph_get_room(const sinew_graph* graph, sinew_program_room* out) {
  return c::call(c::given(graph, out), [&] { return c::write_fields(c::kProgramRoom, graph->definition.room(), out); });
}

sinew_string sinew_graph_name(const sinew_graph* graph, std::uint32_t thing, std::uint32_t index) {
  if (graph == nullptr) return {nullptr, 0};
  const std::uint32_t* const name = name_of_thing(graph->definition.tables(), thing, index);
  return c::to_c(name == nullptr ? std::string_view() : graph->definition.tables().name_at(*name));
}

std::uint32_t sinew_graph_find(const sinew_graph* graph, std::uint32_t thing, const char* name) {
  if (graph == nullptr || name == nullptr) return SINEW_NONE;
  const GraphTables& t = graph->definition.tables();
  for (std::uint32_t i = 0;; ++i) {
    const std::uint32_t* const other = name_of_thing(t, thing, i);
    if (other == nullptr) return SINEW_NONE;
    if (t.name_at(*other) == name) return i;
  }
}

std::uint32_t sinew_graph_find_state(const sinew_graph* graph, std::uint32_t node, const char* name) {
  if (graph == nullptr || name == nullptr) return SINEW_NONE;
  const GraphTables& t = graph->definition.tables();
  if (node >= t.nodes.size() || t.nodes[node].kind != GraphNodeKind::machine) return SINEW_NONE;
  const GraphMachine& machine = t.machines[t.nodes[node].settings];
  for (std::uint32_t s = 0; s < machine.state_count; ++s)
    if (t.name_at(t.states[machine.first_state + s].name) == name) return s;
  return SINEW_NONE;
}

float sinew_graph_initial(const sinew_graph* graph, std::uint32_t parameter) {
  if (graph == nullptr || parameter >= graph->definition.tables().parameters.size()) return 0.0f;
  return graph->definition.tables().parameters[parameter].initial;
}

sinew_error sinew_graph_mask(const sinew_graph* graph, std::uint32_t mask, const sinew_scene* scene, float* weights,
                             std::size_t count) {
  return c::call(c::given(graph, scene, weights), [&] {
    const GraphTables& t = graph->definition.tables();
    if (mask >= t.masks.size()) return SINEW_INDEX_OUT_OF_RANGE;
    if (count < scene->scene.skeleton.joint_count()) return SINEW_SIZE_MISMATCH;
    const auto masks = make_graph_masks(t, scene->scene.skeleton);
    if (!masks) return c::error_from(masks.error());
    std::copy((*masks)[mask].begin(), (*masks)[mask].end(), weights);
    return SINEW_OK;
  });
}

sinew_error sinew_graph_clips_create(const sinew_graph* graph, const sinew_graph_clip* clips, std::size_t count,
                                     const sinew_indices* mirrored_beats, sinew_graph_clips** out) {
  return c::call(c::given(graph, out, c::Array{clips, count}), [&] {
    auto made = std::make_unique<sinew_graph_clips>();
    std::vector<GraphClip> own(count);
    std::vector<std::vector<SyncBeat>> beats(count);
    for (std::size_t i = 0; i < count; ++i) {
      const sinew_graph_clip* element = nullptr;
      sinew_graph_clip clip{};
      clip.root_in_pose = 1;
      if (const sinew_error error = c::element_of(clips, i, element)) return error;
      if (const sinew_error error = c::read_struct(element, clip)) return error;
      if (const sinew_error error = read_clip(clip, *made, beats[i], own[i])) return error;
    }
    std::span<const std::uint32_t> mirrored;
    if (mirrored_beats != nullptr)
      if (const sinew_error error = c::from_c(*mirrored_beats, mirrored)) return error;
    auto set = GraphClipSet::make(graph->definition, own, mirrored);
    if (!set) return c::error_from(set.error());
    made->set = std::move(*set);
    *out = made.release();
    return SINEW_OK;
  });
}

void sinew_graph_clips_destroy(sinew_graph_clips* clips) { delete clips; }

sinew_error sinew_graph_start(const sinew_graph* graph, const sinew_graph_clips* clips, const float* parameters,
                              std::size_t parameter_count, void* state, std::size_t state_bytes) {
  return c::call(c::given(graph, clips, state, c::Array{parameters, parameter_count}), [&] {
    return run(
        StartGraphJob{&graph->definition, &clips->set, {parameters, parameter_count}, bytes_of(state, state_bytes)});
  });
}

sinew_error sinew_graph_carry(const sinew_graph* from, const void* from_state, std::size_t from_bytes,
                              const sinew_graph* graph, const sinew_graph_clips* clips, const float* parameters,
                              std::size_t parameter_count, void* state, std::size_t state_bytes) {
  return c::call(c::given(from, from_state, graph, clips, state, c::Array{parameters, parameter_count}), [&] {
    return run(CarryStateJob{.from = &from->definition,
                             .from_state = {static_cast<const std::byte*>(from_state), from_bytes},
                             .graph = &graph->definition,
                             .clips = &clips->set,
                             .parameters = {parameters, parameter_count},
                             .state = bytes_of(state, state_bytes)});
  });
}

sinew_error sinew_graph_update(const sinew_graph* graph, const sinew_graph_clips* clips, const float* parameters,
                               std::size_t parameter_count, void* state, std::size_t state_bytes, double dt_s,
                               sinew_graph_step* step) {
  return c::call(c::given(graph, clips, state, step, c::Array{parameters, parameter_count}), [&] {
    sinew_graph_step outcome{};
    if (const sinew_error error = c::read_struct(step, outcome)) return error;
    if (outcome.ops == nullptr || (outcome.events == nullptr && outcome.event_room > 0)) return SINEW_NULL_ARGUMENT;
    PoseProgram program;
    GraphStep own;
    const ErrorCode code =
        run(UpdateGraphJob{.graph = &graph->definition,
                           .clips = &clips->set,
                           .parameters = {parameters, parameter_count},
                           .state = bytes_of(state, state_bytes),
                           .dt_s = dt_s,
                           .program = &program,
                           .events = {reinterpret_cast<GraphEvent*>(outcome.events), outcome.event_room},
                           .step = &own});
    if (code != ErrorCode::ok) return c::error_from(code);
    std::memcpy(outcome.ops, program.ops().data(), program.ops().size_bytes());
    for (std::size_t e = 0; e < own.event_count; ++e) turn_into_event_of_c(outcome.events[e]);
    outcome.op_count = program.ops().size();
    outcome.event_count = own.event_count;
    outcome.events_left_out = own.events_left_out;
    outcome.transitions_left_out = own.transitions_left_out ? 1 : 0;
    c::copy_bytes(own.root_motion, outcome.root_motion);
    c::copy_bytes(own.root_place, outcome.root_place);
    return c::write_struct(outcome, step);
  });
}

sinew_error sinew_graph_set_trigger(const sinew_graph* graph, void* state, std::size_t state_bytes,
                                    std::uint32_t parameter, int on) {
  return c::call(c::given(graph, state), [&] {
    const std::span<std::byte> bytes = bytes_of(state, state_bytes);
    return on != 0 ? set_trigger(graph->definition, bytes, graph_index(parameter))
                   : reset_trigger(graph->definition, bytes, graph_index(parameter));
  });
}

sinew_error sinew_graph_request_state(const sinew_graph* graph, void* state, std::size_t state_bytes,
                                      std::uint32_t node, std::uint32_t target) {
  return c::call(c::given(graph, state), [&] {
    const GraphIndex own = target == SINEW_NONE ? kNextState : graph_index(target);
    if (target != SINEW_NONE && own >= kNextState) return ErrorCode::index_out_of_range;
    return request_state(graph->definition, bytes_of(state, state_bytes), graph_index(node), own);
  });
}
