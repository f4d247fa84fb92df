"""The container: MCAP files on disk, including damaged ones."""
