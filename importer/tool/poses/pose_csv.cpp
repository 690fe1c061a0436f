// SPDX-License-Identifier: MIT
#include "importer/tool/poses/pose_csv.h"

#include <iterator>

#include "importer/visible_text.h"

namespace sinew::tool {

std::string csv_field(std::string_view text) {
  std::string field = "\"";
  for (const char c : visible_text(text)) field += c == '"' ? "\"\"" : std::string(1, c);
  return field + '"';
}

void PoseCsv::begin(std::string_view, double) {
  out_.write("clip,clip_name,time_s,node,node_name,m00,m01,m02,m03,m10,m11,m12,m13,m20,m21,m22,m23\n");
}

void PoseCsv::begin_clip(std::uint32_t clip, std::string_view name) {
  clip_ = clip == kNone ? "," : fmt::format("{},{}", clip, csv_field(name));
}

void PoseCsv::begin_sample(const Pose& pose) {
  const auto out = std::back_inserter(text_);
  for (const NodeWorld& node : pose.nodes) {
    const std::uint32_t joint = scene_.skeleton.joint_of_node[node.node];
    fmt::format_to(out, "{},{},{},{}", clip_, pose.time_s, node.node, csv_field(scene_.skeleton.names[joint]));
    for (std::size_t row = 0; row < 3; ++row)
      for (std::size_t column = 0; column < 4; ++column) fmt::format_to(out, ",{:.9g}", node.world[4 * column + row]);
    text_.push_back('\n');
  }
}

void PoseCsv::end_sample() {
  out_.write({text_.data(), text_.size()});
  text_.clear();
}

}  // namespace sinew::tool
