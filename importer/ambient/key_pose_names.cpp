// SPDX-License-Identifier: MIT
#include "importer/ambient/key_pose_names.h"

#include <charconv>

#include "runtime/model/vertex_visibility.h"

namespace sinew {

std::string name_of_key_pose(const KeyPoseName& key) {
  return std::string(kAmbientVisibilityAttribute) + '_' + std::to_string(key.clip) + '_' + std::to_string(key.pose);
}

std::optional<KeyPoseName> key_pose_named(const std::string& name) {
  const std::string start = std::string(kAmbientVisibilityAttribute) + '_';
  if (name.compare(0, start.size(), start) != 0) return std::nullopt;
  KeyPoseName key;
  const char* const end = name.data() + name.size();
  const char* const behind_clip = std::from_chars(name.data() + start.size(), end, key.clip).ptr;
  if (behind_clip == end) return std::nullopt;
  std::from_chars(behind_clip + 1, end, key.pose);
  if (key.pose >= kMostKeyPoses || name != name_of_key_pose(key)) return std::nullopt;
  return key;
}

}  // namespace sinew
