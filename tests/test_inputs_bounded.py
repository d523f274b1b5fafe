"""Files designed to exhaust memory or to block for ever are refused in seconds, in bounded memory."""

from __future__ import annotations

import gzip
import io
import os
import socket
import struct
import subprocess
import sys
import zipfile
from collections.abc import Callable
from pathlib import Path

import pytest

from bounded import HANGING, limits
from proofs import IS_WHOLE

SPECS = Path(__file__).resolve().parent.parent / "specs"
DEVICE = (SPECS.parent / "tests/cases/file_regular/passing/gadget/device.yaml").read_bytes()
MEMORY = 1 << 30
"""Bytes of address space for a run."""
SECONDS = 60
"""Seconds of a processor, far above the usual one to five."""

_MAIN = "http://schemas.openxmlformats.org/spreadsheetml/2006/main"
_OFFICE = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
_PACKAGE = "http://schemas.openxmlformats.org/package/2006"
_FORM = "application/vnd.openxmlformats-officedocument.spreadsheetml"
BOOK = (
    f'<workbook xmlns="{_MAIN}" xmlns:r="{_OFFICE}"><sheets><sheet name="list" sheetId="1" r:id="rId1"/></sheets>'
    "</workbook>"
)
PARTS = {
    "[Content_Types].xml": f'<Types xmlns="{_PACKAGE}/content-types">'
    f'<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>'
    f'<Override PartName="/xl/workbook.xml" ContentType="{_FORM}.sheet.main+xml"/>'
    f'<Override PartName="/xl/worksheets/sheet1.xml" ContentType="{_FORM}.worksheet+xml"/></Types>',
    "_rels/.rels": f'<Relationships xmlns="{_PACKAGE}/relationships">'
    f'<Relationship Id="rId1" Type="{_OFFICE}/officeDocument" Target="xl/workbook.xml"/></Relationships>',
    "xl/_rels/workbook.xml.rels": f'<Relationships xmlns="{_PACKAGE}/relationships">'
    f'<Relationship Id="rId1" Type="{_OFFICE}/worksheet" Target="worksheets/sheet1.xml"/></Relationships>',
    "xl/workbook.xml": BOOK,
}
"""The other parts of a workbook with one sheet."""
SHEET = f'<worksheet xmlns="{_MAIN}">'
CELL = '<c r="A1"><v>1</v></c>'


def run(*arguments: str, seconds: int = SECONDS) -> subprocess.CompletedProcess[str]:
    """Runs the command line in bounded memory and time, and checks that it prints no traceback."""
    ran = subprocess.run(
        [sys.executable, "-m", "fieldspec", *arguments],
        preexec_fn=limits(seconds, MEMORY),
        capture_output=True,
        text=True,
        encoding="utf-8",
        timeout=HANGING,
        check=False,
    )
    assert "Traceback" not in ran.stderr
    return ran


