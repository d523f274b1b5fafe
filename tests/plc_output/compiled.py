"""Structured Text of IEC 61131-3, translated to C by matiec, compiled with sanitizers, and run in a process.

The process reads which routine to run and what it is given, and answers with what that returns. What a sanitizer finds
ends it, and with it the test.
"""

from __future__ import annotations

import atexit
import fcntl
import hashlib
import os
import re
import shutil
import struct
import subprocess
import tempfile
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import islice
from pathlib import Path
from typing import Any

from st_machine import Machine
from st_syntax import Unit, parsed
from standard_text import anonymous

from example_counts import FACTOR
from external_tools import require_tool
from matiec import matiec
from shared_results import FOLDERS, shared

FORMATS = {
    "bool": "?",
    "byte": "B",
    "word": "H",
    "dword": "I",
    "lword": "Q",
    "real": "f",
    "lreal": "d",
    "usint": "B",
    "uint": "H",
    "udint": "I",
    "ulint": "Q",
    "sint": "b",
    "int": "h",
    "dint": "i",
    "lint": "q",
}
WARNINGS = ("-Wall", "-Wextra", "-Werror")
SANITIZED = ("-fsanitize=address,undefined,float-cast-overflow",)
# What ends a program anyway, or is looked at in the nights, takes three quarters of the time that Clang needs.
QUICK = ("-fsanitize-address-outline-instrumentation", "-fno-sanitize=alignment,null,object-size")
STANDARD = "-std=gnu11"
# Most programs run for a moment and are compiled for much longer. Clang builds with sanitizers in a third of the time
# of GCC, which has more warnings; some of those need an optimizer, and are looked for in the nights.
COMPILERS = (
    (("gcc", STANDARD, "-O1", "-g", *WARNINGS, *SANITIZED),)
    if FACTOR > 1
    else (("gcc", STANDARD, "-fsyntax-only", *WARNINGS), ("clang", STANDARD, "-O0", "-w", *SANITIZED, *QUICK))
)
"""The commands that compile a program, the last of which writes it."""
# What matiec writes for every program alike: parameters for EN that a block does not look at, tests of divisors,
# initial values of arrays of arrays on one level.
QUIET = ("-Wno-unused-parameter", "-Wno-unused-function", "-Wno-type-limits", "-Wno-missing-braces")
PROTOTYPE = re.compile(r"^(\w+) (\w+)\(\s*BOOL EN,\s*BOOL \*__ENO(.*?)\);", re.MULTILINE | re.DOTALL)
RESULT = "VAR_RESULT"
LEAST = str(-(2**63))
NUMBER = "udint"
"""The type of the numbers that say what the process is to run, and of times."""


@dataclass(frozen=True)
class Block:
    """A function block or a program to be run scan by scan: what is set before a scan, and what is read after it.

    Both are paths of variables with their types: `fbChannel.xDone`, and of members of structs: `stStatus/xServoOn`.
    """

    name: str
    inputs: tuple[tuple[str, Any], ...]
    outputs: tuple[tuple[str, Any], ...]


@dataclass(frozen=True)
class Form:
    """How a type is written for `struct`, element by element, and how a value becomes elements and is made of them."""

    letters: str
    flatten: Callable[[Any, list[Any]], object]
    raised: Callable[[Iterator[Any]], Any]


@dataclass(frozen=True)
class Packing:
    """How values of some types are packed."""

    struct: struct.Struct
    forms: Sequence[Form]


def _run_compiler(compiler: Sequence[str], tool: Path, *arguments: str) -> None:
    """Compiles something; a warning is an error."""
    name, *flags = compiler
    command = [require_tool(name), *flags, *QUIET, "-isystem", str(tool / "lib" / "C"), *arguments]
    completed_process = subprocess.run(command, capture_output=True, text=True, check=False)
    assert completed_process.returncode == 0, completed_process.stderr[:3000]


