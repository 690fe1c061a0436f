// SPDX-License-Identifier: MIT
#include "runtime/c/messages.h"

#include "runtime/c/handles.h"

std::size_t sinew_message_count(const sinew_messages* messages) {
  return messages != nullptr ? messages->lines.size() : 0;
}

const char* sinew_message(const sinew_messages* messages, std::size_t i) {
  return i < sinew_message_count(messages) ? messages->lines[i].c_str() : "";
}

void sinew_messages_destroy(sinew_messages* messages) { delete messages; }
