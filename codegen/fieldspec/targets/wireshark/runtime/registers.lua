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

local function heading(place)
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

-- What stands before the value of a register, and how it is judged, by operation; made once.
local function options_of(place, operation)
    local options = place[operation]
    if not options then
        local row, index, is_write = place.row, heading(place), operation == "write"
        local before = string.format("0x%04X ", place.address)
        options = {
            index = index, name = row.name .. index, title = before .. row.title .. index, before = before,
            lenient = row.trigger and not is_write, is_write = is_write,
        }
        if row.access == "ro" and is_write then
            options.forbidden = row.name .. " can only be read"
        elseif row.access == "wo" and not is_write then
            options.forbidden = row.name .. " can only be written"
        end
        place[operation] = options
    end
    return options
end

local function show_gap(context, tree, span, first, last)
    local start, size = span.unit_size * (first - span.address), span.unit_size * (last - first + 1)
    if not span.is_bits and start >= 0 and start + size <= #span.bytes then
        show_unlisted(tree, context:range(span.at + start, size), first, last)
    else
        show_unlisted(tree, context:range(span.at, 0), first, last)
    end
end

-- Adds the item of a register whose bit, or whose bytes, the frame has; nil where it has not all of them.
local function show_present(context, tree, span, place, options)
    local row = place.row
    if span.is_bits then
        local index = place.address - span.address
        local bit = bit_at(span, index)
        if not bit then
            return nil
        end
        local at = span.single ~= nil and 0 or math.floor(index / 8)
        local range = context:range(span.at + at, span.single ~= nil and #span.bytes or 1)
        return (values.show(tree, row, range, string.char(bit), options))
    end
    local start, size = span.unit_size * (place.address - span.address) + (row.skip or 0), row.value.size
    if start < 0 or start + size > #span.bytes then
        return nil
    end
    local range, bytes = context:range(span.at + start, size), span.bytes:sub(start + 1, start + size)
    if row.turns_writes and options.is_write then
        bytes = bytes:reverse():gsub("(.)(.)", "%2%1")
    end
    return (values.show(tree, row, range, bytes, options))
end

-- Adds the item of a register without its value.
local function show_accessed(context, tree, span, place, options)
    local row = place.row
    local item = tree:add(fields[device.common.accessed], context:range(span.at, 0), row.name .. options.index)
    item:set_text(options.title)
    item:set_generated()
    if place.address < span.address or place.address + row.words > span.address + span.words then
        item:append_text(": only some of its words")
    end
    values.cite(item, row.errata)
    return item
end

-- Adds the items of all registers of a span: `space`, `address`, `words`, and the `bytes` from `at` on. In a space of
-- bits `is_bits` is set, and `single` is the value of the only bit where that is a number of its own.
function registers.show(context, tree, span, operation)
    local space = spaces[span.space] or { widest = 1, at = {} }
    local reached, stop, names = span.address, span.address + span.words, {}
    context.registers = names
    for address = reached - space.widest + 1, stop - 1 do
        local places = space.at[address]
        for number = 1, places and #places or 0 do
            local place = places[number]
            local after = address + place.row.words
            if after > span.address then
                if address > reached then
                    show_gap(context, tree, span, reached, address - 1)
                end
                reached = math.max(reached, after)
                local options = options_of(place, operation)
                names[#names + 1] = options.name
                local item = show_present(context, tree, span, place, options)
                    or show_accessed(context, tree, span, place, options)
                if options.forbidden then
                    values.report(item, "forbidden", options.forbidden)
                end
            end
        end
    end
    if reached < stop then
        show_gap(context, tree, span, reached, stop - 1)
    end
end
