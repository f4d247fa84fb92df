#!/usr/bin/env bash
# To be sourced: what else would differ between two builds of one commit is that of the commit.
SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2>/dev/null || stat -c %Y pyproject.toml)}
PYTHONHASHSEED=0 # else sets in compiled modules have another order each time
export SOURCE_DATE_EPOCH PYTHONHASHSEED
