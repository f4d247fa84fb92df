"""Remote control: start, stop, notes, vibration and contacts with things, asked by other programs.

`request` says what may be asked and what is answered, `osc` the same in OSC, `reception` bounds who
asks how often, `doors` are the sockets. Off until asked for. See docs/streaming.md.
"""
