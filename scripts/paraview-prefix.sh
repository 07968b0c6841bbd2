#!/usr/bin/env bash
# Unpacks Debian's ParaView with its Python modules and development files into a folder, without installing anything and
# without root: python3-paraview conflicts with python3-vtk9, on which libvtk9-dev depends, so that apt would remove one
# for the other. bin/ of the folder has paraview, pvpython, pvbatch and pvserver, which find their libraries themselves.
#
# usage: paraview-prefix.sh FOLDER      prints what ParaView_DIR has to be
set -euo pipefail

fail() {
  echo "${0##*/}: $*" >&2
  exit 1
}
(($# == 1)) || { sed -n '2,6s/^# \?//p' "$0"; exit 2; }
command -v apt-get >/dev/null || fail "needs Debian's apt-get; elsewhere set ParaView_DIR to your ParaView's CMake folder"

folder=$(realpath -m "$1")
triplet=$(dpkg-architecture -qDEB_HOST_MULTIARCH 2>/dev/null || gcc -print-multiarch)
libraries=$folder/usr/lib/$triplet
if ! compgen -G "$libraries/cmake/paraview-*/paraview-config.cmake" >/dev/null || [[ ! -e $folder/bin/pvserver ]]; then
  packages=(paraview paraview-dev python3-paraview)
  # Libraries that ParaView needs and this machine lacks; of its Python packages only the web server needs any.
  mapfile -t missing < <(apt-get install -s --no-install-recommends paraview 2>/dev/null | sed -n 's/^Inst \(lib[^ ]*\) .*/\1/p')
  rm -rf "$folder/usr" "$folder/deb" "$folder/bin"
  mkdir -p "$folder/deb" "$folder/bin"
  (cd "$folder/deb" && apt-get -o APT::Sandbox::User=root download -q "${packages[@]}" "${missing[@]}" >download.log 2>&1) ||
    { tail -n 3 "$folder/deb/download.log" >&2; fail "apt-get could not download ParaView (apt-get update may help)"; }
  for package in "$folder"/deb/*.deb; do dpkg-deb -x "$package" "$folder"; done
  rm -rf "$folder/deb" "$folder/etc" "$folder/usr/share/doc"

  # Debian 13 names Python modules X.cpython-*.so, its CMake files still say X.so; the plugin needs none of them.
  find "$libraries/cmake" -name '*Python*-targets-*.cmake' -exec sed -i '/_cmake_import_check_\|_IMPORT_CHECK_/d' {} +

  for program in paraview pvpython pvbatch pvserver; do
    cat >"$folder/bin/$program" <<PROGRAM
#!/bin/sh
LD_LIBRARY_PATH=$libraries\${LD_LIBRARY_PATH:+:\$LD_LIBRARY_PATH}
PYTHONPATH=$folder/usr/lib/python3/dist-packages\${PYTHONPATH:+:\$PYTHONPATH}
export LD_LIBRARY_PATH PYTHONPATH
exec $folder/usr/bin/$program "\$@"
PROGRAM
    chmod +x "$folder/bin/$program"
  done
fi
echo "$libraries"/cmake/paraview-*
