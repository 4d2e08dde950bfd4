"""A material as files of render engines and interchange formats, and what each of them makes of it."""
