"""HTTP for pure functions: queries, finished answers, problems, what every answer carries."""
