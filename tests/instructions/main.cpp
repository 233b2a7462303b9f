// Runs each workload, counted by callgrind (--instr-atstart=no), whose counts are written down under its name.
#include <valgrind/callgrind.h>

#include <cstdio>

#include "tests/instructions/workloads.hpp"

int main() {
  for (const auto& workload : sightline::instructions::workloads()) {
    const auto work = workload.prepare();
    CALLGRIND_START_INSTRUMENTATION;
    CALLGRIND_ZERO_STATS;
    work();
    CALLGRIND_DUMP_STATS_AT(workload.name.c_str());
    CALLGRIND_STOP_INSTRUMENTATION;
    std::puts(workload.name.c_str());
  }
}
