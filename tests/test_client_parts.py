"""Parts before the body whose values no spec states: clients count those that number requests, users choose others."""

from __future__ import annotations

import importlib

import pytest

from layouts import TEST_SPECS, newest
from python_package import module_of, runtime


class Line:
    """A line that notes what is sent, and brings the next of some frames."""

    datagrams = True

    def __init__(self, *answers: str) -> None:
        self.answers = [bytes.fromhex(answer) for answer in answers]
        self.sent: list[str] = []
        self.due: list[bytes] = []

    def write(self, data: bytes) -> None:
        """Takes a request."""
        self.sent.append(data.hex(" ").upper())
        self.due = self.answers[:1]
        del self.answers[:1]

    def read(self, limit: float) -> bytes:
        """The answer that is due."""
        return self.due.pop() if self.due else b""

    def close(self) -> None:
        """Nothing is open."""


def test_a_refusal_by_a_part_says_its_number_and_its_name() -> None:
    scanner = module_of(newest(TEST_SPECS, "scanner"))
    owner = importlib.import_module(f"{scanner.__package__}.client")
    for answer, number, text in (("05 02 10 17", 2, "exception 2, busy"), ("05 09 10 1E", 9, "exception 9$")):
        with pytest.raises(runtime("errors").RefusedError, match=text) as refused:
            owner.Client(Line(answer), link="panel", unit_address=5).ask(scanner.ReadStateRequest())
        assert refused.value.number == number
