#!/usr/bin/env python3
"""Draws the pictures of docs/gallery.md and docs/course.md, and writes the pages with the command of each picture.

usage: draw_pages.py BRDF [--only WORD] | --check

  BRDF     the program, e.g. build/release/bin/brdf
  --only   draw the pictures whose file name holds WORD
  --check  draw nothing; fail when a page does not say what scripts/pages say, or a picture is missing

What is on the pages is in scripts/pages: a title, an introduction, the materials that the commands read (MATERIALS,
command lines that are run first) and SECTIONS of (title, text, [(picture, caption, command without --out)]).
"""

import importlib
import os
import shlex
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
DOCS = os.path.join(ROOT, "docs")
PAGES = ("gallery", "course")


def picture_path(page, name):
    return os.path.join(DOCS, "images", page, name + ".png")


def text_of(page, content):
    lines = [f"# {content.TITLE}", "", content.INTRODUCTION]
    if content.MATERIALS:
        lines += ["", "```sh", *(f"brdf {words}" for words in content.MATERIALS), "```"]
    for title, about, pictures in content.SECTIONS:
        lines += ["", f"## {title}", "", about]
        for name, caption, words in pictures:
            if caption:
                lines += ["", caption]
            lines += ["", f"![{caption or title}](images/{page}/{name}.png)", ""]
            lines += ["```sh", f"brdf {words} --out {name}.png", "```"]
    return "\n".join(lines) + "\n"


def check(page, content):
    with open(os.path.join(DOCS, page + ".md")) as file:
        if file.read() != text_of(page, content):
            sys.exit(f"docs/{page}.md is stale: run scripts/draw_pages.py")
    names = [name for _, _, pictures in content.SECTIONS for name, _, _ in pictures]
    missing = [name for name in names if not os.path.exists(picture_path(page, name))]
    if missing:
        sys.exit(f"pictures of docs/{page}.md are missing: " + ", ".join(missing))
    extra = set(os.listdir(os.path.join(DOCS, "images", page))) - {name + ".png" for name in names}
    if extra:
        sys.exit(f"pictures that docs/{page}.md does not show: " + ", ".join(sorted(extra)))


def draw(page, content, program, only):
    wanted = [(name, words) for _, _, pictures in content.SECTIONS for name, _, words in pictures if only in name]
    if wanted:
        os.makedirs(os.path.dirname(picture_path(page, "x")), exist_ok=True)
        with tempfile.TemporaryDirectory() as folder:
            for name in ("datasets", "docs"):
                os.symlink(os.path.join(ROOT, name), os.path.join(folder, name))
            for words in [*content.MATERIALS, *(f"{words} --out {picture_path(page, name)}" for name, words in wanted)]:
                print("brdf", words, flush=True)
                subprocess.run([program, *shlex.split(words), "--quiet"], cwd=folder, check=True)
    with open(os.path.join(DOCS, page + ".md"), "w") as file:
        file.write(text_of(page, content))


def main(arguments):
    if not arguments or "--help" in arguments:
        sys.exit(__doc__)
    only = arguments[arguments.index("--only") + 1] if "--only" in arguments else ""
    for page in PAGES:
        content = importlib.import_module("pages." + page)
        if "--check" in arguments:
            check(page, content)
        else:
            draw(page, content, os.path.abspath(arguments[0]), only)


if __name__ == "__main__":
    main(sys.argv[1:])
