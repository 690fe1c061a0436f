// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace sinew::fuzz {

/// Changes bytes in place, may grow them up to `max_size`; answers the new size. libFuzzer's own mutator has this form.
using MutateBytes = std::function<std::size_t(std::uint8_t* data, std::size_t size, std::size_t max_size)>;

/// One change that keeps the text JSON: a number, word or name replaced by another, values swapped, copied, repeated or
/// dropped, a string's bytes changed. Text that is no JSON comes back as it was.
std::string mutate_json(const std::string& text, std::uint64_t seed, const MutateBytes& mutate_bytes);

}  // namespace sinew::fuzz
