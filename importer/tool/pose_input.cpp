// SPDX-License-Identifier: MIT
#include "importer/tool/pose_input.h"

#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "importer/file/regular_file.h"

namespace sinew::tool {
namespace {

using nlohmann::json;

ImportIssue file_issue(std::string detail) { return {Severity::error, "pose-file", "", std::move(detail)}; }

/// Reads the document and keeps the first error. After an error all results are empty and nothing more is read.
class PoseReader {
 public:
  std::optional<ImportIssue> issue;

  PoseFile file(const json& document) {
    PoseFile out;
    if (!document.is_object()) return failed<PoseFile>("", "a pose file is an object");
    if (document.contains("extent")) out.extent = number(document["extent"], "/extent");
    each(document, "", "clips",
         [&](const json& clip, const std::string& at) { out.clips.push_back(clip_poses(clip, at)); });
    return out;
  }

 private:
  void complain(const std::string& at, std::string detail) {
    if (!issue) issue = {Severity::error, "pose-format", at, std::move(detail)};
  }

  template <class T>
  T failed(const std::string& at, std::string detail) {
    complain(at, std::move(detail));
    return {};
  }

  /// Calls `read(element, pointer)` for each element of the array `object[key]`, which must be there.
  template <class Read>
  void each(const json& object, const std::string& at, const char* key, const Read& read) {
    const std::string array_at = at + "/" + key;
    if (!object.is_object() || !object.contains(key) || !object[key].is_array())
      return complain(array_at, "an array is missing here");
    for (std::size_t i = 0; i < object[key].size() && !issue; ++i)
      read(object[key][i], fmt::format("{}/{}", array_at, i));
  }

  double number(const json& value, const std::string& at) {
    constexpr double kLargest = std::numeric_limits<float>::max();
    if (value.is_number() && std::abs(value.get<double>()) <= kLargest) return value.get<double>();
    return failed<double>(at, "is not a finite number of single precision");
  }

  /// Values of a pose were floats when they were written and become floats again, so that an unchanged pose compares
  /// equal.
  double rounded(const json& value, const std::string& at) {
    return static_cast<double>(static_cast<float>(number(value, at)));
  }

  std::uint32_t index(const json& object, const std::string& at, const char* key) {
    if (object.is_object() && object.contains(key)) return index(object[key], at + "/" + key);
    return failed<std::uint32_t>(at + "/" + key, "an index is missing here");
  }

  std::uint32_t index(const json& value, const std::string& at) {
    if (value.is_number_unsigned() && value.get<std::uint64_t>() < kNone) return value.get<std::uint32_t>();
    return failed<std::uint32_t>(at, "is not an index");
  }

  /// Appends a vector of `width` numbers, or as many NaNs for null.
  void vector(const json& value, const std::string& at, std::size_t width, std::vector<double>& out) {
    if (value.is_null()) {
      out.insert(out.end(), width, std::numeric_limits<double>::quiet_NaN());
      return;
    }
    if (!value.is_array() || value.size() != width)
      return complain(at, fmt::format("is not a vector of {} numbers", width));
    for (const json& component : value) out.push_back(rounded(component, at));
  }

  ClipPoses clip_poses(const json& clip, const std::string& at) {
    ClipPoses out;
    if (!clip.is_object() || !clip.contains("clip"))
      return failed<ClipPoses>(at + "/clip", "an index or null is missing here");
    if (!clip["clip"].is_null()) out.clip = index(clip, at, "clip");
    each(clip, at, "samples",
         [&](const json& sample, const std::string& s) { out.samples.push_back(pose(sample, s)); });
    return out;
  }

  Pose pose(const json& sample, const std::string& at) {
    Pose out;
    if (!sample.is_object() || !sample.contains("time")) return failed<Pose>(at + "/time", "a time is missing here");
    out.time_s = number(sample["time"], at + "/time");
    if (sample.contains("nonUnit")) out.non_unit = number(sample["nonUnit"], at + "/nonUnit");
    if (out.non_unit < 0.0) complain(at + "/nonUnit", "is negative");
    if (sample.contains("bits")) hashes(sample["bits"], at + "/bits", out.bits);
    each(sample, at, "nodes",
         [&](const json& node, const std::string& n) { out.nodes.push_back(node_world(node, n)); });
    each(sample, at, "weights",
         [&](const json& node, const std::string& n) { out.weights.push_back(node_weights(node, n)); });
    each(sample, at, "skinned",
         [&](const json& p, const std::string& n) { out.primitives.push_back(primitive(p, n)); });
    named_once(out.nodes, at + "/nodes", [](const NodeWorld& node) { return node.node; });
    named_once(out.weights, at + "/weights", [](const NodeWeights& node) { return node.node; });
    named_once(out.primitives, at + "/skinned", [](const PrimitivePose& p) { return std::pair(p.node, p.primitive); });
    return out;
  }

