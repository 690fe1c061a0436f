// SPDX-License-Identifier: MIT
#include "importer/tool/convert/written_clips.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "importer/import_gltf.h"
#include "importer/tool/fit_clips.h"
#include "importer/tool/length_text.h"
#include "importer/tool/messages.h"

namespace sinew::tool {
namespace {

/// The largest part of the budget that rounding of keys may take. The rest is for leaving keys out.
constexpr double kOfRounding = 0.3;

/// A written file, and its clips as a reader gets them.
struct Reread {
  RewrittenFile file;
  std::vector<Animation> clips;
};

ImportResult<Reread> write_and_read(const ImportedFile& model, const RewriteOptions& changes) {
  RewriteOptions in_memory = changes;
  in_memory.buffer_uri.clear();
  auto file = rewrite_gltf(model, in_memory);
  if (!file) return tl::unexpected(file.error());
  ImportOptions plain;
  plain.decode_images = plain.make_tangents = plain.make_normals = false;
  auto again = import_gltf(file->file, "the written file", plain);
  if (!again) return tl::unexpected(again.error());
  return Reread{*std::move(file), std::move(again->scene.animations)};
}

std::vector<CertifiedClip> certified(const Scene& scene, std::span<const Animation> truths,
                                     std::span<const Animation> written, double budget_m) {
  const std::vector<ClipCertificate> certificates = certify_keys(scene, truths, written, budget_m);
  std::vector<CertifiedClip> clips;
  for (std::size_t i = 0; i < truths.size(); ++i)
    clips.push_back({i, truths[i].name, truths[i].duration_s, certificates[i]});
  return clips;
}

double worst_m(const std::vector<CertifiedClip>& clips) {
  double worst = 0.0;
  for (const CertifiedClip& clip : clips) worst = std::max(worst, clip.certificate.measured_m);
  return worst;
}

/// The model with all keys, quantized as far as the budget allows.
struct Whole {
  WrittenClips written;          ///< all members but `clips`
  std::vector<Animation> clips;  ///< the clips as a reader of the file gets them
};

ImportResult<Whole> write_whole(const ImportedFile& model, std::span<const Animation> truths, RewriteOptions changes,
                                double budget_m) {
  constexpr KeyRounding kRoundings[] = {KeyRounding::coarse, KeyRounding::fine, KeyRounding::none};
  for (const KeyRounding rounding : kRoundings) {
    if (!changes.quantize && rounding != KeyRounding::none) continue;
    changes.key_rounding = rounding;
    auto whole = write_and_read(model, changes);
    if (!whole) return tl::unexpected(whole.error());
    if (rounding != KeyRounding::none &&
        worst_m(certified(model.scene, truths, whole->clips, budget_m)) > kOfRounding * budget_m)
      continue;
    return Whole{{std::move(whole->file), std::move(changes), {}, {}}, std::move(whole->clips)};
  }
  return tl::unexpected(ImportError{});
}

}  // namespace

ImportResult<WrittenClips> write_keys(const ImportedFile& model, std::span<const Animation> truths,
                                      RewriteOptions changes, std::vector<Animation> keys) {
  WrittenClips out{{}, std::move(changes), std::move(keys), {}};
  out.changes.animations = out.keys;
  auto written = write_and_read(model, out.changes);
  if (!written) return tl::unexpected(written.error());
  out.file = std::move(written->file);
  out.clips = certified(model.scene, truths, written->clips, std::numeric_limits<double>::infinity());
  return out;
}

ImportResult<WrittenClips> write_within(const ImportedFile& model, std::span<const Animation> truths,
                                        RewriteOptions changes, double budget_m) {
  auto whole = write_whole(model, truths, std::move(changes), budget_m);
  if (!whole) return tl::unexpected(whole.error());
  WrittenClips& all_keys = whole->written;
  const auto keep_all = [&] {
    all_keys.clips = certified(model.scene, truths, whole->clips, budget_m);
    return std::move(all_keys);
  };
  if (budget_m == 0.0) return keep_all();
  WrittenClips fewer{{}, all_keys.changes, fit_file_keys(model.scene, truths, whole->clips, budget_m), {}};
  for (bool retried = false;; retried = true) {
    fewer.changes.animations = fewer.keys;
    auto written = write_and_read(model, fewer.changes);
    if (!written) return tl::unexpected(written.error());
    fewer.clips = certified(model.scene, truths, written->clips, budget_m);
    fewer.file = std::move(written->file);
    if (retried || clips_not_met(fewer) == 0) break;
    for (std::size_t i = 0; i < truths.size(); ++i)
      if (!fewer.clips[i].certificate.is_met()) fewer.keys[i] = truths[i];
  }
  const bool grew = fewer.file.file.size() >= all_keys.file.file.size();
  return grew || clips_not_met(fewer) > 0 ? keep_all() : std::move(fewer);
}

std::size_t clips_not_met(const WrittenClips& written) {
  return static_cast<std::size_t>(std::count_if(written.clips.begin(), written.clips.end(),
                                                [](const CertifiedClip& clip) { return !clip.certificate.is_met(); }));
}

std::string summary_of(const WrittenClips& written) {
  std::uint64_t kept = 0, all = 0;
  double asked_m = std::numeric_limits<double>::infinity();
  for (const CertifiedClip& clip : written.clips) {
    kept += clip.certificate.kept_keys;
    all += clip.certificate.source_keys;
    asked_m = clip.certificate.asked_m;
  }
  std::string text = fmt::format("{}, {} of {} keys, farthest off {}", counted(written.clips.size(), "clip"), kept, all,
                                 length_text(worst_m(written.clips)));
  if (std::isfinite(asked_m)) text += fmt::format(" of {}", length_text(asked_m));
  return text;
}

}  // namespace sinew::tool
