"""Random messages: functions with codes, telegrams with numbers, and those that read and write registers."""

from __future__ import annotations

from hypothesis import strategies as st

from random_devices.draft import SIZES, Draft, Spec, bounds
from random_devices.drawn_records import body, draw_separator, telegram
from random_devices.drawn_values import COUNT_DIGITS


def messages(draft: Draft, coded_links: list[str], other_links: list[str]) -> list[Spec]:
    """Messages for the links with codes, and telegrams for the others."""
    drawn: list[Spec] = []
    codes: set[int] = set()
    for _ in range(draft.number(1, 5) if coded_links else 0):
        request, response = body(draft), body(draft)
        drawn.append(draft.bounded(draft.fact(code=free_code(draft, codes), request=request, response=response), 5))
        if other_links or draft.chance(20):
            drawn[-1]["links"] = draft.some(coded_links)
        draw_separator(draft, drawn[-1], request, response)
        if draft.chance(10):
            _repeat_field(draft, drawn[-1])
    if drawn and draft.chance(25):
        _share_codes(draft, drawn)
    if coded_links and (draft.spec.get("registers") or draft.spec.get("tables")):
        drawn += _accesses(draft, codes, coded_links, bool(other_links))
    if coded_links and draft.spec.get("parameters") and draft.chance(60):
        drawn += parameter_messages(draft, codes, coded_links if other_links else [])
    numbers = 0
    for _ in range(draft.number(1, 3) if other_links else 0):
        numbers += draft.number(1, 9)
        request = telegram(draft)
        # Telegrams of one length are told apart by nothing in them.
        response = request if draft.chance(25) else telegram(draft)
        drawn.append(draft.fact(number=numbers, links=list(other_links), request=request, response=response))
    for message in drawn:
        if "broadcast" not in message and draft.chance(20):
            message["broadcast"] = False
        elif "broadcast" not in message and draft.chance(5):
            message["broadcast"] = True
            accesses = message.get("accesses", [])
            if "code" in message and not any(access["operation"] == "read" for access in accesses):
                _leave_unanswered(draft, message, message.get("links", coded_links))
    return drawn


def mark_exceptions(draft: Draft) -> None:
    """Links whose responses carry no code may mark exception responses by the first bytes of their data."""
    for link in draft.spec["links"]:
        if any(part.get("role") == "code" for part in link["response"]) or not draft.chance(40):
            continue
        kind = draft.pick(("u8", "u16", "i16", "u24", "u32", "i32", "u48", "u64", "i64"))
        low, high = bounds(kind)
        number = draft.edge(low, high)
        another = number - 1 if number > low else number + 1
        mark = draft.fact(type=kind, const=number)
        record = draft.fact(fields=[mark, *([draft.fact(type="u16")] if draft.chance(80) else [])])
        draft.spec["records"].append(record)
        link["exception_response"] = {"field": mark["name"], "record": record["name"]}
        for message in draft.spec["messages"]:
            if link["name"] in message.get("links", [link["name"]]) and "response" in message:
                first = _unmarked(draft) if draft.chance(40) else draft.fact(type=kind, const=another)
                message["response"] = [first, *message["response"]]


def _unmarked(draft: Draft) -> Spec:
    """A field of any size where others have the mark of exception responses; its bytes there seldom are the mark."""
    kind = draft.pick(("u8", "i16", "u24", "u32", "i32"))
    low, high = bounds(kind)
    number = draft.number(low, high)
    if draft.chance(60):
        return draft.fact(type=kind, const=number)
    return draft.fact(type=kind, range=f"{number}..{min(number + draft.number(0, 300), high)}")


def draw_response_codes(draft: Draft) -> None:
    """Responses may have other codes than their requests, and several of them the same."""
    coded = [link["name"] for link in draft.spec["links"] if any(p.get("role") == "code" for p in link["response"])]
    if not coded or not draft.chance(30):
        return
    common = draft.code()
    for message in draft.spec["messages"]:
        answered = message.get("answered_on", message.get("links", coded))
        if "code" not in message or not set(coded) & set(answered) or not draft.chance(60):
            continue
        code = common if draft.chance(40) else draft.code()
        if code != message["code"]:
            message["response_code"] = code


