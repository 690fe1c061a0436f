// SPDX-License-Identifier: MIT
#pragma once
/// Only vectors of three and four components. Headers of frames include this file instead of conventions.h, which would
/// add 13,000 lines of GLM to each source that runs frames.
#include <type_traits>

#include <glm/ext/vector_float3.hpp>
#include <glm/ext/vector_float4.hpp>

static_assert(sizeof(glm::vec3) == 12 && alignof(glm::vec3) == 4 && alignof(glm::vec4) == 4,
              "sinew needs GLM's packed types: do not define GLM_FORCE_DEFAULT_ALIGNED_GENTYPES.");
static_assert(std::is_same_v<glm::length_t, int>,
              "sinew needs GLM's lengths to be int: do not define GLM_FORCE_SIZE_T_LENGTH.");

namespace sinew {

template <class T>
using Vec3 = glm::vec<3, T, glm::defaultp>;
template <class T>
using Vec4 = glm::vec<4, T, glm::defaultp>;

// Declared only: conventions.h defines them.
template <class T>
using Quat = glm::qua<T, glm::defaultp>;
template <class T>
using Mat3 = glm::mat<3, 3, T, glm::defaultp>;
template <class T>
using Mat4 = glm::mat<4, 4, T, glm::defaultp>;

}  // namespace sinew
