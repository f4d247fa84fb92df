"""What other programs recorded with IMUs becomes a session: `glovetrack import`."""
