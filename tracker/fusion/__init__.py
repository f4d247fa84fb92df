"""The filters: `chain` (ours) and what any engine shares (buffer, layout, update, start)."""
