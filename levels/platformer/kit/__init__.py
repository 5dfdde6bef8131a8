"""The kit from which the platformer's levels are built, in Blender 3.4."""

from .level import Level

__all__ = ["Level"]
