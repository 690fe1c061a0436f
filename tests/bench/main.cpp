// SPDX-License-Identifier: MIT
#include <cstdio>
#include <string_view>

#include "tests/bench/measure.h"

int main(int argc, char** argv) {
  using namespace sinew::bench;
  const bool instructions = argc == 2 && std::string_view(argv[1]) == "--instructions";
  if (!instructions) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  }
  add_memory();
  add_import();
  add_sample();
  add_blend();
  add_local_to_model();
  add_instances();
  add_crowd();
  add_correctives();
  add_morph();
  const std::size_t most_vertices = instructions ? 10'000 : 1'000'000;  // valgrind is slow on the larger ones
  add_skin(most_vertices);
  add_model_skin();
  add_frame(most_vertices);
  if (!instructions) add_job_thread();  // callgrind runs one thread at a time
  if (instructions) {
    if (count_instructions()) return 0;
    std::fputs("sinew-bench --instructions runs under valgrind --tool=callgrind only\n", stderr);
    return 3;
  }
  register_cases();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
