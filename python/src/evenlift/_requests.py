"""Makes requests from the arguments of a function. The core's errors refer to places in a request, which the caller of a function
never wrote. So errors that the core would report with a line and a column are detected here, with the setting or the place."""

from __future__ import annotations

import difflib
import math
import re
import sys
from typing import Any, Iterable, Mapping, Optional, get_args

from ._library import EvenliftError
from .types import Holes, Place, Point, Polygon, PoseFormat, PoseOrigin, Settings

_most_vertices = 1048576
_most_polygons = 10000
_lists = ("supports", "support_capacities", "cargo")
_frame = re.compile(r"[A-Za-z0-9_.-][A-Za-z0-9_./-]{0,254}")


def _bad_setting(name: str, message: str) -> EvenliftError:
    return EvenliftError(message, "bad_setting", {"setting": name})


# --- Texts


def _broken_at(text: str) -> Optional[int]:
    """The index of half a surrogate pair, which UTF-8 cannot contain."""
    try:
        text.encode("utf-8")
    except UnicodeEncodeError as error:
        return error.start
    return None


def _polygon_text(text: str) -> str:
    at = _broken_at(text)
    if at is None:
        return text
    place: Place = {"line": text.count("\n", 0, at) + 1, "column": at - text.rfind("\n", 0, at)}
    raise EvenliftError(f"Line {place['line']}, column {place['column']}: this is half a character", "bad_syntax", place)


def text(name: str, value: Any) -> str:
    if not isinstance(value, str):
        raise _bad_setting(name, f"{name}: expected a text, not {type(value).__name__}")
    if _broken_at(value) is not None:
        raise _bad_setting(name, f"{name}: the text contains half a character")
    return value


# --- Polygons


class _NotTwoNumbers(Exception):
    pass


def _numbers(point: Any) -> list[float]:
    """The two numbers of a point, as Python floats."""
    try:
        x, y = point
        return [float(x), float(y)]
    except OverflowError:  # the core reports that it is too large
        return [sys.float_info.max, sys.float_info.max]
    except (TypeError, ValueError):
        raise _NotTwoNumbers from None


def _vertex(point: Any, index: int) -> list[float]:
    place: Place = {"vertices": [index]}
    try:
        numbers = _numbers(point)
    except _NotTwoNumbers:
        raise EvenliftError(f"Vertex {index + 1}: a point must be two numbers (x, y)", "bad_syntax", place) from None
    if not all(map(math.isfinite, numbers)):
        raise EvenliftError(f"Vertex {index + 1}: a coordinate is not a finite number", "bad_coordinate", place)
    return numbers


def _ring(points: Any, hole: int) -> list[list[float]]:
    """The vertices of a hole, counted from 1 in errors."""
    try:
        return [_numbers(point) for point in points]
    except (TypeError, _NotTwoNumbers):
        raise EvenliftError(f"Hole {hole}: expected points of two numbers (x, y)", "bad_syntax", {"rings": [hole]}) from None


def _holes(rings: Any) -> list[list[list[float]]]:
    try:
        each = list(rings)
    except TypeError:
        raise EvenliftError("The holes must be a sequence of sequences of points (x, y)", "bad_syntax") from None
    holes = [_ring(points, hole) for hole, points in enumerate(each, 1)]
    for hole, points in enumerate(holes, 1):
        if not all(math.isfinite(number) for point in points for number in point):
            raise EvenliftError(f"Hole {hole}: a coordinate is not a finite number", "bad_coordinate", {"rings": [hole]})
    return holes


def shape(polygon: Polygon) -> dict[str, Any]:
    """The members of a request that describe the polygon."""
    if isinstance(polygon, str):
        return {"text": _polygon_text(polygon)}
    try:
        points = list(polygon)
    except TypeError:
        raise EvenliftError("A polygon must be a sequence of points (x, y), or a text", "bad_syntax") from None
    if len(points) > _most_vertices:
        raise EvenliftError(f"The polygon has more than {_most_vertices} vertices", "too_many_vertices")
    return {"polygon": [_vertex(point, index) for index, point in enumerate(points)]}


def _centre(point: Any) -> list[float]:
    place: Place = {"centre_of_mass": True}
    try:
        numbers = _numbers(point)
    except _NotTwoNumbers:
        raise EvenliftError("The centre of mass must be two numbers (x, y)", "bad_syntax", place) from None
    if not all(map(math.isfinite, numbers)):
        raise EvenliftError("A coordinate of the centre of mass is not a finite number", "bad_coordinate", place)
    return numbers


def named_shapes(polygons: Iterable[tuple[Any, Polygon]]) -> list[dict[str, Any]]:
    """The polygons of an experiment with their names, which also appear in errors."""
    shapes: list[dict[str, Any]] = []
    for given_name, polygon in polygons:
        if len(shapes) == _most_polygons:
            raise EvenliftError(f"There are more than {_most_polygons} polygons", "unsupported")
        name = str(given_name)
        if _broken_at(name) is not None:
            raise EvenliftError(f"The name of polygon {len(shapes) + 1} contains half a character", "bad_syntax")
        try:
            shapes.append({"name": name, **shape(polygon)})
        except EvenliftError as error:
            message = str(error)
            raise EvenliftError(f"{name}: {message[0].lower()}{message[1:]}", error.code, error.place) from None
    return shapes


