#!/usr/bin/env bash
# Installs the build into a folder, moves that folder, builds the examples against it alone, runs them, and compares the
# pictures of the three ways in (run_examples.sh), and with those that docs/install.md shows.
#   check_examples.sh CMAKE BUILD_FOLDER SOURCE_FOLDER SCRATCH_FOLDER PYTHON_OR_EMPTY PYTHON_FOLDER
set -euo pipefail
cmake=$1 build=$2 source=$3 scratch=$4 python=$5 python_folder=$6

rm -rf "$scratch"
mkdir -p "$scratch"
"$cmake" --install "$build" --prefix "$scratch/first" >"$scratch/install.log"
mv "$scratch/first" "$scratch/prefix"
prefix=$scratch/prefix
if grep -n "$source\|$build" "$prefix"/lib*/cmake/*/*.cmake "$prefix"/lib*/*/cmake/*/*.cmake 2>/dev/null; then
  echo "the installed package names the folders that it was built in"
  exit 1
fi

mkdir -p "$scratch/wrong"
printf 'cmake_minimum_required(VERSION 3.25)\nproject(wrong LANGUAGES C CXX)\nfind_package(BRDFLab REQUIRED COMPONENTS nonsense)\n' \
  >"$scratch/wrong/CMakeLists.txt"
if "$cmake" -S "$scratch/wrong" -B "$scratch/wrong/build" -DCMAKE_PREFIX_PATH="$prefix" >"$scratch/wrong.log" 2>&1; then
  echo "a component that does not exist was found"
  exit 1
fi
grep -q "no component nonsense" "$scratch/wrong.log"

"$(dirname "$0")/run_examples.sh" "$cmake" "$prefix" "$scratch" "$python" "$python_folder"
if [ -n "$python" ]; then
  PYTHONPATH=$prefix/$python_folder "$python" "$(dirname "$0")/compare_pictures.py" "$source/docs/images/examples" "$scratch/run"
fi
