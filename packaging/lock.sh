#!/usr/bin/env bash
# Writes requirements.lock: what a fresh environment gets for the program and its tests.
#
#   packaging/lock.sh [PYTHON]
#
# A fresh one, so that the lock holds only what something requires. Run the tests before committing it.
set -euo pipefail
cd "$(dirname "$0")/.."
python=${1:-python3.11}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$python" -m venv "$folder"
pip() { "$folder/bin/python" -m pip --disable-pip-version-check --quiet "$@"; }
pip install --upgrade setuptools # what environment.sh builds this checkout with
pip install ".[test,peers,streams,cluster]"
{
    echo "# Every package of the environment, runtime and tests, at one version (Python 3.11, Linux)."
    echo "# Made by \`make lock\` from a fresh environment; do not edit by hand."
    "$folder/bin/python" -m pip freeze --all | grep -vE '^(pip|glovetrack)( @|==)' |
        LC_ALL=C sort --ignore-case
} >requirements.lock.new
mv requirements.lock.new requirements.lock
