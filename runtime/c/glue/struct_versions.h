// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstring>

#include "runtime/c/frame.h"
#include "runtime/c/jobs.h"
#include "runtime/c/mirror.h"
#include "runtime/c/pages.h"
#include "runtime/c/plan.h"
#include "runtime/c/result.h"
#include "runtime/c/retarget.h"
#include "runtime/c/skeleton_lod.h"
#include "runtime/c/types.h"

// Reads and writes structs that grow (types.h). The caller's version may be older or newer than that of the library.

namespace sinew::c {

/// Bytes of a struct's first version; no caller has a smaller one. For a struct that has grown, its old size is listed
/// here. New fields begin at that size, not in the padding of the old struct.
template <class T>
inline constexpr std::size_t kFirstVersionBytes = sizeof(T);
template <>
inline constexpr std::size_t kFirstVersionBytes<sinew_needs> = offsetof(sinew_needs, skeleton_lod);
template <>
inline constexpr std::size_t kFirstVersionBytes<sinew_frame_input> = offsetof(sinew_frame_input, next_layers);
template <>
inline constexpr std::size_t kFirstVersionBytes<sinew_instance_result> = offsetof(sinew_instance_result, from_cache);
template <>
inline constexpr std::size_t kFirstVersionBytes<sinew_jobs_options> = offsetof(sinew_jobs_options, own_thread);
template <>
inline constexpr std::size_t kFirstVersionBytes<sinew_page_window> = offsetof(sinew_page_window, plan);
template <>
inline constexpr std::size_t kFirstVersionBytes<sinew_result_info> = offsetof(sinew_result_info, local);
template <>
inline constexpr std::size_t kFirstVersionBytes<sinew_skeleton_lod_info> = offsetof(sinew_skeleton_lod_info,
                                                                                    tolerance_m);

template <>
inline constexpr std::size_t kFirstVersionBytes<sinew_mirror_info> = offsetof(sinew_mirror_info, reference);
template <>
inline constexpr std::size_t kFirstVersionBytes<sinew_skeleton_map_options> = offsetof(sinew_skeleton_map_options,
                                                                                       source_reference);
template <>
inline constexpr std::size_t kFirstVersionBytes<sinew_skeleton_map_info> = offsetof(sinew_skeleton_map_info,
                                                                                    source_reference);

/// Copies a struct of the caller's version into one of ours. Fields that the caller's version lacks keep their default
/// in `out`. Null leaves all defaults.
/// err  SINEW_WRONG_STRUCT_SIZE (smaller than the first version, or newer than this library and not zero in the new
///      part)
template <class T>
sinew_error read_struct(const T* given, T& out) noexcept {
  if (given == nullptr) return SINEW_OK;
  const std::size_t size = given->struct_size, known = std::min(size, sizeof(T));
  if (size < kFirstVersionBytes<T>) return SINEW_WRONG_STRUCT_SIZE;
  const auto* bytes = reinterpret_cast<const unsigned char*>(given);
  if (std::any_of(bytes + known, bytes + size, [](unsigned char byte) { return byte != 0; }))
    return SINEW_WRONG_STRUCT_SIZE;
  std::memcpy(&out, given, known);
  return SINEW_OK;
}

/// Element `i` of a caller's array. Its elements are struct_size bytes apart, the size of the caller's version.
/// err  SINEW_WRONG_STRUCT_SIZE (an element of another size than the first one)
template <class T>
sinew_error element_of(const T* given, std::size_t i, const T*& element) noexcept {
  const std::size_t stride = given->struct_size;
  if (stride < kFirstVersionBytes<T> || stride % alignof(T) != 0) return SINEW_WRONG_STRUCT_SIZE;
  element = reinterpret_cast<const T*>(reinterpret_cast<const unsigned char*>(given) + i * stride);
  return element->struct_size == stride ? SINEW_OK : SINEW_WRONG_STRUCT_SIZE;
}

/// Copies a struct of ours into one of the caller's version. Fields that ours lacks become zero.
template <class T>
sinew_error write_struct(T value, T* out) noexcept {
  if (out == nullptr) return SINEW_NULL_ARGUMENT;
  const std::size_t size = out->struct_size, known = std::min(size, sizeof(T));
  if (size < kFirstVersionBytes<T>) return SINEW_WRONG_STRUCT_SIZE;
  value.struct_size = size;
  std::memcpy(out, &value, known);
  std::memset(reinterpret_cast<unsigned char*>(out) + known, 0, size - known);
  return SINEW_OK;
}

}  // namespace sinew::c
