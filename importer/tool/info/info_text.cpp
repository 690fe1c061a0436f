// SPDX-License-Identifier: MIT
#include "importer/tool/info/info_text.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "importer/tool/info/clip_annotations.h"
#include "importer/tool/info/memory_kinds.h"
#include "importer/tool/info/node_tree.h"
#include "importer/tool/messages.h"
#include "importer/tool/text_table.h"
#include "importer/tool/vrm/vrm_info.h"
#include "importer/tool/wrapped_text.h"
#include "importer/visible_text.h"

namespace sinew::tool {
namespace {

std::string text_of(const Json& value) { return value.get<std::string>(); }

/// A text of the file without quotes, safe for a terminal.
std::string shown(const Json& value) { return visible_text(text_of(value)); }

/// "a: 1, b: 2" for an object with numbers.
std::string pairs(const Json& object, const char* separator) {
  std::string out;
  for (const auto& [key, value] : object.items())
    out += fmt::format("{}{}{}{}", out.empty() ? "" : ", ", key, separator, value.dump());
  return out;
}

/// The first `count` names of an array in quotes: "a", "b".
std::string names(const Json& list, std::size_t count) {
  std::string out;
  for (std::size_t i = 0; i < count; ++i) out += (i > 0 ? ", " : "") + in_quotes(text_of(list[i]));
  return out;
}

std::string size_of(const Json& bytes) { return size_text(bytes.get<double>()); }

std::string number(const Json& value) { return value.is_number() ? fmt::format("{:.6g}", value.get<double>()) : ""; }

std::string flag(const Json& value, const char* word) { return value.get<bool>() ? word : ""; }

/// The textures that a material uses, and their images: "base color: image 0, normal: no image".
std::string texture_names(const Json& images) {
  std::string out;
  for (const auto& [name, image] : images.items())
    out +=
        fmt::format("{}{}: {}", out.empty() ? "" : ", ", name, image.is_null() ? "no image" : "image " + image.dump());
  std::replace(out.begin(), out.end(), '_', ' ');
  return out;
}

/// "(1, 2, 3)".
std::string point(const Json& p) {
  return fmt::format("({:.4g}, {:.4g}, {:.4g})", p[0].get<double>(), p[1].get<double>(), p[2].get<double>());
}

/// The number of places that the reports of a list stand for.
std::size_t case_count(const Json& issues) {
  std::size_t count = 0;
  for (const Json& issue : issues) count += issue["cases"].get<std::size_t>();
  return count;
}

class InfoText {
 public:
  InfoText(const Json& info, bool all) : info_(info), all_(all) {}

  std::string make() {
    head();
    extensions();
    meshes();
    morph_targets();
    skins();
    clips();
    materials();
    images();
    cameras();
    lights();
    if (info_.contains("vrm")) text_ += vrm_text(info_["vrm"]);
    if (info_.contains("node_list")) text_ += "node tree:\n" + node_tree_text(info_["node_list"]);
    issues("warnings", info_["warnings"]);
    issues("lost by convert", info_["lost_by_convert"]);
    return std::move(text_);
  }

 private:
  template <class... Args>
  void line(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
    text_ += '\n';
  }

  void head() {
    line("{}", shown(info_["file"]));
    line("glTF {}, {} with all that it refers to", shown(info_["version"]), size_of(info_["bytes"]));
    if (!text_of(info_["generator"]).empty()) line("made with: {}", shown(info_["generator"]));
    if (!text_of(info_["copyright"]).empty()) line("copyright: {}", shown(info_["copyright"]));
    const Json& nodes = info_["nodes"];
    line("nodes: {}, {} roots, {} levels deep; scenes: {}", nodes["count"].dump(), nodes["roots"].dump(),
         nodes["depth"].dump(), info_["scenes"].dump());
    bounds();
    if (!info_["hidden_nodes"].empty()) line("hidden nodes: {}", info_["hidden_nodes"].size());
    text_ += memory_text(info_["memory"]);
  }

