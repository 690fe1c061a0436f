// SPDX-License-Identifier: MIT
#include "tests/bench/measure.h"

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  sinew::bench::add_memory();
  sinew::bench::add_import();
  sinew::bench::add_sample();
  sinew::bench::add_blend();
  sinew::bench::add_local_to_model();
  sinew::bench::add_morph();
  sinew::bench::add_skin();
  sinew::bench::add_frame();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
