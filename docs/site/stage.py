"""Puts the pages of the site, and the files that they show, into a folder for mdBook.

python docs/site/stage.py FOLDER

Pages stand where they stand in the repository, so that their links hold. `SUMMARY.md` has the
reader's way; decisions and measurements follow it, folded. A link to what the site does not have,
as to a source file, becomes its text.
"""

import os
import re
import shutil
import sys
from pathlib import Path

SITE = Path(__file__).resolve().parent
ROOT = SITE.parents[1]
LINK = re.compile(r"(!?)\[((?:[^\[\]]|\[[^\[\]]*\])*)\]\(([^()\s]+)\)")
# What a page may show or hand out.
FILES = {".svg", ".png", ".json", ".ipynb"}
# Stands where the repository's README stands, whose commands are for a clone.
README, START = ROOT / "README.md", SITE / "start.md"
FOLDED = {"Decisions": "docs/adr/README.md", "Measurements": "docs/notes/README.md"}


def title(page: Path) -> str:
    """The first heading of a page."""
    heading = re.search(r"^# (.*)", page.read_text("utf-8"), re.MULTILINE)
    assert heading, f"{page} has no heading"
    return heading[1]


def summary() -> str:
    """The contents, by paths from the root."""
    text = (SITE / "SUMMARY.md").read_text("utf-8")
    lines = [LINK.sub(lambda link: f"[{link[2]}]({from_root(SITE / link[3])})", text)]
    for name, first in FOLDED.items():
        lines.append(f"- [{name}]({first})")
        pages = sorted(path for path in (ROOT / first).parent.glob("*.md"))
        lines += [
            f"  - [{title(page)}]({from_root(page)})" for page in pages if page.name != "README.md"
        ]
    return "\n".join(lines) + "\n"


def from_root(path: Path) -> str:
    return Path(os.path.normpath(path)).relative_to(ROOT).as_posix()


class Stage:
    """The folder of mdBook."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.contents = summary()
        self.pages = {ROOT / link[3] for link in LINK.finditer(self.contents)}

    def write(self) -> None:
        shutil.rmtree(self.folder, ignore_errors=True)
        for page in self.pages:
            self.put(page, self.linked(START if page == README else page))
        self.put(ROOT / "SUMMARY.md", self.contents)
        for name in ("book.toml", "style.css"):
            shutil.copy(SITE / name, self.folder)
        # Without the fonts that mdBook brings: those of the system do.
        fonts = self.folder / "theme/fonts/fonts.css"
        fonts.parent.mkdir(parents=True)
        fonts.write_text("/* none */\n")

    def put(self, path: Path, text: str) -> None:
        to = self.folder / "source" / path.relative_to(ROOT)
        to.parent.mkdir(parents=True, exist_ok=True)
        to.write_text(text, "utf-8")

    def linked(self, page: Path) -> str:
        """The text of a page with the links that the site has; blocks of code are left alone."""
        parts = re.split(
            r"(^```.*?^```$)", page.read_text("utf-8"), flags=re.MULTILINE | re.DOTALL
        )
        parts[::2] = [LINK.sub(lambda link: self.link(page, link), part) for part in parts[::2]]
        text = "".join(parts)
        for source in re.findall(r'<img src="([^"]+)"', text):
            self.copy(page.parent / source)
        return text

    def link(self, page: Path, link: re.Match[str]) -> str:
        kind, words, target = link.groups()
        if "://" in target or target.startswith("#"):
            return link[0]
        name, _, anchor = target.partition("#")
        path = Path(os.path.normpath(page.parent / name))
        if page == START:
            name = from_root(path)
        if path.is_dir():
            path, name = path / "README.md", f"{name.rstrip('/')}/README.md"
        if path in self.pages:
            # mdBook makes an index of a README.
            name = re.sub(r"README\.md$", "index.html", name)
            return f"{kind}[{words}]({name}{'#' if anchor else ''}{anchor})"
        if path.suffix in FILES:
            self.copy(path)
            return f"{kind}[{words}]({name})"
        return words

    def copy(self, path: Path) -> None:
        path = Path(os.path.normpath(path))
        to = self.folder / "source" / path.relative_to(ROOT)
        to.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(path, to)


if __name__ == "__main__":
    Stage(Path(sys.argv[1])).write()
