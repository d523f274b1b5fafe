"""Stand-ins of the vendors' blocks: each keeps the rules of its documentation, and ends as the test says.

`Answer` is the code with which a block ends, 0 where all is well; the other variables after VAR are for the test too.
Buffers that a vendor takes by a pointer are lent. What arrives on a line lies in `Line`: of its bytes, `Arrived` have
come and `Taken` are read.
"""

from __future__ import annotations

REQUEST = """
FUNCTION_BLOCK ModbusRequest (* IoDrvModbus *)
VAR_INPUT hComPort : UDINT; xExecute : BOOL; usiSlaveAddr : USINT; uiFunctionCode : UINT; uiReadOffset : UINT;
uiReadLen : UINT; uiWriteOffset : UINT; uiWriteLen : UINT; tTimeout : TIME; END_VAR
VAR_IN_OUT pWriteBuf : ARRAY[0..124] OF WORD; pReadBuf : ARRAY[0..124] OF WORD; END_VAR
VAR_OUTPUT xBusy : BOOL; xDone : BOOL; xError : BOOL; byModbusErrorCode : BYTE; END_VAR
VAR Answer : INT; Requests : INT; Code : INT; First : WORD; Before : BOOL; Rest : INT; END_VAR
IF xExecute AND NOT Before THEN
  Requests := Requests + 1; xBusy := TRUE; Rest := 3; Code := UINT_TO_INT(uiFunctionCode); First := pWriteBuf[0];
ELSIF NOT xExecute THEN
  xDone := FALSE; xError := FALSE; xBusy := FALSE;
END_IF;
Before := xExecute;
IF xBusy THEN
  Rest := Rest - 1;
  IF Rest = 0 THEN
    xBusy := FALSE; xDone := Answer = 0; xError := Answer <> 0; byModbusErrorCode := INT_TO_BYTE(Answer);
    IF Answer <> 0 THEN pReadBuf[0] := WORD#16#BAD0;
    ELSIF uiFunctionCode = 3 THEN pReadBuf[0] := WORD#16#1234; END_IF;
  END_IF;
END_IF;
END_FUNCTION_BLOCK
"""
"""The outputs stay until xExecute falls. Where another station answers, its words may lie in the buffer."""

RTU_MASTER = """
FUNCTION_BLOCK ModbusRtuMasterV2_KL6x22B (* Tc2_ModbusRTU; each action is a function code *)
VAR_INPUT FunctionCode : INT; UnitID : BYTE; Quantity : WORD; MBAddr : WORD; cbLength : UINT; Execute : BOOL;
Timeout : TIME; END_VAR
VAR_IN_OUT pMemoryAddr : ARRAY[0..124] OF WORD; END_VAR
VAR_OUTPUT BUSY : BOOL; Error : BOOL; ErrorId : INT; cbRead : UINT; END_VAR
VAR Answer : INT; Requests : INT; Code : INT; First : WORD; Before : BOOL; Rest : INT; END_VAR
IF Execute AND NOT Before THEN
  Requests := Requests + 1; BUSY := TRUE; Error := FALSE; ErrorId := 0; Rest := 3;
  Code := FunctionCode; First := pMemoryAddr[0];
ELSIF BUSY THEN
  Rest := Rest - 1;
  IF Rest = 0 THEN
    BUSY := FALSE; Error := Answer <> 0; ErrorId := Answer;
    IF Answer <> 0 THEN pMemoryAddr[0] := WORD#16#BAD0;
    ELSIF FunctionCode = 3 THEN pMemoryAddr[0] := WORD#16#1234; END_IF;
  END_IF;
END_IF;
Before := Execute;
END_FUNCTION_BLOCK
"""
"""BUSY is TRUE in the call with the edge."""

