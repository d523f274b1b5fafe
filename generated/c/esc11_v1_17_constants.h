/*
 * ESC11-B (TAIYO), version 1.17
 * From: ESG1 series, RS485 communication, ESC11-B, instruction manual
 * Identity: 499facc7f5252c73
 *
 * Generated; do not edit. The constants of esc11_v1_17.h, which includes this file: a file that needs no functions compiles faster.
 */
#ifdef ESC11_CONSTANTS_INCLUDED
#ifndef ESC11_VERSION_IS_1_17
#error "another version of this device is already included"
#endif
#else
#define ESC11_CONSTANTS_INCLUDED
#define ESC11_VERSION_IS_1_17

#if defined(__cplusplus) && __cplusplus < 201103L && !defined(__STDC_CONSTANT_MACROS)
#define __STDC_CONSTANT_MACROS
#endif
#if defined(__cplusplus) && __cplusplus < 201103L && !defined(__STDC_LIMIT_MACROS)
#define __STDC_LIMIT_MACROS
#endif
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define ESC11_VERSION "1.17"
#define ESC11_IDENTITY "499facc7f5252c73"

#ifdef __GNUC__
/** An enum has 16 bits, even where the compiler makes enums as short as they can be: a cast of 256 does not become 0. */
#define ESC11_ENUM_16 __attribute__((__mode__(__HI__)))
#else
#define ESC11_ENUM_16
#endif

/* ---- Enums and codes ---- */

/**
 * The gripper that the controller drives, for parameter 0 and command 72h.
 * Printed as 执行器类型.
 * Other values may occur.
 * Note: Open, as the range of parameter 0 is wider than this table. A type that the controller does not know
 * brings up error 33h.
 * Source: 9.6.3 L1122-1129
 */
typedef enum esc11_actuator_type {
    ESC11_ACTUATOR_TYPE_SS_2010 = 110, /**< SS-2010 */
    ESC11_ACTUATOR_TYPE_SS_2005_3N = 111, /**< SS-2005-3N */
    ESC11_ACTUATOR_TYPE_SS_2005_5N = 112, /**< SS-2005-5N */
    ESC11_ACTUATOR_TYPE_ST_2013 = 118, /**< ST-2013 */
    ESC11_ACTUATOR_TYPE_ST_2004 = 119, /**< ST-2004 */
    ESC11_ACTUATOR_TYPE_SS_2815 = 120, /**< SS-2815 */
    ESC11_ACTUATOR_TYPE_ST_2820 = 129, /**< ST-2820 */
    ESC11_ACTUATOR_TYPE_SS_4225 = 130, /**< SS-4225 */
    ESC11_ACTUATOR_TYPE_ST_4230 = 139, /**< ST-4230 */
    ESC11_ACTUATOR_TYPE_SD_2005 = 210, /**< SD-2005 */
    ESC11_ACTUATOR_TYPE_SD_2810 = 220, /**< SD-2810 */
    ESC11_ACTUATOR_TYPE_SD_4220 = 230, /**< SD-4220 */
    ESC11_ACTUATOR_TYPE_FS_2020 = 310, /**< FS (FT) -2020 Also for FT-2020. */
    ESC11_ACTUATOR_TYPE_FS_2840 = 320 /**< FS (FT) -2840 Also for FT-2840. */
} ESC11_ENUM_16 esc11_actuator_type;

/**
 * Alarms (01h to 0Eh, table 10.3) and errors (20h to 33h, table 10.4).
 * Printed as 警报一览表.
 * Other values may occur.
 * Note: 0 is within the printed range of the codes that are read (10.1 L1209), and no table gives it a name.
 * Source: 10.3 L1292-1308; 10.4 L1310-1326
 */
typedef enum esc11_alarm_code {
    ESC11_ALARM_CODE_OVERLOAD = 1, /**< OVER LOAD 过负荷 */
    ESC11_ALARM_CODE_OVERCURRENT = 2, /**< OVER CURRENT 过电流 */
    ESC11_ALARM_CODE_MACHINE_REFERENCE_OVER = 3, /**< MACHINE REFERENCE OVER 超过基准值 */
    ESC11_ALARM_CODE_SUPPLY_VOLTAGE_LOW = 4, /**< POWER SUPPLY VOLTAGE LOW 电源电压下降 */
    ESC11_ALARM_CODE_DATA_NOT_WRITTEN = 5, /**< DATA NOT WRITE 数据写入不良 */
    ESC11_ALARM_CODE_POSITION_DEVIATION_OVER = 6, /**< P.E. COUNTER OVER 位置偏差过大 */
    ESC11_ALARM_CODE_POINT_DATA_DESTROYED = 7, /**< PNT DATA DESTROY 点数据不良 */
    ESC11_ALARM_CODE_PARAMETER_DATA_DESTROYED = 8, /**< PRM DATA DESTROY 参数不良 */
    ESC11_ALARM_CODE_SYSTEM_FAULT_1 = 9, /**< SYSTEM FAULT1 系统异常1 */
    ESC11_ALARM_CODE_FEEDBACK_ERROR_1 = 10, /**< FEEDBACK ERROR1 反馈错误1 */
    ESC11_ALARM_CODE_FEEDBACK_ERROR_2 = 11, /**< FEEDBACK ERROR2 反馈错误2 */
    ESC11_ALARM_CODE_ABNORMAL_VOLTAGE = 12, /**< ABNORMAL VOLTAGE 电压异常 */
    ESC11_ALARM_CODE_SYSTEM_FAULT_2 = 13, /**< SYSTEM FAULT2 系统异常2 */
    ESC11_ALARM_CODE_FEEDBACK_ERROR_3 = 14, /**< FEEDBACK ERROR3 反馈错误3 */
    ESC11_ALARM_CODE_SOFT_LIMIT_EXCEEDED = 32, /**< SOFT LIMIT OVER 超过软限位 */
    ESC11_ALARM_CODE_PULSE_OVERFLOW = 33, /**< PULSE OVERFLOW 脉冲溢出 */
    ESC11_ALARM_CODE_IO_LOGIC_ERROR = 34, /**< I/O逻辑错误 */
    ESC11_ALARM_CODE_HOMING_INCOMPLETE = 35, /**< 原点未完成 */
    ESC11_ALARM_CODE_SERVO_OFF = 36, /**< 伺服OFF */
    ESC11_ALARM_CODE_INTERLOCK = 37, /**< 联锁 */
    ESC11_ALARM_CODE_NO_POINT = 38, /**< 无点 */
    ESC11_ALARM_CODE_OPERATING = 39, /**< 运行中 */
    ESC11_ALARM_CODE_PROCESSING = 40, /**< 处理中 */
    ESC11_ALARM_CODE_HOME_NOT_FOUND = 41, /**< 无原点 */
    ESC11_ALARM_CODE_NETWORK_COMMUNICATION_ERROR = 48, /**< 网络通信错误 */
    ESC11_ALARM_CODE_COMMUNICATION_COMMAND_ERROR = 49, /**< 通信指令错误 */
    ESC11_ALARM_CODE_DATA_ERROR = 50, /**< 数据错误 */
    ESC11_ALARM_CODE_UNKNOWN_ACTUATOR_TYPE = 51 /**< 无执行器代码 */
} ESC11_ENUM_16 esc11_alarm_code;

