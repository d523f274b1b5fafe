-- Checksums: CRCs, sums, xors and Fletcher checksums of up to 64 bits, as pairs of the upper and the lower 32 bits.

local checksums = {}

local FULL = 2 ^ 32

local function right(high, low)
    return numbers.rshift(high, 1), numbers.rshift(low, 1) + numbers.band(high, 1) * 2 ^ 31
end

local function left(high, low)
    return numbers.lshift(high, 1) + numbers.rshift(low, 31), numbers.lshift(low, 1)
end

-- The same bits in the opposite order, of a number of `width` bits.
local function reflected(high, low, width)
    local to_high, to_low = 0, 0
    for _ = 1, width do
        local lowest = numbers.band(low, 1)
        high, low = right(high, low)
        to_high, to_low = left(to_high, to_low)
        to_low = to_low + lowest
    end
    return to_high, to_low
end

-- A CRC bit by bit. The register of one that is reflected begins at its lowest bit, else at the highest of 64.
local function crc_of_bits(kind, bytes, high, low)
    for at = 1, #bytes do
        local byte = bytes:byte(at)
        if kind.reflect_in then
            low = numbers.bxor(low, byte)
        else
            high = numbers.bxor(high, numbers.lshift(byte, 24))
        end
        for _ = 1, 8 do
            local out
            if kind.reflect_in then
                out = numbers.band(low, 1)
                high, low = right(high, low)
            else
                out = numbers.rshift(high, 31)
                high, low = left(high, low)
            end
            if out == 1 then
                high, low = numbers.bxor(high, kind.polynomial[1]), numbers.bxor(low, kind.polynomial[2])
            end
        end
    end
    return high, low
end

-- The register of a CRC of at most 32 bits after each byte alone: the half of the 64 bits that it is in.
local function table_of(kind)
    local list = {}
    for number = 0, 255 do
        local high, low = crc_of_bits(kind, string.char(number), 0, 0)
        list[number] = kind.reflect_in and low or high
    end
    return list
end

-- The same by a table, a byte at a time.
local function crc_of_bytes(kind, bytes, high, low)
    local list, band, bxor, lshift, rshift = kind.list, numbers.band, numbers.bxor, numbers.lshift, numbers.rshift
    for at = 1, #bytes do
        if kind.reflect_in then
            low = bxor(list[band(bxor(low, bytes:byte(at)), 255)], rshift(low, 8))
        else
            high = bxor(list[bxor(rshift(high, 24), bytes:byte(at))], lshift(high, 8))
        end
    end
    return high, low
end

local function crc(kind, bytes)
    local high, low = kind.initial[1], kind.initial[2]
    if kind.width <= 32 then
        kind.list = kind.list or table_of(kind)
        high, low = crc_of_bytes(kind, bytes, high, low)
    else
        high, low = crc_of_bits(kind, bytes, high, low)
    end
    if not kind.reflect_in then
        for _ = 1, 64 - kind.width do
            high, low = right(high, low)
        end
    end
    if kind.reflect_in ~= kind.reflect_out then
        high, low = reflected(high, low, kind.width)
    end
    return numbers.bxor(high, kind.final[1]), numbers.bxor(low, kind.final[2])
end

-- The numbers of `unit_size` bytes; the last one is filled up with zeros after its bytes.
local function units(kind, bytes)
    local result = {}
    bytes = bytes .. ("\0"):rep(-#bytes % kind.unit_size)
    for at = 1, #bytes, kind.unit_size do
        local unit = bytes:sub(at, at + kind.unit_size - 1)
        unit = ("\0"):rep(8 - #unit) .. (kind.order == "little" and unit:reverse() or unit)
        result[#result + 1] = { numbers.unsigned(unit:sub(1, 4)), numbers.unsigned(unit:sub(5)) }
    end
    return result
end

-- Two sums modulo `modulus`: that of the numbers, which have no more than 32 bits, and that of all values of the first.
local function fletcher(kind, bytes)
    local upper, lower = kind.initial[1], kind.initial[2]
    for _, unit in ipairs(units(kind, bytes)) do
        lower = (lower + unit[2]) % kind.modulus
        upper = (upper + lower) % kind.modulus
    end
    local half = 2 ^ (kind.width / 2)
    local above = FULL / half
    return math.floor(upper / above), upper % above * half + lower
end

-- A sum or an xor over numbers of `unit_size` bytes.
local function total(kind, bytes)
    local high, low = kind.initial[1], kind.initial[2]
    for _, unit in ipairs(units(kind, bytes)) do
        local more_high, more_low = unit[1], unit[2]
        if kind.method == "sum" then
            local sum = low + more_low
            high, low = (high + more_high + math.floor(sum / FULL)) % FULL, sum % FULL
        else
            high, low = numbers.bxor(high, more_high), numbers.bxor(low, more_low)
        end
    end
    if kind.complement then
        high, low = FULL - 1 - high, FULL - 1 - low
        if kind.complement == "twos" then
            local sum = low + 1
            high, low = (high + math.floor(sum / FULL)) % FULL, sum % FULL
        end
    end
    return numbers.band(high, kind.mask[1]), numbers.band(low, kind.mask[2])
end

-- The bytes of numbers of `unit_size` bytes, the last byte of each first; the last number is filled up with zeros.
local function swapped(kind, bytes)
    local result = {}
    bytes = bytes .. ("\0"):rep(-#bytes % kind.unit_size)
    for at = 1, #bytes, kind.unit_size do
        result[#result + 1] = bytes:sub(at, at + kind.unit_size - 1):reverse()
    end
    return table.concat(result)
end

-- The bytes of a checksum with others in place of those that must not occur.
local function without_avoided(kind, number)
    local replacements = {}
    for _, pair in ipairs(kind.replacements or {}) do
        replacements[string.char(pair[1])] = string.char(pair[2])
    end
    return (number:gsub(".", replacements))
end

-- The bytes of a checksum part over some bytes, as they are sent.
function checksums.bytes(part, bytes)
    local kind = part.algorithm
    if kind.suffix then
        bytes = bytes .. string.char((table.unpack or unpack)(kind.suffix))
    end
    local high, low
    if kind.method == "crc" then
        high, low = crc(kind, kind.unit_size and swapped(kind, bytes) or bytes)
    elseif kind.method == "fletcher" then
        high, low = fletcher(kind, bytes)
    else
        high, low = total(kind, bytes)
    end
    local digits = string.format("%08x", high) .. string.format("%08x", low)
    if part.digits then
        local text = digits
        if part.digits == "decimal" then
            text = ("0"):rep(part.size) .. tostring(UInt64.new(low, high))
        elseif part.digits == "upper_hex" then
            text = digits:upper()
        end
        return text:sub(-part.size)
    end
    local number = digits:gsub("%x%x", function(pair) return string.char(tonumber(pair, 16)) end)
    number = without_avoided(kind, number:sub(-part.size))
    return part.order == "little" and number:reverse() or number
end

-- The bytes that a checksum covers: a slice of all parts; negative bounds count from the end.
function checksums.covered(part, parts)
    local first = part.start >= 0 and part.start or #parts + part.start
    local last = part.stop == nil and #parts or part.stop >= 0 and part.stop or #parts + part.stop
    return parts:sub(first + 1, last)
end
