/*
 * TC100 (TOYO), version before-2.0
 * From: TC100 series operation manual V.2001
 * Identity: b1a30ddf3d283d0f
 *
 * Generated; do not edit. The constants of tc100_before_2_0.h, which includes this file: a file that needs no functions compiles faster.
 */
#ifdef TC100_CONSTANTS_INCLUDED
#ifndef TC100_VERSION_IS_BEFORE_2_0
#error "another version of this device is already included"
#endif
#else
#define TC100_CONSTANTS_INCLUDED
#define TC100_VERSION_IS_BEFORE_2_0

#if defined(__cplusplus) && __cplusplus < 201103L && !defined(__STDC_CONSTANT_MACROS)
#define __STDC_CONSTANT_MACROS
#endif
#if defined(__cplusplus) && __cplusplus < 201103L && !defined(__STDC_LIMIT_MACROS)
#define __STDC_LIMIT_MACROS
#endif
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define TC100_VERSION "before-2.0"
#define TC100_IDENTITY "b1a30ddf3d283d0f"

#ifdef __GNUC__
/** An enum has 16 bits, even where the compiler makes enums as short as they can be: a cast of 256 does not become 0. */
#define TC100_ENUM_16 __attribute__((__mode__(__HI__)))
#else
#define TC100_ENUM_16
#endif

/* ---- Enums and codes ---- */

/**
 * Other values may occur.
 * Note: Where several exceptions apply, the one with the lowest code is sent (L1780-1782).
 * Source: 8.3 L1772-1776
 */
typedef enum tc100_exception_code {
    TC100_EXCEPTION_CODE_ILLEGAL_FUNCTION = 1, /**< 功能碼錯誤 The function code is none of those that the controller knows. */
    TC100_EXCEPTION_CODE_ILLEGAL_DATA_ADDRESS = 2, /**< 站號錯誤 A register that can only be written was read, one that can only be read was written, or there is no such register. */
    TC100_EXCEPTION_CODE_ILLEGAL_DATA_VALUE = 3 /**< 資料錯誤 A value is out of its range, too many words were asked for, a parameter cannot be changed, or number and data do not fit. */
} TC100_ENUM_16 tc100_exception_code;

/**
 * What is wrong with the drive or the motor. The servo stays off while an alarm stands (6.3).
 * Printed as AlarmStatus 警報狀態.
 * Other values may occur.
 * Note: The flash counts of the ERR LED in 10.2 and 10.3 are not these codes: each is the code plus one, from
 * 2 flashes for alarm 1 to 18 flashes for alarm 17. Alarm 15 has no flash count in print.
 * Source: 8.2 L1509
 */
typedef enum tc100_alarm_code {
    TC100_ALARM_CODE_NO_ALARM = 0, /**< 無警報 */
    TC100_ALARM_CODE_LOOP_ERROR = 1, /**< Loop error */
    TC100_ALARM_CODE_FULL_COUNT = 2, /**< Full Count The difference of the actual and the commanded position exceeds the limit of register 0108H. */
    TC100_ALARM_CODE_OVERSPEED = 3, /**< 過速度 */
    TC100_ALARM_CODE_GAIN_ADJUSTMENT_ERROR = 4, /**< 增益值調整不良 */
    TC100_ALARM_CODE_OVERVOLTAGE = 5, /**< 過電壓 */
    TC100_ALARM_CODE_INITIALIZATION_ERROR = 6, /**< 初期化異常 */
    TC100_ALARM_CODE_EEPROM_ERROR = 7, /**< EEPROM 異常 */
    TC100_ALARM_CODE_MAIN_CIRCUIT_UNDERVOLTAGE = 8, /**< 主迴路電源電壓不足 */
    TC100_ALARM_CODE_OVERCURRENT = 9, /**< 過電流 */
    TC100_ALARM_CODE_REGENERATION_ERROR = 10, /**< 回生異常 */
    TC100_ALARM_CODE_EMERGENCY_STOP = 11, /**< 緊急停止 */
    TC100_ALARM_CODE_MOTOR_DISCONNECTED = 12, /**< 馬達斷線 */
    TC100_ALARM_CODE_ENCODER_DISCONNECTED = 13, /**< 編碼器斷線 */
    TC100_ALARM_CODE_CURRENT_PROTECTION = 14, /**< 保護電流值 */
    TC100_ALARM_CODE_POWER_CYCLE_REQUIRED = 15, /**< 電源再投入 */
    TC100_ALARM_CODE_ACTION_TIMEOUT = 17 /**< 動作超時 */
} TC100_ENUM_16 tc100_alarm_code;

/**
 * Why the controller did not carry out a command or accept a value.
 * Printed as ErrorStatus 故障狀態.
 * Other values may occur.
 * Source: 8.2 L1515
 */
typedef enum tc100_fault_code {
    TC100_FAULT_CODE_NO_FAULT = 0, /**< 沒有錯誤 */
    TC100_FAULT_CODE_MOTION_COMMAND_WHILE_MOVING = 1, /**< 在動作中接收動作指令 */
    TC100_FAULT_CODE_VALUE_OUT_OF_LIMITS = 2, /**< 上下限錯誤 */
    TC100_FAULT_CODE_ADDRESS_ERROR = 3, /**< 位置錯誤 */
    TC100_FAULT_CODE_FORMAT_ERROR = 4, /**< 格式錯誤 */
    TC100_FAULT_CODE_CONTROL_MODE_ERROR = 5, /**< 控制模式錯誤 */
    TC100_FAULT_CODE_POWER_CYCLE_REQUIRED = 6, /**< 斷電重開 */
    TC100_FAULT_CODE_INITIALIZATION_INCOMPLETE = 7, /**< 初始化未完成 */
    TC100_FAULT_CODE_SERVO_ON_OFF_ERROR = 8, /**< Servo ON/OFF 錯誤 */
    TC100_FAULT_CODE_LOCK_ACTIVE = 9, /**< LOCK */
    TC100_FAULT_CODE_SOFT_LIMIT_REACHED = 10, /**< 軟體極限 */
    TC100_FAULT_CODE_PARAMETER_WRITE_NOT_PERMITTED = 11, /**< 參數寫入權限不足 */
    TC100_FAULT_CODE_HOMING_INCOMPLETE = 12, /**< 原點復歸未完成 */
    TC100_FAULT_CODE_BRAKE_RELEASED = 13 /**< 剎車已解除 */
} TC100_ENUM_16 tc100_fault_code;

/** Source: 5.1 L1164 */
typedef enum tc100_rotation_direction {
    TC100_ROTATION_DIRECTION_CLOCKWISE = 0, /**< CW */
    TC100_ROTATION_DIRECTION_COUNTERCLOCKWISE = 1 /**< CCW */
} TC100_ENUM_16 tc100_rotation_direction;

/** Source: 5.1 L1165 */
typedef enum tc100_pulse_input_form {
    TC100_PULSE_INPUT_FORM_CLOCKWISE_AND_COUNTERCLOCKWISE = 0, /**< CW/CCW One pulse train for each direction. */
    TC100_PULSE_INPUT_FORM_PULSE_AND_DIRECTION = 1, /**< PULSE/DIR */
    TC100_PULSE_INPUT_FORM_TWO_PHASES = 2 /**< A 相 /B 相 */
} TC100_ENUM_16 tc100_pulse_input_form;

/** Source: 5.3 L1184 */
typedef enum tc100_control_mode {
    TC100_CONTROL_MODE_POSITION_MODE = 0, /**< 位置模式 */
    TC100_CONTROL_MODE_TORQUE_MODE = 1 /**< 扭力模式 */
} TC100_ENUM_16 tc100_control_mode;

/**
 * Note: 0 is on. The servo status 100CH numbers the states the other way round.
 * Source: 5.3 L1185; 8.2 L1622
 */
typedef enum tc100_servo_command {
    TC100_SERVO_COMMAND_SERVO_ON = 0, /**< 伺服ON */
    TC100_SERVO_COMMAND_SERVO_OFF = 1 /**< 伺服OFF */
} TC100_ENUM_16 tc100_servo_command;

/** Source: 5.6 L1242 */
typedef enum tc100_moving_state_rule {
    TC100_MOVING_STATE_RULE_PULSES_SENT = 0, /**< When all pulses of the move have been given out. */
    TC100_MOVING_STATE_RULE_PULSES_SENT_AND_IN_POSITION = 1 /**< When all pulses of the move have been given out and the in position signal is on. */
} TC100_ENUM_16 tc100_moving_state_rule;

/** Source: 5.7 L1253 */
typedef enum tc100_homing_mode {
    TC100_HOMING_MODE_TORQUE_POSITIVE = 0, /**< 扭力復歸 + 方向 Positive direction until the torque limit. */
    TC100_HOMING_MODE_TORQUE_NEGATIVE = 1, /**< 扭力復歸 - 方向 Negative direction until the torque limit. */
    TC100_HOMING_MODE_TORQUE_POSITIVE_THEN_Z_PHASE = 2, /**< 扭力復歸 + 方向後，反向找 Z 相 Positive direction until the torque limit, then back to the Z phase. */
    TC100_HOMING_MODE_TORQUE_NEGATIVE_THEN_Z_PHASE = 3, /**< 扭力復歸 - 方向後，反向找 Z 相 Negative direction until the torque limit, then back to the Z phase. */
    TC100_HOMING_MODE_SENSOR_POSITIVE = 4, /**< + 方向找 ORG_SIG 信號 Positive direction until the homing sensor. */
    TC100_HOMING_MODE_SENSOR_NEGATIVE = 5, /**< - 方向找 ORG_SIG 信號 Negative direction until the homing sensor. */
    TC100_HOMING_MODE_SENSOR_POSITIVE_THEN_Z_PHASE = 6, /**< + 方向找 ORG_SIG 信號後，反向找 Z 相 Positive direction until the homing sensor, then back to the Z phase. */
    TC100_HOMING_MODE_SENSOR_NEGATIVE_THEN_Z_PHASE = 7 /**< - 方向找 ORG_SIG 信號後，反向找 Z 相 Negative direction until the homing sensor, then back to the Z phase. */
} TC100_ENUM_16 tc100_homing_mode;

/** Source: 5.8 L1271 */
typedef enum tc100_baud_rate {
    TC100_BAUD_RATE_BAUD_9600 = 0, /**< 9600bps */
    TC100_BAUD_RATE_BAUD_19200 = 1, /**< 19200bps */
    TC100_BAUD_RATE_BAUD_38400 = 2, /**< 38400bps */
    TC100_BAUD_RATE_BAUD_57600 = 3, /**< 57600bps */
    TC100_BAUD_RATE_BAUD_115200 = 4 /**< 115200bps */
} TC100_ENUM_16 tc100_baud_rate;

