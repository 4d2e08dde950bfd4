"""Writes the generated files of `materials/` and the CIE tables of `app/optics`.

    python -m tools.build_materials            # write
    python -m tools.build_materials --check    # compare, and fail where a file differs

It needs the extra `data`. The result depends on nothing but `materials/selection.yaml`,
`materials/tables/` and the two pinned packages, down to the byte.
"""
