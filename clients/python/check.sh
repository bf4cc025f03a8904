#!/usr/bin/env bash
# Checks the Python packages.
#
#     clients/python/check.sh fast BRINELL    style, types, generated files, tests against the program BRINELL
#     clients/python/check.sh full BRINELL    the same with every Python there is, and the notebooks
#
# Needs a Python with venv; packages are installed under target/.
set -euo pipefail
what=$1
brinell=$(realpath "$2")
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
here=$PWD/clients/python

# An environment with the package and what its tests need.
environment() {
    local folder=$1 python=$2
    [ -x "$folder/bin/python" ] || "$python" -m venv "$folder"
    "$folder/bin/pip" install --quiet --disable-pip-version-check -r "${3:-$here/requirements.txt}" -e "$here/brinell"
}

fast() {
    local bin=$PWD/target/python/bin
    environment "$PWD/target/python" python3
    (cd "$here/brinell" && "$bin/ruff" check --quiet .. && "$bin/ruff" format --quiet --check .. && "$bin/mypy" --no-error-summary)
    BRINELL_PROGRAM=$brinell "$bin/python" -m pytest "$here/tests" -m "not full"
}

full() {
    fast
    BRINELL_PROGRAM=$brinell "$PWD/target/python/bin/python" -m pytest "$here/tests" -m full
    "$here/scripts/versions.sh" "$brinell"
}

"$what"
