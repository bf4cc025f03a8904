# Shared by .ci/run and .ci/full: named steps with their times, and the programs that the checks need.

cd "$(dirname "${BASH_SOURCE[0]}")/.."
export CARGO_TERM_COLOR=never
mkdir -p target/ci
times=target/ci/$(basename "$0").tsv
: >"$times"

# Prints its name, its output and its time; the first failure ends the run.
step() {
    local begin=$SECONDS
    printf '\n==> %s\n' "$*"
    "$@"
    printf '%d\t%s\n' $((SECONDS - begin)) "$*" >>"$times"
    printf '<== %s: %d s\n' "$*" $((SECONDS - begin))
}

# Prints the time of each step.
summary() {
    printf '\n'
    awk -F'\t' '{ printf "%5d s  %s\n", $1, $2 }' "$times"
    printf 'All passed in %d s.\n' "$SECONDS"
}

# Installs the Debian packages among `program=package ...` whose program is missing.
need() {
    local missing=() pair as_root=()
    for pair in "$@"; do
        command -v "${pair%%=*}" >/dev/null || missing+=(${pair#*=})
    done
    [ ${#missing[@]} -gt 0 ] || return 0
    [ "$(id -u)" -eq 0 ] || as_root=(sudo)
    step "${as_root[@]}" apt-get update -qq
    step "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get install -y -qq --no-install-recommends ca-certificates "${missing[@]}"
}

# A Python environment of its own, with what these requirement files name.
python_with() {
    [ -x target/venv/bin/python ] || python3 -m venv target/venv
    local file
    for file in "$@"; do
        target/venv/bin/pip install --quiet --disable-pip-version-check -r "$file"
    done
}

# PostgreSQL's server programs stand beside the path on Debian.
initdb_is_there() {
    command -v initdb >/dev/null || ls /usr/lib/postgresql/*/bin/initdb >/dev/null 2>&1
}

install_tools() {
    need cc="gcc libc6-dev" curl=curl npm="nodejs npm" chromium=chromium
    initdb_is_there || need initdb=postgresql
}

check_format() {
    step cargo fmt --check
    step cargo fmt --check --manifest-path fuzz/Cargo.toml
}

install_page_tools() {
    step npm --prefix tests/page ci --no-audit --no-fund
    step npm --prefix tests/page run check
}
