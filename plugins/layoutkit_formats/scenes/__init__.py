"""Formats of scenes, one file each."""
