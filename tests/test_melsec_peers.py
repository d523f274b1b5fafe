"""Generated codecs of frames whose parts are digits talk with pymcprotocol over a socket, as its controller."""

from __future__ import annotations

import socket
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import pytest
from pymcprotocol import Type3E
from pymcprotocol.mcprotocolerror import MCProtocolError, UnsupportedComandError

from layouts import TEST_SPECS, newest
from python_package import link_of, module_of
from serial_lines import SECONDS

SEQUENCER = module_of(newest(TEST_SPECS, "sequencer"))
ETHERNET = link_of(SEQUENCER, "ethernet")
LAST = 12288


def answer(frame: bytes, words: dict[int, int], seen: list[Any]) -> bytes:
    """What a controller with these words, by their number, answers to a request."""
    request = ETHERNET.decode_request(frame)
    asked = request.message
    seen.append(request)
    route = {"network": request.network, "pc": request.pc, "module_io": request.module_io}
    match asked:
        case SEQUENCER.ReadWordsRequest() if asked.first + asked.points > LAST:
            parts = (request.network, request.pc, request.module_io, request.unit_address, asked.CODE, 0)
            refusal = SEQUENCER.AccessedRoute(*parts)
            data = ETHERNET.encode_exception_response(request.unit_address, refusal, **route, end_code=0xC056)
            assert isinstance(data, bytes)
            return data
        case SEQUENCER.ReadWordsRequest():
            response = SEQUENCER.ReadWordsResponse([words.get(asked.first + at, 0) for at in range(asked.points)])
        case SEQUENCER.ReadBitsRequest():
            response = SEQUENCER.ReadBitsResponse([(asked.first + at) % 2 for at in range(asked.bit_points)])
        case SEQUENCER.WriteWordsRequest():
            words.update({asked.first + at: word for at, word in enumerate(asked.words)})
            response = SEQUENCER.WriteWordsResponse()
        case _:
            response = SEQUENCER.ReadTypeResponse("Q03UDECPU", 0x0268)
    data = ETHERNET.encode_response(request.unit_address, response, **route, end_code=0)
    assert isinstance(data, bytes)
    return data


@contextmanager
def controller(words: dict[int, int], seen: list[Any], piece: int = 4096) -> Iterator[Type3E]:
    """A controller on a socket, as pymcprotocol sees it; it takes the bytes in pieces."""

    def serve(listening: socket.socket) -> None:
        connection, _ = listening.accept()
        framer = ETHERNET.request_framer()
        with connection:
            while data := connection.recv(piece):
                for frame in framer.feed(data):
                    connection.sendall(answer(frame, words, seen))

    with socket.create_server(("127.0.0.1", 0)) as listening:
        thread = threading.Thread(target=serve, args=(listening,), daemon=True)
        thread.start()
        client = Type3E()
        client.setaccessopt(commtype="ascii", timer_sec=int(SECONDS))
        client.connect("127.0.0.1", listening.getsockname()[1])
        try:
            yield client
        finally:
            client.close()
            thread.join(SECONDS)


@pytest.mark.parametrize("piece", [1, 7, 4096])
def test_pymcprotocol_reads_and_writes_words(piece: int) -> None:
    words, seen = {100: 0x1995, 101: -2, 102: 32767}, []
    with controller(words, seen, piece) as client:
        assert client.batchread_wordunits("D100", 4) == [0x1995, -2, 32767, 0]
        client.batchwrite_wordunits("D4660", [1, -32768])
        assert (words[4660], words[4661]) == (1, -32768)
        assert client.batchread_bitunits("M7", 5) == [1, 0, 1, 0, 1]
        assert client.read_cputype() == ("Q03UDECPU", "0268")
    asked = seen[0]
    assert (asked.network, asked.pc, asked.module_io, asked.unit_address) == (0, 0xFF, 0x3FF, 0)
    assert asked.timer == 4 * SECONDS


def test_pymcprotocol_finds_the_unit_by_its_digits() -> None:
    seen: list[Any] = []
    with controller({}, seen) as client:
        client.setaccessopt(network=0x1A, pc=2, dest_moduleio=0x3E0, dest_modulesta=0x1F)
        assert client.batchread_wordunits("D0", 960) == [0] * 960
    asked = seen[0]
    assert (asked.network, asked.pc, asked.module_io, asked.unit_address) == (0x1A, 2, 0x3E0, 31)


def test_pymcprotocol_reads_the_end_code_of_an_exception_response() -> None:
    with controller({}, []) as client, pytest.raises(MCProtocolError) as caught:
        client.batchread_wordunits("D12287", 2)
    assert caught.value.errorcode == "0xC056"


def test_pymcprotocol_knows_the_end_code_of_an_unknown_command() -> None:
    with socket.create_server(("127.0.0.1", 0)) as listening:

        def refuse() -> None:
            connection, _ = listening.accept()
            with connection:
                connection.recv(4096)
                refusal = SEQUENCER.AccessedRoute(0, 0xFF, 0x3FF, 0, 0x0403, 0)
                connection.sendall(
                    ETHERNET.encode_exception_response(0, refusal, network=0, pc=0xFF, module_io=0x3FF, end_code=0xC059)
                )

        thread = threading.Thread(target=refuse, daemon=True)
        thread.start()
        client = Type3E()
        client.setaccessopt(commtype="ascii")
        client.connect("127.0.0.1", listening.getsockname()[1])
        with pytest.raises(UnsupportedComandError):
            client.randomread(["D1"], [])
        client.close()
        thread.join(SECONDS)
