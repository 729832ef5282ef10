"""The types of evenlift's arguments and results, for type checkers and for code that reads results from files.

docs/cli.md in the repository explains each member of a result. Classes with a leading underscore contain the members that always
exist. docs/write_types.py writes this file from `evenlift --schema`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Iterable, Literal, Mapping, Optional, SupportsFloat, TypedDict, Union

if TYPE_CHECKING:
    import os

    from numpy import float64, int_
    from numpy.typing import NDArray
    from typing_extensions import TypeAlias

    Array: TypeAlias = NDArray[Any]
    FloatArray: TypeAlias = NDArray[float64]
    IntArray: TypeAlias = NDArray[int_]
    Path: TypeAlias = os.PathLike[str]
else:  # NumPy is imported only when an array is requested.
    Array = FloatArray = IntArray = Path = Any

Point = Iterable[SupportsFloat]
"""(x, y): a pair, or a row of a NumPy array. A third coordinate is left out, with a notice."""

File = Union[str, bytes, Path]
"""The text of a file, its bytes, or its path."""

Polygon = Union[File, Iterable[Point], Mapping[str, Any]]
"""A file, points (a list of pairs, or a NumPy array of two columns), or a result or document of evenlift."""

Table = Literal["measurements", "aggregates", "polygons"]

Metric = Literal["area", "circle", "distance", "distributed", "random", "balanced", "given"]


Goal = Literal["cover", "hold"]


Positions = Literal["best", "range"]


LengthUnit = Literal["m", "cm", "mm", "in"]


WeightUnit = Literal["kg", "t", "N", "lb"]


Overlay = Literal["candidates", "chords", "hull", "clockwise", "counterclockwise", "tipping", "halo", "tilt", "load"]


class Settings(TypedDict, total=False):
    """The program's options, with _ in place of -. Null counts as not given."""

    teams: Optional[Union[int, Literal["max"]]]
    """Number of teams, or max for every candidate (default 3)."""
    metric: Optional[Metric]
    """Area (default), circle, distance, distributed, random, balanced or given."""
    method: Optional[Metric]
    """Area (default), circle, distance, distributed, random, balanced or given."""
    min_ratio: Optional[float]
    """Minimum load ratio, 0 to 1 (default 0.8)."""
    com: Optional[Union[Point, str]]
    """Centre of mass (default the file's, else the centroid)."""
    weight: Optional[float]
    """The object's weight (default 100)."""
    seed: Optional[int]
    """For the method random (default 1)."""
    overlays: Optional[Union[Iterable[Overlay], Overlays, str]]
    """What a picture or link shows."""
    step: Optional[Union[int, Literal["none"]]]
    """Step of the walkthrough that a link opens."""
    com_radius: Optional[float]
    """C uncertainty: the radius within which the centre of mass is known; loads become ranges."""
    capacity: Optional[Union[float, Literal["none"]]]
    """Load that one robot can carry: overloaded robots, and the number of robots needed."""
    robot: Optional[Union[RobotSize, str]]
    """Size of a robot: r, reach, depth and width of the hand, and the gap between robots."""
    no_go: Optional[Union[Iterable[Union[int, str]], str]]
    """No-go edges from 1, or parts of them from 0 to 1."""
    unit: Optional[Union[LengthUnit, Literal["none"]]]
    """Label of lengths: m, cm, mm or in (default none)."""
    weight_unit: Optional[WeightUnit]
    """Label of weights: kg (default), t, N or lb."""
    goal: Optional[Goal]
    """Cover: the widest lifting base; hold: a hold with the minimum margin first."""
    robots: Optional[int]
    """Number of balanced robots, 2 to 64 (default 6)."""
    positions: Optional[Positions]
    """Best: one place for two edges; range: anywhere in their range."""
    min_margin: Optional[float]
    """Minimum margin of a hold (default 0.05)."""
    apart: Optional[float]
    """Preferred minimum distance between robots (default 0.12 of the object's radius)."""
    survive: Optional[int]
    """Number of failures that balanced robots should survive (default 0)."""
    clear: Optional[float]
    """Clearance: shorter distances are not relied on, of contacts from corners and, after a failure, of the centre of mass from the edge of the lifting base (default 0.02 of the object's radius)."""
    accuracy: Optional[float]
    """Robots may be off their places by A: searches keep what they promise (default 0)."""
    robot_radius: Optional[float]
    """Radius of the round body; it overrides that of robot, like the next four."""
    robot_reach: Optional[float]
    """Length of the arm, from the body to the contact."""
    robot_depth: Optional[float]
    """Length of the hand, from the contact to the lifting point."""
    robot_width: Optional[float]
    """Width of the hand."""
    robot_gap: Optional[float]
    """Free distance between two bodies."""
    supports: Optional[Union[Iterable[Union[Point, Support]], str]]
    """Robots that already stand, each perhaps with its capacity and name; or a file of them."""
    snap: Optional[float]
    """Supports within S of the outline stand at the edge (default 1e-4 of its size)."""
    support_capacities: Optional[Union[Iterable[Optional[float]], str]]
    """Capacity of each support, as many as there are supports; it overrides those in supports."""
    support_names: Optional[Union[Iterable[Optional[str]], str]]
    """Name of each support, as many as there are supports; it overrides those in supports."""
    cargo: Optional[Union[Iterable[Union[Cargo, tuple[Point, float], tuple[Point, float, str]]], str]]
    """Loads that are fixed to the object, added to those of the file; none removes those."""
    com_height: Optional[float]
    """Height of the centre of mass, with cargo, above the lifting points: at which slope it tips."""
    slope: Optional[Union[float, str]]
    """Greatest slope of the plane of the lifting points: a ratio, 8% or 4.6deg."""
    acceleration: Optional[Union[float, str]]
    """Greatest acceleration along the ground in any direction, in g or such as 2m/s2."""
    give: Optional[Union[float, Literal["none"]]]
    """Length by which a robot gives way under the mean load."""
    uneven: Optional[float]
    """How much the ground or a robot's height is off at most; without --give, loads can reach those at worst."""
    extra: Optional[Union[float, Literal["none"]]]
    """A further weight, such as a person: where it may stand."""
    readings: Optional[Union[Iterable[float], str]]
    """What each support reads, without tare: gives the weight and the centre of mass."""
    reading_error: Optional[Union[float, str]]
    """How far a reading may be off: a part of each, such as 1%, or a weight."""
    level_error: Optional[Union[float, str]]
    """How far the lifting points may be from level while one reads, as a slope."""
    readings_tilted: Optional[Union[Iterable[float], str]]
    """What each support reads on the slope of --tilted: gives the height of C."""
    tilted: Optional[Union[float, str]]
    """Slope of the second weighing: a ratio, 8% or 5deg."""
    heading: Optional[Union[Point, str]]
    """Direction uphill of the second weighing: a vector, or an angle such as 90deg."""
    dynamic: Optional[float]
    """Factor on the greatest loads before they meet a capacity, such as 1.2 (default 1)."""
    weight_doubt: Optional[Union[float, str]]
    """How far the weight may be off, either way: a part of it, such as 5%."""


