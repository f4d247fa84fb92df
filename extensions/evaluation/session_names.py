"""Names of sessions that are not usual; fast to import."""

SESSIONS = {
    "unusual": "unusual people",
    "away": "away for 5 s of 15",
    "exchanged": "red and blue exchanged",
}
"""What is different, by name: sizes, fit of the glove and cloth vary twice as much; the hand is out
of view repeatedly; names of hues are exchanged in the colours."""