/**
 * Printed as 原点复位方向.
 * Source: 10.2 L1264
 */
typedef enum esc11_homing_direction {
    ESC11_HOMING_DIRECTION_OPEN = 0, /**< OPEN */
    ESC11_HOMING_DIRECTION_CLOSE = 1 /**< CLOSE */
} ESC11_ENUM_16 esc11_homing_direction;

/**
 * Printed as 原点复位方式.
 * Source: 10.2 L1275
 */
typedef enum esc11_homing_method {
    ESC11_HOMING_METHOD_STROKE_END = 0, /**< 行程末端 */
    ESC11_HOMING_METHOD_STROKE_END_AND_Z_PHASE = 1 /**< 行程末端+Z相检测方法 */
} ESC11_ENUM_16 esc11_homing_method;

/**
 * What a point does. Each mode does the same as one of the movement commands.
 * Printed as 表9-2 动作模式.
 * Note: The codes are not those of the movement commands, nor in their order. 41h, 43h, 47h and 48h are
 * commands of quite another kind.
 * Source: 9.3.5 L819-831
 */
typedef enum esc11_point_mode {
    ESC11_POINT_MODE_ABSOLUTE_MOVE = 65, /**< 绝对位置移动 Moves to a position counted from the home position; command 17h. */
    ESC11_POINT_MODE_CONSTANT_SPEED_GRIP_CLOSE = 67, /**< 匀速移动夹持（关） Closes at constant speed and grips; command 21h. */
    ESC11_POINT_MODE_RELATIVE_GRIP = 71, /**< 加减速相对位置移动及夹持 Moves by a distance with acceleration and deceleration, and grips; command 22h. */
    ESC11_POINT_MODE_ABSOLUTE_GRIP = 72, /**< 加减速绝对位置移动及夹持 Moves to a position with acceleration and deceleration, and grips; command 23h. */
    ESC11_POINT_MODE_RELATIVE_MOVE = 73, /**< 相对位置移动 Moves by a distance from the current position; command 16h. */
    ESC11_POINT_MODE_CONSTANT_SPEED_GRIP_OPEN_WITH_ZONE = 74, /**< 带ZON匀速移动及夹持（开） Opens at constant speed and grips, with the ZON output; command 24h. */
    ESC11_POINT_MODE_CONSTANT_SPEED_GRIP_CLOSE_WITH_ZONE = 75, /**< 带ZON匀速移动及夹持（关） Closes at constant speed and grips, with the ZON output; command 25h. */
    ESC11_POINT_MODE_CONSTANT_SPEED_GRIP_OPEN = 79 /**< 匀速移动夹持（开） Opens at constant speed and grips; command 20h. */
} ESC11_ENUM_16 esc11_point_mode;

/* ---- Bit fields ---- */

/**
 * The status byte of every response.
 * Printed as 通信状态.
 * A word of 8 bits.
 * Note: The labels of bits 0 to 2 name the state that holds at 0 (finished, in position, servo on). The names
 * here say what is true at 1.
 * Source: 8.2 L283-293
 */
typedef uint8_t esc11_communication_status;

/**
 * Printed as 工作结束.
 * 0: finished. 1: executing.
 * Source: 8.2 L286
 */
#define ESC11_COMMUNICATION_STATUS_EXECUTING_MASK 0x01u
#define ESC11_COMMUNICATION_STATUS_EXECUTING_SHIFT 0u

/**
 * Printed as 在位置状态.
 * 0: within the range. 1: outside of it.
 * Note: The manual does not say which range. By their names, the signal INPOS of command 52h has the opposite
 * sense. Nearly all samples of a controller at rest have 1 here (status 02h); only those of 30h, 4Eh and 63h
 * have 0.
 * Source: 8.2 L287
 */
#define ESC11_COMMUNICATION_STATUS_OUT_OF_POSITION_MASK 0x02u
#define ESC11_COMMUNICATION_STATUS_OUT_OF_POSITION_SHIFT 1u

/**
 * Printed as 伺服ON状态.
 * 0: servo on. 1: servo off.
 * Note: 1 is off, while in commands 31h and 46h 1 is the excited state.
 * Source: 8.2 L288
 */
#define ESC11_COMMUNICATION_STATUS_SERVO_OFF_MASK 0x04u
#define ESC11_COMMUNICATION_STATUS_SERVO_OFF_SHIFT 2u

/**
 * Printed as 请求数据读取.
 * 0: not requested. 1: requested.
 * Source: 8.2 L289
 */
#define ESC11_COMMUNICATION_STATUS_DATA_READ_REQUEST_MASK 0x08u
#define ESC11_COMMUNICATION_STATUS_DATA_READ_REQUEST_SHIFT 3u

/**
 * Printed as 请求重新发送指令.
 * 0: not requested. 1: requested.
 * Source: 8.2 L290
 */
#define ESC11_COMMUNICATION_STATUS_COMMAND_RESEND_REQUEST_MASK 0x10u
#define ESC11_COMMUNICATION_STATUS_COMMAND_RESEND_REQUEST_SHIFT 4u

/**
 * Set in the answer to an unknown command (7.3 L251).
 * Printed as 指令错误.
 * 0: normal. 1: error.
 * Source: 8.2 L291
 */
#define ESC11_COMMUNICATION_STATUS_COMMAND_ERROR_MASK 0x20u
#define ESC11_COMMUNICATION_STATUS_COMMAND_ERROR_SHIFT 5u

/**
 * Printed as 警报状态.
 * 0: normal. 1: error.
 * Source: 8.2 L292
 */
