"""The simulator as a judge: it answers any frame, and what it answers is a response that the reference reads."""

from __future__ import annotations

from typing import Any

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.reference import CodecError, codec
from fieldspec.language.behaviour.part import Behaviour
from fieldspec.tools.simulator.engine import Engine
from fieldspec.tools.simulator.server import Server
from random_devices.queries import Answer, Query


class Simulator:
    """Says nothing about queries; raises AssertionError where an answer is not a response to its request."""

    def __init__(self, layout: DeviceLayout) -> None:
        self.layout = layout
        self.codecs = codec(layout).links
        self.server = Server(Engine(layout, Behaviour(())))
        self.server.complain = self._complain
        self.complaints: list[str] = []

    def _complain(self, reason: str) -> None:
        self.complaints.append(reason)

    def answers(self, queries: list[Query]) -> list[Answer]:
        """Nothing about single queries."""
        for query in queries:
            if query.kind == "frame" and query.values is None and query.path[1] == "request":
                self._assert_answered(query)
        return [Answer(reason=None)] * len(queries)

    def _assert_answered(self, query: Query) -> None:
        """A request is answered by a response to it, or by none where nothing is to be said."""
        link, _, message = query.path
        asked = self._asked(query)
        station = self.layout.links[link].request.role("unit_address")
        if asked is not None and station is not None and station.name in asked.head:
            self.server.unit_address = asked.head[station.name]
        self.complaints.clear()
        self.server.engine.advance(self.server.engine.now + 1)
        answer = self.server.answer(link, query.data, message)
        if not answer.frame:
            return
        name = asked.message.name if asked is not None and asked.message is not None else message
        try:
            response = self.codecs[link].decode(answer.frame, "response", name)
        except CodecError as error:
            text = f"{query.data.hex(' ')} is answered by {answer.frame.hex(' ')}, which is refused: {error}"
            raise AssertionError(text) from None
        if asked is not None and not response.error and response.message is not None:
            assert response.message.name == name, f"{name} is answered by {response.message.name}"

    def _asked(self, query: Query) -> Any:
        try:
            return self.codecs[query.path[0]].decode(query.data, "request", query.path[2])
        except CodecError:
            return None


__all__ = ["Simulator"]
