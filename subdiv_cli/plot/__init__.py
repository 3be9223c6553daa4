"""Pictures of blocks: `panels` puts them on common axes, `sampled` and `relief` make doubles of exact values.

`terminal` and `heights` draw with letters, `figure` and `reliefs` with matplotlib (the extra `plot`), which is loaded
only when a file is drawn; `obj` writes nets.
"""
