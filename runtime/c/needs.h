// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/c/handles.h"

namespace sinew::c {

/// Converts the needs of a C caller to those of the runtime.
/// in   given  null = sinew_default_needs
/// err  the errors of sinew_plan_create for the needs; may throw std::bad_alloc
sinew_error read_needs(const sinew_needs* given, const Scene& scene, Needs& needs);

}  // namespace sinew::c
