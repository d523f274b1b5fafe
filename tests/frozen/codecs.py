"""The answers of all codecs to the inputs of facts, as texts that are the same for codecs that agree.

An answer has aspects, each of which is a text: `values` or "!" for a refusal, its `reason` and its `place`, the bytes
that are encoded `again`, and so on. What a codec does not say, it has no aspect for.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

from fieldspec.codec.explain.values import decode_value
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.reference import CodecError
from fieldspec.codec.reference.records import encoded
from fieldspec.foundation.caches import ByIdentity
from fieldspec.language.diagnostics import has_errors
from fieldspec.targets.queries.backend import remaining
from frozen.inputs import Input
from js_output.explanations import explained_by_node, explained_by_python
from python_package import record_class, runtime
from queries_output.engines import PolarsEngine
from random_devices.c_judge import C
from random_devices.explainer_judge import Explainer
from random_devices.javascript_judge import JavaScript
from random_devices.python_judge import Python
from random_devices.queries import Answer, Query
from random_devices.queries_judge import query_names
from random_devices.reference_answers import Reference
from random_devices.script_judge import ScriptExplainer

Aspects = dict[str, str]
_MODULES: ByIdentity[DeviceLayout, Python] = ByIdentity(limit=1)
_GCC, _TCC = ["gcc", "-std=c99", "-w", "-O1"], ["tcc", "-std=c99", "-w"]
ROWS, EXPLAINED = 16, 2
"""Of so many inputs, one is explained with all rows, if it is a frame, or explained at all: both take long."""
COLUMNS = 4
"""Of so many records, one is read as columns."""


@dataclass(frozen=True)
class Codec:
    """A codec: the letter that stands for it in files of digests, and what answers for a layout in a folder."""

    letter: str
    answers: Callable[[DeviceLayout, Path, list[Input]], list[Aspects]]


def aspects(item: Input, answer: Answer) -> Aspects:
    """An answer of a judge of random devices as its aspects."""
    if answer.reason is None:
        return {}
    if item.aspect != "decode":
        return {item.aspect: "!" + answer.reason if answer.reason else str(answer.again)}
    if answer.reason:
        place = {} if answer.offset is None else {"place": str(answer.offset)}
        return {"values": "!", "reason": answer.reason, **place}
    texts = {"values": answer.values, "quantity": answer.quantity}
    # Which bits of a NaN are encoded is the choice of a language.
    texts["nan" if "nan;" in (answer.values or "") else "again"] = answer.again
    return {aspect: text for aspect, text in texts.items() if text is not None}


def _each(answer: Callable[[Query], Answer], inputs: list[Input]) -> Iterator[Aspects]:
    """The answers of a codec in Python. An exception that is not a refusal is an answer too, by its name."""
    for item in inputs:
        if item.aspect == "access":
            yield {}
            continue
        try:
            result = answer(item.query)
        except Exception as error:
            result = Answer(f"raises {type(error).__name__}")
        yield aspects(item, result)


def _reference(layout: DeviceLayout, folder: Path, inputs: list[Input]) -> list[Aspects]:
    return list(_each(Reference(layout).answer, inputs))


def _module(layout: DeviceLayout, folder: Path) -> Python:
    """The generated Python of a layout, built once for all that is asked about it."""
    return _MODULES.get_or_compute(layout, lambda layout: Python(layout, folder, 0))


def _python(layout: DeviceLayout, folder: Path, inputs: list[Input]) -> list[Aspects]:
    """Its constructors demand every value and know no other one, before any codec is asked."""
    results = _each(_module(layout, folder).answer, inputs)
    return [{} if item.aspect == "absent" else result for item, result in zip(inputs, results, strict=True)]


class _JavaScript(JavaScript):
    """The answers of generated JavaScript; an exception that is not a refusal is an answer, by its name."""

    def raised(self, result: dict[str, Any]) -> Answer:
        return Answer(f"raises {result['raises']}")


def _processes(
    judge: Callable[[DeviceLayout, Path], Any], layout: DeviceLayout, folder: Path, inputs: list[Input]
) -> list[Aspects]:
    """The answers of a codec in a process of its own, which is asked about everything at once."""
    asked = [item for item in inputs if item.aspect != "access"]
    answers = iter(judge(layout, folder).answers([item.query for item in asked]))
    return [{} if item.aspect == "access" else aspects(item, next(answers)) for item in inputs]


def _explained(layout: DeviceLayout, inputs: list[Input]) -> Iterator[Aspects]:
    explainer = Explainer(layout, Path())
    for item in inputs:
        query, result = item.query, {}
        if item.aspect == "decode" and query.kind == "frame" and item.number % EXPLAINED == 0:
            result = aspects(item, explainer.answer(query))
            # It goes on after the first fault, and is not asked about all frames, as the codecs are.
            result = {f"explained_{aspect}": text for aspect, text in result.items()}
        elif item.aspect == "decode" and query.kind not in ("frame", "record") and len(query.data) == query.shape[4]:
            value, order, swapped, *_ = query.shape
            decoded = decode_value(layout.device, value, query.data[: value.size], order, swapped)
            names = [(meaning.name, meaning.bits) for meaning in decoded.meanings]
            result = {"meaning": repr((decoded.text, names, decoded.reason, decoded.verdict, decoded.notes))}
        yield result


def _rows(
    explained: Callable[[list[dict[str, Any]]], Iterable[dict[str, Any]]], script: ScriptExplainer, inputs: list[Input]
) -> Iterator[Aspects]:
    """The explanations of accesses and of some frames, with all their rows."""
    asked = [
        item.aspect == "access" or (item.aspect == "decode" and item.query.kind == "frame" and item.number % ROWS == 0)
        for item in inputs
    ]
    jobs = [
        script.job(item.query.path, item.query.data, item.request)
        for item, is_asked in zip(inputs, asked, strict=True)
        if is_asked
    ]
    rows = iter(explained(jobs))
    for is_asked in asked:
        yield {"rows": json.dumps(_whole(next(rows)), sort_keys=True)} if is_asked else {}


def _whole(data: Any) -> Any:
    """Data of JSON in which whole numbers are not floats, as JavaScript has one type of numbers."""
    if isinstance(data, dict):
        return {key: _whole(value) for key, value in data.items()}
    if isinstance(data, list):
        return [_whole(value) for value in data]
    return int(data) if isinstance(data, float) and data.is_integer() else data


def _explainer(layout: DeviceLayout, folder: Path, inputs: list[Input]) -> list[Aspects]:
    script = ScriptExplainer(layout, folder, 0)
    rows = _rows(lambda jobs: (explained_by_python(layout, job) for job in jobs), script, inputs)
    return [result | row for result, row in zip(_explained(layout, inputs), rows, strict=True)]


def _script(layout: DeviceLayout, folder: Path, inputs: list[Input]) -> list[Aspects]:
    return list(
        _rows(lambda jobs: (row for (row,) in explained_by_node(jobs)), ScriptExplainer(layout, folder, 0), inputs)
    )


def _columns(layout: DeviceLayout, folder: Path, inputs: list[Input]) -> list[Aspects]:
    """The columns that Polars makes of records, and of the data of messages, where the reference encodes it."""
    results: list[Aspects] = [{} for _ in inputs]
    expressed = remaining(layout)
    if has_errors(expressed.findings):
        return results
    names, engine = query_names(expressed.layout), PolarsEngine(expressed.layout)
    payloads: dict[str, list[tuple[int, bytes]]] = {}
    for number, item in enumerate(inputs):
        query = item.query
        if item.aspect == "decode" and query.kind == "record" and query.path[0] in names:
            payloads.setdefault(names[query.path[0]], []).append((number, query.data))
        elif item.aspect == "encode" and query.kind == "frame" and (query.path[2], query.path[1]) in names:
            data = _data(layout, query)
            if data is not None and not query.error:
                payloads.setdefault(names[query.path[2], query.path[1]], []).append((number, data))
    for name, places in payloads.items():
        rows = engine.rows(name, {"payload": [data for _, data in places]})
        for (number, _), row in zip(places, rows, strict=True):
            del row["payload"], row["place"]
            results[number] = {"columns": repr(sorted(row.items()))}
    return results


def _data(layout: DeviceLayout, query: Query) -> bytes | None:
    """The data of a message; None where the reference refuses its values."""
    head = {part.name for part in layout.links[query.path[0]].frame(query.path[1]).header}
    values = {name: value for name, value in (query.values or {}).items() if name not in head}
    try:
        return encoded(query.shape, values, layout.device)
    except CodecError:
        return None


def _arrays(layout: DeviceLayout, folder: Path, inputs: list[Input]) -> list[Aspects]:
    """The columns that NumPy makes of records of one size, one record at a time, and those in units."""
    judge, many = _module(layout, folder), runtime("many")
    results: list[Aspects] = []
    for number, item in enumerate(inputs):
        query, result = item.query, {}
        if item.aspect == "decode" and query.kind == "record" and query.shape.size and number % COLUMNS == 0:
            try:
                columns = many.decode_many(record_class(judge.module, query.shape), query.data)
                result = {"arrays": repr([(name, column.tolist()) for name, column in columns.items()])}
            except judge.error as error:
                result = {"arrays": f"!{error.reason} {error.offset}"}
            except Exception as error:
                result = {"arrays": f"raises {type(error).__name__}"}
        results.append(result)
    return results


CODECS = {
    "reference": Codec("r", _reference),
    "python": Codec("p", _python),
    "javascript": Codec("j", partial(_processes, lambda layout, folder: _JavaScript(layout, folder, 0))),
    "c": Codec("c", partial(_processes, lambda layout, folder: C(layout, folder, _GCC))),
    # It knows none of the ways in which headers use that a compiler is GCC.
    "portable_c": Codec("t", partial(_processes, lambda layout, folder: C(layout, folder, _TCC))),
    "explainer": Codec("e", _explainer),
    "script": Codec("s", _script),
    "columns": Codec("q", _columns),
    "arrays": Codec("n", _arrays),
}
"""All codecs. One that comes later is one more row."""