  void hashes(const json& object, const std::string& at, std::map<std::string, std::string>& out) {
    if (!object.is_object()) return complain(at, "is not an object of hashes");
    for (const auto& [name, hash] : object.items()) {
      if (!hash.is_string()) return complain(at + "/" + name, "is not a hash");
      out[name] = hash.get<std::string>();
    }
  }

  /// Two entries for one thing would leave open which of them counts.
  template <class Entry, class Name>
  void named_once(const std::vector<Entry>& list, const std::string& at, const Name& name) {
    std::set<decltype(name(list.front()))> names;
    for (std::size_t i = 0; i < list.size(); ++i)
      if (!names.insert(name(list[i])).second)
        complain(fmt::format("{}/{}", at, i), "repeats what an earlier entry names");
  }

  NodeWorld node_world(const json& node, const std::string& at) {
    NodeWorld out;
    out.node = index(node, at, "node");
    std::vector<double> world;
    each(node, at, "world", [&](const json& value, const std::string& v) { world.push_back(rounded(value, v)); });
    if (world.size() != out.world.size()) return failed<NodeWorld>(at + "/world", "is not a matrix of 16 numbers");
    std::copy(world.begin(), world.end(), out.world.begin());
    return out;
  }

  NodeWeights node_weights(const json& node, const std::string& at) {
    NodeWeights out;
    out.node = index(node, at, "node");
    each(node, at, "weights",
         [&](const json& value, const std::string& v) { out.weights.push_back(rounded(value, v)); });
    return out;
  }

  PrimitivePose primitive(const json& primitive, const std::string& at) {
    PrimitivePose out;
    out.node = index(primitive, at, "node");
    out.primitive = index(primitive, at, "primitive");
    each(primitive, at, "vertices",
         [&](const json& value, const std::string& v) { out.vertices.push_back(index(value, v)); });
    if (std::adjacent_find(out.vertices.begin(), out.vertices.end(), std::greater_equal<>()) != out.vertices.end())
      complain(at + "/vertices", "do not increase");
    for (std::size_t kind = 0; kind < kVertexKinds.size() && !issue; ++kind) {
      const auto& [key, width, direction] = kVertexKinds[kind];
      if (!primitive.contains(key)) continue;
      each(primitive, at, key,
           [&, w = width](const json& v, const std::string& n) { vector(v, n, w, out.values[kind]); });
      if (!issue && out.values[kind].size() != width * out.vertices.size())
        complain(at + "/" + key,
                 fmt::format("does not have one entry for each of the {} vertices", out.vertices.size()));
    }
    return out;
  }
};

}  // namespace

tl::expected<PoseFile, ImportIssue> parse_poses(const std::string& text) {
  const json document = json::parse(text, nullptr, false);
  if (document.is_discarded()) return tl::unexpected(file_issue("is not JSON"));
  PoseReader reader;
  PoseFile file = reader.file(document);
  if (reader.issue) return tl::unexpected(std::move(*reader.issue));
  return file;
}

tl::expected<PoseFile, ImportIssue> read_poses(const std::string& file) {
  const RegularFile opened(file);
  if (!opened.opened()) return tl::unexpected(file_issue(std::strerror(errno)));
  const auto packed_bytes = opened.size();
  if (!packed_bytes) return tl::unexpected(file_issue("is not a regular file"));
  const gzFile in = gzdopen(dup(opened.descriptor()), "rb");
  if (!in) return tl::unexpected(file_issue(std::strerror(errno)));
  constexpr std::size_t kBlock = std::size_t{1} << 20;
  const std::uint64_t limit = 256 * *packed_bytes + kBlock;
  std::string text;
  int got = 0;
  do {
    const std::size_t before = text.size();
    text.resize(before + kBlock);
    got = gzread(in, text.data() + before, static_cast<unsigned>(kBlock));
    text.resize(before + static_cast<std::size_t>(got > 0 ? got : 0));
  } while (got > 0 && text.size() <= limit);
  const bool truncated = got < 0 || gzclose(in) == Z_BUF_ERROR;
  if (truncated) return tl::unexpected(file_issue("is damaged or cut short"));
  if (text.size() > limit) return tl::unexpected(file_issue("unpacks to more than 256 times its size"));
  return parse_poses(text);
}

}  // namespace sinew::tool
