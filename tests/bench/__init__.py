"""pylmp bench."""
