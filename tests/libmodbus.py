"""libmodbus, a Modbus stack in C, as a client and as a server on a line of pseudo-terminals."""

from __future__ import annotations

import ctypes
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from ctypes.util import find_library
from functools import cache
from typing import Any

from bounded import HANGING
from external_tools import without

EXCEPTIONS = 112345678
"""What libmodbus adds to the code of an exception response, for `errno`."""
LONGEST = 260


@cache
def library() -> Any:
    """The functions of libmodbus. Where it is missing, the test is skipped, or fails in CI."""
    path = find_library("modbus")
    if path is None:
        without("libmodbus")
    functions = ctypes.CDLL(path, use_errno=True)
    functions.modbus_new_rtu.restype = ctypes.c_void_p
    functions.modbus_new_rtu.argtypes = [ctypes.c_char_p, ctypes.c_int, ctypes.c_char, ctypes.c_int, ctypes.c_int]
    functions.modbus_mapping_new_start_address.restype = ctypes.c_void_p
    return functions


class ModbusError(Exception):
    """libmodbus refuses: `code` is that of an exception response, or None for anything else."""

    def __init__(self) -> None:
        number = ctypes.get_errno()
        self.code = number - EXCEPTIONS if number > EXCEPTIONS else None
        library().modbus_strerror.restype = ctypes.c_char_p
        super().__init__(library().modbus_strerror(number).decode())


def checked(result: int) -> int:
    """The result of a function of libmodbus. Raises ModbusError where it is -1."""
    if result == -1:
        raise ModbusError
    return result


@contextmanager
def stack(path: str, seconds: float = 3) -> Iterator[ctypes.c_void_p]:
    """libmodbus on a serial line. It waits so long for a response, and for the next byte."""
    functions = library()
    context = ctypes.c_void_p(functions.modbus_new_rtu(path.encode(), 115200, b"N", 8, 1))
    assert context.value, "libmodbus takes no such line"
    whole, part = int(seconds), int(seconds % 1 * 1_000_000)
    try:
        checked(functions.modbus_set_response_timeout(context, whole, part))
        checked(functions.modbus_set_byte_timeout(context, whole, part))
        checked(functions.modbus_connect(context))
        yield context
    finally:
        functions.modbus_close(context)
        functions.modbus_free(context)


def read_registers(context: ctypes.c_void_p, address: int, count: int) -> list[int]:
    """The words that libmodbus reads with function 3. Raises ModbusError."""
    words = (ctypes.c_uint16 * count)()
    checked(library().modbus_read_registers(context, address, count, words))
    return list(words)


def write_register(context: ctypes.c_void_p, address: int, word: int) -> None:
    """Lets libmodbus write a word with function 6. Raises ModbusError."""
    checked(library().modbus_write_register(context, address, ctypes.c_uint16(word)))


def write_registers(context: ctypes.c_void_p, address: int, words: Sequence[int]) -> None:
    """Lets libmodbus write words with function 16. Raises ModbusError."""
    checked(library().modbus_write_registers(context, address, len(words), (ctypes.c_uint16 * len(words))(*words)))


def report_server_id(context: ctypes.c_void_p) -> bytes:
    """The data that libmodbus reads with function 17. Raises ModbusError."""
    data = (ctypes.c_uint8 * LONGEST)()
    length = checked(library().modbus_report_slave_id(context, LONGEST, data))
    return bytes(data[:length])


@contextmanager
def server(path: str, station: int) -> Iterator[None]:
    """libmodbus as a station with all 65,536 holding registers, which begin with 0, in a thread of its own."""
    functions = library()
    ended = threading.Event()
    with stack(path) as context:
        words = ctypes.c_void_p(functions.modbus_mapping_new_start_address(0, 0, 0, 0, 0, 0x10000, 0, 0))
        checked(functions.modbus_set_slave(context, station))
        checked(functions.modbus_set_indication_timeout(context, 0, 50_000))

        def serve() -> None:
            request = (ctypes.c_uint8 * LONGEST)()
            while not ended.is_set():
                length = functions.modbus_receive(context, request)
                if length > 0:
                    functions.modbus_reply(context, request, length, words)

        thread = threading.Thread(target=serve, daemon=True)
        thread.start()
        try:
            yield
        finally:
            ended.set()
            thread.join(HANGING)
            functions.modbus_mapping_free(words)
