"""Measurements: how well annotations are converted, how fast and how surely facades are laid out anew."""
