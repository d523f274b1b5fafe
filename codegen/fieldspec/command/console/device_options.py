"""The arguments of the verbs that serve a device or talk to one."""

from __future__ import annotations

import argparse
import math

from fieldspec.command.console.verb_parsers import DEVICE_HELP, VerbParser


def add_simulate(simulate: argparse.ArgumentParser) -> None:
    """Adds the arguments of `simulate`."""
    simulate.add_argument("device", metavar="DEVICE[@VERSION]", help=DEVICE_HELP)
    port_help = "pty, tcp://HOST:PORT, udp://HOST:PORT, can://INTERFACE/CHANNEL or a serial port; repeatable"
    port_help += " (default: by the link)"
    simulate.add_argument("--port", metavar="[LINK=]WHERE", action="append", help=port_help)
    browsers = "serve all links to the frame lab in a browser on this machine, at this port (0: any)"
    simulate.add_argument("--websocket", type=whole, metavar="PORT", help=browsers)
    simulate.add_argument("--unit", type=int, metavar="NUMBER", help="the unit address (default: the lowest)")
    _add_line_settings(simulate)
    simulate.add_argument(
        "--message", metavar="NAME", help="the cyclic message in use, by name or number (default: the first)"
    )
    simulate.add_argument("--rate", type=positive, default=1.0, metavar="FACTOR", help="the speed of simulated time")
    simulate.add_argument("--dump", metavar="FILE", help="start with the values of a dump: CSV, XLSX or JSON")
    simulate.add_argument("--record", metavar="FILE", help="write the traffic to a log for `fieldspec decode`")
    chance = "a random fault, such as no_answer=0.01; repeatable"
    simulate.add_argument("--fault", metavar="KIND=PROBABILITY", action="append", help=chance)
    simulate.add_argument("--faults", metavar="FILE", help="a script of faults: one JSON object per line")
    simulate.add_argument("--seed", type=int, default=0, metavar="NUMBER", help="the random seed for faults")
    simulate.add_argument(
        "--control", action="store_true", help="read commands from standard input, one JSON object per line"
    )
    simulate.add_argument("--view", action="store_true", help="show registers, motion and traffic in the terminal")
    simulate.add_argument("--assumptions", action="store_true", help="list the assumptions of the simulator and exit")


def add_live(live: VerbParser) -> None:
    """Adds the arguments of `live`."""
    live.add_argument("device", metavar="DEVICE[@VERSION]", help=DEVICE_HELP)
    live.add_argument(
        "verb_of_device",
        metavar="VERB",
        choices=("find", "read", "write", "watch", "dump", "scan", "points", "backup", "restore", "compare"),
        help="one of %(choices)s",
    )
    names = (
        "names or roles to read or watch, NAME=VALUE to write, ranges to scan, "
        "`download FILE` or `upload FILE` for points, the FILE of the other commands"
    )
    live.add_argument("arguments", nargs="*", default=[], metavar="ARGUMENT", help=names)
    live.examples = (
        "fieldspec live DEVICE find --port /dev/ttyUSB0",
        "fieldspec live DEVICE read actual_position --port /dev/ttyUSB0",
        "fieldspec live DEVICE write NAME=VALUE --port /dev/ttyUSB0 --dry-run",
    )
    _add_connection(live)
    watch = live.add_argument_group("watch")
    watch.add_argument("--every", type=seconds, metavar="SECONDS", help="the time between reads (default: 0.5)")
    watch.add_argument("--count", type=natural, metavar="NUMBER", help="stop after this number of reads")
    writes = live.add_argument_group("write, points upload, restore")
    writes.add_argument("--dry-run", action="store_true", help="print the frames and write nothing")
    writes.add_argument("--yes", action="store_true", help="do not ask for confirmation")
    lists = live.add_argument_group("lists")
    choice = "for points and compare: the table (default: the only table, or the table that the file names)"
    lists.add_argument("--table", metavar="NAME", help=choice)
    other = "accept a file for a different version, and write to a device with a different firmware"
    lists.add_argument("--any-version", action="store_true", help=f"for compare and writes: {other}")
    output = live.add_argument_group("output")
    output.add_argument("--trace", action="store_true", help="print all frames to standard error")
    forms = "json: for find, read, watch, scan and compare"
    output.add_argument("--format", choices=("text", "json"), default="text", help=forms)


