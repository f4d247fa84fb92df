#!/usr/bin/env bash
# Tests `pip install .` and `pipx install .` as a user would run them: in fresh environments outside
# this checkout; the program then runs in another folder with a clean environment.
#
#   packaging/install_smoke.sh [PYTHON]
#
# Downloads the program's dependencies (about 700 MB each) and takes several minutes.
set -euo pipefail
cd "$(dirname "$0")/.."
python=$(realpath -s "$(command -v "${1:-.venv/bin/python}")")
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
pip() { PIP_DISABLE_PIP_VERSION_CHECK=1 "$@"; }
clean() { # program, arguments
    (cd "$place" && env -i HOME="$place/home" PATH=/usr/bin:/bin QT_QPA_PLATFORM=offscreen "$@")
}

try() { # description, program
    rm -f "$place"/*.mcap # commands do not overwrite files
    echo "$1: $(clean "$2" --version)"
    clean "$2" simulate -o "$place/session.mcap" --duration 2 --blobs-only
    clean "$2" track "$place/session.mcap" -o "$place/tracked.mcap"
    clean "$2" export "$place/tracked.mcap" --format glb -o "$place/hand.glb"
}

mkdir "$place/home" "$place/source"
# Committed and uncommitted files, without build outputs.
git ls-files -z --cached --others --exclude-standard | xargs -0 cp --parents -t "$place/source"

"$python" -m venv "$place/pip"
pip "$place/pip/bin/pip" install --quiet "$place/source"
try "pip install ." "$place/pip/bin/glovetrack"
clean "$place/pip/bin/glovetrack" demo --headless-report 5 --out "$place/demo"
rm -rf "$place/pip"

"$python" -m venv "$place/tool"
pip "$place/tool/bin/pip" install --quiet pipx
export PIPX_HOME=$place/pipx PIPX_BIN_DIR=$place/bin
pip "$place/tool/bin/pipx" install --quiet --python "$python" "$place/source"
try "pipx install ." "$place/bin/glovetrack"