Position = list[float]
"""[x, y] of a result."""


class _Support(TypedDict):
    at: Point


class Support(_Support, total=False):
    """A robot that already stands."""

    capacity: Optional[float]
    """What this support can carry."""
    name: str
    """At most 60 characters."""


class _Cargo(TypedDict):
    at: Point
    """Its centre of mass, which may overhang."""
    weight: float
    """1e-100 to 1e100."""


class Cargo(_Cargo, total=False):
    """A load that is fixed to the object."""

    name: str
    """At most 60 characters."""


class _CargoItem(TypedDict):
    at: Position
    weight: float


class CargoItem(_CargoItem, total=False):
    """A load as a result lists it."""

    name: str


class RobotSize(TypedDict):
    """The size of a robot."""

    radius: float
    """Of the round body."""
    reach: float
    """Length of the arm, from the body to the contact."""
    depth: float
    """Length of the hand, from the contact to the lifting point."""
    width: float
    """Of the hand."""
    gap: float
    """Free distance between two bodies."""


class Overlays(TypedDict):
    """What a picture shows."""

    candidates: bool
    chords: bool
    hull: bool
    clockwise: bool
    counterclockwise: bool
    tipping: bool
    halo: bool
    tilt: bool
    load: bool


class PolygonOptions(TypedDict, total=False):
    """What a request may say of its polygon."""

    holes: Optional[Union[Iterable[Iterable[Point]], Literal[False]]]
    """The vertices of each hole, in place of those of the text; `false` leaves those out."""
    centre_of_mass: Optional[Point]
    """Of the object without its cargo; `null` for the centroid. The default is the one in the text, or else the centroid."""
    own_centre_of_mass: Optional[Point]
    """The same by its name in results; it counts if both are given."""
    moved: Optional[str]
    """Robots moved by hand on the page, as a result tells them."""
    shape: Optional[Union[int, str]]
    """Of a text with several shapes: the number, from 1, or name of one."""
    flatten: Optional[float]
    """Of a drawing: greatest distance of edges from curves (default about 1/1000 of the shape)."""
    join: Optional[float]
    """Of a drawing: greatest distance of ends that are joined (default up to 1/1000 of the drawing)."""
    project: Optional[bool]
    """Converts longitudes and latitudes in degrees to metres."""


class Options(Settings, PolygonOptions):
    """Settings, and what a request may say of its polygon."""

    pass


class WeightOptions(TypedDict, total=False):
    """The weight from the area."""

    weight_per_area: Optional[Union[float, str]]
    """The weight from the area, in place of `weight`: of each square unit, or such as `15.6/m2`."""
    thickness: Optional[Union[float, str]]
    """The weight from the area, this thickness and `density`."""
    density: Optional[Union[float, str]]
    """Of each cubic unit, or such as `7850/m3`."""


