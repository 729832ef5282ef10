"""The types that the package declares: every hint can be resolved, the settings are those of the manual, and results
have exactly the members of their types. usage.py runs these checks."""

import inspect
import json
import pathlib
import re
import types as kinds
import typing

import evenlift
from evenlift import types

root = pathlib.Path(__file__).resolve().parents[3]
l_shape = [(0, 0), (4, 0), (4, 1.5), (1.5, 1.5), (1.5, 3), (0, 3)]


# --- Hints


def public_callables():
    """All public functions and classes of the package, with the methods of the classes."""
    things = [getattr(evenlift, name) for name in evenlift.__all__]
    things += [thing for thing in vars(types).values() if inspect.isclass(thing) and thing.__module__ == types.__name__]
    for thing in things:
        if isinstance(thing, kinds.ModuleType):
            continue
        yield thing
        if inspect.isclass(thing):
            yield from (method for name, method in vars(thing).items() if inspect.isfunction(method) and not typing.is_typeddict(thing))


def check_hints():
    found = list(public_callables())
    assert {evenlift.place, evenlift.answer, evenlift.Placement.arrays, evenlift.Experiment.csv, types.Robot} <= set(found)
    for each in found:
        hints = typing.get_type_hints(each)
        if inspect.isfunction(each):
            assert hints.keys() == inspect.signature(each).parameters.keys() - {"self"} | {"return"}, each
    assert typing.get_type_hints(evenlift.place)["return"] is evenlift.Placement
    assert (pathlib.Path(evenlift.__file__).parent / "py.typed").exists()


def check_settings():
    """The settings are those of the manual, and the library knows them."""
    names = set(typing.get_type_hints(evenlift.Settings))
    manual = (root / "docs/requests.md").read_text(encoding="utf-8")
    table = re.search(r"^## Settings\n(.*?)^## ", manual, re.MULTILINE | re.DOTALL)[1]
    rows = re.findall(r"^\| (`.*?) \|", table, re.MULTILINE)
    documented = {name for row in rows for name in re.findall(r"`(\w+)`", row)}
    assert names == documented, names ^ documented
    for name in names:  # a null counts as not given
        asked = json.dumps({"polygon": l_shape, "settings": {name: None}})
        assert evenlift.answer(asked) == evenlift.place(l_shape).json, name


# --- Results


def complaints(value, hint, where="it"):
    """The parts of the value that do not match the type."""
    origin, arguments = typing.get_origin(hint), typing.get_args(hint)
    if typing.is_typeddict(hint):
        if type(value) is not dict:
            return [f"{where} is no object"]
        hints = typing.get_type_hints(hint)
        missing = [f"{where} has no {name}" for name in hint.__required_keys__ - value.keys()]
        unknown = [f"{where} has {name}" for name in value.keys() - hints.keys()]
        known = value.keys() & hints.keys()
        return missing + unknown + [each for name in known for each in complaints(value[name], hints[name], f"{where}.{name}")]
    if origin is typing.Union:
        tried = [complaints(value, each, where) for each in arguments]
        return min(tried, key=len)
    if origin is list:
        if type(value) is not list:
            return [f"{where} is no list"]
        return [each for i, item in enumerate(value) for each in complaints(item, arguments[0], f"{where}[{i}]")]
    if origin is typing.Literal:
        fits = any(value == each and type(value) is type(each) for each in arguments)
    else:
        fits = type(value) is hint or (hint is float and type(value) is int)
    return [] if fits else [f"{where} is {value!r}"]


