"""What an operator sees of the running server: its access log and its metrics."""