class PlaceOptions(Settings, PolygonOptions, WeightOptions, total=False):
    """What a placement may be asked."""

    candidates: Optional[bool]
    """Lists the candidates."""
    failures: Optional[bool]
    """The effect of each robot's failure."""
    even_out: Optional[bool]
    """Moves two or three supports to the edge so that all carry the same load."""
    keep_misfits: Optional[bool]
    """Leaves out supports and holes that do not fit the object, instead of refusing it."""
    cases: Optional[bool]
    """The loads in each case."""
    require: str
    """Conditions, such as `held, max<=20`."""


class PartsOptions(PlaceOptions, total=False):
    """What all parts may be asked."""

    sort: Union[Literal["file"], Literal["number"], Literal["name"], Literal["area"], Literal["weight"], Literal["load"]]
    """The order of the parts, default `file`."""


class SvgOptions(Settings, PolygonOptions, total=False):
    """What a picture may be asked."""

    candidates: Optional[bool]
    """Shows the candidates."""
    keep_misfits: Optional[bool]
    """Leaves out supports and holes that do not fit the object."""


class PosesOptions(Settings, PolygonOptions, total=False):
    """How robots' poses are written."""

    format: Union[Literal["csv"], Literal["json"], Literal["yaml"]]
    """Default `json`; `yaml` is a PoseArray of ROS 2."""
    frame: str
    """The frame's name, default `object`."""
    origin: Union[Literal["file"], Literal["com"]]
    """Default `file`."""


class ShapesOptions(TypedDict, total=False):
    """How a file is read."""

    holes: Optional[bool]
    """`false` leaves them out."""
    flatten: Optional[float]
    """Greatest distance of edges from curves."""
    join: Optional[float]
    """Greatest distance of ends that are joined."""
    project: Optional[bool]
    """Converts longitudes and latitudes in degrees to metres."""


class ExperimentOptions(TypedDict, total=False):
    """What an experiment measures."""

    min_ratio: float
    """Default 0.8."""
    samples: int
    """Random placements of each polygon, default 200."""
    max_teams: int
    """Default 1000."""
    max_balanced: int
    """Balanced robots, default 12."""


class Candidate(TypedDict):
    """A chord on which a team may stand."""

    ends: list[Position]
    ratio: float
    """The shorter half divided by the longer one."""
    kind: Union[Literal["bisecting"], Literal["vertex"], Literal["midpoint"], Literal["range"]]
    """`range` only with `positions` `range`, or for robots with a size."""


class Team(TypedDict):
    """A team of robots."""

    ends: list[Position]
    """The left end first (the lower end of a vertical chord). `balanced` gives one team with an end for each robot, counter-clockwise along the outline from the vertex farthest from C, and `given` one in the order of the supports."""
    ratio: float
    """The load ratio; of `balanced` robots the least load divided by the greatest."""
    loads: list[Optional[float]]
    """In the order of the ends; `null` if the object falls."""


class _Robot(TypedDict):
    at: Position
    """The lifting point."""
    team: int
    """Counted from 0."""
    load: Optional[float]
    """`null` if the object falls."""
    contact: Optional[Position]
    """Where it touches the boundary; `null` beneath the object."""
    stand: Position
    """The middle of its body; without a size the three are one point."""
    heading: Optional[float]
    """The direction of the inward normal in degrees, above −180 and up to 180 (at a vertex, the bisector of the normals of its two edges); `null` beneath the object."""
    place: Union[Literal["edge"], Literal["beneath"]]
    """Only a support stands beneath."""


class Robot(_Robot, total=False):
    """A robot."""

    name: str
    """Of a support, if it has one."""
    support: int
    """Its number among `supports`, counted from 0, if some are left out."""


class LoadModels(TypedDict):
    """The loads by the models springs, best and worst."""

    springs: list[float]
    """In the order of `robots`, like `worst`."""
    best: float
    """The least possible greatest load."""
    worst: list[float]


class _Loads(TypedDict):
    min: float
    """As planned, like the next four."""
    mean: float
    max: float
    spread: float
    """`max` − `min`."""
    max_share: float
    """The greatest share of a team's load that one robot carries."""
    models: Optional[LoadModels]
    """The loads by the other models; `null` if rounding moves C outside the lifting base."""


class Loads(_Loads, total=False):
    """The loads."""

    ranges: list[list[float]]
    """With a C uncertainty, a slope, an acceleration (and a height of C), uneven ground (and a give) or an accuracy only: the least and the greatest load of each robot as planned. With an accuracy they include what loads may change, to first order, if all robots are off by it (tables, verdicts and `capacity` do not: they tell `accuracy` in its own sentence). They presume that the robots are set to their planned loads, then keep their heights and yield like equally stiff springs."""
    may_let_go: bool
    """With `ranges` only: whether a robot may go slack. Then every load lies between the least and the greatest that statics allows, with the weight acting anywhere within reach."""


Motion = Union[Literal["clockwise"], Literal["counterclockwise"], Literal["translation"]]


class DependsOn(TypedDict):
    robot: int
    """Counted from 0."""
    distance: float
    """Of its contact from a corner."""


