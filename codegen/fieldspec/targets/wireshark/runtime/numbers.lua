-- Numbers in bytes: byte and word orders, bits, and whole numbers of up to 64 bits.

local numbers = {}

-- Lua 5.2 has bit32, Wireshark brings BitOp, and Lua 5.4 has operators; all of them take numbers of 32 bits here.
local band, bxor, lshift, rshift
if bit32 then
    band, bxor, lshift, rshift = bit32.band, bit32.bxor, bit32.lshift, bit32.rshift
else
    local operators = [[
        local M = 0xFFFFFFFF
        return function(a, b) return a & b end, function(a, b) return a ~ b end,
            function(a, n) return n > 31 and 0 or a << n & M end, function(a, n) return n > 31 and 0 or a >> n end
    ]]
    band, bxor, lshift, rshift = load(operators)()
end
numbers.band, numbers.bxor, numbers.lshift, numbers.rshift = band, bxor, lshift, rshift

-- The bytes of a value with the most significant one first. With `swapped`, the order of the 16-bit words is the
-- opposite of the order of the bytes in each.
function numbers.significant(bytes, value)
    if value.swapped then
        bytes = bytes:gsub("(.)(.)", "%2%1")
    end
    if (value.order == "little") ~= (value.swapped == true) then
        bytes = bytes:reverse()
    end
    return bytes
end

-- The bytes of the number of a part alone, where it shares them with other parts: `width` bits from `shift` on.
function numbers.alone(bytes, part)
    if not part.width then
        return bytes
    end
    local own = part.order == "little" and bytes or bytes:reverse()
    local first, shift, result = math.floor(part.shift / 8), part.shift % 8, {}
    for place = 1, #own do
        local low, high = own:byte(first + place) or 0, own:byte(first + place + 1) or 0
        local left = math.max(0, math.min(8, part.width - 8 * (place - 1)))
        result[place] = string.char(band(rshift(low + 256 * high, shift), lshift(1, left) - 1))
    end
    local joined = table.concat(result)
    return part.order == "little" and joined or joined:reverse()
end

-- The hexadecimal digits of a value.
function numbers.hexadecimal(bytes, value)
    local ordered = numbers.significant(bytes, value)
    return "0x" .. ordered:gsub(".", function(char) return string.format("%02x", char:byte()) end)
end

-- An unsigned number of up to six bytes, the most significant one first.
function numbers.unsigned(bytes)
    local number = 0
    for at = 1, #bytes do
        number = number * 256 + bytes:byte(at)
    end
    return number
end

-- How a value shows that it is below zero: not at all, in two's complement, or by its highest bit alone.
local function sign_of(value)
    local sign = value.signed or "none"
    if sign ~= "none" and sign ~= true and sign ~= "magnitude" then
        error("unknown sign: " .. tostring(sign))
    end
    return sign
end

