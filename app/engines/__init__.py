"""Render engines as they were measured, and which model explains what each of them reflects."""
