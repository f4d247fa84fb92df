"""The filters: `chain` (ours) and what all engines share (buffer, layout, update, start)."""