-- A whole number as an Int64 or UInt64 of Wireshark, from its bytes, the most significant one first.
local function long(ordered, value)
    local sign, is_high, fill = sign_of(value), ordered:byte(1) > 127, "\0"
    if sign == true and is_high then
        fill = "\255"
    elseif sign == "magnitude" and is_high then
        ordered = string.char(ordered:byte(1) - 128) .. ordered:sub(2)
    end
    local filled = fill:rep(8 - #ordered) .. ordered
    local class = sign == "none" and UInt64 or Int64
    local number = class.new(numbers.unsigned(filled:sub(5)), numbers.unsigned(filled:sub(1, 4)))
    return sign == "magnitude" and is_high and -number or number
end

-- The number of half precision of two bytes, the most significant one first.
local function half(ordered)
    local bits = numbers.unsigned(ordered)
    local exponent, fraction = math.floor(bits / 1024) % 32, bits % 1024
    local size = (exponent == 0 and fraction or fraction + 1024) * 2 ^ (math.max(exponent, 1) - 25)
    if exponent == 31 then
        size = fraction == 0 and math.huge or 0 / 0
    end
    return bits >= 32768 and -size or size
end

-- The floating-point number of bytes, the most significant one first.
local function real(ordered)
    if #ordered == 2 then
        return half(ordered)
    end
    local form = ({ [4] = ">f", [8] = ">d" })[#ordered]
    if not form then
        error("no floating-point number has " .. #ordered .. " bytes")
    end
    return (Struct.unpack(form, ordered))
end

local NUMBERS = { float = "real", integer = "whole", boolean = "whole", text = false, bytes = false }

local function number_kind(value)
    local kind = NUMBERS[value.kind]
    if kind == nil then
        error("unknown kind: " .. tostring(value.kind))
    end
    return kind
end

-- Whether a value is a number, and no text and no bytes.
function numbers.is_number(value)
    return number_kind(value) ~= false
end

local function is_real(value)
    local kind = number_kind(value)
    if not kind then
        error("a text or bytes are not a number")
    end
    return kind == "real"
end

local byte = string.byte

-- The functions that read the commonest values, by their bytes and whether the most significant one comes first.
local COMMON = {
    [1] = { [true] = byte, [false] = byte },
    [2] = {
        [true] = function(bytes) local a, b = byte(bytes, 1, 2) return a * 256 + b end,
        [false] = function(bytes) local a, b = byte(bytes, 1, 2) return b * 256 + a end,
    },
}

-- The function that reads a value.
local function reader_of(value)
    local sign, common = sign_of(value), COMMON[value.size]
    if is_real(value) then
        return function(bytes) return real(numbers.significant(bytes, value)) end
    end
    if value.size > 6 then
        return function(bytes) return long(numbers.significant(bytes, value), value) end
    end
    if common and sign == "none" then
        return common[(value.order == "little") == (value.swapped == true)]
    end
    return function(bytes)
        local ordered = numbers.significant(bytes, value)
        local number = numbers.unsigned(ordered)
        if sign ~= "none" and ordered:byte(1) > 127 then
            return sign == true and number - 256 ^ #ordered or 256 ^ #ordered / 2 - number
        end
        return number
    end
end

-- The number of a value: a Lua number, or an Int64 or UInt64 of Wireshark for more than six bytes.
function numbers.of(bytes, value)
    local read = value.read
    if not read then
        read = reader_of(value)
        value.read = read
    end
    return read(bytes)
end

-- The bytes of a number of at most six bytes, which its value can have, the most significant one first.
function numbers.bytes(number, value)
    if number < 0 then
        number = sign_of(value) == "magnitude" and 256 ^ value.size / 2 - number or number + 256 ^ value.size
    end
    local bytes = {}
    for place = value.size, 1, -1 do
        bytes[place] = string.char(math.floor(number % 256))
        number = math.floor(number / 256)
    end
    return table.concat(bytes)
end

-- The number of a value as its item takes it: fields of more than 32 bits take no Lua number.
function numbers.of_item(bytes, value)
    if not is_real(value) and #bytes > 4 then
        return long(numbers.significant(bytes, value), value)
    end
    return numbers.of(bytes, value)
end

-- A bound, a constant or another number of a spec: those of more than six bytes are texts of 16 hexadecimal digits.
function numbers.bound(number, value)
    if type(number) == "string" then
        return (value.signed and Int64 or UInt64).fromhex(number)
    end
    return number
end

-- A code as data have it: one of more than six bytes is 16 hexadecimal digits, whatever part it comes from.
local function code_of(high, low)
    return high < 65536 and high * 2 ^ 32 + low or string.format("%08x%08x", high, low)
end

local function halves_of(code)
    if type(code) == "string" then
        return tonumber(code:sub(1, 8), 16), tonumber(code:sub(9), 16)
    end
    return math.floor(code / 2 ^ 32), code % 2 ^ 32
end

-- The code in the bytes of a value.
function numbers.code(bytes, value)
    local ordered = ("\0"):rep(8 - #bytes) .. numbers.significant(bytes, value)
    return code_of(numbers.unsigned(ordered:sub(1, 4)), numbers.unsigned(ordered:sub(5)))
end

-- A code without the bits of a flag.
function numbers.without(code, flag)
    local high, low = halves_of(code)
    local flag_high, flag_low = halves_of(flag)
    return code_of(high - band(high, flag_high), low - band(low, flag_low))
end

-- A number as text and as key of tables: no exponent, no decimal point for whole numbers.
function numbers.text(number)
    if type(number) ~= "number" then
        return tostring(number)
    end
    if number ~= number then
        return "NaN"
    end
    if number == math.floor(number) and number > -2 ^ 53 and number < 2 ^ 53 then
        return string.format("%.0f", number)
    end
    return string.format("%.9g", number)
end

-- The bits of a word that a field of bits consists of, the least significant first: runs of adjacent bits.
function numbers.bit_places(bit)
    local places = {}
    for _, run in ipairs(bit.runs or { { bit.first, bit.width } }) do
        for place = run[1], run[1] + run[2] - 1 do
            places[#places + 1] = place
        end
    end
    return places
end

-- The bits at the places `first` to `last` of a list, in the bytes of a number, the most significant byte first.
function numbers.bits(ordered, places, first, last)
    local number, weight = 0, 1
    for index = first, last do
        local place = places[index]
        local byte = ordered:byte(#ordered - math.floor(place / 8))
        if byte and band(rshift(byte, place % 8), 1) == 1 then
            number = number + weight
        end
        weight = weight * 2
    end
    return number
end

-- A number as a double, which does not hold all bits of a long one.
function numbers.double(number)
    return type(number) == "number" and number or number:tonumber()
end

local MOST_DIGITS = 60

-- (count * factor + shift) / divisor, exactly where that takes at most 60 decimals, with at least `places` decimals. All numbers are whole.
-- Nil where a double cannot hold the terms. The count is a double.
function numbers.quotient(count, scale)
    local above = count * scale.factor + scale.shift
    if math.abs(above) >= 2 ^ 53 or math.abs(count * scale.factor) >= 2 ^ 53 or scale.divisor >= 2 ^ 49 then
        return nil
    end
    local sign = above < 0 and "-" or ""
    above = math.abs(above)
    local rest = above % scale.divisor
    local text = sign .. string.format("%.0f", (above - rest) / scale.divisor)
    local digits = {}
    while rest > 0 and #digits < MOST_DIGITS or #digits < scale.places do
        local digit = math.floor(rest * 10 / scale.divisor)
        rest = rest * 10 - digit * scale.divisor
        digits[#digits + 1] = string.format("%.0f", digit)
    end
    return #digits > 0 and text .. "." .. table.concat(digits) or text
end

-- The same as text, approximate where a double cannot hold the terms, and as a number.
function numbers.fraction(count, scale)
    local approximate = (count * scale.factor + scale.shift) / scale.divisor
    return numbers.quotient(count, scale) or "about " .. string.format("%.15g", approximate), approximate
end
