"""Integration with the operating system: tasks, crashes, single instance, screen."""
