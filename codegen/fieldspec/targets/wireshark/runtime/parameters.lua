-- Parameters that a frame names by number: their names, and their values read as the parameter has them.

local parameters = {}

local function is_inside(number, ranges)
    for _, range in ipairs(ranges) do
        if number >= range[1] and number <= range[2] then
            return true
        end
    end
    return false
end

-- The row of a parameter by its number on the wire, and its number in the set; nil and nil where there is none.
local function row_at(set_name, wire_number)
    for _, set in ipairs(device.parameters[set_name] or {}) do
        local number = wire_number - set.base
        for _, row in ipairs(set.rows) do
            if number >= row.number and number < row.number + row.count then
                return row, number
            end
        end
    end
    return nil, nil
end

-- The row of a parameter, and its number, at a place among the values of all numbers of a set; nil after the last.
local function row_placed(set, place)
    for _, row in ipairs(set.rows) do
        if place < row.count then
            return row, row.number + place
        end
        place = place - row.count
    end
    return nil, nil
end

local function known(context, name)
    local number = context.values[name]
    if number == nil and context.asked then
        number = context.asked[name]
    end
    return number
end

-- The entry of an element of a parameter, and its index; the whole parameter has no index.
local function element(row, at)
    if not at or not row.several then
        return row, nil
    end
    for _, inner in ipairs(row.subindices) do
        if is_inside(at, inner.indices) then
            return inner, at
        end
    end
    return row, at
end

-- The bytes of a field as bytes of a parameter's value, of a number the most significant first; nil where they cannot be.
local function read_as(field, value, bytes)
    local own = field.value
    local counts = { integer = true, boolean = true }
    local alike = own.kind == value.kind or counts[own.kind] and counts[value.kind]
    if value.size == field.size and (alike or own.kind ~= "float" and value.kind ~= "float") then
        return numbers.is_number(value) and numbers.significant(bytes, own) or bytes
    end
    if alike and counts[own.kind] and field.size <= 6 and value.size <= 6 then
        local number = numbers.of(bytes, own)
        if number >= value.low and number <= value.high then
            return numbers.bytes(number, value)
        end
    end
    return nil
end

-- What the value of element `index` of a field is, if the frame or its request tells the parameter: an entry, the
-- bytes of its value and options for `values.show`. Nil where the field has only a meaning of its own.
function parameters.entry(context, field, index, bytes)
    local part = field.parameter
    if not part or part.part ~= "values" and part.part ~= "value" then
        return nil
    end
    local row, number, inner, at
    if part.part == "values" then
        row, number = row_placed(device.parameters[part.set][1], index)
    else
        local wire_number = known(context, part.number)
        if not wire_number then
            return nil
        end
        row, number = row_at(part.set, wire_number)
        local first = part.index and known(context, part.index) or 0
        at = first + index
    end
    if not row then
        return nil
    end
    inner, at = element(row, at)
    if numbers.is_number(field.value) then
        local own = numbers.of(bytes, field.value)
        if values.reason(field.value, own, field.value.ranges) then
            return nil
        end
    end
    local again = read_as(field, inner.value, bytes)
    if not again then
        return nil
    end
    -- No codec refuses a frame for the value of a parameter, so whatever is wrong with it is a matter of its range.
    local options = { reason = "out_of_range", lenient = row.trigger and context.direction == "response" }
    options.index = (row.count > 1 and " " .. numbers.text(number) or "") .. (at and "[" .. numbers.text(at) .. "]" or "")
    options.is_write = context.direction == "request"
    return { entry = inner, bytes = again, options = options }
end

-- Appends the name of the parameter to the item of a field with its number or its subindex.
function parameters.name(context, item, field, own)
    local part = field.parameter
    if not part or not own or part.part ~= "number" and part.part ~= "subindex" then
        return
    end
    local wire_number = part.part == "number" and own or known(context, part.number)
    if not wire_number then
        return
    end
    local row = row_at(part.set, wire_number)
    if part.part == "number" then
        item:append_text(row and ", " .. row.title or ", not listed")
        return
    end
    local inner, at = nil, nil
    if row then
        inner, at = element(row, own)
    end
    if at then
        item:append_text(", " .. inner.title .. "[" .. numbers.text(at) .. "]")
    end
end