#define ESC11_COMMUNICATION_STATUS_ALARM_MASK 0x40u
#define ESC11_COMMUNICATION_STATUS_ALARM_SHIFT 6u

/**
 * Printed as 通信错误.
 * 0: normal. 1: error.
 * Source: 8.2 L293
 */
#define ESC11_COMMUNICATION_STATUS_COMMUNICATION_ERROR_MASK 0x80u
#define ESC11_COMMUNICATION_STATUS_COMMUNICATION_ERROR_SHIFT 7u

/**
 * The inputs, in the first byte of the response to command 52h.
 * A word of 8 bits.
 * Source: 9.4.3 L945-946
 */
typedef uint8_t esc11_io_inputs;

/**
 * IPOS0 to IPOS4 together select a point by its number, lowest bit first.
 * Printed as IPOS0.
 * Source: 9.4.3 L945-946
 */
#define ESC11_IO_INPUTS_POINT_INPUT_0_MASK 0x01u
#define ESC11_IO_INPUTS_POINT_INPUT_0_SHIFT 0u

/**
 * Printed as IPOS1.
 * Source: 9.4.3 L945-946
 */
#define ESC11_IO_INPUTS_POINT_INPUT_1_MASK 0x02u
#define ESC11_IO_INPUTS_POINT_INPUT_1_SHIFT 1u

/**
 * Printed as IPOS2.
 * Source: 9.4.3 L945-946
 */
#define ESC11_IO_INPUTS_POINT_INPUT_2_MASK 0x04u
#define ESC11_IO_INPUTS_POINT_INPUT_2_SHIFT 2u

/**
 * Printed as IPOS3.
 * Source: 9.4.3 L945-946
 */
#define ESC11_IO_INPUTS_POINT_INPUT_3_MASK 0x08u
#define ESC11_IO_INPUTS_POINT_INPUT_3_SHIFT 3u

/**
 * Printed as IPOS4.
 * Source: 9.4.3 L945-946
 */
#define ESC11_IO_INPUTS_POINT_INPUT_4_MASK 0x10u
#define ESC11_IO_INPUTS_POINT_INPUT_4_SHIFT 4u

/**
 * Starts the move; with IPOS0 to IPOS4 off the temporary point of command 63h, or homing where there is none
 * (9.5.4).
 * Printed as START.
 * Source: 9.4.3 L945-946
 */
#define ESC11_IO_INPUTS_START_MASK 0x20u
#define ESC11_IO_INPUTS_START_SHIFT 5u

/**
 * Printed as SEL.
 * Note: The manual does not say what it selects.
 * Source: 9.4.3 L945-946
 */
#define ESC11_IO_INPUTS_SELECTION_MASK 0x40u
#define ESC11_IO_INPUTS_SELECTION_SHIFT 6u

/**
 * Printed as INLOK.
 * 0: moves are locked. 1: moves are allowed.
 * Source: 9.4.3 L945-946
 */
#define ESC11_IO_INPUTS_INTERLOCK_RELEASED_MASK 0x80u
#define ESC11_IO_INPUTS_INTERLOCK_RELEASED_SHIFT 7u

/**
 * The outputs, in the second byte of the response to command 52h.
 * A word of 8 bits.
 * Source: 9.4.3 L945, 947
 */
typedef uint8_t esc11_io_outputs;

/**
 * OPOS0 to OPOS4 together give the number of a point, lowest bit first.
 * Printed as OPOS0.
 * Source: 9.4.3 L945, 947
 */
#define ESC11_IO_OUTPUTS_POINT_OUTPUT_0_MASK 0x01u
#define ESC11_IO_OUTPUTS_POINT_OUTPUT_0_SHIFT 0u

/**
 * Printed as OPOS1.
 * Source: 9.4.3 L945, 947
 */
#define ESC11_IO_OUTPUTS_POINT_OUTPUT_1_MASK 0x02u
#define ESC11_IO_OUTPUTS_POINT_OUTPUT_1_SHIFT 1u

/**
 * Printed as OPOS2.
 * Source: 9.4.3 L945, 947
 */
#define ESC11_IO_OUTPUTS_POINT_OUTPUT_2_MASK 0x04u
#define ESC11_IO_OUTPUTS_POINT_OUTPUT_2_SHIFT 2u

/**
 * Printed as OPOS3.
 * Source: 9.4.3 L945, 947
 */
#define ESC11_IO_OUTPUTS_POINT_OUTPUT_3_MASK 0x08u
#define ESC11_IO_OUTPUTS_POINT_OUTPUT_3_SHIFT 3u

/**
 * Printed as OPOS4.
 * Source: 9.4.3 L945, 947
 */
#define ESC11_IO_OUTPUTS_POINT_OUTPUT_4_MASK 0x10u
#define ESC11_IO_OUTPUTS_POINT_OUTPUT_4_SHIFT 4u

/**
 * Printed as RORG.
 * Source: 9.4.3 L945, 947
 */
#define ESC11_IO_OUTPUTS_HOMING_COMPLETE_MASK 0x20u
#define ESC11_IO_OUTPUTS_HOMING_COMPLETE_SHIFT 5u

/**
 * On when a move with a zone stopped between the two limits (9.1.14 L662).
 * Printed as ZON.
 * Source: 9.4.3 L945, 947
 */
#define ESC11_IO_OUTPUTS_IN_ZONE_MASK 0x40u
#define ESC11_IO_OUTPUTS_IN_ZONE_SHIFT 6u

/**
 * The state outputs and the lamps, in the third byte of the response to command 52h.
 * A word of 8 bits.
 * Source: 9.4.3 L945, 948
 */
typedef uint8_t esc11_io_state_outputs;

/**
 * Printed as READY.
 * Source: 9.4.3 L945, 948
 */
#define ESC11_IO_STATE_OUTPUTS_READY_MASK 0x01u
#define ESC11_IO_STATE_OUTPUTS_READY_SHIFT 0u

/**
 * Commands are to be sent when it is off (remedy of error 28h).
 * Printed as BUSY.
 * Source: 9.4.3 L945, 948
 */
#define ESC11_IO_STATE_OUTPUTS_BUSY_MASK 0x02u
#define ESC11_IO_STATE_OUTPUTS_BUSY_SHIFT 1u

/**
 * Printed as ALRM.
 * Source: 9.4.3 L945, 948
 */
