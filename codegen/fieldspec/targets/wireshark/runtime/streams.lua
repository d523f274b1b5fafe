-- From packets to frames: directions, requests and the responses to them, ports and link types, Decode As.

local sessions, results
local streams = { limit = 64 }

-- Wireshark calls this when it opens a capture.
local function reset()
    sessions, results = {}, {}
end
reset()
protocol.init = reset

local in_ranges = values.is_within

local ranges_of = {}

-- `1-16,20` or `0x8001` as ranges; nil for a text without numbers, which means every number.
function streams.ranges(text)
    local known = ranges_of[text]
    if known == nil then
        known = streams.parsed(text) or false
        ranges_of[text] = known
    end
    return known or nil
end

-- The same for a text that is new.
function streams.parsed(text)
    local ranges = {}
    for item in tostring(text):gsub("%s*%-%s*", "-"):gmatch("[^,%s]+") do
        local first, last = item:match("^(%w+)%-?(%w*)$")
        first = first and tonumber(first)
        if first then
            ranges[#ranges + 1] = { first, tonumber(last) or first }
        end
    end
    return #ranges > 0 and ranges or nil
end

-- The direction that the ports of a packet tell, nil where they do not. `ports` are those of the device.
local function direction_by_ports(pinfo, source, target, ports)
    if source == target then
        return nil
    end
    local to, from = ports and in_ranges(target, ports), ports and in_ranges(source, ports)
    if to ~= from then
        return to and "request" or "response"
    end
    if pinfo.match_uint == target then
        return "request"
    end
    return pinfo.match_uint == source and "response" or nil
end

-- The requests of a line that wait for a response, the oldest first.
local function session_of(link, pinfo, source, target)
    local from = tostring(pinfo.src) .. " " .. source
    local to = tostring(pinfo.dst) .. " " .. target
    if to < from then
        from, to = to, from
    end
    local key = link.name .. " " .. from .. " " .. to
    sessions[key] = sessions[key] or {}
    return sessions[key]
end

-- Whether a response answers a request: the same unit, code and other parts, as far as it repeats them.
-- The code that all exception responses have is that of no request.
local function answers(link, request, response)
    if response.message and response.message.is_unrequested then
        return false
    end
    if response.is_coded then
        local is_other = response.message and response.message ~= request.message
        local code = request.message and request.message.response_code or request.code
        if is_other or response.code ~= nil and code ~= response.code then
            return false
        end
    end
    for name, number in pairs(response.repeated) do
        if request.values[name] ~= number then
            return false
        end
    end
    return true
end

-- What the head of a frame tells about its place in a conversation. `repeated` has the numbers that a response repeats,
-- by the names of the parts of the request.
local function head_of(link, direction, bytes, asked, message)
    local head = { values = {}, repeated = {} }
    local shape = link[direction]
    local parts = frames.first_parts(link, shape, bytes)
    head.message = message
    for _, part in ipairs(shape.parts) do
        if part.offset >= 0 and part.value and #parts >= part.offset + part.size then
            local own = frames.own_bytes(part, parts, part.offset)
            local number = numbers.of(own, part.value)
            head.values[part.name] = number
            if part.role == "unit_address" then
                head.unit = number
            elseif part.role == "code" then
                local body = parts:sub(shape.header + 1)
                local code = numbers.code(own, part.value)
                local named, _, answered = frames.message_of(link, direction, code, parts, body)
                head.message, head.code, head.is_coded = named, answered, answered ~= nil
            end
        end
    end
    for _, part in ipairs(link.repeated) do
        head.repeated[part.asked] = head.values[direction == "request" and part.asked or part.answered]
    end
    return head
end

local function open_request(link, session, head)
    for index = #session, 1, -1 do
        if answers(link, session[index], head) then
            return session[index]
        end
    end
    return nil
end

-- The direction, the length and the open request of the first frame in some bytes. The length is nil where nothing
-- tells; the last result is true where more bytes will tell.
local function recognized(link, bytes, hint, session, message)
    local choices = hint and { hint } or { "response", "request" }
    local waits = false
    local fallback
    for _, direction in ipairs(choices) do
        local head = head_of(link, direction, bytes, nil, message)
        local asked
        if direction == "response" then
            asked = open_request(link, session, head)
        end
        local length, more = frames.length(link, direction, bytes, asked, message)
        waits = waits or more or length and length > #bytes
        local choice = { direction = direction, length = length, asked = asked, head = head }
        choice.more = more or length and length > #bytes
        local whole = bytes:sub(1, length or #bytes)
        -- Without a hint, a response must answer a request: an echo of the device looks like a request.
        local is_likely = hint or direction == "request" or asked
        if is_likely and not choice.more and frames.fits(link, direction, whole, asked, message) then
            return choice
        end
        if not fallback or asked then
            fallback = fallback and fallback.asked and fallback or choice
        end
    end
    if not hint then
        local head = head_of(link, "response", bytes, nil, message)
        local length = frames.length(link, "response", bytes, nil, message)
        if frames.fits(link, "response", bytes:sub(1, length or #bytes), nil, message) then
            return { direction = "response", length = length, head = head }
        end
        if not fallback.asked then
            local request_head = head_of(link, "request", bytes, nil, message)
            local request_length, more = frames.length(link, "request", bytes, nil, message)
            fallback = { direction = "request", length = request_length, head = request_head }
            fallback.more = more or request_length and request_length > #bytes
        end
    end
    return fallback
end

-- Closes the requests that a frame leaves without an answer. A device has one open request for each of the numbers that
-- its responses repeat: the next frame with the same numbers answers it, or follows on an answer that is lost. What the
-- device sends of its own accord is neither.
local function close_requests(link, session, head)
    if head.message and head.message.is_unrequested then
        return
    end
    for index = #session, 1, -1 do
        local request = session[index]
        local is_closed = true
        for _, part in ipairs(link.repeated) do
            is_closed = is_closed and request.values[part.asked] == head.repeated[part.asked]
        end
        if is_closed then
            table.remove(session, index)
        end
    end
end

-- Notes a frame in the conversation, at the first visit of its packet.
local function remember(link, session, choice, pinfo)
    local note = { direction = choice.direction, length = choice.length, frame = pinfo.number, time = pinfo.abs_ts }
    close_requests(link, session, choice.head)
    if choice.direction == "request" then
        if #session >= streams.limit then
            table.remove(session, 1)
        end
        note.values, note.message = choice.head.values, choice.head.message
        note.code = choice.head.code
        session[#session + 1] = note
    elseif choice.asked then
        note.asked = choice.asked
        choice.asked.answered_in = pinfo.number
    end
    return note
end

local function show_pairing(tree, note)
    local common = device.common
    if note.direction == "request" and note.answered_in then
        tree:add(fields[common.response_in], note.answered_in):set_generated()
    elseif note.asked then
        tree:add(fields[common.request_in], note.asked.frame):set_generated()
        local span = note.time - note.asked.time
        local seconds = math.floor(span)
        tree:add(fields[common.time], NSTime.new(seconds, math.floor((span - seconds) * 1e9 + 0.5))):set_generated()
    end
end

local MOST_NAMES, PROTOCOL = 3, device.id:upper()

-- The names of the first registers that a frame accesses, for the column of information.
local function registers_text(names)
    if not names or #names == 0 then
        return ""
    end
    local more = #names > MOST_NAMES and ", and " .. #names - MOST_NAMES .. " more" or ""
    return ": " .. table.concat(names, ", ", 1, math.min(#names, MOST_NAMES)) .. more
end

-- Adds one frame to the tree and to the columns.
local function show_frame(link, note, tvb, pinfo, root, message)
    local tree = root:add(protocol, tvb())
    tree:add(fields[device.common.direction], note.direction):set_generated()
    values.link = link.name
    local context = frames.show(link, note.direction, tvb, tree, note.asked, message)
    if note.direction == "request" and not context.is_broken then
        -- The response needs the values of the whole request.
        note.values, note.message = context.values, context.message
    end
    local name = context.message and context.message.name
    if name then
        tree:add(fields[device.common.message], name):set_generated()
        values.cite(tree, context.message.errata)
    end
    show_pairing(tree, note)
    local text = (name or "unknown message") .. (context.is_refusal and " refused" or "") .. " " .. note.direction
    tree:append_text(", " .. link.title .. ": " .. text)
    pinfo.cols.protocol = PROTOCOL
    return text .. registers_text(context.registers)
end

-- Dissects a packet, which has whole frames, or with `is_stream` a piece of a stream. `show_other` shows frames of
-- units that the person has not chosen. Returns the bytes that were taken.
function streams.dissect(link, tvb, pinfo, root, options)
    -- What a packet tells is asked for once: each question makes an object or searches a list.
    local source, target = pinfo.src_port, pinfo.dst_port
    local session = session_of(link, pinfo, source, target)
    local hint = options.direction or not options.is_line and direction_by_ports(pinfo, source, target, options.ports) or nil
    local bytes, at, texts = tvb:raw(), 0, {}
    while at < #bytes do
        local rest = bytes:sub(at + 1)
        local key = pinfo.number .. " " .. link.name .. " " .. at .. " " .. rest
        local note = results[key]
        if not note then
            local choice = recognized(link, rest, hint, session, options.message)
            if choice.more and options.is_stream then
                pinfo.desegment_offset, pinfo.desegment_len = at, DESEGMENT_ONE_MORE_SEGMENT
                if choice.length then
                    pinfo.desegment_len = choice.length - #rest
                end
                break
            end
            local unit = choice.head.unit
            if options.units and unit and not in_ranges(unit, options.units) then
                note = { is_other = true, length = choice.length }
            else
                note = remember(link, session, choice, pinfo)
            end
            results[key] = note
        end
        local length = math.min(note.length or #rest, #rest)
        if length < 1 then
            length = #rest
        end
        local piece = length == #bytes and tvb or tvb(at, length):tvb()
        if note.is_other then
            options.show_other(piece, pinfo, root)
        else
            texts[#texts + 1] = show_frame(link, note, piece, pinfo, root, options.message)
        end
        at = at + length
    end
    if #texts > 0 then
        pinfo.cols.info = table.concat(texts, "; ")
    end
    return #bytes
end
