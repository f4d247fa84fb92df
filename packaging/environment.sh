#!/usr/bin/env bash
# Creates the virtual environment and installs exactly the packages of requirements.lock, then
# this checkout; with "test", those of requirements-test.lock, which also include the test tools.
# Without "test", `slim.py` removes files that the program never loads.
#
#   packaging/environment.sh FOLDER [test]
#
# PYTHON=... selects the interpreter (default: the first one found that is 3.11 or newer).
# uv installs the packages if it is available, since it takes one fifth of pip's time.
set -euo pipefail
cd "$(dirname "$0")/.."
folder=$1

is_new_enough() {
    "$1" -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null
}

find_python() {
    local name
    # The lock was created with 3.11, so try it first.
    for name in ${PYTHON:-python3.11 python3 python3.12 python3.13}; do
        if is_new_enough "$name"; then echo "$name" && return; fi
    done
    echo "Glovetrack requires Python 3.11 or newer, but ${PYTHON:-python3} is older or missing." >&2
    echo "On Debian 12 or newer: sudo apt-get install -y python3 python3-venv" >&2
    return 1
}

require_venv() { # python; on Debian, ensurepip is in a separate package
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
    echo "Creating $folder with $("$python" --version)"
    "$python" -m venv --clear "$folder"
fi
pip() { "$folder/bin/python" -m pip --disable-pip-version-check install --quiet "$@"; }

install() { # the packages of a lock file; files with a different hash are rejected
    packaging/uv.sh "$folder/bin/python" install --require-hashes --requirements "$1" && return
    echo "uv could not install the packages; retrying with pip." >&2
    pip --require-hashes --requirement "$1"
}

lock=requirements.lock
if [ "${2:-}" = test ]; then lock=requirements-test.lock; fi
echo "Installing packages from $lock"
install "$lock"
pip --no-deps --no-build-isolation --editable .
[ $lock != requirements.lock ] || "$folder/bin/python" packaging/slim.py
