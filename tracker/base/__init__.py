"""What every part uses and that knows nothing of hands: clock, errors, files, threads, settings."""
