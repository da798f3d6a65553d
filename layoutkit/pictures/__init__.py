"""Pictures of facades and layouts: PNG from the photo or by labels, SVG, models, and contact sheets.

>>> photo = Photo.open(facade, folder)                        # decoded once
>>> image = render_png(layout, photo)                         # any number of layouts
>>> sheet = contact_sheet(
...     Exhibit(photo.image, facade.name, facade.root.width, facade.root.height, facade.units),
...     [Exhibit(image, layout.name, layout.root.width, layout.root.height, layout.units)],
... )
>>> path.write_bytes(png_bytes(sheet))
"""

from layoutkit.pictures.glb import render_glb
from layoutkit.pictures.photo import Photo
from layoutkit.pictures.png import png_bytes, render_png
from layoutkit.pictures.sheet import Exhibit, contact_sheet
from layoutkit.pictures.svg import render_svg

__all__ = ["Exhibit", "Photo", "contact_sheet", "png_bytes", "render_glb", "render_png", "render_svg"]
