"""Background jobs: exports, tracking again, streams."""
