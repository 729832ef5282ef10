"""Decides where teams of robots should stand around an object to lift it together, each with nearly the same load.

    import evenlift
    placement = evenlift.place([(0, 0), (4, 0), (4, 3), (0, 3)], teams=2, weight=30)
    placement["robots"][0]["load"]

A polygon is a sequence of points (x, y), such as a list of pairs or a NumPy array with two columns; or a text: WKT, GeoJSON,
the thesis's format, or a share link, which also sets the defaults. Settings are keyword arguments with the names and values
of the program's options (see Settings). Invalid input raises EvenliftError.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Mapping, Optional, Sequence, Union

from . import _requests, types
from ._library import EvenliftError, answer, ask
from ._results import Candidates, Experiment, Placement
from .types import Holes, Point, Polygon, PoseFormat, PoseOrigin, Settings

if TYPE_CHECKING:
    from typing_extensions import Unpack
else:
    try:
        from typing import Unpack
    except ImportError:  # before Python 3.11: hints resolve to the settings themselves
        Unpack = {Settings: Settings}

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
    "place",
    "poses",
    "svg",
    "types",
    "version",
]


def place(
    polygon: Polygon,
    *,
    holes: Optional[Holes] = None,
    centre_of_mass: Optional[Point] = None,
    candidates: bool = False,
    failures: bool = False,
    even_out: bool = False,
    require: Optional[str] = None,
    **settings: Unpack[Settings],
) -> Placement:
    """Places robots under the object, or judges `supports` that already stand. `candidates` also lists the candidate chords, and
    `failures` the effect of each failure. `even_out` moves two or three supports so that all carry the same load. `require` contains
    conditions such as "held, max<=20"; the result lists under `requirements` which are kept."""
    asked = _requests.request(polygon, holes, centre_of_mass, settings, also=("candidates", "failures", "even_out", "require"))
    if candidates:
        asked["candidates"] = True
    if failures:
        asked["failures"] = True
    if even_out:
        asked["even_out"] = True
    if require is not None:
        asked["require"] = _requests.text("require", require)
    return Placement(asked)


def candidates(
    polygon: Polygon, *, holes: Optional[Holes] = None, centre_of_mass: Optional[Point] = None, **settings: Unpack[Settings]
) -> Candidates:
    """The chords on which a team may stand, as a list of {"ends", "ratio", "kind"}. Only these settings have an effect: min_ratio,
    centre_of_mass, positions, the robots' size and no_go, and clear with positions="range"."""
    return Candidates({"command": "candidates", **_requests.request(polygon, holes, centre_of_mass, settings)})


def svg(
    polygon: Polygon,
    *,
    holes: Optional[Holes] = None,
    centre_of_mass: Optional[Point] = None,
    candidates: bool = False,
    **settings: Unpack[Settings],
) -> str:
    """The placement as a picture, which also opens in evenlift's page."""
    asked = _requests.request(polygon, holes, centre_of_mass, settings, also=("candidates",))
    picture: str = ask({"command": "svg", **asked, "candidates": bool(candidates)})["svg"]
    return picture


def poses(
    polygon: Polygon,
    *,
    format: PoseFormat = "json",
    frame: str = "object",
    origin: PoseOrigin = "file",
    holes: Optional[Holes] = None,
    centre_of_mass: Optional[Point] = None,
    **settings: Unpack[Settings],
) -> str:
    """The robots' poses as the text of a file; YAML is a geometry_msgs/msg/PoseArray of ROS 2."""
    asked = _requests.request(polygon, holes, centre_of_mass, settings, also=("format", "frame", "origin"))
    text: str = ask({"command": "poses", **asked, **_requests.pose_options(format, frame, origin)})["poses"]
    return text


def link(
    polygon: Polygon, *, holes: Optional[Holes] = None, centre_of_mass: Optional[Point] = None, **settings: Unpack[Settings]
) -> str:
    """The share link of the polygon with its settings."""
    fragment: str = ask({"command": "link", **_requests.request(polygon, holes, centre_of_mass, settings)})["link"]
    return fragment


def experiment(
    polygons: Union[Mapping[str, Polygon], Sequence[Polygon]],
    *,
    min_ratio: float = 0.8,
    samples: int = 200,
    max_teams: int = 1000,
    max_balanced: int = 12,
) -> Experiment:
    """Measures every method with every number of robots on each polygon, like `evenlift experiment`. A polygon with 30 candidates
    takes some seconds. A mapping gives the polygons names; otherwise they have numbers. A polygon that cannot be measured is
    omitted, with the reason in `refused`."""
    named = polygons.items() if isinstance(polygons, Mapping) else ((f"polygon {i}", p) for i, p in enumerate(polygons, 1))
    settings = {"min_ratio": min_ratio, "samples": samples, "max_teams": max_teams, "max_balanced": max_balanced}
    asked = {"command": "experiment", "polygons": _requests.named_shapes(named), "settings": _requests.values(settings)}
    return Experiment(asked)


def version() -> str:
    """The version of the library in this package."""
    number: str = ask({"command": "version"})["version"]
    return number


__version__ = version()
