// SPDX-License-Identifier: MIT
#pragma once
// The C interface of the runtime, for C and C++. Files are read by sinew_assets.h, sinew_geometry.h and
// sinew_import.h.
#include "runtime/c/clips.h"
#include "runtime/c/cut_frame.h"
#include "runtime/c/frame.h"
#include "runtime/c/ik.h"
#include "runtime/c/jobs.h"
#include "runtime/c/library.h"
#include "runtime/c/messages.h"
#include "runtime/c/mirror.h"
#include "runtime/c/pages.h"
#include "runtime/c/plan.h"
#include "runtime/c/playback.h"
#include "runtime/c/pose.h"
#include "runtime/c/pose_program.h"
#include "runtime/c/result.h"
#include "runtime/c/retarget.h"
#include "runtime/c/root_motion.h"
#include "runtime/c/scene.h"
#include "runtime/c/skeleton_lod.h"
#include "runtime/c/types.h"
#include "runtime/c/update_levels.h"
