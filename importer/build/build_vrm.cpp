// SPDX-License-Identifier: MIT
#include "importer/build/build_vrm.h"

#include <string>
#include <utility>

#include "importer/build/build_vrm_0.h"
#include "importer/file/json_pointer.h"
#include "importer/read/extension_fields.h"

namespace sinew {
namespace {

class VrmReader {
 public:
  VrmReader(const gltf::Document& document, const JointOrder& order, const std::vector<std::uint32_t>& instances,
            IssueLog& log, VrmCharacter& out)
      : document_(document), order_(order), instance_of_node_(instances), log_(log), out_(out) {}

  void read_character(const ExtensionFields& vrm) {
    out_.version = vrm.text("specVersion");
    out_.name = vrm.object("meta").text("name");
    out_.licence = vrm.object("meta").text("licenseUrl");
    read_bones(vrm);
    for (const bool preset : {true, false})
      for (const auto& [name, expression] : vrm.object("expressions").object(preset ? "preset" : "custom").members())
        add_expression(name, preset, expression);
    const ExtensionFields look = vrm.object("lookAt");
    const std::string kind = look.text("type");
    using Kind = VrmLookAt::Kind;
    out_.look_at.kind = kind == "bone" ? Kind::bones : kind == "expression" ? Kind::expressions : Kind::none;
    look.numbers("offsetFromHeadBone", &out_.look_at.offset_from_head_m.x, 3);
    const double output = out_.look_at.kind == Kind::expressions ? 1.0 : 10.0;
    const auto read = [&](const char* name, VrmLookAt::Range& range) {
      const ExtensionFields fields = look.object(name);
      range.most_input_deg = static_cast<float>(fields.number("inputMaxValue", 90.0, 0.0));
      range.output = static_cast<float>(fields.number("outputScale", output));
    };
    read("rangeMapHorizontalInner", out_.look_at.inner);
    read("rangeMapHorizontalOuter", out_.look_at.outer);
    read("rangeMapVerticalDown", out_.look_at.down);
    read("rangeMapVerticalUp", out_.look_at.up);
  }

  void read_animation(const ExtensionFields& animation) {
    out_.version = animation.text("specVersion");
    out_.is_animation = true;
    read_bones(animation);
    for (const bool preset : {true, false})
      for (const auto& [name, at] : animation.object("expressions").object(preset ? "preset" : "custom").members()) {
        VrmExpression& expression = out_.expressions.emplace_back();
        expression.name = name;
        expression.is_preset = preset;
        expression.value_joint = joint_in(at, "node");
      }
    out_.look_at.gaze_joint = joint_in(animation.object("lookAt"), "node");
  }

  void read_springs(const ExtensionFields& extension) {
    if (out_.version.empty()) out_.version = extension.text("specVersion");
    for (const auto& collider : extension.list("colliders")) add_collider(collider);
    for (const auto& group : extension.list("colliderGroups"))
      groups_.push_back(group.indices("colliders", out_.colliders.size()));
    for (const auto& spring : extension.list("springs"))
      if (!add_spring(spring)) return;
  }

  void read_constraint(std::uint32_t node, const ExtensionFields& extension) {
    if (out_.version.empty()) out_.version = extension.text("specVersion");
    using Kind = VrmConstraint::Kind;
    constexpr std::pair<const char*, Kind> kKinds[] = {
        {"roll", Kind::roll}, {"aim", Kind::aim}, {"rotation", Kind::rotation}};
    const ExtensionFields constraint = extension.object("constraint");
    for (const auto& [name, kind] : kKinds) {
      if (!constraint.has(name)) continue;
      const ExtensionFields fields = constraint.object(name);
      const std::uint32_t source = joint_in(fields, "source");
      if (source == kNone) continue;
      VrmConstraint& out = out_.constraints.emplace_back();
      out.kind = kind;
      out.joint = order_.joint_of_node[node];
      out.source = source;
      out.weight = static_cast<float>(fields.number("weight", 1.0, 0.0, 1.0));
      if (kind != Kind::rotation) out.axis = axis_of(fields.text(kind == Kind::roll ? "rollAxis" : "aimAxis"));
    }
  }

 private:
  /// Parses an axis such as "X", "PositiveX" or "NegativeX"; 0 for other words.
  static glm::vec3 axis_of(std::string word) {
    const bool positive = word.starts_with("Positive"), negative = word.starts_with("Negative");
    if (positive || negative) word.erase(0, 8);
    glm::vec3 axis(0.0f);
    if (word.size() == 1 && word[0] >= 'X' && word[0] <= 'Z') axis[word[0] - 'X'] = negative ? -1.0f : 1.0f;
    return axis;
  }

  std::uint32_t joint_in(const ExtensionFields& owner, const char* field) const {
    const std::uint32_t node = owner.index(field, document_.nodes.size());
    return node == kNone ? kNone : order_.joint_of_node[node];
  }

  void read_bones(const ExtensionFields& owner) {
    for (const auto& [name, bone] : owner.object("humanoid").object("humanBones").members())
      if (const std::uint32_t joint = joint_in(bone, "node"); joint != kNone) out_.bones.push_back({name, joint});
  }

  static VrmExpression::Override override_of(const std::string& word) {
    using Override = VrmExpression::Override;
    return word == "block" ? Override::block : word == "blend" ? Override::blend : Override::none;
  }

