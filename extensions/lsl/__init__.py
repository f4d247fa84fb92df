"""Lab Streaming Layer: estimates as an outlet, markers of other programs as notes."""
