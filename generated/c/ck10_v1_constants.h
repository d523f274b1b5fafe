/*
 * CK10 (unknown), version 1
 * From: CK10 series, Modbus communication, user manual
 * Identity: fdc1e9665defc19d
 *
 * Generated; do not edit. The constants of ck10_v1.h, which includes this file: a file that needs no functions compiles faster.
 */
#ifdef CK10_CONSTANTS_INCLUDED
#ifndef CK10_VERSION_IS_1
#error "another version of this device is already included"
#endif
#else
#define CK10_CONSTANTS_INCLUDED
#define CK10_VERSION_IS_1

#if defined(__cplusplus) && __cplusplus < 201103L && !defined(__STDC_CONSTANT_MACROS)
#define __STDC_CONSTANT_MACROS
#endif
#if defined(__cplusplus) && __cplusplus < 201103L && !defined(__STDC_LIMIT_MACROS)
#define __STDC_LIMIT_MACROS
#endif
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define CK10_VERSION "1"
#define CK10_IDENTITY "fdc1e9665defc19d"

#ifdef __GNUC__
/** An enum has 16 bits, even where the compiler makes enums as short as they can be: a cast of 256 does not become 0. */
#define CK10_ENUM_16 __attribute__((__mode__(__HI__)))
#else
#define CK10_ENUM_16
#endif

/* ---- Enums and codes ---- */

/**
 * Printed as CK10 異常代碼.
 * Other values may occur.
 * Note: What follows when a register is accessed against its attribute is called a communication error (2
 * L247). In 1.4 that word stands for errors that get no answer at all; 02 is the nearest exception.
 * Source: 1.4 L233
 */
typedef enum ck10_exception_code {
    CK10_EXCEPTION_CODE_ILLEGAL_FUNCTION = 1, /**< 無效功能 The command is not supported. */
    CK10_EXCEPTION_CODE_ILLEGAL_DATA_ADDRESS = 2, /**< 無效資料位置 The address is not allowed. */
    CK10_EXCEPTION_CODE_ILLEGAL_DATA_VALUE = 3, /**< 無效資料值 The value is not allowed. */
    CK10_EXCEPTION_CODE_DEVICE_FAILURE = 4 /**< 從站裝置錯誤 An error came up while the controller carried out the command. */
} CK10_ENUM_16 ck10_exception_code;

/** Source: 2.1 L263 */
typedef enum ck10_push_status {
    CK10_PUSH_STATUS_NO_PUSH = 0, /**< 一般運動 An ordinary move. */
    CK10_PUSH_STATUS_PUSHING = 1, /**< 推力運動中，但未偵測到工件 It pushes, and has not met the workpiece. */
    CK10_PUSH_STATUS_HOLDING = 2, /**< 偵測到工件並保持推力 It has met the workpiece, and goes on pushing. */
    CK10_PUSH_STATUS_MISSED = 3 /**< 推力過程中未偵測到工件 It has not met the workpiece. */
} CK10_ENUM_16 ck10_push_status;

/**
 * Every value but 0 switches the output on.
 * Other values may occur.
 * Source: 2.2 L281
 */
typedef enum ck10_output_switch {
    CK10_OUTPUT_SWITCH_OFF = 0, /**< 停用 */
    CK10_OUTPUT_SWITCH_ON = 1 /**< 啟用 */
} CK10_ENUM_16 ck10_output_switch;

/**
 * Printed as 報警形式.
 * Other values may occur.
 * Note: The list has names alone. What the alarms mean is taken from the flags of 3.1 of the same names and
 * from the parameters 24 and 28; 7, 8 and 12 have no flag.
 * Note: The alarms 1 to 6 are the bits 8 to 13 of 03E8h; 10 is bit 15, and 15 is bit 7.
 * Source: 2.3 L301
 */
typedef enum ck10_alarm_code {
    CK10_ALARM_CODE_NO_ALARM = 0, /**< 無警報 */
    CK10_ALARM_CODE_OVERCURRENT = 1, /**< 過電流 */
    CK10_ALARM_CODE_OVERSPEED = 2, /**< 過速度 */
    CK10_ALARM_CODE_POSITION_TRACKING = 3, /**< 位置追蹤 */
    CK10_ALARM_CODE_OVERLOAD = 4, /**< 過負載 */
    CK10_ALARM_CODE_OVERHEAT = 5, /**< 過溫度 */
    CK10_ALARM_CODE_BACK_EMF = 6, /**< 反電動勢 */
    CK10_ALARM_CODE_MOTOR_CONNECTION = 7, /**< 馬達連結 */
    CK10_ALARM_CODE_ENCODER_CONNECTION = 8, /**< 編碼器連結 */
    CK10_ALARM_CODE_IN_POSITION_ERROR = 10, /**< 定位 */
    CK10_ALARM_CODE_MEMORY = 12, /**< 記憶體裝置 */
    CK10_ALARM_CODE_POSITION_OVERFLOW = 15 /**< 位置溢出 */
} CK10_ENUM_16 ck10_alarm_code;

/**
 * Note: The commands of a point count otherwise: the absolute ones come first.
 * Source: 2.4 L311
 */
typedef enum ck10_move_kind {
    CK10_MOVE_KIND_RELATIVE = 1, /**< 運動至指定的相對位置 By a distance. */
    CK10_MOVE_KIND_ABSOLUTE = 2 /**< 運動至指定的絕對位置 To a position. */
} CK10_ENUM_16 ck10_move_kind;

/**
 * Note: The homing direction and the motor direction count the other way round.
 * Source: 2.4 L315
 */
typedef enum ck10_jog_direction {
    CK10_JOG_DIRECTION_COUNTERCLOCKWISE = 0, /**< CCW */
    CK10_JOG_DIRECTION_CLOCKWISE = 1 /**< CW */
} CK10_ENUM_16 ck10_jog_direction;

/** Source: 2.4 L325 */
typedef enum ck10_push_mode {
    CK10_PUSH_MODE_STOP = 0, /**< 停止模式 It stops when it meets the workpiece. */
    CK10_PUSH_MODE_GO_ON = 1 /**< 不停止模式 It does not stop. */
} CK10_ENUM_16 ck10_push_mode;

/** Source: 2.4 L332 */
typedef enum ck10_stop_kind {
    CK10_STOP_KIND_IMMEDIATE = 0, /**< 立即停止 */
    CK10_STOP_KIND_DECELERATED = 1 /**< 緩停止 */
} CK10_ENUM_16 ck10_stop_kind;

/**
 * Every value but 0 switches the drive on.
 * Other values may occur.
 * Source: 2.4 L333
 */
typedef enum ck10_servo_switch {
    CK10_SERVO_SWITCH_OFF = 0, /**< 驅動停用 */
    CK10_SERVO_SWITCH_ON = 1 /**< 驅動啟用 */
} CK10_ENUM_16 ck10_servo_switch;

/** Source: 2.4 L338 */
typedef enum ck10_point_table_command {
    CK10_POINT_TABLE_COMMAND_START = 1, /**< 執行 "位置表開始行號" 指定值 Starts at the point that the register before it names. */
    CK10_POINT_TABLE_COMMAND_START_SINGLE = 2, /**< 僅執行 "位置表開始行號" 指定值 Carries out that point alone. */
    CK10_POINT_TABLE_COMMAND_NEXT = 3 /**< 執行當前位置表下一步 Goes on with the next step of the point table. */
} CK10_ENUM_16 ck10_point_table_command;

/**
 * Other values may occur.
 * Note: The row of the parameter prints 0 to 50000 as its range, which fits a number of pulses, and this list
 * of codes beside it.
 * Note: In the text of the manual, the last row of the list stands one column further left than the others.
 * Source: 3.4 L713-722
 */
typedef enum ck10_pulses_per_turn {
    CK10_PULSES_PER_TURN_MOTOR_SETTING = 0, /**< MDB 設定 The setting called MDB, which the manual does not explain. */
    CK10_PULSES_PER_TURN_PULSES_500 = 1, /**< 500 */
    CK10_PULSES_PER_TURN_PULSES_1000 = 2, /**< 1,000 */
    CK10_PULSES_PER_TURN_PULSES_1600 = 3, /**< 1,600 */
    CK10_PULSES_PER_TURN_PULSES_2000 = 4, /**< 2,000 */
    CK10_PULSES_PER_TURN_PULSES_3200 = 5, /**< 3,200 */
    CK10_PULSES_PER_TURN_PULSES_3600 = 6, /**< 3,600 */
    CK10_PULSES_PER_TURN_PULSES_4000 = 7, /**< 4,000 */
    CK10_PULSES_PER_TURN_PULSES_4800 = 8, /**< 4,800 */
    CK10_PULSES_PER_TURN_PULSES_5000 = 9, /**< 5,000 */
    CK10_PULSES_PER_TURN_PULSES_6400 = 10, /**< 6,400 */
    CK10_PULSES_PER_TURN_PULSES_8000 = 11, /**< 8,000 */
    CK10_PULSES_PER_TURN_PULSES_9600 = 12, /**< 9,600 */
    CK10_PULSES_PER_TURN_PULSES_10000 = 13, /**< 10,000 */
    CK10_PULSES_PER_TURN_PULSES_16000 = 14, /**< 16,000 */
    CK10_PULSES_PER_TURN_PULSES_20000 = 15 /**< 20,000 */
} CK10_ENUM_16 ck10_pulses_per_turn;

/** Source: 3.4 L735 */
typedef enum ck10_soft_limit_stop {
    CK10_SOFT_LIMIT_STOP_IMMEDIATE = 0, /**< 以緊急停止方式停下馬達 */
    CK10_SOFT_LIMIT_STOP_DECELERATED = 1, /**< 以緩停止方式停下馬達 */
    CK10_SOFT_LIMIT_STOP_NONE = 2 /**< 不使用軟體極限 The soft limits are not used. */
} CK10_ENUM_16 ck10_soft_limit_stop;

/** Source: 3.4 L736 */
typedef enum ck10_hard_limit_stop {
    CK10_HARD_LIMIT_STOP_IMMEDIATE = 0, /**< 以緊急停止方式停下馬達 */
    CK10_HARD_LIMIT_STOP_DECELERATED = 1 /**< 以緩停止方式停下馬達 */
} CK10_ENUM_16 ck10_hard_limit_stop;

/** Source: 3.4 L741-749 */
typedef enum ck10_homing_method {
    CK10_HOMING_METHOD_ORIGIN_SENSOR = 0, /**< To the origin sensor, then back to it slowly. */
    CK10_HOMING_METHOD_ORIGIN_SENSOR_AND_Z_PHASE = 1, /**< To the origin sensor, then slowly to the Z phase. */
    CK10_HOMING_METHOD_LIMIT_SENSOR = 2, /**< To the limit sensor, and stop there at once. */
    CK10_HOMING_METHOD_LIMIT_SENSOR_AND_Z_PHASE = 3, /**< To the limit sensor, then slowly to the Z phase. */
    CK10_HOMING_METHOD_CURRENT_POSITION = 4, /**< The position where the motor is becomes the origin. */
    CK10_HOMING_METHOD_Z_PHASE = 5, /**< Slowly to the Z phase. */
    CK10_HOMING_METHOD_HARD_STOP = 6, /**< With limited torque against a hard stop, which becomes the origin. */
    CK10_HOMING_METHOD_HARD_STOP_AND_Z_PHASE = 7 /**< With limited torque against a hard stop, then slowly to the Z phase. */
} CK10_ENUM_16 ck10_homing_method;

/**
 * Note: The jog direction counts the other way round.
 * Source: 3.4 L751; 3.4 L796
 */
typedef enum ck10_rotation {
    CK10_ROTATION_CLOCKWISE = 0, /**< CW */
    CK10_ROTATION_COUNTERCLOCKWISE = 1 /**< CCW */
} CK10_ENUM_16 ck10_rotation;

/** Source: 3.4 L806 */
typedef enum ck10_emergency_stop_mode {
    CK10_EMERGENCY_STOP_MODE_FAST_STOP = 0, /**< 快速停止 */
    CK10_EMERGENCY_STOP_MODE_FAST_STOP_SERVO_OFF = 1, /**< 快速停止，Servo OFF */
    CK10_EMERGENCY_STOP_MODE_DECELERATED_STOP = 2, /**< 減速停止 */
    CK10_EMERGENCY_STOP_MODE_DECELERATED_STOP_SERVO_OFF = 3, /**< 減速停止，Servo OFF */
    CK10_EMERGENCY_STOP_MODE_SERVO_OFF = 4 /**< Servo OFF */
} CK10_ENUM_16 ck10_emergency_stop_mode;

/** Source: 3.4 L807 */
typedef enum ck10_emergency_brake_mode {
    CK10_EMERGENCY_BRAKE_MODE_LOCKED = 0, /**< 鎖定煞車 */
    CK10_EMERGENCY_BRAKE_MODE_RELEASED = 1 /**< 解鎖煞車 The brake is energised. */
} CK10_ENUM_16 ck10_emergency_brake_mode;

/** Source: 3.4 L808 */
typedef enum ck10_operation_mode {
    CK10_OPERATION_MODE_PULSE_AND_DIRECTION = 0, /**< 單脈衝模式 (Pulse/Dir) */
    CK10_OPERATION_MODE_TWO_PULSES = 1, /**< 雙脈衝模式 (CCW/DIR) */
    CK10_OPERATION_MODE_QUADRATURE = 2, /**< 正交模式 (A/B) */
    CK10_OPERATION_MODE_PLUS_R = 3, /**< Plus-R 模式 */
    CK10_OPERATION_MODE_MODBUS_RTU = 4, /**< MODBUS RTU 模式 */
    CK10_OPERATION_MODE_MODBUS_ASCII = 5 /**< MODBUS ASC 模式 */
} CK10_ENUM_16 ck10_operation_mode;

/** Source: 3.4 L809 */
typedef enum ck10_switch_function {
    CK10_SWITCH_FUNCTION_NONE = 0, /**< 不使用 */
    CK10_SWITCH_FUNCTION_RESET_ALARM = 1 /**< 警報重置 */
} CK10_ENUM_16 ck10_switch_function;

/** Source: 3.4 L810 */
typedef enum ck10_baud_rate {
    CK10_BAUD_RATE_BAUD_9600 = 0, /**< 9,600 */
    CK10_BAUD_RATE_BAUD_19200 = 1, /**< 19,200 */
    CK10_BAUD_RATE_BAUD_38400 = 2, /**< 38,400 */
    CK10_BAUD_RATE_BAUD_57600 = 3, /**< 57,600 */
    CK10_BAUD_RATE_BAUD_115200 = 4 /**< 115,200 */
} CK10_ENUM_16 ck10_baud_rate;

/** Source: 3.4 L811; 3.4 L812 */
typedef enum ck10_enabled {
    CK10_ENABLED_DISABLED = 0, /**< 停用 */
    CK10_ENABLED_ENABLED = 1 /**< 啟用 */
} CK10_ENUM_16 ck10_enabled;

/** Source: 2.6 L438; 2.6 L455 */
typedef enum ck10_polarity {
    CK10_POLARITY_NORMAL = 0, /**< On is 1. */
    CK10_POLARITY_INVERTED = 1 /**< On is 0. */
} CK10_ENUM_16 ck10_polarity;

/** Source: 3.5 L819-832 */
typedef enum ck10_point_command {
    CK10_POINT_COMMAND_ABSOLUTE_LOW_SPEED = 0, /**< Abs Move low speed */
    CK10_POINT_COMMAND_ABSOLUTE_HIGH_SPEED = 1, /**< Abs Move high speed */
    CK10_POINT_COMMAND_ABSOLUTE_HIGH_SPEED_DECELERATED = 2, /**< Abs Move high speed with deceleration */
    CK10_POINT_COMMAND_ABSOLUTE_ACCELERATED_AND_DECELERATED = 3, /**< Abs Move with acceleration and deceleration */
    CK10_POINT_COMMAND_INCREMENTAL_LOW_SPEED = 4, /**< Inc Move low speed */
    CK10_POINT_COMMAND_INCREMENTAL_HIGH_SPEED = 5, /**< Inc Move high speed */
    CK10_POINT_COMMAND_INCREMENTAL_HIGH_SPEED_DECELERATED = 6, /**< Inc Move high speed with deceleration */
    CK10_POINT_COMMAND_INCREMENTAL_ACCELERATED_AND_DECELERATED = 7, /**< Inc Move with acceleration and deceleration */
    CK10_POINT_COMMAND_HOMING = 8, /**< Move to Origin */
    CK10_POINT_COMMAND_CLEAR_POSITION = 9, /**< Clear Position */
    CK10_POINT_COMMAND_PUSH_ABSOLUTE = 10, /**< Push Abs Move */
    CK10_POINT_COMMAND_STOP = 11 /**< Stop */
} CK10_ENUM_16 ck10_point_command;

/**
 * When a point sets its outputs. The fourth value of the two bits is not printed.
 * Source: 2.7 L589
 */
typedef enum ck10_output_moment {
    CK10_OUTPUT_MOMENT_START = 0, /**< 開始動作時發出訊號 */
    CK10_OUTPUT_MOMENT_END = 1, /**< 完成動作時發出訊號 */
    CK10_OUTPUT_MOMENT_TRIGGER_POSITION = 2 /**< 到達 "觸發位置" 時發出訊號 */
} CK10_ENUM_16 ck10_output_moment;

/** Source: 2.7 L593; 3.5 L862 */
typedef enum ck10_check_in_position {
    CK10_CHECK_IN_POSITION_IGNORE = 0, /**< 忽略到位訊號 */
    CK10_CHECK_IN_POSITION_WAIT = 1 /**< 等待到位訊號 */
} CK10_ENUM_16 ck10_check_in_position;

/**
 * What an input is for, by the mask of the signal. Each input has one function.
 * Printed as IO 指派.
 * Other values may occur.
 * Note: Example of the manual: 00000002h assigns Limit- (2.6 L411, 419), 08000000h User IN 1 (3.2 L686).
 * Source: 3.2 L670; 2.6 L411
 */
typedef uint32_t ck10_input_function;
#define CK10_INPUT_FUNCTION_POSITIVE_LIMIT 0x00000001u /**< Limit+ */
#define CK10_INPUT_FUNCTION_NEGATIVE_LIMIT 0x00000002u /**< Limit- */
#define CK10_INPUT_FUNCTION_ORIGIN 0x00000004u /**< Origin */
#define CK10_INPUT_FUNCTION_CLEAR_POSITION 0x00000008u /**< Clear Position */
#define CK10_INPUT_FUNCTION_POINT_ADDRESS_0 0x00000010u /**< PT A0 */
#define CK10_INPUT_FUNCTION_POINT_ADDRESS_1 0x00000020u /**< PT A1 */
#define CK10_INPUT_FUNCTION_POINT_ADDRESS_2 0x00000040u /**< PT A2 */
#define CK10_INPUT_FUNCTION_POINT_ADDRESS_3 0x00000080u /**< PT A3 */
#define CK10_INPUT_FUNCTION_POINT_ADDRESS_4 0x00000100u /**< PT A4 */
#define CK10_INPUT_FUNCTION_POINT_ADDRESS_5_OR_USER_6 0x00000200u /**< PT A5 / User IN 6 */
#define CK10_INPUT_FUNCTION_POINT_ADDRESS_6_OR_USER_7 0x00000400u /**< PT A6 / User IN 7 */
#define CK10_INPUT_FUNCTION_POINT_ADDRESS_7_OR_USER_8 0x00000800u /**< PT A7 / User IN 8 */
#define CK10_INPUT_FUNCTION_START_POINT_TABLE 0x00001000u /**< PT Start */
#define CK10_INPUT_FUNCTION_STOP 0x00002000u /**< Stop */
#define CK10_INPUT_FUNCTION_JOG_POSITIVE 0x00004000u /**< Jog+ */
#define CK10_INPUT_FUNCTION_JOG_NEGATIVE 0x00008000u /**< Jog- */
#define CK10_INPUT_FUNCTION_RESET_ALARM 0x00010000u /**< Alarm Reset */
#define CK10_INPUT_FUNCTION_SERVO_ON 0x00020000u /**< Servo ON */
#define CK10_INPUT_FUNCTION_START_HOMING 0x00080000u /**< Org Search */
#define CK10_INPUT_FUNCTION_EMERGENCY_STOP 0x00200000u /**< E-stop */
#define CK10_INPUT_FUNCTION_JUMP_0 0x00400000u /**< JPT Input 0 */
#define CK10_INPUT_FUNCTION_JUMP_1 0x00800000u /**< JPT Input 1 */
#define CK10_INPUT_FUNCTION_JUMP_2 0x01000000u /**< JPT input 2 */
#define CK10_INPUT_FUNCTION_START_JUMP 0x02000000u /**< JPT Start */
#define CK10_INPUT_FUNCTION_USER_0 0x04000000u /**< User IN 0 */
#define CK10_INPUT_FUNCTION_USER_1 0x08000000u /**< User IN 1 */
#define CK10_INPUT_FUNCTION_USER_2 0x10000000u /**< User IN 2 */
#define CK10_INPUT_FUNCTION_USER_3 0x20000000u /**< User IN 3 */
#define CK10_INPUT_FUNCTION_USER_4 0x40000000u /**< User IN 4 */
#define CK10_INPUT_FUNCTION_USER_5 0x80000000u /**< User IN 5 */

/**
 * What an output is for, by the mask of the signal. Each output has one function.
 * Printed as IO 指派.
 * Other values may occur.
 * Note: Example of the manual: 00080000h assigns User Out 4 (3.3 L706).
 * Source: 3.3 L690; 2.6 L428
 */