def leave_unrequested(draft: Draft) -> None:
    """Only the device sends some messages."""
    if not draft.chance(25):
        return
    of_requests = {"accesses", "segments", "broadcast", "response_code", "supplements"}
    pieces = {message["segments"]["message"] for message in draft.spec["messages"] if "segments" in message}
    for message in draft.spec["messages"]:
        if message["name"] in pieces:
            continue
        if draft.chance(40) and "response" in message and not of_requests & set(message):
            if any({"same_as", "parameter"} & set(field) for field in message["response"]):
                continue
            del message["request"]
            message["requested"] = False


def _share_codes(draft: Draft, drawn: list[Spec]) -> None:
    """Several messages with the code of the first one; the beginning of their data tells them apart.

    It is a constant in each, or a byte with ranges.
    """
    kind = draft.pick(("u8", "u16", "i8", "i16", "u8", "u16", "u24", "u32", "i32", "u40", "i56", "u64", "i64"))
    low, high = bounds(kind)
    sent: Spec = {"type": kind}
    if draft.digits(15):
        sent, high = draft.pick(COUNT_DIGITS)
        low = 0
    numbers: set[int] = set()
    directions = ("request", "response") if draft.chance(65) else ("request",)  # or only the requests tell them apart
    sharing = drawn[: draft.number(2, 4)]
    for _ in sharing:
        number = draft.edge(low, high)
        while number in numbers:
            number = number + 1 if number < high else low
        numbers.add(number)
    ordered = sorted(numbers)
    ends = {number: following - 1 for number, following in zip(ordered, [*ordered[1:], high + 1], strict=True)}
    first = draft.number(0, len(ordered) - 1)
    for message, number in zip(sharing, [*ordered[first:], *ordered[:first]], strict=True):
        message["code"] = drawn[0]["code"]
        end = draft.number(number, ends[number]) if sent == {"type": "u8"} and draft.chance(50) else number
        choice: Spec = {"const": number} if end == number else {"range": f"{number}..{end}"}
        for direction in directions:
            message[direction] = [draft.fact(**sent, **choice), *message[direction]]


def _leave_unanswered(draft: Draft, message: Spec, links: list[str]) -> None:
    """The message is answered on some of its links, or never."""
    message["answered_on"] = draft.some(links) if draft.chance(50) else []
    if not message["answered_on"]:
        message.pop("response", None)


def free_code(draft: Draft, codes: set[int]) -> int:
    code = draft.code()
    while code in codes:
        code = ((code | draft.code_flag) + 1) % (1 << draft.code_bits) & ~draft.code_flag
    codes.add(code)
    return code


def _repeat_field(draft: Draft, message: Spec) -> None:
    """A field of the request that the response repeats."""
    whole = [f for f in message["request"] if "type" in f and not {"measures", "reserved", "const", "repeat"} & set(f)]
    if whole:
        field = {key: v for key, v in draft.pick(whole).items() if key not in ("doc", "label", "notes")}
        field |= {"same_as": field["name"], "source": draft.source()}
        if all(other.get("name") != field["name"] for other in message["response"]):
            message["response"].insert(0, field)


def _accesses(draft: Draft, codes: set[int], coded_links: list[str], is_stated: bool) -> list[Spec]:
    """The messages that read and write each space of words or bytes; the first link may have messages of its own."""
    links = coded_links if is_stated else []
    parts = [links]
    if len(coded_links) > 1 and draft.chance(40):
        parts = [coded_links[:1], coded_links[1:]]
    units = {space["name"]: space.get("unit", "word") for space in draft.spec.get("spaces", [])}
    spaces = [name for name, unit in units.items() if unit != "bit"]
    drawn = []
    for space in spaces if "word" in units.values() else ["", *spaces]:
        for part in parts:
            most = draft.number(1, 60)
            for operation in ("read", "write"):
                message = _access(draft, operation, space, most, "u8" if units.get(space) == "byte" else "u16")
                message["code"] = free_code(draft, codes)
                if part:
                    message["links"] = list(part)
                drawn.append(message)
    if draft.chance(40):
        names = [name for name, unit in units.items() if unit != "bit"] or [""]
        message = _access_steps(draft, [(name, units.get(name, "word")) for name in names])
        message["code"] = free_code(draft, codes)
        if links:
            message["links"] = list(links)
        drawn.append(message)
    for space in [space["name"] for space in draft.spec.get("spaces", []) if space.get("unit") == "bit"]:
        for operation in ("read", "write"):
            message = _bit_access(draft, operation, space)
            message["code"] = free_code(draft, codes)
            if links:
                message["links"] = list(links)
            drawn.append(message)
    return drawn


