// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/c/messages.h"
#include "runtime/c/pose_program.h"
#include "runtime/c/root_motion.h"
#include "runtime/c/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

// Motion graphs: a graph says how a character moves between clips. Characters share it, and each has a state of plain
// bytes. An update moves the state on and writes a pose program for sinew_frame_input.program.
//
//     sinew_graph_create(bytes, byte_count, &graph, &messages);           // bytes of sinew_graph_write
//     sinew_graph_clips_create(graph, clips, clip_count, NULL, &set);     // in the order of sinew_graph_name
//     sinew_graph_start(graph, set, parameters, parameter_count, state, state_bytes);
//     sinew_graph_update(graph, set, parameters, parameter_count, state, state_bytes, dt_s, &step);  // each frame

typedef struct sinew_graph sinew_graph;
typedef struct sinew_graph_clips sinew_graph_clips;

/// Creates a graph from its bytes. Any bytes may be passed; they may be freed afterwards.
/// out  messages  owned by the caller, the rule that the graph breaks; may be null. Given for SINEW_BAD_FILE only
/// err  SINEW_NULL_ARGUMENT, SINEW_BAD_FILE, SINEW_OUT_OF_MEMORY
SINEW_API sinew_error sinew_graph_create(const void* bytes, size_t byte_count, sinew_graph** out,
                                         sinew_messages** messages);
SINEW_API void sinew_graph_destroy(sinew_graph* graph);

/// Writes the bytes of a graph, for sinew_graph_create.
/// out  bytes  filled as far as it reaches; may be null if `room` is 0.   Returns the number of bytes of the graph
SINEW_API size_t sinew_graph_write(const sinew_graph* graph, void* bytes, size_t room);

typedef struct sinew_graph_info {
  size_t struct_size;
  uint32_t parameters, clips, nodes, masks;
  size_t state_bytes;  ///< of a character
  uint32_t ops;        ///< most operations of a program, at most SINEW_MOST_OPS
} sinew_graph_info;
SINEW_API sinew_error sinew_graph_get_info(const sinew_graph* graph, sinew_graph_info* out);

/// Room that the programs of a graph need, for sinew_needs.
SINEW_API sinew_error sinew_graph_get_room(const sinew_graph* graph, sinew_program_room* out);

/// Things of a graph that have names.
typedef enum sinew_graph_thing {
  SINEW_GRAPH_PARAMETER = 0,
  SINEW_GRAPH_CLIP = 1,
  SINEW_GRAPH_NODE = 2,
  SINEW_GRAPH_MASK = 3
} sinew_graph_thing;

/// The name of a thing; empty beyond the last.     in   thing  a value of sinew_graph_thing
SINEW_API sinew_string sinew_graph_name(const sinew_graph* graph, uint32_t thing, uint32_t index);
/// The index of the thing with this zero-terminated name, or SINEW_NONE.
SINEW_API uint32_t sinew_graph_find(const sinew_graph* graph, uint32_t thing, const char* name);
/// The index of a state of a machine with this zero-terminated name, or SINEW_NONE.     in   node  of the machine
SINEW_API uint32_t sinew_graph_find_state(const sinew_graph* graph, uint32_t node, const char* name);
/// Initial value of a parameter; 0 beyond the last.
SINEW_API float sinew_graph_initial(const sinew_graph* graph, uint32_t parameter);

/// Joint weights of a mask of the graph on the skeleton of a scene.
/// in   weights[joints of the scene]
/// err  SINEW_NULL_ARGUMENT, SINEW_INDEX_OUT_OF_RANGE (mask; the skeleton has no joint of a name),
///      SINEW_SIZE_MISMATCH, SINEW_OUT_OF_MEMORY
SINEW_API sinew_error sinew_graph_mask(const sinew_graph* graph, uint32_t mask, const sinew_scene* scene,
                                       float* weights, size_t count);

/// The start of a beat: a foot that touches the ground. Blend spaces and transitions keep motions in step by beats.
typedef struct sinew_graph_beat {
  double phase;   ///< [0, 1) of the clip
  uint32_t name;  ///< any number; equal numbers are the same foot
} sinew_graph_beat;

/// The clip that a character plays for one of its graph's clip names.
typedef struct sinew_graph_clip {
  size_t struct_size;
  uint32_t clip;                  ///< index in the plan
  double duration_s;              ///< at most 6000
  sinew_doubles event_times_s;    ///< never decreasing, within the clip
  const sinew_root_track* root;   ///< null: the clip does not move the character. It is copied
  const sinew_graph_beat* beats;  ///< phases increase
  size_t beat_count;
  uint32_t root_in_pose;  ///< 1: the pose contains the motion of `root`; 0: it plays on the spot
} sinew_graph_clip;

