#!/usr/bin/env bash
# Installs the Debian package, uses it as another user, and checks that removal leaves no files.
#
#   packaging/debian_smoke.sh [PACKAGE]
#
# Requires root on Debian or Ubuntu. FRESH=1 runs everything in a minimal Debian with only the
# package's dependencies; debootstrap creates it, and it is deleted afterwards (also requires
# bubblewrap). FRESH=FOLDER uses a copy of an existing one. LINTIAN=1 also runs lintian.
set -euo pipefail
cd "$(dirname "$0")/.."
package=$(realpath "${1:-$(ls -t dist/glovetrack_*.deb | head -1)}")
work=$(mktemp -d)

if [ -n "${FRESH:-}" ]; then
    trap 'rm -rf --one-file-system "$work"' EXIT
    if [ -d "$FRESH" ]; then
        cp -a "$FRESH/." "$work"
    else
        echo "Making a minimal Debian"
        debootstrap --variant=minbase bookworm "$work" >"$work.log" || { tail "$work.log" >&2 && exit 1; }
    fi
    chmod 755 "$work"
    cp /etc/resolv.conf "$work/etc"
    bwrap --bind "$work" / --dev /dev --perms 1777 --tmpfs /dev/shm --proc /proc --ro-bind "$PWD" /checkout \
        --ro-bind "$package" "/${package##*/}" --unshare-pid --die-with-parent --clearenv \
        --setenv PATH /usr/sbin:/usr/bin:/sbin:/bin --setenv DEBIAN_FRONTEND noninteractive \
        /checkout/packaging/debian_smoke.sh "/${package##*/}"
    exit
fi
trap 'rm -rf "$work"; dpkg --purge glovetrack &>/dev/null || true' EXIT

as_user() { setpriv --reuid=nobody --regid=nogroup --clear-groups env -i HOME="$work" PATH=/usr/bin \
    QT_QPA_PLATFORM=offscreen "$@"; }

expect() { # description, then a command that must succeed
    local what=$1
    shift
    if "$@" &>"$work.log"; then echo "$what: yes"; else
        cat "$work.log" >&2
        echo "$what: no ($*)" >&2
        return 1
    fi
}

left() { # lists installed files of the package
    find /opt/glovetrack /usr/bin/glovetrack /usr/share/applications/glovetrack.desktop \
        /usr/share/mime/packages/glovetrack.xml /usr/lib/udev/rules.d/70-glovetrack.rules \
        /usr/share/icons/hicolor/scalable/apps/glovetrack.svg \
        /usr/share/icons/hicolor/256x256/apps/glovetrack.png /usr/share/doc/glovetrack /usr/share/man/man1/glovetrack.1.gz \
        -maxdepth 0 2>/dev/null
}

if [ -n "${LINTIAN:-}" ]; then # takes minutes; bundled libraries violate Debian policy, so those tags are suppressed
    lintian --allow-root --tag-display-limit 0 --suppress-tags dir-or-file-in-opt,embedded-library \
        "$package" 2>/dev/null | grep -v shared-library-lacks-prerequisites || true
fi
apt-get update -qq
expect "installs with its dependencies" apt-get install -qq -y "$package"
expect "all files are installed" test "$(left | wc -l)" -eq 9
cd "$work" && chown nobody "$work"
expect "the command runs" as_user glovetrack --version
expect "the command runs without a home folder" as_user env HOME=/nonexistent glovetrack --version
expect "a session is simulated" as_user glovetrack simulate -o "$work/session.mcap" --duration 2 --blobs-only
expect "the session is tracked" as_user glovetrack track "$work/session.mcap" -o "$work/tracked.mcap"
expect "the demo runs" as_user glovetrack demo --headless-report 3 --out "$work/demo"
# A simulated glove and camera as system devices: a serial line and a pipe of images.
mkdir -p "$work/.config/glovetrack" "$work/rig" && chown -R nobody "$work/.config" "$work/rig"
cat >"$work/.config/glovetrack/window.json" <<JSON
{"version": 3, "port": "$work/rig/glove", "camera": "$work/rig/camera.mjpeg", "calibration": "$work/rig/camera.yml"}
JSON
set -m # a separate process group, so that one kill ends all its processes
as_user glovetrack rig "$work/rig" --duration 90 &>"$work/rig.log" &
rig=$!
set +m
for _ in {1..300}; do [ -e "$work/rig/camera.yml" ] && break || sleep 0.1; done
expect "devices are tracked" as_user glovetrack devices --headless-report 5 --out "$work/devices"
kill -- -$rig && { wait $rig || true; }
grep -E "^(rates|tracking|error)" "$work.log"
# The guide's instructions for access to the serial port.
expect "the group dialout exists" usermod -aG dialout nobody
expect "the udev rule grants access to the logged-in user" grep -q uaccess /usr/lib/udev/rules.d/70-glovetrack.rules
expect "the manual page is complete" sh -c "zcat /usr/share/man/man1/glovetrack.1.gz | grep -q '^.SH EXIT STATUS'"
expect "the guide is included" test -s /opt/glovetrack/_internal/resources/site/index.html
if command -v desktop-file-validate >/dev/null; then
    expect "the desktop entry is valid" desktop-file-validate /usr/share/applications/glovetrack.desktop
fi
if command -v update-mime-database >/dev/null; then
    expect "the MIME type is registered" grep -q "glovetrack" /usr/share/mime/globs2
fi
expect "the package is removed" dpkg -r glovetrack
expect "no files remain" test -z "$(left)"
expect "the package is purged" dpkg --purge glovetrack
