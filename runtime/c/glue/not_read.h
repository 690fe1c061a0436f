// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/c/types.h"
#include "runtime/plan/refusal.h"

namespace sinew::c {

/// Why a C value was refused. `where` names the place and the rule. `where.error` is not used, since some C codes have
/// no C++ counterpart.
struct [[nodiscard]] NotRead {
  sinew_error error = SINEW_OK;
  Refusal where;
};

/// If `where` has no rule, the description of the code becomes its rule.
inline NotRead refuse(sinew_error error, Refusal where) noexcept {
  if (where.rule == nullptr) where.rule = sinew_describe(error);
  return {error, where};
}

}  // namespace sinew::c
