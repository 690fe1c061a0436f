// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>
#include <vector>

#include "importer/rewrite_gltf.h"
#include "importer/tool/certificate_table.h"
#include "runtime/model/scene.h"

namespace sinew::tool {

/// A model file whose clips were written with new keys, and how far its clips are off when the file is read again.
struct WrittenClips {
  RewrittenFile file;           ///< the file, a .glb
  RewriteOptions changes;       ///< the options that made `file`; their spans refer to `keys` and to data of the caller
  std::vector<Animation> keys;  ///< empty = the keys of `truths`
  std::vector<CertifiedClip> clips;  ///< measured on `file`
};

/// Rewrites a model with keys that take as few bytes as possible. In no clip may anything be farther than the budget
/// from its place in `truths`. The result is read again and measured. A clip that is not within the budget then gets
/// all of its keys back. If a file with all keys is not larger, all keys are kept. Keys are quantized less, or not at
/// all, if the budget needs it.
/// in    truths    one for each clip of the model: its own clips, or mirrored ones
///       changes   all changes besides keys; `animations` are `truths`, or empty if these are the model's own
///       budget_m  in the file's units, >= 0
/// err   as rewrite_gltf()
ImportResult<WrittenClips> write_within(const ImportedFile& model, std::span<const Animation> truths,
                                        RewriteOptions changes, double budget_m);

/// Rewrites a model with given keys, reads it again and measures it.
ImportResult<WrittenClips> write_keys(const ImportedFile& model, std::span<const Animation> truths,
                                      RewriteOptions changes, std::vector<Animation> keys);

/// The number of clips that are not within the budget.
std::size_t clips_not_met(const WrittenClips& written);

/// "3 clips, 120 of 959 keys, farthest off 0.98 mm of 1 mm"
std::string summary_of(const WrittenClips& written);

}  // namespace sinew::tool