typedef uint32_t ck10_output_function;
#define CK10_OUTPUT_FUNCTION_COMPARE_OUTPUT 0x00000001u /**< Compare Out */
#define CK10_OUTPUT_FUNCTION_IN_POSITION 0x00000002u /**< Inposition */
#define CK10_OUTPUT_FUNCTION_ALARM 0x00000004u /**< Alarm */
#define CK10_OUTPUT_FUNCTION_MOVING 0x00000008u /**< Moving */
#define CK10_OUTPUT_FUNCTION_ACCELERATING_OR_DECELERATING 0x00000010u /**< Acc/Dec */
#define CK10_OUTPUT_FUNCTION_ACKNOWLEDGE 0x00000020u /**< ACK */
#define CK10_OUTPUT_FUNCTION_END 0x00000040u /**< END */
#define CK10_OUTPUT_FUNCTION_ALARM_BLINK 0x00000080u /**< AlarmBlink */
#define CK10_OUTPUT_FUNCTION_HOMING_COMPLETE 0x00000100u /**< Origin Search OK */
#define CK10_OUTPUT_FUNCTION_SERVO_READY 0x00000200u /**< Servo Ready */
#define CK10_OUTPUT_FUNCTION_POINT_OUTPUT_0 0x00001000u /**< PT Output0 */
#define CK10_OUTPUT_FUNCTION_POINT_OUTPUT_1 0x00002000u /**< PT Output1 */
#define CK10_OUTPUT_FUNCTION_POINT_OUTPUT_2 0x00004000u /**< PT Output2 */
#define CK10_OUTPUT_FUNCTION_USER_0 0x00008000u /**< User Out 0 */
#define CK10_OUTPUT_FUNCTION_USER_1 0x00010000u /**< User Out 1 */
#define CK10_OUTPUT_FUNCTION_USER_2 0x00020000u /**< User Out 2 */
#define CK10_OUTPUT_FUNCTION_USER_3 0x00040000u /**< User Out 3 */
#define CK10_OUTPUT_FUNCTION_USER_4 0x00080000u /**< User Out 4 */
#define CK10_OUTPUT_FUNCTION_USER_5 0x00100000u /**< User Out 5 */
#define CK10_OUTPUT_FUNCTION_USER_6 0x00200000u /**< User Out 6 */
#define CK10_OUTPUT_FUNCTION_USER_7 0x00400000u /**< User Out 7 */
#define CK10_OUTPUT_FUNCTION_USER_8 0x00800000u /**< User Out 8 */

/* ---- Bit fields ---- */

/**
 * The flags of 03E8h. The manual prints each as a mask.
 * Printed as 狀態標誌定義.
 * A word of 32 bits.
 * Source: 3.1 L632
 */
typedef uint32_t ck10_motion_status;

/**
 * One error or more has come up.
 * Printed as FFLAG_ERRORALL.
 * Source: 3.1 L637
 */
#define CK10_MOTION_STATUS_ERROR_MASK 0x00000001u
#define CK10_MOTION_STATUS_ERROR_SHIFT 0u

/**
 * The positive limit sensor is on.
 * Printed as FFLAG_HWPOSILMT.
 * Source: 3.1 L638
 */
#define CK10_MOTION_STATUS_POSITIVE_HARD_LIMIT_MASK 0x00000002u
#define CK10_MOTION_STATUS_POSITIVE_HARD_LIMIT_SHIFT 1u

/**
 * The negative limit sensor is on.
 * Printed as FFLAG_HWNEGALMT.
 * Source: 3.1 L639
 */
#define CK10_MOTION_STATUS_NEGATIVE_HARD_LIMIT_MASK 0x00000004u
#define CK10_MOTION_STATUS_NEGATIVE_HARD_LIMIT_SHIFT 2u

/**
 * The position is beyond the positive soft limit.
 * Printed as FFLAG_SWPOSILMT.
 * Source: 3.1 L640
 */
#define CK10_MOTION_STATUS_POSITIVE_SOFT_LIMIT_MASK 0x00000008u
#define CK10_MOTION_STATUS_POSITIVE_SOFT_LIMIT_SHIFT 3u

/**
 * The position is beyond the negative soft limit.
 * Printed as FFLAG_SWNEGALMT.
 * Source: 3.1 L641
 */
#define CK10_MOTION_STATUS_NEGATIVE_SOFT_LIMIT_MASK 0x00000010u
#define CK10_MOTION_STATUS_NEGATIVE_SOFT_LIMIT_SHIFT 4u

/**
 * The position error is greater than the overflow limit.
 * Printed as FFLAG_ERRPOSOVERFLOW.
 * Source: 3.1 L644
 */
#define CK10_MOTION_STATUS_POSITION_OVERFLOW_MASK 0x00000080u
#define CK10_MOTION_STATUS_POSITION_OVERFLOW_SHIFT 7u

/**
 * Too much current.
 * Printed as FFLAG_ERROVERCURRENT.
 * Source: 3.1 L645
 */
#define CK10_MOTION_STATUS_OVERCURRENT_MASK 0x00000100u
#define CK10_MOTION_STATUS_OVERCURRENT_SHIFT 8u

/**
 * The motor turns faster than 3300 rpm.
 * Printed as FFLAG_ERROVERSPEED.
 * Source: 3.1 L646
 */
#define CK10_MOTION_STATUS_OVERSPEED_MASK 0x00000200u
#define CK10_MOTION_STATUS_OVERSPEED_SHIFT 9u

/**
 * The position error is greater than the tracking limit.
 * Printed as FFLAG_ERRPOSTRACKING.
 * Source: 3.1 L647
 */
#define CK10_MOTION_STATUS_POSITION_TRACKING_MASK 0x00000400u
#define CK10_MOTION_STATUS_POSITION_TRACKING_SHIFT 10u

/**
 * The load has been greater than the motor can bear for more than 5 s.
 * Printed as FFLAG_ERROVERLOAD.
 * Source: 3.1 L648
 */
#define CK10_MOTION_STATUS_OVERLOAD_MASK 0x00000800u
#define CK10_MOTION_STATUS_OVERLOAD_SHIFT 11u

/**
 * The inside of the controller is hotter than 85 degrees Celsius.
 * Printed as FFLAG_ERROVERHEAT.
 * Source: 3.1 L649
 */
#define CK10_MOTION_STATUS_OVERHEAT_MASK 0x00001000u
#define CK10_MOTION_STATUS_OVERHEAT_SHIFT 12u

/**
 * The voltage that the motor gives back is higher than 48 V.
 * Printed as FFLAG_ERRBACKEMF.
 * Source: 3.1 L650
 */
#define CK10_MOTION_STATUS_BACK_EMF_MASK 0x00002000u
#define CK10_MOTION_STATUS_BACK_EMF_SHIFT 13u

/**
 * After the stop there was a position error for more than 3 s.
 * Printed as FFLAG_ERRINPOSITION.
 * Source: 3.1 L652
 */
#define CK10_MOTION_STATUS_IN_POSITION_ERROR_MASK 0x00008000u
#define CK10_MOTION_STATUS_IN_POSITION_ERROR_SHIFT 15u

/**
 * The controller is in the emergency stop.
 * Printed as FFLAG_EMGSTOP.
 * Source: 3.1 L653
 */
#define CK10_MOTION_STATUS_EMERGENCY_STOP_MASK 0x00010000u
#define CK10_MOTION_STATUS_EMERGENCY_STOP_SHIFT 16u

/**
 * The motor is coming to an ordinary stop.
 * Printed as FFLAG_SLOWSTOP.
 * Source: 3.1 L654
 */
#define CK10_MOTION_STATUS_SLOW_STOP_MASK 0x00020000u
#define CK10_MOTION_STATUS_SLOW_STOP_SHIFT 17u

/**
 * The motor is homing.
 * Printed as FFLAG_ORIGINRETURNING.
 * Source: 3.1 L655
 */
#define CK10_MOTION_STATUS_HOMING_MASK 0x00040000u
#define CK10_MOTION_STATUS_HOMING_SHIFT 18u

/**
 * The motor is in position.
 * Printed as FFLAG_INPOSITION.
 * Source: 3.1 L656
 */
#define CK10_MOTION_STATUS_IN_POSITION_MASK 0x00080000u
#define CK10_MOTION_STATUS_IN_POSITION_SHIFT 19u

/**
 * The controller drives the motor.
 * Printed as FFLAG_SERVOON.
 * Source: 3.1 L657
 */
#define CK10_MOTION_STATUS_SERVO_ON_MASK 0x00100000u
#define CK10_MOTION_STATUS_SERVO_ON_SHIFT 20u

/**
 * The alarm has been reset.
 * Printed as FFLAG_ALARMRESET.
 * Source: 3.1 L658
 */
#define CK10_MOTION_STATUS_ALARM_RESET_MASK 0x00200000u
#define CK10_MOTION_STATUS_ALARM_RESET_SHIFT 21u

/**
 * The point table has come to its end.
 * Printed as FFLAG_PTSTOPPED.
 * Source: 3.1 L659
 */
#define CK10_MOTION_STATUS_POINT_TABLE_STOPPED_MASK 0x00400000u
#define CK10_MOTION_STATUS_POINT_TABLE_STOPPED_SHIFT 22u

/**
 * The origin sensor is on.
 * Printed as FFLAG_ORIGINSENSOR.
 * Source: 3.1 L660
 */
#define CK10_MOTION_STATUS_ORIGIN_SENSOR_MASK 0x00800000u
#define CK10_MOTION_STATUS_ORIGIN_SENSOR_SHIFT 23u

/**
 * The motor is at the Z phase of the encoder.
 * Printed as FFLAG_ZPULSE.
 * Source: 3.1 L661
 */
#define CK10_MOTION_STATUS_Z_PULSE_MASK 0x01000000u
#define CK10_MOTION_STATUS_Z_PULSE_SHIFT 24u

/**
 * Homing has been completed.
 * Printed as FFLAG_ORIGINRETOK.
 * Source: 3.1 L662
 */
#define CK10_MOTION_STATUS_HOMING_COMPLETE_MASK 0x02000000u
#define CK10_MOTION_STATUS_HOMING_COMPLETE_SHIFT 25u

/**
 * The direction of the move.
 * Printed as FFLAG_MOTIONDIR.
 * Note: Which direction is 1 is not printed.
 * Source: 3.1 L663
 */
#define CK10_MOTION_STATUS_DIRECTION_MASK 0x04000000u
#define CK10_MOTION_STATUS_DIRECTION_SHIFT 26u

/**
 * The motor moves.
 * Printed as FFLAG_MOTIONING.
 * Source: 3.1 L664
 */
#define CK10_MOTION_STATUS_MOVING_MASK 0x08000000u
#define CK10_MOTION_STATUS_MOVING_SHIFT 27u

/**
 * The motor accelerates.
 * Printed as FFLAG_MOTIONACCEL.
 * Source: 3.1 L666
 */
#define CK10_MOTION_STATUS_ACCELERATING_MASK 0x20000000u
#define CK10_MOTION_STATUS_ACCELERATING_SHIFT 29u

/**
 * The motor decelerates.
 * Printed as FFLAG_MOTIONDECEL.
 * Source: 3.1 L667
 */
#define CK10_MOTION_STATUS_DECELERATING_MASK 0x40000000u
#define CK10_MOTION_STATUS_DECELERATING_SHIFT 30u

/**
 * The motor moves at a constant speed.
 * Printed as FFLAG_MOTIONCONST.
 * Source: 3.1 L668
 */
#define CK10_MOTION_STATUS_CONSTANT_SPEED_MASK 0x80000000u
#define CK10_MOTION_STATUS_CONSTANT_SPEED_SHIFT 31u

/**
 * The inputs of 03F2h. Each mask is also the value that assigns the signal to an input.
 * Printed as 輸入位元定義.
 * A word of 32 bits.
 * Note: The masks of point address 5 to 7 are those of the user's inputs 6 to 8 too.
 * Note: Eight inputs make the number of a point, which goes to 127 only.
 * Source: 3.2 L670
 */
typedef uint32_t ck10_input_signals;

/**
 * Printed as Limit+.
 * Source: 3.2 L675
 */
#define CK10_INPUT_SIGNALS_POSITIVE_LIMIT_MASK 0x00000001u
#define CK10_INPUT_SIGNALS_POSITIVE_LIMIT_SHIFT 0u

/**
 * Printed as Limit-.
 * Source: 3.2 L676
 */
#define CK10_INPUT_SIGNALS_NEGATIVE_LIMIT_MASK 0x00000002u
#define CK10_INPUT_SIGNALS_NEGATIVE_LIMIT_SHIFT 1u

/**
 * Printed as Origin.
 * Source: 3.2 L677
 */
#define CK10_INPUT_SIGNALS_ORIGIN_MASK 0x00000004u
#define CK10_INPUT_SIGNALS_ORIGIN_SHIFT 2u

/**
 * Printed as Clear Position.
 * Source: 3.2 L678
 */
#define CK10_INPUT_SIGNALS_CLEAR_POSITION_MASK 0x00000008u
#define CK10_INPUT_SIGNALS_CLEAR_POSITION_SHIFT 3u

/**
 * Printed as PT A0.
 * Source: 3.2 L679
 */
#define CK10_INPUT_SIGNALS_POINT_ADDRESS_0_MASK 0x00000010u
#define CK10_INPUT_SIGNALS_POINT_ADDRESS_0_SHIFT 4u

/**
 * Printed as PT A1.
 * Source: 3.2 L680
 */
#define CK10_INPUT_SIGNALS_POINT_ADDRESS_1_MASK 0x00000020u
#define CK10_INPUT_SIGNALS_POINT_ADDRESS_1_SHIFT 5u

/**
 * Printed as PT A2.
 * Source: 3.2 L681
 */
#define CK10_INPUT_SIGNALS_POINT_ADDRESS_2_MASK 0x00000040u
#define CK10_INPUT_SIGNALS_POINT_ADDRESS_2_SHIFT 6u

/**
 * Printed as PT A3.
 * Source: 3.2 L682
 */
#define CK10_INPUT_SIGNALS_POINT_ADDRESS_3_MASK 0x00000080u
#define CK10_INPUT_SIGNALS_POINT_ADDRESS_3_SHIFT 7u

/**
 * Printed as PT A4.
 * Source: 3.2 L675
 */
#define CK10_INPUT_SIGNALS_POINT_ADDRESS_4_MASK 0x00000100u
#define CK10_INPUT_SIGNALS_POINT_ADDRESS_4_SHIFT 8u

/**
 * Printed as PT A5 / User IN 6.
 * Source: 3.2 L676
 */
#define CK10_INPUT_SIGNALS_POINT_ADDRESS_5_OR_USER_6_MASK 0x00000200u
#define CK10_INPUT_SIGNALS_POINT_ADDRESS_5_OR_USER_6_SHIFT 9u

/**
 * Printed as PT A6 / User IN 7.
 * Source: 3.2 L677
 */
#define CK10_INPUT_SIGNALS_POINT_ADDRESS_6_OR_USER_7_MASK 0x00000400u
#define CK10_INPUT_SIGNALS_POINT_ADDRESS_6_OR_USER_7_SHIFT 10u

/**
 * Printed as PT A7 / User IN 8.
 * Source: 3.2 L678
 */
#define CK10_INPUT_SIGNALS_POINT_ADDRESS_7_OR_USER_8_MASK 0x00000800u
#define CK10_INPUT_SIGNALS_POINT_ADDRESS_7_OR_USER_8_SHIFT 11u

/**
 * Printed as PT Start.
 * Source: 3.2 L679
 */
#define CK10_INPUT_SIGNALS_START_POINT_TABLE_MASK 0x00001000u
#define CK10_INPUT_SIGNALS_START_POINT_TABLE_SHIFT 12u

/**
 * Printed as Stop.
 * Source: 3.2 L680
 */
#define CK10_INPUT_SIGNALS_STOP_MASK 0x00002000u
#define CK10_INPUT_SIGNALS_STOP_SHIFT 13u

/**
 * Printed as Jog+.
 * Source: 3.2 L681
 */
#define CK10_INPUT_SIGNALS_JOG_POSITIVE_MASK 0x00004000u
#define CK10_INPUT_SIGNALS_JOG_POSITIVE_SHIFT 14u

/**
 * Printed as Jog-.
 * Source: 3.2 L682
 */
#define CK10_INPUT_SIGNALS_JOG_NEGATIVE_MASK 0x00008000u
#define CK10_INPUT_SIGNALS_JOG_NEGATIVE_SHIFT 15u

/**
 * Printed as Alarm Reset.
 * Source: 3.2 L675
 */
#define CK10_INPUT_SIGNALS_RESET_ALARM_MASK 0x00010000u
#define CK10_INPUT_SIGNALS_RESET_ALARM_SHIFT 16u

/**
 * Printed as Servo ON.
 * Source: 3.2 L676
 */
#define CK10_INPUT_SIGNALS_SERVO_ON_MASK 0x00020000u
#define CK10_INPUT_SIGNALS_SERVO_ON_SHIFT 17u

/**
 * Printed as Org Search.
 * Source: 3.2 L678
 */
#define CK10_INPUT_SIGNALS_START_HOMING_MASK 0x00080000u
#define CK10_INPUT_SIGNALS_START_HOMING_SHIFT 19u

/**
 * Printed as E-stop.
 * Source: 3.2 L680
 */
#define CK10_INPUT_SIGNALS_EMERGENCY_STOP_MASK 0x00200000u
#define CK10_INPUT_SIGNALS_EMERGENCY_STOP_SHIFT 21u

/**
 * Printed as JPT Input 0.
 * Source: 3.2 L681
 */
#define CK10_INPUT_SIGNALS_JUMP_0_MASK 0x00400000u
#define CK10_INPUT_SIGNALS_JUMP_0_SHIFT 22u

/**
 * Printed as JPT Input 1.
 * Source: 3.2 L682
 */
#define CK10_INPUT_SIGNALS_JUMP_1_MASK 0x00800000u
#define CK10_INPUT_SIGNALS_JUMP_1_SHIFT 23u

/**
 * Printed as JPT input 2.
 * Source: 3.2 L675
 */
#define CK10_INPUT_SIGNALS_JUMP_2_MASK 0x01000000u
#define CK10_INPUT_SIGNALS_JUMP_2_SHIFT 24u

/**
 * Printed as JPT Start.
 * Source: 3.2 L676
 */
#define CK10_INPUT_SIGNALS_START_JUMP_MASK 0x02000000u
#define CK10_INPUT_SIGNALS_START_JUMP_SHIFT 25u

/**
 * Printed as User IN 0.
 * Source: 3.2 L677
 */
#define CK10_INPUT_SIGNALS_USER_0_MASK 0x04000000u
#define CK10_INPUT_SIGNALS_USER_0_SHIFT 26u

/**
 * Printed as User IN 1.
 * Source: 3.2 L678
 */
#define CK10_INPUT_SIGNALS_USER_1_MASK 0x08000000u
#define CK10_INPUT_SIGNALS_USER_1_SHIFT 27u

/**
 * Printed as User IN 2.
 * Source: 3.2 L679
 */
#define CK10_INPUT_SIGNALS_USER_2_MASK 0x10000000u
#define CK10_INPUT_SIGNALS_USER_2_SHIFT 28u

/**
 * Printed as User IN 3.
 * Source: 3.2 L680
 */
#define CK10_INPUT_SIGNALS_USER_3_MASK 0x20000000u
#define CK10_INPUT_SIGNALS_USER_3_SHIFT 29u

/**
 * Printed as User IN 4.
 * Source: 3.2 L681
 */
#define CK10_INPUT_SIGNALS_USER_4_MASK 0x40000000u
#define CK10_INPUT_SIGNALS_USER_4_SHIFT 30u

/**
 * Printed as User IN 5.
 * Source: 3.2 L682
 */
#define CK10_INPUT_SIGNALS_USER_5_MASK 0x80000000u
#define CK10_INPUT_SIGNALS_USER_5_SHIFT 31u

/**
 * The outputs of 03F4h. Each mask is also the value that assigns the signal to an output.
 * Printed as 輸出位元定義.
 * A word of 32 bits.
 * Source: 3.3 L690
 */
typedef uint32_t ck10_output_signals;

/**
 * Printed as Compare Out.
 * Source: 3.3 L695
 */
#define CK10_OUTPUT_SIGNALS_COMPARE_OUTPUT_MASK 0x00000001u
#define CK10_OUTPUT_SIGNALS_COMPARE_OUTPUT_SHIFT 0u

/**
 * Printed as Inposition.
 * Source: 3.3 L696
 */
#define CK10_OUTPUT_SIGNALS_IN_POSITION_MASK 0x00000002u
#define CK10_OUTPUT_SIGNALS_IN_POSITION_SHIFT 1u

/**
 * Printed as Alarm.
 * Source: 3.3 L697
 */
#define CK10_OUTPUT_SIGNALS_ALARM_MASK 0x00000004u
#define CK10_OUTPUT_SIGNALS_ALARM_SHIFT 2u

/**
 * Printed as Moving.
 * Source: 3.3 L698
 */
#define CK10_OUTPUT_SIGNALS_MOVING_MASK 0x00000008u
#define CK10_OUTPUT_SIGNALS_MOVING_SHIFT 3u

/**
 * Printed as Acc/Dec.
 * Source: 3.3 L699
 */
#define CK10_OUTPUT_SIGNALS_ACCELERATING_OR_DECELERATING_MASK 0x00000010u
#define CK10_OUTPUT_SIGNALS_ACCELERATING_OR_DECELERATING_SHIFT 4u

/**
 * Printed as ACK.
 * Source: 3.3 L700
 */
#define CK10_OUTPUT_SIGNALS_ACKNOWLEDGE_MASK 0x00000020u
#define CK10_OUTPUT_SIGNALS_ACKNOWLEDGE_SHIFT 5u

/**
 * Printed as END.
 * Source: 3.3 L701
 */
#define CK10_OUTPUT_SIGNALS_END_MASK 0x00000040u
#define CK10_OUTPUT_SIGNALS_END_SHIFT 6u

/**
 * Printed as AlarmBlink.
 * Source: 3.3 L702
 */
#define CK10_OUTPUT_SIGNALS_ALARM_BLINK_MASK 0x00000080u
#define CK10_OUTPUT_SIGNALS_ALARM_BLINK_SHIFT 7u

/**
 * Printed as Origin Search OK.
 * Source: 3.3 L695
 */
#define CK10_OUTPUT_SIGNALS_HOMING_COMPLETE_MASK 0x00000100u
#define CK10_OUTPUT_SIGNALS_HOMING_COMPLETE_SHIFT 8u

/**
 * Printed as Servo Ready.
 * Source: 3.3 L696
 */
#define CK10_OUTPUT_SIGNALS_SERVO_READY_MASK 0x00000200u
#define CK10_OUTPUT_SIGNALS_SERVO_READY_SHIFT 9u

/**
 * Printed as PT Output0.
 * Source: 3.3 L699
 */
