#!/usr/bin/env bash
# Generates a Python client from api/openapi.json and solves a job with it: the document is precise enough to program
# against.
#
#     scripts/python_client/run.sh [BRINELL]
#
# BRINELL is the program (default target/debug/brinell). Needs Python with venv; the generator is installed under
# target/.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
brinell=${1:-target/debug/brinell}

venv=target/python-client
[ -x "$venv/bin/python" ] || python3 -m venv "$venv"
"$venv/bin/pip" install --quiet --disable-pip-version-check -r scripts/python_client/requirements.txt
"$venv/bin/openapi-python-client" generate --path api/openapi.json --output-path "$venv/generated/brinell_client" \
    --config scripts/python_client/config.yaml --meta none --overwrite --fail-on-warning

data=$(mktemp -d)
coproc server { exec "$brinell" serve --listen 127.0.0.1:0 --data-dir "$data" --log warn; }
trap 'kill "$server_PID" 2>/dev/null || true; wait "$server_PID" 2>/dev/null || true; rm -rf "$data"' EXIT
read -r line <&"${server[0]}"
PYTHONPATH="$venv/generated" "$venv/bin/python" scripts/python_client/solve.py "${line##* }"
