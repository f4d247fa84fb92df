"""What keyed poses report, by code."""

TEXTS = {
    "poses.to": "Keyed poses to {host}:{port}",
}
