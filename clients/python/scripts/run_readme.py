"""Runs the Python blocks of a document, one after the other, as one who follows it.

python clients/python/scripts/run_readme.py DOCUMENT

A block without a language right below a Python block is what that prints: words are compared,
figures to three digits. With BRINELL_WRITE=1 it is written anew.
"""

import contextlib
import io
import os
import re
import sys
from itertools import zip_longest
from pathlib import Path

BLOCK = re.compile(r"^```python\n(.*?)^```\n(?:\n```\n(.*?)^```\n)?", re.DOTALL | re.MULTILINE)
# Half a unit of the third digit.
CLOSE = 5e-3


def main() -> None:
    os.environ.setdefault("MPLBACKEND", "agg")
    document = Path(sys.argv[1])
    text = document.read_text("utf-8")
    blocks = list(BLOCK.finditer(text))
    assert blocks
    names: dict[str, object] = {}
    for block in blocks:
        code, shown = block.groups()
        with contextlib.redirect_stdout(io.StringIO()) as output:
            exec(compile(code, document, "exec"), names)
        printed = output.getvalue()
        if shown is None:
            print(printed, end="")
        elif os.environ.get("BRINELL_WRITE"):
            text = text.replace(
                block[0], block[0].replace(f"```\n{shown}```", f"```\n{printed}```")
            )
        elif different := differences(shown, printed):
            sys.exit(f"{document} shows other words than it prints, {different[:3]}:\n{printed}")
    if os.environ.get("BRINELL_WRITE"):
        document.write_text(text, "utf-8")
    print(f"{len(blocks)} blocks of {document} have run")


def differences(shown: str, printed: str) -> list[tuple[str | None, str | None]]:
    """The words that differ, figures beyond three digits."""
    pairs = zip_longest(re.split(r"[\s:,]+", shown.strip()), re.split(r"[\s:,]+", printed.strip()))
    return [(old, new) for old, new in pairs if old != new and not alike(old, new)]


def alike(old: str | None, new: str | None) -> bool:
    try:
        a, b = (float((word or "").rstrip("%.;")) for word in (old, new))
    except ValueError:
        return False
    return abs(a - b) <= CLOSE * max(abs(a), abs(b))


# Processes of an executor import this file.
if __name__ == "__main__":
    main()
