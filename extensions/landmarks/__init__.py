"""Hands for programs made for webcams and headsets: 21 landmarks in MediaPipe's order."""
