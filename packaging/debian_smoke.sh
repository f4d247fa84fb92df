#!/usr/bin/env bash
# Installs the Debian package, uses it as another user, and removes it again: nothing may stay.
#
#   packaging/debian_smoke.sh [PACKAGE]
#
# Needs root on Debian or Ubuntu. Also runs desktop-file-validate where it is, and lintian with
# LINTIAN=1 before the command.
set -euo pipefail
cd "$(dirname "$0")/.."
package=$(realpath "${1:-$(ls -t dist/glovetrack_*.deb | head -1)}")
work=$(mktemp -d)
trap 'rm -rf "$work"; dpkg --purge glovetrack &>/dev/null || true' EXIT

as_user() { setpriv --reuid=nobody --regid=nogroup --clear-groups env -i HOME="$work" PATH=/usr/bin \
    QT_QPA_PLATFORM=offscreen "$@"; }

expect() { # what, then a command that must succeed
    local what=$1
    shift
    if "$@" &>"$work.log"; then echo "$what: yes"; else
        cat "$work.log" >&2
        echo "$what: no ($*)" >&2
        return 1
    fi
}

left() { # what of the package is still about
    find /opt/glovetrack /usr/bin/glovetrack /usr/share/applications/glovetrack.desktop \
        /usr/share/mime/packages/glovetrack.xml /usr/lib/udev/rules.d/70-glovetrack.rules \
        /usr/share/icons/hicolor/scalable/apps/glovetrack.svg \
        /usr/share/icons/hicolor/256x256/apps/glovetrack.png /usr/share/doc/glovetrack /usr/share/man/man1/glovetrack.1.gz \
        -maxdepth 0 2>/dev/null
}

if [ -n "${LINTIAN:-}" ]; then # takes minutes; a program that brings its libraries is no Debian program
    lintian --allow-root --tag-display-limit 0 --suppress-tags dir-or-file-in-opt,embedded-library \
        "$package" 2>/dev/null | grep -v shared-library-lacks-prerequisites || true
fi
expect "installs" dpkg -i "$package"
expect "all its files are there" test "$(left | wc -l)" -eq 9
cd "$work" && chown nobody "$work"
expect "the command is there" as_user glovetrack --version
expect "also without a home" as_user env HOME=/nonexistent glovetrack --version
expect "a session is made" as_user glovetrack simulate -o "$work/session.mcap" --duration 2 --blobs-only
expect "and tracked" as_user glovetrack track "$work/session.mcap" -o "$work/tracked.mcap"
expect "the demo runs" as_user glovetrack demo --headless-report 3 --out "$work/demo"
if command -v desktop-file-validate >/dev/null; then
    expect "the desktop entry is valid" desktop-file-validate /usr/share/applications/glovetrack.desktop
fi
if command -v update-mime-database >/dev/null; then
    expect "sessions have their type" grep -q "glovetrack" /usr/share/mime/globs2
fi
expect "is removed" dpkg -r glovetrack
expect "nothing stays" test -z "$(left)"
expect "is purged" dpkg --purge glovetrack
