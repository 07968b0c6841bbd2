#!/usr/bin/env bash
# Builds the examples against an installed BRDFLab alone, runs them, and compares the pictures of the three ways in: C++,
# Python and the command line draw the same.
#   run_examples.sh CMAKE PREFIX SCRATCH_FOLDER PYTHON_OR_EMPTY PYTHON_FOLDER
set -euo pipefail
cmake=$1 prefix=$2 scratch=$3 python=$4 python_folder=$5
examples=$(find "$prefix"/share/doc -type d -ipath "*brdflab*/examples" | head -n 1)
mkdir -p "$scratch/run" "$scratch/python"

"$cmake" -S "$examples" -B "$scratch/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$prefix" \
  >"$scratch/configure.log" 2>&1 || { cat "$scratch/configure.log"; exit 1; }
"$cmake" --build "$scratch/build" >"$scratch/build.log" 2>&1 || { cat "$scratch/build.log"; exit 1; }

gold=preset:bagher-sgd-gold-metallic-paint
cd "$scratch/run"
"$scratch/build/lobe" "0.3*Lambertian + 0.04*GGX(alpha=0.2, ior=1.5)" lobe.png
"$scratch/build/compare_fits" "$gold" "Lambertian + GGX" "Lambertian + Ward"
"$scratch/build/fit_and_render" "$gold" "$prefix/share/brdflab/environments/venice.exr"
"$scratch/build/turn_brdf" turned.png
"$scratch/build/grooves" quick >grooves.txt
"$prefix/bin/brdf" info "grooves.vtkhdf#fit of 150 degrees" >/dev/null
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
  "$python" "$examples/grooves.py" quick >grooves.txt
  cmp <(cut -c 1-48 grooves.txt) <(cut -c 1-48 ../run/grooves.txt) # reflectances and errors
  for entry in "150 degrees" "fit of 150, crossed"; do # threads add in any order: not to the last bit
    "$prefix/bin/brdf" compare "grooves.vtkhdf#$entry" "../run/grooves.vtkhdf#$entry" --quiet --json - |
      "$python" -c 'import json, sys; assert json.load(sys.stdin)["metrics"]["rms"] < 1e-9'
  done
  "$python" "$examples/regression.py" GGX kept.npy
  "$python" "$examples/regression.py" GGX kept.npy
  if "$python" "$examples/regression.py" "GGX(alpha=0.21)" kept.npy; then
    echo "a changed material passed for the same"
    exit 1
  fi
  "$python" "$examples/custom_filter/highlight.py" | grep "0 degrees: 15.0 degrees wide" >/dev/null
  for picture in lobe errors-a errors-b sphere grooves; do cmp "$picture.png" "../run/$picture.png"; done
fi
