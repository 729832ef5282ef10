"""Where teams of robots should stand round an object so that they lift it together, each with nearly the same load.

    import evenlift
    placement = evenlift.place([(0, 0), (4, 0), (4, 3), (0, 3)], teams=2, weight=30)
    placement["robots"][0]["load"]

A polygon is a sequence of points (x, y), such as a list of pairs or a NumPy array of two columns; or a text: WKT, GeoJSON,
the thesis's format, or a share link, whose settings then count, too. Settings are keyword arguments with the names and
values of the program's options (see Settings). What is wrong with them raises EvenliftError.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal, Mapping, Optional, Sequence, TypedDict, Union

from ._library import EvenliftError, answer, ask
from ._results import Candidates, Experiment, Placement

if TYPE_CHECKING:
    from typing_extensions import Unpack

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
    "version",
]

Point = Sequence[float]
Polygon = Union[str, Sequence[Point], Any]  # Any stands for NumPy's arrays


class Settings(TypedDict, total=False):
    """What may be set; docs/cli.md of the repository tells more of each. None means as usual."""

    teams: Union[int, Literal["max"], None]
    metric: Literal["area", "circle", "distance", "distributed", "random", "balanced", None]
    min_ratio: Optional[float]
    weight: Optional[float]
    seed: Optional[int]
    robots: Optional[int]
    goal: Literal["cover", "hold", None]
    min_margin: Optional[float]
    apart: Optional[float]
    survive: Optional[int]
    positions: Literal["best", "range", None]
    robot: Optional[str]
    robot_radius: Optional[float]
    robot_reach: Optional[float]
    robot_depth: Optional[float]
    robot_width: Optional[float]
    robot_gap: Optional[float]
    no_go: Optional[str]
    com_radius: Optional[float]
    capacity: Optional[float]
    overlays: Optional[str]
    unit: Literal["m", "cm", "mm", "in", "none", None]
    weight_unit: Literal["kg", "t", "N", "lb", None]


def _shape(polygon: Polygon) -> dict[str, Any]:
    """The members of a request that say what the polygon is."""
    if isinstance(polygon, str):
        return {"text": polygon}
    return {"polygon": [[float(x), float(y)] for x, y in polygon]}


def _request(polygon: Polygon, centre_of_mass: Optional[Point], settings: Mapping[str, Any]) -> dict[str, Any]:
    request = _shape(polygon)
    if centre_of_mass is not None:
        x, y = centre_of_mass
        request["centre_of_mass"] = [float(x), float(y)]
    request["settings"] = {name: _plain(value) for name, value in settings.items()}
    return request


def _plain(value: Any) -> Any:
    """NumPy's numbers as Python's."""
    return value.item() if hasattr(value, "item") else value


def place(
    polygon: Polygon,
    *,
    centre_of_mass: Optional[Point] = None,
    candidates: bool = False,
    failures: bool = False,
    **settings: Unpack[Settings],
) -> Placement:
    """Places robots under the object. `candidates` lists the candidate chords, too, and `failures` what happens if a robot fails."""
    request = _request(polygon, centre_of_mass, settings)
    if candidates:
        request["candidates"] = True
    if failures:
        request["failures"] = True
    return Placement(request)


def candidates(polygon: Polygon, *, centre_of_mass: Optional[Point] = None, **settings: Unpack[Settings]) -> Candidates:
    """The chords on which a team may stand, as a list of {"ends", "ratio", "kind"}: at the best places and as points. Of the
    settings only min_ratio and the centre of mass count."""
    return Candidates({"command": "candidates", **_request(polygon, centre_of_mass, settings)})


def svg(polygon: Polygon, *, centre_of_mass: Optional[Point] = None, candidates: bool = False, **settings: Unpack[Settings]) -> str:
    """The placement as a picture, which also opens in evenlift's page."""
    return ask({"command": "svg", **_request(polygon, centre_of_mass, settings), "candidates": candidates})["svg"]


def poses(
    polygon: Polygon,
    *,
    format: Literal["csv", "json", "yaml"] = "json",
    frame: str = "object",
    origin: Literal["file", "com"] = "file",
    centre_of_mass: Optional[Point] = None,
    **settings: Unpack[Settings],
) -> str:
    """The robots' poses as the text of a file; YAML is a geometry_msgs/msg/PoseArray of ROS 2."""
    request = _request(polygon, centre_of_mass, settings)
    return ask({"command": "poses", **request, "format": format, "frame": frame, "origin": origin})["poses"]


def link(polygon: Polygon, *, centre_of_mass: Optional[Point] = None, **settings: Unpack[Settings]) -> str:
    """The share link of the polygon with its settings."""
    return ask({"command": "link", **_request(polygon, centre_of_mass, settings)})["link"]


def experiment(
    polygons: Union[Mapping[str, Polygon], Sequence[Polygon]],
    *,
    min_ratio: float = 0.8,
    samples: int = 200,
    max_teams: int = 1000,
    max_balanced: int = 12,
) -> Experiment:
    """Measures every method with every number of robots on each polygon, as `evenlift experiment` does. It takes long: a polygon
    with 30 candidates some seconds. Polygons have their names in a mapping, and else numbers. One that cannot be measured is left
    out, and `refused` says why."""
    named = polygons.items() if isinstance(polygons, Mapping) else ((f"polygon {i}", p) for i, p in enumerate(polygons, 1))
    asked = [{"name": name, **_shape(polygon)} for name, polygon in named]
    settings = {"min_ratio": min_ratio, "samples": samples, "max_teams": max_teams, "max_balanced": max_balanced}
    return Experiment({"command": "experiment", "polygons": asked, "settings": {k: _plain(v) for k, v in settings.items()}})


def version() -> str:
    """The version of the library inside."""
    return ask({"command": "version"})["version"]


__version__ = version()
