// SPDX-License-Identifier: MIT
#include "importer/c/sinew_import.h"

#include <memory>
#include <string>
#include <vector>

#include "importer/import_gltf.h"
#include "runtime/c/glue/call.h"
#include "runtime/c/glue/fields.h"
#include "runtime/c/handles.h"

using namespace sinew;

namespace {

constexpr auto kImportOptions =
    c::fields(c::field<&sinew_import_options::decode_images, &ImportOptions::decode_images>(),
              c::field<&sinew_import_options::make_normals, &ImportOptions::make_normals>(),
              c::field<&sinew_import_options::make_tangents, &ImportOptions::make_tangents>(),
              c::field<&sinew_import_options::make_centers_of_rotation, &ImportOptions::make_centers_of_rotation>(),
              c::field<&sinew_import_options::max_file_bytes, &ImportOptions::max_file_bytes>(),
              c::field<&sinew_import_options::max_unpacked_bytes, &ImportOptions::max_unpacked_bytes>());

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
  ImportOptions own;
  if (const sinew_error error = c::read_fields(options, kImportOptions, own)) return error;
  ImportResult<ImportedFile> file = read(own);
  std::unique_ptr<sinew_messages> said = messages != nullptr ? messages_of(file, name) : nullptr;
  if (file) *scene = new sinew_scene{std::move(file->scene)};
  if (messages != nullptr) *messages = said.release();
  return file ? SINEW_OK : SINEW_BAD_FILE;
}

}  // namespace

sinew_import_options sinew_default_import_options(void) {
  return c::written<sinew_import_options>(kImportOptions, ImportOptions{});
}

sinew_error sinew_import_file(const char* path, const sinew_import_options* options, sinew_scene** scene,
                              sinew_messages** messages) {
  return c::call(c::given(path, scene), [&] {
    return import(path, options, scene, messages, [&](const ImportOptions& own) {
      return import_gltf(std::filesystem::path(reinterpret_cast<const char8_t*>(path)), own);
    });
  });
}

sinew_error sinew_import_memory(const void* bytes, std::size_t byte_count, const char* name,
                                const sinew_import_options* options, sinew_scene** scene, sinew_messages** messages) {
  return c::call(c::given(bytes, name, scene), [&] {
    return import(name, options, scene, messages, [&](const ImportOptions& own) {
      return import_gltf(std::span(static_cast<const std::byte*>(bytes), byte_count), name, own);
    });
  });
}
