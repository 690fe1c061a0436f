// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/c/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Messages, one line each: why a file was refused, or what is unusual in it. Owned by the caller.
typedef struct sinew_messages sinew_messages;
SINEW_API size_t sinew_message_count(const sinew_messages* messages);
SINEW_API const char* sinew_message(const sinew_messages* messages,
                                    size_t i);  ///< zero-terminated; empty beyond the last
SINEW_API void sinew_messages_destroy(sinew_messages* messages);

#ifdef __cplusplus
}
#endif