#define ESC11_IO_STATE_OUTPUTS_ALARM_MASK 0x04u
#define ESC11_IO_STATE_OUTPUTS_ALARM_SHIFT 2u

/**
 * Printed as INPOS.
 * Note: By its name, the reverse of the bit out_of_position in the status byte.
 * Source: 9.4.3 L945, 948
 */
#define ESC11_IO_STATE_OUTPUTS_IN_POSITION_MASK 0x08u
#define ESC11_IO_STATE_OUTPUTS_IN_POSITION_SHIFT 3u

/**
 * Printed as HOLD.
 * Source: 9.4.3 L945, 948
 */
#define ESC11_IO_STATE_OUTPUTS_HOLD_MASK 0x10u
#define ESC11_IO_STATE_OUTPUTS_HOLD_SHIFT 4u

/**
 * Printed as RUN (LED).
 * Source: 9.4.3 L945, 948
 */
#define ESC11_IO_STATE_OUTPUTS_RUN_LAMP_MASK 0x20u
#define ESC11_IO_STATE_OUTPUTS_RUN_LAMP_SHIFT 5u

/**
 * Printed as READY(LED).
 * Source: 9.4.3 L945, 948
 */
#define ESC11_IO_STATE_OUTPUTS_READY_LAMP_MASK 0x40u
#define ESC11_IO_STATE_OUTPUTS_READY_LAMP_SHIFT 6u

/**
 * Printed as ALM (LED).
 * Source: 9.4.3 L945, 948
 */
#define ESC11_IO_STATE_OUTPUTS_ALARM_LAMP_MASK 0x80u
#define ESC11_IO_STATE_OUTPUTS_ALARM_LAMP_SHIFT 7u

/* ---- Records ---- */

#define ESC11_ALARM_HISTORY_ENTRY_SIZE 4u

#define ESC11_POINT_SIZE 16u

#define ESC11_TEMPORARY_POINT_SIZE 16u

/* ---- Data of requests and responses ---- */

/**
 * Gives the points from a number on, at most 15 of them. Deleted points are left out, so each one brings its
 * number along.
 * Printed as 连续读取点数据.
 * Read consecutive points.
 * Source: 9.4.1 L889-898, 887
 */
#define ESC11_READ_POINTS_CODE 80u

#define ESC11_READ_POINTS_REQUEST_SIZE 1u

#define ESC11_READ_POINTS_RESPONSE_SIZE 240u

/**
 * Gives all 32 parameters in the order of their numbers.
 * Printed as 读取全部参数.
 * Read all parameters.
 * Source: 9.4.2 L920-926, 918
 */
#define ESC11_READ_PARAMETERS_CODE 81u

#define ESC11_READ_PARAMETERS_REQUEST_SIZE 0u

#define ESC11_READ_PARAMETERS_RESPONSE_SIZE 64u

/**
 * Gives the states of the inputs, of the outputs and of the lamps.
 * Printed as 读取I/O状态.
 * Read the inputs and outputs.
 * Source: 9.4.3 L936-940, 934
 */
#define ESC11_READ_IO_STATUS_CODE 82u

#define ESC11_READ_IO_STATUS_REQUEST_SIZE 0u

#define ESC11_READ_IO_STATUS_RESPONSE_SIZE 3u

/**
 * Gives the last alarms with the accumulated time at which each came up, the latest first, at most 16.
 * Printed as 读出警报记录.
 * Read the alarm history.
 * Source: 9.4.4 L952-956, 950
 */
#define ESC11_READ_ALARM_HISTORY_CODE 83u

#define ESC11_READ_ALARM_HISTORY_REQUEST_SIZE 0u

#define ESC11_READ_ALARM_HISTORY_RESPONSE_SIZE 64u

/**
 * Stores up to 15 points under the numbers that they bring along.
 * Printed as 写入点数据.
 * Write points.
 * Note: Another command of the same printed name, 63h, writes one point that is lost with the power.
 * Source: 9.5.1 L969-979, 967
 */
#define ESC11_WRITE_POINTS_CODE 96u

#define ESC11_WRITE_POINTS_REQUEST_SIZE 240u

#define ESC11_WRITE_POINTS_RESPONSE_SIZE 0u

/**
 * Stores all 32 parameters in the order of their numbers.
 * Printed as 写入全部参数.
 * Write all parameters.
 * Source: 9.5.2 L1000-1006, 998
 */
#define ESC11_WRITE_PARAMETERS_CODE 97u

#define ESC11_WRITE_PARAMETERS_REQUEST_SIZE 64u

#define ESC11_WRITE_PARAMETERS_RESPONSE_SIZE 0u

/**
 * Stores one parameter.
 * Printed as 写入一个参数.
 * Write one parameter.
 * Source: 9.5.3 L1016-1022, 1014
 */
#define ESC11_WRITE_PARAMETER_CODE 98u

#define ESC11_WRITE_PARAMETER_REQUEST_SIZE 3u

#define ESC11_WRITE_PARAMETER_RESPONSE_SIZE 0u

/**
 * Writes one point that is kept until the power is switched off. It is carried out by the input START while
 * the inputs IPOS0 to IPOS4 are off, so that several controllers can be started together with few wires.
 * Printed as 写入点数据.
 * Write the temporary point.
 * Note: The point is not written to the EEPROM, so it may be written as often as one likes.
 * Note: After this command homing can no longer be started by the inputs.
 * Note: The point is lost when the power is switched off. After that, START with IPOS0 to IPOS4 off starts
 * homing again.
 * Note: The manual prints the same name for command 60h, which stores points for good.
 * Source: 9.5.4 L1032-1055, 1030, 1068-1072
 */
#define ESC11_WRITE_TEMPORARY_POINT_CODE 99u

#define ESC11_WRITE_TEMPORARY_POINT_REQUEST_SIZE 16u

#define ESC11_WRITE_TEMPORARY_POINT_RESPONSE_SIZE 0u

/**
 * Deletes a number of consecutive points.
 * Printed as 清除点数据.
 * Delete points.
 * Source: 9.6.1 L1078-1084, 1076
 */
#define ESC11_CLEAR_POINTS_CODE 112u

#define ESC11_CLEAR_POINTS_REQUEST_SIZE 2u

#define ESC11_CLEAR_POINTS_RESPONSE_SIZE 0u

/**
 * Deletes all points.
 * Printed as 初始化全部点数据.
 * Delete all points.
 * Source: 9.6.2 L1094-1100, 1092
 */
#define ESC11_INITIALIZE_POINTS_CODE 113u

