// SPDX-License-Identifier: MIT
#include "runtime/c/unbound.h"

#include <utility>

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
  if (if_unbound > SINEW_REFUSE) return SINEW_UNSUPPORTED;
  ClipLibrary grown = library.clips;  // what throws leaves the library as it was
  const Unbound found = grown.add(clips, from, static_cast<IfUnbound>(if_unbound));
  auto lines = messages_of(found);
  library.clips = std::move(grown);
  if (unbound != nullptr) *unbound = lines.release();
  return if_unbound == SINEW_REFUSE && !found.empty() ? SINEW_UNBOUND : SINEW_OK;
}

}  // namespace sinew::c
