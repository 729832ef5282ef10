"""Answers as plain dictionaries and lists, with additions for Python: arrays, tables, pictures."""

from __future__ import annotations

import csv
import io
import json
from typing import TYPE_CHECKING, Any, Optional, Union

from . import types
from ._library import ask, ask_for_text

if TYPE_CHECKING:
    from ._members import ExperimentMembers, PlacementMembers  # pyright: ignore[reportMissingModuleSource]
else:
    ExperimentMembers = PlacementMembers = dict


class Placement(PlacementMembers):
    """The output of `evenlift place --json` as a dictionary (docs/cli.md lists its members). `json` is its exact text."""

    def __init__(self, request: str) -> None:
        self.json = ask_for_text(request)
        self._request = request
        super().__init__(json.loads(self.json))

    def svg(self, candidates: Optional[bool] = None) -> str:
        """The placement as a picture."""
        given: dict[str, Any] = json.loads(self._request)
        asked = {name: value for name, value in given.items() if name not in ("failures", "even_out", "cases", "require")}
        listed = bool(asked.get("candidates")) if candidates is None else candidates
        picture: str = ask({**asked, "command": "svg", "candidates": listed})["svg"]
        return picture

    def _repr_svg_(self) -> str:
        return self.svg()

    def arrays(self) -> types.PlacementArrays:
        """The numbers as NumPy arrays: `polygon` and `hull` (n × 2), and in the order of the robots `at`, `stand` and `contact`
        (m × 2), `load`, `heading` in degrees, and `team`."""
        import numpy

        def points(of: list[types.Position]) -> types.FloatArray:
            return numpy.array(of, dtype=float).reshape(-1, 2)

        robots = self.get("robots") or []
        nowhere: types.Position = [float("nan"), float("nan")]  # a robot beneath the object touches nothing
        return {
            "polygon": points(self["polygon"]),
            "hull": points(self["hull"]),
            "at": points([robot["at"] for robot in robots]),
            "stand": points([robot["stand"] for robot in robots]),
            "contact": points([robot["contact"] or nowhere for robot in robots]),
            "load": numpy.array([robot["load"] for robot in robots], dtype=float),
            "heading": numpy.array([robot["heading"] for robot in robots], dtype=float),
            "team": numpy.array([robot["team"] for robot in robots], dtype=int),
        }


class Candidates(list[types.Candidate]):
    """Candidate chords in candidate order, each {"ends", "ratio", "kind"}."""

    def __init__(self, request: str) -> None:
        self.json = ask_for_text(request)
        super().__init__(json.loads(self.json)["candidates"])

    def arrays(self) -> types.CandidateArrays:
        """`ends` (n × 2 × 2) and `ratio` (n) as NumPy arrays."""
        import numpy

        ends = numpy.array([candidate["ends"] for candidate in self], dtype=float).reshape(-1, 2, 2)
        return {"ends": ends, "ratio": numpy.array([candidate["ratio"] for candidate in self], dtype=float)}


def _number(text: str) -> Union[int, float, str, None]:
    if text == "":
        return None
    try:
        return int(text)
    except ValueError:
        pass
    try:
        return float(text)
    except ValueError:
        return text


_names = {"set", "polygon", "method", "metric", "problem"}  # always text, even if a value looks like a number


class Experiment(ExperimentMembers):
    """The results of `evenlift experiment`. `measurements`, `aggregates` and `polygons` are lists of rows. Each row is a dictionary
    with the columns of the file of that name, and None for an empty field; csv() returns the files themselves."""

    def __init__(self, request: str) -> None:
        self.json = ask_for_text(request)
        content = json.loads(self.json)
        self._tables: dict[str, str] = {name: content[name] for name in ("measurements", "aggregates", "polygons")}
        for name, text in self._tables.items():
            rows = csv.DictReader(io.StringIO(text, newline=""))
            content[name] = [{k: v if k in _names else _number(v) for k, v in row.items()} for row in rows]
        super().__init__(content)

    def csv(self, table: types.Table = "measurements") -> str:
        """A table as the text of a CSV file, the same as the program writes."""
        return self._tables[table]

    def arrays(self, table: types.Table = "measurements") -> dict[str, types.Array]:
        """A table's columns as NumPy arrays; an empty field of numbers is NaN."""
        import numpy

        rows: Any = self[table]
        columns: dict[str, types.Array] = {}
        for name in next(csv.reader(io.StringIO(self._tables[table], newline=""))):
            values = [row[name] for row in rows]
            columns[name] = numpy.array(values) if name in _names else numpy.array(values, dtype=float)
        return columns
