# Sourced by demo.sh and test.sh from the top of the checkout: installs missing packages, configures, builds.
# setup_build <target>... leaves the executables in build/release/bin.

setup_fail() {
  printf '%s: %s\n' "${0##*/}" "$*" >&2
  exit 1
}

# Installs what packages.txt names and is missing; what is installed already stays as it is.
setup_packages() {
  if ! command -v dpkg-query >/dev/null; then
    echo "Not a Debian system: taking the equivalents of packages.txt for installed."
    return
  fi
  local wanted installed missing=() package
  wanted=$(sed 's/#.*//' packages.txt)
  installed=" $(dpkg-query -W -f '${db:Status-Status} ${Package}\n' | sed -n 's/^installed //p' | tr '\n' ' ') "
  for package in $wanted; do
    [[ $installed == *" $package "* ]] || missing+=("$package")
  done
  ((${#missing[@]})) || return 0

  local as_root=()
  if ((EUID != 0)); then
    command -v sudo >/dev/null ||
      setup_fail "packages missing, and neither root nor sudo to install them: ${missing[*]}"
    as_root=(sudo)
  fi
  echo "Installing ${#missing[@]} missing packages: ${missing[*]}"
  local log
  log=$(mktemp)
  if ! "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -q >"$log" 2>&1 ||
    ! "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends --no-upgrade \
      --no-remove "${missing[@]}" >>"$log" 2>&1; then
    tail -n 15 "$log" >&2
    setup_fail "apt-get could not install the missing packages (whole log: $log)"
  fi
  rm -f "$log"
}

# Builds the given targets (none: everything) in build/release; prints the compiler's words only when it fails.
setup_build() {
  local folder=build/release log
  mkdir -p "$folder"
  log=$folder/setup.log
  if [[ ! -e $folder/build.ninja ]]; then
    echo "Configuring in $folder"
    cmake --preset release >"$log" 2>&1 || { cat "$log" >&2; setup_fail "cmake could not configure the build"; }
  fi
  if [[ $(ninja -C "$folder" -n "$@" | tail -n 1) == *"no work to do"* ]]; then return; fi
  echo "Building in $folder"
  if [[ -t 1 ]]; then
    ninja -C "$folder" "$@" || setup_fail "the build failed"
  else
    ninja -C "$folder" "$@" >"$log" 2>&1 || { grep -v '^\[' "$log" | tail -n 60 >&2; setup_fail "the build failed"; }
  fi
}
