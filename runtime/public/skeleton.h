// SPDX-License-Identifier: MIT
#pragma once
/// The skeleton: all nodes of a file, parents before children, each with its transform at rest.
///
///     if (const auto hand = scene.skeleton.find("RightHand")) attach_sword(*hand);
///     const bool same_rig = skeleton_signature(walk.skeleton) == skeleton_signature(knight.skeleton);
#include "runtime/animation/skeleton.h"
#include "runtime/animation/skeleton_signature.h"
#include "runtime/base/index.h"
