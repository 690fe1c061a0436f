// SPDX-License-Identifier: MIT
#include "runtime/plan/refusal.h"

namespace sinew {

std::string text_of(const Refusal& refusal) {
  std::string sentence = refusal.list != nullptr ? refusal.list : "";
  if (refusal.index != kNone) sentence.append("[").append(std::to_string(refusal.index)).append("]");
  if (refusal.field != nullptr) sentence.append(sentence.empty() ? "" : ".").append(refusal.field);
  return sentence.append(": ").append(refusal.rule != nullptr ? refusal.rule : describe(refusal.error));
}

}  // namespace sinew
