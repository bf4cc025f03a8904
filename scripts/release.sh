#!/usr/bin/env bash
# Makes a release of the files that git knows, and uses it as one who has nothing else.
#
#     scripts/release.sh [PROFILE]
#
# PROFILE is that of the program: `dist`, or `dev` for a check. In target/release-files it puts sdists and wheels of both Python
# packages and an archive with program, guide, examples, licences, completions, manual pages and the Python client. The program
# is built once, from the sdist, so that the sdist is known to be whole. Needs Rust, a C compiler, and Python with venv.
set -euo pipefail
profile=${1:-dist}
cd "$(dirname "${BASH_SOURCE[0]}")/.."
root=$PWD
files=$root/target/release-files
source=$root/target/release-source
rm -rf "$files" "$source"
mkdir -p "$files" "$source"

# The tools that build, in an environment of their own.
[ -x target/packages/bin/python ] || python3 -m venv target/packages
python=$root/target/packages/bin/python
"$python" -m pip install --quiet --disable-pip-version-check -r clients/python/server/requirements.txt
version=$(sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml | head -1)

# A source tree of its own: a file that is made for the packages stands in no other.
git ls-files -z | tar --create --null --files-from - | tar --extract --directory "$source"
python3 scripts/licences.py >"$source/clients/python/server/licenses/THIRD-PARTY.txt"

"$python" -m build --outdir "$files" "$source/clients/python/brinell"
# Zig links against the symbols of an old glibc, 2.17, so that the program runs on every Linux since 2014.
# With debug assertions it would read its page in the folder where it was built.
export CARGO_PROFILE_DEV_DEBUG_ASSERTIONS=false
(cd "$source/clients/python/server" && CARGO_TARGET_DIR=$root/target/python-server PATH=$root/target/packages/bin:$PATH \
    "$python" -m maturin build --sdist --profile "$profile" --zig --compatibility manylinux2014 --out "$files")

name=brinell-$version-$(uname -m)-linux
at=$(mktemp -d)/$name
trap 'rm -rf "$(dirname "$at")"' EXIT
mkdir "$at"
"$python" -m zipfile --extract "$files"/brinell_server-*.whl "$at.wheel"
install -m 755 "$at.wheel"/brinell_server-*.data/scripts/brinell "$at/brinell"
cp deploy/archive/README.md LICENSE-* "$source/clients/python/server/licenses/THIRD-PARTY.txt" "$files"/brinell-*.whl "$at"
mkdir -p "$at/api" "$at/completions"
cp -r api/examples "$at/api"
for shell in bash zsh fish; do "$at/brinell" completions $shell >"$at/completions/brinell.$shell"; done
"$at/brinell" man "$at/man/man1"
scripts/site.sh "$at/guide"
tar --create --gzip --sort=name --owner=0 --group=0 --file "$files/$name.tar.gz" --directory "$(dirname "$at")" "$name"
ls -l "$files"
rm -rf "$at"

# From here on neither this repository nor another program named brinell is in sight.
export PATH=/usr/bin:/bin MPLBACKEND=agg HOME=$(dirname "$at")
unset BRINELL_PROGRAM BRINELL_URL
begin=$(date +%s)
tar --extract --file "$files/$name.tar.gz" --directory "$HOME"
cd "$at"
./brinell demo --once | sed -n '/^force/,/^force /p' | head -1
printf 'first answer after %d s\n' $(($(date +%s) - begin))
# The commands of the archive's README, then those of the repository's that a program alone can follow.
block() { sed -n "/^\`\`\`$2\$/,/^\`\`\`\$/{/^\`\`\`/d;p}" "$1"; }
block README.md sh | bash -eu
sed -n 's/^cargo run -- solve/.\/brinell solve/p' "$root/README.md" | bash -eu >/dev/null
coproc server { exec ./brinell serve --listen 127.0.0.1:0 --data-dir :memory: --log warn --exit-with-stdin; }
read -r line <&"${server[0]}"
url=${line##* }
block "$root/README.md" 'sh curl' | sed "s#http://127.0.0.1:8080#$url#" | bash -eu
curl --fail --silent "$url/" | grep '<title>' >/dev/null
curl --fail --silent "$url/guide/docs/tutorial.html" | grep 'From a press to a measured map' >/dev/null
exec {server[1]}>&-
wait "$server_PID"

"$python" -m venv "$HOME/env"
# The packages come from here alone, whatever a registry has under their names.
wheel=$(echo "$files"/brinell-*.whl)
"$HOME/env/bin/pip" install --quiet --disable-pip-version-check "$files"/brinell_server-*.whl "${wheel}[all,surfaces]"
cd "$HOME"
for document in README.md clients/python/brinell/README.md docs/tutorial.md; do
    env/bin/python "$root/clients/python/scripts/run_readme.py" "$root/$document"
done
env/bin/python -m brinell_server --version
env/bin/brinell --version
