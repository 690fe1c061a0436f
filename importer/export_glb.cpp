// SPDX-License-Identifier: MIT
#include "importer/export_glb.h"

#include <cstring>
#include <fstream>
#include <sstream>

#include "importer/write/write_scene.h"

namespace sinew {
namespace {

constexpr std::uint64_t kLargestGlb = 0xffffffffu;  // lengths in a GLB are 32-bit (G67)

ImportError failure(ImportIssue issue) { return {"", std::move(issue), {}}; }

}  // namespace

ImportResult<std::vector<std::byte>> export_glb(const Scene& scene) {
  tinygltf::Model model;
  model.asset.version = "2.0";
  model.asset.generator = "sinew";
  write::GlbBuffer buffer(model);
  write::write_images(scene, model, buffer);
  write::write_materials(scene, model);
  write::write_meshes(scene, model, buffer);
  write::write_cameras_and_lights(scene, model);
  const std::vector<int> node_of_instance = write::write_nodes(scene, model, buffer);
  if (auto issue = write::write_animations(scene, node_of_instance, model, buffer)) return tl::unexpected(failure(*std::move(issue)));
  if (model.buffers[0].data.size() + (std::uint64_t{1} << 20) > kLargestGlb)
    return tl::unexpected(failure({Severity::error, "glb-size", "/buffers/0", "the binary part does not fit into a GLB of 4 GiB"}));
  if (model.buffers[0].data.empty()) model.buffers.clear();

  std::ostringstream stream;
  tinygltf::TinyGLTF writer;
  if (!writer.WriteGltfSceneToStream(&model, stream, false, true))
    return tl::unexpected(failure({Severity::error, "write-file", "", "the scene could not be written"}));
  const std::string text = std::move(stream).str();
  std::vector<std::byte> bytes(text.size());
  std::memcpy(bytes.data(), text.data(), text.size());
  return bytes;
}

ImportResult<std::size_t> export_glb(const Scene& scene, const std::filesystem::path& file) {
  auto bytes = export_glb(scene);
  if (!bytes) return tl::unexpected(std::move(bytes).error());
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes->data()), static_cast<std::streamsize>(bytes->size()));
  out.flush();
  if (!out) return tl::unexpected(ImportError{file.string(), {Severity::error, "write-file", "", "cannot write the file"}, {}});
  return bytes->size();
}

}  // namespace sinew
