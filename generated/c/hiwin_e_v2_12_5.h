/*
 * E1/E2 PROFINET (HIWIN), version 2.12.5
 * From: E series drives, PROFINET communication, command manual MD02UC01-2507_V1.7
 * Identity: 7ecec5e2d7d7950c
 *
 * Generated; do not edit. For C99 and later and C++98 to C++20, hosted or freestanding, with any byte order, any alignment and an
 * int of 16 bits or more. Headers from this generator compile without warnings with gcc and clang, and pass cppcheck. Their
 * self-tests pass on x86-64, AArch64, m68k (big-endian; int of 32 and 16 bits) and Cortex-M0, and under sanitizers; their fuzz
 * targets find nothing.
 *
 * Define before you include it:
 *   HIWIN_E_WITH_TEXTS adds the texts of codes, which take memory
 *   HIWIN_E_WITHOUT_DOUBLE leaves out the conversions, which need double
 */
#include "hiwin_e_v2_12_5_constants.h"
#ifndef HIWIN_E_INCLUDED
#define HIWIN_E_INCLUDED

/* ---- Compilers and machines ---- */

#ifdef __GNUC__
/** A call would take more code than the function itself, even with -Os. */
#define HIWIN_E_INLINE static inline __attribute__((always_inline))
#define HIWIN_E_LIKELY(test) __builtin_expect(!!(test), 1)
/** Built-in functions need no string.h, and no call for a few bytes, also in freestanding code. */
#define HIWIN_E_COPY(to, from, size) __builtin_memcpy((to), (from), (size))
#define HIWIN_E_CLEAR(to, size) __builtin_memset((to), 0, (size))
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__ && \
    (defined(__x86_64__) || defined(__i386__) || defined(__aarch64__) || defined(__ARM_FEATURE_UNALIGNED))
/**
 * Store a number with one instruction. Compilers merge loads of single bytes by themselves, and mostly stores
 * too. Where they may reorder stores, they build vectors instead, which take up to four times as long.
 */
#define HIWIN_E_STORES_AT_ONCE
#endif
#else
#include <string.h>
#define HIWIN_E_INLINE static inline
#define HIWIN_E_LIKELY(test) (test)
#define HIWIN_E_COPY(to, from, size) memcpy((to), (from), (size))
#define HIWIN_E_CLEAR(to, size) memset((to), 0, (size))
#endif

/* ---- Results of codec calls ---- */

/** The result of a codec call. */
typedef enum hiwin_e_codec_status {
    HIWIN_E_OK = 0, /**< No error. */
    HIWIN_E_ERR_INCOMPLETE = 1, /**< There are too few bytes. */
    HIWIN_E_ERR_WRONG_LENGTH = 2, /**< The number of bytes or elements is wrong. */
    HIWIN_E_ERR_WRONG_MARK = 3, /**< A delimiter of the frame is missing or wrong. */
    HIWIN_E_ERR_NOT_HEX = 4, /**< A character is not a hexadecimal digit. */
    HIWIN_E_ERR_WRONG_CHECKSUM = 5, /**< The checksum does not match. */
    HIWIN_E_ERR_UNKNOWN_CODE = 6, /**< No message has this code. */
    HIWIN_E_ERR_UNKNOWN_VALUE = 7, /**< The value is not a member of its enum, or the text is not ASCII. */
    HIWIN_E_ERR_WRONG_CONST = 8, /**< A constant field has another value. */
    HIWIN_E_ERR_WRONG_MEASURE = 9, /**< A length or count field does not match the data. */
    HIWIN_E_ERR_OUT_OF_RANGE = 10, /**< A value is out of range. */
    HIWIN_E_ERR_CAPACITY = 11 /**< The buffer is too small. */
} hiwin_e_codec_status;

/* ---- Numbers and characters ---- */

HIWIN_E_INLINE uint8_t hiwin_e_load_u8(const uint8_t *in)
{
    return in[0];
}

HIWIN_E_INLINE void hiwin_e_store_u8(uint8_t *out, uint8_t value)
{
    out[0] = value;
}

HIWIN_E_INLINE uint16_t hiwin_e_load_u16_be(const uint8_t *in)
{
    return (uint16_t)(((uint32_t)in[0] << 8) | (uint32_t)in[1]);
}

HIWIN_E_INLINE void hiwin_e_store_u16_be(uint8_t *out, uint16_t value)
{
#ifdef HIWIN_E_STORES_AT_ONCE
    value = __builtin_bswap16(value);
    HIWIN_E_COPY(out, &value, sizeof value);
#else
    out[0] = (uint8_t)(value >> 8);
    out[1] = (uint8_t)value;
#endif
}

HIWIN_E_INLINE uint32_t hiwin_e_load_u32_be(const uint8_t *in)
{
    return ((uint32_t)in[0] << 24) | ((uint32_t)in[1] << 16) |
           ((uint32_t)in[2] << 8) | (uint32_t)in[3];
}

HIWIN_E_INLINE void hiwin_e_store_u32_be(uint8_t *out, uint32_t value)
{
#ifdef HIWIN_E_STORES_AT_ONCE
    value = __builtin_bswap32(value);
    HIWIN_E_COPY(out, &value, sizeof value);
#else
    out[0] = (uint8_t)(value >> 24);
    out[1] = (uint8_t)(value >> 16);
    out[2] = (uint8_t)(value >> 8);
    out[3] = (uint8_t)value;
#endif
}

HIWIN_E_INLINE int8_t hiwin_e_signed_8(uint8_t raw)
{
    return (int8_t)((raw & 0x80u) ? -(int32_t)(uint8_t)~raw - 1 : (int32_t)raw);
}

HIWIN_E_INLINE int16_t hiwin_e_signed_16(uint16_t raw)
{
    return (int16_t)((raw & 0x8000u) ? -(int32_t)(uint16_t)~raw - 1 : (int32_t)raw);
}

HIWIN_E_INLINE int32_t hiwin_e_signed_32(uint32_t raw)
{
    return (int32_t)((raw & 0x80000000u) ? -(int32_t)(uint32_t)~raw - 1 : (int32_t)raw);
}

HIWIN_E_INLINE int64_t hiwin_e_signed_64(uint64_t raw)
{
    return (int64_t)((raw & UINT64_C(0x8000000000000000)) ? -(int64_t)(uint64_t)~raw - 1 : (int64_t)raw);
}

HIWIN_E_INLINE float hiwin_e_float_of(uint32_t bits)
{
    float value;
    HIWIN_E_COPY(&value, &bits, sizeof value);
    return value;
}

HIWIN_E_INLINE uint32_t hiwin_e_bits_of(float value)
{
    uint32_t bits;
    HIWIN_E_COPY(&bits, &value, sizeof bits);
    return bits;
}

/* ---- Enums and codes ---- */

/** Whether a value is one of hiwin_e_parameter_format. */
static inline bool hiwin_e_parameter_format_known(int64_t value)
{
    if (value >= INT64_C(1) && value <= INT64_C(8)) {
        return true;
    }
    return HIWIN_E_LIKELY(value >= INT64_C(65) && value <= INT64_C(68));
}

/** Whether a value is one of hiwin_e_motor_type. */
static inline bool hiwin_e_motor_type_known(int64_t value)
{
    return HIWIN_E_LIKELY(value >= INT64_C(0) && value <= INT64_C(2));
}

/** Whether a value is one of hiwin_e_gantry_application_mode. */
static inline bool hiwin_e_gantry_application_mode_known(int64_t value)
{
    if (value >= INT64_C(1) && value <= INT64_C(2)) {
        return true;
    }
    return HIWIN_E_LIKELY(value == INT64_C(11));
}

/** Whether a value is one of hiwin_e_gantry_parameter_command. */
static inline bool hiwin_e_gantry_parameter_command_known(int64_t value)
{
    return HIWIN_E_LIKELY(value >= INT64_C(0) && value <= INT64_C(3));
}

/** Whether a value is one of hiwin_e_gantry_parameter_status. */
static inline bool hiwin_e_gantry_parameter_status_known(int64_t value)
{
    return HIWIN_E_LIKELY(value >= (-INT64_C(6)) && value <= INT64_C(2));
}

/** Whether a value is one of hiwin_e_absolute_encoder_initialization. */
static inline bool hiwin_e_absolute_encoder_initialization_known(int64_t value)
{
    if (value >= INT64_C(0) && value <= INT64_C(2)) {
        return true;
    }
    if (value == INT64_C(4)) {
        return true;
    }
    if (value == INT64_C(16)) {
        return true;
    }
    return HIWIN_E_LIKELY(value == INT64_C(32));
}

/** Whether a value is one of hiwin_e_drive_reset. */
static inline bool hiwin_e_drive_reset_known(int64_t value)
{
    return HIWIN_E_LIKELY(value >= (-INT64_C(1)) && value <= INT64_C(2));
}

/** Whether a value is one of hiwin_e_parameter_save. */
static inline bool hiwin_e_parameter_save_known(int64_t value)
{
    return HIWIN_E_LIKELY(value >= INT64_C(0) && value <= INT64_C(1));
}

/** Whether a value is one of hiwin_e_mastership. */
static inline bool hiwin_e_mastership_known(int64_t value)
{
    return HIWIN_E_LIKELY(value >= INT64_C(0) && value <= INT64_C(1));
}

/** Whether a value is one of hiwin_e_operating_mode. */
static inline bool hiwin_e_operating_mode_known(int64_t value)
{
    return HIWIN_E_LIKELY(value >= INT64_C(1) && value <= INT64_C(3));
}

/** Whether a value is one of hiwin_e_coast_stop_method. */
static inline bool hiwin_e_coast_stop_method_known(int64_t value)
{
    return HIWIN_E_LIKELY(value >= INT64_C(0) && value <= INT64_C(2));
}

/** Whether a value is one of hiwin_e_positioning_path. */
static inline bool hiwin_e_positioning_path_known(int64_t value)
{
    return HIWIN_E_LIKELY(value >= INT64_C(0) && value <= INT64_C(3));
}

/* ---- Bit fields ---- */

static inline bool hiwin_e_digital_output_control_output_1(uint16_t word)
{
    return (word & HIWIN_E_DIGITAL_OUTPUT_CONTROL_OUTPUT_1_MASK) != 0;
}

static inline bool hiwin_e_digital_output_control_output_2(uint16_t word)
{
    return (word & HIWIN_E_DIGITAL_OUTPUT_CONTROL_OUTPUT_2_MASK) != 0;
}

static inline bool hiwin_e_digital_output_control_output_3(uint16_t word)
{
    return (word & HIWIN_E_DIGITAL_OUTPUT_CONTROL_OUTPUT_3_MASK) != 0;
}

static inline bool hiwin_e_digital_output_control_output_4(uint16_t word)
{
    return (word & HIWIN_E_DIGITAL_OUTPUT_CONTROL_OUTPUT_4_MASK) != 0;
}

static inline bool hiwin_e_digital_output_control_output_5(uint16_t word)
{
    return (word & HIWIN_E_DIGITAL_OUTPUT_CONTROL_OUTPUT_5_MASK) != 0;
}

static inline bool hiwin_e_digital_output_states_output_1(uint16_t word)
{
    return (word & HIWIN_E_DIGITAL_OUTPUT_STATES_OUTPUT_1_MASK) != 0;
}

static inline bool hiwin_e_digital_output_states_output_2(uint16_t word)
{
    return (word & HIWIN_E_DIGITAL_OUTPUT_STATES_OUTPUT_2_MASK) != 0;
}

static inline bool hiwin_e_digital_output_states_output_3(uint16_t word)
{
    return (word & HIWIN_E_DIGITAL_OUTPUT_STATES_OUTPUT_3_MASK) != 0;
}

static inline bool hiwin_e_digital_output_states_output_4(uint16_t word)
{
    return (word & HIWIN_E_DIGITAL_OUTPUT_STATES_OUTPUT_4_MASK) != 0;
}

static inline bool hiwin_e_digital_output_states_output_5(uint16_t word)
{
    return (word & HIWIN_E_DIGITAL_OUTPUT_STATES_OUTPUT_5_MASK) != 0;
}

static inline bool hiwin_e_software_state_homing(uint16_t word)
{
    return (word & HIWIN_E_SOFTWARE_STATE_HOMING_MASK) != 0;
}

static inline bool hiwin_e_software_state_position_trigger_active(uint16_t word)
{
    return (word & HIWIN_E_SOFTWARE_STATE_POSITION_TRIGGER_ACTIVE_MASK) != 0;
}

static inline bool hiwin_e_software_state_gantry_communicating(uint16_t word)
{
    return (word & HIWIN_E_SOFTWARE_STATE_GANTRY_COMMUNICATING_MASK) != 0;
}

static inline bool hiwin_e_software_state_yaw_motor_energized(uint16_t word)
{
    return (word & HIWIN_E_SOFTWARE_STATE_YAW_MOTOR_ENERGIZED_MASK) != 0;
}

static inline bool hiwin_e_software_state_yaw_alarm(uint16_t word)
{
    return (word & HIWIN_E_SOFTWARE_STATE_YAW_ALARM_MASK) != 0;
}

static inline bool hiwin_e_software_state_gantry_active(uint16_t word)
{
    return (word & HIWIN_E_SOFTWARE_STATE_GANTRY_ACTIVE_MASK) != 0;
}

static inline bool hiwin_e_software_state_yaw_homed(uint16_t word)
{
    return (word & HIWIN_E_SOFTWARE_STATE_YAW_HOMED_MASK) != 0;
}

static inline bool hiwin_e_software_state_yaw_near_home(uint16_t word)
{
    return (word & HIWIN_E_SOFTWARE_STATE_YAW_NEAR_HOME_MASK) != 0;
}

static inline bool hiwin_e_software_state_yaw_calibrated(uint16_t word)
{
    return (word & HIWIN_E_SOFTWARE_STATE_YAW_CALIBRATED_MASK) != 0;
}

static inline bool hiwin_e_software_state_yaw_in_position(uint16_t word)
{
    return (word & HIWIN_E_SOFTWARE_STATE_YAW_IN_POSITION_MASK) != 0;
}

static inline bool hiwin_e_software_state_yaw_ready(uint16_t word)
{
    return (word & HIWIN_E_SOFTWARE_STATE_YAW_READY_MASK) != 0;
}

static inline bool hiwin_e_reference_mark_functions_error_compensation_table(uint16_t word)
{
    return (word & HIWIN_E_REFERENCE_MARK_FUNCTIONS_ERROR_COMPENSATION_TABLE_MASK) != 0;
}

static inline bool hiwin_e_reference_mark_functions_position_trigger(uint16_t word)
{
    return (word & HIWIN_E_REFERENCE_MARK_FUNCTIONS_POSITION_TRIGGER_MASK) != 0;
}

static inline bool hiwin_e_position_trigger_error_mode_without_arrays(uint16_t word)
{
    return (word & HIWIN_E_POSITION_TRIGGER_ERROR_MODE_WITHOUT_ARRAYS_MASK) != 0;
}

static inline bool hiwin_e_position_trigger_error_wrong_array_index(uint16_t word)
{
    return (word & HIWIN_E_POSITION_TRIGGER_ERROR_WRONG_ARRAY_INDEX_MASK) != 0;
}

static inline bool hiwin_e_position_trigger_error_undefined_command(uint16_t word)
{
    return (word & HIWIN_E_POSITION_TRIGGER_ERROR_UNDEFINED_COMMAND_MASK) != 0;
}

static inline bool hiwin_e_position_trigger_error_encoder_not_supported(uint16_t word)
{
    return (word & HIWIN_E_POSITION_TRIGGER_ERROR_ENCODER_NOT_SUPPORTED_MASK) != 0;
}

static inline bool hiwin_e_position_trigger_error_not_homed(uint16_t word)
{
    return (word & HIWIN_E_POSITION_TRIGGER_ERROR_NOT_HOMED_MASK) != 0;
}

static inline bool hiwin_e_position_trigger_error_wrong_parameter(uint16_t word)
{
    return (word & HIWIN_E_POSITION_TRIGGER_ERROR_WRONG_PARAMETER_MASK) != 0;
}

static inline bool hiwin_e_position_trigger_error_end_position_passed(uint16_t word)
{
    return (word & HIWIN_E_POSITION_TRIGGER_ERROR_END_POSITION_PASSED_MASK) != 0;
}

static inline uint16_t hiwin_e_basic_function_switch_1_coast_stop_method(uint16_t word)
{
    return (uint16_t)((word & HIWIN_E_BASIC_FUNCTION_SWITCH_1_COAST_STOP_METHOD_MASK) >> HIWIN_E_BASIC_FUNCTION_SWITCH_1_COAST_STOP_METHOD_SHIFT);
}

static inline uint16_t hiwin_e_basic_function_switch_1_with_coast_stop_method(uint16_t word, uint16_t value)
{
    return (uint16_t)((word & (uint16_t)~HIWIN_E_BASIC_FUNCTION_SWITCH_1_COAST_STOP_METHOD_MASK) | ((uint16_t)(value << HIWIN_E_BASIC_FUNCTION_SWITCH_1_COAST_STOP_METHOD_SHIFT) & HIWIN_E_BASIC_FUNCTION_SWITCH_1_COAST_STOP_METHOD_MASK));
}

static inline bool hiwin_e_drive_warnings_1_position_deviation_too_large(uint16_t word)
{
    return (word & HIWIN_E_DRIVE_WARNINGS_1_POSITION_DEVIATION_TOO_LARGE_MASK) != 0;
}

static inline bool hiwin_e_drive_warnings_1_overload(uint16_t word)
{
    return (word & HIWIN_E_DRIVE_WARNINGS_1_OVERLOAD_MASK) != 0;
}

static inline bool hiwin_e_drive_warnings_1_internal_fan_stopped(uint16_t word)
{
    return (word & HIWIN_E_DRIVE_WARNINGS_1_INTERNAL_FAN_STOPPED_MASK) != 0;
}

static inline bool hiwin_e_drive_warnings_1_encoder_battery_fault(uint16_t word)
{
    return (word & HIWIN_E_DRIVE_WARNINGS_1_ENCODER_BATTERY_FAULT_MASK) != 0;
}

static inline bool hiwin_e_drive_warnings_1_restart_required(uint16_t word)
{
    return (word & HIWIN_E_DRIVE_WARNINGS_1_RESTART_REQUIRED_MASK) != 0;
}

static inline bool hiwin_e_drive_warnings_1_undervoltage(uint16_t word)
{
    return (word & HIWIN_E_DRIVE_WARNINGS_1_UNDERVOLTAGE_MASK) != 0;
}

static inline bool hiwin_e_drive_warnings_1_overtravel_servo_on(uint16_t word)
{
    return (word & HIWIN_E_DRIVE_WARNINGS_1_OVERTRAVEL_SERVO_ON_MASK) != 0;
}

static inline bool hiwin_e_drive_warnings_1_positive_overtravel_servo_off(uint16_t word)
{
    return (word & HIWIN_E_DRIVE_WARNINGS_1_POSITIVE_OVERTRAVEL_SERVO_OFF_MASK) != 0;
}

static inline bool hiwin_e_drive_warnings_1_negative_overtravel_servo_off(uint16_t word)
{
    return (word & HIWIN_E_DRIVE_WARNINGS_1_NEGATIVE_OVERTRAVEL_SERVO_OFF_MASK) != 0;
}

static inline bool hiwin_e_drive_warnings_2_overvoltage(uint16_t word)
{
    return (word & HIWIN_E_DRIVE_WARNINGS_2_OVERVOLTAGE_MASK) != 0;
}

static inline bool hiwin_e_drive_warnings_2_fieldbus_synchronization_time(uint16_t word)
{
    return (word & HIWIN_E_DRIVE_WARNINGS_2_FIELDBUS_SYNCHRONIZATION_TIME_MASK) != 0;
}

static inline bool hiwin_e_drive_warnings_2_system_warning(uint16_t word)
{
    return (word & HIWIN_E_DRIVE_WARNINGS_2_SYSTEM_WARNING_MASK) != 0;
}

static inline bool hiwin_e_drive_warnings_2_torque_limit(uint16_t word)
{
    return (word & HIWIN_E_DRIVE_WARNINGS_2_TORQUE_LIMIT_MASK) != 0;
}

static inline bool hiwin_e_drive_warnings_2_encoder_communication(uint16_t word)
{
    return (word & HIWIN_E_DRIVE_WARNINGS_2_ENCODER_COMMUNICATION_MASK) != 0;
}

static inline bool hiwin_e_drive_warnings_2_multi_station_function_disabled(uint16_t word)
{
    return (word & HIWIN_E_DRIVE_WARNINGS_2_MULTI_STATION_FUNCTION_DISABLED_MASK) != 0;
}

static inline bool hiwin_e_drive_warnings_2_i2t(uint16_t word)
{
    return (word & HIWIN_E_DRIVE_WARNINGS_2_I2T_MASK) != 0;
}

static inline bool hiwin_e_operation_warnings_relative_move_rejected(uint32_t word)
{
    return (word & HIWIN_E_OPERATION_WARNINGS_RELATIVE_MOVE_REJECTED_MASK) != 0;
}

static inline bool hiwin_e_operation_warnings_absolute_move_rejected(uint32_t word)
{
    return (word & HIWIN_E_OPERATION_WARNINGS_ABSOLUTE_MOVE_REJECTED_MASK) != 0;
}

static inline bool hiwin_e_operation_warnings_lower_limit_positive(uint32_t word)
{
    return (word & HIWIN_E_OPERATION_WARNINGS_LOWER_LIMIT_POSITIVE_MASK) != 0;
}

static inline bool hiwin_e_operation_warnings_upper_limit_negative(uint32_t word)
{
    return (word & HIWIN_E_OPERATION_WARNINGS_UPPER_LIMIT_NEGATIVE_MASK) != 0;
}

static inline bool hiwin_e_operation_warnings_range_too_large(uint32_t word)
{
    return (word & HIWIN_E_OPERATION_WARNINGS_RANGE_TOO_LARGE_MASK) != 0;
}

static inline bool hiwin_e_operation_warnings_range_locked(uint32_t word)
{
    return (word & HIWIN_E_OPERATION_WARNINGS_RANGE_LOCKED_MASK) != 0;
}

static inline bool hiwin_e_control_word_1_on(uint16_t word)
{
    return (word & HIWIN_E_CONTROL_WORD_1_ON_MASK) != 0;
}

static inline bool hiwin_e_control_word_1_no_off2(uint16_t word)
{
    return (word & HIWIN_E_CONTROL_WORD_1_NO_OFF2_MASK) != 0;
}

static inline bool hiwin_e_control_word_1_no_off3(uint16_t word)
{
    return (word & HIWIN_E_CONTROL_WORD_1_NO_OFF3_MASK) != 0;
}

static inline bool hiwin_e_control_word_1_enable_operation(uint16_t word)
{
    return (word & HIWIN_E_CONTROL_WORD_1_ENABLE_OPERATION_MASK) != 0;
}

static inline bool hiwin_e_control_word_1_acknowledge_alarm(uint16_t word)
{
    return (word & HIWIN_E_CONTROL_WORD_1_ACKNOWLEDGE_ALARM_MASK) != 0;
}

static inline bool hiwin_e_control_word_1_control_by_plc(uint16_t word)
{
    return (word & HIWIN_E_CONTROL_WORD_1_CONTROL_BY_PLC_MASK) != 0;
}

static inline bool hiwin_e_control_word_1_positioning_on(uint16_t word)
{
    return (word & HIWIN_E_CONTROL_WORD_1_POSITIONING_ON_MASK) != 0;
}

static inline bool hiwin_e_control_word_1_positioning_no_off2(uint16_t word)
{
    return (word & HIWIN_E_CONTROL_WORD_1_POSITIONING_NO_OFF2_MASK) != 0;
}

static inline bool hiwin_e_control_word_1_positioning_no_off3(uint16_t word)
{
    return (word & HIWIN_E_CONTROL_WORD_1_POSITIONING_NO_OFF3_MASK) != 0;
}

static inline bool hiwin_e_control_word_1_positioning_enable_operation(uint16_t word)
{
    return (word & HIWIN_E_CONTROL_WORD_1_POSITIONING_ENABLE_OPERATION_MASK) != 0;
}

static inline bool hiwin_e_control_word_1_positioning_enable_traversing_task(uint16_t word)
{
    return (word & HIWIN_E_CONTROL_WORD_1_POSITIONING_ENABLE_TRAVERSING_TASK_MASK) != 0;
}

static inline bool hiwin_e_control_word_1_positioning_no_intermediate_stop(uint16_t word)
{
    return (word & HIWIN_E_CONTROL_WORD_1_POSITIONING_NO_INTERMEDIATE_STOP_MASK) != 0;
}

static inline bool hiwin_e_control_word_1_positioning_start_traversing_task(uint16_t word)
{
    return (word & HIWIN_E_CONTROL_WORD_1_POSITIONING_START_TRAVERSING_TASK_MASK) != 0;
}

static inline bool hiwin_e_control_word_1_positioning_acknowledge_alarm(uint16_t word)
{
    return (word & HIWIN_E_CONTROL_WORD_1_POSITIONING_ACKNOWLEDGE_ALARM_MASK) != 0;
}

static inline bool hiwin_e_control_word_1_positioning_jog_1(uint16_t word)
{
    return (word & HIWIN_E_CONTROL_WORD_1_POSITIONING_JOG_1_MASK) != 0;
}

static inline bool hiwin_e_control_word_1_positioning_jog_2(uint16_t word)
{
    return (word & HIWIN_E_CONTROL_WORD_1_POSITIONING_JOG_2_MASK) != 0;
}

static inline bool hiwin_e_control_word_1_positioning_control_by_plc(uint16_t word)
{
    return (word & HIWIN_E_CONTROL_WORD_1_POSITIONING_CONTROL_BY_PLC_MASK) != 0;
}

static inline bool hiwin_e_control_word_1_positioning_start_homing(uint16_t word)
{
    return (word & HIWIN_E_CONTROL_WORD_1_POSITIONING_START_HOMING_MASK) != 0;
}

static inline uint16_t hiwin_e_control_word_2_sign_of_life(uint16_t word)
{
    return (uint16_t)((word & HIWIN_E_CONTROL_WORD_2_SIGN_OF_LIFE_MASK) >> HIWIN_E_CONTROL_WORD_2_SIGN_OF_LIFE_SHIFT);
}

static inline uint16_t hiwin_e_control_word_2_with_sign_of_life(uint16_t word, uint16_t value)
{
    return (uint16_t)((word & (uint16_t)~HIWIN_E_CONTROL_WORD_2_SIGN_OF_LIFE_MASK) | ((uint16_t)(value << HIWIN_E_CONTROL_WORD_2_SIGN_OF_LIFE_SHIFT) & HIWIN_E_CONTROL_WORD_2_SIGN_OF_LIFE_MASK));
}

static inline bool hiwin_e_control_word_2_fixed_stop_traverse_to_fixed_stop(uint16_t word)
{
    return (word & HIWIN_E_CONTROL_WORD_2_FIXED_STOP_TRAVERSE_TO_FIXED_STOP_MASK) != 0;
}

static inline uint16_t hiwin_e_control_word_2_fixed_stop_sign_of_life(uint16_t word)
{
    return (uint16_t)((word & HIWIN_E_CONTROL_WORD_2_FIXED_STOP_SIGN_OF_LIFE_MASK) >> HIWIN_E_CONTROL_WORD_2_FIXED_STOP_SIGN_OF_LIFE_SHIFT);
}

static inline uint16_t hiwin_e_control_word_2_fixed_stop_with_sign_of_life(uint16_t word, uint16_t value)
{
    return (uint16_t)((word & (uint16_t)~HIWIN_E_CONTROL_WORD_2_FIXED_STOP_SIGN_OF_LIFE_MASK) | ((uint16_t)(value << HIWIN_E_CONTROL_WORD_2_FIXED_STOP_SIGN_OF_LIFE_SHIFT) & HIWIN_E_CONTROL_WORD_2_FIXED_STOP_SIGN_OF_LIFE_MASK));
}

static inline bool hiwin_e_status_word_1_ready_to_switch_on(uint16_t word)
{
    return (word & HIWIN_E_STATUS_WORD_1_READY_TO_SWITCH_ON_MASK) != 0;
}

static inline bool hiwin_e_status_word_1_ready_to_operate(uint16_t word)
{
    return (word & HIWIN_E_STATUS_WORD_1_READY_TO_OPERATE_MASK) != 0;
}

static inline bool hiwin_e_status_word_1_operation_enabled(uint16_t word)
{
    return (word & HIWIN_E_STATUS_WORD_1_OPERATION_ENABLED_MASK) != 0;
}

static inline bool hiwin_e_status_word_1_alarm(uint16_t word)
{
    return (word & HIWIN_E_STATUS_WORD_1_ALARM_MASK) != 0;
}

static inline bool hiwin_e_status_word_1_no_off2(uint16_t word)
{
    return (word & HIWIN_E_STATUS_WORD_1_NO_OFF2_MASK) != 0;
}

static inline bool hiwin_e_status_word_1_no_off3(uint16_t word)
{
    return (word & HIWIN_E_STATUS_WORD_1_NO_OFF3_MASK) != 0;
}

static inline bool hiwin_e_status_word_1_switching_on_inhibited(uint16_t word)
{
    return (word & HIWIN_E_STATUS_WORD_1_SWITCHING_ON_INHIBITED_MASK) != 0;
}

static inline bool hiwin_e_status_word_1_warning(uint16_t word)
{
    return (word & HIWIN_E_STATUS_WORD_1_WARNING_MASK) != 0;
}

static inline bool hiwin_e_status_word_1_speed_within_tolerance(uint16_t word)
{
    return (word & HIWIN_E_STATUS_WORD_1_SPEED_WITHIN_TOLERANCE_MASK) != 0;
}

static inline bool hiwin_e_status_word_1_control_requested(uint16_t word)
{
    return (word & HIWIN_E_STATUS_WORD_1_CONTROL_REQUESTED_MASK) != 0;
}

static inline bool hiwin_e_status_word_1_speed_reached(uint16_t word)
{
    return (word & HIWIN_E_STATUS_WORD_1_SPEED_REACHED_MASK) != 0;
}
/** The first state, in the order above, whose bits match the word. */
static inline hiwin_e_status_word_1_state hiwin_e_status_word_1_state_of(uint16_t word)
{
    if ((word & HIWIN_E_STATUS_WORD_1_STATE_SWITCHING_ON_INHIBITED_MASK) == HIWIN_E_STATUS_WORD_1_STATE_SWITCHING_ON_INHIBITED_VALUE) {
        return HIWIN_E_STATUS_WORD_1_STATE_SWITCHING_ON_INHIBITED;
    }
    if ((word & HIWIN_E_STATUS_WORD_1_STATE_READY_FOR_SWITCHING_ON_MASK) == HIWIN_E_STATUS_WORD_1_STATE_READY_FOR_SWITCHING_ON_VALUE) {
        return HIWIN_E_STATUS_WORD_1_STATE_READY_FOR_SWITCHING_ON;
    }
    if ((word & HIWIN_E_STATUS_WORD_1_STATE_SWITCHED_ON_MASK) == HIWIN_E_STATUS_WORD_1_STATE_SWITCHED_ON_VALUE) {
        return HIWIN_E_STATUS_WORD_1_STATE_SWITCHED_ON;
    }
    if ((word & HIWIN_E_STATUS_WORD_1_STATE_OPERATION_MASK) == HIWIN_E_STATUS_WORD_1_STATE_OPERATION_VALUE) {
        return HIWIN_E_STATUS_WORD_1_STATE_OPERATION;
    }
    return HIWIN_E_STATUS_WORD_1_NO_STATE;
}

