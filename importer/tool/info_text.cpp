// SPDX-License-Identifier: MIT
#include "importer/tool/info_text.h"

#include <iterator>
#include <utility>

#include <fmt/format.h>

namespace sinew::tool {
namespace {

using Json = nlohmann::ordered_json;

std::string text_of(const Json& value) { return value.get<std::string>(); }

/// A name of the file, with quotes and control characters escaped: terminals obey what they are shown.
std::string quoted(const Json& name) { return name.dump(-1, ' ', false, Json::error_handler_t::replace); }

/// "a: 1, b: 2" of an object with numbers.
std::string pairs(const Json& object, const char* separator) {
  std::string out;
  for (const auto& [key, value] : object.items())
    out += fmt::format("{}{}{}{}", out.empty() ? "" : ", ", key, separator, value.dump());
  return out;
}

std::string list(const Json& strings) {
  std::string out;
  for (const Json& entry : strings) out += (out.empty() ? "" : ", ") + text_of(entry);
  return out.empty() ? "none" : out;
}

class InfoText {
 public:
  explicit InfoText(const Json& info) : info_(info) {}

  std::string make() {
    head();
    meshes();
    skins();
    clips();
    materials();
    named("cameras", [](const Json& c) { return text_of(c["kind"]); });
    named("lights", [](const Json& l) { return text_of(l["kind"]); });
    line("warnings: {}", info_["warnings"].size());
    for (const Json& w : info_["warnings"])
      line("  {}: {}: {}", text_of(w["pointer"]), text_of(w["rule"]), text_of(w["message"]));
    return std::move(text_);
  }

 private:
  template <class... Args>
  void line(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
    text_ += '\n';
  }

  void head() {
    line("{}", text_of(info_["file"]));
    line("glTF {}, {} bytes with all that it refers to", text_of(info_["version"]),
         info_["bytes"].get<std::uint64_t>());
    if (!text_of(info_["generator"]).empty()) line("made with: {}", text_of(info_["generator"]));
    if (!text_of(info_["copyright"]).empty()) line("copyright: {}", text_of(info_["copyright"]));
    line("extensions used: {}; required: {}", list(info_["extensions_used"]), list(info_["extensions_required"]));
    const Json& nodes = info_["nodes"];
    line("nodes: {}, {} roots, {} levels deep; scenes: {}", nodes["count"].dump(), nodes["roots"].dump(),
         nodes["depth"].dump(), info_["scenes"].dump());
  }

  void meshes() {
    line("meshes: {}, shown {} times", info_["meshes"].size(), info_["mesh_instances"].size());
    for (std::size_t i = 0; i < info_["meshes"].size(); ++i) {
      const Json& mesh = info_["meshes"][i];
      line("  {} {}: {} vertices, {} triangles, {} primitives", i, quoted(mesh["name"]), mesh["vertices"].dump(),
           mesh["triangles"].dump(), mesh["primitives"].size());
      if (!mesh["influences"].empty())
        line("    vertices by number of influences: {}", pairs(mesh["influences"], ": "));
      if (!mesh.contains("morph_targets")) continue;
      line("    morph targets: {}", mesh["morph_targets"].size());
      for (std::size_t t = 0; t < mesh["morph_targets"].size(); ++t)
        line("      {} {}: {} non-zero deltas", t, quoted(mesh["morph_targets"][t]["name"]),
             mesh["morph_targets"][t]["non_zero_deltas"].dump());
    }
  }

  void skins() {
    line("skins: {}", info_["skins"].size());
    for (std::size_t i = 0; i < info_["skins"].size(); ++i)
      line("  {} {}: {} joints", i, quoted(info_["skins"][i]["name"]), info_["skins"][i]["joints"].dump());
  }

  void clips() {
    line("clips: {}", info_["clips"].size());
    for (std::size_t i = 0; i < info_["clips"].size(); ++i) {
      const Json& clip = info_["clips"][i];
      line("  {} {}: {:.6g} s, {} channels ({}), {} keys, modes: {}", i, quoted(clip["name"]),
           clip["duration_s"].get<double>(), clip["channels"].dump(), pairs(clip["channels_by_property"], ": "),
           clip["keys"].dump(), pairs(clip["modes"], ": "));
      line("    compiled: {} bytes, {} tracks folded away, {} key searches a sample", clip["bytes"].dump(),
           clip["folded_tracks"].dump(), clip["key_searches"].dump());
    }
  }

  void materials() {
    named("materials",
          [](const Json& m) { return text_of(m["alpha"]) + (m["double_sided"].get<bool>() ? ", double-sided" : ""); });
    named("images", [](const Json& image) {
      return image["missing"].is_null() ? fmt::format("{} x {}", image["width"].dump(), image["height"].dump())
                                        : "missing: " + text_of(image["missing"]);
    });
  }

  /// A count, then one line per entry with its name and what `describe` says.
  template <class Describe>
  void named(const char* key, const Describe& describe) {
    line("{}: {}", key, info_[key].size());
    for (std::size_t i = 0; i < info_[key].size(); ++i)
      line("  {} {}: {}", i, quoted(info_[key][i]["name"]), describe(info_[key][i]));
  }

  const Json& info_;
  std::string text_;
};

}  // namespace

std::string info_text(const nlohmann::ordered_json& info) { return InfoText(info).make(); }

}  // namespace sinew::tool
