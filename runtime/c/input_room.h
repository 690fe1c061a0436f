// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "runtime/c/frame.h"
#include "runtime/c/handles.h"
#include "runtime/plan/frame_input.h"

namespace sinew::c {

/// `bytes`, rounded up to a multiple of the alignment of arrays.
constexpr std::size_t aligned(std::size_t bytes) noexcept {
  return (bytes + SINEW_FRAME_ALIGNMENT - 1) / SINEW_FRAME_ALIGNMENT * SINEW_FRAME_ALIGNMENT;
}

/// A linear allocator of arrays.
struct Block {
  std::byte* start = nullptr;  ///< at a multiple of SINEW_FRAME_ALIGNMENT; null: take() only counts bytes
  std::size_t used = 0;

  template <class T>
  std::span<T> take(std::size_t count) {
    std::span<T> taken;
    if (start != nullptr) {
      taken = {reinterpret_cast<T*>(start + used), count};
      std::uninitialized_value_construct(taken.begin(), taken.end());
    }
    used += aligned(count * sizeof(T));
    return taken;
  }
};

/// Room for the C++ lists of one frame input, as long as the plan's needs allow.
struct InputRoom {
  InputRoom(const sinew_plan& plan, Block& block);

  std::span<ClipLayer> layers, next_layers;
  std::span<GeometryInput> geometry;
  std::span<ExternalPose> externals;
  std::span<JointOverrides> overrides;
  std::span<PoseProcedure> procedures;
  std::span<PoseMask> masks;
};

/// Room for the C lists of one frame input. It has none for procedures, since inputs refer to the caller's own list.
struct InputRoomOfC {
  InputRoomOfC(const sinew_plan& plan, Block& block);

  std::span<sinew_layer> layers, next_layers;
  std::span<const sinew_page*> pages, next_pages;  ///< pages of layers and of next layers
  std::span<sinew_geometry_input> geometry;
  std::span<sinew_external_pose> externals;
  std::span<sinew_joint_overrides> overrides;
  std::span<sinew_pose_mask> masks;
  sinew_program_inputs* program_inputs;
};

/// An InputRoom or InputRoomOfC that owns its memory.
template <class Room>
class OwnRoom {
 public:
  explicit OwnRoom(const sinew_plan& plan) : memory_(lines_of(plan)), room_(room_in(plan, memory_)) {}
  OwnRoom(OwnRoom&&) noexcept = default;

  const Room& room() const noexcept { return room_; }

 private:
  struct alignas(SINEW_FRAME_ALIGNMENT) Line {
    std::byte bytes[SINEW_FRAME_ALIGNMENT];
  };

  static std::size_t lines_of(const sinew_plan& plan) {
    Block counted;
    Room(plan, counted);
    return counted.used / sizeof(Line);
  }
  static Room room_in(const sinew_plan& plan, std::vector<Line>& memory) {
    Block block{reinterpret_cast<std::byte*>(memory.data())};
    return Room(plan, block);
  }

  std::vector<Line> memory_;
  Room room_;
};

}  // namespace sinew::c
