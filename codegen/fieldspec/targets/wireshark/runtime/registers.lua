-- The registers that a frame accesses, at their addresses.

local registers = {}
local spaces = {}

-- What is at each address of a space: registers and the fields of tables, each element by itself.
local function index_spaces()
    for _, row in ipairs(device.registers) do
        local space = spaces[row.space] or { widest = 1, at = {} }
        spaces[row.space] = space
        space.widest = math.max(space.widest, row.words)
        for number = 0, row.count - 1 do
            local address = row.address + number * row.stride
            local places = space.at[address] or {}
            space.at[address] = places
            places[#places + 1] = { row = row, address = address, number = number }
        end
    end
end

-- What shares words with some addresses, by address, in the order of the spec.
local function occupants(space, first, words)
    local result = {}
    for address = first - space.widest + 1, first + words - 1 do
        for _, place in ipairs(space.at[address] or {}) do
            if address + place.row.words > first then
                result[#result + 1] = place
            end
        end
    end
    return result
end

local function heading(place, access)
    local row = place.row
    local element = row.index_from and row.index_from + place.number
    return element and "[" .. numbers.text(element) .. "]" or ""
end

local function show_unlisted(tree, range, first, last)
    local item = tree:add(fields[device.common.unlisted], range)
    item:set_text(string.format("0x%04X..0x%04X: nothing is listed here", first, last))
    values.report(item, "unlisted", string.format("no register is listed at 0x%04X..0x%04X", first, last))
end

-- The bit of a space of bits at an index, nil where the frame does not tell it.
local function bit_at(span, index)
    if span.single ~= nil then
        return index == 0 and span.single or nil
    end
    local byte = span.bytes:byte(math.floor(index / 8) + 1)
    return byte and numbers.band(numbers.rshift(byte, index % 8), 1)
end

-- Adds the items of all registers of a span: `space`, `address`, `words`, and the `bytes` from `at` on. In a space of
-- bits `is_bits` is set, and `single` is the value of the only bit where that is a number of its own.
function registers.show(context, tree, span, operation)
    local space = spaces[span.space] or { widest = 1, at = {} }
    local reached = span.address
    local function unlisted(first, last)
        local start = (span.unit_size or 2) * (first - span.address)
        local size = (span.unit_size or 2) * (last - first + 1)
        if not span.is_bits and start >= 0 and start + size <= #span.bytes then
            show_unlisted(tree, context:range(span.at + start, size), first, last)
        else
            show_unlisted(tree, context:range(span.at, 0), first, last)
        end
    end
    for _, place in ipairs(occupants(space, span.address, span.words)) do
        local row = place.row
        if place.address > reached then
            unlisted(reached, place.address - 1)
        end
        reached = math.max(reached, place.address + row.words)
        local is_write = operation == "write"
        local options = { index = heading(place), lenient = row.trigger and not is_write, is_write = is_write }
        local item
        local start = (span.unit_size or 2) * (place.address - span.address) + (row.skip or 0)
        if span.is_bits then
            local index = place.address - span.address
            local bit = bit_at(span, index)
            if bit then
                local at = span.single ~= nil and 0 or math.floor(index / 8)
                local range = context:range(span.at + at, span.single ~= nil and #span.bytes or 1)
                item = values.show(tree, row, range, string.char(bit), options)
            end
        elseif start >= 0 and start + row.value.size <= #span.bytes then
            local range = context:range(span.at + start, row.value.size)
            item = values.show(tree, row, range, span.bytes:sub(start + 1, start + row.value.size), options)
        end
        local where = string.format("0x%04X", place.address)
        if item then
            item:prepend_text(where .. " ")
        else
            item = tree:add(fields[device.common.accessed], context:range(span.at, 0), row.name .. options.index)
            item:set_text(where .. " " .. row.title .. options.index)
            item:set_generated()
            local inside = place.address >= span.address and place.address + row.words <= span.address + span.words
            if not inside then
                item:append_text(": only some of its words")
            end
            values.cite(item, row.errata)
        end
        if row.access == "ro" and operation == "write" then
            values.report(item, "forbidden", row.name .. " can only be read")
        elseif row.access == "wo" and operation == "read" then
            values.report(item, "forbidden", row.name .. " can only be written")
        end
    end
    if reached < span.address + span.words then
        unlisted(reached, span.address + span.words - 1)
    end
end
