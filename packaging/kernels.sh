#!/usr/bin/env bash
# Compiles the kernels ahead of time into tracker/kernels, so that the program need not do it.
#
#   packaging/kernels.sh VENV [--for-demo [--shown]]
#
# With --shown, the window builds the first library and shows the progress.
# Kernels that this user has compiled before, in any checkout, are reused.
# Without a C++ compiler this script does nothing: numba compiles each kernel on first use.
set -euo pipefail
cd "$(dirname "$0")/.."
python=$1/bin/python

if ! "$python" -m tracker.kernels.tools; then
    echo "No C++ compiler or Python headers found: kernels are compiled on first use." >&2
    echo "On Debian: sudo apt-get install -y g++ python3-dev, then make kernels" >&2
    exit 0
fi
if [ "${3:-}" = --shown ] && ! compgen -G 'tracker/kernels/_compiled_*.txt' >/dev/null; then
    exit 0
fi
echo "Compiling new and changed kernels"
"$python" -m tracker.kernels.build ${2:+"$2"}
