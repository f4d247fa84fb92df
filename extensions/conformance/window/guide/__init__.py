"""The guided conformance check: scripted gestures are recorded and judged."""
