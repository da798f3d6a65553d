"""The search: what is still open, which words to try, and how to go back where they fail."""
