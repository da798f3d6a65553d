"""Explanation: why a facade has no layout at a size, and what would give it one."""
