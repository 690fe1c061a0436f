// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "viewer/light/environment.h"

namespace sinew::viewer {

/// Names everything that a prepared environment depends on: the sky, bit by bit, and how environments are made.
std::uint64_t environment_key(const CubeMap& sky);

/// What takes long to make of an environment, as bytes: diffuse light, the filtered levels, the table of the split sum.
std::vector<std::byte> stored_parts(const Environment& environment);

/// The environment of a sky with its stored parts: the same bits as make_environment gives. Null when the bytes have
/// another size.
std::shared_ptr<const Environment> whole_environment(CubeMap sky, std::span<const std::byte> parts);

}  // namespace sinew::viewer
