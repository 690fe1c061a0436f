// SPDX-License-Identifier: MIT
#pragma once
/// Clips of many files, bound by names to one skeleton, and to every model on that skeleton. Names without a partner
/// are listed.
///
///     sinew::ClipLibrary library(knight.skeleton);
///     const sinew::Unbound left_out = library.add(walks);
///     const sinew::Plan plan = compile_plan(lend(knight), clips_for(library, knight).clips, needs);
#include "runtime/library/bind_clips.h"
#include "runtime/library/clip_channels.h"
#include "runtime/library/clip_library.h"
