-- Registers everything with Wireshark: fields, preferences, ports, link types, and the entries of Decode As.

declare_fields()
declare_expert_items()
index_spaces()

for _, link in pairs(device.links) do
    link.refused_by_code = {}
    for _, name in ipairs(link.request.messages) do
        local message = device.messages[name]
        -- An exception response does not say which of several messages with one code it refuses.
        link.refused_by_code[message.response_code] = link.refused_by_code[message.response_code] == nil and message
    end
    for key, shape in pairs({ code = link.request, response_code = link.response }) do
        shape.by_code, shape.shared = {}, {}
        for _, name in ipairs(shape.messages) do
            local message = device.messages[name]
            shape.by_code[message[key]] = message
        end
        shape.is_ambiguous = {}
        for _, code in ipairs(shape.ambiguous or {}) do
            shape.is_ambiguous[code] = true
        end
        for _, subcode in ipairs(shape.subcodes) do
            shape.shared[subcode.code] = subcode
            subcode.by_number = {}
            for _, row in ipairs(subcode.messages) do
                subcode.by_number[row.number] = device.messages[row.name]
            end
        end
    end
end

local USER_LINK_TYPES = 147

-- The preferences that say where a link is, and what they were when its dissector was attached.
local carriers = {}

local function own_units()
    return device.has_units and streams.ranges(protocol.prefs.units) or nil
end

-- A dissector of one link; of a link without codes, of one message. `carrier` is `tcp`, `udp`, `line`, or empty for
-- Decode As, where Wireshark tells by the port of the packet what is below.
local function dissector_of(carrier, link, message)
    local function show_other(tvb, pinfo, root)
        local other = carrier.other and carrier.other[pinfo.match_uint] or Dissector.get("data")
        other:call(tvb, pinfo, root)
    end
    return function(tvb, pinfo, root)
        local is_line = carrier.kind == "line" or pinfo.port_type == 0
        local options = {
            units = own_units(),
            ports = carrier.ports,
            is_line = is_line,
            is_stream = not is_line and link.is_framed and pinfo.can_desegment > 0,
            show_other = show_other,
            message = message,
        }
        return streams.dissect(link, tvb, pinfo, root, options)
    end
end

local function decode_as(link, proto)
    for _, name in ipairs({ "tcp.port", "udp.port", "rtacser.data" }) do
        local exists, table_of = pcall(DissectorTable.get, name)
        if exists and table_of then
            pcall(table_of.add_for_decode_as, table_of, proto)
        end
    end
end

local function message_choices(link)
    local list = {}
    for index, name in ipairs(link.messages) do
        list[index] = { index, device.messages[name].title, index }
    end
    return list
end

local descriptions = {}

-- A protocol of its own: Wireshark refuses two with the same description, which links without titles of their own may have.
local function new_protocol(id, description)
    local own = descriptions[description] and description .. " (" .. id .. ")" or description
    descriptions[own] = true
    return Proto(id, own)
end