#define CK10_OUTPUT_SIGNALS_POINT_OUTPUT_0_MASK 0x00001000u
#define CK10_OUTPUT_SIGNALS_POINT_OUTPUT_0_SHIFT 12u

/**
 * Printed as PT Output1.
 * Source: 3.3 L700
 */
#define CK10_OUTPUT_SIGNALS_POINT_OUTPUT_1_MASK 0x00002000u
#define CK10_OUTPUT_SIGNALS_POINT_OUTPUT_1_SHIFT 13u

/**
 * Printed as PT Output2.
 * Source: 3.3 L701
 */
#define CK10_OUTPUT_SIGNALS_POINT_OUTPUT_2_MASK 0x00004000u
#define CK10_OUTPUT_SIGNALS_POINT_OUTPUT_2_SHIFT 14u

/**
 * Printed as User Out 0.
 * Source: 3.3 L702
 */
#define CK10_OUTPUT_SIGNALS_USER_0_MASK 0x00008000u
#define CK10_OUTPUT_SIGNALS_USER_0_SHIFT 15u

/**
 * Printed as User Out 1.
 * Source: 3.3 L695
 */
#define CK10_OUTPUT_SIGNALS_USER_1_MASK 0x00010000u
#define CK10_OUTPUT_SIGNALS_USER_1_SHIFT 16u

/**
 * Printed as User Out 2.
 * Source: 3.3 L696
 */
#define CK10_OUTPUT_SIGNALS_USER_2_MASK 0x00020000u
#define CK10_OUTPUT_SIGNALS_USER_2_SHIFT 17u

/**
 * Printed as User Out 3.
 * Source: 3.3 L697
 */
#define CK10_OUTPUT_SIGNALS_USER_3_MASK 0x00040000u
#define CK10_OUTPUT_SIGNALS_USER_3_SHIFT 18u

/**
 * Printed as User Out 4.
 * Source: 3.3 L698
 */
#define CK10_OUTPUT_SIGNALS_USER_4_MASK 0x00080000u
#define CK10_OUTPUT_SIGNALS_USER_4_SHIFT 19u

/**
 * Printed as User Out 5.
 * Source: 3.3 L699
 */
#define CK10_OUTPUT_SIGNALS_USER_5_MASK 0x00100000u
#define CK10_OUTPUT_SIGNALS_USER_5_SHIFT 20u

/**
 * Printed as User Out 6.
 * Source: 3.3 L700
 */
#define CK10_OUTPUT_SIGNALS_USER_6_MASK 0x00200000u
#define CK10_OUTPUT_SIGNALS_USER_6_SHIFT 21u

/**
 * Printed as User Out 7.
 * Source: 3.3 L701
 */
#define CK10_OUTPUT_SIGNALS_USER_7_MASK 0x00400000u
#define CK10_OUTPUT_SIGNALS_USER_7_SHIFT 22u

/**
 * Printed as User Out 8.
 * Source: 3.3 L702
 */
#define CK10_OUTPUT_SIGNALS_USER_8_MASK 0x00800000u
#define CK10_OUTPUT_SIGNALS_USER_8_SHIFT 23u

/**
 * Printed as USR_IN_ALL.
 * A word of 16 bits.
 * Source: 2.2 L270
 */
typedef uint16_t ck10_user_inputs;

/** Source: 2.2 L270 */
#define CK10_USER_INPUTS_USER_0_MASK 0x0001u
#define CK10_USER_INPUTS_USER_0_SHIFT 0u

/** Source: 2.2 L270 */
#define CK10_USER_INPUTS_USER_1_MASK 0x0002u
#define CK10_USER_INPUTS_USER_1_SHIFT 1u

/** Source: 2.2 L270 */
#define CK10_USER_INPUTS_USER_2_MASK 0x0004u
#define CK10_USER_INPUTS_USER_2_SHIFT 2u

/** Source: 2.2 L270 */
#define CK10_USER_INPUTS_USER_3_MASK 0x0008u
#define CK10_USER_INPUTS_USER_3_SHIFT 3u

/** Source: 2.2 L270 */
#define CK10_USER_INPUTS_USER_4_MASK 0x0010u
#define CK10_USER_INPUTS_USER_4_SHIFT 4u

/** Source: 2.2 L270 */
#define CK10_USER_INPUTS_USER_5_MASK 0x0020u
#define CK10_USER_INPUTS_USER_5_SHIFT 5u

/** Source: 2.2 L270 */
#define CK10_USER_INPUTS_USER_6_MASK 0x0040u
#define CK10_USER_INPUTS_USER_6_SHIFT 6u

/** Source: 2.2 L270 */
#define CK10_USER_INPUTS_USER_7_MASK 0x0080u
#define CK10_USER_INPUTS_USER_7_SHIFT 7u

/** Source: 2.2 L270 */
#define CK10_USER_INPUTS_USER_8_MASK 0x0100u
#define CK10_USER_INPUTS_USER_8_SHIFT 8u

/**
 * Printed as USR_OUT_ALL.
 * A word of 16 bits.
 * Source: 2.2 L280
 */
typedef uint16_t ck10_user_outputs;

/** Source: 2.2 L280 */
#define CK10_USER_OUTPUTS_USER_0_MASK 0x0001u
#define CK10_USER_OUTPUTS_USER_0_SHIFT 0u

/** Source: 2.2 L280 */
#define CK10_USER_OUTPUTS_USER_1_MASK 0x0002u
#define CK10_USER_OUTPUTS_USER_1_SHIFT 1u

/** Source: 2.2 L280 */
#define CK10_USER_OUTPUTS_USER_2_MASK 0x0004u
#define CK10_USER_OUTPUTS_USER_2_SHIFT 2u

/** Source: 2.2 L280 */
#define CK10_USER_OUTPUTS_USER_3_MASK 0x0008u
#define CK10_USER_OUTPUTS_USER_3_SHIFT 3u

/** Source: 2.2 L280 */
#define CK10_USER_OUTPUTS_USER_4_MASK 0x0010u
#define CK10_USER_OUTPUTS_USER_4_SHIFT 4u

/** Source: 2.2 L280 */
#define CK10_USER_OUTPUTS_USER_5_MASK 0x0020u
#define CK10_USER_OUTPUTS_USER_5_SHIFT 5u

/** Source: 2.2 L280 */
#define CK10_USER_OUTPUTS_USER_6_MASK 0x0040u
#define CK10_USER_OUTPUTS_USER_6_SHIFT 6u

/** Source: 2.2 L280 */
#define CK10_USER_OUTPUTS_USER_7_MASK 0x0080u
#define CK10_USER_OUTPUTS_USER_7_SHIFT 7u

/** Source: 2.2 L280 */
#define CK10_USER_OUTPUTS_USER_8_MASK 0x0100u
#define CK10_USER_OUTPUTS_USER_8_SHIFT 8u

/**
 * Which outputs a point sets, and when.
 * Printed as PT 設定.
 * A word of 16 bits.
 * Note: 3.5 gives the whole number: 0, 8 and 16 set no output; 1 to 7 at the start, 9 to 15 at the end, 17 to
 * 23 at the trigger position.
 * Source: 2.7 L589; 3.5 L860
 */
typedef uint16_t ck10_point_output_setting;

/**
 * Printed as PT Output0.
 * Source: 2.7 L589
 */
#define CK10_POINT_OUTPUT_SETTING_POINT_OUTPUT_0_MASK 0x0001u
#define CK10_POINT_OUTPUT_SETTING_POINT_OUTPUT_0_SHIFT 0u

/**
 * Printed as PT Output1.
 * Source: 2.7 L589
 */
#define CK10_POINT_OUTPUT_SETTING_POINT_OUTPUT_1_MASK 0x0002u
#define CK10_POINT_OUTPUT_SETTING_POINT_OUTPUT_1_SHIFT 1u

/**
 * Printed as PT Output2.
 * Source: 2.7 L589
 */
#define CK10_POINT_OUTPUT_SETTING_POINT_OUTPUT_2_MASK 0x0004u
#define CK10_POINT_OUTPUT_SETTING_POINT_OUTPUT_2_SHIFT 2u

/**
 * When the outputs come on.
 * See output_moment.
 * Source: 2.7 L589; 3.5 L860
 */
#define CK10_POINT_OUTPUT_SETTING_MOMENT_MASK 0x0018u
#define CK10_POINT_OUTPUT_SETTING_MOMENT_SHIFT 3u

/* ---- Records ---- */

#define CK10_EXCEPTION_SIZE 1u

#define CK10_POINT_SIZE 64u

/* ---- Data of requests and responses ---- */

/**
 * Reads neighbouring registers.
 * Printed as 0x03 讀取暫存器.
 * Read holding registers.
 * Note: How many registers one request may read is not printed; 125 are what a frame of Modbus has room for.
 * Source: 1.3 L122-138
 */
#define CK10_READ_REGISTERS_CODE 3u

#define CK10_READ_REGISTERS_REQUEST_SIZE 4u

#define CK10_READ_REGISTERS_RESPONSE_SIZE 251u

/**
 * Writes one register. The response repeats the request.
 * Printed as 0x06 寫入單一暫存器.
 * Write one register.
 * Source: 1.3 L140-158
 */
#define CK10_WRITE_REGISTER_CODE 6u

#define CK10_WRITE_REGISTER_REQUEST_SIZE 4u

#define CK10_WRITE_REGISTER_RESPONSE_SIZE 4u

/**
 * Writes neighbouring registers. The response repeats the address and the number.
 * Printed as 0x10 寫入多個暫存器.
 * Write several registers.
 * Note: How many registers one request may write is not printed; 123 are what a frame of Modbus has room for.
 * Source: 1.3 L160-176
 */
#define CK10_WRITE_REGISTERS_CODE 16u

#define CK10_WRITE_REGISTERS_REQUEST_SIZE 251u

#define CK10_WRITE_REGISTERS_RESPONSE_SIZE 4u

/**
 * Asks for the identity and the running state of the controller. CK10 always gives the same answer.
 * Printed as 0x11 回報從站 ID.
 * Report the device's identity.
 * Source: 1.3 L178-194
 */
#define CK10_REPORT_SERVER_ID_CODE 17u

#define CK10_REPORT_SERVER_ID_REQUEST_SIZE 0u

#define CK10_REPORT_SERVER_ID_RESPONSE_SIZE 3u

/* ---- Registers ---- */

/**
 * Printed as AxisStartSpd 運動起始速度.
 * Read and write. 2 words must be accessed in one request. The same as start_speed.
 * One count is 1 pps.
 * Source: 2.4 L306
 */
#define CK10_REG_AXIS_START_SPEED_ADDRESS 0x07D0u
#define CK10_REG_AXIS_START_SPEED_WORDS 2u

/**
 * Printed as AxisAccTime 運動加速時間.
 * Read and write. The same as acceleration_time.
 * One count is 1 ms.
 * Note: One word here, two at 138Eh: the value is the same, its width is not.
 * Source: 2.4 L307
 */
#define CK10_REG_AXIS_ACCELERATION_TIME_ADDRESS 0x07D2u
#define CK10_REG_AXIS_ACCELERATION_TIME_WORDS 1u

/**
 * Printed as AxisDecTime 運動減速時間.
 * Read and write. The same as deceleration_time.
 * One count is 1 ms.
 * Note: One word here, two at 1390h.
 * Source: 2.4 L308
 */
#define CK10_REG_AXIS_DECELERATION_TIME_ADDRESS 0x07D3u
#define CK10_REG_AXIS_DECELERATION_TIME_WORDS 1u

/**
 * The speed of the move that 07D8h starts.
 * Printed as AxisMoveSpd 運動速度.
 * Read and write. 2 words must be accessed in one request.
 * Note: Neither unit nor range is printed; the speeds of 3.4 are in pps, and 138Ah limits them.
 * Source: 2.4 L309
 */
#define CK10_REG_AXIS_MOVE_SPEED_ADDRESS 0x07D4u
#define CK10_REG_AXIS_MOVE_SPEED_WORDS 2u

/**
 * Where to, or how far, 07D8h moves.
 * Printed as SetDistPos 運動位置或距離.
 * Read and write. 2 words must be accessed in one request.
 * Note: Neither unit nor range is printed; the positions of points are in pulses (2.7 L575).
 * Source: 2.4 L310
 */
#define CK10_REG_TARGET_POSITION_OR_DISTANCE_ADDRESS 0x07D6u
#define CK10_REG_TARGET_POSITION_OR_DISTANCE_WORDS 2u

/**
 * Writing starts a move. Reading gives the kind of the last one.
 * Printed as MoveTypeTrg 運動類型.
 * Read and write. Writing starts an action.
 * See move_kind.
 * Note: What is read must not be written back: it would start the last kind of move again.
 * Source: 2.4 L311
 */
#define CK10_REG_START_MOVE_ADDRESS 0x07D8u
#define CK10_REG_START_MOVE_WORDS 1u

/**
 * Printed as JogAccDecTime 吋動加減速時間.
 * Read and write. The same as jog_acceleration_time.
 * One count is 1 ms.
 * Note: One word here, two at 1398h.
 * Source: 2.4 L312
 */
#define CK10_REG_AXIS_JOG_ACCELERATION_TIME_ADDRESS 0x07D9u
#define CK10_REG_AXIS_JOG_ACCELERATION_TIME_WORDS 1u

/**
 * Printed as JogStartSpd 吋動起始速度.
 * Read and write. 2 words must be accessed in one request. The same as jog_start_speed.
 * One count is 1 pps.
 * Source: 2.4 L313
 */
#define CK10_REG_AXIS_JOG_START_SPEED_ADDRESS 0x07DAu
#define CK10_REG_AXIS_JOG_START_SPEED_WORDS 2u

/**
 * Printed as JogSpd 吋動速度.
 * Read and write. 2 words must be accessed in one request. The same as jog_speed.
 * One count is 1 pps.
 * Source: 2.4 L314
 */
#define CK10_REG_AXIS_JOG_SPEED_ADDRESS 0x07DCu
#define CK10_REG_AXIS_JOG_SPEED_WORDS 2u

/**
 * Printed as JogDir 吋動方向.
 * Read and write.
 * See jog_direction.
 * Note: 0 is counterclockwise here; in the parameters 13ACh and 13BAh, 0 is clockwise.
 * Source: 2.4 L315
 */
#define CK10_REG_JOG_DIRECTION_ADDRESS 0x07DEu
#define CK10_REG_JOG_DIRECTION_WORDS 1u

/**
 * Writing 1 starts to jog. Reading gives 0.
 * Printed as JogTrg.
 * Read and write. Writing starts an action.
 * Source: 2.4 L316
 */
#define CK10_REG_START_JOG_ADDRESS 0x07DFu
#define CK10_REG_START_JOG_WORDS 1u
#define CK10_REG_START_JOG_VALUE 1u

/**
 * The speed at which the move before the push starts.
 * Printed as PushPosStSpd 位置運動起始速度.
 * Read and write. 2 words must be accessed in one request.
 * Note: Neither unit nor range is printed; the speeds of points are in pps (2.7 L576).
 * Source: 2.4 L321
 */
#define CK10_REG_PUSH_START_SPEED_ADDRESS 0x07E0u
#define CK10_REG_PUSH_START_SPEED_WORDS 2u

/**
 * The speed of the move before the push.
 * Printed as PushPosSpd 位置運動速度.
 * Read and write. 2 words must be accessed in one request.
 * Note: Neither unit nor range is printed; the speeds of points are in pps (2.7 L577).
 * Source: 2.4 L322
 */
#define CK10_REG_PUSH_MOVE_SPEED_ADDRESS 0x07E2u
#define CK10_REG_PUSH_MOVE_SPEED_WORDS 2u

/**
 * Printed as PushPosAcc 位置運動加速時間.
 * Read and write.
 * Note: Neither unit nor range is printed; the times of points are in ms (2.7 L578).
 * Source: 2.4 L323
 */
#define CK10_REG_PUSH_ACCELERATION_TIME_ADDRESS 0x07E4u
#define CK10_REG_PUSH_ACCELERATION_TIME_WORDS 1u

/**
 * Printed as PushPosDec 位置運動減速時間.
 * Read and write.
 * Note: Neither unit nor range is printed; the times of points are in ms (2.7 L579).
 * Source: 2.4 L324
 */
#define CK10_REG_PUSH_DECELERATION_TIME_ADDRESS 0x07E5u
#define CK10_REG_PUSH_DECELERATION_TIME_WORDS 1u

/**
 * Printed as PushMod 偵測到工件時動作.
 * Read and write.
 * See push_mode.
 * Note: The same field of a point counts otherwise: 0 stops, 1 to 10000 do not.
 * Source: 2.4 L325
 */
#define CK10_REG_PUSH_MODE_ADDRESS 0x07E6u
#define CK10_REG_PUSH_MODE_WORDS 1u

/**
 * Printed as PushRatio 推力運動扭力輸出比.
 * Read and write.
 * Note: Neither unit nor range is printed; the same quantity of a point is in %, 20 to 90 (3.5 L865).
 * Source: 2.4 L326
 */
#define CK10_REG_PUSH_TORQUE_RATIO_ADDRESS 0x07E7u
#define CK10_REG_PUSH_TORQUE_RATIO_WORDS 1u

/**
 * Printed as PushSpd 推力運動速度.
 * Read and write. 2 words must be accessed in one request.
 * Note: Neither unit nor range is printed; the same quantity of a point is in pps, 1 to 33333 (3.5 L866).
 * Source: 2.4 L327
 */
#define CK10_REG_PUSH_SPEED_ADDRESS 0x07E8u
#define CK10_REG_PUSH_SPEED_WORDS 2u

/**
 * Where the push begins, after the move to it.
 * Printed as PushStartPos 推力運動起始座標.
 * Read and write. 2 words must be accessed in one request.
 * Note: Neither unit nor range is printed; the positions of points are in pulses (2.7 L575).
 * Source: 2.4 L328
 */
#define CK10_REG_PUSH_START_POSITION_ADDRESS 0x07EAu
#define CK10_REG_PUSH_START_POSITION_WORDS 2u

/**
 * Where the push ends.
 * Printed as PushEndPos 推力運動結束座標.
 * Read and write. 2 words must be accessed in one request.
 * Note: Neither unit nor range is printed; the push position of a point is in pulses (3.5 L867).
 * Source: 2.4 L329
 */
#define CK10_REG_PUSH_END_POSITION_ADDRESS 0x07ECu
#define CK10_REG_PUSH_END_POSITION_WORDS 2u

/**
 * Writing 1 starts the push motion. Reading gives 0.
 * Printed as DoPushMotion 開始推力運動.
 * Read and write. Writing starts an action.
 * Source: 2.4 L330
 */
#define CK10_REG_START_PUSH_MOTION_ADDRESS 0x07EEu
#define CK10_REG_START_PUSH_MOTION_WORDS 1u
#define CK10_REG_START_PUSH_MOTION_VALUE 1u

/**
 * Writing 1 starts homing. The parameters define the method. Reading gives 0.
 * Printed as MoveOrigin 開始回原點.
 * Read and write. Writing starts an action.
 * Source: 2.4 L331
 */
#define CK10_REG_START_HOMING_ADDRESS 0x07EFu
#define CK10_REG_START_HOMING_WORDS 1u
#define CK10_REG_START_HOMING_VALUE 1u

/**
 * Writing stops the move. Reading gives 0.
 * Printed as MoveStop 停止當前運動.
 * Read and write. Writing starts an action.
 * See stop_kind.
 * Note: What is read must not be written back: 0 stops at once.
 * Source: 2.4 L332
 */
#define CK10_REG_STOP_ADDRESS 0x07F0u
#define CK10_REG_STOP_WORDS 1u

/**
 * Whether the motor is driven.
 * Printed as ServoOn 馬達驅動啟用或停用.
 * Read and write.
 * See servo_switch.
 * Source: 2.4 L333
 */
#define CK10_REG_SERVO_ADDRESS 0x07F1u
#define CK10_REG_SERVO_WORDS 1u

/**
 * Writing 1 sets the commanded and the actual position to 0. Reading gives 0.
 * Printed as ClrPos 命令位置及實際位置歸零.
 * Read and write. Writing starts an action.
 * Source: 2.4 L334
 */
#define CK10_REG_CLEAR_POSITION_ADDRESS 0x07F2u
#define CK10_REG_CLEAR_POSITION_WORDS 1u
#define CK10_REG_CLEAR_POSITION_VALUE 1u

/**
 * Writing 1 clears the alarm, and ends an emergency stop. Reading gives 0.
 * Printed as RstAlarm 警報狀態.
 * Read and write. Writing starts an action.
 * Source: 2.4 L335
 */
#define CK10_REG_RESET_ALARM_ADDRESS 0x07F3u
#define CK10_REG_RESET_ALARM_WORDS 1u
#define CK10_REG_RESET_ALARM_VALUE 1u

/**
 * Writing 1 stores the point table of the memory, 2710h to 370Fh, in flash, 4E20h to 5E1Fh. Reading gives 0.
 * Printed as SavePT.
 * Read and write. Writing starts an action.
 * Note: 2.7 calls the register PosTableWriteROM.
 * Source: 2.4 L336
 */
#define CK10_REG_SAVE_POINT_TABLE_ADDRESS 0x07F5u
#define CK10_REG_SAVE_POINT_TABLE_WORDS 1u
#define CK10_REG_SAVE_POINT_TABLE_VALUE 1u

/**
 * The point with which 07F7h starts.
 * Printed as PtNoToStart 位置表執行行號.
 * Read and write.
 * Note: No range is printed; the points are 0 to 127.
 * Source: 2.4 L337
 */
#define CK10_REG_START_POINT_ADDRESS 0x07F6u
#define CK10_REG_START_POINT_WORDS 1u

/**
 * Writing starts the point table, one point of it, or the next step.
 * Printed as DoPT.
 * Read and write. Writing starts an action.
 * See point_table_command.
 * Note: What reading gives is not printed.
 * Source: 2.4 L338
 */
#define CK10_REG_RUN_POINT_TABLE_ADDRESS 0x07F7u
#define CK10_REG_RUN_POINT_TABLE_WORDS 1u

/**
 * Writing 1 stores all parameters of the memory, 1388h to 1431h, in flash, 1450h to 14F9h. Reading gives 0.
 * Printed as SaveAllParam.
 * Read and write. Writing starts an action.
 * Source: 2.6 L356
 */
