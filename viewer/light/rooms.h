// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

#include "viewer/light/environment.h"

namespace sinew::viewer {

/// A built-in environment, computed by code from a fixed seed. Its sky is the same on every machine.
enum class Room : std::uint8_t {
  studio,   ///< a neutral room: a large soft light behind and above, weaker ones at the sides, a dim floor
  sunset,   ///< outdoors: a low warm sun, a sky from orange to blue, thin clouds
  overcast  ///< outdoors under even clouds: no sun and no shadows
};

/// "studio", "sunset", "overcast"
std::string_view name_of(Room room) noexcept;

/// The room of that name; empty if there is none.
std::optional<Room> room_named(std::string_view name) noexcept;

/// The radiance of a room from all directions.
CubeMap sky_of(Room room);

/// Adds a room's key light and backdrop to an environment that was prefiltered from its sky.
std::shared_ptr<const Environment> furnished(Room room, std::shared_ptr<Environment> filtered);

/// The environment of a room. Each room is computed once and shared.
std::shared_ptr<const Environment> room_environment(Room room);

}  // namespace sinew::viewer
