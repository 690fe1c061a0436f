// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "runtime/c/glue/fields.h"
#include "runtime/c/input_room.h"

namespace sinew::c {

/// How refusals describe a list of C: its name, and the code and rule for a list that is too long.
struct ListName {
  const char* name;
  sinew_error too_long;
  const char* rule = nullptr;  ///< the rule that a list breaks which is too long
};

/// Reads a list into `room`. `entries` becomes the part of `room` that was filled.
/// err  SINEW_NULL_ARGUMENT, ListName::too_long, those of the fields
template <class OfC, class Own, class... F>
NotRead read_list(const ListName& list, const Fields<F...>& fields, const OfC* given, std::size_t count,
                  std::span<Own> room, std::span<const Own>& entries) noexcept {
  if (given == nullptr && count > 0) return refuse(SINEW_NULL_ARGUMENT, {.list = list.name});
  if (count > room.size()) return refuse(list.too_long, {.rule = list.rule, .list = list.name});
  for (std::size_t i = 0; i < count; ++i) {
    NotRead why = fields.read(given[i], room[i]);
    if (why.error == SINEW_OK) continue;
    why.where.list = list.name;
    why.where.index = static_cast<std::uint32_t>(i);
    return why;
  }
  entries = room.first(count);
  return {};
}

/// A list of an input: pointer and count in a C struct, a span in a C++ struct. Its converted entries are stored in a
/// member of InputRoom or InputRoomOfC.
template <auto Data, auto Count, auto Own, auto Room, auto RoomOfC, class Entry>
struct ListField {
  ListName list;
  Entry entry;

  NotRead read(const auto& given, const InputRoom& room, auto& own) const noexcept {
    return read_list(list, entry, given.*Data, given.*Count, room.*Room, own.*Own);
  }
  void write(const auto& own, const InputRoomOfC& room, auto& out) const noexcept {
    const auto entries = own.*Own;
    for (std::size_t i = 0; i < entries.size(); ++i) entry.write(entries[i], (room.*RoomOfC)[i]);
    out.*Data = entries.empty() ? nullptr : (room.*RoomOfC).data();
    out.*Count = entries.size();
  }
};
template <auto Data, auto Count, auto Own, auto Room, auto RoomOfC, class Entry>
constexpr ListField<Data, Count, Own, Room, RoomOfC, Entry> list_field(const ListName& list,
                                                                       const Entry& entry) noexcept {
  return {list, entry};
}

}  // namespace sinew::c
