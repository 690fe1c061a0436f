// SPDX-License-Identifier: MIT
#pragma once
/// Left and right swapped. make_mirror_map pairs the joints of a skeleton once. The map then mirrors animations when
/// they are made, poses while they play, and layers of a frame (Needs::in.mirror, ClipLayer::mirrored).
///
///     const sinew::MirrorMap map = make_mirror_map(scene);
///     const sinew::Animation left_handed = mirror_animation(throw_ball, map, scene.skeleton, scene.first_weight);
#include "runtime/animation/mirror_animation.h"
#include "runtime/animation/mirror_map.h"
#include "runtime/animation/side_names.h"
#include "runtime/model/bind_pose.h"
#include "runtime/model/mirror_scene.h"
#include "runtime/pose/mirror_pose.h"
