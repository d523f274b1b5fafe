-- The items of a frame: one for each of its parts, and for what is wrong with it.

local Context = {}
Context.__index = Context

-- Bytes of the parts in the packet; past the end, none.
function Context:range(at, size)
    local length = self.length
    if at + self.skip >= 0 and at + self.skip + size <= length then
        return self.tvb(at + self.skip, size)
    end
    local first = math.max(0, math.min(at + self.skip, length))
    return self.tvb(first, math.max(0, math.min(size, length - first)))
end

local function show_part(context, part, at)
    local bytes = frames.own_bytes(part, context.bytes, at)
    local tree, link = context.tree, context.link
    if #bytes < part.size then
        local item = tree:add(fields[device.common.undecoded], context:range(at, #bytes))
        values.report(item, "incomplete", "bytes are missing for " .. part.name)
        return
    end
    local range = context:range(at, part.size)
    if part.role == "checksum" then
        local should = checksums.bytes(part, checksums.covered(part, context.bytes))
        local item = tree:add(fields[part.filter], range)
        local function text(own)
            return part.digits and own or (own:gsub(".", function(char) return string.format("%02X", char:byte()) end))
        end
        local printable = text(bytes):gsub("[^\32-\126]", "?")
        item:set_text(part.title .. ": " .. printable .. (bytes == should and " (right)" or " (wrong)"))
        if bytes ~= should then
            values.report(item, "wrong_checksum", part.name .. " should be " .. text(should))
        end
        values.cite(item, part.errata)
        return
    end
    local item, number, reason = values.show(tree, part, range, bytes)
    if part.role == "length" then
        if number * part.unit_size + part.base ~= #context.bytes then
            values.report(item, "wrong_length", part.name .. " counts other bytes than the frame has")
        end
        return
    end
    if part.offset < 0 then
        return
    end
    context.values[part.name] = number
    if part.role == "code" then
        local shape, code = link[context.direction], numbers.code(bytes, part.value)
        local body = context.bytes:sub(shape.header + 1, math.max(shape.header, #context.bytes - shape.trailer))
        context.message, context.is_refusal =
            frames.message_of(link, context.direction, code, context.bytes, body, context.open)
        if context.is_refusal then
            context.values[part.name] = numbers.bound(numbers.without(code, link.exception.flag), part.value)
        end
        if context.message then
            item:append_text(", " .. context.message.title .. (context.is_refusal and ", refused" or ""))
        elseif not context.is_refusal then
            values.report(item, "unknown_code", "no message has the code " .. numbers.text(number))
        end
        if context.is_refusal then
            values.report(item, "exception", "exception response")
        end
    elseif part.role == "unit_address" then
        context.unit = number
        local addresses = link.units
        if addresses and number == numbers.bound(addresses.broadcast, part.value) then
            item:append_text(", for all stations")
        elseif addresses and addresses.ranges and not values.is_within(number, addresses.ranges, part.value) then
            values.report(item, "out_of_range", part.name .. " is not an address of this device")
        end
    elseif part.same_as and context.asked and not reason then
        local expected = context.asked[part.same_as]
        if expected ~= nil and expected ~= number then
            values.report(item, "mismatch", part.name .. " does not repeat that of the request")
        end
    end
end

-- What a message accesses, as a span for `registers.show`; nil where nothing tells.
local function span_of(context, access)
    local asked = context.asked or {}
    local address = context.values[access.start] or asked[access.start]
    if not address then
        return nil
    end
    local place = access.values and context.places[access.values]
    local at, size = place and place.at or context.body_end, place and place.size or 0
    local bytes = context.bytes:sub(at + 1, at + size)
    local unit_size = access.unit_size or 2
    if not access.is_bits then
        bytes = bytes:sub(1, #bytes - #bytes % unit_size)
    end
    local span = {
        space = access.space, address = address, at = at, bytes = bytes, is_bits = access.is_bits, unit_size = unit_size,
    }
    if access.is_bits and access.set then
        local number = #bytes > 0 and context.values[access.values]
        span.single = number == access.set and 1 or number == access.clear and 0 or false
        span.words = 1
        return span
    end
    local count = access.is_bits and 1 or math.max(1, math.floor(#bytes / unit_size))
    if access.count then
        count = context.values[access.count] or asked[access.count]
    end
    span.words = count or (access.is_bits and 8 * #bytes or math.floor(#bytes / unit_size))
    return span
end

local function show_mark(context, range, bytes, name, expected)
    local item = context.tree:add(fields[device.common.mark], range)
    item:set_text(name)
    if bytes ~= expected then
        values.report(item, "wrong_mark", "the " .. name:lower() .. " is wrong")
    end
end

-- Adds the items of one frame: `tvb` has its bytes. `asked` is the result for the request that a response answers, and
-- `message` the message of a link without codes. Returns the values, the message, the unit and whether it is refused.
function frames.show(link, direction, tvb, tree, asked, message)
    local bytes = tvb:raw()
    local shape = link[direction]
    local surplus, least = surplus_of(shape, bytes), shape.preamble and shape.preamble.least or 0
    local context = setmetatable({
        link = link, direction = direction, tree = tree, tvb = tvb, length = tvb:len(), skip = surplus + #shape.start, values = {}, places = {},
        measuring = {}, open = asked, asked = asked and asked.values, message = message or asked and asked.message,
    }, Context)
    if shape.preamble then
        local size = surplus + least
        local sent = bytes:sub(1, size)
        show_mark(context, context:range(-surplus - #shape.start, size), sent, "Preamble", shape.preamble.byte:rep(size))
    end
    local mark = shape.start:sub(least + 1)
    if #mark > 0 then
        local own = bytes:sub(surplus + least + 1, surplus + #shape.start)
        show_mark(context, context:range(-#mark, #mark), own, "Start", mark)
    end
    local parts, reason = unwrapped(link, direction, bytes)
    if not parts then
        local item = tree:add(fields[device.common.undecoded], tvb())
        values.report(item, reason, "no frame of the link " .. link.name)
        context.is_broken = true
        return context
    end
    context.bytes = parts
    if link.hex and #parts > 0 then
        local digits = parts:gsub(".", function(char) return string.format("%02x", char:byte()) end)
        context.tvb, context.length, context.skip = ByteArray.new(digits):tvb("Decoded frame"), #parts, 0
    end
    for _, part in ipairs(shape.parts) do
        if part.offset >= 0 then
            show_part(context, part, part.offset)
        end
    end
    if #parts < shape.header then
        return context
    end
    local start, stop = shape.header, math.max(shape.header, #parts - shape.trailer)
    context.body_end = stop
    if not with_role(shape, "code") and has_mark(link, direction, parts, parts:sub(start + 1, stop)) then
        context.is_refusal = true
        values.report(tree, "exception", "exception response")
    end
    local record = record_of(link, direction, context.message, context.is_refusal)
    if record then
        records.show(context, tree, record, start, stop)
        local access = context.message and not context.is_refusal and context.message.access
        local span = access and span_of(context, access)
        if span then
            registers.show(context, tree, span, access.operation)
        end
    elseif stop > start or not with_role(shape, "code") then
        local item = tree:add(fields[device.common.undecoded], context:range(start, stop - start))
        if not with_role(shape, "code") then
            values.report(item, "unknown_code", "nothing tells which message this is")
        end
    end
    for _, part in ipairs(shape.parts) do
        if part.offset < 0 then
            show_part(context, part, stop + shape.trailer + part.offset)
        end
    end
    if #shape.stop > 0 then
        local range = tvb(#bytes - #shape.stop, #shape.stop)
        show_mark(context, range, bytes:sub(-#shape.stop), "End", shape.stop)
    end
    return context
end
