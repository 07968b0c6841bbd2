#!/usr/bin/env bash
# Downloads measured BRDFs of the public databases, by name, into the current folder or the one given with --to.
# Each database has its own terms, which --list shows: downloading means that you accept them.
set -euo pipefail

usage() {
  cat <<'TEXT'
usage: download.sh [--to FOLDER] DATABASE NAME...
       download.sh --list | --help

  DATABASE  merl           one NAME.binary for each NAME, 33 MiB: gold-metallic-paint, alum-bronze, ...
            rgl            one NAME_rgb.bsdf for each NAME: acrylic_felt_green, colodur_connemara_4c, ...
            rgl-spectral   one NAME_spec.bsdf for each NAME
  --to      folder to write to (made when missing)
  --list    every database: what it holds, its page, its terms, and how to get it

A file that is there and complete is left alone; a partial download (NAME.part) is resumed.
example: datasets/download.sh --to merl merl gold-metallic-paint nickel
TEXT
}

list() {
  cat <<'TEXT'
merl          MERL BRDF database: 100 isotropic materials, RGB (Matusik, Pfister, Brand, McMillan 2003)
              page   https://www.merl.com/research/downloads/BRDF
              terms  free for academic and research use, with citation; commercial use needs MERL's licence
              get    download.sh merl NAME...
rgl           RGL material database, EPFL: isotropic and anisotropic, RGB and spectral (Dupuy, Jakob 2018)
              page   https://rgl.epfl.ch/materials
              terms  CC0 1.0, as each material's page states; citation asked for
              get    download.sh rgl NAME...    download.sh rgl-spectral NAME...
utia          UTIA BRDF database, Prague: 150 anisotropic materials, RGB (Filip, Vavra 2014)
              page   http://btf.utia.cas.cz/?brdf_dat_dwn
              terms  research use, no redistribution; access is granted on the page
              get    by hand, from the page
mpi-carpaint  MPI Informatik car paint BRDFs (Guenther, Chen, Goesele, Wald, Seidel 2005)
              page   https://www.mpi-inf.mpg.de (search for "BRDF car paint")
              terms  non-commercial use, with citation
              get    by hand, from the page
cornell       Cornell Program of Computer Graphics, light measurement laboratory: spectral, isotropic
              page   https://www.graphics.cornell.edu/online/measurements/reflectance/
              terms  research use, with acknowledgement
              get    by hand, from the page
csail-aniso   MIT CSAIL anisotropic BRDFs: 4 materials (Ngan, Durand, Matusik 2005)
              page   https://people.csail.mit.edu/addy/research/brdf
              terms  research use, with citation
              get    by hand, from the page
TEXT
}

fail() {
  echo "download.sh: $1" >&2
  exit "${2:-1}"
}

# url_of DATABASE NAME: where the file lies.
url_of() {
  case $1 in
    merl) echo "https://people.csail.mit.edu/wojciech/BRDFDatabase/brdfs/$2.binary" ;;
    rgl) echo "https://rgl.s3.eu-central-1.amazonaws.com/media/materials/$2/$2_rgb.bsdf" ;;
    rgl-spectral) echo "https://rgl.s3.eu-central-1.amazonaws.com/media/materials/$2/$2_spec.bsdf" ;;
    utia | mpi-carpaint | cornell | csail-aniso) fail "$1 is not offered for automatic download; see --list" ;;
    *) fail "unknown database: $1; allowed: merl, rgl, rgl-spectral (see --list)" 2 ;;
  esac
}

# complete DATABASE FILE: whether the file is whole and in its database's format.
complete() {
  [ -f "$2" ] || return 1
  case $1 in
    # Three little-endian int32 (90, 90, 180), then 3 x 1458000 doubles.
    merl)
      [ "$(wc -c <"$2")" -eq 34992012 ] &&
        [ "$(head -c 12 "$2" | od -An -v -tu1 | tr -s ' \n' ' ')" = " 90 0 0 0 90 0 0 0 180 0 0 0 " ]
      ;;
    rgl | rgl-spectral) [ "$(head -c 11 "$2")" = tensor_file ] ;;
  esac
}

fetch() {
  local database=$1 name=$2 folder=$3 url file
  [[ $name =~ ^[A-Za-z0-9][A-Za-z0-9._-]*$ ]] || fail "not a material's name: $name" 2
  url=$(url_of "$database" "$name")
  file=$folder/${url##*/}
  if complete "$database" "$file"; then
    echo "$file: already there"
    return
  fi
  if complete "$database" "$file.part"; then
    mv "$file.part" "$file"
    return
  fi
  echo "$file: from $url"
  command -v curl >/dev/null || fail "needs curl"
  curl --fail --location --silent --show-error --connect-timeout 20 --retry 3 --continue-at - \
    --output "$file.part" "$url" || fail "$name: download failed (no network, or no such material); run again to resume"
  if ! complete "$database" "$file.part"; then
    rm -f "$file.part"
    fail "$name: what came is not a complete $database file, and was removed"
  fi
  mv "$file.part" "$file"
}

folder=.
arguments=()
while [ $# -gt 0 ]; do
  case $1 in
    --help | -h) usage; exit 0 ;;
    --list) list; exit 0 ;;
    --to)
      [ $# -ge 2 ] || fail "--to needs a folder" 2
      folder=$2
      shift
      ;;
    -*) fail "unknown option: $1 (see --help)" 2 ;;
    *) arguments+=("$1") ;;
  esac
  shift
done
if [ ${#arguments[@]} -lt 2 ]; then
  usage >&2
  exit 2
fi
url_of "${arguments[0]}" name >/dev/null
mkdir -p "$folder"
for name in "${arguments[@]:1}"; do
  fetch "${arguments[0]}" "$name" "$folder"
done
