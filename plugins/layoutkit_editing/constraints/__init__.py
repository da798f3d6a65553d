"""Constraints of the facade document, respected while it is edited."""
