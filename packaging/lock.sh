#!/usr/bin/env bash
# Writes requirements.lock from what is installed in the virtual environment.
#
#   packaging/lock.sh FOLDER
set -euo pipefail
cd "$(dirname "$0")/.."
# What `make package` alone installs stays out.
{
    echo "# Every package of the environment, runtime and tests, at one version (Python 3.11, Linux)."
    echo "# Made by \`make lock\` from an environment in which all tests pass; do not edit by hand."
    "$1/bin/python" -m pip freeze --all --exclude-editable |
        grep -vE '^(pip|altgraph|pyinstaller|pyinstaller-hooks-contrib)==' |
        LC_ALL=C sort --ignore-case
} >requirements.lock.new
mv requirements.lock.new requirements.lock
