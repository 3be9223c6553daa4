"""The mathematical objects: one file per kind of scheme. Constructors hold Fractions; flint is entered on first use."""