def add_scan(scan: argparse.ArgumentParser) -> None:
    """Adds the arguments of `scan`."""
    scan.add_argument("device", metavar="DEVICE[@VERSION]", help=DEVICE_HELP)
    ranges = "addresses such as 0x1000..0x10FF, or SPACE:0..255 (default: all blocks of 256 addresses with registers)"
    scan.add_argument("arguments", nargs="*", default=[], metavar="RANGE", help=ranges)
    _add_connection(scan)
    scan.add_argument("--trace", action="store_true", help="print all frames to standard error")
    scan.add_argument("--format", choices=("text", "json"), default="text", help="json: for `audit --evidence`")


def add_redact(redact: argparse.ArgumentParser) -> None:
    """Adds the arguments of `redact`."""
    redact.add_argument("device", metavar="DEVICE[@VERSION]", help=DEVICE_HELP)
    paths = "captures, logs, dumps and scans; the folder of a unit; or a folder with folders of units"
    redact.add_argument("paths", nargs="+", metavar="PATH", help=paths)
    redact.add_argument("--out", metavar="FOLDER", required=True, help="an empty folder for the output")
    secret = "a number or a text that must not occur in the output, in any encoding; repeatable"
    redact.add_argument("--secret", metavar="TEXT", action="append", help=secret)
    spare = "a text that does not identify the unit and is copied unchanged; repeatable"
    redact.add_argument("--spare", metavar="NAME", action="append", help=spare)


def _add_connection(verb: argparse.ArgumentParser) -> None:
    """Adds the options that say where a device is, and how it is asked."""
    connection = verb.add_argument_group("connection")
    port_help = "a serial port, socket://HOST:PORT, tcp://HOST:PORT, udp://HOST:PORT or can://INTERFACE/CHANNEL"
    connection.add_argument("--port", metavar="WHERE", help=port_help)
    connection.add_argument("--link", metavar="NAME", help="the link (default: the factory setting)")
    connection.add_argument("--unit", type=int, metavar="NUMBER", help="the unit address (default: the lowest)")
    fixed = "a request value that the spec does not state, such as axis=0; repeatable"
    connection.add_argument("--with", metavar="NAME=VALUE", dest="fixed", action="append", default=[], help=fixed)
    _add_line_settings(connection)
    times = verb.add_argument_group("times")
    limit = "the longest time until a response (default: 1; find: 0.3)"
    times.add_argument("--timeout", type=positive, metavar="SECONDS", help=limit)
    retries = "the number of repetitions of a read without a response (default: 2)"
    times.add_argument("--retries", type=whole, default=2, metavar="NUMBER", help=retries)
    pause = "idle seconds before each request (default: the link's silence)"
    times.add_argument("--pause", type=seconds, metavar="SECONDS", help=pause)


def _add_line_settings(verb: argparse._ActionsContainer) -> None:
    """Adds the options with the settings of a serial port."""
    verb.add_argument("--baud", type=natural, metavar="NUMBER", help="the baud rate (default: the factory setting)")
    verb.add_argument(
        "--parity", choices=("none", "even", "odd"), help="the parity of a serial port (default: the factory setting)"
    )
    bits = "the data bits of a serial port (default: the factory setting)"
    verb.add_argument("--data-bits", type=int, choices=(5, 6, 7, 8), help=bits)


def add_mcp(mcp: argparse.ArgumentParser) -> None:
    """Adds the arguments of `mcp`."""
    port_help = "a device to read and its port, as for `live --port`; repeatable"
    mcp.add_argument("--port", metavar="DEVICE=WHERE", action="append", help=port_help)
    mcp.add_argument("--allow-writes", action="store_true", help="also allow writes to these devices")


def seconds(text: str) -> float:
    """A time that may be 0. Raises ArgumentTypeError."""
    number = _finite_number(text)
    if number < 0:
        raise argparse.ArgumentTypeError(f"{text} is less than 0")
    return number


def positive(text: str) -> float:
    """A number above 0. Raises ArgumentTypeError."""
    number = _finite_number(text)
    if number <= 0:
        raise argparse.ArgumentTypeError(f"{text} is not more than 0")
    return number


def whole(text: str) -> int:
    """A whole number from 0 on. Raises ArgumentTypeError."""
    if not (text.isascii() and text.isdecimal()):
        raise argparse.ArgumentTypeError(f"{text} is not a whole number from 0 on")
    return int(text)


def natural(text: str) -> int:
    """A whole number from 1 on. Raises ArgumentTypeError."""
    if not (text.isascii() and text.isdecimal() and int(text)):
        raise argparse.ArgumentTypeError(f"{text} is not a whole number from 1 on")
    return int(text)


def _finite_number(text: str) -> float:
    try:
        number = float(text)
    except ValueError:
        number = math.nan
    if not math.isfinite(number):
        raise argparse.ArgumentTypeError(f"{text} is not a number")
    return number
