"""Conformance: a script of gestures, recorded and judged by the rules of robot labs."""