@cache
def _library(compiler: Sequence[str], tool: Path) -> Path:
    """The header of matiec's library, beside which a compiler finds what it has read: most programs are shorter."""

    def precompile() -> str:
        folder = Path(tempfile.mkdtemp(prefix="library-", dir=FOLDERS[0] if FOLDERS else None))
        if not FOLDERS:
            atexit.register(shutil.rmtree, folder)
        header = folder / "library.h"
        header.write_text('#include "accessor.h"\n#include "iec_std_lib.h"\n', "utf-8")
        whole = [flag for flag in compiler if flag != "-fsyntax-only"]
        _run_compiler(whole, tool, "-x", "c-header", str(header), "-o", f"{header}.gch")
        return str(header)

    return Path(shared(f"library_{compiler[0]}", precompile))


class Compiled(Machine):
    """The functions of a text in the standard's dialect; calls go to the compiled code."""

    def __init__(
        self,
        text: str,
        folder: Path,
        block: Block | None = None,
        unit: Unit | None = None,
    ) -> None:
        super().__init__(parsed(anonymous(text)) if unit is None else unit)
        self.block = block
        self._forms: dict[Any, Form] = {}
        self._packings: dict[tuple[Any, ...], Packing] = {}
        self.numbers = {name: number for number, name in enumerate(self.unit.functions)}
        self._process = subprocess.Popen(
            [str(self._program(text, folder))],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            env={**os.environ, "ASAN_OPTIONS": "detect_leaks=0", "UBSAN_OPTIONS": "halt_on_error=1:print_stacktrace=1"},
        )

    def call(self, name: str, **arguments: Any) -> tuple[Any, ...]:
        """What a function returns, and after it its outputs; what it is lent is changed."""
        function = self.unit.functions[name.lower()]
        arguments = {key.lower(): value for key, value in arguments.items()}
        sections = [
            (role, variable, self.kind(kind)) for role, variable, kind, _ in function.variables if role != "VAR"
        ]
        into = [(kind, variable) for role, variable, kind in sections if role in ("VAR_INPUT", "VAR_IN_OUT")]
        out = [
            (RESULT, "", self.kind(function.returns)),
            *(section for role in ("VAR_OUTPUT", "VAR_IN_OUT") for section in sections if section[0] == role),
        ]
        values = [self.numbers[function.name], *(arguments[variable] for _, variable in into)]
        packing = self._packing(NUMBER, *(kind for kind, _ in into))
        answer = self._asked(packing, values, self._packing(*(kind for _, _, kind in out)))
        for (role, variable, _), value in zip(out, answer, strict=True):
            if role == "VAR_IN_OUT" and isinstance(value, list):
                arguments[variable][:] = value
            elif role == "VAR_IN_OUT":
                arguments[variable].update(value)
        return tuple(value for (role, _, _), value in zip(out, answer, strict=True) if role != "VAR_IN_OUT")

    def restart(self) -> None:
        """Gives the variables of the block their initial values, as when a controller is switched on."""
        self._asked(self._packing(NUMBER), [len(self.numbers)], self._packing())

    def scan(self, milliseconds: int, values: Sequence[Any]) -> list[Any]:
        """Runs the block once, some time after the scan before, and gives what is read after it."""
        assert self.block is not None
        packing = self._packing(NUMBER, NUMBER, *[kind for _, kind in self.block.inputs])
        answer = self._packing(*[kind for _, kind in self.block.outputs])
        return self._asked(packing, [len(self.numbers) + 1, milliseconds, *values], answer)

    def _asked(self, packing: Packing, values: Sequence[Any], answer: Packing) -> list[Any]:
        """What the process answers."""
        flat: list[Any] = []
        for form, value in zip(packing.forms, values, strict=True):
            form.flatten(value, flat)
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        try:
            self._process.stdin.write(packing.struct.pack(*flat))
            self._process.stdin.flush()
        except BrokenPipeError:
            pass
        size = answer.struct.size
        got = self._process.stdout.read(size) if size else b""
        if len(got) < size:
            assert self._process.stderr is not None
            raise AssertionError(self._process.stderr.read().decode()[-4000:])
        elements = iter(answer.struct.unpack(got))
        return [form.raised(elements) for form in answer.forms]

    def _packing(self, *kinds: Any) -> Packing:
        """How values of some types are packed."""
        if kinds not in self._packings:
            forms = [self._form(kind) for kind in kinds]
            self._packings[kinds] = Packing(struct.Struct("<" + "".join(form.letters for form in forms)), forms)
        return self._packings[kinds]

    def _form(self, kind: Any) -> Form:
        """How values of a type are packed."""
        if kind not in self._forms:
            self._forms[kind] = self._new_form(self.kind(kind))
        return self._forms[kind]

    def _new_form(self, kind: Any) -> Form:
        if isinstance(kind, tuple):
            _, low, high, of = kind
            count, item = high - low + 1, self._form(of)
            letters = item.letters * count
            if of in FORMATS:
                return Form(letters, lambda array, flat: flat.extend(array), lambda rest: list(islice(rest, count)))
            return Form(
                letters,
                lambda array, flat: [item.flatten(value, flat) for value in array],
                lambda rest: [item.raised(rest) for _ in range(count)],
            )
        if kind in self.unit.structs:
            members = [(name, self._form(of)) for name, of, _ in self.unit.structs[kind]]
            return Form(
                "".join(member.letters for _, member in members),
                lambda value, flat: [member.flatten(value[name], flat) for name, member in members],
                lambda rest: {name: member.raised(rest) for name, member in members},
            )
        return Form(FORMATS[kind], lambda value, flat: flat.append(value), next)

    def _program(self, text: str, folder: Path) -> Path:
        """The program of a text, compiled."""
        tool = matiec()
        about = repr((text, self.block, COMPILERS, QUIET, Path(__file__).read_bytes()))
        place = folder / hashlib.sha256(about.encode()).hexdigest()[:16]
        place.mkdir(parents=True, exist_ok=True)
        with (place / "lock").open("w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            if not (place / "program").exists():
                self._compile(text, place, tool)
        return place / "program"

    def _compile(self, text: str, place: Path, tool: Path) -> None:
        """Translates and compiles a text; a warning of either compiler is an error."""
        (place / "text.st").write_text(text, "utf-8")
        ran = subprocess.run(
            [str(tool / "iec2c"), "-I", str(tool / "lib"), "-T", str(place), str(place / "text.st")],
            capture_output=True,
            text=True,
            check=False,
        )
        assert ran.returncode == 0, ran.stderr[-3000:]
        assert not ran.stderr, ran.stderr[-3000:]
        (place / "driver.c").write_text(self._driver((place / "POUS.h").read_text("utf-8")), "utf-8")
        # C has no literal of the least number of 64 bits: gcc warns of the one that matiec writes.
        source = place / "POUS.c"
        source.write_text(source.read_text("utf-8").replace(LEAST, f"({LEAST[:-1]}7 - 1)"), "utf-8")
        unfinished = place / "unfinished"
        for compiler in COMPILERS:
            places = ["-include", str(_library(compiler, tool)), f"-I{place}", "-o", str(unfinished)]
            _run_compiler(compiler, tool, *places, str(place / "driver.c"), "-lm")
        unfinished.rename(place / "program")

    def _driver(self, header: str) -> str:
        """The C around the routines: reads what is asked, calls it, and answers."""
        kinds = {name.lower(): (returns, rest) for returns, name, rest in PROTOTYPE.findall(header)}
        lines = [
            "#include <stdio.h>",
            "#include <stdlib.h>",
            '#include "POUS.h"',
            "TIME __CURRENT_TIME;",
            "BOOL __DEBUG;",
            '#include "POUS.c"',
            "static void get(void *to, size_t size) { if (fread(to, 1, size, stdin) != size) exit(0); }",
            "static void put(const void *from, size_t size) { fwrite(from, 1, size, stdout); }",
        ]
        for number, (name, function) in enumerate(self.unit.functions.items()):
            returns, rest = kinds[name]
            types = {text: kind for kind, text in self._parameters(rest)}
            lines.append(f"static void run_{number}(void) {{")
            sections = [
                (role, variable, self.kind(kind)) for role, variable, kind, _ in function.variables if role != "VAR"
            ]
            lines += [f"  static {types[variable]} of_{variable};" for _, variable, _ in sections]
            for role, variable, kind in sections:
                if role != "VAR_OUTPUT":
                    lines += self._moved("get", f"of_{variable}", kind, 1)
            arguments = [
                f"of_{text}" if role == "VAR_INPUT" else f"&of_{text}"
                for role, text, _ in self._in_order(sections, rest)
            ]
            lines.append(f"  {returns} result = {name.upper()}({', '.join(['1', 'NULL', *arguments])});")
            lines += self._moved("put", "result", self.kind(function.returns), 1)
            for wanted in ("VAR_OUTPUT", "VAR_IN_OUT"):
                for role, variable, kind in sections:
                    if role == wanted:
                        lines += self._moved("put", f"of_{variable}", kind, 1)
            lines.append("}")
        lines += self._block_lines()
        lines += [
            "int main(void) {",
            "  for (;;) {",
            "    unsigned number;",
            "    get(&number, 4);",
            "    switch (number) {",
        ]
        lines += [f"      case {number}: run_{number}(); break;" for number in range(self._routines())]
        lines += ["      default: return 1;", "    }", "    fflush(stdout);", "  }", "}"]
        return "\n".join(lines) + "\n"

    def _routines(self) -> int:
        return len(self.numbers) + (2 if self.block is not None else 0)

    @staticmethod
    def _parameters(rest: str) -> list[tuple[str, str]]:
        """The types and names of the parameters in a prototype."""
        result = []
        for text in filter(None, (part.strip() for part in rest.split(","))):
            kind, _, name = text.partition(" ")
            result.append((kind, name.removeprefix("*").removeprefix("__").lower()))
        return result

    def _in_order(self, sections: list[tuple[str, str, Any]], rest: str) -> list[tuple[str, str, Any]]:
        by_name = {text: (role, text, kind) for role, text, kind in sections}
        return [by_name[name] for _, name in self._parameters(rest)]

    def _block_lines(self) -> list[str]:
        """The functions that start and run the block."""
        if self.block is None:
            return []
        name, first = self.block.name.upper(), len(self.numbers)
        lines = [f"static {name} block;", f"static void run_{first}(void) {{"]
        lines += [f"  memset(&block, 0, sizeof block); {name}_init__(&block, 0);", "}"]
        lines += [f"static void run_{first + 1}(void) {{", "  unsigned milliseconds; get(&milliseconds, 4);"]
        lines += [
            "  long long at = __CURRENT_TIME.tv_sec * 1000LL + __CURRENT_TIME.tv_nsec / 1000000 + milliseconds;",
            "  __CURRENT_TIME.tv_sec = at / 1000; __CURRENT_TIME.tv_nsec = at % 1000 * 1000000;",
        ]
        for path, kind in self.block.inputs:
            lines += self._moved("get", self._place(path), self.kind(kind), 1)
        lines.append(f"  {name}_body__(&block);")
        for path, kind in self.block.outputs:
            lines += self._moved("put", self._place(path), self.kind(kind), 1)
        return [*lines, "}"]

    @staticmethod
    def _place(path: str) -> str:
        """A variable of the block in C, or a member of one."""
        variable, _, member = path.upper().partition("/")
        return f"block.{variable}.value" + (f".{member}" if member else "")

    def _moved(self, deed: str, place: str, kind: Any, depth: int) -> list[str]:
        """Statements that read or write a value, element by element."""
        kind, pad = self.kind(kind), "  " * depth
        if isinstance(kind, tuple):
            at = f"at{depth}"
            head = f"{pad}for (int {at} = 0; {at} < {kind[2] - kind[1] + 1}; {at}++) {{"
            return [head, *self._moved(deed, f"{place}.table[{at}]", kind[3], depth + 1), f"{pad}}}"]
        if kind in self.unit.structs:
            members = self.unit.structs[kind]
            return [line for name, of, _ in members for line in self._moved(deed, f"{place}.{name.upper()}", of, depth)]
        return [f"{pad}{deed}(&{place}, sizeof {place});"]