COMM_LOAD = """
FUNCTION_BLOCK Modbus_Comm_Load
VAR_INPUT REQ : BOOL; PORT : WORD; BAUD : UDINT; PARITY : UINT; RESP_TO : UINT;
MODE : USINT := 0; RETRIES : WORD := WORD#16#0002; LINE_PRE : USINT := 0; STOP_BITS : USINT := 1; END_VAR
VAR_OUTPUT DONE : BOOL; ERROR : BOOL; STATUS : WORD := WORD#16#7000; END_VAR
VAR Answer : WORD; Requests : INT; Before : BOOL; Rest : INT; END_VAR
DONE := FALSE; ERROR := FALSE; STATUS := WORD#16#7000;
IF REQ AND NOT Before THEN Requests := Requests + 1; Rest := 4; END_IF;
Before := REQ;
IF Rest > 0 THEN
  Rest := Rest - 1; STATUS := WORD#16#7002;
  IF Rest = 0 THEN
    DONE := Answer = WORD#16#0000; ERROR := Answer <> WORD#16#0000; STATUS := Answer;
  END_IF;
END_IF;
END_FUNCTION_BLOCK
"""
"""The values at the inputs are those of its instance data block; MODE and RETRIES are static there."""

S7_MASTER = """
FUNCTION_BLOCK Modbus_Master
VAR_INPUT REQ : BOOL; MB_ADDR : UINT; MODE : USINT; DATA_ADDR : UDINT; DATA_LEN : UINT; END_VAR
VAR_IN_OUT DATA_PTR : ARRAY[0..124] OF WORD; END_VAR
VAR_OUTPUT DONE : BOOL; BUSY : BOOL; ERROR : BOOL; STATUS : WORD; END_VAR
VAR Answer : WORD; Requests : INT; Code : INT; First : WORD; Rest : INT; END_VAR
DONE := FALSE; ERROR := FALSE; STATUS := WORD#16#0000;
IF BUSY THEN
  Rest := Rest - 1; STATUS := WORD#16#7002;
  IF Rest = 0 THEN
    BUSY := FALSE; DONE := Answer = WORD#16#0000; ERROR := Answer <> WORD#16#0000; STATUS := Answer;
    IF ERROR THEN DATA_PTR[0] := WORD#16#BAD0;
    ELSIF MODE = 0 THEN DATA_PTR[0] := WORD#16#1234; END_IF;
  END_IF;
ELSIF REQ THEN
  Requests := Requests + 1; BUSY := TRUE; Rest := 3; STATUS := WORD#16#7001; First := DATA_PTR[0];
  Code := 3;
  IF MODE <> 0 THEN
    Code := 16;
    IF (MODE = 1) AND (DATA_LEN = 1) THEN Code := 6; END_IF;
  END_IF;
END_IF;
END_FUNCTION_BLOCK
"""
"""DONE, ERROR and STATUS are valid in one call only. REQ is a level: it sends again after the end."""

