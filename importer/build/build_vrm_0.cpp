// SPDX-License-Identifier: MIT
#include "importer/build/build_vrm_0.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

namespace sinew {
namespace {

struct Renamed {
  std::string_view before, now;
};

/// Bone names that VRM 1.0 renamed; all others are unchanged.
constexpr Renamed kBones[] = {{"leftThumbProximal", "leftThumbMetacarpal"},
                              {"leftThumbIntermediate", "leftThumbProximal"},
                              {"rightThumbProximal", "rightThumbMetacarpal"},
                              {"rightThumbIntermediate", "rightThumbProximal"}};
constexpr Renamed kPresets[] = {{"joy", "happy"},
                                {"angry", "angry"},
                                {"sorrow", "sad"},
                                {"fun", "relaxed"},
                                {"a", "aa"},
                                {"i", "ih"},
                                {"u", "ou"},
                                {"e", "ee"},
                                {"o", "oh"},
                                {"blink", "blink"},
                                {"blink_l", "blinkLeft"},
                                {"blink_r", "blinkRight"},
                                {"lookup", "lookUp"},
                                {"lookdown", "lookDown"},
                                {"lookleft", "lookLeft"},
                                {"lookright", "lookRight"},
                                {"neutral", "neutral"}};

std::string_view renamed(std::string_view name, std::span<const Renamed> table) {
  const auto found = std::find_if(table.begin(), table.end(), [&](const Renamed& r) { return r.before == name; });
  return found == table.end() ? std::string_view() : found->now;
}

/// Reads an object {x, y, z}.
glm::vec3 vector_in(const ExtensionFields& owner, const char* field, glm::vec3 fallback = glm::vec3(0.0f)) {
  const ExtensionFields v = owner.object(field);
  return {static_cast<float>(v.number("x", static_cast<double>(fallback.x))),
          static_cast<float>(v.number("y", static_cast<double>(fallback.y))),
          static_cast<float>(v.number("z", static_cast<double>(fallback.z)))};
}

class Vrm0Reader {
 public:
  Vrm0Reader(const gltf::Document& document, const JointOrder& order, const std::vector<std::uint32_t>& instances,
             IssueLog& log, VrmCharacter& out)
      : document_(document), order_(order), instance_of_node_(instances), log_(log), out_(out) {}

  void read(const ExtensionFields& vrm) {
    const ExtensionFields meta = vrm.object("meta");
    out_.version = vrm.text("specVersion");
    if (out_.version.empty()) out_.version = "0.0";
    out_.name = meta.text("title");
    out_.authors = meta.text("author");
    out_.licence = meta.text("licenseName");
    for (const auto& bone : vrm.object("humanoid").list("humanBones")) add_bone(bone);
    for (const auto& group : vrm.object("blendShapeMaster").list("blendShapeGroups")) add_expression(group);
    read_look_at(vrm.object("firstPerson"));
    const ExtensionFields secondary = vrm.object("secondaryAnimation");
    for (const auto& group : secondary.list("colliderGroups")) add_colliders(group);
    for (const auto& group : secondary.list("boneGroups")) add_springs(group);
  }

 private:
  /// The joint of a node field; kNone if absent or -1.
  std::uint32_t joint_in(const ExtensionFields& owner, const char* field) const {
    if (owner.number(field, -1.0) < 0.0) return kNone;
    const std::uint32_t node = owner.index(field, document_.nodes.size());
    return node == kNone ? kNone : order_.joint_of_node[node];
  }

  bool takes(std::size_t more, const ExtensionFields& place) {
    entries_ += more;
    if (entries_ <= kMostVrmEntries) return true;
    log_.report(Rule::memory_budget, place.place(), "more entries in all than the importer allows");
    return false;
  }

  void add_bone(const ExtensionFields& bone) {
    const std::string name = bone.text("bone");
    const std::string_view now = renamed(name, kBones);
    const std::uint32_t joint = joint_in(bone, "node");
    if (joint != kNone) out_.bones.push_back({now.empty() ? name : std::string(now), joint});
  }

