"""Decides where teams of robots should stand around an object to lift it together, each with nearly the same load.

    import evenlift
    placement = evenlift.place([(0, 0), (4, 0), (4, 3), (0, 3)], teams=2, weight=30)
    placement["robots"][0]["load"]

A polygon is a sequence of points (x, y), such as a list of pairs or a NumPy array with two columns; a file, as its text, its
bytes or its path, of any format that the program reads, or a share link; a result or document of evenlift; or an object of a
geometry library (`__geo_interface__`). Settings are keyword arguments with the names and values of the program's options (see
types.Settings). Invalid input raises EvenliftError.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Mapping, Sequence, Union

from . import types
from ._library import EvenliftError, answer, ask, file_members, polygon_members, written
from ._results import Candidates, Experiment, Placement
from .types import ExperimentOptions, File, Options, PartsOptions, PlaceOptions, Polygon, PosesOptions, Settings, ShapesOptions, SvgOptions

if TYPE_CHECKING:
    from typing_extensions import Unpack
else:
    try:
        from typing import Unpack
    except ImportError:  # before Python 3.11: hints resolve to the options themselves

        class Unpack:
            def __class_getitem__(cls, options):
                return options


__all__ = [
    "Candidates",
    "EvenliftError",
    "Experiment",
    "Placement",
    "Settings",
    "answer",
    "candidates",
    "experiment",
    "link",
    "optimum",
    "parts",
    "place",
    "poses",
    "shapes",
    "svg",
    "trace",
    "types",
    "version",
]


def place(polygon: Polygon, **options: Unpack[PlaceOptions]) -> Placement:
    """Places robots under the object, or judges `supports` that already stand. `candidates` also lists the candidate chords, and
    `failures` the effect of each failure. `even_out` moves two or three supports so that all carry the same load. `require` contains
    conditions such as "held, max<=20"; the result lists under `requirements` which are kept."""
    return Placement(written({**options, "command": "place", **polygon_members(polygon)}))


def candidates(polygon: Polygon, **options: Unpack[Options]) -> Candidates:
    """The chords on which a team may stand, as a list of {"ends", "ratio", "kind"}. Only these settings have an effect: min_ratio,
    centre_of_mass, positions, the robots' size and no_go, and clear with positions="range"."""
    return Candidates(written({**options, "command": "candidates", **polygon_members(polygon)}))


def svg(polygon: Polygon, **options: Unpack[SvgOptions]) -> str:
    """The placement as a picture, which also opens in evenlift's page. `candidates` shows the candidates."""
    picture: str = ask({**options, "command": "svg", **polygon_members(polygon)})["svg"]
    return picture


def poses(polygon: Polygon, **options: Unpack[PosesOptions]) -> str:
    """The robots' poses as the text of a file; YAML is a geometry_msgs/msg/PoseArray of ROS 2."""
    text: str = ask({**options, "command": "poses", **polygon_members(polygon)})["poses"]
    return text


def link(polygon: Polygon, **options: Unpack[Options]) -> str:
    """The share link of the polygon with its settings."""
    fragment: str = ask({**options, "command": "link", **polygon_members(polygon)})["link"]
    return fragment


def optimum(polygon: Polygon, **options: Unpack[Options]) -> types.Optimum:
    """How far the greedy choice of teams is from the best one."""
    compared: types.Optimum = ask({**options, "command": "optimum", **polygon_members(polygon)})
    return compared


def trace(polygon: Polygon, **options: Unpack[Options]) -> list[dict[str, Any]]:
    """The algorithm's steps in order, in words and with this polygon's numbers, as `evenlift trace --json` prints them."""
    steps: list[dict[str, Any]] = ask({**options, "command": "trace", **polygon_members(polygon)})["steps"]
    return steps


def shapes(file: File, **options: Unpack[ShapesOptions]) -> types.Shapes:
    """All shapes of a file: a drawing, a table, or any other format that the program reads. The `document` of each is a polygon for
    the other functions."""
    read: types.Shapes = ask({**options, "command": "shapes", **file_members(file)})
    return read


def parts(file: File, **options: Unpack[PartsOptions]) -> types.Parts:
    """Places robots on each shape of a file. With `weight_per_area`, or with `thickness` and `density`, each has a weight by its area;
    with a `capacity`, the number of robots that it needs. `parts` is a list of placements, and of reasons why shapes were refused; `csv`
    is the same as a table."""
    placed: types.Parts = ask({**options, "command": "parts", **file_members(file)})
    return placed


def experiment(polygons: Union[Mapping[str, Polygon], Sequence[Polygon]], **settings: Unpack[ExperimentOptions]) -> Experiment:
    """Measures every method with every number of robots on each polygon, like `evenlift experiment`. A polygon with 30 candidates
    takes some seconds. A mapping gives the polygons names; otherwise they have numbers. A polygon that cannot be measured is
    omitted, with the reason in `refused`."""
    named = polygons.items() if isinstance(polygons, Mapping) else ((f"polygon {i}", p) for i, p in enumerate(polygons, 1))
    measured = [{"name": str(name), **polygon_members(polygon)} for name, polygon in named]
    return Experiment(written({"command": "experiment", "polygons": measured, "settings": settings}))


def version() -> str:
    """The version of the library in this package."""
    number: str = ask({"command": "version"})["version"]
    return number


__version__ = version()
