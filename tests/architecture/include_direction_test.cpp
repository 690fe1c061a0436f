// SPDX-License-Identifier: MIT
// Data flows one way, and so do includes: importer and viewer see the runtime, and the two programs see both. Inside
// the runtime the table in runtime/README.md decides. A file that includes against this order fails here.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "tests/architecture/source_tree.h"

namespace sinew::test {
namespace {

/// The folders that each folder of the runtime may include, read from the table in runtime/README.md: "runtime/pose" ->
/// {"runtime/base", ...}.
const std::map<std::string, std::set<std::string>>& runtime_rows() {
  static const std::map<std::string, std::set<std::string>> rows = [] {
    std::map<std::string, std::set<std::string>> found;
    static const std::regex row(R"re(^\| `([\w/]+)/` \|.*\|([\w/ ]*)\|$)re");
    std::ifstream in(std::filesystem::path(SINEW_SOURCE_DIR) / "runtime/README.md");
    for (std::string line; std::getline(in, line);) {
      std::smatch match;
      if (!std::regex_match(line, match, row)) continue;
      std::set<std::string>& seen = found["runtime/" + match[1].str()];
      std::istringstream names(match[2]);
      for (std::string name; names >> name;) seen.insert("runtime/" + name);
    }
    return found;
  }();
  return rows;
}

/// The part of the tree that a path belongs to: "runtime/pose", "importer", "importer/tool", "viewer/app", ...
std::string part_of(const std::string& path) {
  const auto starts = [&](const std::string& folder) { return path.starts_with(folder + "/"); };
  for (auto row = runtime_rows().rbegin(); row != runtime_rows().rend(); ++row)  // subfolders before their folder
    if (starts(row->first)) return row->first;
  for (const char* part : {"importer/tool", "importer/c", "importer/geometry_cache", "importer/ambient",
                           "importer/formats", "importer/graph", "importer/ktx2", "importer/python", "viewer/app",
                           "viewer/light", "importer", "viewer", "samples", "tests", "runtime"})
    if (starts(part)) return part;
  return "";
}

bool sees(const std::string& from, const std::string& to) {
  static const std::set<std::string> kAssets = {"runtime/base", "runtime/math",  "runtime/animation",
                                                "runtime/clip", "runtime/model", "runtime/threads"};
  if (to == "tests") return from == "tests";
  if (from == "tests" || from == "samples" || from == "importer/tool" || from == "viewer/app") return true;
  if (from == "importer/c") return to.starts_with("importer") || to.starts_with("runtime");
  if (from == "importer/geometry_cache")
    return to.starts_with("importer") || kAssets.contains(to) || to == "runtime/geometry_cache";
  if (from == "importer/ambient") return to == from || to == "importer" || kAssets.contains(to) || to == "runtime/plan";
  if (from == "importer/formats") return to == from || to == "importer" || kAssets.contains(to);
  if (from == "importer/python")
    return to == from || to == "importer" || to == "importer/formats" || to.starts_with("runtime");
  if (from == "importer/graph")
    return to == from || to == "importer" || kAssets.contains(to) || to == "runtime/graph" ||
           to == "runtime/playback" || to == "runtime/pose" || to == "runtime/pose_program" || to == "runtime/sync";
  if (from == "importer/ktx2") return to == from;
  if (from == "importer")
    return to == "importer" || to == "importer/ktx2" || kAssets.contains(to) || to.starts_with("runtime/procedures/");
  if (from == "viewer/light")
    return to == from || to == "runtime/base" || to == "runtime/math" || to == "runtime/threads";
  if (from == "viewer") return to == "viewer" || to == "viewer/light" || to.starts_with("runtime/");
  if (from == "runtime") return to == "runtime/c";  // sinew.h
  const auto row = runtime_rows().find(from);
  if (row == runtime_rows().end()) return false;
  return to == from || to.starts_with(from + "/") || row->second.contains(to);
}

/// Libraries that only some parts of the tree may include, by the start of the header's name.
const std::map<std::string, std::set<std::string>> kWhoMayInclude = {
    {"tiny_gltf", {"importer", "tests"}},
    {"OpenMesh/", {"importer", "tests"}},
    {"meshoptimizer", {"importer", "importer/tool", "tests"}},
    {"draco/", {"importer", "tests"}},
    {"assimp/", {"importer/formats", "tests"}},
    {"embree", {"importer/ambient", "tests"}},
    {"vulkan/", {"viewer", "viewer/app", "tests"}},
    {"GLFW/", {"viewer", "viewer/app", "tests"}},
    {"imgui", {"viewer/app", "tests"}},
    {"CLI/", {"importer/tool", "viewer/app", "tests"}},
    {"nlohmann/", {"importer", "importer/graph", "importer/tool", "tests"}},
    {"hwy/",
     {"runtime/base", "runtime/math", "runtime/pose", "runtime/compress", "runtime/deform", "runtime/retarget",
      "runtime/geometry_cache", "runtime/transition", "runtime/procedures", "runtime/procedures/springs", "importer",
      "importer/tool", "tests"}},
    {"zstd",
     {"runtime/asset_file", "runtime/geometry_cache", "importer/geometry_cache", "importer/ktx2", "importer/tool",
      "tests"}},
    {"tbb/", {"runtime/threads", "importer/tool", "tests"}},
    {"oneapi/", {}},
    {"Eigen/", {"runtime/blend_space", "runtime/model", "runtime/procedures", "tests"}},
    {"OpenEXR/", {"viewer/light", "tests"}},
};

std::vector<std::string> broken_arrows(const SourceFile& file) {
  std::vector<std::string> broken;
  const std::string from = part_of(file.path);
  const auto quoted = quoted_includes(file.text);
  for (const std::string& name : quoted) {
    const std::string to = part_of(name);
    if (!to.empty() && !sees(from, to)) broken.push_back(file.path + " includes " + name);
  }
  for (auto names : {quoted, system_includes(file.text)})
    for (const std::string& name : names)
      for (const auto& [library, allowed] : kWhoMayInclude)
        if (name.starts_with(library) && !allowed.contains(from)) broken.push_back(file.path + " includes " + name);
  return broken;
}

TEST(include_direction, holds_in_the_whole_tree) {
  std::vector<std::string> broken;
  for (const SourceFile& file : source_tree())
    for (const std::string& arrow : broken_arrows(file)) broken.push_back(arrow);
  EXPECT_THAT(broken, testing::IsEmpty());
}

TEST(include_direction, every_folder_of_the_runtime_has_a_row_and_no_two_see_each_other) {
  const auto& rows = runtime_rows();
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(SINEW_SOURCE_DIR) / "runtime"))
    if (entry.is_directory()) {
      EXPECT_TRUE(rows.contains("runtime/" + entry.path().filename().string())) << entry.path();
    }
  for (const auto& [folder, seen] : rows)
    for (const std::string& other : seen) {
      ASSERT_TRUE(rows.contains(other)) << folder << " sees " << other << ", which has no row";
      EXPECT_FALSE(other == folder || rows.at(other).contains(folder))
          << folder << " and " << other << " see each other";
    }
}

