"""A session's file: writer beside reader, recovery, verdicts and exports."""
