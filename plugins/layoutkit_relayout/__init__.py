"""Relayout: variations of a facade that keep its constraints (Bao, Schwarz and Wonka 2013), and inference."""
