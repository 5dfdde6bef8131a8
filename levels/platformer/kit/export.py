"""From Blender's scene to the .glb, with extras as plain JSON."""

import json
import math
import struct

import bpy


def file_axes(p):
    """Blender's +Z up to the file's +Y up."""
    return [round(p[0], 4) + 0.0, round(p[2], 4) + 0.0, round(-p[1], 4) + 0.0]


def displayed(colour):
    return [int(colour[i:i + 2], 16) / 255 for i in (1, 3, 5)]


def linear(c):
    return c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4


def material_of(name, values):
    made = bpy.data.materials.get(name)
    if made is None:
        made = bpy.data.materials.new(name)
        made.use_nodes = True
        shown = displayed(values["colour"])
        shader = made.node_tree.nodes["Principled BSDF"]
        shader.inputs["Base Color"].default_value = (*[linear(c) for c in shown], 1)
        shader.inputs["Roughness"].default_value = 0.9
        extras = {**values, "colour": [round(c, 3) for c in shown]}
        made["surefoot"] = json.dumps(extras)
    return made


def link_node(name, data, place, heading, extras):
    node = bpy.data.objects.new(name, data)
    node.location = place
    node.rotation_euler = (0, 0, math.radians(heading))
    if extras:
        node["surefoot"] = json.dumps(extras)
    bpy.context.scene.collection.objects.link(node)


def finish_file(target):
    bpy.ops.export_scene.gltf(filepath=target, export_format="GLB", export_extras=True, export_yup=True,
                              export_normals=False, export_texcoords=False, export_colors=False,
                              export_animations=False, export_skins=False, export_morph=False)
    unfold_extras(target)


def unfold_extras(target):
    """Blender's properties hold no lists of lists, so extras go through it as JSON text; here they become JSON."""
    with open(target, "rb") as file:
        data = file.read()
    length = struct.unpack_from("<I", data, 12)[0]
    tree, rest = json.loads(data[20:20 + length]), data[20 + length:]
    for thing in tree["nodes"] + tree["materials"]:
        if "surefoot" in thing.get("extras", {}):
            thing["extras"] = {"surefoot": json.loads(thing["extras"]["surefoot"])}
    text = json.dumps(tree, separators=(",", ":"), ensure_ascii=False).encode()
    text += b" " * (-len(text) % 4)
    with open(target, "wb") as file:
        file.write(struct.pack("<4sII", b"glTF", 2, 20 + len(text) + len(rest)))
        file.write(struct.pack("<I4s", len(text), b"JSON") + text + rest)
