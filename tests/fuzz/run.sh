#!/usr/bin/env bash
# Runs one fuzz target: tests/fuzz/run.sh NAME [LIBFUZZER_OPTION]..., for example
#   tests/fuzz/run.sh soil -runs=10000000
# Starts from the corpus that is kept; new inputs go to build/fuzz/corpus/NAME, findings to
# build/fuzz/findings. Build first: cmake --preset fuzz && cmake --build --preset fuzz
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

name=$1
new=build/fuzz/corpus/$name
options=(-timeout=60 -rss_limit_mb=1024 -max_len=4096)
[[ ! -f tests/fuzz/dictionary/$name.txt ]] || options+=("-dict=tests/fuzz/dictionary/$name.txt")
[[ $name != state ]] || options+=(-max_len=64 -len_control=0)  # a dozen edits of a file
mkdir -p "$new" build/fuzz/findings
# Short stacks of allocations: to unwind at each of them takes most of the time.
export ASAN_OPTIONS=malloc_context_size=2:quarantine_size_mb=16
exec "build/fuzz/bin/${name}_fuzz" "${options[@]}" -artifact_prefix=build/fuzz/findings/ -print_final_stats=1 \
  "${@:2}" "$new" "tests/fuzz/corpus/$name"
