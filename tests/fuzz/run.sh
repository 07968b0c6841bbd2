#!/usr/bin/env bash
# Fuzzes every reader for SECONDS each (default 60), or only the targets named:
#   tests/fuzz/run.sh [--seconds N] [--build-only] [TARGET...]
# Inputs that crash, hang or allocate too much are kept in build/fuzz/findings; new corpus entries in build/fuzz/corpus
# (merge.sh takes a small set of them over). Prints one line a target and the sum of executions.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
seconds=60 targets=() build_only=
while (($#)); do
  case $1 in
    --seconds) seconds=$2; shift 2 ;;
    --build-only) build_only=1; shift ;;
    *) targets+=("$1"); shift ;;
  esac
done
command -v clang++ >/dev/null || { echo "tests/fuzz/run.sh: clang++ is missing" >&2; exit 1; }

flags="-fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer -g1"
cmake -S . -B build/fuzz -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ \
  -DCMAKE_C_FLAGS="$flags" -DCMAKE_CXX_FLAGS="$flags -O1" -DBUILD_SHARED_LIBS=OFF -DBRDF_BUILD_VTK=OFF \
  -DBRDF_BUILD_TESTS=ON -DBRDF_BUILD_FUZZERS=ON >build/fuzz.log 2>&1 || { cat build/fuzz.log >&2; exit 1; }
ninja -C build/fuzz brdf_fuzz >build/fuzz.log 2>&1 || { tail -n 40 build/fuzz.log >&2; exit 1; }
[[ -n $build_only ]] && exit 0

fuzzer=$PWD/build/fuzz/bin/brdf_fuzz
export LSAN_OPTIONS=suppressions=$PWD/tests/fuzz/leaks.txt:print_suppressions=0
((${#targets[@]})) || mapfile -t targets < <("$fuzzer" --list)
mkdir -p build/fuzz/findings build/fuzz/corpus/container
"$fuzzer" --seeds=build/fuzz/corpus/container
status=0 total=0
for target in "${targets[@]}"; do
  mkdir -p "build/fuzz/corpus/$target" "tests/fuzz/corpus/$target"
  log=build/fuzz/findings/$target.log
  # 100 bytes must not make gigabytes: an allocation above 256 MB is a finding, whatever the input.
  "$fuzzer" "--target=$target" -max_total_time="$seconds" -max_len=65536 -timeout=20 -rss_limit_mb=2048 \
    -malloc_limit_mb=256 -print_final_stats=1 -artifact_prefix="build/fuzz/findings/$target-" \
    "build/fuzz/corpus/$target" "tests/fuzz/corpus/$target" tests/data tests/data/*/ >"$log" 2>&1 && result=ok || result=FINDING
  executions=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
  rmdir "tests/fuzz/corpus/$target" 2>/dev/null || true
  printf '%-20s %12s executions  %s\n' "$target" "${executions:-0}" "$result"
  total=$((total + ${executions:-0}))
  [[ $result == ok ]] || status=1
done
printf '%-20s %12s executions, %s s a target\n' "all ${#targets[@]} targets" "$total" "$seconds"
exit "$status"
