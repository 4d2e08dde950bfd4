"""Measured comparisons, each printing ratios taken side by side in one run."""
