#!/usr/bin/env bash
# Checks spelling, retired words (packaging/prose/retired.txt: docs/glossary.md has the words in use),
# style (packaging/prose/styles), sentences of errors in tests, and the titles of commits.
#
#   packaging/prose.sh VENV
set -euo pipefail
cd "$(dirname "$0")/.."
codespell=$PWD/$1/bin/codespell
prose=packaging/prose
since=bdbe0a8 # titles before this commit are as they are

mapfile -t files < <(git ls-files -- '*.py' '*.md' '*.toml' '*.sh' '*.c' '*.cpp' '*.h' '*.yml' Makefile ":!:$prose")
"$codespell" --ignore-words "$prose/vocabulary.txt" "${files[@]}"
# Identifiers are split at underscores, so that a retired word is found in them as well. Names in
# recordings and files keep the words that they had.
names='"[a-z_.]*(told|anew)[a-z_.]*"|[`"]aside[`"]|aside_deg'
mapfile -t product < <(printf '%s\n' "${files[@]}" | grep -vE "^(CHANGELOG|resources/firmware|packaging/(prose|debian_smoke))")
"$codespell" --dictionary "$prose/retired.txt" --regex '[A-Za-z][a-z]+' --ignore-regex "$names" \
    "${product[@]}"

"$1/bin/python" "$prose/style.py"

# Tests compare codes of notices (tests/notices.py) rather than English sentences.
ours='Glovetrack|File|Device|Config|Stream|Usage|Request|Flash|Calibration|Alignment'
if git grep -nE "raises\([A-Za-z_.]*($ours)Error\b.*match=\"[^\"]* [^\"]* " -- '*.py'; then
    echo "compare the code of the notice: tests.notices.raises"
    exit 1
fi

if git cat-file -e "$since" 2>/dev/null; then # absent in a shallow clone
    git log --no-merges --format='%h %s' "$since..HEAD" | awk '
        { title = substr($0, index($0, " ") + 1); first = $2 }
        length(title) > 72 { print $1 ": title longer than 72 characters: " title; bad = 1 }
        first !~ /^[A-Z]/ || first ~ /(ed|ing)$/ && first !~ /^(Need|Feed|Speed|Embed|Bring|Shed|Seed)$/ {
            print $1 ": title does not start with a verb in the imperative: " title; bad = 1 }
        title ~ /\.$/ { print $1 ": title ends with a full stop: " title; bad = 1 }
        END { exit bad }'
fi