/** Source: 5.8 L1272 */
typedef enum tc100_data_bits {
    TC100_DATA_BITS_EIGHT_BITS = 0, /**< 8bit */
    TC100_DATA_BITS_SEVEN_BITS = 1 /**< 7bit */
} TC100_ENUM_16 tc100_data_bits;

/** Source: 5.8 L1273 */
typedef enum tc100_parity {
    TC100_PARITY_NO_PARITY = 0, /**< None */
    TC100_PARITY_EVEN_PARITY = 1, /**< Even */
    TC100_PARITY_ODD_PARITY = 2 /**< Odd */
} TC100_ENUM_16 tc100_parity;

/** Source: 5.8 L1275 */
typedef enum tc100_protocol {
    TC100_PROTOCOL_MODBUS_ASCII = 0, /**< MODBUS-ASCII */
    TC100_PROTOCOL_MODBUS_RTU = 1 /**< MODBUS-RTU */
} TC100_ENUM_16 tc100_protocol;

/** Source: 8.2 L1506 */
typedef enum tc100_action_status {
    TC100_ACTION_STATUS_STOPPED = 0, /**< 停止 */
    TC100_ACTION_STATUS_MOVING = 1, /**< 動作中 */
    TC100_ACTION_STATUS_STOPPED_BY_ERROR = 2 /**< 異常停止 An abnormal stop. */
} TC100_ENUM_16 tc100_action_status;

/** Source: 8.2 L1620 */
typedef enum tc100_torque_search_direction {
    TC100_TORQUE_SEARCH_DIRECTION_POSITIVE = 0, /**< + 方向 */
    TC100_TORQUE_SEARCH_DIRECTION_NEGATIVE = 1 /**< - 方向 */
} TC100_ENUM_16 tc100_torque_search_direction;

/**
 * Note: Points number the same motions differently: homing is 3 here and 2 in a point's mode.
 * Source: 8.2 L1624
 */
typedef enum tc100_motion_command {
    TC100_MOTION_COMMAND_RELATIVE_MOVE = 0, /**< INC 相對位置移動 Moves by the distance in 2000H. */
    TC100_MOTION_COMMAND_ABSOLUTE_MOVE = 1, /**< ABS 絶對位置移動 Moves to the position in 2002H. */
    TC100_MOTION_COMMAND_TORQUE_SEARCH = 2, /**< TSL 扭力搜尋移動 Moves in the direction of 2005H until the torque limit. */
    TC100_MOTION_COMMAND_HOMING = 3, /**< ORG 原點復歸 */
    TC100_MOTION_COMMAND_PRESET_POSITION = 4, /**< 設定指令和現在位置數據值 Gives the commanded and the present position the value in 2006H. */
    TC100_MOTION_COMMAND_ALARM_RESET = 6, /**< 警報重置 */
    TC100_MOTION_COMMAND_CLEAR_DEVIATION = 7, /**< 偏差清除 Makes the commanded position equal to the present one. */
    TC100_MOTION_COMMAND_DECELERATE_AND_STOP = 8, /**< 減速停止 */
    TC100_MOTION_COMMAND_EMERGENCY_STOP = 9, /**< 緊急停止 */
    TC100_MOTION_COMMAND_JOG_POSITIVE = 11, /**< + JOG Jogs in the positive direction. How long is not described. */
    TC100_MOTION_COMMAND_JOG_NEGATIVE = 12 /**< - JOG Jogs in the negative direction. How long is not described. */
} TC100_ENUM_16 tc100_motion_command;

/** Source: 8.2 L1667 */
typedef enum tc100_parameter_storage {
    TC100_PARAMETER_STORAGE_PRESENT_PARAMETERS = 0, /**< 當前參數 The parameters as they are. */
    TC100_PARAMETER_STORAGE_DEFAULT_PARAMETERS = 1 /**< 默認數據 The default values. */
} TC100_ENUM_16 tc100_parameter_storage;

/**
 * Other values may occur.
 * Note: The gripper software of 9.5 has the modes CLOSE, CLOSE-R, OPEN and OPEN-R too. Their codes are not
 * printed; the values may be among those that are called unavailable here, so values without a name are passed
 * on.
 * Note: The vendor's software numbers its list of modes by itself: its 05 and 06 are INC-R and ABS-R (9.3),
 * which are 12 and 13 on the wire.
 * Note: The motion command 201EH numbers the same motions differently: homing is 3 there and 2 here.
 * Note: Nine modes are available (4.1).
 * Source: 8.2 L1648
 */
typedef enum tc100_point_mode {
    TC100_POINT_MODE_RELATIVE_MOVE = 0, /**< INC 相對位置移動 Moves by the distance. */
    TC100_POINT_MODE_ABSOLUTE_MOVE = 1, /**< ABS 絶對位置移動 Moves to the position. */
    TC100_POINT_MODE_HOMING = 2, /**< ORG 原點復歸 */
    TC100_POINT_MODE_TORQUE_SEARCH_POSITIVE = 3, /**< + TSL 正方向扭力搜尋移動 Moves in the positive direction until the torque limit, or to the end of the stroke. */
    TC100_POINT_MODE_TORQUE_SEARCH_NEGATIVE = 4, /**< - TSL 負方向扭力搜尋移動 Moves in the negative direction until the torque limit, or to the end of the stroke. */
    TC100_POINT_MODE_RELATIVE_MOVE_CONTINUOUS = 12, /**< INC-R 相對位置移動 (連續移動) Moves by the distance and on to the next point without a stop, changing speed. */
    TC100_POINT_MODE_ABSOLUTE_MOVE_CONTINUOUS = 13, /**< ABS-R 絶對位置移動 (連續移動) Moves to the position and on to the next point without a stop, changing speed. */
    TC100_POINT_MODE_RELATIVE_MOVE_WITH_TORQUE = 15, /**< INC-T 相對位置移動 [扭力模式] Moves by the distance with the torque limit; stops and reports when more torque is needed. */
    TC100_POINT_MODE_ABSOLUTE_MOVE_WITH_TORQUE = 16 /**< ABS-T 絶對位置移動 [扭力模式] Moves to the position with the torque limit; stops and reports when more torque is needed. */
} TC100_ENUM_16 tc100_point_mode;

/* ---- Bit fields ---- */

/**
 * All simulated inputs.
 * A word of 16 bits.
 * Source: 8.2 L1625
 */
typedef uint16_t tc100_simulated_input_word;

/**
 * Printed as IN1.
 * Source: 8.2 L1625
 */
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_1_MASK 0x0001u
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_1_SHIFT 0u

/**
 * Printed as IN2.
 * Source: 8.2 L1625
 */
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_2_MASK 0x0002u
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_2_SHIFT 1u

/**
 * Printed as IN3.
 * Source: 8.2 L1625
 */
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_3_MASK 0x0004u
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_3_SHIFT 2u

/**
 * Printed as IN4.
 * Source: 8.2 L1625
 */
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_4_MASK 0x0008u
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_4_SHIFT 3u

/**
 * Printed as IN5.
 * Source: 8.2 L1625
 */
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_5_MASK 0x0010u
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_5_SHIFT 4u

/**
 * Printed as IN6.
 * Source: 8.2 L1625
 */
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_6_MASK 0x0020u
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_6_SHIFT 5u

/**
 * Printed as IN7.
 * Source: 8.2 L1625
 */
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_7_MASK 0x0040u
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_7_SHIFT 6u

/**
 * Printed as IN8.
 * Source: 8.2 L1625
 */
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_8_MASK 0x0080u
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_8_SHIFT 7u

/**
 * Printed as IN9.
 * Source: 8.2 L1625
 */
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_9_MASK 0x0100u
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_9_SHIFT 8u

/**
 * Printed as IN10.
 * Source: 8.2 L1625
 */
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_10_MASK 0x0200u
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_10_SHIFT 9u

/**
 * Printed as IN11.
 * Source: 8.2 L1625
 */
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_11_MASK 0x0400u
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_11_SHIFT 10u

/**
 * Printed as IN12.
 * Source: 8.2 L1625
 */
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_12_MASK 0x0800u
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_12_SHIFT 11u

/**
 * Printed as IN13.
 * Source: 8.2 L1625
 */
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_13_MASK 0x1000u
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_13_SHIFT 12u

/**
 * Printed as IN14.
 * Source: 8.2 L1625
 */
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_14_MASK 0x2000u
#define TC100_SIMULATED_INPUT_WORD_SIMULATED_INPUT_14_SHIFT 13u

/**
 * All outputs.
 * A word of 16 bits.
 * Source: 8.2 L1517
 */
typedef uint16_t tc100_output_word;

/**
 * Printed as OUT 1.
 * Source: 8.2 L1517
 */
#define TC100_OUTPUT_WORD_OUTPUT_1_MASK 0x0001u
#define TC100_OUTPUT_WORD_OUTPUT_1_SHIFT 0u

/**
 * Printed as OUT 2.
 * Source: 8.2 L1517
 */
#define TC100_OUTPUT_WORD_OUTPUT_2_MASK 0x0002u
#define TC100_OUTPUT_WORD_OUTPUT_2_SHIFT 1u

/**
 * Printed as OUT 3.
 * Source: 8.2 L1517
 */
#define TC100_OUTPUT_WORD_OUTPUT_3_MASK 0x0004u
#define TC100_OUTPUT_WORD_OUTPUT_3_SHIFT 2u

/**
 * Printed as OUT 4.
 * Source: 8.2 L1517
 */
#define TC100_OUTPUT_WORD_OUTPUT_4_MASK 0x0008u
#define TC100_OUTPUT_WORD_OUTPUT_4_SHIFT 3u

/**
 * Printed as OUT 5.
 * Source: 8.2 L1517
 */
#define TC100_OUTPUT_WORD_OUTPUT_5_MASK 0x0010u
#define TC100_OUTPUT_WORD_OUTPUT_5_SHIFT 4u

/**
 * Printed as OUT 6.
 * Source: 8.2 L1517
 */
#define TC100_OUTPUT_WORD_OUTPUT_6_MASK 0x0020u
#define TC100_OUTPUT_WORD_OUTPUT_6_SHIFT 5u

/**
 * Printed as OUT 7.
 * Source: 8.2 L1517
 */
#define TC100_OUTPUT_WORD_OUTPUT_7_MASK 0x0040u
#define TC100_OUTPUT_WORD_OUTPUT_7_SHIFT 6u

/**
 * Printed as OUT 8.
 * Source: 8.2 L1517
 */
#define TC100_OUTPUT_WORD_OUTPUT_8_MASK 0x0080u
#define TC100_OUTPUT_WORD_OUTPUT_8_SHIFT 7u

/**
 * Printed as OUT 9.
 * Source: 8.2 L1517
 */
