// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "importer/file/base64.h"
#include "importer/tool/json.h"
#include "importer/tool/verify/verify_report.h"

namespace sinew::tool {
namespace {

constexpr std::string_view kVerifyPageTemplate =
#include "verify_page.inc"
    ;

constexpr std::size_t kFilesDrawn = 50, kTableRows = 20, kPointsOfCurve = 240;

Json point_json(const Point& point) { return Json(point); }

/// Rows of a curve of `count` samples that are drawn: evenly spaced, and the row that must be seen.
std::vector<std::size_t> rows_drawn(std::size_t count, std::size_t needed) {
  const std::size_t step = count / kPointsOfCurve + 1;
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < count; ++i)
    if (i % step == 0 || i == needed || i + 1 == count) rows.push_back(i);
  return rows;
}

Json over_time_json(const DifferenceOverTime& clip) {
  const auto worst = std::max_element(clip.ratios.begin(), clip.ratios.end());
  Json out = {{"clip", clip.clip}, {"samples", clip.times_s.size()}};
  out["times"] = Json::array();
  out["ratios"] = Json::array();
  for (const std::size_t row : rows_drawn(clip.times_s.size(), static_cast<std::size_t>(worst - clip.ratios.begin()))) {
    out["times"].push_back(clip.times_s[row]);
    out["ratios"].push_back(clip.ratios[row]);
  }
  return out;
}

Json joint_json(const JointHistory& joint) {
  const auto worst = std::find(joint.times_s.begin(), joint.times_s.end(), joint.worst_s);
  Json out = {{"joint", joint.name}, {"clip", joint.clip}, {"node", joint.node}, {"worst_s", joint.worst_s}};
  for (const char* key : {"times", "golden", "now", "turned_deg"}) out[key] = Json::array();
  for (const std::size_t row :
       rows_drawn(joint.times_s.size(), static_cast<std::size_t>(worst - joint.times_s.begin()))) {
    out["times"].push_back(joint.times_s[row]);
    out["golden"].push_back(point_json(joint.golden[row]));
    out["now"].push_back(point_json(joint.now[row]));
    out["turned_deg"].push_back(joint.turned_deg[row]);
  }
  return out;
}

Json points_json(const std::vector<Point>& points) {
  Json out = Json::array();
  for (const Point& point : points) out.push_back(point_json(point));
  return out;
}

Json figure_json(const PoseFigure& figure) {
  Json out = {{"time_s", figure.time_s},
              {"golden", points_json(figure.golden)},
              {"now", points_json(figure.now)},
              {"golden_vertices", points_json(figure.golden_vertices)},
              {"vertices", points_json(figure.vertices)}};
  out["bones"] = Json::array();
  for (const auto& [parent, child] : figure.bones) out["bones"].push_back(Json(std::array{parent, child}));
  return out;
}

const char* verdict_of(const VerifiedFile& file) {
  if (!file.moved()) return file.code == ExitCode::done ? "same" : "unread";
  return file.code == ExitCode::done ? "updated" : "moved";
}

Json file_json(const VerifiedFile& file, bool drawn) {
  Json out = {{"file", file.file},         {"golden", file.golden},     {"verdict", verdict_of(file)},
              {"compared", file.compared}, {"failed", file.failed},     {"largest_m", file.largest_m},
              {"seconds", file.seconds},   {"kinds", file.worst.size()}};
  out["worst"] = Json::array();
  for (std::size_t i = 0; i < std::min(file.worst.size(), kTableRows); ++i) {
    const Deviation& worst = file.worst[i];
    out["worst"].push_back({{"where", worst.where},
                            {"amount", worst.amount},
                            {"allowed", worst.tolerance},
                            {"unit", worst.unit},
                            {"more", worst.more}});
  }
  if (file.worst.empty()) out["lines"] = file.lines;
  if (!drawn) return out;
  out["starts"] = file.history.starts;
  for (const char* key : {"over_time", "joints"}) out[key] = Json::array();
  for (const DifferenceOverTime& clip : file.over_time) out["over_time"].push_back(over_time_json(clip));
  for (const JointHistory& joint : file.history.joints) out["joints"].push_back(joint_json(joint));
  out["figure"] = figure_json(file.history.figure);
  if (!file.picture.empty()) out["picture"] = "data:image/png;base64," + encode_base64(file.picture);
  return out;
}

/// JSON that is safe inside a script element: it contains no "</script" and no "<!--".
std::string without_tags(const Json& json) {
  std::string safe;
  for (const char c : json.dump()) safe += c == '<' ? "\\u003c" : std::string(1, c);
  return safe;
}

/// Unreadable files first, since nothing is known of them. Then those that moved, by their worst difference; those that
/// differ in words alone (traces of graphs) come last.
std::vector<const VerifiedFile*> failures_first(std::span<const VerifiedFile> files) {
  std::vector<const VerifiedFile*> order;
  for (const VerifiedFile& file : files) order.push_back(&file);
  const auto rank = [](const VerifiedFile* file) {
    const std::string_view verdict = verdict_of(*file);
    return verdict == "unread" ? 0 : verdict == "moved" ? 1 : verdict == "updated" ? 2 : 3;
  };
  std::stable_sort(order.begin(), order.end(), [&](const VerifiedFile* a, const VerifiedFile* b) {
    if (rank(a) != rank(b) || !a->moved()) return rank(a) < rank(b);
    if (a->worst.empty() || b->worst.empty()) return !a->worst.empty() && b->worst.empty();
    return a->worst.front().is_worse_than(b->worst.front());
  });
  return order;
}

}  // namespace

std::string verify_page(std::span<const VerifiedFile> files) {
  Json report = {{"version", SINEW_VERSION}};
  report["files"] = Json::array();
  std::size_t drawn = 0;
  for (const VerifiedFile* file : failures_first(files))
    report["files"].push_back(file_json(*file, !file->worst.empty() && file->moved() && drawn++ < kFilesDrawn));
  constexpr std::string_view kPlace = "@REPORT@";
  std::string page(kVerifyPageTemplate);
  page.replace(page.find(kPlace), kPlace.size(), without_tags(report));
  return page;
}

}  // namespace sinew::tool
