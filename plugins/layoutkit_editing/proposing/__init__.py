"""Proposals: what an edit can come to, sized and checked (Dang et al. 2014, sections 4 to 6)."""
