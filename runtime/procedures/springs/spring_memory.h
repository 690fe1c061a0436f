// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "runtime/math/transform.h"
#include "runtime/procedures/springs/spring_inputs.h"
#include "runtime/procedures/springs/spring_records.h"

namespace sinew::springs {

/// Clock and sleep state of a character.
struct Clock {
  double left_s;          ///< seconds of past frames that no tick has simulated yet; slightly below 0 after rounding
  double before_s;        ///< seconds of the previous frame; 0 = unknown
  std::uint32_t started;  ///< 0 before the first frame
  std::uint32_t asleep;
  std::uint32_t at_rest;      ///< all joints had rest transforms in the last frame, so `read` was not written
  std::uint32_t quiet_ticks;  ///< consecutive ticks in which nothing moved or changed
  std::uint64_t sleeps;       ///< how often the springs fell asleep
  Affined root;               ///< root transform of the last frame
};

/// A collider in the world.
struct WorldShape {
  SpringCollider::Kind kind;
  bool inside;
  Vec at;          ///< centre, first end, or a point of the plane
  Vec along;       ///< capsule: to the second end; plane: the normal
  double inverse;  ///< 1 / |along|^2, or 0 if `along` is zero
  double radius;
};

}  // namespace sinew::springs

namespace sinew {

/// Divides a character's state and the working memory into arrays. All element types are trivially copyable.
struct SpringMemory {
  springs::Clock* clock = nullptr;
  std::span<springs::InputFrame> before;   ///< [frames] of the frame before
  std::span<springs::InputFrame> earlier;  ///< [frames] of the frame before that
  springs::Planes<double> tails;           ///< tail::Plane by slots
  std::span<float> written;                ///< [4][records] rotations that the last frame wrote
  std::span<Transform> read;               ///< [records] local transforms that the last frame read

  std::span<Affined> ancestors;              ///< [ancestors]
  std::span<springs::InputFrame> now;        ///< [frames] of this frame
  std::span<springs::MatrixFrame> matrices;  ///< [frames] for colliders, at the time of a tick
  std::span<springs::WorldShape> shapes;     ///< [colliders]
  springs::Planes<double> frames;            ///< transforms of input frames and joints by slots, at the time of a tick
  springs::Planes<double> inputs;            ///< input::Plane by slots
  springs::Planes<double> next;              ///< tail::now and tail::end after a tick, by slots
  springs::Planes<double> shown;             ///< shown::Plane by slots

  SpringMemory(const SpringTables& tables, std::byte* state, std::byte* scratch) noexcept {
    Cutter keep{state}, work{scratch};
    cut(tables, keep, work);
  }
  static std::size_t state_bytes(const SpringTables& tables) noexcept { return bytes(tables).state; }
  static std::size_t scratch_bytes(const SpringTables& tables) noexcept { return bytes(tables).scratch; }

 private:
  struct Bytes {
    std::size_t state, scratch;
  };
  struct Cutter {
    std::byte* memory = nullptr;
    std::size_t used = 0;

    template <class T>
    std::span<T> take(std::size_t count) noexcept {
      static_assert(alignof(T) <= 8);
      T* first = memory ? reinterpret_cast<T*>(memory + used) : nullptr;
      used += (count * sizeof(T) + 7) / 8 * 8;
      return {first, memory ? count : 0};
    }
  };

  SpringMemory() = default;

  static Bytes bytes(const SpringTables& tables) noexcept {
    Cutter keep, work;
    SpringMemory().cut(tables, keep, work);
    return {keep.used, work.used};
  }

  static springs::Planes<double> planes(Cutter& from, const SpringTables& tables, std::size_t count) noexcept {
    return {from.take<double>(count * tables.slots.stride).data(), tables.slots.stride};
  }

  void cut(const SpringTables& tables, Cutter& keep, Cutter& work) noexcept {
    const std::size_t frame_count = tables.frames.size(), records = tables.records.size();
    clock = keep.take<springs::Clock>(1).data();
    before = keep.take<springs::InputFrame>(frame_count);
    earlier = keep.take<springs::InputFrame>(frame_count);
    tails = planes(keep, tables, springs::tail::count);
    written = keep.take<float>(4 * records);
    read = keep.take<Transform>(records);
    ancestors = work.take<Affined>(tables.ancestors.size());
    now = work.take<springs::InputFrame>(frame_count);
    matrices = work.take<springs::MatrixFrame>(frame_count);
    shapes = work.take<springs::WorldShape>(tables.colliders.size());
    frames = planes(work, tables, springs::kFramePlanes);
    inputs = planes(work, tables, springs::input::count);
    next = planes(work, tables, springs::tail::count - springs::tail::now);
    shown = planes(work, tables, springs::shown::count);
  }
};

}  // namespace sinew