#define ESC11_INITIALIZE_POINTS_REQUEST_SIZE 0u

#define ESC11_INITIALIZE_POINTS_RESPONSE_SIZE 0u

/**
 * Sets all parameters to the initial values of an actuator type.
 * Printed as 初始化全部参数.
 * Set all parameters to those of an actuator type.
 * Note: A type that does not exist brings up error 33h.
 * Source: 9.6.3 L1108-1114, 1106
 */
#define ESC11_INITIALIZE_PARAMETERS_CODE 114u

#define ESC11_INITIALIZE_PARAMETERS_REQUEST_SIZE 2u

#define ESC11_INITIALIZE_PARAMETERS_RESPONSE_SIZE 0u

/**
 * Deletes all entries of the alarm history.
 * Printed as 清除警报记录.
 * Delete the alarm history.
 * Source: 9.6.4 L1133-1136, 1131
 */
#define ESC11_CLEAR_ALARM_HISTORY_CODE 115u

#define ESC11_CLEAR_ALARM_HISTORY_REQUEST_SIZE 0u

#define ESC11_CLEAR_ALARM_HISTORY_RESPONSE_SIZE 0u

/**
 * Sets the accumulated time to zero.
 * Printed as 清除累计时间.
 * Set the accumulated time to zero.
 * Source: 9.6.5 L1142-1145, 1140
 */
#define ESC11_CLEAR_ACCUMULATED_TIME_CODE 116u

#define ESC11_CLEAR_ACCUMULATED_TIME_REQUEST_SIZE 0u

#define ESC11_CLEAR_ACCUMULATED_TIME_RESPONSE_SIZE 0u

/**
 * Stops a move that is going on.
 * Printed as 停止.
 * Stop.
 * Source: 9.1.1 L305-308, 303
 */
#define ESC11_STOP_CODE 16u

#define ESC11_STOP_REQUEST_SIZE 0u

#define ESC11_STOP_RESPONSE_SIZE 0u

/**
 * Starts the homing run.
 * Printed as 原点复位.
 * Start homing.
 * Source: 9.1.2 L313-316, 311
 */
#define ESC11_START_HOMING_CODE 17u

#define ESC11_START_HOMING_REQUEST_SIZE 0u

#define ESC11_START_HOMING_RESPONSE_SIZE 0u

/**
 * Moves a short distance from the current position in the positive direction.
 * Printed as +指定量移动.
 * Move a distance in the positive direction.
 * Source: 9.1.3 L321-324, 319
 */
#define ESC11_MOVE_POSITIVE_DISTANCE_CODE 18u

#define ESC11_MOVE_POSITIVE_DISTANCE_REQUEST_SIZE 3u

#define ESC11_MOVE_POSITIVE_DISTANCE_RESPONSE_SIZE 0u

/**
 * Moves a short distance from the current position in the negative direction.
 * Printed as -指定量移动.
 * Move a distance in the negative direction.
 * Source: 9.1.4 L349-355, 347
 */
#define ESC11_MOVE_NEGATIVE_DISTANCE_CODE 19u

#define ESC11_MOVE_NEGATIVE_DISTANCE_REQUEST_SIZE 3u

#define ESC11_MOVE_NEGATIVE_DISTANCE_RESPONSE_SIZE 0u

/**
 * Moves in the opening direction at constant speed; the figure shows the run up to the end of the stroke.
 * Printed as 匀速移动 (开).
 * Move in the opening direction at constant speed.
 * Source: 9.1.5 L383-393, 381
 */
#define ESC11_MOVE_OPEN_CODE 20u

#define ESC11_MOVE_OPEN_REQUEST_SIZE 1u

#define ESC11_MOVE_OPEN_RESPONSE_SIZE 0u

/**
 * Moves in the closing direction at constant speed.
 * Printed as 匀速移动（关）.
 * Move in the closing direction at constant speed.
 * Source: 9.1.6 L407-410, 405
 */
#define ESC11_MOVE_CLOSE_CODE 21u

#define ESC11_MOVE_CLOSE_REQUEST_SIZE 1u

#define ESC11_MOVE_CLOSE_RESPONSE_SIZE 0u

/**
 * Moves by a signed distance from the current position.
 * Printed as 相对位置移动.
 * Move to a relative position.
 * Source: 9.1.7 L421-427, 419
 */
#define ESC11_MOVE_RELATIVE_CODE 22u

#define ESC11_MOVE_RELATIVE_REQUEST_SIZE 5u

#define ESC11_MOVE_RELATIVE_RESPONSE_SIZE 0u

/**
 * Moves to a position that is counted from the home position.
 * Printed as 绝对位置移动.
 * Move to an absolute position.
 * Source: 9.1.8 L450-458, 448
 */
#define ESC11_MOVE_ABSOLUTE_CODE 23u

#define ESC11_MOVE_ABSOLUTE_REQUEST_SIZE 5u

#define ESC11_MOVE_ABSOLUTE_RESPONSE_SIZE 0u

/**
 * Carries out the move or the grip that is stored under a point number.
 * Printed as 点移动.
 * Move as a point says.
 * Note: The general speed formula of table 10.1 (L1254), which it also refers to for this command, does not
 * mention the point's own speed; 9.1.9 L506 multiplies by it.
 * Source: 9.1.9 L484-490, 482
 */
#define ESC11_MOVE_TO_POINT_CODE 26u

#define ESC11_MOVE_TO_POINT_REQUEST_SIZE 2u

#define ESC11_MOVE_TO_POINT_RESPONSE_SIZE 0u

/**
 * Moves in the opening direction at constant speed and grips with the given force.
 * Printed as 匀速移动夹持（开）.
 * Move in the opening direction at constant speed and grip.
 * Source: 9.1.10 L512-520, 510
 */
#define ESC11_GRIP_OPEN_CODE 32u

#define ESC11_GRIP_OPEN_REQUEST_SIZE 2u

#define ESC11_GRIP_OPEN_RESPONSE_SIZE 0u

/**
 * Moves in the closing direction at constant speed and grips with the given force.
 * Printed as 匀速移动夹持（关）.
 * Move in the closing direction at constant speed and grip.
 * Source: 9.1.11 L540-546, 538
 */
#define ESC11_GRIP_CLOSE_CODE 33u

#define ESC11_GRIP_CLOSE_REQUEST_SIZE 2u

#define ESC11_GRIP_CLOSE_RESPONSE_SIZE 0u

