-- Expert items: what can be wrong with a value, a frame or an exchange, with its group and severity.

local expert_items = {
    exception = { "Exception response", expert.group.RESPONSE_CODE, expert.severity.NOTE },
    forbidden = { "Access that the register does not allow", expert.group.PROTOCOL, expert.severity.WARN },
    incomplete = { "Bytes are missing", expert.group.MALFORMED, expert.severity.ERROR },
    misprint = { "The manual departs from what is right", expert.group.COMMENTS_GROUP, expert.severity.COMMENT },
    mismatch = { "The response does not fit its request", expert.group.SEQUENCE, expert.severity.WARN },
    not_hex = { "No hexadecimal digits", expert.group.MALFORMED, expert.severity.ERROR },
    out_of_range = { "Value out of its range", expert.group.PROTOCOL, expert.severity.WARN },
    unknown_code = { "Unknown code", expert.group.UNDECODED, expert.severity.WARN },
    unknown_value = { "Unknown value", expert.group.PROTOCOL, expert.severity.WARN },
    unlisted = { "The manual lists nothing here", expert.group.UNDECODED, expert.severity.NOTE },
    wrong_checksum = { "Wrong checksum", expert.group.CHECKSUM, expert.severity.ERROR },
    wrong_const = { "Wrong constant", expert.group.PROTOCOL, expert.severity.WARN },
    wrong_length = { "Wrong length", expert.group.MALFORMED, expert.severity.ERROR },
    wrong_mark = { "Wrong delimiter", expert.group.MALFORMED, expert.severity.ERROR },
    wrong_measure = { "Wrong size of a list", expert.group.PROTOCOL, expert.severity.WARN },
}

-- Declares them under the names that filters have.
local function declare_expert_items()
    local infos = {}
    for reason, row in pairs(expert_items) do
        local info = ProtoExpert.new(device.id .. ".expert." .. reason, row[1], row[2], row[3])
        expert_items[reason] = info
        infos[#infos + 1] = info
    end
    protocol.experts = infos
end