def _access_steps(draft: Draft, spaces: list[tuple[str, str]]) -> Spec:
    """A message that writes and reads registers in several steps, or changes bits of one."""
    request: list[Spec] = []
    response: list[Spec] = []
    steps: list[Spec] = []
    kinds = draft.pick((("mask",), ("write", "read"), ("mask", "read"), ("read", "mask"), ("mask", "mask")))
    for kind in kinds:
        space, unit = draft.pick(spaces)
        word = "u8" if unit == "byte" else "u16"
        address = draft.fact(type="u16")
        request.append(address)
        step: Spec = {"operation": "read" if kind == "read" else "write", "start": address["name"]}
        if space:
            step["space"] = space
        if kind == "mask":
            masks = [draft.fact(type=word), draft.fact(type=word)]
            request += masks
            step |= {"and_mask": masks[0]["name"], "or_mask": masks[1]["name"]}
        else:
            most = draft.number(1, 20)
            count = draft.fact(type="u16", range=f"1..{most}")
            words = draft.fact(type=word, repeat=f"1..{most}")
            request.append(count)
            step |= {"count": count["name"], "values": words["name"]}
            if kind == "write":
                count["measures"] = {"items": words["name"]}
            else:
                response.append(words)
        steps.append(step)
    lists = [step["values"] for step in steps if step["operation"] == "write" and "values" in step]
    for name in lists:
        count = next(field for field in request if field.get("measures") == {"items": name})
        request.append(draft.fact(type=_element(spaces, steps, name), repeat=count["range"]) | {"name": name})
    return draft.fact(request=request, response=response, accesses=steps)


def _element(spaces: list[tuple[str, str]], steps: list[Spec], name: str) -> str:
    """The type of the words or bytes that a step carries."""
    space = next(step.get("space", "") for step in steps if step.get("values") == name)
    return "u8" if dict(spaces).get(space) == "byte" else "u16"


def _bit_access(draft: Draft, operation: str, space: str) -> Spec:
    """A message that carries packed bits, or a single one as a number."""
    address = draft.fact(type="u16")
    access: Spec = {"operation": operation, "space": space, "start": address["name"]}
    if draft.chance(50):
        numbers = draft.pick(((1, 0), (0xFF00, 0), (2, 3), (0, 1)))
        bit = draft.fact(
            type="u16" if numbers[0] > 255 else draft.pick(("u8", "u16")), range=f"{numbers[0]}, {numbers[1]}"
        )
        access |= {"values": bit["name"], "set": numbers[0]} | ({"clear": numbers[1]} if numbers[1] else {})
        asked, answered = ([address], [bit]) if operation == "read" else ([address, bit], [])
        return draft.fact(request=asked, response=answered, accesses=[access])
    most = draft.number(1, 30)
    count = draft.fact(type="u16", range=f"1..{8 * most}")
    bits = draft.fact(type="u8", repeat=f"1..{most}")
    size = draft.fact(type="u8", measures={"bytes": bits["name"]})
    sized = [size, bits] if draft.chance(60) else [bits]
    access |= {"count": count["name"], "values": bits["name"]}
    asked, answered = ([address, count], sized) if operation == "read" else ([address, count, *sized], [])
    return draft.fact(request=asked, response=answered, accesses=[access])


def _word_digits(draft: Draft, unit: str) -> Spec:
    """Two hexadecimal digits for each byte of a word, in the byte order of the registers."""
    order = next((link["byte_order"] for link in draft.spec["links"] if link.get("byte_order")), "big")
    is_low_first = unit == "u16" and order == "little"
    digits = {"digits": draft.pick(("upper_hex", "lower_hex")), "length": 4 if unit == "u16" else 2}
    return digits | ({"byte_order": "little"} if is_low_first else {})


