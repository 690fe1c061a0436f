// SPDX-License-Identifier: MIT
#pragma once
#include <type_traits>

#include "runtime/asset_file/asset_fields.h"

namespace sinew {

/// Types whose memory is stored as it is: numbers without padding, for which all bit patterns are safe to read.
template <class T>
inline constexpr bool kIsPlain = std::is_arithmetic_v<T> && !std::is_same_v<T, bool>;
template <>
inline constexpr bool kIsPlain<std::byte> = true;
template <>
inline constexpr bool kIsPlain<glm::vec2> = true;
template <>
inline constexpr bool kIsPlain<glm::vec3> = true;
template <>
inline constexpr bool kIsPlain<glm::vec4> = true;
template <>
inline constexpr bool kIsPlain<glm::quat> = true;
template <>
inline constexpr bool kIsPlain<Affine> = true;
template <>
inline constexpr bool kIsPlain<Transform> = true;
template <>
inline constexpr bool kIsPlain<Aabb> = true;
template <>
inline constexpr bool kIsPlain<InfluenceGroup> = true;
template <>
inline constexpr bool kIsPlain<VariantMaterial> = true;

static_assert(sizeof(glm::vec3) == 12 && sizeof(glm::quat) == 16 && sizeof(Affine) == 48 && sizeof(Transform) == 40 &&
              sizeof(Aabb) == 24 && sizeof(InfluenceGroup) == 16 && sizeof(VariantMaterial) == 8);

/// The last value of each enumeration that files store; all start at 0.
constexpr auto last_of(Topology) noexcept { return Topology::triangles; }
constexpr auto last_of(AlphaMode) noexcept { return AlphaMode::blend; }
constexpr auto last_of(Filter) noexcept { return Filter::linear; }
constexpr auto last_of(Wrap) noexcept { return Wrap::mirrored_repeat; }
constexpr auto last_of(Light::Kind) noexcept { return Light::Kind::spot; }
constexpr auto last_of(Interpolation) noexcept { return Interpolation::squad; }
constexpr auto last_of(PropertyKind) noexcept { return PropertyKind::texture_scale; }
constexpr auto last_of(TextureSlot) noexcept { return TextureSlot::emissive; }
constexpr auto last_of(RotationMeasure) noexcept { return RotationMeasure::twist; }
constexpr auto last_of(RadialKernel) noexcept { return RadialKernel::thin_plate; }
constexpr auto last_of(PolynomialTail) noexcept { return PolynomialTail::affine; }

}  // namespace sinew
