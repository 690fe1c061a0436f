// SPDX-License-Identifier: MIT
#include "importer/read/meshes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <type_traits>

#include "importer/file/json_pointer.h"
#include "importer/read/accessor.h"
#include "importer/read/primitive_indices.h"
#include "importer/read/vertex_formats.h"
#include "runtime/base/all_finite.h"

namespace sinew {
namespace {

constexpr float kNormalTolerance = 0.00674f;  // rounding error of an 8-bit normal; the same as in common validators

std::vector<glm::vec4> opaque(const std::vector<glm::vec3>& colors) {
  std::vector<glm::vec4> out;
  out.reserve(colors.size());
  for (const auto& c : colors) out.emplace_back(c, 1.0f);
  return out;
}

class PrimitiveReader {
 public:
  PrimitiveReader(const gltf::Document& document, std::uint32_t mesh, std::uint32_t primitive, IssueLog& log)
      : document_(document),
        source_(document.meshes[mesh].primitives[primitive]),
        place_(pointer("meshes", mesh, "primitives", primitive)),
        log_(log) {}

  PrimitiveData read() {
    data_.primitive.topology = topology_of(mode_of(source_));
    data_.primitive.material = source_.material;
    const auto position = source_.attributes.find("POSITION");
    if (position == source_.attributes.end()) {
      log_.report(Rule::mesh_no_position, pointer(place_, "attributes"), "no POSITION; the primitive is left out");
      return std::move(data_);
    }
    count_ = document_.accessors[position->second].count;
    for (const auto& [name, accessor] : source_.attributes) read_attribute(name, accessor);
    collect_texcoords();
    collect_influences();
    if (log_.error_count() != errors_before_) return std::move(data_);
    data_.primitive.indices = read_indices(document_, source_, static_cast<std::uint32_t>(count_), place_, log_);
    if (!data_.primitive.tangents.empty() && data_.primitive.normals.empty())
      log_.report(Rule::mesh_tangent_without_normal, pointer(place_, "attributes", "TANGENT"),
                  "tangents without normals are ignored");
    if (data_.primitive.normals.empty()) data_.primitive.tangents.clear();
    return std::move(data_);
  }

 private:
  void read_attribute(const std::string& name, std::uint32_t accessor) {
    const auto semantic = parse_semantic(name);
    const std::string place = pointer(place_, "attributes", pointer_token(name));
    if (!semantic) {
      if (!name.starts_with('_'))
        log_.report(Rule::mesh_attribute_name, place, "is no attribute that glTF defines; ignored");
      return;
    }
    if (document_.accessors[accessor].count != count_)
      return log_.report(
          Rule::mesh_attribute_count, place,
          std::to_string(document_.accessors[accessor].count) + " entries for " + std::to_string(count_) + " vertices");
    if (!check_vertex_format(document_, accessor, semantic->attribute, false, place, log_)) return;
    if (semantic->attribute == Attribute::joints) {
      joints_[semantic->set] = read_unsigned(document_, accessor);
      return;
    }
    store(*semantic, accessor, place);
  }

  template <class V>
  std::vector<V> numbers(std::uint32_t accessor, const std::string& place) {
    return read_finite<V>(document_, accessor, place, log_);
  }

  void store(const Semantic& semantic, std::uint32_t accessor, const std::string& place) {
    auto& primitive = data_.primitive;
    switch (semantic.attribute) {
      case Attribute::position: primitive.positions = numbers<glm::vec3>(accessor, place); break;
      case Attribute::normal:
        primitive.normals = numbers<glm::vec3>(accessor, place);
        make_unit(place);
        break;
      case Attribute::tangent:
        primitive.tangents = numbers<glm::vec4>(accessor, place);
        make_signs(place);
        break;
      case Attribute::texcoord: texcoords_[semantic.set] = numbers<glm::vec2>(accessor, place); break;
      case Attribute::color:
        if (semantic.set != 0)
          numbers<float>(accessor, place);
        else if (document_.accessors[accessor].type == gltf::ElementType::vec4)
          primitive.colors = numbers<glm::vec4>(accessor, place);
        else
          primitive.colors = opaque(numbers<glm::vec3>(accessor, place));
        break;
      case Attribute::weights: weights_[semantic.set] = numbers<float>(accessor, place); break;
      case Attribute::joints: break;
    }
  }

