// SPDX-License-Identifier: MIT
#include "importer/vrm_look_at.h"

#include <cstddef>
#include <numbers>
#include <string_view>
#include <utility>

namespace sinew {
namespace {

std::uint32_t bone_called(const VrmCharacter& vrm, std::string_view name) noexcept {
  for (const NamedBone& bone : vrm.bones)
    if (bone.name == name) return bone.joint;
  return kNone;
}

}  // namespace

std::optional<EyesSetup> eyes_of(const VrmCharacter& vrm) {
  using Kind = VrmLookAt::Kind;
  const VrmLookAt& from = vrm.look_at;
  EyesSetup eyes;
  eyes.head = bone_called(vrm, "head");
  if (from.kind == Kind::none || eyes.head == kNone) return std::nullopt;
  const bool turns_joints = from.kind == Kind::bones;
  eyes.kind = turns_joints ? EyeKind::joints : EyeKind::weights;
  if (turns_joints) {
    eyes.left = bone_called(vrm, "leftEye");
    eyes.right = bone_called(vrm, "rightEye");
  }
  eyes.between_eyes_m = from.offset_from_head_m;
  if (vrm.version.starts_with('0')) eyes.forward = {0.0f, 0.0f, -1.0f};
  constexpr float kRadians = std::numbers::pi_v<float> / 180.0f;
  const auto range = [&](const VrmLookAt::Range& r) {
    return GazeRange{r.most_input_deg * kRadians, r.output * (turns_joints ? kRadians : 1.0f)};
  };
  eyes.inner = range(from.inner);
  eyes.outer = range(from.outer);
  eyes.down = range(from.down);
  eyes.upward = range(from.up);
  return eyes;
}

LookExpressions look_expressions_of(const VrmCharacter& vrm) {
  LookExpressions out;
  const std::pair<std::string_view, std::uint32_t*> presets[] = {
      {"lookLeft", &out.left}, {"lookRight", &out.right}, {"lookUp", &out.up}, {"lookDown", &out.down}};
  for (std::size_t e = 0; e < vrm.expressions.size(); ++e)
    for (const auto& [name, index] : presets)
      if (vrm.expressions[e].is_preset && vrm.expressions[e].name == name) *index = static_cast<std::uint32_t>(e);
  return out;
}

void set_look_values(const LookExpressions& of, const Gaze& gaze, std::span<float> values) noexcept {
  const auto set = [&](std::uint32_t expression, float weight) {
    if (expression < values.size()) values[expression] = weight;
  };
  set(of.left, gaze.left);
  set(of.right, gaze.right);
  set(of.up, gaze.up);
  set(of.down, gaze.down);
}

}  // namespace sinew
