-- A dissector for the packet of peers/panel.py, as somebody writes it by hand: the same items as the generated one on
-- whole frames, and no more. It reads one request or answer in each packet.

local panel = Proto("panel_hand", "Panel by hand")
local f, list = {}, {}
local function declare(name, kind, title)
    f[name] = kind("panel_hand." .. name, title)
    list[#list + 1] = f[name]
end
declare("direction", ProtoField.string, "Direction")
declare("message", ProtoField.string, "Message")
declare("length", ProtoField.uint16, "Length")
declare("code", ProtoField.uint8, "Code")
declare("request_in", ProtoField.framenum, "Request in")
declare("response_in", ProtoField.framenum, "Response in")
declare("time", ProtoField.relative_time, "Time from the request")
local numbers, quantities, bit_fields, bit_texts = {}, {}, {}, {}
for place = 0, 19 do
    declare("f" .. place, ProtoField.uint16, "F" .. place)
    numbers[place] = f["f" .. place]
end
for place = 8, 13 do
    declare("q" .. place, ProtoField.double, "F" .. place)
    quantities[place] = f["q" .. place]
end
for place = 4, 7 do
    bit_fields[place], bit_texts[place] = {}, {}
    for bit = 0, 15 do
        local name = "w" .. place - 4 .. "_" .. bit
        declare(name, ProtoField.bool, name)
        bit_fields[place][bit] = f[name]
        local head = string.format("Bit %d, W%d flag %d: ", bit, place - 4, bit)
        bit_texts[place][bit] = { [true] = head .. "1", [false] = head .. "0" }
    end
end
panel.fields = list
local unknown = ProtoExpert.new("panel_hand.unknown", "Unknown value", expert.group.PROTOCOL, expert.severity.WARN)
panel.experts = { unknown }

local band, lshift = bit32.band, bit32.lshift

local open, notes = nil, {}
function panel.init()
    open, notes = nil, {}
end

local function show_body(tvb, tree)
    for place = 0, 19 do
        local range = tvb(3 + 2 * place, 2)
        local number = range:uint()
        local item = tree:add(numbers[place], range)
        local head = "F" .. place .. ": "
        if place < 4 then
            if number < 20 then
                item:set_text(head .. "s" .. place .. "_" .. number .. " (" .. number .. ")")
            else
                item:set_text(head .. number)
                item:add_proto_expert_info(unknown, "f" .. place .. " is " .. number .. ": not permitted")
            end
        elseif place < 8 then
            item:set_text(string.format("%s0x%04x", head, number))
            local fields, texts = bit_fields[place], bit_texts[place]
            for bit = 0, 15 do
                local is_set = band(number, lshift(1, bit)) ~= 0
                item:add(fields[bit], range, is_set):set_text(texts[bit][is_set])
            end
        elseif place < 14 then
            local quantity = string.format("%.2f mm", number / 100)
            item:set_text(head .. quantity .. " (" .. number .. ")")
            local inner = item:add(quantities[place], range, number / 100)
            inner:set_text("Quantity: " .. quantity)
            inner:set_generated()
        else
            item:set_text(head .. number)
        end
    end
end

function panel.dissector(tvb, pinfo, root)
    local is_request = pinfo.dst_port == 4001
    local length = tvb(0, 2):uint()
    if length ~= tvb:len() then
        return 0
    end
    local note = notes[pinfo.number]
    if not note then
        note = { frame = pinfo.number, time = pinfo.abs_ts }
        notes[pinfo.number] = note
        if is_request then
            open = note
        else
            note.asked, open = open, nil
            if note.asked then
                note.asked.answered_in = pinfo.number
            end
        end
    end
    local tree = root:add(panel, tvb())
    local direction = is_request and "request" or "response"
    tree:add(f.direction, direction):set_generated()
    tree:add(f.length, tvb(0, 2)):set_text("Length: " .. length)
    tree:add(f.code, tvb(2, 1)):set_text("Code: " .. tvb(2, 1):uint() .. ", Read all")
    if not is_request then
        show_body(tvb, tree)
    end
    tree:add(f.message, "read_all"):set_generated()
    if note.answered_in then
        tree:add(f.response_in, note.answered_in):set_generated()
    elseif note.asked then
        tree:add(f.request_in, note.asked.frame):set_generated()
        local span = note.time - note.asked.time
        local seconds = math.floor(span)
        tree:add(f.time, NSTime.new(seconds, math.floor((span - seconds) * 1e9 + 0.5))):set_generated()
    end
    tree:append_text(", Tcp: read_all " .. direction)
    pinfo.cols.protocol = "PANEL"
    pinfo.cols.info = "read_all " .. direction
    return tvb:len()
end

DissectorTable.get("tcp.port"):add(4001, panel)
