// SPDX-License-Identifier: MIT
#pragma once
/// Time: clocks that loop, clamp or swing, events that a step crosses, curves of an engine's own values with triggers,
/// and the motion of the root. Frames know nothing of it: a clock gives ClipLayer::time_s, and root motion moves
/// FrameInput::root.
///
///     sinew::PlaybackClock clock(clip.duration_s());
///     const sinew::PlaybackStep step = clock.advance(frame_s);
///     sinew::EventCursor events(step, step_sounds_s);
///     while (const auto event = events.next()) play_sound(*event);
#include "runtime/playback/curve.h"
#include "runtime/playback/curve_edges.h"
#include "runtime/playback/event_cursor.h"
#include "runtime/playback/playback_clock.h"
#include "runtime/playback/root_motion.h"
#include "runtime/playback/root_track.h"