# --- Settings


def _number(value: Any) -> Any:
    """Any number as a Python number, for JSON."""
    if isinstance(value, int):
        return value
    return value.item() if hasattr(value, "item") else float(value)


def _support(support: Any) -> list[float]:
    """The place of a support."""
    try:
        numbers = _numbers(support)
    except _NotTwoNumbers:
        raise _bad_setting("supports", "supports: a support must be two numbers (x, y)") from None
    if not all(map(math.isfinite, numbers)):
        raise _bad_setting("supports", "supports: a coordinate is not a finite number")
    return numbers


def _parts_of_load(item: Any) -> dict[str, Any]:
    """The parts of a load by their names; of a sequence, in the order at, weight, name."""
    names = ("at", "weight", "name")
    if isinstance(item, Mapping):
        return dict(item)
    parts = list(item)
    return dict(zip(names, parts)) if len(parts) <= len(names) else {"parts": parts}


def _cargo(item: Any) -> dict[str, Any]:
    """A load: (at, weight), (at, weight, name), or a mapping with these names."""
    wrong = _bad_setting("cargo", "cargo: a load must be a place (x, y), its weight and perhaps its name")
    try:
        parts = _parts_of_load(item)
        made: dict[str, Any] = {"at": _numbers(parts.pop("at")), "weight": _value("cargo", parts.pop("weight"))}
    except (KeyError, TypeError, ValueError, _NotTwoNumbers):
        raise wrong from None
    name = parts.pop("name", None)
    if parts or isinstance(made["weight"], (str, bool, type(None))):
        raise wrong
    if not all(map(math.isfinite, made["at"])):
        raise _bad_setting("cargo", "cargo: a coordinate is not a finite number")
    return {**made, "name": text("cargo", name)} if name else made


def _list(name: str, value: Any) -> list[Any]:
    """The places of supports, their capacities, or the cargo."""
    if name == "cargo":
        return [_cargo(item) for item in value]
    return [_support(item) if name == "supports" else _value(name, item) for item in value]


def _value(name: str, value: Any) -> Any:
    """A setting's value. Values that the core refuses by the setting's name are passed on."""
    if value is None or isinstance(value, bool):
        return value
    if isinstance(value, str):
        return text(name, value)
    try:
        number = _number(value)
        finite = math.isfinite(number)
    except OverflowError:
        raise _bad_setting(name, f"{name}: the number is too large") from None
    except (TypeError, ValueError):
        raise _bad_setting(name, f"{name}: expected a number or a text, not {type(value).__name__}") from None
    if not finite:
        raise _bad_setting(name, f"{name}: {number} is not a finite number")
    return number


def _is_list(name: str, value: Any) -> bool:
    return name in _lists and not isinstance(value, str) and hasattr(value, "__iter__")


def values(settings: Mapping[str, Any]) -> dict[str, Any]:
    return {name: _list(name, value) if _is_list(name, value) else _value(name, value) for name, value in settings.items()}


def _unknown(name: str, known: list[str]) -> EvenliftError:
    message = f'There is no setting "{name}"'
    meant = difflib.get_close_matches(name.lower(), known, n=1)
    return _bad_setting(name, f'{message}; did you mean "{meant[0]}"?' if meant else message)


def request(
    polygon: Polygon,
    holes: Optional[Holes],
    centre_of_mass: Optional[Point],
    settings: Mapping[str, Any],
    also: tuple[str, ...] = (),
) -> dict[str, Any]:
    """A request without its command. `also` contains further names for suggestions, in addition to the settings'."""
    known = [*Settings.__annotations__, "holes", "centre_of_mass", *also]
    for name in settings:
        # The program calls the centre of mass "com", and the core also accepts that.
        if name not in Settings.__annotations__ and name != "com":
            raise _unknown(name, known)
    made = shape(polygon)
    if holes is not None:
        made["holes"] = _holes(holes)
    if centre_of_mass is not None:
        made["centre_of_mass"] = _centre(centre_of_mass)
    made["settings"] = values(settings)
    return made


def pose_options(format: Any, frame: Any, origin: Any) -> dict[str, Any]:
    if format not in get_args(PoseFormat):
        raise _bad_setting("format", "The format of poses must be csv, json or yaml")
    if origin not in get_args(PoseOrigin):
        raise _bad_setting("origin", "The origin of poses must be file or com")
    if not isinstance(frame, str) or not _frame.fullmatch(frame):
        raise _bad_setting("frame", "The frame must be 1 to 255 letters, digits, _, -, . and /, without / at the beginning")
    return {"format": format, "frame": frame, "origin": origin}
