-- Loads a dissector without Wireshark, whose objects are stubs, and prints what its own functions say of frames.
-- Arguments: the dissector, and a file with a line for each frame: link, direction, bytes in hexadecimal.

local stub = {}
setmetatable(stub, {
    __index = function() return stub end,
    __newindex = function() end,
    __call = function() return stub end,
})
for _, name in ipairs({
    "Proto", "ProtoField", "ProtoExpert", "Pref", "DissectorTable", "Dissector", "Field", "NSTime", "ByteArray",
    "base", "ftypes", "frametype", "expert", "register_postdissector", "set_plugin_info",
}) do
    _G[name] = stub
end

-- Numbers of 64 bits, of which decimal digits of a checksum are made.
UInt64 = { new = function(low, high) return string.format("%.0f", high * 4294967296 + low) end }

local file = assert(io.open(arg[1]))
local text = file:read("*a") .. "\nreturn { frames = frames, numbers = numbers, checksums = checksums, device = device }\n"
local program = assert(load(text, "=dissector"))()

local function bytes_of(digits)
    return (digits:gsub("..", function(pair) return string.char(tonumber(pair, 16)) end))
end

for line in io.lines(arg[2]) do
    local link_name, direction, digits = line:match("^(%S+) (%S+) (%S+)$")
    local link, bytes = program.device.links[link_name], bytes_of(digits)
    local length = program.frames.length(link, direction, bytes, nil, nil)
    local numbers = {}
    for _, part in ipairs(link[direction].parts) do
        local at = part.offset >= 0 and part.offset or #bytes + part.offset
        local own = bytes:sub(at + 1, at + part.size)
        if part.value and #own == part.size then
            numbers[#numbers + 1] = program.numbers.text(program.numbers.of(own, part.value))
        end
    end
    print(tostring(program.frames.fits(link, direction, bytes, nil, nil)), length or "-", table.concat(numbers, " "))
end
