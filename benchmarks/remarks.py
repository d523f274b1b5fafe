"""What stands in the way of the goals that are missed, by group and name of the row."""

from __future__ import annotations

RICHER = (
    "The floor knows one device in one form. Ours takes 2.5 to 3 times as long to read and check alone, as every value "
    "knows its place and seventy rules look at it. What it writes is eight times as long: tests of every constant and "
    "example beside the C header, codecs in Python, pages as HTML and Markdown, and an audit."
)
START = (
    "Of 130 ms for reading and checking, 60 are imports: the libraries of YAML and of the schema take 17, and 160 "
    "modules of ours 20. The peer has a tenth of that to import."
)
READS = (
    "The device is compiled already; of its ten thousand objects, three hundred are made. Half of what is left is the "
    "import of sixty small modules, which say what a device is made of and how a frame is explained, and a fifth that "
    "of argparse; to see that specs and compiler are the same takes 3 ms."
)
MODEL = "What was read, and the model that is made of it, take 0.8 GB; the text of an output comes on top."
WATCH = (
    "Findings are there after 0.1 s. All outputs of all versions of a device are then made again, however little of it "
    "has changed; half of that is the documentation with its audit, which is one piece of work."
)
LARGE_SAVE = (
    "Seventy checks look at every register again, which takes a third of the time. The rest moves the text after the "
    "change, lays out and identifies the device, and joins the pieces of its outputs. Checks are not kept by item: no "
    "check takes more than 8 us for a register, and a look-up takes 2 us."
)
MANY_VERSIONS = (
    "All versions are read, checked, laid out and joined again, and only what they share is printed once. Most "
    "registers of a version are equal to the registers of the version before it, but each version is judged on its "
    "own, which takes a third of the time."
)
ALL = (
    "Nearly 4 s of work are shared by two processors, but not evenly: one has the largest device, the other the "
    "three that are left, which take a fifth longer. To divide a device made more work than it saved. Before they "
    "begin, 0.3 s go by with imports and the reading of all specs."
)
TURNS = (
    "pymodbus takes 3.7 times as long as the loop over 256 entries; when the goal was set, it took 4.7 times as long. "
    "The least by hand that makes the same objects, for one message and with no link between, is at 8.0. What remains "
    "is a call of the link each way, and the look-up of the class by the code. construct is at 29 to 31, by run."
)
TESTS = (
    "Eighteen fields have ranges, and a comparison takes 9 ns: the tests are half of the time. Without any, the same "
    "class by hand is at 23 beside construct, and at 39 beside Kaitai. With them, nothing was found to be faster: to "
    "test the packed bytes as one large number takes as long for fields of one interval alone; a regular expression, "
    "`min` and `max`, sets, and `map` take longer. Limits that are those of the type are left to `struct`."
)
SUMS = "What is written by hand with the same tests is at 30, with none at 34; the goal was set without tests."
CLASSES = (
    "One file of such classes by hand takes 3.1 ms, most of it for making 100 classes of 21 slots. The rest are nine "
    "modules instead of one, so that devices share what they can (1.3 ms), and what says which field is refused and "
    "decodes many records at once (0.6 ms)."
)
SHIFTS = (
    "Beside shifts by hand it is at 1.05. A DataView tests one bound for a number, shifts test one for each byte; to "
    "make a DataView of every frame takes five times as long as to decode it, and frames seldom lie in the same bytes."
)
INLINED = (
    "V8 puts a function into its caller up to 460 bytes of its code; with nine tests and what they throw, the writer "
    "has 770. Where V8 is told to take larger ones, it is at 1.06 into bytes, and at 1.28 with new bytes. Tests apart "
    "from stores would be such functions, but state every test twice."
)

REMARKS = {
    ("JavaScript", "decode telegram 111, nine fields read"): SHIFTS,
    ("JavaScript", "encode telegram 111, all values checked"): INLINED,
    ("JavaScript", "write telegram 111 into bytes, all values checked"): INLINED,
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
    (
        "100,000 registers",
        "memory",
    ): MODEL,
}
NODES = (
    "Every value becomes an object of its own that knows its place, and tags, anchors, keys that stand there twice, "
    "depth and size are looked after; the prototype that took 0.32 did nothing of this."
)
BY_GROUP = {"build --watch": WATCH, "All outputs of four devices": ALL, "YAML with line numbers": NODES}
"""What stands in the way of every row of a group that has no remark of its own."""
