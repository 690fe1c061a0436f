// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/c/frame.h"
#include "runtime/c/glue/convert.h"
#include "runtime/plan/vertex_source.h"

namespace sinew::c {

/// C callers pass vertex sources on as opaque bytes.
template <>
struct Convert<sinew_vertex_source, VertexSource> : ConvertInside<sinew_vertex_source, VertexSource> {};

}  // namespace sinew::c
