"""Why some goals are missed, by group and name of the row."""

from __future__ import annotations

RICHER = (
    "The peer, a hand-written program, supports one device in one format. For reading and checking, fieldspec takes "
    "2.5 to 3 times as long as the peer, because fieldspec keeps the source position of every value, and seventy "
    "rules check the values. The outputs of fieldspec are eight times as large: they also contain tests of every "
    "constant and example, Python codecs, HTML and Markdown pages, and an audit."
)
START = (
    "Reading and checking take 130 ms, of which imports take 60 ms. The imports of the peer take a tenth of these 60 "
    "ms."
)
READS = (
    "The device comes from the cache, and only 300 of its 10,000 objects are created. Most of the time is for "
    "imports, mainly of sixty small modules and of argparse."
)
MODEL = "The parsed files and their model occupy 0.8 GB. The text of an output needs further memory."
WATCH = (
    "A third of the time is for reading, for seventy checks, and for the audit, which checks the device again with "
    "each misprint. A build reuses the texts of unchanged facts in code, and of unchanged sections in documentation. "
    "It cannot reuse the texts of vectors, queries and PLC blocks, because the text for a fact depends on many facts."
)
LARGE_SAVE = (
    "Checks of single values and bit fields run again only for changed facts. Checks that compare facts, however, "
    "read every register, which takes a fifth of the time. Joining the parts of the C files takes a third of the "
    "time."
)
MANY_VERSIONS = (
    "All versions are read, laid out and joined again; only the code that they share is printed once. Checks that "
    "compare facts, such as names and addresses, run for each version, which takes a third of the time. Joining the C"
    " files takes another third."
)
ALL = (
    "Two processors share nearly 4 s of work, but not evenly. One processor builds the largest device. The other "
    "builds the remaining three devices, which takes a fifth longer. Dividing the work for one device between the "
    "processors takes more time than it saves. Before the processors start, imports and the reading of all specs take"
    " 0.3 s."
)
TURNS = (
    "The peer, pymodbus, has become faster. It takes 3.7 times as long as a loop over the 256-entry CRC table; when "
    "the goal was set, it took 4.7 times as long. Even the shortest hand-written code that creates the same objects, "
    "for one message and without a link, reaches only the ratio 8.0. Compared with the package construct, the ratio is "
    "29 to 31, depending on the run."
)
TESTS = (
    "Eighteen fields have ranges, and a comparison takes 9 ns, so range checks take half of the time. Without range "
    "checks, a hand-written class with the same fields is 23 times as fast as construct, and 39 times as fast as "
    "Kaitai. No faster method of checking ranges was found: a comparison of the packed bytes as one large number "
    "takes as long, and regular expressions, `min` and `max`, sets, and `map` take longer."
)
SUMS = (
    "Hand-written code with the same checks is 30 times as fast as construct; without checks, it is 34 times as fast."
    " The goal assumed no checks."
)
CLASSES = (
    "A single hand-written file with such classes takes 3.1 ms, mostly to create 100 classes with 21 slots. fieldspec"
    " imports nine modules instead of one, so that devices share code; this takes 1.3 ms. The code that names a "
    "rejected field and decodes many records at once takes 0.6 ms."
)
SHIFTS = (
    "The peer reuses DataViews, which programs can seldom do, because frames seldom share a buffer. Creating a "
    "DataView takes six times as long as decoding the frame. The generated code therefore reads single bytes, and V8 "
    "checks the bounds for 22 bytes, but for only 9 numbers of a DataView. This takes 1.3 times as long, even in "
    "hand-written code; the generated code takes no longer than hand-written shifts."
)
INLINED = (
    "Counting the keys, so that unknown ones are refused, takes a fifth of the peer's time. V8 inlines functions of up "
    "to 460 bytes of bytecode; the function that writes has 670 bytes, and its call takes a further quarter. If it is "
    "inlined, its nine checks together take 4 %."
)
WRITES = (
    "The simulated device evaluates the rules of its behaviour after each write, and checks the registers and the "
    "value, which takes a third of the time. The peer only stores a number."
)

REMARKS = {
    ("Modbus RTU over TCP", "simulated device, each time another position written, requests a second"): WRITES,
    ("JavaScript", "decode telegram 111, nine fields read"): SHIFTS,
    ("JavaScript", "encode telegram 111, all values checked"): INLINED,
    ("JavaScript", "decode telegram 111, value kept"): SHIFTS,
    ("build --watch", "10,000 registers: Python and C after a changed label"): LARGE_SAVE,
    ("build --watch", "51 versions of 200 registers: after one line in the base"): MANY_VERSIONS,
    ("Python, Modbus request", "build and parse"): TURNS,
    ("Python, CK10 point record", "encode"): TESTS,
    ("Python, ESC11 packet", "build and parse"): SUMS,
    ("Python, import", "100 records of 21 fields, added to python -c pass"): CLASSES,
    ("Command line", "decode of one frame"): READS,
    ("Command line", "show"): READS,
    ("400 registers", "C, Python, Markdown and HTML"): f"{START} {RICHER}",
    ("400 registers", "C header and self-test"): START,
    ("400 registers", "HTML and Markdown"): START,
    ("10,000 registers", "C, Python, Markdown and HTML"): RICHER,
    ("100,000 registers", "C, Python, Markdown and HTML"): RICHER,
    ("100,000 registers", "memory"): MODEL,
}
NODES = (
    "Every value becomes a separate object with its source position. Tags, anchors, duplicate keys, depth and size "
    "are checked. The prototype with the ratio 0.32 did none of this."
)
BY_GROUP = {"build --watch": WATCH, "All outputs of four devices": ALL, "YAML with line numbers": NODES}
"""Why the rows of a group without their own remark miss their goals."""
