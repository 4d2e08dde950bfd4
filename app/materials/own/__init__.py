"""Materials that people bring: the id carries the data, and no server keeps them."""
