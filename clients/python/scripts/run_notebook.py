"""Runs a notebook and keeps its figures.

python clients/python/scripts/run_notebook.py NOTEBOOK FOLDER
"""

import base64
import os
import sys
from pathlib import Path

import nbformat
from nbclient import NotebookClient


def main() -> None:
    # The kernel's own, which puts figures into the notebook.
    os.environ.pop("MPLBACKEND", None)
    notebook, folder = Path(sys.argv[1]), Path(sys.argv[2])
    document = nbformat.read(notebook, as_version=4)
    NotebookClient(document, timeout=300, resources={"metadata": {"path": folder}}).execute()
    outputs = [output for cell in document.cells for output in cell.get("outputs", [])]
    figures = [
        output.data["image/png"] for output in outputs if "image/png" in output.get("data", {})
    ]
    for number, figure in enumerate(figures, start=1):
        (folder / f"{notebook.stem}-{number}.png").write_bytes(base64.b64decode(figure))


if __name__ == "__main__":
    main()
