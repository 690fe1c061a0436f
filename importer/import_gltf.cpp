// SPDX-License-Identifier: MIT
#include "importer/import_gltf.h"

#include <exception>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "importer/add_centers_of_rotation.h"
#include "importer/build/build_clips.h"
#include "importer/build/build_instances.h"
#include "importer/build/build_meshes.h"
#include "importer/build/build_placements.h"
#include "importer/build/build_skeleton.h"
#include "importer/build/build_skins.h"
#include "importer/build/build_vrm.h"
#include "importer/decode/decode_draco.h"
#include "importer/decode/decode_meshopt.h"
#include "importer/file/check_capabilities.h"
#include "importer/file/check_declarations.h"
#include "importer/file/check_references.h"
#include "importer/file/check_unused_objects.h"
#include "importer/file/data_uri.h"
#include "importer/file/document_size.h"
#include "importer/file/foreign_file.h"
#include "importer/file/glb_container.h"
#include "importer/file/gltf_shape.h"
#include "importer/file/load_buffers.h"
#include "importer/file/parse_json.h"
#include "importer/file/quarantine.h"
#include "importer/file/read_document.h"
#include "importer/file/sandboxed_files.h"
#include "importer/issue_log.h"
#include "importer/platform/files.h"
#include "importer/read/check_accessors.h"
#include "importer/read/check_bounds.h"
#include "importer/read/check_unused.h"
#include "importer/read/images.h"
#include "importer/read/materials.h"
#include "importer/read/memory_budget.h"
#include "importer/read/textures.h"
#include "importer/read/variants.h"
#include "importer/rewrite/carried_document.h"

namespace sinew {
namespace {

using gltf::Bytes;
using gltf::Document;

/// One import, from bytes to scene. Each step relies on the checks of earlier steps. The first step with an error
/// ends the import. If all errors are collected, it removes the broken parts and continues, but returns no scene.
class Import {
 public:
  Import(SandboxedFiles& files, const ImportOptions& options, IssueLog& log)
      : files_(files), options_(options), log_(log) {}

  /// Stores the bytes of the file next to the document that points into them.
  Bytes own(std::vector<std::byte> file) {
    carried_->file = std::move(file);
    return carried_->file;
  }

  std::optional<ImportedFile> run(Bytes file) {
    progress("parse", 0.0);
    if (!parse(file)) return std::nullopt;
    progress("buffers", 0.1);
    if (!load()) return std::nullopt;
    progress("scene", 0.3);
    ImportedFile out;
    if (!build(out.scene) || log_.error_count() > 0) return std::nullopt;
    progress("check", 0.9);
    finish_scene(out.scene);
    if (const ErrorCode code = check(out.scene); code != ErrorCode::ok) {
      log_.report(Rule::scene_check, "", std::string(describe(code)));
      return std::nullopt;
    }
    fill_facts(out.facts);
    out.warnings = log_.take_warnings();
    out.vrm = std::move(vrm_);
    if (options_.carry_document) out.carried = carry();
    progress("done", 1.0);
    return out;
  }

 private:
  bool parse(Bytes file) {
    if (const auto kind = describe_foreign_file(file)) {
      log_.report(Rule::not_gltf, "", "the file is " + *kind);
      return false;
    }
    Container parts{file, std::nullopt};
    if (looks_like_glb(file)) {
      const auto glb = open_glb(file, log_);
      if (!glb) return false;
      parts = *glb;
    }
    bin_ = parts.bin;
    const auto json = parse_json(parts.json, log_);
    if (json == nullptr || !check_is_gltf(json->root, log_) || !check_major_version(json->root, log_)) return false;
    if (options_.carry_document) carried_->json = to_json(json->root);
    check_shape(json->root, gltf_shape(), "", log_);
    if (!log_.ok() && !isolate(*json)) return false;
    check_capabilities(json->root, options_.max_nodes, log_);
    if (!log_.ok()) return false;
    if (options_.thorough) check_declarations(json->root, log_);
    if (!check_entry_bytes(json->root)) return false;
    document_ = read_document(json->root);
    // If all errors are reported, entries that depend on a malformed entry are still checked for bad references of
    // their own.
    if (!options_.collect_all_errors && !go_on()) return false;
    ReferencedEntries referenced;
    check_references(document_, log_, options_.thorough ? &referenced : nullptr);
    if (options_.thorough && log_.error_count() == 0)
      check_unused_objects(json->root, document_, std::move(referenced), log_);
    if (!go_on()) return false;
    if (options_.thorough) check_position_bounds(document_, log_);
    check_accessor_layout(document_, log_);
    return go_on();
  }

