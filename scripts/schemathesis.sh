#!/usr/bin/env bash
# Sends generated requests, good and bad, to a running service and holds every answer to its OpenAPI document: no
# 5xx, no status, header, content type or body that the document does not have.
#
#     scripts/schemathesis.sh [BRINELL [EXAMPLES]]
#
# BRINELL is the program (default target/debug/brinell), EXAMPLES how many requests each operation gets in each
# fuzzing phase (default 50). Needs Python with venv; schemathesis itself is installed under target/.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
brinell=${1:-target/debug/brinell}
examples=${2:-50}
# A fresh seed each run; name one to repeat a run.
seed=${SEED:-$RANDOM$RANDOM}
echo "schemathesis seed $seed (SEED=$seed repeats this run)"

venv=target/schemathesis
[ -x "$venv/bin/schemathesis" ] || python3 -m venv "$venv"
"$venv/bin/pip" install --quiet --disable-pip-version-check 'schemathesis==4.32.5'

data=$(mktemp -d)
# Jobs are kept small: this is about answers, not about solving.
coproc server { exec "$brinell" serve --listen 127.0.0.1:0 --data-dir "$data" --job-timeout 2 --solve-limit 5 \
    --max-job-memory 64 --log warn; }
trap 'kill "$server_PID" 2>/dev/null || true; wait "$server_PID" 2>/dev/null || true; rm -rf "$data"' EXIT
read -r line <&"${server[0]}"
url=${line##* }

"$venv/bin/schemathesis" --config-file scripts/schemathesis.toml run "$url/openapi.json" --phases examples,coverage,fuzzing,stateful \
    --max-examples "$examples" --seed "$seed" --continue-on-failure --request-timeout 30 --warnings off
curl --fail --silent --show-error "$url/readyz"