#define CK10_REG_SAVE_ALL_PARAMETERS_ADDRESS 0x07F4u
#define CK10_REG_SAVE_ALL_PARAMETERS_WORDS 1u
#define CK10_REG_SAVE_ALL_PARAMETERS_VALUE 1u

/**
 * The absolute position of the first pulse.
 * Printed as CmpStPos 輸出脈衝之起始位置.
 * Read and write. 2 words must be accessed in one request.
 * Note: Neither unit nor range is printed; the trigger position of a point is in pulses (3.5 L863).
 * Source: 2.5 L345
 */
#define CK10_REG_COMPARE_START_POSITION_ADDRESS 0x07F8u
#define CK10_REG_COMPARE_START_POSITION_WORDS 2u

/**
 * The distance from pulse to pulse.
 * Printed as CmpPeriod 輸出脈衝之區間.
 * Read and write. 2 words must be accessed in one request.
 * Note: Neither unit nor range is printed; the trigger position of a point is in pulses (3.5 L863).
 * Source: 2.5 L346
 */
#define CK10_REG_COMPARE_PERIOD_ADDRESS 0x07FAu
#define CK10_REG_COMPARE_PERIOD_WORDS 2u

/**
 * How long a pulse is.
 * Printed as CmpPlsWidth 脈衝長度.
 * Read and write.
 * One count is 1 ms. Range: 1..1000.
 * Source: 2.5 L347
 */
#define CK10_REG_COMPARE_PULSE_WIDTH_ADDRESS 0x07FCu
#define CK10_REG_COMPARE_PULSE_WIDTH_WORDS 1u
#define CK10_REG_COMPARE_PULSE_WIDTH_MIN 1u
#define CK10_REG_COMPARE_PULSE_WIDTH_MAX 1000u

/**
 * Enables the compare output.
 * Printed as CmpEnable.
 * Read and write.
 * Source: 2.5 L348
 */
#define CK10_REG_COMPARE_ENABLE_ADDRESS 0x07FDu
#define CK10_REG_COMPARE_ENABLE_WORDS 1u

/**
 * Whether the compare output is enabled.
 * Printed as CmpStat.
 * Read only.
 * Source: 2.5 L349
 */
#define CK10_REG_COMPARE_ACTIVE_ADDRESS 0x07FEu
#define CK10_REG_COMPARE_ACTIVE_WORDS 1u

/**
 * The model of the controller: CK10 answers 104, as its identity does in function 11h.
 * Printed as MODEL_ID 控制器型號 ID.
 * Read only. 2 words must be accessed in one request.
 * Source: 2.8 L623
 */
#define CK10_REG_MODEL_ID_ADDRESS 0x0834u
#define CK10_REG_MODEL_ID_WORDS 2u
#define CK10_REG_MODEL_ID_VALUE 104u

/**
 * The hardware of the controller: CK10 answers 31.
 * Printed as HW_TYPE 控制器硬體 ID.
 * Read only.
 * Source: 2.8 L624
 */
#define CK10_REG_HARDWARE_TYPE_ADDRESS 0x0836u
#define CK10_REG_HARDWARE_TYPE_WORDS 1u
#define CK10_REG_HARDWARE_TYPE_VALUE 31u

/**
 * Printed as FW_VER 韌體版本.
 * Read only.
 * Note: How the number is to be read is not printed.
 * Source: 2.8 L625
 */
#define CK10_REG_FIRMWARE_VERSION_ADDRESS 0x0837u
#define CK10_REG_FIRMWARE_VERSION_WORDS 1u

/**
 * How often the controller has been switched on.
 * Printed as NO_PWR_CYCLE 電源週期總數.
 * Read only. 2 words must be accessed in one request.
 * Source: 2.8 L626
 */
#define CK10_REG_POWER_CYCLES_ADDRESS 0x0838u
#define CK10_REG_POWER_CYCLES_WORDS 2u

/**
 * The turns that the controller has made in all.
 * Printed as TURN_TOTAL 控制器總轉動數.
 * Read only. 4 words must be accessed in one request.
 * One count is 1 rev.
 * Source: 2.8 L627
 */
#define CK10_REG_TURNS_TOTAL_ADDRESS 0x083Au
#define CK10_REG_TURNS_TOTAL_WORDS 4u

/**
 * The turns since it was switched on.
 * Printed as TURN_CURPWR 送電後轉動數.
 * Read only. 4 words must be accessed in one request.
 * One count is 1 rev.
 * Source: 2.8 L628
 */
#define CK10_REG_TURNS_SINCE_POWER_ON_ADDRESS 0x083Eu
#define CK10_REG_TURNS_SINCE_POWER_ON_WORDS 4u

/**
 * The pulses of one turn. Changing it switches the servo off.
 * Printed as 解析度.
 * Read and write. 2 words must be accessed in one request.
 * One count is 1 pulse/rev. Range: 0..50000. See pulses_per_turn.
 * Source: 2.6 L364; 3.4 L713
 */
#define CK10_REG_RESOLUTION_ADDRESS 0x1388u
#define CK10_REG_RESOLUTION_WORDS 2u
#define CK10_REG_RESOLUTION_NUMBER 0u
#define CK10_REG_RESOLUTION_MIN 0u
#define CK10_REG_RESOLUTION_MAX 50000u
#define CK10_REG_RESOLUTION_DEFAULT 0u

/**
 * The greatest speed of a move.
 * Printed as 軸最大速度.
 * Read and write. 2 words must be accessed in one request.
 * One count is 1 pps. Range: 1..800000.
 * Note: The resolution limits it further: 500000 pps at 10000 pulses per turn, 800000 pps at 16000. At 20000
 * the same 3000 rpm would be more than the greatest value.
 * Source: 2.6 L365; 3.4 L723
 */
#define CK10_REG_MAXIMUM_SPEED_ADDRESS 0x138Au
#define CK10_REG_MAXIMUM_SPEED_WORDS 2u
#define CK10_REG_MAXIMUM_SPEED_NUMBER 1u
#define CK10_REG_MAXIMUM_SPEED_MIN 1u
#define CK10_REG_MAXIMUM_SPEED_MAX 800000u
#define CK10_REG_MAXIMUM_SPEED_DEFAULT 500000u

/**
 * The speed at which a move starts.
 * Printed as 軸起始速度.
 * Read and write. 2 words must be accessed in one request.
 * One count is 1 pps. Range: 1..35000.
 * Source: 2.6 L366; 3.4 L724
 */
#define CK10_REG_START_SPEED_ADDRESS 0x138Cu
#define CK10_REG_START_SPEED_WORDS 2u
#define CK10_REG_START_SPEED_NUMBER 2u
#define CK10_REG_START_SPEED_MIN 1u
#define CK10_REG_START_SPEED_MAX 35000u
#define CK10_REG_START_SPEED_DEFAULT 1u

/**
 * The acceleration time of a move.
 * Printed as 軸加速時間.
 * Read and write. 2 words must be accessed in one request.
 * One count is 1 ms. Range: 1..9999.
 * Source: 2.6 L367; 3.4 L725
 */
#define CK10_REG_ACCELERATION_TIME_ADDRESS 0x138Eu
#define CK10_REG_ACCELERATION_TIME_WORDS 2u
#define CK10_REG_ACCELERATION_TIME_NUMBER 3u
#define CK10_REG_ACCELERATION_TIME_MIN 1u
#define CK10_REG_ACCELERATION_TIME_MAX 9999u
#define CK10_REG_ACCELERATION_TIME_DEFAULT 100u

/**
 * The deceleration time of a move.
 * Printed as 軸減速時間.
 * Read and write. 2 words must be accessed in one request.
 * One count is 1 ms. Range: 1..9999.
 * Source: 2.6 L368; 3.4 L726
 */
#define CK10_REG_DECELERATION_TIME_ADDRESS 0x1390u
#define CK10_REG_DECELERATION_TIME_WORDS 2u
#define CK10_REG_DECELERATION_TIME_NUMBER 4u
#define CK10_REG_DECELERATION_TIME_MIN 1u
#define CK10_REG_DECELERATION_TIME_MAX 9999u
#define CK10_REG_DECELERATION_TIME_DEFAULT 100u

/**
 * Printed as 保留.
 * Read and write. 2 words must be accessed in one request.
 * Range: 100.
 * Source: 2.6 L369; 3.4 L727
 */
#define CK10_REG_RESERVED_5_ADDRESS 0x1392u
#define CK10_REG_RESERVED_5_WORDS 2u
#define CK10_REG_RESERVED_5_NUMBER 5u
#define CK10_REG_RESERVED_5_MIN 100u
#define CK10_REG_RESERVED_5_MAX 100u
#define CK10_REG_RESERVED_5_DEFAULT 100u

/**
 * The speed of jogging.
 * Printed as 吋動速度.
 * Read and write. 2 words must be accessed in one request.
 * One count is 1 pps. Range: 1..800000.
 * Source: 2.6 L370; 3.4 L728
 */
#define CK10_REG_JOG_SPEED_ADDRESS 0x1394u
#define CK10_REG_JOG_SPEED_WORDS 2u
#define CK10_REG_JOG_SPEED_NUMBER 6u
#define CK10_REG_JOG_SPEED_MIN 1u
#define CK10_REG_JOG_SPEED_MAX 800000u
#define CK10_REG_JOG_SPEED_DEFAULT 5000u

/**
 * The speed at which jogging starts.
 * Printed as 吋動起始速度.
 * Read and write. 2 words must be accessed in one request.
 * One count is 1 pps. Range: 1..35000.
 * Source: 2.6 L371; 3.4 L729
 */
#define CK10_REG_JOG_START_SPEED_ADDRESS 0x1396u
#define CK10_REG_JOG_START_SPEED_WORDS 2u
#define CK10_REG_JOG_START_SPEED_NUMBER 7u
#define CK10_REG_JOG_START_SPEED_MIN 1u
#define CK10_REG_JOG_START_SPEED_MAX 35000u
#define CK10_REG_JOG_START_SPEED_DEFAULT 1u

/**
 * The acceleration and deceleration time of jogging.
 * Printed as 吋動加減速時間.
 * Read and write. 2 words must be accessed in one request.
 * One count is 1 ms. Range: 1..9999.
 * Source: 2.6 L372; 3.4 L730
 */
#define CK10_REG_JOG_ACCELERATION_TIME_ADDRESS 0x1398u
#define CK10_REG_JOG_ACCELERATION_TIME_WORDS 2u
#define CK10_REG_JOG_ACCELERATION_TIME_NUMBER 8u
#define CK10_REG_JOG_ACCELERATION_TIME_MIN 1u
#define CK10_REG_JOG_ACCELERATION_TIME_MAX 9999u
#define CK10_REG_JOG_ACCELERATION_TIME_DEFAULT 100u

/**
 * The greatest position that a move may reach.
 * Printed as 軟體正極限.
 * Read and write. 2 words must be accessed in one request.
 * One count is 1 pulse. Range: -2147483648..2147483647.
 * Source: 2.6 L373; 3.4 L731
 */
#define CK10_REG_POSITIVE_SOFT_LIMIT_ADDRESS 0x139Au
#define CK10_REG_POSITIVE_SOFT_LIMIT_WORDS 2u
#define CK10_REG_POSITIVE_SOFT_LIMIT_NUMBER 9u
#define CK10_REG_POSITIVE_SOFT_LIMIT_MIN (-2147483647 - 1)
#define CK10_REG_POSITIVE_SOFT_LIMIT_MAX 2147483647
#define CK10_REG_POSITIVE_SOFT_LIMIT_DEFAULT 2147483647

/**
 * The least position that a move may reach.
 * Printed as 軟體負極限.
 * Read and write. 2 words must be accessed in one request.
 * One count is 1 pulse. Range: -2147483648..2147483647.
 * Source: 2.6 L374; 3.4 L732
 */
#define CK10_REG_NEGATIVE_SOFT_LIMIT_ADDRESS 0x139Cu
#define CK10_REG_NEGATIVE_SOFT_LIMIT_WORDS 2u
#define CK10_REG_NEGATIVE_SOFT_LIMIT_NUMBER 10u
#define CK10_REG_NEGATIVE_SOFT_LIMIT_MIN (-2147483647 - 1)
#define CK10_REG_NEGATIVE_SOFT_LIMIT_MAX 2147483647
#define CK10_REG_NEGATIVE_SOFT_LIMIT_DEFAULT (-2147483647 - 1)

/**
 * How the motor stops at a soft limit.
 * Printed as 軟體極限停止方法.
 * Read and write. 2 words must be accessed in one request.
 * Range: 0..2. See soft_limit_stop.
 * Source: 2.6 L380; 3.4 L735
 */
#define CK10_REG_SOFT_LIMIT_STOP_ADDRESS 0x139Eu
#define CK10_REG_SOFT_LIMIT_STOP_WORDS 2u
#define CK10_REG_SOFT_LIMIT_STOP_NUMBER 11u
#define CK10_REG_SOFT_LIMIT_STOP_MIN 0u
#define CK10_REG_SOFT_LIMIT_STOP_MAX 2u
#define CK10_REG_SOFT_LIMIT_STOP_DEFAULT 2u

/**
 * How the motor stops at a limit sensor.
 * Printed as 硬體極限停止方法.
 * Read and write. 2 words must be accessed in one request.
 * Range: 0..1. See hard_limit_stop.
 * Source: 2.6 L381; 3.4 L736
 */
#define CK10_REG_HARD_LIMIT_STOP_ADDRESS 0x13A0u
#define CK10_REG_HARD_LIMIT_STOP_WORDS 2u
#define CK10_REG_HARD_LIMIT_STOP_NUMBER 12u
#define CK10_REG_HARD_LIMIT_STOP_MIN 0u
#define CK10_REG_HARD_LIMIT_STOP_MAX 1u
#define CK10_REG_HARD_LIMIT_STOP_DEFAULT 0u

/**
 * Printed as 保留.
 * Read and write. 2 words must be accessed in one request.
 * Range: 0..1.
 * Source: 2.6 L382; 3.4 L737
 */
#define CK10_REG_RESERVED_13_ADDRESS 0x13A2u
#define CK10_REG_RESERVED_13_WORDS 2u
#define CK10_REG_RESERVED_13_NUMBER 13u
#define CK10_REG_RESERVED_13_MIN 0u
#define CK10_REG_RESERVED_13_MAX 1u
#define CK10_REG_RESERVED_13_DEFAULT 0u

/**
 * The speed until the origin is found.
 * Printed as 原點速度.
 * Read and write. 2 words must be accessed in one request.
 * One count is 1 pps. Range: 1..800000.
 * Source: 2.6 L383; 3.4 L738
 */
#define CK10_REG_HOMING_SPEED_ADDRESS 0x13A4u
#define CK10_REG_HOMING_SPEED_WORDS 2u
#define CK10_REG_HOMING_SPEED_NUMBER 14u
#define CK10_REG_HOMING_SPEED_MIN 1u
#define CK10_REG_HOMING_SPEED_MAX 800000u
#define CK10_REG_HOMING_SPEED_DEFAULT 5000u

/**
 * The speed back to the origin once it is found.
 * Printed as 原點搜尋速度.
 * Read and write. 2 words must be accessed in one request.
 * One count is 1 pps. Range: 1..80000.
 * Note: Its greatest value is a tenth of that of the other speeds.
 * Source: 2.6 L384; 3.4 L739
 */
#define CK10_REG_HOMING_SEARCH_SPEED_ADDRESS 0x13A6u
#define CK10_REG_HOMING_SEARCH_SPEED_WORDS 2u
#define CK10_REG_HOMING_SEARCH_SPEED_NUMBER 15u
#define CK10_REG_HOMING_SEARCH_SPEED_MIN 1u
#define CK10_REG_HOMING_SEARCH_SPEED_MAX 80000u
#define CK10_REG_HOMING_SEARCH_SPEED_DEFAULT 1000u

/**
 * The acceleration and deceleration time of homing.
 * Printed as 原點加減速時間.
 * Read and write. 2 words must be accessed in one request.
 * One count is 1 ms. Range: 1..9999.
 * Source: 2.6 L385; 3.4 L740
 */
#define CK10_REG_HOMING_ACCELERATION_TIME_ADDRESS 0x13A8u
#define CK10_REG_HOMING_ACCELERATION_TIME_WORDS 2u
#define CK10_REG_HOMING_ACCELERATION_TIME_NUMBER 16u
#define CK10_REG_HOMING_ACCELERATION_TIME_MIN 1u
#define CK10_REG_HOMING_ACCELERATION_TIME_MAX 9999u
#define CK10_REG_HOMING_ACCELERATION_TIME_DEFAULT 50u

/**
 * Printed as 原點方法.
 * Read and write. 2 words must be accessed in one request.
 * Range: 0..7. See homing_method.
 * Note: The limits and the default stand on the row of method 3 in the text of the manual.
 * Source: 2.6 L386; 3.4 L741, 745
 */
#define CK10_REG_HOMING_METHOD_ADDRESS 0x13AAu
#define CK10_REG_HOMING_METHOD_WORDS 2u
#define CK10_REG_HOMING_METHOD_NUMBER 17u
#define CK10_REG_HOMING_METHOD_MIN 0u
#define CK10_REG_HOMING_METHOD_MAX 7u
#define CK10_REG_HOMING_METHOD_DEFAULT 0u

/**
 * Printed as 原點方向.
 * Read and write. 2 words must be accessed in one request.
 * Range: 0..1. See rotation.
 * Note: 0 is clockwise here; in the jog direction 07DEh, 0 is counterclockwise.
 * Source: 2.6 L387; 3.4 L751
 */
#define CK10_REG_HOMING_DIRECTION_ADDRESS 0x13ACu
#define CK10_REG_HOMING_DIRECTION_WORDS 2u
#define CK10_REG_HOMING_DIRECTION_NUMBER 18u
#define CK10_REG_HOMING_DIRECTION_MIN 0u
#define CK10_REG_HOMING_DIRECTION_MAX 1u
#define CK10_REG_HOMING_DIRECTION_DEFAULT 0u

/**
 * How far the motor moves on from the origin before the position is set.
 * Printed as 原點偏位.
 * Read and write. 2 words must be accessed in one request.
 * One count is 1 pulse. Range: -2147483648..2147483647.
 * Source: 2.6 L388; 3.4 L752
 */
#define CK10_REG_HOMING_OFFSET_ADDRESS 0x13AEu
#define CK10_REG_HOMING_OFFSET_WORDS 2u
#define CK10_REG_HOMING_OFFSET_NUMBER 19u
#define CK10_REG_HOMING_OFFSET_MIN (-2147483647 - 1)
#define CK10_REG_HOMING_OFFSET_MAX 2147483647
#define CK10_REG_HOMING_OFFSET_DEFAULT 0

/**
 * The value that the commanded and the actual position get at the origin.
 * Printed as 設為原點.
 * Read and write. 2 words must be accessed in one request.
 * One count is 1 pulse. Range: -2147483648..2147483647.
 * Source: 2.6 L389; 3.4 L753
 */
#define CK10_REG_ORIGIN_POSITION_ADDRESS 0x13B0u
#define CK10_REG_ORIGIN_POSITION_WORDS 2u
#define CK10_REG_ORIGIN_POSITION_NUMBER 20u
#define CK10_REG_ORIGIN_POSITION_MIN (-2147483647 - 1)
#define CK10_REG_ORIGIN_POSITION_MAX 2147483647
#define CK10_REG_ORIGIN_POSITION_DEFAULT 0

/**
 * Printed as 保留.
 * Read and write. 2 words must be accessed in one request.
 * Range: 0..1.
 * Source: 2.6 L390; 3.4 L756
 */
#define CK10_REG_RESERVED_21_ADDRESS 0x13B2u
#define CK10_REG_RESERVED_21_WORDS 2u
#define CK10_REG_RESERVED_21_NUMBER 21u
#define CK10_REG_RESERVED_21_MIN 0u
#define CK10_REG_RESERVED_21_MAX 1u
#define CK10_REG_RESERVED_21_DEFAULT 0u

/**
 * How the motor answers to its load when it stops: a relative value, not the gain of the drive. Which
 * constants it stands for is in the table of gains.
 * Printed as 位置迴路增益.
 * Read and write. 2 words must be accessed in one request.
 * Range: 0..63.
 * Note: Small values stop fast and are sensitive, great ones slow and insensitive. Start with 0, go up until
 * the motor is steady, then change it by one or two steps.
 * Source: 2.6 L391; 3.4 L757
 */
#define CK10_REG_POSITION_LOOP_GAIN_ADDRESS 0x13B4u
#define CK10_REG_POSITION_LOOP_GAIN_WORDS 2u
#define CK10_REG_POSITION_LOOP_GAIN_NUMBER 22u
#define CK10_REG_POSITION_LOOP_GAIN_MIN 0u
#define CK10_REG_POSITION_LOOP_GAIN_MAX 63u
#define CK10_REG_POSITION_LOOP_GAIN_DEFAULT 4u

/**
 * The position error up to which the motor counts as in position after a move. 0 to 63 choose the fast answer,
 * 64 to 127 the exact one; both stand for an error of 0 to 63.
 * Printed as 定位值.
 * Read and write. 2 words must be accessed in one request.
 * Range: 0..127.
 * Source: 2.6 L392; 3.4 L793
 */
#define CK10_REG_IN_POSITION_RANGE_ADDRESS 0x13B6u
#define CK10_REG_IN_POSITION_RANGE_WORDS 2u
#define CK10_REG_IN_POSITION_RANGE_NUMBER 23u
#define CK10_REG_IN_POSITION_RANGE_MIN 0u
#define CK10_REG_IN_POSITION_RANGE_MAX 127u
#define CK10_REG_IN_POSITION_RANGE_DEFAULT 0u

/**
 * A greater position error while moving gives an alarm and switches the motor off.
 * Printed as 位置追蹤限制.
 * Read and write. 2 words must be accessed in one request.
 * One count is 1 pulse. Range: 1..134217727.
 * Source: 2.6 L393; 3.4 L795
 */
#define CK10_REG_TRACKING_LIMIT_ADDRESS 0x13B8u
#define CK10_REG_TRACKING_LIMIT_WORDS 2u
#define CK10_REG_TRACKING_LIMIT_NUMBER 24u
#define CK10_REG_TRACKING_LIMIT_MIN 1u
#define CK10_REG_TRACKING_LIMIT_MAX 134217727u
#define CK10_REG_TRACKING_LIMIT_DEFAULT 2500u

