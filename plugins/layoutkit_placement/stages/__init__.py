"""The stages of placement."""
