"""Real hand motion from files, fitted with our skeleton: Qualisys TSV, Leap, BVH."""
