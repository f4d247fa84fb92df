"""Benchmarks. They run with one numeric thread, as the program does: OpenBLAS with two is a hundred
times slower for matrices of these sizes on two cores."""

from tracker.base.numeric_threads import limit_this_process

limit_this_process()  # before numpy is imported
