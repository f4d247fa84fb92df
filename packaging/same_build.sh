#!/usr/bin/env bash
# Compares two builds of one commit (folders or packages) and lists the files that differ.
# Exit status 0: no differences.
#
#   packaging/same_build.sh A B
set -euo pipefail
sums() { # folder or file
    if [ -d "$1" ]; then
        (cd "$1" && find . -type f -print0 | sort -z | xargs -0 sha256sum)
    else
        sha256sum <"$1"
    fi
}
differing=$(diff <(sums "$1") <(sums "$2") | sed -n 's/^[<>] [0-9a-f]*  //p' | sort -u || true)
if [ -n "$differing" ]; then
    echo "$differing"
    echo "These files differ." >&2
    exit 1
fi
echo "Both are identical, byte for byte."
