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
  # The Qt that its window is made with, for widgets of ours in it.
  qt=(qtbase5-dev libqt5opengl5-dev libqt5svg5-dev qttools5-dev)
  apt-cache depends paraview | grep -q libqt5widgets5 || qt=(qt6-base-dev qt6-svg-dev qt6-tools-dev qt6-5compat-dev)
  # What ParaView and that Qt need and this machine lacks; of Python's packages only ParaView's web server needs any.
  mapfile -t missing < <(apt-get install -s --no-install-recommends paraview "${qt[@]}" 2>/dev/null |
    sed -n 's/^Inst \([^ ]*\) .*/\1/p' | grep -v python)
  rm -rf "$folder/usr" "$folder/deb" "$folder/bin"
  mkdir -p "$folder/deb" "$folder/bin"
  (cd "$folder/deb" && apt-get -o APT::Sandbox::User=root download -q "${packages[@]}" "${missing[@]}" >download.log 2>&1) ||
    { tail -n 3 "$folder/deb/download.log" >&2; fail "apt-get could not download ParaView (apt-get update may help)"; }
  for package in "$folder"/deb/*.deb; do dpkg-deb -x "$package" "$folder"; done
  rm -rf "$folder/deb" "$folder/etc" "$folder/usr/share/doc"

  # Qt's CMake files look beside themselves for what is installed, not unpacked.
  find "$libraries" -maxdepth 1 -xtype l -printf '%l\n' | while read -r target; do
    [[ ! -e /usr/lib/$triplet/$target ]] || ln -sf "/usr/lib/$triplet/$target" "$libraries/$target"
  done
  for plugins in /usr/lib/"$triplet"/qt[56]/plugins/*; do
    [[ ! -e $plugins ]] || { mkdir -p "$libraries${plugins#"/usr/lib/$triplet"}" && cp -sn "$plugins"/* "$libraries${plugins#"/usr/lib/$triplet"}"; }
  done
  # Debian 13 names Python modules X.cpython-*.so, its CMake files still say X.so; the plugin needs none of them.
  find "$libraries/cmake" -name '*Python*-targets-*.cmake' -exec sed -i '/_cmake_import_check_\|_IMPORT_CHECK_/d' {} +

  for program in paraview pvpython pvbatch pvserver; do
    cat >"$folder/bin/$program" <<PROGRAM
#!/bin/sh
LD_LIBRARY_PATH=$libraries\${LD_LIBRARY_PATH:+:\$LD_LIBRARY_PATH}
PYTHONPATH=$folder/usr/lib/python3/dist-packages\${PYTHONPATH:+:\$PYTHONPATH}
QT_PLUGIN_PATH=$(printf '%s:' "$libraries"/qt[56]/plugins)\$QT_PLUGIN_PATH
export LD_LIBRARY_PATH PYTHONPATH QT_PLUGIN_PATH
exec $folder/usr/bin/$program "\$@"
PROGRAM
    chmod +x "$folder/bin/$program"
  done
fi
echo "$libraries"/cmake/paraview-*
