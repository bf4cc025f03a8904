"""Runs an example and keeps its figures.

python clients/python/scripts/run_example.py EXAMPLE FOLDER
"""

import os
import runpy
import sys
from pathlib import Path

os.environ.setdefault("MPLBACKEND", "agg")

import matplotlib.pyplot as plt

DPI = 70


def main() -> None:
    example, folder = Path(sys.argv[1]), Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    runpy.run_path(str(example), run_name="__main__")
    for number in plt.get_fignums():
        plt.figure(number).savefig(folder / f"{example.stem}-{number}.png", dpi=DPI)


if __name__ == "__main__":
    main()
