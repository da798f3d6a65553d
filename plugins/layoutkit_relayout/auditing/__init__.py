"""Auditing: faults in what a facade's constraints mean, found without laying it out."""
