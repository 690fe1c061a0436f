// SPDX-License-Identifier: MIT
// The libFuzzer program: the environment variable SINEW_FUZZ_TARGET names the target.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "importer/file/glb_container.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/geometry_mutator.h"
#include "tests/fuzz/json_mutator.h"
#include "tests/importer/glb_seeds.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace {

using namespace sinew;

const fuzz::Target& chosen_target() {
  static const fuzz::Target& chosen = [&]() -> const fuzz::Target& {
    const char* name = std::getenv("SINEW_FUZZ_TARGET");
    for (const fuzz::Target& target : fuzz::targets())
      if (name != nullptr && target.name == name) return target;
    std::fprintf(stderr, "sinew-fuzz: set SINEW_FUZZ_TARGET to one of the targets\n");
    std::exit(2);
  }();
  return chosen;
}

std::string text_of(fuzz::Bytes bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

/// Replaces the input by `out` if it fits.
std::optional<std::size_t> put(const void* out, std::size_t size, std::uint8_t* data, std::size_t max_size) {
  if (size == 0 || size > max_size) return std::nullopt;
  std::memcpy(data, out, size);
  return size;
}

std::optional<std::size_t> change_json(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed) {
  const std::string text = fuzz::mutate_json(text_of(std::as_bytes(std::span(data, size))), seed, LLVMFuzzerMutate);
  return put(text.data(), text.size(), data, max_size);
}

/// Changes one part of the container and corrects its lengths, so that the code behind the container check runs.
std::optional<std::size_t> change_glb(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed) {
  IssueLog log;
  const auto parts = open_glb(std::as_bytes(std::span(data, size)), log);
  if (!parts) return std::nullopt;
  std::string json = text_of(parts->json);
  std::vector<std::byte> bin;
  if (parts->bin) bin.assign(parts->bin->begin(), parts->bin->end());
  if (seed % 4 == 0 && !bin.empty()) {
    const std::size_t used = bin.size();
    bin.resize(used + 64);
    bin.resize(LLVMFuzzerMutate(reinterpret_cast<std::uint8_t*>(bin.data()), used, bin.size()));
  } else {
    json = fuzz::mutate_json(json, seed, LLVMFuzzerMutate);
  }
  const std::vector<std::byte> file = test::make_glb(std::move(json), std::move(bin));
  return put(file.data(), file.size(), data, max_size);
}

std::optional<std::size_t> change_geometry(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed) {
  const auto file = fuzz::mutate_geometry(std::as_bytes(std::span(data, size)), seed, LLVMFuzzerMutate);
  return put(file.data(), file.size(), data, max_size);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  chosen_target().run(std::as_bytes(std::span(data, size)));
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed) {
  std::optional<std::size_t> changed;
  if (seed % 5 != 0) {  // otherwise changes bytes, to test the code before JSON parsing
    const std::string_view name = chosen_target().name;
    if (name == "geometry") changed = change_geometry(data, size, max_size, seed / 5);
    if (name == "glb") changed = change_glb(data, size, max_size, seed / 5);
    if (name == "json" || name == "poses" || name == "graphs") changed = change_json(data, size, max_size, seed / 5);
  }
  return changed ? *changed : LLVMFuzzerMutate(data, size, max_size);
}
