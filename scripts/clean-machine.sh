#!/usr/bin/env bash
# Checks on a Debian of which only the base is there, in a folder (debootstrap and chroot: as root). The folder is kept,
# so that a second run goes on where the first one was; delete it when done.
#   scripts/clean-machine.sh package FOLDER brdflab_VERSION_amd64.deb   installs the package, runs the program and Python,
#                                                builds the examples against it, and compares their pictures
#   scripts/clean-machine.sh sources FOLDER [TEST_PATTERN]   builds this checkout's last commit and runs its tests (ctest -R)
# SUITE=trixie takes Debian 13; bookworm is the default.
set -euo pipefail
cd "$(dirname "$0")/.."
what=${1:-} folder=${2:-}
[[ $what == package || $what == sources ]] && [[ -n $folder ]] || { sed -n '2,8s/^# \?//p' "$0" >&2; exit 2; }
((EUID == 0)) || { echo "clean-machine.sh: debootstrap and chroot need root" >&2; exit 1; }
suite=${SUITE:-bookworm}

if [[ ! -e $folder/etc/debian_version ]]; then
  echo "Debian $suite into $folder"
  debootstrap --variant=minbase "$suite" "$folder" >"${folder%/}.log" 2>&1 || { tail "${folder%/}.log"; exit 1; }
  cp /etc/resolv.conf /etc/hosts "$folder/etc/"
fi
mounted=()
trap 'for place in "${mounted[@]}"; do umount -l "$place"; done' EXIT
for place in proc sys dev; do
  mountpoint -q "$folder/$place" && continue
  mount --bind "/$place" "$folder/$place"
  mounted+=("$folder/$place")
done
inside() { chroot "$folder" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive bash -euo pipefail -c "$*"; }
install_packages() { inside "apt-get update -q && apt-get install -q -y --no-install-recommends $*" >"${folder%/}.packages.log" 2>&1 || { tail "${folder%/}.packages.log"; exit 1; }; }

if [[ $what == package ]]; then
  package=$(basename "$3")
  cp "$3" "$folder/tmp/$package"
  install_packages "/tmp/$package"
  inside 'brdf --version && brdf models >/dev/null && cd /tmp && brdf lobe "GGX(alpha=0.2)" --out first.png --quiet'
  echo "The program alone: works"
  install_packages python3-vtk9 python3-numpy cmake g++ ninja-build libvtk9-dev mpi-default-dev
  mkdir -p "$folder/opt/check"
  cp tests/package/run_examples.sh tests/package/check_plugin.sh "$folder/opt/check/"
  inside 'rm -rf /tmp/examples && /opt/check/run_examples.sh cmake /usr /tmp/examples /usr/bin/python3 lib/python3/dist-packages'
  echo "Examples in C++ and Python, and the command line: the same pictures"
else
  if [[ ! -e $folder/brdflab ]]; then git clone -q . "$folder/brdflab"; fi
  git -C "$folder/brdflab" pull -q --ff-only "$PWD" HEAD
  install_packages git python3 "$(sed 's/#.*//' packages.txt | tr '\n' ' ')"
  inside 'cd /brdflab && cmake --preset release && ninja -C build/release'
  inside "cd /brdflab && ctest --test-dir build/release -j\$(nproc) --output-on-failure -R '${3:-.}'"
fi