def _access(draft: Draft, operation: str, space: str, most: int, unit: str) -> Spec:
    address = draft.fact(type="u16")
    count = draft.fact(type=draft.pick(("u16", "u8")), range=f"1..{most}")
    words = draft.fact(type=unit, repeat=f"1..{most}")
    if has_characters := draft.chance(25):
        address |= draft.pick(({"digits": "upper_hex", "length": 4}, {"digits": "decimal", "length": 4}))
        words |= _word_digits(draft, unit)
        if operation == "read" or draft.chance(50):
            count |= {"digits": "decimal", "length": 2}
    size = draft.fact(type="u8" if not has_characters else "u16", measures={"bytes": words["name"]})
    sized = [size, words] if draft.chance(60) else [words]
    access: Spec = {"operation": operation, "start": address["name"], "values": words["name"]}
    if space and (unit == "u8" or len(draft.spec["spaces"]) == 1 or draft.chance(95)):
        access["space"] = space
    if operation == "read":
        access["count"] = count["name"]
        return draft.fact(request=[address, count], response=sized, accesses=[access])
    if draft.chance(30):
        single = {key: v for key, v in words.items() if key != "repeat"}
        return draft.fact(request=[address, single], response=[], accesses=[access])
    if "digits" not in count and draft.chance(50):
        access["count"] = count["name"]
        count["measures"] = {"items": words["name"]}
        return draft.fact(request=[address, count, *sized], response=[], accesses=[access])
    return draft.fact(request=[address, *sized], response=[], accesses=[access])


_PARAMETER_DIGITS: dict[str, tuple[Spec, ...]] = {
    "u16": ({"digits": "upper_hex", "length": 4}, {"digits": "bcd", "length": 2}),
    "u32": ({"digits": "lower_hex", "length": 8}, {"digits": "decimal", "length": 9, "varies": True}),
    "i32": ({"digits": "decimal", "length": 10}, {"digits": "decimal", "length": 9, "varies": True}),
}
"""How values of parameters may be sent as digits, by their types."""
_NUMBERS = ("u8", "i8", "u16", "i16", "u24", "i24", "u32", "i32", "u64", "i64")


def parameter_messages(draft: Draft, codes: set[int], links: list[str]) -> list[Spec]:
    """The messages that read and write the parameters of a set by their numbers."""
    parameter_set = draft.pick(draft.spec["parameters"])
    name = parameter_set.get("space") or parameter_set["name"]
    rows = _rows_of_first_type(parameter_set)
    if draft.chance(20) and "space" not in parameter_set and rows:
        parameter_set["rows"] = rows
        return _with_codes(draft, _messages_of_all(draft, parameter_set), codes, links)
    is_text = draft.chance(35)
    sent = {"digits": "upper_hex", "length": 4} if is_text else {}
    number = draft.fact(type="u16", parameter={"set": name, "part": "number"}, **sent)
    if not is_text and draft.chance(40):
        return _with_codes(draft, _messages_of_bytes(draft, name, number), codes, links)
    kind = draft.pick(("u16", "u32", "i32") if is_text else ("u16", "u32", "i32", "u24", "i48"))
    sent = draft.pick(_PARAMETER_DIGITS[kind]) if is_text else {}
    value = draft.fact(type=kind, parameter={"set": name, "part": "value", "number": number["name"]}, **sent)
    drawn = [draft.fact(request=[number], response=[number, value]), draft.fact(request=[number, value], response=[])]
    return _with_codes(draft, drawn, codes, links)


def _with_codes(draft: Draft, drawn: list[Spec], codes: set[int], links: list[str]) -> list[Spec]:
    for message in drawn:
        message["code"] = free_code(draft, codes)
        if links:
            message["links"] = list(links)
    return drawn


def _rows_of_first_type(parameter_set: Spec) -> list[Spec]:
    """The rows of a set that have the type of the first number, and no elements."""
    rows = [row for row in parameter_set["rows"] if row["type"] in _NUMBERS and "elements" not in row]
    return [row for row in rows if row["type"] == rows[0]["type"] and "digits" not in row]