local function add_carrier(link, kind, title, text)
    local id = device.id .. "_" .. link.name .. "_" .. kind
    local proto = new_protocol(id, device.title .. ", " .. link.title .. ", " .. title)
    local preference = link.name .. "_" .. kind
    protocol.prefs[preference] = Pref.string(link.name .. ": " .. title, (link.ports or {})[kind] or "", text)
    local carrier = { kind = kind, preference = preference, proto = proto, link = link, attached = {} }
    proto.dissector = dissector_of(carrier, link)
    if not link.is_coded then
        proto.dissector = function(tvb, pinfo, root)
            local message = device.messages[link.messages[protocol.prefs[link.name .. "_message"]]]
            return dissector_of(carrier, link, message)(tvb, pinfo, root)
        end
    end
    carriers[#carriers + 1] = carrier
end

local TABLES = { tcp = "tcp.port", udp = "udp.port", line = "wtap_encap" }

-- Attaches a carrier to the ports or link types of its preference, and gives back those that it had.
local function attach(carrier)
    local table_of = DissectorTable.get(TABLES[carrier.kind])
    for number, previous in pairs(carrier.attached) do
        table_of:remove(number, carrier.proto)
        if previous then
            table_of:add(number, previous)
        end
    end
    carrier.attached, carrier.other = {}, {}
    carrier.ports = streams.ranges(protocol.prefs[carrier.preference])
    for _, range in ipairs(carrier.ports or {}) do
        for number = range[1], math.min(range[2], 65535) do
            local place = number
            if carrier.kind == "line" then
                place = number >= USER_LINK_TYPES and number <= USER_LINK_TYPES + 15
                    and wtap.USER0 + number - USER_LINK_TYPES or nil
            end
            if place then
                local previous = table_of:get_dissector(place)
                carrier.attached[place] = previous or false
                carrier.other[place] = previous
                table_of:add(place, carrier.proto)
            end
        end
    end
end

local PROFINET, FRAME_ID, STATUS = 0x8892, 2, 4

-- Process data in cyclic frames of PROFINET: the dissector of Wireshark shows the frame, and this one the process data
-- of those frames whose numbers a person has entered.
local function add_process_data(link)
    local proto = new_protocol(device.id .. "_" .. link.name .. "_pn", device.title .. ", process data of PROFINET")
    local prefix = link.name .. "_pn_"
    local prefs, table_of, previous = protocol.prefs, DissectorTable.get("ethertype"), nil
    local text = "Numbers of the cyclic frames, such as 0x8001. Empty for none."
    prefs[prefix .. "request"] = Pref.string(link.name .. ": PROFINET frame IDs to the device", "", text)
    prefs[prefix .. "response"] = Pref.string(link.name .. ": PROFINET frame IDs from the device", "", text)
    text = "Bytes before the process data in a frame: other submodules, and the status of their data."
    prefs[prefix .. "offset"] = Pref.uint(link.name .. ": PROFINET offset", 0, text)
    local function show(direction, tvb, pinfo, root)
        local message = device.messages[link.messages[prefs[link.name .. "_message"]]]
        local start = FRAME_ID + prefs[prefix .. "offset"]
        local room = tvb:len() - STATUS - start
        local size = math.min(device.records[message[direction]].size or room, room)
        if size > 0 then
            streams.dissect(link, tvb(start, size):tvb(), pinfo, root, { direction = direction, message = message })
        end
    end
    proto.dissector = function(tvb, pinfo, root)
        if previous then
            previous:call(tvb, pinfo, root)
        end
        local number = tvb:len() >= FRAME_ID and tvb(0, FRAME_ID):uint()
        for _, direction in ipairs({ "request", "response" }) do
            local ranges = streams.ranges(prefs[prefix .. direction])
            if number and ranges and values.is_within(number, ranges) then
                show(direction, tvb, pinfo, root)
            end
        end
        return tvb:len()
    end
    local is_attached = false
    carriers[#carriers + 1] = {
        attach = function()
            local is_wanted = streams.ranges(prefs[prefix .. "request"]) or streams.ranges(prefs[prefix .. "response"])
            if is_wanted and not is_attached then
                previous = table_of:get_dissector(PROFINET)
                table_of:add(PROFINET, proto)
            elseif is_attached and not is_wanted then
                table_of:remove(PROFINET, proto)
                if previous then
                    table_of:add(PROFINET, previous)
                end
            end
            is_attached = is_wanted ~= nil
        end,
    }
end

for _, link in ipairs(device.link_order) do
    link = device.links[link]
    if not link.is_coded then
        local text = "The message that the packets carry, as their bytes do not tell it."
        protocol.prefs[link.name .. "_message"] =
            Pref.enum(link.name .. ": message", 1, text, message_choices(link), false)
        add_process_data(link)
    end
    -- Where nothing tells the end of a frame in a stream, each segment is read as whole frames.
    if link.is_framed or (link.ports and link.ports.tcp) then
        add_carrier(link, "tcp", "TCP ports", "Ports of the device or its gateway, such as 4001 or 4001-4004. Empty for none.")
    end
    add_carrier(link, "udp", "UDP ports", "Ports of the device or its gateway. Empty for none.")
    add_carrier(link, "line", "link types", "Numbers of DLT_USER link types, 147 to 162, whose packets are frames of a serial line.")
    local titles = link.is_coded and { false } or link.messages
    for _, name in ipairs(titles) do
        local message = name and device.messages[name] or nil
        local id = device.id .. "_" .. link.name .. (name and "_" .. name or "")
        local proto = new_protocol(id, device.title .. ", " .. (message and message.title or link.title))
        proto.dissector = dissector_of({}, link, message)
        decode_as(link, proto)
    end
end

if device.has_units then
    protocol.prefs.units = Pref.string("Unit addresses", "", "Units that are this device, such as 1-16,20. Empty for all.")
end

local function attach_all()
    for _, carrier in ipairs(carriers) do
        (carrier.attach or attach)(carrier)
    end
end
protocol.prefs_changed = attach_all
attach_all()