class Closure(TypedDict):
    """How the robots' contact alone holds the object."""

    form_closure: bool
    """Whether no motion is free to first order if robots keep their formation and can push sideways; contacts at convex vertices are not counted."""
    margin: Optional[float]
    """Strength of the hold; positive in form closure, `null` without contacts. It is the largest-ball measure with one limit for the sum of all contact forces. It depends on C and R, so use it only to compare placements of one object."""
    clearance: Optional[float]
    """Greatest distance such that the hold needs no contact nearer than this to a corner; `null` if it needs no contact beside a corner, and 0 without form closure."""
    tolerance: Optional[float]
    """Form closure remains if all robots are off by less than this at once, each along the outline, if robots in inward corners stay there; `null` if it remains in any case, and 0 without form closure."""
    second_order: bool
    """Whether the object is immobile although first-order motions are free."""
    free: list[Motion]
    """The motions that are free; empty in form closure."""
    slides: Optional[Position]
    """A direction of unit length in which it can slide; `null` if it cannot."""
    depends_on: Optional[DependsOn]
    """The robot on whose accuracy the hold depends, since its contact is at the distance `clearance` from a corner."""
    clockwise: list[Position]
    """Corners of the region of free centres of clockwise rotation whose distance from C, in x and in y, is at most 100 times the diagonal of the bounding box; may be empty (even if the region continues farther out), one point or two points. Clockwise assumes that x points right and y up."""
    counterclockwise: list[Position]
    """The same for counter-clockwise rotation."""


class LimitedBy(TypedDict):
    what: Union[Literal["fits"], Literal["stands"], Literal["hold"], Literal["capacity"]]
    robots: list[int]
    """Those that it depends on, counted from 0."""
    edge: Optional[int]
    """Where one has no more room."""


class Accuracy(TypedDict):
    """How far all robots may be off. Each length is null if what it is about does not hold, or has no limit."""

    asked: float
    """The setting."""
    all_within: Optional[float]
    """The least of the last four."""
    limited_by: Optional[LimitedBy]
    fits_within: Optional[float]
    """Robots off by this still fit."""
    stands_within: Optional[float]
    """The object still stands."""
    hold_within: Optional[float]
    """They still hold it."""
    capacity_within: Optional[float]
    """None is overloaded."""


class _Robustness(TypedDict):
    com_margin: float
    """Tipping distance: the least distance by which C must be off for the object to tip, if robots push back and none is overloaded; 0 with one team of two. If the object falls, minus the distance of C from the lifting base."""
    failures_carried: int
    """Number of robots that may fail at once, whichever they are, while the others, if strong enough, still carry the object at rest; −1 if it falls already."""
    failures_steady: int
    """The number of failures, of whichever robots, after which C is still inside the others' convex hull by more than τL; −1 if C is not that far inside even with all robots, as with one team."""
    failures_clear: int
    """The number of failures after which C is still at least `clear` inside."""
    load_per_length: Optional[list[float]]
    """For each robot: the greatest change in its load by springs per unit of length that C moves; `null` if `models` is."""


class Robustness(_Robustness, total=False):
    """What the placement survives."""

    com_radius: float
    """With a C uncertainty only: as given."""
    exact_within: Optional[float]
    """With a C uncertainty only: the distance that C may be off while the same robots carry the object."""
    plan_ranges: list[list[float]]
    """The same as `loads.ranges`."""
    springs_ranges: list[list[float]]
    """The same by springs."""


class Tilt(TypedDict):
    """When the object tips, in the worst direction."""

    height: float
    """H."""
    reach: float
    """How far from C the weight may act, E + H (S + A √(1 + S²)), where S includes the tilt by uneven heights."""
    stays: bool
    """Whether the object stays upright then."""
    slope: float
    """The slope, as a ratio, at which it tips in the worst direction; this and the next two each alone, on level, even ground and with C off by up to E."""
    degrees: float
    """The same as an angle."""
    acceleration: float
    """In g."""
    acceleration_left: Optional[float]
    """At which it tips on the given slope; `null` without one."""
    slope_left: Optional[float]
    """At which it tips with the given acceleration; `null` without one."""


class ExtraLoad(TypedDict):
    """Where a further load may stand."""

    weight: float
    """As given; all else is `null` if the object falls."""
    region: Optional[list[Position]]
    """Corners of the convex polygon within the object's bounding box in which the weight lifts no robot off and overloads none."""
    share: Optional[float]
    """The share of the object's area in it."""
    anywhere: Optional[float]
    """The greatest weight that may stand anywhere on the object; `null` for any weight."""


VerdictCode = Union[Literal["no_place"], Literal["falls"], Literal["tips"], Literal["overloaded"], Literal["left_out"], Literal["misfit"], Literal["fewer_teams"], Literal["not_upright"], Literal["low_coverage"], Literal["not_held"], Literal["inaccurate"]]


class Verdict(TypedDict):
    """Whether the placement is good, and if not, why."""

    kind: Union[Literal["good"], Literal["warning"], Literal["bad"]]
    """`bad` if there are no robots, the object falls, it tips under the given conditions, or a robot carries, or within these conditions can carry, more than its capacity as planned; `warning` if a support or hole is left out, there are fewer teams than requested, a robot does not fit, the coverage is below 0.5, C is not clearly inside the lifting base, the object is not `held`, or something may end with robots off by `accuracy`; otherwise `good`."""
    reasons: list[str]
    """Sentences, the most serious first; none if it is good."""
    codes: list[VerdictCode]
    """What each of these sentences is about."""


