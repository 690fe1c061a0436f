// SPDX-License-Identifier: MIT
#include "importer/tool/vrm/vrm_info.h"

#include <fmt/core.h>

#include "importer/tool/messages.h"
#include "importer/visible_text.h"

namespace sinew::tool {
namespace {

constexpr const char* kLookAt[] = {"", "bones", "expressions"};
constexpr const char* kColliders[] = {"sphere", "capsule", "plane"};
constexpr const char* kConstraints[] = {"roll", "aim", "rotation"};

template <class Kind, std::size_t N>
const char* word(Kind kind, const char* const (&words)[N]) {
  return words[static_cast<std::size_t>(kind)];
}

Json node_or_null(const Scene& scene, std::uint32_t joint) {
  return joint < scene.skeleton.node_of_joint.size() ? Json(scene.skeleton.node_of_joint[joint]) : Json(nullptr);
}

Json expression_json(const VrmExpression& expression, const Scene& scene) {
  Json morphs = Json::array();
  for (const VrmMorphBind& bind : expression.morphs)
    morphs.push_back({{"node", node_or_null(scene, scene.instances[bind.instance].joint)},
                      {"target", bind.target},
                      {"weight", bind.weight}});
  return {{"name", expression.name},
          {"preset", expression.is_preset},
          {"binary", expression.is_binary},
          {"morphs", std::move(morphs)}};
}

Json spring_json(const VrmSpring& spring, const Scene& scene) {
  Json joints = Json::array();
  for (const VrmSpringJoint& joint : spring.joints) joints.push_back(node_or_null(scene, joint.joint));
  return {{"name", spring.name}, {"nodes", std::move(joints)}, {"colliders", spring.colliders.size()}};
}

std::string quoted(const Json& name) { return in_quotes(name.get<std::string>()); }

}  // namespace

Json vrm_json(const VrmCharacter& vrm, const Scene& scene) {
  Json out{{"version", vrm.version},
           {"name", vrm.name},
           {"authors", vrm.authors},
           {"animation", vrm.is_animation},
           {"look_at", word(vrm.look_at.kind, kLookAt)},
           {"bones", Json::object()},
           {"expressions", Json::array()},
           {"colliders", Json::array()},
           {"springs", Json::array()},
           {"constraints", Json::array()}};
  for (const NamedBone& bone : vrm.bones) out["bones"][bone.name] = node_or_null(scene, bone.joint);
  for (const auto& expression : vrm.expressions) out["expressions"].push_back(expression_json(expression, scene));
  for (const VrmCollider& collider : vrm.colliders)
    out["colliders"].push_back({{"node", node_or_null(scene, collider.joint)},
                                {"shape", word(collider.kind, kColliders)},
                                {"radius_m", collider.radius_m}});
  for (const VrmSpring& spring : vrm.springs) out["springs"].push_back(spring_json(spring, scene));
  for (const VrmConstraint& constraint : vrm.constraints)
    out["constraints"].push_back({{"node", node_or_null(scene, constraint.joint)},
                                  {"source", node_or_null(scene, constraint.source)},
                                  {"kind", word(constraint.kind, kConstraints)},
                                  {"weight", constraint.weight}});
  return out;
}

std::string vrm_text(const Json& vrm) {
  std::string out = fmt::format("VRM {}{}: {} humanoid bones", visible_text(vrm["version"].get<std::string>()),
                                vrm["animation"].get<bool>() ? " animation" : "", vrm["bones"].size());
  if (!vrm["name"].get<std::string>().empty()) out += fmt::format(", {}", quoted(vrm["name"]));
  if (!vrm["authors"].get<std::string>().empty()) out += fmt::format(" by {}", quoted(vrm["authors"]));
  if (!vrm["look_at"].get<std::string>().empty())
    out += fmt::format(", looks with {}", vrm["look_at"].get<std::string>());
  out += '\n';
  if (!vrm["expressions"].empty()) {
    out += "  expressions:";
    for (const Json& expression : vrm["expressions"])
      out += fmt::format(" {} ({})", quoted(expression["name"]), counted(expression["morphs"].size(), "morph"));
    out += '\n';
  }
  std::size_t swinging = 0;
  for (const Json& spring : vrm["springs"]) swinging += spring["nodes"].size();
  if (!vrm["springs"].empty())
    out += fmt::format("  springs: {} with {}, {}\n", vrm["springs"].size(), counted(swinging, "joint"),
                       counted(vrm["colliders"].size(), "collider"));
  for (const Json& constraint : vrm["constraints"])
    out += fmt::format("  constraint: node {} follows node {} ({}, weight {})\n", constraint["node"].dump(),
                       constraint["source"].dump(), constraint["kind"].get<std::string>(), constraint["weight"].dump());
  return out;
}

}  // namespace sinew::tool
