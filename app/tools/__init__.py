"""The window used as a tool: screenshots, soak test, headless report."""

from tracker.base.numeric_threads import limit_this_process

limit_this_process()  # before numpy is imported, as the program does