class _Misfit(TypedDict):
    robot: int
    """Counted from 0."""
    why: str
    """`outside` (no room for the body), `arm` (it would cross the object), `hand` (it would stick out of the object), `hole` (it would reach into a hole), `no-go`, or, for two that collide, `too near robot 2`, counted from 1."""


class Misfit(_Misfit, total=False):
    """A support that does not fit."""

    other: int
    """Of two that collide, the other one, counted from 0."""


class _Failure(TypedDict):
    robot: int
    """Counted from 0."""
    carried: bool
    """Whether the others carry the object; otherwise all members after `clear` are `null`."""
    steady: bool
    """Whether C is inside their convex hull by more than τL."""
    clear: bool
    """Whether C is at least `clear` inside."""
    com_margin: Optional[float]
    coverage: Optional[float]
    form_closure: Optional[bool]
    margin: Optional[float]
    """Also `null` if there are no contacts."""
    plan_max: Optional[float]
    """Greatest load as planned; also `null` if there is no other team."""
    springs_max: Optional[float]
    best_max: Optional[float]
    springs: Optional[list[float]]
    """The load of each robot by springs, 0 for the failed one; `null` for more than 64 robots, for which all failures together would have millions of loads."""


class Failure(_Failure, total=False):
    """What happens if this robot fails."""

    over_capacity: Optional[bool]
    """With capacities only: whether one of the others carries more than its capacity by springs, under the given conditions; `null` if it does not stay upright under them."""
    overloaded: Optional[list[int]]
    """With capacities only: these robots, counted from 0."""
    greatest_end: Optional[float]
    """Only if `loads.ranges` exists: the greatest load within the given conditions; `null` if it does not stay."""
    stays: Optional[bool]
    """Only if `loads.ranges` exists: whether the object stays upright under the given conditions."""


class FailurePlan(TypedDict):
    """The robots needed so that any one of them may fail."""

    robots_needed: Optional[int]
    """The least number of robots found with which, under the given conditions, none carries more than the limit, both as planned with all robots working and by springs after any one has failed, and C is then at least `clear` inside the lifting base of the others; `null` if no number was found."""
    greatest_load: Optional[float]
    """With that number."""
    robots_tried: int
    """The greatest number of robots tried, 0 if none was."""


class Capacity(TypedDict):
    """What robots can carry, and how many are needed."""

    limit: Optional[float]
    """The common limit, or `null` if only single supports have one."""
    overloaded: list[int]
    """The robots whose planned load exceeds their limit; on slopes, when braked or on uneven ground, those whose greatest end in `loads.ranges` does (`robustness.plan_ranges` also shows which may exceed it if C is anywhere within `com_radius`). Robot 2 *t* + *e* is at end *e* of team *t*, all counted from 0."""
    teams_needed: Optional[int]
    """The least number of teams that keeps every robot within the limit; `null` if there is none. With `given` this and the next three contain no plan: they are `null`, and 0 for the numbers tried."""
    greatest_load: Optional[float]
    """With that number."""
    teams_tried: int
    """The last number of teams tried: at most 512, or 32 for teams that are swapped until they hold, or all teams that find a place; 1 for balanced robots."""
    robots_needed: Optional[int]
    """The number of robots in these teams; for balanced robots the least number, up to 64, that the weight and `survive` need."""
    com_radius: Optional[float]
    """The greatest C uncertainty with which every load by springs stays within the limit; `null` if a load is already beyond it."""
    if_one_fails: Optional[FailurePlan]
    """On the page `null` for balanced robots until it has been computed, since each number requires a search."""
    use: Optional[float]
    """The greatest use of a robot, under all given conditions; `null` if the object falls or tips under them."""


class Requirement(TypedDict):
    """A condition, and whether it is kept."""

    condition: str
    value: Optional[Union[float, bool]]
    """`null` if there is none."""
    kept: bool


UnusableReason = Union[Literal["no_go"], Literal["body"], Literal["arm"], Literal["corner"], Literal["hand"], Literal["hole"], Literal["near_no_go"], Literal["narrow"]]


class Effective(TypedDict):
    """The values of settings whose defaults depend on the object."""

    clear: float
    """The setting, or its default of 2 % of R; with `given` less by 1e-4 L, since places that are typed have few digits."""
    apart: float
    """The setting, or its default of 12 % of R."""
    snap: float
    """The setting, or its default of 1e-4 L."""


class Weighing(TypedDict):
    """What the readings of supports tell."""

    weight: float
    """Of the object with its cargo."""
    weight_error: float
    """How far it may be off."""
    centre_of_mass: Position
    """Of the object with its cargo."""
    radius: float
    """How far that may be off: by errors of readings, `accuracy`, and the height of C times `level_error`."""
    residuals: Optional[list[float]]
    """By how much each reading differs from what equally stiff supports on even ground would read; `null` if fewer than four carry."""
    fit: Optional[bool]
    """Whether errors of readings, and uneven ground if it is given, explain these."""
    suspect: Optional[int]
    """If they do not: the support whose wrong reading would explain most, counted from 0, if it is the only one of at least five that carry."""
    too_little: Optional[list[float]]
    """If they do not: by how much each support reads too little if its reading alone is wrong."""
    height: Optional[float]
    """Of C above the lifting points, from a second weighing on a slope."""
    height_error: Optional[float]
    """How far that may be off."""
    height_fits: Optional[bool]
    """Whether the second readings add up to the same weight, or to its part across the slope."""


