"""Runs what the pages of the documentation show.

    run_pages.py SOURCE_FOLDER BRDF PAGE...

Blocks of a page marked `sh` and `python` run in their order, in a folder of the page's own, Python in one namespace. The
folder has links to `datasets`, `docs` and `examples`, and those of FILES that the page speaks of, which stand for a
reader's own. Python that waits for an interactive window is compiled only. A block marked `cpp` has to be part of a file
that is built: in examples/ or docs/examples/. What only shows something (`console`, no mark) is left alone."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

os.environ.pop("DISPLAY", None)
source, program = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
os.environ["PATH"] = f"{program.parent}:{os.environ['PATH']}"
compiled = [path.read_text() for folder in ("examples", "docs/examples") for path in (source / folder).rglob("*")
            if path.suffix in (".cpp", ".cxx", ".h")]

FILES = {
    "gold.binary": 'brdf convert preset:bagher-sgd-gold-metallic-paint gold.binary --quiet',
    "garnet_red.brdf": 'brdf convert "(0.2,0.02,0.03)*Lambertian + 0.04*GGX(alpha=0.2)" garnet_red.brdf '
                       '--grid spherical:15 --format brdflab-text --quiet',
    "fit.vtkhdf": 'brdf convert "(0.2,0.02,0.03)*Lambertian + 0.05*GGX(alpha=0.2)" fit.vtkhdf --quiet',
    "lamp.csv": 'printf "380,1\\n780,3\\n" > lamp.csv',
    "lambert_phong.py": "sed -n '/^```py$/,/^```$/{//!p}' docs/external-programs.md > lambert_phong.py",
    "mine.xml": 'cp docs/examples/lobes/SatinPaint.xml mine.xml',
}


def run_page(page):
    written = page.read_text()
    blocks = re.findall(r"^```(sh|python|cpp)\n(.*?)^```", written, re.MULTILINE | re.DOTALL)
    if not blocks:
        sys.exit(f"{page}: shows nothing that can be run")
    for name, command in FILES.items():
        if name in written:
            subprocess.run(["bash", "-euc", command], check=True)
    namespace = {}
    for number, (language, text) in enumerate(blocks, 1):
        where = f"{page.name}, block {number} ({language})"
        if language == "cpp":
            if not any(text.strip() in file for file in compiled):
                sys.exit(f"{where}: is no part of a file in examples/ or docs/examples/")
        elif language == "python":
            code = compile(text, where, "exec")
            if "interactor.Start()" not in text:
                exec(code, namespace)
        else:
            done = subprocess.run(["bash", "-euo", "pipefail", "-c", text], capture_output=True, text=True)
            if done.returncode:
                sys.exit(f"{where}: exit code {done.returncode}\n{text}{done.stdout[-2000:]}{done.stderr[-2000:]}")
    print(f"{page.name}: {len(blocks)} blocks")


for name in sys.argv[3:]:
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for link in ("datasets", "docs", "examples"):
            os.symlink(source / link, link)
        run_page(source / name)
        os.chdir("/")