  void bounds() {
    const Json& box = info_["bounds"];
    if (box.is_null()) return;
    const auto side = [&](std::size_t axis) {
      return box["upper"][axis].get<double>() - box["lower"][axis].get<double>();
    };
    line("bounds at rest: {} to {}, {:.4g} x {:.4g} x {:.4g} m", point(box["lower"]), point(box["upper"]), side(0),
         side(1), side(2));
  }

  /// A heading with the number of entries, then one row per entry. `cells` returns the cells after its number and name.
  template <class Cells>
  void table(const char* title, const Json& list, std::vector<std::string> columns, const Cells& cells) {
    line("{}: {}", title, list.size());
    columns.insert(columns.begin(), {"#", "name"});
    TextTable table(std::move(columns));
    for (std::size_t i = 0; i < list.size(); ++i) {
      const std::string name = text_of(list[i]["name"]);
      std::vector<std::string> row = cells(list[i]);
      row.insert(row.begin(), {std::to_string(i), name.empty() ? "" : in_quotes(name)});
      table.add(std::move(row));
    }
    text_ += table.text();
  }

  void extensions() {
    table("extensions", info_["extensions"], {"required", "handling"}, [](const Json& e) {
      return std::vector{std::string(flag(e["required"], "required")), text_of(e["handling"])};
    });
  }

  void meshes() {
    std::uint64_t shown = 0;
    for (const Json& instance : info_["mesh_instances"]) shown += instance["copies"].get<std::uint64_t>();
    line("mesh instances: {}, shown {} times", info_["mesh_instances"].size(), shown);
    table("meshes", info_["meshes"], {"vertices", "triangles", "primitives", "morph targets"}, [](const Json& m) {
      return std::vector{m["vertices"].dump(), m["triangles"].dump(), std::to_string(m["primitives"].size()),
                         m.contains("morph_targets") ? std::to_string(m["morph_targets"].size()) : std::string()};
    });
  }

  void morph_targets() {
    for (std::size_t i = 0; i < info_["meshes"].size(); ++i)
      if (const Json& mesh = info_["meshes"][i]; mesh.contains("morph_targets"))
        table(fmt::format("morph targets of mesh {}", i).c_str(), mesh["morph_targets"],
              {"non-zero deltas", "default weight"}, [](const Json& t) {
                return std::vector{t["non_zero_deltas"].dump(), number(t["default_weight"])};
              });
  }

  void skins() {
    table("skins", info_["skins"], {"joints", "with weight", "vertices by number of influences"}, [](const Json& s) {
      return std::vector{s["joints"].dump(), s["joints_with_weight"].dump(), pairs(s["vertices_by_influences"], ": ")};
    });
    for (std::size_t i = 0; i < info_["skins"].size(); ++i) joints(i, info_["skins"][i]["joint_names"]);
  }

  void joints(std::size_t skin, const Json& all_names) {
    if (std::all_of(all_names.begin(), all_names.end(), [](const Json& name) { return text_of(name).empty(); })) return;
    constexpr std::size_t kShown = 24;
    const std::size_t count = all_ ? all_names.size() : std::min(all_names.size(), kShown);
    const std::string title = fmt::format("joints of skin {}: ", skin);
    std::string text = names(all_names, count);
    if (count < all_names.size()) text += fmt::format(" and {} more (--all lists them)", all_names.size() - count);
    line("{}{}", title, wrapped(text, 2, title.size()));
  }

  void clips() {
    table("clips", info_["clips"],
          {"seconds", "nodes", "channels", "keys", "most keys", "constant", "size of keys", "size compiled", "modes",
           "properties"},
          [](const Json& c) {
            return std::vector{number(c["duration_s"]),
                               std::to_string(c["animated_nodes"].size()),
                               c["channels"].dump(),
                               c["keys"].dump(),
                               c["most_keys_of_a_channel"].dump(),
                               c["constant_tracks"].dump(),
                               size_of(c["bytes_of_keys"]),
                               size_of(c["bytes_compiled"]),
                               pairs(c["modes"], ": "),
                               pairs(c["channels_by_property"], ": ")};
          });
    for (const Json& clip : info_["clips"]) text_ += annotation_lines(clip);
  }