CAA = """
FUNCTION_BLOCK ComOpen
VAR_INPUT xExecute : BOOL; usiListLength : USINT; END_VAR
VAR_OUTPUT xDone : BOOL; xError : BOOL; eError : UINT; hCom : UDINT; END_VAR
VAR Answer : UINT; Requests : INT; Before : BOOL; END_VAR
IF NOT xExecute THEN xDone := FALSE; xError := FALSE; eError := 0;
ELSIF NOT Before THEN
  Requests := Requests + 1; xDone := Answer = 0; xError := Answer <> 0; eError := Answer; hCom := 7;
END_IF;
Before := xExecute;
END_FUNCTION_BLOCK
FUNCTION_BLOCK ComClose
VAR_INPUT xExecute : BOOL; hCom : UDINT; END_VAR
VAR_OUTPUT xDone : BOOL; xError : BOOL; eError : UINT; END_VAR
VAR Answer : UINT; Requests : INT; Before : BOOL; END_VAR
IF NOT xExecute THEN xDone := FALSE; xError := FALSE; eError := 0;
ELSIF NOT Before THEN Requests := Requests + 1; xDone := Answer = 0; xError := Answer <> 0; eError := Answer;
END_IF;
Before := xExecute;
END_FUNCTION_BLOCK
FUNCTION_BLOCK ComWrite
VAR_INPUT xExecute : BOOL; hCom : UDINT; szSize : UDINT; udiTimeOut : UDINT; END_VAR
VAR_IN_OUT pBuffer : ARRAY[0..254] OF BYTE; END_VAR
VAR_OUTPUT xDone : BOOL; xError : BOOL; eError : UINT; END_VAR
VAR Answer : UINT; Requests : INT; Before : BOOL; Busy : BOOL; END_VAR
IF NOT xExecute THEN xDone := FALSE; xError := FALSE; eError := 0; Busy := FALSE;
ELSIF NOT Before THEN Busy := TRUE;
ELSIF Busy THEN
  Busy := FALSE; Requests := Requests + 1; xDone := Answer = 0; xError := Answer <> 0; eError := Answer;
END_IF;
Before := xExecute;
END_FUNCTION_BLOCK
FUNCTION_BLOCK ComRead
VAR_INPUT xExecute : BOOL; hCom : UDINT; szBuffer : UDINT; udiTimeOut : UDINT; END_VAR
VAR_IN_OUT pBuffer : ARRAY[0..254] OF BYTE; END_VAR
VAR_OUTPUT xDone : BOOL; xError : BOOL; eError : UINT; szSize : UDINT; END_VAR
VAR Answer : UINT; Waits : BOOL; Line : ARRAY[0..254] OF BYTE; Arrived : INT; Taken : INT; Before : BOOL; Busy : BOOL;
Place : INT; Micros : UDINT; END_VAR
IF NOT xExecute THEN xDone := FALSE; xError := FALSE; eError := 0; szSize := 0; Busy := FALSE;
ELSIF NOT Before THEN Busy := TRUE; Micros := 0;
ELSIF Busy THEN
  Micros := Micros + 5000;
  IF Answer <> 0 THEN Busy := FALSE; xError := TRUE; eError := Answer;
  ELSIF Arrived > Taken THEN
    FOR Place := Taken TO Arrived - 1 DO pBuffer[Place - Taken] := Line[Place]; END_FOR;
    Busy := FALSE; xDone := TRUE; szSize := INT_TO_UDINT(Arrived - Taken); Taken := Arrived;
  ELSIF NOT Waits THEN Busy := FALSE; xDone := TRUE;
  ELSIF Micros >= udiTimeOut THEN Busy := FALSE; xError := TRUE; eError := 5001;
  END_IF;
END_IF;
Before := xExecute;
END_FUNCTION_BLOCK
"""
"""CAA SerialCom. Without data COM.Read is done with no bytes, or where it `Waits`, ends with the time-out 5001."""

SERIAL = """
FUNCTION_BLOCK ClearComBuffer
VAR_INPUT Unused : BOOL; END_VAR VAR_OUTPUT Calls : INT; END_VAR Calls := Calls + 1; END_FUNCTION_BLOCK
FUNCTION_BLOCK SendByteBlock
VAR_INPUT SendByte : BYTE; END_VAR VAR_OUTPUT Busy : BOOL; Error : INT; END_VAR
VAR Answer : INT; Full : BOOL; Requests : INT; END_VAR
Busy := Full; Error := Answer;
IF NOT Busy AND (Error = 0) THEN Requests := Requests + 1; END_IF;
END_FUNCTION_BLOCK
FUNCTION_BLOCK ReceiveByteBlock
VAR_INPUT Unused : BOOL; END_VAR VAR_OUTPUT ByteReceived : BOOL; ReceivedByte : BYTE; Error : INT; END_VAR
VAR Answer : INT; Line : ARRAY[0..254] OF BYTE; Arrived : INT; Taken : INT; END_VAR
ByteReceived := Arrived > Taken; Error := Answer;
IF ByteReceived THEN ReceivedByte := Line[Taken]; Taken := Taken + 1; END_IF;
END_FUNCTION_BLOCK
FUNCTION_BLOCK SerialLineControl
VAR_INPUT Mode : INT; SizeComIn : INT; END_VAR VAR_OUTPUT Error : BOOL; ErrorID : INT; END_VAR
VAR Answer : INT; END_VAR
Error := Answer <> 0; ErrorID := Answer;
END_FUNCTION_BLOCK
"""
"""Tc2_SerialCom: a byte a call, several calls a cycle; a byte is in the buffer where Busy is FALSE and Error 0."""

