#!/usr/bin/env bash
# Builds BRDFLab's ParaView plugin, with ParaView unpacked beside it where it is not installed (docs/paraview.md).
#
# usage: build-paraview-plugin.sh [FOLDER]       default: build/paraview
#
#   FOLDER/bin      paraview, pvpython, pvbatch and pvserver that load the plugin by themselves
#   FOLDER/build    the build tree: lib/paraview-VERSION/plugins/BRDFLab/BRDFLab.so
#   FOLDER/prefix   ParaView, where it is not installed
#
# BRDF_BUILD names a build folder or an installed prefix of BRDFLab whose libbrdf is used (default: build/release, made
# where it is missing); ParaView_DIR the CMake folder of a ParaView of your own.
set -euo pipefail
case ${1-} in -h | --help) sed -n '2,13s/^# \?//p' "$0"; exit 0 ;; esac
cd "$(dirname "${BASH_SOURCE[0]}")/.."
folder=$(realpath -m "${1:-build/paraview}")
brdf=$(realpath -m "${BRDF_BUILD:-build/release}")

if ! compgen -G "$brdf/lib*/cmake/brdf/brdfTargets.cmake" >/dev/null &&
  ! compgen -G "$brdf/lib/*/cmake/brdf/brdfTargets.cmake" >/dev/null; then
  [[ -z ${BRDF_BUILD-} ]] || { echo "${0##*/}: no libbrdf in $brdf" >&2; exit 1; }
  cmake --preset release -DBRDF_BUILD_VTK=OFF -DBRDF_BUILD_TESTS=OFF
fi
# Up to date, where it is a build folder.
[[ ! -e $brdf/build.ninja ]] || cmake --build "$brdf" --target brdf

paraview=${ParaView_DIR-}
if [[ -z $paraview ]]; then
  paraview=$(compgen -G "/usr/lib/*/cmake/paraview-*" | head -n 1 || true)
  # An installed one serves only with its Python modules, which hold the class hierarchies that the wrapping reads.
  [[ -n $paraview && -x /usr/bin/pvpython ]] || paraview=$(scripts/paraview-prefix.sh "$folder/prefix")
fi

cmake -S paraview -B "$folder/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DBRDF_BUILD="$brdf" -DParaView_DIR="$paraview" \
  >"$folder/configure.log" 2>&1 || { tail -n 20 "$folder/configure.log" >&2; exit 1; }
cmake --build "$folder/build"

plugin=$(compgen -G "$folder/build/lib/paraview-*/plugins/BRDFLab/BRDFLab.so")
widgets=$(compgen -G "$folder/build/lib/paraview-*/plugins/BRDFLabWidgets" || true)
programs=/usr/bin
[[ ! -d $folder/prefix/bin ]] || programs=$folder/prefix/bin
[[ -z ${ParaView_DIR-} ]] || programs=$(realpath "$ParaView_DIR/../../../bin")
mkdir -p "$folder/bin"
for program in paraview pvpython pvbatch pvserver; do
  [[ -x $programs/$program ]] || continue
  path=$(dirname "$plugin")
  [[ $program != paraview || -z $widgets ]] || path+=:$widgets
  printf '#!/bin/sh\nexport PV_PLUGIN_PATH=%s${PV_PLUGIN_PATH:+:$PV_PLUGIN_PATH}\nexec %s "$@"\n' \
    "$path" "$programs/$program" >"$folder/bin/$program"
  chmod +x "$folder/bin/$program"
done
echo "plugin:   $plugin"
echo "programs: $folder/bin"
