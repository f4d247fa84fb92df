#!/usr/bin/env bash
# Compiles the OpenXR API layer into extensions/openxr/layer, from where packages include it.
#
#   packaging/openxr_layer.sh VENV
#
# Nothing is done on other systems than Linux.
set -euo pipefail
cd "$(dirname "$0")/.."
if [ "$(uname -s)" != Linux ]; then
    echo "The OpenXR layer is compiled on Linux only." >&2
    exit 0
fi
packaging/system_libraries.sh openxr
"$1/bin/python" -m extensions.openxr.build