  void materials() {
    if (!info_["variants"].empty()) line("material variants: {}", names(info_["variants"], info_["variants"].size()));
    table("materials", info_["materials"], {"alpha", "sides", "lighting", "metallic", "roughness", "textures"},
          [](const Json& m) {
            return std::vector{text_of(m["alpha"]),       flag(m["double_sided"], "both"),
                               flag(m["unlit"], "unlit"), number(m["metallic"]),
                               number(m["roughness"]),    texture_names(m["texture_images"])};
          });
  }

  void images() {
    table("images", info_["images"], {"format", "width", "height", "in the file", "decoded", "missing because"},
          [](const Json& i) {
            if (!i["missing"].is_null()) return std::vector<std::string>{"", "", "", "", "", shown(i["missing"])};
            return std::vector<std::string>{i["format"].is_null() ? "" : text_of(i["format"]),
                                            i["width"].dump(),
                                            i["height"].dump(),
                                            size_of(i["bytes"]),
                                            size_of(i["bytes_decoded"]),
                                            ""};
          });
  }

  void cameras() {
    table("cameras", info_["cameras"], {"node", "kind", "field of view", "half height", "near", "far"},
          [](const Json& c) {
            constexpr double kDegrees = 57.29577951308232;
            return std::vector{number(c["node"]),
                               text_of(c["kind"]),
                               c["fov_y_rad"].is_null()
                                   ? std::string()
                                   : fmt::format("{:.4g} deg", kDegrees * c["fov_y_rad"].get<double>()),
                               number(c["half_height"]),
                               number(c["near_m"]),
                               number(c["far_m"])};
          });
  }

  void lights() {
    table("lights", info_["lights"], {"node", "kind", "intensity", "range"}, [](const Json& l) {
      return std::vector{number(l["node"]), text_of(l["kind"]), number(l["intensity"]), number(l["range_m"])};
    });
  }

  /// Prints one line for all reports of one rule, with the first of them.
  void issues(const char* title, const Json& list) {
    line("{}: {}", title, case_count(list));
    std::map<std::string, std::size_t> cases;
    for (const Json& issue : list) cases[text_of(issue["rule"])] += issue["cases"].get<std::size_t>();
    for (const Json& issue : list) {
      const std::string rule = text_of(issue["rule"]);
      const std::size_t count = all_ ? 1 : std::exchange(cases[rule], 0);
      if (count > 0)
        line("  {}: {}{}: {}", shown(issue["pointer"]), rule, count > 1 ? fmt::format(" x{}", count) : "",
             shown(issue["message"]));
    }
  }

  const Json& info_;
  bool all_;
  std::string text_;
};

}  // namespace

std::string info_text(const Json& info, bool all) { return InfoText(info, all).make(); }

std::string info_line(const Json& info) {
  std::size_t vertices = 0, triangles = 0;
  for (const Json& mesh : info["meshes"]) {
    vertices += mesh["vertices"].get<std::size_t>();
    triangles += mesh["triangles"].get<std::size_t>();
  }
  const auto size = [&](const char* list, const char* word) { return counted(info[list].size(), word); };
  std::string line =
      fmt::format("{}: {}, {}, {}, {} vertices, {}, {}, {}", shown(info["file"]), size_of(info["bytes"]),
                  counted(info["nodes"]["count"].get<std::size_t>(), "node"), size("meshes", "mesh"), vertices,
                  counted(triangles, "triangle"), size("skins", "skin"), size("clips", "clip"));
  if (const std::size_t warnings = case_count(info["warnings"])) line += ", " + counted(warnings, "warning");
  return line + '\n';
}

}  // namespace sinew::tool
