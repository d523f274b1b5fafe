-- A dissector for the ten registers of peers/switchboard.py over Modbus TCP, as somebody writes it by hand: the same items
-- as the generated one on whole frames, and no more. It reads one request or answer in each packet.

local board = Proto("board", "Board by hand")
local f, list = {}, {}
local function declare(name, kind, title)
    f[name] = kind("board." .. name, title)
    list[#list + 1] = f[name]
end
for _, name in ipairs({ "direction", "message", "accessed" }) do
    declare(name, ProtoField.string, name)
end
declare("request_in", ProtoField.framenum, "Request in")
declare("response_in", ProtoField.framenum, "Response in")
declare("time", ProtoField.relative_time, "Time from the request")
for _, name in ipairs({ "transaction", "protocol", "length", "address", "word_count", "values" }) do
    declare(name, ProtoField.uint16, name)
end
for _, name in ipairs({ "station", "code", "byte_count" }) do
    declare(name, ProtoField.uint8, name)
end
for place = 0, 9 do
    declare("r" .. place, ProtoField.uint16, "R" .. place)
end
for word = 0, 4 do
    for bit = 0, 15 do
        declare("w" .. word .. "_" .. bit, ProtoField.bool, "W" .. word .. " flag " .. bit)
    end
end
board.fields = list
local unknown = ProtoExpert.new("board.unknown", "Unknown value", expert.group.PROTOCOL, expert.severity.WARN)
board.experts = { unknown }

local band, lshift = bit32.band, bit32.lshift
local bit_fields, bit_texts = {}, {}
for word = 0, 4 do
    bit_fields[word], bit_texts[word] = {}, {}
    for bit = 0, 15 do
        bit_fields[word][bit] = f["w" .. word .. "_" .. bit]
        local head = string.format("Bit %d, W%d Flag %d: ", bit, word, bit)
        bit_texts[word][bit] = { [true] = head .. "1", [false] = head .. "0" }
    end
end
local values, registers = f.values, {}
for place = 0, 9 do
    registers[place] = f["r" .. place]
end

local open, notes = {}, {}
function board.init()
    open, notes = {}, {}
end

local function show_head(tvb, tree, length)
    tree:add(f.transaction, tvb(0, 2)):set_text("Transaction: " .. tvb(0, 2):uint())
    tree:add(f.protocol, tvb(2, 2)):set_text("Protocol: " .. tvb(2, 2):uint())
    tree:add(f.length, tvb(4, 2)):set_text("Length: " .. length)
    tree:add(f.station, tvb(6, 1)):set_text("Station: " .. tvb(6, 1):uint())
    tree:add(f.code, tvb(7, 1)):set_text("Function: " .. tvb(7, 1):uint() .. ", Read input registers")
end

local function show_request(tvb, tree)
    local address, count = tvb(8, 2):uint(), tvb(10, 2):uint()
    tree:add(f.address, tvb(8, 2)):set_text("Address: " .. address)
    tree:add(f.word_count, tvb(10, 2)):set_text("Word count: " .. count)
    for place = address, math.min(address + count, 10) - 1 do
        local item = tree:add(f.accessed, tvb(12, 0), "r" .. place)
        item:set_text(string.format("0x%04X R%d", place, place))
        item:set_generated()
    end
end

local function show_answer(tvb, tree, address)
    local size = tvb(8, 1):uint()
    tree:add(f.byte_count, tvb(8, 1)):set_text("Byte count: " .. size)
    for place = 0, size / 2 - 1 do
        local range = tvb(9 + 2 * place, 2)
        tree:add(values, range):set_text("Values[" .. place .. "]: " .. range:uint())
    end
    for place = 0, size / 2 - 1 do
        local range, own = tvb(9 + 2 * place, 2), address + place
        local number = range:uint()
        local item = tree:add(registers[own], range)
        local head = string.format("0x%04X R%d: ", own, own)
        if own < 5 then
            if number < 20 then
                item:set_text(head .. "s" .. own .. "_" .. number .. " (" .. number .. ")")
            else
                item:set_text(head .. number)
                item:add_proto_expert_info(unknown, "r" .. own .. " is " .. number .. ": not permitted")
            end
        else
            item:set_text(string.format("%s0x%04x", head, number))
            local fields, texts = bit_fields[own - 5], bit_texts[own - 5]
            for bit = 0, 15 do
                local is_set = band(number, lshift(1, bit)) ~= 0
                item:add(fields[bit], range, is_set):set_text(texts[bit][is_set])
            end
        end
    end
end

function board.dissector(tvb, pinfo, root)
    local is_request = pinfo.dst_port == 502
    local length, transaction = tvb(4, 2):uint(), tvb(0, 2):uint()
    if length + 6 ~= tvb:len() then
        return 0
    end
    local note = notes[pinfo.number]
    if not note then
        note = { frame = pinfo.number, time = pinfo.abs_ts }
        notes[pinfo.number] = note
        if is_request then
            note.address, open[transaction] = tvb(8, 2):uint(), note
        else
            note.asked, open[transaction] = open[transaction], nil
            if note.asked then
                note.asked.answered_in = pinfo.number
            end
        end
    end
    local tree = root:add(board, tvb())
    local direction = is_request and "request" or "response"
    tree:add(f.direction, direction):set_generated()
    show_head(tvb, tree, length)
    if is_request then
        show_request(tvb, tree)
    else
        show_answer(tvb, tree, note.asked and note.asked.address or 0)
    end
    tree:add(f.message, "read_input_registers"):set_generated()
    if note.answered_in then
        tree:add(f.response_in, note.answered_in):set_generated()
    elseif note.asked then
        tree:add(f.request_in, note.asked.frame):set_generated()
        local span = note.time - note.asked.time
        local seconds = math.floor(span)
        tree:add(f.time, NSTime.new(seconds, math.floor((span - seconds) * 1e9 + 0.5))):set_generated()
    end
    tree:append_text(", Modbus TCP: read_input_registers " .. direction)
    pinfo.cols.protocol = "BOARD"
    pinfo.cols.info = "read_input_registers " .. direction
    return tvb:len()
end

DissectorTable.get("tcp.port"):add(502, board)
