"""Reference recordings of a laboratory: import, time alignment, registration, accuracy."""
