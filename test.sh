#!/usr/bin/env bash
# Sets the machine up, builds everything and runs every test. The last line gives the counts; the exit code is 0 only
# when all passed. Arguments go to ctest, e.g. ./test.sh -R fit.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
source scripts/setup.sh
setup_packages
setup_build

# Lobes and plugins of the user are no part of what is tested.
export XDG_DATA_HOME=$PWD/build/release/tests/none BRDFLAB_MODEL_PATH= BRDFLAB_PLUGIN_PATH=

report=$PWD/build/release/test-report.xml
rm -f "$report"
status=0
ctest --test-dir build/release -j"$(nproc)" --output-on-failure --no-tests=error --output-junit "$report" \
  --progress "$@" || status=$?

count() { sed -n "s/^[[:space:]]*$1=\"\([0-9]*\)\".*/\1/p; s/.*<testsuite .*[[:space:]]$1=\"\([0-9]*\)\".*/\1/p" "$report" | head -n 1; }
[[ -e $report ]] || setup_fail "no test ran"
total=$(count tests) failed=$(count failures) skipped=$(($(count skipped) + $(count disabled)))
echo "$total tests in $SECONDS s, build included:"
echo "$((total - failed - skipped)) passed, $failed failed, $skipped skipped"
exit "$status"