class LoadCase(TypedDict):
    """A case of loading."""

    name: Union[Literal["level"], Literal["com"], Literal["slope"], Literal["acceleration"], Literal["uneven"], Literal["all"], Literal["failure"]]
    """The condition that alone counts; all of them; or all of them after a robot has failed."""
    failed: Optional[int]
    """That robot, counted from 0."""
    greatest: Optional[float]
    """The greatest load, as planned; after a failure by springs. `null` if the object falls or can tip."""
    robot: Optional[int]
    """Whose it is."""
    least: Optional[float]
    """The least load; after a failure only without conditions."""
    use: Optional[float]
    """The greatest use of a robot."""
    stays: bool
    """Whether the object stands and cannot tip."""


class LeftOut(TypedDict):
    """A support or a hole that does not fit the object."""

    kind: Union[Literal["support"], Literal["hole"]]
    index: int
    """Counted from 0."""
    in_hole: Optional[int]
    """The hole that the support is in; `null` outside the object."""


EvenedOut = TypedDict("EvenedOut", {"robot": int, "from": Position, "to": Position, "by": float})
"""A support that was moved to even out the loads."""


class _PlacementDict(TypedDict):
    polygon: list[Position]
    """As given."""
    centre_of_mass: Position
    """Of the object with its cargo, to which everything else refers."""
    own_centre_of_mass: Position
    """Of the object alone; given to a request, it is the centre of mass of the object without cargo."""
    total_weight: float
    """With the cargo, from which all loads are computed."""
    metric: Metric
    """Area (default), circle, distance, distributed, random, balanced or given."""
    min_ratio: float
    """Minimum load ratio, 0 to 1 (default 0.8)."""
    weight: float
    """The object's weight (default 100)."""
    seed: int
    """For the method random (default 1)."""
    clear: Optional[float]
    """Clearance: shorter distances are not relied on, of contacts from corners and, after a failure, of the centre of mass from the edge of the lifting base (default 0.02 of the object's radius)."""
    requested_teams: int
    """With `max` the number of candidates, and with `balanced` and `given` 1."""
    teams: list[Team]
    """In the order of selection."""
    hull: list[Position]
    """Corners of the lifting base, counter-clockwise; empty if there is no team."""
    coverage: float
    """0 to 1."""
    loads: Optional[Loads]
    """`null` if there is no team or the object falls."""
    closure: Closure
    goal: Goal
    goal_reached: bool
    """Whether robots are placed and, with the goal `hold`, are in firm form closure."""
    stands: bool
    """Whether the robots can carry the object: the centre of mass is in the lifting base. Only supports can fail this, or a placement without robots."""
    held: bool
    """Whether the robots hold the object: in form closure with a clearance of at least `clear` and a tolerance of at least half of that and of at least `accuracy`, or to second order."""
    verdict: Verdict
    """The page's judgement."""
    tilt: Optional[Tilt]
    """When the object tips; `null` without a height of C."""
    effective: Effective
    """Lengths that settings have here, whether or not they are set."""
    version: str
    """Of evenlift."""


