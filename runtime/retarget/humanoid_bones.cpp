// SPDX-License-Identifier: MIT
#include "runtime/retarget/humanoid_bones.h"

#include <algorithm>
#include <string>

#include "runtime/animation/side_names.h"
#include "runtime/retarget/name_words.h"

namespace sinew {
namespace {

/// The words of a name that denote a body part, joined. Sides, prefixes of tools and numbers are dropped.
std::string part_of(std::string_view name) {
  static constexpr std::string_view kNoParts[] = {"left", "right", "l",    "r", "c",         "j", "b",    "bip", "def",
                                                  "org",  "cc",    "base", "f", "mixamorig", "",  "bone", "bend"};
  std::string part;
  for (std::string word : name_words(name)) {
    for (const std::string_view side : {"left", "right"})
      if (word.size() > side.size() && word.starts_with(side)) word.erase(0, side.size());
    if (std::find(std::begin(kNoParts), std::end(kNoParts), word) == std::end(kNoParts)) part += word;
  }
  return part;
}

struct PartName {
  std::string_view part, bone;
};
constexpr PartName kCenter[] = {{"hips", "hips"}, {"pelvis", "hips"},    {"hip", "hips"},
                                {"neck", "neck"}, {"necklower", "neck"}, {"head", "head"}};
constexpr PartName kSides[] = {
    {"shoulder", "Shoulder"}, {"clavicle", "Shoulder"}, {"collar", "Shoulder"},   {"upperarm", "UpperArm"},
    {"arm", "UpperArm"},      {"shldr", "UpperArm"},    {"lowerarm", "LowerArm"}, {"forearm", "LowerArm"},
    {"hand", "Hand"},         {"upperleg", "UpperLeg"}, {"upleg", "UpperLeg"},    {"thigh", "UpperLeg"},
    {"lowerleg", "LowerLeg"}, {"leg", "LowerLeg"},      {"calf", "LowerLeg"},     {"shin", "LowerLeg"},
    {"foot", "Foot"},         {"toes", "Toes"},         {"toe", "Toes"},          {"ball", "Toes"}};
constexpr PartName kFingers[] = {{"thumb", "Thumb"}, {"index", "Index"},  {"middle", "Middle"},
                                 {"ring", "Ring"},   {"pinky", "Little"}, {"little", "Little"}};

std::string on_side(Side side, std::string_view bone) {
  return (side == Side::left ? "left" : "right") + std::string(bone);
}

/// The bone that a name alone identifies; kNone for spines and fingers, which are counted.
std::uint32_t bone_by_name(const std::string& name) {
  const std::string part = part_of(name);
  const Side side = side_of(name);
  if (side == Side::none) {
    for (const PartName& known : kCenter)
      if (part == known.part) return humanoid_bone(known.bone);
    return kNone;
  }
  for (const PartName& known : kSides)
    if (part == known.part) return humanoid_bone(on_side(side, known.bone));
  return kNone;
}

bool is_below(const Skeleton& skeleton, std::uint32_t joint, std::uint32_t above) noexcept {
  while (joint != kNone && joint != above) joint = skeleton.parents[joint];
  return joint == above;
}

/// Assigns the joints between hips and neck (or head, if there is no neck).
void find_spine(const Skeleton& skeleton, std::vector<std::uint32_t>& joints) {
  const std::uint32_t hips = joints[0], neck = joints[4] != kNone ? joints[4] : joints[5];
  if (hips == kNone || neck == kNone || !is_below(skeleton, neck, hips)) return;
  std::vector<std::uint32_t> between;
  for (std::uint32_t j = skeleton.parents[neck]; j != hips; j = skeleton.parents[j]) between.insert(between.begin(), j);
  if (between.empty()) return;
  joints[1] = between.front();
  if (between.size() > 1) joints[2] = between[between.size() == 2 ? 1 : between.size() / 2];
  if (between.size() > 2) joints[3] = between.back();
}

/// Assigns the first three joints of each finger below a hand.
void find_fingers(const Skeleton& skeleton, Side side, std::vector<std::uint32_t>& joints) {
  const std::uint32_t hand = joints[humanoid_bone(on_side(side, "Hand"))];
  if (hand == kNone) return;
  for (const PartName& finger : kFingers) {
    const bool thumb = finger.bone == "Thumb";
    std::uint32_t bone = humanoid_bone(on_side(side, finger.bone) + (thumb ? "Metacarpal" : "Proximal"));
    if (joints[bone] != kNone) continue;
    std::uint32_t last = hand, found = 0;
    for (std::uint32_t j = hand + 1; j < skeleton.joint_count() && found < 3; ++j) {
      if (part_of(skeleton.names[j]).find(finger.part) == std::string::npos || !is_below(skeleton, j, last)) continue;
      joints[bone + found++] = last = j;
    }
  }
}

}  // namespace

std::uint32_t humanoid_bone(std::string_view name) noexcept {
  const auto found = std::find(kHumanoidBones.begin(), kHumanoidBones.end(), name);
  return found == kHumanoidBones.end() ? kNone : static_cast<std::uint32_t>(found - kHumanoidBones.begin());
}

std::vector<std::uint32_t> find_humanoid_bones(const Skeleton& skeleton) {
  std::vector<std::uint32_t> joints(kHumanoidBones.size(), kNone);
  for (std::uint32_t j = 0; j < skeleton.joint_count(); ++j)
    if (const std::uint32_t bone = bone_by_name(skeleton.names[j]); bone != kNone && joints[bone] == kNone)
      joints[bone] = j;
  find_spine(skeleton, joints);
  find_fingers(skeleton, Side::left, joints);
  find_fingers(skeleton, Side::right, joints);
  return joints;
}

std::vector<std::uint32_t> humanoid_bones_of(std::span<const NamedBone> bones) {
  std::vector<std::uint32_t> joints(kHumanoidBones.size(), kNone);
  bool has_any = false;
  for (const NamedBone& bone : bones)
    if (const std::uint32_t index = humanoid_bone(bone.name); index != kNone) {
      joints[index] = bone.joint;
      has_any = true;
    }
  if (!has_any) joints.clear();
  return joints;
}

std::uint32_t find_root_joint(const Skeleton& skeleton, std::uint32_t hips) {
  std::uint32_t root = kNone;
  for (std::uint32_t j = hips; j != kNone; j = skeleton.parents[j])
    if (j != hips && part_of(skeleton.names[j]) == "root") root = j;
  return root;
}

}  // namespace sinew