/**
 * Moves by a signed distance from the current position, with acceleration and deceleration, and grips with the
 * given force.
 * Printed as 加减速相对位置移动及夹持.
 * Move to a relative position and grip.
 * Source: 9.1.12 L566-574, 564
 */
#define ESC11_GRIP_RELATIVE_CODE 34u

#define ESC11_GRIP_RELATIVE_REQUEST_SIZE 6u

#define ESC11_GRIP_RELATIVE_RESPONSE_SIZE 0u

/**
 * Moves to a position that is counted from the home position, with acceleration and deceleration, and grips
 * with the given force.
 * Printed as 加减速绝对位置移动及夹持.
 * Move to an absolute position and grip.
 * Source: 9.1.13 L602-610, 600
 */
#define ESC11_GRIP_ABSOLUTE_CODE 35u

#define ESC11_GRIP_ABSOLUTE_REQUEST_SIZE 6u

#define ESC11_GRIP_ABSOLUTE_RESPONSE_SIZE 0u

/**
 * Moves in the opening direction at constant speed and grips. The ZON signal is on when it stops between the
 * two limits of the zone.
 * Printed as 带ZON匀速移动及夹持（开）.
 * Move in the opening direction at constant speed and grip, with a zone.
 * Source: 9.1.14 L638-648, 636
 */
#define ESC11_GRIP_OPEN_WITH_ZONE_CODE 36u

#define ESC11_GRIP_OPEN_WITH_ZONE_REQUEST_SIZE 10u

#define ESC11_GRIP_OPEN_WITH_ZONE_RESPONSE_SIZE 0u

/**
 * Moves in the closing direction at constant speed and grips. The ZON signal is on when it stops between the
 * two limits of the zone.
 * Printed as 带ZON匀速移动及夹持（关）.
 * Move in the closing direction at constant speed and grip, with a zone.
 * Source: 9.1.15 L676-686, 674
 */
#define ESC11_GRIP_CLOSE_WITH_ZONE_CODE 37u

#define ESC11_GRIP_CLOSE_WITH_ZONE_REQUEST_SIZE 10u

#define ESC11_GRIP_CLOSE_WITH_ZONE_RESPONSE_SIZE 0u

/**
 * Does nothing, and is answered with the status.
 * Printed as NOP.
 * No operation.
 * Source: 9.2.1 L716-719, 714
 */
#define ESC11_NO_OPERATION_CODE 48u

#define ESC11_NO_OPERATION_REQUEST_SIZE 0u

#define ESC11_NO_OPERATION_RESPONSE_SIZE 0u

/**
 * Excites the motor, or releases it.
 * Printed as 电机励磁.
 * Switch the motor's excitation.
 * Note: The status of the response shows the result with the opposite sense, its bit servo_off is 1 while the
 * motor is not excited.
 * Source: 9.2.2 L724-727, 722
 */
#define ESC11_SET_MOTOR_EXCITATION_CODE 49u

#define ESC11_SET_MOTOR_EXCITATION_REQUEST_SIZE 1u

#define ESC11_SET_MOTOR_EXCITATION_RESPONSE_SIZE 0u

/**
 * Gives the version of the controller.
 * Printed as 读取版本.
 * Read the version.
 * Source: 9.3.1 L740-743, 738
 */
#define ESC11_READ_VERSION_CODE 64u

#define ESC11_READ_VERSION_REQUEST_SIZE 0u

#define ESC11_READ_VERSION_RESPONSE_SIZE 6u

/**
 * Gives the position.
 * Printed as 读取当前位置.
 * Read the current position.
 * Source: 9.3.2 L752-755, 750
 */
#define ESC11_READ_CURRENT_POSITION_CODE 65u

#define ESC11_READ_CURRENT_POSITION_REQUEST_SIZE 0u

#define ESC11_READ_CURRENT_POSITION_RESPONSE_SIZE 4u

/**
 * Gives the number of the point that was carried out last.
 * Printed as 读取当前点编号.
 * Read the current point's number.
 * Source: 9.3.3 L763-766, 761
 */
#define ESC11_READ_CURRENT_POINT_NUMBER_CODE 66u

#define ESC11_READ_CURRENT_POINT_NUMBER_REQUEST_SIZE 0u

#define ESC11_READ_CURRENT_POINT_NUMBER_RESPONSE_SIZE 1u

/**
 * Gives the value of one parameter.
 * Printed as 读取指定参数.
 * Read one parameter.
 * Source: 9.3.4 L773-776, 771
 */
#define ESC11_READ_PARAMETER_CODE 67u

#define ESC11_READ_PARAMETER_REQUEST_SIZE 1u

#define ESC11_READ_PARAMETER_RESPONSE_SIZE 2u

/**
 * Gives the data of one point.
 * Printed as 读取指定点.
 * Read one point.
 * Note: What is answered for a point without data is not printed. Error 26h is that of a move to one.
 * Source: 9.3.5 L784-790, 782
 */
#define ESC11_READ_POINT_CODE 68u

#define ESC11_READ_POINT_REQUEST_SIZE 1u

#define ESC11_READ_POINT_RESPONSE_SIZE 16u

/**
 * Tells whether homing has been completed.
 * Printed as 查看原点复位状态.
 * Read whether homing is complete.
 * Source: 9.3.6 L835-838, 833
 */
#define ESC11_READ_HOMING_STATE_CODE 69u

#define ESC11_READ_HOMING_STATE_REQUEST_SIZE 0u

#define ESC11_READ_HOMING_STATE_RESPONSE_SIZE 1u

/**
 * Tells whether the motor is excited.
 * Printed as 查看电机励磁状态.
 * Read whether the motor is excited.
 * Source: 9.3.7 L844-847, 842
 */
#define ESC11_READ_MOTOR_EXCITATION_CODE 70u

#define ESC11_READ_MOTOR_EXCITATION_REQUEST_SIZE 0u

#define ESC11_READ_MOTOR_EXCITATION_RESPONSE_SIZE 1u

/**
 * Gives the number of the alarm or error that stands.
 * Printed as 读取警报错误编号.
 * Read the alarm or error.
 * Source: 9.3.8 L853-856, 851
 */
#define ESC11_READ_ALARM_CODE_CODE 71u

#define ESC11_READ_ALARM_CODE_REQUEST_SIZE 0u

#define ESC11_READ_ALARM_CODE_RESPONSE_SIZE 1u