class PlacementDict(_PlacementDict, total=False):
    """What evenlift place --json prints."""

    holes: list[list[Position]]
    """Only if there are any: as given."""
    unit: LengthUnit
    """Label of lengths: m, cm, mm or in (default none); only if it is set."""
    weight_unit: WeightUnit
    """Label of weights: kg (default), t, N or lb; only if it is set."""
    requested_robots: int
    """Number of balanced robots, 2 to 64 (default 6); only with balanced robots."""
    positions: Positions
    """Best: one place for two edges; range: anywhere in their range; only if it is set."""
    min_margin: float
    """Minimum margin of a hold (default 0.05); only with balanced robots and with the goal hold."""
    apart: Optional[float]
    """Preferred minimum distance between robots (default 0.12 of the object's radius); only with balanced robots."""
    survive: int
    """Number of failures that balanced robots should survive (default 0); only with balanced robots."""
    supports: list[Position]
    """Robots that already stand, each perhaps with its capacity and name; or a file of them; only with supports."""
    snap: float
    """Supports within S of the outline stand at the edge (default 1e-4 of its size); only with supports."""
    support_capacities: list[Optional[float]]
    """Capacity of each support, as many as there are supports; it overrides those in supports; only with supports."""
    support_names: list[Optional[str]]
    """Name of each support, as many as there are supports; it overrides those in supports; only with supports."""
    cargo: list[CargoItem]
    """Loads that are fixed to the object, added to those of the file; none removes those; only if it is set."""
    com_height: float
    """Height of the centre of mass, with cargo, above the lifting points: at which slope it tips; only if it is set."""
    slope: float
    """Greatest slope of the plane of the lifting points: a ratio, 8% or 4.6deg; only if it is set."""
    acceleration: float
    """Greatest acceleration along the ground in any direction, in g or such as 2m/s2; only if it is set."""
    give: float
    """Length by which a robot gives way under the mean load; only if it is set."""
    uneven: float
    """How much the ground or a robot's height is off at most; without --give, loads can reach those at worst; only if it is set."""
    readings: list[float]
    """What each support reads, without tare: gives the weight and the centre of mass; only with supports."""
    reading_error: Union[float, str]
    """How far a reading may be off: a part of each, such as 1%, or a weight; only with supports."""
    level_error: float
    """How far the lifting points may be from level while one reads, as a slope; only with supports."""
    readings_tilted: list[float]
    """What each support reads on the slope of --tilted: gives the height of C; only with supports."""
    tilted: float
    """Slope of the second weighing: a ratio, 8% or 5deg; only with supports."""
    heading: Position
    """Direction uphill of the second weighing: a vector, or an angle such as 90deg; only with supports."""
    dynamic: float
    """Factor on the greatest loads before they meet a capacity, such as 1.2 (default 1); only if it is set."""
    weight_doubt: float
    """How far the weight may be off, either way: a part of it, such as 5%; only if it is set."""
    candidates: list[Candidate]
    """If they are asked for: in order of slope, for every method, even if it does not use candidates."""
    robots: list[Robot]
    """Team by team; missing without a team, like `robustness` and `accuracy`."""
    left_out: list[LeftOut]
    """With `keep_misfits` only: supports and holes that do not fit the object, and do not count."""
    misfits: list[Misfit]
    """With `given` only: the supports that do not fit."""
    tips_over: list[int]
    """With `given`, and only if the object falls: the one or two robots over which it tips, counted from 0."""
    search_ended: bool
    """With `balanced`: `false` if the search was cut short, which happens on large, strongly winding outlines and with many robots, or while the page is still searching. For teams that are swapped until they hold, `false` if the swaps were cut short; otherwise missing."""
    teams_asked: Union[int, Literal["max"]]
    """Only if `requested_teams` differs from the request: `max`, or with `balanced` and `given` a link's number of teams for the other methods, unless it is 3. Used when the result is reopened."""
    overlays: Overlays
    """From a link or the page, unless all are at their defaults."""
    moved: str
    """From a link with robots moved by hand on the page: their places, in the form used in the link."""
    robot: RobotSize
    """This and the next two only if robots have a size, or there are no-go edges."""
    no_go: str
    unusable: list[list[Union[float, UnusableReason]]]
    """The parts of edges that robots cannot use: the edge, counted from 1, from where to where, from 0 to 1, and why."""
    robustness: Robustness
    accuracy: Accuracy
    """How far robots may be off."""
    failures: list[Failure]
    """If they are asked for."""
    extra: ExtraLoad
    """With `extra` only."""
    weighing: Weighing
    """With `readings` only."""
    use: list[Optional[float]]
    """With capacities only: how much of each robot is used, its greatest planned load under all given conditions, times `dynamic` and 1 + `weight_doubt`, divided by its capacity; `null` without one."""
    cases: list[LoadCase]
    """With `cases` only: the loads in each case."""
    capacity: Capacity
    """With `capacity` or a support's own capacity only."""
    requirements: list[Requirement]
    """If conditions are required."""
    evened_out: list[EvenedOut]
    """With `even_out` only: the supports that were moved."""
    notices: list[str]
    """Of requests only: what was left out of polygon or text, such as third coordinates."""


class GreedyChoice(TypedDict):
    taken: list[int]
    """Candidates, counted from 0."""
    coverage: float


class WidestChoice(TypedDict):
    taken: list[int]
    coverage: float
    bound: float
    """No choice covers more."""
    proved: bool
    """Whether no choice covers more than this one."""


class HoldingChoice(TypedDict):
    taken: list[int]
    level: int
    """Of the hold, from 0 (none) to 3."""
    coverage: float
    most_level: int
    """No choice has a higher one."""
    bound: float
    """No choice with that level covers more."""
    proved: bool
    """Whether no choice is better."""


class _Optimum(TypedDict):
    teams: int
    candidates: int
    """Their number."""
    greedy: GreedyChoice
    """The choice that is placed."""
    optimum: WidestChoice
    """The widest choice that was found."""


class Optimum(_Optimum, total=False):
    """How far the greedy choice of teams is from the best one."""

    hold: HoldingChoice
    """With the goal `hold` only."""
    notices: list[str]


class ImportedShape(TypedDict):
    """A shape of a drawing or table."""

    name: str
    """Of the object or its layer; empty if there is none."""
    kind: str
    """In words, such as `rectangle`."""
    sheet: bool
    """Whether it is the sheet of a drawing rather than a part on it."""
    tolerance: Optional[float]
    """Greatest distance of edges from curves; `null` without curves."""
    document: dict[str, Any]
    """Outline, holes, cargo and settings: a polygon for all other requests."""