/**
 * Which way the motor turns on a move.
 * Printed as 馬達方向.
 * Read and write. 2 words must be accessed in one request.
 * Range: 0..1. See rotation.
 * Note: 0 is clockwise here; in the jog direction 07DEh, 0 is counterclockwise.
 * Source: 2.6 L394; 3.4 L796
 */
#define CK10_REG_MOTOR_DIRECTION_ADDRESS 0x13BAu
#define CK10_REG_MOTOR_DIRECTION_WORDS 2u
#define CK10_REG_MOTOR_DIRECTION_NUMBER 25u
#define CK10_REG_MOTOR_DIRECTION_MIN 0u
#define CK10_REG_MOTOR_DIRECTION_MAX 1u
#define CK10_REG_MOTOR_DIRECTION_DEFAULT 0u

/**
 * Printed as 保留.
 * Read and write. 2 words must be accessed in one request.
 * Range: 0..1.
 * Source: 2.6 L395; 3.4 L797
 */
#define CK10_REG_RESERVED_26_ADDRESS 0x13BCu
#define CK10_REG_RESERVED_26_WORDS 2u
#define CK10_REG_RESERVED_26_NUMBER 26u
#define CK10_REG_RESERVED_26_MIN 0u
#define CK10_REG_RESERVED_26_MAX 1u
#define CK10_REG_RESERVED_26_DEFAULT 0u

/**
 * The torque at which the motor stops when homing against a stop.
 * Printed as 原點扭力比.
 * Read and write. 2 words must be accessed in one request.
 * One count is 1 %. Range: 20..90.
 * Source: 2.6 L396; 3.4 L798
 */
#define CK10_REG_HOMING_TORQUE_RATIO_ADDRESS 0x13BEu
#define CK10_REG_HOMING_TORQUE_RATIO_WORDS 2u
#define CK10_REG_HOMING_TORQUE_RATIO_NUMBER 27u
#define CK10_REG_HOMING_TORQUE_RATIO_MIN 20u
#define CK10_REG_HOMING_TORQUE_RATIO_MAX 90u
#define CK10_REG_HOMING_TORQUE_RATIO_DEFAULT 50u

/**
 * A greater position error at rest, with the servo on, gives an alarm and switches the motor off.
 * Printed as 位置錯誤溢出限制.
 * Read and write. 2 words must be accessed in one request.
 * One count is 1 pulse. Range: 1..134217727.
 * Source: 2.6 L397; 3.4 L799
 */
#define CK10_REG_POSITION_OVERFLOW_LIMIT_ADDRESS 0x13C0u
#define CK10_REG_POSITION_OVERFLOW_LIMIT_WORDS 2u
#define CK10_REG_POSITION_OVERFLOW_LIMIT_NUMBER 28u
#define CK10_REG_POSITION_OVERFLOW_LIMIT_MIN 1u
#define CK10_REG_POSITION_OVERFLOW_LIMIT_MAX 134217727u
#define CK10_REG_POSITION_OVERFLOW_LIMIT_DEFAULT 2500u

/**
 * Printed as 保留.
 * Read and write. 2 words must be accessed in one request.
 * One count is 1 ms. Range: 10..5000.
 * Source: 2.6 L398; 3.4 L800
 */
#define CK10_REG_RESERVED_29_ADDRESS 0x13C2u
#define CK10_REG_RESERVED_29_WORDS 2u
#define CK10_REG_RESERVED_29_NUMBER 29u
#define CK10_REG_RESERVED_29_MIN 10u
#define CK10_REG_RESERVED_29_MAX 5000u
#define CK10_REG_RESERVED_29_DEFAULT 200u

/**
 * The current while moving, as a share of the motor's rated one.
 * Printed as 運行電流.
 * Read and write. 2 words must be accessed in one request.
 * One count is 10 %. Range: 5..15.
 * Note: A greater current heats the motor more. The controller gives at most 4.8 A.
 * Source: 2.6 L399; 3.4 L801
 */
#define CK10_REG_RUN_CURRENT_ADDRESS 0x13C4u
#define CK10_REG_RUN_CURRENT_WORDS 2u
#define CK10_REG_RUN_CURRENT_NUMBER 30u
#define CK10_REG_RUN_CURRENT_MIN 5u
#define CK10_REG_RUN_CURRENT_MAX 15u
#define CK10_REG_RUN_CURRENT_DEFAULT 10u
#define CK10_REG_RUN_CURRENT_SCALE_NUMERATOR INT64_C(10)
#define CK10_REG_RUN_CURRENT_SCALE_DENOMINATOR INT64_C(1)

/**
 * A current that is added while accelerating, for acceleration times that would else be too short.
 * Printed as 起動電流.
 * Read and write. 2 words must be accessed in one request.
 * One count is 50 %. Range: 0..7.
 * Note: A greater current heats the motor more. The controller gives at most 4.8 A. Example of the manual: a
 * motor of 0.67 A, run current 10, boost current 1: 0.67 A + 50 % of 0.67 A is about 1.00 A.
 * Source: 2.6 L400; 3.4 L804
 */
#define CK10_REG_BOOST_CURRENT_ADDRESS 0x13C6u
#define CK10_REG_BOOST_CURRENT_WORDS 2u
#define CK10_REG_BOOST_CURRENT_NUMBER 31u
#define CK10_REG_BOOST_CURRENT_MIN 0u
#define CK10_REG_BOOST_CURRENT_MAX 7u
#define CK10_REG_BOOST_CURRENT_DEFAULT 0u
#define CK10_REG_BOOST_CURRENT_SCALE_NUMERATOR INT64_C(50)
#define CK10_REG_BOOST_CURRENT_SCALE_DENOMINATOR INT64_C(1)

/**
 * The current from 0.1 s after the motor has stopped.
 * Printed as 停止電流.
 * Read and write. 2 words must be accessed in one request.
 * One count is 10 %. Range: 2..10.
 * Note: A greater current heats the motor more.
 * Source: 2.6 L401; 3.4 L805
 */
#define CK10_REG_STOP_CURRENT_ADDRESS 0x13C8u
#define CK10_REG_STOP_CURRENT_WORDS 2u
#define CK10_REG_STOP_CURRENT_NUMBER 32u
#define CK10_REG_STOP_CURRENT_MIN 2u
#define CK10_REG_STOP_CURRENT_MAX 10u
#define CK10_REG_STOP_CURRENT_DEFAULT 5u
#define CK10_REG_STOP_CURRENT_SCALE_NUMERATOR INT64_C(10)
#define CK10_REG_STOP_CURRENT_SCALE_DENOMINATOR INT64_C(1)

/**
 * What the emergency stop input does.
 * Printed as 緊急停止模式.
 * Read and write. 2 words must be accessed in one request.
 * Range: 0..4. See emergency_stop_mode.
 * Source: 2.6 L402; 3.4 L806
 */
#define CK10_REG_EMERGENCY_STOP_MODE_ADDRESS 0x13CAu
#define CK10_REG_EMERGENCY_STOP_MODE_WORDS 2u
#define CK10_REG_EMERGENCY_STOP_MODE_NUMBER 33u
#define CK10_REG_EMERGENCY_STOP_MODE_MIN 0u
#define CK10_REG_EMERGENCY_STOP_MODE_MAX 4u
#define CK10_REG_EMERGENCY_STOP_MODE_DEFAULT 0u

/**
 * What the brake does in the emergency stop.
 * Printed as 緊急剎車模式.
 * Read and write. 2 words must be accessed in one request.
 * Range: 0..1. See emergency_brake_mode.
 * Source: 2.6 L403; 3.4 L807
 */
#define CK10_REG_EMERGENCY_BRAKE_MODE_ADDRESS 0x13CCu
#define CK10_REG_EMERGENCY_BRAKE_MODE_WORDS 2u
#define CK10_REG_EMERGENCY_BRAKE_MODE_NUMBER 34u
#define CK10_REG_EMERGENCY_BRAKE_MODE_MIN 0u
#define CK10_REG_EMERGENCY_BRAKE_MODE_MAX 1u
#define CK10_REG_EMERGENCY_BRAKE_MODE_DEFAULT 0u

/**
 * How the controller gets its commands.
 * Printed as 操作模式.
 * Read and write. A change takes effect after a restart. 2 words must be accessed in one request.
 * Range: 0..5. See operation_mode.
 * Note: Modbus needs 4 or 5; the controller is delivered with 3.
 * Source: 2.6 L404; 3.4 L808
 */
#define CK10_REG_OPERATION_MODE_ADDRESS 0x13CEu
#define CK10_REG_OPERATION_MODE_WORDS 2u
#define CK10_REG_OPERATION_MODE_NUMBER 35u
#define CK10_REG_OPERATION_MODE_MIN 0u
#define CK10_REG_OPERATION_MODE_MAX 5u
#define CK10_REG_OPERATION_MODE_DEFAULT 3u

/**
 * What the switch SW3 of the controller does.
 * Printed as 切換開關功能.
 * Read and write. 2 words must be accessed in one request.
 * Range: 0..1. See switch_function.
 * Source: 2.6 L405; 3.4 L809
 */
#define CK10_REG_SWITCH_FUNCTION_ADDRESS 0x13D0u
#define CK10_REG_SWITCH_FUNCTION_WORDS 2u
#define CK10_REG_SWITCH_FUNCTION_NUMBER 36u
#define CK10_REG_SWITCH_FUNCTION_MIN 0u
#define CK10_REG_SWITCH_FUNCTION_MAX 1u
#define CK10_REG_SWITCH_FUNCTION_DEFAULT 0u

/**
 * The speed of the line.
 * Printed as 鮑率.
 * Read and write. A change takes effect after a restart. 2 words must be accessed in one request.
 * Range: 0..4. See baud_rate.
 * Source: 2.6 L406; 3.4 L810
 */
#define CK10_REG_BAUD_RATE_ADDRESS 0x13D2u
#define CK10_REG_BAUD_RATE_WORDS 2u
#define CK10_REG_BAUD_RATE_NUMBER 37u
#define CK10_REG_BAUD_RATE_MIN 0u
#define CK10_REG_BAUD_RATE_MAX 4u
#define CK10_REG_BAUD_RATE_DEFAULT 4u

/**
 * Whether the position and the point table are kept when the power goes.
 * Printed as 儲存位置 / 位置表.
 * Read and write. 2 words must be accessed in one request.
 * Range: 0..1. See enabled.
 * Note: The position that is kept may not be the actual one.
 * Note: The title in 3.4 has the number of the point table, the sentence below it the point table itself.
 * Source: 2.6 L407; 3.4 L811
 */
#define CK10_REG_SAVE_POSITION_ADDRESS 0x13D4u
#define CK10_REG_SAVE_POSITION_WORDS 2u
#define CK10_REG_SAVE_POSITION_NUMBER 38u
#define CK10_REG_SAVE_POSITION_MIN 0u
#define CK10_REG_SAVE_POSITION_MAX 1u
#define CK10_REG_SAVE_POSITION_DEFAULT 1u

/**
 * Whether the LED blinks the number of the motor, which makes the start some seconds longer.
 * Printed as 顯示馬達編號.
 * Read and write. 2 words must be accessed in one request.
 * Range: 0..1. See enabled.
 * Source: 2.6 L408; 3.4 L812
 */
#define CK10_REG_SHOW_MOTOR_NUMBER_ADDRESS 0x13D6u
#define CK10_REG_SHOW_MOTOR_NUMBER_WORDS 2u
#define CK10_REG_SHOW_MOTOR_NUMBER_NUMBER 39u
#define CK10_REG_SHOW_MOTOR_NUMBER_MIN 0u
#define CK10_REG_SHOW_MOTOR_NUMBER_MAX 1u
#define CK10_REG_SHOW_MOTOR_NUMBER_DEFAULT 0u

/**
 * The manual calls it reserved.
 * Printed as IO 指派 旗標.
 * Read and write. 2 words must be accessed in one request.
 * Source: 2.6 L410
 */
#define CK10_REG_ASSIGNMENT_FLAGS_ADDRESS 0x13D8u
#define CK10_REG_ASSIGNMENT_FLAGS_WORDS 2u

/**
 * What input 1 is for.
 * Printed as IO 指派 IN1.
 * Read and write. 2 words must be accessed in one request.
 * See input_function.
 * Source: 2.6 L411
 */
#define CK10_REG_INPUT_1_FUNCTION_ADDRESS 0x13DAu
#define CK10_REG_INPUT_1_FUNCTION_WORDS 2u

/**
 * What input 2 is for.
 * Printed as IO 指派 IN2.
 * Read and write. 2 words must be accessed in one request.
 * See input_function.
 * Source: 2.6 L412
 */
#define CK10_REG_INPUT_2_FUNCTION_ADDRESS 0x13DCu
#define CK10_REG_INPUT_2_FUNCTION_WORDS 2u

/**
 * What input 3 is for.
 * Printed as IO 指派 IN3.
 * Read and write. 2 words must be accessed in one request.
 * See input_function.
 * Source: 2.6 L413
 */
#define CK10_REG_INPUT_3_FUNCTION_ADDRESS 0x13DEu
#define CK10_REG_INPUT_3_FUNCTION_WORDS 2u

/**
 * What input 4 is for.
 * Printed as IO 指派 IN4.
 * Read and write. 2 words must be accessed in one request.
 * See input_function.
 * Source: 2.6 L419
 */
#define CK10_REG_INPUT_4_FUNCTION_ADDRESS 0x13E0u
#define CK10_REG_INPUT_4_FUNCTION_WORDS 2u

/**
 * What input 5 is for.
 * Printed as IO 指派 IN5.
 * Read and write. 2 words must be accessed in one request.
 * See input_function.
 * Source: 2.6 L420
 */
#define CK10_REG_INPUT_5_FUNCTION_ADDRESS 0x13E2u
#define CK10_REG_INPUT_5_FUNCTION_WORDS 2u

/**
 * What input 6 is for.
 * Printed as IO 指派 IN6.
 * Read and write. 2 words must be accessed in one request.
 * See input_function.
 * Source: 2.6 L421
 */
#define CK10_REG_INPUT_6_FUNCTION_ADDRESS 0x13E4u
#define CK10_REG_INPUT_6_FUNCTION_WORDS 2u

/**
 * What input 7 is for.
 * Printed as IO 指派 IN7.
 * Read and write. 2 words must be accessed in one request.
 * See input_function.
 * Source: 2.6 L422
 */
#define CK10_REG_INPUT_7_FUNCTION_ADDRESS 0x13E6u
#define CK10_REG_INPUT_7_FUNCTION_WORDS 2u

/**
 * What input 8 is for.
 * Printed as IO 指派 IN8.
 * Read and write. 2 words must be accessed in one request.
 * See input_function.
 * Source: 2.6 L423
 */
#define CK10_REG_INPUT_8_FUNCTION_ADDRESS 0x13E8u
#define CK10_REG_INPUT_8_FUNCTION_WORDS 2u

/**
 * What input 9 is for.
 * Printed as IO 指派 IN9.
 * Read and write. 2 words must be accessed in one request.
 * See input_function.
 * Source: 2.6 L424
 */
#define CK10_REG_INPUT_9_FUNCTION_ADDRESS 0x13EAu
#define CK10_REG_INPUT_9_FUNCTION_WORDS 2u

/**
 * What input 10 is for.
 * Printed as IO 指派 IN10.
 * Read and write. 2 words must be accessed in one request.
 * See input_function.
 * Source: 2.6 L425
 */
#define CK10_REG_INPUT_10_FUNCTION_ADDRESS 0x13ECu
#define CK10_REG_INPUT_10_FUNCTION_WORDS 2u

/**
 * What input 11 is for.
 * Printed as IO 指派 IN11.
 * Read and write. 2 words must be accessed in one request.
 * See input_function.
 * Source: 2.6 L426
 */
#define CK10_REG_INPUT_11_FUNCTION_ADDRESS 0x13EEu
#define CK10_REG_INPUT_11_FUNCTION_WORDS 2u

/**
 * What input 12 is for.
 * Printed as IO 指派 IN12.
 * Read and write. 2 words must be accessed in one request.
 * See input_function.
 * Source: 2.6 L427
 */
#define CK10_REG_INPUT_12_FUNCTION_ADDRESS 0x13F0u
#define CK10_REG_INPUT_12_FUNCTION_WORDS 2u

/**
 * What output 1 is for.
 * Printed as IO 指派 OUT1.
 * Read and write. 2 words must be accessed in one request.
 * See output_function.
 * Source: 2.6 L428
 */
#define CK10_REG_OUTPUT_1_FUNCTION_ADDRESS 0x13F2u
#define CK10_REG_OUTPUT_1_FUNCTION_WORDS 2u

/**
 * What output 2 is for.
 * Printed as IO 指派 OUT2.
 * Read and write. 2 words must be accessed in one request.
 * See output_function.
 * Source: 2.6 L429
 */
#define CK10_REG_OUTPUT_2_FUNCTION_ADDRESS 0x13F4u
#define CK10_REG_OUTPUT_2_FUNCTION_WORDS 2u

/**
 * What output 3 is for.
 * Printed as IO 指派 OUT3.
 * Read and write. 2 words must be accessed in one request.
 * See output_function.
 * Source: 2.6 L430
 */
#define CK10_REG_OUTPUT_3_FUNCTION_ADDRESS 0x13F6u
#define CK10_REG_OUTPUT_3_FUNCTION_WORDS 2u

/**
 * What output 4 is for.
 * Printed as IO 指派 OUT4.
 * Read and write. 2 words must be accessed in one request.
 * See output_function.
 * Source: 2.6 L431
 */
#define CK10_REG_OUTPUT_4_FUNCTION_ADDRESS 0x13F8u
#define CK10_REG_OUTPUT_4_FUNCTION_WORDS 2u

/**
 * What output 5 is for.
 * Printed as IO 指派 OUT5.
 * Read and write. 2 words must be accessed in one request.
 * See output_function.
 * Source: 2.6 L432
 */
#define CK10_REG_OUTPUT_5_FUNCTION_ADDRESS 0x13FAu
#define CK10_REG_OUTPUT_5_FUNCTION_WORDS 2u

/**
 * What output 6 is for.
 * Printed as IO 指派 OUT6.
 * Read and write. 2 words must be accessed in one request.
 * See output_function.
 * Source: 2.6 L433
 */
#define CK10_REG_OUTPUT_6_FUNCTION_ADDRESS 0x13FCu
#define CK10_REG_OUTPUT_6_FUNCTION_WORDS 2u

/**
 * What output 7 is for.
 * Printed as IO 指派 OUT7.
 * Read and write. 2 words must be accessed in one request.
 * See output_function.
 * Source: 2.6 L434
 */
#define CK10_REG_OUTPUT_7_FUNCTION_ADDRESS 0x13FEu
#define CK10_REG_OUTPUT_7_FUNCTION_WORDS 2u

/**
 * What output 8 is for.
 * Printed as IO 指派 OUT8.
 * Read and write. 2 words must be accessed in one request.
 * See output_function.
 * Source: 2.6 L435
 */
#define CK10_REG_OUTPUT_8_FUNCTION_ADDRESS 0x1400u
#define CK10_REG_OUTPUT_8_FUNCTION_WORDS 2u

/**
 * What output 9 is for.
 * Printed as IO 指派 OUT9.
 * Read and write. 2 words must be accessed in one request.
 * See output_function.
 * Source: 2.6 L436
 */
#define CK10_REG_OUTPUT_9_FUNCTION_ADDRESS 0x1402u
#define CK10_REG_OUTPUT_9_FUNCTION_WORDS 2u

/**
 * What output 10 is for.
 * Printed as IO 指派 OUT10.
 * Read and write. 2 words must be accessed in one request.
 * See output_function.
 * Source: 2.6 L437
 */
#define CK10_REG_OUTPUT_10_FUNCTION_ADDRESS 0x1404u
#define CK10_REG_OUTPUT_10_FUNCTION_WORDS 2u

/**
 * Whether input 1 is 1 when it is on or when it is off.
 * Printed as IO 極性 IN1.
 * Read and write. 2 words must be accessed in one request.
 * See polarity.
 * Source: 2.6 L438
 */
#define CK10_REG_INPUT_1_POLARITY_ADDRESS 0x1406u
#define CK10_REG_INPUT_1_POLARITY_WORDS 2u

/**
 * Whether input 2 is 1 when it is on or when it is off.
 * Printed as IO 極性 IN2.
 * Read and write. 2 words must be accessed in one request.
 * See polarity.
 * Source: 2.6 L439
 */
#define CK10_REG_INPUT_2_POLARITY_ADDRESS 0x1408u
#define CK10_REG_INPUT_2_POLARITY_WORDS 2u

/**
 * Whether input 3 is 1 when it is on or when it is off.
 * Printed as IO 極性 IN3.
 * Read and write. 2 words must be accessed in one request.
 * See polarity.
 * Source: 2.6 L440
 */
#define CK10_REG_INPUT_3_POLARITY_ADDRESS 0x140Au
#define CK10_REG_INPUT_3_POLARITY_WORDS 2u

/**
 * Whether input 4 is 1 when it is on or when it is off.
 * Printed as IO 極性 IN4.
 * Read and write. 2 words must be accessed in one request.
 * See polarity.
 * Source: 2.6 L441
 */
#define CK10_REG_INPUT_4_POLARITY_ADDRESS 0x140Cu
#define CK10_REG_INPUT_4_POLARITY_WORDS 2u

/**
 * Whether input 5 is 1 when it is on or when it is off.
 * Printed as IO 極性 IN5.
 * Read and write. 2 words must be accessed in one request.
 * See polarity.
 * Source: 2.6 L442
 */
#define CK10_REG_INPUT_5_POLARITY_ADDRESS 0x140Eu
#define CK10_REG_INPUT_5_POLARITY_WORDS 2u

/**
 * Whether input 6 is 1 when it is on or when it is off.
 * Printed as IO 極性 IN6.
 * Read and write. 2 words must be accessed in one request.
 * See polarity.
 * Source: 2.6 L443
 */
#define CK10_REG_INPUT_6_POLARITY_ADDRESS 0x1410u
#define CK10_REG_INPUT_6_POLARITY_WORDS 2u

