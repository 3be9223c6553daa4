"""What is computed of a vector scheme, each number once: `vector` has the object, the other files the functions."""
