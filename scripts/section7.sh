#!/usr/bin/env bash
# Section 7 of the BRDFLab paper as one batch: its optimizers and its models on its four materials.
#
#   scripts/section7.sh [--merl DIR] [--out DIR] [--ranks N]
#
# DIR of --merl (default datasets/merl) holds the measurements, which `datasets/download.sh merl --to datasets/merl
# red-fabric orange-paint pearl-paint blue-metallic-paint` fetches. Unless all four are there, tables computed from the
# published shifted-gamma fits of the materials (presets) stand in for them: free of noise, and themselves a microfacet
# model. Every table and picture then says "surrogate", and nothing follows from them about the paper. The report is
# report/report.md in DIR of --out (default section7-out). Started again, it goes on.
set -euo pipefail
merl=datasets/merl out=section7-out ranks=1
usage() { sed -n '2,/^set/{/^set/d; s/^# \{0,1\}//; p}' "${BASH_SOURCE[0]}"; }
while (($#)); do
  case $1 in
    -h | --help) usage; exit ;;
    --merl | --out | --ranks)
      (($# > 1)) || { echo "section7.sh: $1 needs a value" >&2; exit 2; }
      printf -v "${1#--}" %s "$2"
      shift 2
      ;;
    *) echo "section7.sh: unknown argument: $1; allowed: --merl DIR, --out DIR, --ranks N" >&2; exit 2 ;;
  esac
done
[[ $ranks =~ ^[1-9][0-9]*$ ]] || { echo "section7.sh: --ranks: found $ranks; allowed: 1, 2, ..." >&2; exit 2; }
root=$(dirname "$(dirname "$(realpath "${BASH_SOURCE[0]}")")")
[[ $merl == /* || -d $merl ]] || merl=$root/$merl
brdf=${BRDF:-$root/build/release/bin/brdf}
[[ -x $brdf ]] || { echo "section7.sh: no program at $brdf; build it, or set BRDF" >&2; exit 1; }
mkdir -p "$out"

materials=(red-fabric orange-paint pearl-paint blue-metallic-paint)
kind=measured note=
for material in "${materials[@]}"; do [[ -f $merl/$material.binary ]] || kind=surrogate; done
if [[ $kind == surrogate ]]; then
  note="surrogate: tables of published shifted-gamma fits (Bagher et al. 2012), not measurements; nothing follows about the paper"
  echo "Without all four measurements in $merl: surrogates."
fi
targets=
for material in "${materials[@]}"; do
  name=$material file=$(realpath -m "$merl/$material.binary")
  if [[ $kind == surrogate ]]; then
    name="$material (surrogate)" file=$material-surrogate.binary
    [[ -f $out/$file ]] || "$brdf" convert "preset:bagher-sgd-$material" "$out/$file" --quiet
  fi
  targets+="${targets:+,}
    {\"name\": \"$name\", \"material\": \"$file\"}"
done

cat >"$out/section7.json" <<JOB
{
  "title": "Section 7: optimizers and models",
  "note": "$note",
  "targets": [$targets
  ],
  "fits": [
    {"title": "Figure 7, top: optimizers, from the default parameters",
     "lobes": "Lambertian + AshikhminShirley",
     "optimizer": ["lm", "cobyla", "bobyqa", "newuoa", "praxis", "neldermead", "sbplx"],
     "no-scan": true, "max-theta": 80},
    {"title": "Figure 7, bottom: models, by Levenberg-Marquardt",
     "lobes": ["Lambertian + BlinnPhong", "Lambertian + Ward", "Lambertian + Lafortune", "Lambertian + CookTorrance",
               "Lambertian + AshikhminShirley"],
     "max-theta": 80},
    {"title": "Two lobes and a diffuse one: at once, or one at a time",
     "lobes": "Lambertian + AshikhminShirley + CookTorrance",
     "progressive": [false, true], "no-scan": true, "max-theta": 80},
    {"title": "Scale factors: by least squares inside the search, or searched with the rest",
     "lobes": "Lambertian + AshikhminShirley",
     "strategy": ["separable", "joint"], "no-scan": true, "max-theta": 80},
    {"title": "Metrics of the paper: L2, L2 times the cosine, Ngan's",
     "lobes": "Lambertian + AshikhminShirley",
     "metric": ["rms", "rms_cos", "ngan"], "max-theta": 80}
  ]
}
JOB
command=("$brdf" batch "$out/section7.json" --out "$out/results" --report "$out/report")
if ((ranks > 1)); then command=(mpirun -n "$ranks" "${command[@]}"); fi
exec "${command[@]}"
