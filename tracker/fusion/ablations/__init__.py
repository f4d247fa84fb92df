"""What is kept to be measured against."""
