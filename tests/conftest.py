"""What all tests share: their options, and a cache of their own."""

from __future__ import annotations

import gc
import os
import shutil
import signal
import sys
import tempfile
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest
from _pytest.assertion import rewrite
from hypothesis import settings
from hypothesis.internal.conjecture import providers
from xdist.workermanage import WorkerController

import parsed_once
from fieldspec import command
from fieldspec.language.model.codecs import provide
from package_site import example_codecs
from proofs import IS_WHOLE, share
from shared_results import FOLDERS

TESTS = Path(__file__).parent

assert command  # which provides those of installed packages
assert parsed_once  # which has specs read once
provide(example_codecs)

SLOW = (
    "audit/test_audit_page.py",
    "audit/test_detection.py",
    "c_output",
    "device",
    "docs_output",
    "frozen",
    "hostile_bytes",
    "hostile_texts",
    "js_output",
    "plc_memory",
    "plc_output",
    "queries_output",
    "random_devices",
    "test_add_a_device.py",
    "test_audit_of_manuals.py",
    "test_build.py",
    "test_build_incremental.py",
    "test_capabilities.py",
    "test_changes_mutations.py",
    "test_changes_never_raise.py",
    "test_checks_never_raise.py",
    "test_cli_docs.py",
    "test_cli_import.py",
    "test_compiled.py",
    "test_compiler_mutants.py",
    "test_determinism.py",
    "test_distribution.py",
    "test_editor.py",
    "test_explanation.py",
    "test_faults.py",
    "test_generated.py",
    "test_inputs_bounded.py",
    "test_interruptions.py",
    "test_mutants.py",
    "test_overviews.py",
    "test_page_commands.py",
    "test_plugins.py",
    "test_python_conversions.py",
    "test_python_frames.py",
    "test_python_heads.py",
    "test_python_many.py",
    "test_python_package.py",
    "test_python_records.py",
    "test_reading_any_input.py",
    "test_reading_large.py",
    "test_reading_yaml.py",
    "test_readme.py",
    "test_review.py",
    "test_rules.py",
    "test_schema.py",
    "test_versions_bad_input.py",
    "test_versions_example.py",
    "wireshark_output",
)
"""Files and folders that `--fast` leaves out: they run compilers, a browser or builds, or try many random inputs."""

MEMORY = Path("/dev/shm")
ROOM = 4 << 30
"""Bytes that all files of a run have room in."""

AT_ONCE = 0.01
"""Seconds of a fixture that no report shows."""

SHARED = "shared_results"
SHARED_FOLDER = pytest.StashKey[str]()

# The same inputs on every machine; the other profile looks for new ones.
settings.register_profile("fixed", derandomize=True, deadline=None)
settings.register_profile("random", derandomize=False, deadline=None, print_blob=True)
settings.load_profile("fixed")

# Hypothesis draws constants from the sources of all modules that are imported by then. A fixed seed would mean other
# examples whenever tests run in another order, or beside others.
assert callable(providers._get_local_constants)
NO_CONSTANTS = providers.Constants()
providers._get_local_constants = lambda: NO_CONSTANTS


# A shell that starts the tests in the background has them ignore interrupts, which the commands under test would
# inherit.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--accept", action="store_true", help="rewrite what the tests expect")
    parser.addoption("--fast", action="store_true", help="leave out the tests that take long")


def has_room(folder: Path) -> bool:
    return folder.is_dir() and os.access(folder, os.W_OK) and shutil.disk_usage(folder).free > ROOM


def pytest_configure(config: pytest.Config) -> None:
    """Tells a worker the folder of what workers share. Nothing of what is collected becomes garbage.

    Temporary files stay in memory where it can be: each file that a build places has to be on the disk before the next
    one, which takes longer than to make it.
    """
    if "TMPDIR" not in os.environ and has_room(MEMORY):
        os.environ["TMPDIR"] = tempfile.tempdir = str(MEMORY)
    config.addinivalue_line("markers", "proof(cases): a long proof, of which a run has a share: so many cases")
    gc.disable()
    if hasattr(config, "workerinput"):
        FOLDERS.append(Path(config.workerinput[SHARED]))
        if config.option.verbose <= 0:
            (worker,) = (plugin for plugin in config.pluginmanager.get_plugins() if hasattr(plugin, "sendevent"))
            worker.sendevent = partial(_send_what_matters, worker.sendevent)
        if not config.option.file_or_dir:
            workers, number = config.workerinput["workercount"], int(config.workerinput["workerid"].removeprefix("gw"))
            rewrite_tests(config, sorted(TESTS.rglob("test_*.py"))[number % workers :: workers])
            compute_first(number)


