"""Writes the types of the packages and the tables of the manual from `evenlift --schema`.

    python3 docs/write_types.py PROGRAM [--check]

It writes npm/evenlift.d.ts (its functions are in npm/functions.d.ts), python/src/evenlift/types.py and _members.pyi, and
the tables between the marks `<!-- types: NAME … -->` and `<!-- end -->` in docs. With --check it writes nothing, and fails
if a file is not what it would write.
"""

import json
import keyword
import pathlib
import re
import subprocess
import sys

root = pathlib.Path(__file__).resolve().parents[1]
made_by = "docs/write_types.py writes this file from `evenlift --schema`."

# Of requests. Their lists may be any sequences, and their numbers any numbers.
arguments = {"Point", "Support", "Cargo", "Settings", "PolygonOptions", "Options", "WeightOptions", "PlaceOptions", "PartsOptions", "SvgOptions", "PosesOptions", "ShapesOptions", "ExperimentOptions"}  # fmt: skip
not_typed = {"Request", "Error"}  # the packages' functions and errors have types of their own


def name_of(reference):
    return reference.rsplit("/", 1)[1]


def choices(schema):
    """The schemas of which a value has one, without unions in unions."""
    return [each for one in schema["anyOf"] for each in choices(one)] if "anyOf" in schema else [schema]


def items_of(schema):
    """The schemas of the items of a list of fixed length, else None."""
    if "prefixItems" in schema:
        return schema["prefixItems"]
    return [schema["items"]] * schema["maxItems"] if "maxItems" in schema else None


def is_object(schema):
    return schema.get("type") == "object" and "properties" in schema


def plain(text):
    """Without links, for comments in code."""
    return re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", text)


def sentence(text):
    text = plain(text)
    return text[:1].upper() + text[1:] + ("" if text.endswith(".") else ".")


# --- TypeScript


def ts_type(schema, given):
    if "$ref" in schema:
        return name_of(schema["$ref"])
    if "anyOf" in schema:
        return " | ".join(dict.fromkeys(ts_type(each, given) for each in choices(schema)))
    if "enum" in schema:
        return " | ".join(map(json.dumps, schema["enum"]))
    if "const" in schema:
        return json.dumps(schema["const"])
    if schema["type"] == "array":
        fixed = items_of(schema)
        if fixed is not None:
            listed = f"[{', '.join(ts_type(each, given) for each in fixed)}]"
        else:
            item = ts_type(schema["items"], given)
            listed = f"({item})[]" if " | " in item or item.startswith("readonly") else f"{item}[]"
        return f"readonly {listed}" if given else listed
    return {"integer": "number", "object": "Record<string, unknown>"}.get(schema["type"], schema["type"])


def ts_comment(text, indent=""):
    return f"{indent}/** {sentence(text)} */\n" if text else ""


def ts_member(name, schema, required, given):
    # JSON has no BigInt; the package writes its digits.
    kind = ("number | bigint | string | null" if name == "seed" and given else ts_type(schema, given))
    return f"{ts_comment(schema.get('description', ''), '  ')}  {name}{'' if name in required else '?'}: {kind};\n"


def ts_definition(name, schema):
    given = name in arguments
    head = ts_comment(schema.get("description", ""))
    if not is_object(schema):
        return f"{head}export type {name} = {ts_type(schema, given)};\n"
    others = ", ".join(name_of(each["$ref"]) for each in schema.get("allOf", []))
    members = "".join(ts_member(each, of, schema.get("required", []), given) for each, of in schema["properties"].items())
    return f"{head}export interface {name}{' extends ' + others if others else ''} {{\n{members}}}\n"


def typescript(types):
    functions = (root / "npm/functions.d.ts").read_text(encoding="utf-8")
    head = f"/** Finds places for robots that lift a polygon together, with nearly equal loads. */\n\n// {made_by}\n\n"
    return head + "\n".join([ts_definition(name, of) for name, of in types.items() if name not in not_typed] + [functions])


# --- Python

python_names = {"Placement": "PlacementDict"}  # the package's Placement is a class

python_head = f'''"""The types of evenlift's arguments and results, for type checkers and for code that reads results from files.

docs/cli.md in the repository explains each member of a result. Classes with a leading underscore contain the members that always
exist. {made_by}
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

'''