/**
 * Whether input 7 is 1 when it is on or when it is off.
 * Printed as IO 極性 IN7.
 * Read and write. 2 words must be accessed in one request.
 * See polarity.
 * Source: 2.6 L444
 */
#define CK10_REG_INPUT_7_POLARITY_ADDRESS 0x1412u
#define CK10_REG_INPUT_7_POLARITY_WORDS 2u

/**
 * Whether input 8 is 1 when it is on or when it is off.
 * Printed as IO 極性 IN8.
 * Read and write. 2 words must be accessed in one request.
 * See polarity.
 * Source: 2.6 L445
 */
#define CK10_REG_INPUT_8_POLARITY_ADDRESS 0x1414u
#define CK10_REG_INPUT_8_POLARITY_WORDS 2u

/**
 * Whether input 9 is 1 when it is on or when it is off.
 * Printed as IO 極性 IN9.
 * Read and write. 2 words must be accessed in one request.
 * See polarity.
 * Source: 2.6 L446
 */
#define CK10_REG_INPUT_9_POLARITY_ADDRESS 0x1416u
#define CK10_REG_INPUT_9_POLARITY_WORDS 2u

/**
 * Whether input 10 is 1 when it is on or when it is off.
 * Printed as IO 極性 IN10.
 * Read and write. 2 words must be accessed in one request.
 * See polarity.
 * Source: 2.6 L447
 */
#define CK10_REG_INPUT_10_POLARITY_ADDRESS 0x1418u
#define CK10_REG_INPUT_10_POLARITY_WORDS 2u

/**
 * Whether input 11 is 1 when it is on or when it is off.
 * Printed as IO 極性 IN11.
 * Read and write. 2 words must be accessed in one request.
 * See polarity.
 * Source: 2.6 L448
 */
#define CK10_REG_INPUT_11_POLARITY_ADDRESS 0x141Au
#define CK10_REG_INPUT_11_POLARITY_WORDS 2u

/**
 * Whether input 12 is 1 when it is on or when it is off.
 * Printed as IO 極性 IN12.
 * Read and write. 2 words must be accessed in one request.
 * See polarity.
 * Source: 2.6 L449
 */
#define CK10_REG_INPUT_12_POLARITY_ADDRESS 0x141Cu
#define CK10_REG_INPUT_12_POLARITY_WORDS 2u

/**
 * Whether output 1 is on when its signal is 1 or when it is 0.
 * Printed as IO 極性 OUT1.
 * Read and write. 2 words must be accessed in one request.
 * See polarity.
 * Source: 2.6 L455
 */
#define CK10_REG_OUTPUT_1_POLARITY_ADDRESS 0x141Eu
#define CK10_REG_OUTPUT_1_POLARITY_WORDS 2u

/**
 * Whether output 2 is on when its signal is 1 or when it is 0.
 * Printed as IO 極性 OUT2.
 * Read and write. 2 words must be accessed in one request.
 * See polarity.
 * Source: 2.6 L456
 */
#define CK10_REG_OUTPUT_2_POLARITY_ADDRESS 0x1420u
#define CK10_REG_OUTPUT_2_POLARITY_WORDS 2u

/**
 * Whether output 3 is on when its signal is 1 or when it is 0.
 * Printed as IO 極性 OUT3.
 * Read and write. 2 words must be accessed in one request.
 * See polarity.
 * Source: 2.6 L457
 */
#define CK10_REG_OUTPUT_3_POLARITY_ADDRESS 0x1422u
#define CK10_REG_OUTPUT_3_POLARITY_WORDS 2u

/**
 * Whether output 4 is on when its signal is 1 or when it is 0.
 * Printed as IO 極性 OUT4.
 * Read and write. 2 words must be accessed in one request.
 * See polarity.
 * Source: 2.6 L458
 */
#define CK10_REG_OUTPUT_4_POLARITY_ADDRESS 0x1424u
#define CK10_REG_OUTPUT_4_POLARITY_WORDS 2u

/**
 * Whether output 5 is on when its signal is 1 or when it is 0.
 * Printed as IO 極性 OUT5.
 * Read and write. 2 words must be accessed in one request.
 * See polarity.
 * Source: 2.6 L459
 */
#define CK10_REG_OUTPUT_5_POLARITY_ADDRESS 0x1426u
#define CK10_REG_OUTPUT_5_POLARITY_WORDS 2u

/**
 * Whether output 6 is on when its signal is 1 or when it is 0.
 * Printed as IO 極性 OUT6.
 * Read and write. 2 words must be accessed in one request.
 * See polarity.
 * Source: 2.6 L460
 */
#define CK10_REG_OUTPUT_6_POLARITY_ADDRESS 0x1428u
#define CK10_REG_OUTPUT_6_POLARITY_WORDS 2u

/**
 * Whether output 7 is on when its signal is 1 or when it is 0.
 * Printed as IO 極性 OUT7.
 * Read and write. 2 words must be accessed in one request.
 * See polarity.
 * Source: 2.6 L461
 */
#define CK10_REG_OUTPUT_7_POLARITY_ADDRESS 0x142Au
#define CK10_REG_OUTPUT_7_POLARITY_WORDS 2u

/**
 * Whether output 8 is on when its signal is 1 or when it is 0.
 * Printed as IO 極性 OUT8.
 * Read and write. 2 words must be accessed in one request.
 * See polarity.
 * Source: 2.6 L462
 */
#define CK10_REG_OUTPUT_8_POLARITY_ADDRESS 0x142Cu
#define CK10_REG_OUTPUT_8_POLARITY_WORDS 2u

/**
 * Whether output 9 is on when its signal is 1 or when it is 0.
 * Printed as IO 極性 OUT9.
 * Read and write. 2 words must be accessed in one request.
 * See polarity.
 * Source: 2.6 L463
 */
#define CK10_REG_OUTPUT_9_POLARITY_ADDRESS 0x142Eu
#define CK10_REG_OUTPUT_9_POLARITY_WORDS 2u

/**
 * Whether output 10 is on when its signal is 1 or when it is 0.
 * Printed as IO 極性 OUT10.
 * Read and write. 2 words must be accessed in one request.
 * See polarity.
 * Source: 2.6 L464
 */
#define CK10_REG_OUTPUT_10_POLARITY_ADDRESS 0x1430u
#define CK10_REG_OUTPUT_10_POLARITY_WORDS 2u

/**
 * The pulses of one turn. Changing it switches the servo off.
 * Printed as 解析度.
 * Read only. 2 words must be accessed in one request. A copy of resolution.
 * One count is 1 pulse/rev. Range: 0..50000. See pulses_per_turn.
 * Source: 2.6 L472
 */
#define CK10_REG_FLASH_RESOLUTION_ADDRESS 0x1450u
#define CK10_REG_FLASH_RESOLUTION_WORDS 2u
#define CK10_REG_FLASH_RESOLUTION_MIN 0u
#define CK10_REG_FLASH_RESOLUTION_MAX 50000u
#define CK10_REG_FLASH_RESOLUTION_DEFAULT 0u

/**
 * The greatest speed of a move.
 * Printed as 軸最大速度.
 * Read only. 2 words must be accessed in one request. A copy of maximum_speed.
 * One count is 1 pps. Range: 1..800000.
 * Source: 2.6 L473
 */
#define CK10_REG_FLASH_MAXIMUM_SPEED_ADDRESS 0x1452u
#define CK10_REG_FLASH_MAXIMUM_SPEED_WORDS 2u
#define CK10_REG_FLASH_MAXIMUM_SPEED_MIN 1u
#define CK10_REG_FLASH_MAXIMUM_SPEED_MAX 800000u
#define CK10_REG_FLASH_MAXIMUM_SPEED_DEFAULT 500000u

/**
 * The speed at which a move starts.
 * Printed as 軸起始速度.
 * Read only. 2 words must be accessed in one request. A copy of start_speed.
 * One count is 1 pps. Range: 1..35000.
 * Source: 2.6 L474
 */
#define CK10_REG_FLASH_START_SPEED_ADDRESS 0x1454u
#define CK10_REG_FLASH_START_SPEED_WORDS 2u
#define CK10_REG_FLASH_START_SPEED_MIN 1u
#define CK10_REG_FLASH_START_SPEED_MAX 35000u
#define CK10_REG_FLASH_START_SPEED_DEFAULT 1u

/**
 * The acceleration time of a move.
 * Printed as 軸加速時間.
 * Read only. 2 words must be accessed in one request. A copy of acceleration_time.
 * One count is 1 ms. Range: 1..9999.
 * Source: 2.6 L475
 */
#define CK10_REG_FLASH_ACCELERATION_TIME_ADDRESS 0x1456u
#define CK10_REG_FLASH_ACCELERATION_TIME_WORDS 2u
#define CK10_REG_FLASH_ACCELERATION_TIME_MIN 1u
#define CK10_REG_FLASH_ACCELERATION_TIME_MAX 9999u
#define CK10_REG_FLASH_ACCELERATION_TIME_DEFAULT 100u

/**
 * The deceleration time of a move.
 * Printed as 軸減速時間.
 * Read only. 2 words must be accessed in one request. A copy of deceleration_time.
 * One count is 1 ms. Range: 1..9999.
 * Source: 2.6 L476
 */
#define CK10_REG_FLASH_DECELERATION_TIME_ADDRESS 0x1458u
#define CK10_REG_FLASH_DECELERATION_TIME_WORDS 2u
#define CK10_REG_FLASH_DECELERATION_TIME_MIN 1u
#define CK10_REG_FLASH_DECELERATION_TIME_MAX 9999u
#define CK10_REG_FLASH_DECELERATION_TIME_DEFAULT 100u

/**
 * Printed as 保留.
 * Read only. 2 words must be accessed in one request. A copy of reserved_5.
 * Range: 100.
 * Source: 2.6 L477
 */
#define CK10_REG_FLASH_RESERVED_5_ADDRESS 0x145Au
#define CK10_REG_FLASH_RESERVED_5_WORDS 2u
#define CK10_REG_FLASH_RESERVED_5_MIN 100u
#define CK10_REG_FLASH_RESERVED_5_MAX 100u
#define CK10_REG_FLASH_RESERVED_5_DEFAULT 100u

/**
 * The speed of jogging.
 * Printed as 吋動速度.
 * Read only. 2 words must be accessed in one request. A copy of jog_speed.
 * One count is 1 pps. Range: 1..800000.
 * Source: 2.6 L478
 */
#define CK10_REG_FLASH_JOG_SPEED_ADDRESS 0x145Cu
#define CK10_REG_FLASH_JOG_SPEED_WORDS 2u
#define CK10_REG_FLASH_JOG_SPEED_MIN 1u
#define CK10_REG_FLASH_JOG_SPEED_MAX 800000u
#define CK10_REG_FLASH_JOG_SPEED_DEFAULT 5000u

/**
 * The speed at which jogging starts.
 * Printed as 吋動起始速度.
 * Read only. 2 words must be accessed in one request. A copy of jog_start_speed.
 * One count is 1 pps. Range: 1..35000.
 * Source: 2.6 L479
 */
#define CK10_REG_FLASH_JOG_START_SPEED_ADDRESS 0x145Eu
#define CK10_REG_FLASH_JOG_START_SPEED_WORDS 2u
#define CK10_REG_FLASH_JOG_START_SPEED_MIN 1u
#define CK10_REG_FLASH_JOG_START_SPEED_MAX 35000u
#define CK10_REG_FLASH_JOG_START_SPEED_DEFAULT 1u

/**
 * The acceleration and deceleration time of jogging.
 * Printed as 吋動加減速時間.
 * Read only. 2 words must be accessed in one request. A copy of jog_acceleration_time.
 * One count is 1 ms. Range: 1..9999.
 * Source: 2.6 L480
 */
#define CK10_REG_FLASH_JOG_ACCELERATION_TIME_ADDRESS 0x1460u
#define CK10_REG_FLASH_JOG_ACCELERATION_TIME_WORDS 2u
#define CK10_REG_FLASH_JOG_ACCELERATION_TIME_MIN 1u
#define CK10_REG_FLASH_JOG_ACCELERATION_TIME_MAX 9999u
#define CK10_REG_FLASH_JOG_ACCELERATION_TIME_DEFAULT 100u

/**
 * The greatest position that a move may reach.
 * Printed as 軟體正極限.
 * Read only. 2 words must be accessed in one request. A copy of positive_soft_limit.
 * One count is 1 pulse. Range: -2147483648..2147483647.
 * Source: 2.6 L481
 */
#define CK10_REG_FLASH_POSITIVE_SOFT_LIMIT_ADDRESS 0x1462u
#define CK10_REG_FLASH_POSITIVE_SOFT_LIMIT_WORDS 2u
#define CK10_REG_FLASH_POSITIVE_SOFT_LIMIT_MIN (-2147483647 - 1)
#define CK10_REG_FLASH_POSITIVE_SOFT_LIMIT_MAX 2147483647
#define CK10_REG_FLASH_POSITIVE_SOFT_LIMIT_DEFAULT 2147483647

/**
 * The least position that a move may reach.
 * Printed as 軟體負極限.
 * Read only. 2 words must be accessed in one request. A copy of negative_soft_limit.
 * One count is 1 pulse. Range: -2147483648..2147483647.
 * Source: 2.6 L482
 */
#define CK10_REG_FLASH_NEGATIVE_SOFT_LIMIT_ADDRESS 0x1464u
#define CK10_REG_FLASH_NEGATIVE_SOFT_LIMIT_WORDS 2u
#define CK10_REG_FLASH_NEGATIVE_SOFT_LIMIT_MIN (-2147483647 - 1)
#define CK10_REG_FLASH_NEGATIVE_SOFT_LIMIT_MAX 2147483647
#define CK10_REG_FLASH_NEGATIVE_SOFT_LIMIT_DEFAULT (-2147483647 - 1)

/**
 * How the motor stops at a soft limit.
 * Printed as 軟體極限停止方法.
 * Read only. 2 words must be accessed in one request. A copy of soft_limit_stop.
 * Range: 0..2. See soft_limit_stop.
 * Source: 2.6 L483
 */
#define CK10_REG_FLASH_SOFT_LIMIT_STOP_ADDRESS 0x1466u
#define CK10_REG_FLASH_SOFT_LIMIT_STOP_WORDS 2u
#define CK10_REG_FLASH_SOFT_LIMIT_STOP_MIN 0u
#define CK10_REG_FLASH_SOFT_LIMIT_STOP_MAX 2u
#define CK10_REG_FLASH_SOFT_LIMIT_STOP_DEFAULT 2u

/**
 * How the motor stops at a limit sensor.
 * Printed as 硬體極限停止方法.
 * Read only. 2 words must be accessed in one request. A copy of hard_limit_stop.
 * Range: 0..1. See hard_limit_stop.
 * Source: 2.6 L484
 */
#define CK10_REG_FLASH_HARD_LIMIT_STOP_ADDRESS 0x1468u
#define CK10_REG_FLASH_HARD_LIMIT_STOP_WORDS 2u
#define CK10_REG_FLASH_HARD_LIMIT_STOP_MIN 0u
#define CK10_REG_FLASH_HARD_LIMIT_STOP_MAX 1u
#define CK10_REG_FLASH_HARD_LIMIT_STOP_DEFAULT 0u

/**
 * Printed as 保留.
 * Read only. 2 words must be accessed in one request. A copy of reserved_13.
 * Range: 0..1.
 * Source: 2.6 L485
 */
#define CK10_REG_FLASH_RESERVED_13_ADDRESS 0x146Au
#define CK10_REG_FLASH_RESERVED_13_WORDS 2u
#define CK10_REG_FLASH_RESERVED_13_MIN 0u
#define CK10_REG_FLASH_RESERVED_13_MAX 1u
#define CK10_REG_FLASH_RESERVED_13_DEFAULT 0u

/**
 * The speed until the origin is found.
 * Printed as 原點速度.
 * Read only. 2 words must be accessed in one request. A copy of homing_speed.
 * One count is 1 pps. Range: 1..800000.
 * Source: 2.6 L486
 */
#define CK10_REG_FLASH_HOMING_SPEED_ADDRESS 0x146Cu
#define CK10_REG_FLASH_HOMING_SPEED_WORDS 2u
#define CK10_REG_FLASH_HOMING_SPEED_MIN 1u
#define CK10_REG_FLASH_HOMING_SPEED_MAX 800000u
#define CK10_REG_FLASH_HOMING_SPEED_DEFAULT 5000u

/**
 * The speed back to the origin once it is found.
 * Printed as 原點搜尋速度.
 * Read only. 2 words must be accessed in one request. A copy of homing_search_speed.
 * One count is 1 pps. Range: 1..80000.
 * Source: 2.6 L487
 */
#define CK10_REG_FLASH_HOMING_SEARCH_SPEED_ADDRESS 0x146Eu
#define CK10_REG_FLASH_HOMING_SEARCH_SPEED_WORDS 2u
#define CK10_REG_FLASH_HOMING_SEARCH_SPEED_MIN 1u
#define CK10_REG_FLASH_HOMING_SEARCH_SPEED_MAX 80000u
#define CK10_REG_FLASH_HOMING_SEARCH_SPEED_DEFAULT 1000u

/**
 * The acceleration and deceleration time of homing.
 * Printed as 原點加減速時間.
 * Read only. 2 words must be accessed in one request. A copy of homing_acceleration_time.
 * One count is 1 ms. Range: 1..9999.
 * Source: 2.6 L488
 */
#define CK10_REG_FLASH_HOMING_ACCELERATION_TIME_ADDRESS 0x1470u
#define CK10_REG_FLASH_HOMING_ACCELERATION_TIME_WORDS 2u
#define CK10_REG_FLASH_HOMING_ACCELERATION_TIME_MIN 1u
#define CK10_REG_FLASH_HOMING_ACCELERATION_TIME_MAX 9999u
#define CK10_REG_FLASH_HOMING_ACCELERATION_TIME_DEFAULT 50u

/**
 * Printed as 原點方法.
 * Read only. 2 words must be accessed in one request. A copy of homing_method.
 * Range: 0..7. See homing_method.
 * Source: 2.6 L489
 */
#define CK10_REG_FLASH_HOMING_METHOD_ADDRESS 0x1472u
#define CK10_REG_FLASH_HOMING_METHOD_WORDS 2u
#define CK10_REG_FLASH_HOMING_METHOD_MIN 0u
#define CK10_REG_FLASH_HOMING_METHOD_MAX 7u
#define CK10_REG_FLASH_HOMING_METHOD_DEFAULT 0u

/**
 * Printed as 原點方向.
 * Read only. 2 words must be accessed in one request. A copy of homing_direction.
 * Range: 0..1. See rotation.
 * Source: 2.6 L490
 */
#define CK10_REG_FLASH_HOMING_DIRECTION_ADDRESS 0x1474u
#define CK10_REG_FLASH_HOMING_DIRECTION_WORDS 2u
#define CK10_REG_FLASH_HOMING_DIRECTION_MIN 0u
#define CK10_REG_FLASH_HOMING_DIRECTION_MAX 1u
#define CK10_REG_FLASH_HOMING_DIRECTION_DEFAULT 0u

/**
 * How far the motor moves on from the origin before the position is set.
 * Printed as 原點偏位.
 * Read only. 2 words must be accessed in one request. A copy of homing_offset.
 * One count is 1 pulse. Range: -2147483648..2147483647.
 * Source: 2.6 L491
 */
#define CK10_REG_FLASH_HOMING_OFFSET_ADDRESS 0x1476u
#define CK10_REG_FLASH_HOMING_OFFSET_WORDS 2u
#define CK10_REG_FLASH_HOMING_OFFSET_MIN (-2147483647 - 1)
#define CK10_REG_FLASH_HOMING_OFFSET_MAX 2147483647
#define CK10_REG_FLASH_HOMING_OFFSET_DEFAULT 0

/**
 * The value that the commanded and the actual position get at the origin.
 * Printed as 設為原點.
 * Read only. 2 words must be accessed in one request. A copy of origin_position.
 * One count is 1 pulse. Range: -2147483648..2147483647.
 * Source: 2.6 L492
 */
#define CK10_REG_FLASH_ORIGIN_POSITION_ADDRESS 0x1478u
#define CK10_REG_FLASH_ORIGIN_POSITION_WORDS 2u
#define CK10_REG_FLASH_ORIGIN_POSITION_MIN (-2147483647 - 1)
#define CK10_REG_FLASH_ORIGIN_POSITION_MAX 2147483647
#define CK10_REG_FLASH_ORIGIN_POSITION_DEFAULT 0

/**
 * Printed as 保留.
 * Read only. 2 words must be accessed in one request. A copy of reserved_21.
 * Range: 0..1.
 * Source: 2.6 L496
 */
#define CK10_REG_FLASH_RESERVED_21_ADDRESS 0x147Au
#define CK10_REG_FLASH_RESERVED_21_WORDS 2u
#define CK10_REG_FLASH_RESERVED_21_MIN 0u
#define CK10_REG_FLASH_RESERVED_21_MAX 1u
#define CK10_REG_FLASH_RESERVED_21_DEFAULT 0u

/**
 * How the motor answers to its load when it stops: a relative value, not the gain of the drive. Which
 * constants it stands for is in the table of gains.
 * Printed as 位置迴路增益.
 * Read only. 2 words must be accessed in one request. A copy of position_loop_gain.
 * Range: 0..63.
 * Source: 2.6 L497
 */
#define CK10_REG_FLASH_POSITION_LOOP_GAIN_ADDRESS 0x147Cu
#define CK10_REG_FLASH_POSITION_LOOP_GAIN_WORDS 2u
#define CK10_REG_FLASH_POSITION_LOOP_GAIN_MIN 0u
#define CK10_REG_FLASH_POSITION_LOOP_GAIN_MAX 63u
#define CK10_REG_FLASH_POSITION_LOOP_GAIN_DEFAULT 4u

/**
 * The position error up to which the motor counts as in position after a move. 0 to 63 choose the fast answer,
 * 64 to 127 the exact one; both stand for an error of 0 to 63.
 * Printed as 定位值.
 * Read only. 2 words must be accessed in one request. A copy of in_position_range.
 * Range: 0..127.
 * Source: 2.6 L498
 */
