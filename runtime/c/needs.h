// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/c/handles.h"

namespace sinew::c {

/// The needs of a C caller as the runtime takes them.
/// in   given  null = sinew_default_needs
/// err  the errors of sinew_plan_create for the needs; may throw std::bad_alloc
sinew_error read_needs(const sinew_needs* given, const Scene& scene, Needs& needs);

}  // namespace sinew::c
