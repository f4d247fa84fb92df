#!/usr/bin/env bash
# Compiles the kernels ahead of time into tracker/kernels, so that no start of the program has to.
#
#   packaging/kernels.sh VENV [--for-demo [--shown]]
#
# With --shown the very first library is left to the window, which shows how far it is.
# What was compiled before for this user, in any checkout, is taken from there.
# Without a C++ compiler they stay as they are: numba compiles each where it is first needed.
set -euo pipefail
cd "$(dirname "$0")/.."
python=$1/bin/python

if ! "$python" -m tracker.kernels.tools; then
    echo "Without a C++ compiler and Python's headers kernels are compiled when first needed." >&2
    echo "On Debian: sudo apt-get install -y g++ python3-dev, then make kernels" >&2
    exit 0
fi
if [ "${3:-}" = --shown ] && ! compgen -G 'tracker/kernels/_compiled_*.txt' >/dev/null; then
    exit 0
fi
echo "Compiling the kernels, as far as they are new"
"$python" -m tracker.kernels.build ${2:+"$2"}
