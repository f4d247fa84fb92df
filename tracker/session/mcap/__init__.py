"""The container: MCAP files on disk, damaged ones too."""
