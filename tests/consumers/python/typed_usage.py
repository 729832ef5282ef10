"""Typed code of users: neither mypy nor pyright complains about any of it. check_types.py runs them."""

from __future__ import annotations

from typing import Any, Literal, Optional, Union

import evenlift
import numpy
from evenlift import Candidates, EvenliftError, Experiment, Placement, Settings, types
from typing_extensions import assert_type

plate = [(0, 0), (4, 0), (4, 1.5), (1.5, 1.5), (1.5, 3), (0, 3)]


def polygons_of_all_kinds() -> None:
    evenlift.place("POLYGON ((0 0, 4 0, 4 3, 0 0))")
    evenlift.place([[0, 0], [4.5, 0], [4, 3]], centre_of_mass=[1, 1])
    evenlift.place(((0, 0), (4, 0), (4, 3)), centre_of_mass=(1, 1.5))
    evenlift.place(zip([0, 4, 4], [0, 0, 3]))
    array = numpy.array(plate)
    evenlift.place(array, centre_of_mass=array.mean(axis=0))
    evenlift.experiment({"plate": plate, "text": "(0,0)", "array": array}, samples=5)
    evenlift.experiment([plate, array])


def settings_of_all_kinds() -> None:
    evenlift.place(plate, teams="max", metric="circle", min_ratio=0.7, weight=30, seed=7, goal="hold", positions="range", clear=0.1)
    evenlift.place(plate, metric="balanced", robots=5, min_margin=0.1, apart=None, survive=1, candidates=True, failures=True)
    evenlift.place(plate, robot="r=1", robot_gap=0.5, no_go="1,2:0-0.5", com_radius=1, capacity="none", unit="mm", weight_unit="lb")
    several: Settings = {"teams": 2, "weight": 30.5, "metric": "distance", "step": "none", "overlays": "hull"}
    assert_type(evenlift.link(plate, **several), str)
    assert_type(evenlift.poses(plate, format="yaml", frame="map", origin="com", **several), str)
    assert_type(evenlift.svg(plate, candidates=True, **several), str)
    assert_type(evenlift.version(), str)
    assert_type(evenlift.answer("{}"), str)


def placement() -> None:
    placed = evenlift.place(plate)
    assert_type(placed, Placement)
    assert_type(placed.json, str)
    assert_type(placed.svg(), str)
    for robot in placed["robots"]:
        assert_type(robot, types.Robot)
        assert_type(robot["load"], Optional[float])
        assert_type(robot["at"], list[float])
        assert_type(robot["team"], int)
    assert_type(placed["closure"]["margin"], Optional[float])
    assert_type(placed["closure"]["clearance"], Optional[float])
    assert_type(placed["closure"]["tolerance"], Optional[float])
    assert_type(placed["closure"]["free"], list[Literal["clockwise", "counterclockwise", "translation"]])
    loads = placed["loads"]
    if loads is not None:
        assert_type(loads["max_share"], float)
        if loads["models"] is not None:
            assert_type(loads["models"]["springs"], list[float])
    assert_type(placed["failures"][0]["best_max"], Optional[float])
    assert_type(placed["capacity"]["overloaded"], list[int])
    robustness = placed["robustness"]
    if "plan_ranges" in robustness:
        assert_type(robustness["plan_ranges"], list[list[float]])
    assert_type(placed.get("unusable"), Optional[list[list[Union[float, types.UnusableReason]]]])
    number_of_teams: int = placed["requested_teams"]
    print(number_of_teams)
    placed.arrays()["load"].sum()


def read_from_a_file(content: types.PlacementDict) -> float:
    return (content["teams"][0]["loads"][0] or 0) + content["weight"]


def candidates() -> None:
    chords = evenlift.candidates(plate, min_ratio=0.9)
    assert_type(chords, Candidates)
    assert_type(chords[0], types.Candidate)
    assert_type(chords[0]["kind"], Literal["bisecting", "vertex", "midpoint", "range"])
    chords.arrays()["ends"].mean()


def experiment() -> None:
    measured = evenlift.experiment([plate], samples=1, max_teams=1, max_balanced=2)
    assert_type(measured, Experiment)
    assert_type(measured["measurements"][0]["coverage"], float)
    assert_type(measured["aggregates"][0]["spread_sd"], Optional[float])
    assert_type(measured["refused"][0]["problem"], str)
    assert_type(measured["claims"]["rows"][0]["ours"], list[str])
    assert_type(measured.csv("polygons"), str)
    measured.arrays("aggregates")["coverage_mean"].mean()


def errors() -> Optional[str]:
    try:
        evenlift.place(plate)
    except EvenliftError as error:
        assert_type(error.code, str)
        assert_type(error.place, Optional[types.Place])
        if error.place is not None and "setting" in error.place:
            return error.place["setting"]
    return None


def passed_on(polygon: types.Polygon, **settings: Any) -> Placement:
    return evenlift.place(polygon, **settings)
