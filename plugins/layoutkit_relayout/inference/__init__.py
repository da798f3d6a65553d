"""Inference: constraints read off a segmentation, for the user to edit."""
