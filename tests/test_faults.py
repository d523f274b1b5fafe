"""After any fault at any operation on files, the outputs are all old or all new, and the next run repairs them."""

from __future__ import annotations

import os
import shutil
import signal
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from faults import FAULTS, Fault, struck
from faulty_works import GONE, NEW, built, exported, imported, new, placed, repaired, signed
from fieldspec.command.builds import workers
from fieldspec.command.console.usage import UsageError
from fieldspec.command.files.cache_folder import TAG
from fieldspec.command.files.placement import Staging, begin, complete, prepared, undo
from fieldspec.command.files.storage import BESIDE
from fieldspec.language.model.choice import PROJECT_FILE
from proofs import IS_WHOLE

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="needs fork")

SPECS = Path(__file__).resolve().parent / "specs"
MOST = 2000
STEP = 1 if IS_WHOLE else 47
"""A whole build is tested with a fault at every n-th operation, and in the whole proof at every operation."""
PLACING_STEP = min(STEP, 7)
"""The same for placing a few files."""
REPAIRS = 4 if IS_WHOLE else 48
"""Every how many of the places at which a build was killed its repair is killed too."""

State = dict[str, bytes]


def state(folder: Path) -> State:
    """The files and empty folders of a folder, without those that exist only while something is written."""
    return {
        path.relative_to(folder).as_posix(): path.read_bytes() if path.is_file() else b""
        for path in sorted(folder.rglob("*"))
        if (path.is_file() or not any(path.iterdir()))
        and not any(part.startswith(BESIDE) for part in path.relative_to(folder).parts)
    }


def left_over(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.rglob(f"*{BESIDE}*"))


def test_files_are_restored_into_folders_that_went_with_them(tmp_path: Path) -> None:
    out, folder = tmp_path / "out", tmp_path / "out" / f"{BESIDE}{'0' * 16}"
    (out / "c" / "tc100").mkdir(parents=True)
    for path in ("c/tc100/tc100.h", "manifest.json"):
        (out / path).write_text(path, "utf-8")
    old = state(out)
    journal = prepared(out, folder, (), ("c/tc100/tc100.h", "manifest.json"))
    begin(folder, journal)
    complete(out, folder, journal)
    assert state(out) == {}
    undo(out, folder, journal)
    assert state(out) == old


class Work:
    """A change of a folder from an old state to a new one, which a test can repeat."""

    def __init__(self, folder: Path, old: Path, work: Callable[[Path], object]) -> None:
        self.folder, self.before, self.work = folder / "place", old, work
        self.reset()
        self.old = state(self.folder)
        work(self.folder)
        self.new = state(self.folder)
        assert left_over(self.folder) == []
        assert self.old != self.new

    def reset(self) -> None:
        shutil.rmtree(self.folder, ignore_errors=True)
        shutil.copytree(self.before, self.folder, symlinks=True)

    def faulty(self, fault: Fault, step: int = 1, first: int = 1) -> Iterator[int]:
        """Puts a fault at each operation in turn, or at every n-th one from the first."""
        for number in range(first, MOST, step):
            self.reset()
            if not struck(self.work, self.folder, fault, number):
                return
            yield number
        raise AssertionError("there is no end of operations")


OLD = {"a/one": b"1", "a/two": b"2", "b/three": b"3", "gone/four": b"4", "mine": b"not ours", "same": b"s"}


@pytest.fixture
def files(tmp_path: Path) -> Work:
    for path, content in OLD.items():
        (tmp_path / "old" / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "old" / path).write_bytes(content)
    return Work(tmp_path, tmp_path / "old", placed)


