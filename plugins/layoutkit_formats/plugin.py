"""What this package adds: the formats of annotations and of scenes that `convert` reads."""

from __future__ import annotations

from collections.abc import Iterable

from layoutkit.hooks.specs import Format, SceneFormat, hookimpl


@hookimpl
def layoutkit_formats() -> Iterable[Format]:
    """Return the readers of annotations."""
    from layoutkit_formats.cmp import CmpFormat
    from layoutkit_formats.masks import MaskFormat

    return [CmpFormat(), MaskFormat()]


@hookimpl
def layoutkit_scene_formats() -> Iterable[SceneFormat]:
    """Return the readers of scenes."""
    from layoutkit_formats.scenes.cmp import CmpScenes
    from layoutkit_formats.scenes.geojson import GeoJsonFormat
    from layoutkit_formats.scenes.geopackage import GeoPackageFormat
    from layoutkit_formats.scenes.procthor import ProcThorFormat
    from layoutkit_formats.scenes.resplan import ResPlanFormat
    from layoutkit_formats.scenes.svg import SvgFormat
    from layoutkit_formats.scenes.wkt import WktFormat

    return [
        GeoJsonFormat(),
        SvgFormat(),
        WktFormat(),
        GeoPackageFormat(),
        CmpScenes(),
        ProcThorFormat(),
        ResPlanFormat(),
    ]
