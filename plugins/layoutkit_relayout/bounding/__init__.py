"""Proofs that no words can be: linear programs over how often each symbol stands where, and over sizes."""
