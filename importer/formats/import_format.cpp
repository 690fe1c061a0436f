// SPDX-License-Identifier: MIT
#include "importer/formats/import_format.h"

#include <algorithm>
#include <cctype>
#include <span>
#include <string_view>
#include <utility>

#include "importer/file/foreign_file.h"
#include "importer/file/sandboxed_files.h"
#include "importer/formats/bvh_model.h"
#include "importer/formats/model_draft.h"
#include "importer/formats/scene_file.h"

namespace sinew::formats {
namespace {

enum class Kind { bvh, fbx, collada, other };

std::string_view text_in(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

Kind kind_of(std::string_view bytes) {
  if (bytes.starts_with("Kaydara FBX Binary")) return Kind::fbx;
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  const std::string_view head = bytes.substr(0, 4096);
  const std::size_t first = std::min(head.find_first_not_of(" \t\r\n"), head.size());
  std::string word(head.substr(first, 9));
  std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::toupper(c); });
  if (word == "HIERARCHY") return Kind::bvh;
  if (word.starts_with("; FBX ") || head.find("FBXHeaderExtension") != head.npos) return Kind::fbx;
  if (word.starts_with('<') && head.find("<COLLADA") != head.npos) return Kind::collada;
  return Kind::other;
}

ImportError error_of(const std::filesystem::path& file, ImportIssue issue) {
  return {file.string(), std::move(issue), {}, {}};
}

ImportIssue other_kind(std::span<const std::byte> bytes) {
  const auto foreign = describe_foreign_file(bytes);
  return {Severity::error, "file-kind", "",
          foreign ? "the file is " + *foreign
                  : std::string("the file is JSON or glTF, which needs no import; `sinew convert` writes it as .glb")};
}

/// Counts what was written, for the summary of the command.
void count(const tinygltf::Model& model, ImportedFormat& out) {
  out.joints = model.nodes.size();
  out.clips = model.animations.size();
  for (const auto& animation : model.animations)
    for (const auto& sampler : animation.samplers) {
      const auto& times = model.accessors[static_cast<std::size_t>(sampler.input)];
      out.keys = std::max(out.keys, times.count);
      if (!times.maxValues.empty()) out.duration_s = std::max(out.duration_s, times.maxValues[0]);
    }
  for (const auto& mesh : model.meshes)
    for (const auto& primitive : mesh.primitives)
      if (const auto at = primitive.attributes.find("POSITION"); at != primitive.attributes.end())
        out.vertices += model.accessors[static_cast<std::size_t>(at->second)].count;
}

/// Names joints whose OFFSET and position channels can be understood in two ways.
void note_positions(const Bvh& bvh, bool add, ImportedFormat& out) {
  const auto two_ways = [](const BvhJoint& joint) {
    return joint.offset != glm::dvec3(0.0) && std::any_of(joint.channels.begin(), joint.channels.end(),
                                                          [](const BvhChannel& channel) { return !channel.rotates; });
  };
  const auto found = std::find_if(bvh.joints.begin(), bvh.joints.end(), two_ways);
  if (found == bvh.joints.end()) return;
  out.warnings.push_back({Severity::warning, "bvh-positions", "",
                          "joint '" + found->name + "' has an OFFSET and position channels; positions " +
                              (add ? "were added to it" : "took its place (--positions add adds them)")});
}

/// err   the issue
std::optional<ImportIssue> add_motion(std::string_view text, const std::filesystem::path& file,
                                      const FormatOptions& options, ModelDraft& draft, ImportedFormat& out) {
  auto bvh = read_bvh(text);
  if (!bvh) return std::move(bvh).error();
  BvhMeaning meaning;
  meaning.metres_per_unit = options.metres_per_unit.value_or(meaning.metres_per_unit);
  meaning.z_up = options.z_up.value_or(false);
  meaning.keep_end_sites = options.keep_end_sites;
  meaning.positions_add_to_offset = options.positions_add_to_offset;
  out.warnings = std::move(bvh->warnings);
  note_positions(*bvh, options.positions_add_to_offset, out);
  add_bvh(*bvh, meaning, file.stem().string(), draft);
  return std::nullopt;
}

}  // namespace

ImportResult<ImportedFormat> import_format(const std::filesystem::path& file, const FormatOptions& options) {
  SandboxedFiles files(file.parent_path(), options.max_file_bytes);
  const auto bytes = files.read_path(file);
  if (!bytes) return tl::unexpected(error_of(file, {Severity::error, "file-missing", "", bytes.error().detail}));
  ImportedFormat out;
  ModelDraft draft;
  const Kind kind = kind_of(text_in(*bytes));
  out.format = kind == Kind::bvh ? "BVH" : kind == Kind::fbx ? "FBX" : "COLLADA";
  std::optional<ImportIssue> fault;
  if (kind == Kind::other)
    fault = other_kind(*bytes);
  else if (kind == Kind::bvh)
    fault = add_motion(text_in(*bytes), file, options, draft, out);
  else
    fault = add_scene_file(*bytes, kind == Kind::fbx, file, options, draft, out);
  if (fault) return tl::unexpected(error_of(file, *std::move(fault)));
  auto glb = draft.finish(file.string(), out.warnings);
  if (!glb) return tl::unexpected(std::move(glb).error());
  count(draft.model, out);
  out.glb = *std::move(glb);
  return out;
}

}  // namespace sinew::formats