#define CK10_REG_FLASH_IN_POSITION_RANGE_ADDRESS 0x147Eu
#define CK10_REG_FLASH_IN_POSITION_RANGE_WORDS 2u
#define CK10_REG_FLASH_IN_POSITION_RANGE_MIN 0u
#define CK10_REG_FLASH_IN_POSITION_RANGE_MAX 127u
#define CK10_REG_FLASH_IN_POSITION_RANGE_DEFAULT 0u

/**
 * A greater position error while moving gives an alarm and switches the motor off.
 * Printed as 位置追蹤限制.
 * Read only. 2 words must be accessed in one request. A copy of tracking_limit.
 * One count is 1 pulse. Range: 1..134217727.
 * Source: 2.6 L499
 */
#define CK10_REG_FLASH_TRACKING_LIMIT_ADDRESS 0x1480u
#define CK10_REG_FLASH_TRACKING_LIMIT_WORDS 2u
#define CK10_REG_FLASH_TRACKING_LIMIT_MIN 1u
#define CK10_REG_FLASH_TRACKING_LIMIT_MAX 134217727u
#define CK10_REG_FLASH_TRACKING_LIMIT_DEFAULT 2500u

/**
 * Which way the motor turns on a move.
 * Printed as 馬達方向.
 * Read only. 2 words must be accessed in one request. A copy of motor_direction.
 * Range: 0..1. See rotation.
 * Source: 2.6 L500
 */
#define CK10_REG_FLASH_MOTOR_DIRECTION_ADDRESS 0x1482u
#define CK10_REG_FLASH_MOTOR_DIRECTION_WORDS 2u
#define CK10_REG_FLASH_MOTOR_DIRECTION_MIN 0u
#define CK10_REG_FLASH_MOTOR_DIRECTION_MAX 1u
#define CK10_REG_FLASH_MOTOR_DIRECTION_DEFAULT 0u

/**
 * Printed as 保留.
 * Read only. 2 words must be accessed in one request. A copy of reserved_26.
 * Range: 0..1.
 * Source: 2.6 L501
 */
#define CK10_REG_FLASH_RESERVED_26_ADDRESS 0x1484u
#define CK10_REG_FLASH_RESERVED_26_WORDS 2u
#define CK10_REG_FLASH_RESERVED_26_MIN 0u
#define CK10_REG_FLASH_RESERVED_26_MAX 1u
#define CK10_REG_FLASH_RESERVED_26_DEFAULT 0u

/**
 * The torque at which the motor stops when homing against a stop.
 * Printed as 原點扭力比.
 * Read only. 2 words must be accessed in one request. A copy of homing_torque_ratio.
 * One count is 1 %. Range: 20..90.
 * Source: 2.6 L502
 */
#define CK10_REG_FLASH_HOMING_TORQUE_RATIO_ADDRESS 0x1486u
#define CK10_REG_FLASH_HOMING_TORQUE_RATIO_WORDS 2u
#define CK10_REG_FLASH_HOMING_TORQUE_RATIO_MIN 20u
#define CK10_REG_FLASH_HOMING_TORQUE_RATIO_MAX 90u
#define CK10_REG_FLASH_HOMING_TORQUE_RATIO_DEFAULT 50u

/**
 * A greater position error at rest, with the servo on, gives an alarm and switches the motor off.
 * Printed as 位置錯誤溢出限制.
 * Read only. 2 words must be accessed in one request. A copy of position_overflow_limit.
 * One count is 1 pulse. Range: 1..134217727.
 * Source: 2.6 L503
 */
#define CK10_REG_FLASH_POSITION_OVERFLOW_LIMIT_ADDRESS 0x1488u
#define CK10_REG_FLASH_POSITION_OVERFLOW_LIMIT_WORDS 2u
#define CK10_REG_FLASH_POSITION_OVERFLOW_LIMIT_MIN 1u
#define CK10_REG_FLASH_POSITION_OVERFLOW_LIMIT_MAX 134217727u
#define CK10_REG_FLASH_POSITION_OVERFLOW_LIMIT_DEFAULT 2500u

/**
 * Printed as 保留.
 * Read only. 2 words must be accessed in one request. A copy of reserved_29.
 * One count is 1 ms. Range: 10..5000.
 * Source: 2.6 L504
 */
#define CK10_REG_FLASH_RESERVED_29_ADDRESS 0x148Au
#define CK10_REG_FLASH_RESERVED_29_WORDS 2u
#define CK10_REG_FLASH_RESERVED_29_MIN 10u
#define CK10_REG_FLASH_RESERVED_29_MAX 5000u
#define CK10_REG_FLASH_RESERVED_29_DEFAULT 200u

/**
 * The current while moving, as a share of the motor's rated one.
 * Printed as 運行電流.
 * Read only. 2 words must be accessed in one request. A copy of run_current.
 * One count is 10 %. Range: 5..15.
 * Source: 2.6 L505
 */
#define CK10_REG_FLASH_RUN_CURRENT_ADDRESS 0x148Cu
#define CK10_REG_FLASH_RUN_CURRENT_WORDS 2u
#define CK10_REG_FLASH_RUN_CURRENT_MIN 5u
#define CK10_REG_FLASH_RUN_CURRENT_MAX 15u
#define CK10_REG_FLASH_RUN_CURRENT_DEFAULT 10u
#define CK10_REG_FLASH_RUN_CURRENT_SCALE_NUMERATOR INT64_C(10)
#define CK10_REG_FLASH_RUN_CURRENT_SCALE_DENOMINATOR INT64_C(1)

/**
 * A current that is added while accelerating, for acceleration times that would else be too short.
 * Printed as 起動電流.
 * Read only. 2 words must be accessed in one request. A copy of boost_current.
 * One count is 50 %. Range: 0..7.
 * Source: 2.6 L506
 */
#define CK10_REG_FLASH_BOOST_CURRENT_ADDRESS 0x148Eu
#define CK10_REG_FLASH_BOOST_CURRENT_WORDS 2u
#define CK10_REG_FLASH_BOOST_CURRENT_MIN 0u
#define CK10_REG_FLASH_BOOST_CURRENT_MAX 7u
#define CK10_REG_FLASH_BOOST_CURRENT_DEFAULT 0u
#define CK10_REG_FLASH_BOOST_CURRENT_SCALE_NUMERATOR INT64_C(50)
#define CK10_REG_FLASH_BOOST_CURRENT_SCALE_DENOMINATOR INT64_C(1)

/**
 * The current from 0.1 s after the motor has stopped.
 * Printed as 停止電流.
 * Read only. 2 words must be accessed in one request. A copy of stop_current.
 * One count is 10 %. Range: 2..10.
 * Source: 2.6 L507
 */
#define CK10_REG_FLASH_STOP_CURRENT_ADDRESS 0x1490u
#define CK10_REG_FLASH_STOP_CURRENT_WORDS 2u
#define CK10_REG_FLASH_STOP_CURRENT_MIN 2u
#define CK10_REG_FLASH_STOP_CURRENT_MAX 10u
#define CK10_REG_FLASH_STOP_CURRENT_DEFAULT 5u
#define CK10_REG_FLASH_STOP_CURRENT_SCALE_NUMERATOR INT64_C(10)
#define CK10_REG_FLASH_STOP_CURRENT_SCALE_DENOMINATOR INT64_C(1)

/**
 * What the emergency stop input does.
 * Printed as 緊急停止模式.
 * Read only. 2 words must be accessed in one request. A copy of emergency_stop_mode.
 * Range: 0..4. See emergency_stop_mode.
 * Source: 2.6 L508
 */
#define CK10_REG_FLASH_EMERGENCY_STOP_MODE_ADDRESS 0x1492u
#define CK10_REG_FLASH_EMERGENCY_STOP_MODE_WORDS 2u
#define CK10_REG_FLASH_EMERGENCY_STOP_MODE_MIN 0u
#define CK10_REG_FLASH_EMERGENCY_STOP_MODE_MAX 4u
#define CK10_REG_FLASH_EMERGENCY_STOP_MODE_DEFAULT 0u

/**
 * What the brake does in the emergency stop.
 * Printed as 緊急剎車模式.
 * Read only. 2 words must be accessed in one request. A copy of emergency_brake_mode.
 * Range: 0..1. See emergency_brake_mode.
 * Source: 2.6 L509
 */
#define CK10_REG_FLASH_EMERGENCY_BRAKE_MODE_ADDRESS 0x1494u
#define CK10_REG_FLASH_EMERGENCY_BRAKE_MODE_WORDS 2u
#define CK10_REG_FLASH_EMERGENCY_BRAKE_MODE_MIN 0u
#define CK10_REG_FLASH_EMERGENCY_BRAKE_MODE_MAX 1u
#define CK10_REG_FLASH_EMERGENCY_BRAKE_MODE_DEFAULT 0u

/**
 * How the controller gets its commands.
 * Printed as 操作模式.
 * Read only. 2 words must be accessed in one request. A copy of operation_mode.
 * Range: 0..5. See operation_mode.
 * Source: 2.6 L510
 */
#define CK10_REG_FLASH_OPERATION_MODE_ADDRESS 0x1496u
#define CK10_REG_FLASH_OPERATION_MODE_WORDS 2u
#define CK10_REG_FLASH_OPERATION_MODE_MIN 0u
#define CK10_REG_FLASH_OPERATION_MODE_MAX 5u
#define CK10_REG_FLASH_OPERATION_MODE_DEFAULT 3u

/**
 * What the switch SW3 of the controller does.
 * Printed as 切換開關功能.
 * Read only. 2 words must be accessed in one request. A copy of switch_function.
 * Range: 0..1. See switch_function.
 * Source: 2.6 L511
 */
#define CK10_REG_FLASH_SWITCH_FUNCTION_ADDRESS 0x1498u
#define CK10_REG_FLASH_SWITCH_FUNCTION_WORDS 2u
#define CK10_REG_FLASH_SWITCH_FUNCTION_MIN 0u
#define CK10_REG_FLASH_SWITCH_FUNCTION_MAX 1u
#define CK10_REG_FLASH_SWITCH_FUNCTION_DEFAULT 0u

/**
 * The speed of the line.
 * Printed as 鮑率.
 * Read only. 2 words must be accessed in one request. A copy of baud_rate.
 * Range: 0..4. See baud_rate.
 * Source: 2.6 L512
 */
#define CK10_REG_FLASH_BAUD_RATE_ADDRESS 0x149Au
#define CK10_REG_FLASH_BAUD_RATE_WORDS 2u
#define CK10_REG_FLASH_BAUD_RATE_MIN 0u
#define CK10_REG_FLASH_BAUD_RATE_MAX 4u
#define CK10_REG_FLASH_BAUD_RATE_DEFAULT 4u

/**
 * Whether the position and the point table are kept when the power goes.
 * Printed as 儲存位置 / 位置表.
 * Read only. 2 words must be accessed in one request. A copy of save_position.
 * Range: 0..1. See enabled.
 * Source: 2.6 L513
 */
#define CK10_REG_FLASH_SAVE_POSITION_ADDRESS 0x149Cu
#define CK10_REG_FLASH_SAVE_POSITION_WORDS 2u
#define CK10_REG_FLASH_SAVE_POSITION_MIN 0u
#define CK10_REG_FLASH_SAVE_POSITION_MAX 1u
#define CK10_REG_FLASH_SAVE_POSITION_DEFAULT 1u

/**
 * Whether the LED blinks the number of the motor, which makes the start some seconds longer.
 * Printed as 顯示馬達編號.
 * Read only. 2 words must be accessed in one request. A copy of show_motor_number.
 * Range: 0..1. See enabled.
 * Source: 2.6 L514
 */
#define CK10_REG_FLASH_SHOW_MOTOR_NUMBER_ADDRESS 0x149Eu
#define CK10_REG_FLASH_SHOW_MOTOR_NUMBER_WORDS 2u
#define CK10_REG_FLASH_SHOW_MOTOR_NUMBER_MIN 0u
#define CK10_REG_FLASH_SHOW_MOTOR_NUMBER_MAX 1u
#define CK10_REG_FLASH_SHOW_MOTOR_NUMBER_DEFAULT 0u

/**
 * The manual calls it reserved.
 * Printed as IO 指派旗標.
 * Read only. 2 words must be accessed in one request. A copy of assignment_flags.
 * Source: 2.6 L516
 */
#define CK10_REG_FLASH_ASSIGNMENT_FLAGS_ADDRESS 0x14A0u
#define CK10_REG_FLASH_ASSIGNMENT_FLAGS_WORDS 2u

/**
 * What input 1 is for.
 * Printed as IO 指派 IN1.
 * Read only. 2 words must be accessed in one request. A copy of input_1_function.
 * See input_function.
 * Source: 2.6 L517
 */
#define CK10_REG_FLASH_INPUT_1_FUNCTION_ADDRESS 0x14A2u
#define CK10_REG_FLASH_INPUT_1_FUNCTION_WORDS 2u

/**
 * What input 2 is for.
 * Printed as IO 指派 IN2.
 * Read only. 2 words must be accessed in one request. A copy of input_2_function.
 * See input_function.
 * Source: 2.6 L518
 */
#define CK10_REG_FLASH_INPUT_2_FUNCTION_ADDRESS 0x14A4u
#define CK10_REG_FLASH_INPUT_2_FUNCTION_WORDS 2u

/**
 * What input 3 is for.
 * Printed as IO 指派 IN3.
 * Read only. 2 words must be accessed in one request. A copy of input_3_function.
 * See input_function.
 * Source: 2.6 L519
 */
#define CK10_REG_FLASH_INPUT_3_FUNCTION_ADDRESS 0x14A6u
#define CK10_REG_FLASH_INPUT_3_FUNCTION_WORDS 2u

/**
 * What input 4 is for.
 * Printed as IO 指派 IN4.
 * Read only. 2 words must be accessed in one request. A copy of input_4_function.
 * See input_function.
 * Source: 2.6 L520
 */
#define CK10_REG_FLASH_INPUT_4_FUNCTION_ADDRESS 0x14A8u
#define CK10_REG_FLASH_INPUT_4_FUNCTION_WORDS 2u

/**
 * What input 5 is for.
 * Printed as IO 指派 IN5.
 * Read only. 2 words must be accessed in one request. A copy of input_5_function.
 * See input_function.
 * Source: 2.6 L521
 */
#define CK10_REG_FLASH_INPUT_5_FUNCTION_ADDRESS 0x14AAu
#define CK10_REG_FLASH_INPUT_5_FUNCTION_WORDS 2u

/**
 * What input 6 is for.
 * Printed as IO 指派 IN6.
 * Read only. 2 words must be accessed in one request. A copy of input_6_function.
 * See input_function.
 * Source: 2.6 L522
 */
#define CK10_REG_FLASH_INPUT_6_FUNCTION_ADDRESS 0x14ACu
#define CK10_REG_FLASH_INPUT_6_FUNCTION_WORDS 2u

/**
 * What input 7 is for.
 * Printed as IO 指派 IN7.
 * Read only. 2 words must be accessed in one request. A copy of input_7_function.
 * See input_function.
 * Source: 2.6 L523
 */
#define CK10_REG_FLASH_INPUT_7_FUNCTION_ADDRESS 0x14AEu
#define CK10_REG_FLASH_INPUT_7_FUNCTION_WORDS 2u

/**
 * What input 8 is for.
 * Printed as IO 指派 IN8.
 * Read only. 2 words must be accessed in one request. A copy of input_8_function.
 * See input_function.
 * Source: 2.6 L524
 */
#define CK10_REG_FLASH_INPUT_8_FUNCTION_ADDRESS 0x14B0u
#define CK10_REG_FLASH_INPUT_8_FUNCTION_WORDS 2u

/**
 * What input 9 is for.
 * Printed as IO 指派 IN9.
 * Read only. 2 words must be accessed in one request. A copy of input_9_function.
 * See input_function.
 * Source: 2.6 L525
 */
#define CK10_REG_FLASH_INPUT_9_FUNCTION_ADDRESS 0x14B2u
#define CK10_REG_FLASH_INPUT_9_FUNCTION_WORDS 2u

/**
 * What input 10 is for.
 * Printed as IO 指派 IN10.
 * Read only. 2 words must be accessed in one request. A copy of input_10_function.
 * See input_function.
 * Source: 2.6 L526
 */
#define CK10_REG_FLASH_INPUT_10_FUNCTION_ADDRESS 0x14B4u
#define CK10_REG_FLASH_INPUT_10_FUNCTION_WORDS 2u

/**
 * What input 11 is for.
 * Printed as IO 指派 IN11.
 * Read only. 2 words must be accessed in one request. A copy of input_11_function.
 * See input_function.
 * Source: 2.6 L527
 */
#define CK10_REG_FLASH_INPUT_11_FUNCTION_ADDRESS 0x14B6u
#define CK10_REG_FLASH_INPUT_11_FUNCTION_WORDS 2u

/**
 * What input 12 is for.
 * Printed as IO 指派 IN12.
 * Read only. 2 words must be accessed in one request. A copy of input_12_function.
 * See input_function.
 * Source: 2.6 L528
 */
#define CK10_REG_FLASH_INPUT_12_FUNCTION_ADDRESS 0x14B8u
#define CK10_REG_FLASH_INPUT_12_FUNCTION_WORDS 2u

/**
 * What output 1 is for.
 * Printed as IO 指派 OUT1.
 * Read only. 2 words must be accessed in one request. A copy of output_1_function.
 * See output_function.
 * Source: 2.6 L529
 */
#define CK10_REG_FLASH_OUTPUT_1_FUNCTION_ADDRESS 0x14BAu
#define CK10_REG_FLASH_OUTPUT_1_FUNCTION_WORDS 2u

/**
 * What output 2 is for.
 * Printed as IO 指派 OUT2.
 * Read only. 2 words must be accessed in one request. A copy of output_2_function.
 * See output_function.
 * Source: 2.6 L530
 */
#define CK10_REG_FLASH_OUTPUT_2_FUNCTION_ADDRESS 0x14BCu
#define CK10_REG_FLASH_OUTPUT_2_FUNCTION_WORDS 2u

/**
 * What output 3 is for.
 * Printed as IO 指派 OUT3.
 * Read only. 2 words must be accessed in one request. A copy of output_3_function.
 * See output_function.
 * Source: 2.6 L531
 */
#define CK10_REG_FLASH_OUTPUT_3_FUNCTION_ADDRESS 0x14BEu
#define CK10_REG_FLASH_OUTPUT_3_FUNCTION_WORDS 2u

/**
 * What output 4 is for.
 * Printed as IO 指派 OUT4.
 * Read only. 2 words must be accessed in one request. A copy of output_4_function.
 * See output_function.
 * Source: 2.6 L535
 */
#define CK10_REG_FLASH_OUTPUT_4_FUNCTION_ADDRESS 0x14C0u
#define CK10_REG_FLASH_OUTPUT_4_FUNCTION_WORDS 2u

/**
 * What output 5 is for.
 * Printed as IO 指派 OUT5.
 * Read only. 2 words must be accessed in one request. A copy of output_5_function.
 * See output_function.
 * Source: 2.6 L536
 */
#define CK10_REG_FLASH_OUTPUT_5_FUNCTION_ADDRESS 0x14C2u
#define CK10_REG_FLASH_OUTPUT_5_FUNCTION_WORDS 2u

/**
 * What output 6 is for.
 * Printed as IO 指派 OUT6.
 * Read only. 2 words must be accessed in one request. A copy of output_6_function.
 * See output_function.
 * Source: 2.6 L537
 */
#define CK10_REG_FLASH_OUTPUT_6_FUNCTION_ADDRESS 0x14C4u
#define CK10_REG_FLASH_OUTPUT_6_FUNCTION_WORDS 2u

/**
 * What output 7 is for.
 * Printed as IO 指派 OUT7.
 * Read only. 2 words must be accessed in one request. A copy of output_7_function.
 * See output_function.
 * Source: 2.6 L538
 */
#define CK10_REG_FLASH_OUTPUT_7_FUNCTION_ADDRESS 0x14C6u
#define CK10_REG_FLASH_OUTPUT_7_FUNCTION_WORDS 2u

/**
 * What output 8 is for.
 * Printed as IO 指派 OUT8.
 * Read only. 2 words must be accessed in one request. A copy of output_8_function.
 * See output_function.
 * Source: 2.6 L539
 */
#define CK10_REG_FLASH_OUTPUT_8_FUNCTION_ADDRESS 0x14C8u
#define CK10_REG_FLASH_OUTPUT_8_FUNCTION_WORDS 2u

/**
 * What output 9 is for.
 * Printed as IO 指派 OUT9.
 * Read only. 2 words must be accessed in one request. A copy of output_9_function.
 * See output_function.
 * Source: 2.6 L540
 */
#define CK10_REG_FLASH_OUTPUT_9_FUNCTION_ADDRESS 0x14CAu
#define CK10_REG_FLASH_OUTPUT_9_FUNCTION_WORDS 2u

/**
 * What output 10 is for.
 * Printed as IO 指派 OUT10.
 * Read only. 2 words must be accessed in one request. A copy of output_10_function.
 * See output_function.
 * Source: 2.6 L541
 */
#define CK10_REG_FLASH_OUTPUT_10_FUNCTION_ADDRESS 0x14CCu
#define CK10_REG_FLASH_OUTPUT_10_FUNCTION_WORDS 2u

/**
 * Whether input 1 is 1 when it is on or when it is off.
 * Printed as IO 極性 IN1.
 * Read only. 2 words must be accessed in one request. A copy of input_1_polarity.
 * See polarity.
 * Source: 2.6 L542
 */
#define CK10_REG_FLASH_INPUT_1_POLARITY_ADDRESS 0x14CEu
#define CK10_REG_FLASH_INPUT_1_POLARITY_WORDS 2u

/**
 * Whether input 2 is 1 when it is on or when it is off.
 * Printed as IO 極性 IN2.
 * Read only. 2 words must be accessed in one request. A copy of input_2_polarity.
 * See polarity.
 * Source: 2.6 L543
 */
#define CK10_REG_FLASH_INPUT_2_POLARITY_ADDRESS 0x14D0u
#define CK10_REG_FLASH_INPUT_2_POLARITY_WORDS 2u

/**
 * Whether input 3 is 1 when it is on or when it is off.
 * Printed as IO 極性 IN3.
 * Read only. 2 words must be accessed in one request. A copy of input_3_polarity.
 * See polarity.
 * Source: 2.6 L544
 */
