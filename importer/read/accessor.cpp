// SPDX-License-Identifier: MIT
#include "importer/read/accessor.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

namespace sinew {
namespace {

using gltf::Accessor;
using gltf::Bytes;
using gltf::ComponentType;
using gltf::Document;
using gltf::ElementType;

template <class T>
T load(const std::byte* at) noexcept {
  T value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

template <class Component>
float normalised(Component c) noexcept {
  const float f = static_cast<float>(c) / static_cast<float>(std::numeric_limits<Component>::max());
  return std::max(f, -1.0f);
}

/// Reads `count` elements, `stride` bytes apart, into tight components.
template <class Component, class Out, class Convert>
void copy_elements(const std::byte* from, std::uint64_t stride, std::size_t count, const ElementLayout& layout, Out* to,
                   Convert convert) {
  for (std::size_t i = 0; i < count; ++i, from += stride)
    for (std::uint32_t column = 0; column < layout.columns; ++column)
      for (std::uint32_t row = 0; row < layout.rows; ++row)
        *to++ = convert(load<Component>(from + column * layout.column_bytes + row * sizeof(Component)));
}

template <class Component>
void copy_as(const std::byte* from, std::uint64_t stride, std::size_t count, const ElementLayout& layout, bool normalized,
             float* to) {
  if constexpr (!std::is_floating_point_v<Component>) {
    if (normalized) return copy_elements<Component>(from, stride, count, layout, to, normalised<Component>);
  }
  copy_elements<Component>(from, stride, count, layout, to, [](Component c) { return static_cast<float>(c); });
}

void copy(ComponentType type, bool normalized, const std::byte* from, std::uint64_t stride, std::size_t count,
          const ElementLayout& layout, float* to) {
  switch (type) {
    case ComponentType::i8: return copy_as<std::int8_t>(from, stride, count, layout, normalized, to);
    case ComponentType::u8: return copy_as<std::uint8_t>(from, stride, count, layout, normalized, to);
    case ComponentType::i16: return copy_as<std::int16_t>(from, stride, count, layout, normalized, to);
    case ComponentType::u16: return copy_as<std::uint16_t>(from, stride, count, layout, normalized, to);
    case ComponentType::u32: return copy_as<std::uint32_t>(from, stride, count, layout, false, to);
    case ComponentType::f32: return copy_as<float>(from, stride, count, layout, false, to);
  }
}

void copy(ComponentType type, bool, const std::byte* from, std::uint64_t stride, std::size_t count,
          const ElementLayout& layout, std::uint32_t* to) {
  const auto same = [](auto c) { return static_cast<std::uint32_t>(c); };
  switch (type) {
    case ComponentType::u8: return copy_elements<std::uint8_t>(from, stride, count, layout, to, same);
    case ComponentType::u16: return copy_elements<std::uint16_t>(from, stride, count, layout, to, same);
    case ComponentType::u32: return copy_elements<std::uint32_t>(from, stride, count, layout, to, same);
    case ComponentType::i8:
    case ComponentType::i16:
    case ComponentType::f32: return;
  }
}

void copy(ComponentType type, bool, const std::byte* from, std::uint64_t stride, std::size_t count,
          const ElementLayout& layout, double* to) {
  const auto same = [](auto c) { return static_cast<double>(c); };
  switch (type) {
    case ComponentType::i8: return copy_elements<std::int8_t>(from, stride, count, layout, to, same);
    case ComponentType::u8: return copy_elements<std::uint8_t>(from, stride, count, layout, to, same);
    case ComponentType::i16: return copy_elements<std::int16_t>(from, stride, count, layout, to, same);
    case ComponentType::u16: return copy_elements<std::uint16_t>(from, stride, count, layout, to, same);
    case ComponentType::u32: return copy_elements<std::uint32_t>(from, stride, count, layout, to, same);
    case ComponentType::f32: return copy_elements<float>(from, stride, count, layout, to, same);
  }
}

template <class Out>
void apply_sparse(const Document& document, const Accessor& accessor, const ElementLayout& layout, std::vector<Out>& out) {
  const auto& sparse = accessor.sparse;
  const auto count = static_cast<std::size_t>(sparse.count);
  const std::byte* index_bytes = document.buffer_views[sparse.indices_view].bytes.data() + sparse.indices_offset;
  const std::byte* value_bytes = document.buffer_views[sparse.values_view].bytes.data() + sparse.values_offset;
  std::vector<std::uint32_t> indices(count);
  copy(sparse.index_type, false, index_bytes, component_bytes(sparse.index_type), count,
       element_layout(ElementType::scalar, sparse.index_type), indices.data());
  for (std::size_t i = 0; i < count; ++i)
    copy(accessor.component_type, accessor.normalized, value_bytes + i * layout.element_bytes, layout.element_bytes, 1, layout,
         out.data() + std::size_t{indices[i]} * layout.components());
}

template <class Out>
std::vector<Out> read(const Document& document, std::uint32_t index) {
  const Accessor& accessor = document.accessors[index];
  const ElementLayout layout = element_layout(accessor);
  const auto count = static_cast<std::size_t>(accessor.count);
  std::vector<Out> out(count * layout.components());
  if (accessor.buffer_view != kNone && count > 0)
    copy(accessor.component_type, accessor.normalized, document.buffer_views[accessor.buffer_view].bytes.data() + accessor.byte_offset,
         element_stride(document, accessor), count, layout, out.data());
  if (accessor.sparse.count > 0) apply_sparse(document, accessor, layout, out);
  return out;
}

}  // namespace

std::uint32_t component_bytes(ComponentType type) noexcept {
  switch (type) {
    case ComponentType::i8:
    case ComponentType::u8: return 1;
    case ComponentType::i16:
    case ComponentType::u16: return 2;
    case ComponentType::u32:
    case ComponentType::f32: return 4;
  }
  return 4;
}

ElementLayout element_layout(ElementType type, ComponentType component) noexcept {
  constexpr std::uint32_t kRows[] = {1, 2, 3, 4, 2, 3, 4};
  constexpr std::uint32_t kColumns[] = {1, 1, 1, 1, 2, 3, 4};
  ElementLayout layout;
  layout.rows = kRows[static_cast<std::size_t>(type)];
  layout.columns = kColumns[static_cast<std::size_t>(type)];
  layout.component_bytes = component_bytes(component);
  layout.column_bytes = layout.rows * layout.component_bytes;
  if (layout.columns > 1) layout.column_bytes = (layout.column_bytes + 3) / 4 * 4;
  layout.element_bytes = layout.columns * layout.column_bytes;
  return layout;
}

std::uint64_t element_stride(const Document& document, const Accessor& accessor) noexcept {
  const std::uint32_t stride = accessor.buffer_view == kNone ? 0 : document.buffer_views[accessor.buffer_view].byte_stride;
  return stride != 0 ? stride : element_layout(accessor).element_bytes;
}

std::vector<float> read_floats(const Document& document, std::uint32_t accessor) { return read<float>(document, accessor); }

std::vector<std::uint32_t> read_unsigned(const Document& document, std::uint32_t accessor) {
  return read<std::uint32_t>(document, accessor);
}

std::vector<double> read_stored(const Document& document, std::uint32_t accessor) { return read<double>(document, accessor); }

}  // namespace sinew