def _messages_of_all(draft: Draft, parameter_set: Spec) -> list[Spec]:
    """Messages that read and write all parameters of a set, in the order of their numbers."""
    count = sum(row.get("count", 1) for row in parameter_set["rows"])
    keys: Spec = {
        "type": parameter_set["rows"][0]["type"],
        "parameter": {"set": parameter_set["name"], "part": "values"},
    }
    if count > 1:
        keys["count"] = count
    values = draft.fact(**keys)
    return [draft.fact(request=[], response=[values]), draft.fact(request=[values], response=[])]


def _messages_of_bytes(draft: Draft, name: str, number: Spec) -> list[Spec]:
    """Messages with the bytes of values: as many as a field before them says, or a message for each number of bytes."""
    sets = [own for own in draft.spec["parameters"] if name in (own.get("space"), own["name"])]
    rows = [row for own in sets for row in own["rows"]]
    kinds = [inner for row in rows for inner in (row, *row.get("subindices", ()))]
    sizes = sorted({SIZES.get(kind["type"], kind.get("length", 0)) for kind in kinds})
    subindex = draft.fact(type="u8", parameter={"set": name, "part": "subindex", "number": number["name"]})
    asked = [number, subindex] if draft.chance(60) else [number]
    value = {"set": name, "part": "value", "number": number["name"]}
    values = draft.draw(st.lists(st.integers(0, 255), min_size=len(sizes), max_size=len(sizes), unique=True))
    members = [{"value": at, "name": f"bytes_{size}"} for at, size in zip(sorted(values), sizes, strict=True)]
    enum = {**draft.fact(), "sparse": True, "members": members}
    draft.spec["enums"].append(enum)
    by = draft.fact(type="u8", enum=enum["name"])
    cases = [{"when": [f"bytes_{size}"], "bytes": size} for size in sizes]
    length = sizes[-1] + draft.number(0, 2)
    padded = draft.fact(type="bytes", length=length, parameter={**value, "sizes": {"by": by["name"], "cases": cases}})
    drawn = [draft.fact(request=asked, response=[by, number, padded])]
    if draft.chance(60):
        return [*drawn, *_pieces_of_values(draft, drawn[0], enum, asked, values)]
    if draft.chance(50):
        return [*drawn, draft.fact(request=[*asked, by, padded], response=[])]
    single = [draft.fact(type="bytes", length=size, parameter=value) for size in sizes]
    return [*drawn, *(draft.fact(request=[*asked, data], response=[]) for data in single)]


def _pieces_of_values(draft: Draft, first: Spec, enum: Spec, asked: list[Spec], taken: list[int]) -> list[Spec]:
    """The messages with the pieces of values that no message carries alone, and that which begins to write one."""
    enum["members"].append({"value": next(n for n in range(256) if n not in taken), "name": "in_pieces"})
    enum["members"].sort(key=lambda member: int(member["value"]))
    last, unused, turn = draft.name(), draft.name(), draft.name()
    bits: list[Spec] = [{"bit": 0, "name": last}, {"bits": "1..3", "name": unused}, {"bit": 4, "name": turn}]
    if draft.chance(50):
        bits.append({"bit": draft.number(5, 7), "name": draft.name(), "default": 1})
    word = draft.fact(type="u8", bits=bits)
    draft.spec["flags"].append(word)
    command = draft.fact(type="u8", flags=word["name"])
    data = draft.fact(type="bytes", length=draft.number(1, 7))
    reads = draft.fact(request=[command], response=[command, data])
    how: Spec = {"data": data["name"], "counter": turn, "unused": unused, "last": last}
    first["segments"] = {"message": reads["name"], "when": ["in_pieces"], **how}
    writes = draft.fact(request=[command, data], response=[command])
    size = draft.fact(type=draft.pick(("u16", "u32")))
    begins = draft.fact(request=[*asked, size], response=[])
    begins["segments"] = {"message": writes["name"], "size": size["name"], **how}
    return [reads, begins, writes]