#define TC100_OUTPUT_WORD_OUTPUT_9_MASK 0x0100u
#define TC100_OUTPUT_WORD_OUTPUT_9_SHIFT 8u

/**
 * Printed as OUT 10.
 * Source: 8.2 L1517
 */
#define TC100_OUTPUT_WORD_OUTPUT_10_MASK 0x0200u
#define TC100_OUTPUT_WORD_OUTPUT_10_SHIFT 9u

/**
 * All inputs.
 * A word of 16 bits.
 * Source: 8.2 L1531
 */
typedef uint16_t tc100_input_word;

/**
 * Printed as IN 1.
 * Source: 8.2 L1531
 */
#define TC100_INPUT_WORD_INPUT_1_MASK 0x0001u
#define TC100_INPUT_WORD_INPUT_1_SHIFT 0u

/**
 * Printed as IN 2.
 * Source: 8.2 L1531
 */
#define TC100_INPUT_WORD_INPUT_2_MASK 0x0002u
#define TC100_INPUT_WORD_INPUT_2_SHIFT 1u

/**
 * Printed as IN 3.
 * Source: 8.2 L1531
 */
#define TC100_INPUT_WORD_INPUT_3_MASK 0x0004u
#define TC100_INPUT_WORD_INPUT_3_SHIFT 2u

/**
 * Printed as IN 4.
 * Source: 8.2 L1531
 */
#define TC100_INPUT_WORD_INPUT_4_MASK 0x0008u
#define TC100_INPUT_WORD_INPUT_4_SHIFT 3u

/**
 * Printed as IN 5.
 * Source: 8.2 L1531
 */
#define TC100_INPUT_WORD_INPUT_5_MASK 0x0010u
#define TC100_INPUT_WORD_INPUT_5_SHIFT 4u

/**
 * Printed as IN 6.
 * Source: 8.2 L1531
 */
#define TC100_INPUT_WORD_INPUT_6_MASK 0x0020u
#define TC100_INPUT_WORD_INPUT_6_SHIFT 5u

/**
 * Printed as IN 7.
 * Source: 8.2 L1531
 */
#define TC100_INPUT_WORD_INPUT_7_MASK 0x0040u
#define TC100_INPUT_WORD_INPUT_7_SHIFT 6u

/**
 * Printed as IN 8.
 * Source: 8.2 L1531
 */
#define TC100_INPUT_WORD_INPUT_8_MASK 0x0080u
#define TC100_INPUT_WORD_INPUT_8_SHIFT 7u

/**
 * Printed as IN 9.
 * Source: 8.2 L1531
 */
#define TC100_INPUT_WORD_INPUT_9_MASK 0x0100u
#define TC100_INPUT_WORD_INPUT_9_SHIFT 8u

/**
 * Printed as IN 10.
 * Source: 8.2 L1531
 */
#define TC100_INPUT_WORD_INPUT_10_MASK 0x0200u
#define TC100_INPUT_WORD_INPUT_10_SHIFT 9u

/**
 * Printed as IN 11.
 * Source: 8.2 L1531
 */
#define TC100_INPUT_WORD_INPUT_11_MASK 0x0400u
#define TC100_INPUT_WORD_INPUT_11_SHIFT 10u

/**
 * Printed as IN 12.
 * Source: 8.2 L1531
 */
#define TC100_INPUT_WORD_INPUT_12_MASK 0x0800u
#define TC100_INPUT_WORD_INPUT_12_SHIFT 11u

/**
 * Printed as IN 13.
 * Source: 8.2 L1531
 */
#define TC100_INPUT_WORD_INPUT_13_MASK 0x1000u
#define TC100_INPUT_WORD_INPUT_13_SHIFT 12u

/**
 * Printed as IN 14.
 * Source: 8.2 L1531
 */
#define TC100_INPUT_WORD_INPUT_14_MASK 0x2000u
#define TC100_INPUT_WORD_INPUT_14_SHIFT 13u

/**
 * Printed as Z 相.
 * Source: 8.2 L1531
 */
#define TC100_INPUT_WORD_Z_PHASE_MASK 0x4000u
#define TC100_INPUT_WORD_Z_PHASE_SHIFT 14u

/* ---- Records ---- */

#define TC100_EXCEPTION_SIZE 1u

#define TC100_POINT_SIZE 28u

/* ---- Data of requests and responses ---- */

/**
 * Reads neighbouring registers.
 * Printed as 03 H 資料讀取.
 * Read holding registers.
 * Source: 8.2 L1710
 */
#define TC100_READ_REGISTERS_CODE 3u

#define TC100_READ_REGISTERS_REQUEST_SIZE 4u

#define TC100_READ_REGISTERS_RESPONSE_SIZE 121u

/**
 * Writes one register. The response repeats the request.
 * Printed as 06 H 資料寫入 (1Word).
 * Write one register.
 * Source: 8.2 L1711
 */
#define TC100_WRITE_REGISTER_CODE 6u

#define TC100_WRITE_REGISTER_REQUEST_SIZE 4u

#define TC100_WRITE_REGISTER_RESPONSE_SIZE 4u

/**
 * Writes neighbouring registers. The response repeats the address and the number.
 * Printed as 10 H 連續資料寫入 (1Word 以上).
 * Write several registers.
 * Note: The manual gives 59, 60 and 63 words as the most that one request may write; the least of them is
 * safe.
 * Source: 8.2 L1712
 */
#define TC100_WRITE_REGISTERS_CODE 16u

#define TC100_WRITE_REGISTERS_REQUEST_SIZE 123u

#define TC100_WRITE_REGISTERS_RESPONSE_SIZE 4u

/* ---- Registers ---- */

/**
 * Jogs in the positive direction while MANUAL is on.
 * Printed as JOG+ + JOG 移動.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.4 L1193
 */
#define TC100_REG_JOG_POSITIVE_INPUT_ADDRESS 0x0601u
#define TC100_REG_JOG_POSITIVE_INPUT_WORDS 1u

/**
 * Jogs in the negative direction while MANUAL is on.
 * Printed as JOG- - JOG 移動.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.4 L1194
 */
#define TC100_REG_JOG_NEGATIVE_INPUT_ADDRESS 0x0602u
#define TC100_REG_JOG_NEGATIVE_INPUT_WORDS 1u

/**
 * Printed as MANUAL 手動模式.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.4 L1195
 */
#define TC100_REG_MANUAL_MODE_INPUT_ADDRESS 0x0603u
#define TC100_REG_MANUAL_MODE_INPUT_WORDS 1u

/**
 * Stores the present position in the selected point while MANUAL is on.
 * Printed as TEACH 點位置存入.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.4 L1196
 */
#define TC100_REG_TEACH_INPUT_ADDRESS 0x0604u
#define TC100_REG_TEACH_INPUT_WORDS 1u

/**
 * Pause, interlock.
 * Printed as LOCK 暫停 / 聯鎖.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.4 L1197
 */
#define TC100_REG_LOCK_INPUT_ADDRESS 0x0607u
#define TC100_REG_LOCK_INPUT_WORDS 1u

/**
 * Printed as PRGSEL4 程式選擇 No.0~127 Bit4.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.4 L1198
 */
#define TC100_REG_POINT_SELECT_BIT_4_INPUT_ADDRESS 0x060Eu
#define TC100_REG_POINT_SELECT_BIT_4_INPUT_WORDS 1u

/**
 * Printed as PRGSEL5 程式選擇 No.0~127 Bit5.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.4 L1199
 */
#define TC100_REG_POINT_SELECT_BIT_5_INPUT_ADDRESS 0x060Fu
#define TC100_REG_POINT_SELECT_BIT_5_INPUT_WORDS 1u

/**
 * Printed as PRGSEL6 程式選擇 No.0~127 Bit6.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.4 L1200
 */
#define TC100_REG_POINT_SELECT_BIT_6_INPUT_ADDRESS 0x0610u
#define TC100_REG_POINT_SELECT_BIT_6_INPUT_WORDS 1u

/**
 * Printed as ORG_SIG 原點復歸用檢出信號.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.4 L1201
 */
#define TC100_REG_HOMING_SENSOR_INPUT_ADDRESS 0x0611u
#define TC100_REG_HOMING_SENSOR_INPUT_WORDS 1u

/**
 * Switches the brake while the servo is off.
 * Printed as BK_OFF 制動 ON/OFF 信號.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.4 L1202
 */
#define TC100_REG_BRAKE_INPUT_ADDRESS 0x0612u
#define TC100_REG_BRAKE_INPUT_WORDS 1u

/**
 * Switches the detection of full count, which is active initially.
 * Printed as FULL_COUNT 切換 FULL-COUNT 判斷.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.4 L1203
 */
#define TC100_REG_FULL_COUNT_INPUT_ADDRESS 0x0613u
#define TC100_REG_FULL_COUNT_INPUT_WORDS 1u

/**
 * Printed as INPOSITION Inposition 到位信號.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1209
 */
#define TC100_REG_IN_POSITION_OUTPUT_ADDRESS 0x0700u
#define TC100_REG_IN_POSITION_OUTPUT_WORDS 1u

/**
 * Printed as ALARM 錯誤信號.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1210
 */
#define TC100_REG_ALARM_OUTPUT_ADDRESS 0x0701u
#define TC100_REG_ALARM_OUTPUT_WORDS 1u

/**
 * Ready for the next point.
 * Printed as READY 準備完成，可執行下一點位.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1211
 */
#define TC100_REG_READY_OUTPUT_ADDRESS 0x0702u
#define TC100_REG_READY_OUTPUT_WORDS 1u

/**
 * Printed as MOVE 移動中.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1212
 */
#define TC100_REG_MOVING_OUTPUT_ADDRESS 0x0703u
#define TC100_REG_MOVING_OUTPUT_WORDS 1u

/**
 * Printed as SERVO-S SERVO ON 狀態.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1213
 */
#define TC100_REG_SERVO_ON_OUTPUT_ADDRESS 0x0705u
#define TC100_REG_SERVO_ON_OUTPUT_WORDS 1u

/**
 * Printed as PRGSEL0-S 程式選擇 No.0~127 Bit0.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1214
 */
#define TC100_REG_POINT_SELECT_BIT_0_OUTPUT_ADDRESS 0x0706u
#define TC100_REG_POINT_SELECT_BIT_0_OUTPUT_WORDS 1u

/**
 * Printed as PRGSEL1-S 程式選擇 No.0~127 Bit1.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1215
 */
#define TC100_REG_POINT_SELECT_BIT_1_OUTPUT_ADDRESS 0x0707u
#define TC100_REG_POINT_SELECT_BIT_1_OUTPUT_WORDS 1u

/**
 * Printed as PRGSEL2-S 程式選擇 No.0~127 Bit2.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1216
 */
