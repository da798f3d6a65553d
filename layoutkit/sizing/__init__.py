"""Sizing: cut lines, linear rows, the QP and its backends."""
