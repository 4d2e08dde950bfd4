"""The atlas of errors: how wrong every model is at every material, and where that was worked out."""
