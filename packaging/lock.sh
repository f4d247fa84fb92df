#!/usr/bin/env bash
# Writes requirements.lock with all packages of the program, and requirements-test.lock, which adds
# those of the tests. Each package has its newest compatible version and the SHA-256 hashes of all
# published files of that version, so that the lock files work on every platform.
#
#   packaging/lock.sh [PYTHON]
#
# Run the tests before committing the lock files.
set -euo pipefail
cd "$(dirname "$0")/.."
python=${1:-python3.11}

write_lock() { # file, purpose, options
    {
        echo "# Every package of $2, at one version (Python 3.11, Linux), with the hashes of its files."
        echo "# Made by \`make lock\`; do not edit by hand."
        # environment.sh builds this checkout with setuptools
        echo setuptools | packaging/uv.sh "$python" compile pyproject.toml - --upgrade \
            --generate-hashes --no-annotate --no-header --no-emit-index-url --no-emit-find-links \
            "${@:3}"
    } >"$1.new"
    mv "$1.new" "$1"
}

write_lock requirements.lock "the program"
extras=(parquet test peers streams cluster robot)
write_lock requirements-test.lock "the program and its tests" \
    --constraint requirements.lock "${extras[@]/#/--extra=}"
