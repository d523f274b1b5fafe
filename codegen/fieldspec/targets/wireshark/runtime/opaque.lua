-- Data that this file does not decode: they are shown as bytes.

local show_decoded = records.show

function records.show(context, tree, record, start, stop)
    if not record.is_opaque then
        show_decoded(context, tree, record, start, stop)
        return
    end
    local size = stop - start
    if size > 0 then
        tree:add(fields[device.common.opaque], context:range(start, size))
    end
    if size < record.least then
        values.report(tree, "incomplete", "bytes are missing")
    elseif record.most and size > record.most then
        values.report(tree, "wrong_length", (size - record.most) .. " bytes too many")
    end
end
