#!/usr/bin/env bash
# Runs a command with an X server of its own, for programs that draw in windows only (ParaView from Debian). The server
# picks a free display number by itself, so that any number of these may run at once; `xvfb-run -a` looks first and can
# be overtaken.
#
# usage: with-display.sh COMMAND [ARGUMENT...]
set -euo pipefail
(($#)) || { sed -n '2,6s/^# \?//p' "$0" >&2; exit 2; }
command -v Xvfb >/dev/null || { echo "${0##*/}: no Xvfb (Debian package xvfb)" >&2; exit 1; }

exec {number}< <(exec Xvfb -displayfd 1 -screen 0 1280x1024x24 -nolisten tcp -noreset 2>/dev/null)
server=$!
trap 'kill "$server" 2>/dev/null || true' EXIT
read -r -t 30 -u "$number" display || { echo "${0##*/}: Xvfb did not start" >&2; exit 1; }
DISPLAY=:$display "$@"
