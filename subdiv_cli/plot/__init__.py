"""Pictures of sampled curves: `sampled` makes points of exact values, `terminal` draws with letters, `figure` with

matplotlib (the extra `plot`), which is loaded only when a file is drawn.
"""
