// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <span>

#include "runtime/pose_program/program_inputs.h"

namespace sinew {

inline std::size_t version_count(const PoseProgramInputs& inputs) noexcept {
  return inputs.externals.size() + inputs.overrides.size() + inputs.procedures.size() + inputs.masks.size();
}

/// Calls `see(version)` for the version of each list entry until `see` returns false.     out  false if it returned
/// false
template <class See>
bool each_version(const PoseProgramInputs& inputs, const See& see) noexcept {
  const auto all = [&](const auto& entries) {
    return std::all_of(entries.begin(), entries.end(), [&](const auto& entry) { return see(entry.version); });
  };
  return all(inputs.externals) && all(inputs.overrides) && all(inputs.procedures) && all(inputs.masks);
}

/// True if the inputs promise the same content as the inputs whose versions are in `versions`.
inline bool has_versions(const PoseProgramInputs& inputs, std::span<const ContentVersion> versions) noexcept {
  if (version_count(inputs) != versions.size()) return false;
  auto next = versions.begin();
  return each_version(inputs, [&](ContentVersion version) { return version != 0 && version == *next++; });
}

inline void copy_versions(const PoseProgramInputs& inputs, std::span<ContentVersion> versions) noexcept {
  auto next = versions.begin();
  each_version(inputs, [&](ContentVersion version) {
    *next++ = version;
    return true;
  });
}

}  // namespace sinew
