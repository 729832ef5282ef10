"""The package's C library: requests and answers as JSON."""

from __future__ import annotations

import ctypes
import json
import pathlib
import sys
from typing import Any, Optional

from .types import Place

_name = {"win32": "evenlift.dll", "darwin": "libevenlift.dylib"}.get(sys.platform, "libevenlift.so")
_library = ctypes.CDLL(str(pathlib.Path(__file__).with_name(_name)))
_library.evenlift_run.argtypes = [ctypes.c_char_p]
_library.evenlift_run.restype = ctypes.c_void_p
_library.evenlift_free.argtypes = [ctypes.c_void_p]
_library.evenlift_free.restype = None


class EvenliftError(ValueError):
    """A request that evenlift cannot answer. `code` is one word for programs; `place` is the place of the error, if known."""

    code: str
    place: Optional[Place]

    def __init__(self, message: str, code: str, place: Optional[Place] = None) -> None:
        super().__init__(message)
        self.code = code
        self.place = place

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


def ask_for_text(request: dict[str, Any]) -> str:
    """Returns the unchanged text of the answer. Raises EvenliftError or MemoryError for an error."""
    text = answer(json.dumps(request, allow_nan=False))
    if text.startswith('{"error": '):
        error = json.loads(text)["error"]
        if error["code"] == "no_memory":
            raise MemoryError(error["message"])
        raise EvenliftError(error["message"], error["code"], error["place"])
    return text


def ask(request: dict[str, Any]) -> dict[str, Any]:
    answered: dict[str, Any] = json.loads(ask_for_text(request))
    return answered
