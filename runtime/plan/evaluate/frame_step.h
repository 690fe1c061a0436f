// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/plan/evaluate/frame_work.h"
#include "runtime/plan/frame_memory.h"
#include "runtime/plan/reuse/reuse.h"

namespace sinew {

/// Memory and tables of a frame that is being evaluated.
struct FrameStep {
  FrameMemory memory;
  const Reuse& reuse;
  const FrameTables& tables;  ///< tables in `memory`
  bool past_caches = false;   ///< as FrameBuffer::write_past_caches
};

}  // namespace sinew
