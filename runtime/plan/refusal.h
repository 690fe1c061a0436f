// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>

#include "runtime/base/api.h"
#include "runtime/base/index.h"
#include "runtime/base/result.h"

namespace sinew {

/// The first rule that an input breaks, and its place: `list`[index].`field`. Parts of the place that do not apply are
/// null or kNone.
struct Refusal {
  ErrorCode error = ErrorCode::ok;
  const char* field = nullptr;  ///< null: the rule is about the list as a whole
  const char* rule = nullptr;   ///< the rule in words; null: describe(error) says it
  const char* list = nullptr;
  std::uint32_t index = kNone;
};

// Rules that the C interface checks as well.
inline constexpr const char* kNotEachWeight = "not one for each morph weight of the scene";
inline constexpr const char* kNotEachSource = "not one for each of the needs' cached instances";
inline constexpr const char* kLongerThanNeeds = "longer than the needs declare";
inline constexpr const char* kNoUpdates = "the needs declare no frames between updates";

/// The sentence of why_refused: "layers[1].weight: a weight is below 0".
SINEW_API std::string text_of(const Refusal& refusal);

}  // namespace sinew
