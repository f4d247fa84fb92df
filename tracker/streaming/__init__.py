"""Live outputs: the estimate for other programs and for the glove's motors; off by default.

One file per protocol. Each is a `publisher.Publisher`; `streams.Streams` runs them in threads of
their own, so that a slow or dead client never slows tracking. See docs/streaming.md.
"""
