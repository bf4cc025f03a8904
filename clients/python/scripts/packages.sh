#!/usr/bin/env bash
# Builds wheels and sdists of both packages, installs the wheels into an empty environment and runs the blocks of the
# README there. The server's wheel is built from its sdist, so that the sdist is known to be whole, and tagged for the glibc
# of this machine.
#
#     clients/python/scripts/packages.sh [PROFILE]
#
# PROFILE is that of the server's program: `release`, unless it is only a check. Needs Rust, and Python with venv.
set -euo pipefail
profile=${1:-release}
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
dist=$PWD/target/python-dist
rm -rf "$dist"

# The tools that build, in an environment of their own.
[ -x target/packages/bin/python ] || python3 -m venv target/packages
python=$PWD/target/packages/bin/python
mapfile -t tools < <(grep -E '^(build|maturin)==' clients/python/requirements.txt)
"$python" -m pip install --quiet --disable-pip-version-check "${tools[@]}"

"$python" -m build --outdir "$dist" clients/python/brinell
(cd clients/python/server && CARGO_TARGET_DIR=$OLDPWD/target/python-server \
    "$python" -m maturin build --sdist --profile "$profile" --out "$dist")
ls -l "$dist"

empty=$(mktemp -d)
trap 'rm -rf "$empty"' EXIT
python3 -m venv "$empty/env"
# The two packages come from here alone, whatever a registry has under their names.
wheel=$(echo "$dist"/brinell-*.whl)
"$empty/env/bin/pip" install --quiet --disable-pip-version-check "$dist"/brinell_server-*.whl "${wheel}[all,surfaces]"
# Neither this repository nor another program named brinell is in sight.
root=$PWD
cd "$empty"
export PATH=/usr/bin:/bin MPLBACKEND=agg
unset BRINELL_PROGRAM BRINELL_URL
env/bin/python "$root/clients/python/scripts/run_readme.py" "$root/clients/python/brinell/README.md"
env/bin/python -m brinell_server --version
env/bin/brinell --version