def workbook(sheet: str, times: int = 1, repeated: str = "", end: str = "", level: int = 1) -> bytes:
    """A workbook whose sheet begins with a text and repeats another one, written in parts to save memory."""
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED, compresslevel=level) as file:
        for name, text in PARTS.items():
            file.writestr(name, text)
        with file.open("xl/worksheets/sheet1.xml", "w") as part:
            part.write((SHEET + sheet).encode())
            for _ in range(times // 1000):
                part.write(repeated.encode() * 1000)
            part.write((end + "</worksheet>").encode())
    return packed.getvalue()


LISTS: dict[str, tuple[Callable[[], bytes], str]] = {
    "a row of 250 MB of cells": (
        lambda: workbook("<sheetData><row>", 11_000_000, CELL, "</row></sheetData>"),
        "unpacks to more than a list of registers holds",
    ),
    "a row of 100 MB of cells": (
        lambda: workbook("<sheetData><row>", 4_500_000, "<c><v>1</v></c>", "</row></sheetData>"),
        "has more than 1000 columns",
    ),
    "many rows of cells": (
        lambda: workbook("<sheetData>", 90_000, f"<row>{'<c><v>1</v></c>' * 10}</row>", "</sheetData>"),
        "has more than 500000 cells",
    ),
    "many rows": (
        lambda: workbook("<sheetData>", 200_000, "<row><c><v>1</v></c></row>", "</sheetData>"),
        "has more than 100000 rows",
    ),
    "many empty rows": (lambda: workbook("<sheetData>", 200_000, "<row/>", "</sheetData>"), "is empty"),
    "a cell far away": (
        lambda: workbook('<sheetData><row r="99999"><c r="ALL99999"><v>1</v></c></row></sheetData>'),
        "has 99999 rows with 1000 columns, which is more than 500000 cells; remove what is far away",
    ),
    "a cell at the end": (
        lambda: workbook('<sheetData><row r="1048576"><c r="XFD1048576"><v>1</v></c></row></sheetData>'),
        "has more than 100000 rows",
    ),
    "an empty cell at the end": (
        lambda: workbook('<sheetData><row r="1048576"><c r="XFD1048576"/></row></sheetData>'),
        "is empty",
    ),
    "an empty row of no sheet": (
        lambda: workbook('<sheetData><row r="2000000000"/></sheetData>'),
        "is empty",
    ),
    "a giant merged range": (
        lambda: workbook('<sheetData/><mergeCells><mergeCell ref="A1:XFD1048576"/></mergeCells>'),
        "has merged cells as far as A1:XFD1048576",
    ),
    "many merged ranges": (
        lambda: workbook("<sheetData/><mergeCells>", 2000, '<mergeCell ref="A1:Z1000"/>', "</mergeCells>"),
        "has merged cells as far as",
    ),
    "elements within each other": (lambda: workbook("<a>" * 1000), "unpacks to more than a list of registers holds"),
    "an entity after a long remark": (
        lambda: (
            workbook("").replace(b"", b"", 0)
            and _packed(f"<!--{'x' * 5000}--><!DOCTYPE x [<!ENTITY a 'b'>]><x>&a;</x>")
        ),
        "declares entities",
    ),
    "more parts than a workbook has": (lambda: _packed(BOOK, 3000), "has more than 2000 parts"),
    "JSON nested 985 deep": (lambda: b"[" * 985 + b"]" * 985, "nested more than 16 levels deep"),
    "JSON of empty lists": (lambda: b"[" + b"[]," * 10_000_000 + b"[]]", "is JSON with more than 2000000 values"),
    "JSON of marks of escapes": (lambda: b'["' + b'\\"' * 4_000_000, "begins like JSON but is not JSON"),
    "lines without an end": (lambda: b"\n" * (32 << 20), "is empty"),
    "an address and many empty lines": (lambda: b"address\n0x10\n" + b"\n" * (31 << 20), "has more than 100000 rows"),
    "a row of separators": (lambda: b"address" + b"," * (31 << 20), "has a row with more than 1048576 characters"),
    "a row of open quotes": (
        lambda: b"address\n" + b',"a\n"' * 6_000_000,
        "has a row with more than 1048576 characters",
    ),
}


def _packed(book: str, parts: int = 0) -> bytes:
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as file:
        file.writestr("xl/workbook.xml", book)
        for number in range(parts):
            file.writestr(f"xl/{number}", "")
    return packed.getvalue()


@pytest.mark.proof(5)
@pytest.mark.parametrize("name", LISTS)
def test_a_list_that_is_made_to_be_large_is_refused(name: str, tmp_path: Path) -> None:
    make, text = LISTS[name]
    path = tmp_path / "list.dat"
    path.write_bytes(make())
    ran = run("import", str(path), "--to", "-")
    assert (ran.returncode, ran.stdout) == (2, "")
    assert len(ran.stderr.splitlines()) == 1
    assert len(ran.stderr) < 1000
    assert text in ran.stderr


def test_a_dump_that_is_nested_deep_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "dump.json"
    path.write_text('{"1": ' + "[" * 985 + "]" * 985 + "}", encoding="utf-8")
    ran = run("audit", "tc100", "--dump", str(path), "--specs", str(SPECS))
    assert (ran.returncode, ran.stdout) == (2, "")
    assert "nested more than 16 levels deep" in ran.stderr


@pytest.mark.proof
@pytest.mark.parametrize(
    ("verb", "first"),
    [(("compare", "tc100"), 0x1000), (("audit", "tc100", "--dump"), 0x20000)],
    ids=["compare", "audit"],
)
def test_a_list_of_many_rows_prints_what_a_person_can_read(verb: tuple[str, ...], first: int, tmp_path: Path) -> None:
    path = tmp_path / "list.csv"
    # The report of all rows would be longer than what is asserted for any of these numbers.
    numbers = range(99_000 if IS_WHOLE else 6_000)
    rows = [f"{first + (number if first > 0xFFFF else 0):#x},{number % 7}" for number in numbers]
    path.write_text("address,value\n0x1000,0\n" + "\n".join(rows), encoding="utf-8")
    ran = run(*verb, str(path), "--specs", str(SPECS))
    assert ran.returncode == 1
    assert len(ran.stdout) < 100_000


def pipe(path: Path) -> None:
    os.mkfifo(path)


def sparse(path: Path) -> None:
    with path.open("wb") as file:
        file.truncate(1 << 40)


def bound(path: Path) -> None:
    with socket.socket(socket.AF_UNIX) as listener:
        here = os.getcwd()
        os.chdir(path.parent)
        listener.bind(path.name)
        os.chdir(here)


def secret(path: Path) -> None:
    path.symlink_to(next(above / "secret.txt" for above in path.parents if (above / "secret.txt").exists()))


IRREGULAR: dict[str, tuple[Callable[[Path], object], str]] = {
    "a pipe": (pipe, "it is a pipe"),
    "a socket": (bound, "it is a socket"),
    "a folder": (Path.mkdir, "it is a folder"),
    "a sparse file": (sparse, "has 1099511627776 bytes"),
    "zeros without end": (lambda path: path.symlink_to("/dev/zero"), "a link out of the folder of the specs"),
    "noise without end": (lambda path: path.symlink_to("/dev/urandom"), "a link out of the folder of the specs"),
    "a file of somebody else": (secret, "a link out of the folder of the specs"),
    "a link to itself": (lambda path: path.symlink_to(path.name), "the file"),
}


@pytest.mark.proof(6)
@pytest.mark.parametrize(
    "place", ["gadget/device.yaml", "gadget/more.yaml", "protocols/wire.yaml", "gadget/versions/2.yaml"]
)
@pytest.mark.parametrize("kind", IRREGULAR)
def test_a_spec_that_is_no_regular_file_is_refused_and_not_quoted(kind: str, place: str, tmp_path: Path) -> None:
    make, text = IRREGULAR[kind]
    (tmp_path / "secret.txt").write_text("root:secret:0", encoding="utf-8")
    specs = tmp_path / "specs"
    for folder in ("gadget/versions", "protocols"):
        (specs / folder).mkdir(parents=True)
    (specs / "gadget/device.yaml").write_bytes(DEVICE)
    (specs / place).unlink(missing_ok=True)
    make(specs / place)
    out = tmp_path / "out"
    builds = (("build", "--out", str(out)), ("build", "--check", "--out", str(out)))
    for words in (("check",), *(builds if place == "gadget/device.yaml" else ())):
        ran = run(*words, "--specs", str(specs))
        assert ran.returncode == 1
        assert text in ran.stdout + ran.stderr
        assert "secret:0" not in ran.stdout + ran.stderr
    assert not out.exists()


@pytest.mark.proof(5)
@pytest.mark.parametrize("kind", ["a pipe", "a socket", "a folder", "a sparse file"])
@pytest.mark.parametrize(
    "words",
    [
        ("import", "FILE", "--to", "-"),
        ("compare", "tc100", "FILE"),
        ("audit", "tc100", "--dump", "FILE"),
        ("audit", "tc100", "--manual", "FILE"),
    ],
    ids=" ".join,
)
def test_a_list_or_manual_that_is_no_regular_file_is_wrong_use(
    kind: str, words: tuple[str, ...], tmp_path: Path
) -> None:
    path = tmp_path / "file"
    IRREGULAR[kind][0](path)
    specs = () if words[0] == "import" else ("--specs", str(SPECS))
    ran = run(*(str(path) if word == "FILE" else word for word in words), *specs)
    assert (ran.returncode, ran.stdout) == (2, "")
    assert len(ran.stderr.splitlines()) == 1


PACKET = struct.pack("<IIII", 1, 0, 1 << 26, 1 << 26)
SPARSE: dict[str, bytes] = {
    "nothing but zeros": b"",
    "the header of a capture": struct.pack("<IHHiIII", 0xA1B2C3D4, 2, 4, 0, 0, 0x40000, 1),
    "a capture with a packet of all": struct.pack("<IHHiIII", 0xA1B2C3D4, 2, 4, 0, 0, 0x40000, 147) + PACKET,
    "the header of pcapng": struct.pack("<IIIHHqI", 0x0A0D0D0A, 28, 0x1A2B3C4D, 1, 0, -1, 28),
    "a log": b"12:00:00 TX: 01 04 00 00 00 02 71 CB\n" * 200,
    "a log that ends in a line": b"12:00:00 TX: 01 04 00 00 00 02 71 CB\n" * 200 + b"12:00:00 TX: 01",
    "rows of registers": b"time,address,value\n" + b"1.5 ,0,1\n" * 800,
}
"""What a file of 10 GB begins with; the rest of it was never written, so it takes no place on the disk."""


@pytest.mark.proof(2)
@pytest.mark.parametrize("kind", SPARSE)
def test_a_capture_of_which_most_was_never_written_is_read_in_seconds(kind: str, tmp_path: Path) -> None:
    path = tmp_path / "captures" / "file"
    path.parent.mkdir()
    with path.open("wb") as file:
        file.write(SPARSE[kind])
        file.truncate(10 << 30)
    out = tmp_path / "out"
    verbs = {
        ("decode", "wattmeter", str(path), "--to", "csv", "--out", str(out)): (1,),
        ("audit", "wattmeter", "--captures", str(path.parent)): (0, 2),
        ("redact", "wattmeter", str(path), "--out", str(tmp_path / "redacted")): (0, 1),
    }
    for words, codes in verbs.items():
        assert run(*words, "--specs", str(SPECS.parent / "tests/specs"), seconds=20).returncode in codes
    assert ("bytes lost" in (out / "summary.json").read_text("utf-8")) == bool(SPARSE[kind])


@pytest.mark.proof(1)
@pytest.mark.parametrize("kind", ["the header of a capture", "a capture with a packet of all", "a log"])
def test_a_capture_that_unpacks_to_much_more_is_read_in_bounded_memory(kind: str, tmp_path: Path) -> None:
    path = tmp_path / "file"
    with gzip.open(path, "wb", compresslevel=1) as stream:
        stream.write(SPARSE[kind])
        for _ in range(400):
            stream.write(bytes(1 << 20))
    words = ("decode", "wattmeter", str(path), "--to", "csv", "--out", str(tmp_path / "out"))
    assert run(*words, "--specs", str(SPECS.parent / "tests/specs")).returncode == 1


@pytest.mark.parametrize("kind", ["a pipe", "a folder", "a sparse file"])
def test_an_index_of_a_manual_that_is_no_regular_file_is_refused(kind: str, tmp_path: Path) -> None:
    specs = tmp_path / "specs"
    (specs / "gadget").mkdir(parents=True)
    (specs / "gadget/device.yaml").write_bytes(DEVICE)
    IRREGULAR[kind][0](specs / "gadget/manual.index")
    # A build leaves out the device alone, as for any file of its spec that is wrong; an audit is about nothing else.
    for words, code in ((("audit", "gadget"), 2), (("build", "--out", str(tmp_path / "out")), 1)):
        ran = run(*words, "--specs", str(specs))
        assert ran.returncode == code
        assert "manual.index" in ran.stderr


@pytest.mark.parametrize("kind", ["a pipe", "a socket"])
def test_an_output_that_is_no_regular_file_is_replaced(kind: str, tmp_path: Path) -> None:
    specs, out = tmp_path / "specs", tmp_path / "out"
    (specs / "gadget").mkdir(parents=True)
    (specs / "gadget/device.yaml").write_bytes(DEVICE)
    words = ("build", "--to", "vectors", "--specs", str(specs), "--out", str(out))
    assert run(*words).returncode == 0
    for path in (out / "manifest.json", out / "vectors/gadget.json"):
        before = path.read_bytes()
        path.unlink()
        IRREGULAR[kind][0](path)
        assert run(*words).returncode == 0
        assert path.read_bytes() == before


def uses(*names: str) -> str:
    return "uses: [" + ", ".join(f"{{protocol: {name}}}" for name in names) + "]\n"


REFERRING: dict[str, tuple[Callable[[], dict[str, str]], int]] = {
    "a chain of protocols": (
        lambda: {"gadget/device.yaml": uses("p0"), **{f"protocols/p{n}.yaml": uses(f"p{n + 1}") for n in range(900)}},
        1,
    ),
    "a fan of protocols": (
        lambda: (
            {"gadget/device.yaml": uses(*(f"p{n}" for n in range(900)))}
            | {f"protocols/p{n}.yaml": "" for n in range(900)}
        ),
        1,
    ),
    "protocols that all use the next two": (
        lambda: (
            {"gadget/device.yaml": uses("p0", "q0")}
            | {
                f"protocols/{p}{n}.yaml": uses(f"p{n + 1}", f"q{n + 1}") if n < 14 else ""
                for n in range(15)
                for p in "pq"
            }
        ),
        0,
    ),
    "a chain of versions": (
        lambda: (
            {"gadget/device.yaml": 'versions: [{line: main, title: A, members: [{id: "0", source: 1 L1}]}]\n'}
            | {
                f"gadget/versions/{n}.yaml": f'{{id: "{n}", line: main, based_on: "{n - 1}", source: 1 L1}}'
                for n in range(1, 900)
            }
        ),
        1,
    ),
    "more files than a folder has": (
        lambda: {"gadget/device.yaml": ""} | {f"gadget/{n}.yaml": "enums: []\n" for n in range(5000)},
        1,
    ),
}


@pytest.mark.parametrize("name", REFERRING)
def test_specs_that_refer_to_each_other_without_end_are_read_in_seconds(name: str, tmp_path: Path) -> None:
    make, code = REFERRING[name]
    for path, text in make().items():
        folder, _, file = path.partition("/")
        stem = file.rpartition("/")[2].removesuffix(".yaml")
        head = f"protocol: {{id: {stem}, title: A, doc: B.}}\n" if folder == "protocols" else ""
        head = DEVICE.decode() if file == "device.yaml" else "overlay: " if "versions" in file else head
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(head + text, encoding="utf-8")
    ran = run("check", "--specs", str(tmp_path))
    assert ran.returncode == code
    assert len(ran.stdout) < 200_000