def check_placements(samples):
    texts = {sample.stem: sample.read_text(encoding="utf-8") for sample in samples}
    asked = [
        *((text, {}) for text in list(texts.values())[::5]),
        (texts["hammer"], {"failures": True, "candidates": True, "capacity": 20, "com_radius": 5}),
        (texts["hammer"], {"capacity": 0.001, "unit": "mm", "weight_unit": "lb"}),
        (texts["star"], {"metric": "balanced", "robots": 5, "failures": True, "teams": 4}),
        (texts["guitar"], {"positions": "range", "goal": "hold", "candidates": True, "clear": 1}),
        (texts["grand-piano"], {"robot": "r=30,reach=20,depth=40,width=60,gap=10", "no_go": "38,2:0.25-0.75"}),
        (texts["square"], {"metric": "balanced", "robot_radius": 3, "apart": 10}),
        (texts["square"], {"teams": "max", "overlays": "hull,halo"}),
        (texts["star"], {"metric": "random", "seed": 2**64 - 1}),
        (l_shape, {"robot": "r=100"}),  # no robot finds a place
        # l_shape on robots that already stand, and falling from others:
        (l_shape, {"supports": [(0, 0), (4, 0), (0, 3), (1, 1)], "support_capacities": [30, None, 40, 50], "snap": 0.1, "require": "held"}),
        (l_shape, {"supports": [(0, 0), (4, 0), (0, 3), (1, 1)], "readings": [20, 30, 25, 25], "reading_error": "1%",
                   "level_error": 0.01, "readings_tilted": [21, 29, 26, 24], "tilted": "5deg", "heading": [1, 0], "dynamic": 1.1,
                   "weight_doubt": 0.05, "cases": True}),
        (l_shape, {"holes": [[(0.5, 0.5), (1, 0.5), (1, 1)]], "cargo": [((3, 0.5), 20, "motor"), {"at": (0.2, 2), "weight": 5}], "teams": 2}),
        (
            texts["hammer"],
            {"com_height": 9, "slope": "8%", "acceleration": 0.1, "give": 3, "uneven": 1, "extra": 20, "failures": True},
        ),
        (l_shape, {"cargo": '3,0.5:20:"a motor" 0.2,2:5', "teams": 2}),
        (l_shape, {"supports": "0,0 0,3", "failures": True, "robot": "r=100", "even_out": False}),
        (l_shape, {"supports": [(0, 0), (4, 0), (0, 3)], "support_names": ["north", "", "south west"]}),
        (l_shape, {"supports": "0,0 9,9 0,3", "keep_misfits": True, "holes": [[(3, 0), (4, 0), (4, 1)]]}),
        ([*l_shape, l_shape[0]], {}),  # a notice
        (texts["square"], {"supports": [(0, 0), (1000, 0), (900, 1000), (0, 1000)], "even_out": True}),
    ]
    seen = set()
    for polygon, settings in asked:
        placement = evenlift.place(polygon, **settings)
        content = json.loads(placement.json)
        assert content == placement and complaints(content, types.PlacementDict) == []
        assert complaints(list(evenlift.candidates(polygon)), list[types.Candidate]) == []
        seen |= content.keys()
    moved = {"moved"}  # by hand, on the page only
    assert seen == typing.get_type_hints(types.PlacementDict).keys() - moved, seen ^ typing.get_type_hints(types.PlacementDict).keys()


def check_complaints():
    """The check above finds differences."""
    content = json.loads(evenlift.place(l_shape).json)
    assert complaints({**content, "news": 1}, types.PlacementDict) == ["it has news"]
    hull = content.pop("hull")
    assert complaints(content, types.PlacementDict) == ["it has no hull"]
    assert complaints({**content, "hull": hull, "seed": 1.5}, types.PlacementDict) == ["it.seed is 1.5"]
    assert complaints({**content, "hull": hull, "goal": "both"}, types.PlacementDict) == ["it.goal is 'both'"]
    assert complaints({**content, "hull": [[0, None]]}, types.PlacementDict) == ["it.hull[0][1] is None"]


def check_experiments():
    polygons = {"l": l_shape, "bad": "POLYGON (", "triangle": [(0, 0), (3, 0), (0, 4)]}
    result = evenlift.experiment(polygons, samples=2, max_teams=2, max_balanced=3)
    assert complaints(dict(result), types.ExperimentDict) == []
    assert result["measurements"] and result["figures"] and result["claims"]["rows"] and result["few_robots"] and result["refused"]
    assert complaints(dict(evenlift.experiment([])), types.ExperimentDict) == []


def check_places():
    """The place in an error is a Place, whatever is wrong."""
    link = evenlift.link(l_shape)
    wrong = [(l_shape, {"teams": 0}), (l_shape[:2] * 2, {}), (l_shape, {"centre_of_mass": (9, 9)}), ("(0,0", {}), (link[:-1], {}), ([], {})]
    for polygon, settings in wrong:
        try:
            evenlift.place(polygon, **settings)
        except evenlift.EvenliftError as error:
            assert error.place is None or complaints(error.place, types.Place) == [], error.place
        else:
            raise AssertionError(f"{polygon} was not refused")


def check(samples):
    check_hints()
    check_settings()
    check_complaints()
    check_placements(samples)
    check_experiments()
    check_places()
