"""The claims on masks in several variables, as FORMAT.md in this kind's folder says; `proof` begins."""
