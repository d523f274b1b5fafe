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

-- An unsigned number of up to six bytes, the most significant one first.
function numbers.unsigned(bytes)
    local number = 0
    for at = 1, #bytes do
        number = number * 256 + bytes:byte(at)
    end
    return number
end

-- A whole number as an Int64 or UInt64 of Wireshark, from its bytes, the most significant one first.
local function long(ordered, value)
    local filled = (value.signed and ordered:byte(1) > 127 and "\255" or "\0"):rep(8 - #ordered) .. ordered
    local class = value.signed and Int64 or UInt64
    return class.new(numbers.unsigned(filled:sub(5)), numbers.unsigned(filled:sub(1, 4)))
end

-- The number of a value: a Lua number, or an Int64 or UInt64 of Wireshark for more than six bytes.
function numbers.of(bytes, value)
    local ordered = numbers.significant(bytes, value)
    if value.kind == "float" then
        return (Struct.unpack(#ordered == 8 and ">d" or ">f", ordered))
    end
    if #ordered > 6 then
        return long(ordered, value)
    end
    local number = numbers.unsigned(ordered)
    if value.signed and ordered:byte(1) > 127 then
        number = number - 256 ^ #ordered
    end
    return number
end

-- The number of a value as its item takes it: fields of more than 32 bits take no Lua number.
function numbers.of_item(bytes, value)
    if value.kind ~= "float" and #bytes > 4 then
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

-- The bits `first` to `first + width - 1` of the bytes of a number, the most significant byte first.
function numbers.bits(ordered, first, width)
    local number, weight = 0, 1
    for place = first, first + width - 1 do
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
