#!/usr/bin/env bash
# Compiles the engine's kernels into a bundle, so that its first start need not.
#
#   packaging/kernels.sh BUNDLE WORK
#
# The program is put to work; what numba then leaves in its cache (in WORK) goes into the bundle.
# A kernel that is not among them is compiled where it is first needed.
set -euo pipefail
bundle=$(realpath "$1") work=$2
kernels=$bundle/_internal/kernels

rm -rf "$kernels" "$work" && mkdir -p "$work"
cd "$work"
export XDG_CACHE_HOME=$PWD/cache QT_QPA_PLATFORM=offscreen
run() { nice "$bundle/glovetrack" "$@" >run.log 2>&1 || { cat run.log >&2 && return 1; }; }

echo "Compiling the kernels"
run demo --headless-report 8 --out demo
run simulate -o pictures.mcap --duration 3
for engine in chain vist switching madgwick; do
    run track pictures.mcap -o $engine.mcap --engine $engine
done
cp -r cache/glovetrack/kernels-* "$kernels"
chmod -R a+rX "$kernels" # a cache is its user's alone
find "$kernels" -name '*.nbc' | wc -l | sed 's/$/ kernels compiled/'