/**
 * Gives how long the controller has been powered, all times together.
 * Printed as 读取累计时间.
 * Read the accumulated time.
 * Note: The minutes are lost when the power is switched off.
 * Note: After an alarm the count goes on from the hours and minutes at which the alarm came up (L869).
 * Source: 9.3.9 L862-865, 860, 867-869
 */
#define ESC11_READ_ACCUMULATED_TIME_CODE 72u

#define ESC11_READ_ACCUMULATED_TIME_REQUEST_SIZE 0u

#define ESC11_READ_ACCUMULATED_TIME_RESPONSE_SIZE 3u

/**
 * Resets the alarm.
 * Printed as 解除警报.
 * Reset the alarm.
 * Note: To be sent after the cause has been looked up and removed.
 * Note: If a workpiece gripped by mistake in an absolute move brought up the overload, take the workpiece out
 * first (L883).
 * Source: 9.3.10 L871-876, 881-883
 */
#define ESC11_RESET_ALARM_CODE 78u

#define ESC11_RESET_ALARM_REQUEST_SIZE 0u

#define ESC11_RESET_ALARM_RESPONSE_SIZE 0u

/* ---- Parameters ---- */

/**
 * The gripper that is connected.
 * Printed as 执行器类型.
 * Range: 0..65535. See actuator_type.
 * Source: 10.2 L1259
 */
#define ESC11_PAR_PARAMETERS_ACTUATOR_TYPE_NUMBER 0u
#define ESC11_PAR_PARAMETERS_ACTUATOR_TYPE_MIN 0u
#define ESC11_PAR_PARAMETERS_ACTUATOR_TYPE_MAX 65535u

/**
 * Printed as (+) 软限位.
 * One count is 0.1 mm. Range: 0..9999.
 * Note: 9.3.4 L779 shows the value 64h as 10.00 mm, with one decimal more than the parameter has.
 * Source: 10.2 L1260
 */
#define ESC11_PAR_PARAMETERS_POSITIVE_SOFT_LIMIT_NUMBER 1u
#define ESC11_PAR_PARAMETERS_POSITIVE_SOFT_LIMIT_MIN 0u
#define ESC11_PAR_PARAMETERS_POSITIVE_SOFT_LIMIT_MAX 9999u
#define ESC11_PAR_PARAMETERS_POSITIVE_SOFT_LIMIT_SCALE_NUMERATOR INT64_C(1)
#define ESC11_PAR_PARAMETERS_POSITIVE_SOFT_LIMIT_SCALE_DENOMINATOR INT64_C(10)

/**
 * Printed as (-) 软限位.
 * One count is 0.1 mm. Range: -9999..0.
 * Source: 10.2 L1261
 */
#define ESC11_PAR_PARAMETERS_NEGATIVE_SOFT_LIMIT_NUMBER 2u
#define ESC11_PAR_PARAMETERS_NEGATIVE_SOFT_LIMIT_MIN (-9999)
#define ESC11_PAR_PARAMETERS_NEGATIVE_SOFT_LIMIT_MAX 0
#define ESC11_PAR_PARAMETERS_NEGATIVE_SOFT_LIMIT_SCALE_NUMERATOR INT64_C(1)
#define ESC11_PAR_PARAMETERS_NEGATIVE_SOFT_LIMIT_SCALE_DENOMINATOR INT64_C(10)

/**
 * Printed as 行程.
 * One count is 0.1 mm. Range: 0..9999.
 * Source: 10.2 L1262
 */
#define ESC11_PAR_PARAMETERS_STROKE_NUMBER 3u
#define ESC11_PAR_PARAMETERS_STROKE_MIN 0u
#define ESC11_PAR_PARAMETERS_STROKE_MAX 9999u
#define ESC11_PAR_PARAMETERS_STROKE_SCALE_NUMERATOR INT64_C(1)
#define ESC11_PAR_PARAMETERS_STROKE_SCALE_DENOMINATOR INT64_C(10)

/**
 * Preset; no meaning is printed.
 * Printed as 已设定.
 * Reserved.
 * Source: 10.2 L1263
 */
#define ESC11_PAR_PARAMETERS_PRESET_4_NUMBER 4u

/**
 * Printed as 原点复位方向.
 * See homing_direction.
 * Source: 10.2 L1264
 */
#define ESC11_PAR_PARAMETERS_HOMING_DIRECTION_NUMBER 5u

/**
 * Printed as 原点复位速度.
 * One count is 1 %. Range: 1..50.
 * Source: 10.2 L1265
 */
#define ESC11_PAR_PARAMETERS_HOMING_SPEED_NUMBER 6u
#define ESC11_PAR_PARAMETERS_HOMING_SPEED_MIN 1u
#define ESC11_PAR_PARAMETERS_HOMING_SPEED_MAX 50u

/**
 * Printed as 原点偏置.
 * One count is 0.1 mm. Range: -9999..9999.
 * Source: 10.2 L1266
 */
#define ESC11_PAR_PARAMETERS_HOME_OFFSET_NUMBER 7u
#define ESC11_PAR_PARAMETERS_HOME_OFFSET_MIN (-9999)
#define ESC11_PAR_PARAMETERS_HOME_OFFSET_MAX 9999
#define ESC11_PAR_PARAMETERS_HOME_OFFSET_SCALE_NUMERATOR INT64_C(1)
#define ESC11_PAR_PARAMETERS_HOME_OFFSET_SCALE_DENOMINATOR INT64_C(10)

/**
 * Printed as 加速度.
 * One count is 1 %. Range: 1..100.
 * Source: 10.2 L1267
 */
#define ESC11_PAR_PARAMETERS_ACCELERATION_NUMBER 8u
#define ESC11_PAR_PARAMETERS_ACCELERATION_MIN 1u
#define ESC11_PAR_PARAMETERS_ACCELERATION_MAX 100u

/**
 * Printed as 程序最高速度.
 * One count is 1 %. Range: 1..100.
 * Source: 10.2 L1268
 */
#define ESC11_PAR_PARAMETERS_MAXIMUM_PROGRAM_SPEED_NUMBER 9u
#define ESC11_PAR_PARAMETERS_MAXIMUM_PROGRAM_SPEED_MIN 1u
#define ESC11_PAR_PARAMETERS_MAXIMUM_PROGRAM_SPEED_MAX 100u

/**
 * Printed as 夹持速度.
 * One count is 1 %. Range: 1..100.
 * Source: 10.2 L1269
 */
