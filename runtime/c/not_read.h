// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/c/types.h"
#include "runtime/plan/refusal.h"

namespace sinew::c {

/// Why something of C was not read. `where` has the place and always a rule; its code means nothing, since some of C's
/// have no twin.
struct [[nodiscard]] NotRead {
  sinew_error error = SINEW_OK;
  Refusal where;
};

/// Without a rule of its own, the sentence of the code is the rule.
inline NotRead refuse(sinew_error error, Refusal where) noexcept {
  if (where.rule == nullptr) where.rule = sinew_describe(error);
  return {error, where};
}

}  // namespace sinew::c
