"""Remote control: start, stop, notes, vibration and contacts with things, asked by other programs.

`request` defines requests and replies, `osc` the same in OSC, `reception` bounds who
asks how often, `doors` are the sockets. Off until asked for. See docs/streaming.md.
"""
