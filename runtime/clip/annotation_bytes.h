// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/animation/annotations.h"
#include "runtime/clip/byte_stream.h"

namespace sinew {

void write_annotations(const Annotations& annotations, ByteWriter& out);

/// Reads what write_annotations wrote. The result of any other bytes may be one that check(Annotations) refuses.
Annotations read_annotations(ByteReader& in);

}  // namespace sinew
