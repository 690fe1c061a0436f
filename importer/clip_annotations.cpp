// SPDX-License-Identifier: MIT
#include "importer/clip_annotations.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "importer/file/json_pointer.h"
#include "importer/issue_log.h"
#include "importer/read/annotations.h"
#include "importer/rules.h"
#include "runtime/clip/clip.h"

namespace sinew {
namespace {

struct ClipAnnotations {
  std::size_t clip;
  Annotations annotations;
};

std::vector<ClipAnnotations> read_clips(std::span<const Animation> animations, const gltf::Json& all, IssueLog& log) {
  std::vector<ClipAnnotations> read;
  for (const auto& [name, extras] : all.items()) {
    const std::string place = pointer(pointer_token(name));
    const auto clip = std::find_if(animations.begin(), animations.end(),
                                   [&, wanted = &name](const Animation& one) { return one.name == *wanted; });
    if (clip == animations.end()) {
      log.report(Rule::animation_extras, place, "the model has no clip " + in_quotes(name));
    } else if (!extras.is_object()) {
      log.report(Rule::animation_extras, place, "is no object with events and curves");
    } else {
      for (const auto& [key, value] : extras.items())
        if (key != "events" && key != "curves")
          log.report(Rule::animation_extras, pointer(place, pointer_token(key)), "is neither events nor curves");
      read.push_back({static_cast<std::size_t>(clip - animations.begin()),
                      read_annotations(extras, place, clip->duration_s, log)});
    }
  }
  return read;
}

/// In a model these are warnings about entries that are left out; here nothing is taken.
std::vector<ImportIssue> as_errors(std::vector<ImportIssue> issues) {
  constexpr std::string_view kLeftOut = "; it is left out";
  for (ImportIssue& issue : issues) {
    issue.severity = Severity::error;
    if (issue.detail.ends_with(kLeftOut)) issue.detail.resize(issue.detail.size() - kLeftOut.size());
  }
  return issues;
}

}  // namespace

std::vector<ImportIssue> annotate_clips(std::span<Animation> animations, std::string_view json) {
  const gltf::Json all = gltf::Json::parse(json, nullptr, false);
  if (!all.is_object())
    return {{Severity::error, std::string(describe(Rule::json_syntax).id), "",
             "is no JSON object with the names of clips"}};
  IssueLog log;
  std::vector<ClipAnnotations> read = read_clips(animations, all, log);
  if (std::vector<ImportIssue> issues = log.take_warnings(); !issues.empty()) return as_errors(std::move(issues));
  for (ClipAnnotations& one : read) animations[one.clip].annotations = std::move(one.annotations);
  return {};
}

std::vector<ImportIssue> annotate_clips(Scene& scene, std::string_view json) {
  std::vector<ImportIssue> issues = annotate_clips(std::span(scene.animations), json);
  if (scene.clips.size() != scene.animations.size()) return issues;
  for (std::size_t a = 0; a < scene.clips.size(); ++a)
    if (scene.clips[a].annotations() != scene.animations[a].annotations)
      scene.clips[a] = with_annotations(scene.clips[a], scene.animations[a].annotations);
  return issues;
}

}  // namespace sinew
