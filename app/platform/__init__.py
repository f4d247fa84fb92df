"""What the window needs of the system it runs on: tasks, crashes, one instance, the screen."""
