// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "importer/file/tinygltf.h"
#include "runtime/math/affine.h"
#include "runtime/model/morph_set.h"

namespace sinew::write {

/// What a buffer view holds; it decides the `target` of the view.
enum class ViewUse { vertices, indices, other };

/// Appends typed arrays to the only buffer of `model`. Each array gets a view and an accessor and starts at a multiple
/// of four bytes.
class GlbBuffer {
 public:
  explicit GlbBuffer(tinygltf::Model& model) : model_(model) { model_.buffers.resize(1); }

  int add_view(std::span<const std::byte> bytes, ViewUse use);

  /// All functions below return the index of the new accessor. `with_bounds` writes min and max, which glTF demands for
  /// positions and key times.
  int add(std::span<const float> values, bool with_bounds = false);
  int add(std::span<const glm::vec2> values);
  int add(std::span<const glm::vec3> values, bool with_bounds = false, ViewUse use = ViewUse::vertices);
  int add(std::span<const glm::vec4> values);
  /// Values of 1 to 4 numbers each.
  int add_numbers(std::span<const float> values, std::uint32_t components);
  int add_flags(std::span<const float> values);
  int add_rotations(std::span<const glm::quat> values);
  int add_indices(std::span<const std::uint32_t> values);
  int add_joints(std::span<const std::uint16_t> four_per_vertex);
  int add_matrices(std::span<const Affine> values);

  /// Displacements of `vertex_count` vertices: sparse where that takes fewer bytes than one value per vertex, and
  /// without bytes where nothing moves.
  int add_deltas(const SparseDeltas<glm::vec2>& deltas, std::size_t vertex_count);
  int add_deltas(const SparseDeltas<glm::vec3>& deltas, std::size_t vertex_count, bool with_bounds = false);
  int add_deltas(const SparseDeltas<glm::vec4>& deltas, std::size_t vertex_count);

 private:
  template <class V>
  int add_zeros(std::size_t count, bool with_bounds);
  template <class V>
  int add_sparse_or_dense(const SparseDeltas<V>& deltas, std::size_t vertex_count, bool with_bounds);
  int add_accessor(std::span<const std::byte> bytes, std::size_t count, int type, int component, ViewUse use);

  tinygltf::Model& model_;
};

}  // namespace sinew::write
