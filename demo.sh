#!/usr/bin/env bash
# From a measured material to a fit, pictures and a file, without a display:
#   ./demo.sh [MEASURED_FILE]
# Without an argument the measurement is stood in for by a table computed from the published shifted-gamma fit of
# gold-metallic-paint. Files go to ./demo-out, or to the folder that BRDF_DEMO_OUT names.
set -euo pipefail
start=$PWD
case ${1:-} in
  -h | --help) sed -n '2,/^set/{/^set/d; s/^# \{0,1\}//; p}' "${BASH_SOURCE[0]}"; exit ;;
esac
if (($# > 1)); then echo "${0##*/}: one file at most; found $# arguments" >&2; exit 2; fi
measured=${1:+$(realpath -m -- "$1")}
[[ -z $measured || -r $measured ]] || { echo "${0##*/}: $1: no such file, or not readable" >&2; exit 1; }
out=$(realpath -m -- "${BRDF_DEMO_OUT:-demo-out}")
cd "$(dirname "${BASH_SOURCE[0]}")"

source scripts/setup.sh
setup_packages
setup_build brdf_app brdf_pictures

brdf=$PWD/build/release/bin/brdf
environment=$PWD/datasets/environments/studio.exr
mkdir -p "$out"
cd "$out"
if [[ -z $measured ]]; then
  measured=gold-metallic-paint.binary
  echo "== A measurement: MERL table of the published fit of gold-metallic-paint (Bagher et al. 2012)"
  "$brdf" convert preset:bagher-sgd-gold-metallic-paint "$measured"
fi
name=$(basename -- "${measured%.*}")
container=$name-fit.vtkhdf

echo "== What it is"
"$brdf" info "$measured"
echo "== The fit: Lambertian and GGX, up to 80 degrees"
"$brdf" fit "$measured" --lobes "Lambertian + GGX" --channels rgb --metric cuberoot --max-theta 80 \
  --out "$container" --report "$name-fit.txt" --json "$name-fit.json"
echo "== Pictures"
"$brdf" lobe "$measured" "$container" --theta-i 45 --transform cuberoot --out "$name-lobe.png"
"$brdf" error "$container" "$measured" --measure cuberoot --out "$name-error.png"
"$brdf" render "$container" --light "env:$environment" --samples 256 --out "$name-render.png" --out "$name-render.exr"

echo
echo "Files in $(realpath --relative-to="$start" "$out"):"
for file in "$name-fit.txt:fit report" "$name-fit.json:fit report for programs" "$name-lobe.png:lobes, measured and fit" \
  "$name-error.png:error map" "$name-render.png:a sphere of the fit under environment light" \
  "$name-render.exr:the same, linear radiance" "$container:the fit with its provenance"; do
  [[ -s ${file%%:*} ]] || setup_fail "${file%%:*} was not written"
  printf '  %-34s %s\n' "${file%%:*}" "${file#*:}"
done
