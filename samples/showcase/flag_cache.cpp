// SPDX-License-Identifier: MIT
#include "samples/showcase/showcase.h"

namespace sinew::showcase {
namespace {

constexpr unsigned char kBytes[] = {
#include "flag_cache.inc"  // of sinew-bake-flag
};

}  // namespace

std::span<const std::byte> flag_cache() { return std::as_bytes(std::span(kBytes)); }

}  // namespace sinew::showcase
