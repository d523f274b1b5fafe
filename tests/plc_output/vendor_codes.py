"""The codes of the vendors' blocks, and the ErrorID that each must become.

They are those of the vendors' documentation, but those of Send_P2P, Port_Config, DPRD_DAT and DPWR_DAT are not all
confirmed there.

2 no answer in time, 3 damaged, 4 another station, 5 another request, 6 the device refuses, 7 the port.
"""

from __future__ import annotations

IO_DRV_MODBUS = {
    **dict.fromkeys((1, 2, 3, 4, 5, 6, 8, 0x0A, 0x0B), 6),
    0xA1: 2,
    0xA2: 3,
    0xA3: 4,
    0xA4: 5,
    0xA5: 7,
    0xA6: 3,
    0xA7: 3,
    0xA8: 3,
    0xA9: 7,
    0xFF: 7,
}
"""MB_ErrorCodes of IoDrvModbus 4.5: exceptions, no response, CRC, slave, function code, not sent, data, protocol,
header, parameter, undefined."""

MODBUS_ERRORS = {
    **dict.fromkeys((1, 2, 3, 4, 5, 6, 7, 8, 0x0A, 0x0B), 6),
    0x20: 2,
    0x21: 3,
    0x22: 4,
    0x23: 7,
    0x24: 7,
    0x25: 2,
    102: 7,
    103: 7,
    107: 7,
    110: 7,
    120: 7,
    150: 3,
    232: 7,
    233: 7,
}
"""MODBUS_ERRORS of Tc2_ModbusRTU 1.4: exceptions, then CHARREC_TIMEOUT, ILLEGAL_DATA_SIZE, ILLEGAL_DEVICE_ADDRESS,
ILLEGAL_DESTINATION_ADDRESS, _SIZE, NO_RESPONSE, TXBUFFOVERRUN, SENDTIMEOUT, DATASIZEOVERRUN, STRINGOVERRUN,
INVALIDPOINTER, CRC, INVALIDMEMORYADDRESS, TRANSMITBUFFERTOOSMALL."""

MODBUS_MASTER = {
    0x80C8: 2,
    0x80C9: 2,
    0x80D1: 7,
    0x80D2: 7,
    0x80E0: 7,
    0x80E1: 3,
    0x80E2: 3,
    0x80E3: 3,
    0x80E4: 3,
    **dict.fromkeys((0x8180, 0x8186, 0x8188, 0x8189, 0x818A, 0x818B, 0x818C, 0x818D), 7),
    **dict.fromkeys((0x8200, 0x8280, 0x8281, 0x8282), 7),
    0x8380: 3,
    0x8381: 6,
    0x8382: 6,
    0x8383: 6,
    0x8384: 6,
    0x8385: 6,
    0x8386: 5,
    0x8387: 4,
    0x8388: 5,
    0x8FFF: 7,
}
"""STATUS of Modbus_Master, "Error messages" in the help of TIA Portal."""

COMM_LOAD = (0x8180, 0x8181, 0x8182, 0x8183, 0x8184, 0x8280, 0x8281, 0x8282, 0x8FFF)
"""STATUS of Modbus_Comm_Load: MB_DB, rate, parity, flow control, response time, module."""

CAA_SERIAL_COM = (5002, 5003, 5004, 5005, 5006, 5050, 5099)
"""COM.ERROR but 5001: abort, handle, unknown, parameter, incomplete; the manufacturer's."""

COM_ERROR = (*(1, 2, 10, 11), *range(20, 25), 0x101, 0x102, *range(0x1001, 0x1009))
"""ComError_t of Tc2_SerialCom."""

RECEIVE_P2P = {
    0x8085: 7,
    0x8088: 3,
    0x8090: 7,
    0x81E0: 3,
    0x81E1: 3,
    0x81E2: 3,
    0x81E3: 3,
    0x81E4: 3,
    0x81E5: 7,
    0x81E6: 7,
    0x81E7: 7,
    0x81E8: 3,
    0x81EB: 3,
    0x8201: 7,
    0x8223: 7,
    0x8280: 7,
    0x8281: 7,
    0x8282: 7,
}
"""STATUS of Receive_P2P: a frame that is longer than the buffer is damaged, as one with a wrong parity is."""

# Of these, all are errors of the port.
SEND_P2P = (0x80D1, 0x80D2, 0x8085, 0x8088, 0x81F1, 0x8280, 0x8281, 0x8282)
PORT_CONFIG = (0x81A0, 0x81A1, 0x81A2, 0x81A3, 0x81A4, 0x81A5, 0x81A6, 0x8280, 0x8281, 0x8282)

DPRD_DAT = (0x8090, 0x8092, 0x8093, 0x80A0, 0x80B0, 0x80B1, 0x80B2, 0x80B3, 0x80C0, 0x80C2, 0x80F1, 0x8785)
DPWR_DAT = (0x8090, 0x8092, 0x8093, 0x80A1, 0x80B0, 0x80B1, 0x80B2, 0x80B3, 0x80C1, 0x80C2, 0x80F1, 0x8785)
"""RET_VAL of the calls for process data."""
