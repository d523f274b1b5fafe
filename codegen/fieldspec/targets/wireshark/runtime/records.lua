-- The body of a frame, field by field.

local records = {}

-- How many elements a field has in `room` bytes: as many as fit where their number is free.
local function count_of(field, room)
    if not field.repeats then
        return field.count or 1
    end
    return math.min(math.max(math.floor(room / field.size), field.repeats[1]), field.repeats[2])
end

-- The fields of a record, with the last one as the selecting field decides it; nil, and that field, where it does not.
local function fields_of(record, body)
    if not record.by then
        return record.fields
    end
    local by = record.fields[record.by]
    local bytes = body:sub(by.offset + 1, by.offset + by.size)
    local number = #bytes == by.size and numbers.text(numbers.of(bytes, by.value))
    local list = {}
    for index, field in ipairs(record.fields) do
        list[index] = field
    end
    list[#list + 1] = number and record.cases[number] or nil
    return list, not (number and record.cases[number])
end

local show_record

local NONE = {}

-- The options of an element of a list, made once.
local function options_of(field, index)
    field.options = field.options or {}
    local options = field.options[index]
    if not options then
        options = { index = "[" .. index .. "]" }
        field.options[index] = options
    end
    return options
end

local function show_value(context, tree, field, at, index, top)
    local bytes = context.bytes:sub(at + 1, at + field.size)
    local entry, options = field, field.is_list and options_of(field, index) or nil
    local range = context:range(at, field.size)
    local described = field.parameter and parameters.entry(context, field, index, bytes)
    if described then
        entry, bytes, options = described.entry, described.bytes, described.options
    end
    local item, number, reason = values.show(tree, entry, range, bytes, options)
    if described and described.entry ~= field then
        local sent = context.bytes:sub(at + 1, at + field.size)
        local own = numbers.is_number(field.value) and numbers.of(sent, field.value)
        number = own
        local inner = item:add(fields[field.filter], range, own and numbers.of_item(sent, field.value))
        inner:set_text("On the wire, " .. field.title .. ": " .. numbers.text(own))
    end
    if field.parameter then
        parameters.name(context, item, field, number)
    end
    for _, conversion in ipairs(field.percent or NONE) do
        local text = numbers.fraction(numbers.double(number), conversion)
        item:append_text(", " .. text .. " % of " .. conversion.of)
    end
    if top and field.same_as and context.asked and not reason then
        local expected = context.asked[field.same_as]
        if expected ~= nil and expected ~= number then
            local text = field.name .. " is " .. numbers.text(number) .. ", but the request has " .. numbers.text(expected)
            values.report(item, "mismatch", text)
        end
    end
    return item, number
end

-- Adds the items of one element. Returns the item and, of a value, its number.
local function show_element(context, tree, field, at, index, top)
    if field.record then
        local item = tree:add(fields[field.filter], context:range(at, field.size))
        item:set_text(field.title .. (field.is_list and "[" .. index .. "]" or ""))
        values.cite(item, field.errata)
        show_record(context, item, device.records[field.record].fields, at)
        return item, nil
    end
    return show_value(context, tree, field, at, index, top)
end

show_record = function(context, tree, list, at)
    for _, field in ipairs(list) do
        for index = 0, (field.count or 1) - 1 do
            show_element(context, tree, field, at + field.offset + index * field.size, index, false)
        end
    end
end

local function report_rest(context, tree, at, stop, reason, text)
    local item = tree:add(fields[device.common.undecoded], context:range(at, stop - at))
    values.report(item, reason, text)
end

-- Adds the items of all elements of a field that are there. Returns where the next field begins; nil where bytes are missing.
local function show_elements(context, tree, field, at, stop, room)
    local count = count_of(field, room)
    local present = field.size > 0 and math.max(0, math.min(count, math.floor((stop - at) / field.size))) or 0
    if field.has_place then
        context.places[field.name] = { at = at, size = present * field.size, count = present }
    end
    for index = 0, present - 1 do
        local item, number = show_element(context, tree, field, at + index * field.size, index, true)
        if not field.is_list then
            context.values[field.name] = number
        end
        if number and (field.measures or field.bits_of) then
            context.measuring[#context.measuring + 1] = { field = field, item = item, number = number }
        end
    end
    local reached = at + present * field.size
    if present < count then
        report_rest(context, tree, reached, stop, "incomplete", "bytes are missing for " .. field.name)
        return nil
    end
    return reached
end

local function show_body(context, tree, record, list, open, start, stop)
    local body = context.bytes:sub(start + 1, stop)
    local at, bytes, tvb, skip, by_name = start, context.bytes, context.tvb, context.skip, context.values
    for _, field in ipairs(list) do
        local size = field.size
        if field.is_plain and at + size <= stop then
            local _, number = field.shown(field, tree, tvb(at + skip, size), bytes:sub(at + 1, at + size), NONE)
            by_name[field.name] = number
            at = at + size
        else
            at = show_elements(context, tree, field, at, stop, #body - field.offset)
            if not at then
                return
            end
        end
    end
    if open then
        if #body < record.least then
            report_rest(context, tree, at, stop, "incomplete", "bytes are missing for " .. record.last)
        else
            local by = record.fields[record.by].name
            report_rest(context, tree, at, stop, "unknown_value", by .. " does not decide the type of " .. record.last)
        end
    elseif at < stop then
        report_rest(context, tree, at, stop, "wrong_length", (stop - at) .. " bytes too many")
    end
end

-- Reports a field whose number is not the size of what it measures.
local function judge_measure(context, measuring)
    local field, number, expected = measuring.field, measuring.number, nil
    local packed = field.bits_of and context.places[field.bits_of]
    if packed and math.floor((number + 7) / 8) ~= packed.size then
        expected = packed.size > 0 and (8 * packed.size - 7) .. " to " .. 8 * packed.size or "0"
    end
    local measured = field.measures and context.places[field.measures.field]
    if measured then
        local size = field.measures.of == "bytes" and measured.size or measured.count
        local whole = size + (field.measures.plus or 0)
        expected = number ~= whole and numbers.text(whole) or nil
    end
    if expected then
        local text = field.name .. " is " .. numbers.text(number) .. ": should be " .. expected
        values.report(measuring.item, "wrong_measure", text)
    end
end

-- Adds the items of a body, the bytes from `start` to `stop`. The numbers of its fields go to `context.values`, and
-- the places of fields with `has_place` to `context.places`.
function records.show(context, tree, record, start, stop)
    local list, open = fields_of(record, context.bytes:sub(start + 1, stop))
    show_body(context, tree, record, list, open, start, stop)
    for _, measuring in ipairs(context.measuring) do
        judge_measure(context, measuring)
    end
end
