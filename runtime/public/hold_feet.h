// SPDX-License-Identifier: MIT
#pragma once
/// Feet that stay on the ground after retargeting: where the source's foot stands, the target's foot stands. For
/// animations when they are baked, and as a job for poses while they play. measure_foot_slide says how far feet slide
/// in an animation.
///
///     const sinew::FeetMap feet = make_feet_map(map, actor.skeleton, knight.skeleton);
///     hold_feet(feet, actor.animations[0], actor.skeleton, knight.skeleton, walk);
#include "runtime/retarget/feet_map.h"
#include "runtime/retarget/hold_feet.h"
