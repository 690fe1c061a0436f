// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "runtime/c/glue/convert.h"

// Descriptions of the fields of a C struct, each with the member of a C++ struct that it corresponds to.

namespace sinew::c {

/// The member at the end of a path: member_of<&Needs::in, &Inputs::cut>(needs) is needs.in.cut.
template <auto First, auto... Rest>
constexpr auto& member_of(auto& object) noexcept {
  if constexpr (sizeof...(Rest) == 0)
    return object.*First;
  else
    return member_of<Rest...>(object.*First);
}

/// A field of C and the member of C++ that it converts to and from (conversion.h).
template <auto OfC, auto... Own>
struct Field {
  const char* name = nullptr;  ///< the name that refusals show

  sinew_error read(const auto& given, auto& own) const { return from_c(given.*OfC, member_of<Own...>(own)); }
  void write(const auto& own, auto& out) const noexcept { out.*OfC = to_c(member_of<Own...>(own)); }
};
template <auto OfC, auto... Own>
constexpr Field<OfC, Own...> field(const char* name = nullptr) noexcept {
  return {name};
}

/// Two fields of C, pointer and count, and the span or vector of C++ that they correspond to.
template <auto Data, auto Count, auto... Own>
struct SpanField {
  const char* name = nullptr;

  sinew_error read(const auto& given, auto& own) const {
    if (given.*Data == nullptr && given.*Count > 0) return SINEW_NULL_ARGUMENT;
    auto& array = member_of<Own...>(own);
    using Array = std::remove_reference_t<decltype(array)>;
    static_assert(kSameBytes<std::remove_cvref_t<decltype(*(given.*Data))>, typename Array::value_type>);
    if constexpr (requires { typename Array::allocator_type; }) {
      const auto* first = reinterpret_cast<typename Array::const_pointer>(given.*Data);
      array.assign(first, first + given.*Count);
    } else {
      array = {reinterpret_cast<typename Array::pointer>(given.*Data), given.*Count};
    }
    return SINEW_OK;
  }
  void write(const auto& own, auto& out) const noexcept {
    const auto& array = member_of<Own...>(own);
    out.*Data = reinterpret_cast<std::remove_reference_t<decltype(out.*Data)>>(array.data());
    out.*Count = array.size();
  }
};
template <auto Data, auto Count, auto... Own>
constexpr SpanField<Data, Count, Own...> span_field(const char* name = nullptr) noexcept {
  return {name};
}

/// A bit of a field of C, and the bool of C++ that it corresponds to.
template <auto OfC, std::uint32_t Bit, auto... Own>
struct BitField {
  static constexpr std::uint32_t bit = Bit;
  const char* name = nullptr;

  sinew_error read(const auto& given, auto& own) const noexcept {
    member_of<Own...>(own) = (given.*OfC & Bit) != 0;
    return SINEW_OK;
  }
  void write(const auto& own, auto& out) const noexcept {
    if (member_of<Own...>(own)) out.*OfC |= Bit;
  }
};

/// Two fields of C, pointer and count. Their elements are converted one by one into a vector of C++. They are read,
/// never written.
template <auto Data, auto Count, auto Own, class Entry>
struct CopiedField {
  Entry entry;
  const char* name = nullptr;

  sinew_error read(const auto& given, auto& own) const {
    if (given.*Data == nullptr && given.*Count > 0) return SINEW_NULL_ARGUMENT;
    (own.*Own).resize(given.*Count);
    for (std::size_t i = 0; i < given.*Count; ++i)
      if (const sinew_error error = entry.read((given.*Data)[i], (own.*Own)[i]).error) return error;
    return SINEW_OK;
  }
  void write(const auto&, auto&) const noexcept {}
};
template <auto Data, auto Count, auto Own, class Entry>
constexpr CopiedField<Data, Count, Own, Entry> copied_field(const Entry& entry) noexcept {
  return {entry};
}

}  // namespace sinew::c
