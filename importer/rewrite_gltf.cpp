// SPDX-License-Identifier: MIT
#include "importer/rewrite_gltf.h"

#include <exception>
#include <new>
#include <optional>
#include <utility>

#include "importer/rewrite/add_animations.h"
#include "importer/rewrite/add_attributes.h"
#include "importer/rewrite/decode_images.h"
#include "importer/rewrite/embed_images.h"
#include "importer/rewrite/mend.h"
#include "importer/rewrite/pack_buffer.h"
#include "importer/rewrite/quantize_streams.h"
#include "importer/rewrite/references.h"
#include "importer/rewrite/remove_unused.h"
#include "importer/rewrite/reorder_vertices.h"
#include "importer/rewrite/replace_keys.h"
#include "importer/rewrite/streams.h"
#include "importer/rewrite/take_decoded.h"
#include "importer/rewrite/weight_bits.h"
#include "importer/write/glb_bytes.h"
#include "runtime/base/contract.h"

namespace sinew {
namespace {

using rewrite::Draft;
using rewrite::Json;
using rewrite::Loss;

/// Losses outside the JSON document, such as extra data in a GLB.
void find_losses_outside(const ImportedFile& file, Draft& draft) {
  for (const ImportIssue& warning : file.warnings)
    if (warning.rule == "glb-extra-data" || warning.rule == "json-duplicate")
      draft.losses.push_back({warning.rule, warning.json_pointer, warning.detail});
}

/// Finds unknown extensions that refer to a buffer; their offsets would be wrong after the buffer is packed.
void find_unknown_offsets(Draft& draft) {
  rewrite::for_each_extension(draft.json, [&](const std::string& name, const std::string& place, Json& extension) {
    if (extension.is_object() && extension.contains("buffer"))
      draft.losses.push_back({name, place, "names bytes of a buffer by their offset"});
  });
}

ImportIssue issue_of(const Loss& loss) {
  return {Severity::error, "not-carried", loss.json_pointer, loss.name + ": " + loss.detail};
}

/// Splits losses into permitted ones and an error for the others.
std::optional<ImportError> settle(const std::vector<Loss>& losses, const std::set<std::string>& drop,
                                  std::vector<ImportIssue>& drops) {
  std::vector<ImportIssue> refused;
  for (const Loss& loss : losses)
    (drop.contains("all") || drop.contains(loss.name) ? drops : refused).push_back(issue_of(loss));
  for (ImportIssue& issue : drops) issue.severity = Severity::warning;
  if (refused.empty()) return std::nullopt;
  ImportError error;
  error.issue = std::move(refused.front());
  error.more_errors.assign(std::make_move_iterator(refused.begin() + 1), std::make_move_iterator(refused.end()));
  return error;
}

ImportError failure(const char* rule, const char* place, std::string detail) {
  return {"", {Severity::error, rule, place, std::move(detail)}, {}, {}};
}

rewrite::QuantizeBits bits_of(KeyRounding rounding, std::set<std::uint32_t> fine_weights) {
  rewrite::QuantizeBits bits;
  bits.fine_weights = std::move(fine_weights);
  bits.keys = rounding != KeyRounding::none;
  if (rounding == KeyRounding::fine) {
    bits.rotations = 16;
    bits.key_vectors = 20;
  }
  return bits;
}

/// Quantizes and compresses vertices, indices and keys.
void recode(const gltf::Document& document, const Scene& scene, const RewriteOptions& options, Draft& draft) {
  if (!options.quantize && !options.meshopt && !options.merge_vertices) return;
  std::set<std::uint32_t> fine_weights;
  if (options.quantize) fine_weights = rewrite::weights_of_16_bits(document, scene, draft);
  rewrite::Streams streams = rewrite::take_streams(document, draft, options.meshopt);
  if (options.meshopt) rewrite::reorder_vertices(streams, draft);
  rewrite::narrow_indices(streams, draft);
  if (options.quantize)
    rewrite::quantize_streams(bits_of(options.key_rounding, std::move(fine_weights)), options.meshopt, streams, draft);
  if (options.merge_vertices && !options.meshopt) rewrite::join_vertices(streams, draft);
  rewrite::put_streams(streams, options.meshopt, draft);
}

ImportResult<RewrittenFile> rewritten(const ImportedFile& file, const RewriteOptions& options) {
  const gltf::Document& document = file.carried->document;
  Draft draft = rewrite::make_draft(*file.carried);
  find_losses_outside(file, draft);
  rewrite::take_decoded(document, draft);
  find_unknown_offsets(draft);
  if (!options.animations.empty())
    rewrite::replace_keys(document, file.scene, {options.animations, options.channels_to}, draft);
  rewrite::add_animations(file.scene, options.added_animations, draft);
  rewrite::leave_out_attributes(options.left_out_attributes, draft);
  rewrite::add_attributes(options.added_attributes, draft);
  recode(document, file.scene, options, draft);
  rewrite::embed_images(document, draft);
  if (options.decode_images) rewrite::decode_images(document, draft);
  rewrite::remove_unused(draft);
  rewrite::mend(draft);
  RewrittenFile out;
  std::vector<std::byte> buffer = rewrite::pack_buffer(draft);
  if (auto error = settle(draft.losses, options.drop, out.drops)) return tl::unexpected(*std::move(error));
  if (!options.buffer_uri.empty()) {
    if (!buffer.empty()) draft.json["buffers"][0]["uri"] = options.buffer_uri;
    const std::string text = draft.json.dump();
    const auto bytes = std::as_bytes(std::span(text));
    out.file.assign(bytes.begin(), bytes.end());
    out.buffer = std::move(buffer);
    return out;
  }
  auto glb = write::glb_bytes(draft.json.dump(), buffer);
  if (!glb) return tl::unexpected(failure("glb-size", "/buffers/0", "the document does not fit into a GLB of 4 GiB"));
  out.file = *std::move(glb);
  return out;
}

}  // namespace

ImportResult<RewrittenFile> rewrite_gltf(const ImportedFile& file, const RewriteOptions& options) {
  CONTRACT(file.carried != nullptr);
  try {
    return rewritten(file, options);
  } catch (const std::bad_alloc&) {
    return tl::unexpected(failure("memory-budget", "", "out of memory"));
  } catch (const std::exception& error) {
    return tl::unexpected(failure("internal", "", error.what()));
  }
}

}  // namespace sinew
