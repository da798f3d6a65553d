"""Paints the pictures of our own designs, terminal by terminal, from their documents."""
