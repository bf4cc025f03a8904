#!/usr/bin/env bash
# Builds the image and holds the container to what docs/operations.md promises: hardened, solving, healthy, stopping.
#
# usage: tests/container.sh [docker|podman]
# Without an engine it ends with 1 and says so. Nothing else is needed but curl.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

engine=${1:-}
for candidate in docker podman; do
    [ -n "$engine" ] || { command -v "$candidate" >/dev/null && engine=$candidate; }
done
[ -n "$engine" ] || { echo "this test needs docker or podman: install one" >&2; exit 1; }

image=brinell:test
port=${BRINELL_TEST_PORT:-18080}
url=http://127.0.0.1:$port

fail() { echo "FAILED: $*" >&2; exit 1; }
now() { date +%s%3N; }

"$engine" build -t "$image" .
size=$("$engine" image inspect --format '{{.Size}}' "$image")
base=$("$engine" image inspect --format '{{.Size}}' debian:bookworm-slim)
echo "size: $(((size - base) / 1000000)) MB without the base"
[ $((size - base)) -lt 60000000 ] || fail "the image is too large"
user=$("$engine" image inspect --format '{{.Config.User}}' "$image")
[ "$user" = 10001:10001 ] || fail "runs as $user"

begin=$(now)
id=$("$engine" run -d --read-only --cap-drop ALL --security-opt no-new-privileges -p "127.0.0.1:$port:8080" \
    -e BRINELL_ALLOW_ANONYMOUS=true "$image")
trap '"$engine" rm -f -v "$id" >/dev/null' EXIT
until curl -sf "$url/readyz" >/dev/null; do
    [ $(($(now) - begin)) -lt 10000 ] || fail "not ready after ten seconds"
done
echo "ready after $(($(now) - begin)) ms"

answer=$(curl -sf "$url/v1/solve" -H 'Content-Type: application/json' -d @api/examples/two_cylinders.json)
[[ $answer == *'"status":"converged"'* ]] || fail "the job was not solved: $answer"
curl -sf "$url/guide/docs/tutorial.html" >/dev/null || fail "there is no guide"
"$engine" exec "$id" brinell healthcheck || fail "not healthy"
if "$engine" exec "$id" touch /usr/local/bin/x 2>/dev/null; then fail "the root is writable"; fi

"$engine" stop -t 30 "$id" >/dev/null
code=$("$engine" inspect --format '{{.State.ExitCode}}' "$id")
[ "$code" = 0 ] || fail "SIGTERM ends with $code"
echo "SIGTERM ends with 0"
