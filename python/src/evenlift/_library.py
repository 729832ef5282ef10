"""The package's C library: requests and answers as JSON."""

from __future__ import annotations

import base64
import ctypes
import json
import os
import pathlib
import sys
from typing import Any, Mapping, Optional

from .types import Place

_name = {"win32": "evenlift.dll", "darwin": "libevenlift.dylib"}.get(sys.platform, "libevenlift.so")
_library = ctypes.CDLL(str(pathlib.Path(__file__).with_name(_name)))
_library.evenlift_run.argtypes = [ctypes.c_char_p]
_library.evenlift_run.restype = ctypes.c_void_p
_library.evenlift_free.argtypes = [ctypes.c_void_p]
_library.evenlift_free.restype = None


class EvenliftError(ValueError):
    """A request that evenlift cannot answer. `code` is one word for programs; `place` is the place of the error, and `path` that
    of the argument's member, such as "cargo[2].weight", if known."""

    code: str
    place: Optional[Place]
    path: Optional[str]

    def __init__(self, message: str, code: str, place: Optional[Place] = None, path: Optional[str] = None) -> None:
        super().__init__(message)
        self.code = code
        self.place = place
        self.path = path

    def __reduce__(self) -> tuple[Any, ...]:
        return _made_again, (type(self), self.args), self.__dict__


def _made_again(kind: type[EvenliftError], args: tuple[Any, ...]) -> EvenliftError:
    """Recreates an error from a copy or another process; its attributes follow. Does not call __init__, since an error does not
    keep its arguments and a subclass may change them. A process pool would wait for ever for an error that cannot be recreated."""
    return kind.__new__(kind, *args)


def answer(request: str) -> str:
    """Returns the answer to a request, both JSON (docs/requests.md). Other threads can run meanwhile."""
    if "\0" in request:
        raise EvenliftError("A request must not contain zero bytes", "bad_syntax")
    try:
        data = request.encode("utf-8")
    except UnicodeEncodeError as error:
        raise EvenliftError(f"Character {error.start + 1} of the request is half a character", "bad_syntax") from None
    pointer = _library.evenlift_run(data)
    if not pointer:
        raise MemoryError
    try:
        return ctypes.string_at(pointer).decode("utf-8")
    finally:
        _library.evenlift_free(pointer)


# --- Requests


def file_members(file: Any) -> dict[str, Any]:
    """A file as members of a request: its text, or its bytes."""
    if isinstance(file, os.PathLike):
        file = pathlib.Path(file).read_bytes()
    return {"bytes": base64.b64encode(file).decode("ascii")} if isinstance(file, (bytes, bytearray)) else {"text": file}


def polygon_members(polygon: Any) -> dict[str, Any]:
    """A polygon as members of a request."""
    if isinstance(polygon, (str, bytes, bytearray, os.PathLike)):
        return file_members(polygon)
    if hasattr(polygon, "__geo_interface__"):
        return {"text": json.dumps(polygon.__geo_interface__)}
    return {"document" if isinstance(polygon, Mapping) else "polygon": polygon}


def _plain(value: Any) -> Any:
    """Makes JSON of what `json` does not know: arrays and numbers of NumPy, other numbers, mappings and sequences. Anything else
    becomes a text, which the core refuses by its path."""
    if hasattr(value, "tolist"):
        return value.tolist()
    if isinstance(value, Mapping):
        return dict(value)
    for kind in (float, list):
        try:
            return kind(value)
        except (TypeError, ValueError, OverflowError):
            pass
    return f"<{type(value).__name__}>"


def written(request: dict[str, Any]) -> str:
    """The request as JSON."""
    try:
        return json.dumps(request, default=_plain)
    except (TypeError, ValueError) as error:  # a key that is no text, or a number of thousands of digits
        raise EvenliftError(f"The request cannot be written as JSON: {error}", "bad_syntax") from None


def ask_for_text(request: str) -> str:
    """Returns the unchanged text of the answer. Raises EvenliftError or MemoryError for an error."""
    text = answer(request)
    if text.startswith('{"error": '):
        error = json.loads(text)["error"]
        if error["code"] == "no_memory":
            raise MemoryError(error["message"])
        raise EvenliftError(error["message"], error["code"], error["place"], error["path"])
    return text


def ask(request: dict[str, Any]) -> Any:
    return json.loads(ask_for_text(written(request)))
