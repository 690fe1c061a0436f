// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "viewer/device/device_error.h"

namespace sinew::viewer {

/// Calls a Vulkan enumeration function twice: for the count, then for the entries, of which there may be fewer by then.
/// in   call  (std::uint32_t* count, T* entries) -> VkResult
/// err  DeviceError with `what`
template <typename T, typename Call>
std::vector<T> listed(const char* what, const Call& call) {
  std::uint32_t count = 0;
  must(call(&count, nullptr), what);
  std::vector<T> entries(count);
  must(call(&count, entries.data()), what);
  entries.resize(count);
  return entries;
}

}  // namespace sinew::viewer
