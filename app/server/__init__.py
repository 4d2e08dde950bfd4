"""The running server: its processes, threads, memory, log, and the way it stops."""
