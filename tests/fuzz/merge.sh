#!/usr/bin/env bash
# Takes over, from what run.sh found, the smallest inputs that keep the coverage: at most 20 a target, of 4 kB or less.
#   tests/fuzz/merge.sh [TARGET...]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
fuzzer=$PWD/build/fuzz/bin/brdf_fuzz
export LSAN_OPTIONS=suppressions=$PWD/tests/fuzz/leaks.txt:print_suppressions=0
targets=("$@")
((${#targets[@]})) || mapfile -t targets < <("$fuzzer" --list)
for target in "${targets[@]}"; do
  from=build/fuzz/corpus/$target small=build/fuzz/small/$target to=tests/fuzz/corpus/$target
  [[ -d $from ]] || continue
  rm -rf "$small" && mkdir -p "$small" "$to"
  "$fuzzer" "--target=$target" -merge=1 -max_len=4096 "$small" "$from" "$to" >/dev/null 2>&1 || true
  rm -f "$to"/*
  find "$small" -type f -size -5k -printf '%s %p\n' | sort -n | tail -n 20 | cut -d' ' -f2- | xargs -r cp -t "$to"
  rmdir "$to" 2>/dev/null || true
done
