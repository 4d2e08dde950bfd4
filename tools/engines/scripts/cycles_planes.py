"""Cycles, as the Python module bpy: a mirror-smooth plane under a white world, EXR pixels read back."""

from __future__ import annotations

import json
import math
import sys
import tempfile
from pathlib import Path
from typing import Any

import bpy

SAMPLES = 64


def ways(medium: dict[str, Any]) -> dict[str, tuple[str, str | None, dict[str, Any]]]:
    """Return nodes, their modes and what is typed in, by the way in which a medium is entered."""
    if not medium["metal"]:
        typed = {"Base Color": [0, 0, 0], "IOR": medium["n"][0], "Roughness": 0}
        return {"Principled BSDF": ("ShaderNodeBsdfPrincipled", None, typed)}
    color, tint = medium["F0"], medium["tint"]
    f82 = {"Base Color": color, "Edge Tint": tint, "Roughness": 0}
    metallic = "ShaderNodeBsdfMetallic"
    principled = {"Base Color": color, "Metallic": 1, "Specular Tint": tint, "Roughness": 0}
    return {
        "Metallic BSDF, F82 Tint": (metallic, "F82", f82),
        "Metallic BSDF, Physical Conductor": (
            metallic,
            "PHYSICAL_CONDUCTOR",
            {"IOR": medium["n"], "Extinction": medium["k"], "Roughness": 0},
        ),
        "Principled BSDF": ("ShaderNodeBsdfPrincipled", None, principled),
    }


def empty_scene() -> Any:
    """Return a scene with a plane at the origin, a white world and an orthographic camera."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.samples = SAMPLES
    scene.cycles.use_adaptive_sampling = False
    scene.cycles.use_denoising = False
    scene.cycles.max_bounces = 1
    scene.render.resolution_x = scene.render.resolution_y = 4
    scene.render.resolution_percentage = 100
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.view_settings.view_transform = "Raw"
    scene.world = bpy.data.worlds.new("white")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (1, 1, 1, 1)
    bpy.ops.mesh.primitive_plane_add(size=1000)
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.data.type = "ORTHO"
    camera.data.ortho_scale = 0.01
    scene.collection.objects.link(camera)
    scene.camera = camera
    return scene


def material(node_type: str, mode: str | None, typed: dict[str, Any]) -> Any:
    """Return a material of one node."""
    made = bpy.data.materials.new("m")
    made.use_nodes = True
    nodes = made.node_tree.nodes
    nodes.clear()
    node = nodes.new(node_type)
    if mode:
        node.fresnel_type = mode  # inputs of the other mode are not to be had by name
    for name, value in typed.items():
        socket = node.inputs[name]
        socket.default_value = (*value, 1) if socket.type == "RGBA" else value
    out = nodes.new("ShaderNodeOutputMaterial")
    made.node_tree.links.new(node.outputs[0], out.inputs["Surface"])
    return made


def reflectance(scene: Any, path: Path, degrees: float) -> list[float]:
    """Render from one angle, and return the mean of the pixels by channel."""
    theta = math.radians(degrees)
    scene.camera.location = (10 * math.sin(theta), 0, 10 * math.cos(theta))
    scene.camera.rotation_euler = (0, theta, 0)
    scene.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(str(path))
    pixels = list(image.pixels)
    bpy.data.images.remove(image)
    return [sum(pixels[c::4]) / (len(pixels) // 4) for c in range(3)]


def main() -> None:
    """Answer the questions on standard input."""
    asked = json.load(sys.stdin)
    scene = empty_scene()
    plane = bpy.context.object
    path = Path(tempfile.mkdtemp()) / "seen.exr"
    curves = []
    entered = [
        (medium["name"], way, *node)
        for medium in asked["media"]
        for way, node in ways(medium).items()
    ]
    principled = "ShaderNodeBsdfPrincipled"
    entered += [("settings", way, principled, None, typed) for way, typed in asked["settings"]]
    for name, way, node_type, mode, typed in entered:
        plane.data.materials.clear()
        plane.data.materials.append(material(node_type, mode, typed))
        rows = [reflectance(scene, path, degrees) for degrees in asked["theta_i_deg"]]
        curves.append(
            {
                "medium": name,
                "light": "environment",
                "way": way,
                "typed": typed,
                "reflectance": rows,
            }
        )
    print("\n" + json.dumps(curves))


main()