def python_type(schema, given):
    if "$ref" in schema:
        name = name_of(schema["$ref"])
        return python_names.get(name, name)
    if "anyOf" in schema:
        each = list(dict.fromkeys(python_type(one, given) for one in choices(schema)))
        rest = [one for one in each if one != "None"]
        union = f"Union[{', '.join(rest)}]" if len(rest) > 1 else rest[0]
        return f"Optional[{union}]" if "None" in each else union
    if "enum" in schema:
        return f"Literal[{', '.join(map(json.dumps, schema['enum']))}]"
    if "const" in schema:
        return f"Literal[{schema['const']!r}]" if isinstance(schema["const"], bool) else f"Literal[{json.dumps(schema['const'])}]"
    if schema["type"] == "array":
        fixed = items_of(schema)
        if fixed is not None and given:
            return f"tuple[{', '.join(python_type(one, given) for one in fixed)}]"
        if fixed is not None:
            each = list(dict.fromkeys(python_type(one, given).replace("int", "float") for one in fixed))
            return f"list[{each[0] if len(each) == 1 else 'Union[' + ', '.join(each) + ']'}]"
        return f"{'Iterable' if given else 'list'}[{python_type(schema['items'], given)}]"
    simple = {"number": "float", "integer": "int", "string": "str", "boolean": "bool", "null": "None", "object": "dict[str, Any]"}
    return simple[schema["type"]]


def python_class(name, bases, about, members, given):
    if any(map(keyword.iskeyword, members)):  # `from` cannot be a member of a class
        hints = ", ".join(f'"{each}": {python_type(of, given)}' for each, of in members.items())
        return f'{name} = TypedDict("{name}", {{{hints}}})\n"""{sentence(about)}"""\n'
    lines = [f"class {name}({', '.join(bases)}):"]
    if about:
        lines.append(f'    """{sentence(about)}"""\n')
    for each, of in members.items():
        lines.append(f"    {each}: {python_type(of, given)}")
        if of.get("description"):
            lines.append(f'    """{sentence(of["description"])}"""')
    return "\n".join(lines if members else [*lines, "    pass"]) + "\n"


def python_definition(name, schema):
    given = name in arguments
    about, name = schema.get("description", ""), python_names.get(name, name)
    if not is_object(schema):
        comment = f'"""{sentence(about)}"""\n' if about else ""
        return f"{name} = {python_type(schema, given)}\n{comment}"
    always = {each: of for each, of in schema["properties"].items() if each in schema.get("required", [])}
    perhaps = {each: of for each, of in schema["properties"].items() if each not in always}
    bases = [python_names.get(each, each) for each in map(name_of, (each["$ref"] for each in schema.get("allOf", [])))]
    if not perhaps:
        return python_class(name, bases or ["TypedDict"], about, always, given)
    if not always:
        return python_class(name, [*(bases or ["TypedDict"]), "total=False"], about, perhaps, given)
    return python_class(f"_{name}", ["TypedDict"], "", always, given) + "\n\n" + python_class(name, [f"_{name}", "total=False"], about, perhaps, given)


def python(types):
    tables = (root / "python/tables.py.in").read_text(encoding="utf-8")
    made = [python_definition(name, of) for name, of in types.items() if name not in not_typed | {"Experiment", "Point"}]
    return python_head + "\n\n".join(made) + "\n\n" + tables


members_head = f'''"""The members of results, for type checkers. A dictionary with methods cannot be a TypedDict, so its members are declared one by
one here. {made_by}"""

# pyright: reportIncompatibleMethodOverride=false

from typing import Any, Literal, Optional, Union, overload

from . import types
'''


def member_types(types):
    """The members of a Placement and of an Experiment, with the types of Python."""
    tables = {"measurements": "list[MeasurementRow]", "aggregates": "list[AggregateRow]", "polygons": "list[PolygonRow]"}
    for name in ("Placement", "Experiment"):
        yield name, {each: tables.get(each) if name == "Experiment" and each in tables else python_type(of, False) for each, of in types[name]["properties"].items()}


