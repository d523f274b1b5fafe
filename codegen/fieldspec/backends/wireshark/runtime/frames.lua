-- Frames: where they end, whether bytes are one, and the items of their parts.

local frames = {}

local function part_number(part, bytes)
    local own = bytes:sub(part.offset + 1, part.offset + part.size)
    return #own == part.size and part.value and numbers.of(own, part.value) or nil
end

local function with_role(shape, role)
    for _, part in ipairs(shape.parts) do
        if part.role == role then
            return part
        end
    end
    return nil
end

-- The bytes that hexadecimal characters encode.
local function encoded(characters)
    return (characters:gsub("..", function(pair) return string.char(tonumber(pair, 16)) end))
end

-- The bytes of the first parts behind the start mark, as far as there are any.
function frames.first_parts(link, shape, bytes)
    local parts = bytes:sub(#shape.start + 1)
    if not link.hex then
        return parts
    end
    parts = parts:gsub("%X.*$", "")
    return encoded(parts:sub(1, #parts - #parts % 2))
end

-- The bytes of the parts of a frame without delimiters and encoding, and a reason where these are wrong.
local function unwrapped(link, direction, bytes)
    local shape = link[direction]
    if bytes:sub(1, #shape.start) ~= shape.start then
        return nil, "wrong_mark"
    end
    if #shape.stop > 0 and bytes:sub(-#shape.stop) ~= shape.stop or #bytes < #shape.start + #shape.stop then
        return nil, "wrong_mark"
    end
    local inner = bytes:sub(#shape.start + 1, #bytes - #shape.stop)
    if not link.hex then
        return inner
    end
    if inner:find("%X") then
        return nil, "not_hex"
    end
    if #inner % 2 == 1 then
        return nil, "wrong_length"
    end
    return encoded(inner)
end

-- The message with a code and a number in its data, which several messages with one code have. Where nothing in the
-- data tells them apart, it is that of the request.
local function message_with(shape, code, body, asked)
    if shape.is_ambiguous[code] then
        return asked and asked.message and asked.message.response_code == code and asked.message or nil
    end
    local subcode = shape.shared[code]
    if not subcode then
        return shape.by_code[code]
    end
    local own = body:sub(subcode.offset + 1, subcode.offset + subcode.size)
    if #own < subcode.size then
        return nil
    end
    return subcode.by_number[numbers.unsigned(subcode.order == "little" and own:reverse() or own)]
end

-- Whether parts with a code are an exception response: by a bit in the code, by the code, or by another part.
local function is_marked(link, direction, code, parts)
    local exception = direction == "response" and link.exception
    if not exception then
        return false
    end
    if exception.part then
        for _, part in ipairs(link.response.parts) do
            if part.name == exception.part then
                local number = part_number(part, parts)
                return number ~= nil and not values.is_within(number, exception.normal, part.value)
            end
        end
    end
    if not code then
        return false
    end
    if exception.code then
        return code == exception.code
    end
    return numbers.band(code, exception.flag) ~= 0
end

-- Whether a response without a code is an exception response: by another part, or by bytes in its data.
local function has_mark(link, direction, parts, body)
    local mark = direction == "response" and link.exception and link.exception.mark
    if not mark then
        return is_marked(link, direction, nil, parts)
    end
    return body:sub(mark.offset + 1, mark.offset + #mark.bytes) == mark.bytes
end

-- The message, or nil, whether it is refused, and its code, by the code of a frame and its parts, or by the request
-- that it answers. `body` are the parts from the body on.
function frames.message_of(link, direction, code, parts, body, asked, message)
    if code == nil then
        return message or asked and asked.message, has_mark(link, direction, parts, body)
    end
    if is_marked(link, direction, code, parts) then
        if link.exception.code then
            -- All exception responses have this code; only the request tells which message they answer.
            return asked and asked.message, true
        end
        code = code - numbers.band(code, link.exception.flag)
        if link.refused_by_code[code] == false then
            -- An exception response carries no subcode; only the request tells which message it answers.
            return asked and asked.message and asked.message.response_code == code and asked.message or nil, true, code
        end
        return link.refused_by_code[code], true, code
    end
    return message_with(link[direction], code, body, asked), false, code
end

local function record_of(link, direction, message, is_refusal)
    if is_refusal then
        return device.records[link.exception.record]
    end
    return message and device.records[message[direction]]
end

-- The bytes of the body that a record describes; nil where `body` does not tell, and true where it is too short to.
local function extent_of(record, body)
    if record.size then
        return record.size
    end
    local extent = record.extent
    if not extent then
        return nil
    end
    local own = body:sub(extent.offset + 1, extent.offset + extent.value.size)
    if #own < extent.value.size then
        return nil, true
    end
    return extent.fixed + numbers.of(own, extent.value) * extent.unit
end

-- The bytes of the first frame, or nil where nothing tells; the second result is true where more bytes will tell.
function frames.length(link, direction, bytes, asked, message)
    local shape = link[direction]
    local marks, width = #shape.start + #shape.stop, link.hex and 2 or 1
    if link.hex and #shape.stop > 0 then
        local _, stop = bytes:find(shape.stop, #shape.start + 1, true)
        return stop, stop == nil and #bytes < shape.longest
    end
    local parts = frames.first_parts(link, shape, bytes)
    local length = with_role(shape, "length")
    if length then
        local number = part_number(length, parts)
        if not number then
            return nil, true
        end
        local total = marks + width * (number * length.unit_size + length.base)
        return total >= shape.shortest and total <= shape.longest and total or nil
    end
    if #parts < shape.header then
        return nil, true
    end
    local code = with_role(shape, "code")
    local number = code and part_number(code, parts)
    local rest = parts:sub(shape.header + 1)
    local subcode = shape.shared[number]
    if subcode and not is_marked(link, direction, number, parts) and #rest < subcode.offset + subcode.size then
        return nil, true
    end
    local named, is_refusal = frames.message_of(link, direction, number, parts, rest, asked, message)
    local record = record_of(link, direction, named, is_refusal)
    if not record then
        return nil
    end
    local body, is_short = extent_of(record, rest)
    return body and marks + width * (shape.header + body + shape.trailer), is_short
end

-- Whether bytes are a frame: delimiters, length, checksums, code and the length of the body are right.
function frames.fits(link, direction, bytes, asked, message)
    local shape = link[direction]
    local parts = unwrapped(link, direction, bytes)
    if not parts or #parts < shape.header + shape.trailer then
        return false
    end
    local code
    for _, part in ipairs(shape.parts) do
        local at = part.offset >= 0 and part.offset or #parts + part.offset
        local own = parts:sub(at + 1, at + part.size)
        if part.role == "checksum" and checksums.bytes(part, checksums.covered(part, parts)) ~= own then
            return false
        elseif part.role == "length" and numbers.of(own, part.value) * part.unit_size + part.base ~= #parts then
            return false
        elseif part.role == "code" then
            code = numbers.of(own, part.value)
        elseif part.constant and not part.reserved then
            if numbers.of(own, part.value) ~= numbers.bound(part.constant, part.value) then
                return false
            end
        end
    end
    local body = parts:sub(shape.header + 1, #parts - shape.trailer)
    local named, is_refusal = frames.message_of(link, direction, code, parts, body, asked, message)
    local record = record_of(link, direction, named, is_refusal)
    if not record then
        return false
    end
    local size = #parts - shape.header - shape.trailer
    local exact = extent_of(record, parts:sub(shape.header + 1))
    if exact and exact ~= size or size < record.least or record.most and size > record.most then
        return false
    end
    return not (asked and direction == "response" and named and asked.message and named ~= asked.message)
end

local Context = {}
Context.__index = Context

-- Bytes of the parts in the packet; past the end, none.
function Context:range(at, size)
    local length = self.tvb:len()
    local first = math.max(0, math.min(at + self.skip, length))
    return self.tvb(first, math.max(0, math.min(size, length - first)))
end

local function show_part(context, part, at)
    local bytes = context.bytes:sub(at + 1, at + part.size)
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
            values.report(item, "wrong_check", part.name .. " should be " .. text(should))
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
        local shape = link[context.direction]
        local body = context.bytes:sub(shape.header + 1, math.max(shape.header, #context.bytes - shape.trailer))
        context.message, context.is_refusal =
            frames.message_of(link, context.direction, number, context.bytes, body, context.open)
        if context.is_refusal then
            context.values[part.name] = number - numbers.band(number, link.exception.flag)
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
        if addresses and number == addresses.broadcast then
            item:append_text(", for all stations")
        elseif addresses and addresses.ranges and not values.is_within(number, addresses.ranges) then
            values.report(item, "out_of_range", part.name .. " is no address of this device")
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
    local context = setmetatable({
        link = link, direction = direction, tree = tree, tvb = tvb, skip = #shape.start, values = {}, places = {},
        items = {}, open = asked, asked = asked and asked.values, message = message or asked and asked.message,
    }, Context)
    if #shape.start > 0 then
        show_mark(context, context:range(-#shape.start, #shape.start), bytes:sub(1, #shape.start), "Start", shape.start)
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
        context.tvb, context.skip = ByteArray.new(digits):tvb("Decoded frame"), 0
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
