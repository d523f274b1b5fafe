"""Prints what a codec answers about a fact: `python tests/frozen/answers.py tc100 2.0 python registers/motion_command`.

`--against main` prints instead the first input that the codec of another commit answers otherwise, with both answers.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
from itertools import zip_longest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from frozen.codecs import CODECS, Aspects
from frozen.digests import answered, distinct_layouts
from frozen.inputs import facts

ROOT = Path(__file__).resolve().parents[2]


def answer_lines(device: str, version: str, codec: str, path: str) -> list[str]:
    """A line for each input, with the answers of a codec; raises KeyError for a fact or a version that there is not."""
    layout = distinct_layouts()[device, version]
    fact = {fact.path: fact for fact in facts(layout)}[path]
    (entry,) = answered(layout, [fact], [codec])
    return [f"{item.text} -> {_text(answer)}" for item, answer in zip(entry.inputs, entry.answers[codec], strict=True)]


def _text(answer: Aspects) -> str:
    return "; ".join(f"{aspect} {text}" for aspect, text in sorted(answer.items()))


def lines_of_commit(commit: str, arguments: list[str]) -> list[str]:
    """What this program prints at another commit."""
    with tempfile.TemporaryDirectory(prefix="fieldspec-commit-") as folder:
        git = ["git", "-C", str(ROOT), "worktree"]
        subprocess.run([*git, "add", "--quiet", "--detach", folder, commit], check=True)
        try:
            program = Path(folder, "tests", "frozen", "answers.py")
            environment = {**os.environ, "PYTHONPATH": str(Path(folder, "codegen"))}
            command = [sys.executable, str(program), *arguments]
            run = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
        finally:
            subprocess.run([*git, "remove", "--force", folder], check=True)
    return run.stdout.splitlines()


def main() -> int:
    """Prints the answers. Returns the exit code: 1 where those of the other commit differ."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("device")
    parser.add_argument("version")
    parser.add_argument("codec", choices=CODECS)
    parser.add_argument("fact", help="its path, as it stands in tests/frozen/digests/")
    parser.add_argument("--against", metavar="COMMIT")
    options = parser.parse_args()
    arguments = [options.device, options.version, options.codec, options.fact]
    lines = answer_lines(*arguments)
    if options.against is None:
        print("\n".join(lines))
        return 0
    for now, before in zip_longest(lines, lines_of_commit(options.against, arguments), fillvalue="nothing"):
        if now != before:
            print(f"{options.against}: {before}\nhere: {now}")
            return 1
    print(f"{len(lines)} answers are the same")
    return 0


if __name__ == "__main__":
    sys.exit(main())
