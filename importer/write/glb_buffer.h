// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "importer/file/tinygltf.h"
#include "runtime/math/affine.h"
#include "runtime/model/morph_set.h"

namespace sinew::write {

/// Content of a buffer view; it decides the view's `target`.
enum class ViewUse { vertices, indices, other };

/// Appends typed arrays to the single buffer of `model`. Each array gets a view and an accessor, aligned to four bytes.
class GlbBuffer {
 public:
  explicit GlbBuffer(tinygltf::Model& model) : model_(model) { model_.buffers.resize(1); }

  int add_view(std::span<const std::byte> bytes, ViewUse use);

  /// All functions below return the index of the new accessor. `with_bounds` writes min and max, which glTF requires
  /// for positions and key times.
  int add(std::span<const float> values, bool with_bounds = false);
  int add(std::span<const glm::vec2> values);
  int add(std::span<const glm::vec3> values, bool with_bounds = false, ViewUse use = ViewUse::vertices);
  int add(std::span<const glm::vec4> values);
  /// Adds values of 1 to 4 components.
  int add_numbers(std::span<const float> values, std::uint32_t components);
  int add_flags(std::span<const float> values);
  int add_rotations(std::span<const glm::quat> values);
  int add_indices(std::span<const std::uint32_t> values);
  int add_joints(std::span<const std::uint16_t> four_per_vertex);
  int add_matrices(std::span<const Affine> values);

  /// Adds displacements of `vertex_count` vertices: sparse if that takes fewer bytes; without a view if all are zero.
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