POINT_TO_POINT = """
FUNCTION_BLOCK Port_Config
VAR_INPUT REQ : BOOL; PORT : WORD; BAUD : UINT; PARITY : UINT; DATABITS : UINT; STOPBITS : UINT; MODE : USINT; END_VAR
VAR_OUTPUT DONE : BOOL; ERROR : BOOL; STATUS : WORD; END_VAR
VAR Answer : WORD; Requests : INT; Before : BOOL; Rest : INT; END_VAR
DONE := FALSE; ERROR := FALSE; STATUS := WORD#16#7000;
IF REQ AND NOT Before THEN Requests := Requests + 1; Rest := 3; END_IF;
Before := REQ;
IF Rest > 0 THEN
  Rest := Rest - 1;
  IF Rest = 0 THEN DONE := Answer = WORD#16#0000; ERROR := NOT DONE; STATUS := Answer; END_IF;
END_IF;
END_FUNCTION_BLOCK
FUNCTION_BLOCK Receive_Reset
VAR_INPUT REQ : BOOL; PORT : WORD; END_VAR VAR_OUTPUT DONE : BOOL; ERROR : BOOL; STATUS : WORD; END_VAR
VAR Answer : WORD; Requests : INT; Before : BOOL; Rest : INT; END_VAR
DONE := FALSE; ERROR := FALSE; STATUS := WORD#16#7000;
IF REQ AND NOT Before THEN Requests := Requests + 1; Rest := 2; END_IF;
Before := REQ;
IF Rest > 0 THEN
  Rest := Rest - 1;
  IF Rest = 0 THEN DONE := Answer = WORD#16#0000; ERROR := NOT DONE; STATUS := Answer; END_IF;
END_IF;
END_FUNCTION_BLOCK
FUNCTION_BLOCK Send_P2P
VAR_INPUT REQ : BOOL; PORT : WORD; LENGTH : UINT; END_VAR
VAR_IN_OUT BUFFER : ARRAY[0..243] OF BYTE; END_VAR
VAR_OUTPUT DONE : BOOL; ERROR : BOOL; STATUS : WORD; END_VAR
VAR Answer : WORD; Requests : INT; Before : BOOL; Rest : INT; END_VAR
DONE := FALSE; ERROR := FALSE; STATUS := WORD#16#7000;
IF REQ AND NOT Before THEN Requests := Requests + 1; Rest := 2; END_IF;
Before := REQ;
IF Rest > 0 THEN
  Rest := Rest - 1;
  IF Rest = 0 THEN DONE := Answer = WORD#16#0000; ERROR := NOT DONE; STATUS := Answer; END_IF;
END_IF;
END_FUNCTION_BLOCK
FUNCTION_BLOCK Receive_P2P
VAR_INPUT PORT : WORD; END_VAR
VAR_IN_OUT BUFFER : ARRAY[0..243] OF BYTE; END_VAR
VAR_OUTPUT NDR : BOOL; ERROR : BOOL; STATUS : WORD; LENGTH : UINT; END_VAR
VAR Answer : WORD; Line : ARRAY[0..254] OF BYTE; Arrived : INT; Taken : INT; Place : INT; END_VAR
NDR := FALSE; ERROR := FALSE; STATUS := WORD#16#0000; LENGTH := 0;
IF Answer <> WORD#16#0000 THEN ERROR := TRUE; STATUS := Answer;
ELSIF Arrived > Taken THEN
  FOR Place := Taken TO Arrived - 1 DO BUFFER[Place - Taken] := Line[Place]; END_FOR;
  NDR := TRUE; LENGTH := INT_TO_UINT(Arrived - Taken); STATUS := WORD#16#0096; Taken := Arrived;
END_IF;
END_FUNCTION_BLOCK
"""
"""A frame is whole when it `Arrived`. Outputs are valid in one call only; STATUS 0096 is an end by a character gap."""

ALL = REQUEST + RTU_MASTER + COMM_LOAD + S7_MASTER + CAA + SERIAL + POINT_TO_POINT
