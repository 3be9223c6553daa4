"""JSON read value by value, so that of a long report one result at a time is in memory."""

from __future__ import annotations

import json
import re
from codecs import getincrementaldecoder
from collections.abc import Iterator
from io import BufferedReader
from typing import Any

BLOCK = 1 << 20
"""The bytes that are read at a time, of a long value more."""
_BLANK = re.compile(r"[ \t\n\r]*")
_OF_NUMBERS = "0123456789.eE+-"


class JsonReader:
    """A place in a JSON text: what comes next is looked at, and read as a whole or part by part.

    ValueError is raised where the text is not JSON, or not what is to be read.
    """

    def __init__(self, stream: BufferedReader) -> None:
        self._stream = stream
        self._letters = getincrementaldecoder(json.detect_encoding(stream.peek(4)[:4]))("surrogatepass")
        self._decoder = json.JSONDecoder()
        self._text, self._at = "", 0

    def next(self) -> str:
        """The first character of what comes next, "" at the end."""
        while True:
            self._at = _BLANK.match(self._text, self._at).end()  # type: ignore[union-attr]
            if self._at < len(self._text):
                return self._text[self._at]
            if not self._more():
                return ""

    def value(self) -> Any:
        """The value that comes next, read as a whole."""
        self.next()
        while True:
            try:
                value, end = self._decoder.raw_decode(self._text, self._at)
            except json.JSONDecodeError:
                if not self._more():
                    raise
                continue
            size = end - self._at
            ended = self._text[end:].strip(_OF_NUMBERS) != ""  # else a number may go on in the next block
            if ended or not self._more():
                self._at += size
                return value

    def members(self) -> Iterator[str]:
        """The keys of the object that comes next; whoever iterates reads the value after each. Raises ValueError."""
        self._take("{")
        if self.next() == "}":
            self._take("}")
            return
        while True:
            key = self.value()
            if not isinstance(key, str):
                raise ValueError("a key is no string")
            self._take(":")
            yield key
            if self._take(",}") == "}":
                return

    def elements(self) -> Iterator[Any]:
        """The elements of the array that comes next."""
        self._take("[")
        if self.next() == "]":
            self._take("]")
            return
        while True:
            yield self.value()
            if self._take(",]") == "]":
                return

    def end(self) -> None:
        """Make sure that nothing comes any more. Raises ValueError."""
        if self.next():
            raise ValueError("there is something after the end")

    def _take(self, wanted: str) -> str:
        """The next character, which is one of those wanted, and is read."""
        character = self.next()
        if not character or character not in wanted:
            raise ValueError(f"{character!r} instead of {' or '.join(wanted)}")
        self._at += 1
        return character

    def _more(self) -> bool:
        """Whether there was more to read; what has been read already is dropped."""
        read, more = b"more", ""
        while read and not more:
            read = self._stream.read(max(BLOCK, len(self._text) - self._at))
            more = self._letters.decode(read, final=not read)
        self._text, self._at = self._text[self._at :] + more, 0
        return bool(more)
