"""`python -m brinell_server`: runs the program."""

from __future__ import annotations

import os
import subprocess
import sys

from . import find_brinell


def main() -> int:
    """Runs the program in place of this process, or beside it where that is impossible."""
    program = find_brinell()
    if program is None:
        print("there is no brinell program where pip puts scripts, nor on PATH", file=sys.stderr)
        return 1
    if sys.platform != "win32":
        os.execv(program, [program, *sys.argv[1:]])
    return subprocess.run([program, *sys.argv[1:]], check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