#define CK10_REG_FLASH_INPUT_3_POLARITY_ADDRESS 0x14D2u
#define CK10_REG_FLASH_INPUT_3_POLARITY_WORDS 2u

/**
 * Whether input 4 is 1 when it is on or when it is off.
 * Printed as IO 極性 IN4.
 * Read only. 2 words must be accessed in one request. A copy of input_4_polarity.
 * See polarity.
 * Source: 2.6 L545
 */
#define CK10_REG_FLASH_INPUT_4_POLARITY_ADDRESS 0x14D4u
#define CK10_REG_FLASH_INPUT_4_POLARITY_WORDS 2u

/**
 * Whether input 5 is 1 when it is on or when it is off.
 * Printed as IO 極性 IN5.
 * Read only. 2 words must be accessed in one request. A copy of input_5_polarity.
 * See polarity.
 * Source: 2.6 L546
 */
#define CK10_REG_FLASH_INPUT_5_POLARITY_ADDRESS 0x14D6u
#define CK10_REG_FLASH_INPUT_5_POLARITY_WORDS 2u

/**
 * Whether input 6 is 1 when it is on or when it is off.
 * Printed as IO 極性 IN6.
 * Read only. 2 words must be accessed in one request. A copy of input_6_polarity.
 * See polarity.
 * Source: 2.6 L547
 */
#define CK10_REG_FLASH_INPUT_6_POLARITY_ADDRESS 0x14D8u
#define CK10_REG_FLASH_INPUT_6_POLARITY_WORDS 2u

/**
 * Whether input 7 is 1 when it is on or when it is off.
 * Printed as IO 極性 IN7.
 * Read only. 2 words must be accessed in one request. A copy of input_7_polarity.
 * See polarity.
 * Source: 2.6 L548
 */
#define CK10_REG_FLASH_INPUT_7_POLARITY_ADDRESS 0x14DAu
#define CK10_REG_FLASH_INPUT_7_POLARITY_WORDS 2u

/**
 * Whether input 8 is 1 when it is on or when it is off.
 * Printed as IO 極性 IN8.
 * Read only. 2 words must be accessed in one request. A copy of input_8_polarity.
 * See polarity.
 * Source: 2.6 L549
 */
#define CK10_REG_FLASH_INPUT_8_POLARITY_ADDRESS 0x14DCu
#define CK10_REG_FLASH_INPUT_8_POLARITY_WORDS 2u

/**
 * Whether input 9 is 1 when it is on or when it is off.
 * Printed as IO 極性 IN9.
 * Read only. 2 words must be accessed in one request. A copy of input_9_polarity.
 * See polarity.
 * Source: 2.6 L550
 */
#define CK10_REG_FLASH_INPUT_9_POLARITY_ADDRESS 0x14DEu
#define CK10_REG_FLASH_INPUT_9_POLARITY_WORDS 2u

/**
 * Whether input 10 is 1 when it is on or when it is off.
 * Printed as IO 極性 IN10.
 * Read only. 2 words must be accessed in one request. A copy of input_10_polarity.
 * See polarity.
 * Source: 2.6 L551
 */
#define CK10_REG_FLASH_INPUT_10_POLARITY_ADDRESS 0x14E0u
#define CK10_REG_FLASH_INPUT_10_POLARITY_WORDS 2u

/**
 * Whether input 11 is 1 when it is on or when it is off.
 * Printed as IO 極性 IN11.
 * Read only. 2 words must be accessed in one request. A copy of input_11_polarity.
 * See polarity.
 * Source: 2.6 L552
 */
#define CK10_REG_FLASH_INPUT_11_POLARITY_ADDRESS 0x14E2u
#define CK10_REG_FLASH_INPUT_11_POLARITY_WORDS 2u

/**
 * Whether input 12 is 1 when it is on or when it is off.
 * Printed as IO 極性 IN12.
 * Read only. 2 words must be accessed in one request. A copy of input_12_polarity.
 * See polarity.
 * Source: 2.6 L553
 */
#define CK10_REG_FLASH_INPUT_12_POLARITY_ADDRESS 0x14E4u
#define CK10_REG_FLASH_INPUT_12_POLARITY_WORDS 2u

/**
 * Whether output 1 is on when its signal is 1 or when it is 0.
 * Printed as IO 極性 OUT1.
 * Read only. 2 words must be accessed in one request. A copy of output_1_polarity.
 * See polarity.
 * Source: 2.6 L554
 */
#define CK10_REG_FLASH_OUTPUT_1_POLARITY_ADDRESS 0x14E6u
#define CK10_REG_FLASH_OUTPUT_1_POLARITY_WORDS 2u

/**
 * Whether output 2 is on when its signal is 1 or when it is 0.
 * Printed as IO 極性 OUT2.
 * Read only. 2 words must be accessed in one request. A copy of output_2_polarity.
 * See polarity.
 * Source: 2.6 L555
 */
#define CK10_REG_FLASH_OUTPUT_2_POLARITY_ADDRESS 0x14E8u
#define CK10_REG_FLASH_OUTPUT_2_POLARITY_WORDS 2u

/**
 * Whether output 3 is on when its signal is 1 or when it is 0.
 * Printed as IO 極性 OUT3.
 * Read only. 2 words must be accessed in one request. A copy of output_3_polarity.
 * See polarity.
 * Source: 2.6 L556
 */
#define CK10_REG_FLASH_OUTPUT_3_POLARITY_ADDRESS 0x14EAu
#define CK10_REG_FLASH_OUTPUT_3_POLARITY_WORDS 2u

/**
 * Whether output 4 is on when its signal is 1 or when it is 0.
 * Printed as IO 極性 OUT4.
 * Read only. 2 words must be accessed in one request. A copy of output_4_polarity.
 * See polarity.
 * Source: 2.6 L557
 */
#define CK10_REG_FLASH_OUTPUT_4_POLARITY_ADDRESS 0x14ECu
#define CK10_REG_FLASH_OUTPUT_4_POLARITY_WORDS 2u

/**
 * Whether output 5 is on when its signal is 1 or when it is 0.
 * Printed as IO 極性 OUT5.
 * Read only. 2 words must be accessed in one request. A copy of output_5_polarity.
 * See polarity.
 * Source: 2.6 L558
 */
#define CK10_REG_FLASH_OUTPUT_5_POLARITY_ADDRESS 0x14EEu
#define CK10_REG_FLASH_OUTPUT_5_POLARITY_WORDS 2u

/**
 * Whether output 6 is on when its signal is 1 or when it is 0.
 * Printed as IO 極性 OUT6.
 * Read only. 2 words must be accessed in one request. A copy of output_6_polarity.
 * See polarity.
 * Source: 2.6 L559
 */
#define CK10_REG_FLASH_OUTPUT_6_POLARITY_ADDRESS 0x14F0u
#define CK10_REG_FLASH_OUTPUT_6_POLARITY_WORDS 2u

/**
 * Whether output 7 is on when its signal is 1 or when it is 0.
 * Printed as IO 極性 OUT7.
 * Read only. 2 words must be accessed in one request. A copy of output_7_polarity.
 * See polarity.
 * Source: 2.6 L560
 */
#define CK10_REG_FLASH_OUTPUT_7_POLARITY_ADDRESS 0x14F2u
#define CK10_REG_FLASH_OUTPUT_7_POLARITY_WORDS 2u

/**
 * Whether output 8 is on when its signal is 1 or when it is 0.
 * Printed as IO 極性 OUT8.
 * Read only. 2 words must be accessed in one request. A copy of output_8_polarity.
 * See polarity.
 * Source: 2.6 L561
 */
#define CK10_REG_FLASH_OUTPUT_8_POLARITY_ADDRESS 0x14F4u
#define CK10_REG_FLASH_OUTPUT_8_POLARITY_WORDS 2u

/**
 * Whether output 9 is on when its signal is 1 or when it is 0.
 * Printed as IO 極性 OUT9.
 * Read only. 2 words must be accessed in one request. A copy of output_9_polarity.
 * See polarity.
 * Source: 2.6 L562
 */
#define CK10_REG_FLASH_OUTPUT_9_POLARITY_ADDRESS 0x14F6u
#define CK10_REG_FLASH_OUTPUT_9_POLARITY_WORDS 2u

/**
 * Whether output 10 is on when its signal is 1 or when it is 0.
 * Printed as IO 極性 OUT10.
 * Read only. 2 words must be accessed in one request. A copy of output_10_polarity.
 * See polarity.
 * Source: 2.6 L563
 */
#define CK10_REG_FLASH_OUTPUT_10_POLARITY_ADDRESS 0x14F8u
#define CK10_REG_FLASH_OUTPUT_10_POLARITY_WORDS 2u

/**
 * The state of the controller and of its move, as the flags of 3.1.
 * Printed as MotionStatus 運動狀態.
 * Read only. 2 words must be accessed in one request.
 * See motion_status.
 * Source: 2.1 L254
 */
#define CK10_REG_MOTION_STATUS_ADDRESS 0x03E8u
#define CK10_REG_MOTION_STATUS_WORDS 2u

/**
 * Printed as ActPos 實際位置.
 * Read only. 2 words must be accessed in one request.
 * Note: No unit is printed; the limits of 3.4 and the points of 2.7 are in pulses.
 * Source: 2.1 L255
 */
#define CK10_REG_ACTUAL_POSITION_ADDRESS 0x03EAu
#define CK10_REG_ACTUAL_POSITION_WORDS 2u

/**
 * Printed as CmdPos 命令位置.
 * Read only. 2 words must be accessed in one request.
 * Note: No unit is printed; the positions of points are in pulses (2.7 L575).
 * Source: 2.1 L256
 */
#define CK10_REG_COMMAND_POSITION_ADDRESS 0x03ECu
#define CK10_REG_COMMAND_POSITION_WORDS 2u

/**
 * Printed as Velocity 速度.
 * Read only. 2 words must be accessed in one request.
 * Note: No unit is printed; the speeds of 3.4 are in pps.
 * Source: 2.1 L257
 */
#define CK10_REG_SPEED_ADDRESS 0x03EEu
#define CK10_REG_SPEED_WORDS 2u

/**
 * How far the actual position is from the commanded one.
 * Printed as PosError 位置錯誤.
 * Read only. 2 words must be accessed in one request.
 * Note: No unit is printed; the positions of points are in pulses (2.7 L575).
 * Source: 2.1 L258
 */
#define CK10_REG_POSITION_ERROR_ADDRESS 0x03F0u
#define CK10_REG_POSITION_ERROR_WORDS 2u

/**
 * All inputs, the user's and those of the controller.
 * Printed as InputAll 輸入端口值.
 * Read only. 2 words must be accessed in one request.
 * See input_signals.
 * Source: 2.1 L259
 */
#define CK10_REG_INPUTS_ADDRESS 0x03F2u
#define CK10_REG_INPUTS_WORDS 2u

/**
 * All outputs, the user's and those of the controller.
 * Printed as OutputAll 輸出端口值.
 * Read only. 2 words must be accessed in one request.
 * See output_signals.
 * Source: 2.1 L260
 */
#define CK10_REG_OUTPUTS_ADDRESS 0x03F4u
#define CK10_REG_OUTPUTS_WORDS 2u

/**
 * The number of the point that is being carried out.
 * Printed as CurPtNo 當前位置表號碼.
 * Read only.
 * Source: 2.1 L261
 */
#define CK10_REG_CURRENT_POINT_ADDRESS 0x03F6u
#define CK10_REG_CURRENT_POINT_WORDS 1u

/**
 * The point table is being carried out.
 * Printed as PT Status 位置表狀態.
 * Read only.
 * Source: 2.1 L262
 */
#define CK10_REG_POINT_TABLE_RUNNING_ADDRESS 0x03F7u
#define CK10_REG_POINT_TABLE_RUNNING_WORDS 1u

/**
 * Printed as PushStatus 推力運動狀態.
 * Read only.
 * See push_status.
 * Source: 2.1 L263
 */
#define CK10_REG_PUSH_STATUS_ADDRESS 0x03F8u
#define CK10_REG_PUSH_STATUS_WORDS 1u

/**
 * Printed as CurAlarm 當前警報號碼.
 * Read only.
 * See alarm_code.
 * Source: 2.1 L264
 */
#define CK10_REG_CURRENT_ALARM_ADDRESS 0x03F9u
#define CK10_REG_CURRENT_ALARM_WORDS 1u

/**
 * Which motor is set; what the numbers stand for is not printed.
 * Printed as MotorID 馬達 ID.
 * Read only.
 * Source: 2.1 L265
 */
#define CK10_REG_MOTOR_ID_ADDRESS 0x03FAu
#define CK10_REG_MOTOR_ID_WORDS 1u

/**
 * The inputs that are assigned to the user, all in one word.
 * Printed as USR_IN_ALL 使用者 IN0~IN8.
 * Read only.
 * See user_inputs.
 * Source: 2.2 L270
 */
#define CK10_REG_USER_INPUTS_ADDRESS 0x0406u
#define CK10_REG_USER_INPUTS_WORDS 1u

/**
 * Printed as USR_IN0 使用者 IN0.
 * Read only.
 * Source: 2.2 L271
 */
#define CK10_REG_USER_INPUT_0_ADDRESS 0x0407u
#define CK10_REG_USER_INPUT_0_WORDS 1u

/**
 * Printed as USR_IN1 使用者 IN1.
 * Read only.
 * Source: 2.2 L272
 */
#define CK10_REG_USER_INPUT_1_ADDRESS 0x0408u
#define CK10_REG_USER_INPUT_1_WORDS 1u

/**
 * Printed as USR_IN2 使用者 IN2.
 * Read only.
 * Source: 2.2 L273
 */
#define CK10_REG_USER_INPUT_2_ADDRESS 0x0409u
#define CK10_REG_USER_INPUT_2_WORDS 1u

/**
 * Printed as USR_IN3 使用者 IN3.
 * Read only.
 * Source: 2.2 L274
 */
#define CK10_REG_USER_INPUT_3_ADDRESS 0x040Au
#define CK10_REG_USER_INPUT_3_WORDS 1u

/**
 * Printed as USR_IN4 使用者 IN4.
 * Read only.
 * Source: 2.2 L275
 */
#define CK10_REG_USER_INPUT_4_ADDRESS 0x040Bu
#define CK10_REG_USER_INPUT_4_WORDS 1u

/**
 * Printed as USR_IN5 使用者 IN5.
 * Read only.
 * Source: 2.2 L276
 */
#define CK10_REG_USER_INPUT_5_ADDRESS 0x040Cu
#define CK10_REG_USER_INPUT_5_WORDS 1u

/**
 * Printed as USR_IN6 使用者 IN6.
 * Read only.
 * Source: 2.2 L277
 */
#define CK10_REG_USER_INPUT_6_ADDRESS 0x040Du
#define CK10_REG_USER_INPUT_6_WORDS 1u

/**
 * Printed as USR_IN7 使用者 IN7.
 * Read only.
 * Source: 2.2 L278
 */
#define CK10_REG_USER_INPUT_7_ADDRESS 0x040Eu
#define CK10_REG_USER_INPUT_7_WORDS 1u

/**
 * Printed as USR_IN8 使用者 IN8.
 * Read only.
 * Source: 2.2 L279
 */
#define CK10_REG_USER_INPUT_8_ADDRESS 0x040Fu
#define CK10_REG_USER_INPUT_8_WORDS 1u

/**
 * The outputs that are assigned to the user, all in one word.
 * Printed as USR_OUT_ALL 使用者 OUT.
 * Read and write.
 * See user_outputs.
 * Source: 2.2 L280
 */
#define CK10_REG_USER_OUTPUTS_ADDRESS 0x0410u
#define CK10_REG_USER_OUTPUTS_WORDS 1u

/**
 * Printed as USR_OUT0 使用者 OUT0.
 * Read and write.
 * See output_switch.
 * Source: 2.2 L281
 */
#define CK10_REG_USER_OUTPUT_0_ADDRESS 0x0411u
#define CK10_REG_USER_OUTPUT_0_WORDS 1u

/**
 * Printed as USR_OUT1 使用者 OUT1.
 * Read and write.
 * See output_switch.
 * Source: 2.2 L282
 */
#define CK10_REG_USER_OUTPUT_1_ADDRESS 0x0412u
#define CK10_REG_USER_OUTPUT_1_WORDS 1u

/**
 * Printed as USR_OUT2 使用者 OUT2.
 * Read and write.
 * See output_switch.
 * Source: 2.2 L283
 */
#define CK10_REG_USER_OUTPUT_2_ADDRESS 0x0413u
#define CK10_REG_USER_OUTPUT_2_WORDS 1u

/**
 * Printed as USR_OUT3 使用者 OUT3.
 * Read and write.
 * See output_switch.
 * Source: 2.2 L284
 */
#define CK10_REG_USER_OUTPUT_3_ADDRESS 0x0414u
#define CK10_REG_USER_OUTPUT_3_WORDS 1u

/**
 * Printed as USR_OUT4 使用者 OUT4.
 * Read and write.
 * See output_switch.
 * Source: 2.2 L285
 */
#define CK10_REG_USER_OUTPUT_4_ADDRESS 0x0415u
#define CK10_REG_USER_OUTPUT_4_WORDS 1u

/**
 * Printed as USR_OUT5 使用者 OUT5.
 * Read and write.
 * See output_switch.
 * Source: 2.2 L286
 */
#define CK10_REG_USER_OUTPUT_5_ADDRESS 0x0416u
#define CK10_REG_USER_OUTPUT_5_WORDS 1u

/**
 * Printed as USR_OUT6 使用者 OUT6.
 * Read and write.
 * See output_switch.
 * Source: 2.2 L287
 */
#define CK10_REG_USER_OUTPUT_6_ADDRESS 0x0417u
#define CK10_REG_USER_OUTPUT_6_WORDS 1u

/**
 * Printed as USR_OUT7 使用者 OUT7.
 * Read and write.
 * See output_switch.
 * Source: 2.2 L288
 */
#define CK10_REG_USER_OUTPUT_7_ADDRESS 0x0418u
#define CK10_REG_USER_OUTPUT_7_WORDS 1u

/**
 * Printed as USR_OUT8 使用者 OUT8.
 * Read and write.
 * See output_switch.
 * Source: 2.2 L289
 */
#define CK10_REG_USER_OUTPUT_8_ADDRESS 0x0419u
#define CK10_REG_USER_OUTPUT_8_WORDS 1u

/**
 * Writing FFFFh clears the history.
 * Printed as ALM_CLR 清除警報記錄.
 * Write only. Writing starts an action.
 * Source: 2.3 L294
 */
#define CK10_REG_CLEAR_ALARM_HISTORY_ADDRESS 0x0423u
#define CK10_REG_CLEAR_ALARM_HISTORY_WORDS 1u
#define CK10_REG_CLEAR_ALARM_HISTORY_VALUE 65535u

/**
 * The alarms that were, the oldest first.
 * Printed as ALM_LOG 警報記錄.
 * Read only.
 * See alarm_code.
 * Note: The manual prints the elements 0, 1, 28 and 29 (0424h, 0425h, 0440h, 0441h; 1060, 1061, 1088, 1089),
 * and dots for those between.
 * Note: Number 0 is the earliest alarm, so the latest one is not at a fixed place.
 * Source: 2.3 L295-299
 */
#define CK10_REG_ALARM_HISTORY_ADDRESS 0x0424u
#define CK10_REG_ALARM_HISTORY_WORDS 1u
#define CK10_REG_ALARM_HISTORY_COUNT 30u
#define CK10_REG_ALARM_HISTORY_STRIDE 1u
#define CK10_REG_ALARM_HISTORY_FIRST 0u

/* ---- Record tables ---- */

/**
 * Point n begins at 2710h + 20h * n. 07F5h stores the table in flash.
 * Printed as 位置表記憶體.
 * Its elements are ck10_point.
 * Read and write.
 * Note: Wrong data may cause errors when a point is carried out (2.7 L607).
 * Note: Decimal addresses are printed for the points 0, 1, 2 and 127: 10000, 10032, 10064 and 14064.
 * Source: 2.7 L572-607
 */
#define CK10_TABLE_POINTS_ADDRESS 0x2710u
#define CK10_TABLE_POINTS_WORDS 32u
#define CK10_TABLE_POINTS_STRIDE 32u
#define CK10_TABLE_POINTS_COUNT 128u
#define CK10_TABLE_POINTS_FIRST 0u

/**
 * What is stored. It cannot be written directly; 07F5h copies the table in memory to it.
 * Printed as 快閃記憶體 PT.
 * Its elements are ck10_point.
 * Read only.
 * Note: Decimal addresses are printed for the points 0, 1, 2 and 127: 20000, 20032, 20064 and 24064.
 * Source: 2.7 L609-618
 */
#define CK10_TABLE_FLASH_POINTS_ADDRESS 0x4E20u
#define CK10_TABLE_FLASH_POINTS_WORDS 32u
#define CK10_TABLE_FLASH_POINTS_STRIDE 32u
#define CK10_TABLE_FLASH_POINTS_COUNT 128u
#define CK10_TABLE_FLASH_POINTS_FIRST 0u

/* ---- Values that stand for a state ---- */

#define CK10_POINT_COMMAND_ABSENT_IGNORED 65535u /**< point.command: ignored. The point has no command. */

#define CK10_POINT_JUMP_POINT_ABSENT_IGNORED 65535u /**< point.jump_point: ignored. The point table ends here. */

#define CK10_POINT_JUMP_POINT_OF_INPUT_0_ABSENT_IGNORED 65535u /**< point.jump_point_of_input_0: ignored. The input makes no jump. */

#define CK10_POINT_JUMP_POINT_OF_INPUT_1_ABSENT_IGNORED 65535u /**< point.jump_point_of_input_1: ignored. The input makes no jump. */

#define CK10_POINT_JUMP_POINT_OF_INPUT_2_ABSENT_IGNORED 65535u /**< point.jump_point_of_input_2: ignored. The input makes no jump. */

#define CK10_POINT_CLEAR_LOOP_COUNTER_OF_ABSENT_IGNORED 65535u /**< point.clear_loop_counter_of: ignored. No loop counter is cleared. */

#define CK10_POINT_PUSH_MODE_ABSENT_STOP_MODE 0u /**< point.push_mode: stop_mode. The motor stops at the workpiece. */

#endif
