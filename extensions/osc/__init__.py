"""Open Sound Control: fingers to avatars by VMC, and remote control.

Messages are encoded and decoded here and not by python-osc (public domain): that library ignores
an argument of an unknown type and goes on, lets UnicodeDecodeError through, and reads an address
that does not begin with a slash. Refusing these takes as many lines as decoding does.
"""
