#!/bin/sh
# run-fuzzer.sh FUZZER CORPUS SCRATCH: feeds FUZZER for EYEBRIDGE_TEST_FUZZ_SECONDS (3) from a copy of CORPUS.
# A crash leaves its input in SCRATCH and fails.
set -eu
[ -d "$2" ] && [ -n "$(ls "$2")" ] || { echo "$2: no seed corpus; expected at least one input" >&2; exit 1; }
mkdir -p "$3/corpus"
cp "$2"/* "$3/corpus/"
exec "$1" -max_total_time="${EYEBRIDGE_TEST_FUZZ_SECONDS:-3}" -timeout=10 -rss_limit_mb=2048 -print_final_stats=1 \
  -verbosity=0 -artifact_prefix="$3/" "$3/corpus"
