"""Many mask files: which ones are meant (discovery)."""
