#!/usr/bin/env bash
# Builds wheels and sdists of both packages, installs them into an empty environment and runs the blocks of the README there.
# The server is built from its sdist, as one does who has no wheel.
#
#     clients/python/scripts/packages.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
python=$PWD/target/python/bin/python
dist=$PWD/target/python-dist
rm -rf "$dist"

"$python" -m build --outdir "$dist" clients/python/brinell
(cd clients/python/server && "$python" -m maturin sdist --out "$dist")
CARGO_TARGET_DIR=$PWD/target/python-server "$python" -m pip wheel --quiet --disable-pip-version-check --no-deps \
    --wheel-dir "$dist" "$dist"/brinell_server-*.tar.gz
ls -l "$dist"

empty=$(mktemp -d)
trap 'rm -rf "$empty"' EXIT
python3 -m venv "$empty/env"
"$empty/env/bin/pip" install --quiet --disable-pip-version-check --find-links "$dist" "brinell[all]"
# Neither this repository nor another program named brinell is in sight.
(cd "$empty" && env -u BRINELL_PROGRAM -u BRINELL_URL PATH=/usr/bin:/bin MPLBACKEND=agg \
    "$empty/env/bin/python" "$OLDPWD/clients/python/scripts/run_readme.py" "$OLDPWD/clients/python/brinell/README.md")
"$empty/env/bin/python" -m brinell_server --version
"$empty/env/bin/brinell" --version