#define TC100_REG_POINT_SELECT_BIT_2_OUTPUT_ADDRESS 0x0708u
#define TC100_REG_POINT_SELECT_BIT_2_OUTPUT_WORDS 1u

/**
 * Printed as PRGSEL3-S 程式選擇 No.0~127 Bit3.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1217
 */
#define TC100_REG_POINT_SELECT_BIT_3_OUTPUT_ADDRESS 0x0709u
#define TC100_REG_POINT_SELECT_BIT_3_OUTPUT_WORDS 1u

/**
 * Printed as PRGSEL4-S 程式選擇 No.0~127 Bit4.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1218
 */
#define TC100_REG_POINT_SELECT_BIT_4_OUTPUT_ADDRESS 0x070Au
#define TC100_REG_POINT_SELECT_BIT_4_OUTPUT_WORDS 1u

/**
 * Printed as PRGSEL5-S 程式選擇 No.0~127 Bit5.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1219
 */
#define TC100_REG_POINT_SELECT_BIT_5_OUTPUT_ADDRESS 0x070Bu
#define TC100_REG_POINT_SELECT_BIT_5_OUTPUT_WORDS 1u

/**
 * Printed as PRGSEL6-S 程式選擇 No.0~127 Bit6.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1220
 */
#define TC100_REG_POINT_SELECT_BIT_6_OUTPUT_ADDRESS 0x070Cu
#define TC100_REG_POINT_SELECT_BIT_6_OUTPUT_WORDS 1u

/**
 * Called TRQLIM in 6.2 and 7.5.
 * Printed as TRQ_LMT 扭力極限.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1221
 */
#define TC100_REG_TORQUE_LIMIT_OUTPUT_ADDRESS 0x070Du
#define TC100_REG_TORQUE_LIMIT_OUTPUT_WORDS 1u

/**
 * Printed as ERR0 錯誤編碼 Bit0.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Note: 6.4 says that ERR0 to ERR3 show 16 states in binary. It does not say whether they carry alarms or
 * faults; alarm 17 does not fit four bits.
 * Source: 5.5 L1222
 */
#define TC100_REG_ERROR_BIT_0_OUTPUT_ADDRESS 0x070Eu
#define TC100_REG_ERROR_BIT_0_OUTPUT_WORDS 1u

/**
 * Printed as ERR1 錯誤編碼 Bit1.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1223
 */
#define TC100_REG_ERROR_BIT_1_OUTPUT_ADDRESS 0x070Fu
#define TC100_REG_ERROR_BIT_1_OUTPUT_WORDS 1u

/**
 * Printed as ERR2 錯誤編碼 Bit2.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1224
 */
#define TC100_REG_ERROR_BIT_2_OUTPUT_ADDRESS 0x0710u
#define TC100_REG_ERROR_BIT_2_OUTPUT_WORDS 1u

/**
 * Printed as ERR3 錯誤編碼 Bit3.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1225
 */
#define TC100_REG_ERROR_BIT_3_OUTPUT_ADDRESS 0x0711u
#define TC100_REG_ERROR_BIT_3_OUTPUT_WORDS 1u

/**
 * On while the position is inside the zone of the point.
 * Printed as INRANGE 區間設定範圍內輸出.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1226
 */
#define TC100_REG_ZONE_OUTPUT_ADDRESS 0x0712u
#define TC100_REG_ZONE_OUTPUT_WORDS 1u

/**
 * On near the target, see 011DH; the target is that of a point in mode ABS or INC.
 * Printed as NEAR 當移動至目標位置的範圍內時輸出.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1227
 */
#define TC100_REG_NEAR_OUTPUT_ADDRESS 0x0713u
#define TC100_REG_NEAR_OUTPUT_WORDS 1u

/**
 * On when the position has reached a soft limit.
 * Printed as SOFTLMT 軟體極限輸出燈號.
 * Read and write. A change takes effect after a restart.
 * 0 means not_used.
 * Source: 5.5 L1228
 */
#define TC100_REG_SOFT_LIMIT_OUTPUT_ADDRESS 0x0714u
#define TC100_REG_SOFT_LIMIT_OUTPUT_WORDS 1u

/**
 * The distance of a relative move in position or torque control.
 * Printed as INCamount 相對移動量.
 * Read and write.
 * Note: One count is 0.01 mm or 1 pulse; what decides between them is not printed.
 * Source: 8.2 L1618
 */
#define TC100_REG_RELATIVE_DISTANCE_ADDRESS 0x2000u
#define TC100_REG_RELATIVE_DISTANCE_WORDS 2u
#define TC100_REG_RELATIVE_DISTANCE_DEFAULT 0

/**
 * The target of an absolute move in position or torque control.
 * Printed as ABSSamount 絕對移動量.
 * Read and write.
 * Note: One count is 0.01 mm or 1 pulse; what decides between them is not printed.
 * Source: 8.2 L1619
 */
#define TC100_REG_ABSOLUTE_POSITION_ADDRESS 0x2002u
#define TC100_REG_ABSOLUTE_POSITION_WORDS 2u
#define TC100_REG_ABSOLUTE_POSITION_DEFAULT 0

/**
 * The direction of the torque search of 201EH.
 * Printed as TrqStopDir 扭力停止搜尋方向.
 * Read and write.
 * Range: 0..1. See torque_search_direction.
 * Note: In points, each direction is a mode of its own.
 * Source: 8.2 L1620
 */
#define TC100_REG_TORQUE_SEARCH_DIRECTION_ADDRESS 0x2005u
#define TC100_REG_TORQUE_SEARCH_DIRECTION_WORDS 1u
#define TC100_REG_TORQUE_SEARCH_DIRECTION_MIN 0u
#define TC100_REG_TORQUE_SEARCH_DIRECTION_MAX 1u

/**
 * The value that command 4 of 201EH gives to the commanded and the present position.
 * Printed as PosAmount 位置指定資料.
 * Read and write.
 * Note: One count is 0.01 mm or 1 pulse; what decides between them is not printed.
 * Source: 8.2 L1621
 */
#define TC100_REG_PRESET_POSITION_ADDRESS 0x2006u
#define TC100_REG_PRESET_POSITION_WORDS 2u
#define TC100_REG_PRESET_POSITION_DEFAULT 0

/**
 * Switches the servo.
 * Printed as Servo ON/OFF 伺服ON/OFF.
 * Read and write.
 * Range: 0..1. See servo_command.
 * Note: 0 is on and 1 is off. The servo status 100CH says it the other way round.
 * Source: 8.2 L1622
 */
#define TC100_REG_SERVO_ADDRESS 0x2011u
#define TC100_REG_SERVO_WORDS 1u
#define TC100_REG_SERVO_MIN 0u
#define TC100_REG_SERVO_MAX 1u

/**
 * The speed of relative and absolute moves and of jogging by 201EH, a percentage of the maximum speed 0802H.
 * Printed as MovSpeedSet 位置 / 扭力控制動作速度設定.
 * Read and write.
 * One count is 1 %. Range: 0..100. 0 means start_speed.
 * Source: 8.2 L1623
 */
#define TC100_REG_MOTION_SPEED_ADDRESS 0x2014u
#define TC100_REG_MOTION_SPEED_WORDS 1u
#define TC100_REG_MOTION_SPEED_MIN 0u
#define TC100_REG_MOTION_SPEED_MAX 100u

/**
 * Writing a value starts the action that it names.
 * Printed as MovType 移動類型.
 * The manual does not say how it is accessed. Writing starts an action.
 * Range: 0..12. See motion_command.
 * Source: 8.2 L1624
 */
#define TC100_REG_MOTION_COMMAND_ADDRESS 0x201Eu
#define TC100_REG_MOTION_COMMAND_WORDS 1u
#define TC100_REG_MOTION_COMMAND_MIN 0u
#define TC100_REG_MOTION_COMMAND_MAX 12u

/**
 * All simulated inputs at once.
 * Printed as 模擬輸入設定(二進制).
 * Read and write.
 * Range: 0..16383. See simulated_input_word.
 * Source: 8.2 L1625
 */
#define TC100_REG_SIMULATED_INPUTS_ADDRESS 0x2040u
#define TC100_REG_SIMULATED_INPUTS_WORDS 1u
#define TC100_REG_SIMULATED_INPUTS_MIN 0u
#define TC100_REG_SIMULATED_INPUTS_MAX 16383u

/**
 * One simulated input; 1 is on. The controller receives this value or the signal at the terminal.
 * Printed as 模擬輸入設定.
 * Read and write.
 * Range: 0..1.
 * Source: 8.2 L1626-1632, 1636-1642
 */
#define TC100_REG_SIMULATED_INPUT_ADDRESS 0x2041u
#define TC100_REG_SIMULATED_INPUT_WORDS 1u
#define TC100_REG_SIMULATED_INPUT_COUNT 14u
#define TC100_REG_SIMULATED_INPUT_STRIDE 1u
#define TC100_REG_SIMULATED_INPUT_FIRST 1u
#define TC100_REG_SIMULATED_INPUT_MIN 0u
#define TC100_REG_SIMULATED_INPUT_MAX 1u

/**
 * Stores the parameters.
 * Printed as 參數儲存.
 * The manual does not say how it is accessed. Writing starts an action.
 * Range: 0..1. See parameter_storage.
 * Note: Which parameters and whether points too are stored is not printed, nor whether 1 stores the default
 * values or brings them back, nor how long it takes, nor what reading gives.
 * Source: 8.2 L1667
 */
#define TC100_REG_PARAMETER_STORAGE_ADDRESS 0x9999u
#define TC100_REG_PARAMETER_STORAGE_WORDS 1u
#define TC100_REG_PARAMETER_STORAGE_MIN 0u
#define TC100_REG_PARAMETER_STORAGE_MAX 1u

/**
 * Writing the four words 4C76 3031 5479 5667 opens writing. As characters they read Lv01TyVg.
 * Printed as 開放寫入指令.
 * Write only. Writing starts an action.
 * Note: What needs it, how long it lasts and whether other keys exist is not printed; a flow chart of writing
 * parameters that followed is not in the text. Fault 11 (parameter write not permitted) asks for a higher
 * write level.
 * Source: 8.2 L1669, 1673-1675
 */
#define TC100_REG_WRITE_ENABLE_KEY_ADDRESS 0x999Bu
#define TC100_REG_WRITE_ENABLE_KEY_WORDS 4u
#define TC100_REG_WRITE_ENABLE_KEY_VALUE UINT64_C(5509644182563149415)

/**
 * The full count alarm is raised when the actual position is further than this from the commanded one.
 * Printed as FullCountValue 計數器溢位警報值.
 * Read and write.
 * One count is 1 pulse. Range: 1..100000.
 * Note: 5.1 prints no range; it is taken from the two screens of chapter 9. They show 100 and 200 as values,
 * which depend on the actuator and are not defaults.
 * Source: 5.1 L1160
 */
