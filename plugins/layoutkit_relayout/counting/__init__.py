"""Counting arrangements, and drawing them evenly: nothing is drawn or tried that the count has not told apart."""