static inline bool hiwin_e_status_word_1_positioning_ready_to_switch_on(uint16_t word)
{
    return (word & HIWIN_E_STATUS_WORD_1_POSITIONING_READY_TO_SWITCH_ON_MASK) != 0;
}

static inline bool hiwin_e_status_word_1_positioning_ready_to_operate(uint16_t word)
{
    return (word & HIWIN_E_STATUS_WORD_1_POSITIONING_READY_TO_OPERATE_MASK) != 0;
}

static inline bool hiwin_e_status_word_1_positioning_operation_enabled(uint16_t word)
{
    return (word & HIWIN_E_STATUS_WORD_1_POSITIONING_OPERATION_ENABLED_MASK) != 0;
}

static inline bool hiwin_e_status_word_1_positioning_alarm(uint16_t word)
{
    return (word & HIWIN_E_STATUS_WORD_1_POSITIONING_ALARM_MASK) != 0;
}

static inline bool hiwin_e_status_word_1_positioning_no_off2(uint16_t word)
{
    return (word & HIWIN_E_STATUS_WORD_1_POSITIONING_NO_OFF2_MASK) != 0;
}

static inline bool hiwin_e_status_word_1_positioning_no_off3(uint16_t word)
{
    return (word & HIWIN_E_STATUS_WORD_1_POSITIONING_NO_OFF3_MASK) != 0;
}

static inline bool hiwin_e_status_word_1_positioning_switching_on_inhibited(uint16_t word)
{
    return (word & HIWIN_E_STATUS_WORD_1_POSITIONING_SWITCHING_ON_INHIBITED_MASK) != 0;
}

static inline bool hiwin_e_status_word_1_positioning_warning(uint16_t word)
{
    return (word & HIWIN_E_STATUS_WORD_1_POSITIONING_WARNING_MASK) != 0;
}

static inline bool hiwin_e_status_word_1_positioning_position_within_tolerance(uint16_t word)
{
    return (word & HIWIN_E_STATUS_WORD_1_POSITIONING_POSITION_WITHIN_TOLERANCE_MASK) != 0;
}

static inline bool hiwin_e_status_word_1_positioning_control_requested(uint16_t word)
{
    return (word & HIWIN_E_STATUS_WORD_1_POSITIONING_CONTROL_REQUESTED_MASK) != 0;
}

static inline bool hiwin_e_status_word_1_positioning_target_reached(uint16_t word)
{
    return (word & HIWIN_E_STATUS_WORD_1_POSITIONING_TARGET_REACHED_MASK) != 0;
}

static inline bool hiwin_e_status_word_1_positioning_homing_complete(uint16_t word)
{
    return (word & HIWIN_E_STATUS_WORD_1_POSITIONING_HOMING_COMPLETE_MASK) != 0;
}

static inline bool hiwin_e_status_word_1_positioning_traversing_task_acknowledged(uint16_t word)
{
    return (word & HIWIN_E_STATUS_WORD_1_POSITIONING_TRAVERSING_TASK_ACKNOWLEDGED_MASK) != 0;
}

static inline bool hiwin_e_status_word_1_positioning_motor_stopped(uint16_t word)
{
    return (word & HIWIN_E_STATUS_WORD_1_POSITIONING_MOTOR_STOPPED_MASK) != 0;
}
/** The first state, in the order above, whose bits match the word. */
static inline hiwin_e_status_word_1_positioning_state hiwin_e_status_word_1_positioning_state_of(uint16_t word)
{
    if ((word & HIWIN_E_STATUS_WORD_1_POSITIONING_STATE_SWITCHING_ON_INHIBITED_MASK) == HIWIN_E_STATUS_WORD_1_POSITIONING_STATE_SWITCHING_ON_INHIBITED_VALUE) {
        return HIWIN_E_STATUS_WORD_1_POSITIONING_STATE_SWITCHING_ON_INHIBITED;
    }
    if ((word & HIWIN_E_STATUS_WORD_1_POSITIONING_STATE_READY_FOR_SWITCHING_ON_MASK) == HIWIN_E_STATUS_WORD_1_POSITIONING_STATE_READY_FOR_SWITCHING_ON_VALUE) {
        return HIWIN_E_STATUS_WORD_1_POSITIONING_STATE_READY_FOR_SWITCHING_ON;
    }
    if ((word & HIWIN_E_STATUS_WORD_1_POSITIONING_STATE_SWITCHED_ON_MASK) == HIWIN_E_STATUS_WORD_1_POSITIONING_STATE_SWITCHED_ON_VALUE) {
        return HIWIN_E_STATUS_WORD_1_POSITIONING_STATE_SWITCHED_ON;
    }
    if ((word & HIWIN_E_STATUS_WORD_1_POSITIONING_STATE_OPERATION_MASK) == HIWIN_E_STATUS_WORD_1_POSITIONING_STATE_OPERATION_VALUE) {
        return HIWIN_E_STATUS_WORD_1_POSITIONING_STATE_OPERATION;
    }
    return HIWIN_E_STATUS_WORD_1_POSITIONING_NO_STATE;
}

static inline uint16_t hiwin_e_status_word_2_sign_of_life(uint16_t word)
{
    return (uint16_t)((word & HIWIN_E_STATUS_WORD_2_SIGN_OF_LIFE_MASK) >> HIWIN_E_STATUS_WORD_2_SIGN_OF_LIFE_SHIFT);
}

static inline uint16_t hiwin_e_status_word_2_with_sign_of_life(uint16_t word, uint16_t value)
{
    return (uint16_t)((word & (uint16_t)~HIWIN_E_STATUS_WORD_2_SIGN_OF_LIFE_MASK) | ((uint16_t)(value << HIWIN_E_STATUS_WORD_2_SIGN_OF_LIFE_SHIFT) & HIWIN_E_STATUS_WORD_2_SIGN_OF_LIFE_MASK));
}

static inline bool hiwin_e_status_word_2_pulse_command_pulses_enabled(uint16_t word)
{
    return (word & HIWIN_E_STATUS_WORD_2_PULSE_COMMAND_PULSES_ENABLED_MASK) != 0;
}

static inline uint16_t hiwin_e_status_word_2_pulse_command_sign_of_life(uint16_t word)
{
    return (uint16_t)((word & HIWIN_E_STATUS_WORD_2_PULSE_COMMAND_SIGN_OF_LIFE_MASK) >> HIWIN_E_STATUS_WORD_2_PULSE_COMMAND_SIGN_OF_LIFE_SHIFT);
}

static inline uint16_t hiwin_e_status_word_2_pulse_command_with_sign_of_life(uint16_t word, uint16_t value)
{
    return (uint16_t)((word & (uint16_t)~HIWIN_E_STATUS_WORD_2_PULSE_COMMAND_SIGN_OF_LIFE_MASK) | ((uint16_t)(value << HIWIN_E_STATUS_WORD_2_PULSE_COMMAND_SIGN_OF_LIFE_SHIFT) & HIWIN_E_STATUS_WORD_2_PULSE_COMMAND_SIGN_OF_LIFE_MASK));
}

static inline bool hiwin_e_status_word_2_fixed_stop_traverse_to_fixed_stop_active(uint16_t word)
{
    return (word & HIWIN_E_STATUS_WORD_2_FIXED_STOP_TRAVERSE_TO_FIXED_STOP_ACTIVE_MASK) != 0;
}

static inline uint16_t hiwin_e_status_word_2_fixed_stop_sign_of_life(uint16_t word)
{
    return (uint16_t)((word & HIWIN_E_STATUS_WORD_2_FIXED_STOP_SIGN_OF_LIFE_MASK) >> HIWIN_E_STATUS_WORD_2_FIXED_STOP_SIGN_OF_LIFE_SHIFT);
}

static inline uint16_t hiwin_e_status_word_2_fixed_stop_with_sign_of_life(uint16_t word, uint16_t value)
{
    return (uint16_t)((word & (uint16_t)~HIWIN_E_STATUS_WORD_2_FIXED_STOP_SIGN_OF_LIFE_MASK) | ((uint16_t)(value << HIWIN_E_STATUS_WORD_2_FIXED_STOP_SIGN_OF_LIFE_SHIFT) & HIWIN_E_STATUS_WORD_2_FIXED_STOP_SIGN_OF_LIFE_MASK));
}

static inline bool hiwin_e_status_word_2_positioning_traverse_to_fixed_stop_active(uint16_t word)
{
    return (word & HIWIN_E_STATUS_WORD_2_POSITIONING_TRAVERSE_TO_FIXED_STOP_ACTIVE_MASK) != 0;
}

static inline bool hiwin_e_status_word_2_positioning_pulses_enabled(uint16_t word)
{
    return (word & HIWIN_E_STATUS_WORD_2_POSITIONING_PULSES_ENABLED_MASK) != 0;
}

static inline uint16_t hiwin_e_status_word_2_positioning_sign_of_life(uint16_t word)
{
    return (uint16_t)((word & HIWIN_E_STATUS_WORD_2_POSITIONING_SIGN_OF_LIFE_MASK) >> HIWIN_E_STATUS_WORD_2_POSITIONING_SIGN_OF_LIFE_SHIFT);
}

static inline uint16_t hiwin_e_status_word_2_positioning_with_sign_of_life(uint16_t word, uint16_t value)
{
    return (uint16_t)((word & (uint16_t)~HIWIN_E_STATUS_WORD_2_POSITIONING_SIGN_OF_LIFE_MASK) | ((uint16_t)(value << HIWIN_E_STATUS_WORD_2_POSITIONING_SIGN_OF_LIFE_SHIFT) & HIWIN_E_STATUS_WORD_2_POSITIONING_SIGN_OF_LIFE_MASK));
}

static inline bool hiwin_e_encoder_1_control_word_function_1(uint16_t word)
{
    return (word & HIWIN_E_ENCODER_1_CONTROL_WORD_FUNCTION_1_MASK) != 0;
}

static inline bool hiwin_e_encoder_1_control_word_function_2(uint16_t word)
{
    return (word & HIWIN_E_ENCODER_1_CONTROL_WORD_FUNCTION_2_MASK) != 0;
}

static inline bool hiwin_e_encoder_1_control_word_function_3(uint16_t word)
{
    return (word & HIWIN_E_ENCODER_1_CONTROL_WORD_FUNCTION_3_MASK) != 0;
}

static inline bool hiwin_e_encoder_1_control_word_function_4(uint16_t word)
{
    return (word & HIWIN_E_ENCODER_1_CONTROL_WORD_FUNCTION_4_MASK) != 0;
}

static inline uint16_t hiwin_e_encoder_1_control_word_command(uint16_t word)
{
    return (uint16_t)((word & HIWIN_E_ENCODER_1_CONTROL_WORD_COMMAND_MASK) >> HIWIN_E_ENCODER_1_CONTROL_WORD_COMMAND_SHIFT);
}

static inline uint16_t hiwin_e_encoder_1_control_word_with_command(uint16_t word, uint16_t value)
{
    return (uint16_t)((word & (uint16_t)~HIWIN_E_ENCODER_1_CONTROL_WORD_COMMAND_MASK) | ((uint16_t)(value << HIWIN_E_ENCODER_1_CONTROL_WORD_COMMAND_SHIFT) & HIWIN_E_ENCODER_1_CONTROL_WORD_COMMAND_MASK));
}

static inline bool hiwin_e_encoder_1_control_word_no_reference_mark_search(uint16_t word)
{
    return (word & HIWIN_E_ENCODER_1_CONTROL_WORD_NO_REFERENCE_MARK_SEARCH_MASK) != 0;
}

static inline bool hiwin_e_encoder_1_control_word_parking_sensor(uint16_t word)
{
    return (word & HIWIN_E_ENCODER_1_CONTROL_WORD_PARKING_SENSOR_MASK) != 0;
}

static inline bool hiwin_e_encoder_1_control_word_acknowledge_alarm(uint16_t word)
{
    return (word & HIWIN_E_ENCODER_1_CONTROL_WORD_ACKNOWLEDGE_ALARM_MASK) != 0;
}

static inline bool hiwin_e_encoder_1_status_word_function_1_active(uint16_t word)
{
    return (word & HIWIN_E_ENCODER_1_STATUS_WORD_FUNCTION_1_ACTIVE_MASK) != 0;
}

static inline bool hiwin_e_encoder_1_status_word_function_2_active(uint16_t word)
{
    return (word & HIWIN_E_ENCODER_1_STATUS_WORD_FUNCTION_2_ACTIVE_MASK) != 0;
}

static inline bool hiwin_e_encoder_1_status_word_function_3_active(uint16_t word)
{
    return (word & HIWIN_E_ENCODER_1_STATUS_WORD_FUNCTION_3_ACTIVE_MASK) != 0;
}

static inline bool hiwin_e_encoder_1_status_word_function_4_active(uint16_t word)
{
    return (word & HIWIN_E_ENCODER_1_STATUS_WORD_FUNCTION_4_ACTIVE_MASK) != 0;
}

static inline bool hiwin_e_encoder_1_status_word_value_1_available(uint16_t word)
{
    return (word & HIWIN_E_ENCODER_1_STATUS_WORD_VALUE_1_AVAILABLE_MASK) != 0;
}

static inline bool hiwin_e_encoder_1_status_word_value_2_available(uint16_t word)
{
    return (word & HIWIN_E_ENCODER_1_STATUS_WORD_VALUE_2_AVAILABLE_MASK) != 0;
}

static inline bool hiwin_e_encoder_1_status_word_value_3_available(uint16_t word)
{
    return (word & HIWIN_E_ENCODER_1_STATUS_WORD_VALUE_3_AVAILABLE_MASK) != 0;
}

static inline bool hiwin_e_encoder_1_status_word_value_4_available(uint16_t word)
{
    return (word & HIWIN_E_ENCODER_1_STATUS_WORD_VALUE_4_AVAILABLE_MASK) != 0;
}

static inline bool hiwin_e_encoder_1_status_word_acknowledging_alarm(uint16_t word)
{
    return (word & HIWIN_E_ENCODER_1_STATUS_WORD_ACKNOWLEDGING_ALARM_MASK) != 0;
}

static inline bool hiwin_e_encoder_1_status_word_sensor_parked(uint16_t word)
{
    return (word & HIWIN_E_ENCODER_1_STATUS_WORD_SENSOR_PARKED_MASK) != 0;
}

static inline bool hiwin_e_encoder_1_status_word_alarm(uint16_t word)
{
    return (word & HIWIN_E_ENCODER_1_STATUS_WORD_ALARM_MASK) != 0;
}

static inline bool hiwin_e_block_selection_mdi(uint16_t word)
{
    return (word & HIWIN_E_BLOCK_SELECTION_MDI_MASK) != 0;
}

static inline bool hiwin_e_selected_block_mdi(uint16_t word)
{
    return (word & HIWIN_E_SELECTED_BLOCK_MDI_MASK) != 0;
}

static inline bool hiwin_e_mdi_mode_absolute(uint16_t word)
{
    return (word & HIWIN_E_MDI_MODE_ABSOLUTE_MASK) != 0;
}

static inline bool hiwin_e_positioning_control_word_1_absolute(uint16_t word)
{
    return (word & HIWIN_E_POSITIONING_CONTROL_WORD_1_ABSOLUTE_MASK) != 0;
}

static inline uint16_t hiwin_e_positioning_control_word_1_path(uint16_t word)
{
    return (uint16_t)((word & HIWIN_E_POSITIONING_CONTROL_WORD_1_PATH_MASK) >> HIWIN_E_POSITIONING_CONTROL_WORD_1_PATH_SHIFT);
}

static inline uint16_t hiwin_e_positioning_control_word_1_with_path(uint16_t word, uint16_t value)
{
    return (uint16_t)((word & (uint16_t)~HIWIN_E_POSITIONING_CONTROL_WORD_1_PATH_MASK) | ((uint16_t)(value << HIWIN_E_POSITIONING_CONTROL_WORD_1_PATH_SHIFT) & HIWIN_E_POSITIONING_CONTROL_WORD_1_PATH_MASK));
}

static inline bool hiwin_e_positioning_control_word_1_continuous(uint16_t word)
{
    return (word & HIWIN_E_POSITIONING_CONTROL_WORD_1_CONTINUOUS_MASK) != 0;
}

static inline bool hiwin_e_positioning_control_word_1_mdi_setup(uint16_t word)
{
    return (word & HIWIN_E_POSITIONING_CONTROL_WORD_1_MDI_SETUP_MASK) != 0;
}

static inline bool hiwin_e_positioning_control_word_1_mdi(uint16_t word)
{
    return (word & HIWIN_E_POSITIONING_CONTROL_WORD_1_MDI_MASK) != 0;
}

static inline bool hiwin_e_positioning_control_word_2_set_reference_point(uint16_t word)
{
    return (word & HIWIN_E_POSITIONING_CONTROL_WORD_2_SET_REFERENCE_POINT_MASK) != 0;
}

static inline bool hiwin_e_positioning_control_word_2_jog_incremental(uint16_t word)
{
    return (word & HIWIN_E_POSITIONING_CONTROL_WORD_2_JOG_INCREMENTAL_MASK) != 0;
}

static inline bool hiwin_e_positioning_status_word_1_negative_overtravel(uint16_t word)
{
    return (word & HIWIN_E_POSITIONING_STATUS_WORD_1_NEGATIVE_OVERTRAVEL_MASK) != 0;
}

static inline bool hiwin_e_positioning_status_word_1_positive_overtravel(uint16_t word)
{
    return (word & HIWIN_E_POSITIONING_STATUS_WORD_1_POSITIVE_OVERTRAVEL_MASK) != 0;
}

static inline bool hiwin_e_positioning_status_word_1_jogging(uint16_t word)
{
    return (word & HIWIN_E_POSITIONING_STATUS_WORD_1_JOGGING_MASK) != 0;
}

static inline bool hiwin_e_positioning_status_word_1_homing(uint16_t word)
{
    return (word & HIWIN_E_POSITIONING_STATUS_WORD_1_HOMING_MASK) != 0;
}

static inline bool hiwin_e_positioning_status_word_1_mdi_setup(uint16_t word)
{
    return (word & HIWIN_E_POSITIONING_STATUS_WORD_1_MDI_SETUP_MASK) != 0;
}

static inline bool hiwin_e_positioning_status_word_1_mdi(uint16_t word)
{
    return (word & HIWIN_E_POSITIONING_STATUS_WORD_1_MDI_MASK) != 0;
}

static inline bool hiwin_e_positioning_status_word_2_ready_for_command(uint16_t word)
{
    return (word & HIWIN_E_POSITIONING_STATUS_WORD_2_READY_FOR_COMMAND_MASK) != 0;
}

static inline bool hiwin_e_positioning_status_word_2_moving_forward(uint16_t word)
{
    return (word & HIWIN_E_POSITIONING_STATUS_WORD_2_MOVING_FORWARD_MASK) != 0;
}

static inline bool hiwin_e_positioning_status_word_2_moving_backward(uint16_t word)
{
    return (word & HIWIN_E_POSITIONING_STATUS_WORD_2_MOVING_BACKWARD_MASK) != 0;
}

static inline bool hiwin_e_positioning_status_word_2_fixed_stop_reached(uint16_t word)
{
    return (word & HIWIN_E_POSITIONING_STATUS_WORD_2_FIXED_STOP_REACHED_MASK) != 0;
}

static inline bool hiwin_e_positioning_status_word_2_fixed_stop_torque_reached(uint16_t word)
{
    return (word & HIWIN_E_POSITIONING_STATUS_WORD_2_FIXED_STOP_TORQUE_REACHED_MASK) != 0;
}

static inline bool hiwin_e_positioning_status_word_2_traverse_to_fixed_stop_enabled(uint16_t word)
{
    return (word & HIWIN_E_POSITIONING_STATUS_WORD_2_TRAVERSE_TO_FIXED_STOP_ENABLED_MASK) != 0;
}

static inline bool hiwin_e_positioning_status_word_2_traversing_command_active(uint16_t word)
{
    return (word & HIWIN_E_POSITIONING_STATUS_WORD_2_TRAVERSING_COMMAND_ACTIVE_MASK) != 0;
}

static inline bool hiwin_e_message_word_torque_limit_not_active(uint16_t word)
{
    return (word & HIWIN_E_MESSAGE_WORD_TORQUE_LIMIT_NOT_ACTIVE_MASK) != 0;
}

static inline bool hiwin_e_message_word_no_motor_overload_warning(uint16_t word)
{
    return (word & HIWIN_E_MESSAGE_WORD_NO_MOTOR_OVERLOAD_WARNING_MASK) != 0;
}

static inline bool hiwin_e_message_word_no_i2t_warning(uint16_t word)
{
    return (word & HIWIN_E_MESSAGE_WORD_NO_I2T_WARNING_MASK) != 0;
}

static inline bool hiwin_e_message_word_speed_within_tolerance(uint16_t word)
{
    return (word & HIWIN_E_MESSAGE_WORD_SPEED_WITHIN_TOLERANCE_MASK) != 0;
}

static inline bool hiwin_e_message_word_controlled_by_plc(uint16_t word)
{
    return (word & HIWIN_E_MESSAGE_WORD_CONTROLLED_BY_PLC_MASK) != 0;
}

static inline bool hiwin_e_message_word_drive_ready(uint16_t word)
{
    return (word & HIWIN_E_MESSAGE_WORD_DRIVE_READY_MASK) != 0;
}

static inline bool hiwin_e_message_word_pulses_enabled(uint16_t word)
{
    return (word & HIWIN_E_MESSAGE_WORD_PULSES_ENABLED_MASK) != 0;
}

/* ---- Conversions, which need double ---- */

#ifndef HIWIN_E_WITHOUT_DOUBLE

/**
 * The reference is Pt317 for rotary motors, in rpm, and Pt386 for linear ones, in mm/s.
 * Speed from NSOLL_B = reference * raw / 1073741824.0
 * Printed: speed = NSOLL_B / 40000000h * reference
 * Signals: speed_setpoint_b.
 * Reference: parameters/servo_parameters/reference_speed_rotary,
 * parameters/servo_parameters/reference_speed_linear.
 * Source: 6.1 L1556, 1562; 3.1 L506
 */
static inline double hiwin_e_commanded_speed_from_raw(int32_t raw, double reference)
{
    return reference * ((double)raw / 1073741824.0);
}

/**
 * The count of a quantity, the nearest one, of two equally near ones the even one;
 * refused where it is not in -2147483648..2147483647, and where the reference is 0.
 */