#define TC100_REG_FULL_COUNT_LIMIT_ADDRESS 0x0108u
#define TC100_REG_FULL_COUNT_LIMIT_WORDS 2u
#define TC100_REG_FULL_COUNT_LIMIT_MIN 1u
#define TC100_REG_FULL_COUNT_LIMIT_MAX 100000u

/**
 * The in position signal is on while the actual position is nearer than this to the commanded one.
 * Printed as InPositionZone INPOSITION 信號的到位區間範圍設定.
 * Read and write.
 * One count is 1 pulse. Range: 0..1000.
 * Note: A large value, or a slow motion, can keep the signal on all the time.
 * Source: 5.1 L1161
 */
#define TC100_REG_IN_POSITION_ZONE_ADDRESS 0x010Au
#define TC100_REG_IN_POSITION_ZONE_WORDS 1u
#define TC100_REG_IN_POSITION_ZONE_MIN 0u
#define TC100_REG_IN_POSITION_ZONE_MAX 1000u

/**
 * With the denominator: the encoder pulses of one motor revolution after the change are the basic ones divided
 * by (numerator / denominator).
 * Printed as ElectroGearNum 電子齒輪分子.
 * Read and write. A change takes effect after a restart.
 * Range: 1..10000.
 * Note: The vendor's software shows it in pulse control only.
 * Source: 5.1 L1162
 */
#define TC100_REG_ELECTRONIC_GEAR_NUMERATOR_ADDRESS 0x010Bu
#define TC100_REG_ELECTRONIC_GEAR_NUMERATOR_WORDS 1u
#define TC100_REG_ELECTRONIC_GEAR_NUMERATOR_MIN 1u
#define TC100_REG_ELECTRONIC_GEAR_NUMERATOR_MAX 10000u
#define TC100_REG_ELECTRONIC_GEAR_NUMERATOR_DEFAULT 1u

/**
 * See the numerator.
 * Printed as ElectroGearDen 電子齒輪分母.
 * Read and write. A change takes effect after a restart.
 * Range: 1..10000.
 * Source: 5.1 L1163
 */
#define TC100_REG_ELECTRONIC_GEAR_DENOMINATOR_ADDRESS 0x010Cu
#define TC100_REG_ELECTRONIC_GEAR_DENOMINATOR_WORDS 1u
#define TC100_REG_ELECTRONIC_GEAR_DENOMINATOR_MIN 1u
#define TC100_REG_ELECTRONIC_GEAR_DENOMINATOR_MAX 10000u
#define TC100_REG_ELECTRONIC_GEAR_DENOMINATOR_DEFAULT 1u

/**
 * The direction in which the motor turns in control by external pulses.
 * Printed as PosDir 外部脈沖指令，旋轉方向指定.
 * Read and write. A change takes effect after a restart.
 * Range: 0..1. See rotation_direction.
 * Source: 5.1 L1164
 */
#define TC100_REG_PULSE_ROTATION_DIRECTION_ADDRESS 0x0114u
#define TC100_REG_PULSE_ROTATION_DIRECTION_WORDS 1u
#define TC100_REG_PULSE_ROTATION_DIRECTION_MIN 0u
#define TC100_REG_PULSE_ROTATION_DIRECTION_MAX 1u

/**
 * The form of the external pulses.
 * Printed as SelComPulse 外部脈衝指令形式.
 * Read and write. A change takes effect after a restart.
 * Range: 0..2. See pulse_input_form.
 * Source: 5.1 L1165
 */
#define TC100_REG_PULSE_INPUT_FORM_ADDRESS 0x0115u
#define TC100_REG_PULSE_INPUT_FORM_WORDS 1u
#define TC100_REG_PULSE_INPUT_FORM_MIN 0u
#define TC100_REG_PULSE_INPUT_FORM_MAX 2u
#define TC100_REG_PULSE_INPUT_FORM_DEFAULT 0u

/**
 * The near output is on when the target is nearer than this.
 * Printed as NearZone NEAR 信號輸出的區間範圍設定.
 * Read and write.
 * One count is 1 pulse. Range: 0..10000.
 * Source: 5.1 L1166
 */
#define TC100_REG_NEAR_ZONE_ADDRESS 0x011Du
#define TC100_REG_NEAR_ZONE_WORDS 1u
#define TC100_REG_NEAR_ZONE_MIN 0u
#define TC100_REG_NEAR_ZONE_MAX 10000u
#define TC100_REG_NEAR_ZONE_DEFAULT 4u

/**
 * The torque when pushing in the positive direction. The moves by the homing offsets 0902H and 0908H use it
 * too.
 * Printed as PushTrqRateCw + 方向的推壓，扭力值.
 * Read and write.
 * One count is 0.1 %. Range: 0..1000.
 * Source: 5.2 L1172
 */
#define TC100_REG_PUSH_TORQUE_POSITIVE_ADDRESS 0x0400u
#define TC100_REG_PUSH_TORQUE_POSITIVE_WORDS 1u
#define TC100_REG_PUSH_TORQUE_POSITIVE_MIN 0u
#define TC100_REG_PUSH_TORQUE_POSITIVE_MAX 1000u
#define TC100_REG_PUSH_TORQUE_POSITIVE_SCALE_NUMERATOR INT64_C(1)
#define TC100_REG_PUSH_TORQUE_POSITIVE_SCALE_DENOMINATOR INT64_C(10)

/**
 * The torque when pushing in the negative direction. The moves by the homing offsets 0902H and 0908H use it
 * too.
 * Printed as PushTrqRateCcw - 方向的推壓，扭力值.
 * Read and write.
 * One count is 0.1 %. Range: 0..1000.
 * Source: 5.2 L1173
 */
#define TC100_REG_PUSH_TORQUE_NEGATIVE_ADDRESS 0x0401u
#define TC100_REG_PUSH_TORQUE_NEGATIVE_WORDS 1u
#define TC100_REG_PUSH_TORQUE_NEGATIVE_MIN 0u
#define TC100_REG_PUSH_TORQUE_NEGATIVE_MAX 1000u
#define TC100_REG_PUSH_TORQUE_NEGATIVE_SCALE_NUMERATOR INT64_C(1)
#define TC100_REG_PUSH_TORQUE_NEGATIVE_SCALE_DENOMINATOR INT64_C(10)

/**
 * The time after which the torque limit counts as reached.
 * Printed as TrqLmtTime 扭力極限檢出時間.
 * Read and write. A change takes effect after a restart.
 * One count is 1 ms. Range: 0..10000.
 * Note: Homing has a time of its own, 090AH, with a range of 0 to 1000.
 * Source: 5.2 L1174
 */
#define TC100_REG_TORQUE_LIMIT_TIME_ADDRESS 0x0402u
#define TC100_REG_TORQUE_LIMIT_TIME_WORDS 1u
#define TC100_REG_TORQUE_LIMIT_TIME_MIN 0u
#define TC100_REG_TORQUE_LIMIT_TIME_MAX 10000u

/**
 * The speed of position correction is limited by 0407H.
 * Printed as RtnSpdLmtEnable 選擇有無位置補正速限.
 * Read and write.
 * Range: 0..1.
 * Source: 5.2 L1175
 */
#define TC100_REG_POSITION_CORRECTION_SPEED_LIMIT_ENABLED_ADDRESS 0x0406u
#define TC100_REG_POSITION_CORRECTION_SPEED_LIMIT_ENABLED_WORDS 1u
#define TC100_REG_POSITION_CORRECTION_SPEED_LIMIT_ENABLED_MIN 0u
#define TC100_REG_POSITION_CORRECTION_SPEED_LIMIT_ENABLED_MAX 1u
#define TC100_REG_POSITION_CORRECTION_SPEED_LIMIT_ENABLED_DEFAULT 1u

/**
 * Printed as RtnMaxSpd 位置補正速限.
 * Read and write.
 * One count is 1 rpm. Range: 10..500.
 * Source: 5.2 L1176
 */
#define TC100_REG_POSITION_CORRECTION_SPEED_LIMIT_ADDRESS 0x0407u
#define TC100_REG_POSITION_CORRECTION_SPEED_LIMIT_WORDS 1u
#define TC100_REG_POSITION_CORRECTION_SPEED_LIMIT_MIN 10u
#define TC100_REG_POSITION_CORRECTION_SPEED_LIMIT_MAX 500u
#define TC100_REG_POSITION_CORRECTION_SPEED_LIMIT_DEFAULT 10u

/**
 * The greatest torque in position mode.
 * Printed as MaxTrqRate 位置模式時最大輸出扭力設定.
 * Read and write.
 * One count is 0.1 %. Range: 0..650.
 * Note: The torque limit of a point goes to 1000 (100.0% of the rated current), this one to 650; the manual
 * does not relate the two.
 * Source: 5.3 L1182
 */
#define TC100_REG_MAXIMUM_TORQUE_ADDRESS 0x0500u
#define TC100_REG_MAXIMUM_TORQUE_WORDS 1u
#define TC100_REG_MAXIMUM_TORQUE_MIN 0u
#define TC100_REG_MAXIMUM_TORQUE_MAX 650u
#define TC100_REG_MAXIMUM_TORQUE_DEFAULT 650u
#define TC100_REG_MAXIMUM_TORQUE_SCALE_NUMERATOR INT64_C(1)
#define TC100_REG_MAXIMUM_TORQUE_SCALE_DENOMINATOR INT64_C(10)

/**
 * The time at full torque in position mode after which an error is detected.
 * Printed as FullTrqTime 位置模式時檢測完全扭力錯誤時間.
 * Read and write.
 * One count is 1 ms. Range: 500..10000.
 * Source: 5.3 L1183
 */
#define TC100_REG_FULL_TORQUE_TIME_ADDRESS 0x0501u
#define TC100_REG_FULL_TORQUE_TIME_WORDS 1u
#define TC100_REG_FULL_TORQUE_TIME_MIN 500u
#define TC100_REG_FULL_TORQUE_TIME_MAX 10000u
#define TC100_REG_FULL_TORQUE_TIME_DEFAULT 1000u

/**
 * Position mode or torque mode in control by external pulses.
 * Printed as ModeSwitch Pulse 控制下切換模式開關.
 * Read and write.
 * Range: 0..1. See control_mode.
 * Note: 5.3 calls 1 torque mode; 3.8 and 6.3 say that 1 lets the input signal CONT_MODE choose between the
 * modes. Chapter 5 has no parameter that assigns CONT_MODE to an input.
 * Source: 5.3 L1184
 */
#define TC100_REG_CONTROL_MODE_ADDRESS 0x0503u
#define TC100_REG_CONTROL_MODE_WORDS 1u
#define TC100_REG_CONTROL_MODE_MIN 0u
#define TC100_REG_CONTROL_MODE_MAX 1u
#define TC100_REG_CONTROL_MODE_DEFAULT 0u

