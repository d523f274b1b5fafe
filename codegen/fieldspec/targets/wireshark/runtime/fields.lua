-- The protocol, and all that a filter can name. Wireshark takes each list once.

-- Wireshark may have a protocol with the name of the device: then another name takes its place in all names.
local listed_id, is_free, protocol = device.id, pcall(Proto, device.id, device.title)
if not is_free then
    device.id = device.id .. "_device"
    protocol = Proto(device.id, device.title)
end

local fields, names_of = {}, {}

-- Declares the fields of filters.
local function declare_fields()
    local list = {}
    for name, enum in pairs(device.enums) do
        names_of[name] = enum.names
    end
    for _, row in ipairs(device.fields) do
        local names = row.names and (type(row.names) == "string" and names_of[row.names] or row.names)
        local display = row.base and base[row.base] or base.NONE
        if row.type == "FRAMENUM" then
            names = frametype[row.names]
        end
        local name = device.id .. row.filter:sub(#listed_id + 1)
        local field = ProtoField.new(row.title, name, ftypes[row.type], names, display, nil, row.text)
        fields[row.filter] = field
        list[#list + 1] = field
    end
    protocol.fields = list
end
