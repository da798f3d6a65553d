"""Draft the documents of our scenes."""
