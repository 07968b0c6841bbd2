"""Runs the Python snippets of the documentation: those of a page one after the other, in one namespace."""

import os
import re
import sys
import tempfile

os.environ.pop("DISPLAY", None)

for page in sys.argv[1:]:
    with open(page) as file:
        snippets = re.findall(r"^```python\n(.*?)^```", file.read(), re.MULTILINE | re.DOTALL)
    assert snippets, f"{page} has no Python"
    namespace = {}
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for number, snippet in enumerate(snippets, 1):
            exec(compile(snippet, f"{page}, snippet {number}", "exec"), namespace)
        os.chdir("/")
    print(f"{page}: {len(snippets)} snippets")