@pytest.mark.proof
@pytest.mark.parametrize("fault", FAULTS, ids=lambda fault: fault.name)
def test_files_are_placed_all_or_none_whatever_happens(fault: Fault, files: Work) -> None:
    assert files.new == {path: content for path, content in {**OLD, **NEW}.items() if path not in GONE}
    states = set()
    for number in files.faulty(fault, min(STEP, 23) if fault.name == "interrupted call" else PLACING_STEP):
        if fault.error is not None and not fault.lasts:
            assert state(files.folder) in (files.old, files.new), f"at operation {number}"
        with Staging(files.folder):
            pass
        now = state(files.folder)
        assert now in (files.old, files.new), f"at operation {number}"
        assert left_over(files.folder) == [], f"at operation {number}"
        states.add("old" if now == files.old else "new")
        placed(files.folder)
        assert state(files.folder) == files.new, f"at operation {number}"
    # On a full disk no journal can be begun.
    assert states == ({"old"} if fault.name == "full disk" else {"old", "new"})


def test_signals_during_operations_change_nothing(files: Work) -> None:
    counts = [0]

    def count(*_: object) -> None:
        counts[0] += 1

    previous = signal.signal(signal.SIGALRM, count)
    signal.setitimer(signal.ITIMER_REAL, 0.0002, 0.0002)
    try:
        for _ in range(10):
            files.reset()
            placed(files.folder)
            assert state(files.folder) == files.new
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, previous)
    assert counts[0] > 10
    assert left_over(files.folder) == []


@pytest.mark.proof
def test_a_repair_that_is_interrupted_is_repaired(files: Work) -> None:
    kill = FAULTS[0]
    unfinished = 0
    for first in files.faulty(kill, REPAIRS, REPAIRS):
        if not left_over(files.folder):
            continue
        broken = files.folder.with_name("broken")
        shutil.rmtree(broken, ignore_errors=True)
        shutil.copytree(files.folder, broken, symlinks=True)
        for fault in (kill, FAULTS[2]):
            for second in range(1, MOST):
                shutil.rmtree(files.folder)
                shutil.copytree(broken, files.folder, symlinks=True)
                if not struck(repaired, files.folder, fault, second):
                    break
                unfinished += 1
                repaired(files.folder)
                assert state(files.folder) in (files.old, files.new), f"at operations {first} and {second}"
                assert left_over(files.folder) == []
    assert unfinished > 200 / REPAIRS


@pytest.fixture
def outputs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Work:
    """A build after which a device has changed, one is new, and one has gone."""
    monkeypatch.setattr(workers, "WORTH_IT", 10**9)  # in one process: the one with the fault
    monkeypatch.setenv("FIELDSPEC_CACHE", str(tmp_path / "place/cache"))
    old = tmp_path / "old"
    for name in ("gadget", "gizmo"):
        shutil.copytree(SPECS / name, old / "specs" / name)
    monkeypatch.setenv("FIELDSPEC_CACHE", str(tmp_path / "unused"))
    assert built(old) == 0
    shutil.rmtree(old / "specs/gizmo")
    shutil.copytree(SPECS / "glider-x", old / "specs/glider-x")
    device = old / "specs/gadget/device.yaml"
    device.write_text(device.read_text("utf-8").replace("name: Gadget", "name: Gidget", 1), "utf-8")
    monkeypatch.setenv("FIELDSPEC_CACHE", str(tmp_path / "place/cache"))
    return Work(tmp_path, old, built)


def of_outputs(files: State) -> State:
    return {path: content for path, content in files.items() if path.startswith("out/")}


