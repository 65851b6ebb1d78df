#!/usr/bin/env bash
# run-shards.sh PROGRAM COUNT: runs a GoogleTest program's tests in COUNT processes at once, each a
# share of them. For tests that mostly wait. Prints what the failed ones said, and how many ran.
set -euo pipefail
program=$1
count=$2
out=$(mktemp -d)
finish() {
  local left
  left=$(jobs -p)
  [ -z "$left" ] || kill $left 2>/dev/null || true
  rm -rf "$out"
}
trap finish EXIT
trap 'exit 1' TERM INT

pids=()
for ((i = 0; i < count; i++)); do
  GTEST_TOTAL_SHARDS=$count GTEST_SHARD_INDEX=$i "$program" >"$out/$i" 2>&1 </dev/null &
  pids+=($!)
done
failed=0
for ((i = 0; i < count; i++)); do
  wait "${pids[$i]}" && continue
  failed=1
  echo "share $i of $count:"
  grep -v -e '^\[ RUN ' -e '^\[       OK ' "$out/$i" || true
done
passed=$(cat "$out"/* | grep -c '^\[       OK ' || true)
echo "$passed tests passed in $count processes"
[ "$passed" -gt 0 ] && [ "$failed" -eq 0 ]
