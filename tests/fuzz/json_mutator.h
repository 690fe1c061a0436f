// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace sinew::fuzz {

/// Changes bytes in place and may grow them up to `max_size`; returns the new size. It has the signature of libFuzzer's
/// own mutator.
using MutateBytes = std::function<std::size_t(std::uint8_t* data, std::size_t size, std::size_t max_size)>;

/// Makes one to three changes that keep the text JSON. A change replaces a number, word or name, swaps, copies, repeats
/// or drops values, changes a string's bytes, or adds a member of glTF or an extension. Text that is not JSON is
/// returned unchanged.
std::string mutate_json(const std::string& text, std::uint64_t seed, const MutateBytes& mutate_bytes);

}  // namespace sinew::fuzz
