// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/c/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Why a file was refused, or what was odd about it, one line each. Owned by the caller.
typedef struct sinew_messages sinew_messages;
SINEW_API size_t sinew_message_count(const sinew_messages* messages);
SINEW_API const char* sinew_message(const sinew_messages* messages,
                                    size_t i);  ///< ended by a zero; empty beyond the last
SINEW_API void sinew_messages_destroy(sinew_messages* messages);

#ifdef __cplusplus
}
#endif