TEST(include_direction, finds_an_include_against_the_arrow) {
  const auto count = [](const char* path, const char* include) {
    return broken_arrows({path, std::string("#include ") + include + "\n"}).size();
  };
  EXPECT_EQ(count("runtime/math/x.h", "\"runtime/clip/clip.h\""), 1u);
  EXPECT_EQ(count("runtime/clip/x.h", "\"runtime/math/affine.h\""), 0u);
  EXPECT_EQ(count("runtime/clip/x.h", "\"runtime/model/scene.h\""), 1u);
  EXPECT_EQ(count("runtime/playback/x.h", "\"runtime/plan/compile_plan.h\""), 1u);
  for (const char* offline : {"\"runtime/compress/clip_error.h\"", "\"runtime/lod/clip_bounds.h\"",
                              "\"runtime/geometry_cache/geometry_cache.h\""})
    for (const char* frame :
         {"runtime/pose/x.cpp", "runtime/deform/simd/x-inl.h", "runtime/plan/x.cpp", "runtime/threads/x.cpp"})
      EXPECT_EQ(count(frame, offline), 1u) << frame << offline;
  EXPECT_EQ(count("runtime/plan/x.cpp", "\"importer/import_gltf.h\""), 1u);
  EXPECT_EQ(count("runtime/plan/x.cpp", "\"runtime/plan/evaluate/x.h\""), 0u);
  EXPECT_EQ(count("runtime/plan/evaluate/x.cpp", "\"runtime/plan/reuse/x.h\""), 0u);
  EXPECT_EQ(count("runtime/plan/reuse/x.cpp", "\"runtime/plan/evaluate/x.h\""), 1u);
  EXPECT_EQ(count("runtime/plan/reuse/x.cpp", "\"runtime/pose/sample_clip.h\""), 1u);
  EXPECT_EQ(count("importer/build/x.cpp", "\"runtime/pose/sample_clip.h\""), 1u);
  EXPECT_EQ(count("importer/tool/x.cpp", "\"runtime/pose/sample_clip.h\""), 0u);
  EXPECT_EQ(count("runtime/plan/x.cpp", "\"runtime/c/frame.h\""), 1u);
  EXPECT_EQ(count("importer/c/x.cpp", "\"runtime/c/handles.h\""), 0u);
  EXPECT_EQ(count("importer/read/x.cpp", "\"runtime/c/handles.h\""), 1u);
  EXPECT_EQ(count("viewer/passes/x.cpp", "\"importer/import_gltf.h\""), 1u);
  EXPECT_EQ(count("importer/read/x.cpp", "\"importer/ambient/ray_scene.h\""), 1u);
  EXPECT_EQ(count("importer/ambient/x.cpp", "\"runtime/pose/sample_clip.h\""), 1u);
  EXPECT_EQ(count("viewer/app/main.cpp", "\"importer/import_gltf.h\""), 0u);
  EXPECT_EQ(count("viewer/passes/x.cpp", "\"viewer/app/panel/panel.h\""), 1u);
  EXPECT_EQ(count("samples/x/main.cpp", "\"tests/support/near.h\""), 1u);
  EXPECT_EQ(count("runtime/pose/x.cpp", "<vulkan/vulkan.h>"), 1u);
  EXPECT_EQ(count("importer/tool/x.cpp", "\"tiny_gltf.h\""), 1u);
}

