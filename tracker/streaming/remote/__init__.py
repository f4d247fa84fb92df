"""Remote control: other programs start and stop recordings and send notes, vibrations and contacts.

`request` defines requests and replies, `osc` the same in OSC, `reception` limits their
rates, `doors` are the sockets. Off by default. See docs/streaming.md.
"""
