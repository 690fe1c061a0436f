// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <span>

#include "runtime/c/handles.h"
#include "runtime/c/library.h"

// Reports names that do not bind to C callers.

namespace sinew::c {

/// One line for each name; null if all names bind.
std::unique_ptr<sinew_messages> messages_of(const Unbound& unbound);

/// Adds clips to a library.
/// err  SINEW_UNSUPPORTED (if_unbound), SINEW_UNBOUND;   throws std::bad_alloc
sinew_error add_to(sinew_library& library, std::span<const Clip> clips, const ClipChannels& from,
                   std::uint32_t if_unbound, sinew_messages** unbound);

}  // namespace sinew::c
