#!/usr/bin/env bash
# Makes the site of the documents, and looks for links that lead nowhere.
#
#     scripts/site.sh [FOLDER]
#
# FOLDER, by default target/site/guide, is what `brinell serve --guide FOLDER` serves at /guide/. Needs Python with venv.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
stage=$PWD/target/site
bin=$PWD/target/site-tools/bin
[ -x "$bin/python" ] || python3 -m venv target/site-tools
"$bin/pip" install --quiet --disable-pip-version-check -r docs/site/requirements.txt -e clients/python/brinell

"$bin/python" docs/site/stage.py "$stage"
"$bin/mdbook" build "$stage"
guide=$stage/guide
# Types of packages that are not installed here stay as they are written.
"$bin/python" -W ignore -m pdoc brinell '!brinell.models' '!brinell.reports' --no-show-source --docformat google --output-directory "$guide/python"
# Names of addresses elsewhere are not asked for.
"$bin/lychee" --offline --no-progress --include-fragments --root-dir "$guide" "$guide/**/*.html"
printf '%d files, %d KiB, %d KiB compressed\n' "$(find "$guide" -type f | wc -l)" "$(du -sk "$guide" | cut -f1)" \
    "$(tar -cz -C "$guide" . | wc -c | awk '{print int($1 / 1024)}')"
if [ -n "${1:-}" ]; then mkdir -p "$1" && cp -r "$guide/." "$1"; fi
