"""Which of all arrangements variations have: likely ones, each equally often, or far apart."""
