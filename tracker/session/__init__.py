"""Session files: writing, reading, recovery, verification and export."""
