#!/usr/bin/env bash
# Makes the virtual environment and installs into it exactly what requirements.lock names, then
# this checkout itself; with "test" what requirements-test.lock names, which is more. Without it
# `slim.py` takes out what the program never loads.
#
#   packaging/environment.sh FOLDER [test]
#
# PYTHON=... chooses the interpreter; otherwise the first one that is 3.11 or newer is taken.
# Packages are installed by uv where that can be had, since it takes a fifth of pip's time.
set -euo pipefail
cd "$(dirname "$0")/.."
folder=$1

is_new_enough() {
    "$1" -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null
}

find_python() {
    local name
    # The lock was made for 3.11, so that comes first.
    for name in ${PYTHON:-python3.11 python3 python3.12 python3.13}; do
        if is_new_enough "$name"; then echo "$name" && return; fi
    done
    echo "Glovetrack needs Python 3.11 or newer, and ${PYTHON:-python3} is none." >&2
    echo "On Debian 12 or newer: sudo apt-get install -y python3 python3-venv" >&2
    return 1
}

require_venv() { # python; Debian keeps venv's ensurepip in a package of its own
    if "$1" -c 'import ensurepip, venv' 2>/dev/null; then return; fi
    local package
    package=$("$1" -c 'import sys; print("python3.%d-venv" % sys.version_info[1])')
    if [ "$(id -u)" -eq 0 ] && command -v apt-get >/dev/null; then
        apt-get update -qq && apt-get install -y -qq --no-install-recommends "$package" >/dev/null
    else
        echo "Python's venv is missing. Run: sudo apt-get install -y $package" >&2
        return 1
    fi
}

python=$(find_python)
require_venv "$python"
if ! is_new_enough "$folder/bin/python"; then
    echo "Making $folder with $("$python" --version)"
    "$python" -m venv --clear "$folder"
fi
pip() { "$folder/bin/python" -m pip --disable-pip-version-check install --quiet "$@"; }

install() { # the packages of a lock file; a file with another hash than it names is refused
    packaging/uv.sh "$folder/bin/python" install --require-hashes --requirements "$1" && return
    echo "uv could not install them; pip tries." >&2
    pip --require-hashes --requirement "$1"
}

lock=requirements.lock
if [ "${2:-}" = test ]; then lock=requirements-test.lock; fi
echo "Installing the packages of $lock"
install "$lock"
pip --no-deps --no-build-isolation --editable .
[ $lock != requirements.lock ] || "$folder/bin/python" packaging/slim.py
