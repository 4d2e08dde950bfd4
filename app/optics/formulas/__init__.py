"""The collection of formulas: equation, symbols, domain, source, error and curve of each."""