/**
 * Whether the servo is on after power-on.
 * Printed as ServoState 電源投入後・伺服狀態設定.
 * Read and write.
 * Range: 0..1. See servo_command.
 * Note: 0 is on, as in 2011H and against 100CH, where 1 is on.
 * Source: 5.3 L1185
 */
#define TC100_REG_SERVO_AT_POWER_ON_ADDRESS 0x0515u
#define TC100_REG_SERVO_AT_POWER_ON_WORDS 1u
#define TC100_REG_SERVO_AT_POWER_ON_MIN 0u
#define TC100_REG_SERVO_AT_POWER_ON_MAX 1u
#define TC100_REG_SERVO_AT_POWER_ON_DEFAULT 0u

/**
 * No motion is possible before homing is done.
 * Printed as OrgRetRestrict 原點復歸未完成的動作限制.
 * Read and write.
 * Range: 0..1.
 * Source: 5.3 L1186
 */
#define TC100_REG_HOMING_REQUIRED_ADDRESS 0x051Bu
#define TC100_REG_HOMING_REQUIRED_WORDS 1u
#define TC100_REG_HOMING_REQUIRED_MIN 0u
#define TC100_REG_HOMING_REQUIRED_MAX 1u
#define TC100_REG_HOMING_REQUIRED_DEFAULT 1u

/**
 * The revolutions of the motor are accumulated.
 * Printed as UseTotalRev 指定馬達累積計算迴轉數的功能開關.
 * Read and write. A change takes effect after a restart.
 * Range: 0..1.
 * Note: The vendor's software shows the total (9.3); 8.2 prints no register for it.
 * Source: 5.3 L1187
 */
#define TC100_REG_TOTAL_REVOLUTIONS_ENABLED_ADDRESS 0x051Eu
#define TC100_REG_TOTAL_REVOLUTIONS_ENABLED_WORDS 1u
#define TC100_REG_TOTAL_REVOLUTIONS_ENABLED_MIN 0u
#define TC100_REG_TOTAL_REVOLUTIONS_ENABLED_MAX 1u
#define TC100_REG_TOTAL_REVOLUTIONS_ENABLED_DEFAULT 0u

/**
 * The speed that a speed setting of 0% stands for, whatever 0802H holds.
 * Printed as LowSpeed 啟動速度設定.
 * Read and write.
 * One count is 1 pps.
 * Source: 5.6 L1234
 */
#define TC100_REG_START_SPEED_ADDRESS 0x0800u
#define TC100_REG_START_SPEED_WORDS 2u

/**
 * The speed of which speed settings are a percentage: revolutions per minute / 60 * pulses of the encoder per
 * revolution.
 * Printed as HighSpeed 運轉時最高速設定.
 * Read and write.
 * One count is 1 pps.
 * Source: 5.6 L1235
 */
#define TC100_REG_MAXIMUM_SPEED_ADDRESS 0x0802u
#define TC100_REG_MAXIMUM_SPEED_WORDS 2u

/**
 * Printed as AccelTim 加速時間設定.
 * Read and write.
 * One count is 1 ms. Range: 1..30000.
 * Source: 5.6 L1236
 */
#define TC100_REG_ACCELERATION_TIME_ADDRESS 0x0804u
#define TC100_REG_ACCELERATION_TIME_WORDS 1u
#define TC100_REG_ACCELERATION_TIME_MIN 1u
#define TC100_REG_ACCELERATION_TIME_MAX 30000u

/**
 * Printed as DecelTime 減速時間設定.
 * Read and write.
 * One count is 1 ms. Range: 1..30000.
 * Source: 5.6 L1237
 */
#define TC100_REG_DECELERATION_TIME_ADDRESS 0x0805u
#define TC100_REG_DECELERATION_TIME_WORDS 1u
#define TC100_REG_DECELERATION_TIME_MIN 1u
#define TC100_REG_DECELERATION_TIME_MAX 30000u

/**
 * How far a torque search goes on after it has reached the torque limit.
 * Printed as TrqLimitPress 扭力公差設定.
 * Read and write.
 * One count is 1 pulse.
 * Source: 5.6 L1238
 */
#define TC100_REG_TORQUE_LIMIT_PRESS_DISTANCE_ADDRESS 0x0807u
#define TC100_REG_TORQUE_LIMIT_PRESS_DISTANCE_WORDS 2u

/**
 * When the moving state ends.
 * Printed as MoveSttSet 移動中的狀態設定.
 * Read and write.
 * Range: 0..1. See moving_state_rule.
 * Source: 5.6 L1242
 */
#define TC100_REG_MOVING_STATE_RULE_ADDRESS 0x080Au
#define TC100_REG_MOVING_STATE_RULE_WORDS 1u
#define TC100_REG_MOVING_STATE_RULE_MIN 0u
#define TC100_REG_MOVING_STATE_RULE_MAX 1u

/**
 * The speed of jogging by the inputs.
 * Printed as JogInchingSpd JOG 移動時速度設定.
 * Read and write.
 * One count is 0.1 %. Range: 1..1000.
 * Note: In tenths of a percent; all other speeds that are given in percent are whole percents. Jogging by
 * 201EH uses 2014H.
 * Source: 5.6 L1243
 */
#define TC100_REG_JOG_SPEED_ADDRESS 0x080Fu
#define TC100_REG_JOG_SPEED_WORDS 1u
#define TC100_REG_JOG_SPEED_MIN 1u
#define TC100_REG_JOG_SPEED_MAX 1000u
#define TC100_REG_JOG_SPEED_SCALE_NUMERATOR INT64_C(1)
#define TC100_REG_JOG_SPEED_SCALE_DENOMINATOR INT64_C(10)

/**
 * The distance of one jog by the inputs.
 * Printed as JogInchingData JOG 移動時的移動量設定.
 * Read and write.
 * One count is 1 pulse.
 * Source: 5.6 L1244
 */
#define TC100_REG_JOG_DISTANCE_ADDRESS 0x0810u
#define TC100_REG_JOG_DISTANCE_WORDS 2u

/**
 * The wait after a jog by the inputs.
 * Printed as JogInchingWait JOG 移動後的等待時間設定.
 * Read and write.
 * One count is 1 ms. Range: 0..1000.
 * Source: 5.6 L1245
 */
#define TC100_REG_JOG_WAIT_TIME_ADDRESS 0x0812u
#define TC100_REG_JOG_WAIT_TIME_WORDS 1u
#define TC100_REG_JOG_WAIT_TIME_MIN 0u
#define TC100_REG_JOG_WAIT_TIME_MAX 1000u

/**
 * The soft limit in the positive direction.
 * Printed as PlusSoftLimit + 方向的軟體極限.
 * Read and write.
 * 0 means no_limit.
 * Note: The description says mm, and not how many mm one count is.
 * Source: 5.6 L1246
 */
#define TC100_REG_SOFT_LIMIT_POSITIVE_ADDRESS 0x0813u
#define TC100_REG_SOFT_LIMIT_POSITIVE_WORDS 2u

/**
 * The soft limit in the negative direction.
 * Printed as MinusSoftLimit - 方向的軟體極限.
 * Read and write.
 * 0 means no_limit.
 * Note: The description says mm, and not how many mm one count is.
 * Source: 5.6 L1247
 */
#define TC100_REG_SOFT_LIMIT_NEGATIVE_ADDRESS 0x0815u
#define TC100_REG_SOFT_LIMIT_NEGATIVE_WORDS 2u

/**
 * How and in which direction the home position is searched.
 * Printed as OrgMode 原點復歸方向.
 * Read and write.
 * Range: 0..7. See homing_mode.
 * Source: 5.7 L1253
 */
#define TC100_REG_HOMING_MODE_ADDRESS 0x0900u
#define TC100_REG_HOMING_MODE_WORDS 1u
#define TC100_REG_HOMING_MODE_MIN 0u
#define TC100_REG_HOMING_MODE_MAX 7u

/**
 * A percentage of the maximum speed 0802H. For homing by torque, 20 or less is advised.
 * Printed as OrgSpeed 原點復歸速度.
 * Read and write.
 * One count is 1 %. Range: 0..100. 0 means start_speed.
 * Source: 5.7 L1254
 */
#define TC100_REG_HOMING_SPEED_ADDRESS 0x0901u
#define TC100_REG_HOMING_SPEED_WORDS 1u
#define TC100_REG_HOMING_SPEED_MIN 0u
#define TC100_REG_HOMING_SPEED_MAX 100u

/**
 * The distance that is moved after homing is done. The push torques 0400H and 0401H apply.
 * Printed as OrgOffset 原點復歸的偏移量設定.
 * Read and write.
 * One count is 1 pulse.
 * Note: This row places the move after homing; 0904H places it after the detection of torque, in the other
 * direction, and for homing by torque only.
 * Source: 5.7 L1255
 */
#define TC100_REG_HOMING_OFFSET_ADDRESS 0x0902u
#define TC100_REG_HOMING_OFFSET_WORDS 2u

/**
 * The speed of the move by the offset, back from where the torque was detected; a percentage of the maximum
 * speed 0802H.
 * Printed as OrgOffsetSpeed 原點復歸偏移量 移動速度.
 * Read and write.
 * One count is 1 %. Range: 0..100. 0 means start_speed.
 * Source: 5.7 L1259
 */
#define TC100_REG_HOMING_OFFSET_SPEED_ADDRESS 0x0904u
#define TC100_REG_HOMING_OFFSET_SPEED_WORDS 1u
#define TC100_REG_HOMING_OFFSET_SPEED_MIN 0u
#define TC100_REG_HOMING_OFFSET_SPEED_MAX 100u

/**
 * The value that the position takes when homing is done.
 * Printed as OrgData 原點復歸的數據.
 * Read and write.
 * Note: The description says mm, and not how many mm one count is.
 * Source: 5.7 L1260
 */
#define TC100_REG_HOMING_POSITION_ADDRESS 0x0905u
#define TC100_REG_HOMING_POSITION_WORDS 2u

/**
 * The torque that counts as having met the hard stop.
 * Printed as OrgTrqLimit 原點復歸時的扭力設定.
 * Read and write.
 * One count is 0.1 %. Range: 0..1000.
 * Source: 5.7 L1261
 */
#define TC100_REG_HOMING_TORQUE_LIMIT_ADDRESS 0x0907u
#define TC100_REG_HOMING_TORQUE_LIMIT_WORDS 1u
#define TC100_REG_HOMING_TORQUE_LIMIT_MIN 0u
#define TC100_REG_HOMING_TORQUE_LIMIT_MAX 1000u
#define TC100_REG_HOMING_TORQUE_LIMIT_SCALE_NUMERATOR INT64_C(1)
#define TC100_REG_HOMING_TORQUE_LIMIT_SCALE_DENOMINATOR INT64_C(10)

