-- Frames: where they end, and whether bytes are one.

local frames = {}

-- The bytes of a part alone, as far as there are any; `at` is its offset.
function frames.own_bytes(part, bytes, at)
    return numbers.alone(bytes:sub(at + 1, at + part.size), part)
end

local function part_number(part, bytes)
    local own = frames.own_bytes(part, bytes, part.offset)
    return #own == part.size and part.value and numbers.of(own, part.value) or nil
end

local function code_in(part, bytes)
    local own = frames.own_bytes(part, bytes, part.offset)
    return #own == part.size and numbers.code(own, part.value) or nil
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

-- How many bytes of its preamble a frame has before the least ones, which are the first of the start mark.
local function surplus_of(shape, bytes)
    local preamble, count = shape.preamble, 0
    while preamble and bytes:sub(count + 1, count + 1) == preamble.byte do
        count = count + 1
    end
    return preamble and count >= preamble.least and count <= preamble.most and count - preamble.least or 0
end

-- The bytes of the first parts after the start mark, as far as there are any.
function frames.first_parts(link, shape, bytes)
    local parts = bytes:sub(surplus_of(shape, bytes) + #shape.start + 1)
    if not link.hex then
        return parts
    end
    parts = parts:gsub("%X.*$", "")
    return encoded(parts:sub(1, #parts - #parts % 2))
end

-- The bytes of the parts of a frame without delimiters and encoding, and a reason where these are wrong.
local function unwrapped(link, direction, bytes)
    local shape = link[direction]
    bytes = bytes:sub(surplus_of(shape, bytes) + 1)
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
    return subcode.by_number[numbers.code(own, subcode)]
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
    return numbers.without(code, exception.flag) ~= code
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
        code = numbers.without(code, link.exception.flag)
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

-- Whether a record may have so many bytes, where it does not tell them itself.
local function may_have(record, size)
    if size < record.least or record.most and size > record.most then
        return false
    end
    return not record.step or (size - record.step.fixed) % record.step.unit == 0
end

-- The bytes of the first frame, which ends with the first end delimiter with which it is one; nil where it is not there.
-- The second result is true where more bytes may bring it: a damaged frame is not taken for the beginning of a longer one.
local function delimited(link, direction, bytes, record, asked, message)
    local shape = link[direction]
    local at = #shape.start + 1
    while true do
        local first, stop = bytes:find(shape.stop, at, true)
        if not stop then
            local size = #bytes - #shape.start - shape.header - shape.trailer - #shape.stop
            local is_whole = bytes:sub(-#shape.stop) == shape.stop and may_have(record, size)
            return nil, not is_whole and #bytes < shape.longest
        end
        if frames.fits(link, direction, bytes:sub(1, stop), asked, message) then
            return stop
        end
        at = first + 1
    end
end

-- The bytes of the first frame without those that `surplus_of` counts, or nil where nothing tells; the second result is
-- true where more bytes will tell.
local function own_length(link, direction, bytes, asked, message)
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
    local number = code and code_in(code, parts)
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
    if not body and not is_short and #shape.stop > 0 then
        return delimited(link, direction, bytes, record, asked, message)
    end
    return body and marks + width * (shape.header + body + shape.trailer), is_short
end

-- The bytes of the first frame, or nil where nothing tells; the second result is true where more bytes will tell.
function frames.length(link, direction, bytes, asked, message)
    local surplus = surplus_of(link[direction], bytes)
    local own, more = own_length(link, direction, bytes:sub(surplus + 1), asked, message)
    return own and own + surplus, more
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
        local own = frames.own_bytes(part, parts, at)
        if part.role == "checksum" and checksums.bytes(part, checksums.covered(part, parts)) ~= own then
            return false
        elseif part.role == "length" and numbers.of(own, part.value) * part.unit_size + part.base ~= #parts then
            return false
        elseif part.role == "code" then
            code = numbers.code(own, part.value)
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
    if exact and exact ~= size or not may_have(record, size) then
        return false
    end
    return not (asked and direction == "response" and named and asked.message and named ~= asked.message)
end
