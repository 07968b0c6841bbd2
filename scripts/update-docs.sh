#!/usr/bin/env bash
# Writes docs/models.md and docs/models/ anew from the models' own records (libbrdf/models), and paraview/plugin/*.xml from them
# and from the classes of vtkfilters.
# Usage: scripts/update-docs.sh [BUILD_FOLDER]   (default: the one under build/ that was used last)
set -euo pipefail
cd "$(dirname "$0")/.."
build=${1:-}
if [[ -z $build ]]; then
  build=$(ls -td build/*/build.ninja 2>/dev/null | head -n 1 || true)
  build=${build%/build.ninja}
fi
[[ -e $build/build.ninja ]] || { echo "update-docs.sh: no build folder; cmake --preset release first" >&2; exit 1; }
ninja -C "$build" brdf_app >/dev/null || { echo "update-docs.sh: brdf does not build in $build" >&2; exit 1; }
rm -f docs/models/*.md
# Without lobes of the user's own.
env -u BRDFLAB_MODEL_PATH XDG_DATA_HOME=/nonexistent "$build/bin/brdf" models --markdown docs
# What the ParaView plugin says of the lobes and classes, where the Python package is built.
package=$(compgen -G "$build/lib/python3*/dist-packages" || true)
if [[ -n $package ]]; then
  ninja -C "$build" vtkBRDFFiltersPython >/dev/null
  python=$(sed -n 's/^Python3_EXECUTABLE:[^=]*=//p' "$build/CMakeCache.txt")
  PYTHONPATH=$package "$python" paraview/describe.py "$build/bin/brdf"
fi
