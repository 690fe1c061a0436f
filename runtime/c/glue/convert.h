// SPDX-License-Identifier: MIT
#pragma once
#include <concepts>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <glm/vec2.hpp>

#include "runtime/c/glue/conversion.h"
#include "runtime/c/glue/enum_pairs.h"
#include "runtime/c/types.h"
#include "runtime/math/affine.h"
#include "runtime/math/joint_matrix.h"
#include "runtime/model/aabb.h"

// The rules of conversion: numbers, enumerations, vectors and matrices, spans, strings.

namespace sinew::c {

template <>
inline constexpr bool kSameBytes<sinew_vec2, glm::vec2> = true;
template <>
inline constexpr bool kSameBytes<sinew_vec3, glm::vec3> = true;
template <>
inline constexpr bool kSameBytes<sinew_vec4, glm::vec4> = true;
template <>
inline constexpr bool kSameBytes<sinew_affine, Affine> = true;
template <>
inline constexpr bool kSameBytes<sinew_joint_matrix, JointMatrix> = true;
template <>
inline constexpr bool kSameBytes<sinew_box, Aabb> = true;
template <>
inline constexpr bool kSameBytes<unsigned char, bool> = true;

template <>
struct Convert<std::uint32_t, bool> {
  static sinew_error read(std::uint32_t given, bool& own) noexcept {
    own = given != 0;
    return SINEW_OK;
  }
  static void write(bool own, std::uint32_t& out) noexcept { out = own ? 1 : 0; }
};

/// Converts between integers of different widths. A number that does not fit into the C++ type is SINEW_UNSUPPORTED.
template <std::unsigned_integral OfC, std::unsigned_integral Own>
requires(!std::same_as<OfC, Own> && !std::same_as<Own, bool>) struct Convert<OfC, Own> {
  static sinew_error read(OfC given, Own& own) noexcept {
    if (given > std::numeric_limits<Own>::max()) return SINEW_UNSUPPORTED;
    own = static_cast<Own>(given);
    return SINEW_OK;
  }
  static void write(Own own, OfC& out) noexcept { out = static_cast<OfC>(own); }
};

template <class OfC, class Own>
requires(std::is_enum_v<Own> && !kSameBytes<OfC, Own>) struct Convert<OfC, Own> {
  static sinew_error read(OfC given, Own& own) noexcept {
    if (!kEnum<Own>.has(static_cast<std::uint32_t>(given))) return SINEW_UNSUPPORTED;
    own = static_cast<Own>(given);
    return SINEW_OK;
  }
  static void write(Own own, OfC& out) noexcept { out = static_cast<OfC>(own); }
};

/// True for the span structs of C, which have `data` and `count`.
template <class OfC>
concept SpanOfC = requires(OfC span) {
  *span.data;
  { span.count } -> std::same_as<std::size_t&>;
};
template <SpanOfC OfC>
using ElementOfC = std::remove_cvref_t<decltype(*OfC{}.data)>;

template <SpanOfC OfC, class T>
requires kSameBytes<ElementOfC<OfC>, std::remove_const_t<T>>
struct Convert<OfC, std::span<T>> {
  static sinew_error read(const OfC& given, std::span<T>& own) noexcept {
    if (given.data == nullptr && given.count > 0) return SINEW_NULL_ARGUMENT;
    own = {reinterpret_cast<T*>(given.data), given.count};
    return SINEW_OK;
  }
  static void write(std::span<T> own, OfC& out) noexcept {
    out = {reinterpret_cast<decltype(out.data)>(own.data()), own.size()};
  }
};

template <SpanOfC OfC, class T>
requires kSameBytes<ElementOfC<OfC>, T>
struct Convert<OfC, std::vector<T>> {
  static sinew_error read(const OfC& given, std::vector<T>& own) {
    std::span<const T> view;
    if (const sinew_error error = Convert<OfC, std::span<const T>>::read(given, view)) return error;
    own.assign(view.begin(), view.end());
    return SINEW_OK;
  }
  static void write(const std::vector<T>& own, OfC& out) noexcept { Convert<OfC, std::span<const T>>::write(own, out); }
};

template <std::convertible_to<std::string_view> Own>
struct Convert<sinew_string, Own> {
  static void write(std::string_view own, sinew_string& out) noexcept { out = {own.data(), own.size()}; }
};

}  // namespace sinew::c
