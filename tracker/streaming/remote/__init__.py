"""Remote control: start, stop and note from other programs, and vibration of a finger.

`request` says what may be asked and what is answered, `osc` the same in OSC, `reception` bounds who
asks how often, `doors` are the sockets. Off until asked for. See docs/streaming.md.
"""
