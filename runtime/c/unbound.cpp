// SPDX-License-Identifier: MIT
#include "runtime/c/unbound.h"

#include <utility>

#include "runtime/c/glue/convert.h"
#include "runtime/c/glue/enums.h"

namespace sinew::c {

std::unique_ptr<sinew_messages> messages_of(const Unbound& unbound) {
  if (unbound.empty()) return nullptr;
  auto messages = std::make_unique<sinew_messages>();
  for (const std::string& name : unbound.missing) messages->lines.push_back("missing: " + name);
  for (const std::string& name : unbound.ambiguous) messages->lines.push_back("ambiguous: " + name);
  return messages;
}

sinew_error add_to(sinew_library& library, std::span<const Clip> clips, const ClipChannels& from,
                   std::uint32_t if_unbound, sinew_messages** unbound) {
  IfUnbound rule = IfUnbound::leave_out;
  if (const sinew_error error = from_c(if_unbound, rule)) return error;
  ClipLibrary grown = library.clips;  // a copy, so that an exception leaves the library unchanged
  const Unbound found = grown.add(clips, from, rule);
  auto lines = messages_of(found);
  library.clips = std::move(grown);
  if (unbound != nullptr) *unbound = lines.release();
  return rule == IfUnbound::refuse && !found.empty() ? SINEW_UNBOUND : SINEW_OK;
}

}  // namespace sinew::c