def _send_what_matters(send: Callable[..., None], name: str, **content: Any) -> None:
    """Tells the process that prints results nothing of fixtures that were ready at once; each report costs it 1 ms."""
    report = content.get("data", {}) if name == "testreport" else {}
    is_nothing = report.get("outcome") == "passed" and report["when"] != "call" and report["duration"] < AT_ONCE
    if not is_nothing and name not in ("logstart", "logfinish"):
        send(name, **content)


def rewrite_tests(config: pytest.Config, paths: Iterable[Path]) -> None:
    """Keeps the bytecode of some tests, for all workers to load.

    Rewriting their assertions takes several seconds, which each worker would do for all tests where Python may not
    write bytecode by itself, or where none is there yet.
    """
    for path in paths:
        folder = rewrite.get_cache_dir(path)
        target = folder / f"{path.stem}{rewrite.PYC_TAIL}"
        if rewrite._read_pyc(path, target) is None and rewrite.try_makedirs(folder):
            source_hash, code = rewrite._rewrite_test(path, config)
            rewrite._write_pyc(config.stash[rewrite.assertstate_key], code, source_hash, target)


def compute_first(number: int) -> None:
    """Computes one of the three largest results that tests are named after, in each worker another one.

    All workers collect the tests in the same order, and would wait for the first of them at each result.
    """
    sys.path[:0] = [str(TESTS / folder) for folder in ("c_output", "plc_output")]
    match number % 3:
        case 0:
            import_module("docs_output.documented").documentation()
        case 1:
            import_module("adapter_texts")  # which has the texts of all adapters
        case _:
            import_module("headers").newest_texts()


def pytest_configure_node(node: WorkerController) -> None:
    """Names the folder of what workers share to each of them, and makes it for the first."""
    if SHARED_FOLDER not in node.config.stash:
        folder = tempfile.TemporaryDirectory(prefix="fieldspec-tests-")
        node.config.stash[SHARED_FOLDER] = folder.name
        node.config.add_cleanup(folder.cleanup)
    node.workerinput[SHARED] = node.config.stash[SHARED_FOLDER]


def pytest_xdist_auto_num_workers() -> int:
    """One worker more than processors: tests that talk to devices and browsers wait for most of their time.

    Each worker collects all tests.
    """
    return 1 + (len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1)


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    """Leaves the slow tests out of a fast run, unless they are named on the command line."""
    if not config.getoption("--fast"):
        return None
    return True if any(collection_path == TESTS / name for name in SLOW) else None


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Leaves cases of long proofs out, unless the whole of them is asked for or a case is named."""
    proofs: dict[str, list[pytest.Item]] = defaultdict(list)
    for item in items:
        if not IS_WHOLE and item.get_closest_marker("proof"):
            proofs[item.nodeid.partition("[")[0]].append(item)
    left_out = set()
    for cases in proofs.values():
        marker = cases[0].get_closest_marker("proof")
        left_out |= {*cases} - {*share(cases, *(marker.args if marker is not None else ()))}
    if left_out:
        config.hook.pytest_deselected(items=[item for item in items if item in left_out])
        items[:] = [item for item in items if item not in left_out]


def pytest_collection_finish() -> None:
    """Keeps what is alive until the end out of the sight of the garbage collector, which also looks less often."""
    gc.enable()
    gc.freeze()
    gc.set_threshold(20_000, 10, 10)


@pytest.fixture(scope="session")
def accept(pytestconfig: pytest.Config) -> bool:
    """Whether a test writes its expectation instead of comparing with it."""
    return bool(pytestconfig.getoption("--accept"))


@pytest.fixture(scope="session", autouse=True)
def _cache_of_its_own(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """A folder for what verbs keep, which all workers share, so that no test sees what another run has left."""
    folder = FOLDERS[0] / "cache" if FOLDERS else tmp_path_factory.mktemp("cache")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("FIELDSPEC_CACHE", str(folder))
        yield
