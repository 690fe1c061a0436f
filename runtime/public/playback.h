// SPDX-License-Identifier: MIT
#pragma once
/// Playback outside of frames. PlaybackClock advances clip times (loop, clamp, ping-pong), and EventCursor finds the
/// events that a step of the clock crosses. BlendedEvents does so for all clips of a fade or a pose program, with their
/// weights. A curve gives an engine a number for each time of a clip, for example the width of a trail; find_edges
/// makes events where it passes a threshold. Root motion moves FrameInput::root, and a clock gives ClipLayer::time_s.
///
///     sinew::PlaybackClock clock(clip.duration_s());
///     const sinew::PlaybackStep step = clock.advance(frame_s);
///     sinew::EventCursor events(step, step_sounds_s);
///     while (const auto event = events.next()) play_sound(*event);
#include "runtime/animation/curve.h"
#include "runtime/playback/blend_curves.h"
#include "runtime/playback/blended_events.h"
#include "runtime/playback/curve_edges.h"
#include "runtime/playback/event_cursor.h"
#include "runtime/playback/playback_clock.h"
#include "runtime/playback/root_motion.h"
#include "runtime/playback/root_track.h"