  /// Normalises normals whose length is not close to 1. Others stay unchanged, because morphed normals are sums of
  /// stored values.
  void make_unit(const std::string& place) {
    std::size_t odd = 0;
    float worst = 1.0f;
    for (auto& n : data_.primitive.normals) {
      const float length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
      if (std::abs(length - 1.0f) <= kNormalTolerance) continue;
      if (std::abs(length - 1.0f) > std::abs(worst - 1.0f)) worst = length;
      ++odd;
      n = length > 1e-20f ? n / length : glm::vec3(0.0f, 0.0f, 1.0f);
    }
    if (odd > 0)
      log_.report(Rule::mesh_normal_length, place,
                  std::to_string(odd) + " normals are not of unit length (one has " + std::to_string(worst) +
                      "); normalised, +Z where there is none");
  }

  void make_signs(const std::string& place) {
    std::size_t odd = 0;
    for (auto& t : data_.primitive.tangents) {
      if (t.w == 1.0f || t.w == -1.0f) continue;
      ++odd;
      t.w = t.w < 0.0f ? -1.0f : 1.0f;
    }
    if (odd > 0)
      log_.report(Rule::mesh_tangent_sign, place,
                  std::to_string(odd) + " handedness values are not +1 or -1; the sign is taken");
  }

  void collect_texcoords() {
    for (auto& [set, values] : texcoords_) {
      if (set != data_.primitive.texcoords.size())
        return log_.report(Rule::mesh_texcoord_gap, pointer(place_, "attributes"),
                           "TEXCOORD_" + std::to_string(set) + " follows a gap; ignored");
      data_.primitive.texcoords.push_back(std::move(values));
    }
  }

  void collect_influences() {
    for (auto& [set, joints] : joints_) {
      const auto weights = weights_.find(set);
      if (weights == weights_.end()) continue;
      data_.influence_sets.push_back({set, std::move(joints), std::move(weights->second)});
    }
    if (data_.influence_sets.size() != joints_.size() || joints_.size() != weights_.size())
      log_.report(Rule::mesh_joint_sets, pointer(place_, "attributes"),
                  "JOINTS_n and WEIGHTS_n do not pair up; single ones are ignored");
  }

  const gltf::Document& document_;
  const gltf::Primitive& source_;
  std::string place_;
  IssueLog& log_;
  const std::size_t errors_before_ = log_.error_count();
  std::uint64_t count_ = 0;
  PrimitiveData data_;
  std::map<std::uint32_t, std::vector<glm::vec2>> texcoords_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> joints_;
  std::map<std::uint32_t, std::vector<float>> weights_;
};

}  // namespace

template <class V>
bool check_finite(std::span<const V> values, std::span<const std::uint32_t> indices, std::size_t components,
                  const std::string& place, IssueLog& log) {
  if (all_finite(values)) return true;
  const auto* first = reinterpret_cast<const float*>(values.data());
  const auto* bad =
      std::find_if(first, first + values.size_bytes() / sizeof(float), [](float f) { return !std::isfinite(f); });
  const auto element = static_cast<std::size_t>(bad - first) / components;
  log.report(Rule::not_finite, place,
             "element " + std::to_string(indices.empty() ? element : indices[element]) + " holds NaN or infinity");
  return false;
}
template bool check_finite(std::span<const glm::vec2>, std::span<const std::uint32_t>, std::size_t, const std::string&,
                           IssueLog&);
template bool check_finite(std::span<const glm::vec3>, std::span<const std::uint32_t>, std::size_t, const std::string&,
                           IssueLog&);
template bool check_finite(std::span<const glm::vec4>, std::span<const std::uint32_t>, std::size_t, const std::string&,
                           IssueLog&);

template <class V>
std::vector<V> read_finite(const gltf::Document& document, std::uint32_t index, const std::string& place,
                           IssueLog& log) {
  const gltf::Accessor& accessor = document.accessors[index];
  std::vector<V> values;
  if constexpr (std::is_same_v<V, float>)
    values = read_floats(document, index);
  else
    values = read_vectors<V>(document, index);
  const bool whole = accessor.component_type != gltf::ComponentType::f32;  // integers are always finite
  if (whole || check_finite<V>(values, {}, element_layout(accessor).components(), place, log)) return values;
  return {};
}
template std::vector<float> read_finite(const gltf::Document&, std::uint32_t, const std::string&, IssueLog&);
template std::vector<glm::vec2> read_finite(const gltf::Document&, std::uint32_t, const std::string&, IssueLog&);
template std::vector<glm::vec3> read_finite(const gltf::Document&, std::uint32_t, const std::string&, IssueLog&);
template std::vector<glm::vec4> read_finite(const gltf::Document&, std::uint32_t, const std::string&, IssueLog&);

PrimitiveData read_primitive(const gltf::Document& document, std::uint32_t mesh, std::uint32_t primitive,
                             IssueLog& log) {
  return PrimitiveReader(document, mesh, primitive, log).read();
}

}  // namespace sinew
