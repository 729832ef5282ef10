"""Wrong arguments: each raises EvenliftError, which names the place of the fault and reaches every caller that
waits for it. usage.py runs these checks."""

import copy
import decimal
import json
import math
import multiprocessing
import pathlib
import pickle
import tempfile

import evenlift
import numpy

l_shape = [(0, 0), (4, 0), (4, 1.5), (1.5, 1.5), (1.5, 3), (0, 3)]
crossing = [(0, 0), (4, 4), (4, 0), (0, 4)]


def refused(call, *arguments, kind=evenlift.EvenliftError, **settings):
    try:
        call(*arguments, **settings)
    except kind as error:
        assert type(error) is kind, repr(error)
        return error
    raise AssertionError(f"{arguments} {settings} was not refused")


def with_vertex(vertex):
    return [*l_shape[:2], vertex, *l_shape[3:]]


# --- Errors travel


class Noted(evenlift.EvenliftError):
    """A third-party error, made from other arguments."""

    def __init__(self, robot):
        super().__init__(f"robot {robot} is noted", "noted", {"vertices": [robot]})
        self.robot = robot


class Both(evenlift.EvenliftError, KeyError):
    pass


def all_of(error):
    return type(error), str(error), error.args, vars(error)


def check_copies():
    """An error is the same after pickling, by every protocol, and after copying; so are errors of derived classes, and results."""
    errors = [refused(evenlift.place, crossing), refused(evenlift.place, l_shape, teams=0), Noted(3), Both("both", "noted", None)]
    for error in errors:
        copies = [pickle.loads(pickle.dumps(error, protocol)) for protocol in range(pickle.HIGHEST_PROTOCOL + 1)]
        for each in [*copies, copy.copy(error), copy.deepcopy(error)]:
            assert all_of(each) == all_of(error), repr(each)
    for result in (evenlift.place(l_shape), evenlift.candidates(l_shape), evenlift.experiment([l_shape], samples=1, max_teams=1, max_balanced=2)):
        copies = [pickle.loads(pickle.dumps(result, protocol)) for protocol in range(pickle.HIGHEST_PROTOCOL + 1)]
        for each in [*copies, copy.copy(result), copy.deepcopy(result)]:
            assert type(each) is type(result) and each == result and each.json == result.json
    assert pickle.loads(pickle.dumps(evenlift.place(l_shape))).svg() == evenlift.svg(l_shape)


def check_pools():
    """A refused polygon of a pool's map() raises for the caller that waits, however the processes begin."""
    expected = refused(evenlift.place, crossing)
    for way in multiprocessing.get_all_start_methods():
        with multiprocessing.get_context(way).Pool(2) as pool:
            # The timeout only ends a hanging call.
            placements = pool.map_async(evenlift.place, [l_shape, l_shape]).get(timeout=300)
            assert [each.json for each in placements] == [evenlift.place(l_shape).json] * 2
            error = refused(pool.map_async(evenlift.place, [l_shape, crossing, l_shape]).get, 300)
            assert (str(error), error.code, error.place) == (str(expected), "edges_cross", {"edges": [0, 2]}), way


# --- Places in errors


def check_refusals():
    error = refused(evenlift.place, crossing)
    assert str(error) == "Edges 1 and 3 cross, touch or overlap"
    assert (error.code, error.place) == ("edges_cross", {"edges": [0, 2]})
    assert isinstance(error, ValueError)
    assert refused(evenlift.place, l_shape, metric="Area").place == {"setting": "metric"}
    assert refused(evenlift.place, "(0,0)\n(4,0)\n(4 4)\n").place == {"line": 3, "column": 4}


