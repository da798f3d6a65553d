"""A constraint-solving facade and layout engine: one segmented facade in, many plausible variations out."""

__version__ = "0.1.0"
