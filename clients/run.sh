#!/usr/bin/env bash
# Generates a client of the service by every generator that is worth supporting, checks its types strictly and uses it
# against the running service: validate, solve, submit and wait and fetch the result, list, cancel, a bad job, events,
# CSV and VTU.
#
#     clients/run.sh [BRINELL]
#
# BRINELL is the program (default target/debug/brinell). Needs Python with venv, and Node with what `npm --prefix
# clients ci` installs; the Python generators are installed under target/.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
brinell=$(realpath "${1:-target/debug/brinell}")

venv=$PWD/target/clients
[ -x "$venv/bin/python" ] || python3 -m venv "$venv"
"$venv/bin/pip" install --quiet --disable-pip-version-check -r clients/requirements.txt

cd clients
rm -rf generated
mkdir generated

# Runs a generator, whose warnings are failures.
generate() {
    local log
    log=$("$@" 2>&1) || { printf '%s\n' "$log"; return 1; }
    if grep -iE '\bwarn(ing)?s?\b' <<<"$log"; then
        printf '%s\n' "$log"
        return 1
    fi
}

generate "$venv/bin/openapi-python-client" generate --path ../api/openapi.json --output-path generated/brinell_client \
    --config generated_python/config.yaml --meta none --overwrite --fail-on-warning
generate "$venv/bin/datamodel-codegen" --input ../api/openapi.json --input-file-type openapi \
    --output generated/brinell_models.py --output-model-type pydantic_v2.BaseModel --target-python-version 3.11 \
    --use-annotated --use-standard-collections --disable-timestamp --formatters builtin --capitalise-enum-members
generate node_modules/.bin/openapi-typescript ../api/openapi.json --output generated/openapi-typescript.ts
generate node_modules/.bin/openapi-ts --input ../api/openapi.json --output generated/hey-api --client @hey-api/client-fetch
generate node_modules/.bin/orval --config orval.config.cjs

export MYPYPATH=$PWD/generated:$PWD/generated_python
"$venv/bin/mypy" --strict --no-error-summary generated_python/openapi_python_client.py generated_python/pydantic_models.py
npm run --silent check

data=$(mktemp -d)
BRINELL_API_KEY=$("$brinell" key create clients --scope admin --data-dir "$data" | tail -n 1)
export BRINELL_API_KEY
coproc server { exec "$brinell" serve --listen 127.0.0.1:0 --data-dir "$data" --log warn; }
trap 'kill "$server_PID" 2>/dev/null || true; wait "$server_PID" 2>/dev/null || true; rm -rf "$data"' EXIT
read -r line <&"${server[0]}"
url=${line##* }

export PYTHONPATH=$MYPYPATH
"$venv/bin/python" generated_python/openapi_python_client.py "$url"
"$venv/bin/python" generated_python/pydantic_models.py "$url"
# Types are checked above; here they are only taken out.
for client in openapi-fetch hey-api orval; do
    node_modules/.bin/esbuild "typescript/$client.ts" --bundle --platform=node --format=esm --log-level=warning \
        --outfile="generated/$client.mjs"
    BRINELL_URL=$url node "generated/$client.mjs" "$url"
done
