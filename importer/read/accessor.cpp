// SPDX-License-Identifier: MIT
#include "importer/read/accessor.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <limits>
#include <type_traits>

#include "runtime/base/contract.h"

namespace sinew {
namespace {

using gltf::Accessor;
using gltf::ComponentType;
using gltf::Document;
using gltf::ElementType;

template <class T>
T load(const std::byte* at) noexcept {
  T value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

/// Decodes a stored component: unchanged, or for normalised integers as a fraction of the largest integer.
template <bool normalized, class Out, class Component>
Out decoded(Component c) noexcept {
  if constexpr (normalized)
    return std::max(static_cast<float>(c) / static_cast<float>(std::numeric_limits<Component>::max()), -1.0f);
  else
    return static_cast<Out>(c);
}

/// Iterates over elements with any stride and alignment, as values of type V. Constructing a vector from two of these
/// iterators avoids zeroing its memory first.
template <class V, class Component, bool normalized>
class ElementIterator {
 public:
  using iterator_category = std::random_access_iterator_tag;
  using value_type = V;
  using difference_type = std::ptrdiff_t;
  using pointer = const V*;
  using reference = V;

  ElementIterator(const std::byte* first, std::size_t stride, difference_type index = 0)
      : first_(first), stride_(stride), index_(index) {}

  V operator*() const noexcept {
    const std::byte* at = first_ + static_cast<std::size_t>(index_) * stride_;
    if constexpr (std::is_arithmetic_v<V>) {
      return decoded<normalized, V>(load<Component>(at));
    } else {
      V out;
      for (int c = 0; c < V::length(); ++c)
        out[c] = decoded<normalized, typename V::value_type>(
            load<Component>(at + static_cast<std::size_t>(c) * sizeof(Component)));
      return out;
    }
  }
  ElementIterator& operator++() noexcept {
    ++index_;
    return *this;
  }
  ElementIterator operator++(int) noexcept { return {first_, stride_, index_++}; }
  ElementIterator& operator--() noexcept {
    --index_;
    return *this;
  }
  ElementIterator& operator+=(difference_type n) noexcept {
    index_ += n;
    return *this;
  }
  ElementIterator operator+(difference_type n) const noexcept { return {first_, stride_, index_ + n}; }
  difference_type operator-(const ElementIterator& other) const noexcept { return index_ - other.index_; }
  bool operator==(const ElementIterator& other) const noexcept { return index_ == other.index_; }

 private:
  const std::byte* first_;
  std::size_t stride_;
  difference_type index_;
};

/// Calls `use(begin)` with an iterator for the stored component type. Does not decode normalised integers for V =
/// uint32_t and double.
template <class V, class Use>
auto with_elements(ComponentType type, bool normalized, const std::byte* first, std::size_t stride, Use use) {
  const auto go = [&]<class Component>(Component) {
    if constexpr (std::is_integral_v<Component> && sizeof(Component) < 4 && !std::is_same_v<V, std::uint32_t> &&
                  !std::is_same_v<V, double>)
      if (normalized) return use(ElementIterator<V, Component, true>(first, stride));
    return use(ElementIterator<V, Component, false>(first, stride));
  };
  switch (type) {
    case ComponentType::i8: return go(std::int8_t{});
    case ComponentType::u8: return go(std::uint8_t{});
    case ComponentType::i16: return go(std::int16_t{});
    case ComponentType::u16: return go(std::uint16_t{});
    case ComponentType::u32: return go(std::uint32_t{});
    case ComponentType::f32: break;
  }
  return go(float{});
}

/// Number of components of V.
template <class V>
constexpr std::size_t width_of() {
  if constexpr (std::is_arithmetic_v<V>)
    return 1;
  else
    return static_cast<std::size_t>(V::length());
}

/// Appends `count` elements, each as one V. If V is a number, appends all components, column by column.
template <class V>
void append(std::vector<V>& out, const Accessor& accessor, const ElementLayout& layout, const std::byte* first,
            std::size_t stride, std::size_t count) {
  const auto add = [&](const std::byte* from, std::size_t step, std::size_t n) {
    with_elements<V>(accessor.component_type, accessor.normalized, from, step,
                     [&](auto it) { out.insert(out.end(), it, it + static_cast<std::ptrdiff_t>(n)); });
  };
  if constexpr (!std::is_arithmetic_v<V>) {
    add(first, stride, count);
  } else if (stride == layout.components() * layout.component_bytes) {
    const std::size_t components = count * layout.components();
    if (!std::is_same_v<V, float> || accessor.component_type != ComponentType::f32)
      return add(first, layout.component_bytes, components);
    out.resize(out.size() + components);
    std::memcpy(out.data() + (out.size() - components), first, components * sizeof(float));
  } else {
    for (std::size_t i = 0; i < count; ++i)
      for (std::uint32_t column = 0; column < layout.columns; ++column)
        add(first + i * stride + column * layout.column_bytes, layout.component_bytes, layout.rows);
  }
}

/// Reads sparse replacements. V is a vector with as many components as the accessor, or a number; then each index has
/// several values.
template <class V>
Replacements<V> replacements(const Document& document, const Accessor& accessor, const ElementLayout& layout) {
  const auto& sparse = accessor.sparse;
  const auto count = static_cast<std::size_t>(sparse.count);
  const std::byte* index_bytes = document.buffer_views[sparse.indices_view].bytes.data() + sparse.indices_offset;
  const std::byte* value_bytes = document.buffer_views[sparse.values_view].bytes.data() + sparse.values_offset;
  Replacements<V> out;
  append(out.values, accessor, layout, value_bytes, layout.element_bytes, count);
  with_elements<std::uint32_t>(sparse.index_type, false, index_bytes, component_bytes(sparse.index_type),
                               [&](auto it) { out.indices.assign(it, it + static_cast<std::ptrdiff_t>(count)); });
  return out;
}

template <class V>
void apply_sparse(const Document& document, const Accessor& accessor, const ElementLayout& layout,
                  std::vector<V>& out) {
  const auto [indices, values] = replacements<V>(document, accessor, layout);
  const std::size_t entries = layout.components() / width_of<V>();  // entries of `out` for one element
  for (std::size_t i = 0; i < indices.size(); ++i)
    std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(i * entries), entries,
                out.begin() + static_cast<std::ptrdiff_t>(indices[i] * entries));
}

template <class V>
std::vector<V> read(const Document& document, std::uint32_t index) {
  const Accessor& accessor = document.accessors[index];
  const ElementLayout layout = element_layout(accessor);
  const auto count = static_cast<std::size_t>(accessor.count);
  const std::size_t size = count * layout.components() / width_of<V>();
  std::vector<V> out;
  if (accessor.buffer_view == kNone || count == 0) {
    out.assign(size, V(0));
  } else {
    out.reserve(size);
    append(out, accessor, layout, document.buffer_views[accessor.buffer_view].bytes.data() + accessor.byte_offset,
           static_cast<std::size_t>(element_stride(document, accessor)), count);
  }
  if (accessor.sparse.count > 0) apply_sparse(document, accessor, layout, out);
  return out;
}

}  // namespace

bool is_unsigned(ComponentType type) noexcept {
  return type == ComponentType::u8 || type == ComponentType::u16 || type == ComponentType::u32;
}

std::uint32_t component_bytes(ComponentType type) noexcept {
  switch (type) {
    case ComponentType::i8:
    case ComponentType::u8: return 1;
    case ComponentType::i16:
    case ComponentType::u16: return 2;
    case ComponentType::u32:
    case ComponentType::f32: break;
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
  const std::uint32_t stride =
      accessor.buffer_view == kNone ? 0 : document.buffer_views[accessor.buffer_view].byte_stride;
  return stride != 0 ? stride : element_layout(accessor).element_bytes;
}

std::vector<float> read_floats(const Document& document, std::uint32_t accessor) {
  return read<float>(document, accessor);
}

std::vector<std::uint32_t> read_unsigned(const Document& document, std::uint32_t index) {
  CONTRACT(is_unsigned(document.accessors[index].component_type));
  return read<std::uint32_t>(document, index);
}

std::vector<double> read_stored(const Document& document, std::uint32_t accessor) {
  return read<double>(document, accessor);
}

template <class V>
std::vector<V> read_vectors(const Document& document, std::uint32_t accessor) {
  return read<V>(document, accessor);
}
template std::vector<glm::vec2> read_vectors(const Document&, std::uint32_t);
template std::vector<glm::vec3> read_vectors(const Document&, std::uint32_t);
template std::vector<glm::vec4> read_vectors(const Document&, std::uint32_t);

template <class V>
Replacements<V> read_replacements(const Document& document, std::uint32_t index) {
  const Accessor& accessor = document.accessors[index];
  return replacements<V>(document, accessor, element_layout(accessor));
}
template Replacements<glm::vec2> read_replacements(const Document&, std::uint32_t);
template Replacements<glm::vec3> read_replacements(const Document&, std::uint32_t);
template Replacements<glm::vec4> read_replacements(const Document&, std::uint32_t);

}  // namespace sinew
