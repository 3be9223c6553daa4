"""One theorem, or one family of conditions, per file: numbers of a scheme -> findings with their witnesses.

A stage is a pure function `run(numbers, facts)`. `numbers` computes what is asked of it; `facts` are the findings of
the stages before it, by code. Every stage's docstring names the theorem and its hypotheses; a hypothesis is checked in
code or stands in the finding. `scalar.py` puts those of scalar schemes in order.
"""
