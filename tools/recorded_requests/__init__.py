"""Record what a server and its commands answer, and compare another build with that.

Kept outside CI: it is for changes that must leave behaviour as it is.
"""