def members(types):
    made = [members_head]
    for name, hints in member_types(types):
        by_hint = {}
        for member, hint in hints.items():
            by_hint.setdefault(re.sub(r"\b(?!Optional|Union|Literal|Any\b)([A-Z]\w+)", r"types.\1", hint), []).append(member)
        made.append(f"\nclass {name}Members(dict[str, Any]):")
        for call, result in (("__getitem__", "{}"), ("get", "Optional[{}]")):
            for i, (hint, each) in enumerate(by_hint.items()):
                given = result.format(hint) if not (call == "get" and hint.startswith("Optional")) else hint
                made.append(f"    @overload{'  # type: ignore[override]' if i == 0 else ''}")
                made.append(f"    def {call}(self, key: Literal[{', '.join(map(json.dumps, each))}]) -> {given}: ...")
        made += ["    @overload", "    def get(self, key: str, default: Any = ...) -> Any: ..."]
    return "\n".join(made) + "\n"


# --- The manual


def number_in_words(number):
    short = f"{number:.0e}".replace("+", "").replace("e0", "e")
    return short if float(short) == number and not 1e-9 < number < 1e9 and number else f"{number:.10g}"


def manual_type(schema):
    """The type in words and Markdown."""
    if "$ref" in schema:
        name = name_of(schema["$ref"])
        return manual_type(named_in_full[name]) if name in named_in_full else f"`{name}`"
    if "anyOf" in schema:
        each = choices(schema)
        names = [one for one in each if "const" in one]
        rest = [manual_type(one) for one in each if "const" not in one]
        return " or ".join(dict.fromkeys([*rest, *([", ".join(map(manual_type, names))] if names else [])]))
    if "enum" in schema:
        return ", ".join(f"`{json.dumps(each)}`" for each in schema["enum"])
    if "const" in schema:
        return f"`{json.dumps(schema['const'])}`"
    if "minimum" in schema:
        whole = "a whole number " if schema["type"] == "integer" else ""
        return f"{whole}{number_in_words(schema['minimum'])} to {number_in_words(schema['maximum'])}"
    if schema["type"] == "array":
        fixed = items_of(schema)
        if fixed is not None and len(fixed) > 3:
            return "a list"
        if fixed is not None:
            return "[" + ", ".join(manual_type(each) for each in fixed) + "]"
        return "[" + manual_type(schema["items"]) + ", …]"
    return {"integer": "a whole number", "number": "a number", "string": "a text", "boolean": "`true`, `false`", "object": "an object", "null": "`null`"}[schema["type"]]


named_in_full = {}


def table_of(name, schema):
    def row(member, of):
        kinds = choices(of)
        if name == "Settings":  # null always counts as not given
            kinds = [each for each in kinds if each.get("type") != "null"]
        kind = manual_type({"anyOf": kinds})
        return f"| `{member}` | {kind} | {of.get('description', '')} |"

    rows = [row(member, of) for member, of in schema["properties"].items()]
    return "\n".join(["| member | value | meaning |", "| --- | --- | --- |", *rows])


def tables(types, names):
    """The tables of these types, and a heading for each if there are several."""
    made = []
    for name in names:
        heading = f"`{name}`: {types[name].get('description', '')}\n\n" if len(names) > 1 else ""
        made.append(heading + table_of(name, types[name]))
    return "\n\n".join(made)


def with_tables(text, types):
    def replaced(found):
        return f"{found[1]}\n{tables(types, found[2].split())}\n\n<!-- end -->"

    return re.sub(r"(<!-- types: ([\w ]+) -->\n).*?<!-- end -->", replaced, text, flags=re.DOTALL)


def main():
    program, *options = sys.argv[1:]
    types = json.loads(subprocess.run([program, "--schema"], check=True, stdout=subprocess.PIPE).stdout)["$defs"]
    named_in_full.update({name: of for name, of in types.items() if not is_object(of) and name not in ("Position", "Point")})
    files = {"npm/evenlift.d.ts": typescript(types), "python/src/evenlift/types.py": python(types), "python/src/evenlift/_members.pyi": members(types)}
    for name in ("docs/cli.md", "docs/requests.md"):
        files[name] = with_tables((root / name).read_text(encoding="utf-8"), types)
    wrong = [name for name, text in files.items() if not (root / name).exists() or (root / name).read_text(encoding="utf-8") != text]
    if "--check" not in options:
        for name in wrong:
            (root / name).write_text(files[name], encoding="utf-8")
        print("written: " + (", ".join(wrong) or "nothing, all is up to date"))
    elif wrong:
        sys.exit(f"{', '.join(wrong)}: not what the schema says; run: python3 docs/write_types.py build/bin/evenlift")


if __name__ == "__main__":
    main()
