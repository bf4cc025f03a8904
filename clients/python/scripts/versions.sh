#!/usr/bin/env bash
# Runs the fast tests with every other Python from 3.10 on that this machine has.
#
#     clients/python/scripts/versions.sh BRINELL
set -euo pipefail
brinell=$(realpath "$1")
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
used=$(python3 -c 'import sys; print("%d.%d" % sys.version_info[:2])')

for version in 3.10 3.11 3.12 3.13 3.14; do
    [ "$version" != "$used" ] || continue
    python=$(ls "$HOME"/.pyenv/versions/"$version".*/bin/python 2>/dev/null | tail -1 || true)
    [ -n "$python" ] || python=$(command -v "python$version" || true)
    if ! "$python" -c 'import venv, ensurepip' 2>/dev/null; then
        echo "no Python $version here"
        continue
    fi
    folder=$PWD/target/python-$version
    [ -x "$folder/bin/python" ] || "$python" -m venv "$folder"
    # The versions that this Python has of what the tests need.
    "$folder/bin/pip" install --quiet --disable-pip-version-check -e clients/python/brinell \
        distributed fsspec loky matplotlib pandas pint pytest scipy tqdm xarray
    echo "Python $version"
    BRINELL_PROGRAM=$brinell "$folder/bin/python" -m pytest clients/python/tests -m "not full and not generated"
done
