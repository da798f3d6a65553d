"""Sizes for chosen words: drawn, fitted to all rules, told apart where they have to differ."""
