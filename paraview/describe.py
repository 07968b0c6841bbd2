#!/usr/bin/env python3
"""Writes the server-manager XML of the ParaView plugin, paraview/plugin/*.xml, from what the C++ classes say: defaults
and bounds from their getters, texts from their headers, lobes from the records of their parameters.

usage: describe.py BRDF [--check]      with the package brdflab on PYTHONPATH

  BRDF     the program, e.g. build/release/bin/brdf
  --check  write nothing; fail when a file is not what would be written

What ParaView offers, and how settings are entered, is in paraview/describe/proxies.py.
"""

import json
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
# The user's own lobes and plugins are no part of ours.
os.environ |= {"BRDFLAB_MODEL_PATH": "", "BRDFLAB_PLUGIN_PATH": "", "XDG_DATA_HOME": os.path.join(HERE, "none")}
sys.path.insert(0, HERE)

import brdflab  # noqa: E402

# The folder of this name, not this file.
sys.modules.pop("describe", None)
from describe.pages import files  # noqa: E402


def main(arguments):
    if not 1 <= len(arguments) <= 2 or (len(arguments) == 2 and arguments[1] != "--check"):
        sys.exit(__doc__)
    models = json.loads(subprocess.run([arguments[0], "models", "--json", "-"], check=True, capture_output=True).stdout)
    stale = []
    for name, text in files(brdflab, models, brdflab.names).items():
        path = os.path.join(HERE, "plugin", name)
        present = open(path, encoding="utf-8").read() if os.path.exists(path) else None
        if present == text:
            continue
        stale.append(name)
        if len(arguments) == 1:
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
    if len(arguments) == 2 and stale:
        sys.exit(f"paraview/plugin: {', '.join(stale)} not as the classes say: run scripts/update-docs.sh")


main(sys.argv[1:])
