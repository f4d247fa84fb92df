"""The hand for retargeting programs: keyed poses as a stream, and files for dex-retargeting."""
