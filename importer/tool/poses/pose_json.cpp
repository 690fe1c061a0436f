// SPDX-License-Identifier: MIT
#include "importer/tool/poses/pose_json.h"

#include <cmath>
#include <iterator>
#include <span>

#include "importer/tool/json.h"
#include "importer/tool/messages.h"

namespace sinew::tool {
namespace {

using Text = fmt::memory_buffer;
constexpr std::size_t kChunk = std::size_t{1} << 20;  // bytes that are written at once

template <class... Args>
void put(Text& text, fmt::format_string<Args...> format, Args&&... args) {
  fmt::format_to(std::back_inserter(text), format, std::forward<Args>(args)...);
}

/// Nine digits reproduce every float exactly. JSON has no NaN or infinity: a vector that holds one is written as null.
void put_vector(Text& text, std::span<const double> numbers) {
  for (const double number : numbers)
    if (!std::isfinite(number)) return put(text, "null");
  put(text, "[");
  for (std::size_t i = 0; i < numbers.size(); ++i) put(text, "{}{:.9g}", i ? ", " : "", numbers[i]);
  put(text, "]");
}

}  // namespace

void PoseJson::begin(std::string_view model, double extent) {
  put(text_, "{{\"model\": {},\n \"extent\": {:.9g},\n \"clips\": [", in_quotes(model), extent);
}

void PoseJson::begin_clip(std::uint32_t clip, std::string_view name) {
  put(text_, "{}", first_clip_ ? "\n" : ",\n");
  if (clip == kNone)
    put(text_, "  {{\"clip\": null, \"index\": null, \"name\": null, \"samples\": [");
  else
    put(text_, "  {{\"clip\": {0}, \"index\": {0}, \"name\": {1}, \"samples\": [", clip, in_quotes(name));
  first_clip_ = false;
  first_sample_ = true;
}

void PoseJson::begin_sample(const Pose& pose) {
  put(text_, "{}   {{\"time\": {},\n    ", first_sample_ ? "\n" : ",\n", pose.time_s);
  if (!pose.bits.empty()) put(text_, "\"bits\": {},\n    ", Json(pose.bits).dump());
  put(text_, "\"nodes\": [");
  first_sample_ = false;
  add_nodes(pose);
  put(text_, "],\n    \"skinned\": [");
  first_primitive_ = true;
  for (const PrimitivePose& primitive : pose.primitives) add(primitive);
}

void PoseJson::end_sample() {
  put(text_, "]}}");
  flush();
}

void PoseJson::add_nodes(const Pose& pose) {
  for (std::size_t i = 0; i < pose.nodes.size(); ++i) {
    put(text_, "{}{{\"node\": {}, \"world\": ", i ? ",\n     " : "\n     ", pose.nodes[i].node);
    put_vector(text_, pose.nodes[i].world);
    put(text_, "}}");
  }
  put(text_, "],\n    \"weights\": [");
  for (std::size_t i = 0; i < pose.weights.size(); ++i) {
    put(text_, "{}{{\"node\": {}, \"weights\": ", i ? ",\n     " : "\n     ", pose.weights[i].node);
    put_vector(text_, pose.weights[i].weights);
    put(text_, "}}");
  }
}

void PoseJson::add(const PrimitivePose& primitive) {
  put(text_, "{}{{\"node\": {}, \"mesh\": {}, \"primitive\": {},\n      \"vertices\": [{}]",
      first_primitive_ ? "\n     " : ",\n     ", primitive.node, primitive.mesh, primitive.primitive,
      fmt::join(primitive.vertices, ", "));
  first_primitive_ = false;
  for (std::size_t kind = 0; kind < kVertexKinds.size(); ++kind) {
    const std::vector<double>& values = primitive.values[kind];
    if (values.empty()) continue;
    const std::size_t width = kVertexKinds[kind].width;
    put(text_, ",\n      \"{}\": [", kVertexKinds[kind].key);
    for (std::size_t i = 0; i < values.size(); i += width) {
      if (i) put(text_, ", ");
      put_vector(text_, std::span(values).subspan(i, width));
      if (text_.size() > kChunk) flush();
    }
    put(text_, "]");
  }
  put(text_, "}}");
}

void PoseJson::end_clip() { put(text_, "]}}"); }

void PoseJson::end() {
  put(text_, "\n ]}}\n");
  flush();
}

void PoseJson::flush() {
  out_.write({text_.data(), text_.size()});
  text_.clear();
}

}  // namespace sinew::tool
