"""Generated Structured Text as a judge: its functions are run, by an interpreter or compiled by matiec and gcc."""

from __future__ import annotations

import random
import sys
from pathlib import Path

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.language.diagnostics import has_errors
from fieldspec.targets import OUTPUTS
from fieldspec.targets.controllers.structured.program import declared_in_text, program
from fieldspec.targets.iec.backend import refusals, source
from fieldspec.targets.iec.backend import text as standard_text
from fieldspec.targets.st.backend import text
from random_devices.queries import Answer, Query

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "plc_output"))

from comparisons import compare_requests, compare_responses, compare_states, compare_telegrams
from compiled import Compiled
from proving import Proof
from st_machine import Machine
from st_syntax import parsed

SILENT = Answer(reason=None)
DEFECTS_OF_MATIEC = ("Internal compiler error in file generate_c", "error: expected expression before ")
"""What matiec does with some declarations: it ends, or writes `{0,,}` in C for an array of arrays with one element.

The interpreter judges such devices all the same.
"""
UNJUDGED = ("kv", "scl", "wireshark")
"""Outputs without a judge, which are written all the same: what is left out is nowhere asked for."""
TRIES = 6
"""Values for each message; a compiled program runs them faster, but takes seconds to compile."""


class StructuredText:
    """The functions of a device, for what the output does not leave out. Of a device that it refuses, there are none.

    Every other output also says what it refuses, and must not raise; some are written.
    """

    def __init__(self, layout: DeviceLayout, folder: Path, is_compiled: bool = False) -> None:
        self.prover: Proof | None = None
        if is_compiled and not has_errors(refusals([layout])):
            own = source(layout)
            try:
                self.prover = Proof(own.declared.world, Compiled(standard_text(own), folder))
            except AssertionError as error:
                if not any(defect in str(error) for defect in DEFECTS_OF_MATIEC):
                    raise
        for output in () if is_compiled else OUTPUTS.values():
            if not has_errors(output.refusals([layout])) and output.name in UNJUDGED:
                output.files([layout])
        if not is_compiled and not has_errors(declared_in_text(layout).findings):
            own_program = program(layout)
            self.prover = Proof(own_program.declared.world, Machine(parsed(text(own_program))))

    def answers(self, queries: list[Query]) -> list[Answer]:
        """Nothing about single queries; raises AssertionError where a function does other than the reference."""
        if self.prover is not None:
            dice = random.Random(len(queries))
            compare_states(self.prover)
            compare_telegrams(self.prover, dice, TRIES)
            compare_requests(self.prover, dice, TRIES)
            compare_responses(self.prover, dice, 2 * TRIES)
        return [SILENT] * len(queries)
