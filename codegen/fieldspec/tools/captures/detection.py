"""Tells on which link of the device a connection speaks, from its first payloads."""

from __future__ import annotations

from typing import Any

import numpy as np

from fieldspec.tools.captures.columns import Numbers, runs
from fieldspec.tools.captures.link_decoding import LinkDecoder
from fieldspec.tools.captures.payloads import Payloads, joined, payloads_of

SAMPLE = 256
"""The payloads of a connection from which its link is told."""

SAMPLE_BYTES = 4096
"""The bytes in which framers search for frames if payloads are not frames."""

MOST_BYTES, MOST_PAYLOADS = 1 << 20, 1 << 14
"""What waits at most until the links of all connections are told."""

NONE, WAITS = -1, -2
"""In place of a link: no frame of the device is there; it is open yet."""


class Detection:
    """The links of connections. The payloads of a connection wait until it has a link, or has shown enough of itself.

    `link_of` has the links, `foreign` the connections in whose first bytes the framers have found no frame.
    """

    def __init__(self, links: dict[str, LinkDecoder]) -> None:
        self.links = links
        self.link_of: dict[int, str] = {}
        self.foreign: set[int] = set()
        self.waiting = payloads_of([])

    def state(self) -> dict[str, Any]:
        """The state from which another detection continues."""
        return {"link_of": self.link_of, "foreign": sorted(self.foreign), "waiting": self.waiting.state()}

    def restore(self, state: dict[str, Any]) -> None:
        """Continues from the state of another detection."""
        self.link_of = {int(stream): link for stream, link in state["link_of"].items()}
        self.foreign = set(state["foreign"])
        self.waiting = Payloads.of_state(state["waiting"])

    def with_links(self, payloads: Payloads) -> tuple[Payloads, Numbers]:
        """The waiting payloads and these, without payloads that still wait, and the place of each link, or NONE."""
        fresh = {stream for stream, _ in runs(payloads.stream) if stream not in self.link_of}
        payloads = joined(self.waiting, payloads) if len(self.waiting) else payloads
        groups = runs(payloads.stream)
        if fresh:
            self._judge(payloads, [rows[:SAMPLE] for stream, rows in groups if stream in fresh])
        places = {name: place for place, name in enumerate(self.links)}
        result = np.full(len(payloads), WAITS)
        for stream, rows in groups:
            result[rows] = self._place(stream, places)
        waits = np.flatnonzero(result == WAITS)
        sizes = np.cumsum(payloads.size[waits][::-1])[::-1]
        is_much = (sizes > MOST_BYTES) | (np.arange(len(waits))[::-1] >= MOST_PAYLOADS)
        result[waits[is_much]] = NONE
        self.waiting = payloads.at_rows(waits[~is_much]).compact()
        ready = result != WAITS
        return (payloads, result) if ready.all() else (payloads.at_rows(ready), result[ready])

    def _place(self, stream: int, places: dict[str, int]) -> int:
        if stream in self.link_of:
            return places[self.link_of[stream]]
        return NONE if stream in self.foreign else WAITS

    def rest(self) -> int:
        """How many payloads still wait at the end of a source."""
        count, self.waiting = len(self.waiting), payloads_of([])
        return count

    def _judge(self, payloads: Payloads, rows: list[Numbers]) -> None:
        """Tells links: that with the most bytes of frames, where a payload is one, or most of the bytes are some."""
        sample = payloads.at_rows(np.concatenate(rows)).compact()
        streams, starts, count = np.unique(sample.stream, return_index=True, return_counts=True)
        whole = {name: _bytes_of(streams, sample.at_rows(link.whole(sample))) for name, link in self.links.items()}
        is_clear = np.any([own == _bytes_of(streams, sample) for own in whole.values()], axis=0)
        is_open = ~is_clear & ~np.isin(streams, [*self.foreign])
        before = np.cumsum(sample.size) - sample.size
        left = SAMPLE_BYTES - (before - np.repeat(before[starts], count))
        is_first = np.repeat(is_open, count) & (left > 0)
        first = sample.at_rows(is_first)
        np.minimum(first.size, left[is_first], out=first.size)
        framed = {name: _bytes_of(streams, *link.frames_anywhere(first)) for name, link in self.links.items()}
        sample_bytes = _bytes_of(streams, first)
        for place, stream in enumerate(streams.tolist()):
            sizes = {name: (framed if is_open[place] else whole)[name][place] for name in self.links}
            fitting = [name for name in self.links if whole[name][place] or 2 * sizes[name] > sample_bytes[place]]
            if fitting:
                self.link_of[stream] = max(fitting, key=sizes.__getitem__)
                self.foreign.discard(stream)
            elif count[place] == SAMPLE or sample_bytes[place] >= SAMPLE_BYTES:
                self.foreign.add(stream)


def _bytes_of(streams: Numbers, *parts: Payloads) -> Numbers:
    """The number of bytes of payloads in each stream."""
    sizes = np.zeros(len(streams), np.int64)
    for part in parts:
        np.add.at(sizes, np.searchsorted(streams, part.stream), part.size)
    return sizes
