"""Speed and accuracy compared with other software: make bench."""
