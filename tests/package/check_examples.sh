#!/usr/bin/env bash
# Installs the build into a folder, moves that folder, builds the examples against it alone, runs them, and compares the
# pictures of the three ways in: C++, Python and the command line draw the same.
#   check_examples.sh CMAKE BUILD_FOLDER SOURCE_FOLDER SCRATCH_FOLDER PYTHON_OR_EMPTY PYTHON_FOLDER
set -euo pipefail
cmake=$1 build=$2 source=$3 scratch=$4 python=$5 python_folder=$6

rm -rf "$scratch"
mkdir -p "$scratch/run" "$scratch/python"
"$cmake" --install "$build" --prefix "$scratch/first" >"$scratch/install.log"
mv "$scratch/first" "$scratch/prefix"
prefix=$scratch/prefix
examples=$(find "$prefix" -type d -name examples)

"$cmake" -S "$examples" -B "$scratch/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$prefix" \
  >"$scratch/configure.log" 2>&1 || { cat "$scratch/configure.log"; exit 1; }
"$cmake" --build "$scratch/build" >"$scratch/build.log" 2>&1 || { cat "$scratch/build.log"; exit 1; }
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

gold=preset:bagher-sgd-gold-metallic-paint
cd "$scratch/run"
"$scratch/build/lobe" "0.3*Lambertian + 0.04*GGX(alpha=0.2, ior=1.5)" lobe.png
"$scratch/build/compare_fits" "$gold" "Lambertian + GGX" "Lambertian + Ward"
"$scratch/build/fit_and_render" "$gold" "$prefix/share/brdflab/environments/venice.exr"
"$scratch/build/turn_brdf" turned.png
"$scratch/build/regression" GGX kept.exr
"$scratch/build/regression" GGX kept.exr
if "$scratch/build/regression" "GGX(alpha=0.21)" kept.exr; then
  echo "a changed material passed for the same"
  exit 1
fi

"$prefix/bin/brdf" lobe "0.3*Lambertian + 0.04*GGX(alpha=0.2, ior=1.5)" --size 450x350 --out cli-lobe.png --quiet
cmp lobe.png cli-lobe.png
"$prefix/bin/brdf" fit "$gold" --lobes "Lambertian + GGX" --out fit.vtkhdf --quiet
"$prefix/bin/brdf" render fit.vtkhdf --light "env:$prefix/share/brdflab/environments/venice.exr" --size 128x128 \
  --out cli-sphere.png --quiet
cmp sphere.png cli-sphere.png

if [ -n "$python" ]; then
  cd "$scratch/python"
  export PYTHONPATH=$prefix/$python_folder
  "$python" "$examples/lobe.py" "0.3*Lambertian + 0.04*GGX(alpha=0.2, ior=1.5)" lobe.png
  "$python" "$examples/compare_fits.py" "$gold" "Lambertian + GGX" "Lambertian + Ward"
  "$python" "$examples/fit_and_render.py" "$gold" "$prefix/share/brdflab/environments/venice.exr"
  for picture in lobe errors-a errors-b sphere; do cmp "$picture.png" "../run/$picture.png"; done
fi