/// Binds clips to the clip names of a graph, for all characters that play the same motions.
/// in   clips[clips of the graph];   mirrored_beats  [names of beats] the mirrored name of each, for clips that play
///      mirrored; may be null
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE, SINEW_SIZE_MISMATCH (fewer clips than the graph has), and as
///      GraphClipSet::make: SINEW_NOT_FINITE, SINEW_TOO_LARGE, SINEW_TIMES_NOT_INCREASING, SINEW_INDEX_OUT_OF_RANGE;
///      SINEW_OUT_OF_MEMORY
SINEW_API sinew_error sinew_graph_clips_create(const sinew_graph* graph, const sinew_graph_clip* clips, size_t count,
                                               const sinew_indices* mirrored_beats, sinew_graph_clips** out);
SINEW_API void sinew_graph_clips_destroy(sinew_graph_clips* clips);

/// Writes the start state of a character.
/// in   parameters[parameters of the graph];   state  8-byte aligned, sinew_graph_info.state_bytes. A copy of the bytes
///      saves it, and copying them back restores it
/// err  SINEW_NULL_ARGUMENT, SINEW_SIZE_MISMATCH, SINEW_NOT_FINITE
SINEW_API sinew_error sinew_graph_start(const sinew_graph* graph, const sinew_graph_clips* clips,
                                        const float* parameters, size_t parameter_count, void* state,
                                        size_t state_bytes);

/// An event of an update.
typedef struct sinew_graph_event {
  double time_s;   ///< on the clock of the graph, which starts at 0
  uint32_t node;   ///< node that plays the clip, or the machine
  uint32_t clip;   ///< clip of the graph; SINEW_NONE: the machine has entered a state
  uint32_t index;  ///< of the clip's event, or of the state
  float weight;    ///< of the clip in the pose
} sinew_graph_event;

/// Memory of the caller for an update, and its outcome.
typedef struct sinew_graph_step {
  size_t struct_size;
  sinew_pose_op* ops;         ///< in: [SINEW_MOST_OPS]
  sinew_graph_event* events;  ///< in: [event_room], may be null if that is 0
  size_t event_room;          ///< in
  size_t op_count, event_count;
  uint64_t events_left_out;       ///< there was no room
  sinew_dual_quat root_motion;    ///< world = sinew_dual_quat_product(world, root_motion)
  sinew_dual_quat root_place;     ///< sinew_frame_input.root: world times the inverse of root_place
  uint32_t transitions_left_out;  ///< 1: an update takes at most 16,384 transitions
} sinew_graph_step;

/// Plays a character for a time step, of any sign, and writes the program of its pose. Results do not depend on how
/// time is cut into steps.
/// in   dt_s  from -3600 to 3600
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE, SINEW_SIZE_MISMATCH, SINEW_WRONG_PLAN (a state of another graph),
///      SINEW_NOT_FINITE, SINEW_TOO_LARGE. After an error the state is as before
/// cost as UpdateGraphJob, no allocation
SINEW_API sinew_error sinew_graph_update(const sinew_graph* graph, const sinew_graph_clips* clips,
                                         const float* parameters, size_t parameter_count, void* state,
                                         size_t state_bytes, double dt_s, sinew_graph_step* step);

/// Sets a trigger, or takes it back if `on` is 0. It stays set until a transition uses it up.
/// err  SINEW_NULL_ARGUMENT, SINEW_INDEX_OUT_OF_RANGE (no trigger), SINEW_WRONG_PLAN
SINEW_API sinew_error sinew_graph_set_trigger(const sinew_graph* graph, void* state, size_t state_bytes,
                                              uint32_t parameter, int on);
/// Makes a machine enter a state at the next update, whatever its conditions.
/// in   node  of the machine;   target  index of a state, or SINEW_NONE: that of its most urgent transition
/// err  SINEW_NULL_ARGUMENT, SINEW_INDEX_OUT_OF_RANGE, SINEW_WRONG_PLAN
SINEW_API sinew_error sinew_graph_request_state(const sinew_graph* graph, void* state, size_t state_bytes,
                                                uint32_t node, uint32_t target);

#ifdef __cplusplus
}
#endif