#define ESC11_PAR_PARAMETERS_GRIPPING_SPEED_NUMBER 10u
#define ESC11_PAR_PARAMETERS_GRIPPING_SPEED_MIN 1u
#define ESC11_PAR_PARAMETERS_GRIPPING_SPEED_MAX 100u

/**
 * Printed as 匀速移动距离.
 * One count is 0.01 mm. Range: 1..9999.
 * Source: 10.2 L1270
 */
#define ESC11_PAR_PARAMETERS_CONSTANT_SPEED_DISTANCE_NUMBER 11u
#define ESC11_PAR_PARAMETERS_CONSTANT_SPEED_DISTANCE_MIN 1u
#define ESC11_PAR_PARAMETERS_CONSTANT_SPEED_DISTANCE_MAX 9999u
#define ESC11_PAR_PARAMETERS_CONSTANT_SPEED_DISTANCE_SCALE_NUMERATOR INT64_C(1)
#define ESC11_PAR_PARAMETERS_CONSTANT_SPEED_DISTANCE_SCALE_DENOMINATOR INT64_C(100)

/**
 * Printed as 限位宽度.
 * One count is 0.01 mm. Range: 1..9999.
 * Source: 10.2 L1271
 */
#define ESC11_PAR_PARAMETERS_LIMIT_WIDTH_NUMBER 12u
#define ESC11_PAR_PARAMETERS_LIMIT_WIDTH_MIN 1u
#define ESC11_PAR_PARAMETERS_LIMIT_WIDTH_MAX 9999u
#define ESC11_PAR_PARAMETERS_LIMIT_WIDTH_SCALE_NUMERATOR INT64_C(1)
#define ESC11_PAR_PARAMETERS_LIMIT_WIDTH_SCALE_DENOMINATOR INT64_C(100)

/**
 * Printed as 定位完成脉冲.
 * One count is 1 pulse. Range: 1..4000.
 * Source: 10.2 L1272
 */
#define ESC11_PAR_PARAMETERS_POSITIONING_COMPLETE_PULSES_NUMBER 13u
#define ESC11_PAR_PARAMETERS_POSITIONING_COMPLETE_PULSES_MIN 1u
#define ESC11_PAR_PARAMETERS_POSITIONING_COMPLETE_PULSES_MAX 4000u

/**
 * Preset; no meaning is printed.
 * Printed as 已设定.
 * Reserved.
 * Source: 10.2 L1273
 */
#define ESC11_PAR_PARAMETERS_PRESET_14_NUMBER 14u

/**
 * Preset; no meaning is printed.
 * Printed as 已设定.
 * Reserved.
 * Source: 10.2 L1274
 */
#define ESC11_PAR_PARAMETERS_PRESET_15_NUMBER 15u

/**
 * Printed as 原点复位方式.
 * See homing_method.
 * Source: 10.2 L1275
 */
#define ESC11_PAR_PARAMETERS_HOMING_METHOD_NUMBER 16u

/**
 * Preset; no meaning is printed.
 * Printed as 已设定.
 * Reserved.
 * Source: 10.2 L1276
 */
#define ESC11_PAR_PARAMETERS_PRESET_17_NUMBER 17u

/**
 * Not registered.
 * Printed as 未登录.
 * Reserved.
 * Source: 10.2 L1277
 */
#define ESC11_PAR_PARAMETERS_UNREGISTERED_18_NUMBER 18u

/**
 * Not registered.
 * Printed as 未登录.
 * Reserved.
 * Source: 10.2 L1278
 */
#define ESC11_PAR_PARAMETERS_UNREGISTERED_19_NUMBER 19u

/**
 * Not registered.
 * Printed as 未登录.
 * Reserved.
 * Source: 10.2 L1279
 */
#define ESC11_PAR_PARAMETERS_UNREGISTERED_20_NUMBER 20u

/**
 * Preset; no meaning is printed.
 * Printed as 已设定.
 * Reserved.
 * Source: 10.2 L1280
 */
#define ESC11_PAR_PARAMETERS_PRESET_21_NUMBER 21u

/**
 * Preset; no meaning is printed.
 * Printed as 已设定.
 * Reserved.
 * Source: 10.2 L1281
 */
#define ESC11_PAR_PARAMETERS_PRESET_22_NUMBER 22u

/**
 * Preset; no meaning is printed.
 * Printed as 已设定.
 * Reserved.
 * Source: 10.2 L1282
 */
#define ESC11_PAR_PARAMETERS_PRESET_23_NUMBER 23u

/**
 * Preset; no meaning is printed.
 * Printed as 已设定.
 * Reserved.
 * Source: 10.2 L1283
 */
#define ESC11_PAR_PARAMETERS_PRESET_24_NUMBER 24u

/**
 * Preset; no meaning is printed.
 * Printed as 已设定.
 * Reserved.
 * Source: 10.2 L1284
 */
#define ESC11_PAR_PARAMETERS_PRESET_25_NUMBER 25u

/**
 * Preset; no meaning is printed.
 * Printed as 已设定.
 * Reserved.
 * Source: 10.2 L1285
 */
#define ESC11_PAR_PARAMETERS_PRESET_26_NUMBER 26u

/**
 * Preset; no meaning is printed.
 * Printed as 已设定.
 * Reserved.
 * Source: 10.2 L1286
 */
#define ESC11_PAR_PARAMETERS_PRESET_27_NUMBER 27u

/**
 * Preset; no meaning is printed.
 * Printed as 已设定.
 * Reserved.
 * Source: 10.2 L1287
 */
#define ESC11_PAR_PARAMETERS_PRESET_28_NUMBER 28u

/**
 * Preset; no meaning is printed.
 * Printed as 已设定.
 * Reserved.
 * Source: 10.2 L1288
 */
#define ESC11_PAR_PARAMETERS_PRESET_29_NUMBER 29u

/**
 * Preset. The actuator's highest speed, as the speed formula of 10.1 calls it.
 * Printed as 已设定.
 * Reserved.
 * One count is 1 pps.
 * Source: 10.2 L1289
 */
#define ESC11_PAR_PARAMETERS_ACTUATOR_MAXIMUM_SPEED_NUMBER 30u

/**
 * Preset; no meaning is printed.
 * Printed as 已设定.
 * Reserved.
 * Source: 10.2 L1290
 */
#define ESC11_PAR_PARAMETERS_PRESET_31_NUMBER 31u

#endif