static inline hiwin_e_codec_status hiwin_e_commanded_speed_to_raw(double quantity, double reference, int32_t *raw)
{
    double count, rest;
    int32_t whole;
    if (!(reference < 0.0 || reference > 0.0)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    count = quantity / reference * 1073741824.0;
    if (!(count > -4294967297.0 / 2.0 && count < 4294967295.0 / 2.0)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    whole = (int32_t)count;
    rest = count - (double)whole;
    if (rest > 0.5 || (rest >= 0.5 && whole % 2 != 0)) {
        whole = (int32_t)(whole + 1);
    } else if (rest < -0.5 || (rest <= -0.5 && whole % 2 != 0)) {
        whole = (int32_t)(whole - 1);
    }
    *raw = whole;
    return HIWIN_E_OK;
}

/**
 * The reference is Pt317 for rotary motors, in rpm, and Pt386 for linear ones, in mm/s.
 * Speed from NIST_B = reference * raw / 1073741824.0
 * Printed: NIST_B = speed / reference * 40000000h
 * Signals: speed_actual_b.
 * Reference: parameters/servo_parameters/reference_speed_rotary,
 * parameters/servo_parameters/reference_speed_linear.
 * Source: 6.1 L1560, 1562; 3.1 L506
 */
static inline double hiwin_e_actual_speed_from_raw(int32_t raw, double reference)
{
    return reference * ((double)raw / 1073741824.0);
}

/**
 * The count of a quantity, the nearest one, of two equally near ones the even one;
 * refused where it is not in -2147483648..2147483647, and where the reference is 0.
 */
static inline hiwin_e_codec_status hiwin_e_actual_speed_to_raw(double quantity, double reference, int32_t *raw)
{
    double count, rest;
    int32_t whole;
    if (!(reference < 0.0 || reference > 0.0)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    count = quantity / reference * 1073741824.0;
    if (!(count > -4294967297.0 / 2.0 && count < 4294967295.0 / 2.0)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    whole = (int32_t)count;
    rest = count - (double)whole;
    if (rest > 0.5 || (rest >= 0.5 && whole % 2 != 0)) {
        whole = (int32_t)(whole + 1);
    } else if (rest < -0.5 || (rest <= -0.5 && whole % 2 != 0)) {
        whole = (int32_t)(whole - 1);
    }
    *raw = whole;
    return HIWIN_E_OK;
}

/**
 * The form of 16 bits, which is in no telegram of this drive. The reference is Pt317 for rotary motors, Pt386
 * for linear ones.
 * Speed from NSOLL_A = reference * raw / 16384.0
 * Printed: speed = NSOLL_A / 4000h * reference
 * Reference: parameters/servo_parameters/reference_speed_rotary,
 * parameters/servo_parameters/reference_speed_linear.
 * Source: 6.1 L1554, 1562
 */
static inline double hiwin_e_commanded_speed_a_from_raw(int16_t raw, double reference)
{
    return reference * ((double)raw / 16384.0);
}

/**
 * The count of a quantity, the nearest one, of two equally near ones the even one;
 * refused where it is not in -32768..32767, and where the reference is 0.
 */
static inline hiwin_e_codec_status hiwin_e_commanded_speed_a_to_raw(double quantity, double reference, int16_t *raw)
{
    double count, rest;
    int16_t whole;
    if (!(reference < 0.0 || reference > 0.0)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    count = quantity / reference * 16384.0;
    if (!(count > -65537.0 / 2.0 && count < 65535.0 / 2.0)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    whole = (int16_t)count;
    rest = count - (double)whole;
    if (rest > 0.5 || (rest >= 0.5 && whole % 2 != 0)) {
        whole = (int16_t)(whole + 1);
    } else if (rest < -0.5 || (rest <= -0.5 && whole % 2 != 0)) {
        whole = (int16_t)(whole - 1);
    }
    *raw = whole;
    return HIWIN_E_OK;
}

/**
 * The form of 16 bits, which is in no telegram of this drive. The reference is Pt317 for rotary motors, Pt386
 * for linear ones.
 * Speed from NIST_A = reference * raw / 16384.0
 * Printed: NIST_A = speed / reference * 4000h
 * Reference: parameters/servo_parameters/reference_speed_rotary,
 * parameters/servo_parameters/reference_speed_linear.
 * Source: 6.1 L1558, 1562
 */
static inline double hiwin_e_actual_speed_a_from_raw(int16_t raw, double reference)
{
    return reference * ((double)raw / 16384.0);
}

/**
 * The count of a quantity, the nearest one, of two equally near ones the even one;
 * refused where it is not in -32768..32767, and where the reference is 0.
 */
static inline hiwin_e_codec_status hiwin_e_actual_speed_a_to_raw(double quantity, double reference, int16_t *raw)
{
    double count, rest;
    int16_t whole;
    if (!(reference < 0.0 || reference > 0.0)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    count = quantity / reference * 16384.0;
    if (!(count > -65537.0 / 2.0 && count < 65535.0 / 2.0)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    whole = (int16_t)count;
    rest = count - (double)whole;
    if (rest > 0.5 || (rest >= 0.5 && whole % 2 != 0)) {
        whole = (int16_t)(whole + 1);
    } else if (rest < -0.5 || (rest <= -0.5 && whole % 2 != 0)) {
        whole = (int16_t)(whole - 1);
    }
    *raw = whole;
    return HIWIN_E_OK;
}

/**
 * The reference is Pt42A for rotary motors, a torque in Nm, and Pt43A for linear ones, a force in N.
 * Torque that MOMRED leaves = reference * (1 - raw / 16384.0)
 * Printed: torque = (1 - MOMRED / 4000h) * reference
 * Signals: torque_reduction.
 * Reference: parameters/servo_parameters/reference_torque, parameters/servo_parameters/reference_force.
 * Source: 6.11 L1796, 1810; 3.1 L512
 */
static inline double hiwin_e_output_torque_from_raw(uint16_t raw, double reference)
{
    return reference * (1.0 - (double)raw / 16384.0);
}

/**
 * The count of a quantity, the nearest one, of two equally near ones the even one;
 * refused where it is not in 0..16384, and where the reference is 0.
 */
static inline hiwin_e_codec_status hiwin_e_output_torque_to_raw(double quantity, double reference, uint16_t *raw)
{
    double count, rest;
    uint16_t whole;
    if (!(reference < 0.0 || reference > 0.0)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    count = (1.0 - quantity / reference) * 16384.0;
    if (!(count > -1.0 / 2.0 && count < 32769.0 / 2.0)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    whole = (uint16_t)count;
    rest = count - (double)whole;
    if (rest > 0.5 || (rest >= 0.5 && whole % 2u != 0u)) {
        whole = (uint16_t)(whole + 1u);
    }
    *raw = whole;
    return HIWIN_E_OK;
}

/**
 * The reference is Pt42A for rotary motors, a torque in Nm, and Pt43A for linear ones, a force in N.
 * Torque that MOMRED takes away = reference * raw / 16384.0
 * Printed: reduction = MOMRED / 4000h * reference
 * Signals: torque_reduction.
 * Reference: parameters/servo_parameters/reference_torque, parameters/servo_parameters/reference_force.
 * Source: 6.11 L1794, 1810; 3.1 L512
 */
static inline double hiwin_e_torque_reduced_by_from_raw(uint16_t raw, double reference)
{
    return reference * ((double)raw / 16384.0);
}

/**
 * The count of a quantity, the nearest one, of two equally near ones the even one;
 * refused where it is not in 0..16384, and where the reference is 0.
 */
static inline hiwin_e_codec_status hiwin_e_torque_reduced_by_to_raw(double quantity, double reference, uint16_t *raw)
{
    double count, rest;
    uint16_t whole;
    if (!(reference < 0.0 || reference > 0.0)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    count = quantity / reference * 16384.0;
    if (!(count > -1.0 / 2.0 && count < 32769.0 / 2.0)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    whole = (uint16_t)count;
    rest = count - (double)whole;
    if (rest > 0.5 || (rest >= 0.5 && whole % 2u != 0u)) {
        whole = (uint16_t)(whole + 1u);
    }
    *raw = whole;
    return HIWIN_E_OK;
}

/**
 * The reference is Pt42A for rotary motors, a torque in Nm, and Pt43A for linear ones, a force in N.
 * Torque from M_ACT = reference * raw / 16384.0
 * Printed: M_ACT = torque / reference * 4000h
 * Signals: torque_actual.
 * Reference: parameters/servo_parameters/reference_torque, parameters/servo_parameters/reference_force.
 * Source: 6.11 L1800, 1810
 */
static inline double hiwin_e_motor_torque_from_raw(int16_t raw, double reference)
{
    return reference * ((double)raw / 16384.0);
}

/**
 * The count of a quantity, the nearest one, of two equally near ones the even one;
 * refused where it is not in -32768..32767, and where the reference is 0.
 */
static inline hiwin_e_codec_status hiwin_e_motor_torque_to_raw(double quantity, double reference, int16_t *raw)
{
    double count, rest;
    int16_t whole;
    if (!(reference < 0.0 || reference > 0.0)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    count = quantity / reference * 16384.0;
    if (!(count > -65537.0 / 2.0 && count < 65535.0 / 2.0)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    whole = (int16_t)count;
    rest = count - (double)whole;
    if (rest > 0.5 || (rest >= 0.5 && whole % 2 != 0)) {
        whole = (int16_t)(whole + 1);
    } else if (rest < -0.5 || (rest <= -0.5 && whole % 2 != 0)) {
        whole = (int16_t)(whole - 1);
    }
    *raw = whole;
    return HIWIN_E_OK;
}

/**
 * The reference is Pt42A for rotary motors, a torque in Nm, and Pt43A for linear ones, a force in N.
 * Torque from M_ADD1, M_LIMIT_POS and M_LIMIT_NEG = reference * raw / 16384.0
 * Printed: torque = received data / 4000h * reference
 * Signals: additional_torque, positive_torque_limit, negative_torque_limit.
 * Reference: parameters/servo_parameters/reference_torque, parameters/servo_parameters/reference_force.
 * Note: The words are signed: read as unsigned, 65536 is to be taken off what is greater than 32767 (L1808).
 * Source: 6.11 L1804-1808, 1810; 6.11.1 L1842; 6.11.2 L1856
 */
static inline double hiwin_e_torque_value_from_raw(int16_t raw, double reference)
{
    return reference * ((double)raw / 16384.0);
}

/**
 * The count of a quantity, the nearest one, of two equally near ones the even one;
 * refused where it is not in -32768..32767, and where the reference is 0.
 */
static inline hiwin_e_codec_status hiwin_e_torque_value_to_raw(double quantity, double reference, int16_t *raw)
{
    double count, rest;
    int16_t whole;
    if (!(reference < 0.0 || reference > 0.0)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    count = quantity / reference * 16384.0;
    if (!(count > -65537.0 / 2.0 && count < 65535.0 / 2.0)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    whole = (int16_t)count;
    rest = count - (double)whole;
    if (rest > 0.5 || (rest >= 0.5 && whole % 2 != 0)) {
        whole = (int16_t)(whole + 1);
    } else if (rest < -0.5 || (rest <= -0.5 && whole % 2 != 0)) {
        whole = (int16_t)(whole - 1);
    }
    *raw = whole;
    return HIWIN_E_OK;
}

/**
 * The reference is the acceleration or the deceleration that the time in Pt534 or Pt537 gives.
 * What MDI_ACC and MDI_DEC leave of the acceleration = reference * raw / 16384.0
 * Signals: mdi_acceleration, mdi_deceleration.
 * Note: No fact holds the reference: the two parameters are times, and a smaller share of the acceleration
 * takes longer.
 * Source: 3.1 L508; 6.6.1 L1646-1647
 */
static inline double hiwin_e_share_of_acceleration_from_raw(uint16_t raw, double reference)
{
    return reference * ((double)raw / 16384.0);
}

/**
 * The count of a quantity, the nearest one, of two equally near ones the even one;
 * refused where it is not in 0..16384, and where the reference is 0.
 */
static inline hiwin_e_codec_status hiwin_e_share_of_acceleration_to_raw(double quantity, double reference,
        uint16_t *raw)
{
    double count, rest;
    uint16_t whole;
    if (!(reference < 0.0 || reference > 0.0)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    count = quantity / reference * 16384.0;
    if (!(count > -1.0 / 2.0 && count < 32769.0 / 2.0)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    whole = (uint16_t)count;
    rest = count - (double)whole;
    if (rest > 0.5 || (rest >= 0.5 && whole % 2u != 0u)) {
        whole = (uint16_t)(whole + 1u);
    }
    *raw = whole;
    return HIWIN_E_OK;
}

/**
 * The reference is the speed of the MDI command or, for jogging with telegram 111, Pt533 for rotary and Pt585
 * for linear motors.
 * What the override leaves of a speed = reference * raw / 16384.0
 * Signals: velocity_override.
 * Reference: signals/mdi_velocity, parameters/servo_parameters/point_to_point_speed_rotary,
 * parameters/servo_parameters/point_to_point_speed_linear.
 * Source: 3.1 L510; 6.6.1 L1648; 6.8 L1670
 */
static inline double hiwin_e_overridden_velocity_from_raw(uint16_t raw, double reference)
{
    return reference * ((double)raw / 16384.0);
}

/**
 * The count of a quantity, the nearest one, of two equally near ones the even one;
 * refused where it is not in 0..32767, and where the reference is 0.
 */
static inline hiwin_e_codec_status hiwin_e_overridden_velocity_to_raw(double quantity, double reference, uint16_t *raw)
{
    double count, rest;
    uint16_t whole;
    if (!(reference < 0.0 || reference > 0.0)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    count = quantity / reference * 16384.0;
    if (!(count > -1.0 / 2.0 && count < 65535.0 / 2.0)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    whole = (uint16_t)count;
    rest = count - (double)whole;
    if (rest > 0.5 || (rest >= 0.5 && whole % 2u != 0u)) {
        whole = (uint16_t)(whole + 1u);
    }
    *raw = whole;
    return HIWIN_E_OK;
}

#endif

/* ---- Records ---- */

/**
 * What a refused request is answered with. Reading and writing print the same table.
 * Printed as 參數回應-發生錯誤.
 * Source: 4.3.1 L1267-1277
 */
typedef struct hiwin_e_parameter_error {
    /**
     * Printed as 錯誤值.
     * See parameter_error_number.
     * Source: 4.3.1 L1276-1277
     */
    uint16_t error_number;
} hiwin_e_parameter_error;

/** Writes hiwin_e_parameter_error to 4 bytes without checks. */
static inline void hiwin_e_parameter_error_pack(const hiwin_e_parameter_error *in, uint8_t *out)
{
    hiwin_e_store_u8(out + 0, 68u);
    hiwin_e_store_u8(out + 1, 1u);
    hiwin_e_store_u16_be(out + 2, in->error_number);
}

/** Reads hiwin_e_parameter_error from 4 bytes without checks. */
static inline void hiwin_e_parameter_error_unpack(const uint8_t *in, hiwin_e_parameter_error *out)
{
    out->error_number = hiwin_e_load_u16_be(in + 2);
}

/**
 * Writes hiwin_e_parameter_error: 4 bytes.
 * `length` receives the number of bytes written.
 */
static inline hiwin_e_codec_status hiwin_e_parameter_error_encode(const hiwin_e_parameter_error *in, uint8_t *out,
        size_t capacity, size_t *length)
{
    if (capacity < 4u) {
        return HIWIN_E_ERR_CAPACITY;
    }
    hiwin_e_parameter_error_pack(in, out);
    *length = 4u;
    return HIWIN_E_OK;
}

/** Reads hiwin_e_parameter_error from exactly 4 bytes. */
static inline hiwin_e_codec_status hiwin_e_parameter_error_decode(const uint8_t *in, size_t length,
        hiwin_e_parameter_error *out)
{
    if (length != 4u) {
        return length < 4u ? HIWIN_E_ERR_INCOMPLETE : HIWIN_E_ERR_WRONG_LENGTH;
    }
    hiwin_e_parameter_error_unpack(in, out);
    if (hiwin_e_load_u8(in + 0) != 68u) {
        return HIWIN_E_ERR_WRONG_CONST;
    }
    if (hiwin_e_load_u8(in + 1) != 1u) {
        return HIWIN_E_ERR_WRONG_CONST;
    }
    return HIWIN_E_OK;
}

/* ---- Data of requests and responses ---- */

typedef struct hiwin_e_read_parameter_request {
    /**
     * 0 for one value, n for n elements of an array.
     * Printed as 元素數量.
     * Source: 4.3.1 L1247
     */
    uint8_t element_count;
    /**
     * The PNU.
     * Printed as 參數號碼.
     * Source: 4.3.1 L1248-1249
     */
    uint16_t parameter_number;
    /**
     * The first element. It has no effect for one value.
     * Printed as 子索引.
     * Source: 4.3.1 L1250-1251
     */
    uint16_t subindex;
} hiwin_e_read_parameter_request;

/** Writes hiwin_e_read_parameter_request to 6 bytes without checks. */
static inline void hiwin_e_read_parameter_request_pack(const hiwin_e_read_parameter_request *in, uint8_t *out)
{
    hiwin_e_store_u8(out + 0, 16u);
    hiwin_e_store_u8(out + 1, in->element_count);
    hiwin_e_store_u16_be(out + 2, in->parameter_number);
    hiwin_e_store_u16_be(out + 4, in->subindex);
}

/** Reads hiwin_e_read_parameter_request from 6 bytes without checks. */
static inline void hiwin_e_read_parameter_request_unpack(const uint8_t *in, hiwin_e_read_parameter_request *out)
{
    out->element_count = hiwin_e_load_u8(in + 1);
    out->parameter_number = hiwin_e_load_u16_be(in + 2);
    out->subindex = hiwin_e_load_u16_be(in + 4);
}

/**
 * Writes hiwin_e_read_parameter_request: 6 bytes.
 * `length` receives the number of bytes written.
 */
static inline hiwin_e_codec_status hiwin_e_read_parameter_request_encode(const hiwin_e_read_parameter_request *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    if (capacity < 6u) {
        return HIWIN_E_ERR_CAPACITY;
    }
    hiwin_e_read_parameter_request_pack(in, out);
    *length = 6u;
    return HIWIN_E_OK;
}

/** Reads hiwin_e_read_parameter_request from exactly 6 bytes. */
static inline hiwin_e_codec_status hiwin_e_read_parameter_request_decode(const uint8_t *in, size_t length,
        hiwin_e_read_parameter_request *out)
{
    if (length != 6u) {
        return length < 6u ? HIWIN_E_ERR_INCOMPLETE : HIWIN_E_ERR_WRONG_LENGTH;
    }
    hiwin_e_read_parameter_request_unpack(in, out);
    if (hiwin_e_load_u8(in + 0) != 16u) {
        return HIWIN_E_ERR_WRONG_CONST;
    }
    return HIWIN_E_OK;
}

typedef struct hiwin_e_read_parameter_response {
    /**
     * The type of the values.
     * Printed as 格式.
     * See parameter_format.
     * Source: 4.3.1 L1260
     */
    uint8_t format;
    /**
     * Printed as 值.
     * Source: 4.3.1 L1262-1265
     */
    union {
        /**
         * While format is boolean.
         * Source: 4.3.5 L1411
         */
        bool boolean_value[255];
        /**
         * While format is integer_8.
         * Source: 4.3.5 L1411
         */
        int8_t integer_8_value[255];
        /**
         * While format is integer_16.
         * Source: 4.3.5 L1411
         */
        int16_t integer_16_value[255];
        /**
         * While format is integer_32.
         * Source: 4.3.5 L1411
         */
        int32_t integer_32_value[255];
        /**
         * While format is unsigned_8 or byte.
         * Source: 4.3.5 L1411
         */
        uint8_t unsigned_8_value[255];
        /**
         * While format is unsigned_16 or word.
         * Source: 4.3.5 L1411
         */
        uint16_t unsigned_16_value[255];
        /**
         * While format is unsigned_32 or double_word.
         * Source: 4.3.5 L1411
         */
        uint32_t unsigned_32_value[255];
        /**
         * While format is floating_point_32.
         * Source: 4.3.5 L1411
         */
        float floating_point_value[255];
    } values;
    size_t values_count;
} hiwin_e_read_parameter_response;

/**
 * Writes hiwin_e_read_parameter_response: 3 to 1022 bytes.
 * `length` receives the number of bytes written.
 */
static inline hiwin_e_codec_status hiwin_e_read_parameter_response_encode(const hiwin_e_read_parameter_response *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    size_t element;
    size_t at;
    switch (in->format) {
    case 1u:
    case 2u:
    case 5u:
    case 65u:
        element = 1u;
        break;
    case 3u:
    case 6u:
    case 66u:
        element = 2u;
        break;
    case 4u:
    case 7u:
    case 8u:
    case 67u:
        element = 4u;
        break;
    default:
        return HIWIN_E_ERR_UNKNOWN_VALUE;
    }
    if (in->values_count < 1u || in->values_count > 255u) {
        return HIWIN_E_ERR_WRONG_LENGTH;
    }
    if (capacity < (2u + in->values_count * element)) {
        return HIWIN_E_ERR_CAPACITY;
    }
    if (!hiwin_e_parameter_format_known((int64_t)in->format)) {
        return HIWIN_E_ERR_UNKNOWN_VALUE;
    }
    hiwin_e_store_u8(out + 0, in->format);
    switch (in->format) {
    case 1u:
        for (at = 0; at < in->values_count; at++) {
            hiwin_e_store_u8(out + 2u + at * 1u, (uint8_t)(in->values.boolean_value[at] ? 1 : 0));
        }
        break;
    case 2u:
        for (at = 0; at < in->values_count; at++) {
            hiwin_e_store_u8(out + 2u + at * 1u, (uint8_t)in->values.integer_8_value[at]);
        }
        break;
    case 3u:
        for (at = 0; at < in->values_count; at++) {
            hiwin_e_store_u16_be(out + 2u + at * 2u, (uint16_t)in->values.integer_16_value[at]);
        }
        break;
    case 4u:
        for (at = 0; at < in->values_count; at++) {
            hiwin_e_store_u32_be(out + 2u + at * 4u, (uint32_t)in->values.integer_32_value[at]);
        }
        break;
    case 5u:
    case 65u:
        for (at = 0; at < in->values_count; at++) {
            hiwin_e_store_u8(out + 2u + at * 1u, in->values.unsigned_8_value[at]);
        }
        break;
    case 6u:
    case 66u:
        for (at = 0; at < in->values_count; at++) {
            hiwin_e_store_u16_be(out + 2u + at * 2u, in->values.unsigned_16_value[at]);
        }
        break;
    case 7u:
    case 67u:
        for (at = 0; at < in->values_count; at++) {
            hiwin_e_store_u32_be(out + 2u + at * 4u, in->values.unsigned_32_value[at]);
        }
        break;
    case 8u:
        for (at = 0; at < in->values_count; at++) {
            hiwin_e_store_u32_be(out + 2u + at * 4u, hiwin_e_bits_of(in->values.floating_point_value[at]));
        }
        break;
    default:
        return HIWIN_E_ERR_UNKNOWN_VALUE;
    }
    if (in->values_count > 255u) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u8(out + 1, (uint8_t)(in->values_count));
    *length = (2u + in->values_count * element);
    return HIWIN_E_OK;
}

/** Reads hiwin_e_read_parameter_response from exactly 3 to 1022 bytes. */
static inline hiwin_e_codec_status hiwin_e_read_parameter_response_decode(const uint8_t *in, size_t length,
        hiwin_e_read_parameter_response *out)
{
    size_t element;
    size_t at;
    if (length < 3u) {
        return HIWIN_E_ERR_INCOMPLETE;
    }
    if (length > 1022u) {
        return HIWIN_E_ERR_WRONG_LENGTH;
    }
    switch (hiwin_e_load_u8(in + 0)) {
    case 1u:
    case 2u:
    case 5u:
    case 65u:
        element = 1u;
        break;
    case 3u:
    case 6u:
    case 66u:
        element = 2u;
        break;
    case 4u:
    case 7u:
    case 8u:
    case 67u:
        element = 4u;
        break;
    default:
        return HIWIN_E_ERR_UNKNOWN_VALUE;
    }
    if (length < 2u + 1u * element) {
        return HIWIN_E_ERR_INCOMPLETE;
    }
    if (length > 2u + 255u * element) {
        return HIWIN_E_ERR_WRONG_LENGTH;
    }
    if ((length - 2u) % element != 0) {
        return HIWIN_E_ERR_WRONG_LENGTH;
    }
    out->values_count = (length - 2u) / element;
    out->format = hiwin_e_load_u8(in + 0);
    if (!hiwin_e_parameter_format_known((int64_t)out->format)) {
        return HIWIN_E_ERR_UNKNOWN_VALUE;
    }
    switch (hiwin_e_load_u8(in + 0)) {
    case 1u:
        for (at = 0; at < out->values_count; at++) {
            out->values.boolean_value[at] = hiwin_e_load_u8(in + 2u + at * 1u) != 0;
            if (hiwin_e_load_u8(in + 2u + at * 1u) > 1u) {
                return HIWIN_E_ERR_UNKNOWN_VALUE;
            }
        }
        break;
    case 2u:
        for (at = 0; at < out->values_count; at++) {
            out->values.integer_8_value[at] = hiwin_e_signed_8(hiwin_e_load_u8(in + 2u + at * 1u));
        }
        break;
    case 3u:
        for (at = 0; at < out->values_count; at++) {
            out->values.integer_16_value[at] = hiwin_e_signed_16(hiwin_e_load_u16_be(in + 2u + at * 2u));
        }
        break;
    case 4u:
        for (at = 0; at < out->values_count; at++) {
            out->values.integer_32_value[at] = hiwin_e_signed_32(hiwin_e_load_u32_be(in + 2u + at * 4u));
        }
        break;
    case 5u:
    case 65u:
        for (at = 0; at < out->values_count; at++) {
            out->values.unsigned_8_value[at] = hiwin_e_load_u8(in + 2u + at * 1u);
        }
        break;
    case 6u:
    case 66u:
        for (at = 0; at < out->values_count; at++) {
            out->values.unsigned_16_value[at] = hiwin_e_load_u16_be(in + 2u + at * 2u);
        }
        break;
    case 7u:
    case 67u:
        for (at = 0; at < out->values_count; at++) {
            out->values.unsigned_32_value[at] = hiwin_e_load_u32_be(in + 2u + at * 4u);
        }
        break;
    case 8u:
        for (at = 0; at < out->values_count; at++) {
            out->values.floating_point_value[at] = hiwin_e_float_of(hiwin_e_load_u32_be(in + 2u + at * 4u));
        }
        break;
    default:
        return HIWIN_E_ERR_UNKNOWN_VALUE;
    }
    if (hiwin_e_load_u8(in + 1) != out->values_count) {
        return HIWIN_E_ERR_WRONG_MEASURE;
    }
    return HIWIN_E_OK;
}

typedef struct hiwin_e_write_parameter_request {
    /**
     * 0 for one value, n for n elements of an array.
     * Printed as 元素數量.
     * Source: 4.3.2 L1289
     */
    uint8_t element_count;
    /**
     * The PNU.
     * Printed as 參數號碼.
     * Source: 4.3.2 L1290
     */
    uint16_t parameter_number;
    /**
     * The first element that is written. It has no effect for one value.
     * Printed as 子索引.
     * Source: 4.3.2 L1291-1292
     */
    uint16_t subindex;
    /**
     * The type of the values.
     * Printed as 格式.
     * See parameter_format.
     * Source: 4.3.2 L1293
     */
    uint8_t format;
    /**
     * Printed as 值.
     * Source: 4.3.2 L1295-1299
     */
    union {
        /**
         * While format is boolean.
         * Source: 4.3.5 L1411
         */
        bool boolean_value[255];
        /**
         * While format is integer_8.
         * Source: 4.3.5 L1411
         */
        int8_t integer_8_value[255];
        /**
         * While format is integer_16.
         * Source: 4.3.5 L1411
         */
        int16_t integer_16_value[255];
        /**
         * While format is integer_32.
         * Source: 4.3.5 L1411
         */
        int32_t integer_32_value[255];
        /**
         * While format is unsigned_8 or byte.
         * Source: 4.3.5 L1411
         */
        uint8_t unsigned_8_value[255];
        /**
         * While format is unsigned_16 or word.
         * Source: 4.3.5 L1411
         */
        uint16_t unsigned_16_value[255];
        /**
         * While format is unsigned_32 or double_word.
         * Source: 4.3.5 L1411
         */
        uint32_t unsigned_32_value[255];
        /**
         * While format is floating_point_32.
         * Source: 4.3.5 L1411
         */
        float floating_point_value[255];
    } values;
    size_t values_count;
} hiwin_e_write_parameter_request;

/**
 * Writes hiwin_e_write_parameter_request: 9 to 1028 bytes.
 * `length` receives the number of bytes written.
 */
static inline hiwin_e_codec_status hiwin_e_write_parameter_request_encode(const hiwin_e_write_parameter_request *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    size_t element;
    size_t at;
    switch (in->format) {
    case 1u:
    case 2u:
    case 5u:
    case 65u:
        element = 1u;
        break;
    case 3u:
    case 6u:
    case 66u:
        element = 2u;
        break;
    case 4u:
    case 7u:
    case 8u:
    case 67u:
        element = 4u;
        break;
    default:
        return HIWIN_E_ERR_UNKNOWN_VALUE;
    }
    if (in->values_count < 1u || in->values_count > 255u) {
        return HIWIN_E_ERR_WRONG_LENGTH;
    }
    if (capacity < (8u + in->values_count * element)) {
        return HIWIN_E_ERR_CAPACITY;
    }
    hiwin_e_store_u8(out + 0, 16u);
    hiwin_e_store_u8(out + 1, in->element_count);
    hiwin_e_store_u16_be(out + 2, in->parameter_number);
    hiwin_e_store_u16_be(out + 4, in->subindex);
    if (!hiwin_e_parameter_format_known((int64_t)in->format)) {
        return HIWIN_E_ERR_UNKNOWN_VALUE;
    }
    hiwin_e_store_u8(out + 6, in->format);
    switch (in->format) {
    case 1u:
        for (at = 0; at < in->values_count; at++) {
            hiwin_e_store_u8(out + 8u + at * 1u, (uint8_t)(in->values.boolean_value[at] ? 1 : 0));
        }
        break;
    case 2u:
        for (at = 0; at < in->values_count; at++) {
            hiwin_e_store_u8(out + 8u + at * 1u, (uint8_t)in->values.integer_8_value[at]);
        }
        break;
    case 3u:
        for (at = 0; at < in->values_count; at++) {
            hiwin_e_store_u16_be(out + 8u + at * 2u, (uint16_t)in->values.integer_16_value[at]);
        }
        break;
    case 4u:
        for (at = 0; at < in->values_count; at++) {
            hiwin_e_store_u32_be(out + 8u + at * 4u, (uint32_t)in->values.integer_32_value[at]);
        }
        break;
    case 5u:
    case 65u:
        for (at = 0; at < in->values_count; at++) {
            hiwin_e_store_u8(out + 8u + at * 1u, in->values.unsigned_8_value[at]);
        }
        break;
    case 6u:
    case 66u:
        for (at = 0; at < in->values_count; at++) {
            hiwin_e_store_u16_be(out + 8u + at * 2u, in->values.unsigned_16_value[at]);
        }
        break;
    case 7u:
    case 67u:
        for (at = 0; at < in->values_count; at++) {
            hiwin_e_store_u32_be(out + 8u + at * 4u, in->values.unsigned_32_value[at]);
        }
        break;
    case 8u:
        for (at = 0; at < in->values_count; at++) {
            hiwin_e_store_u32_be(out + 8u + at * 4u, hiwin_e_bits_of(in->values.floating_point_value[at]));
        }
        break;
    default:
        return HIWIN_E_ERR_UNKNOWN_VALUE;
    }
    if (in->values_count > 255u) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u8(out + 7, (uint8_t)(in->values_count));
    *length = (8u + in->values_count * element);
    return HIWIN_E_OK;
}

/** Reads hiwin_e_write_parameter_request from exactly 9 to 1028 bytes. */
static inline hiwin_e_codec_status hiwin_e_write_parameter_request_decode(const uint8_t *in, size_t length,
        hiwin_e_write_parameter_request *out)
{
    size_t element;
    size_t at;
    if (length < 9u) {
        return HIWIN_E_ERR_INCOMPLETE;
    }
    if (length > 1028u) {
        return HIWIN_E_ERR_WRONG_LENGTH;
    }
    switch (hiwin_e_load_u8(in + 6)) {
    case 1u:
    case 2u:
    case 5u:
    case 65u:
        element = 1u;
        break;
    case 3u:
    case 6u:
    case 66u:
        element = 2u;
        break;
    case 4u:
    case 7u:
    case 8u:
    case 67u:
        element = 4u;
        break;
    default:
        return HIWIN_E_ERR_UNKNOWN_VALUE;
    }
    if (length < 8u + 1u * element) {
        return HIWIN_E_ERR_INCOMPLETE;
    }
    if (length > 8u + 255u * element) {
        return HIWIN_E_ERR_WRONG_LENGTH;
    }
    if ((length - 8u) % element != 0) {
        return HIWIN_E_ERR_WRONG_LENGTH;
    }
    out->values_count = (length - 8u) / element;
    if (hiwin_e_load_u8(in + 0) != 16u) {
        return HIWIN_E_ERR_WRONG_CONST;
    }
    out->element_count = hiwin_e_load_u8(in + 1);
    out->parameter_number = hiwin_e_load_u16_be(in + 2);
    out->subindex = hiwin_e_load_u16_be(in + 4);
    out->format = hiwin_e_load_u8(in + 6);
    if (!hiwin_e_parameter_format_known((int64_t)out->format)) {
        return HIWIN_E_ERR_UNKNOWN_VALUE;
    }
    switch (hiwin_e_load_u8(in + 6)) {
    case 1u:
        for (at = 0; at < out->values_count; at++) {
            out->values.boolean_value[at] = hiwin_e_load_u8(in + 8u + at * 1u) != 0;
            if (hiwin_e_load_u8(in + 8u + at * 1u) > 1u) {
                return HIWIN_E_ERR_UNKNOWN_VALUE;
            }
        }
        break;
    case 2u:
        for (at = 0; at < out->values_count; at++) {
            out->values.integer_8_value[at] = hiwin_e_signed_8(hiwin_e_load_u8(in + 8u + at * 1u));
        }
        break;
    case 3u:
        for (at = 0; at < out->values_count; at++) {
            out->values.integer_16_value[at] = hiwin_e_signed_16(hiwin_e_load_u16_be(in + 8u + at * 2u));
        }
        break;
    case 4u:
        for (at = 0; at < out->values_count; at++) {
            out->values.integer_32_value[at] = hiwin_e_signed_32(hiwin_e_load_u32_be(in + 8u + at * 4u));
        }
        break;
    case 5u:
    case 65u:
        for (at = 0; at < out->values_count; at++) {
            out->values.unsigned_8_value[at] = hiwin_e_load_u8(in + 8u + at * 1u);
        }
        break;
    case 6u:
    case 66u:
        for (at = 0; at < out->values_count; at++) {
            out->values.unsigned_16_value[at] = hiwin_e_load_u16_be(in + 8u + at * 2u);
        }
        break;
    case 7u:
    case 67u:
        for (at = 0; at < out->values_count; at++) {
            out->values.unsigned_32_value[at] = hiwin_e_load_u32_be(in + 8u + at * 4u);
        }
        break;
    case 8u:
        for (at = 0; at < out->values_count; at++) {
            out->values.floating_point_value[at] = hiwin_e_float_of(hiwin_e_load_u32_be(in + 8u + at * 4u));
        }
        break;
    default:
        return HIWIN_E_ERR_UNKNOWN_VALUE;
    }
    if (hiwin_e_load_u8(in + 7) != out->values_count) {
        return HIWIN_E_ERR_WRONG_MEASURE;
    }
    return HIWIN_E_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes hiwin_e_write_parameter_response: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline hiwin_e_codec_status hiwin_e_write_parameter_response_encode(uint8_t *out, size_t capacity,
        size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return HIWIN_E_OK;
}

/** Reads hiwin_e_write_parameter_response from exactly 0 bytes. */
static inline hiwin_e_codec_status hiwin_e_write_parameter_response_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return HIWIN_E_ERR_WRONG_LENGTH;
    }
    return HIWIN_E_OK;
}

typedef struct hiwin_e_telegram_3_request {
    /**
     * Switches the drive on and off and, with telegrams 9 and 111, moves it.
     * Printed as STW1 Control word 1.
     * Range: 0..65535. See control_word_1.
     * Source: 3.2 L538
     */
    uint16_t control_word_1;
    /**
     * The commanded speed, as a share of the reference speed: Pt317 for rotary motors, Pt386 for linear ones.
     * Printed as NSOLL_B 速度控制命令 B (32 位元).
     * One count is 100/2^30 %. Range: -2147483648..2147483647.
     * Source: 3.2 L539-540
     */
    int32_t speed_setpoint_b;
    /**
     * The sign of life of the controller.
     * Printed as STW2 Control word 2.
     * Range: 0..65535. See control_word_2.
     * Source: 3.2 L541
     */
    uint16_t control_word_2;
    /**
     * Printed as G1_STW 編碼器 1 control word.
     * Range: 0..65535. See encoder_1_control_word.
     * Source: 3.2 L542
     */
    uint16_t encoder_1_control_word;
} hiwin_e_telegram_3_request;

/** Writes hiwin_e_telegram_3_request to 10 bytes without checks. */
static inline void hiwin_e_telegram_3_request_pack(const hiwin_e_telegram_3_request *in, uint8_t *out)
{
    hiwin_e_store_u16_be(out + 0, in->control_word_1);
    hiwin_e_store_u32_be(out + 2, (uint32_t)in->speed_setpoint_b);
    hiwin_e_store_u16_be(out + 6, in->control_word_2);
    hiwin_e_store_u16_be(out + 8, in->encoder_1_control_word);
}

/** Reads hiwin_e_telegram_3_request from 10 bytes without checks. */
static inline void hiwin_e_telegram_3_request_unpack(const uint8_t *in, hiwin_e_telegram_3_request *out)
{
    out->control_word_1 = hiwin_e_load_u16_be(in + 0);
    out->speed_setpoint_b = hiwin_e_signed_32(hiwin_e_load_u32_be(in + 2));
    out->control_word_2 = hiwin_e_load_u16_be(in + 6);
    out->encoder_1_control_word = hiwin_e_load_u16_be(in + 8);
}

/**
 * Writes hiwin_e_telegram_3_request: 10 bytes.
 * `length` receives the number of bytes written.
 */
static inline hiwin_e_codec_status hiwin_e_telegram_3_request_encode(const hiwin_e_telegram_3_request *in, uint8_t *out,
        size_t capacity, size_t *length)
{
    if (capacity < 10u) {
        return HIWIN_E_ERR_CAPACITY;
    }
    hiwin_e_telegram_3_request_pack(in, out);
    *length = 10u;
    return HIWIN_E_OK;
}

/** Reads hiwin_e_telegram_3_request from exactly 10 bytes. */
static inline hiwin_e_codec_status hiwin_e_telegram_3_request_decode(const uint8_t *in, size_t length,
        hiwin_e_telegram_3_request *out)
{
    if (length != 10u) {
        return length < 10u ? HIWIN_E_ERR_INCOMPLETE : HIWIN_E_ERR_WRONG_LENGTH;
    }
    hiwin_e_telegram_3_request_unpack(in, out);
    return HIWIN_E_OK;
}

typedef struct hiwin_e_telegram_3_response {
    /**
     * The state of the drive and, with telegrams 9 and 111, of its movements.
     * Printed as ZSW1 Status word 1.
     * Range: 0..65535. See status_word_1.
     * Source: 3.2 L538
     */
    uint16_t status_word_1;
    /**
     * The actual speed, as a share of the reference speed: Pt317 for rotary motors, Pt386 for linear ones.
     * Printed as NIST_B 速度實際值 B (32 位元).
     * One count is 100/2^30 %. Range: -2147483648..2147483647.
     * Source: 3.2 L539-540
     */
    int32_t speed_actual_b;
    /**
     * The sign of life of the drive.
     * Printed as ZSW2 Status word 2.
     * Range: 0..65535. See status_word_2.
     * Source: 3.2 L541
     */
    uint16_t status_word_2;
    /**
     * Printed as G1_ZSW 編碼器 1 status word.
     * Range: 0..65535. See encoder_1_status_word.
     * Source: 3.2 L542
     */
    uint16_t encoder_1_status_word;
    /**
     * Printed as G1_XIST1 編碼器 1 實際位置 1.
     * One count is 1 control unit. Range: -2147483648..2147483647.
     * Source: 3.2 L543-544
     */
    int32_t encoder_1_position_1;
    /**
     * Printed as G1_XIST2 編碼器 1 實際位置 2.
     * One count is 1 control unit. Range: -2147483648..2147483647.
     * Source: 3.2 L545-546
     */
    int32_t encoder_1_position_2;
} hiwin_e_telegram_3_response;

/** Writes hiwin_e_telegram_3_response to 18 bytes without checks. */
static inline void hiwin_e_telegram_3_response_pack(const hiwin_e_telegram_3_response *in, uint8_t *out)
{
    hiwin_e_store_u16_be(out + 0, in->status_word_1);
    hiwin_e_store_u32_be(out + 2, (uint32_t)in->speed_actual_b);
    hiwin_e_store_u16_be(out + 6, in->status_word_2);
    hiwin_e_store_u16_be(out + 8, in->encoder_1_status_word);
    hiwin_e_store_u32_be(out + 10, (uint32_t)in->encoder_1_position_1);
    hiwin_e_store_u32_be(out + 14, (uint32_t)in->encoder_1_position_2);
}

/** Reads hiwin_e_telegram_3_response from 18 bytes without checks. */
static inline void hiwin_e_telegram_3_response_unpack(const uint8_t *in, hiwin_e_telegram_3_response *out)
{
    out->status_word_1 = hiwin_e_load_u16_be(in + 0);
    out->speed_actual_b = hiwin_e_signed_32(hiwin_e_load_u32_be(in + 2));
    out->status_word_2 = hiwin_e_load_u16_be(in + 6);
    out->encoder_1_status_word = hiwin_e_load_u16_be(in + 8);
    out->encoder_1_position_1 = hiwin_e_signed_32(hiwin_e_load_u32_be(in + 10));
    out->encoder_1_position_2 = hiwin_e_signed_32(hiwin_e_load_u32_be(in + 14));
}

/**
 * Writes hiwin_e_telegram_3_response: 18 bytes.
 * `length` receives the number of bytes written.
 */
static inline hiwin_e_codec_status hiwin_e_telegram_3_response_encode(const hiwin_e_telegram_3_response *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    if (capacity < 18u) {
        return HIWIN_E_ERR_CAPACITY;
    }
    hiwin_e_telegram_3_response_pack(in, out);
    *length = 18u;
    return HIWIN_E_OK;
}

/** Reads hiwin_e_telegram_3_response from exactly 18 bytes. */
static inline hiwin_e_codec_status hiwin_e_telegram_3_response_decode(const uint8_t *in, size_t length,
        hiwin_e_telegram_3_response *out)
{
    if (length != 18u) {
        return length < 18u ? HIWIN_E_ERR_INCOMPLETE : HIWIN_E_ERR_WRONG_LENGTH;
    }
    hiwin_e_telegram_3_response_unpack(in, out);
    return HIWIN_E_OK;
}

typedef struct hiwin_e_telegram_5_request {
    /**
     * Switches the drive on and off and, with telegrams 9 and 111, moves it.
     * Printed as STW1 Control word 1.
     * Range: 0..65535. See control_word_1.
     * Source: 3.2 L538
     */
    uint16_t control_word_1;
    /**
     * The commanded speed, as a share of the reference speed: Pt317 for rotary motors, Pt386 for linear ones.
     * Printed as NSOLL_B 速度控制命令 B (32 位元).
     * One count is 100/2^30 %. Range: -2147483648..2147483647.
     * Source: 3.2 L539-540
     */
    int32_t speed_setpoint_b;
    /**
     * The sign of life of the controller.
     * Printed as STW2 Control word 2.
     * Range: 0..65535. See control_word_2.
     * Source: 3.2 L541
     */
    uint16_t control_word_2;
    /**
     * Printed as G1_STW 編碼器 1 control word.
     * Range: 0..65535. See encoder_1_control_word.
     * Source: 3.2 L542
     */
    uint16_t encoder_1_control_word;
    /**
     * The position deviation, which the controller sends.
     * Printed as XERR 位置偏差值.
     * One count is 1 control unit. Range: -2147483648..2147483647.
     * Source: 3.2 L543-544
     */
    int32_t position_error;
    /**
     * The gain of the position controller.
     * Printed as KPC 位置控制器增益係數.
     * One count is 1/1000 1/s. Range: -2147483648..2147483647.
     * Source: 3.2 L545-546
     */
    int32_t position_controller_gain;
} hiwin_e_telegram_5_request;

/** Writes hiwin_e_telegram_5_request to 18 bytes without checks. */
static inline void hiwin_e_telegram_5_request_pack(const hiwin_e_telegram_5_request *in, uint8_t *out)
{
    hiwin_e_store_u16_be(out + 0, in->control_word_1);
    hiwin_e_store_u32_be(out + 2, (uint32_t)in->speed_setpoint_b);
    hiwin_e_store_u16_be(out + 6, in->control_word_2);
    hiwin_e_store_u16_be(out + 8, in->encoder_1_control_word);
    hiwin_e_store_u32_be(out + 10, (uint32_t)in->position_error);
    hiwin_e_store_u32_be(out + 14, (uint32_t)in->position_controller_gain);
}

/** Reads hiwin_e_telegram_5_request from 18 bytes without checks. */
static inline void hiwin_e_telegram_5_request_unpack(const uint8_t *in, hiwin_e_telegram_5_request *out)
{
    out->control_word_1 = hiwin_e_load_u16_be(in + 0);
    out->speed_setpoint_b = hiwin_e_signed_32(hiwin_e_load_u32_be(in + 2));
    out->control_word_2 = hiwin_e_load_u16_be(in + 6);
    out->encoder_1_control_word = hiwin_e_load_u16_be(in + 8);
    out->position_error = hiwin_e_signed_32(hiwin_e_load_u32_be(in + 10));
    out->position_controller_gain = hiwin_e_signed_32(hiwin_e_load_u32_be(in + 14));
}

/**
 * Writes hiwin_e_telegram_5_request: 18 bytes.
 * `length` receives the number of bytes written.
 */
static inline hiwin_e_codec_status hiwin_e_telegram_5_request_encode(const hiwin_e_telegram_5_request *in, uint8_t *out,
        size_t capacity, size_t *length)
{
    if (capacity < 18u) {
        return HIWIN_E_ERR_CAPACITY;
    }
    hiwin_e_telegram_5_request_pack(in, out);
    *length = 18u;
    return HIWIN_E_OK;
}

/** Reads hiwin_e_telegram_5_request from exactly 18 bytes. */
static inline hiwin_e_codec_status hiwin_e_telegram_5_request_decode(const uint8_t *in, size_t length,
        hiwin_e_telegram_5_request *out)
{
    if (length != 18u) {
        return length < 18u ? HIWIN_E_ERR_INCOMPLETE : HIWIN_E_ERR_WRONG_LENGTH;
    }
    hiwin_e_telegram_5_request_unpack(in, out);
    return HIWIN_E_OK;
}

typedef struct hiwin_e_telegram_5_response {
    /**
     * The state of the drive and, with telegrams 9 and 111, of its movements.
     * Printed as ZSW1 Status word 1.
     * Range: 0..65535. See status_word_1.
     * Source: 3.2 L538
     */
    uint16_t status_word_1;
    /**
     * The actual speed, as a share of the reference speed: Pt317 for rotary motors, Pt386 for linear ones.
     * Printed as NIST_B 速度實際值 B (32 位元).
     * One count is 100/2^30 %. Range: -2147483648..2147483647.
     * Source: 3.2 L539-540
     */
    int32_t speed_actual_b;
    /**
     * The sign of life of the drive.
     * Printed as ZSW2 Status word 2.
     * Range: 0..65535. See status_word_2.
     * Source: 3.2 L541
     */
    uint16_t status_word_2;
    /**
     * Printed as G1_ZSW 編碼器 1 status word.
     * Range: 0..65535. See encoder_1_status_word.
     * Source: 3.2 L542
     */
    uint16_t encoder_1_status_word;
    /**
     * Printed as G1_XIST1 編碼器 1 實際位置 1.
     * One count is 1 control unit. Range: -2147483648..2147483647.
     * Source: 3.2 L543-544
     */
    int32_t encoder_1_position_1;
    /**
     * Printed as G1_XIST2 編碼器 1 實際位置 2.
     * One count is 1 control unit. Range: -2147483648..2147483647.
     * Source: 3.2 L545-546
     */
    int32_t encoder_1_position_2;
} hiwin_e_telegram_5_response;

/** Writes hiwin_e_telegram_5_response to 18 bytes without checks. */
static inline void hiwin_e_telegram_5_response_pack(const hiwin_e_telegram_5_response *in, uint8_t *out)
{
    hiwin_e_store_u16_be(out + 0, in->status_word_1);
    hiwin_e_store_u32_be(out + 2, (uint32_t)in->speed_actual_b);
    hiwin_e_store_u16_be(out + 6, in->status_word_2);
    hiwin_e_store_u16_be(out + 8, in->encoder_1_status_word);
    hiwin_e_store_u32_be(out + 10, (uint32_t)in->encoder_1_position_1);
    hiwin_e_store_u32_be(out + 14, (uint32_t)in->encoder_1_position_2);
}

/** Reads hiwin_e_telegram_5_response from 18 bytes without checks. */
static inline void hiwin_e_telegram_5_response_unpack(const uint8_t *in, hiwin_e_telegram_5_response *out)
{
    out->status_word_1 = hiwin_e_load_u16_be(in + 0);
    out->speed_actual_b = hiwin_e_signed_32(hiwin_e_load_u32_be(in + 2));
    out->status_word_2 = hiwin_e_load_u16_be(in + 6);
    out->encoder_1_status_word = hiwin_e_load_u16_be(in + 8);
    out->encoder_1_position_1 = hiwin_e_signed_32(hiwin_e_load_u32_be(in + 10));
    out->encoder_1_position_2 = hiwin_e_signed_32(hiwin_e_load_u32_be(in + 14));
}

/**
 * Writes hiwin_e_telegram_5_response: 18 bytes.
 * `length` receives the number of bytes written.
 */
static inline hiwin_e_codec_status hiwin_e_telegram_5_response_encode(const hiwin_e_telegram_5_response *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    if (capacity < 18u) {
        return HIWIN_E_ERR_CAPACITY;
    }
    hiwin_e_telegram_5_response_pack(in, out);
    *length = 18u;
    return HIWIN_E_OK;
}

/** Reads hiwin_e_telegram_5_response from exactly 18 bytes. */
static inline hiwin_e_codec_status hiwin_e_telegram_5_response_decode(const uint8_t *in, size_t length,
        hiwin_e_telegram_5_response *out)
{
    if (length != 18u) {
        return length < 18u ? HIWIN_E_ERR_INCOMPLETE : HIWIN_E_ERR_WRONG_LENGTH;
    }
    hiwin_e_telegram_5_response_unpack(in, out);
    return HIWIN_E_OK;
}

typedef struct hiwin_e_telegram_9_request {
    /**
     * Switches the drive on and off and, with telegrams 9 and 111, moves it.
     * Printed as STW1 Control word 1.
     * Range: 0..65535. See control_word_1_positioning.
     * Source: 3.2 L551
     */
    uint16_t control_word_1;
    /**
     * Printed as SATZANW 位置模塊選擇.
     * Range: 0..65535. See block_selection.
     * Note: Only its MDI bit has an effect (L575).
     * Source: 3.2 L552
     */
    uint16_t block_selection;
    /**
     * The sign of life of the controller.
     * Printed as STW2 Control word 2.
     * Range: 0..65535. See control_word_2.
     * Source: 3.2 L553
     */
    uint16_t control_word_2;
    /**
     * The position, or in relative positioning the distance, of an MDI command.
     * Printed as MDI_TARPOS MDI 位置命令.
     * One count is 1 control unit. Range: -2147483648..2147483647.
     * Source: 3.2 L554-555
     */
    int32_t mdi_target_position;
    /**
     * The speed of an MDI command; OVERRIDE scales it. In the setup mode its direction is chosen in POS_STW1.
     * Printed as MDI_VELOCITY MDI 速度命令.
     * One count is 1000 control unit/min. Range: 0..2147483647.
     * Source: 3.2 L556-557
     */
    int32_t mdi_velocity;
    /**
     * The share of the acceleration that Pt534 sets.
     * Printed as MDI_ACC MDI 加速度命令 Override.
     * One count is 100/2^14 %. Range: 0..16384.
     * Source: 3.2 L558
     */
    uint16_t mdi_acceleration;
    /**
     * The share of the deceleration that Pt537 sets.
     * Printed as MDI_DEC MDI 減速度命令 Override.
     * One count is 100/2^14 %. Range: 0..16384.
     * Source: 3.2 L559
     */
    uint16_t mdi_deceleration;
    /**
     * Printed as MDI_MODE MDI 位置模式.
     * Range: 0..65535. See mdi_mode.
     * Source: 3.2 L560
     */
    uint16_t mdi_mode;
} hiwin_e_telegram_9_request;

/** Whether the values of hiwin_e_telegram_9_request may be written. */
static inline hiwin_e_codec_status hiwin_e_telegram_9_request_check(const hiwin_e_telegram_9_request *in)
{
    if (!(in->mdi_velocity >= 0)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    if (!(in->mdi_acceleration <= 16384u)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    if (!(in->mdi_deceleration <= 16384u)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    return HIWIN_E_OK;
}

/** Writes hiwin_e_telegram_9_request to 20 bytes without checks. */
static inline void hiwin_e_telegram_9_request_pack(const hiwin_e_telegram_9_request *in, uint8_t *out)
{
    hiwin_e_store_u16_be(out + 0, in->control_word_1);
    hiwin_e_store_u16_be(out + 2, in->block_selection);
    hiwin_e_store_u16_be(out + 4, in->control_word_2);
    hiwin_e_store_u32_be(out + 6, (uint32_t)in->mdi_target_position);
    hiwin_e_store_u32_be(out + 10, (uint32_t)in->mdi_velocity);
    hiwin_e_store_u16_be(out + 14, in->mdi_acceleration);
    hiwin_e_store_u16_be(out + 16, in->mdi_deceleration);
    hiwin_e_store_u16_be(out + 18, in->mdi_mode);
}

/** Reads hiwin_e_telegram_9_request from 20 bytes without checks. */
static inline void hiwin_e_telegram_9_request_unpack(const uint8_t *in, hiwin_e_telegram_9_request *out)
{
    out->control_word_1 = hiwin_e_load_u16_be(in + 0);
    out->block_selection = hiwin_e_load_u16_be(in + 2);
    out->control_word_2 = hiwin_e_load_u16_be(in + 4);
    out->mdi_target_position = hiwin_e_signed_32(hiwin_e_load_u32_be(in + 6));
    out->mdi_velocity = hiwin_e_signed_32(hiwin_e_load_u32_be(in + 10));
    out->mdi_acceleration = hiwin_e_load_u16_be(in + 14);
    out->mdi_deceleration = hiwin_e_load_u16_be(in + 16);
    out->mdi_mode = hiwin_e_load_u16_be(in + 18);
}

/**
 * Writes hiwin_e_telegram_9_request: 20 bytes.
 * `length` receives the number of bytes written.
 */
static inline hiwin_e_codec_status hiwin_e_telegram_9_request_encode(const hiwin_e_telegram_9_request *in, uint8_t *out,
        size_t capacity, size_t *length)
{
    hiwin_e_codec_status status;
    if (capacity < 20u) {
        return HIWIN_E_ERR_CAPACITY;
    }
    status = hiwin_e_telegram_9_request_check(in);
    if (status != HIWIN_E_OK) {
        return status;
    }
    hiwin_e_telegram_9_request_pack(in, out);
    *length = 20u;
    return HIWIN_E_OK;
}

/** Reads hiwin_e_telegram_9_request from exactly 20 bytes. */
static inline hiwin_e_codec_status hiwin_e_telegram_9_request_decode(const uint8_t *in, size_t length,
        hiwin_e_telegram_9_request *out)
{
    if (length != 20u) {
        return length < 20u ? HIWIN_E_ERR_INCOMPLETE : HIWIN_E_ERR_WRONG_LENGTH;
    }
    hiwin_e_telegram_9_request_unpack(in, out);
    return HIWIN_E_OK;
}

typedef struct hiwin_e_telegram_9_response {
    /**
     * The state of the drive and, with telegrams 9 and 111, of its movements.
     * Printed as ZSW1 Status word 1.
     * Range: 0..65535. See status_word_1_positioning.
     * Source: 3.2 L551
     */
    uint16_t status_word_1;
    /**
     * Printed as AKTSATZ 已選擇的位置模塊.
     * Range: 0..65535. See selected_block.
     * Source: 3.2 L552
     */
    uint16_t selected_block;
    /**
     * The sign of life of the drive.
     * Printed as ZSW2 Status word 2.
     * Range: 0..65535. See status_word_2_pulse_command.
     * Source: 3.2 L553
     */
    uint16_t status_word_2;
    /**
     * Printed as XIST_A 位置實際值 A.
     * One count is 1 control unit. Range: -2147483648..2147483647.
     * Source: 3.2 L554-555
     */
    int32_t position_actual_a;
} hiwin_e_telegram_9_response;

/** Writes hiwin_e_telegram_9_response to 10 bytes without checks. */
static inline void hiwin_e_telegram_9_response_pack(const hiwin_e_telegram_9_response *in, uint8_t *out)
{
    hiwin_e_store_u16_be(out + 0, in->status_word_1);
    hiwin_e_store_u16_be(out + 2, in->selected_block);
    hiwin_e_store_u16_be(out + 4, in->status_word_2);
    hiwin_e_store_u32_be(out + 6, (uint32_t)in->position_actual_a);
}

/** Reads hiwin_e_telegram_9_response from 10 bytes without checks. */
static inline void hiwin_e_telegram_9_response_unpack(const uint8_t *in, hiwin_e_telegram_9_response *out)
{
    out->status_word_1 = hiwin_e_load_u16_be(in + 0);
    out->selected_block = hiwin_e_load_u16_be(in + 2);
    out->status_word_2 = hiwin_e_load_u16_be(in + 4);
    out->position_actual_a = hiwin_e_signed_32(hiwin_e_load_u32_be(in + 6));
}

/**
 * Writes hiwin_e_telegram_9_response: 10 bytes.
 * `length` receives the number of bytes written.
 */
static inline hiwin_e_codec_status hiwin_e_telegram_9_response_encode(const hiwin_e_telegram_9_response *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    if (capacity < 10u) {
        return HIWIN_E_ERR_CAPACITY;
    }
    hiwin_e_telegram_9_response_pack(in, out);
    *length = 10u;
    return HIWIN_E_OK;
}

/** Reads hiwin_e_telegram_9_response from exactly 10 bytes. */
static inline hiwin_e_codec_status hiwin_e_telegram_9_response_decode(const uint8_t *in, size_t length,
        hiwin_e_telegram_9_response *out)
{
    if (length != 10u) {
        return length < 10u ? HIWIN_E_ERR_INCOMPLETE : HIWIN_E_ERR_WRONG_LENGTH;
    }
    hiwin_e_telegram_9_response_unpack(in, out);
    return HIWIN_E_OK;
}

typedef struct hiwin_e_telegram_102_request {
    /**
     * Switches the drive on and off and, with telegrams 9 and 111, moves it.
     * Printed as STW1 Control word 1.
     * Range: 0..65535. See control_word_1.
     * Source: 3.2 L538
     */
    uint16_t control_word_1;
    /**
     * The commanded speed, as a share of the reference speed: Pt317 for rotary motors, Pt386 for linear ones.
     * Printed as NSOLL_B 速度控制命令 B (32 位元).
     * One count is 100/2^30 %. Range: -2147483648..2147483647.
     * Source: 3.2 L539-540
     */
    int32_t speed_setpoint_b;
    /**
     * The sign of life of the controller.
     * Printed as STW2 Control word 2.
     * Range: 0..65535. See control_word_2_fixed_stop.
     * Source: 3.2 L541
     */
    uint16_t control_word_2;
    /**
     * What is taken off the torque, as a share of the reference torque: Pt42A for rotary motors, the force Pt43A
     * for linear ones.
     * Printed as MOMRED 轉矩調節值.
     * One count is 100/2^14 %. Range: 0..16384.
     * Source: 3.2 L542
     */
    uint16_t torque_reduction;
    /**
     * Printed as G1_STW 編碼器 1 control word.
     * Range: 0..65535. See encoder_1_control_word.
     * Source: 3.2 L543
     */
    uint16_t encoder_1_control_word;
} hiwin_e_telegram_102_request;

/** Whether the values of hiwin_e_telegram_102_request may be written. */
static inline hiwin_e_codec_status hiwin_e_telegram_102_request_check(const hiwin_e_telegram_102_request *in)
{
    if (!(in->torque_reduction <= 16384u)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    return HIWIN_E_OK;
}

/** Writes hiwin_e_telegram_102_request to 12 bytes without checks. */
static inline void hiwin_e_telegram_102_request_pack(const hiwin_e_telegram_102_request *in, uint8_t *out)
{
    hiwin_e_store_u16_be(out + 0, in->control_word_1);
    hiwin_e_store_u32_be(out + 2, (uint32_t)in->speed_setpoint_b);
    hiwin_e_store_u16_be(out + 6, in->control_word_2);
    hiwin_e_store_u16_be(out + 8, in->torque_reduction);
    hiwin_e_store_u16_be(out + 10, in->encoder_1_control_word);
}

/** Reads hiwin_e_telegram_102_request from 12 bytes without checks. */
static inline void hiwin_e_telegram_102_request_unpack(const uint8_t *in, hiwin_e_telegram_102_request *out)
{
    out->control_word_1 = hiwin_e_load_u16_be(in + 0);
    out->speed_setpoint_b = hiwin_e_signed_32(hiwin_e_load_u32_be(in + 2));
    out->control_word_2 = hiwin_e_load_u16_be(in + 6);
    out->torque_reduction = hiwin_e_load_u16_be(in + 8);
    out->encoder_1_control_word = hiwin_e_load_u16_be(in + 10);
}

/**
 * Writes hiwin_e_telegram_102_request: 12 bytes.
 * `length` receives the number of bytes written.
 */
static inline hiwin_e_codec_status hiwin_e_telegram_102_request_encode(const hiwin_e_telegram_102_request *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    hiwin_e_codec_status status;
    if (capacity < 12u) {
        return HIWIN_E_ERR_CAPACITY;
    }
    status = hiwin_e_telegram_102_request_check(in);
    if (status != HIWIN_E_OK) {
        return status;
    }
    hiwin_e_telegram_102_request_pack(in, out);
    *length = 12u;
    return HIWIN_E_OK;
}

/** Reads hiwin_e_telegram_102_request from exactly 12 bytes. */
static inline hiwin_e_codec_status hiwin_e_telegram_102_request_decode(const uint8_t *in, size_t length,
        hiwin_e_telegram_102_request *out)
{
    if (length != 12u) {
        return length < 12u ? HIWIN_E_ERR_INCOMPLETE : HIWIN_E_ERR_WRONG_LENGTH;
    }
    hiwin_e_telegram_102_request_unpack(in, out);
    return HIWIN_E_OK;
}

typedef struct hiwin_e_telegram_102_response {
    /**
     * The state of the drive and, with telegrams 9 and 111, of its movements.
     * Printed as ZSW1 Status word 1.
     * Range: 0..65535. See status_word_1.
     * Source: 3.2 L538
     */
    uint16_t status_word_1;
    /**
     * The actual speed, as a share of the reference speed: Pt317 for rotary motors, Pt386 for linear ones.
     * Printed as NIST_B 速度實際值 B (32 位元).
     * One count is 100/2^30 %. Range: -2147483648..2147483647.
     * Source: 3.2 L539-540
     */
    int32_t speed_actual_b;
    /**
     * The sign of life of the drive.
     * Printed as ZSW2 Status word 2.
     * Range: 0..65535. See status_word_2_fixed_stop.
     * Source: 3.2 L541
     */
    uint16_t status_word_2;
    /**
     * Printed as MELDW Message word.
     * Range: 0..65535. See message_word.
     * Source: 3.2 L542
     */
    uint16_t message_word;
    /**
     * Printed as G1_ZSW 編碼器 1 status word.
     * Range: 0..65535. See encoder_1_status_word.
     * Source: 3.2 L543
     */
    uint16_t encoder_1_status_word;
    /**
     * Printed as G1_XIST1 編碼器 1 實際位置 1.
     * One count is 1 control unit. Range: -2147483648..2147483647.
     * Source: 3.2 L544-545
     */
    int32_t encoder_1_position_1;
    /**
     * Printed as G1_XIST2 編碼器 1 實際位置 2.
     * One count is 1 control unit. Range: -2147483648..2147483647.
     * Source: 3.2 L546-547
     */
    int32_t encoder_1_position_2;
} hiwin_e_telegram_102_response;

/** Writes hiwin_e_telegram_102_response to 20 bytes without checks. */
static inline void hiwin_e_telegram_102_response_pack(const hiwin_e_telegram_102_response *in, uint8_t *out)
{
    hiwin_e_store_u16_be(out + 0, in->status_word_1);
    hiwin_e_store_u32_be(out + 2, (uint32_t)in->speed_actual_b);
    hiwin_e_store_u16_be(out + 6, in->status_word_2);
    hiwin_e_store_u16_be(out + 8, in->message_word);
    hiwin_e_store_u16_be(out + 10, in->encoder_1_status_word);
    hiwin_e_store_u32_be(out + 12, (uint32_t)in->encoder_1_position_1);
    hiwin_e_store_u32_be(out + 16, (uint32_t)in->encoder_1_position_2);
}

/** Reads hiwin_e_telegram_102_response from 20 bytes without checks. */
static inline void hiwin_e_telegram_102_response_unpack(const uint8_t *in, hiwin_e_telegram_102_response *out)
{
    out->status_word_1 = hiwin_e_load_u16_be(in + 0);
    out->speed_actual_b = hiwin_e_signed_32(hiwin_e_load_u32_be(in + 2));
    out->status_word_2 = hiwin_e_load_u16_be(in + 6);
    out->message_word = hiwin_e_load_u16_be(in + 8);
    out->encoder_1_status_word = hiwin_e_load_u16_be(in + 10);
    out->encoder_1_position_1 = hiwin_e_signed_32(hiwin_e_load_u32_be(in + 12));
    out->encoder_1_position_2 = hiwin_e_signed_32(hiwin_e_load_u32_be(in + 16));
}

/**
 * Writes hiwin_e_telegram_102_response: 20 bytes.
 * `length` receives the number of bytes written.
 */
static inline hiwin_e_codec_status hiwin_e_telegram_102_response_encode(const hiwin_e_telegram_102_response *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    if (capacity < 20u) {
        return HIWIN_E_ERR_CAPACITY;
    }
    hiwin_e_telegram_102_response_pack(in, out);
    *length = 20u;
    return HIWIN_E_OK;
}

/** Reads hiwin_e_telegram_102_response from exactly 20 bytes. */
static inline hiwin_e_codec_status hiwin_e_telegram_102_response_decode(const uint8_t *in, size_t length,
        hiwin_e_telegram_102_response *out)
{
    if (length != 20u) {
        return length < 20u ? HIWIN_E_ERR_INCOMPLETE : HIWIN_E_ERR_WRONG_LENGTH;
    }
    hiwin_e_telegram_102_response_unpack(in, out);
    return HIWIN_E_OK;
}

typedef struct hiwin_e_telegram_105_request {
    /**
     * Switches the drive on and off and, with telegrams 9 and 111, moves it.
     * Printed as STW1 Control word 1.
     * Range: 0..65535. See control_word_1.
     * Source: 3.2 L538
     */
    uint16_t control_word_1;
    /**
     * The commanded speed, as a share of the reference speed: Pt317 for rotary motors, Pt386 for linear ones.
     * Printed as NSOLL_B 速度控制命令 B (32 位元).
     * One count is 100/2^30 %. Range: -2147483648..2147483647.
     * Source: 3.2 L539-540
     */
    int32_t speed_setpoint_b;
    /**
     * The sign of life of the controller.
     * Printed as STW2 Control word 2.
     * Range: 0..65535. See control_word_2_fixed_stop.
     * Source: 3.2 L541
     */
    uint16_t control_word_2;
    /**
     * What is taken off the torque, as a share of the reference torque: Pt42A for rotary motors, the force Pt43A
     * for linear ones.
     * Printed as MOMRED 轉矩調節值.
     * One count is 100/2^14 %. Range: 0..16384.
     * Source: 3.2 L542
     */
    uint16_t torque_reduction;
    /**
     * Printed as G1_STW 編碼器 1 control word.
     * Range: 0..65535. See encoder_1_control_word.
     * Source: 3.2 L543
     */
    uint16_t encoder_1_control_word;
    /**
     * The position deviation, which the controller sends.
     * Printed as XERR 位置偏差值.
     * One count is 1 control unit. Range: -2147483648..2147483647.
     * Source: 3.2 L544-545
     */
    int32_t position_error;
    /**
     * The gain of the position controller.
     * Printed as KPC 位置控制器增益係數.
     * One count is 1/1000 1/s. Range: -2147483648..2147483647.
     * Source: 3.2 L546-547
     */
    int32_t position_controller_gain;
} hiwin_e_telegram_105_request;

/** Whether the values of hiwin_e_telegram_105_request may be written. */
static inline hiwin_e_codec_status hiwin_e_telegram_105_request_check(const hiwin_e_telegram_105_request *in)
{
    if (!(in->torque_reduction <= 16384u)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    return HIWIN_E_OK;
}

/** Writes hiwin_e_telegram_105_request to 20 bytes without checks. */
static inline void hiwin_e_telegram_105_request_pack(const hiwin_e_telegram_105_request *in, uint8_t *out)
{
    hiwin_e_store_u16_be(out + 0, in->control_word_1);
    hiwin_e_store_u32_be(out + 2, (uint32_t)in->speed_setpoint_b);
    hiwin_e_store_u16_be(out + 6, in->control_word_2);
    hiwin_e_store_u16_be(out + 8, in->torque_reduction);
    hiwin_e_store_u16_be(out + 10, in->encoder_1_control_word);
    hiwin_e_store_u32_be(out + 12, (uint32_t)in->position_error);
    hiwin_e_store_u32_be(out + 16, (uint32_t)in->position_controller_gain);
}

/** Reads hiwin_e_telegram_105_request from 20 bytes without checks. */
static inline void hiwin_e_telegram_105_request_unpack(const uint8_t *in, hiwin_e_telegram_105_request *out)
{
    out->control_word_1 = hiwin_e_load_u16_be(in + 0);
    out->speed_setpoint_b = hiwin_e_signed_32(hiwin_e_load_u32_be(in + 2));
    out->control_word_2 = hiwin_e_load_u16_be(in + 6);
    out->torque_reduction = hiwin_e_load_u16_be(in + 8);
    out->encoder_1_control_word = hiwin_e_load_u16_be(in + 10);
    out->position_error = hiwin_e_signed_32(hiwin_e_load_u32_be(in + 12));
    out->position_controller_gain = hiwin_e_signed_32(hiwin_e_load_u32_be(in + 16));
}

/**
 * Writes hiwin_e_telegram_105_request: 20 bytes.
 * `length` receives the number of bytes written.
 */
static inline hiwin_e_codec_status hiwin_e_telegram_105_request_encode(const hiwin_e_telegram_105_request *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    hiwin_e_codec_status status;
    if (capacity < 20u) {
        return HIWIN_E_ERR_CAPACITY;
    }
    status = hiwin_e_telegram_105_request_check(in);
    if (status != HIWIN_E_OK) {
        return status;
    }
    hiwin_e_telegram_105_request_pack(in, out);
    *length = 20u;
    return HIWIN_E_OK;
}

/** Reads hiwin_e_telegram_105_request from exactly 20 bytes. */
static inline hiwin_e_codec_status hiwin_e_telegram_105_request_decode(const uint8_t *in, size_t length,
        hiwin_e_telegram_105_request *out)
{
    if (length != 20u) {
        return length < 20u ? HIWIN_E_ERR_INCOMPLETE : HIWIN_E_ERR_WRONG_LENGTH;
    }
    hiwin_e_telegram_105_request_unpack(in, out);
    return HIWIN_E_OK;
}

typedef struct hiwin_e_telegram_105_response {
    /**
     * The state of the drive and, with telegrams 9 and 111, of its movements.
     * Printed as ZSW1 Status word 1.
     * Range: 0..65535. See status_word_1.
     * Source: 3.2 L538
     */
    uint16_t status_word_1;
    /**
     * The actual speed, as a share of the reference speed: Pt317 for rotary motors, Pt386 for linear ones.
     * Printed as NIST_B 速度實際值 B (32 位元).
     * One count is 100/2^30 %. Range: -2147483648..2147483647.
     * Source: 3.2 L539-540
     */
    int32_t speed_actual_b;
    /**
     * The sign of life of the drive.
     * Printed as ZSW2 Status word 2.
     * Range: 0..65535. See status_word_2_fixed_stop.
     * Source: 3.2 L541
     */
    uint16_t status_word_2;
    /**
     * Printed as MELDW Message word.
     * Range: 0..65535. See message_word.
     * Source: 3.2 L542
     */
    uint16_t message_word;
    /**
     * Printed as G1_ZSW 編碼器 1 status word.
     * Range: 0..65535. See encoder_1_status_word.
     * Source: 3.2 L543
     */
    uint16_t encoder_1_status_word;
    /**
     * Printed as G1_XIST1 編碼器 1 實際位置 1.
     * One count is 1 control unit. Range: -2147483648..2147483647.
     * Source: 3.2 L544-545
     */
    int32_t encoder_1_position_1;
    /**
     * Printed as G1_XIST2 編碼器 1 實際位置 2.
     * One count is 1 control unit. Range: -2147483648..2147483647.
     * Source: 3.2 L546-547
     */
    int32_t encoder_1_position_2;
} hiwin_e_telegram_105_response;

/** Writes hiwin_e_telegram_105_response to 20 bytes without checks. */
static inline void hiwin_e_telegram_105_response_pack(const hiwin_e_telegram_105_response *in, uint8_t *out)
{
    hiwin_e_store_u16_be(out + 0, in->status_word_1);
    hiwin_e_store_u32_be(out + 2, (uint32_t)in->speed_actual_b);
    hiwin_e_store_u16_be(out + 6, in->status_word_2);
    hiwin_e_store_u16_be(out + 8, in->message_word);
    hiwin_e_store_u16_be(out + 10, in->encoder_1_status_word);
    hiwin_e_store_u32_be(out + 12, (uint32_t)in->encoder_1_position_1);
    hiwin_e_store_u32_be(out + 16, (uint32_t)in->encoder_1_position_2);
}

/** Reads hiwin_e_telegram_105_response from 20 bytes without checks. */
static inline void hiwin_e_telegram_105_response_unpack(const uint8_t *in, hiwin_e_telegram_105_response *out)
{
    out->status_word_1 = hiwin_e_load_u16_be(in + 0);
    out->speed_actual_b = hiwin_e_signed_32(hiwin_e_load_u32_be(in + 2));
    out->status_word_2 = hiwin_e_load_u16_be(in + 6);
    out->message_word = hiwin_e_load_u16_be(in + 8);
    out->encoder_1_status_word = hiwin_e_load_u16_be(in + 10);
    out->encoder_1_position_1 = hiwin_e_signed_32(hiwin_e_load_u32_be(in + 12));
    out->encoder_1_position_2 = hiwin_e_signed_32(hiwin_e_load_u32_be(in + 16));
}

/**
 * Writes hiwin_e_telegram_105_response: 20 bytes.
 * `length` receives the number of bytes written.
 */
static inline hiwin_e_codec_status hiwin_e_telegram_105_response_encode(const hiwin_e_telegram_105_response *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    if (capacity < 20u) {
        return HIWIN_E_ERR_CAPACITY;
    }
    hiwin_e_telegram_105_response_pack(in, out);
    *length = 20u;
    return HIWIN_E_OK;
}

/** Reads hiwin_e_telegram_105_response from exactly 20 bytes. */
static inline hiwin_e_codec_status hiwin_e_telegram_105_response_decode(const uint8_t *in, size_t length,
        hiwin_e_telegram_105_response *out)
{
    if (length != 20u) {
        return length < 20u ? HIWIN_E_ERR_INCOMPLETE : HIWIN_E_ERR_WRONG_LENGTH;
    }
    hiwin_e_telegram_105_response_unpack(in, out);
    return HIWIN_E_OK;
}

typedef struct hiwin_e_telegram_111_request {
    /**
     * Switches the drive on and off and, with telegrams 9 and 111, moves it.
     * Printed as STW1 Control word 1.
     * Range: 0..65535. See control_word_1_positioning.
     * Source: 3.2 L551
     */
    uint16_t control_word_1;
    /**
     * Printed as POS_STW1 定位 control word 1.
     * Range: 0..65535. See positioning_control_word_1.
     * Source: 3.2 L552
     */
    uint16_t positioning_control_word_1;
    /**
     * Printed as POS_STW2 定位 control word 2.
     * Range: 0..65535. See positioning_control_word_2.
     * Source: 3.2 L553
     */
    uint16_t positioning_control_word_2;
    /**
     * The sign of life of the controller.
     * Printed as STW2 Control word 2.
     * Range: 0..65535. See control_word_2_fixed_stop.
     * Source: 3.2 L554
     */
    uint16_t control_word_2;
    /**
     * The share of the MDI velocity and, with telegram 111, of the jog speed that is run (6.8 L1670). The greatest
     * is one count less than 200 %.
     * Printed as OVERRIDE 速度命令 Override.
     * One count is 100/2^14 %. Range: 0..32767.
     * Source: 3.2 L555
     */
    uint16_t velocity_override;
    /**
     * The position, or in relative positioning the distance, of an MDI command.
     * Printed as MDI_TARPOS MDI 位置命令.
     * One count is 1 control unit. Range: -2147483648..2147483647.
     * Source: 3.2 L556-557
     */
    int32_t mdi_target_position;
    /**
     * The speed of an MDI command; OVERRIDE scales it. In the setup mode its direction is chosen in POS_STW1.
     * Printed as MDI_VELOCITY MDI 速度命令.
     * One count is 1000 control unit/min. Range: 0..2147483647.
     * Source: 3.2 L558-559
     */
    int32_t mdi_velocity;
    /**
     * The share of the acceleration that Pt534 sets.
     * Printed as MDI_ACC MDI 加速度命令 Override.
     * One count is 100/2^14 %. Range: 0..16384.
     * Source: 3.2 L559-560
     */
    uint16_t mdi_acceleration;
    /**
     * The share of the deceleration that Pt537 sets.
     * Printed as MDI_DEC MDI 減速度命令 Override.
     * One count is 100/2^14 %. Range: 0..16384.
     * Source: 3.2 L560-561
     */
    uint16_t mdi_deceleration;
} hiwin_e_telegram_111_request;

/** Whether the values of hiwin_e_telegram_111_request may be written. */
static inline hiwin_e_codec_status hiwin_e_telegram_111_request_check(const hiwin_e_telegram_111_request *in)
{
    if (!(in->velocity_override <= 32767u)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    if (!(in->mdi_velocity >= 0)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    if (!(in->mdi_acceleration <= 16384u)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    if (!(in->mdi_deceleration <= 16384u)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    return HIWIN_E_OK;
}

/** Writes hiwin_e_telegram_111_request to 24 bytes without checks. */
static inline void hiwin_e_telegram_111_request_pack(const hiwin_e_telegram_111_request *in, uint8_t *out)
{
    hiwin_e_store_u16_be(out + 0, in->control_word_1);
    hiwin_e_store_u16_be(out + 2, in->positioning_control_word_1);
    hiwin_e_store_u16_be(out + 4, in->positioning_control_word_2);
    hiwin_e_store_u16_be(out + 6, in->control_word_2);
    hiwin_e_store_u16_be(out + 8, in->velocity_override);
    hiwin_e_store_u32_be(out + 10, (uint32_t)in->mdi_target_position);
    hiwin_e_store_u32_be(out + 14, (uint32_t)in->mdi_velocity);
    hiwin_e_store_u16_be(out + 18, in->mdi_acceleration);
    hiwin_e_store_u16_be(out + 20, in->mdi_deceleration);
    hiwin_e_store_u16_be(out + 22, 0u);
}

/** Reads hiwin_e_telegram_111_request from 24 bytes without checks. */
static inline void hiwin_e_telegram_111_request_unpack(const uint8_t *in, hiwin_e_telegram_111_request *out)
{
    out->control_word_1 = hiwin_e_load_u16_be(in + 0);
    out->positioning_control_word_1 = hiwin_e_load_u16_be(in + 2);
    out->positioning_control_word_2 = hiwin_e_load_u16_be(in + 4);
    out->control_word_2 = hiwin_e_load_u16_be(in + 6);
    out->velocity_override = hiwin_e_load_u16_be(in + 8);
    out->mdi_target_position = hiwin_e_signed_32(hiwin_e_load_u32_be(in + 10));
    out->mdi_velocity = hiwin_e_signed_32(hiwin_e_load_u32_be(in + 14));
    out->mdi_acceleration = hiwin_e_load_u16_be(in + 18);
    out->mdi_deceleration = hiwin_e_load_u16_be(in + 20);
}

/**
 * Writes hiwin_e_telegram_111_request: 24 bytes.
 * `length` receives the number of bytes written.
 */
static inline hiwin_e_codec_status hiwin_e_telegram_111_request_encode(const hiwin_e_telegram_111_request *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    hiwin_e_codec_status status;
    if (capacity < 24u) {
        return HIWIN_E_ERR_CAPACITY;
    }
    status = hiwin_e_telegram_111_request_check(in);
    if (status != HIWIN_E_OK) {
        return status;
    }
    hiwin_e_telegram_111_request_pack(in, out);
    *length = 24u;
    return HIWIN_E_OK;
}

/** Reads hiwin_e_telegram_111_request from exactly 24 bytes. */
static inline hiwin_e_codec_status hiwin_e_telegram_111_request_decode(const uint8_t *in, size_t length,
        hiwin_e_telegram_111_request *out)
{
    if (length != 24u) {
        return length < 24u ? HIWIN_E_ERR_INCOMPLETE : HIWIN_E_ERR_WRONG_LENGTH;
    }
    hiwin_e_telegram_111_request_unpack(in, out);
    return HIWIN_E_OK;
}

typedef struct hiwin_e_telegram_111_response {
    /**
     * The state of the drive and, with telegrams 9 and 111, of its movements.
     * Printed as ZSW1 Status word 1.
     * Range: 0..65535. See status_word_1_positioning.
     * Source: 3.2 L551
     */
    uint16_t status_word_1;
    /**
     * Printed as POS_ZSW1 定位 status word 1.
     * Range: 0..65535. See positioning_status_word_1.
     * Source: 3.2 L552
     */
    uint16_t positioning_status_word_1;
    /**
     * Printed as POS_ZSW2 定位 status word 2.
     * Range: 0..65535. See positioning_status_word_2.
     * Source: 3.2 L553
     */
    uint16_t positioning_status_word_2;
    /**
     * The sign of life of the drive.
     * Printed as ZSW2 Status word 2.
     * Range: 0..65535. See status_word_2_positioning.
     * Source: 3.2 L554
     */
    uint16_t status_word_2;
    /**
     * Printed as MELDW Message word.
     * Range: 0..65535. See message_word.
     * Source: 3.2 L555
     */
    uint16_t message_word;
    /**
     * Printed as XIST_A 位置實際值 A.
     * One count is 1 control unit. Range: -2147483648..2147483647.
     * Source: 3.2 L556-557
     */
    int32_t position_actual_a;
    /**
     * The actual speed, as a share of the reference speed: Pt317 for rotary motors, Pt386 for linear ones.
     * Printed as NIST_B 速度實際值 B (32 位元).
     * One count is 100/2^30 %. Range: -2147483648..2147483647.
     * Source: 3.2 L558-559
     */
    int32_t speed_actual_b;
    /**
     * The alarm that the drive has.
     * Printed as FAULT_CODE 警報代碼.
     * Range: 0..65535. See alarm_code.
     * Source: 3.2 L559-560
     */
    uint16_t fault_code;
    /**
     * The warning that the drive has.
     * Printed as WARN_CODE 警告代碼.
     * Range: 0..65535. See warning_code.
     * Source: 3.2 L560-561
     */
    uint16_t warning_code;
} hiwin_e_telegram_111_response;

/** Writes hiwin_e_telegram_111_response to 24 bytes without checks. */
static inline void hiwin_e_telegram_111_response_pack(const hiwin_e_telegram_111_response *in, uint8_t *out)
{
    hiwin_e_store_u16_be(out + 0, in->status_word_1);
    hiwin_e_store_u16_be(out + 2, in->positioning_status_word_1);
    hiwin_e_store_u16_be(out + 4, in->positioning_status_word_2);
    hiwin_e_store_u16_be(out + 6, in->status_word_2);
    hiwin_e_store_u16_be(out + 8, in->message_word);
    hiwin_e_store_u32_be(out + 10, (uint32_t)in->position_actual_a);
    hiwin_e_store_u32_be(out + 14, (uint32_t)in->speed_actual_b);
    hiwin_e_store_u16_be(out + 18, in->fault_code);
    hiwin_e_store_u16_be(out + 20, in->warning_code);
    hiwin_e_store_u16_be(out + 22, 0u);
}

/** Reads hiwin_e_telegram_111_response from 24 bytes without checks. */
static inline void hiwin_e_telegram_111_response_unpack(const uint8_t *in, hiwin_e_telegram_111_response *out)
{
    out->status_word_1 = hiwin_e_load_u16_be(in + 0);
    out->positioning_status_word_1 = hiwin_e_load_u16_be(in + 2);
    out->positioning_status_word_2 = hiwin_e_load_u16_be(in + 4);
    out->status_word_2 = hiwin_e_load_u16_be(in + 6);
    out->message_word = hiwin_e_load_u16_be(in + 8);
    out->position_actual_a = hiwin_e_signed_32(hiwin_e_load_u32_be(in + 10));
    out->speed_actual_b = hiwin_e_signed_32(hiwin_e_load_u32_be(in + 14));
    out->fault_code = hiwin_e_load_u16_be(in + 18);
    out->warning_code = hiwin_e_load_u16_be(in + 20);
}

/**
 * Writes hiwin_e_telegram_111_response: 24 bytes.
 * `length` receives the number of bytes written.
 */
static inline hiwin_e_codec_status hiwin_e_telegram_111_response_encode(const hiwin_e_telegram_111_response *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    if (capacity < 24u) {
        return HIWIN_E_ERR_CAPACITY;
    }
    hiwin_e_telegram_111_response_pack(in, out);
    *length = 24u;
    return HIWIN_E_OK;
}

/** Reads hiwin_e_telegram_111_response from exactly 24 bytes. */
static inline hiwin_e_codec_status hiwin_e_telegram_111_response_decode(const uint8_t *in, size_t length,
        hiwin_e_telegram_111_response *out)
{
    if (length != 24u) {
        return length < 24u ? HIWIN_E_ERR_INCOMPLETE : HIWIN_E_ERR_WRONG_LENGTH;
    }
    hiwin_e_telegram_111_response_unpack(in, out);
    return HIWIN_E_OK;
}

typedef struct hiwin_e_telegram_750_request {
    /**
     * A torque that is added, as a share of the reference torque: it holds a vertical axis when the motor is
     * excited.
     * Printed as M_ADD1 附加轉矩值.
     * One count is 100/2^14 %. Range: -32768..32767.
     * Source: 3.2 L568
     */
    int16_t additional_torque;
    /**
     * The limit in the positive direction, as a share of the reference torque. The lesser of this and Pt402 or
     * Pt483 counts.
     * Printed as M_LIMIT_POS 轉矩上限值.
     * One count is 100/2^14 %. Range: 0..32767.
     * Source: 3.2 L569
     */
    int16_t positive_torque_limit;
    /**
     * The limit in the negative direction, a negative share of the reference torque. The lesser of this and Pt403
     * or Pt484 counts.
     * Printed as M_LIMIT_NEG 轉矩下限值.
     * One count is 100/2^14 %. Range: -32768..0.
     * Source: 3.2 L570
     */
    int16_t negative_torque_limit;
} hiwin_e_telegram_750_request;

/** Whether the values of hiwin_e_telegram_750_request may be written. */
static inline hiwin_e_codec_status hiwin_e_telegram_750_request_check(const hiwin_e_telegram_750_request *in)
{
    if (!(in->positive_torque_limit >= 0)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    if (!(in->negative_torque_limit <= 0)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    return HIWIN_E_OK;
}

/** Writes hiwin_e_telegram_750_request to 6 bytes without checks. */
static inline void hiwin_e_telegram_750_request_pack(const hiwin_e_telegram_750_request *in, uint8_t *out)
{
    hiwin_e_store_u16_be(out + 0, (uint16_t)in->additional_torque);
    hiwin_e_store_u16_be(out + 2, (uint16_t)in->positive_torque_limit);
    hiwin_e_store_u16_be(out + 4, (uint16_t)in->negative_torque_limit);
}

/** Reads hiwin_e_telegram_750_request from 6 bytes without checks. */
static inline void hiwin_e_telegram_750_request_unpack(const uint8_t *in, hiwin_e_telegram_750_request *out)
{
    out->additional_torque = hiwin_e_signed_16(hiwin_e_load_u16_be(in + 0));
    out->positive_torque_limit = hiwin_e_signed_16(hiwin_e_load_u16_be(in + 2));
    out->negative_torque_limit = hiwin_e_signed_16(hiwin_e_load_u16_be(in + 4));
}

/**
 * Writes hiwin_e_telegram_750_request: 6 bytes.
 * `length` receives the number of bytes written.
 */
static inline hiwin_e_codec_status hiwin_e_telegram_750_request_encode(const hiwin_e_telegram_750_request *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    hiwin_e_codec_status status;
    if (capacity < 6u) {
        return HIWIN_E_ERR_CAPACITY;
    }
    status = hiwin_e_telegram_750_request_check(in);
    if (status != HIWIN_E_OK) {
        return status;
    }
    hiwin_e_telegram_750_request_pack(in, out);
    *length = 6u;
    return HIWIN_E_OK;
}

/** Reads hiwin_e_telegram_750_request from exactly 6 bytes. */
static inline hiwin_e_codec_status hiwin_e_telegram_750_request_decode(const uint8_t *in, size_t length,
        hiwin_e_telegram_750_request *out)
{
    if (length != 6u) {
        return length < 6u ? HIWIN_E_ERR_INCOMPLETE : HIWIN_E_ERR_WRONG_LENGTH;
    }
    hiwin_e_telegram_750_request_unpack(in, out);
    return HIWIN_E_OK;
}

typedef struct hiwin_e_telegram_750_response {
    /**
     * The torque that the motor gives, as a share of the reference torque: Pt42A for rotary motors, the force
     * Pt43A for linear ones.
     * Printed as M_ACT 實際轉矩值.
     * One count is 100/2^14 %. Range: -32768..32767.
     * Source: 3.2 L568
     */
    int16_t torque_actual;
} hiwin_e_telegram_750_response;

/** Writes hiwin_e_telegram_750_response to 2 bytes without checks. */
static inline void hiwin_e_telegram_750_response_pack(const hiwin_e_telegram_750_response *in, uint8_t *out)
{
    hiwin_e_store_u16_be(out + 0, (uint16_t)in->torque_actual);
}

/** Reads hiwin_e_telegram_750_response from 2 bytes without checks. */
static inline void hiwin_e_telegram_750_response_unpack(const uint8_t *in, hiwin_e_telegram_750_response *out)
{
    out->torque_actual = hiwin_e_signed_16(hiwin_e_load_u16_be(in + 0));
}

/**
 * Writes hiwin_e_telegram_750_response: 2 bytes.
 * `length` receives the number of bytes written.
 */
static inline hiwin_e_codec_status hiwin_e_telegram_750_response_encode(const hiwin_e_telegram_750_response *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    if (capacity < 2u) {
        return HIWIN_E_ERR_CAPACITY;
    }
    hiwin_e_telegram_750_response_pack(in, out);
    *length = 2u;
    return HIWIN_E_OK;
}

/** Reads hiwin_e_telegram_750_response from exactly 2 bytes. */
static inline hiwin_e_codec_status hiwin_e_telegram_750_response_decode(const uint8_t *in, size_t length,
        hiwin_e_telegram_750_response *out)
{
    if (length != 2u) {
        return length < 2u ? HIWIN_E_ERR_INCOMPLETE : HIWIN_E_ERR_WRONG_LENGTH;
    }
    hiwin_e_telegram_750_response_unpack(in, out);
    return HIWIN_E_OK;
}

/* ---- Parameters ---- */

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_motor_type_decode(const uint8_t *in,
        hiwin_e_motor_type *out)
{
    const uint16_t number = hiwin_e_load_u16_be(in);
    if (!hiwin_e_motor_type_known((int64_t)number)) {
        return HIWIN_E_ERR_UNKNOWN_VALUE;
    }
    *out = (hiwin_e_motor_type)number;
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_motor_type_encode(hiwin_e_motor_type value,
        uint8_t *out)
{
    if (!hiwin_e_motor_type_known((int64_t)value)) {
        return HIWIN_E_ERR_UNKNOWN_VALUE;
    }
    hiwin_e_store_u16_be(out, (uint16_t)value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_inner_encoder_resolution_decode(const uint8_t *in,
        int32_t *out)
{
    *out = hiwin_e_signed_32(hiwin_e_load_u32_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_inner_encoder_resolution_encode(int32_t value,
        uint8_t *out)
{
    hiwin_e_store_u32_be(out, (uint32_t)value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_digital_outputs_decode(const uint8_t *in, uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_digital_outputs_encode(uint16_t value, uint8_t *out)
{
    if (!(value <= 31u)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_software_state_12_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_software_state_12_encode(uint16_t value, uint8_t *out)
{
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_gantry_application_mode_decode(const uint8_t *in,
        hiwin_e_gantry_application_mode *out)
{
    const uint16_t number = hiwin_e_load_u16_be(in);
    if (!hiwin_e_gantry_application_mode_known((int64_t)number)) {
        return HIWIN_E_ERR_UNKNOWN_VALUE;
    }
    *out = (hiwin_e_gantry_application_mode)number;
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_gantry_application_mode_encode(hiwin_e_gantry_application_mode value,
        uint8_t *out)
{
    if (!hiwin_e_gantry_application_mode_known((int64_t)value)) {
        return HIWIN_E_ERR_UNKNOWN_VALUE;
    }
    hiwin_e_store_u16_be(out, (uint16_t)value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_yaw_target_position_decode(const uint8_t *in,
        int32_t *out)
{
    *out = hiwin_e_signed_32(hiwin_e_load_u32_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_yaw_target_position_encode(int32_t value, uint8_t *out)
{
    hiwin_e_store_u32_be(out, (uint32_t)value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_yaw_feedback_position_decode(const uint8_t *in,
        int32_t *out)
{
    *out = hiwin_e_signed_32(hiwin_e_load_u32_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_yaw_feedback_position_encode(int32_t value,
        uint8_t *out)
{
    hiwin_e_store_u32_be(out, (uint32_t)value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_master_feedback_position_decode(const uint8_t *in,
        int32_t *out)
{
    *out = hiwin_e_signed_32(hiwin_e_load_u32_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_master_feedback_position_encode(int32_t value,
        uint8_t *out)
{
    hiwin_e_store_u32_be(out, (uint32_t)value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_slave_feedback_position_decode(const uint8_t *in,
        int32_t *out)
{
    *out = hiwin_e_signed_32(hiwin_e_load_u32_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_slave_feedback_position_encode(int32_t value,
        uint8_t *out)
{
    hiwin_e_store_u32_be(out, (uint32_t)value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_reference_mark_functions_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_reference_mark_functions_encode(uint16_t value,
        uint8_t *out)
{
    if (!(value <= 3u)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_position_trigger_enabled_decode(const uint8_t *in,
        bool *out)
{
    *out = hiwin_e_load_u16_be(in) != 0;
    if (hiwin_e_load_u16_be(in) > 1u) {
        return HIWIN_E_ERR_UNKNOWN_VALUE;
    }
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_position_trigger_enabled_encode(bool value,
        uint8_t *out)
{
    hiwin_e_store_u16_be(out, (uint16_t)(value ? 1 : 0));
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_speed_analog_input_voltage_decode(const uint8_t *in,
        int16_t *out)
{
    *out = hiwin_e_signed_16(hiwin_e_load_u16_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_speed_analog_input_voltage_encode(int16_t value,
        uint8_t *out)
{
    if (!(value >= (-10000) && value <= 10000)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u16_be(out, (uint16_t)value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_speed_analog_input_offset_decode(const uint8_t *in,
        int16_t *out)
{
    *out = hiwin_e_signed_16(hiwin_e_load_u16_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_speed_analog_input_offset_encode(int16_t value,
        uint8_t *out)
{
    if (!(value >= (-10000) && value <= 10000)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u16_be(out, (uint16_t)value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_torque_analog_input_voltage_decode(const uint8_t *in,
        int16_t *out)
{
    *out = hiwin_e_signed_16(hiwin_e_load_u16_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_torque_analog_input_voltage_encode(int16_t value,
        uint8_t *out)
{
    if (!(value >= (-10000) && value <= 10000)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u16_be(out, (uint16_t)value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_torque_analog_input_offset_decode(const uint8_t *in,
        int16_t *out)
{
    *out = hiwin_e_signed_16(hiwin_e_load_u16_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_torque_analog_input_offset_encode(int16_t value,
        uint8_t *out)
{
    if (!(value >= (-10000) && value <= 10000)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u16_be(out, (uint16_t)value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_analog_output_1_voltage_decode(const uint8_t *in,
        int16_t *out)
{
    *out = hiwin_e_signed_16(hiwin_e_load_u16_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_analog_output_1_voltage_encode(int16_t value,
        uint8_t *out)
{
    if (!(value >= (-10000) && value <= 10000)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u16_be(out, (uint16_t)value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_analog_output_2_voltage_decode(const uint8_t *in,
        int16_t *out)
{
    *out = hiwin_e_signed_16(hiwin_e_load_u16_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_analog_output_2_voltage_encode(int16_t value,
        uint8_t *out)
{
    if (!(value >= (-10000) && value <= 10000)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u16_be(out, (uint16_t)value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_position_trigger_array_value_decode(const uint8_t *in,
        int32_t *out)
{
    *out = hiwin_e_signed_32(hiwin_e_load_u32_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_position_trigger_array_value_encode(int32_t value,
        uint8_t *out)
{
    hiwin_e_store_u32_be(out, (uint32_t)value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_position_trigger_array_index_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_position_trigger_array_index_encode(uint16_t value,
        uint8_t *out)
{
    if (!(value <= 255u)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_position_trigger_array_control_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_position_trigger_array_control_encode(uint16_t value,
        uint8_t *out)
{
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_position_trigger_error_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_position_trigger_error_encode(uint16_t value,
        uint8_t *out)
{
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_position_trigger_status_decode(const uint8_t *in,
        int16_t *out)
{
    *out = hiwin_e_signed_16(hiwin_e_load_u16_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_position_trigger_status_encode(int16_t value,
        uint8_t *out)
{
    if (!(value >= 0)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u16_be(out, (uint16_t)value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_expected_position_trigger_count_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_expected_position_trigger_count_encode(uint16_t value,
        uint8_t *out)
{
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_position_trigger_count_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_position_trigger_count_encode(uint16_t value,
        uint8_t *out)
{
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_remaining_position_trigger_count_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_remaining_position_trigger_count_encode(uint16_t value,
        uint8_t *out)
{
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_gantry_parameter_index_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_gantry_parameter_index_encode(uint16_t value,
        uint8_t *out)
{
    if (!(value >= 8192u && value <= 20479u)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_gantry_parameter_subindex_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_gantry_parameter_subindex_encode(uint16_t value,
        uint8_t *out)
{
    if (!(value == 0u)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_gantry_parameter_type_decode(const uint8_t *in,
        int16_t *out)
{
    *out = hiwin_e_signed_16(hiwin_e_load_u16_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_gantry_parameter_type_encode(int16_t value,
        uint8_t *out)
{
    if (!(value >= (-3) && value <= 8)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u16_be(out, (uint16_t)value);
    return HIWIN_E_OK;
}

/**
 * Decodes the value.
 * An integer, as the device may answer what gantry_parameter_command does not have.
 */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_gantry_parameter_command_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_gantry_parameter_command_encode(hiwin_e_gantry_parameter_command value,
        uint8_t *out)
{
    if (!hiwin_e_gantry_parameter_command_known((int64_t)value)) {
        return HIWIN_E_ERR_UNKNOWN_VALUE;
    }
    hiwin_e_store_u16_be(out, (uint16_t)value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_gantry_parameter_status_decode(const uint8_t *in,
        hiwin_e_gantry_parameter_status *out)
{
    const int16_t number = hiwin_e_signed_16(hiwin_e_load_u16_be(in));
    if (!hiwin_e_gantry_parameter_status_known((int64_t)number)) {
        return HIWIN_E_ERR_UNKNOWN_VALUE;
    }
    *out = (hiwin_e_gantry_parameter_status)number;
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_gantry_parameter_status_encode(hiwin_e_gantry_parameter_status value,
        uint8_t *out)
{
    if (!hiwin_e_gantry_parameter_status_known((int64_t)value)) {
        return HIWIN_E_ERR_UNKNOWN_VALUE;
    }
    hiwin_e_store_u16_be(out, (uint16_t)value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_gantry_integer_input_decode(const uint8_t *in,
        int32_t *out)
{
    *out = hiwin_e_signed_32(hiwin_e_load_u32_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_gantry_integer_input_encode(int32_t value, uint8_t *out)
{
    hiwin_e_store_u32_be(out, (uint32_t)value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_gantry_integer_output_decode(const uint8_t *in,
        int32_t *out)
{
    *out = hiwin_e_signed_32(hiwin_e_load_u32_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_gantry_integer_output_encode(int32_t value,
        uint8_t *out)
{
    hiwin_e_store_u32_be(out, (uint32_t)value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_gantry_float_input_decode(const uint8_t *in, float *out)
{
    *out = hiwin_e_float_of(hiwin_e_load_u32_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_gantry_float_input_encode(float value, uint8_t *out)
{
    hiwin_e_store_u32_be(out, hiwin_e_bits_of(value));
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_gantry_float_output_decode(const uint8_t *in,
        float *out)
{
    *out = hiwin_e_float_of(hiwin_e_load_u32_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_gantry_float_output_encode(float value, uint8_t *out)
{
    hiwin_e_store_u32_be(out, hiwin_e_bits_of(value));
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_drive_warnings_1_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_drive_warnings_1_encode(uint16_t value, uint8_t *out)
{
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_drive_warnings_2_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_drive_warnings_2_encode(uint16_t value, uint8_t *out)
{
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_operation_warnings_decode(const uint8_t *in,
        uint32_t *out)
{
    *out = hiwin_e_load_u32_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_operation_warnings_encode(uint32_t value, uint8_t *out)
{
    hiwin_e_store_u32_be(out, value);
    return HIWIN_E_OK;
}

/**
 * Decodes the value.
 * An integer, as the device may answer what absolute_encoder_initialization does not have.
 */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_absolute_encoder_initialization_decode(const uint8_t *in,
        int32_t *out)
{
    *out = hiwin_e_signed_32(hiwin_e_load_u32_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_absolute_encoder_initialization_encode(hiwin_e_absolute_encoder_initialization value,
        uint8_t *out)
{
    const int64_t number = (int64_t)value;
    if (!hiwin_e_absolute_encoder_initialization_known((int64_t)value)) {
        return HIWIN_E_ERR_UNKNOWN_VALUE;
    }
    if (!(number >= 0 && number <= 1)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u32_be(out, (uint32_t)value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_general_integer_1_decode(const uint8_t *in,
        int32_t *out)
{
    *out = hiwin_e_signed_32(hiwin_e_load_u32_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_general_integer_1_encode(int32_t value, uint8_t *out)
{
    hiwin_e_store_u32_be(out, (uint32_t)value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_general_integer_2_decode(const uint8_t *in,
        int32_t *out)
{
    *out = hiwin_e_signed_32(hiwin_e_load_u32_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_general_integer_2_encode(int32_t value, uint8_t *out)
{
    hiwin_e_store_u32_be(out, (uint32_t)value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_general_integer_3_decode(const uint8_t *in,
        int32_t *out)
{
    *out = hiwin_e_signed_32(hiwin_e_load_u32_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_general_integer_3_encode(int32_t value, uint8_t *out)
{
    hiwin_e_store_u32_be(out, (uint32_t)value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_general_integer_4_decode(const uint8_t *in,
        int32_t *out)
{
    *out = hiwin_e_signed_32(hiwin_e_load_u32_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_general_integer_4_encode(int32_t value, uint8_t *out)
{
    hiwin_e_store_u32_be(out, (uint32_t)value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_general_integer_5_decode(const uint8_t *in,
        int32_t *out)
{
    *out = hiwin_e_signed_32(hiwin_e_load_u32_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_general_integer_5_encode(int32_t value, uint8_t *out)
{
    hiwin_e_store_u32_be(out, (uint32_t)value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_general_integer_6_decode(const uint8_t *in,
        int32_t *out)
{
    *out = hiwin_e_signed_32(hiwin_e_load_u32_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_general_integer_6_encode(int32_t value, uint8_t *out)
{
    hiwin_e_store_u32_be(out, (uint32_t)value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_general_integer_7_decode(const uint8_t *in,
        int32_t *out)
{
    *out = hiwin_e_signed_32(hiwin_e_load_u32_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_general_integer_7_encode(int32_t value, uint8_t *out)
{
    hiwin_e_store_u32_be(out, (uint32_t)value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_general_integer_8_decode(const uint8_t *in,
        int32_t *out)
{
    *out = hiwin_e_signed_32(hiwin_e_load_u32_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_general_integer_8_encode(int32_t value, uint8_t *out)
{
    hiwin_e_store_u32_be(out, (uint32_t)value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_general_integer_9_decode(const uint8_t *in,
        int32_t *out)
{
    *out = hiwin_e_signed_32(hiwin_e_load_u32_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_general_integer_9_encode(int32_t value, uint8_t *out)
{
    hiwin_e_store_u32_be(out, (uint32_t)value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_general_float_0_decode(const uint8_t *in, float *out)
{
    *out = hiwin_e_float_of(hiwin_e_load_u32_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_general_float_0_encode(float value, uint8_t *out)
{
    hiwin_e_store_u32_be(out, hiwin_e_bits_of(value));
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_general_float_1_decode(const uint8_t *in, float *out)
{
    *out = hiwin_e_float_of(hiwin_e_load_u32_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_general_float_1_encode(float value, uint8_t *out)
{
    hiwin_e_store_u32_be(out, hiwin_e_bits_of(value));
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_general_float_2_decode(const uint8_t *in, float *out)
{
    *out = hiwin_e_float_of(hiwin_e_load_u32_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_general_float_2_encode(float value, uint8_t *out)
{
    hiwin_e_store_u32_be(out, hiwin_e_bits_of(value));
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_general_float_3_decode(const uint8_t *in, float *out)
{
    *out = hiwin_e_float_of(hiwin_e_load_u32_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_general_float_3_encode(float value, uint8_t *out)
{
    hiwin_e_store_u32_be(out, hiwin_e_bits_of(value));
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_general_float_4_decode(const uint8_t *in, float *out)
{
    *out = hiwin_e_float_of(hiwin_e_load_u32_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_general_float_4_encode(float value, uint8_t *out)
{
    hiwin_e_store_u32_be(out, hiwin_e_bits_of(value));
    return HIWIN_E_OK;
}

/**
 * Decodes the value.
 * An integer, as the device may answer what drive_reset does not have.
 */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_drive_reset_decode(const uint8_t *in, int16_t *out)
{
    *out = hiwin_e_signed_16(hiwin_e_load_u16_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_drive_reset_encode(hiwin_e_drive_reset value,
        uint8_t *out)
{
    if (!hiwin_e_drive_reset_known((int64_t)value)) {
        return HIWIN_E_ERR_UNKNOWN_VALUE;
    }
    hiwin_e_store_u16_be(out, (uint16_t)value);
    return HIWIN_E_OK;
}

/**
 * Decodes the value.
 * An integer, as the device may answer what parameter_save does not have.
 */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_parameter_save_decode(const uint8_t *in, int16_t *out)
{
    *out = hiwin_e_signed_16(hiwin_e_load_u16_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_parameter_save_encode(hiwin_e_parameter_save value,
        uint8_t *out)
{
    if (!hiwin_e_parameter_save_known((int64_t)value)) {
        return HIWIN_E_ERR_UNKNOWN_VALUE;
    }
    hiwin_e_store_u16_be(out, (uint16_t)value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_mastership_decode(const uint8_t *in,
        hiwin_e_mastership *out)
{
    const int16_t number = hiwin_e_signed_16(hiwin_e_load_u16_be(in));
    if (!hiwin_e_mastership_known((int64_t)number)) {
        return HIWIN_E_ERR_UNKNOWN_VALUE;
    }
    *out = (hiwin_e_mastership)number;
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_drive_parameters_mastership_encode(hiwin_e_mastership value,
        uint8_t *out)
{
    if (!hiwin_e_mastership_known((int64_t)value)) {
        return HIWIN_E_ERR_UNKNOWN_VALUE;
    }
    hiwin_e_store_u16_be(out, (uint16_t)value);
    return HIWIN_E_OK;
}

/** A number of the set as it is on the wire: 0x4000 for Ut000. Other numbers are refused. */
static inline hiwin_e_codec_status hiwin_e_par_monitoring_parameters_wire_number(uint32_t number, uint16_t *out)
{
    if (!(number <= 0x0FFFu)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    *out = (uint16_t)(HIWIN_E_PAR_MONITORING_PARAMETERS_BASE + number);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_monitoring_parameters_digital_output_states_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_monitoring_parameters_digital_output_states_encode(uint16_t value,
        uint8_t *out)
{
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_monitoring_parameters_alarm_decode(const uint8_t *in, uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_monitoring_parameters_alarm_encode(uint16_t value, uint8_t *out)
{
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_monitoring_parameters_warning_decode(const uint8_t *in, uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_monitoring_parameters_warning_encode(uint16_t value, uint8_t *out)
{
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_telegram_selection_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_telegram_selection_encode(uint16_t value,
        uint8_t *out)
{
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_sign_of_life_failure_tolerance_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_sign_of_life_failure_tolerance_encode(uint16_t value,
        uint8_t *out)
{
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_operating_mode_decode(const uint8_t *in,
        hiwin_e_operating_mode *out)
{
    const uint16_t number = hiwin_e_load_u16_be(in);
    if (!hiwin_e_operating_mode_known((int64_t)number)) {
        return HIWIN_E_ERR_UNKNOWN_VALUE;
    }
    *out = (hiwin_e_operating_mode)number;
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_operating_mode_encode(hiwin_e_operating_mode value,
        uint8_t *out)
{
    if (!hiwin_e_operating_mode_known((int64_t)value)) {
        return HIWIN_E_ERR_UNKNOWN_VALUE;
    }
    hiwin_e_store_u16_be(out, (uint16_t)value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_alarm_counter_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_alarm_counter_encode(uint16_t value, uint8_t *out)
{
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_alarm_codes_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_alarm_codes_encode(uint16_t value, uint8_t *out)
{
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_internal_alarm_codes_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_internal_alarm_codes_encode(uint16_t value,
        uint8_t *out)
{
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_alarm_buffer_capacity_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_alarm_buffer_capacity_encode(uint16_t value,
        uint8_t *out)
{
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_alarm_buffer_capacity_block_count_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_alarm_buffer_capacity_block_count_encode(uint16_t value,
        uint8_t *out)
{
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_alarm_buffer_capacity_alarms_per_block_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_alarm_buffer_capacity_alarms_per_block_encode(uint16_t value,
        uint8_t *out)
{
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_alarm_block_counter_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_alarm_block_counter_encode(uint16_t value,
        uint8_t *out)
{
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_drive_identification_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_drive_identification_encode(uint16_t value,
        uint8_t *out)
{
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_drive_identification_manufacturer_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_drive_identification_manufacturer_encode(uint8_t *out)
{
    hiwin_e_store_u16_be(out, 2730u);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_drive_identification_drive_unit_type_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_drive_identification_drive_unit_type_encode(uint8_t *out)
{
    hiwin_e_store_u16_be(out, 5u);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_drive_identification_firmware_version_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_drive_identification_firmware_version_encode(uint16_t value,
        uint8_t *out)
{
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_drive_identification_firmware_year_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_drive_identification_firmware_year_encode(uint16_t value,
        uint8_t *out)
{
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_drive_identification_firmware_day_and_month_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_drive_identification_firmware_day_and_month_encode(uint16_t value,
        uint8_t *out)
{
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_drive_identification_drive_object_count_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_drive_identification_drive_object_count_encode(uint8_t *out)
{
    hiwin_e_store_u16_be(out, 1u);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_drive_identification_minor_firmware_version_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_drive_identification_minor_firmware_version_encode(uint16_t value,
        uint8_t *out)
{
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_encoder_format_decode(const uint8_t *in,
        uint32_t *out)
{
    *out = hiwin_e_load_u32_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_encoder_format_encode(uint32_t value, uint8_t *out)
{
    hiwin_e_store_u32_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_encoder_format_header_decode(const uint8_t *in,
        uint32_t *out)
{
    *out = hiwin_e_load_u32_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_encoder_format_header_encode(uint32_t value,
        uint8_t *out)
{
    hiwin_e_store_u32_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_encoder_format_encoder_type_decode(const uint8_t *in,
        uint32_t *out)
{
    *out = hiwin_e_load_u32_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_encoder_format_encoder_type_encode(uint32_t value,
        uint8_t *out)
{
    hiwin_e_store_u32_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_encoder_format_encoder_resolution_decode(const uint8_t *in,
        uint32_t *out)
{
    *out = hiwin_e_load_u32_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_encoder_format_encoder_resolution_encode(uint32_t value,
        uint8_t *out)
{
    hiwin_e_store_u32_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_encoder_format_actual_position_1_shift_decode(const uint8_t *in,
        uint32_t *out)
{
    *out = hiwin_e_load_u32_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_encoder_format_actual_position_1_shift_encode(uint32_t value,
        uint8_t *out)
{
    hiwin_e_store_u32_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_encoder_format_actual_position_2_shift_decode(const uint8_t *in,
        uint32_t *out)
{
    *out = hiwin_e_load_u32_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_encoder_format_actual_position_2_shift_encode(uint32_t value,
        uint8_t *out)
{
    hiwin_e_store_u32_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_encoder_format_maximum_turn_count_decode(const uint8_t *in,
        uint32_t *out)
{
    *out = hiwin_e_load_u32_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_profidrive_parameters_encoder_format_maximum_turn_count_encode(uint32_t value,
        uint8_t *out)
{
    hiwin_e_store_u32_be(out, value);
    return HIWIN_E_OK;
}

/** A number of the set as it is on the wire: 0x2000 for Pt000. Other numbers are refused. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_wire_number(uint32_t number, uint16_t *out)
{
    if (!(number <= 0x0FFFu)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    *out = (uint16_t)(HIWIN_E_PAR_SERVO_PARAMETERS_BASE + number);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_basic_function_switch_1_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_basic_function_switch_1_encode(uint16_t value,
        uint8_t *out)
{
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_quick_stop_deceleration_time_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_quick_stop_deceleration_time_encode(uint16_t value,
        uint8_t *out)
{
    if (!(value <= 10000u)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_maximum_speed_rotary_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_maximum_speed_rotary_encode(uint16_t value,
        uint8_t *out)
{
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_reference_speed_rotary_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_reference_speed_rotary_encode(uint16_t value,
        uint8_t *out)
{
    if (!(value >= 1u)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_maximum_speed_linear_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_maximum_speed_linear_encode(uint16_t value,
        uint8_t *out)
{
    if (!(value <= 100u)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_reference_speed_linear_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_reference_speed_linear_encode(uint16_t value,
        uint8_t *out)
{
    if (!(value >= 1u && value <= 100u)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_positive_torque_limit_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_positive_torque_limit_encode(uint16_t value,
        uint8_t *out)
{
    if (!(value <= 800u)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_negative_torque_limit_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_negative_torque_limit_encode(uint16_t value,
        uint8_t *out)
{
    if (!(value <= 800u)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_reference_torque_decode(const uint8_t *in,
        uint32_t *out)
{
    *out = hiwin_e_load_u32_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_reference_torque_encode(uint32_t value, uint8_t *out)
{
    if (!(value <= 2147483647u)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u32_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_positive_fixed_stop_tolerance_decode(const uint8_t *in,
        uint32_t *out)
{
    *out = hiwin_e_load_u32_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_positive_fixed_stop_tolerance_encode(uint32_t value,
        uint8_t *out)
{
    if (!(value <= 2147483647u)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u32_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_negative_fixed_stop_tolerance_decode(const uint8_t *in,
        uint32_t *out)
{
    *out = hiwin_e_load_u32_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_negative_fixed_stop_tolerance_encode(uint32_t value,
        uint8_t *out)
{
    if (!(value <= 2147483647u)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u32_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_positive_fixed_stop_torque_decode(const uint8_t *in,
        uint32_t *out)
{
    *out = hiwin_e_load_u32_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_positive_fixed_stop_torque_encode(uint32_t value,
        uint8_t *out)
{
    if (!(value <= 2147483647u)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u32_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_negative_fixed_stop_torque_decode(const uint8_t *in,
        uint32_t *out)
{
    *out = hiwin_e_load_u32_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_negative_fixed_stop_torque_encode(uint32_t value,
        uint8_t *out)
{
    if (!(value <= 2147483647u)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u32_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_fixed_stop_following_error_decode(const uint8_t *in,
        uint32_t *out)
{
    *out = hiwin_e_load_u32_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_fixed_stop_following_error_encode(uint32_t value,
        uint8_t *out)
{
    if (!(value <= 2147483647u)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u32_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_reference_force_decode(const uint8_t *in, uint32_t *out)
{
    *out = hiwin_e_load_u32_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_reference_force_encode(uint32_t value, uint8_t *out)
{
    if (!(value <= 2147483647u)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u32_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_positive_force_limit_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_positive_force_limit_encode(uint16_t value,
        uint8_t *out)
{
    if (!(value <= 800u)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_negative_force_limit_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_negative_force_limit_encode(uint16_t value,
        uint8_t *out)
{
    if (!(value <= 800u)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_point_to_point_speed_rotary_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_point_to_point_speed_rotary_encode(uint16_t value,
        uint8_t *out)
{
    if (!(value >= 1u && value <= 10000u)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_point_to_point_acceleration_time_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_point_to_point_acceleration_time_encode(uint16_t value,
        uint8_t *out)
{
    if (!(value >= 2u && value <= 10000u)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_point_to_point_deceleration_time_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_point_to_point_deceleration_time_encode(uint16_t value,
        uint8_t *out)
{
    if (!(value >= 2u && value <= 10000u)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_point_to_point_emergency_deceleration_time_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_point_to_point_emergency_deceleration_time_encode(uint16_t value,
        uint8_t *out)
{
    if (!(value >= 2u && value <= 10000u)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_point_to_point_distance_decode(const uint8_t *in,
        int32_t *out)
{
    *out = hiwin_e_signed_32(hiwin_e_load_u32_be(in));
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_point_to_point_distance_encode(int32_t value,
        uint8_t *out)
{
    if (!(value >= 1 && value <= 1073741824)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u32_be(out, (uint32_t)value);
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_jog_direction_reversed_decode(const uint8_t *in,
        bool *out)
{
    *out = hiwin_e_load_u16_be(in) != 0;
    if (hiwin_e_load_u16_be(in) > 1u) {
        return HIWIN_E_ERR_UNKNOWN_VALUE;
    }
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_jog_direction_reversed_encode(bool value, uint8_t *out)
{
    hiwin_e_store_u16_be(out, (uint16_t)(value ? 1 : 0));
    return HIWIN_E_OK;
}

/** Decodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_point_to_point_speed_linear_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = hiwin_e_load_u16_be(in);
    return HIWIN_E_OK;
}

/** Encodes the value. */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_point_to_point_speed_linear_encode(uint16_t value,
        uint8_t *out)
{
    if (!(value >= 1u && value <= 10000u)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u16_be(out, value);
    return HIWIN_E_OK;
}

/* ---- Frames ---- */

/**
 * The data of one telegram in both directions, which the controller and the drive exchange in every cycle.
 * PROFINET carries them in frames of its own; what is decoded here is the data of the telegram alone.
 * Printed as 週期性資料.
 * Frames are binary.
 * Note: One PZD is one word (3.2 L574).
 * Note: Nothing in the data says which telegram they are. It is set up in the drive (7.1 L2023-2025) and in
 * the controller, and parameter 922 holds its number.
 * Note: Whether the data of a supplementary telegram follow those of the main one, or lie in a submodule of
 * their own, is not printed; each telegram is decoded by itself.
 * Note: The data are valid only while the status byte IOPS that is sent with them is good (2.5.3 L363).
 * Source: 2.5.3 L361-383; 3.2 L516
 */
/** An opened request: its header, and where its body is. */
typedef struct hiwin_e_cyclic_request_frame {
    const uint8_t *body;
    size_t body_length;
} hiwin_e_cyclic_request_frame;

/** Checks a frame and finds its body. */
static inline hiwin_e_codec_status hiwin_e_cyclic_request_open(const uint8_t *frame, size_t size,
        hiwin_e_cyclic_request_frame *out)
{
    const uint8_t *in = frame;
    size_t length = size;
    out->body = in;
    out->body_length = length;
    return HIWIN_E_OK;
}

/** Completes a frame whose body is at out + 0. `length` receives the size of the frame. */
static inline hiwin_e_codec_status hiwin_e_cyclic_request_close(size_t body_length, uint8_t *out, size_t capacity,
        size_t *length)
{
    const size_t total = body_length;
    if (body_length > capacity) {
        return HIWIN_E_ERR_CAPACITY;
    }
    (void)out;
    *length = total;
    return HIWIN_E_OK;
}

/** An opened response: its header, and where its body is. */
typedef struct hiwin_e_cyclic_response_frame {
    const uint8_t *body;
    size_t body_length;
} hiwin_e_cyclic_response_frame;

/** Checks a frame and finds its body. */
static inline hiwin_e_codec_status hiwin_e_cyclic_response_open(const uint8_t *frame, size_t size,
        hiwin_e_cyclic_response_frame *out)
{
    const uint8_t *in = frame;
    size_t length = size;
    out->body = in;
    out->body_length = length;
    return HIWIN_E_OK;
}

/** Completes a frame whose body is at out + 0. `length` receives the size of the frame. */
static inline hiwin_e_codec_status hiwin_e_cyclic_response_close(size_t body_length, uint8_t *out, size_t capacity,
        size_t *length)
{
    const size_t total = body_length;
    if (body_length > capacity) {
        return HIWIN_E_ERR_CAPACITY;
    }
    (void)out;
    *length = total;
    return HIWIN_E_OK;
}

/** Writes the whole frame of the request telegram_3_request. */
static inline hiwin_e_codec_status hiwin_e_cyclic_encode_telegram_3_request(const hiwin_e_telegram_3_request *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    hiwin_e_codec_status status;
    status = hiwin_e_telegram_3_request_encode(in, out, capacity, &body_length);
    if (status != HIWIN_E_OK) {
        return status;
    }
    return hiwin_e_cyclic_request_close(body_length, out, capacity, length);
}

/** Writes the whole frame of the response telegram_3_response. */
static inline hiwin_e_codec_status hiwin_e_cyclic_encode_telegram_3_response(const hiwin_e_telegram_3_response *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    hiwin_e_codec_status status;
    status = hiwin_e_telegram_3_response_encode(in, out, capacity, &body_length);
    if (status != HIWIN_E_OK) {
        return status;
    }
    return hiwin_e_cyclic_response_close(body_length, out, capacity, length);
}

/** Writes the whole frame of the request telegram_5_request. */
static inline hiwin_e_codec_status hiwin_e_cyclic_encode_telegram_5_request(const hiwin_e_telegram_5_request *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    hiwin_e_codec_status status;
    status = hiwin_e_telegram_5_request_encode(in, out, capacity, &body_length);
    if (status != HIWIN_E_OK) {
        return status;
    }
    return hiwin_e_cyclic_request_close(body_length, out, capacity, length);
}

/** Writes the whole frame of the response telegram_5_response. */
static inline hiwin_e_codec_status hiwin_e_cyclic_encode_telegram_5_response(const hiwin_e_telegram_5_response *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    hiwin_e_codec_status status;
    status = hiwin_e_telegram_5_response_encode(in, out, capacity, &body_length);
    if (status != HIWIN_E_OK) {
        return status;
    }
    return hiwin_e_cyclic_response_close(body_length, out, capacity, length);
}

/** Writes the whole frame of the request telegram_9_request. */
static inline hiwin_e_codec_status hiwin_e_cyclic_encode_telegram_9_request(const hiwin_e_telegram_9_request *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    hiwin_e_codec_status status;
    status = hiwin_e_telegram_9_request_encode(in, out, capacity, &body_length);
    if (status != HIWIN_E_OK) {
        return status;
    }
    return hiwin_e_cyclic_request_close(body_length, out, capacity, length);
}

/** Writes the whole frame of the response telegram_9_response. */
static inline hiwin_e_codec_status hiwin_e_cyclic_encode_telegram_9_response(const hiwin_e_telegram_9_response *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    hiwin_e_codec_status status;
    status = hiwin_e_telegram_9_response_encode(in, out, capacity, &body_length);
    if (status != HIWIN_E_OK) {
        return status;
    }
    return hiwin_e_cyclic_response_close(body_length, out, capacity, length);
}

/** Writes the whole frame of the request telegram_102_request. */
static inline hiwin_e_codec_status hiwin_e_cyclic_encode_telegram_102_request(const hiwin_e_telegram_102_request *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    hiwin_e_codec_status status;
    status = hiwin_e_telegram_102_request_encode(in, out, capacity, &body_length);
    if (status != HIWIN_E_OK) {
        return status;
    }
    return hiwin_e_cyclic_request_close(body_length, out, capacity, length);
}

/** Writes the whole frame of the response telegram_102_response. */
static inline hiwin_e_codec_status hiwin_e_cyclic_encode_telegram_102_response(const hiwin_e_telegram_102_response *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    hiwin_e_codec_status status;
    status = hiwin_e_telegram_102_response_encode(in, out, capacity, &body_length);
    if (status != HIWIN_E_OK) {
        return status;
    }
    return hiwin_e_cyclic_response_close(body_length, out, capacity, length);
}

/** Writes the whole frame of the request telegram_105_request. */
static inline hiwin_e_codec_status hiwin_e_cyclic_encode_telegram_105_request(const hiwin_e_telegram_105_request *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    hiwin_e_codec_status status;
    status = hiwin_e_telegram_105_request_encode(in, out, capacity, &body_length);
    if (status != HIWIN_E_OK) {
        return status;
    }
    return hiwin_e_cyclic_request_close(body_length, out, capacity, length);
}

/** Writes the whole frame of the response telegram_105_response. */
static inline hiwin_e_codec_status hiwin_e_cyclic_encode_telegram_105_response(const hiwin_e_telegram_105_response *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    hiwin_e_codec_status status;
    status = hiwin_e_telegram_105_response_encode(in, out, capacity, &body_length);
    if (status != HIWIN_E_OK) {
        return status;
    }
    return hiwin_e_cyclic_response_close(body_length, out, capacity, length);
}

/** Writes the whole frame of the request telegram_111_request. */
static inline hiwin_e_codec_status hiwin_e_cyclic_encode_telegram_111_request(const hiwin_e_telegram_111_request *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    hiwin_e_codec_status status;
    status = hiwin_e_telegram_111_request_encode(in, out, capacity, &body_length);
    if (status != HIWIN_E_OK) {
        return status;
    }
    return hiwin_e_cyclic_request_close(body_length, out, capacity, length);
}

/** Writes the whole frame of the response telegram_111_response. */
static inline hiwin_e_codec_status hiwin_e_cyclic_encode_telegram_111_response(const hiwin_e_telegram_111_response *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    hiwin_e_codec_status status;
    status = hiwin_e_telegram_111_response_encode(in, out, capacity, &body_length);
    if (status != HIWIN_E_OK) {
        return status;
    }
    return hiwin_e_cyclic_response_close(body_length, out, capacity, length);
}

/** Writes the whole frame of the request telegram_750_request. */
static inline hiwin_e_codec_status hiwin_e_cyclic_encode_telegram_750_request(const hiwin_e_telegram_750_request *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    hiwin_e_codec_status status;
    status = hiwin_e_telegram_750_request_encode(in, out, capacity, &body_length);
    if (status != HIWIN_E_OK) {
        return status;
    }
    return hiwin_e_cyclic_request_close(body_length, out, capacity, length);
}

/** Writes the whole frame of the response telegram_750_response. */
static inline hiwin_e_codec_status hiwin_e_cyclic_encode_telegram_750_response(const hiwin_e_telegram_750_response *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    hiwin_e_codec_status status;
    status = hiwin_e_telegram_750_response_encode(in, out, capacity, &body_length);
    if (status != HIWIN_E_OK) {
        return status;
    }
    return hiwin_e_cyclic_response_close(body_length, out, capacity, length);
}

/**
 * Reads and writes parameters by number, outside of the cyclic data. A request holds one parameter; its
 * response repeats the head of the request, and either gives the values or says why not.
 * Printed as 參數存取.
 * Frames are binary.
 * Note: The drive takes one parameter per request only. One parameter may still give, or take, several
 * elements of its array.
 * Note: The reply to an unknown request ID has the response ID 80h (4.3.6 L1448), whichever ID was sent. It
 * names no message, so it can only be told from the request.
 * Note: Whether an odd number of value bytes is followed by a byte that fills the word, the manual does not
 * say; its tables show none. The computed examples avoid it.
 * Note: The order of requests and responses is drawn in figure 4.3.1, which the text does not have
 * (L1232-1235).
 * Note: How many bytes a request or a response may have at most is not printed; error 15h says that there is a
 * limit.
 * Source: 4.3 L1230-1235; 4.3.1 L1237-1277; 4.3.2 L1279-1319; 4.3.3 L1321-1362; 4.3.4 L1364-1404
 */
/** An opened request: its header, and where its body is. */
typedef struct hiwin_e_parameter_channel_request_frame {
    /**
     * Chosen by the controller; the response repeats it.
     * Printed as 請求參考編號.
     * Source: 4.3.1 L1242
     */
    uint8_t request_reference;
    /** The code, without the flag of an exception response. */
    uint32_t code;
    const uint8_t *body;
    size_t body_length;
} hiwin_e_parameter_channel_request_frame;

/** Checks a frame and finds its body. */
static inline hiwin_e_codec_status hiwin_e_parameter_channel_request_open(const uint8_t *frame, size_t size,
        hiwin_e_parameter_channel_request_frame *out)
{
    const uint8_t *in = frame;
    size_t length = size;
    if (length < 4u) {
        return HIWIN_E_ERR_INCOMPLETE;
    }
    if (hiwin_e_load_u8(in + 2) != 0u) {
        return HIWIN_E_ERR_WRONG_CONST;
    }
    if (hiwin_e_load_u8(in + 3) != 1u) {
        return HIWIN_E_ERR_WRONG_CONST;
    }
    out->request_reference = hiwin_e_load_u8(in + 0);
    out->code = hiwin_e_load_u8(in + 1);
    if (out->code != 1u && out->code != 2u) {
        return HIWIN_E_ERR_UNKNOWN_CODE;
    }
    out->body = in + 4u;
    out->body_length = length - 4u;
    return HIWIN_E_OK;
}

/** Completes a frame whose body is at out + 4. `length` receives the size of the frame. */
static inline hiwin_e_codec_status hiwin_e_parameter_channel_request_close(uint8_t request_reference, uint32_t code,
        size_t body_length, uint8_t *out, size_t capacity, size_t *length)
{
    const size_t total = body_length + 4u;
    if (capacity < 4u || body_length > capacity - 4u) {
        return HIWIN_E_ERR_CAPACITY;
    }
    if (!(request_reference >= 1u)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u8(out + 0, (uint8_t)request_reference);
    if (code > 255u) {
        return HIWIN_E_ERR_UNKNOWN_CODE;
    }
    hiwin_e_store_u8(out + 1, (uint8_t)code);
    hiwin_e_store_u8(out + 2, 0u);
    hiwin_e_store_u8(out + 3, 1u);
    *length = total;
    return HIWIN_E_OK;
}

/** An opened response: its header, and where its body is. */
typedef struct hiwin_e_parameter_channel_response_frame {
    /**
     * The reference of the request.
     * Printed as 請求參考編號鏡射.
     * Source: 4.3.1 L1256
     */
    uint8_t request_reference;
    /** The code, without the flag of an exception response. */
    uint32_t code;
    /** The frame is an exception response; its body is the record of the exception. */
    bool error;
    const uint8_t *body;
    size_t body_length;
} hiwin_e_parameter_channel_response_frame;

/** Checks a frame and finds its body. */
static inline hiwin_e_codec_status hiwin_e_parameter_channel_response_open(const uint8_t *frame, size_t size,
        hiwin_e_parameter_channel_response_frame *out)
{
    const uint8_t *in = frame;
    size_t length = size;
    if (length < 4u) {
        return HIWIN_E_ERR_INCOMPLETE;
    }
    if (hiwin_e_load_u8(in + 2) != 0u) {
        return HIWIN_E_ERR_WRONG_CONST;
    }
    if (hiwin_e_load_u8(in + 3) != 1u) {
        return HIWIN_E_ERR_WRONG_CONST;
    }
    out->request_reference = hiwin_e_load_u8(in + 0);
    out->code = hiwin_e_load_u8(in + 1);
    out->error = (out->code & 128u) != 0;
    if (out->error) {
        out->code &= ~(uint32_t)128u;
    }
    if (!out->error && out->code != 1u && out->code != 2u) {
        return HIWIN_E_ERR_UNKNOWN_CODE;
    }
    out->body = in + 4u;
    out->body_length = length - 4u;
    return HIWIN_E_OK;
}

/** Completes a frame whose body is at out + 4. `length` receives the size of the frame. */
static inline hiwin_e_codec_status hiwin_e_parameter_channel_response_close(uint8_t request_reference, uint32_t code,
        size_t body_length, uint8_t *out, size_t capacity, size_t *length)
{
    const size_t total = body_length + 4u;
    if (capacity < 4u || body_length > capacity - 4u) {
        return HIWIN_E_ERR_CAPACITY;
    }
    if (!(request_reference >= 1u)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    hiwin_e_store_u8(out + 0, (uint8_t)request_reference);
    if (code > 255u) {
        return HIWIN_E_ERR_UNKNOWN_CODE;
    }
    hiwin_e_store_u8(out + 1, (uint8_t)code);
    hiwin_e_store_u8(out + 2, 0u);
    hiwin_e_store_u8(out + 3, 1u);
    *length = total;
    return HIWIN_E_OK;
}

/** Writes the whole frame of the request read_parameter_request. */
static inline hiwin_e_codec_status hiwin_e_parameter_channel_encode_read_parameter_request(uint8_t request_reference,
        const hiwin_e_read_parameter_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    hiwin_e_codec_status status;
    if (capacity < 4u) {
        return HIWIN_E_ERR_CAPACITY;
    }
    status = hiwin_e_read_parameter_request_encode(in, out + 4, capacity - 4u, &body_length);
    if (status != HIWIN_E_OK) {
        return status;
    }
    return hiwin_e_parameter_channel_request_close(request_reference, 1u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response read_parameter_response. */
static inline hiwin_e_codec_status hiwin_e_parameter_channel_encode_read_parameter_response(uint8_t request_reference,
        const hiwin_e_read_parameter_response *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    hiwin_e_codec_status status;
    if (capacity < 4u) {
        return HIWIN_E_ERR_CAPACITY;
    }
    status = hiwin_e_read_parameter_response_encode(in, out + 4, capacity - 4u, &body_length);
    if (status != HIWIN_E_OK) {
        return status;
    }
    return hiwin_e_parameter_channel_response_close(request_reference, 1u, body_length, out, capacity, length);
}

/** Writes the whole frame of the request write_parameter_request. */
static inline hiwin_e_codec_status hiwin_e_parameter_channel_encode_write_parameter_request(uint8_t request_reference,
        const hiwin_e_write_parameter_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    hiwin_e_codec_status status;
    if (capacity < 4u) {
        return HIWIN_E_ERR_CAPACITY;
    }
    status = hiwin_e_write_parameter_request_encode(in, out + 4, capacity - 4u, &body_length);
    if (status != HIWIN_E_OK) {
        return status;
    }
    return hiwin_e_parameter_channel_request_close(request_reference, 2u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response write_parameter_response. */
static inline hiwin_e_codec_status hiwin_e_parameter_channel_encode_write_parameter_response(uint8_t request_reference,
        uint8_t *out, size_t capacity, size_t *length)
{
    return hiwin_e_parameter_channel_response_close(request_reference, 2u, 0, out, capacity, length);
}

/** Writes the whole frame of an exception response to a code. */
static inline hiwin_e_codec_status hiwin_e_parameter_channel_encode_exception_response(uint8_t request_reference,
        uint32_t code, const hiwin_e_parameter_error *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    hiwin_e_codec_status status;
    if (capacity < 4u) {
        return HIWIN_E_ERR_CAPACITY;
    }
    status = hiwin_e_parameter_error_encode(in, out + 4, capacity - 4u, &body_length);
    if (status != HIWIN_E_OK) {
        return status;
    }
    return hiwin_e_parameter_channel_response_close(request_reference, code | 128u, body_length, out, capacity, length);
}

/* ---- Texts of codes, in UTF-8 ---- */

#ifdef HIWIN_E_WITH_TEXTS
/** The texts of a code. Line ends separate several causes or remedies. `printed` is the code as the manual writes it;
 * `number` is the second number that the manual gives the code, or -1. */
typedef struct hiwin_e_code_text {
    int64_t code;
    int64_t number;
    const char *printed;
    const char *name;
    const char *label;
    const char *problem;
    const char *causes;
    const char *remedies;
} hiwin_e_code_text;

/** The texts of a code of hiwin_e_alarm_code, or NULL if the code is unknown. */
static inline const hiwin_e_code_text *hiwin_e_alarm_code_text(int64_t code)
{
    static const hiwin_e_code_text texts[] = {
        {INT64_C(36), INT64_C(4), "AL.024", "system_alarm_1", "\347\263\273\347\265\261\350\255\246\345\240\261 1", "", "", ""},
        {INT64_C(37), INT64_C(5), "AL.025", "system_alarm_2", "\347\263\273\347\265\261\350\255\246\345\240\261 2", "", "", ""},
        {INT64_C(48), INT64_C(6), "AL.030", "main_circuit_fault", "\344\270\273\350\277\264\350\267\257\346\225\205\351\232\234", "", "", ""},
        {INT64_C(64), INT64_C(7), "AL.040", "parameter_setting_error", "\345\217\203\346\225\270\350\250\255\345\256\232\351\214\257\350\252\244", "", "", ""},
        {INT64_C(80), INT64_C(11), "AL.050", "combination_error", "\347\265\204\345\220\210\351\214\257\350\252\244", "", "", ""},
        {INT64_C(112), INT64_C(12), "AL.070", "motor_change_detected", "\351\246\254\351\201\224\350\256\212\346\233\264\346\252\242\345\207\272", "", "", ""},
        {INT64_C(176), INT64_C(14), "AL.0b0", "servo_on_command_invalid", "\344\274\272\346\234\215 ON \345\221\275\344\273\244\347\204\241\346\225\210\350\255\246\345\240\261", "", "", ""},
        {INT64_C(256), INT64_C(15), "AL.100", "overcurrent", "\351\201\216\351\233\273\346\265\201\346\252\242\345\207\272", "", "", ""},
        {INT64_C(800), INT64_C(16), "AL.320", "regenerative_energy_overload", "\345\233\236\347\224\237\350\203\275\351\207\217\351\201\216\350\274\211", "", "", ""},
        {INT64_C(1024), INT64_C(17), "AL.400", "overvoltage", "\351\201\216\351\233\273\345\243\223", "", "", ""},
        {INT64_C(1040), INT64_C(18), "AL.410", "undervoltage", "\344\275\216\351\233\273\345\243\223", "", "", ""},
        {INT64_C(1296), INT64_C(19), "AL.510", "overspeed", "\351\201\216\351\200\237\345\272\246", "", "", ""},
        {INT64_C(1297), INT64_C(20), "AL.511", "encoder_pulse_output_overspeed", "\347\267\250\347\242\274\345\231\250\350\204\210\346\263\242\350\274\270\345\207\272\351\201\216\351\200\237", "", "", ""},
        {INT64_C(1808), INT64_C(24), "AL.710", "momentary_overload", "\351\201\216\350\274\211 (\347\236\254\351\226\223\346\234\200\345\244\247\350\262\240\350\274\211)", "", "", ""},
        {INT64_C(1824), INT64_C(25), "AL.720", "continuous_overload", "\351\201\216\350\274\211 (\351\200\243\347\272\214\346\234\200\345\244\247\350\262\240\350\274\211)", "", "", ""},
        {INT64_C(1953), INT64_C(29), "AL.7A1", "drive_overload", "\351\251\205\345\213\225\345\231\250\351\201\216\350\274\211", "", "", ""},
        {INT64_C(1954), INT64_C(30), "AL.7A2", "power_board_temperature", "\351\233\273\346\272\220\351\233\273\350\267\257\346\235\277\346\272\253\345\272\246\347\225\260\345\270\270", "", "", ""},
        {INT64_C(2048), INT64_C(33), "AL.800", "encoder_absolute_position_lost", "\347\267\250\347\242\274\345\231\250\347\265\225\345\260\215\344\275\215\347\275\256\351\201\272\345\244\261", "", "", ""},
        {INT64_C(2064), INT64_C(34), "AL.810", "encoder_battery_voltage_low", "\347\267\250\347\242\274\345\231\250\351\233\273\346\261\240\351\233\273\345\243\223\351\201\216\344\275\216", "", "", ""},
        {INT64_C(2080), INT64_C(35), "AL.820", "encoder_communication_error", "\347\267\250\347\242\274\345\231\250\351\200\232\350\250\212\351\214\257\350\252\244", "", "", ""},
        {INT64_C(2096), INT64_C(36), "AL.830", "encoder_data_error", "\347\267\250\347\242\274\345\231\250\350\263\207\346\226\231\351\214\257\350\252\244", "", "", ""},
        {INT64_C(2112), INT64_C(37), "AL.840", "encoder_communication_check_error", "\347\267\250\347\242\274\345\231\250\351\200\232\350\250\212\346\240\241\351\251\227\351\214\257\350\252\244", "", "", ""},
        {INT64_C(2128), INT64_C(38), "AL.850", "encoder_counting_error", "\347\267\250\347\242\274\345\231\250\350\250\210\346\225\270\351\214\257\350\252\244", "", "", ""},
        {INT64_C(2144), INT64_C(39), "AL.860", "encoder_write_error", "\347\267\250\347\242\274\345\231\250\350\263\207\346\226\231\345\257\253\345\205\245\351\214\257\350\252\244", "", "", ""},
        {INT64_C(2160), INT64_C(40), "AL.870", "encoder_overheated", "\347\267\250\347\242\274\345\231\250\351\201\216\346\272\253", "", "", ""},
        {INT64_C(2176), INT64_C(41), "AL.880", "incremental_encoder_phase_sequence", "\345\242\236\351\207\217\345\274\217\347\267\250\347\242\274\345\231\250\350\250\212\350\231\237\347\233\270\345\272\217\347\225\260\345\270\270", "", "", ""},
        {INT64_C(2192), INT64_C(42), "AL.890", "adapter_incremental_encoder_disconnected", "\350\275\211\346\216\245\347\233\222\345\242\236\351\207\217\345\274\217\347\267\250\347\242\274\345\231\250\346\226\267\347\267\232", "", "", ""},
        {INT64_C(2208), INT64_C(43), "AL.8A0", "encoder_1_signal_at_adapter", "\347\254\254\344\270\200\347\265\204\347\267\250\347\242\274\345\231\250\302\267\350\275\211\346\216\245\347\233\222\347\253\257\350\250\212\350\231\237\347\225\260\345\270\270", "", "", ""},
        {INT64_C(2224), INT64_C(44), "AL.8b0", "encoder_1_signal_at_encoder", "\347\254\254\344\270\200\347\265\204\347\267\250\347\242\274\345\231\250\302\267\347\267\250\347\242\274\345\231\250\347\253\257\350\250\212\350\231\237\347\225\260\345\270\270", "", "", ""},
        {INT64_C(2240), INT64_C(45), "AL.8C0", "encoder_2_signal_at_adapter", "\347\254\254\344\272\214\347\265\204\347\267\250\347\242\274\345\231\250\302\267\350\275\211\346\216\245\347\233\222\347\253\257\350\250\212\350\231\237\347\225\260\345\270\270", "", "", ""},
        {INT64_C(2256), INT64_C(46), "AL.8d0", "encoder_2_signal_at_encoder", "\347\254\254\344\272\214\347\265\204\347\267\250\347\242\274\345\231\250\302\267\347\267\250\347\242\274\345\231\250\347\253\257\350\250\212\350\231\237\347\225\260\345\270\270", "", "", ""},
        {INT64_C(2272), INT64_C(47), "AL.8E0", "digital_encoder_disconnected", "\346\225\270\344\275\215\347\267\250\347\242\274\345\231\250\346\226\267\347\267\232", "", "", ""},
        {INT64_C(2288), INT64_C(48), "AL.8F0", "encoder_adapter_internal_error", "\347\267\250\347\242\274\345\231\250\350\275\211\346\216\245\347\233\222\345\205\247\351\203\250\347\225\260\345\270\270", "", "", ""},
        {INT64_C(2145), INT64_C(49), "AL.861", "motor_overheated", "\351\246\254\351\201\224\351\201\216\347\206\261", "", "", ""},
        {INT64_C(2832), INT64_C(50), "AL.b10", "speed_command_converter_error", "\351\200\237\345\272\246\345\221\275\344\273\244 A/D \350\275\211\346\217\233\345\231\250\347\225\260\345\270\270", "", "", ""},
        {INT64_C(2848), INT64_C(52), "AL.b20", "torque_command_converter_error", "\350\275\211\347\237\251\345\221\275\344\273\244 A/D \350\275\211\346\217\233\345\231\250\347\225\260\345\270\270", "", "", ""},
        {INT64_C(2867), INT64_C(53), "AL.b33", "current_detection_fault", "\351\233\273\346\265\201\346\252\242\345\207\272\346\225\205\351\232\234", "", "", ""},
        {INT64_C(3088), INT64_C(54), "AL.C10", "motor_runaway", "\351\246\254\351\201\224\345\244\261\346\216\247\346\252\242\345\207\272", "", "", ""},
        {INT64_C(3104), INT64_C(55), "AL.C20", "phase_detection_error", "\347\233\270\344\275\215\346\252\242\345\207\272\351\214\257\350\252\244", "", "", ""},
        {INT64_C(3105), INT64_C(56), "AL.C21", "hall_sensor_fault", "\351\234\215\347\210\276\346\204\237\346\270\254\345\231\250\346\225\205\351\232\234", "", "", ""},
        {INT64_C(3152), INT64_C(58), "AL.C50", "electrical_angle_detection_failed", "\351\233\273\346\251\237\350\247\222\346\252\242\345\207\272\345\244\261\346\225\227", "", "", ""},
        {INT64_C(3153), INT64_C(59), "AL.C51", "electrical_angle_detection_overtravel", "\351\233\273\346\251\237\350\247\222\346\252\242\345\207\272\346\231\202\350\266\205\347\250\213", "", "", ""},
        {INT64_C(3154), INT64_C(60), "AL.C52", "electrical_angle_detection_incomplete", "\351\233\273\346\251\237\350\247\222\346\252\242\345\207\272\346\234\252\345\256\214\346\210\220", "", "", ""},
        {INT64_C(3328), INT64_C(62), "AL.d00", "position_deviation_too_large", "\344\275\215\347\275\256\345\201\217\345\267\256\351\201\216\345\244\247", "", "", ""},
        {INT64_C(3344), INT64_C(65), "AL.d10", "load_position_deviation_too_large", "\351\246\254\351\201\224\350\210\207\350\262\240\350\274\211\351\226\223\344\275\215\347\275\256\345\201\217\345\267\256\351\201\216\345\244\247", "", "", ""},
        {INT64_C(3760), INT64_C(66), "AL.Eb0", "safety_function_alarm", "\345\256\211\345\205\250\345\212\237\350\203\275\350\255\246\345\240\261", "", "", ""},
        {INT64_C(3761), INT64_C(67), "AL.Eb1", "safety_input_timing", "\345\256\211\345\205\250\345\212\237\350\203\275\347\224\250\350\250\212\350\231\237\350\274\270\345\205\245\346\231\202\351\226\223\347\225\260\345\270\270", "", "", ""},
        {INT64_C(3762), INT64_C(68), "AL.Eb2", "safety_module_error", "\345\256\211\345\205\250\345\212\237\350\203\275\346\250\241\347\265\204\347\225\260\345\270\270", "", "", ""},
        {INT64_C(3856), INT64_C(69), "AL.F10", "power_line_phase_missing", "\351\233\273\346\272\220\347\267\232\347\274\272\347\233\270", "", "", ""},
        {INT64_C(3920), INT64_C(70), "AL.F50", "motor_line_disconnected", "\351\246\254\351\201\224\344\270\273\350\277\264\350\267\257\346\216\245\347\267\232\346\226\267\347\267\232", "", "", ""},
        {INT64_C(4000), INT64_C(71), "AL.FA0", "encoder_supply_error", "\347\267\250\347\242\274\345\231\250\351\233\273\346\272\220\347\225\260\345\270\270", "", "", ""},
        {INT64_C(4016), INT64_C(72), "AL.FB0", "fieldbus_hardware_failure", "\347\270\275\347\267\232\351\200\232\350\250\212\347\241\254\351\253\224\345\244\261\346\225\210", "", "", ""},
        {INT64_C(4017), INT64_C(73), "AL.FB1", "fieldbus_communication_error", "\347\270\275\347\267\232\351\200\232\350\250\212\351\214\257\350\252\244", "", "", ""},
        {INT64_C(4032), INT64_C(74), "AL.FC0", "dual_axis_communication_error", "\351\233\231\350\273\270\346\216\247\345\210\266\347\263\273\347\265\261\351\200\232\350\250\212\351\214\257\350\252\244", "", "", ""},
        {INT64_C(4033), INT64_C(75), "AL.FC1", "dual_axis_slave_alarm", "\351\233\231\350\273\270\346\216\247\345\210\266\347\263\273\347\265\261\345\276\236\350\273\270\350\255\246\345\240\261", "", "", ""},
        {INT64_C(2193), INT64_C(76), "AL.891", "incremental_encoder_signal_error", "\345\242\236\351\207\217\345\274\217\347\267\250\347\242\274\345\231\250\350\250\212\350\231\237\347\225\260\345\270\270", "", "", ""},
        {INT64_C(4018), INT64_C(77), "AL.FB2", "fieldbus_setting_error", "\347\270\275\347\267\232\351\200\232\350\250\212\350\250\255\345\256\232\351\214\257\350\252\244", "", "", ""},
        {INT64_C(3808), INT64_C(78), "AL.EE0", "fixed_stop_alarm", "Fixed stop \346\207\211\347\224\250\350\255\246\345\240\261", "Something went wrong while or after traversing to a fixed stop.", "The absolute movement is complete and the fixed stop was not reached\nThe fixed stop was reached, and the position then left the range that is monitored", "Check whether the workpiece lies where it should, and whether the commanded position and the greatest following error (Pt42F) suit the task.\nSet both to suit the workpiece.\nCheck whether the mechanism and the workpiece are mounted well and rigid.\nCorrect the mechanism; if need be, widen the range (Pt42B, Pt42C) or lower the clamping torque (Pt42D, Pt42E)."},
        {INT64_C(4048), INT64_C(79), "AL.Fd0", "electronic_cam_alarm", "\351\233\273\345\255\220\345\207\270\350\274\252\346\216\247\345\210\266\347\263\273\347\265\261\350\255\246\345\240\261", "", "", ""},
        {INT64_C(3833), INT64_C(80), "AL.EF9", "multi_station_alarm", "\345\244\232\345\267\245\344\275\215\345\212\237\350\203\275\350\255\246\345\240\261", "", "", ""},
    };
    size_t at;
    for (at = 0; at < sizeof texts / sizeof texts[0]; at++) {
        if (texts[at].code == code) {
            return &texts[at];
        }
    }
    return NULL;
}

/** The texts of a code of hiwin_e_internal_alarm_code, or NULL if the code is unknown. */
static inline const hiwin_e_code_text *hiwin_e_internal_alarm_code_text(int64_t code)
{
    static const hiwin_e_code_text texts[] = {
        {INT64_C(4), (-INT64_C(1)), "AL.024", "system_alarm_1", "\347\263\273\347\265\261\350\255\246\345\240\261 1", "", "", ""},
        {INT64_C(5), (-INT64_C(1)), "AL.025", "system_alarm_2", "\347\263\273\347\265\261\350\255\246\345\240\261 2", "", "", ""},
        {INT64_C(6), (-INT64_C(1)), "AL.030", "main_circuit_fault", "\344\270\273\350\277\264\350\267\257\346\225\205\351\232\234", "", "", ""},
        {INT64_C(7), (-INT64_C(1)), "AL.040", "parameter_setting_error", "\345\217\203\346\225\270\350\250\255\345\256\232\351\214\257\350\252\244", "", "", ""},
        {INT64_C(11), (-INT64_C(1)), "AL.050", "combination_error", "\347\265\204\345\220\210\351\214\257\350\252\244", "", "", ""},
        {INT64_C(12), (-INT64_C(1)), "AL.070", "motor_change_detected", "\351\246\254\351\201\224\350\256\212\346\233\264\346\252\242\345\207\272", "", "", ""},
        {INT64_C(14), (-INT64_C(1)), "AL.0b0", "servo_on_command_invalid", "\344\274\272\346\234\215 ON \345\221\275\344\273\244\347\204\241\346\225\210\350\255\246\345\240\261", "", "", ""},
        {INT64_C(15), (-INT64_C(1)), "AL.100", "overcurrent", "\351\201\216\351\233\273\346\265\201\346\252\242\345\207\272", "", "", ""},
        {INT64_C(16), (-INT64_C(1)), "AL.320", "regenerative_energy_overload", "\345\233\236\347\224\237\350\203\275\351\207\217\351\201\216\350\274\211", "", "", ""},
        {INT64_C(17), (-INT64_C(1)), "AL.400", "overvoltage", "\351\201\216\351\233\273\345\243\223", "", "", ""},
        {INT64_C(18), (-INT64_C(1)), "AL.410", "undervoltage", "\344\275\216\351\233\273\345\243\223", "", "", ""},
        {INT64_C(19), (-INT64_C(1)), "AL.510", "overspeed", "\351\201\216\351\200\237\345\272\246", "", "", ""},
        {INT64_C(20), (-INT64_C(1)), "AL.511", "encoder_pulse_output_overspeed", "\347\267\250\347\242\274\345\231\250\350\204\210\346\263\242\350\274\270\345\207\272\351\201\216\351\200\237", "", "", ""},
        {INT64_C(24), (-INT64_C(1)), "AL.710", "momentary_overload", "\351\201\216\350\274\211 (\347\236\254\351\226\223\346\234\200\345\244\247\350\262\240\350\274\211)", "", "", ""},
        {INT64_C(25), (-INT64_C(1)), "AL.720", "continuous_overload", "\351\201\216\350\274\211 (\351\200\243\347\272\214\346\234\200\345\244\247\350\262\240\350\274\211)", "", "", ""},
        {INT64_C(29), (-INT64_C(1)), "AL.7A1", "drive_overload", "\351\251\205\345\213\225\345\231\250\351\201\216\350\274\211", "", "", ""},
        {INT64_C(30), (-INT64_C(1)), "AL.7A2", "power_board_temperature", "\351\233\273\346\272\220\351\233\273\350\267\257\346\235\277\346\272\253\345\272\246\347\225\260\345\270\270", "", "", ""},
        {INT64_C(33), (-INT64_C(1)), "AL.800", "encoder_absolute_position_lost", "\347\267\250\347\242\274\345\231\250\347\265\225\345\260\215\344\275\215\347\275\256\351\201\272\345\244\261", "", "", ""},
        {INT64_C(34), (-INT64_C(1)), "AL.810", "encoder_battery_voltage_low", "\347\267\250\347\242\274\345\231\250\351\233\273\346\261\240\351\233\273\345\243\223\351\201\216\344\275\216", "", "", ""},
        {INT64_C(35), (-INT64_C(1)), "AL.820", "encoder_communication_error", "\347\267\250\347\242\274\345\231\250\351\200\232\350\250\212\351\214\257\350\252\244", "", "", ""},
        {INT64_C(36), (-INT64_C(1)), "AL.830", "encoder_data_error", "\347\267\250\347\242\274\345\231\250\350\263\207\346\226\231\351\214\257\350\252\244", "", "", ""},
        {INT64_C(37), (-INT64_C(1)), "AL.840", "encoder_communication_check_error", "\347\267\250\347\242\274\345\231\250\351\200\232\350\250\212\346\240\241\351\251\227\351\214\257\350\252\244", "", "", ""},
        {INT64_C(38), (-INT64_C(1)), "AL.850", "encoder_counting_error", "\347\267\250\347\242\274\345\231\250\350\250\210\346\225\270\351\214\257\350\252\244", "", "", ""},
        {INT64_C(39), (-INT64_C(1)), "AL.860", "encoder_write_error", "\347\267\250\347\242\274\345\231\250\350\263\207\346\226\231\345\257\253\345\205\245\351\214\257\350\252\244", "", "", ""},
        {INT64_C(40), (-INT64_C(1)), "AL.870", "encoder_overheated", "\347\267\250\347\242\274\345\231\250\351\201\216\346\272\253", "", "", ""},
        {INT64_C(41), (-INT64_C(1)), "AL.880", "incremental_encoder_phase_sequence", "\345\242\236\351\207\217\345\274\217\347\267\250\347\242\274\345\231\250\350\250\212\350\231\237\347\233\270\345\272\217\347\225\260\345\270\270", "", "", ""},
        {INT64_C(42), (-INT64_C(1)), "AL.890", "adapter_incremental_encoder_disconnected", "\350\275\211\346\216\245\347\233\222\345\242\236\351\207\217\345\274\217\347\267\250\347\242\274\345\231\250\346\226\267\347\267\232", "", "", ""},
        {INT64_C(43), (-INT64_C(1)), "AL.8A0", "encoder_1_signal_at_adapter", "\347\254\254\344\270\200\347\265\204\347\267\250\347\242\274\345\231\250\302\267\350\275\211\346\216\245\347\233\222\347\253\257\350\250\212\350\231\237\347\225\260\345\270\270", "", "", ""},
        {INT64_C(44), (-INT64_C(1)), "AL.8b0", "encoder_1_signal_at_encoder", "\347\254\254\344\270\200\347\265\204\347\267\250\347\242\274\345\231\250\302\267\347\267\250\347\242\274\345\231\250\347\253\257\350\250\212\350\231\237\347\225\260\345\270\270", "", "", ""},
        {INT64_C(45), (-INT64_C(1)), "AL.8C0", "encoder_2_signal_at_adapter", "\347\254\254\344\272\214\347\265\204\347\267\250\347\242\274\345\231\250\302\267\350\275\211\346\216\245\347\233\222\347\253\257\350\250\212\350\231\237\347\225\260\345\270\270", "", "", ""},
        {INT64_C(46), (-INT64_C(1)), "AL.8d0", "encoder_2_signal_at_encoder", "\347\254\254\344\272\214\347\265\204\347\267\250\347\242\274\345\231\250\302\267\347\267\250\347\242\274\345\231\250\347\253\257\350\250\212\350\231\237\347\225\260\345\270\270", "", "", ""},
        {INT64_C(47), (-INT64_C(1)), "AL.8E0", "digital_encoder_disconnected", "\346\225\270\344\275\215\347\267\250\347\242\274\345\231\250\346\226\267\347\267\232", "", "", ""},
        {INT64_C(48), (-INT64_C(1)), "AL.8F0", "encoder_adapter_internal_error", "\347\267\250\347\242\274\345\231\250\350\275\211\346\216\245\347\233\222\345\205\247\351\203\250\347\225\260\345\270\270", "", "", ""},
        {INT64_C(49), (-INT64_C(1)), "AL.861", "motor_overheated", "\351\246\254\351\201\224\351\201\216\347\206\261", "", "", ""},
        {INT64_C(50), (-INT64_C(1)), "AL.b10", "speed_command_converter_error", "\351\200\237\345\272\246\345\221\275\344\273\244 A/D \350\275\211\346\217\233\345\231\250\347\225\260\345\270\270", "", "", ""},
        {INT64_C(52), (-INT64_C(1)), "AL.b20", "torque_command_converter_error", "\350\275\211\347\237\251\345\221\275\344\273\244 A/D \350\275\211\346\217\233\345\231\250\347\225\260\345\270\270", "", "", ""},
        {INT64_C(53), (-INT64_C(1)), "AL.b33", "current_detection_fault", "\351\233\273\346\265\201\346\252\242\345\207\272\346\225\205\351\232\234", "", "", ""},
        {INT64_C(54), (-INT64_C(1)), "AL.C10", "motor_runaway", "\351\246\254\351\201\224\345\244\261\346\216\247\346\252\242\345\207\272", "", "", ""},
        {INT64_C(55), (-INT64_C(1)), "AL.C20", "phase_detection_error", "\347\233\270\344\275\215\346\252\242\345\207\272\351\214\257\350\252\244", "", "", ""},
        {INT64_C(56), (-INT64_C(1)), "AL.C21", "hall_sensor_fault", "\351\234\215\347\210\276\346\204\237\346\270\254\345\231\250\346\225\205\351\232\234", "", "", ""},
        {INT64_C(58), (-INT64_C(1)), "AL.C50", "electrical_angle_detection_failed", "\351\233\273\346\251\237\350\247\222\346\252\242\345\207\272\345\244\261\346\225\227", "", "", ""},
        {INT64_C(59), (-INT64_C(1)), "AL.C51", "electrical_angle_detection_overtravel", "\351\233\273\346\251\237\350\247\222\346\252\242\345\207\272\346\231\202\350\266\205\347\250\213", "", "", ""},
        {INT64_C(60), (-INT64_C(1)), "AL.C52", "electrical_angle_detection_incomplete", "\351\233\273\346\251\237\350\247\222\346\252\242\345\207\272\346\234\252\345\256\214\346\210\220", "", "", ""},
        {INT64_C(62), (-INT64_C(1)), "AL.d00", "position_deviation_too_large", "\344\275\215\347\275\256\345\201\217\345\267\256\351\201\216\345\244\247", "", "", ""},
        {INT64_C(65), (-INT64_C(1)), "AL.d10", "load_position_deviation_too_large", "\351\246\254\351\201\224\350\210\207\350\262\240\350\274\211\351\226\223\344\275\215\347\275\256\345\201\217\345\267\256\351\201\216\345\244\247", "", "", ""},
        {INT64_C(66), (-INT64_C(1)), "AL.Eb0", "safety_function_alarm", "\345\256\211\345\205\250\345\212\237\350\203\275\350\255\246\345\240\261", "", "", ""},
        {INT64_C(67), (-INT64_C(1)), "AL.Eb1", "safety_input_timing", "\345\256\211\345\205\250\345\212\237\350\203\275\347\224\250\350\250\212\350\231\237\350\274\270\345\205\245\346\231\202\351\226\223\347\225\260\345\270\270", "", "", ""},
        {INT64_C(68), (-INT64_C(1)), "AL.Eb2", "safety_module_error", "\345\256\211\345\205\250\345\212\237\350\203\275\346\250\241\347\265\204\347\225\260\345\270\270", "", "", ""},
        {INT64_C(69), (-INT64_C(1)), "AL.F10", "power_line_phase_missing", "\351\233\273\346\272\220\347\267\232\347\274\272\347\233\270", "", "", ""},
        {INT64_C(70), (-INT64_C(1)), "AL.F50", "motor_line_disconnected", "\351\246\254\351\201\224\344\270\273\350\277\264\350\267\257\346\216\245\347\267\232\346\226\267\347\267\232", "", "", ""},
        {INT64_C(71), (-INT64_C(1)), "AL.FA0", "encoder_supply_error", "\347\267\250\347\242\274\345\231\250\351\233\273\346\272\220\347\225\260\345\270\270", "", "", ""},
        {INT64_C(72), (-INT64_C(1)), "AL.FB0", "fieldbus_hardware_failure", "\347\270\275\347\267\232\351\200\232\350\250\212\347\241\254\351\253\224\345\244\261\346\225\210", "", "", ""},
        {INT64_C(73), (-INT64_C(1)), "AL.FB1", "fieldbus_communication_error", "\347\270\275\347\267\232\351\200\232\350\250\212\351\214\257\350\252\244", "", "", ""},
        {INT64_C(74), (-INT64_C(1)), "AL.FC0", "dual_axis_communication_error", "\351\233\231\350\273\270\346\216\247\345\210\266\347\263\273\347\265\261\351\200\232\350\250\212\351\214\257\350\252\244", "", "", ""},
        {INT64_C(75), (-INT64_C(1)), "AL.FC1", "dual_axis_slave_alarm", "\351\233\231\350\273\270\346\216\247\345\210\266\347\263\273\347\265\261\345\276\236\350\273\270\350\255\246\345\240\261", "", "", ""},
        {INT64_C(76), (-INT64_C(1)), "AL.891", "incremental_encoder_signal_error", "\345\242\236\351\207\217\345\274\217\347\267\250\347\242\274\345\231\250\350\250\212\350\231\237\347\225\260\345\270\270", "", "", ""},
        {INT64_C(77), (-INT64_C(1)), "AL.FB2", "fieldbus_setting_error", "\347\270\275\347\267\232\351\200\232\350\250\212\350\250\255\345\256\232\351\214\257\350\252\244", "", "", ""},
        {INT64_C(78), (-INT64_C(1)), "AL.EE0", "fixed_stop_alarm", "Fixed stop \346\207\211\347\224\250\350\255\246\345\240\261", "", "", ""},
        {INT64_C(79), (-INT64_C(1)), "AL.Fd0", "electronic_cam_alarm", "\351\233\273\345\255\220\345\207\270\350\274\252\346\216\247\345\210\266\347\263\273\347\265\261\350\255\246\345\240\261", "", "", ""},
        {INT64_C(80), (-INT64_C(1)), "AL.EF9", "multi_station_alarm", "\345\244\232\345\267\245\344\275\215\345\212\237\350\203\275\350\255\246\345\240\261", "", "", ""},
    };
    size_t at;
    for (at = 0; at < sizeof texts / sizeof texts[0]; at++) {
        if (texts[at].code == code) {
            return &texts[at];
        }
    }
    return NULL;
}

/** The texts of a code of hiwin_e_parameter_error_number, or NULL if the code is unknown. */
static inline const hiwin_e_code_text *hiwin_e_parameter_error_number_text(int64_t code)
{
    static const hiwin_e_code_text texts[] = {
        {INT64_C(0), (-INT64_C(1)), "", "parameter_number_not_allowed", "\344\270\215\345\205\201\350\250\261\347\232\204\345\217\203\346\225\270\350\231\237\347\242\274", "There is no such parameter.", "", ""},
        {INT64_C(1), (-INT64_C(1)), "", "value_not_changeable", "\344\270\215\345\217\257\346\224\271\350\256\212\345\217\203\346\225\270\345\200\274", "The parameter cannot be written.", "", ""},
        {INT64_C(2), (-INT64_C(1)), "", "limit_exceeded", "\350\266\205\351\201\216\346\234\200\344\275\216\346\210\226\346\234\200\351\253\230\351\231\220\345\210\266", "The value is outside of the limits.", "", ""},
        {INT64_C(3), (-INT64_C(1)), "", "wrong_subindex", "\351\214\257\350\252\244\347\232\204\345\255\220\347\264\242\345\274\225", "The array or text has no such element.", "", ""},
        {INT64_C(4), (-INT64_C(1)), "", "no_array", "\347\204\241\351\231\243\345\210\227", "A sub-index was used for a parameter that has none.", "", ""},
        {INT64_C(5), (-INT64_C(1)), "", "wrong_data_type", "\344\270\215\346\255\243\347\242\272\347\232\204\350\263\207\346\226\231\345\236\213\346\205\213", "The type of the value is not that of the parameter.", "", ""},
        {INT64_C(6), (-INT64_C(1)), "", "setting_not_allowed", "\344\270\215\350\242\253\345\205\201\350\250\261\347\232\204\350\250\255\345\256\232 (\345\217\257\350\203\275\345\217\252\350\203\275\351\207\215\347\275\256)", "A value other than 0 was written where that is not allowed; perhaps the parameter can only be reset.", "", ""},
        {INT64_C(7), (-INT64_C(1)), "", "description_not_changeable", "\344\270\215\345\217\257\346\224\271\350\256\212\346\217\217\350\277\260\345\205\203\347\264\240", "The element of the description cannot be written.", "", ""},
        {INT64_C(9), (-INT64_C(1)), "", "description_not_available", "\347\204\241\346\263\225\345\217\226\345\276\227\347\232\204\346\217\217\350\277\260\350\263\207\346\226\231", "There is no such description.", "", ""},
        {INT64_C(11), (-INT64_C(1)), "", "no_priority", "\347\204\241\345\204\252\345\205\210\345\255\230\345\217\226\346\254\212", "Whoever asks has no right to change the parameter.", "", ""},
        {INT64_C(15), (-INT64_C(1)), "", "text_array_not_available", "\347\204\241\346\263\225\345\217\226\345\276\227\347\232\204\346\226\207\345\255\227\351\231\243\345\210\227", "There is no such array of texts.", "", ""},
        {INT64_C(17), (-INT64_C(1)), "", "operating_state_prevents_access", "\345\233\240\351\201\213\350\275\211\347\213\200\346\205\213\350\200\214\347\204\241\346\263\225\345\237\267\350\241\214\350\253\213\346\261\202", "The parameter cannot be accessed at present, for a reason that is not given.", "", ""},
        {INT64_C(20), (-INT64_C(1)), "", "value_not_allowed", "\344\270\215\345\205\201\350\250\261\347\232\204\345\200\274", "The value is within the limits, but is not one of those that the parameter may take.", "", ""},
        {INT64_C(21), (-INT64_C(1)), "", "response_too_long", "\345\233\236\346\207\211\345\244\252\351\225\267", "The response would be longer than what can be sent at once.", "", "Ask for less in one request."},
        {INT64_C(22), (-INT64_C(1)), "", "parameter_address_not_allowed", "\344\270\215\345\205\201\350\250\261\347\232\204\345\217\203\346\225\270\344\275\215\345\235\200", "Attribute, number of elements, parameter number or sub-index, or several of them together, are not valid or not supported.", "", ""},
        {INT64_C(23), (-INT64_C(1)), "", "wrong_format", "\351\235\236\346\263\225\347\232\204\346\240\274\345\274\217", "Writing: the format is not valid, or does not suit the parameter.", "", ""},
        {INT64_C(24), (-INT64_C(1)), "", "value_count_inconsistent", "\345\200\274\346\225\270\351\207\217\344\270\215\344\270\200\350\207\264", "Writing: the number of values is not the number of elements in the address.", "", ""},
        {INT64_C(25), (-INT64_C(1)), "", "axis_missing", "\344\270\215\345\255\230\345\234\250\347\232\204\350\273\270 / DO", "There is no such axis or drive object.", "", ""},
        {INT64_C(32), (-INT64_C(1)), "", "text_not_changeable", "\344\270\215\345\217\257\346\224\271\350\256\212\345\217\203\346\225\270\346\226\207\345\255\227\345\205\203\347\264\240", "The element of the parameter's texts cannot be written.", "", ""},
        {INT64_C(33), (-INT64_C(1)), "", "service_not_supported", "\344\270\215\346\224\257\346\217\264\346\255\244\346\234\215\345\213\231", "The request ID is not valid or unknown. The response ID is 80h then.", "", ""},
        {INT64_C(34), (-INT64_C(1)), "", "too_many_parameters", "\345\244\252\345\244\232\345\217\203\346\225\270\350\253\213\346\261\202", "The request asks for more parameters than one request may.", "", ""},
        {INT64_C(35), (-INT64_C(1)), "", "several_parameters_not_supported", "\344\270\215\346\224\257\346\217\264\345\244\232\345\217\203\346\225\270\345\255\230\345\217\226", "Requests for several parameters are not supported.", "", ""},
    };
    size_t at;
    for (at = 0; at < sizeof texts / sizeof texts[0]; at++) {
        if (texts[at].code == code) {
            return &texts[at];
        }
    }
    return NULL;
}

/** The texts of a code of hiwin_e_warning_code, or NULL if the code is unknown. */
static inline const hiwin_e_code_text *hiwin_e_warning_code_text(int64_t code)
{
    static const hiwin_e_code_text texts[] = {
        {INT64_C(2304), (-INT64_C(1)), "AL.900", "position_deviation_too_large", "\344\275\215\347\275\256\345\201\217\345\267\256\351\201\216\345\244\247", "", "", ""},
        {INT64_C(2305), (-INT64_C(1)), "AL.901", "unsupported_901", "", "", "", ""},
        {INT64_C(2320), (-INT64_C(1)), "AL.910", "overload", "\351\201\216\350\274\211", "", "", ""},
        {INT64_C(2321), (-INT64_C(1)), "AL.911", "unsupported_911", "", "", "", ""},
        {INT64_C(2322), (-INT64_C(1)), "AL.912", "unsupported_912", "", "", "", ""},
        {INT64_C(2336), (-INT64_C(1)), "AL.920", "unsupported_920", "", "", "", ""},
        {INT64_C(2337), (-INT64_C(1)), "AL.921", "unsupported_921", "", "", "", ""},
        {INT64_C(2339), (-INT64_C(1)), "AL.923", "internal_fan_stopped", "\345\205\247\351\203\250\351\242\250\346\211\207\345\201\234\346\255\242\351\201\213\350\275\211", "", "", ""},
        {INT64_C(2340), (-INT64_C(1)), "AL.924", "i2t", "I\302\262T", "The square of the current over time is too large.", "", ""},
        {INT64_C(2352), (-INT64_C(1)), "AL.930", "encoder_battery_fault", "\347\267\250\347\242\274\345\231\250\351\233\273\346\261\240\346\225\205\351\232\234\350\255\246\345\221\212", "", "", ""},
        {INT64_C(2369), (-INT64_C(1)), "AL.941", "restart_required", "\350\256\212\346\233\264\344\272\206\351\234\200\345\204\262\345\255\230\344\270\246\351\207\215\346\226\260\346\216\245\351\200\232\351\233\273\346\272\220\346\211\215\345\217\257\347\224\237\346\225\210\347\232\204\345\217\203\346\225\270\346\210\226\345\212\237\350\203\275", "Something was changed that must be stored and takes effect after power has been off and on.", "", ""},
        {INT64_C(2371), (-INT64_C(1)), "AL.943", "fieldbus_synchronization_time", "\347\270\275\347\267\232\351\200\232\350\250\212\345\220\214\346\255\245\346\231\202\351\226\223\350\255\246\345\221\212", "", "", ""},
        {INT64_C(2372), (-INT64_C(1)), "AL.944", "system_warning", "\347\263\273\347\265\261\350\255\246\345\221\212", "", "", ""},
        {INT64_C(2373), (-INT64_C(1)), "AL.945", "torque_limit", "\350\275\211\347\237\251\351\231\220\345\210\266\350\255\246\345\221\212", "", "", ""},
        {INT64_C(2374), (-INT64_C(1)), "AL.946", "encoder_communication", "\347\267\250\347\242\274\345\231\250\351\200\232\350\250\212\350\255\246\345\221\212", "", "", ""},
        {INT64_C(2375), (-INT64_C(1)), "AL.947", "multi_station_function_disabled", "\345\244\232\345\267\245\344\275\215\345\212\237\350\203\275\345\244\261\346\225\210\350\255\246\345\221\212", "", "", ""},
        {INT64_C(2417), (-INT64_C(1)), "AL.971", "undervoltage", "\344\275\216\351\233\273\345\243\223", "", "", ""},
        {INT64_C(2432), (-INT64_C(1)), "AL.980", "operation", "", "The controller has asked for something that the drive does not do; parameter 3120h says what.", "", ""},
        {INT64_C(2464), (-INT64_C(1)), "AL.9A0", "overtravel_servo_on", "\350\266\205\347\250\213 (\344\274\272\346\234\215ON\346\231\202\346\252\242\345\207\272\344\273\273\344\270\200\350\266\205\347\250\213\350\250\212\350\231\237)", "An overtravel signal while the servo is on.", "", ""},
        {INT64_C(2465), (-INT64_C(1)), "AL.9A1", "positive_overtravel_servo_off", "\350\266\205\347\250\213 (\344\274\272\346\234\215OFF\346\231\202\346\252\242\345\207\272P-OT\350\250\212\350\231\237)", "The signal P-OT while the servo is off.", "", ""},
        {INT64_C(2466), (-INT64_C(1)), "AL.9A2", "negative_overtravel_servo_off", "\350\266\205\347\250\213 (\344\274\272\346\234\215OFF\346\231\202\346\252\242\345\207\272N-OT\350\250\212\350\231\237)", "The signal N-OT while the servo is off.", "", ""},
        {INT64_C(2474), (-INT64_C(1)), "AL.9AA", "unsupported_9aa", "", "", "", ""},
        {INT64_C(2475), (-INT64_C(1)), "AL.9Ab", "unsupported_9ab", "", "", "", ""},
        {INT64_C(2544), (-INT64_C(1)), "AL.9F0", "overvoltage", "\344\274\272\346\234\215\351\233\273\345\243\223\351\201\216\351\253\230", "", "", ""},
    };
    size_t at;
    for (at = 0; at < sizeof texts / sizeof texts[0]; at++) {
        if (texts[at].code == code) {
            return &texts[at];
        }
    }
    return NULL;
}
#endif

/* ---- Values that stand for a state ---- */

/** Whether servo_parameters.negative_fixed_stop_tolerance is not a quantity: as_positive. */
static inline bool hiwin_e_par_servo_parameters_negative_fixed_stop_tolerance_is_absent(uint32_t value)
{
    return value == 0u;
}

/** Whether servo_parameters.negative_fixed_stop_torque is not a quantity: as_positive. */
static inline bool hiwin_e_par_servo_parameters_negative_fixed_stop_torque_is_absent(uint32_t value)
{
    return value == 0u;
}

#ifndef HIWIN_E_WITHOUT_DOUBLE

/**
 * servo_parameters.negative_fixed_stop_torque as a quantity, in Nm or N; refused for a count that stands for
 * as_positive.
 */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_negative_fixed_stop_torque_from_raw(uint32_t raw,
        double *quantity)
{
    if (raw == 0u) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    *quantity = (double)raw / 1000.0;
    return HIWIN_E_OK;
}

/**
 * The count of a quantity, the nearest one, of two equally near ones the even one; refused where it
 * is not in 0..2147483647, and where it stands for as_positive.
 */
static inline hiwin_e_codec_status hiwin_e_par_servo_parameters_negative_fixed_stop_torque_to_raw(double quantity,
        uint32_t *raw)
{
    double count, rest;
    uint32_t whole;
    count = quantity * 1000.0;
    if (!(count > -1.0 / 2.0 && count < 4294967295.0 / 2.0)) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    whole = (uint32_t)count;
    rest = count - (double)whole;
    if (rest > 0.5 || (rest >= 0.5 && whole % 2u != 0u)) {
        whole = (uint32_t)(whole + 1u);
    }
    if (whole == 0u) {
        return HIWIN_E_ERR_OUT_OF_RANGE;
    }
    *raw = whole;
    return HIWIN_E_OK;
}

#endif

/* ---- Values out of range ---- */

/** Whether mdi_velocity is outside of its stated range. */
static inline bool hiwin_e_signal_mdi_velocity_is_out_of_range(int32_t value)
{
    return !(value >= 0);
}

/** Whether mdi_acceleration is outside of its stated range. */
static inline bool hiwin_e_signal_mdi_acceleration_is_out_of_range(uint16_t value)
{
    return !(value <= 16384u);
}

/** Whether mdi_deceleration is outside of its stated range. */
static inline bool hiwin_e_signal_mdi_deceleration_is_out_of_range(uint16_t value)
{
    return !(value <= 16384u);
}

/** Whether velocity_override is outside of its stated range. */
static inline bool hiwin_e_signal_velocity_override_is_out_of_range(uint16_t value)
{
    return !(value <= 32767u);
}

/** Whether torque_reduction is outside of its stated range. */
static inline bool hiwin_e_signal_torque_reduction_is_out_of_range(uint16_t value)
{
    return !(value <= 16384u);
}

/** Whether positive_torque_limit is outside of its stated range. */
static inline bool hiwin_e_signal_positive_torque_limit_is_out_of_range(int16_t value)
{
    return !(value >= 0);
}

/** Whether negative_torque_limit is outside of its stated range. */
static inline bool hiwin_e_signal_negative_torque_limit_is_out_of_range(int16_t value)
{
    return !(value <= 0);
}

/** Whether telegram_9_request.mdi_velocity is outside of its stated range. */
static inline bool hiwin_e_telegram_9_request_mdi_velocity_is_out_of_range(int32_t value)
{
    return !(value >= 0);
}

/** Whether telegram_9_request.mdi_acceleration is outside of its stated range. */
static inline bool hiwin_e_telegram_9_request_mdi_acceleration_is_out_of_range(uint16_t value)
{
    return !(value <= 16384u);
}

/** Whether telegram_9_request.mdi_deceleration is outside of its stated range. */
static inline bool hiwin_e_telegram_9_request_mdi_deceleration_is_out_of_range(uint16_t value)
{
    return !(value <= 16384u);
}

/** Whether telegram_102_request.torque_reduction is outside of its stated range. */
static inline bool hiwin_e_telegram_102_request_torque_reduction_is_out_of_range(uint16_t value)
{
    return !(value <= 16384u);
}

/** Whether telegram_105_request.torque_reduction is outside of its stated range. */
static inline bool hiwin_e_telegram_105_request_torque_reduction_is_out_of_range(uint16_t value)
{
    return !(value <= 16384u);
}

/** Whether telegram_111_request.velocity_override is outside of its stated range. */
static inline bool hiwin_e_telegram_111_request_velocity_override_is_out_of_range(uint16_t value)
{
    return !(value <= 32767u);
}

/** Whether telegram_111_request.mdi_velocity is outside of its stated range. */
static inline bool hiwin_e_telegram_111_request_mdi_velocity_is_out_of_range(int32_t value)
{
    return !(value >= 0);
}

/** Whether telegram_111_request.mdi_acceleration is outside of its stated range. */
static inline bool hiwin_e_telegram_111_request_mdi_acceleration_is_out_of_range(uint16_t value)
{
    return !(value <= 16384u);
}

/** Whether telegram_111_request.mdi_deceleration is outside of its stated range. */
static inline bool hiwin_e_telegram_111_request_mdi_deceleration_is_out_of_range(uint16_t value)
{
    return !(value <= 16384u);
}

/** Whether telegram_750_request.positive_torque_limit is outside of its stated range. */
static inline bool hiwin_e_telegram_750_request_positive_torque_limit_is_out_of_range(int16_t value)
{
    return !(value >= 0);
}

/** Whether telegram_750_request.negative_torque_limit is outside of its stated range. */
static inline bool hiwin_e_telegram_750_request_negative_torque_limit_is_out_of_range(int16_t value)
{
    return !(value <= 0);
}

/** Whether drive_parameters.digital_outputs is outside of its stated range. */
static inline bool hiwin_e_par_drive_parameters_digital_outputs_is_out_of_range(uint16_t value)
{
    return !(value <= 31u);
}

/** Whether drive_parameters.reference_mark_functions is outside of its stated range. */
static inline bool hiwin_e_par_drive_parameters_reference_mark_functions_is_out_of_range(uint16_t value)
{
    return !(value <= 3u);
}

/** Whether drive_parameters.speed_analog_input_voltage is outside of its stated range. */
static inline bool hiwin_e_par_drive_parameters_speed_analog_input_voltage_is_out_of_range(int16_t value)
{
    return !(value >= (-10000) && value <= 10000);
}

/** Whether drive_parameters.speed_analog_input_offset is outside of its stated range. */
static inline bool hiwin_e_par_drive_parameters_speed_analog_input_offset_is_out_of_range(int16_t value)
{
    return !(value >= (-10000) && value <= 10000);
}

/** Whether drive_parameters.torque_analog_input_voltage is outside of its stated range. */
static inline bool hiwin_e_par_drive_parameters_torque_analog_input_voltage_is_out_of_range(int16_t value)
{
    return !(value >= (-10000) && value <= 10000);
}

/** Whether drive_parameters.torque_analog_input_offset is outside of its stated range. */
static inline bool hiwin_e_par_drive_parameters_torque_analog_input_offset_is_out_of_range(int16_t value)
{
    return !(value >= (-10000) && value <= 10000);
}

/** Whether drive_parameters.analog_output_1_voltage is outside of its stated range. */
static inline bool hiwin_e_par_drive_parameters_analog_output_1_voltage_is_out_of_range(int16_t value)
{
    return !(value >= (-10000) && value <= 10000);
}

/** Whether drive_parameters.analog_output_2_voltage is outside of its stated range. */
static inline bool hiwin_e_par_drive_parameters_analog_output_2_voltage_is_out_of_range(int16_t value)
{
    return !(value >= (-10000) && value <= 10000);
}

/** Whether drive_parameters.position_trigger_array_index is outside of its stated range. */
static inline bool hiwin_e_par_drive_parameters_position_trigger_array_index_is_out_of_range(uint16_t value)
{
    return !(value <= 255u);
}

/** Whether drive_parameters.position_trigger_status is outside of its stated range. */
static inline bool hiwin_e_par_drive_parameters_position_trigger_status_is_out_of_range(int16_t value)
{
    return !(value >= 0);
}

/** Whether drive_parameters.gantry_parameter_index is outside of its stated range. */
static inline bool hiwin_e_par_drive_parameters_gantry_parameter_index_is_out_of_range(uint16_t value)
{
    return !(value >= 8192u && value <= 20479u);
}

/** Whether drive_parameters.gantry_parameter_subindex is outside of its stated range. */
static inline bool hiwin_e_par_drive_parameters_gantry_parameter_subindex_is_out_of_range(uint16_t value)
{
    return !(value == 0u);
}

/** Whether drive_parameters.gantry_parameter_type is outside of its stated range. */
static inline bool hiwin_e_par_drive_parameters_gantry_parameter_type_is_out_of_range(int16_t value)
{
    return !(value >= (-3) && value <= 8);
}

/** Whether servo_parameters.quick_stop_deceleration_time is outside of its stated range. */
static inline bool hiwin_e_par_servo_parameters_quick_stop_deceleration_time_is_out_of_range(uint16_t value)
{
    return !(value <= 10000u);
}

/** Whether servo_parameters.reference_speed_rotary is outside of its stated range. */
static inline bool hiwin_e_par_servo_parameters_reference_speed_rotary_is_out_of_range(uint16_t value)
{
    return !(value >= 1u);
}

/** Whether servo_parameters.maximum_speed_linear is outside of its stated range. */
static inline bool hiwin_e_par_servo_parameters_maximum_speed_linear_is_out_of_range(uint16_t value)
{
    return !(value <= 100u);
}

/** Whether servo_parameters.reference_speed_linear is outside of its stated range. */
static inline bool hiwin_e_par_servo_parameters_reference_speed_linear_is_out_of_range(uint16_t value)
{
    return !(value >= 1u && value <= 100u);
}

/** Whether servo_parameters.positive_torque_limit is outside of its stated range. */
static inline bool hiwin_e_par_servo_parameters_positive_torque_limit_is_out_of_range(uint16_t value)
{
    return !(value <= 800u);
}

/** Whether servo_parameters.negative_torque_limit is outside of its stated range. */
static inline bool hiwin_e_par_servo_parameters_negative_torque_limit_is_out_of_range(uint16_t value)
{
    return !(value <= 800u);
}

/** Whether servo_parameters.reference_torque is outside of its stated range. */
static inline bool hiwin_e_par_servo_parameters_reference_torque_is_out_of_range(uint32_t value)
{
    return !(value <= 2147483647u);
}

/** Whether servo_parameters.positive_fixed_stop_tolerance is outside of its stated range. */
static inline bool hiwin_e_par_servo_parameters_positive_fixed_stop_tolerance_is_out_of_range(uint32_t value)
{
    return !(value <= 2147483647u);
}

/** Whether servo_parameters.negative_fixed_stop_tolerance is outside of its stated range. */
static inline bool hiwin_e_par_servo_parameters_negative_fixed_stop_tolerance_is_out_of_range(uint32_t value)
{
    return !(value <= 2147483647u);
}

/** Whether servo_parameters.positive_fixed_stop_torque is outside of its stated range. */
static inline bool hiwin_e_par_servo_parameters_positive_fixed_stop_torque_is_out_of_range(uint32_t value)
{
    return !(value <= 2147483647u);
}

/** Whether servo_parameters.negative_fixed_stop_torque is outside of its stated range. */
static inline bool hiwin_e_par_servo_parameters_negative_fixed_stop_torque_is_out_of_range(uint32_t value)
{
    return !(value <= 2147483647u);
}

/** Whether servo_parameters.fixed_stop_following_error is outside of its stated range. */
static inline bool hiwin_e_par_servo_parameters_fixed_stop_following_error_is_out_of_range(uint32_t value)
{
    return !(value <= 2147483647u);
}

/** Whether servo_parameters.reference_force is outside of its stated range. */
static inline bool hiwin_e_par_servo_parameters_reference_force_is_out_of_range(uint32_t value)
{
    return !(value <= 2147483647u);
}

/** Whether servo_parameters.positive_force_limit is outside of its stated range. */
static inline bool hiwin_e_par_servo_parameters_positive_force_limit_is_out_of_range(uint16_t value)
{
    return !(value <= 800u);
}

/** Whether servo_parameters.negative_force_limit is outside of its stated range. */
static inline bool hiwin_e_par_servo_parameters_negative_force_limit_is_out_of_range(uint16_t value)
{
    return !(value <= 800u);
}

/** Whether servo_parameters.point_to_point_speed_rotary is outside of its stated range. */
static inline bool hiwin_e_par_servo_parameters_point_to_point_speed_rotary_is_out_of_range(uint16_t value)
{
    return !(value >= 1u && value <= 10000u);
}

/** Whether servo_parameters.point_to_point_acceleration_time is outside of its stated range. */
static inline bool hiwin_e_par_servo_parameters_point_to_point_acceleration_time_is_out_of_range(uint16_t value)
{
    return !(value >= 2u && value <= 10000u);
}

/** Whether servo_parameters.point_to_point_deceleration_time is outside of its stated range. */
static inline bool hiwin_e_par_servo_parameters_point_to_point_deceleration_time_is_out_of_range(uint16_t value)
{
    return !(value >= 2u && value <= 10000u);
}

/** Whether servo_parameters.point_to_point_emergency_deceleration_time is outside of its stated range. */
static inline bool hiwin_e_par_servo_parameters_point_to_point_emergency_deceleration_time_is_out_of_range(uint16_t value)
{
    return !(value >= 2u && value <= 10000u);
}

/** Whether servo_parameters.point_to_point_distance is outside of its stated range. */
static inline bool hiwin_e_par_servo_parameters_point_to_point_distance_is_out_of_range(int32_t value)
{
    return !(value >= 1 && value <= 1073741824);
}

/** Whether servo_parameters.point_to_point_speed_linear is outside of its stated range. */
static inline bool hiwin_e_par_servo_parameters_point_to_point_speed_linear_is_out_of_range(uint16_t value)
{
    return !(value >= 1u && value <= 10000u);
}

#endif
