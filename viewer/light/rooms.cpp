// SPDX-License-Identifier: MIT
#include "viewer/light/rooms.h"

#include <array>
#include <utility>

#include "viewer/light/outdoor_skies.h"
#include "viewer/light/studio_sky.h"

namespace sinew::viewer {
namespace {

constexpr std::uint32_t kSkySize = 128;  // enough, because lights and clouds have soft edges
constexpr std::array kRooms = {Room::studio, Room::sunset, Room::overcast};

/// The studio's backdrop is darker than its light, so that white models stand out from it.
constexpr float kStudioBackdrop = 0.22f;

}  // namespace

std::string_view name_of(Room room) noexcept {
  switch (room) {
    case Room::studio: return "studio";
    case Room::sunset: return "sunset";
    case Room::overcast: break;
  }
  return "overcast";
}

std::optional<Room> room_named(std::string_view name) noexcept {
  for (const Room room : kRooms)
    if (name == name_of(room)) return room;
  return std::nullopt;
}

CubeMap sky_of(Room room) {
  switch (room) {
    case Room::studio: return cube_of(kSkySize, studio_radiance);
    case Room::sunset: return cube_of(kSkySize, sunset_radiance);
    case Room::overcast: break;
  }
  return cube_of(kSkySize, overcast_radiance);
}

std::shared_ptr<const Environment> furnished(Room room, std::shared_ptr<Environment> filtered) {
  switch (room) {
    case Room::studio:
      filtered->key = kStudioKey;
      filtered->backdrop = kStudioBackdrop;
      break;
    case Room::sunset: filtered->key = kSun; break;
    case Room::overcast: filtered->key = KeyLight{{0.0f, 1.0f, 0.0f}, glm::vec3(0.0f)}; break;
  }
  return filtered;
}

std::shared_ptr<const Environment> room_environment(Room room) {
  static const auto make = [](Room made) { return furnished(made, make_environment(sky_of(made))); };
  switch (room) {
    case Room::studio: {
      static const std::shared_ptr<const Environment> studio = make(Room::studio);
      return studio;
    }
    case Room::sunset: {
      static const std::shared_ptr<const Environment> sunset = make(Room::sunset);
      return sunset;
    }
    case Room::overcast: break;
  }
  static const std::shared_ptr<const Environment> overcast = make(Room::overcast);
  return overcast;
}

std::shared_ptr<const Environment> studio_environment() { return room_environment(Room::studio); }

}  // namespace sinew::viewer
