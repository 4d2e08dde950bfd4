"""Where the references can be read: addresses of DOIs, and of what is on the web without one."""

import re

_DOI = re.compile(r"doi:(10\.[^\s,;]+)")
_ADDRESS = re.compile(r"https://[^\s,;]+")

ADDRESSES = {
    "Memo on Fresnel equations": "https://seblagarde.wordpress.com/2013/04/29/memo-on-fresnel-equations/",
    "Fresnel Equations, Schlick Approximation": "https://psgraphics.blogspot.com/2020/03/"
    "fresnel-equations-schlick-approximation.html",
    "Hitchhiker's Guide to Multiple Scattering": "https://www.eugenedeon.com/hitchhikers",
    "M. Wloka, Fresnel Reflection": "https://developer.download.nvidia.com/SDK/9.5/Samples/DEMOS/"
    "Direct3D9/src/HLSL_FresnelReflection/docs/FresnelReflection.pdf",
    "Artist Friendly Metallic Fresnel": "https://jcgt.org/published/0003/04/03/",
    "glTF 2.0 Specification": "https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html",
    "SIGGRAPH 2012 course notes": "https://blog.selfshadow.com/publications/s2012-shading-course/",
    "SIGGRAPH 2013 course notes": "https://blog.selfshadow.com/publications/s2013-shading-course/",
    "SIGGRAPH 2014 course notes": "https://blog.selfshadow.com/publications/s2014-shading-course/",
    "SIGGRAPH 2017 course": "https://blog.selfshadow.com/publications/s2017-shading-course/",
    "IEC 61966-2-1": "https://webstore.iec.ch/publication/6169",
    "OpenPBR": "https://academysoftwarefoundation.github.io/OpenPBR/",
    "Rendering in Filament": "https://google.github.io/filament/Filament.md.html",
    "Physically Based Rendering, 1st edition": "https://pbrt.org/",
}
"""Address by the words that name the source in a reference."""


def links(reference: str) -> list[str]:
    """Addresses of the sources that a reference names: DOIs, addresses, works that are known here.

    Examples
    --------
    >>> links("A model, Journal 1, 2 (1994), doi:10.1111/1467-8659.1330233; OpenPBR")
    ['https://doi.org/10.1111/1467-8659.1330233', 'https://academysoftwarefoundation.github.io/OpenPBR/']
    >>> links("A note (2026), https://example.org/note.pdf")
    ['https://example.org/note.pdf']
    """
    found = [f"https://doi.org/{doi}" for doi in _DOI.findall(reference)]
    found += _ADDRESS.findall(reference)
    return found + [address for words, address in ADDRESSES.items() if words in reference]
