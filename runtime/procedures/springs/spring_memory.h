// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "runtime/math/transform.h"
#include "runtime/procedures/springs/spring_inputs.h"
#include "runtime/procedures/springs/spring_records.h"

namespace sinew::springs {

/// Time and sleep of one character.
struct Clock {
  double left_s;          ///< time of frames that no tick has covered; slightly below 0 after rounding
  double before_s;        ///< length of the frame before; 0 = there is no frame before that
  std::uint32_t started;  ///< 0 before the first frame
  std::uint32_t asleep;
  std::uint32_t at_rest;      ///< all joints had their rest transforms in the last frame; `read` was not written
  std::uint32_t quiet_ticks;  ///< ticks in a row in which nothing moved or changed
  std::uint64_t sleeps;       ///< how often the springs fell asleep
  Affined root;               ///< of the last frame
};

/// A tail in the space of its centre: now, and a tick before.
struct Tail {
  Vec now, before;
  Vec end;  ///< end of the bone now, in the space of the frame that the chain hangs on
};

/// A tail after a tick, as Tail::now and Tail::end.
struct NextTail {
  Vec now, end;
};

/// A collider in the world.
struct WorldShape {
  SpringCollider::Kind kind;
  bool inside;
  Vec at;          ///< centre, first end, or a point of the plane
  Vec along;       ///< capsule: to the second end; plane: the normal
  double inverse;  ///< 1 / |along|^2; 0 if that is none
  double radius;
};

}  // namespace sinew::springs

namespace sinew {

static_assert(sizeof(springs::UniformFrame) <= sizeof(springs::MatrixFrame));  // which the memory is made for

/// Cuts a character's state and the working memory into arrays. All element types are trivially copyable.
struct SpringMemory {
  springs::Clock* clock = nullptr;
  std::span<springs::InputFrame> before;   ///< [frames] of the frame before
  std::span<springs::InputFrame> earlier;  ///< [frames] of the frame before that
  std::span<springs::Tail> tails;          ///< [records]
  std::span<springs::Rot> shown;           ///< [records] result of the last frame
  std::span<Transform> read;               ///< [records] local transforms of the last frame

  std::span<Affined> ancestors;            ///< [ancestors]
  std::span<springs::InputFrame> now;      ///< [frames] of this frame
  std::span<springs::MatrixFrame> frames;  ///< [frames] at the time of a tick
  std::span<springs::MatrixFrame> joints;  ///< [records] at the time of a tick
  std::span<springs::WorldShape> shapes;   ///< [colliders]
  std::span<springs::JointInput> inputs;   ///< [records]
  std::span<springs::NextTail> next;       ///< [records] tails after a tick

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

  void cut(const SpringTables& tables, Cutter& keep, Cutter& work) noexcept {
    const std::size_t frame_count = tables.frames.size(), records = tables.records.size();
    clock = keep.take<springs::Clock>(1).data();
    before = keep.take<springs::InputFrame>(frame_count);
    earlier = keep.take<springs::InputFrame>(frame_count);
    tails = keep.take<springs::Tail>(records);
    shown = keep.take<springs::Rot>(records);
    read = keep.take<Transform>(records);
    ancestors = work.take<Affined>(tables.ancestors.size());
    now = work.take<springs::InputFrame>(frame_count);
    frames = work.take<springs::MatrixFrame>(frame_count);
    joints = work.take<springs::MatrixFrame>(records);
    shapes = work.take<springs::WorldShape>(tables.colliders.size());
    inputs = work.take<springs::JointInput>(records);
    next = work.take<springs::NextTail>(records);
  }
};

}  // namespace sinew