def check_names():
    """A wrong name is reported together with the intended one."""
    meant = {"team": "teams", "min_ration": "min_ratio", "wieght": "weight", "minRatio": "min_ratio", "robots_radius": "robot_radius",
             "center_of_mass": "centre_of_mass", "Apart": "apart", "failure": "failures"}  # fmt: skip
    for wrong, right in meant.items():
        error = refused(evenlift.place, l_shape, **{wrong: 3})
        assert str(error) == f'There is no setting "{wrong}"; did you mean "{right}"?'
        assert (error.code, error.place) == ("bad_setting", {"setting": wrong})
    assert str(refused(evenlift.place, l_shape, zzz=1)) == 'There is no setting "zzz"'
    assert str(refused(evenlift.poses, l_shape, fromat="csv")) == 'There is no setting "fromat"; did you mean "format"?'
    for call in (evenlift.candidates, evenlift.link, evenlift.svg):
        assert refused(call, l_shape, failures=True).place == {"setting": "failures"}
    for call in (evenlift.candidates, evenlift.link, evenlift.svg, evenlift.poses):
        assert refused(call, l_shape, team=3).place == {"setting": "team"}


def check_numbers():
    """A number that is not finite is reported by its vertex, by the centre of mass or by its setting."""
    for bad in (math.nan, math.inf, -math.inf, numpy.nan, numpy.float32("inf"), decimal.Decimal("nan")):
        for vertex in ((bad, 1), (1, bad)):
            error = refused(evenlift.place, with_vertex(vertex))
            assert str(error) == "Vertex 3: this is not a finite number"
            assert (error.code, error.place, error.path) == ("bad_coordinate", {"vertices": [2]}, "polygon[2]")
            error = refused(evenlift.place, l_shape, centre_of_mass=vertex)
            assert (error.code, error.place) == ("bad_coordinate", {"centre_of_mass": True})
        for name in evenlift.Settings.__annotations__:
            error = refused(evenlift.place, l_shape, **{name: bad})
            assert str(error) == f"{name}: this is not a finite number"
            assert (error.code, error.place) == ("bad_setting", {"setting": name})
        assert refused(evenlift.experiment, [l_shape], samples=bad).place == {"setting": "samples"}
    array = numpy.array(l_shape)
    array[4, 1] = numpy.nan
    assert refused(evenlift.candidates, array).place == {"vertices": [4]}
    error = refused(evenlift.experiment, {"plate": l_shape, "hammer": array})
    assert error.path == "polygons[1].polygon[4][1]" and str(error).endswith("this is not a finite number")


def check_other_values():
    """So is a value that is not a number, a point, a polygon or a text. Only EvenliftError is raised."""
    for vertex in ((1, 2, 3, 4), (1,), (), 1, None, (None, 1), ("a", "b"), (1j, 0), (10**400, 0), (1e300, 0)):
        assert refused(evenlift.place, with_vertex(vertex)).place == {"vertices": [2]}, vertex
    for centre in ((1, 2, 3, 4), 3, ("a", "b"), (10**400, 0), [[1, 2]]):
        assert refused(evenlift.place, l_shape, centre_of_mass=centre).place == {"centre_of_mass": True}, centre
    for value in ([1], {}, object(), 1j, 10**400, numpy.array([1, 2]), True, "half \ud800"):
        assert refused(evenlift.place, l_shape, weight=value).place == {"setting": "weight"}, type(value)
    for polygon in (None, 3, object()):
        assert refused(evenlift.place, polygon).code == "bad_syntax"
    refused(evenlift.place, l_shape, weight=-(10**5000))
    refused(evenlift.place, math.nan)
    refused(evenlift.place, l_shape, cargo={(1, 2): 3})
    assert refused(evenlift.place, "(0,0)\n(4,\ud8000)").path == "text"
    assert refused(evenlift.place, l_shape, cargo=[((1, 1), 3), ((1, 1), 0)]).path == "cargo[1][1]"
    assert refused(evenlift.place, l_shape, supports=[(0, 0), {"at": (4, 0), "capacity": -1}]).path == "supports[1].capacity"
    assert "give one of them" in str(refused(evenlift.place, l_shape, com=(1, 1), centre_of_mass=(1, 1)))
    refused(evenlift.place, "(0,0)\0")
    refused(evenlift.experiment, {"half \ud800": l_shape})
    refused(evenlift.experiment, [l_shape] * 10001)
    assert refused(evenlift.place, [(0, 0)] * 1048578).code == "too_many_vertices"
    for request in ('{"polygon": "\ud800"}', "{\0}"):
        assert refused(evenlift.answer, request).code == "bad_syntax"


