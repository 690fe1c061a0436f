// SPDX-License-Identifier: MIT
// The archives of the runtime have no writable variables. The exceptions are the engine's handler of broken contracts,
// cache sizes of the corrective solver, and an empty name. (Highway's choice of the instruction set is in libhwy; the
// tables of kernels are constants.)
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace sinew::test {
namespace {

std::string output_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string text;
  std::array<char, 4096> part;
  while (pipe && std::fgets(part.data(), part.size(), pipe.get())) text += part.data();
  return text;
}

/// Names of the variables in writable memory, from a symbol table as `objdump -t -C` prints it.
std::vector<std::string> writable_variables(const std::string& table) {
  static const std::regex line(R"(^[0-9a-f]+ .{7} (\.data|\.bss|\.tdata|\.tbss|\*COM\*)(\.\S*)?\s+[0-9a-f]+\s+(.*)$)");
  std::vector<std::string> names;
  std::istringstream lines(table);
  for (std::string text; std::getline(lines, text);)
    if (std::smatch match; std::regex_match(text, match, line))
      if (match[2].str().rfind(".rel.ro", 0) != 0 && !match[3].str().starts_with(".") &&
          match[3].str().find("DW.ref.") == std::string::npos)
        names.push_back(match[3]);
  return names;
}

/// True for the engine's handler of broken contracts (base/contract.h), and for the cache sizes and the empty text.
/// These two are made at the first use and are the same for every caller.
bool is_allowed(const std::string& name) {
  return name == "sinew::(anonymous namespace)::contract_handler" ||
         name.find("Eigen::internal::manage_caching_sizes") != std::string::npos ||
         name.find("sinew::SharedName::str") != std::string::npos;
}

TEST(library_symbols, the_runtime_has_no_globals) {
  const std::string table = output_of("objdump -t -C " SINEW_RUNTIME_ARCHIVES);
  ASSERT_THAT(table, testing::HasSubstr("sinew::run_plan("));  // the table was really read
  for (const std::string& name : writable_variables(table)) EXPECT_TRUE(is_allowed(name)) << name;
}

TEST(library_symbols, P18_the_runtime_asks_for_nothing_of_files_pictures_or_ray_casting) {
  // Lines that end with a colon are file names, whose folder may have any name.
  const std::string table = output_of("nm -C " SINEW_RUNTIME_ARCHIVES " | grep -v ':$'");
  ASSERT_THAT(table, testing::HasSubstr("U tbb::"));  // symbols that the archives need are listed
  for (const char* name :
       {"tinygltf", "nlohmann", "OpenMesh", "draco", "meshopt_", "rtcNew", "stbi_", "WebP", "tjDecompress", "inflate",
        "vkCreate", "glfw", "ImGui", "fopen", "std::basic_ifstream", "import_gltf", "ambient_occlusion"})
    EXPECT_THAT(table, testing::Not(testing::HasSubstr(name)));
}

#ifdef SINEW_SHARED_RUNTIME
TEST(library_symbols, the_shared_library_shows_functions_of_sinew_and_no_copy_of_an_inline_function) {
  std::istringstream lines(output_of("nm -D -C --defined-only " SINEW_SHARED_RUNTIME));
  std::size_t functions = 0;
  for (std::string text; std::getline(lines, text);) {
    const std::string kind = text.substr(std::min(text.size(), text.find(' ')), 3);  // " T " between value and name
    functions += kind == " T ";
    const bool asks_for_memory = text.find("FrameBuffer<std::pmr::memory_resource>") != text.npos;  // computes nothing
    EXPECT_TRUE(kind != " W " || asks_for_memory) << text;
    EXPECT_TRUE(kind != " u " || std::regex_search(text, std::regex("::k[A-Z]"))) << text;  // constants of classes
    EXPECT_THAT(text, testing::HasSubstr("sinew")) << "of another library";
    EXPECT_THAT(text, testing::Not(testing::HasSubstr("::N_"))) << "a kernel";
  }
  EXPECT_GT(functions, 100u);
  EXPECT_LT(functions, 400u);
}
#endif

#ifdef SINEW_IMPORTER_ARCHIVE
// Classes of tinygltf are inline, and Debian's libdraco and engines contain other versions of them. Of two classes with
// one name the linker takes the first it meets. Then the destructor of one version would destroy an object of the
// other.
TEST(library_symbols, the_importer_shares_no_class_with_another_copy_of_tinygltf) {
  const std::string table = output_of("nm -C --defined-only " SINEW_IMPORTER_ARCHIVE);
  ASSERT_THAT(table, testing::HasSubstr(" sinew_tinygltf::Model::"));
  EXPECT_THAT(table, testing::Not(testing::HasSubstr(" tinygltf::")));
}
#endif

TEST(library_symbols, only_the_job_thread_asks_for_onetbb) {
  const std::string table = output_of("nm -C " SINEW_RUNTIME_ARCHIVE);
  ASSERT_THAT(table, testing::HasSubstr("sinew::run_plan("));
  EXPECT_THAT(table, testing::Not(testing::HasSubstr("tbb::")));
}

TEST(library_symbols, a_variable_is_found_and_a_constant_is_not) {
  EXPECT_THAT(writable_variables("0000000000000000 l     O .bss\t0000000000000008 (anonymous namespace)::calls\n"
                                 "0000000000000000 l     O .tbss.x\t0000000000000008 cache\n"
                                 "0000000000000000 g     O .data\t0000000000000008 sinew::state\n"
                                 "0000000000000000  w    O .data.rel.ro._ZTV1A\t0000000000000018 vtable for A\n"
                                 "0000000000000000 l     O .rodata\t0000000000000008 kTable\n"
                                 "0000000000000000 l    d  .bss\t0000000000000000 .bss\n"),
              testing::ElementsAre("(anonymous namespace)::calls", "cache", "sinew::state"));
}

}  // namespace
}  // namespace sinew::test