class Shapes(TypedDict):
    """The shapes of a file."""

    format: str
    """Such as `DXF`."""
    unit: str
    """In words, such as `millimetres`; empty if the text names none."""
    doubtful: bool
    """Whether what does not close is larger than the largest shape."""
    notices: list[str]
    """Omissions and decisions."""
    shapes: list[ImportedShape]
    """One or more; in a drawing the largest first, and sheets last."""


class Part(TypedDict):
    """A part of a drawing."""

    shape: int
    """Its number in the file, from 1."""
    name: str
    """Unique, or empty."""
    at: Position
    """The middle of its bounding box."""
    size: Position
    """The width and height of that box."""
    area: float
    """Without holes."""


class PlacedPart(Part, PlacementDict):
    """A part with its robots."""

    pass


class RefusedPart(Part):
    """A part that is refused."""

    error: Problem
    """In place of a placement."""


class Parts(TypedDict):
    """All parts of a drawing."""

    notices: list[str]
    """Omissions and decisions."""
    parts: list[Union[PlacedPart, RefusedPart]]
    """The lines of `evenlift place --shape all --json`."""
    csv: str
    """The rows of `--csv`."""


class FigureSeries(TypedDict):
    method: Metric
    points: list[list[float]]
    """Robots, value, polygons."""


class Figure(TypedDict):
    """A figure of the thesis's chapter 5."""

    set: str
    id: str
    title: str
    unit: str
    column: str
    sentence: str
    series: list[FigureSeries]


class Claim(TypedDict):
    """A statement of the thesis."""

    section: str
    """Of the thesis."""
    what: str
    thesis: str
    """What it states."""
    ours: list[str]
    """Our measurements, one text for each set."""


class Claims(TypedDict):
    """The thesis's statements beside our measurements."""

    sets: list[str]
    rows: list[Claim]


class FewRobotsRow(TypedDict):
    what: str
    robots: int
    cells: list[str]


class FewRobots(TypedDict):
    set: str
    rows: list[FewRobotsRow]


class Refused(TypedDict):
    polygon: str
    problem: str


class Place(TypedDict, total=False):
    """The place of an error, of one of these kinds."""

    line: int
    """Of the text, counted from 1."""
    column: int
    """In characters, counted from 1."""
    vertices: list[int]
    """One or two, counted from 0."""
    edges: list[int]
    """One or two, counted from 0: edge i runs from vertex i."""
    rings: list[int]
    """Of these, or a whole ring: 0 is the outline, 2 the second hole."""
    centre_of_mass: Literal[True]
    setting: str
    """A setting or another member, or its path, such as `supports[3]`."""
    character: int
    """In a link, counted from 1; 0 is the whole link."""


class Problem(TypedDict):
    """Why a part is refused."""

    code: str
    """One word for programs."""
    message: str
    """The sentence that the program prints."""
    place: Optional[Place]
    path: Optional[str]
    """Of the member at fault, counted from 0: `cargo[2].weight`, `polygon[3]`."""


# --- Arrays, and the tables of experiments


class PlacementArrays(TypedDict):
    """n × 2: `polygon` and `hull`; for m robots, m × 2: `at`, `stand` and `contact`, and m: `load`, `heading` and `team`. NaN stands for
    None."""

    polygon: FloatArray
    hull: FloatArray
    at: FloatArray
    stand: FloatArray
    contact: FloatArray
    load: FloatArray
    heading: FloatArray
    team: IntArray


class CandidateArrays(TypedDict):
    """`ends` is n × 2 × 2, and `ratio` n."""

    ends: FloatArray
    ratio: FloatArray



class MeasurementRow(TypedDict):
    """A row of measurements.csv, with None for an empty field."""

    set: str
    polygon: str
    method: Metric
    teams: int
    robots: int
    samples: int
    coverage: float
    form_closure: float
    no_area: float
    held_clear: float
    load_min: float
    load_mean: float
    load_max: float
    spread: float
    max_share: float
    chosen: Optional[int]


class AggregateRow(TypedDict):
    """A row of aggregates.csv."""

    set: str
    method: Metric
    teams: int
    robots: int
    polygons: int
    spread_mean: float
    spread_sd: Optional[float]
    load_max_mean: float
    load_max_sd: Optional[float]
    max_share_mean: float
    max_share_sd: Optional[float]
    coverage_mean: float
    coverage_sd: Optional[float]
    closed_mean: float
    closable: int
    form_closure_mean: Optional[float]
    no_area_possible: int
    no_area_mean: Optional[float]
    held_clear_mean: float


class PolygonRow(TypedDict):
    """A row of polygons.csv: the polygon's numbers, or the reason why it was refused."""

    set: str
    polygon: str
    vertices: Optional[int]
    convex: Optional[int]
    candidates: Optional[int]
    problem: str


class ExperimentDict(TypedDict):
    """The members of an Experiment."""

    measurements: list[MeasurementRow]
    aggregates: list[AggregateRow]
    polygons: list[PolygonRow]
    thesis: str
    refused: list[Refused]
    figures: list[Figure]
    claims: Claims
    few_robots: list[FewRobots]
