#!/usr/bin/env bash
# Sends generated requests, good and bad, to a running service and holds every answer to its OpenAPI document: no
# 5xx, no status, header, content type or body that the document does not have.
#
#     scripts/schemathesis.sh [BRINELL [EXAMPLES]]
#
# BRINELL is the program (default target/debug/brinell), EXAMPLES how many requests each operation gets in each
# fuzzing phase (default 50). Needs Python with venv; schemathesis itself is installed under target/. With LIGHT=1 good bodies
# of jobs are the examples: to generate one from the whole schema takes seconds.
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

document=$url/openapi.json
if [ -n "${LIGHT:-}" ]; then
    document=$data/light.json
    python3 - "$url" > "$document" <<'END'
import json, pathlib, sys, urllib.request

document = json.load(urllib.request.urlopen(sys.argv[1] + "/openapi.json"))
schemas = document["components"]["schemas"]
files = sorted(pathlib.Path("api/examples").glob("*.json"))
schemas["ExampleJob"] = {"enum": [json.loads(file.read_text()) for file in files]}
light = lambda part: json.loads(json.dumps(part).replace('schemas/Job"', 'schemas/ExampleJob"'))
schemas["BatchedJob"] = light(schemas["BatchedJob"])
for operations in document["paths"].values():
    for operation in operations.values():
        if "requestBody" in operation:
            operation["requestBody"] = light(operation["requestBody"])
json.dump(document, sys.stdout)
END
fi
"$venv/bin/schemathesis" --config-file scripts/schemathesis.toml run "$document" --url "$url" --phases examples,coverage,fuzzing,stateful \
    --max-examples "$examples" --seed "$seed" --continue-on-failure --request-timeout 30 --warnings off
curl --fail --silent --show-error "$url/readyz"
