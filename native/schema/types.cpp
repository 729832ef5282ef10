// All objects of results and requests, member by member. docs/write_types.py makes the types of the
// packages and the tables of docs/cli.md and docs/requests.md from them.
#include "schema/schema.h"

namespace evenlift::native {
namespace {

// --- Small objects

constexpr TypeMember support[] = {{"at", "Point", ""},
                                  {"capacity?", "number | null", "what this support can carry"},
                                  {"name?", "string", "at most 60 characters"}};
constexpr TypeMember cargo[] = {{"at", "Point", "its centre of mass, which may overhang"},
                                {"weight", "number", "1e-100 to 1e100"},
                                {"name?", "string", "at most 60 characters"}};
constexpr TypeMember cargo_item[] = {
    {"at", "Position", ""}, {"weight", "number", ""}, {"name?", "string", ""}};
constexpr TypeMember robot_size[] = {
    {"radius", "number", "of the round body"},
    {"reach", "number", "length of the arm, from the body to the contact"},
    {"depth", "number", "length of the hand, from the contact to the lifting point"},
    {"width", "number", "of the hand"},
    {"gap", "number", "free distance between two bodies"}};
constexpr TypeMember overlays[] = {{"candidates", "boolean", ""},
                                   {"chords", "boolean", ""},
                                   {"hull", "boolean", ""},
                                   {"clockwise", "boolean", ""},
                                   {"counterclockwise", "boolean", ""},
                                   {"tipping", "boolean", ""},
                                   {"halo", "boolean", ""},
                                   {"tilt", "boolean", ""},
                                   {"load", "boolean", ""}};

// --- Requests

constexpr TypeMember polygon_options[] = {
    {"holes?", "Point[][] | false | null",
     "the vertices of each hole, in place of those of the text; `false` leaves those out"},
    {"centre_of_mass?", "Point | null",
     "of the object without its cargo; `null` for the centroid. The default is the one in the text, or else the centroid"},
    {"own_centre_of_mass?", "Point | null",
     "the same by its name in results; it counts if both are given"},
    {"moved?", "string | null", "robots moved by hand on the page, as a result tells them"},
    {"shape?", "integer | string | null",
     "of a text with several shapes: the number, from 1, or name of one"},
    {"flatten?", "number | null",
     "of a drawing: greatest distance of edges from curves (default about 1/1000 of the shape)"},
    {"join?", "number | null",
     "of a drawing: greatest distance of ends that are joined (default up to 1/1000 of the drawing)"},
    {"project?", "boolean | null", "converts longitudes and latitudes in degrees to metres"}};
constexpr TypeMember place_options[] = {
    {"candidates?", "boolean | null", "lists the candidates"},
    {"failures?", "boolean | null", "the effect of each robot's failure"},
    {"even_out?", "boolean | null",
     "moves two or three supports to the edge so that all carry the same load"},
    {"keep_misfits?", "boolean | null",
     "leaves out supports and holes that do not fit the object, instead of refusing it"},
    {"cases?", "boolean | null", "[the loads in each case](who-bears-what.md#cases)"},
    {"require?", "string", "[conditions](cli.md#conditions), such as `held, max<=20`"}};
constexpr TypeMember weight_options[] = {
    {"weight_per_area?", "number | string | null",
     "the weight from the area, in place of `weight`: of each square unit, or such as `15.6/m2`"},
    {"thickness?", "number | string | null",
     "the weight from the area, this thickness and `density`"},
    {"density?", "number | string | null", "of each cubic unit, or such as `7850/m3`"}};
constexpr TypeMember parts_options[] = {
    {"sort?", R"("file" | "number" | "name" | "area" | "weight" | "load")",
     "the order of the parts, default `file`"}};
constexpr TypeMember svg_options[] = {{"candidates?", "boolean | null", "shows the candidates"},
                                      {"keep_misfits?", "boolean | null",
                                       "leaves out supports and holes that do not fit the object"}};
constexpr TypeMember poses_options[] = {
    {"format?", R"("csv" | "json" | "yaml")", "default `json`; `yaml` is a PoseArray of ROS 2"},
    {"frame?", "string", "the frame's name, default `object`"},
    {"origin?", R"("file" | "com")", "default `file`"}};
constexpr TypeMember shapes_options[] = {
    {"holes?", "boolean | null", "`false` leaves them out"},
    {"flatten?", "number | null", "greatest distance of edges from curves"},
    {"join?", "number | null", "greatest distance of ends that are joined"},
    {"project?", "boolean | null", "converts longitudes and latitudes in degrees to metres"}};
constexpr TypeMember experiment_options[] = {
    {"min_ratio?", "number", "default 0.8"},
    {"samples?", "integer", "random placements of each polygon, default 200"},
    {"max_teams?", "integer", "default 1000"},
    {"max_balanced?", "integer", "balanced robots, default 12"}};
constexpr TypeMember request[] = {
    {"command?", R"("place" | "candidates" | "svg" | "poses" | "link" | "optimum" | "trace")",
     "default `place`"},
    {"polygon?", "Point[]",
     "the vertices, clockwise or counter-clockwise; a last one that repeats the first is left out, with a notice"},
    {"text?", "string",
     "in place of `polygon`: a file of any format that the program reads, or a share link"},
    {"bytes?", "string", "the same in base64, for a file that is not UTF-8"},
    {"document?", "object",
     "in place of `polygon`: a result or document of evenlift, with its settings"},
    {"settings?", "Settings", "settings may also stand in an object of their own"},
    {"candidates?", "boolean | null", ""},
    {"failures?", "boolean | null", ""},
    {"even_out?", "boolean | null", ""},
    {"keep_misfits?", "boolean | null", ""},
    {"require?", "string", ""},
    {"format?", R"("csv" | "json" | "yaml")", ""},
    {"frame?", "string", ""},
    {"origin?", R"("file" | "com")", ""}};
constexpr std::string_view of_polygon[] = {"Settings", "PolygonOptions"};
constexpr std::string_view of_placement[] = {"Settings", "PolygonOptions", "WeightOptions"};
constexpr std::string_view of_parts[] = {"PlaceOptions"};

// --- Placements

constexpr TypeMember candidate[] = {
    {"ends", "Position[2]", ""},
    {"ratio", "number", "the shorter half divided by the longer one"},
    {"kind", R"("bisecting" | "vertex" | "midpoint" | "range")",
     "`range` only with `positions` `range`, or for robots with a size"}};

constexpr TypeMember team[] = {
    {"ends", "Position[]",
     "the left end first (the lower end of a vertical chord). `balanced` gives one team with an end for each robot, "
     "counter-clockwise along the outline from the vertex farthest from C, and `given` one in the order of the supports"},
    {"ratio", "number",
     "the load ratio; of `balanced` robots the least load divided by the greatest"},
    {"loads", "(number | null)[]", "in the order of the ends; `null` if the object falls"}};

constexpr TypeMember robot[] = {
    {"at", "Position", "the lifting point"},
    {"team", "integer", "counted from 0"},
    {"load", "number | null", "`null` if the object falls"},
    {"contact", "Position | null", "where it touches the boundary; `null` beneath the object"},
    {"stand", "Position", "the middle of its body; without a size the three are one point"},
    {"heading", "number | null",
     "the direction of the inward normal in degrees, above −180 and up to 180 (at a vertex, the bisector of the normals of "
     "its two edges); `null` beneath the object"},
    {"place", R"("edge" | "beneath")", "only a support stands beneath"},
    {"name?", "string", "of a support, if it has one"},
    {"support?", "integer", "its number among `supports`, counted from 0, if some are left out"}};
constexpr TypeMember left_out[] = {
    {"kind", R"("support" | "hole")", ""},
    {"index", "integer", "counted from 0"},
    {"in_hole", "integer | null", "the hole that the support is in; `null` outside the object"}};

constexpr TypeMember load_models[] = {
    {"springs", "number[]", "in the order of `robots`, like `worst`"},
    {"best", "number", "the least possible greatest load"},
    {"worst", "number[]", ""}};

constexpr TypeMember loads[] = {
    {"min", "number", "as planned, like the next four"},
    {"mean", "number", ""},
    {"max", "number", ""},
    {"spread", "number", "`max` − `min`"},
    {"max_share", "number", "the greatest share of a team's load that one robot carries"},
    {"models", "LoadModels | null",
     "the loads by the other models; `null` if rounding moves C outside the lifting base"},
    {"ranges?", "number[2][]",
     "with a C uncertainty, a slope, an acceleration (and a height of C), uneven ground (and a give) or an accuracy only: "
     "the least and the greatest load of each robot as planned. With an accuracy they include what loads may change, to "
     "first order, if all robots are off by it (tables, verdicts and `capacity` do not: they tell `accuracy` in its own "
     "sentence). They [presume](who-bears-what.md#where-is-the-centre-of-mass) that the robots are set to their planned "
     "loads, then keep their heights and yield like equally stiff springs"},
    {"may_let_go?", "boolean",
     "with `ranges` only: whether a robot may go slack. Then every load lies between the least and the greatest that "
     "statics allows, with the weight acting anywhere within reach"}};

constexpr TypeMember depends_on[] = {{"robot", "integer", "counted from 0"},
                                     {"distance", "number", "of its contact from a corner"}};

constexpr TypeMember closure[] = {
    {"form_closure", "boolean",
     "whether no motion is free to first order if robots keep their formation and can push sideways; contacts at convex "
     "vertices are not counted"},
    {"margin", "number | null",
     "strength of the hold; positive in form closure, `null` without contacts. It is the largest-ball measure with one "
     "limit for the sum of all contact forces. It depends on C and R, so use it only to compare placements of one object"},
    {"clearance", "number | null",
     "greatest distance such that the hold needs no contact nearer than this to a corner; `null` if it needs no contact "
     "beside a corner, and 0 without form closure"},
    {"tolerance", "number | null",
     "form closure remains if all robots are off by less than this at once, each along the outline, if robots in inward "
     "corners stay there; `null` if it remains in any case, and 0 without form closure"},
    {"second_order", "boolean",
     "whether the object is immobile although first-order motions are free"},
    {"free", "Motion[]", "the motions that are free; empty in form closure"},
    {"slides", "Position | null",
     "a direction of unit length in which it can slide; `null` if it cannot"},
    {"depends_on", "DependsOn | null",
     "the robot on whose accuracy the hold depends, since its contact is at the distance `clearance` from a corner"},
    {"clockwise", "Position[]",
     "corners of the region of free centres of clockwise rotation whose distance from C, in x and in y, is at most 100 "
     "times the diagonal of the bounding box; may be empty (even if the region continues farther out), one point or two "
     "points. Clockwise assumes that x points right and y up"},
    {"counterclockwise", "Position[]", "the same for counter-clockwise rotation"}};

constexpr TypeMember limited_by[] = {
    {"what", R"("fits" | "stands" | "hold" | "capacity")", ""},
    {"robots", "integer[]", "those that it depends on, counted from 0"},
    {"edge", "integer | null", "where one has no more room"}};

constexpr TypeMember accuracy[] = {{"asked", "number", "the setting"},
                                   {"all_within", "number | null", "the least of the last four"},
                                   {"limited_by", "LimitedBy | null", ""},
                                   {"fits_within", "number | null", "robots off by this still fit"},
                                   {"stands_within", "number | null", "the object still stands"},
                                   {"hold_within", "number | null", "they still hold it"},
                                   {"capacity_within", "number | null", "none is overloaded"}};

constexpr TypeMember robustness[] = {
    {"com_margin", "number",
     "tipping distance: the least distance by which C must be off for the object to tip, if robots push back and none is "
     "overloaded; 0 with one team of two. If the object falls, minus the distance of C from the lifting base"},
    {"failures_carried", "integer",
     "number of robots that may fail at once, whichever they are, while the others, if strong enough, still carry the "
     "object at rest; −1 if it falls already"},
    {"failures_steady", "integer",
     "the number of failures, of whichever robots, after which C is still inside the others' convex hull by more than "
     "[τL](algorithm.md#terms); −1 if C is not that far inside even with all robots, as with one team"},
    {"failures_clear", "integer",
     "the number of failures after which C is still at least `clear` inside"},
    {"load_per_length", "number[] | null",
     "for each robot: the greatest change in its load by springs per unit of length that C moves; `null` if `models` is"},
    {"com_radius?", "number", "with a C uncertainty only: as given"},
    {"exact_within?", "number | null",
     "with a C uncertainty only: the distance that C may be off while the same robots carry the object"},
    {"plan_ranges?", "number[2][]", "the same as `loads.ranges`"},
    {"springs_ranges?", "number[2][]", "the same by springs"}};

constexpr TypeMember tilt[] = {
    {"height", "number", "H"},
    {"reach", "number",
     "how far from C the weight may act, E + H (S + A √(1 + S²)), where S includes the tilt by uneven heights"},
    {"stays", "boolean", "whether the object stays upright then"},
    {"slope", "number",
     "the slope, as a ratio, at which it tips in the worst direction; this and the next two each alone, on level, even "
     "ground and with C off by up to E"},
    {"degrees", "number", "the same as an angle"},
    {"acceleration", "number", "in g"},
    {"acceleration_left", "number | null",
     "at which it tips on the given slope; `null` without one"},
    {"slope_left", "number | null",
     "at which it tips with the given acceleration; `null` without one"}};

constexpr TypeMember extra[] = {
    {"weight", "number", "as given; all else is `null` if the object falls"},
    {"region", "Position[] | null",
     "corners of the convex polygon within the object's bounding box in which the weight lifts no robot off and overloads "
     "none"},
    {"share", "number | null", "the share of the object's area in it"},
    {"anywhere", "number | null",
     "the greatest weight that may stand anywhere on the object; `null` for any weight"}};

constexpr TypeMember verdict[] = {
    {"kind", R"("good" | "warning" | "bad")",
     "`bad` if there are no robots, the object falls, it tips under the given conditions, or a robot carries, or within "
     "these conditions can carry, more than its capacity as planned; `warning` if a support or hole is left out, there are "
     "fewer teams than requested, a robot does not fit, the coverage is below 0.5, C is not clearly inside the lifting base, "
     "the object is not `held`, or something may end with robots off by `accuracy`; otherwise `good`"},
    {"reasons", "string[]", "sentences, the most serious first; none if it is good"},
    {"codes", "VerdictCode[]", "what each of these sentences is about"}};

constexpr TypeMember misfit[] = {
    {"robot", "integer", "counted from 0"},
    {"why", "string",
     "`outside` (no room for the body), `arm` (it would cross the object), `hand` (it would stick out of the object), "
     "`hole` (it would reach into a hole), `no-go`, or, for two that collide, `too near robot 2`, counted from 1"},
    {"other?", "integer", "of two that collide, the other one, counted from 0"}};

constexpr TypeMember failure[] = {
    {"robot", "integer", "counted from 0"},
    {"carried", "boolean",
     "whether the others carry the object; otherwise all members after `clear` are `null`"},
    {"steady", "boolean", "whether C is inside their convex hull by more than τL"},
    {"clear", "boolean", "whether C is at least `clear` inside"},
    {"com_margin", "number | null", ""},
    {"coverage", "number | null", ""},
    {"form_closure", "boolean | null", ""},
    {"margin", "number | null", "also `null` if there are no contacts"},
    {"plan_max", "number | null",
     "greatest load as planned; also `null` if there is no other team"},
    {"springs_max", "number | null", ""},
    {"best_max", "number | null", ""},
    {"springs", "number[] | null",
     "the load of each robot by springs, 0 for the failed one; `null` for more than 64 robots, for which all failures "
     "together would have millions of loads"},
    {"over_capacity?", "boolean | null",
     "with capacities only: whether one of the others carries more than its capacity by springs, under the given "
     "conditions; `null` if it does not stay upright under them"},
    {"overloaded?", "integer[] | null", "with capacities only: these robots, counted from 0"},
    {"greatest_end?", "number | null",
     "only if `loads.ranges` exists: the greatest load within the given conditions; `null` if it does not stay"},
    {"stays?", "boolean | null",
     "only if `loads.ranges` exists: whether the object stays upright under the given conditions"}};

constexpr TypeMember failure_plan[] = {
    {"robots_needed", "integer | null",
     "the least number of robots found with which, under the given conditions, none carries more than the limit, both as "
     "planned with all robots working and by springs after any one has failed, and C is then at least `clear` inside the "
     "lifting base of the others; `null` if no number was found"},
    {"greatest_load", "number | null", "with that number"},
    {"robots_tried", "integer", "the greatest number of robots tried, 0 if none was"}};

constexpr TypeMember capacity[] = {
    {"limit", "number | null", "the common limit, or `null` if only single supports have one"},
    {"overloaded", "integer[]",
     "the robots whose planned load exceeds their limit; on slopes, when braked or on uneven ground, those whose greatest "
     "end in `loads.ranges` does (`robustness.plan_ranges` also shows which may exceed it if C is anywhere within "
     "`com_radius`). Robot 2 *t* + *e* is at end *e* of team *t*, all counted from 0"},
    {"teams_needed", "integer | null",
     "the least number of teams that keeps every robot within the limit; `null` if there is none. With `given` this and "
     "the next three contain no plan: they are `null`, and 0 for the numbers tried"},
    {"greatest_load", "number | null", "with that number"},
    {"teams_tried", "integer",
     "the last number of teams tried: at most 512, or 32 for teams that are swapped until they hold, or all teams that "
     "find a place; 1 for balanced robots"},
    {"robots_needed", "integer | null",
     "the number of robots in these teams; for balanced robots the least number, up to 64, that the weight and `survive` "
     "need"},
    {"com_radius", "number | null",
     "the greatest C uncertainty with which every load by springs stays within the limit; `null` if a load is already "
     "beyond it"},
    {"if_one_fails", "FailurePlan | null",
     "on the page `null` for balanced robots until it has been computed, since each number requires a search"},
    {"use", "number | null",
     "the greatest use of a robot, under all given conditions; `null` if the object falls or tips under them"}};

constexpr TypeMember requirement[] = {
    {"condition", "string", ""},
    {"value", "number | boolean | null", "`null` if there is none"},
    {"kept", "boolean", ""}};

constexpr TypeMember effective[] = {
    {"clear", "number",
     "the setting, or its default of 2 % of R; with `given` less by 1e-4 L, since places that are typed have few digits"},
    {"apart", "number", "the setting, or its default of 12 % of R"},
    {"snap", "number", "the setting, or its default of 1e-4 L"}};

constexpr TypeMember weighing[] = {
    {"weight", "number", "of the object with its cargo"},
    {"weight_error", "number", "how far it may be off"},
    {"centre_of_mass", "Position", "of the object with its cargo"},
    {"radius", "number",
     "how far that may be off: by errors of readings, `accuracy`, and the height of C times `level_error`"},
    {"residuals", "number[] | null",
     "by how much each reading differs from what equally stiff supports on even ground would read; `null` if fewer than "
     "four carry"},
    {"fit", "boolean | null",
     "whether errors of readings, and uneven ground if it is given, explain these"},
    {"suspect", "integer | null",
     "if they do not: the support whose wrong reading would explain most, counted from 0, if it is the only one of at "
     "least five that carry"},
    {"too_little", "number[] | null",
     "if they do not: by how much each support reads too little if its reading alone is wrong"},
    {"height", "number | null", "of C above the lifting points, from a second weighing on a slope"},
    {"height_error", "number | null", "how far that may be off"},
    {"height_fits", "boolean | null",
     "whether the second readings add up to the same weight, or to its part across the slope"}};

constexpr TypeMember load_case[] = {
    {"name", R"("level" | "com" | "slope" | "acceleration" | "uneven" | "all" | "failure")",
     "the condition that alone counts; all of them; or all of them after a robot has failed"},
    {"failed", "integer | null", "that robot, counted from 0"},
    {"greatest", "number | null",
     "the greatest load, as planned; after a failure by springs. `null` if the object falls or can tip"},
    {"robot", "integer | null", "whose it is"},
    {"least", "number | null", "the least load; after a failure only without conditions"},
    {"use", "number | null", "the greatest use of a robot"},
    {"stays", "boolean", "whether the object stands and cannot tip"}};

constexpr TypeMember evened_out[] = {{"robot", "integer", "counted from 0"},
                                     {"from", "Position", "where the support stood"},
                                     {"to", "Position", ""},
                                     {"by", "number", "the distance"}};

constexpr TypeMember placement[] = {
    {"polygon", "Position[]", "as given"},
    {"holes?", "Position[][]", "only if there are any: as given"},
    {"centre_of_mass", "Position", "of the object with its cargo, to which everything else refers"},
    {"own_centre_of_mass", "Position",
     "of the object alone; given to a request, it is the centre of mass of the object without cargo"},
    {"total_weight", "number", "with the cargo, from which all loads are computed"},
    {settings_as_used, "", ""},
    {"candidates?", "Candidate[]",
     "if they are asked for: in order of slope, for every method, even if it does not use candidates"},
    {"requested_teams", "integer",
     "with `max` the number of candidates, and with `balanced` and `given` 1"},
    {"teams", "Team[]", "in the order of selection"},
    {"robots?", "Robot[]",
     "team by team; missing without a team, like `robustness` and `accuracy`"},
    {"hull", "Position[]",
     "corners of the lifting base, counter-clockwise; empty if there is no team"},
    {"coverage", "number", "0 to 1"},
    {"loads", "Loads | null", "`null` if there is no team or the object falls"},
    {"closure", "Closure", ""},
    {"goal", "Goal", ""},
    {"goal_reached", "boolean",
     "whether robots are placed and, with the goal `hold`, are in firm form closure"},
    {"stands", "boolean",
     "whether the robots can carry the object: the centre of mass is in the lifting base. Only supports can fail this, or "
     "a placement without robots"},
    {"held", "boolean",
     "whether the robots hold the object: in form closure with a clearance of at least `clear` and a tolerance of at least "
     "half of that and of at least `accuracy`, or to second order"},
    {"verdict", "Verdict", "the page's judgement"},
    {"left_out?", "LeftOut[]",
     "with `keep_misfits` only: supports and holes that do not fit the object, and do not count"},
    {"misfits?", "Misfit[]", "with `given` only: the supports that do not fit"},
    {"tips_over?", "integer[]",
     "with `given`, and only if the object falls: the one or two robots over which it tips, counted from 0"},
    {"search_ended?", "boolean",
     "with `balanced`: `false` if the search was cut short, which happens on large, strongly winding outlines and with many "
     "robots, or while the page is still searching. For teams that are swapped until they hold, `false` if the swaps were "
     "cut short; otherwise missing"},
    {"teams_asked?", R"(integer | "max")",
     "only if `requested_teams` differs from the request: `max`, or with `balanced` and `given` a link's number of teams "
     "for the other methods, unless it is 3. Used when the result is reopened"},
    {"overlays?", "Overlays", "from a link or the page, unless all are at their defaults"},
    {"moved?", "string",
     "from a link with robots moved by hand on the page: their places, in the form used in "
     "[the link](link-format.md#5-records-of-version-2-only)"},
    {"robot?", "RobotSize",
     "this and the next two only if robots have a size, or there are no-go edges"},
    {"no_go?", "string", ""},
    {"unusable?", "(integer, number, number, UnusableReason)[]",
     "the parts of edges that robots cannot use: the edge, counted from 1, from where to where, from 0 to 1, and "
     "[why](stands.md#where-an-edge-can-be-used)"},
    {"robustness?", "Robustness", ""},
    {"accuracy?", "Accuracy", "[how far robots may be off](#how-far-robots-may-be-off)"},
    {"failures?", "Failure[]", "if they are asked for"},
    {"tilt", "Tilt | null", "when the object tips; `null` without a height of C"},
    {"extra?", "ExtraLoad", "with `extra` only"},
    {"weighing?", "Weighing", "with `readings` only"},
    {"use?", "(number | null)[]",
     "with capacities only: how much of each robot is used, its greatest planned load under all given conditions, times "
     "`dynamic` and 1 + `weight_doubt`, divided by its capacity; `null` without one"},
    {"cases?", "LoadCase[]",
     "with `cases` only: [the loads in each case](who-bears-what.md#cases)"},
    {"capacity?", "Capacity", "with `capacity` or a support's own capacity only"},
    {"requirements?", "Requirement[]", "if conditions are required"},
    {"effective", "Effective", "lengths that settings have here, whether or not they are set"},
    {"evened_out?", "EvenedOut[]", "with `even_out` only: the supports that were moved"},
    {"notices?", "string[]",
     "of requests only: what was left out of polygon or text, such as third coordinates"},
    {"version", "string", "of evenlift"}};

// --- Other answers

constexpr TypeMember greedy[] = {{"taken", "integer[]", "candidates, counted from 0"},
                                 {"coverage", "number", ""}};
constexpr TypeMember widest[] = {
    {"taken", "integer[]", ""},
    {"coverage", "number", ""},
    {"bound", "number", "no choice covers more"},
    {"proved", "boolean", "whether no choice covers more than this one"}};
constexpr TypeMember to_hold[] = {{"taken", "integer[]", ""},
                                  {"level", "integer", "of the hold, from 0 (none) to 3"},
                                  {"coverage", "number", ""},
                                  {"most_level", "integer", "no choice has a higher one"},
                                  {"bound", "number", "no choice with that level covers more"},
                                  {"proved", "boolean", "whether no choice is better"}};
constexpr TypeMember optimum[] = {{"teams", "integer", ""},
                                  {"candidates", "integer", "their number"},
                                  {"greedy", "GreedyChoice", "the choice that is placed"},
                                  {"optimum", "WidestChoice", "the widest choice that was found"},
                                  {"hold?", "HoldingChoice", "with the goal `hold` only"},
                                  {"notices?", "string[]", ""}};

constexpr TypeMember imported[] = {
    {"name", "string", "of the object or its layer; empty if there is none"},
    {"kind", "string", "in words, such as `rectangle`"},
    {"sheet", "boolean", "whether it is the sheet of a drawing rather than a part on it"},
    {"tolerance", "number | null", "greatest distance of edges from curves; `null` without curves"},
    {"document", "object", "outline, holes, cargo and settings: a polygon for all other requests"}};
constexpr TypeMember shapes[] = {
    {"format", "string", "such as `DXF`"},
    {"unit", "string", "in words, such as `millimetres`; empty if the text names none"},
    {"doubtful", "boolean", "whether what does not close is larger than the largest shape"},
    {"notices", "string[]", "omissions and decisions"},
    {"shapes", "ImportedShape[]", "one or more; in a drawing the largest first, and sheets last"}};

constexpr TypeMember part[] = {{"shape", "integer", "its number in the file, from 1"},
                               {"name", "string", "unique, or empty"},
                               {"at", "Position", "the middle of its bounding box"},
                               {"size", "Position", "the width and height of that box"},
                               {"area", "number", "without holes"}};
constexpr TypeMember refused_part[] = {{"error", "Problem", "in place of a placement"}};
constexpr std::string_view of_part[] = {"Part"}, of_placed_part[] = {"Part", "Placement"};
constexpr TypeMember parts[] = {
    {"notices", "string[]", "omissions and decisions"},
    {"parts", "(PlacedPart | RefusedPart)[]", "the lines of `evenlift place --shape all --json`"},
    {"csv", "string", "the rows of `--csv`"}};

constexpr TypeMember figure_series[] = {{"method", "Metric", ""},
                                        {"points", "number[3][]", "robots, value, polygons"}};
constexpr TypeMember figure[] = {{"set", "string", ""},           {"id", "string", ""},
                                 {"title", "string", ""},         {"unit", "string", ""},
                                 {"column", "string", ""},        {"sentence", "string", ""},
                                 {"series", "FigureSeries[]", ""}};
constexpr TypeMember claim[] = {{"section", "string", "of the thesis"},
                                {"what", "string", ""},
                                {"thesis", "string", "what it states"},
                                {"ours", "string[]", "our measurements, one text for each set"}};
constexpr TypeMember claims[] = {{"sets", "string[]", ""}, {"rows", "Claim[]", ""}};
constexpr TypeMember few_robots_row[] = {
    {"what", "string", ""}, {"robots", "integer", ""}, {"cells", "string[]", ""}};
constexpr TypeMember few_robots[] = {{"set", "string", ""}, {"rows", "FewRobotsRow[]", ""}};
constexpr TypeMember refused[] = {{"polygon", "string", ""}, {"problem", "string", ""}};
constexpr TypeMember experiment[] = {
    {"measurements", "string", "CSV, like the next two"},
    {"aggregates", "string", ""},
    {"polygons", "string", ""},
    {"thesis", "string", "Markdown"},
    {"refused", "Refused[]", "polygons that could not be measured"},
    {"figures", "Figure[]", ""},
    {"claims", "Claims", ""},
    {"few_robots", "FewRobots[]", ""}};

constexpr TypeMember place[] = {
    {"line?", "integer", "of the text, counted from 1"},
    {"column?", "integer", "in characters, counted from 1"},
    {"vertices?", "integer[]", "one or two, counted from 0"},
    {"edges?", "integer[]", "one or two, counted from 0: edge i runs from vertex i"},
    {"rings?", "integer[]", "of these, or a whole ring: 0 is the outline, 2 the second hole"},
    {"centre_of_mass?", "true", ""},
    {"setting?", "string", "a setting or another member, or its path, such as `supports[3]`"},
    {"character?", "integer", "in a link, counted from 1; 0 is the whole link"}};
constexpr TypeMember error[] = {
    {"code", "string", "one word for programs"},
    {"message", "string", "the sentence that the program prints"},
    {"place", "Place | null", ""},
    {"path", "string | null",
     "of the member at fault, counted from 0: `cargo[2].weight`, `polygon[3]`"}};

constexpr Type types[] = {
    {"Point",
     "A point of a request: x to the right, y up; a third coordinate is left out, with a notice.",
     {},
     "number[2] | number[3]"},
    {"Position", "[x, y] of a result.", {}, "number[2]"},
    {"Support", "A robot that already stands.", support},
    {"Cargo", "A load that is fixed to the object.", cargo},
    {"CargoItem", "A load as a result lists it.", cargo_item},
    {"RobotSize", "The size of a robot.", robot_size},
    {"Overlays", "What a picture shows.", overlays},
    {"PolygonOptions", "What a request may say of its polygon.", polygon_options, {}, {}, true},
    {"Options", "Settings, and what a request may say of its polygon.", {}, {}, of_polygon},
    {"WeightOptions", "The weight from the area.", weight_options, {}, {}, true},
    {"PlaceOptions", "What a placement may be asked.", place_options, {}, of_placement},
    {"PartsOptions", "What all parts may be asked.", parts_options, {}, of_parts},
    {"SvgOptions", "What a picture may be asked.", svg_options, {}, of_polygon},
    {"PosesOptions", "How robots' poses are written.", poses_options, {}, of_polygon},
    {"ShapesOptions", "How a file is read.", shapes_options},
    {"ExperimentOptions", "What an experiment measures.", experiment_options},
    {"Request", "A request about one polygon.", request, {}, of_placement},
    {"Candidate", "A chord on which a team may stand.", candidate},
    {"Team", "A team of robots.", team},
    {"Robot", "A robot.", robot},
    {"LoadModels", "The loads by the models springs, best and worst.", load_models},
    {"Loads", "The loads.", loads},
    {"Motion", "", {}, R"("clockwise" | "counterclockwise" | "translation")"},
    {"DependsOn", "", depends_on},
    {"Closure", "How the robots' contact alone holds the object.", closure},
    {"LimitedBy", "", limited_by},
    {"Accuracy",
     "How far all robots may be off. Each length is null if what it is about does not hold, or has no limit.",
     accuracy},
    {"Robustness", "What the placement survives.", robustness},
    {"Tilt", "When the object tips, in the worst direction.", tilt},
    {"ExtraLoad", "Where a further load may stand.", extra},
    {"VerdictCode",
     "",
     {},
     R"("no_place" | "falls" | "tips" | "overloaded" | "left_out" | "misfit" | "fewer_teams" | "not_upright" | "low_coverage" | "not_held" | "inaccurate")"},
    {"Verdict", "Whether the placement is good, and if not, why.", verdict},
    {"Misfit", "A support that does not fit.", misfit},
    {"Failure", "What happens if this robot fails.", failure},
    {"FailurePlan", "The robots needed so that any one of them may fail.", failure_plan},
    {"Capacity", "What robots can carry, and how many are needed.", capacity},
    {"Requirement", "A condition, and whether it is kept.", requirement},
    {"UnusableReason",
     "",
     {},
     R"("no_go" | "body" | "arm" | "corner" | "hand" | "hole" | "near_no_go" | "narrow")"},
    {"Effective", "The values of settings whose defaults depend on the object.", effective},
    {"Weighing", "What the readings of supports tell.", weighing},
    {"LoadCase", "A case of loading.", load_case},
    {"LeftOut", "A support or a hole that does not fit the object.", left_out},
    {"EvenedOut", "A support that was moved to even out the loads.", evened_out},
    {"Placement", "What evenlift place --json prints.", placement},
    {"GreedyChoice", "", greedy},
    {"WidestChoice", "", widest},
    {"HoldingChoice", "", to_hold},
    {"Optimum", "How far the greedy choice of teams is from the best one.", optimum},
    {"ImportedShape", "A shape of a drawing or table.", imported},
    {"Shapes", "The shapes of a file.", shapes},
    {"Part", "A part of a drawing.", part, {}, {}, true},
    {"PlacedPart", "A part with its robots.", {}, {}, of_placed_part},
    {"RefusedPart", "A part that is refused.", refused_part, {}, of_part},
    {"Parts", "All parts of a drawing.", parts},
    {"FigureSeries", "", figure_series},
    {"Figure", "A figure of the thesis's chapter 5.", figure},
    {"Claim", "A statement of the thesis.", claim},
    {"Claims", "The thesis's statements beside our measurements.", claims},
    {"FewRobotsRow", "", few_robots_row},
    {"FewRobots", "", few_robots},
    {"Refused", "", refused},
    {"Experiment", "The measurements of the thesis's chapter 5.", experiment},
    {"Place", "The place of an error, of one of these kinds.", place},
    {"Problem", "Why a part is refused.", error},
    {"Error", "A request that is refused.", error}};

}  // namespace

std::span<const Type> described_types() { return types; }

}  // namespace evenlift::native
