// SPDX-License-Identifier: MIT
#include <cstdio>
#include <cstring>
#include <string>
#include <string_view>

#include "tests/bench/measure.h"
#include "tests/bench/targets.h"

namespace sinew::bench {
namespace {

void print_help() {
  std::fputs(
      "sinew-bench [--target NAME] [BENCHMARK OPTIONS]   measures; NAME is the instruction set that the jobs are held\n"
      "                                                  to: avx3 (AVX-512), avx2, sse4, neon or scalar (one float at\n"
      "                                                  a time); without it they choose as always\n"
      "sinew-bench --targets                             the names that this machine can run, the best first\n"
      "sinew-bench --instructions                        under callgrind: counts instructions on each target\n"
      "sinew-bench --compiler                            the compiler that made this program\n\n",
      stdout);
  benchmark::PrintDefaultHelp();
}

/// Options of this program; other arguments stay in argv for Google Benchmark.
struct Options {
  std::string target;  ///< empty = the best one
  bool targets = false, instructions = false, compiler = false;
  bool complete = true;  ///< false: --target has no name behind it

  Options(int& argc, char** argv) {
    int kept = 1;
    for (int i = 1; i < argc; ++i) {
      const std::string_view word = argv[i];
      if (word == "--targets")
        targets = true;
      else if (word == "--instructions")
        instructions = true;
      else if (word == "--compiler")
        compiler = true;
      else if (word.starts_with("--target="))
        target = word.substr(std::strlen("--target="));
      else if (word == "--target" && i + 1 < argc)
        target = argv[++i];
      else if (word == "--target")
        complete = false;
      else
        argv[kept++] = argv[i];
    }
    argc = kept;
  }
};

std::string listed(const std::vector<std::string>& names, const char* between) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : between) + name;
  return list;
}

/// Applies --target.
/// err  false, with a message on stderr: no such target on this machine
bool hold_to(const Options& options) {
  if (!options.complete || (!options.target.empty() && !choose_target(options.target))) {
    const std::string asked = options.complete ? "cannot run target '" + options.target + "'" : "--target needs a name";
    std::fprintf(stderr, "sinew-bench: %s; this machine has %s\n", asked.c_str(), listed(target_names(), ", ").c_str());
    return false;
  }
  benchmark::AddCustomContext("target", options.target.empty() ? target_names().front() : options.target);
  return true;
}

void add_all(bool for_counting) {
  const std::size_t most_vertices = for_counting ? 10'000 : 1'000'000;  // valgrind is too slow for larger cases
  if (!for_counting) {
    add_memory();
    add_import();
    add_setup();
    add_asset_files();
    add_geometry_cache();
    add_job_thread();
    add_ik();
  }
  add_sample();
  add_blend();
  add_mirrors();
  add_springs();
  add_local_to_model();
  add_instances();
  add_crowd();
  add_correctives();
  add_palettes();
  add_morph();
  add_flat_normals();
  add_skin(most_vertices);
  add_model_skin();
  add_frame(most_vertices);
}

}  // namespace
}  // namespace sinew::bench

int main(int argc, char** argv) {
  using namespace sinew::bench;
  const Options options(argc, argv);
  if (options.targets) return std::puts(listed(target_names(), "\n").c_str()) < 0;
  if (options.compiler) return std::puts(compiler().c_str()) < 0;
  if (!hold_to(options)) return 2;
  if (options.instructions) {
    add_all(true);
    if (count_instructions()) return 0;
    std::fputs("sinew-bench --instructions runs under valgrind --tool=callgrind only\n", stderr);
    return 3;
  }
  benchmark::Initialize(&argc, argv, print_help);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  add_all(false);
  register_cases();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