/**
 * The distance that is moved from the hard stop before the Z phase is searched. The push torques 0400H and
 * 0401H apply.
 * Printed as OrgOffset_Z 檢出 Z 相前，偏移量.
 * Read and write.
 * One count is 1 pulse.
 * Source: 5.7 L1262
 */
#define TC100_REG_HOMING_Z_PHASE_OFFSET_ADDRESS 0x0908u
#define TC100_REG_HOMING_Z_PHASE_OFFSET_WORDS 2u

/**
 * How long the torque must last in homing by torque.
 * Printed as OrgTrqLmtTime 原點復歸時的扭力檢測時間.
 * Read and write.
 * One count is 1 ms. Range: 0..1000.
 * Source: 5.7 L1263
 */
#define TC100_REG_HOMING_TORQUE_LIMIT_TIME_ADDRESS 0x090Au
#define TC100_REG_HOMING_TORQUE_LIMIT_TIME_WORDS 1u
#define TC100_REG_HOMING_TORQUE_LIMIT_TIME_MIN 0u
#define TC100_REG_HOMING_TORQUE_LIMIT_TIME_MAX 1000u

/**
 * The speed of the first search of the Z phase, a percentage of the maximum speed 0802H.
 * Printed as OrgSpeed_Z1 Z 相檢出速度 _1.
 * Read and write.
 * One count is 1 %. Range: 1..100.
 * Source: 5.7 L1264
 */
#define TC100_REG_HOMING_Z_PHASE_SPEED_1_ADDRESS 0x090Bu
#define TC100_REG_HOMING_Z_PHASE_SPEED_1_WORDS 1u
#define TC100_REG_HOMING_Z_PHASE_SPEED_1_MIN 1u
#define TC100_REG_HOMING_Z_PHASE_SPEED_1_MAX 100u

/**
 * The speed of the second search of the Z phase, in the other direction.
 * Printed as OrgSpeed_Z2 Z 相檢出速度 _2.
 * Read and write.
 * One count is 1 %. Range: 1..100.
 * Source: 5.7 L1265
 */
#define TC100_REG_HOMING_Z_PHASE_SPEED_2_ADDRESS 0x090Cu
#define TC100_REG_HOMING_Z_PHASE_SPEED_2_WORDS 1u
#define TC100_REG_HOMING_Z_PHASE_SPEED_2_MIN 1u
#define TC100_REG_HOMING_Z_PHASE_SPEED_2_MAX 100u

/**
 * Printed as BaudRate 通信速率.
 * Read and write. A change takes effect after a restart.
 * Range: 0..4. See baud_rate.
 * Source: 5.8 L1271
 */
#define TC100_REG_BAUD_RATE_ADDRESS 0x0A00u
#define TC100_REG_BAUD_RATE_WORDS 1u
#define TC100_REG_BAUD_RATE_MIN 0u
#define TC100_REG_BAUD_RATE_MAX 4u
#define TC100_REG_BAUD_RATE_DEFAULT 1u

/**
 * Printed as DataSize 字串數據 Bit 設定.
 * Read and write. A change takes effect after a restart.
 * Range: 0..1. See data_bits.
 * Note: RTU needs 8 bits (8.1).
 * Source: 5.8 L1272
 */
#define TC100_REG_DATA_BITS_ADDRESS 0x0A01u
#define TC100_REG_DATA_BITS_WORDS 1u
#define TC100_REG_DATA_BITS_MIN 0u
#define TC100_REG_DATA_BITS_MAX 1u
#define TC100_REG_DATA_BITS_DEFAULT 0u

/**
 * Printed as Parity 奇偶校驗.
 * Read and write. A change takes effect after a restart.
 * Range: 0..2. See parity.
 * Source: 5.8 L1273
 */
#define TC100_REG_PARITY_ADDRESS 0x0A02u
#define TC100_REG_PARITY_WORDS 1u
#define TC100_REG_PARITY_MIN 0u
#define TC100_REG_PARITY_MAX 2u
#define TC100_REG_PARITY_DEFAULT 0u

/**
 * Messages to the broadcast station 0 are obeyed; otherwise they are ignored.
 * Printed as Broadcast 擴播設定.
 * Read and write.
 * Range: 0..1.
 * Source: 5.8 L1274
 */
#define TC100_REG_BROADCAST_ENABLED_ADDRESS 0x0A03u
#define TC100_REG_BROADCAST_ENABLED_WORDS 1u
#define TC100_REG_BROADCAST_ENABLED_MIN 0u
#define TC100_REG_BROADCAST_ENABLED_MAX 1u
#define TC100_REG_BROADCAST_ENABLED_DEFAULT 0u

/**
 * The Modbus mode of RS485.
 * Printed as Protocol 通訊協議.
 * Read and write. A change takes effect after a restart.
 * Range: 0..1. See protocol.
 * Note: The vendor's software needs ASCII (8.1).
 * Source: 5.8 L1275
 */
#define TC100_REG_PROTOCOL_ADDRESS 0x0A04u
#define TC100_REG_PROTOCOL_WORDS 1u
#define TC100_REG_PROTOCOL_MIN 0u
#define TC100_REG_PROTOCOL_MAX 1u
#define TC100_REG_PROTOCOL_DEFAULT 0u

/**
 * Printed as ActionStatus 動作狀態.
 * Read only.
 * Range: 0..2. See action_status.
 * Source: 8.2 L1506
 */
#define TC100_REG_ACTION_STATUS_ADDRESS 0x1000u
#define TC100_REG_ACTION_STATUS_WORDS 1u
#define TC100_REG_ACTION_STATUS_MIN 0u
#define TC100_REG_ACTION_STATUS_MAX 2u

/**
 * The position is within the zone around the target, see 010AH.
 * Printed as InpStatus 到位訊號目前的狀態.
 * Read only.
 * Range: 0..1.
 * Source: 8.2 L1507
 */
#define TC100_REG_IN_POSITION_ADDRESS 0x1001u
#define TC100_REG_IN_POSITION_WORDS 1u
#define TC100_REG_IN_POSITION_MIN 0u
#define TC100_REG_IN_POSITION_MAX 1u

/**
 * The torque has reached its limit.
 * Printed as TrqLmtStatus 力矩極限狀態.
 * Read only.
 * Source: 8.2 L1508
 */
#define TC100_REG_TORQUE_LIMIT_REACHED_ADDRESS 0x1004u
#define TC100_REG_TORQUE_LIMIT_REACHED_WORDS 1u

/**
 * The present alarm.
 * Printed as AlarmStatus 警報狀態.
 * Read only.
 * See alarm_code.
 * Source: 8.2 L1509
 */
#define TC100_REG_ALARM_ADDRESS 0x1005u
#define TC100_REG_ALARM_WORDS 1u

/**
 * Printed as MonSpeed 馬達轉速.
 * Read only.
 * One count is 1 rpm.
 * Source: 8.2 L1510
 */
#define TC100_REG_MOTOR_SPEED_ADDRESS 0x1006u
#define TC100_REG_MOTOR_SPEED_WORDS 1u

/**
 * Printed as MonCurrent 馬達電流值.
 * Read only.
 * One count is 0.1 %.
 * Source: 8.2 L1511
 */
#define TC100_REG_MOTOR_CURRENT_ADDRESS 0x1007u
#define TC100_REG_MOTOR_CURRENT_WORDS 1u
#define TC100_REG_MOTOR_CURRENT_SCALE_NUMERATOR INT64_C(1)
#define TC100_REG_MOTOR_CURRENT_SCALE_DENOMINATOR INT64_C(10)

/**
 * Where the position command stands.
 * Printed as CmdNowPos 指令現在位置.
 * Read only.
 * Note: In control by external pulses it is not cleared after homing (3.9).
 * Source: 8.2 L1512
 */
#define TC100_REG_COMMAND_POSITION_ADDRESS 0x1008u
#define TC100_REG_COMMAND_POSITION_WORDS 2u

/**
 * Where the encoder says that the motor is.
 * Printed as EcdPos 編碼器位置.
 * Read only.
 * Note: In control by external pulses it is not cleared after homing (3.9).
 * Source: 8.2 L1513
 */
#define TC100_REG_ENCODER_POSITION_ADDRESS 0x100Au
#define TC100_REG_ENCODER_POSITION_WORDS 2u

/**
 * Printed as ServoStatus 伺服狀態.
 * Read only.
 * Range: 0..1.
 * Note: 1 is on. In the command 2011H and in the parameter 0515H 1 is off.
 * Source: 8.2 L1514
 */
#define TC100_REG_SERVO_ON_ADDRESS 0x100Cu
#define TC100_REG_SERVO_ON_WORDS 1u
#define TC100_REG_SERVO_ON_MIN 0u
#define TC100_REG_SERVO_ON_MAX 1u

/**
 * The present fault.
 * Printed as ErrorStatus 故障狀態.
 * Read only.
 * See fault_code.
 * Source: 8.2 L1515
 */
#define TC100_REG_FAULT_ADDRESS 0x100Du
#define TC100_REG_FAULT_WORDS 1u

/**
 * The number of the point that was executed last.
 * Printed as StepNo 程序選擇號碼.
 * Read only.
 * Range: -1..127. -1 means none.
 * Note: The printed range holds 0; points are numbered from 1.
 * Source: 8.2 L1516
 */
#define TC100_REG_EXECUTED_POINT_ADDRESS 0x100Eu
#define TC100_REG_EXECUTED_POINT_WORDS 1u
#define TC100_REG_EXECUTED_POINT_MIN (-1)
#define TC100_REG_EXECUTED_POINT_MAX 127

/**
 * All outputs at once.
 * Printed as PORT (OUT1~10) 整體輸出狀態.
 * Read only.
 * Range: 0..1023. See output_word.
 * Source: 8.2 L1517
 */
#define TC100_REG_OUTPUT_STATES_ADDRESS 0x1020u
#define TC100_REG_OUTPUT_STATES_WORDS 1u
#define TC100_REG_OUTPUT_STATES_MIN 0u
#define TC100_REG_OUTPUT_STATES_MAX 1023u

/**
 * One output; 1 is on.
 * Printed as 單獨輸出狀態.
 * Read only.
 * Range: 0..1.
 * Source: 8.2 L1518-1519, 1523-1530
 */
#define TC100_REG_OUTPUT_STATE_ADDRESS 0x1021u
#define TC100_REG_OUTPUT_STATE_WORDS 1u
#define TC100_REG_OUTPUT_STATE_COUNT 10u
#define TC100_REG_OUTPUT_STATE_STRIDE 1u
#define TC100_REG_OUTPUT_STATE_FIRST 1u
#define TC100_REG_OUTPUT_STATE_MIN 0u
#define TC100_REG_OUTPUT_STATE_MAX 1u

