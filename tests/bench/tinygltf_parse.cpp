// SPDX-License-Identifier: MIT
#include "tests/bench/tinygltf_parse.h"

#include <string>
#include <vector>

#include "importer/file/tinygltf.h"

namespace sinew::bench {
namespace {

bool leave_image(tinygltf::Image*, const int, std::string*, std::string*, int, int, const unsigned char*, int, void*) {
  return true;
}

template <class Load>
int parse(Load load) {
  tinygltf::Model model;
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader(leave_image, nullptr);
  std::string error, warning;
  return load(loader, &model, &error, &warning) ? static_cast<int>(model.nodes.size()) : -1;
}

}  // namespace

int parse_with_tinygltf(std::span<const std::byte> glb) {
  return parse([&](tinygltf::TinyGLTF& loader, auto... out) {
    return loader.LoadBinaryFromMemory(out..., reinterpret_cast<const unsigned char*>(glb.data()),
                                       static_cast<unsigned int>(glb.size()));
  });
}

int parse_with_tinygltf(const std::filesystem::path& file) {
  return parse([&](tinygltf::TinyGLTF& loader, auto... out) {
    return file.extension() == ".glb" ? loader.LoadBinaryFromFile(out..., file.string())
                                      : loader.LoadASCIIFromFile(out..., file.string());
  });
}

}  // namespace sinew::bench
