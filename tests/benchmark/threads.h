// How benchmarks of the soil update are run: on one thread and on two, in wall time.
#pragma once

#include <benchmark/benchmark.h>

namespace softsoil {

inline void OnOneAndTwoThreads(benchmark::internal::Benchmark* family) {
  family->ArgName("threads")->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);
}

}  // namespace softsoil
