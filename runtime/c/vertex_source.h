// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/c/frame.h"
#include "runtime/c/glue/convert.h"
#include "runtime/plan/vertex_source.h"

namespace sinew::c {

/// C carries sources without looking inside.
template <>
struct Convert<sinew_vertex_source, VertexSource> : ConvertInside<sinew_vertex_source, VertexSource> {};

}  // namespace sinew::c
