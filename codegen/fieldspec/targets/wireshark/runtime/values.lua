-- Items of the tree: one value with its name, its quantity, its bits, and what is wrong with it.

local values = {}

-- Adds a finding to an item.
function values.report(item, reason, text)
    item:add_proto_expert_info(expert_items[reason], text)
end

-- Adds the errata of a fact to its item, without those that concern only other links than `values.link`.
function values.cite(item, errata)
    if not errata then
        return
    end
    for _, id in ipairs(errata) do
        local elsewhere = device.errata_elsewhere[id]
        if not (elsewhere and elsewhere[values.link]) then
            values.report(item, "misprint", id .. ": " .. device.errata[id])
        end
    end
end

local function is_within(number, ranges, value)
    for _, range in ipairs(ranges) do
        if number >= numbers.bound(range[1], value) and number <= numbers.bound(range[2], value) then
            return true
        end
    end
    return false
end

local function ranges_text(ranges)
    local parts = {}
    for _, range in ipairs(ranges) do
        parts[#parts + 1] = range[1] == range[2] and tostring(range[1]) or range[1] .. ".." .. range[2]
    end
    return table.concat(parts, ", ")
end

-- The quantity of a count with its unit, and as a number; nil where the value has neither scale nor unit.
function values.quantity(number, value)
    local unit = value.unit and " " .. value.unit or ""
    if not value.scale then
        return value.unit and numbers.text(number) .. unit or nil, nil
    end
    local count = numbers.double(number)
    local text, approximate = numbers.fraction(count, value.scale)
    return text .. unit, approximate
end

-- The name of the state that a number stands for, nil for a quantity.
local function state_of(value, number, key)
    if value.special and value.special[key] then
        return value.special[key]
    end
    for _, state in ipairs(value.special_ranges or {}) do
        if is_within(number, state.range, value) then
            return state.name
        end
    end
    return nil
end

-- The reason for which a value is refused, nil where there is none.
function values.reason(value, number, ranges)
    local key = numbers.text(number)
    if value.kind == "boolean" and key ~= "0" and key ~= "1" then
        return "unknown_value"
    end
    if value.const and number ~= numbers.bound(value.const, value) then
        return "wrong_const"
    end
    if state_of(value, number, key) then
        return nil
    end
    local enum = value.enum and device.enums[value.enum]
    if enum and not enum.open and (not enum.names[tonumber(key)] or enum.unavailable[tonumber(key)]) then
        return "unknown_value"
    end
    return ranges and not is_within(number, ranges, value) and "out_of_range" or nil
end

values.is_within = is_within

-- The number of a field of bits, as Wireshark takes it.
local function bits_number(ordered, bit)
    bit.places = bit.places or numbers.bit_places(bit)
    local places = bit.places
    if bit.width > 32 then
        local low = numbers.bits(ordered, places, 1, 32)
        local high = numbers.bits(ordered, places, 33, bit.width)
        if bit.signed and high >= 2 ^ (bit.width - 33) then
            high = high + 2 ^ 32 - 2 ^ (bit.width - 32)
        end
        return (bit.signed and Int64 or UInt64).new(low, high)
    end
    local number = numbers.bits(ordered, places, 1, bit.width)
    if bit.signed and number >= 2 ^ (bit.width - 1) then
        number = number - 2 ^ bit.width
    end
    return number
end

-- The reason and the details where a field of bits of a word is out of its range; nil where it is not.
function values.judged_bits(bit, ordered)
    if is_within(bits_number(ordered, bit), bit.ranges, bit) then
        return nil, nil
    end
    return "out_of_range", bit.name .. " should be " .. ranges_text(bit.ranges) .. (bit.scale and " counts" or "")
end

-- The item of a field of bits of a word.
function values.show_bits(item, range, bit, field, ordered)
    local number = bits_number(ordered, bit)
    local inner
    if bit.width == 1 then
        inner = item:add(field, range, number == 1)
    else
        inner = item:add(field, range, number)
    end
    local place = bit.place or bit.first .. ".." .. bit.first + bit.width - 1
    local head = bit.width == 1 and "Bit " .. bit.first or "Bits " .. place
    local digits = numbers.text(number)
    local text = bit.enum and device.enums[bit.enum].names[tonumber(digits)]
    if not text and bit.width == 1 then
        text = number == 1 and bit.one or number == 0 and bit.zero or nil
    end
    text = text or values.quantity(number, bit)
    inner:set_text(head .. ", " .. bit.title .. ": " .. (text and text .. " (" .. digits .. ")" or digits))
    values.cite(inner, bit.errata)
end

-- The item of a quantity below that of its count.
function values.show_quantity(item, entry, range, text, number)
    local inner = item:add(fields[entry.quantity], range, number)
    inner:set_text("Quantity: " .. text)
    inner:set_generated()
end

-- What the manual says of a member of an enum.
function values.remark(item, enum, key)
    local text = enum.texts[key]
    if text then
        item:append_text(", " .. text)
    end
    values.cite(item, enum.errata[key])
end

-- Whether bytes match one of some patterns, or there are none.
local function has_digits(bytes, patterns)
    for _, pattern in ipairs(patterns or {}) do
        if bytes:find(pattern) then
            return true
        end
    end
    return not patterns
end

-- The item of a text, or of bytes.
local function show_characters(entry, tree, range, bytes, options)
    if entry.value.kind == "bytes" then
        local item = tree:add(entry.field, range)
        if options.before then
            item:prepend_text(options.before)
        end
        if not has_digits(bytes, entry.value.digits) then
            values.report(item, "unknown_value", "the bytes are not the digits of a number")
        end
        values.cite(item, entry.errata)
        return item, nil, nil
    end
    local text = bytes:gsub("\0+$", "")
    local is_ascii = not text:find("[\128-\255]")
    text = text:gsub("[^\32-\126]", function(char) return string.format("\\x%02x", char:byte()) end)
    local item = tree:add(entry.field, range, text)
    item:set_text((options.title or entry.title .. (options.index or "")) .. ": " .. text)
    if not is_ascii and not entry.reserved then
        values.report(item, "unknown_value", "the text is not ASCII")
    end
    values.cite(item, entry.errata)
    return item, text, nil
end

-- Looks up once what the function of an entry needs.
local function linked(entry)
    entry.field = fields[entry.filter]
    if entry.value.word then
        entry.bit_fields = {}
        for place, bit in ipairs(device.words[entry.value.word]) do
            entry.bit_fields[place] = fields[entry.bits .. "." .. bit.name]
        end
    end
    entry.shown = entry.show and values.shows[entry.show] or show_characters
    -- A field whose item depends on its own bytes alone.
    entry.is_plain = not (
        entry.is_list or entry.has_place or entry.parameter or entry.percent or entry.same_as
        or entry.measures or entry.bits_of
    )
    return entry.shown
end

local NO_OPTIONS = {}

-- Adds the item of a value. `entry` has its filter name, title and value; `range` are its bytes in the packet and
-- `bytes` those of the value. Returns the item, the number, and the reason of a finding; the functions in
-- `values.shows` say what `options` are.
function values.show(tree, entry, range, bytes, options)
    return (entry.shown or linked(entry))(entry, tree, range, bytes, options or NO_OPTIONS)
end
