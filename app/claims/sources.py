"""The publications and programs that claims are taken from."""

from app.claims.claim import Source

SHIRLEY = Source(
    "P. Shirley",
    2020,
    "Fresnel Equations, Schlick Approximation, Metals, and Dielectrics",
    "https://psgraphics.blogspot.com/2020/03/fresnel-equations-schlick-approximation.html",
)
LAGARDE = Source(
    "S. Lagarde",
    2013,
    "Memo on Fresnel equations, version 1.4",
    "https://seblagarde.wordpress.com/2013/04/29/memo-on-fresnel-equations/",
)
WLOKA = Source(
    "M. Wloka",
    2002,
    "Fresnel Reflection, NVIDIA technical report",
    "https://developer.download.nvidia.com/SDK/9.5/Samples/DEMOS/Direct3D9/src/"
    "HLSL_FresnelReflection/docs/FresnelReflection.pdf",
)
DEON = Source(
    "E. d'Eon",
    2019,
    "Fresnel Boundaries, notebook to A Hitchhiker's Guide to Multiple Scattering",
    "https://www.eugenedeon.com/hitchhikers",
)
MITSUBA = Source(
    "W. Jakob et al.",
    2022,
    "Mitsuba 3",
    "https://github.com/mitsuba-renderer/mitsuba3/blob/master/include/mitsuba/render/fresnel.h",
)
KULLA_CONTY = Source(
    "C. Kulla and A. Conty",
    2017,
    "Revisiting Physically Based Shading at Imageworks, SIGGRAPH course",
    "https://blog.selfshadow.com/publications/s2017-shading-course/",
)
KARIS = Source(
    "B. Karis",
    2013,
    "Real Shading in Unreal Engine 4, SIGGRAPH course",
    "https://blog.selfshadow.com/publications/s2013-shading-course/",
)
BURLEY = Source(
    "B. Burley",
    2012,
    "Physically Based Shading at Disney, SIGGRAPH course",
    "https://blog.selfshadow.com/publications/s2012-shading-course/",
)
GLTF = Source(
    "Khronos Group",
    2021,
    "glTF 2.0 Specification",
    "https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html",
)
FILAMENT = Source(
    "R. Guy and M. Agopian",
    2018,
    "Physically Based Rendering in Filament",
    "https://google.github.io/filament/Filament.md.html",
)
UNREAL = Source(
    "Epic Games",
    2014,
    "Unreal Engine 4, Engine/Shaders/Private/BRDF.ush",
    "https://github.com/EpicGames/UnrealEngine",
)
KUTZ = Source(
    "P. Kutz, M. Hašan and D. Edmondson",
    2021,
    "Novel Aspects of the Adobe Standard Material",
    "https://helpx.adobe.com/content/dam/substance-3d/general-knowledge/asm/"
    "Adobe%20Standard%20Material%20-%20Technical%20Documentation%20-%20May2023.pdf",
)
GULBRANDSEN = Source(
    "O. Gulbrandsen",
    2014,
    "Artist Friendly Metallic Fresnel, Journal of Computer Graphics Techniques 3(4)",
    "https://jcgt.org/published/0003/04/03/",
)
