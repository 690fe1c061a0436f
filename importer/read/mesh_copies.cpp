// SPDX-License-Identifier: MIT
#include "importer/read/mesh_copies.h"

#include "importer/file/json_pointer.h"
#include "importer/read/accessor.h"
#include "importer/read/json_member.h"
#include "importer/read/meshes.h"
#include "importer/read/rotations.h"

namespace sinew {
namespace {

using gltf::ComponentType;
using gltf::ElementType;
using gltf::Json;

constexpr const char* kMeshCopies = "EXT_mesh_gpu_instancing";

std::string place_of(std::uint32_t node) { return pointer("nodes", node, "extensions", kMeshCopies, "attributes"); }

class CopyReader {
 public:
  CopyReader(const gltf::Document& document, std::uint32_t node, IssueLog& log)
      : document_(document), place_(place_of(node)), log_(log) {}

  std::optional<std::vector<Transform>> read(const std::map<std::string, std::uint32_t>& attributes) {
    for (const auto& [name, accessor] : attributes)
      if (!check_attribute(name, document_.accessors[accessor])) return std::nullopt;
    std::vector<Transform> copies(count_.value_or(0));
    for (const auto& [name, accessor] : attributes) {
      if (name.starts_with('_')) continue;
      const std::vector<float> numbers =
          read_finite<float>(document_, accessor, pointer(place_, pointer_token(name)), log_);
      if (numbers.empty() && !copies.empty()) return std::nullopt;  // some number is not finite
      if (name == "ROTATION")
        fill_rotations(copies, numbers);
      else
        for (std::size_t i = 0; i < copies.size(); ++i)
          (name == "SCALE" ? copies[i].scale : copies[i].translation) =
              glm::vec3(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]);
    }
    return copies;
  }

 private:
  bool fail(const std::string& name, const std::string& why) {
    log_.report(Rule::instancing_attributes, pointer(place_, pointer_token(name)), why);
    return false;
  }

  bool check_attribute(const std::string& name, const gltf::Accessor& accessor) {
    if (count_.value_or(accessor.count) != accessor.count)
      return fail(name, std::to_string(accessor.count) + " entries, another attribute has " + std::to_string(*count_));
    count_ = accessor.count;
    if (name.starts_with('_')) return true;
    const bool rotation = name == "ROTATION";
    if (!rotation && name != "TRANSLATION" && name != "SCALE") return fail(name, "is no attribute of an instance");
    const bool floats = accessor.component_type == ComponentType::f32;
    const bool small = accessor.component_type == ComponentType::i8 || accessor.component_type == ComponentType::i16;
    if (accessor.type != (rotation ? ElementType::vec4 : ElementType::vec3))
      return fail(name, "has the wrong number of components");
    return floats || (rotation && small && accessor.normalized) ||
           fail(name, "has a component type that is not allowed");
  }

  void fill_rotations(std::vector<Transform>& copies, const std::vector<float>& numbers) {
    RotationTally tally;
    for (std::size_t i = 0; i < copies.size(); ++i) {
      const float* q = numbers.data() + 4 * i;
      const UnitRotation unit = unit_rotation(q[0], q[1], q[2], q[3]);
      copies[i].rotation = unit.rotation;
      tally.add(unit.length);
    }
    tally.report(pointer(place_, "ROTATION"), "a rotation", "rotations", log_);
  }

  const gltf::Document& document_;
  std::string place_;
  IssueLog& log_;
  std::optional<std::uint64_t> count_;
};

}  // namespace

std::map<std::string, std::uint32_t> copy_attributes(const gltf::Document& document, std::uint32_t node,
                                                     IssueLog& log) {
  std::map<std::string, std::uint32_t> out;
  const Json* extension = member(&document.nodes[node].extensions, kMeshCopies);
  if (extension == nullptr) return out;
  const Json* attributes = member(extension, "attributes");
  if (attributes == nullptr || !attributes->is_object()) {
    log.report(Rule::extension_value, pointer("nodes", node, "extensions", kMeshCopies), "has no attributes; ignored");
    return out;
  }
  for (const auto& [name, index] : attributes->items()) {
    const std::uint32_t accessor = index_below(&index, document.accessors.size());
    if (accessor != kNone)
      out.emplace(name, accessor);
    else
      log.report(Rule::reference, pointer(place_of(node), pointer_token(name)), "is no index of an accessor");
  }
  return out;
}

std::optional<std::vector<Transform>> read_mesh_copies(const gltf::Document& document, std::uint32_t node,
                                                       IssueLog& log) {
  const std::size_t errors = log.error_count();
  const auto attributes = copy_attributes(document, node, log);
  if (attributes.empty() || log.error_count() != errors) return std::nullopt;
  return CopyReader(document, node, log).read(attributes);
}

}  // namespace sinew
