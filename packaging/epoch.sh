#!/usr/bin/env bash
# Source this file to make builds reproducible: dates are those of the commit, hashes have no seed.
SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2>/dev/null || stat -c %Y pyproject.toml)}
PYTHONHASHSEED=0 # otherwise the order of sets in compiled modules differs between builds
export SOURCE_DATE_EPOCH PYTHONHASHSEED