  /// Limits the memory of parsed JSON entries relative to the file size: many short entries take far more memory than
  /// their text.
  bool check_entry_bytes(const JsonNode& json) {
    const std::uint64_t taken = entry_bytes(json), read = files_.bytes_read();
    const std::uint64_t allowed = allowed_bytes(read, std::numeric_limits<std::uint64_t>::max());
    if (taken > allowed)
      log_.report(Rule::memory_budget, "",
                  "its entries would take " + std::to_string(taken) + " bytes, a file of " + std::to_string(read) +
                      " bytes may take " + std::to_string(allowed));
    return taken <= allowed;
  }

  /// Replaces malformed entries of the JSON tree. False if the import ends with their errors.
  bool isolate(JsonTree& json) {
    return quarantine_.isolate(json, log_) &&
           (options_.collect_all_errors || quarantine_.holds_only_animations_and_data());
  }

  /// Called after each step; removes the broken parts. True if there is no error, or if the import can go on without
  /// these parts: they are animation channels, or all errors are collected. False if there are too many errors, or the
  /// document as a whole is broken. A document that is carried along must stay whole.
  bool go_on() {
    if (log_.error_count() == 0 && quarantine_.empty()) return true;
    if (!quarantine_.mark(log_)) return false;
    if (!options_.carry_document && quarantine_.touches_only_animations(document_))
      log_.survive([](std::string_view place) { return std::string(consequence(place)); });
    else if (!options_.collect_all_errors)
      return false;
    quarantine_.empty_marked(document_, log_);
    return true;
  }

  /// Says in a report which part of an animation is dropped because of an error at `place`, while the import goes on.
  static std::string_view consequence(std::string_view place) {
    return place.find("/channels/") != place.npos ? "; the channel is left out"
                                                  : "; it is left out, with the animation channels that use it";
  }

  bool load() {
    load_buffers(document_, files_, bin_, log_);
    if (!go_on()) return false;
    point_views(document_, log_);
    if (!go_on()) return false;
    DecodeBudget budget(files_.bytes_read(), options_.max_unpacked_bytes);
    decode_meshopt(document_, budget, log_);
    if (!go_on()) return false;
    decode_draco(document_, budget, log_);
    if (!go_on()) return false;
    check_accessors(document_, log_);
    if (!go_on()) return false;
    check_memory_budget(document_, files_.bytes_read(), options_.max_unpacked_bytes, log_);
    if (!go_on()) return false;
    if (options_.thorough) check_spare_parts();
    if (options_.decode_images || options_.probe_images || options_.keep_encoded_images || options_.carry_document)
      load_images(document_, files_, log_);
    return true;
  }

  void check_spare_parts() {
    check_bounds(document_, log_);
    check_unused_accessors(document_, log_);
    check_unused_samplers(document_, log_);
  }

  bool build(Scene& scene) {
    const JointOrder order = order_joints(document_);
    if (const std::size_t depth = order.level_begin.size() - 1; depth > options_.max_node_depth)
      log_.report(
          Rule::too_many, "/nodes",
          std::to_string(depth) + " levels, at most " + std::to_string(options_.max_node_depth) + " are allowed");
    scene.skeleton = build_skeleton(document_, order, find_animated_nodes(document_), log_);
    scene.skins = build_skins(document_, order, log_);
    scene.materials = read_materials(document_, log_);
    scene.textures = read_textures(document_, log_);
    scene.variants = read_variants(document_, log_);
    if (!go_on()) return false;
    progress("meshes", 0.35);
    scene.meshes = build_meshes(document_, options_, log_);
    if (!go_on()) return false;
    progress("clips", 0.65);
    check_texcoords(scene, log_);
    Instances instances = build_instances(document_, order, scene.meshes, log_);
    const Placements placements = build_placements(document_, order, scene, log_);
    scene.animations = build_clips(document_, order, instances, placements, options_, log_);
    vrm_ = build_vrm(document_, order, instances.of_node, log_);
    scene.instances = std::move(instances.list);
    progress("images", 0.7);
    scene.images = read_images(document_, options_, scene.textures, log_);
    if (options_.make_centers_of_rotation && log_.error_count() == 0) add_centers(scene);
    return true;
  }

