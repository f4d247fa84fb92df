"""Live outputs: the estimate to other programs and to the glove's motors, off until asked for.

One file per protocol. Each is a `publisher.Publisher`; `streams.Streams` runs them in threads of
their own, so that a slow or dead client never slows tracking. See docs/streaming.md.
"""
