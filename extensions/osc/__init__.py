"""Open Sound Control: fingers to avatars by VMC, and remote control.

Messages are encoded and decoded in this package. python-osc 1.10 (public domain) would replace 100
lines, but takes 1.7 ms for a bundle of 45 bones (here 0.11 ms; 100 bundles a second for each hand).
When decoding, it drops an argument of an unknown type and keeps the others, raises
UnicodeDecodeError for a text that is not UTF-8, and accepts an address without a slash; requests
that start a recording must be refused in these cases. The tests use it as the other side.
"""
