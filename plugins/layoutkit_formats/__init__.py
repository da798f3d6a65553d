"""Annotations made by others, read as facades: CMP boxes and label masks."""
