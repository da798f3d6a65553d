"""The topological jump: elements inserted, removed and moved (Dang et al. 2014, section 4)."""
