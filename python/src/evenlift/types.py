"""The types of evenlift's arguments and results, for type checkers and for code that reads results from files.

docs/cli.md in the repository explains each member of a result. Classes with a leading underscore contain the members that always
exist.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Iterable, Literal, Optional, SupportsFloat, TypedDict, Union

if TYPE_CHECKING:
    from numpy import float64, int_
    from numpy.typing import NDArray
    from typing_extensions import TypeAlias

    Array: TypeAlias = NDArray[Any]
    FloatArray: TypeAlias = NDArray[float64]
    IntArray: TypeAlias = NDArray[int_]
else:  # NumPy is imported only when an array is requested.
    Array = FloatArray = IntArray = Any

# --- Arguments

Point = Iterable[SupportsFloat]
"""(x, y): a pair, or a row of a NumPy array."""

Polygon = Union[str, Iterable[Point]]
"""A text, or points: a list of pairs, or a NumPy array of two columns."""

Holes = Iterable[Iterable[Point]]
"""The vertices of each hole in a polygon."""

Metric = Literal["area", "circle", "distance", "distributed", "random", "balanced", "given"]
Goal = Literal["cover", "hold"]
Positions = Literal["best", "range"]
LengthUnit = Literal["m", "cm", "mm", "in"]
WeightUnit = Literal["kg", "t", "N", "lb"]
PoseFormat = Literal["csv", "json", "yaml"]
PoseOrigin = Literal["file", "com"]
Table = Literal["measurements", "aggregates", "polygons"]


class _Load(TypedDict):
    at: Point
    weight: float


class Cargo(_Load, total=False):
    """A load that is fixed to the object, at its own centre of mass."""

    name: str


class Settings(TypedDict, total=False):
    """The settings, which docs/cli.md in the repository explains. None means the default."""

    teams: Union[int, Literal["max"], None]
    metric: Optional[Metric]
    method: Optional[Metric]  # another name of metric
    min_ratio: Optional[float]
    weight: Optional[float]
    seed: Optional[int]
    robots: Optional[int]
    goal: Optional[Goal]
    min_margin: Optional[float]
    apart: Optional[float]
    clear: Optional[float]
    accuracy: Optional[float]
    survive: Optional[int]
    positions: Optional[Positions]
    robot: Optional[str]
    robot_radius: Optional[float]
    robot_reach: Optional[float]
    robot_depth: Optional[float]
    robot_width: Optional[float]
    robot_gap: Optional[float]
    no_go: Optional[str]
    supports: Union[str, Iterable[Point], None]  # sets the method to given
    snap: Optional[float]
    support_capacities: Union[str, Iterable[Optional[float]], None]
    cargo: Union[str, Iterable[Union[Cargo, tuple[Point, float], tuple[Point, float, str]]], None]
    com_radius: Optional[float]
    com_height: Optional[float]
    slope: Union[float, str, None]
    acceleration: Optional[float]
    give: Union[float, Literal["none"], None]
    uneven: Optional[float]
    extra: Union[float, Literal["none"], None]
    capacity: Union[float, Literal["none"], None]
    overlays: Optional[str]
    step: Union[int, Literal["none"], None]
    unit: Union[LengthUnit, Literal["none"], None]
    weight_unit: Optional[WeightUnit]


# --- Placements

Position = list[float]
"""[x, y]"""

Motion = Literal["clockwise", "counterclockwise", "translation"]
UnusableReason = Literal["no_go", "body", "arm", "corner", "hand", "hole", "near_no_go", "narrow"]


class Candidate(TypedDict):
    """A chord on which a team may stand."""

    ends: list[Position]
    ratio: float
    kind: Literal["bisecting", "vertex", "midpoint", "range"]


class Team(TypedDict):
    """The loads are None if given supports do not carry the object."""

    ends: list[Position]
    ratio: float
    loads: list[Optional[float]]


class Robot(TypedDict):
    """`at` is the lifting point, `team` counts from 0, and `heading` is in degrees. `load` is None if the object falls; `contact` and
    `heading` are None for a support beneath the object. Only given supports can be either."""

    at: Position
    team: int
    load: Optional[float]
    contact: Optional[Position]
    stand: Position
    heading: Optional[float]
    place: Literal["edge", "beneath"]


class LoadModels(TypedDict):
    springs: list[float]
    best: float
    worst: list[float]


class _Loads(TypedDict):
    min: float
    mean: float
    max: float
    spread: float
    max_share: float
    models: Optional[LoadModels]


class Loads(_Loads, total=False):
    """These members exist only with a C uncertainty, a slope, uneven ground, or an acceleration and a height of C. If a robot may go
    slack, all ranges extend from the least to the greatest load that statics allows."""

    ranges: list[list[float]]
    may_let_go: bool


class Tilt(TypedDict):
    """When the object tips in the worst direction. `slope` is a ratio and `acceleration` in g, each alone and on even ground.
    `acceleration_left` is the acceleration at which it tips on the given slope, None without a slope; `slope_left` is the slope at which
    it tips with the given acceleration, None without an acceleration."""

    height: float
    reach: float
    stays: bool
    slope: float
    degrees: float
    acceleration: float
    acceleration_left: Optional[float]
    slope_left: Optional[float]


class ExtraLoad(TypedDict):
    """Where a further load may stand. `anywhere` is None for any weight; all but the weight are None if the object falls."""

    weight: float
    region: Optional[list[Position]]
    share: Optional[float]
    anywhere: Optional[float]


class Closure(TypedDict):
    """`margin` is None without contacts, and `clearance` is None if no contact is beside a corner."""

    form_closure: bool
    margin: Optional[float]
    clearance: Optional[float]
    tolerance: Optional[float]
    second_order: bool
    free: list[Motion]
    clockwise: list[Position]
    counterclockwise: list[Position]


class Verdict(TypedDict):
    """`kind` is "bad" without robots, if the object falls or tips under the given conditions, or if a robot is or can be overloaded. The
    reasons are sentences, the most serious first; a good result has none."""

    kind: Literal["good", "warning", "bad"]
    reasons: list[str]


class Misfit(TypedDict):
    """A support, counted from 0, that does not fit. `why` is "outside", "arm", "hand", "no-go", or "too near robot 2", counted from 1."""

    robot: int
    why: str


class Requirement(TypedDict):
    condition: str
    value: Union[float, bool, None]
    kept: bool


class LimitedBy(TypedDict):
    what: Literal["fits", "stands", "hold", "capacity"]
    robots: list[int]
    edge: Optional[int]


class Accuracy(TypedDict):
    """How far all robots may be off. Each length is None if what it is about does not hold, or has no limit."""

    asked: float
    all_within: Optional[float]
    limited_by: Optional[LimitedBy]
    fits_within: Optional[float]
    stands_within: Optional[float]
    hold_within: Optional[float]
    capacity_within: Optional[float]


class _Robustness(TypedDict):
    com_margin: float
    failures_carried: int
    failures_steady: int
    failures_clear: int
    load_per_length: Optional[list[float]]


class Robustness(_Robustness, total=False):
    """The first two exist only with a com_radius above 0, the others also on slopes and uneven ground."""

    com_radius: float
    exact_within: Optional[float]
    plan_ranges: list[list[float]]
    springs_ranges: list[list[float]]


class _Failure(TypedDict):
    robot: int
    carried: bool
    steady: bool
    clear: bool
    com_margin: Optional[float]
    coverage: Optional[float]
    form_closure: Optional[bool]
    margin: Optional[float]
    plan_max: Optional[float]
    springs_max: Optional[float]
    best_max: Optional[float]
    springs: Optional[list[float]]


class Failure(_Failure, total=False):
    """The lift after `robot`, counted from 0, fails. All members after `clear` are None if the others do not carry the object;
    `over_capacity` exists only with a capacity, and the last two only if the loads have ranges. Where `stays` is False, the object tips
    under the given conditions, and `over_capacity` and `greatest_end` are None."""

    over_capacity: Optional[bool]
    greatest_end: Optional[float]
    stays: Optional[bool]


class FailurePlan(TypedDict):
    """The number of robots needed so that any one of them may fail: then C is at least `clear` inside, and the object stays upright and
    each robot within the capacity under the given conditions. `robots_tried` is 0 if no number was tried."""

    robots_needed: Optional[int]
    greatest_load: Optional[float]
    robots_tried: int


class Capacity(TypedDict):
    """`limit` is None if only single supports have a capacity. `overloaded` includes robots that can carry more than their capacity on
    slopes, when braked or on uneven ground."""

    limit: Optional[float]
    overloaded: list[int]
    teams_needed: Optional[int]
    greatest_load: Optional[float]
    teams_tried: int
    robots_needed: Optional[int]
    com_radius: Optional[float]
    if_one_fails: Optional[FailurePlan]
    use: Optional[float]


class RobotSize(TypedDict):
    radius: float
    reach: float
    depth: float
    width: float
    gap: float


class Overlays(TypedDict):
    candidates: bool
    chords: bool
    hull: bool
    clockwise: bool
    counterclockwise: bool
    tipping: bool
    halo: bool
    tilt: bool
    load: bool


class _CargoItem(TypedDict):
    at: Position
    weight: float


class CargoItem(_CargoItem, total=False):
    """A load as a result lists it."""

    name: str


class _PlacementDict(TypedDict):
    polygon: list[Position]
    centre_of_mass: Position
    own_centre_of_mass: Position
    total_weight: float
    metric: Metric
    min_ratio: float
    weight: float
    seed: int
    requested_teams: int
    teams: list[Team]
    hull: list[Position]
    coverage: float
    loads: Optional[Loads]
    closure: Closure
    goal: Goal
    goal_reached: bool
    stands: bool
    verdict: Verdict
    clear: Optional[float]
    tilt: Optional[Tilt]


class PlacementDict(_PlacementDict, total=False):
    """The output of `evenlift place --json`: a Placement has these members, and json.loads() of its text returns this type."""

    holes: list[list[Position]]
    cargo: list[CargoItem]
    unit: LengthUnit
    weight_unit: WeightUnit
    candidates: list[Candidate]
    robots: list[Robot]
    misfits: list[Misfit]
    tips_over: list[int]
    search_ended: bool
    requested_robots: int
    min_margin: float
    apart: Optional[float]
    survive: int
    positions: Literal["range"]
    supports: list[Position]
    snap: float
    support_capacities: list[Optional[float]]
    teams_asked: Union[int, Literal["max"]]
    overlays: Overlays
    moved: str
    robot: RobotSize
    no_go: str
    unusable: list[list[Union[float, UnusableReason]]]
    robustness: Robustness
    accuracy: Accuracy
    extra: ExtraLoad
    com_height: float
    slope: float
    acceleration: float
    give: float
    uneven: float
    failures: list[Failure]
    capacity: Capacity
    requirements: list[Requirement]


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


# --- Experiments


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


class Refused(TypedDict):
    polygon: str
    problem: str


class FigureSeries(TypedDict):
    """Each point is [robots, value, polygons]."""

    method: Metric
    points: list[list[float]]


class Figure(TypedDict):
    set: str
    id: str
    title: str
    unit: str
    column: str
    sentence: str
    series: list[FigureSeries]


class Claim(TypedDict):
    section: str
    what: str
    thesis: str
    ours: list[str]


class Claims(TypedDict):
    sets: list[str]
    rows: list[Claim]


class FewRobotsRow(TypedDict):
    what: str
    robots: int
    cells: list[str]


class FewRobots(TypedDict):
    set: str
    rows: list[FewRobotsRow]


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


# --- Errors


class Place(TypedDict, total=False):
    """The place of an error; one line below lists the members of one kind. Vertices and edges count from 0, all else from 1."""

    line: int
    column: int
    vertices: list[int]
    edges: list[int]
    rings: list[int]
    centre_of_mass: Literal[True]
    setting: str
    character: int
