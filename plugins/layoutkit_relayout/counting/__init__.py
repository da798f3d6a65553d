"""Counting arrangements, which is also telling which one is the n-th: so that they can be drawn evenly."""
