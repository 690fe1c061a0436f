// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <tuple>

#include "runtime/c/glue/field.h"
#include "runtime/c/glue/not_read.h"
#include "runtime/c/glue/struct_versions.h"

// Describes a C struct and the C++ struct that it corresponds to, field by field. Reading, writing and defaults all use
// this one list.

namespace sinew::c {

/// The fields of a struct: those of field.h, and any other type with `name`, `read` and `write`. If a field has a
/// `rule`, its refusal states that rule.
template <class... F>
struct Fields {
  std::tuple<F...> all;

  /// Reads the fields in their order, until one is refused.
  NotRead read(const auto& given, auto& own) const {
    NotRead why;
    const auto is_read = [&](const auto& one) {
      const sinew_error error = one.read(given, own);
      if (error != SINEW_OK) why = refuse(error, {.field = one.name, .rule = rule_of(one)});
      return error == SINEW_OK;
    };
    std::apply([&](const auto&... one) { static_cast<void>((is_read(one) && ...)); }, all);
    return why;
  }

  static constexpr std::uint32_t bit_of(const auto& one) noexcept {
    if constexpr (requires { one.bit; })
      return one.bit;
    else
      return 0;
  }
  static constexpr const char* rule_of(const auto& one) noexcept {
    if constexpr (requires { one.rule; })
      return one.rule;
    else
      return nullptr;
  }

  /// The bits of all BitFields in the list.
  constexpr std::uint32_t bits() const noexcept {
    return std::apply([](const auto&... one) { return (bit_of(one) | ...); }, all);
  }

  void write(const auto& own, auto& out) const noexcept {
    std::apply([&](const auto&... one) { (one.write(own, out), ...); }, all);
  }
};
template <class... F>
constexpr Fields<F...> fields(F... one) noexcept {
  return {{one...}};
}

/// Makes the C struct that stands for a C++ struct, for example to return the defaults.
template <class OfC, class Own, class... F>
OfC written(const Fields<F...>& fields, const Own& own) noexcept {
  OfC out{};
  if constexpr (requires { out.struct_size; }) out.struct_size = sizeof(OfC);
  fields.write(own, out);
  return out;
}

/// Writes a C struct of the caller's version.
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE
template <class OfC, class Own, class... F>
sinew_error write_fields(const Fields<F...>& fields, const Own& own, OfC* out) noexcept {
  return write_struct(written<OfC>(fields, own), out);
}

/// Reads a C struct of the caller's version. Fields that this version lacks keep their value in `own`; so do all if
/// `given` is null.
/// err  SINEW_WRONG_STRUCT_SIZE, those of the fields
template <class OfC, class Own, class... F>
sinew_error read_fields(const OfC* given, const Fields<F...>& fields, Own& own) {
  OfC known = written<OfC>(fields, own);
  if (const sinew_error error = read_struct(given, known)) return error;
  return fields.read(known, own).error;
}

}  // namespace sinew::c
