#!/usr/bin/env bash
# run-shards.sh PROGRAM COUNT: runs a GoogleTest program's tests in COUNT processes at once, each a
# share of them. For tests that mostly wait. Prints what the failed ones said, gives those a second chance
# alone, and says how many ran.
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
again=()
for ((i = 0; i < count; i++)); do
  wait "${pids[$i]}" && continue
  echo "share $i of $count:"
  grep -v -e '^\[ RUN ' -e '^\[       OK ' "$out/$i" || true
  mapfile -t names < <(sed -n 's/^\[  FAILED  \] \([^ ,]*\).*([0-9]* ms)$/\1/p' "$out/$i")
  [ "${#names[@]}" -gt 0 ] || { echo "share $i ended without its tests' results"; exit 1; }
  again+=("${names[@]}")
done
passed=$(cat "$out"/* | grep -c '^\[       OK ' || true)
# In the computer's time a crowd may have made one late. Alone, it has to pass.
if [ "${#again[@]}" -gt 0 ]; then
  echo "once more, alone: ${again[*]}"
  "$program" --gtest_brief=1 "--gtest_filter=$(IFS=:; echo "${again[*]}")" </dev/null
fi
echo "$passed tests passed in $count processes, ${#again[@]} alone"
[ "$((passed + ${#again[@]}))" -gt 0 ]