TEST(include_direction, names_are_written_from_the_repository_root) {
  std::vector<std::string> relative;
  const std::filesystem::path root = SINEW_SOURCE_DIR;
  for (const SourceFile& file : source_tree())
    for (const std::string& name : quoted_includes(file.text))
      if (!std::filesystem::exists(root / name) && std::filesystem::exists((root / file.path).parent_path() / name))
        relative.push_back(file.path + " includes " + name);
  EXPECT_THAT(relative, testing::IsEmpty());
}

TEST(include_direction, a_source_file_includes_its_own_header_first) {
  std::vector<std::string> late;
  const auto files = source_tree();
  std::set<std::string> headers;
  for (const SourceFile& file : files)
    if (file.is_header()) headers.insert(file.path);
  for (const SourceFile& file : files) {
    if (file.is_header() || file.text.find("foreach_target.h") != std::string::npos) continue;  // Highway's own order
    const std::string own = file.path.substr(0, file.path.size() - 4) + ".h";
    if (!headers.contains(own)) continue;
    const std::size_t first = file.text.find("#include");
    if (!file.text.substr(first).starts_with("#include \"" + own + "\"")) late.push_back(file.path);
  }
  EXPECT_THAT(late, testing::IsEmpty());
}

TEST(include_direction, tinygltf_is_included_by_one_header_only) {
  std::vector<std::string> who;
  for (const SourceFile& file : source_tree())
    for (auto names : {quoted_includes(file.text), system_includes(file.text)})
      for (const std::string& name : names)
        if (name.starts_with("tiny_gltf") && !file.in("tests")) who.push_back(file.path);
  EXPECT_LE(who.size(), 1u) << testing::PrintToString(who);
}

}  // namespace
}  // namespace sinew::test