  void add_expression(const std::string& name, bool preset, const ExtensionFields& fields) {
    VrmExpression expression{name, preset, fields.boolean("isBinary", false), {}};
    expression.override_blink = override_of(fields.text("overrideBlink"));
    expression.override_look_at = override_of(fields.text("overrideLookAt"));
    expression.override_mouth = override_of(fields.text("overrideMouth"));
    for (const auto& bind : fields.list("morphTargetBinds")) {
      const std::uint32_t node = bind.index("node", document_.nodes.size());
      if (node == kNone || instance_of_node_[node] == kNone) continue;
      expression.morphs.push_back({instance_of_node_[node],
                                   static_cast<std::uint32_t>(bind.number("index", 0.0, 0.0, 4294967294.0)),
                                   static_cast<float>(bind.number("weight", 1.0, 0.0, 1.0))});
    }
    out_.expressions.push_back(std::move(expression));
  }

  /// Adds a collider; one without a usable node is added too, because colliders are referred to by index.
  void add_collider(const ExtensionFields& fields) {
    VrmCollider& out = out_.colliders.emplace_back();
    out.joint = joint_in(fields, "node");
    const ExtensionFields extended =
        fields.object("extensions").object("VRMC_springBone_extended_collider").object("shape");
    const ExtensionFields shape = extended ? extended : fields.object("shape");
    const bool capsule = shape.has("capsule"), plane = shape.has("plane");
    out.kind = plane ? VrmCollider::Kind::plane : capsule ? VrmCollider::Kind::capsule : VrmCollider::Kind::sphere;
    const ExtensionFields body = shape.object(plane ? "plane" : capsule ? "capsule" : "sphere");
    body.numbers("offset", &out.offset_m.x, 3);
    body.numbers("tail", &out.tail_m.x, 3);
    body.numbers("normal", &out.normal.x, 3);
    out.radius_m = static_cast<float>(body.number("radius", 0.0, 0.0));
    out.inside = body.boolean("inside", false);
  }

  bool add_spring(const ExtensionFields& fields) {
    VrmSpring& spring = out_.springs.emplace_back();
    spring.name = fields.text("name");
    spring.center = joint_in(fields, "center");
    for (const auto& joint : fields.list("joints")) add_spring_joint(joint, spring);
    for (const std::uint32_t g : fields.indices("colliderGroups", groups_.size())) {
      entries_ += groups_[g].size();
      if (entries_ > kMostVrmEntries) {
        log_.report(Rule::memory_budget, fields.place(), "more colliders in all springs than the importer allows");
        return false;
      }
      spring.colliders.insert(spring.colliders.end(), groups_[g].begin(), groups_[g].end());
    }
    return true;
  }

  void add_spring_joint(const ExtensionFields& fields, VrmSpring& spring) const {
    VrmSpringJoint joint;
    joint.joint = joint_in(fields, "node");
    if (joint.joint == kNone) return;
    const auto number = [&](const char* name, float fallback) {
      return static_cast<float>(fields.number(name, static_cast<double>(fallback)));
    };
    joint.hit_radius_m = number("hitRadius", joint.hit_radius_m);
    joint.stiffness = number("stiffness", joint.stiffness);
    joint.gravity_power = number("gravityPower", joint.gravity_power);
    joint.drag_force = number("dragForce", joint.drag_force);
    fields.numbers("gravityDir", &joint.gravity_direction.x, 3);
    spring.joints.push_back(joint);
  }

  const gltf::Document& document_;
  const JointOrder& order_;
  const std::vector<std::uint32_t>& instance_of_node_;
  IssueLog& log_;
  VrmCharacter& out_;
  std::vector<std::vector<std::uint32_t>> groups_;  ///< [groups] indices of its colliders
  std::size_t entries_ = 0;
};

/// The names of the authors, separated by commas.
std::string authors_of(const gltf::Json& extensions) {
  const gltf::Json::json_pointer place("/VRMC_vrm/meta/authors");
  std::string out;
  if (!extensions.contains(place) || !extensions.at(place).is_array()) return out;
  for (const gltf::Json& author : extensions.at(place))
    if (author.is_string()) out += (out.empty() ? "" : ", ") + author.get<std::string>();
  return out;
}

}  // namespace

std::shared_ptr<const VrmCharacter> build_vrm(const gltf::Document& document, const JointOrder& order,
                                              const std::vector<std::uint32_t>& instance_of_node, IssueLog& log) {
  const auto extension = [&](const char* name) { return ExtensionFields(document.extensions, "", name, log); };
  const ExtensionFields vrm = extension("VRMC_vrm"), vrm_0 = extension("VRM"), springs = extension("VRMC_springBone"),
                        animation = extension("VRMC_vrm_animation");
  VrmCharacter out;
  VrmReader reader(document, order, instance_of_node, log, out);
  bool any = vrm || vrm_0 || springs || animation;
  if (vrm) {
    reader.read_character(vrm);
    out.authors = authors_of(document.extensions);
  } else if (vrm_0) {
    read_vrm_0(vrm_0, document, order, instance_of_node, out);
  } else if (animation) {
    reader.read_animation(animation);
  }
  if (springs) reader.read_springs(springs);
  for (std::uint32_t n = 0; n < document.nodes.size(); ++n)
    if (const ExtensionFields constraint(document.nodes[n].extensions, pointer("nodes", n), "VRMC_node_constraint",
                                         log);
        constraint) {
      reader.read_constraint(n, constraint);
      any = true;
    }
  return any ? std::make_shared<const VrmCharacter>(std::move(out)) : nullptr;
}

}  // namespace sinew
