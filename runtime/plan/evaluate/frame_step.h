// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/plan/evaluate/frame_work.h"
#include "runtime/plan/frame_memory.h"
#include "runtime/plan/reuse/reuse.h"

namespace sinew {

/// A frame under evaluation.
struct FrameStep {
  FrameMemory memory;
  const Reuse& reuse;
  const FrameTables& tables;  ///< of `memory`
  bool past_caches = false;   ///< FrameBuffer::write_past_caches
};

}  // namespace sinew