/**
 * All inputs at once.
 * Printed as PORT (IN1~IN14、Z相) 整體輸入狀態.
 * Read only.
 * Range: 0..32767. See input_word.
 * Source: 8.2 L1531
 */
#define TC100_REG_INPUT_STATES_ADDRESS 0x1040u
#define TC100_REG_INPUT_STATES_WORDS 1u
#define TC100_REG_INPUT_STATES_MIN 0u
#define TC100_REG_INPUT_STATES_MAX 32767u

/**
 * One input; 1 is on.
 * Printed as 單獨輸入狀態.
 * Read only.
 * Range: 0..1.
 * Source: 8.2 L1532-1545
 */
#define TC100_REG_INPUT_STATE_ADDRESS 0x1041u
#define TC100_REG_INPUT_STATE_WORDS 1u
#define TC100_REG_INPUT_STATE_COUNT 14u
#define TC100_REG_INPUT_STATE_STRIDE 1u
#define TC100_REG_INPUT_STATE_FIRST 1u
#define TC100_REG_INPUT_STATE_MIN 0u
#define TC100_REG_INPUT_STATE_MAX 1u

/**
 * The Z phase of the encoder; 1 is on.
 * Printed as Z 相輸入狀態 Z 相輸入狀態.
 * Read only.
 * Range: 0..1.
 * Source: 8.2 L1546
 */
#define TC100_REG_Z_PHASE_STATE_ADDRESS 0x104Fu
#define TC100_REG_Z_PHASE_STATE_WORDS 1u
#define TC100_REG_Z_PHASE_STATE_MIN 0u
#define TC100_REG_Z_PHASE_STATE_MAX 1u

/**
 * The stored alarms.
 * Printed as 50 筆錯誤履歷.
 * Read only.
 * See alarm_code.
 * Note: Whether the first entry is the newest or the oldest one is not printed, nor what an empty entry holds.
 * Source: 8.2 L1552-1574, 1578-1604
 */
#define TC100_REG_ALARM_HISTORY_ADDRESS 0x1060u
#define TC100_REG_ALARM_HISTORY_WORDS 1u
#define TC100_REG_ALARM_HISTORY_COUNT 50u
#define TC100_REG_ALARM_HISTORY_STRIDE 1u
#define TC100_REG_ALARM_HISTORY_FIRST 1u

/**
 * The type of the motor, up to 31 letters and digits.
 * Printed as MotorType 馬達型號.
 * Read only.
 * Note: How a shorter text is ended or filled is not printed.
 * Source: 8.2 L1610
 */
#define TC100_REG_MOTOR_TYPE_ADDRESS 0x10D0u
#define TC100_REG_MOTOR_TYPE_WORDS 16u

/**
 * The type of the controller, TC-100.
 * Printed as Controller 控制器型號.
 * Read only.
 * Note: The manual's cover and 1.2 write the name without a hyphen. How the text is ended or filled is not
 * printed.
 * Source: 8.2 L1611
 */
#define TC100_REG_CONTROLLER_TYPE_ADDRESS 0x10E0u
#define TC100_REG_CONTROLLER_TYPE_WORDS 16u

/**
 * The firmware version; 100 stands for 1.00.
 * Printed as FirmwareNo Firmware 版本.
 * Read only.
 * Note: The remark calls the form HEX-ASCII. Whether 1.00 is the word 0100H, or the number 100 (0064H), is not
 * decided by the print. The title bar of the vendor's software shows 02.21 (9.3).
 * Source: 8.2 L1612
 */
#define TC100_REG_FIRMWARE_VERSION_ADDRESS 0x10F0u
#define TC100_REG_FIRMWARE_VERSION_WORDS 1u

/* ---- Record tables ---- */

/**
 * The points P1 to P127. The table prints the first one whole and the addresses of the second one; the others
 * follow at the same distance.
 * Printed as 步序指令說明.
 * Its elements are tc100_point.
 * Note: Two words between one point and the next, 901EH and 901FH for the first one, are not described.
 * Source: 8.2 L1644-1659
 */
#define TC100_TABLE_POINTS_ADDRESS 0x9010u
#define TC100_TABLE_POINTS_WORDS 14u
#define TC100_TABLE_POINTS_STRIDE 16u
#define TC100_TABLE_POINTS_COUNT 127u
#define TC100_TABLE_POINTS_FIRST 1u

/* ---- Values that stand for a state ---- */

#define TC100_POINT_SPEED_ABSENT_START_SPEED 0u /**< point.speed: start_speed. The start speed 0800H. */

#define TC100_POINT_NEXT_POINT_ABSENT_END (-1) /**< point.next_point: end. The program ends. */

#define TC100_REG_JOG_POSITIVE_INPUT_ABSENT_NOT_USED 0u /**< jog_positive_input: not_used. The function has no terminal. */

#define TC100_REG_JOG_NEGATIVE_INPUT_ABSENT_NOT_USED 0u /**< jog_negative_input: not_used. The function has no terminal. */

#define TC100_REG_MANUAL_MODE_INPUT_ABSENT_NOT_USED 0u /**< manual_mode_input: not_used. The function has no terminal. */

#define TC100_REG_TEACH_INPUT_ABSENT_NOT_USED 0u /**< teach_input: not_used. The function has no terminal. */

#define TC100_REG_LOCK_INPUT_ABSENT_NOT_USED 0u /**< lock_input: not_used. The function has no terminal. */

#define TC100_REG_POINT_SELECT_BIT_4_INPUT_ABSENT_NOT_USED 0u /**< point_select_bit_4_input: not_used. The function has no terminal. */

#define TC100_REG_POINT_SELECT_BIT_5_INPUT_ABSENT_NOT_USED 0u /**< point_select_bit_5_input: not_used. The function has no terminal. */

#define TC100_REG_POINT_SELECT_BIT_6_INPUT_ABSENT_NOT_USED 0u /**< point_select_bit_6_input: not_used. The function has no terminal. */

#define TC100_REG_HOMING_SENSOR_INPUT_ABSENT_NOT_USED 0u /**< homing_sensor_input: not_used. The function has no terminal. */

#define TC100_REG_BRAKE_INPUT_ABSENT_NOT_USED 0u /**< brake_input: not_used. The function has no terminal. */

#define TC100_REG_FULL_COUNT_INPUT_ABSENT_NOT_USED 0u /**< full_count_input: not_used. The function has no terminal. */

#define TC100_REG_IN_POSITION_OUTPUT_ABSENT_NOT_USED 0u /**< in_position_output: not_used. The function has no terminal. */

#define TC100_REG_ALARM_OUTPUT_ABSENT_NOT_USED 0u /**< alarm_output: not_used. The function has no terminal. */

#define TC100_REG_READY_OUTPUT_ABSENT_NOT_USED 0u /**< ready_output: not_used. The function has no terminal. */

#define TC100_REG_MOVING_OUTPUT_ABSENT_NOT_USED 0u /**< moving_output: not_used. The function has no terminal. */

#define TC100_REG_SERVO_ON_OUTPUT_ABSENT_NOT_USED 0u /**< servo_on_output: not_used. The function has no terminal. */

#define TC100_REG_POINT_SELECT_BIT_0_OUTPUT_ABSENT_NOT_USED 0u /**< point_select_bit_0_output: not_used. The function has no terminal. */

#define TC100_REG_POINT_SELECT_BIT_1_OUTPUT_ABSENT_NOT_USED 0u /**< point_select_bit_1_output: not_used. The function has no terminal. */

#define TC100_REG_POINT_SELECT_BIT_2_OUTPUT_ABSENT_NOT_USED 0u /**< point_select_bit_2_output: not_used. The function has no terminal. */

#define TC100_REG_POINT_SELECT_BIT_3_OUTPUT_ABSENT_NOT_USED 0u /**< point_select_bit_3_output: not_used. The function has no terminal. */

#define TC100_REG_POINT_SELECT_BIT_4_OUTPUT_ABSENT_NOT_USED 0u /**< point_select_bit_4_output: not_used. The function has no terminal. */

#define TC100_REG_POINT_SELECT_BIT_5_OUTPUT_ABSENT_NOT_USED 0u /**< point_select_bit_5_output: not_used. The function has no terminal. */

#define TC100_REG_POINT_SELECT_BIT_6_OUTPUT_ABSENT_NOT_USED 0u /**< point_select_bit_6_output: not_used. The function has no terminal. */

#define TC100_REG_TORQUE_LIMIT_OUTPUT_ABSENT_NOT_USED 0u /**< torque_limit_output: not_used. The function has no terminal. */

#define TC100_REG_ERROR_BIT_0_OUTPUT_ABSENT_NOT_USED 0u /**< error_bit_0_output: not_used. The function has no terminal. */

#define TC100_REG_ERROR_BIT_1_OUTPUT_ABSENT_NOT_USED 0u /**< error_bit_1_output: not_used. The function has no terminal. */

#define TC100_REG_ERROR_BIT_2_OUTPUT_ABSENT_NOT_USED 0u /**< error_bit_2_output: not_used. The function has no terminal. */

#define TC100_REG_ERROR_BIT_3_OUTPUT_ABSENT_NOT_USED 0u /**< error_bit_3_output: not_used. The function has no terminal. */

#define TC100_REG_ZONE_OUTPUT_ABSENT_NOT_USED 0u /**< zone_output: not_used. The function has no terminal. */

#define TC100_REG_NEAR_OUTPUT_ABSENT_NOT_USED 0u /**< near_output: not_used. The function has no terminal. */

#define TC100_REG_SOFT_LIMIT_OUTPUT_ABSENT_NOT_USED 0u /**< soft_limit_output: not_used. The function has no terminal. */

#define TC100_REG_MOTION_SPEED_ABSENT_START_SPEED 0u /**< motion_speed: start_speed. The start speed 0800H. */

#define TC100_REG_SOFT_LIMIT_POSITIVE_ABSENT_NO_LIMIT 0 /**< soft_limit_positive: no_limit. The soft limit is not active. */

#define TC100_REG_SOFT_LIMIT_NEGATIVE_ABSENT_NO_LIMIT 0 /**< soft_limit_negative: no_limit. The soft limit is not active. */

#define TC100_REG_HOMING_SPEED_ABSENT_START_SPEED 0u /**< homing_speed: start_speed. The start speed 0800H. */

#define TC100_REG_HOMING_OFFSET_SPEED_ABSENT_START_SPEED 0u /**< homing_offset_speed: start_speed. The start speed 0800H. */

#define TC100_REG_EXECUTED_POINT_ABSENT_NONE (-1) /**< executed_point: none. No point was executed yet. */

#endif
