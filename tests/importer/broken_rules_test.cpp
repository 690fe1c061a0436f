// SPDX-License-Identifier: MIT
// For every rule of importer/rules.inc a small file breaks it; the import reports its code, severity and JSON pointer.
// Files in broken/ are named after the rule; asset.extras has the location and the expected report. Rules about
// containers and limits, which no .gltf can break, are broken in code.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <set>

#include "importer/rules.h"
#include "tests/importer/tiny_draco.h"
#include "tests/importer/tiny_gltf.h"

namespace sinew::test {
namespace {
namespace fs = std::filesystem;

/// Rules that no file can break, because they guard the importer against its own mistakes.
const std::set<std::string_view> kGuards{"scene-check", "internal"};

const ImportOptions kCollectAll{.collect_all_errors = true};

std::vector<ImportIssue> issues_of(ImportResult<ImportedFile> result) {
  if (result) return std::move(result->warnings);
  ImportError& error = result.error();
  std::vector<ImportIssue> all{std::move(error.issue)};
  all.insert(all.end(), error.more_errors.begin(), error.more_errors.end());
  all.insert(all.end(), error.warnings.begin(), error.warnings.end());
  return all;
}

std::string list(const std::vector<ImportIssue>& issues) {
  std::string text;
  for (const auto& issue : issues) text += describe("file", issue) + '\n';
  return text;
}

/// The reports of a rule at a location, joined by " | "; empty if there are none.
std::string said(const std::vector<ImportIssue>& issues, const RuleText& rule, const std::string& place) {
  std::string text;
  for (const ImportIssue& issue : issues)
    if (issue.rule == rule.id && issue.json_pointer == place && issue.severity == rule.severity)
      text += (text.empty() ? "" : " | ") + issue.detail;
  return text;
}

const RuleText* find_rule(std::string_view id) {
  for (const RuleText& rule : all_rules())
    if (rule.id == id) return &rule;
  return nullptr;
}

std::string container(const std::vector<std::pair<std::string, std::string>>& chunks, const std::string& after = "") {
  const auto number = [](std::size_t n) {
    std::string out;
    for (int shift = 0; shift < 32; shift += 8) out += static_cast<char>(n >> shift & 255);
    return out;
  };
  std::string body;
  for (const auto& [type, data] : chunks) body += number(data.size()) + type + data;
  return "glTF" + number(2) + number(12 + body.size()) + body + after;
}

const std::string kEmpty = R"({"asset":{"version":"2.0"}} )";
const std::string kBin("BIN\0", 4);

/// A rule that no .gltf file can break, its expected report, and the import that breaks it.
struct CaseInCode {
  std::string_view rule;
  std::string says;
  std::vector<ImportIssue> issues;
};

std::vector<CaseInCode> cases_in_code() {
  const auto text = [](const std::string& bytes, const ImportOptions& options = {}) {
    return issues_of(import_gltf(bytes_of(bytes), "case", options));
  };
  ImportOptions two_nodes, ten_bytes;
  two_nodes.max_nodes = 2;
  ten_bytes.max_file_bytes = 10;
  std::vector<CaseInCode> cases;
  const auto add = [&](std::string_view rule, std::string says, std::vector<ImportIssue> issues) {
    cases.push_back({rule, std::move(says), std::move(issues)});
  };
  add("file-unreadable", "No such file or directory", issues_of(import_gltf(fs::path("/nonexistent/x.gltf"))));
  add("file-too-large", "28 bytes are more than allowed", text(kEmpty, ten_bytes));
  add("not-gltf", "the file is gzip data; unpack it (gunzip) and import what is inside", text("\x1f\x8b\x08"));
  add("glb-header", "the file has 5 bytes, a header needs 12", text("glTF\x03"));
  add("glb-header", "the header says 48 bytes, the file has 30; it is cut off: copy or download it again",
      text(container({{"JSON", kEmpty}}).substr(0, 30)));
  add("glb-chunk", "the first chunk is not JSON", text(container({{kBin, "1234"}})));
  add("glb-chunk", "there is a second JSON chunk", text(container({{"JSON", kEmpty}, {"JSON", kEmpty}})));
  add("glb-chunk", "there is a second BIN chunk", text(container({{"JSON", kEmpty}, {kBin, "1234"}, {kBin, "1234"}})));
  add("glb-alignment", "the chunk at byte 12 has 31 bytes, not a multiple of 4; read all the same",
      text(container({{"JSON", kEmpty + "123"}})));
  add("glb-extra-data", "4 bytes after the end are ignored", text(container({{"JSON", kEmpty}}, "more")));
  add("glb-extra-data", "chunk 1 has an unknown type and is ignored",
      text(container({{"JSON", kEmpty}, {"XYZW", "1234"}})));
  add("json-syntax", "line 1, column 10: Invalid value.", text(R"({"asset":)"));
  add("json-syntax", "line 1, column 40: Invalid encoding in string. The text is not UTF-8; save it as UTF-8.",
      text("{\"asset\":{\"version\":\"2.0\",\"generator\":\"\xff\"}}"));
  add("json-bom", "the text starts with a byte order mark, which is skipped", text("\xEF\xBB\xBF" + kEmpty));
  add("json-duplicate", "has \"nodes\" more than once",
      text(R"({"asset":{"version":"2.0"},"nodes":[{}],"nodes":[{},{}]})"));
  add("json-depth", "nested more than 256 deep", text(std::string(100'000, '[')));
  add("too-many", "3 entries, at most 2 are allowed",
      text(R"({"asset":{"version":"2.0"},"nodes":[{},{},{}]})", two_nodes));
  add("buffer-longer", "4 bytes, the BIN chunk has 8; the rest is ignored",
      text(container(
          {{"JSON", R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":4}]}    )"}, {kBin, "12345678"}})));
  const TriangleValues too_bright{{"POSITION", {0, 0, 0, 1, 0, 0, 0, 1, 0}},
                                  {"COLOR_0", {1.001f, 0, 0, 0, 1, 0, 0, 0, 1}}};
  add("draco-range",
      "1 colours and weights outside [0, 1] are clamped; the weights of 0 vertices are divided by their sum",
      issues_of(draco_document(too_bright).import()));
  return cases;
}

const std::map<std::string_view, std::string> kPlaceInCode{
    {"too-many", "/nodes"}, {"buffer-longer", "/buffers/0/byteLength"}, {"draco-range", "/meshes/0/primitives/0"}};

fs::path broken_folder() { return fs::path(SINEW_SOURCE_DIR) / "tests" / "importer" / "broken"; }

TEST(broken_rules, T1_G26_G36_each_file_of_a_few_lines_names_its_rule_and_place_in_its_words) {
  ImportOptions thorough;
  thorough.thorough = thorough.collect_all_errors = true;
  for (const auto& entry : fs::directory_iterator(broken_folder())) {
    SCOPED_TRACE(entry.path().filename().string());
    const RuleText* rule = find_rule(entry.path().stem().string());
    ASSERT_NE(rule, nullptr) << "no rule of this name";
    std::ifstream stream(entry.path());
    const Json json = Json::parse(stream);
    const auto issues = issues_of(import_gltf(entry.path(), thorough));
    const Json& expected = json["asset"]["extras"];
    EXPECT_EQ(said(issues, *rule, expected["at"]), expected["says"]) << expected["at"] << "\n" << list(issues);
    EXPECT_LT(fs::file_size(entry.path()), 4000u) << "a few lines";
  }
}

TEST(broken_rules, broken_containers_and_limits_name_their_rule) {
  for (const auto& [id, says, issues] : cases_in_code()) {
    const RuleText* rule = find_rule(id);
    ASSERT_NE(rule, nullptr) << id;
    const auto place = kPlaceInCode.find(id);
    EXPECT_EQ(said(issues, *rule, place == kPlaceInCode.end() ? "" : place->second), says) << id << '\n'
                                                                                           << list(issues);
  }
}

TEST(broken_rules, no_rule_is_without_a_file_that_breaks_it) {
  const auto in_code = cases_in_code();
  for (const RuleText& rule : all_rules()) {
    if (kGuards.contains(rule.id)) continue;
    const bool in_folder = fs::exists(broken_folder() / (std::string(rule.id) + ".gltf"));
    EXPECT_TRUE(in_folder ||
                std::any_of(in_code.begin(), in_code.end(), [&](const CaseInCode& c) { return c.rule == rule.id; }))
        << rule.id << ": add tests/importer/broken/" << rule.id << ".gltf";
  }
}

TEST(broken_rules, the_page_of_rules_is_the_table_of_rules) {
  std::ifstream page(fs::path(SINEW_SOURCE_DIR) / "importer" / "RULES.md");
  std::vector<std::string> rows, expected;
  for (std::string line; std::getline(page, line);)
    if (line.starts_with("| `")) rows.push_back(line);
  for (const RuleText& rule : all_rules())
    expected.push_back("| `" + std::string(rule.id) + "` | " + name_of(rule.severity) + " | " +
                       std::string(name_of(rule.consequence)) + " | " + std::string(rule.sentence) + " |");
  EXPECT_EQ(rows, expected);
}

TEST(broken_rules, the_consequence_of_a_rule_says_whether_the_file_loads) {
  for (const auto& entry : fs::directory_iterator(broken_folder())) {
    const RuleText* rule = find_rule(entry.path().stem().string());
    ASSERT_NE(rule, nullptr) << entry.path();
    if (rule->consequence == Consequence::refused_or_left_out) continue;  // depends on what needs the broken part
    EXPECT_EQ(import_gltf(entry.path()).has_value(), rule->consequence != Consequence::refused) << entry.path();
  }
}

TEST(broken_rules, one_run_finds_errors_of_every_step) {
  TinyGltf file;
  Json& primitive = file.add_triangle();
  primitive["indices"] = file.add<std::uint16_t>({0, 1, 7}, "SCALAR", 5123, 1);
  file.root["nodes"].push_back({{"rotation", "none"}});
  file.root["nodes"].push_back({{"mesh", 9}});
  file.root["accessors"].push_back({{"bufferView", 0}, {"componentType", 5126}, {"count", 50}, {"type", "VEC3"}});
  file.animate("translation", file.scalars({0, 1}), file.scalars({0, 1}));
  const auto issues = issues_of(file.import(kCollectAll));
  std::set<std::string> found;
  for (const auto& issue : issues)
    if (issue.severity == Severity::error) found.insert(issue.rule + " at " + issue.json_pointer);
  EXPECT_EQ(found,
            (std::set<std::string>{"json-type at /nodes/1/rotation", "reference at /nodes/2/mesh",
                                   "accessor-fit at /accessors/2", "mesh-index at /meshes/0/primitives/0/indices",
                                   "animation-output at /animations/0/samplers/0/output"}))
      << list(issues);
}

/// "rule at /pointer" of the errors, in any order.
std::set<std::string> errors_of(const TinyGltf& file) {
  std::set<std::string> found;
  for (const auto& issue : issues_of(file.import(kCollectAll)))
    if (issue.severity == Severity::error) found.insert(issue.rule + " at " + issue.json_pointer);
  return found;
}

TEST(broken_rules, data_of_sound_entries_are_checked_after_structural_errors) {
  TinyGltf file;
  Json& primitive = file.add_triangle();
  primitive["indices"] = file.add<std::uint16_t>({0, 1, 7}, "SCALAR", 5123, 1);
  const std::string bad_index = "mesh-index at /meshes/0/primitives/0/indices";
  TinyGltf no_asset = file, odd_asset = file, odd_primitive = file, cut = file;
  no_asset.root.erase("asset");
  EXPECT_EQ(errors_of(no_asset), (std::set<std::string>{"json-missing at ", bad_index}));
  odd_asset.root["asset"] = {{"version", true}};
  EXPECT_EQ(errors_of(odd_asset), (std::set<std::string>{"json-type at /asset/version", bad_index}));
  odd_primitive.root["meshes"][0]["primitives"].push_back({{"attributes", 7}});
  EXPECT_EQ(errors_of(odd_primitive),
            (std::set<std::string>{"json-type at /meshes/0/primitives/1/attributes", bad_index}));
  cut.root = Json::parse(cut.text());
  cut.root["buffers"][0]["byteLength"] = 500;
  EXPECT_EQ(errors_of(cut), (std::set<std::string>{"buffer-short at /buffers/0", bad_index}));
}

TEST(broken_rules, consequences_of_an_error_are_not_reported) {
  TinyGltf file;
  file.add_skinned_triangle({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  file.root["accessors"][1]["count"] = 100;  // JOINTS_0
  file.animate("weights", file.times({0, 1}), file.scalars({0, 1}));
  const auto issues = issues_of(file.import(kCollectAll));
  ASSERT_EQ(issues.size(), 1u) << list(issues);
  EXPECT_EQ(issues[0].rule, "accessor-fit");
}

TEST(broken_rules, copies_of_a_mesh_and_pointers_that_only_suffer_from_an_error_are_not_reported) {
  TinyGltf file;
  file.add_triangle();
  const std::size_t broken = file.vec3({0, 0, 0, 1, 2, 3}), whole = file.vec3({1, 1, 1, 2, 2, 2});
  file.root["accessors"][broken]["count"] = 100;
  file.root["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = broken;
  file.root["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"TRANSLATION", broken},
                                                                                  {"SCALE", whole}};
  file.animate("pointer", file.times({0, 1}), file.scalars({0, 1}));
  file.root["animations"][0]["channels"][0]["target"] =
      Json{{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", "/meshes/0/weights"}}}}}};
  const auto issues = issues_of(file.import(kCollectAll));
  ASSERT_EQ(issues.size(), 1u) << list(issues);
  EXPECT_EQ(issues[0].rule, "accessor-fit");
}

TEST(broken_rules, errors_of_copies_are_found_beside_errors_of_earlier_steps) {
  TinyGltf file;
  file.add_triangle()["indices"] = file.add<std::uint16_t>({0, 1, 7}, "SCALAR", 5123, 1);
  file.root["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"SCALE", file.scalars({1, 2})}};
  std::set<std::string> places;
  for (const auto& issue : issues_of(file.import(kCollectAll))) places.insert(issue.json_pointer);
  EXPECT_EQ(places, (std::set<std::string>{"/meshes/0/primitives/0/indices",
                                           "/nodes/0/extensions/EXT_mesh_gpu_instancing/attributes/SCALE"}));
}

TEST(broken_rules, all_nodes_of_a_cycle_are_named_and_the_rest_of_the_file_is_checked) {
  const std::string text =
      R"({"asset":{"version":"2.0"},"nodes":[{"children":[1]},{"children":[2]},{"children":[0]},{"mesh":3}],)"
      R"("accessors":[{"componentType":5126,"count":1,"type":"SCALAR","bufferView":4}]})";
  std::set<std::string> places;
  for (const auto& issue : issues_of(import_gltf(bytes_of(text), "x", kCollectAll))) places.insert(issue.json_pointer);
  EXPECT_EQ(places,
            (std::set<std::string>{"/nodes/0", "/nodes/1", "/nodes/2", "/nodes/3/mesh", "/accessors/0/bufferView"}));
}

TEST(broken_rules, G68_a_flood_of_errors_is_cut_and_ends) {
  std::string text = R"({"asset":{"version":"2.0"},"nodes":[{"mesh":1})";
  for (int n = 0; n < 20'000; ++n) text += R"(,{"mesh":1})";
  const auto issues = issues_of(import_gltf(bytes_of(text + "]}"), "x"));
  EXPECT_EQ(issues.size(), 64u);
  EXPECT_NE(issues.back().detail.find("19937 more of this rule are not listed"), std::string::npos);
  std::size_t cases = 0;
  for (const auto& issue : issues) cases += issue.cases;
  EXPECT_EQ(cases, 20'001u);
  ImportOptions every;
  every.max_listed_per_rule = 30'000;
  const auto all = issues_of(import_gltf(bytes_of(text + "]}"), "x", every));
  ASSERT_EQ(all.size(), 20'001u);
  EXPECT_EQ(all.back().detail.find("not listed"), std::string::npos);
}

TEST(broken_rules, decoded_values_that_are_no_numbers_are_not_called_out_of_range) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const TriangleValues values{{"POSITION", {0, 0, 0, 1, 0, 0, 0, 1, 0}}, {"COLOR_0", {0, nan, 0, 0, 1, 0, 0, 0, 1}}};
  const auto issues = issues_of(draco_document(values).import());
  EXPECT_EQ(said(issues, *find_rule("draco-range"), "/meshes/0/primitives/0"), "") << list(issues);
  EXPECT_NE(said(issues, *find_rule("not-finite"), "/meshes/0/primitives/0/attributes/COLOR_0"), "") << list(issues);
}

TEST(broken_rules, many_warnings_of_a_rule_do_not_hide_its_error) {
  TinyGltf file;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (int i = 0; i < 100; ++i) file.scalars({nan});
  file.add_triangle();
  file.root["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = file.vec3(std::vector<float>(9, nan));
  ImportOptions thorough;
  thorough.thorough = thorough.collect_all_errors = true;
  const auto result = file.import(thorough);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().issue.rule, "not-finite");
  EXPECT_EQ(result.error().issue.json_pointer, "/meshes/0/primitives/0/attributes/NORMAL");
}

}  // namespace
}  // namespace sinew::test
