"""The stages of schemes in several variables, SD6xx: one theorem, or one family of conditions, per file."""