  void add_expression(const ExtensionFields& group) {
    std::string preset = group.text("presetName");
    for (char& c : preset) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    const std::string_view now = renamed(preset, kPresets);
    VrmExpression expression{
        now.empty() ? group.text("name") : std::string(now), !now.empty(), group.boolean("isBinary", false), {}};
    for (const auto& bind : group.list("binds")) {
      const std::uint32_t mesh = bind.index("mesh", document_.meshes.size());
      const auto target = static_cast<std::uint32_t>(bind.number("index", 0.0, 0.0, 4294967294.0));
      const auto weight = static_cast<float>(bind.number("weight", 100.0, 0.0, 100.0) / 100.0);
      if (mesh == kNone) continue;
      for (std::size_t n = 0; n < document_.nodes.size(); ++n)
        if (static_cast<std::uint32_t>(document_.nodes[n].mesh) == mesh && instance_of_node_[n] != kNone) {
          if (!takes(1, group)) return;
          expression.morphs.push_back({instance_of_node_[n], target, weight});
        }
    }
    out_.expressions.push_back(std::move(expression));
  }

  void read_look_at(const ExtensionFields& person) {
    const std::string kind = person.text("lookAtTypeName");
    using Kind = VrmLookAt::Kind;
    out_.look_at.kind = kind == "Bone" ? Kind::bones : kind == "BlendShape" ? Kind::expressions : Kind::none;
    out_.look_at.offset_from_head_m = vector_in(person, "firstPersonBoneOffset", out_.look_at.offset_from_head_m);
    out_.look_at.offset_from_head_m.z *= -1.0f;  // Unity's axes, as those of colliders
    const double output = out_.look_at.kind == Kind::expressions ? 1.0 : 10.0;
    const auto read = [&](const char* name, VrmLookAt::Range& range) {  // the curves of VRM 0 are taken as lines
      const ExtensionFields fields = person.object(name);
      range.most_input_deg = static_cast<float>(fields.number("xRange", 90.0, 0.0));
      range.output = static_cast<float>(fields.number("yRange", output));
    };
    read("lookAtHorizontalInner", out_.look_at.inner);
    read("lookAtHorizontalOuter", out_.look_at.outer);
    read("lookAtVerticalDown", out_.look_at.down);
    read("lookAtVerticalUp", out_.look_at.up);
  }

  void add_colliders(const ExtensionFields& group) {
    const std::uint32_t joint = joint_in(group, "node");
    auto& members = groups_.emplace_back();
    for (const auto& collider : group.list("colliders")) {
      if (joint == kNone) continue;
      glm::vec3 offset = vector_in(collider, "offset");
      offset.z = -offset.z;
      members.push_back(static_cast<std::uint32_t>(out_.colliders.size()));
      VrmCollider& sphere = out_.colliders.emplace_back();
      sphere.joint = joint;
      sphere.offset_m = offset;
      sphere.radius_m = static_cast<float>(collider.number("radius", 0.0, 0.0));
    }
  }

  void add_springs(const ExtensionFields& group) {
    VrmSpring spring;
    spring.name = group.text("comment");
    spring.center = joint_in(group, "center");
    for (const std::uint32_t g : group.indices("colliderGroups", groups_.size())) {
      if (!takes(groups_[g].size(), group)) return;
      spring.colliders.insert(spring.colliders.end(), groups_[g].begin(), groups_[g].end());
    }
    VrmSpringJoint joint;
    joint.hit_radius_m = static_cast<float>(group.number("hitRadius", 0.0, 0.0));
    // This misspelling is part of the file format.
    joint.stiffness = static_cast<float>(group.number("stiffiness", 1.0, 0.0));
    joint.gravity_power = static_cast<float>(group.number("gravityPower", 0.0));
    joint.drag_force = static_cast<float>(group.number("dragForce", 0.5, 0.0));
    joint.gravity_direction = vector_in(group, "gravityDir", joint.gravity_direction);
    for (const std::uint32_t node : group.indices("bones", document_.nodes.size())) {
      if (!takes(1 + spring.colliders.size() + spring.name.size() / 64, group)) return;
      joint.joint = order_.joint_of_node[node];
      spring.joints = {joint};
      out_.springs.push_back(spring);
    }
  }

  const gltf::Document& document_;
  const JointOrder& order_;
  const std::vector<std::uint32_t>& instance_of_node_;
  IssueLog& log_;
  VrmCharacter& out_;
  std::vector<std::vector<std::uint32_t>> groups_;  ///< [groups] indices of its colliders
  std::size_t entries_ = 0;
};

}  // namespace

void read_vrm_0(const ExtensionFields& vrm, const gltf::Document& document, const JointOrder& order,
                const std::vector<std::uint32_t>& instance_of_node, VrmCharacter& out) {
  Vrm0Reader(document, order, instance_of_node, vrm.log(), out).read(vrm);
}

}  // namespace sinew
