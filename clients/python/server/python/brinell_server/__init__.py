"""Where the `brinell` program of this package is."""

from __future__ import annotations

import os
import shutil
import sys
import sysconfig
from collections.abc import Iterator

__all__ = ["find_brinell"]


def find_brinell() -> str | None:
    """The program: where pip puts scripts, or the first on PATH; `None` if there is none."""
    name = "brinell" + (sysconfig.get_config_var("EXE") or "")
    for folder in _folders():
        path = os.path.join(folder, name)
        if os.path.isfile(path):
            return path
    return shutil.which("brinell")


def _folders() -> Iterator[str]:
    """Of this interpreter, of its base, of the user, and beside `pip install --target`."""
    yield sysconfig.get_path("scripts")
    # Of a virtual environment whose packages another interpreter was pointed at.
    yield sysconfig.get_path("scripts", vars={"base": sys.base_prefix})
    yield sysconfig.get_path("scripts", scheme=sysconfig.get_preferred_scheme("user"))
    packages = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    yield os.path.join(packages, "bin")
