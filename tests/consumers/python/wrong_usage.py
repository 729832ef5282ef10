"""Mistakes that mypy and pyright find, on exactly the lines marked "wrong". check_types.py runs them."""

from __future__ import annotations

import evenlift
from evenlift import types

plate = [(0, 0), (4, 0), (4, 1.5), (1.5, 1.5), (1.5, 3), (0, 3)]

evenlift.place()  # wrong
evenlift.place(3)  # wrong
evenlift.place([1, 2, 3])  # wrong
evenlift.place(["(0,0)"])  # wrong
evenlift.place(plate, team=3)  # wrong
evenlift.place(plate, teams="all")  # wrong
evenlift.place(plate, metric="best")  # wrong
evenlift.place(plate, weight="heavy")  # wrong
evenlift.place(plate, unit="kg")  # wrong
evenlift.place(plate, centre_of_mass=3)  # wrong
evenlift.link(plate, candidates=True)  # wrong
evenlift.poses(plate, format="xml")  # wrong
evenlift.experiment([plate], sample=3)  # wrong

placed = evenlift.place(plate)
placed["robot_s"]  # wrong
placed["robots"][0]["loads"]  # wrong
placed["closure"]["margin"] + 1  # wrong
placed["loads"]["max"]  # wrong
placed["hull"].x  # wrong
load: str = placed["robots"][0]["load"]  # wrong
goal: types.Goal = placed["metric"]  # wrong
placed.get("robots")[0]  # wrong
evenlift.candidates(plate)[0]["end"]  # wrong
measured = evenlift.experiment([plate])
measured["measured"]  # wrong
measured["polygons"][0]["edges"]  # wrong
measured.csv("figures")  # wrong


def code(error: evenlift.EvenliftError) -> int:
    return error.code  # wrong
