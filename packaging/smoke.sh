#!/usr/bin/env bash
# Tests a built program under a new user's conditions: without this checkout, Python or a home
# folder, with the program's folder read-only, and not as root.
#
#   packaging/smoke.sh [BUNDLE] [OUT]
#
# BUNDLE contains the program (default: dist/glovetrack); OUT receives the results and a screenshot
# (default: build/smoke). Requires bubblewrap and Xvfb. Exit status 0: all steps succeeded.
set -euo pipefail
cd "$(dirname "$0")/.."
bundle=$(realpath "${1:-dist/glovetrack}") out=${2:-build/smoke}
seconds=20
for tool in bwrap Xvfb; do
    command -v $tool >/dev/null || { echo "$tool is missing: apt-get install bubblewrap xvfb" >&2 && exit 1; }
done
rm -rf "$out" && mkdir -p "$out/home"
out=$(realpath "$out")

Xvfb -displayfd 3 -noreset -screen 0 1440x900x24 -nolisten tcp &>"$out/xvfb.log" 3>"$out/display" &
screen=$!
trap 'kill $screen' EXIT
until [ -s "$out/display" ]; do sleep 0.05; done # Xvfb selects a free display number
display=:$(cat "$out/display")

within() { # runs the command in "words" with these arguments; only /out and HOME are writable
    bwrap --unshare-all --uid 1000 --gid 1000 --die-with-parent --clearenv \
        --ro-bind /usr /usr --symlink usr/bin /bin --symlink usr/lib /lib --symlink usr/lib64 /lib64 \
        --tmpfs /usr/local --ro-bind-try /etc/fonts /etc/fonts --ro-bind-try /etc/ld.so.cache /etc/ld.so.cache \
        --proc /proc --dev /dev --tmpfs /tmp --ro-bind /tmp/.X11-unix /tmp/.X11-unix --tmpfs /run \
        --ro-bind "$bundle" /opt/glovetrack --bind "$out" /out --chdir /out \
        --setenv HOME /out/home --setenv PATH /usr/bin --setenv DISPLAY $display --setenv LANG C.UTF-8 \
        "${words[@]}" "$@"
}
words=()
inside() { words=(/opt/glovetrack/"$1") && within "${@:2}"; }
inside_sh() { words=(/bin/bash -mc) && within "PATH=\$PATH:/opt/glovetrack; $1"; }

step() { # name, command
    local begun=$EPOCHREALTIME what=$1
    shift
    if ! "$@" &>"$out/$what.log"; then
        cat "$out/$what.log" >&2
        echo "failed: $what ($*)" >&2
        return 1
    fi
    LC_ALL=C printf '%-12s %6.2f s\n' "$what" "$(bc <<<"$EPOCHREALTIME - $begun")"
}

opens() { # name, command: prints the seconds until its window appears, then ends the program
    local begun=$EPOCHREALTIME what=$1
    shift
    "$@" &>"$out/$what.log" &
    local program=$!
    timeout 120 xdotool search --sync --onlyvisible --name Glovetrack >/dev/null
    LC_ALL=C printf '%-12s %6.2f s\n' "$what" "$(bc <<<"$EPOCHREALTIME - $begun")"
    kill $program && { wait $program || true; }
    for _ in {1..100}; do # until the window has closed
        xdotool search --onlyvisible --name Glovetrack >/dev/null || break
        sleep 0.1
    done
}

source_run() { # the same program from this checkout, for comparison
    export HOME=$out/home
    exec .venv/bin/python -m app # so that kill reaches the program
}

step site test -s "$bundle/_internal/resources/site/search/index_on_disk.js"
step version inside glovetrack --version
step version-again inside glovetrack --version
if command -v xdotool >/dev/null; then
    export DISPLAY=$display
    opens window inside glovetrack
    opens window-again inside glovetrack
    [ ! -x .venv/bin/python ] || opens from-source source_run
fi
step simulate inside glovetrack simulate -o practice.mcap --duration 3 --blobs-only
step demo-first inside glovetrack demo --headless-report 2 --out first
step demo inside glovetrack demo --headless-report $seconds --out demo
cat "$out/demo.log"
step verify inside glovetrack verify demo/session.mcap
formats=$(inside glovetrack export --help | grep -o '{[a-z0-9.,]*}' | head -1 | tr -d '{}' | tr , ' ')
for format in $formats; do
    step $format inside glovetrack export demo/session.mcap --format $format -o "made.$format"
done
# System devices simulated by a second process: a serial line and a pipe of images.
mkdir -p "$out/home/.config/glovetrack" "$out/rig"
cat >"$out/home/.config/glovetrack/window.json" <<'JSON'
{"version": 3, "port": "/out/rig/glove", "camera": "/out/rig/camera.mjpeg", "calibration": "/out/rig/camera.yml"}
JSON
step devices inside_sh "glovetrack rig rig --duration 90 & while ! [ -e rig/camera.yml ]; do sleep 0.2; done;
    glovetrack devices --headless-report 15 --out devices; code=\$?; kill %1; exit \$code"
cat "$out/devices.log"
for engine in chain vist switching madgwick; do
    step track-$engine inside glovetrack track practice.mcap -o $engine.mcap --engine $engine
done
step conformance inside glovetrack conformance --simulate --hands both -o simulated.html
step batch inside glovetrack track practice.mcap demo/session.mcap -o batch --jobs 2
step compare inside glovetrack compare chain.mcap vist.mcap

tracked=$(sed -n 's/^tracking *\([0-9]*\) %.*/\1/p' "$out/demo.log")
[ "$tracked" -ge 50 ] || { echo "The hand was tracked for only $tracked % of the time." >&2 && exit 1; }
[ -s "$out/demo/window.png" ] || { echo "The screenshot of the window is missing." >&2 && exit 1; }
if grep -H "runs uncompiled" "$out"/*.log; then
    echo "The library lacks kernels for the types of some calls." >&2 && exit 1
fi
echo "All steps succeeded. Screenshot: $out/demo/window.png"