@pytest.mark.proof
@pytest.mark.parametrize("fault", [FAULTS[0], FAULTS[3]], ids=lambda fault: fault.name)
def test_a_build_leaves_the_old_outputs_or_the_new_ones(
    fault: Fault, outputs: Work, capsys: pytest.CaptureFixture[str]
) -> None:
    count = 0
    for number in outputs.faulty(fault, STEP):
        count += 1
        out = outputs.folder / "out"
        unfinished = bool(left_over(out))
        capsys.readouterr()
        code = built(outputs.folder, "--check")
        output = capsys.readouterr().out
        assert unfinished == ("unfinished: " in output or "left over: " in output), f"at operation {number}"
        assert code == (1 if unfinished or "not fresh" in output else 0)
        with Staging(out):
            pass
        now = of_outputs(state(outputs.folder))
        assert now in (of_outputs(outputs.old), of_outputs(outputs.new)), f"at operation {number}"
        assert built(outputs.folder) == 0
        assert of_outputs(state(outputs.folder)) == of_outputs(outputs.new), f"at operation {number}"
        assert left_over(outputs.folder) == []
        cache = outputs.folder / "cache"
        assert [path.name for path in cache.rglob("*") if path.is_file() and not path.name.isalnum()] == [TAG]
    assert count > 50 / STEP


LIST = "Address,Name,Type,Access\n0x10,speed,u16,rw\n0x11,torque,u16,r\n"


VERBS: dict[str, Callable[[Path], int]] = {"import": imported, "--sign": signed, "new": new, "export": exported}


@pytest.mark.proof(3)
@pytest.mark.parametrize("fault", [FAULTS[0], FAULTS[3], FAULTS[5]], ids=lambda fault: fault.name)
@pytest.mark.parametrize("verb", VERBS)
def test_a_verb_that_writes_a_file_writes_it_whole_or_not_at_all(
    verb: str, fault: Fault, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("FIELDSPEC_CACHE", str(tmp_path / "cache"))
    shutil.copytree(SPECS / "gadget", tmp_path / "old/specs/gadget")
    (tmp_path / "old/list.csv").write_text(LIST, encoding="utf-8")
    work = Work(tmp_path, tmp_path / "old", VERBS[verb])
    count = 0
    for number in work.faulty(fault):
        count += 1
        now = {path: content for path, content in state(work.folder).items() if content}
        full = {path: content for path, content in work.new.items() if content}
        before = {path: content for path, content in work.old.items() if content}
        # Schemas for editors and the project file are files of their own, written before the device.
        shared = {path: full[path] for path in now if path.endswith((".schema.json", PROJECT_FILE))}
        assert now in (before | shared, full), f"at operation {number}"
        if now != full:
            assert VERBS[verb](work.folder) == 0
        elif verb in ("import", "new"):
            assert VERBS[verb](work.folder) == 2  # such a file exists already
        else:
            assert VERBS[verb](work.folder) == 0
        assert left_over(work.folder) == [], f"at operation {number}"
    assert count >= 3


def test_a_journal_that_somebody_else_wrote_has_no_effect(tmp_path: Path) -> None:
    out = tmp_path / "out"
    folder = out / f"{BESIDE}{'0' * 16}"
    (folder / "new/c").mkdir(parents=True)
    (folder / "new/c/x").write_bytes(b"evil")
    (tmp_path / "home").mkdir()
    (out / "c").symlink_to(tmp_path / "home")
    for path in ("c/x", "../home/x", "/etc/passwd"):
        (folder / "journal").write_text(f'{{"place": ["{path}"], "remove": [], "absent": [], "folders": []}}', "utf-8")
        with pytest.raises(UsageError, match="leads out of"), Staging(out):
            pass
        assert os.listdir(tmp_path / "home") == []
    (folder / "journal").write_text("[]", "utf-8")
    with pytest.raises(UsageError, match="is not a journal of a build"), Staging(out):
        pass


def test_nothing_is_placed_through_a_link_that_leads_out(tmp_path: Path) -> None:
    (tmp_path / "home").mkdir()
    (tmp_path / "out").mkdir()
    (tmp_path / "out/c").symlink_to(tmp_path / "home")
    with Staging(tmp_path / "out") as beside:
        beside.write("c/x", b"evil")
        with pytest.raises(UsageError, match="leads out of"):
            beside.place(["c/x"], [])
    assert os.listdir(tmp_path / "home") == []
    assert left_over(tmp_path) == []
