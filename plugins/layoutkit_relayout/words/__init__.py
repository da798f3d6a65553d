"""Words: which arrangements the regions of a group may have, as machines, and tables that count them."""
