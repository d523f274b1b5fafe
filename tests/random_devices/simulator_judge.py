"""The simulator as a judge: it answers any frame, and what it answers is a response that the reference reads."""

from __future__ import annotations

from typing import Any

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.reference import CodecError, codec
from fieldspec.language.behaviour.part import Behaviour
from fieldspec.tools.simulator.bare_requests import Decoder, bare_decoder, has_bare_requests
from fieldspec.tools.simulator.codecs import device_module, link_codec
from fieldspec.tools.simulator.engine import Engine
from fieldspec.tools.simulator.received import received
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
        bare_links = [link for link in layout.links.values() if has_bare_requests(link)]
        module = device_module(layout) if bare_links else None
        self.decoders = {
            link.name: bare_decoder(link_codec(module, link.name), link) for link in bare_links if module is not None
        }

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
        if link in self.decoders:
            requests = [self._received(query, decode) for decode in (None, self.decoders[link])]
            assert repr(requests[0]) == repr(requests[1]), query.data.hex(" ")
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

    def _received(self, query: Query, decode: Decoder | None) -> object:
        """The head and the values of a request, or why it is ignored, by the reference or by the generated codec."""
        request = received(self.codecs[query.path[0]], self.server.unit_address, query.data, query.path[2], decode)
        return request if isinstance(request, str) else (request.head, request.values, request.out_of_range)

    def _asked(self, query: Query) -> Any:
        try:
            return self.codecs[query.path[0]].decode(query.data, "request", query.path[2])
        except CodecError:
            return None


__all__ = ["Simulator"]
