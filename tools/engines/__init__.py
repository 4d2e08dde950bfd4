"""What render engines reflect, measured by running them: outside of the tests, one at a time."""
