"""Runs the Python blocks of a document, one after the other, as one who follows it.

python clients/python/scripts/run_readme.py DOCUMENT
"""

import re
import sys
from pathlib import Path


def main() -> None:
    text = Path(sys.argv[1]).read_text("utf-8")
    blocks = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
    assert len(blocks) > 3
    names: dict[str, object] = {}
    for block in blocks:
        exec(compile(block, sys.argv[1], "exec"), names)
    print(f"{len(blocks)} blocks of {sys.argv[1]} have run")


# Processes of an executor import this file.
if __name__ == "__main__":
    main()
