"""Reads the robots' poses with third-party readers: CSV, JSON, and YAML, checked for the shape of a ROS 2 message.

    EVENLIFT_BUILD=build/native EVENLIFT_PROGRAM=build/bin/evenlift python3 tests/consumers/check_poses.py
"""

import csv
import json
import math
import sys

import yaml
from installed import expect, main, program, run, samples

# geometry_msgs/msg/PoseArray as `ros2 interface show` prints it.
pose_array = {
    "header": {"stamp": {"sec": int, "nanosec": int}, "frame_id": str},
    "poses": [{"position": {"x": float, "y": float, "z": float}, "orientation": {"x": float, "y": float, "z": float, "w": float}}],
}
metres = {None: 1, "m": 1, "cm": 0.01, "mm": 0.001, "in": 0.0254}


def check_shape(value, shape, where):
    if isinstance(shape, dict):
        expect(isinstance(value, dict) and value.keys() == shape.keys(), f"{where} has other members: {value}")
        for name in shape:
            check_shape(value[name], shape[name], f"{where}.{name}")
    elif isinstance(shape, list):
        expect(isinstance(value, list), f"{where} is no list")
        for i, item in enumerate(value):
            check_shape(item, shape[0], f"{where}[{i}]")
    else:
        expect(type(value) is shape, f"{where} is {value!r}, no {shape.__name__}")


def near(a, b, scale=1.0):
    return abs(a - b) <= 1e-12 * scale


def poses_of(folder, sample, ending, *options):
    file = folder / f"poses{ending}"
    answer = json.loads(run(program, "place", sample, "--json", "--poses", file, *options))
    return file.read_text(), answer


def check_table(text, answer, unit):
    rows = list(csv.DictReader(text.splitlines()))
    expect(len(rows) == len(answer["robots"]), "the table has another number of robots")
    for i, (row, robot) in enumerate(zip(rows, answer["robots"])):
        expect((int(row["robot"]), int(row["team"])) == (i + 1, robot["team"] + 1), f"row {i}: {row}")
        expect([float(row["x"]), float(row["y"])] == robot["stand"], f"row {i}: another place")
        expect((float(row["heading_deg"]), float(row["load"])) == (robot["heading"], robot["load"]), f"row {i}: {row}")
        expect((row["unit"], row["weight_unit"]) == (unit or "", "kg"), f"row {i}: {row}")


def check_json(text, answer, unit):
    poses = json.loads(text)
    expect((poses["frame"], poses["origin"], poses["unit"], poses["weight_unit"]) == ("table/1", "com", unit, "kg"), "JSON: heading")
    centre = answer["centre_of_mass"]
    for got, robot in zip(poses["robots"], answer["robots"], strict=True):
        expect([got["x"], got["y"]] == [robot["stand"][0] - centre[0], robot["stand"][1] - centre[1]], "JSON: another place")
        angle = math.radians(robot["heading"])
        expect(near(got["direction"][0], math.cos(angle)) and near(got["direction"][1], math.sin(angle)), "JSON: another direction")


def check_message(text, answer, unit, frame):
    message = yaml.safe_load(text)
    check_shape(message, pose_array, "PoseArray")
    expect(message["header"]["frame_id"] == frame, "another frame")
    size = max(abs(x) for point in answer["polygon"] for x in point)
    for pose, robot in zip(message["poses"], answer["robots"], strict=True):
        at, turn = pose["position"], pose["orientation"]
        for axis, here in zip("xy", robot["stand"]):
            expect(near(at[axis], here * metres[unit], size * metres[unit]), f"{axis} is {at[axis]}, not {here} {unit}")
        expect((at["z"], turn["x"], turn["y"]) == (0, 0, 0), "it leaves the plane")
        # The quaternion's rotation of (1, 0, 0), by the general formula.
        w, z = turn["w"], turn["z"]
        angle = math.radians(robot["heading"])
        expect(near(w * w - z * z, math.cos(angle)) and near(2 * w * z, math.sin(angle)), f"another heading: {robot}")
        expect(near(w * w + z * z, 1), "no unit quaternion")
    comments = [line for line in text.splitlines() if "carries" in line]
    loads = [f"carries {robot['load']:.12g} kg" for robot in answer["robots"]]
    expect(len(comments) == len(loads), "a robot has no comment")


def check(folder):
    robots = 0
    for i, sample in enumerate(samples):
        unit = [None, "m", "cm", "mm", "in"][i % 5]
        options = ["--metric", ["area", "distributed", "balanced"][i % 3]] + (["--unit", unit] if unit else [])
        check_table(*poses_of(folder, sample, ".csv", *options), unit)
        check_json(*poses_of(folder, sample, ".json", *options, "--origin", "com", "--frame", "table/1"), unit)
        text, answer = poses_of(folder, sample, ".yaml", *options)
        check_message(text, answer, unit, "object")
        robots += len(answer.get("robots", []))
    expect(robots > 300, "hardly any robots")
    text, _ = poses_of(folder, samples[0], ".yaml", "--frame", "map")
    expect(yaml.safe_load(text)["header"]["frame_id"] == "map", "the frame is not the one given")
    return f"{len(samples)} samples, {robots} robots"


sys.exit(main(check))