  void add_centers(Scene& scene) const {
    CentersOptions centers;
    centers.cache_folder = options_.centers_cache;
    centers.progress = [this](double done) { progress("centers of rotation", done); };
    add_centers_of_rotation(scene, centers);
  }

  void fill_facts(ImportedFile::Facts& facts) {
    facts.generator = document_.asset.generator;
    facts.copyright = document_.asset.copyright;
    facts.version = document_.asset.version;
    facts.extensions_used = document_.extensions_used;
    facts.extensions_required = document_.extensions_required;
    facts.file_bytes = files_.bytes_read();
    for (const auto& image : document_.images)
      if (!image.uri.empty() && !is_data_uri(image.uri)) files_.note(image.uri);
    facts.files.assign(files_.paths().begin(), files_.paths().end());
  }

  std::shared_ptr<const CarriedDocument> carry() {
    for (const char* list : {"buffers", "images"})
      if (const auto found = carried_->json.find(list); found != carried_->json.end())
        for (auto& entry : *found)
          if (const auto uri = entry.find("uri"); uri != entry.end() && is_data_uri(uri->get_ref<const std::string&>()))
            *uri = "data:";  // drops the long text, since its data are decoded already
    carried_->document = std::move(document_);
    return carried_;
  }

  void progress(const char* stage, double done) const {
    if (options_.progress) options_.progress(stage, done);
  }

  SandboxedFiles& files_;
  const ImportOptions& options_;
  IssueLog& log_;
  Document document_;
  Quarantine quarantine_;
  std::shared_ptr<const VrmCharacter> vrm_;
  std::optional<Bytes> bin_;
  const std::shared_ptr<CarriedDocument> carried_ = std::make_shared<CarriedDocument>();
};

/// Runs an import and converts every exception of a library to an error result.
template <class Run>
ImportResult<ImportedFile> guarded(const std::string& name, IssueLog& log, Run run) {
  try {
    if (auto out = run()) return std::move(*out);
  } catch (const std::bad_alloc&) {
    log.report(Rule::memory_budget, "", "out of memory");
  } catch (const std::exception& error) {
    log.report(Rule::internal, "", error.what());
  }
  return tl::make_unexpected(log.take_error(name));
}

}  // namespace

ImportResult<ImportedFile> import_gltf(const std::filesystem::path& file, const ImportOptions& options) {
  IssueLog log(options.max_listed_per_rule);
  const std::string name = platform::text_of(file);
  return guarded(name, log, [&]() -> std::optional<ImportedFile> {
    SandboxedFiles files(file.parent_path(), options.max_file_bytes);
    auto bytes = files.read_path(file);
    if (!bytes) {
      const bool large = bytes.error().kind == FileFault::Kind::too_large;
      log.report(large ? Rule::file_too_large : Rule::file_unreadable, "", bytes.error().detail);
      return std::nullopt;
    }
    Import import(files, options, log);
    return import.run(import.own(*std::move(bytes)));
  });
}

ImportResult<ImportedFile> import_gltf(std::span<const std::byte> bytes, const std::string& name,
                                       const ImportOptions& options) {
  IssueLog log(options.max_listed_per_rule);
  return guarded(name, log, [&]() -> std::optional<ImportedFile> {
    SandboxedFiles files(std::nullopt, options.max_file_bytes);
    if (!files.take(bytes.size())) {
      log.report(Rule::file_too_large, "", std::to_string(bytes.size()) + " bytes are more than allowed");
      return std::nullopt;
    }
    Import import(files, options, log);
    return import.run(options.carry_document ? import.own({bytes.begin(), bytes.end()}) : bytes);
  });
}

}  // namespace sinew