def check_poses():
    """The options of poses are refused by their names, and exactly when the core refuses them."""
    request = {"command": "poses", "polygon": l_shape}
    for name, values in {
        "format": ["csv", "json", "yaml", "CSV", "xml", "", None, 3],
        "origin": ["file", "com", "File", "", None, 3],
        "frame": ["map", "a/b", "/a", "a b", "", "a" * 255, "a" * 256, "é", "a\n", "-_.", None, 3],
    }.items():
        for value in values:
            core_refuses = "error" in json.loads(evenlift.answer(json.dumps({**request, name: value})))
            if core_refuses:
                assert refused(evenlift.poses, l_shape, **{name: value}).place == {"setting": name}, (name, value)
            else:
                evenlift.poses(l_shape, **{name: value})


def check_numbers_of_others():
    """Numbers of NumPy and of other libraries are numbers."""
    expected = evenlift.place(l_shape, teams=2, weight=30.5, centre_of_mass=(1, 1)).json
    array = numpy.array(l_shape, dtype=numpy.float32)
    assert evenlift.place(array, teams=numpy.int64(2), weight=decimal.Decimal("30.5"), centre_of_mass=array[0] + 1).json == expected
    assert evenlift.place(map(list, l_shape), teams="2", weight=numpy.array(30.5), centre_of_mass=[1, 1], seed=None).json == expected


def check_kinds_of_polygons():
    """Rings of geometry libraries, files and results are polygons."""
    plain = evenlift.place(l_shape)
    closed = evenlift.place([(x, y, 7) for x, y in [*l_shape, l_shape[0]]])
    assert closed.pop("notices") == ["third coordinates are left out", "a last vertex that repeats the first is left out"] and closed == plain

    class Geometry:
        __geo_interface__ = {"type": "Polygon", "coordinates": [[*l_shape, l_shape[0]]]}

    assert evenlift.place(Geometry())["teams"] == plain["teams"]
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "plate.csv"
        file.write_bytes("x;y;Größe\n".encode("latin-1") + "".join(f"{x};{y};1\n" for x, y in l_shape).encode())
        assert evenlift.place(file)["teams"] == evenlift.place(file.read_bytes())["teams"] == plain["teams"]
        assert evenlift.shapes(file)["shapes"][0]["document"]["polygon"] == plain["polygon"]
    two = "a\n0,0\n4,0\n4,3\n\nb\n10,0\n14,0\n14,9\n"
    parts = evenlift.parts(two, weight_per_area=2, capacity=20, sort="weight")
    assert [part["name"] for part in parts["parts"]] == ["b", "a"] and parts["parts"][0]["weight"] == 36 and parts["csv"].count("\n") == 3
    assert evenlift.parts("0,0\n4,4\n4,0\n0,4\n")["parts"][0]["error"]["code"] == "edges_cross"
    cargo = [((0.5, 0.5), 50, "motor"), {"at": (3, 1), "weight": 2}]
    loaded = evenlift.place(l_shape, cargo=cargo, teams=2, weight=7)
    assert evenlift.place(loaded) == loaded and evenlift.place(json.loads(loaded.json)) == loaded
    own = {name: loaded[name] for name in ("centre_of_mass", "own_centre_of_mass")}
    assert evenlift.place(l_shape, cargo=cargo, teams=2, weight=7, **own)["centre_of_mass"] == loaded["centre_of_mass"]
    assert evenlift.optimum(l_shape, teams=2)["teams"] == 2
    assert evenlift.trace(l_shape, teams=1)[0]["chapter"]


def check():
    check_copies()
    check_pools()
    check_refusals()
    check_names()
    check_numbers()
    check_other_values()
    check_poses()
    check_numbers_of_others()
    check_kinds_of_polygons()
