"""Settings of all tests."""

from hypothesis import settings

# A busy machine must not turn a slow example into a failure.
settings.register_profile("project", deadline=None)
if settings.get_current_profile_name() == "default":
    settings.load_profile("project")
