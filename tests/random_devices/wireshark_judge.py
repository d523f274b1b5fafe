"""The dissector as a judge: tshark shows of right frames what the explanation says, and of others that they are wrong.

A dissector cuts frames out of packets, so of a damaged frame it may show another mistake than codecs do, and take the
bytes after a frame for the next one.
"""

from __future__ import annotations

import random
import shutil

from fieldspec.codec.explain.explanation import explained
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.reference import CodecError, codec
from fieldspec.targets.wireshark.backend import refusals
from random_devices.inputs import header_values, record_values
from random_devices.queries import Answer, Query
from wireshark_output.expectations import Case, expect, results


def has_tshark() -> bool:
    """Whether there is a Wireshark without windows."""
    return shutil.which("tshark") is not None


class Wireshark:
    """Says nothing about queries; raises AssertionError where the dissector shows something else."""

    def __init__(self, layout: DeviceLayout) -> None:
        self.layout = layout
        self.is_refused = bool(refusals([layout]))

    def answers(self, queries: list[Query]) -> list[Answer]:
        """Nothing about single queries."""
        dice = random.Random(len(queries))
        frames = [query for query in queries if query.kind == "frame" and query.values is None and query.data]
        cases = [case for query in frames if self._is_known(case := self._case(query, dice))]
        if cases and not self.is_refused:
            for case, items in results(cases):
                reasons = set(case.explanation().reasons)
                if reasons - {"wrong_length"}:
                    assert any(".expert." in item.name for item in items), f"nothing is wrong with {case.text}"
                elif not reasons:
                    expect(case, items)
        return [Answer(reason=None)] * len(queries)

    def _is_known(self, case: Case) -> bool:
        """Whether the message of a frame is told by the frame, by its request, or by the port of the message."""
        link = self.layout.links[case.link]
        coded = [link.frame(direction).role("code") is not None for direction in ("request", "response")]
        if coded == [True, False] and case.direction == "response":
            return bool(case.request)
        return bool(case.message) or all(coded)

    def _case(self, query: Query, dice: random.Random) -> Case:
        link, direction, message = query.path
        request = self._request(link, message, query.data, dice) if direction == "response" and message else b""
        return Case(self.layout, link, direction, message, request, query.data)

    def _request(self, link: str, message: str, response: bytes, dice: random.Random) -> bytes:
        """A request to the unit that sends the response; empty where there is none."""
        if message not in self.layout.links[link].carried("request"):
            return b""
        values = record_values(self.layout, self.layout.messages[message].request, dice)
        head = header_values(self.layout, link, self.layout.links[link].request, dice)
        asked, answering = (self.layout.links[link].frame(way).role("unit_address") for way in ("request", "response"))
        if asked is not None and answering is not None:
            explanation = explained(self.layout, link, "response", response, message)
            head[asked.name] = explanation.values.get(answering.name, head[asked.name])
        try:
            return codec(self.layout).links[link].encode("request", message, {**head, **values})
        except CodecError:
            return b""


__all__ = ["Wireshark", "has_tshark"]
