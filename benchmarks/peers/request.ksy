# Modbus RTU's request to read registers: 8 bytes.
meta: {id: request, endian: be}
seq:
  - {id: station, type: u1}
  - {id: function, type: u1}
  - {id: start, type: u2}
  - {id: count, type: u2}
  - {id: check, type: u2le}
