// SPDX-License-Identifier: MIT
#include "importer/tool/pose_output.h"

#include <unistd.h>
#include <zlib.h>

#include <cmath>
#include <cstdio>
#include <iterator>
#include <span>
#include <system_error>

#include <nlohmann/json.hpp>

#include "importer/tool/messages.h"

namespace sinew::tool {
namespace {

using Text = fmt::memory_buffer;
constexpr std::size_t kChunk = std::size_t{1} << 20;  // bytes handed to zlib at once

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

PoseOutput::PoseOutput(const std::string& file_or_empty) {
  if (file_or_empty.empty()) {
    file_ = gzdopen(dup(STDOUT_FILENO), "wbT");
    return;
  }
  std::error_code error;
  target_ = std::filesystem::canonical(file_or_empty, error);
  if (error) target_ = file_or_empty;  // a new file
  unfinished_ = fmt::format("{}.{}.tmp", target_.string(), getpid());
  file_ = gzopen(unfinished_.c_str(), file_or_empty.ends_with(".gz") ? "wbx6" : "wbxT");
}

PoseOutput::~PoseOutput() {
  if (!file_) return;
  gzclose(static_cast<gzFile>(file_));
  if (!unfinished_.empty()) unlink(unfinished_.c_str());
}

void PoseOutput::begin(std::string_view model, double extent) {
  put(text_, "{{\"model\": {},\n \"extent\": {:.9g},\n \"clips\": [", in_quotes(model), extent);
}

void PoseOutput::begin_clip(std::uint32_t clip, std::string_view name) {
  put(text_, "{}", first_clip_ ? "\n" : ",\n");
  if (clip == kNone)
    put(text_, "  {{\"clip\": null, \"index\": null, \"name\": null, \"samples\": [");
  else
    put(text_, "  {{\"clip\": {0}, \"index\": {0}, \"name\": {1}, \"samples\": [", clip, in_quotes(name));
  first_clip_ = false;
  first_sample_ = true;
}

void PoseOutput::begin_sample(const Pose& pose) {
  put(text_, "{}   {{\"time\": {},\n    ", first_sample_ ? "\n" : ",\n", pose.time_s);
  if (!pose.bits.empty()) put(text_, "\"bits\": {},\n    ", nlohmann::json(pose.bits).dump());
  put(text_, "\"nodes\": [");
  first_sample_ = false;
  add_nodes(pose);
  put(text_, "],\n    \"skinned\": [");
  first_primitive_ = true;
  for (const PrimitivePose& primitive : pose.primitives) add(primitive);
}

void PoseOutput::end_sample() {
  put(text_, "]}}");
  flush();
}

void PoseOutput::add_nodes(const Pose& pose) {
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

void PoseOutput::add(const PrimitivePose& primitive) {
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

void PoseOutput::end_clip() { put(text_, "]}}"); }

bool PoseOutput::end() {
  put(text_, "\n ]}}\n");
  flush();
  const int closed = gzclose(static_cast<gzFile>(file_));
  file_ = nullptr;
  const bool written = closed == Z_OK && !failed_;
  if (unfinished_.empty()) return written;
  if (written && rename(unfinished_.c_str(), target_.c_str()) == 0) return true;
  unlink(unfinished_.c_str());
  return false;
}

void PoseOutput::flush() {
  if (!failed_ && text_.size() > 0)
    failed_ = gzwrite(static_cast<gzFile>(file_), text_.data(), static_cast<unsigned>(text_.size())) <= 0;
  text_.clear();
}

}  // namespace sinew::tool
