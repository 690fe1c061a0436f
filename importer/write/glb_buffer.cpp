// SPDX-License-Identifier: MIT
#include "importer/write/glb_buffer.h"

#include <algorithm>
#include <vector>

namespace sinew::write {
namespace {

template <class V>
constexpr int kType = TINYGLTF_TYPE_SCALAR;
template <>
constexpr int kType<glm::vec2> = TINYGLTF_TYPE_VEC2;
template <>
constexpr int kType<glm::vec3> = TINYGLTF_TYPE_VEC3;
template <>
constexpr int kType<glm::vec4> = TINYGLTF_TYPE_VEC4;

/// Writes min and max per component of `count` elements with `width` floats. Set `includes_zero` for sparse accessors,
/// whose other elements are 0.
void set_bounds(tinygltf::Accessor& accessor, const float* values, std::size_t count, std::size_t width,
                bool includes_zero) {
  for (std::size_t c = 0; c < width; ++c) {
    double lower = includes_zero ? 0.0 : values[c], upper = lower;
    for (std::size_t i = 0; i < count; ++i) {
      lower = std::min(lower, static_cast<double>(values[i * width + c]));
      upper = std::max(upper, static_cast<double>(values[i * width + c]));
    }
    accessor.minValues.push_back(lower);
    accessor.maxValues.push_back(upper);
  }
}

}  // namespace

int GlbBuffer::add_view(std::span<const std::byte> bytes, ViewUse use) {
  auto& data = model_.buffers[0].data;
  data.resize((data.size() + 3) / 4 * 4);
  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = data.size();
  view.byteLength = bytes.size();
  if (use == ViewUse::vertices) view.target = TINYGLTF_TARGET_ARRAY_BUFFER;
  if (use == ViewUse::indices) view.target = TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER;
  const auto* first = reinterpret_cast<const unsigned char*>(bytes.data());
  data.insert(data.end(), first, first + bytes.size());
  model_.bufferViews.push_back(std::move(view));
  return static_cast<int>(model_.bufferViews.size() - 1);
}

int GlbBuffer::add_accessor(std::span<const std::byte> bytes, std::size_t count, int type, int component, ViewUse use) {
  tinygltf::Accessor accessor;
  accessor.bufferView = add_view(bytes, use);
  accessor.count = count;
  accessor.type = type;
  accessor.componentType = component;
  model_.accessors.push_back(std::move(accessor));
  return static_cast<int>(model_.accessors.size() - 1);
}

int GlbBuffer::add(std::span<const float> values, bool with_bounds) {
  const int index = add_accessor(std::as_bytes(values), values.size(), TINYGLTF_TYPE_SCALAR,
                                 TINYGLTF_COMPONENT_TYPE_FLOAT, ViewUse::other);
  if (with_bounds && !values.empty()) set_bounds(model_.accessors.back(), values.data(), values.size(), 1, false);
  return index;
}

int GlbBuffer::add(std::span<const glm::vec2> values) {
  return add_accessor(std::as_bytes(values), values.size(), TINYGLTF_TYPE_VEC2, TINYGLTF_COMPONENT_TYPE_FLOAT,
                      ViewUse::vertices);
}

int GlbBuffer::add(std::span<const glm::vec3> values, bool with_bounds, ViewUse use) {
  const int index =
      add_accessor(std::as_bytes(values), values.size(), TINYGLTF_TYPE_VEC3, TINYGLTF_COMPONENT_TYPE_FLOAT, use);
  if (with_bounds && !values.empty()) set_bounds(model_.accessors.back(), &values[0].x, values.size(), 3, false);
  return index;
}

int GlbBuffer::add(std::span<const glm::vec4> values) {
  return add_accessor(std::as_bytes(values), values.size(), TINYGLTF_TYPE_VEC4, TINYGLTF_COMPONENT_TYPE_FLOAT,
                      ViewUse::vertices);
}

int GlbBuffer::add_numbers(std::span<const float> values, std::uint32_t components) {
  const int types[] = {TINYGLTF_TYPE_SCALAR, TINYGLTF_TYPE_VEC2, TINYGLTF_TYPE_VEC3, TINYGLTF_TYPE_VEC4};
  return add_accessor(std::as_bytes(values), values.size() / components, types[components - 1],
                      TINYGLTF_COMPONENT_TYPE_FLOAT, ViewUse::other);
}

int GlbBuffer::add_flags(std::span<const float> values) {
  std::vector<std::uint8_t> flags;
  flags.reserve(values.size());
  for (const float value : values) flags.push_back(value >= 0.5f);
  return add_accessor(std::as_bytes(std::span(flags)), flags.size(), TINYGLTF_TYPE_SCALAR,
                      TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, ViewUse::other);
}

int GlbBuffer::add_rotations(std::span<const glm::quat> values) {
  std::vector<glm::vec4> xyzw;
  xyzw.reserve(values.size());
  for (const auto& q : values) xyzw.emplace_back(q.x, q.y, q.z, q.w);
  return add_accessor(std::as_bytes(std::span(xyzw)), xyzw.size(), TINYGLTF_TYPE_VEC4, TINYGLTF_COMPONENT_TYPE_FLOAT,
                      ViewUse::other);
}

int GlbBuffer::add_indices(std::span<const std::uint32_t> values) {
  return add_accessor(std::as_bytes(values), values.size(), TINYGLTF_TYPE_SCALAR, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
                      ViewUse::indices);
}

int GlbBuffer::add_joints(std::span<const std::uint16_t> four_per_vertex) {
  return add_accessor(std::as_bytes(four_per_vertex), four_per_vertex.size() / 4, TINYGLTF_TYPE_VEC4,
                      TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, ViewUse::vertices);
}

int GlbBuffer::add_matrices(std::span<const Affine> values) {
  std::vector<glm::mat4> columns;
  columns.reserve(values.size());
  for (const auto& m : values) columns.push_back(mat4_from_affine(m));
  return add_accessor(std::as_bytes(std::span(columns)), columns.size(), TINYGLTF_TYPE_MAT4,
                      TINYGLTF_COMPONENT_TYPE_FLOAT, ViewUse::other);
}

/// Adds an accessor without a view: its elements are 0 (glTF 2.0, "Accessors").
template <class V>
int GlbBuffer::add_zeros(std::size_t count, bool with_bounds) {
  tinygltf::Accessor accessor;
  accessor.count = count;
  accessor.type = kType<V>;
  accessor.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
  if (with_bounds) accessor.minValues = accessor.maxValues = std::vector<double>(sizeof(V) / sizeof(float), 0.0);
  model_.accessors.push_back(std::move(accessor));
  return static_cast<int>(model_.accessors.size() - 1);
}

template <class V>
int GlbBuffer::add_sparse_or_dense(const SparseDeltas<V>& deltas, std::size_t vertex_count, bool with_bounds) {
  const std::size_t moved = deltas.vertices.size();
  if (moved == 0) return add_zeros<V>(vertex_count, with_bounds);
  const bool sparse = moved * (sizeof(V) + sizeof(std::uint32_t)) < vertex_count * sizeof(V);
  std::vector<V> dense;
  if (!sparse) {
    dense.resize(vertex_count, V(0.0f));
    for (std::size_t i = 0; i < moved; ++i) dense[deltas.vertices[i]] = deltas.deltas[i];
    add_accessor(std::as_bytes(std::span<const V>(dense)), vertex_count, kType<V>, TINYGLTF_COMPONENT_TYPE_FLOAT,
                 ViewUse::vertices);
  } else {
    tinygltf::Accessor accessor;
    accessor.count = vertex_count;
    accessor.type = kType<V>;
    accessor.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
    accessor.sparse.isSparse = true;
    accessor.sparse.count = static_cast<int>(moved);
    accessor.sparse.indices.byteOffset = accessor.sparse.values.byteOffset = 0;  // not initialised by its constructor
    accessor.sparse.indices.bufferView = add_view(std::as_bytes(std::span(deltas.vertices)), ViewUse::other);
    accessor.sparse.indices.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    accessor.sparse.values.bufferView = add_view(std::as_bytes(std::span(deltas.deltas)), ViewUse::other);
    model_.accessors.push_back(std::move(accessor));
  }
  const auto& written = sparse ? deltas.deltas : dense;
  if (with_bounds && !written.empty())
    set_bounds(model_.accessors.back(), &written[0].x, written.size(), sizeof(V) / sizeof(float), sparse);
  return static_cast<int>(model_.accessors.size() - 1);
}

int GlbBuffer::add_deltas(const SparseDeltas<glm::vec2>& deltas, std::size_t vertex_count) {
  return add_sparse_or_dense(deltas, vertex_count, false);
}
int GlbBuffer::add_deltas(const SparseDeltas<glm::vec3>& deltas, std::size_t vertex_count, bool with_bounds) {
  return add_sparse_or_dense(deltas, vertex_count, with_bounds);
}
int GlbBuffer::add_deltas(const SparseDeltas<glm::vec4>& deltas, std::size_t vertex_count) {
  return add_sparse_or_dense(deltas, vertex_count, false);
}

}  // namespace sinew::write
