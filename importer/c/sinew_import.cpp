// SPDX-License-Identifier: MIT
#include "importer/c/sinew_import.h"

#include <memory>
#include <string>
#include <vector>

#include "importer/import_gltf.h"
#include "runtime/c/boundary.h"
#include "runtime/c/handles.h"

using namespace sinew;

namespace {

ImportOptions options_from(const sinew_import_options& given) {
  ImportOptions options;
  options.decode_images = given.decode_images != 0;
  options.make_normals = given.make_normals != 0;
  options.make_tangents = given.make_tangents != 0;
  options.make_centers_of_rotation = given.make_centers_of_rotation != 0;
  options.max_file_bytes = given.max_file_bytes;
  options.max_unpacked_bytes = given.max_unpacked_bytes;
  return options;
}

std::unique_ptr<sinew_messages> messages_of(const ImportResult<ImportedFile>& file, const std::string& name) {
  auto messages = std::make_unique<sinew_messages>();
  const auto add = [&](const std::vector<ImportIssue>& issues) {
    for (const ImportIssue& issue : issues) messages->lines.push_back(describe(name, issue));
  };
  if (file) {
    add(file->warnings);
    return messages;
  }
  add({file.error().issue});
  add(file.error().more_errors);
  add(file.error().warnings);
  return messages;
}

/// in   read(options)  runs the import
template <class Read>
sinew_error import(const std::string& name, const sinew_import_options* options, sinew_scene** scene,
                   sinew_messages** messages, Read&& read) {
  sinew_import_options given = sinew_default_import_options();
  if (const sinew_error error = c::read_struct(options, given); error != SINEW_OK) return error;
  ImportResult<ImportedFile> file = read(options_from(given));
  std::unique_ptr<sinew_messages> said = messages != nullptr ? messages_of(file, name) : nullptr;
  if (file) *scene = new sinew_scene{std::move(file->scene)};
  if (messages != nullptr) *messages = said.release();
  return file ? SINEW_OK : SINEW_BAD_FILE;
}

}  // namespace

sinew_import_options sinew_default_import_options(void) {
  const ImportOptions defaults;
  return {.struct_size = sizeof(sinew_import_options),
          .decode_images = defaults.decode_images,
          .make_normals = defaults.make_normals,
          .make_tangents = defaults.make_tangents,
          .make_centers_of_rotation = defaults.make_centers_of_rotation,
          .max_file_bytes = defaults.max_file_bytes,
          .max_unpacked_bytes = defaults.max_unpacked_bytes};
}

sinew_error sinew_import_file(const char* path, const sinew_import_options* options, sinew_scene** scene,
                              sinew_messages** messages) {
  if (path == nullptr || scene == nullptr) return SINEW_NULL_ARGUMENT;
  return c::guarded([&] {
    return import(path, options, scene, messages, [&](const ImportOptions& own) {
      return import_gltf(std::filesystem::path(reinterpret_cast<const char8_t*>(path)), own);
    });
  });
}

sinew_error sinew_import_memory(const void* bytes, std::size_t byte_count, const char* name,
                                const sinew_import_options* options, sinew_scene** scene, sinew_messages** messages) {
  if (bytes == nullptr || name == nullptr || scene == nullptr) return SINEW_NULL_ARGUMENT;
  return c::guarded([&] {
    return import(name, options, scene, messages, [&](const ImportOptions& own) {
      return import_gltf(std::span(static_cast<const std::byte*>(bytes), byte_count), name, own);
    });
  });
}
