// SPDX-License-Identifier: MIT
#include "viewer/app/load_environment.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "viewer/light/panorama.h"

namespace sinew::viewer {
namespace {

constexpr std::uint32_t kFaceSize = 256;

}  // namespace

tl::expected<std::shared_ptr<const Environment>, std::string> load_environment(const std::string& name) {
  if (name == "studio") return studio_environment();
  if (name == "plain") return plain_environment();
  if (name == "none") return nullptr;
  std::error_code error;
  if (!std::filesystem::is_regular_file(name, error))
    return tl::unexpected(name + ": there is no such file, and the built-in environments are studio, plain and none");
  std::ifstream in(name, std::ios::binary);
  const std::vector<char> bytes(std::istreambuf_iterator<char>(in), {});
  if (!in) return tl::unexpected(name + ": cannot be read");
  const auto panorama = decode_panorama(std::as_bytes(std::span(bytes)));
  if (!panorama) return tl::unexpected(name + ": " + panorama.error());
  return make_environment(cube_from(*panorama, kFaceSize));
}

}  // namespace sinew::viewer
