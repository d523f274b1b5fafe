/*
 * ESC11-B (TAIYO), version 1.17
 * From: ESG1 series, RS485 communication, ESC11-B, instruction manual
 * Identity: 499facc7f5252c73
 *
 * Generated; do not edit. For C99 and later and C++98 to C++20, hosted or freestanding, with any byte order, any alignment and an
 * int of 16 bits or more. Headers from this generator compile without warnings with gcc and clang, and pass cppcheck. Their
 * self-tests pass on x86-64, AArch64, m68k (big-endian; int of 32 and 16 bits) and Cortex-M0, and under sanitizers; their fuzz
 * targets find nothing.
 *
 * Define before you include it:
 *   ESC11_WITH_TEXTS adds the texts of codes, which take memory
 */
#include "esc11_v1_17_constants.h"
#ifndef ESC11_INCLUDED
#define ESC11_INCLUDED

/* ---- Compilers and machines ---- */

#ifdef __GNUC__
/** A call would take more code than the function itself, even with -Os. */
#define ESC11_INLINE static inline __attribute__((always_inline))
#define ESC11_LIKELY(test) __builtin_expect(!!(test), 1)
/** Built-in functions need no string.h, and no call for a few bytes, also in freestanding code. */
#define ESC11_COPY(to, from, size) __builtin_memcpy((to), (from), (size))
#define ESC11_CLEAR(to, size) __builtin_memset((to), 0, (size))
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__ && \
    (defined(__x86_64__) || defined(__i386__) || defined(__aarch64__) || defined(__ARM_FEATURE_UNALIGNED))
/**
 * Store a number with one instruction. Compilers merge loads of single bytes by themselves, and mostly stores
 * too. Where they may reorder stores, they build vectors instead, which take up to four times as long.
 */
#define ESC11_STORES_AT_ONCE
#endif
#else
#include <string.h>
#define ESC11_INLINE static inline
#define ESC11_LIKELY(test) (test)
#define ESC11_COPY(to, from, size) memcpy((to), (from), (size))
#define ESC11_CLEAR(to, size) memset((to), 0, (size))
#endif

/* ---- Results of codec calls ---- */

/** The result of a codec call. */
typedef enum esc11_codec_status {
    ESC11_OK = 0, /**< No error. */
    ESC11_ERR_INCOMPLETE = 1, /**< There are too few bytes. */
    ESC11_ERR_WRONG_LENGTH = 2, /**< The number of bytes or elements is wrong. */
    ESC11_ERR_WRONG_MARK = 3, /**< A delimiter of the frame is missing or wrong. */
    ESC11_ERR_NOT_HEX = 4, /**< A character is not a hexadecimal digit. */
    ESC11_ERR_WRONG_CHECKSUM = 5, /**< The checksum does not match. */
    ESC11_ERR_UNKNOWN_CODE = 6, /**< No message has this code. */
    ESC11_ERR_UNKNOWN_VALUE = 7, /**< The value is not a member of its enum, or the text is not ASCII. */
    ESC11_ERR_WRONG_CONST = 8, /**< A constant field has another value. */
    ESC11_ERR_WRONG_MEASURE = 9, /**< A length or count field does not match the data. */
    ESC11_ERR_OUT_OF_RANGE = 10, /**< A value is out of range. */
    ESC11_ERR_CAPACITY = 11 /**< The buffer is too small. */
} esc11_codec_status;

/* ---- Numbers and characters ---- */

ESC11_INLINE uint8_t esc11_load_u8(const uint8_t *in)
{
    return in[0];
}

ESC11_INLINE void esc11_store_u8(uint8_t *out, uint8_t value)
{
    out[0] = value;
}

ESC11_INLINE uint16_t esc11_load_u16_le(const uint8_t *in)
{
    return (uint16_t)((uint32_t)in[0] | ((uint32_t)in[1] << 8));
}

ESC11_INLINE void esc11_store_u16_le(uint8_t *out, uint16_t value)
{
#ifdef ESC11_STORES_AT_ONCE
    ESC11_COPY(out, &value, sizeof value);
#else
    out[0] = (uint8_t)value;
    out[1] = (uint8_t)(value >> 8);
#endif
}

ESC11_INLINE uint32_t esc11_load_u32_le(const uint8_t *in)
{
    return (uint32_t)in[0] | ((uint32_t)in[1] << 8) |
           ((uint32_t)in[2] << 16) | ((uint32_t)in[3] << 24);
}

ESC11_INLINE void esc11_store_u32_le(uint8_t *out, uint32_t value)
{
#ifdef ESC11_STORES_AT_ONCE
    ESC11_COPY(out, &value, sizeof value);
#else
    out[0] = (uint8_t)value;
    out[1] = (uint8_t)(value >> 8);
    out[2] = (uint8_t)(value >> 16);
    out[3] = (uint8_t)(value >> 24);
#endif
}

ESC11_INLINE int8_t esc11_signed_8(uint8_t raw)
{
    return (int8_t)((raw & 0x80u) ? -(int32_t)(uint8_t)~raw - 1 : (int32_t)raw);
}

ESC11_INLINE int16_t esc11_signed_16(uint16_t raw)
{
    return (int16_t)((raw & 0x8000u) ? -(int32_t)(uint16_t)~raw - 1 : (int32_t)raw);
}

ESC11_INLINE int32_t esc11_signed_32(uint32_t raw)
{
    return (int32_t)((raw & 0x80000000u) ? -(int32_t)(uint32_t)~raw - 1 : (int32_t)raw);
}

ESC11_INLINE int64_t esc11_signed_64(uint64_t raw)
{
    return (int64_t)((raw & UINT64_C(0x8000000000000000)) ? -(int64_t)(uint64_t)~raw - 1 : (int64_t)raw);
}

static inline bool esc11_is_ascii(const uint8_t *in, size_t size)
{
    size_t offset;
    for (offset = 0; offset < size; offset++) {
        if (in[offset] > 127u) {
            return false;
        }
    }
    return true;
}

/** Whether a text of at most `size` characters is ASCII. */
static inline bool esc11_is_text(const char *text, size_t size)
{
    size_t offset;
    for (offset = 0; offset < size && text[offset] != '\0'; offset++) {
        if ((uint8_t)text[offset] > 127u) {
            return false;
        }
    }
    return true;
}

/** Writes a text of at most `size` characters, padded with zeros. */
static inline void esc11_put_text(uint8_t *out, const char *text, size_t size)
{
    size_t offset;
    ESC11_CLEAR(out, size);
    for (offset = 0; offset < size && text[offset] != '\0'; offset++) {
        out[offset] = (uint8_t)text[offset];
    }
}

/* ---- Checksums ---- */

/** The low byte of the sum of all bytes. */
static inline uint8_t esc11_sum8(const uint8_t *in, size_t size)
{
    uint32_t sum = 0;
    size_t offset;
    for (offset = 0; offset < size; offset++) {
        sum += in[offset];
    }
    return (uint8_t)(sum & 0xFFu);
}

/* ---- Enums and codes ---- */

/** Whether a value is one of esc11_homing_direction. */
static inline bool esc11_homing_direction_known(int64_t value)
{
    return ESC11_LIKELY(value >= INT64_C(0) && value <= INT64_C(1));
}

/** Whether a value is one of esc11_homing_method. */
static inline bool esc11_homing_method_known(int64_t value)
{
    return ESC11_LIKELY(value >= INT64_C(0) && value <= INT64_C(1));
}

/** Whether a value is one of esc11_point_mode. */
static inline bool esc11_point_mode_known(int64_t value)
{
    if (value == INT64_C(65)) {
        return true;
    }
    if (value == INT64_C(67)) {
        return true;
    }
    if (value >= INT64_C(71) && value <= INT64_C(75)) {
        return true;
    }
    return ESC11_LIKELY(value == INT64_C(79));
}

/* ---- Bit fields ---- */

static inline bool esc11_communication_status_executing(uint8_t word)
{
    return (word & ESC11_COMMUNICATION_STATUS_EXECUTING_MASK) != 0;
}

static inline bool esc11_communication_status_out_of_position(uint8_t word)
{
    return (word & ESC11_COMMUNICATION_STATUS_OUT_OF_POSITION_MASK) != 0;
}

static inline bool esc11_communication_status_servo_off(uint8_t word)
{
    return (word & ESC11_COMMUNICATION_STATUS_SERVO_OFF_MASK) != 0;
}

static inline bool esc11_communication_status_data_read_request(uint8_t word)
{
    return (word & ESC11_COMMUNICATION_STATUS_DATA_READ_REQUEST_MASK) != 0;
}

static inline bool esc11_communication_status_command_resend_request(uint8_t word)
{
    return (word & ESC11_COMMUNICATION_STATUS_COMMAND_RESEND_REQUEST_MASK) != 0;
}

static inline bool esc11_communication_status_command_error(uint8_t word)
{
    return (word & ESC11_COMMUNICATION_STATUS_COMMAND_ERROR_MASK) != 0;
}

static inline bool esc11_communication_status_alarm(uint8_t word)
{
    return (word & ESC11_COMMUNICATION_STATUS_ALARM_MASK) != 0;
}

static inline bool esc11_communication_status_communication_error(uint8_t word)
{
    return (word & ESC11_COMMUNICATION_STATUS_COMMUNICATION_ERROR_MASK) != 0;
}

static inline bool esc11_io_inputs_point_input_0(uint8_t word)
{
    return (word & ESC11_IO_INPUTS_POINT_INPUT_0_MASK) != 0;
}

static inline bool esc11_io_inputs_point_input_1(uint8_t word)
{
    return (word & ESC11_IO_INPUTS_POINT_INPUT_1_MASK) != 0;
}

static inline bool esc11_io_inputs_point_input_2(uint8_t word)
{
    return (word & ESC11_IO_INPUTS_POINT_INPUT_2_MASK) != 0;
}

static inline bool esc11_io_inputs_point_input_3(uint8_t word)
{
    return (word & ESC11_IO_INPUTS_POINT_INPUT_3_MASK) != 0;
}

static inline bool esc11_io_inputs_point_input_4(uint8_t word)
{
    return (word & ESC11_IO_INPUTS_POINT_INPUT_4_MASK) != 0;
}

static inline bool esc11_io_inputs_start(uint8_t word)
{
    return (word & ESC11_IO_INPUTS_START_MASK) != 0;
}

static inline bool esc11_io_inputs_selection(uint8_t word)
{
    return (word & ESC11_IO_INPUTS_SELECTION_MASK) != 0;
}

static inline bool esc11_io_inputs_interlock_released(uint8_t word)
{
    return (word & ESC11_IO_INPUTS_INTERLOCK_RELEASED_MASK) != 0;
}

static inline bool esc11_io_outputs_point_output_0(uint8_t word)
{
    return (word & ESC11_IO_OUTPUTS_POINT_OUTPUT_0_MASK) != 0;
}

static inline bool esc11_io_outputs_point_output_1(uint8_t word)
{
    return (word & ESC11_IO_OUTPUTS_POINT_OUTPUT_1_MASK) != 0;
}

static inline bool esc11_io_outputs_point_output_2(uint8_t word)
{
    return (word & ESC11_IO_OUTPUTS_POINT_OUTPUT_2_MASK) != 0;
}

static inline bool esc11_io_outputs_point_output_3(uint8_t word)
{
    return (word & ESC11_IO_OUTPUTS_POINT_OUTPUT_3_MASK) != 0;
}

static inline bool esc11_io_outputs_point_output_4(uint8_t word)
{
    return (word & ESC11_IO_OUTPUTS_POINT_OUTPUT_4_MASK) != 0;
}

static inline bool esc11_io_outputs_homing_complete(uint8_t word)
{
    return (word & ESC11_IO_OUTPUTS_HOMING_COMPLETE_MASK) != 0;
}

static inline bool esc11_io_outputs_in_zone(uint8_t word)
{
    return (word & ESC11_IO_OUTPUTS_IN_ZONE_MASK) != 0;
}

static inline bool esc11_io_state_outputs_ready(uint8_t word)
{
    return (word & ESC11_IO_STATE_OUTPUTS_READY_MASK) != 0;
}

static inline bool esc11_io_state_outputs_busy(uint8_t word)
{
    return (word & ESC11_IO_STATE_OUTPUTS_BUSY_MASK) != 0;
}

static inline bool esc11_io_state_outputs_alarm(uint8_t word)
{
    return (word & ESC11_IO_STATE_OUTPUTS_ALARM_MASK) != 0;
}

static inline bool esc11_io_state_outputs_in_position(uint8_t word)
{
    return (word & ESC11_IO_STATE_OUTPUTS_IN_POSITION_MASK) != 0;
}

static inline bool esc11_io_state_outputs_hold(uint8_t word)
{
    return (word & ESC11_IO_STATE_OUTPUTS_HOLD_MASK) != 0;
}

static inline bool esc11_io_state_outputs_run_lamp(uint8_t word)
{
    return (word & ESC11_IO_STATE_OUTPUTS_RUN_LAMP_MASK) != 0;
}

static inline bool esc11_io_state_outputs_ready_lamp(uint8_t word)
{
    return (word & ESC11_IO_STATE_OUTPUTS_READY_LAMP_MASK) != 0;
}

static inline bool esc11_io_state_outputs_alarm_lamp(uint8_t word)
{
    return (word & ESC11_IO_STATE_OUTPUTS_ALARM_LAMP_MASK) != 0;
}

/* ---- Records ---- */

/**
 * One alarm with the accumulated time at which it came up.
 * Source: 9.4.4 L956; 10.1 L1229-1232
 */
typedef struct esc11_alarm_history_entry {
    /**
     * Printed as 累计时间的小时数.
     * One count is 1 h. Range: 0..65535.
     * Source: 9.4.4 L956, 961
     */
    uint16_t hours;
    /**
     * Printed as 累计时间的分钟数.
     * One count is 1 min. Range: 0..60.
     * Note: The upper end of 60 is as printed; see command 48h.
     * Source: 9.4.4 L956, 962
     */
    uint8_t minutes;
    /**
     * Printed as 警报编号.
     * Range: 0..255. See alarm_code.
     * Source: 10.1 L1231
     */
    uint8_t alarm_code;
} esc11_alarm_history_entry;

/** Whether the values of esc11_alarm_history_entry may be written. */
static inline esc11_codec_status esc11_alarm_history_entry_check(const esc11_alarm_history_entry *in)
{
    if (!(in->minutes <= 60u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    return ESC11_OK;
}

/** Writes esc11_alarm_history_entry to 4 bytes without checks. */
static inline void esc11_alarm_history_entry_pack(const esc11_alarm_history_entry *in, uint8_t *out)
{
    esc11_store_u16_le(out + 0, in->hours);
    esc11_store_u8(out + 2, in->minutes);
    esc11_store_u8(out + 3, in->alarm_code);
}

/** Reads esc11_alarm_history_entry from 4 bytes without checks. */
static inline void esc11_alarm_history_entry_unpack(const uint8_t *in, esc11_alarm_history_entry *out)
{
    out->hours = esc11_load_u16_le(in + 0);
    out->minutes = esc11_load_u8(in + 2);
    out->alarm_code = esc11_load_u8(in + 3);
}

/**
 * Writes esc11_alarm_history_entry: 4 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_alarm_history_entry_encode(const esc11_alarm_history_entry *in, uint8_t *out,
        size_t capacity, size_t *length)
{
    esc11_codec_status status;
    if (capacity < 4u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_alarm_history_entry_check(in);
    if (status != ESC11_OK) {
        return status;
    }
    esc11_alarm_history_entry_pack(in, out);
    *length = 4u;
    return ESC11_OK;
}

/** Reads esc11_alarm_history_entry from exactly 4 bytes. */
static inline esc11_codec_status esc11_alarm_history_entry_decode(const uint8_t *in, size_t length,
        esc11_alarm_history_entry *out)
{
    if (length != 4u) {
        return length < 4u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_alarm_history_entry_unpack(in, out);
    return ESC11_OK;
}

/**
 * One point as commands 44h, 50h and 60h carry it.
 * Printed as 表9-1 数据内容.
 * Source: 9.3.5 L806-817, 790
 */
typedef struct esc11_point {
    /**
     * Printed as 点编号.
     * Range: 1..31.
     * Source: 9.3.5 L811
     */
    uint8_t number;
    /**
     * Printed as 动作模式.
     * See point_mode.
     * Source: 9.3.5 L812
     */
    uint8_t mode;
    /**
     * Where to move, or how far, as the mode says. The constant speed modes do not need it.
     * Printed as 带符号移动量.
     * One count is 0.01 mm. Range: -134217727..134217727.
     * Source: 9.3.5 L813
     */
    int32_t distance;
    /**
     * Printed as 速度.
     * One count is 1 %. Range: 0..100.
     * Source: 9.3.5 L814
     */
    uint8_t speed;
    /**
     * Gripping force. The samples of plain moves have 0.
     * Printed as 力.
     * One count is 1 %. Range: 0..100.
     * Source: 9.3.5 L815
     */
    uint8_t force;
    /**
     * One limit of the zone, for the modes with a zone.
     * Printed as ZON范围1.
     * One count is 0.01 mm. Range: -134217727..134217727.
     * Source: 9.3.5 L816
     */
    int32_t zone_limit_1;
    /**
     * The other limit of the zone, for the modes with a zone.
     * Printed as ZON范围2.
     * One count is 0.01 mm. Range: -134217727..134217727.
     * Source: 9.3.5 L817
     */
    int32_t zone_limit_2;
} esc11_point;

/** Whether the values of esc11_point may be written. */
static inline esc11_codec_status esc11_point_check(const esc11_point *in)
{
    if (!(in->number >= 1u && in->number <= 31u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    if (!esc11_point_mode_known((int64_t)in->mode)) {
        return ESC11_ERR_UNKNOWN_VALUE;
    }
    if (!(in->distance >= (-134217727) && in->distance <= 134217727)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    if (!(in->speed <= 100u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    if (!(in->force <= 100u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    if (!(in->zone_limit_1 >= (-134217727) && in->zone_limit_1 <= 134217727)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    if (!(in->zone_limit_2 >= (-134217727) && in->zone_limit_2 <= 134217727)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    return ESC11_OK;
}

/** Writes esc11_point to 16 bytes without checks. */
static inline void esc11_point_pack(const esc11_point *in, uint8_t *out)
{
    esc11_store_u8(out + 0, in->number);
    esc11_store_u8(out + 1, in->mode);
    esc11_store_u32_le(out + 2, (uint32_t)in->distance);
    esc11_store_u8(out + 6, in->speed);
    esc11_store_u8(out + 7, in->force);
    esc11_store_u32_le(out + 8, (uint32_t)in->zone_limit_1);
    esc11_store_u32_le(out + 12, (uint32_t)in->zone_limit_2);
}

/** Reads esc11_point from 16 bytes without checks. */
static inline void esc11_point_unpack(const uint8_t *in, esc11_point *out)
{
    out->number = esc11_load_u8(in + 0);
    out->mode = esc11_load_u8(in + 1);
    out->distance = esc11_signed_32(esc11_load_u32_le(in + 2));
    out->speed = esc11_load_u8(in + 6);
    out->force = esc11_load_u8(in + 7);
    out->zone_limit_1 = esc11_signed_32(esc11_load_u32_le(in + 8));
    out->zone_limit_2 = esc11_signed_32(esc11_load_u32_le(in + 12));
}

/**
 * Writes esc11_point: 16 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_point_encode(const esc11_point *in, uint8_t *out, size_t capacity,
        size_t *length)
{
    esc11_codec_status status;
    if (capacity < 16u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_point_check(in);
    if (status != ESC11_OK) {
        return status;
    }
    esc11_point_pack(in, out);
    *length = 16u;
    return ESC11_OK;
}

/** Reads esc11_point from exactly 16 bytes. */
static inline esc11_codec_status esc11_point_decode(const uint8_t *in, size_t length, esc11_point *out)
{
    if (length != 16u) {
        return length < 16u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_point_unpack(in, out);
    if (!esc11_point_mode_known((int64_t)out->mode)) {
        return ESC11_ERR_UNKNOWN_VALUE;
    }
    return ESC11_OK;
}

/**
 * The point of command 63h. It is laid out like a stored point, and its number is always 0.
 * Printed as 表1 数据内容.
 * Source: 9.5.4 L1044-1053, 1042
 */
typedef struct esc11_temporary_point {
    /**
     * Printed as 动作模式.
     * See point_mode.
     * Source: 9.5.4 L1048
     */
    uint8_t mode;
    /**
     * Printed as 带符号移动量.
     * One count is 0.01 mm. Range: -134217727..134217727.
     * Source: 9.5.4 L1049
     */
    int32_t distance;
    /**
     * Printed as 速度.
     * One count is 1 %. Range: 0..100.
     * Source: 9.5.4 L1050
     */
    uint8_t speed;
    /**
     * Printed as 力.
     * One count is 1 %. Range: 0..100.
     * Source: 9.5.4 L1051
     */
    uint8_t force;
    /**
     * Printed as ZON范围1.
     * One count is 0.01 mm. Range: -134217727..134217727.
     * Source: 9.5.4 L1052
     */
    int32_t zone_limit_1;
    /**
     * Printed as ZON范围2.
     * One count is 0.01 mm. Range: -134217727..134217727.
     * Source: 9.5.4 L1053
     */
    int32_t zone_limit_2;
} esc11_temporary_point;

/** Whether the values of esc11_temporary_point may be written. */
static inline esc11_codec_status esc11_temporary_point_check(const esc11_temporary_point *in)
{
    if (!esc11_point_mode_known((int64_t)in->mode)) {
        return ESC11_ERR_UNKNOWN_VALUE;
    }
    if (!(in->distance >= (-134217727) && in->distance <= 134217727)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    if (!(in->speed <= 100u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    if (!(in->force <= 100u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    if (!(in->zone_limit_1 >= (-134217727) && in->zone_limit_1 <= 134217727)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    if (!(in->zone_limit_2 >= (-134217727) && in->zone_limit_2 <= 134217727)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    return ESC11_OK;
}

/** Writes esc11_temporary_point to 16 bytes without checks. */
static inline void esc11_temporary_point_pack(const esc11_temporary_point *in, uint8_t *out)
{
    esc11_store_u8(out + 0, 0u);
    esc11_store_u8(out + 1, in->mode);
    esc11_store_u32_le(out + 2, (uint32_t)in->distance);
    esc11_store_u8(out + 6, in->speed);
    esc11_store_u8(out + 7, in->force);
    esc11_store_u32_le(out + 8, (uint32_t)in->zone_limit_1);
    esc11_store_u32_le(out + 12, (uint32_t)in->zone_limit_2);
}

/** Reads esc11_temporary_point from 16 bytes without checks. */
static inline void esc11_temporary_point_unpack(const uint8_t *in, esc11_temporary_point *out)
{
    out->mode = esc11_load_u8(in + 1);
    out->distance = esc11_signed_32(esc11_load_u32_le(in + 2));
    out->speed = esc11_load_u8(in + 6);
    out->force = esc11_load_u8(in + 7);
    out->zone_limit_1 = esc11_signed_32(esc11_load_u32_le(in + 8));
    out->zone_limit_2 = esc11_signed_32(esc11_load_u32_le(in + 12));
}

/**
 * Writes esc11_temporary_point: 16 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_temporary_point_encode(const esc11_temporary_point *in, uint8_t *out,
        size_t capacity, size_t *length)
{
    esc11_codec_status status;
    if (capacity < 16u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_temporary_point_check(in);
    if (status != ESC11_OK) {
        return status;
    }
    esc11_temporary_point_pack(in, out);
    *length = 16u;
    return ESC11_OK;
}

/** Reads esc11_temporary_point from exactly 16 bytes. */
static inline esc11_codec_status esc11_temporary_point_decode(const uint8_t *in, size_t length,
        esc11_temporary_point *out)
{
    if (length != 16u) {
        return length < 16u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_temporary_point_unpack(in, out);
    if (esc11_load_u8(in + 0) != 0u) {
        return ESC11_ERR_WRONG_CONST;
    }
    if (!esc11_point_mode_known((int64_t)out->mode)) {
        return ESC11_ERR_UNKNOWN_VALUE;
    }
    return ESC11_OK;
}

/* ---- Data of requests and responses ---- */

typedef struct esc11_read_points_request {
    /**
     * The point from which to read on.
     * Printed as 始点.
     * Range: 1..31.
     * Source: 10.1 L1215
     */
    uint8_t first_point;
} esc11_read_points_request;

/** Whether the values of esc11_read_points_request may be written. */
static inline esc11_codec_status esc11_read_points_request_check(const esc11_read_points_request *in)
{
    if (!(in->first_point >= 1u && in->first_point <= 31u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    return ESC11_OK;
}

/** Writes esc11_read_points_request to 1 byte without checks. */
static inline void esc11_read_points_request_pack(const esc11_read_points_request *in, uint8_t *out)
{
    esc11_store_u8(out + 0, in->first_point);
}

/** Reads esc11_read_points_request from 1 byte without checks. */
static inline void esc11_read_points_request_unpack(const uint8_t *in, esc11_read_points_request *out)
{
    out->first_point = esc11_load_u8(in + 0);
}

/**
 * Writes esc11_read_points_request: 1 byte.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_read_points_request_encode(const esc11_read_points_request *in, uint8_t *out,
        size_t capacity, size_t *length)
{
    esc11_codec_status status;
    if (capacity < 1u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_read_points_request_check(in);
    if (status != ESC11_OK) {
        return status;
    }
    esc11_read_points_request_pack(in, out);
    *length = 1u;
    return ESC11_OK;
}

/** Reads esc11_read_points_request from exactly 1 byte. */
static inline esc11_codec_status esc11_read_points_request_decode(const uint8_t *in, size_t length,
        esc11_read_points_request *out)
{
    if (length != 1u) {
        return length < 1u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_read_points_request_unpack(in, out);
    return ESC11_OK;
}

typedef struct esc11_read_points_response {
    /**
     * Printed as 数据.
     * Note: What is answered where no point is left to send is not printed.
     * Source: 9.4.1 L895-898, 914-916
     */
    esc11_point points[15];
    size_t points_count;
} esc11_read_points_response;

/**
 * Writes esc11_read_points_response: 16 to 240 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_read_points_response_encode(const esc11_read_points_response *in, uint8_t *out,
        size_t capacity, size_t *length)
{
    size_t at;
    esc11_codec_status status;
    if (in->points_count < 1u || in->points_count > 15u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    if (capacity < (0u + in->points_count * 16u)) {
        return ESC11_ERR_CAPACITY;
    }
    for (at = 0; at < in->points_count; at++) {
        status = esc11_point_check(&in->points[at]);
        if (status != ESC11_OK) {
            return status;
        }
        esc11_point_pack(&in->points[at], out + 0u + at * 16u);
    }
    *length = (0u + in->points_count * 16u);
    return ESC11_OK;
}

/** Reads esc11_read_points_response from exactly 16 to 240 bytes. */
static inline esc11_codec_status esc11_read_points_response_decode(const uint8_t *in, size_t length,
        esc11_read_points_response *out)
{
    size_t at;
    esc11_codec_status status;
    if (length < 16u) {
        return ESC11_ERR_INCOMPLETE;
    }
    if (length > 240u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    if ((length - 0u) % 16u != 0) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    out->points_count = (length - 0u) / 16u;
    for (at = 0; at < out->points_count; at++) {
        status = esc11_point_decode(in + 0u + at * 16u, 16u, &out->points[at]);
        if (status != ESC11_OK) {
            return status;
        }
    }
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_read_parameters_request: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_read_parameters_request_encode(uint8_t *out, size_t capacity, size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_read_parameters_request from exactly 0 bytes. */
static inline esc11_codec_status esc11_read_parameters_request_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

typedef struct esc11_read_parameters_response {
    /**
     * Printed as 参数PRM.
     * Range: 0..65535.
     * Source: 10.1 L1224-1225
     */
    uint16_t parameters[32];
} esc11_read_parameters_response;

/** Writes esc11_read_parameters_response to 64 bytes without checks. */
static inline void esc11_read_parameters_response_pack(const esc11_read_parameters_response *in, uint8_t *out)
{
    size_t at;
    for (at = 0; at < 32u; at++) {
        esc11_store_u16_le(out + 0u + at * 2u, in->parameters[at]);
    }
}

/** Reads esc11_read_parameters_response from 64 bytes without checks. */
static inline void esc11_read_parameters_response_unpack(const uint8_t *in, esc11_read_parameters_response *out)
{
    size_t at;
    for (at = 0; at < 32u; at++) {
        out->parameters[at] = esc11_load_u16_le(in + 0u + at * 2u);
    }
}

/**
 * Writes esc11_read_parameters_response: 64 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_read_parameters_response_encode(const esc11_read_parameters_response *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    if (capacity < 64u) {
        return ESC11_ERR_CAPACITY;
    }
    esc11_read_parameters_response_pack(in, out);
    *length = 64u;
    return ESC11_OK;
}

/** Reads esc11_read_parameters_response from exactly 64 bytes. */
static inline esc11_codec_status esc11_read_parameters_response_decode(const uint8_t *in, size_t length,
        esc11_read_parameters_response *out)
{
    if (length != 64u) {
        return length < 64u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_read_parameters_response_unpack(in, out);
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_read_io_status_request: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_read_io_status_request_encode(uint8_t *out, size_t capacity, size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_read_io_status_request from exactly 0 bytes. */
static inline esc11_codec_status esc11_read_io_status_request_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

typedef struct esc11_read_io_status_response {
    /**
     * Printed as 数据1.
     * See io_inputs.
     * Source: 9.4.3 L939-940, 946
     */
    uint8_t inputs;
    /**
     * Printed as 数据2.
     * See io_outputs.
     * Source: 9.4.3 L939-940, 947
     */
    uint8_t outputs;
    /**
     * Printed as 数据3.
     * See io_state_outputs.
     * Source: 9.4.3 L939-940, 948
     */
    uint8_t state_outputs;
} esc11_read_io_status_response;

/** Writes esc11_read_io_status_response to 3 bytes without checks. */
static inline void esc11_read_io_status_response_pack(const esc11_read_io_status_response *in, uint8_t *out)
{
    esc11_store_u8(out + 0, in->inputs);
    esc11_store_u8(out + 1, in->outputs);
    esc11_store_u8(out + 2, in->state_outputs);
}

/** Reads esc11_read_io_status_response from 3 bytes without checks. */
static inline void esc11_read_io_status_response_unpack(const uint8_t *in, esc11_read_io_status_response *out)
{
    out->inputs = esc11_load_u8(in + 0);
    out->outputs = esc11_load_u8(in + 1);
    out->state_outputs = esc11_load_u8(in + 2);
}

/**
 * Writes esc11_read_io_status_response: 3 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_read_io_status_response_encode(const esc11_read_io_status_response *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    esc11_read_io_status_response_pack(in, out);
    *length = 3u;
    return ESC11_OK;
}

/** Reads esc11_read_io_status_response from exactly 3 bytes. */
static inline esc11_codec_status esc11_read_io_status_response_decode(const uint8_t *in, size_t length,
        esc11_read_io_status_response *out)
{
    if (length != 3u) {
        return length < 3u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_read_io_status_response_unpack(in, out);
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_read_alarm_history_request: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_read_alarm_history_request_encode(uint8_t *out, size_t capacity, size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_read_alarm_history_request from exactly 0 bytes. */
static inline esc11_codec_status esc11_read_alarm_history_request_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

typedef struct esc11_read_alarm_history_response {
    /** Source: 9.4.4 L953-956 */
    esc11_alarm_history_entry entries[16];
    size_t entries_count;
} esc11_read_alarm_history_response;

/**
 * Writes esc11_read_alarm_history_response: 0 to 64 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_read_alarm_history_response_encode(const esc11_read_alarm_history_response *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    size_t at;
    esc11_codec_status status;
    if (in->entries_count > 16u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    if (capacity < (0u + in->entries_count * 4u)) {
        return ESC11_ERR_CAPACITY;
    }
    for (at = 0; at < in->entries_count; at++) {
        status = esc11_alarm_history_entry_check(&in->entries[at]);
        if (status != ESC11_OK) {
            return status;
        }
        esc11_alarm_history_entry_pack(&in->entries[at], out + 0u + at * 4u);
    }
    *length = (0u + in->entries_count * 4u);
    return ESC11_OK;
}

/** Reads esc11_read_alarm_history_response from exactly 0 to 64 bytes. */
static inline esc11_codec_status esc11_read_alarm_history_response_decode(const uint8_t *in, size_t length,
        esc11_read_alarm_history_response *out)
{
    size_t at;
    if (length > 64u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    if ((length - 0u) % 4u != 0) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    out->entries_count = (length - 0u) / 4u;
    for (at = 0; at < out->entries_count; at++) {
        esc11_alarm_history_entry_unpack(in + 0u + at * 4u, &out->entries[at]);
    }
    return ESC11_OK;
}

typedef struct esc11_write_points_request {
    /**
     * Printed as 数据.
     * Source: 9.5.1 L973-977, 996
     */
    esc11_point points[15];
    size_t points_count;
} esc11_write_points_request;

/**
 * Writes esc11_write_points_request: 16 to 240 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_write_points_request_encode(const esc11_write_points_request *in, uint8_t *out,
        size_t capacity, size_t *length)
{
    size_t at;
    esc11_codec_status status;
    if (in->points_count < 1u || in->points_count > 15u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    if (capacity < (0u + in->points_count * 16u)) {
        return ESC11_ERR_CAPACITY;
    }
    for (at = 0; at < in->points_count; at++) {
        status = esc11_point_check(&in->points[at]);
        if (status != ESC11_OK) {
            return status;
        }
        esc11_point_pack(&in->points[at], out + 0u + at * 16u);
    }
    *length = (0u + in->points_count * 16u);
    return ESC11_OK;
}

/** Reads esc11_write_points_request from exactly 16 to 240 bytes. */
static inline esc11_codec_status esc11_write_points_request_decode(const uint8_t *in, size_t length,
        esc11_write_points_request *out)
{
    size_t at;
    esc11_codec_status status;
    if (length < 16u) {
        return ESC11_ERR_INCOMPLETE;
    }
    if (length > 240u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    if ((length - 0u) % 16u != 0) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    out->points_count = (length - 0u) / 16u;
    for (at = 0; at < out->points_count; at++) {
        status = esc11_point_decode(in + 0u + at * 16u, 16u, &out->points[at]);
        if (status != ESC11_OK) {
            return status;
        }
    }
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_write_points_response: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_write_points_response_encode(uint8_t *out, size_t capacity, size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_write_points_response from exactly 0 bytes. */
static inline esc11_codec_status esc11_write_points_response_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

typedef struct esc11_write_parameters_request {
    /**
     * Printed as 参数PRM.
     * Range: 0..65535.
     * Source: 10.1 L1241-1242
     */
    uint16_t parameters[32];
} esc11_write_parameters_request;

/** Writes esc11_write_parameters_request to 64 bytes without checks. */
static inline void esc11_write_parameters_request_pack(const esc11_write_parameters_request *in, uint8_t *out)
{
    size_t at;
    for (at = 0; at < 32u; at++) {
        esc11_store_u16_le(out + 0u + at * 2u, in->parameters[at]);
    }
}

/** Reads esc11_write_parameters_request from 64 bytes without checks. */
static inline void esc11_write_parameters_request_unpack(const uint8_t *in, esc11_write_parameters_request *out)
{
    size_t at;
    for (at = 0; at < 32u; at++) {
        out->parameters[at] = esc11_load_u16_le(in + 0u + at * 2u);
    }
}

/**
 * Writes esc11_write_parameters_request: 64 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_write_parameters_request_encode(const esc11_write_parameters_request *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    if (capacity < 64u) {
        return ESC11_ERR_CAPACITY;
    }
    esc11_write_parameters_request_pack(in, out);
    *length = 64u;
    return ESC11_OK;
}

/** Reads esc11_write_parameters_request from exactly 64 bytes. */
static inline esc11_codec_status esc11_write_parameters_request_decode(const uint8_t *in, size_t length,
        esc11_write_parameters_request *out)
{
    if (length != 64u) {
        return length < 64u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_write_parameters_request_unpack(in, out);
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_write_parameters_response: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_write_parameters_response_encode(uint8_t *out, size_t capacity, size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_write_parameters_response from exactly 0 bytes. */
static inline esc11_codec_status esc11_write_parameters_response_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

typedef struct esc11_write_parameter_request {
    /**
     * Printed as 参数编号.
     * Range: 0..31.
     * Note: In table 10.1 the row stands above the row with the command's code, as if it belonged to 61h.
     * Source: 10.1 L1243
     */
    uint8_t parameter_number;
    /**
     * What it means depends on the parameter.
     * Printed as 参数数据.
     * Range: 0..65535.
     * Source: 10.1 L1244
     */
    uint16_t value;
} esc11_write_parameter_request;

/** Whether the values of esc11_write_parameter_request may be written. */
static inline esc11_codec_status esc11_write_parameter_request_check(const esc11_write_parameter_request *in)
{
    if (!(in->parameter_number <= 31u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    return ESC11_OK;
}

/** Writes esc11_write_parameter_request to 3 bytes without checks. */
static inline void esc11_write_parameter_request_pack(const esc11_write_parameter_request *in, uint8_t *out)
{
    esc11_store_u8(out + 0, in->parameter_number);
    esc11_store_u16_le(out + 1, in->value);
}

/** Reads esc11_write_parameter_request from 3 bytes without checks. */
static inline void esc11_write_parameter_request_unpack(const uint8_t *in, esc11_write_parameter_request *out)
{
    out->parameter_number = esc11_load_u8(in + 0);
    out->value = esc11_load_u16_le(in + 1);
}

/**
 * Writes esc11_write_parameter_request: 3 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_write_parameter_request_encode(const esc11_write_parameter_request *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_write_parameter_request_check(in);
    if (status != ESC11_OK) {
        return status;
    }
    esc11_write_parameter_request_pack(in, out);
    *length = 3u;
    return ESC11_OK;
}

/** Reads esc11_write_parameter_request from exactly 3 bytes. */
static inline esc11_codec_status esc11_write_parameter_request_decode(const uint8_t *in, size_t length,
        esc11_write_parameter_request *out)
{
    if (length != 3u) {
        return length < 3u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_write_parameter_request_unpack(in, out);
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_write_parameter_response: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_write_parameter_response_encode(uint8_t *out, size_t capacity, size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_write_parameter_response from exactly 0 bytes. */
static inline esc11_codec_status esc11_write_parameter_response_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

typedef struct esc11_write_temporary_point_request {
    /**
     * Printed as 数据.
     * Source: 9.5.4 L1042
     */
    esc11_temporary_point point;
} esc11_write_temporary_point_request;

/** Whether the values of esc11_write_temporary_point_request may be written. */
static inline esc11_codec_status esc11_write_temporary_point_request_check(const esc11_write_temporary_point_request *in)
{
    esc11_codec_status status;
    status = esc11_temporary_point_check(&in->point);
    if (status != ESC11_OK) {
        return status;
    }
    return ESC11_OK;
}

/** Writes esc11_write_temporary_point_request to 16 bytes without checks. */
static inline void esc11_write_temporary_point_request_pack(const esc11_write_temporary_point_request *in, uint8_t *out)
{
    esc11_temporary_point_pack(&in->point, out + 0);
}

/** Reads esc11_write_temporary_point_request from 16 bytes without checks. */
static inline void esc11_write_temporary_point_request_unpack(const uint8_t *in,
        esc11_write_temporary_point_request *out)
{
    esc11_temporary_point_unpack(in + 0, &out->point);
}

/**
 * Writes esc11_write_temporary_point_request: 16 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_write_temporary_point_request_encode(const esc11_write_temporary_point_request *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    esc11_codec_status status;
    if (capacity < 16u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_write_temporary_point_request_check(in);
    if (status != ESC11_OK) {
        return status;
    }
    esc11_write_temporary_point_request_pack(in, out);
    *length = 16u;
    return ESC11_OK;
}

/** Reads esc11_write_temporary_point_request from exactly 16 bytes. */
static inline esc11_codec_status esc11_write_temporary_point_request_decode(const uint8_t *in, size_t length,
        esc11_write_temporary_point_request *out)
{
    esc11_codec_status status;
    if (length != 16u) {
        return length < 16u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_write_temporary_point_request_unpack(in, out);
    status = esc11_temporary_point_decode(in + 0, 16u, &out->point);
    if (status != ESC11_OK) {
        return status;
    }
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_write_temporary_point_response: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_write_temporary_point_response_encode(uint8_t *out, size_t capacity,
        size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_write_temporary_point_response from exactly 0 bytes. */
static inline esc11_codec_status esc11_write_temporary_point_response_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

typedef struct esc11_clear_points_request {
    /**
     * The first point to delete.
     * Printed as 删除始点编号.
     * Range: 1..31.
     * Source: 10.1 L1245
     */
    uint8_t first_point;
    /**
     * How many points to delete, the first one included.
     * Printed as 删除的点数.
     * Range: 1..31.
     * Source: 10.1 L1246
     */
    uint8_t point_count;
} esc11_clear_points_request;

/** Whether the values of esc11_clear_points_request may be written. */
static inline esc11_codec_status esc11_clear_points_request_check(const esc11_clear_points_request *in)
{
    if (!(in->first_point >= 1u && in->first_point <= 31u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    if (!(in->point_count >= 1u && in->point_count <= 31u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    return ESC11_OK;
}

/** Writes esc11_clear_points_request to 2 bytes without checks. */
static inline void esc11_clear_points_request_pack(const esc11_clear_points_request *in, uint8_t *out)
{
    esc11_store_u8(out + 0, in->first_point);
    esc11_store_u8(out + 1, in->point_count);
}

/** Reads esc11_clear_points_request from 2 bytes without checks. */
static inline void esc11_clear_points_request_unpack(const uint8_t *in, esc11_clear_points_request *out)
{
    out->first_point = esc11_load_u8(in + 0);
    out->point_count = esc11_load_u8(in + 1);
}

/**
 * Writes esc11_clear_points_request: 2 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_clear_points_request_encode(const esc11_clear_points_request *in, uint8_t *out,
        size_t capacity, size_t *length)
{
    esc11_codec_status status;
    if (capacity < 2u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_clear_points_request_check(in);
    if (status != ESC11_OK) {
        return status;
    }
    esc11_clear_points_request_pack(in, out);
    *length = 2u;
    return ESC11_OK;
}

/** Reads esc11_clear_points_request from exactly 2 bytes. */
static inline esc11_codec_status esc11_clear_points_request_decode(const uint8_t *in, size_t length,
        esc11_clear_points_request *out)
{
    if (length != 2u) {
        return length < 2u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_clear_points_request_unpack(in, out);
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_clear_points_response: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_clear_points_response_encode(uint8_t *out, size_t capacity, size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_clear_points_response from exactly 0 bytes. */
static inline esc11_codec_status esc11_clear_points_response_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_initialize_points_request: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_initialize_points_request_encode(uint8_t *out, size_t capacity, size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_initialize_points_request from exactly 0 bytes. */
static inline esc11_codec_status esc11_initialize_points_request_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_initialize_points_response: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_initialize_points_response_encode(uint8_t *out, size_t capacity, size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_initialize_points_response from exactly 0 bytes. */
static inline esc11_codec_status esc11_initialize_points_response_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

typedef struct esc11_initialize_parameters_request {
    /**
     * Printed as 执行器类型.
     * Range: 0..65535. See actuator_type.
     * Source: 9.6.3 L1112, 1120-1129
     */
    uint16_t actuator_type;
} esc11_initialize_parameters_request;

/** Writes esc11_initialize_parameters_request to 2 bytes without checks. */
static inline void esc11_initialize_parameters_request_pack(const esc11_initialize_parameters_request *in, uint8_t *out)
{
    esc11_store_u16_le(out + 0, in->actuator_type);
}

/** Reads esc11_initialize_parameters_request from 2 bytes without checks. */
static inline void esc11_initialize_parameters_request_unpack(const uint8_t *in,
        esc11_initialize_parameters_request *out)
{
    out->actuator_type = esc11_load_u16_le(in + 0);
}

/**
 * Writes esc11_initialize_parameters_request: 2 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_initialize_parameters_request_encode(const esc11_initialize_parameters_request *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    if (capacity < 2u) {
        return ESC11_ERR_CAPACITY;
    }
    esc11_initialize_parameters_request_pack(in, out);
    *length = 2u;
    return ESC11_OK;
}

/** Reads esc11_initialize_parameters_request from exactly 2 bytes. */
static inline esc11_codec_status esc11_initialize_parameters_request_decode(const uint8_t *in, size_t length,
        esc11_initialize_parameters_request *out)
{
    if (length != 2u) {
        return length < 2u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_initialize_parameters_request_unpack(in, out);
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_initialize_parameters_response: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_initialize_parameters_response_encode(uint8_t *out, size_t capacity,
        size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_initialize_parameters_response from exactly 0 bytes. */
static inline esc11_codec_status esc11_initialize_parameters_response_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_clear_alarm_history_request: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_clear_alarm_history_request_encode(uint8_t *out, size_t capacity, size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_clear_alarm_history_request from exactly 0 bytes. */
static inline esc11_codec_status esc11_clear_alarm_history_request_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_clear_alarm_history_response: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_clear_alarm_history_response_encode(uint8_t *out, size_t capacity,
        size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_clear_alarm_history_response from exactly 0 bytes. */
static inline esc11_codec_status esc11_clear_alarm_history_response_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_clear_accumulated_time_request: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_clear_accumulated_time_request_encode(uint8_t *out, size_t capacity,
        size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_clear_accumulated_time_request from exactly 0 bytes. */
static inline esc11_codec_status esc11_clear_accumulated_time_request_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_clear_accumulated_time_response: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_clear_accumulated_time_response_encode(uint8_t *out, size_t capacity,
        size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_clear_accumulated_time_response from exactly 0 bytes. */
static inline esc11_codec_status esc11_clear_accumulated_time_response_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_stop_request: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_stop_request_encode(uint8_t *out, size_t capacity, size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_stop_request from exactly 0 bytes. */
static inline esc11_codec_status esc11_stop_request_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_stop_response: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_stop_response_encode(uint8_t *out, size_t capacity, size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_stop_response from exactly 0 bytes. */
static inline esc11_codec_status esc11_stop_response_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_start_homing_request: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_start_homing_request_encode(uint8_t *out, size_t capacity, size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_start_homing_request from exactly 0 bytes. */
static inline esc11_codec_status esc11_start_homing_request_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_start_homing_response: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_start_homing_response_encode(uint8_t *out, size_t capacity, size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_start_homing_response from exactly 0 bytes. */
static inline esc11_codec_status esc11_start_homing_response_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

typedef struct esc11_move_positive_distance_request {
    /**
     * Counted from the current position. For the other direction there is command 13h.
     * Printed as 相对移动量.
     * One count is 0.01 mm. Range: 1..255.
     * Source: 10.1 L1156
     */
    uint8_t distance;
    /**
     * The lowest and the highest speed depend on the gripper's model.
     * Printed as 速度.
     * One count is 1 %. Range: 1..100.
     * Source: 10.1 L1157
     */
    uint8_t speed;
    /**
     * Gripping force, and also the thrust during the move.
     * Printed as 力.
     * One count is 1 %. Range: 0..100.
     * Source: 10.1 L1158
     */
    uint8_t force;
} esc11_move_positive_distance_request;

/** Whether the values of esc11_move_positive_distance_request may be written. */
static inline esc11_codec_status esc11_move_positive_distance_request_check(const esc11_move_positive_distance_request *in)
{
    if (!(in->distance >= 1u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    if (!(in->speed >= 1u && in->speed <= 100u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    if (!(in->force <= 100u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    return ESC11_OK;
}

/** Writes esc11_move_positive_distance_request to 3 bytes without checks. */
static inline void esc11_move_positive_distance_request_pack(const esc11_move_positive_distance_request *in,
        uint8_t *out)
{
    esc11_store_u8(out + 0, in->distance);
    esc11_store_u8(out + 1, in->speed);
    esc11_store_u8(out + 2, in->force);
}

/** Reads esc11_move_positive_distance_request from 3 bytes without checks. */
static inline void esc11_move_positive_distance_request_unpack(const uint8_t *in,
        esc11_move_positive_distance_request *out)
{
    out->distance = esc11_load_u8(in + 0);
    out->speed = esc11_load_u8(in + 1);
    out->force = esc11_load_u8(in + 2);
}

/**
 * Writes esc11_move_positive_distance_request: 3 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_move_positive_distance_request_encode(const esc11_move_positive_distance_request *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_move_positive_distance_request_check(in);
    if (status != ESC11_OK) {
        return status;
    }
    esc11_move_positive_distance_request_pack(in, out);
    *length = 3u;
    return ESC11_OK;
}

/** Reads esc11_move_positive_distance_request from exactly 3 bytes. */
static inline esc11_codec_status esc11_move_positive_distance_request_decode(const uint8_t *in, size_t length,
        esc11_move_positive_distance_request *out)
{
    if (length != 3u) {
        return length < 3u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_move_positive_distance_request_unpack(in, out);
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_move_positive_distance_response: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_move_positive_distance_response_encode(uint8_t *out, size_t capacity,
        size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_move_positive_distance_response from exactly 0 bytes. */
static inline esc11_codec_status esc11_move_positive_distance_response_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

typedef struct esc11_move_negative_distance_request {
    /**
     * Counted from the current position, and positive. For the other direction there is command 12h.
     * Printed as 相对移动量.
     * One count is 0.01 mm. Range: 1..255.
     * Source: 10.1 L1159
     */
    uint8_t distance;
    /**
     * The lowest and the highest speed depend on the gripper's model.
     * Printed as 速度.
     * One count is 1 %. Range: 1..100.
     * Source: 10.1 L1160
     */
    uint8_t speed;
    /**
     * Gripping force, and also the thrust during the move.
     * Printed as 力.
     * One count is 1 %. Range: 0..100.
     * Source: 10.1 L1161
     */
    uint8_t force;
} esc11_move_negative_distance_request;

/** Whether the values of esc11_move_negative_distance_request may be written. */
static inline esc11_codec_status esc11_move_negative_distance_request_check(const esc11_move_negative_distance_request *in)
{
    if (!(in->distance >= 1u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    if (!(in->speed >= 1u && in->speed <= 100u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    if (!(in->force <= 100u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    return ESC11_OK;
}

/** Writes esc11_move_negative_distance_request to 3 bytes without checks. */
static inline void esc11_move_negative_distance_request_pack(const esc11_move_negative_distance_request *in,
        uint8_t *out)
{
    esc11_store_u8(out + 0, in->distance);
    esc11_store_u8(out + 1, in->speed);
    esc11_store_u8(out + 2, in->force);
}

/** Reads esc11_move_negative_distance_request from 3 bytes without checks. */
static inline void esc11_move_negative_distance_request_unpack(const uint8_t *in,
        esc11_move_negative_distance_request *out)
{
    out->distance = esc11_load_u8(in + 0);
    out->speed = esc11_load_u8(in + 1);
    out->force = esc11_load_u8(in + 2);
}

/**
 * Writes esc11_move_negative_distance_request: 3 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_move_negative_distance_request_encode(const esc11_move_negative_distance_request *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_move_negative_distance_request_check(in);
    if (status != ESC11_OK) {
        return status;
    }
    esc11_move_negative_distance_request_pack(in, out);
    *length = 3u;
    return ESC11_OK;
}

/** Reads esc11_move_negative_distance_request from exactly 3 bytes. */
static inline esc11_codec_status esc11_move_negative_distance_request_decode(const uint8_t *in, size_t length,
        esc11_move_negative_distance_request *out)
{
    if (length != 3u) {
        return length < 3u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_move_negative_distance_request_unpack(in, out);
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_move_negative_distance_response: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_move_negative_distance_response_encode(uint8_t *out, size_t capacity,
        size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_move_negative_distance_response from exactly 0 bytes. */
static inline esc11_codec_status esc11_move_negative_distance_response_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

typedef struct esc11_move_open_request {
    /**
     * The lowest and the highest speed depend on the gripper's model.
     * Printed as 速度.
     * One count is 1 %. Range: 1..100.
     * Source: 10.1 L1162
     */
    uint8_t speed;
} esc11_move_open_request;

/** Whether the values of esc11_move_open_request may be written. */
static inline esc11_codec_status esc11_move_open_request_check(const esc11_move_open_request *in)
{
    if (!(in->speed >= 1u && in->speed <= 100u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    return ESC11_OK;
}

/** Writes esc11_move_open_request to 1 byte without checks. */
static inline void esc11_move_open_request_pack(const esc11_move_open_request *in, uint8_t *out)
{
    esc11_store_u8(out + 0, in->speed);
}

/** Reads esc11_move_open_request from 1 byte without checks. */
static inline void esc11_move_open_request_unpack(const uint8_t *in, esc11_move_open_request *out)
{
    out->speed = esc11_load_u8(in + 0);
}

/**
 * Writes esc11_move_open_request: 1 byte.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_move_open_request_encode(const esc11_move_open_request *in, uint8_t *out,
        size_t capacity, size_t *length)
{
    esc11_codec_status status;
    if (capacity < 1u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_move_open_request_check(in);
    if (status != ESC11_OK) {
        return status;
    }
    esc11_move_open_request_pack(in, out);
    *length = 1u;
    return ESC11_OK;
}

/** Reads esc11_move_open_request from exactly 1 byte. */
static inline esc11_codec_status esc11_move_open_request_decode(const uint8_t *in, size_t length,
        esc11_move_open_request *out)
{
    if (length != 1u) {
        return length < 1u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_move_open_request_unpack(in, out);
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_move_open_response: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_move_open_response_encode(uint8_t *out, size_t capacity, size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_move_open_response from exactly 0 bytes. */
static inline esc11_codec_status esc11_move_open_response_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

typedef struct esc11_move_close_request {
    /**
     * The lowest and the highest speed depend on the gripper's model.
     * Printed as 速度.
     * One count is 1 %. Range: 1..100.
     * Source: 10.1 L1163
     */
    uint8_t speed;
} esc11_move_close_request;

/** Whether the values of esc11_move_close_request may be written. */
static inline esc11_codec_status esc11_move_close_request_check(const esc11_move_close_request *in)
{
    if (!(in->speed >= 1u && in->speed <= 100u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    return ESC11_OK;
}

/** Writes esc11_move_close_request to 1 byte without checks. */
static inline void esc11_move_close_request_pack(const esc11_move_close_request *in, uint8_t *out)
{
    esc11_store_u8(out + 0, in->speed);
}

/** Reads esc11_move_close_request from 1 byte without checks. */
static inline void esc11_move_close_request_unpack(const uint8_t *in, esc11_move_close_request *out)
{
    out->speed = esc11_load_u8(in + 0);
}

/**
 * Writes esc11_move_close_request: 1 byte.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_move_close_request_encode(const esc11_move_close_request *in, uint8_t *out,
        size_t capacity, size_t *length)
{
    esc11_codec_status status;
    if (capacity < 1u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_move_close_request_check(in);
    if (status != ESC11_OK) {
        return status;
    }
    esc11_move_close_request_pack(in, out);
    *length = 1u;
    return ESC11_OK;
}

/** Reads esc11_move_close_request from exactly 1 byte. */
static inline esc11_codec_status esc11_move_close_request_decode(const uint8_t *in, size_t length,
        esc11_move_close_request *out)
{
    if (length != 1u) {
        return length < 1u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_move_close_request_unpack(in, out);
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_move_close_response: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_move_close_response_encode(uint8_t *out, size_t capacity, size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_move_close_response from exactly 0 bytes. */
static inline esc11_codec_status esc11_move_close_response_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

typedef struct esc11_move_relative_request {
    /**
     * Counted from the current position. The low byte comes first.
     * Printed as 带符号相对移动量.
     * One count is 0.01 mm. Range: -134217727..134217727.
     * Source: 10.1 L1164
     */
    int32_t distance;
    /**
     * The lowest and the highest speed depend on the gripper's model.
     * Printed as 速度.
     * One count is 1 %. Range: 0..100.
     * Source: 10.1 L1165
     */
    uint8_t speed;
} esc11_move_relative_request;

/** Whether the values of esc11_move_relative_request may be written. */
static inline esc11_codec_status esc11_move_relative_request_check(const esc11_move_relative_request *in)
{
    if (!(in->distance >= (-134217727) && in->distance <= 134217727)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    if (!(in->speed <= 100u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    return ESC11_OK;
}

/** Writes esc11_move_relative_request to 5 bytes without checks. */
static inline void esc11_move_relative_request_pack(const esc11_move_relative_request *in, uint8_t *out)
{
    esc11_store_u32_le(out + 0, (uint32_t)in->distance);
    esc11_store_u8(out + 4, in->speed);
}

/** Reads esc11_move_relative_request from 5 bytes without checks. */
static inline void esc11_move_relative_request_unpack(const uint8_t *in, esc11_move_relative_request *out)
{
    out->distance = esc11_signed_32(esc11_load_u32_le(in + 0));
    out->speed = esc11_load_u8(in + 4);
}

/**
 * Writes esc11_move_relative_request: 5 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_move_relative_request_encode(const esc11_move_relative_request *in, uint8_t *out,
        size_t capacity, size_t *length)
{
    esc11_codec_status status;
    if (capacity < 5u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_move_relative_request_check(in);
    if (status != ESC11_OK) {
        return status;
    }
    esc11_move_relative_request_pack(in, out);
    *length = 5u;
    return ESC11_OK;
}

/** Reads esc11_move_relative_request from exactly 5 bytes. */
static inline esc11_codec_status esc11_move_relative_request_decode(const uint8_t *in, size_t length,
        esc11_move_relative_request *out)
{
    if (length != 5u) {
        return length < 5u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_move_relative_request_unpack(in, out);
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_move_relative_response: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_move_relative_response_encode(uint8_t *out, size_t capacity, size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_move_relative_response from exactly 0 bytes. */
static inline esc11_codec_status esc11_move_relative_response_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

typedef struct esc11_move_absolute_request {
    /**
     * Counted from the home position. The low byte comes first.
     * Printed as 带符号绝对移动量.
     * One count is 0.01 mm. Range: -134217727..134217727.
     * Source: 10.1 L1166
     */
    int32_t position;
    /**
     * The lowest and the highest speed depend on the gripper's model.
     * Printed as 速度.
     * One count is 1 %. Range: 0..100.
     * Source: 10.1 L1167
     */
    uint8_t speed;
} esc11_move_absolute_request;

/** Whether the values of esc11_move_absolute_request may be written. */
static inline esc11_codec_status esc11_move_absolute_request_check(const esc11_move_absolute_request *in)
{
    if (!(in->position >= (-134217727) && in->position <= 134217727)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    if (!(in->speed <= 100u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    return ESC11_OK;
}

/** Writes esc11_move_absolute_request to 5 bytes without checks. */
static inline void esc11_move_absolute_request_pack(const esc11_move_absolute_request *in, uint8_t *out)
{
    esc11_store_u32_le(out + 0, (uint32_t)in->position);
    esc11_store_u8(out + 4, in->speed);
}

/** Reads esc11_move_absolute_request from 5 bytes without checks. */
static inline void esc11_move_absolute_request_unpack(const uint8_t *in, esc11_move_absolute_request *out)
{
    out->position = esc11_signed_32(esc11_load_u32_le(in + 0));
    out->speed = esc11_load_u8(in + 4);
}

/**
 * Writes esc11_move_absolute_request: 5 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_move_absolute_request_encode(const esc11_move_absolute_request *in, uint8_t *out,
        size_t capacity, size_t *length)
{
    esc11_codec_status status;
    if (capacity < 5u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_move_absolute_request_check(in);
    if (status != ESC11_OK) {
        return status;
    }
    esc11_move_absolute_request_pack(in, out);
    *length = 5u;
    return ESC11_OK;
}

/** Reads esc11_move_absolute_request from exactly 5 bytes. */
static inline esc11_codec_status esc11_move_absolute_request_decode(const uint8_t *in, size_t length,
        esc11_move_absolute_request *out)
{
    if (length != 5u) {
        return length < 5u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_move_absolute_request_unpack(in, out);
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_move_absolute_response: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_move_absolute_response_encode(uint8_t *out, size_t capacity, size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_move_absolute_response from exactly 0 bytes. */
static inline esc11_codec_status esc11_move_absolute_response_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

typedef struct esc11_move_to_point_request {
    /**
     * The point to carry out.
     * Printed as 点编号.
     * Range: 1..31.
     * Source: 10.1 L1168
     */
    uint8_t point_number;
    /**
     * The speed of the move is the point's own speed times this one. The lowest and the highest speed depend on
     * the gripper's model.
     * Printed as 速度.
     * One count is 1 %. Range: 0..100.
     * Source: 10.1 L1169
     */
    uint8_t speed;
} esc11_move_to_point_request;

/** Whether the values of esc11_move_to_point_request may be written. */
static inline esc11_codec_status esc11_move_to_point_request_check(const esc11_move_to_point_request *in)
{
    if (!(in->point_number >= 1u && in->point_number <= 31u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    if (!(in->speed <= 100u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    return ESC11_OK;
}

/** Writes esc11_move_to_point_request to 2 bytes without checks. */
static inline void esc11_move_to_point_request_pack(const esc11_move_to_point_request *in, uint8_t *out)
{
    esc11_store_u8(out + 0, in->point_number);
    esc11_store_u8(out + 1, in->speed);
}

/** Reads esc11_move_to_point_request from 2 bytes without checks. */
static inline void esc11_move_to_point_request_unpack(const uint8_t *in, esc11_move_to_point_request *out)
{
    out->point_number = esc11_load_u8(in + 0);
    out->speed = esc11_load_u8(in + 1);
}

/**
 * Writes esc11_move_to_point_request: 2 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_move_to_point_request_encode(const esc11_move_to_point_request *in, uint8_t *out,
        size_t capacity, size_t *length)
{
    esc11_codec_status status;
    if (capacity < 2u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_move_to_point_request_check(in);
    if (status != ESC11_OK) {
        return status;
    }
    esc11_move_to_point_request_pack(in, out);
    *length = 2u;
    return ESC11_OK;
}

/** Reads esc11_move_to_point_request from exactly 2 bytes. */
static inline esc11_codec_status esc11_move_to_point_request_decode(const uint8_t *in, size_t length,
        esc11_move_to_point_request *out)
{
    if (length != 2u) {
        return length < 2u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_move_to_point_request_unpack(in, out);
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_move_to_point_response: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_move_to_point_response_encode(uint8_t *out, size_t capacity, size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_move_to_point_response from exactly 0 bytes. */
static inline esc11_codec_status esc11_move_to_point_response_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

typedef struct esc11_grip_open_request {
    /**
     * The lowest and the highest speed depend on the gripper's model.
     * Printed as 速度.
     * One count is 1 %. Range: 0..100.
     * Source: 10.1 L1170
     */
    uint8_t speed;
    /**
     * Gripping force.
     * Printed as 力.
     * One count is 1 %. Range: 0..100.
     * Source: 10.1 L1171
     */
    uint8_t force;
} esc11_grip_open_request;

/** Whether the values of esc11_grip_open_request may be written. */
static inline esc11_codec_status esc11_grip_open_request_check(const esc11_grip_open_request *in)
{
    if (!(in->speed <= 100u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    if (!(in->force <= 100u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    return ESC11_OK;
}

/** Writes esc11_grip_open_request to 2 bytes without checks. */
static inline void esc11_grip_open_request_pack(const esc11_grip_open_request *in, uint8_t *out)
{
    esc11_store_u8(out + 0, in->speed);
    esc11_store_u8(out + 1, in->force);
}

/** Reads esc11_grip_open_request from 2 bytes without checks. */
static inline void esc11_grip_open_request_unpack(const uint8_t *in, esc11_grip_open_request *out)
{
    out->speed = esc11_load_u8(in + 0);
    out->force = esc11_load_u8(in + 1);
}

/**
 * Writes esc11_grip_open_request: 2 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_grip_open_request_encode(const esc11_grip_open_request *in, uint8_t *out,
        size_t capacity, size_t *length)
{
    esc11_codec_status status;
    if (capacity < 2u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_grip_open_request_check(in);
    if (status != ESC11_OK) {
        return status;
    }
    esc11_grip_open_request_pack(in, out);
    *length = 2u;
    return ESC11_OK;
}

/** Reads esc11_grip_open_request from exactly 2 bytes. */
static inline esc11_codec_status esc11_grip_open_request_decode(const uint8_t *in, size_t length,
        esc11_grip_open_request *out)
{
    if (length != 2u) {
        return length < 2u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_grip_open_request_unpack(in, out);
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_grip_open_response: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_grip_open_response_encode(uint8_t *out, size_t capacity, size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_grip_open_response from exactly 0 bytes. */
static inline esc11_codec_status esc11_grip_open_response_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

typedef struct esc11_grip_close_request {
    /**
     * The lowest and the highest speed depend on the gripper's model.
     * Printed as 速度.
     * One count is 1 %. Range: 0..100.
     * Source: 10.1 L1172
     */
    uint8_t speed;
    /**
     * Gripping force.
     * Printed as 力.
     * One count is 1 %. Range: 0..100.
     * Source: 10.1 L1173
     */
    uint8_t force;
} esc11_grip_close_request;

/** Whether the values of esc11_grip_close_request may be written. */
static inline esc11_codec_status esc11_grip_close_request_check(const esc11_grip_close_request *in)
{
    if (!(in->speed <= 100u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    if (!(in->force <= 100u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    return ESC11_OK;
}

/** Writes esc11_grip_close_request to 2 bytes without checks. */
static inline void esc11_grip_close_request_pack(const esc11_grip_close_request *in, uint8_t *out)
{
    esc11_store_u8(out + 0, in->speed);
    esc11_store_u8(out + 1, in->force);
}

/** Reads esc11_grip_close_request from 2 bytes without checks. */
static inline void esc11_grip_close_request_unpack(const uint8_t *in, esc11_grip_close_request *out)
{
    out->speed = esc11_load_u8(in + 0);
    out->force = esc11_load_u8(in + 1);
}

/**
 * Writes esc11_grip_close_request: 2 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_grip_close_request_encode(const esc11_grip_close_request *in, uint8_t *out,
        size_t capacity, size_t *length)
{
    esc11_codec_status status;
    if (capacity < 2u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_grip_close_request_check(in);
    if (status != ESC11_OK) {
        return status;
    }
    esc11_grip_close_request_pack(in, out);
    *length = 2u;
    return ESC11_OK;
}

/** Reads esc11_grip_close_request from exactly 2 bytes. */
static inline esc11_codec_status esc11_grip_close_request_decode(const uint8_t *in, size_t length,
        esc11_grip_close_request *out)
{
    if (length != 2u) {
        return length < 2u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_grip_close_request_unpack(in, out);
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_grip_close_response: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_grip_close_response_encode(uint8_t *out, size_t capacity, size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_grip_close_response from exactly 0 bytes. */
static inline esc11_codec_status esc11_grip_close_response_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

typedef struct esc11_grip_relative_request {
    /**
     * Counted from the current position. The low byte comes first.
     * Printed as 带符号相对移动量.
     * One count is 0.01 mm. Range: -134217727..134217727.
     * Source: 10.1 L1174
     */
    int32_t distance;
    /**
     * The lowest and the highest speed depend on the gripper's model.
     * Printed as 速度.
     * One count is 1 %. Range: 0..100.
     * Source: 10.1 L1175
     */
    uint8_t speed;
    /**
     * Gripping force.
     * Printed as 力.
     * One count is 1 %. Range: 0..100.
     * Source: 10.1 L1176
     */
    uint8_t force;
} esc11_grip_relative_request;

/** Whether the values of esc11_grip_relative_request may be written. */
static inline esc11_codec_status esc11_grip_relative_request_check(const esc11_grip_relative_request *in)
{
    if (!(in->distance >= (-134217727) && in->distance <= 134217727)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    if (!(in->speed <= 100u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    if (!(in->force <= 100u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    return ESC11_OK;
}

/** Writes esc11_grip_relative_request to 6 bytes without checks. */
static inline void esc11_grip_relative_request_pack(const esc11_grip_relative_request *in, uint8_t *out)
{
    esc11_store_u32_le(out + 0, (uint32_t)in->distance);
    esc11_store_u8(out + 4, in->speed);
    esc11_store_u8(out + 5, in->force);
}

/** Reads esc11_grip_relative_request from 6 bytes without checks. */
static inline void esc11_grip_relative_request_unpack(const uint8_t *in, esc11_grip_relative_request *out)
{
    out->distance = esc11_signed_32(esc11_load_u32_le(in + 0));
    out->speed = esc11_load_u8(in + 4);
    out->force = esc11_load_u8(in + 5);
}

/**
 * Writes esc11_grip_relative_request: 6 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_grip_relative_request_encode(const esc11_grip_relative_request *in, uint8_t *out,
        size_t capacity, size_t *length)
{
    esc11_codec_status status;
    if (capacity < 6u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_grip_relative_request_check(in);
    if (status != ESC11_OK) {
        return status;
    }
    esc11_grip_relative_request_pack(in, out);
    *length = 6u;
    return ESC11_OK;
}

/** Reads esc11_grip_relative_request from exactly 6 bytes. */
static inline esc11_codec_status esc11_grip_relative_request_decode(const uint8_t *in, size_t length,
        esc11_grip_relative_request *out)
{
    if (length != 6u) {
        return length < 6u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_grip_relative_request_unpack(in, out);
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_grip_relative_response: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_grip_relative_response_encode(uint8_t *out, size_t capacity, size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_grip_relative_response from exactly 0 bytes. */
static inline esc11_codec_status esc11_grip_relative_response_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

typedef struct esc11_grip_absolute_request {
    /**
     * Counted from the home position. The low byte comes first.
     * Printed as 带符号绝对移动量.
     * One count is 0.01 mm. Range: -134217727..134217727.
     * Source: 10.1 L1177
     */
    int32_t position;
    /**
     * The lowest and the highest speed depend on the gripper's model.
     * Printed as 速度.
     * One count is 1 %. Range: 0..100.
     * Source: 10.1 L1178
     */
    uint8_t speed;
    /**
     * Gripping force.
     * Printed as 力.
     * One count is 1 %. Range: 0..100.
     * Source: 10.1 L1179
     */
    uint8_t force;
} esc11_grip_absolute_request;

/** Whether the values of esc11_grip_absolute_request may be written. */
static inline esc11_codec_status esc11_grip_absolute_request_check(const esc11_grip_absolute_request *in)
{
    if (!(in->position >= (-134217727) && in->position <= 134217727)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    if (!(in->speed <= 100u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    if (!(in->force <= 100u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    return ESC11_OK;
}

/** Writes esc11_grip_absolute_request to 6 bytes without checks. */
static inline void esc11_grip_absolute_request_pack(const esc11_grip_absolute_request *in, uint8_t *out)
{
    esc11_store_u32_le(out + 0, (uint32_t)in->position);
    esc11_store_u8(out + 4, in->speed);
    esc11_store_u8(out + 5, in->force);
}

/** Reads esc11_grip_absolute_request from 6 bytes without checks. */
static inline void esc11_grip_absolute_request_unpack(const uint8_t *in, esc11_grip_absolute_request *out)
{
    out->position = esc11_signed_32(esc11_load_u32_le(in + 0));
    out->speed = esc11_load_u8(in + 4);
    out->force = esc11_load_u8(in + 5);
}

/**
 * Writes esc11_grip_absolute_request: 6 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_grip_absolute_request_encode(const esc11_grip_absolute_request *in, uint8_t *out,
        size_t capacity, size_t *length)
{
    esc11_codec_status status;
    if (capacity < 6u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_grip_absolute_request_check(in);
    if (status != ESC11_OK) {
        return status;
    }
    esc11_grip_absolute_request_pack(in, out);
    *length = 6u;
    return ESC11_OK;
}

/** Reads esc11_grip_absolute_request from exactly 6 bytes. */
static inline esc11_codec_status esc11_grip_absolute_request_decode(const uint8_t *in, size_t length,
        esc11_grip_absolute_request *out)
{
    if (length != 6u) {
        return length < 6u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_grip_absolute_request_unpack(in, out);
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_grip_absolute_response: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_grip_absolute_response_encode(uint8_t *out, size_t capacity, size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_grip_absolute_response from exactly 0 bytes. */
static inline esc11_codec_status esc11_grip_absolute_response_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

typedef struct esc11_grip_open_with_zone_request {
    /**
     * One limit of the zone, an absolute position.
     * Printed as ZON信号ON的位置.
     * One count is 0.01 mm. Range: -134217727..134217727.
     * Source: 10.1 L1180
     */
    int32_t zone_limit_1;
    /**
     * The other limit of the zone, an absolute position.
     * Printed as ZON信号OFF的位置.
     * One count is 0.01 mm. Range: -134217727..134217727.
     * Source: 10.1 L1181
     */
    int32_t zone_limit_2;
    /**
     * The lowest and the highest speed depend on the gripper's model.
     * Printed as 速度.
     * One count is 1 %. Range: 0..100.
     * Source: 10.1 L1182
     */
    uint8_t speed;
    /**
     * Gripping force.
     * Printed as 力.
     * One count is 1 %. Range: 0..100.
     * Source: 10.1 L1183
     */
    uint8_t force;
} esc11_grip_open_with_zone_request;

/** Whether the values of esc11_grip_open_with_zone_request may be written. */
static inline esc11_codec_status esc11_grip_open_with_zone_request_check(const esc11_grip_open_with_zone_request *in)
{
    if (!(in->zone_limit_1 >= (-134217727) && in->zone_limit_1 <= 134217727)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    if (!(in->zone_limit_2 >= (-134217727) && in->zone_limit_2 <= 134217727)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    if (!(in->speed <= 100u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    if (!(in->force <= 100u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    return ESC11_OK;
}

/** Writes esc11_grip_open_with_zone_request to 10 bytes without checks. */
static inline void esc11_grip_open_with_zone_request_pack(const esc11_grip_open_with_zone_request *in, uint8_t *out)
{
    esc11_store_u32_le(out + 0, (uint32_t)in->zone_limit_1);
    esc11_store_u32_le(out + 4, (uint32_t)in->zone_limit_2);
    esc11_store_u8(out + 8, in->speed);
    esc11_store_u8(out + 9, in->force);
}

/** Reads esc11_grip_open_with_zone_request from 10 bytes without checks. */
static inline void esc11_grip_open_with_zone_request_unpack(const uint8_t *in, esc11_grip_open_with_zone_request *out)
{
    out->zone_limit_1 = esc11_signed_32(esc11_load_u32_le(in + 0));
    out->zone_limit_2 = esc11_signed_32(esc11_load_u32_le(in + 4));
    out->speed = esc11_load_u8(in + 8);
    out->force = esc11_load_u8(in + 9);
}

/**
 * Writes esc11_grip_open_with_zone_request: 10 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_grip_open_with_zone_request_encode(const esc11_grip_open_with_zone_request *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    esc11_codec_status status;
    if (capacity < 10u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_grip_open_with_zone_request_check(in);
    if (status != ESC11_OK) {
        return status;
    }
    esc11_grip_open_with_zone_request_pack(in, out);
    *length = 10u;
    return ESC11_OK;
}

/** Reads esc11_grip_open_with_zone_request from exactly 10 bytes. */
static inline esc11_codec_status esc11_grip_open_with_zone_request_decode(const uint8_t *in, size_t length,
        esc11_grip_open_with_zone_request *out)
{
    if (length != 10u) {
        return length < 10u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_grip_open_with_zone_request_unpack(in, out);
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_grip_open_with_zone_response: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_grip_open_with_zone_response_encode(uint8_t *out, size_t capacity,
        size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_grip_open_with_zone_response from exactly 0 bytes. */
static inline esc11_codec_status esc11_grip_open_with_zone_response_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

typedef struct esc11_grip_close_with_zone_request {
    /**
     * One limit of the zone, an absolute position.
     * Printed as ZON信号ON的位置.
     * One count is 0.01 mm. Range: -134217727..134217727.
     * Source: 10.1 L1184
     */
    int32_t zone_limit_1;
    /**
     * The other limit of the zone, an absolute position.
     * Printed as ZON信号OFF的位置.
     * One count is 0.01 mm. Range: -134217727..134217727.
     * Source: 10.1 L1185
     */
    int32_t zone_limit_2;
    /**
     * The lowest and the highest speed depend on the gripper's model.
     * Printed as 速度.
     * One count is 1 %. Range: 0..100.
     * Source: 10.1 L1186
     */
    uint8_t speed;
    /**
     * Gripping force.
     * Printed as 力.
     * One count is 1 %. Range: 0..100.
     * Source: 10.1 L1187
     */
    uint8_t force;
} esc11_grip_close_with_zone_request;

/** Whether the values of esc11_grip_close_with_zone_request may be written. */
static inline esc11_codec_status esc11_grip_close_with_zone_request_check(const esc11_grip_close_with_zone_request *in)
{
    if (!(in->zone_limit_1 >= (-134217727) && in->zone_limit_1 <= 134217727)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    if (!(in->zone_limit_2 >= (-134217727) && in->zone_limit_2 <= 134217727)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    if (!(in->speed <= 100u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    if (!(in->force <= 100u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    return ESC11_OK;
}

/** Writes esc11_grip_close_with_zone_request to 10 bytes without checks. */
static inline void esc11_grip_close_with_zone_request_pack(const esc11_grip_close_with_zone_request *in, uint8_t *out)
{
    esc11_store_u32_le(out + 0, (uint32_t)in->zone_limit_1);
    esc11_store_u32_le(out + 4, (uint32_t)in->zone_limit_2);
    esc11_store_u8(out + 8, in->speed);
    esc11_store_u8(out + 9, in->force);
}

/** Reads esc11_grip_close_with_zone_request from 10 bytes without checks. */
static inline void esc11_grip_close_with_zone_request_unpack(const uint8_t *in, esc11_grip_close_with_zone_request *out)
{
    out->zone_limit_1 = esc11_signed_32(esc11_load_u32_le(in + 0));
    out->zone_limit_2 = esc11_signed_32(esc11_load_u32_le(in + 4));
    out->speed = esc11_load_u8(in + 8);
    out->force = esc11_load_u8(in + 9);
}

/**
 * Writes esc11_grip_close_with_zone_request: 10 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_grip_close_with_zone_request_encode(const esc11_grip_close_with_zone_request *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    esc11_codec_status status;
    if (capacity < 10u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_grip_close_with_zone_request_check(in);
    if (status != ESC11_OK) {
        return status;
    }
    esc11_grip_close_with_zone_request_pack(in, out);
    *length = 10u;
    return ESC11_OK;
}

/** Reads esc11_grip_close_with_zone_request from exactly 10 bytes. */
static inline esc11_codec_status esc11_grip_close_with_zone_request_decode(const uint8_t *in, size_t length,
        esc11_grip_close_with_zone_request *out)
{
    if (length != 10u) {
        return length < 10u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_grip_close_with_zone_request_unpack(in, out);
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_grip_close_with_zone_response: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_grip_close_with_zone_response_encode(uint8_t *out, size_t capacity,
        size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_grip_close_with_zone_response from exactly 0 bytes. */
static inline esc11_codec_status esc11_grip_close_with_zone_response_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_no_operation_request: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_no_operation_request_encode(uint8_t *out, size_t capacity, size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_no_operation_request from exactly 0 bytes. */
static inline esc11_codec_status esc11_no_operation_request_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_no_operation_response: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_no_operation_response_encode(uint8_t *out, size_t capacity, size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_no_operation_response from exactly 0 bytes. */
static inline esc11_codec_status esc11_no_operation_response_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

typedef struct esc11_set_motor_excitation_request {
    /**
     * 1 excites the motor, for moves and grips. 0 releases it; the fingers of an SS gripper can then be moved by
     * hand.
     * Printed as 励磁状态.
     * Source: 9.2.2 L726, 732-734
     */
    bool excited;
} esc11_set_motor_excitation_request;

/** Writes esc11_set_motor_excitation_request to 1 byte without checks. */
static inline void esc11_set_motor_excitation_request_pack(const esc11_set_motor_excitation_request *in, uint8_t *out)
{
    esc11_store_u8(out + 0, (uint8_t)(in->excited ? 1 : 0));
}

/** Reads esc11_set_motor_excitation_request from 1 byte without checks. */
static inline void esc11_set_motor_excitation_request_unpack(const uint8_t *in, esc11_set_motor_excitation_request *out)
{
    out->excited = esc11_load_u8(in + 0) != 0;
}

/**
 * Writes esc11_set_motor_excitation_request: 1 byte.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_set_motor_excitation_request_encode(const esc11_set_motor_excitation_request *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    if (capacity < 1u) {
        return ESC11_ERR_CAPACITY;
    }
    esc11_set_motor_excitation_request_pack(in, out);
    *length = 1u;
    return ESC11_OK;
}

/** Reads esc11_set_motor_excitation_request from exactly 1 byte. */
static inline esc11_codec_status esc11_set_motor_excitation_request_decode(const uint8_t *in, size_t length,
        esc11_set_motor_excitation_request *out)
{
    if (length != 1u) {
        return length < 1u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_set_motor_excitation_request_unpack(in, out);
    if (esc11_load_u8(in + 0) > 1u) {
        return ESC11_ERR_UNKNOWN_VALUE;
    }
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_set_motor_excitation_response: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_set_motor_excitation_response_encode(uint8_t *out, size_t capacity,
        size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_set_motor_excitation_response from exactly 0 bytes. */
static inline esc11_codec_status esc11_set_motor_excitation_response_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_read_version_request: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_read_version_request_encode(uint8_t *out, size_t capacity, size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_read_version_request from exactly 0 bytes. */
static inline esc11_codec_status esc11_read_version_request_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

typedef struct esc11_read_version_response {
    /**
     * ASCII. Both samples begin and end with a blank and have a point between the digits.
     * Printed as 版本号.
     * Source: 9.3.1 L743, 748
     */
    char version[7];
} esc11_read_version_response;

/** Whether the values of esc11_read_version_response may be written. */
static inline esc11_codec_status esc11_read_version_response_check(const esc11_read_version_response *in)
{
    if (!esc11_is_text(in->version, 6u)) {
        return ESC11_ERR_UNKNOWN_VALUE;
    }
    return ESC11_OK;
}

/** Writes esc11_read_version_response to 6 bytes without checks. */
static inline void esc11_read_version_response_pack(const esc11_read_version_response *in, uint8_t *out)
{
    esc11_put_text(out + 0, in->version, 6u);
}

/** Reads esc11_read_version_response from 6 bytes without checks. */
static inline void esc11_read_version_response_unpack(const uint8_t *in, esc11_read_version_response *out)
{
    ESC11_COPY(out->version, in + 0, 6u);
    out->version[6] = '\0';
}

/**
 * Writes esc11_read_version_response: 6 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_read_version_response_encode(const esc11_read_version_response *in, uint8_t *out,
        size_t capacity, size_t *length)
{
    esc11_codec_status status;
    if (capacity < 6u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_read_version_response_check(in);
    if (status != ESC11_OK) {
        return status;
    }
    esc11_read_version_response_pack(in, out);
    *length = 6u;
    return ESC11_OK;
}

/** Reads esc11_read_version_response from exactly 6 bytes. */
static inline esc11_codec_status esc11_read_version_response_decode(const uint8_t *in, size_t length,
        esc11_read_version_response *out)
{
    if (length != 6u) {
        return length < 6u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_read_version_response_unpack(in, out);
    if (!esc11_is_ascii(in + 0, 6u)) {
        return ESC11_ERR_UNKNOWN_VALUE;
    }
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_read_current_position_request: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_read_current_position_request_encode(uint8_t *out, size_t capacity,
        size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_read_current_position_request from exactly 0 bytes. */
static inline esc11_codec_status esc11_read_current_position_request_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

typedef struct esc11_read_current_position_response {
    /**
     * The absolute position at which it stands now.
     * Printed as 带符号当前位置.
     * One count is 0.01 mm. Range: -134217727..134217727.
     * Source: 10.1 L1193
     */
    int32_t position;
} esc11_read_current_position_response;

/** Whether the values of esc11_read_current_position_response may be written. */
static inline esc11_codec_status esc11_read_current_position_response_check(const esc11_read_current_position_response *in)
{
    if (!(in->position >= (-134217727) && in->position <= 134217727)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    return ESC11_OK;
}

/** Writes esc11_read_current_position_response to 4 bytes without checks. */
static inline void esc11_read_current_position_response_pack(const esc11_read_current_position_response *in,
        uint8_t *out)
{
    esc11_store_u32_le(out + 0, (uint32_t)in->position);
}

/** Reads esc11_read_current_position_response from 4 bytes without checks. */
static inline void esc11_read_current_position_response_unpack(const uint8_t *in,
        esc11_read_current_position_response *out)
{
    out->position = esc11_signed_32(esc11_load_u32_le(in + 0));
}

/**
 * Writes esc11_read_current_position_response: 4 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_read_current_position_response_encode(const esc11_read_current_position_response *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    esc11_codec_status status;
    if (capacity < 4u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_read_current_position_response_check(in);
    if (status != ESC11_OK) {
        return status;
    }
    esc11_read_current_position_response_pack(in, out);
    *length = 4u;
    return ESC11_OK;
}

/** Reads esc11_read_current_position_response from exactly 4 bytes. */
static inline esc11_codec_status esc11_read_current_position_response_decode(const uint8_t *in, size_t length,
        esc11_read_current_position_response *out)
{
    if (length != 4u) {
        return length < 4u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_read_current_position_response_unpack(in, out);
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_read_current_point_number_request: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_read_current_point_number_request_encode(uint8_t *out, size_t capacity,
        size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_read_current_point_number_request from exactly 0 bytes. */
static inline esc11_codec_status esc11_read_current_point_number_request_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

typedef struct esc11_read_current_point_number_response {
    /**
     * Printed as 点编号.
     * Range: 1..31.
     * Note: What is answered before any point has been carried out is not printed.
     * Source: 10.1 L1195
     */
    uint8_t point_number;
} esc11_read_current_point_number_response;

/** Whether the values of esc11_read_current_point_number_response may be written. */
static inline esc11_codec_status esc11_read_current_point_number_response_check(const esc11_read_current_point_number_response *in)
{
    if (!(in->point_number >= 1u && in->point_number <= 31u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    return ESC11_OK;
}

/** Writes esc11_read_current_point_number_response to 1 byte without checks. */
static inline void esc11_read_current_point_number_response_pack(const esc11_read_current_point_number_response *in,
        uint8_t *out)
{
    esc11_store_u8(out + 0, in->point_number);
}

/** Reads esc11_read_current_point_number_response from 1 byte without checks. */
static inline void esc11_read_current_point_number_response_unpack(const uint8_t *in,
        esc11_read_current_point_number_response *out)
{
    out->point_number = esc11_load_u8(in + 0);
}

/**
 * Writes esc11_read_current_point_number_response: 1 byte.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_read_current_point_number_response_encode(const esc11_read_current_point_number_response *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    esc11_codec_status status;
    if (capacity < 1u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_read_current_point_number_response_check(in);
    if (status != ESC11_OK) {
        return status;
    }
    esc11_read_current_point_number_response_pack(in, out);
    *length = 1u;
    return ESC11_OK;
}

/** Reads esc11_read_current_point_number_response from exactly 1 byte. */
static inline esc11_codec_status esc11_read_current_point_number_response_decode(const uint8_t *in, size_t length,
        esc11_read_current_point_number_response *out)
{
    if (length != 1u) {
        return length < 1u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_read_current_point_number_response_unpack(in, out);
    return ESC11_OK;
}

typedef struct esc11_read_parameter_request {
    /**
     * Printed as 参数编号.
     * Range: 0..31.
     * Source: 10.1 L1196
     */
    uint8_t parameter_number;
} esc11_read_parameter_request;

/** Whether the values of esc11_read_parameter_request may be written. */
static inline esc11_codec_status esc11_read_parameter_request_check(const esc11_read_parameter_request *in)
{
    if (!(in->parameter_number <= 31u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    return ESC11_OK;
}

/** Writes esc11_read_parameter_request to 1 byte without checks. */
static inline void esc11_read_parameter_request_pack(const esc11_read_parameter_request *in, uint8_t *out)
{
    esc11_store_u8(out + 0, in->parameter_number);
}

/** Reads esc11_read_parameter_request from 1 byte without checks. */
static inline void esc11_read_parameter_request_unpack(const uint8_t *in, esc11_read_parameter_request *out)
{
    out->parameter_number = esc11_load_u8(in + 0);
}

/**
 * Writes esc11_read_parameter_request: 1 byte.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_read_parameter_request_encode(const esc11_read_parameter_request *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    esc11_codec_status status;
    if (capacity < 1u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_read_parameter_request_check(in);
    if (status != ESC11_OK) {
        return status;
    }
    esc11_read_parameter_request_pack(in, out);
    *length = 1u;
    return ESC11_OK;
}

/** Reads esc11_read_parameter_request from exactly 1 byte. */
static inline esc11_codec_status esc11_read_parameter_request_decode(const uint8_t *in, size_t length,
        esc11_read_parameter_request *out)
{
    if (length != 1u) {
        return length < 1u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_read_parameter_request_unpack(in, out);
    return ESC11_OK;
}

typedef struct esc11_read_parameter_response {
    /**
     * What it means depends on the parameter that the request names.
     * Printed as 参数数据.
     * Range: 0..65535.
     * Source: 10.1 L1197
     */
    uint16_t value;
} esc11_read_parameter_response;

/** Writes esc11_read_parameter_response to 2 bytes without checks. */
static inline void esc11_read_parameter_response_pack(const esc11_read_parameter_response *in, uint8_t *out)
{
    esc11_store_u16_le(out + 0, in->value);
}

/** Reads esc11_read_parameter_response from 2 bytes without checks. */
static inline void esc11_read_parameter_response_unpack(const uint8_t *in, esc11_read_parameter_response *out)
{
    out->value = esc11_load_u16_le(in + 0);
}

/**
 * Writes esc11_read_parameter_response: 2 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_read_parameter_response_encode(const esc11_read_parameter_response *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    if (capacity < 2u) {
        return ESC11_ERR_CAPACITY;
    }
    esc11_read_parameter_response_pack(in, out);
    *length = 2u;
    return ESC11_OK;
}

/** Reads esc11_read_parameter_response from exactly 2 bytes. */
static inline esc11_codec_status esc11_read_parameter_response_decode(const uint8_t *in, size_t length,
        esc11_read_parameter_response *out)
{
    if (length != 2u) {
        return length < 2u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_read_parameter_response_unpack(in, out);
    return ESC11_OK;
}

typedef struct esc11_read_point_request {
    /**
     * Printed as 点编号.
     * Range: 1..31.
     * Source: 10.1 L1198
     */
    uint8_t point_number;
} esc11_read_point_request;

/** Whether the values of esc11_read_point_request may be written. */
static inline esc11_codec_status esc11_read_point_request_check(const esc11_read_point_request *in)
{
    if (!(in->point_number >= 1u && in->point_number <= 31u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    return ESC11_OK;
}

/** Writes esc11_read_point_request to 1 byte without checks. */
static inline void esc11_read_point_request_pack(const esc11_read_point_request *in, uint8_t *out)
{
    esc11_store_u8(out + 0, in->point_number);
}

/** Reads esc11_read_point_request from 1 byte without checks. */
static inline void esc11_read_point_request_unpack(const uint8_t *in, esc11_read_point_request *out)
{
    out->point_number = esc11_load_u8(in + 0);
}

/**
 * Writes esc11_read_point_request: 1 byte.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_read_point_request_encode(const esc11_read_point_request *in, uint8_t *out,
        size_t capacity, size_t *length)
{
    esc11_codec_status status;
    if (capacity < 1u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_read_point_request_check(in);
    if (status != ESC11_OK) {
        return status;
    }
    esc11_read_point_request_pack(in, out);
    *length = 1u;
    return ESC11_OK;
}

/** Reads esc11_read_point_request from exactly 1 byte. */
static inline esc11_codec_status esc11_read_point_request_decode(const uint8_t *in, size_t length,
        esc11_read_point_request *out)
{
    if (length != 1u) {
        return length < 1u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_read_point_request_unpack(in, out);
    return ESC11_OK;
}

typedef struct esc11_read_point_response {
    /**
     * Printed as 数据.
     * Source: 9.3.5 L790
     */
    esc11_point point;
} esc11_read_point_response;

/** Whether the values of esc11_read_point_response may be written. */
static inline esc11_codec_status esc11_read_point_response_check(const esc11_read_point_response *in)
{
    esc11_codec_status status;
    status = esc11_point_check(&in->point);
    if (status != ESC11_OK) {
        return status;
    }
    return ESC11_OK;
}

/** Writes esc11_read_point_response to 16 bytes without checks. */
static inline void esc11_read_point_response_pack(const esc11_read_point_response *in, uint8_t *out)
{
    esc11_point_pack(&in->point, out + 0);
}

/** Reads esc11_read_point_response from 16 bytes without checks. */
static inline void esc11_read_point_response_unpack(const uint8_t *in, esc11_read_point_response *out)
{
    esc11_point_unpack(in + 0, &out->point);
}

/**
 * Writes esc11_read_point_response: 16 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_read_point_response_encode(const esc11_read_point_response *in, uint8_t *out,
        size_t capacity, size_t *length)
{
    esc11_codec_status status;
    if (capacity < 16u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_read_point_response_check(in);
    if (status != ESC11_OK) {
        return status;
    }
    esc11_read_point_response_pack(in, out);
    *length = 16u;
    return ESC11_OK;
}

/** Reads esc11_read_point_response from exactly 16 bytes. */
static inline esc11_codec_status esc11_read_point_response_decode(const uint8_t *in, size_t length,
        esc11_read_point_response *out)
{
    esc11_codec_status status;
    if (length != 16u) {
        return length < 16u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_read_point_response_unpack(in, out);
    status = esc11_point_decode(in + 0, 16u, &out->point);
    if (status != ESC11_OK) {
        return status;
    }
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_read_homing_state_request: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_read_homing_state_request_encode(uint8_t *out, size_t capacity, size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_read_homing_state_request from exactly 0 bytes. */
static inline esc11_codec_status esc11_read_homing_state_request_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

typedef struct esc11_read_homing_state_response {
    /**
     * 1 when homing is complete.
     * Printed as 原点复位状态.
     * Source: 9.3.6 L838, 840
     */
    bool homing_complete;
} esc11_read_homing_state_response;

/** Writes esc11_read_homing_state_response to 1 byte without checks. */
static inline void esc11_read_homing_state_response_pack(const esc11_read_homing_state_response *in, uint8_t *out)
{
    esc11_store_u8(out + 0, (uint8_t)(in->homing_complete ? 1 : 0));
}

/** Reads esc11_read_homing_state_response from 1 byte without checks. */
static inline void esc11_read_homing_state_response_unpack(const uint8_t *in, esc11_read_homing_state_response *out)
{
    out->homing_complete = esc11_load_u8(in + 0) != 0;
}

/**
 * Writes esc11_read_homing_state_response: 1 byte.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_read_homing_state_response_encode(const esc11_read_homing_state_response *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    if (capacity < 1u) {
        return ESC11_ERR_CAPACITY;
    }
    esc11_read_homing_state_response_pack(in, out);
    *length = 1u;
    return ESC11_OK;
}

/** Reads esc11_read_homing_state_response from exactly 1 byte. */
static inline esc11_codec_status esc11_read_homing_state_response_decode(const uint8_t *in, size_t length,
        esc11_read_homing_state_response *out)
{
    if (length != 1u) {
        return length < 1u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_read_homing_state_response_unpack(in, out);
    if (esc11_load_u8(in + 0) > 1u) {
        return ESC11_ERR_UNKNOWN_VALUE;
    }
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_read_motor_excitation_request: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_read_motor_excitation_request_encode(uint8_t *out, size_t capacity,
        size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_read_motor_excitation_request from exactly 0 bytes. */
static inline esc11_codec_status esc11_read_motor_excitation_request_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

typedef struct esc11_read_motor_excitation_response {
    /**
     * 1 when the motor is excited and ready for moves and grips. At 0 the fingers of an SS gripper can be moved by
     * hand.
     * Printed as 励磁状态.
     * Note: The bit servo_off in the status of the same response has the opposite sense.
     * Source: 9.3.7 L847, 849
     */
    bool excited;
} esc11_read_motor_excitation_response;

/** Writes esc11_read_motor_excitation_response to 1 byte without checks. */
static inline void esc11_read_motor_excitation_response_pack(const esc11_read_motor_excitation_response *in,
        uint8_t *out)
{
    esc11_store_u8(out + 0, (uint8_t)(in->excited ? 1 : 0));
}

/** Reads esc11_read_motor_excitation_response from 1 byte without checks. */
static inline void esc11_read_motor_excitation_response_unpack(const uint8_t *in,
        esc11_read_motor_excitation_response *out)
{
    out->excited = esc11_load_u8(in + 0) != 0;
}

/**
 * Writes esc11_read_motor_excitation_response: 1 byte.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_read_motor_excitation_response_encode(const esc11_read_motor_excitation_response *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    if (capacity < 1u) {
        return ESC11_ERR_CAPACITY;
    }
    esc11_read_motor_excitation_response_pack(in, out);
    *length = 1u;
    return ESC11_OK;
}

/** Reads esc11_read_motor_excitation_response from exactly 1 byte. */
static inline esc11_codec_status esc11_read_motor_excitation_response_decode(const uint8_t *in, size_t length,
        esc11_read_motor_excitation_response *out)
{
    if (length != 1u) {
        return length < 1u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_read_motor_excitation_response_unpack(in, out);
    if (esc11_load_u8(in + 0) > 1u) {
        return ESC11_ERR_UNKNOWN_VALUE;
    }
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_read_alarm_code_request: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_read_alarm_code_request_encode(uint8_t *out, size_t capacity, size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_read_alarm_code_request from exactly 0 bytes. */
static inline esc11_codec_status esc11_read_alarm_code_request_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

typedef struct esc11_read_alarm_code_response {
    /**
     * Printed as 警报及错误编号.
     * Range: 0..255. See alarm_code.
     * Note: The range begins at 0, and no table names 0; presumably nothing stands then.
     * Source: 10.1 L1209
     */
    uint8_t alarm_code;
} esc11_read_alarm_code_response;

/** Writes esc11_read_alarm_code_response to 1 byte without checks. */
static inline void esc11_read_alarm_code_response_pack(const esc11_read_alarm_code_response *in, uint8_t *out)
{
    esc11_store_u8(out + 0, in->alarm_code);
}

/** Reads esc11_read_alarm_code_response from 1 byte without checks. */
static inline void esc11_read_alarm_code_response_unpack(const uint8_t *in, esc11_read_alarm_code_response *out)
{
    out->alarm_code = esc11_load_u8(in + 0);
}

/**
 * Writes esc11_read_alarm_code_response: 1 byte.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_read_alarm_code_response_encode(const esc11_read_alarm_code_response *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    if (capacity < 1u) {
        return ESC11_ERR_CAPACITY;
    }
    esc11_read_alarm_code_response_pack(in, out);
    *length = 1u;
    return ESC11_OK;
}

/** Reads esc11_read_alarm_code_response from exactly 1 byte. */
static inline esc11_codec_status esc11_read_alarm_code_response_decode(const uint8_t *in, size_t length,
        esc11_read_alarm_code_response *out)
{
    if (length != 1u) {
        return length < 1u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_read_alarm_code_response_unpack(in, out);
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_read_accumulated_time_request: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_read_accumulated_time_request_encode(uint8_t *out, size_t capacity,
        size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_read_accumulated_time_request from exactly 0 bytes. */
static inline esc11_codec_status esc11_read_accumulated_time_request_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

typedef struct esc11_read_accumulated_time_response {
    /**
     * Printed as 累计时间的小时数.
     * One count is 1 h. Range: 0..65535.
     * Source: 9.3.9 L865, 867
     */
    uint16_t hours;
    /**
     * Printed as 分钟数.
     * One count is 1 min. Range: 0..60.
     * Note: All three places print 3Ch, so 60 minutes, as the upper end. A count that carries into the hours ends
     * at 59.
     * Source: 9.3.9 L865, 867
     */
    uint8_t minutes;
} esc11_read_accumulated_time_response;

/** Whether the values of esc11_read_accumulated_time_response may be written. */
static inline esc11_codec_status esc11_read_accumulated_time_response_check(const esc11_read_accumulated_time_response *in)
{
    if (!(in->minutes <= 60u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    return ESC11_OK;
}

/** Writes esc11_read_accumulated_time_response to 3 bytes without checks. */
static inline void esc11_read_accumulated_time_response_pack(const esc11_read_accumulated_time_response *in,
        uint8_t *out)
{
    esc11_store_u16_le(out + 0, in->hours);
    esc11_store_u8(out + 2, in->minutes);
}

/** Reads esc11_read_accumulated_time_response from 3 bytes without checks. */
static inline void esc11_read_accumulated_time_response_unpack(const uint8_t *in,
        esc11_read_accumulated_time_response *out)
{
    out->hours = esc11_load_u16_le(in + 0);
    out->minutes = esc11_load_u8(in + 2);
}

/**
 * Writes esc11_read_accumulated_time_response: 3 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_read_accumulated_time_response_encode(const esc11_read_accumulated_time_response *in,
        uint8_t *out, size_t capacity, size_t *length)
{
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_read_accumulated_time_response_check(in);
    if (status != ESC11_OK) {
        return status;
    }
    esc11_read_accumulated_time_response_pack(in, out);
    *length = 3u;
    return ESC11_OK;
}

/** Reads esc11_read_accumulated_time_response from exactly 3 bytes. */
static inline esc11_codec_status esc11_read_accumulated_time_response_decode(const uint8_t *in, size_t length,
        esc11_read_accumulated_time_response *out)
{
    if (length != 3u) {
        return length < 3u ? ESC11_ERR_INCOMPLETE : ESC11_ERR_WRONG_LENGTH;
    }
    esc11_read_accumulated_time_response_unpack(in, out);
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_reset_alarm_request: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_reset_alarm_request_encode(uint8_t *out, size_t capacity, size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_reset_alarm_request from exactly 0 bytes. */
static inline esc11_codec_status esc11_reset_alarm_request_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

/** It has no values, so it needs no struct. */

/**
 * Writes esc11_reset_alarm_response: 0 bytes.
 * `length` receives the number of bytes written.
 */
static inline esc11_codec_status esc11_reset_alarm_response_encode(uint8_t *out, size_t capacity, size_t *length)
{
    (void)out;
    (void)capacity;
    *length = 0;
    return ESC11_OK;
}

/** Reads esc11_reset_alarm_response from exactly 0 bytes. */
static inline esc11_codec_status esc11_reset_alarm_response_decode(const uint8_t *in, size_t length)
{
    (void)in;
    if (length > 0u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    return ESC11_OK;
}

/* ---- Parameters ---- */

/** Decodes the value. */
static inline esc11_codec_status esc11_par_parameters_actuator_type_decode(const uint8_t *in, uint16_t *out)
{
    *out = esc11_load_u16_le(in);
    return ESC11_OK;
}

/** Encodes the value. */
static inline esc11_codec_status esc11_par_parameters_actuator_type_encode(uint16_t value, uint8_t *out)
{
    esc11_store_u16_le(out, value);
    return ESC11_OK;
}

/** Decodes the value. */
static inline esc11_codec_status esc11_par_parameters_positive_soft_limit_decode(const uint8_t *in, uint16_t *out)
{
    *out = esc11_load_u16_le(in);
    return ESC11_OK;
}

/** Encodes the value. */
static inline esc11_codec_status esc11_par_parameters_positive_soft_limit_encode(uint16_t value, uint8_t *out)
{
    if (!(value <= 9999u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    esc11_store_u16_le(out, value);
    return ESC11_OK;
}

/** Decodes the value. */
static inline esc11_codec_status esc11_par_parameters_negative_soft_limit_decode(const uint8_t *in, int16_t *out)
{
    *out = esc11_signed_16(esc11_load_u16_le(in));
    return ESC11_OK;
}

/** Encodes the value. */
static inline esc11_codec_status esc11_par_parameters_negative_soft_limit_encode(int16_t value, uint8_t *out)
{
    if (!(value >= (-9999) && value <= 0)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    esc11_store_u16_le(out, (uint16_t)value);
    return ESC11_OK;
}

/** Decodes the value. */
static inline esc11_codec_status esc11_par_parameters_stroke_decode(const uint8_t *in, uint16_t *out)
{
    *out = esc11_load_u16_le(in);
    return ESC11_OK;
}

/** Encodes the value. */
static inline esc11_codec_status esc11_par_parameters_stroke_encode(uint16_t value, uint8_t *out)
{
    if (!(value <= 9999u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    esc11_store_u16_le(out, value);
    return ESC11_OK;
}

/** Decodes the value. */
static inline esc11_codec_status esc11_par_parameters_homing_direction_decode(const uint8_t *in,
        esc11_homing_direction *out)
{
    const uint16_t number = esc11_load_u16_le(in);
    if (!esc11_homing_direction_known((int64_t)number)) {
        return ESC11_ERR_UNKNOWN_VALUE;
    }
    *out = (esc11_homing_direction)number;
    return ESC11_OK;
}

/** Encodes the value. */
static inline esc11_codec_status esc11_par_parameters_homing_direction_encode(esc11_homing_direction value,
        uint8_t *out)
{
    if (!esc11_homing_direction_known((int64_t)value)) {
        return ESC11_ERR_UNKNOWN_VALUE;
    }
    esc11_store_u16_le(out, (uint16_t)value);
    return ESC11_OK;
}

/** Decodes the value. */
static inline esc11_codec_status esc11_par_parameters_homing_speed_decode(const uint8_t *in, uint16_t *out)
{
    *out = esc11_load_u16_le(in);
    return ESC11_OK;
}

/** Encodes the value. */
static inline esc11_codec_status esc11_par_parameters_homing_speed_encode(uint16_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 50u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    esc11_store_u16_le(out, value);
    return ESC11_OK;
}

/** Decodes the value. */
static inline esc11_codec_status esc11_par_parameters_home_offset_decode(const uint8_t *in, int16_t *out)
{
    *out = esc11_signed_16(esc11_load_u16_le(in));
    return ESC11_OK;
}

/** Encodes the value. */
static inline esc11_codec_status esc11_par_parameters_home_offset_encode(int16_t value, uint8_t *out)
{
    if (!(value >= (-9999) && value <= 9999)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    esc11_store_u16_le(out, (uint16_t)value);
    return ESC11_OK;
}

/** Decodes the value. */
static inline esc11_codec_status esc11_par_parameters_acceleration_decode(const uint8_t *in, uint16_t *out)
{
    *out = esc11_load_u16_le(in);
    return ESC11_OK;
}

/** Encodes the value. */
static inline esc11_codec_status esc11_par_parameters_acceleration_encode(uint16_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 100u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    esc11_store_u16_le(out, value);
    return ESC11_OK;
}

/** Decodes the value. */
static inline esc11_codec_status esc11_par_parameters_maximum_program_speed_decode(const uint8_t *in, uint16_t *out)
{
    *out = esc11_load_u16_le(in);
    return ESC11_OK;
}

/** Encodes the value. */
static inline esc11_codec_status esc11_par_parameters_maximum_program_speed_encode(uint16_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 100u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    esc11_store_u16_le(out, value);
    return ESC11_OK;
}

/** Decodes the value. */
static inline esc11_codec_status esc11_par_parameters_gripping_speed_decode(const uint8_t *in, uint16_t *out)
{
    *out = esc11_load_u16_le(in);
    return ESC11_OK;
}

/** Encodes the value. */
static inline esc11_codec_status esc11_par_parameters_gripping_speed_encode(uint16_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 100u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    esc11_store_u16_le(out, value);
    return ESC11_OK;
}

/** Decodes the value. */
static inline esc11_codec_status esc11_par_parameters_constant_speed_distance_decode(const uint8_t *in, uint16_t *out)
{
    *out = esc11_load_u16_le(in);
    return ESC11_OK;
}

/** Encodes the value. */
static inline esc11_codec_status esc11_par_parameters_constant_speed_distance_encode(uint16_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 9999u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    esc11_store_u16_le(out, value);
    return ESC11_OK;
}

/** Decodes the value. */
static inline esc11_codec_status esc11_par_parameters_limit_width_decode(const uint8_t *in, uint16_t *out)
{
    *out = esc11_load_u16_le(in);
    return ESC11_OK;
}

/** Encodes the value. */
static inline esc11_codec_status esc11_par_parameters_limit_width_encode(uint16_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 9999u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    esc11_store_u16_le(out, value);
    return ESC11_OK;
}

/** Decodes the value. */
static inline esc11_codec_status esc11_par_parameters_positioning_complete_pulses_decode(const uint8_t *in,
        uint16_t *out)
{
    *out = esc11_load_u16_le(in);
    return ESC11_OK;
}

/** Encodes the value. */
static inline esc11_codec_status esc11_par_parameters_positioning_complete_pulses_encode(uint16_t value, uint8_t *out)
{
    if (!(value >= 1u && value <= 4000u)) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    esc11_store_u16_le(out, value);
    return ESC11_OK;
}

/** Decodes the value. */
static inline esc11_codec_status esc11_par_parameters_homing_method_decode(const uint8_t *in, esc11_homing_method *out)
{
    const uint16_t number = esc11_load_u16_le(in);
    if (!esc11_homing_method_known((int64_t)number)) {
        return ESC11_ERR_UNKNOWN_VALUE;
    }
    *out = (esc11_homing_method)number;
    return ESC11_OK;
}

/** Encodes the value. */
static inline esc11_codec_status esc11_par_parameters_homing_method_encode(esc11_homing_method value, uint8_t *out)
{
    if (!esc11_homing_method_known((int64_t)value)) {
        return ESC11_ERR_UNKNOWN_VALUE;
    }
    esc11_store_u16_le(out, (uint16_t)value);
    return ESC11_OK;
}

/* ---- Frames ---- */

/**
 * Two wires, half duplex: the master polls one controller at a time, and a controller answers every packet
 * with its own address. Each packet begins with its length, which is the number of data bytes plus 4.
 * Frames are binary.
 * Note: A response carries a status byte where the request carries the command: which command it answers shows
 * only in the order of the packets.
 * Note: A controller that gets a packet with a communication error drops it and stays silent (7.3 L250).
 * Note: An unknown command is answered with the bit command_error set in the status (7.3 L251). Whether data
 * follow is not printed.
 * Source: 6 L188-194; 7.2 L234-238; 8.1 L255-268; 8.2 L270-297
 */
/** An opened request: its header, and where its body is. */
typedef struct esc11_serial_request_frame {
    /**
     * The controller that is meant.
     * Printed as 地址.
     * Source: 8.1 L264-265
     */
    uint8_t unit_address;
    /** The code, without the flag of an exception response. */
    uint32_t code;
    const uint8_t *body;
    size_t body_length;
} esc11_serial_request_frame;

/** Checks a frame and finds its body. */
static inline esc11_codec_status esc11_serial_request_open(const uint8_t *frame, size_t size,
        esc11_serial_request_frame *out)
{
    const uint8_t *in = frame;
    size_t length = size;
    if (length < 4u) {
        return ESC11_ERR_INCOMPLETE;
    }
    if (esc11_load_u8(in + 0) != length) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    if (esc11_sum8(in, length - 1u) != esc11_load_u8(in + length - 1u)) {
        return ESC11_ERR_WRONG_CHECKSUM;
    }
    out->unit_address = esc11_load_u8(in + 1);
    out->code = esc11_load_u8(in + 2);
    if (out->code != 16u && out->code != 17u && out->code != 18u && out->code != 19u && out->code != 20u &&
            out->code != 21u && out->code != 22u && out->code != 23u && out->code != 26u && out->code != 32u &&
            out->code != 33u && out->code != 34u && out->code != 35u && out->code != 36u && out->code != 37u &&
            out->code != 48u && out->code != 49u && out->code != 64u && out->code != 65u && out->code != 66u &&
            out->code != 67u && out->code != 68u && out->code != 69u && out->code != 70u && out->code != 71u &&
            out->code != 72u && out->code != 78u && out->code != 80u && out->code != 81u && out->code != 82u &&
            out->code != 83u && out->code != 96u && out->code != 97u && out->code != 98u && out->code != 99u &&
            out->code != 112u && out->code != 113u && out->code != 114u && out->code != 115u && out->code != 116u) {
        return ESC11_ERR_UNKNOWN_CODE;
    }
    out->body = in + 3u;
    out->body_length = length - 4u;
    return ESC11_OK;
}

/** Completes a frame whose body is at out + 3. `length` receives the size of the frame. */
static inline esc11_codec_status esc11_serial_request_close(uint8_t unit_address, uint32_t code, size_t body_length,
        uint8_t *out, size_t capacity, size_t *length)
{
    const size_t total = body_length + 4u;
    if (capacity < 4u || body_length > capacity - 4u) {
        return ESC11_ERR_CAPACITY;
    }
    if (total > 255u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    esc11_store_u8(out + 0, (uint8_t)total);
    if (!((unit_address <= 15))) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    esc11_store_u8(out + 1, (uint8_t)unit_address);
    if (code > 255u) {
        return ESC11_ERR_UNKNOWN_CODE;
    }
    esc11_store_u8(out + 2, (uint8_t)code);
    esc11_store_u8(out + total - 1u, esc11_sum8(out, total - 1u));
    *length = total;
    return ESC11_OK;
}

/** An opened response: its header, and where its body is. */
typedef struct esc11_serial_response_frame {
    /**
     * The controller that answers.
     * Printed as 地址.
     * Source: 8.2 L279-280
     */
    uint8_t unit_address;
    /**
     * How the last command went and the state of the controller.
     * Printed as 通信状态.
     * Source: 8.2 L281
     */
    uint8_t status;
    const uint8_t *body;
    size_t body_length;
} esc11_serial_response_frame;

/** Checks a frame and finds its body. */
static inline esc11_codec_status esc11_serial_response_open(const uint8_t *frame, size_t size,
        esc11_serial_response_frame *out)
{
    const uint8_t *in = frame;
    size_t length = size;
    if (length < 4u) {
        return ESC11_ERR_INCOMPLETE;
    }
    if (esc11_load_u8(in + 0) != length) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    if (esc11_sum8(in, length - 1u) != esc11_load_u8(in + length - 1u)) {
        return ESC11_ERR_WRONG_CHECKSUM;
    }
    out->unit_address = esc11_load_u8(in + 1);
    out->status = esc11_load_u8(in + 2);
    out->body = in + 3u;
    out->body_length = length - 4u;
    return ESC11_OK;
}

/** Completes a frame whose body is at out + 3. `length` receives the size of the frame. */
static inline esc11_codec_status esc11_serial_response_close(uint8_t unit_address, uint8_t status_, size_t body_length,
        uint8_t *out, size_t capacity, size_t *length)
{
    const size_t total = body_length + 4u;
    if (capacity < 4u || body_length > capacity - 4u) {
        return ESC11_ERR_CAPACITY;
    }
    if (total > 255u) {
        return ESC11_ERR_WRONG_LENGTH;
    }
    esc11_store_u8(out + 0, (uint8_t)total);
    if (!((unit_address <= 15))) {
        return ESC11_ERR_OUT_OF_RANGE;
    }
    esc11_store_u8(out + 1, (uint8_t)unit_address);
    esc11_store_u8(out + 2, (uint8_t)status_);
    esc11_store_u8(out + total - 1u, esc11_sum8(out, total - 1u));
    *length = total;
    return ESC11_OK;
}

/** Writes the whole frame of the request read_points_request. */
static inline esc11_codec_status esc11_serial_encode_read_points_request(uint8_t unit_address,
        const esc11_read_points_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_read_points_request_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_request_close(unit_address, 80u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response read_points_response. */
static inline esc11_codec_status esc11_serial_encode_read_points_response(uint8_t unit_address, uint8_t status_,
        const esc11_read_points_response *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_read_points_response_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_response_close(unit_address, status_, body_length, out, capacity, length);
}

/** Writes the whole frame of the request read_parameters_request. */
static inline esc11_codec_status esc11_serial_encode_read_parameters_request(uint8_t unit_address, uint8_t *out,
        size_t capacity, size_t *length)
{
    return esc11_serial_request_close(unit_address, 81u, 0, out, capacity, length);
}

/** Writes the whole frame of the response read_parameters_response. */
static inline esc11_codec_status esc11_serial_encode_read_parameters_response(uint8_t unit_address, uint8_t status_,
        const esc11_read_parameters_response *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_read_parameters_response_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_response_close(unit_address, status_, body_length, out, capacity, length);
}

/** Writes the whole frame of the request read_io_status_request. */
static inline esc11_codec_status esc11_serial_encode_read_io_status_request(uint8_t unit_address, uint8_t *out,
        size_t capacity, size_t *length)
{
    return esc11_serial_request_close(unit_address, 82u, 0, out, capacity, length);
}

/** Writes the whole frame of the response read_io_status_response. */
static inline esc11_codec_status esc11_serial_encode_read_io_status_response(uint8_t unit_address, uint8_t status_,
        const esc11_read_io_status_response *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_read_io_status_response_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_response_close(unit_address, status_, body_length, out, capacity, length);
}

/** Writes the whole frame of the request read_alarm_history_request. */
static inline esc11_codec_status esc11_serial_encode_read_alarm_history_request(uint8_t unit_address, uint8_t *out,
        size_t capacity, size_t *length)
{
    return esc11_serial_request_close(unit_address, 83u, 0, out, capacity, length);
}

/** Writes the whole frame of the response read_alarm_history_response. */
static inline esc11_codec_status esc11_serial_encode_read_alarm_history_response(uint8_t unit_address, uint8_t status_,
        const esc11_read_alarm_history_response *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_read_alarm_history_response_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_response_close(unit_address, status_, body_length, out, capacity, length);
}

/** Writes the whole frame of the request write_points_request. */
static inline esc11_codec_status esc11_serial_encode_write_points_request(uint8_t unit_address,
        const esc11_write_points_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_write_points_request_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_request_close(unit_address, 96u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response write_points_response. */
static inline esc11_codec_status esc11_serial_encode_write_points_response(uint8_t unit_address, uint8_t status_,
        uint8_t *out, size_t capacity, size_t *length)
{
    return esc11_serial_response_close(unit_address, status_, 0, out, capacity, length);
}

/** Writes the whole frame of the request write_parameters_request. */
static inline esc11_codec_status esc11_serial_encode_write_parameters_request(uint8_t unit_address,
        const esc11_write_parameters_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_write_parameters_request_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_request_close(unit_address, 97u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response write_parameters_response. */
static inline esc11_codec_status esc11_serial_encode_write_parameters_response(uint8_t unit_address, uint8_t status_,
        uint8_t *out, size_t capacity, size_t *length)
{
    return esc11_serial_response_close(unit_address, status_, 0, out, capacity, length);
}

/** Writes the whole frame of the request write_parameter_request. */
static inline esc11_codec_status esc11_serial_encode_write_parameter_request(uint8_t unit_address,
        const esc11_write_parameter_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_write_parameter_request_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_request_close(unit_address, 98u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response write_parameter_response. */
static inline esc11_codec_status esc11_serial_encode_write_parameter_response(uint8_t unit_address, uint8_t status_,
        uint8_t *out, size_t capacity, size_t *length)
{
    return esc11_serial_response_close(unit_address, status_, 0, out, capacity, length);
}

/** Writes the whole frame of the request write_temporary_point_request. */
static inline esc11_codec_status esc11_serial_encode_write_temporary_point_request(uint8_t unit_address,
        const esc11_write_temporary_point_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_write_temporary_point_request_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_request_close(unit_address, 99u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response write_temporary_point_response. */
static inline esc11_codec_status esc11_serial_encode_write_temporary_point_response(uint8_t unit_address,
        uint8_t status_, uint8_t *out, size_t capacity, size_t *length)
{
    return esc11_serial_response_close(unit_address, status_, 0, out, capacity, length);
}

/** Writes the whole frame of the request clear_points_request. */
static inline esc11_codec_status esc11_serial_encode_clear_points_request(uint8_t unit_address,
        const esc11_clear_points_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_clear_points_request_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_request_close(unit_address, 112u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response clear_points_response. */
static inline esc11_codec_status esc11_serial_encode_clear_points_response(uint8_t unit_address, uint8_t status_,
        uint8_t *out, size_t capacity, size_t *length)
{
    return esc11_serial_response_close(unit_address, status_, 0, out, capacity, length);
}

/** Writes the whole frame of the request initialize_points_request. */
static inline esc11_codec_status esc11_serial_encode_initialize_points_request(uint8_t unit_address, uint8_t *out,
        size_t capacity, size_t *length)
{
    return esc11_serial_request_close(unit_address, 113u, 0, out, capacity, length);
}

/** Writes the whole frame of the response initialize_points_response. */
static inline esc11_codec_status esc11_serial_encode_initialize_points_response(uint8_t unit_address, uint8_t status_,
        uint8_t *out, size_t capacity, size_t *length)
{
    return esc11_serial_response_close(unit_address, status_, 0, out, capacity, length);
}

/** Writes the whole frame of the request initialize_parameters_request. */
static inline esc11_codec_status esc11_serial_encode_initialize_parameters_request(uint8_t unit_address,
        const esc11_initialize_parameters_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_initialize_parameters_request_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_request_close(unit_address, 114u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response initialize_parameters_response. */
static inline esc11_codec_status esc11_serial_encode_initialize_parameters_response(uint8_t unit_address,
        uint8_t status_, uint8_t *out, size_t capacity, size_t *length)
{
    return esc11_serial_response_close(unit_address, status_, 0, out, capacity, length);
}

/** Writes the whole frame of the request clear_alarm_history_request. */
static inline esc11_codec_status esc11_serial_encode_clear_alarm_history_request(uint8_t unit_address, uint8_t *out,
        size_t capacity, size_t *length)
{
    return esc11_serial_request_close(unit_address, 115u, 0, out, capacity, length);
}

/** Writes the whole frame of the response clear_alarm_history_response. */
static inline esc11_codec_status esc11_serial_encode_clear_alarm_history_response(uint8_t unit_address, uint8_t status_,
        uint8_t *out, size_t capacity, size_t *length)
{
    return esc11_serial_response_close(unit_address, status_, 0, out, capacity, length);
}

/** Writes the whole frame of the request clear_accumulated_time_request. */
static inline esc11_codec_status esc11_serial_encode_clear_accumulated_time_request(uint8_t unit_address, uint8_t *out,
        size_t capacity, size_t *length)
{
    return esc11_serial_request_close(unit_address, 116u, 0, out, capacity, length);
}

/** Writes the whole frame of the response clear_accumulated_time_response. */
static inline esc11_codec_status esc11_serial_encode_clear_accumulated_time_response(uint8_t unit_address,
        uint8_t status_, uint8_t *out, size_t capacity, size_t *length)
{
    return esc11_serial_response_close(unit_address, status_, 0, out, capacity, length);
}

/** Writes the whole frame of the request stop_request. */
static inline esc11_codec_status esc11_serial_encode_stop_request(uint8_t unit_address, uint8_t *out, size_t capacity,
        size_t *length)
{
    return esc11_serial_request_close(unit_address, 16u, 0, out, capacity, length);
}

/** Writes the whole frame of the response stop_response. */
static inline esc11_codec_status esc11_serial_encode_stop_response(uint8_t unit_address, uint8_t status_, uint8_t *out,
        size_t capacity, size_t *length)
{
    return esc11_serial_response_close(unit_address, status_, 0, out, capacity, length);
}

/** Writes the whole frame of the request start_homing_request. */
static inline esc11_codec_status esc11_serial_encode_start_homing_request(uint8_t unit_address, uint8_t *out,
        size_t capacity, size_t *length)
{
    return esc11_serial_request_close(unit_address, 17u, 0, out, capacity, length);
}

/** Writes the whole frame of the response start_homing_response. */
static inline esc11_codec_status esc11_serial_encode_start_homing_response(uint8_t unit_address, uint8_t status_,
        uint8_t *out, size_t capacity, size_t *length)
{
    return esc11_serial_response_close(unit_address, status_, 0, out, capacity, length);
}

/** Writes the whole frame of the request move_positive_distance_request. */
static inline esc11_codec_status esc11_serial_encode_move_positive_distance_request(uint8_t unit_address,
        const esc11_move_positive_distance_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_move_positive_distance_request_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_request_close(unit_address, 18u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response move_positive_distance_response. */
static inline esc11_codec_status esc11_serial_encode_move_positive_distance_response(uint8_t unit_address,
        uint8_t status_, uint8_t *out, size_t capacity, size_t *length)
{
    return esc11_serial_response_close(unit_address, status_, 0, out, capacity, length);
}

/** Writes the whole frame of the request move_negative_distance_request. */
static inline esc11_codec_status esc11_serial_encode_move_negative_distance_request(uint8_t unit_address,
        const esc11_move_negative_distance_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_move_negative_distance_request_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_request_close(unit_address, 19u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response move_negative_distance_response. */
static inline esc11_codec_status esc11_serial_encode_move_negative_distance_response(uint8_t unit_address,
        uint8_t status_, uint8_t *out, size_t capacity, size_t *length)
{
    return esc11_serial_response_close(unit_address, status_, 0, out, capacity, length);
}

/** Writes the whole frame of the request move_open_request. */
static inline esc11_codec_status esc11_serial_encode_move_open_request(uint8_t unit_address,
        const esc11_move_open_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_move_open_request_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_request_close(unit_address, 20u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response move_open_response. */
static inline esc11_codec_status esc11_serial_encode_move_open_response(uint8_t unit_address, uint8_t status_,
        uint8_t *out, size_t capacity, size_t *length)
{
    return esc11_serial_response_close(unit_address, status_, 0, out, capacity, length);
}

/** Writes the whole frame of the request move_close_request. */
static inline esc11_codec_status esc11_serial_encode_move_close_request(uint8_t unit_address,
        const esc11_move_close_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_move_close_request_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_request_close(unit_address, 21u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response move_close_response. */
static inline esc11_codec_status esc11_serial_encode_move_close_response(uint8_t unit_address, uint8_t status_,
        uint8_t *out, size_t capacity, size_t *length)
{
    return esc11_serial_response_close(unit_address, status_, 0, out, capacity, length);
}

/** Writes the whole frame of the request move_relative_request. */
static inline esc11_codec_status esc11_serial_encode_move_relative_request(uint8_t unit_address,
        const esc11_move_relative_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_move_relative_request_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_request_close(unit_address, 22u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response move_relative_response. */
static inline esc11_codec_status esc11_serial_encode_move_relative_response(uint8_t unit_address, uint8_t status_,
        uint8_t *out, size_t capacity, size_t *length)
{
    return esc11_serial_response_close(unit_address, status_, 0, out, capacity, length);
}

/** Writes the whole frame of the request move_absolute_request. */
static inline esc11_codec_status esc11_serial_encode_move_absolute_request(uint8_t unit_address,
        const esc11_move_absolute_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_move_absolute_request_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_request_close(unit_address, 23u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response move_absolute_response. */
static inline esc11_codec_status esc11_serial_encode_move_absolute_response(uint8_t unit_address, uint8_t status_,
        uint8_t *out, size_t capacity, size_t *length)
{
    return esc11_serial_response_close(unit_address, status_, 0, out, capacity, length);
}

/** Writes the whole frame of the request move_to_point_request. */
static inline esc11_codec_status esc11_serial_encode_move_to_point_request(uint8_t unit_address,
        const esc11_move_to_point_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_move_to_point_request_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_request_close(unit_address, 26u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response move_to_point_response. */
static inline esc11_codec_status esc11_serial_encode_move_to_point_response(uint8_t unit_address, uint8_t status_,
        uint8_t *out, size_t capacity, size_t *length)
{
    return esc11_serial_response_close(unit_address, status_, 0, out, capacity, length);
}

/** Writes the whole frame of the request grip_open_request. */
static inline esc11_codec_status esc11_serial_encode_grip_open_request(uint8_t unit_address,
        const esc11_grip_open_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_grip_open_request_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_request_close(unit_address, 32u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response grip_open_response. */
static inline esc11_codec_status esc11_serial_encode_grip_open_response(uint8_t unit_address, uint8_t status_,
        uint8_t *out, size_t capacity, size_t *length)
{
    return esc11_serial_response_close(unit_address, status_, 0, out, capacity, length);
}

/** Writes the whole frame of the request grip_close_request. */
static inline esc11_codec_status esc11_serial_encode_grip_close_request(uint8_t unit_address,
        const esc11_grip_close_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_grip_close_request_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_request_close(unit_address, 33u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response grip_close_response. */
static inline esc11_codec_status esc11_serial_encode_grip_close_response(uint8_t unit_address, uint8_t status_,
        uint8_t *out, size_t capacity, size_t *length)
{
    return esc11_serial_response_close(unit_address, status_, 0, out, capacity, length);
}

/** Writes the whole frame of the request grip_relative_request. */
static inline esc11_codec_status esc11_serial_encode_grip_relative_request(uint8_t unit_address,
        const esc11_grip_relative_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_grip_relative_request_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_request_close(unit_address, 34u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response grip_relative_response. */
static inline esc11_codec_status esc11_serial_encode_grip_relative_response(uint8_t unit_address, uint8_t status_,
        uint8_t *out, size_t capacity, size_t *length)
{
    return esc11_serial_response_close(unit_address, status_, 0, out, capacity, length);
}

/** Writes the whole frame of the request grip_absolute_request. */
static inline esc11_codec_status esc11_serial_encode_grip_absolute_request(uint8_t unit_address,
        const esc11_grip_absolute_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_grip_absolute_request_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_request_close(unit_address, 35u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response grip_absolute_response. */
static inline esc11_codec_status esc11_serial_encode_grip_absolute_response(uint8_t unit_address, uint8_t status_,
        uint8_t *out, size_t capacity, size_t *length)
{
    return esc11_serial_response_close(unit_address, status_, 0, out, capacity, length);
}

/** Writes the whole frame of the request grip_open_with_zone_request. */
static inline esc11_codec_status esc11_serial_encode_grip_open_with_zone_request(uint8_t unit_address,
        const esc11_grip_open_with_zone_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_grip_open_with_zone_request_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_request_close(unit_address, 36u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response grip_open_with_zone_response. */
static inline esc11_codec_status esc11_serial_encode_grip_open_with_zone_response(uint8_t unit_address, uint8_t status_,
        uint8_t *out, size_t capacity, size_t *length)
{
    return esc11_serial_response_close(unit_address, status_, 0, out, capacity, length);
}

/** Writes the whole frame of the request grip_close_with_zone_request. */
static inline esc11_codec_status esc11_serial_encode_grip_close_with_zone_request(uint8_t unit_address,
        const esc11_grip_close_with_zone_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_grip_close_with_zone_request_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_request_close(unit_address, 37u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response grip_close_with_zone_response. */
static inline esc11_codec_status esc11_serial_encode_grip_close_with_zone_response(uint8_t unit_address,
        uint8_t status_, uint8_t *out, size_t capacity, size_t *length)
{
    return esc11_serial_response_close(unit_address, status_, 0, out, capacity, length);
}

/** Writes the whole frame of the request no_operation_request. */
static inline esc11_codec_status esc11_serial_encode_no_operation_request(uint8_t unit_address, uint8_t *out,
        size_t capacity, size_t *length)
{
    return esc11_serial_request_close(unit_address, 48u, 0, out, capacity, length);
}

/** Writes the whole frame of the response no_operation_response. */
static inline esc11_codec_status esc11_serial_encode_no_operation_response(uint8_t unit_address, uint8_t status_,
        uint8_t *out, size_t capacity, size_t *length)
{
    return esc11_serial_response_close(unit_address, status_, 0, out, capacity, length);
}

/** Writes the whole frame of the request set_motor_excitation_request. */
static inline esc11_codec_status esc11_serial_encode_set_motor_excitation_request(uint8_t unit_address,
        const esc11_set_motor_excitation_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_set_motor_excitation_request_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_request_close(unit_address, 49u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response set_motor_excitation_response. */
static inline esc11_codec_status esc11_serial_encode_set_motor_excitation_response(uint8_t unit_address,
        uint8_t status_, uint8_t *out, size_t capacity, size_t *length)
{
    return esc11_serial_response_close(unit_address, status_, 0, out, capacity, length);
}

/** Writes the whole frame of the request read_version_request. */
static inline esc11_codec_status esc11_serial_encode_read_version_request(uint8_t unit_address, uint8_t *out,
        size_t capacity, size_t *length)
{
    return esc11_serial_request_close(unit_address, 64u, 0, out, capacity, length);
}

/** Writes the whole frame of the response read_version_response. */
static inline esc11_codec_status esc11_serial_encode_read_version_response(uint8_t unit_address, uint8_t status_,
        const esc11_read_version_response *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_read_version_response_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_response_close(unit_address, status_, body_length, out, capacity, length);
}

/** Writes the whole frame of the request read_current_position_request. */
static inline esc11_codec_status esc11_serial_encode_read_current_position_request(uint8_t unit_address, uint8_t *out,
        size_t capacity, size_t *length)
{
    return esc11_serial_request_close(unit_address, 65u, 0, out, capacity, length);
}

/** Writes the whole frame of the response read_current_position_response. */
static inline esc11_codec_status esc11_serial_encode_read_current_position_response(uint8_t unit_address,
        uint8_t status_, const esc11_read_current_position_response *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_read_current_position_response_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_response_close(unit_address, status_, body_length, out, capacity, length);
}

/** Writes the whole frame of the request read_current_point_number_request. */
static inline esc11_codec_status esc11_serial_encode_read_current_point_number_request(uint8_t unit_address,
        uint8_t *out, size_t capacity, size_t *length)
{
    return esc11_serial_request_close(unit_address, 66u, 0, out, capacity, length);
}

/** Writes the whole frame of the response read_current_point_number_response. */
static inline esc11_codec_status esc11_serial_encode_read_current_point_number_response(uint8_t unit_address,
        uint8_t status_, const esc11_read_current_point_number_response *in, uint8_t *out, size_t capacity,
        size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_read_current_point_number_response_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_response_close(unit_address, status_, body_length, out, capacity, length);
}

/** Writes the whole frame of the request read_parameter_request. */
static inline esc11_codec_status esc11_serial_encode_read_parameter_request(uint8_t unit_address,
        const esc11_read_parameter_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_read_parameter_request_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_request_close(unit_address, 67u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response read_parameter_response. */
static inline esc11_codec_status esc11_serial_encode_read_parameter_response(uint8_t unit_address, uint8_t status_,
        const esc11_read_parameter_response *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_read_parameter_response_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_response_close(unit_address, status_, body_length, out, capacity, length);
}

/** Writes the whole frame of the request read_point_request. */
static inline esc11_codec_status esc11_serial_encode_read_point_request(uint8_t unit_address,
        const esc11_read_point_request *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_read_point_request_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_request_close(unit_address, 68u, body_length, out, capacity, length);
}

/** Writes the whole frame of the response read_point_response. */
static inline esc11_codec_status esc11_serial_encode_read_point_response(uint8_t unit_address, uint8_t status_,
        const esc11_read_point_response *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_read_point_response_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_response_close(unit_address, status_, body_length, out, capacity, length);
}

/** Writes the whole frame of the request read_homing_state_request. */
static inline esc11_codec_status esc11_serial_encode_read_homing_state_request(uint8_t unit_address, uint8_t *out,
        size_t capacity, size_t *length)
{
    return esc11_serial_request_close(unit_address, 69u, 0, out, capacity, length);
}

/** Writes the whole frame of the response read_homing_state_response. */
static inline esc11_codec_status esc11_serial_encode_read_homing_state_response(uint8_t unit_address, uint8_t status_,
        const esc11_read_homing_state_response *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_read_homing_state_response_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_response_close(unit_address, status_, body_length, out, capacity, length);
}

/** Writes the whole frame of the request read_motor_excitation_request. */
static inline esc11_codec_status esc11_serial_encode_read_motor_excitation_request(uint8_t unit_address, uint8_t *out,
        size_t capacity, size_t *length)
{
    return esc11_serial_request_close(unit_address, 70u, 0, out, capacity, length);
}

/** Writes the whole frame of the response read_motor_excitation_response. */
static inline esc11_codec_status esc11_serial_encode_read_motor_excitation_response(uint8_t unit_address,
        uint8_t status_, const esc11_read_motor_excitation_response *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_read_motor_excitation_response_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_response_close(unit_address, status_, body_length, out, capacity, length);
}

/** Writes the whole frame of the request read_alarm_code_request. */
static inline esc11_codec_status esc11_serial_encode_read_alarm_code_request(uint8_t unit_address, uint8_t *out,
        size_t capacity, size_t *length)
{
    return esc11_serial_request_close(unit_address, 71u, 0, out, capacity, length);
}

/** Writes the whole frame of the response read_alarm_code_response. */
static inline esc11_codec_status esc11_serial_encode_read_alarm_code_response(uint8_t unit_address, uint8_t status_,
        const esc11_read_alarm_code_response *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_read_alarm_code_response_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_response_close(unit_address, status_, body_length, out, capacity, length);
}

/** Writes the whole frame of the request read_accumulated_time_request. */
static inline esc11_codec_status esc11_serial_encode_read_accumulated_time_request(uint8_t unit_address, uint8_t *out,
        size_t capacity, size_t *length)
{
    return esc11_serial_request_close(unit_address, 72u, 0, out, capacity, length);
}

/** Writes the whole frame of the response read_accumulated_time_response. */
static inline esc11_codec_status esc11_serial_encode_read_accumulated_time_response(uint8_t unit_address,
        uint8_t status_, const esc11_read_accumulated_time_response *in, uint8_t *out, size_t capacity, size_t *length)
{
    size_t body_length = 0;
    esc11_codec_status status;
    if (capacity < 3u) {
        return ESC11_ERR_CAPACITY;
    }
    status = esc11_read_accumulated_time_response_encode(in, out + 3, capacity - 3u, &body_length);
    if (status != ESC11_OK) {
        return status;
    }
    return esc11_serial_response_close(unit_address, status_, body_length, out, capacity, length);
}

/** Writes the whole frame of the request reset_alarm_request. */
static inline esc11_codec_status esc11_serial_encode_reset_alarm_request(uint8_t unit_address, uint8_t *out,
        size_t capacity, size_t *length)
{
    return esc11_serial_request_close(unit_address, 78u, 0, out, capacity, length);
}

/** Writes the whole frame of the response reset_alarm_response. */
static inline esc11_codec_status esc11_serial_encode_reset_alarm_response(uint8_t unit_address, uint8_t status_,
        uint8_t *out, size_t capacity, size_t *length)
{
    return esc11_serial_response_close(unit_address, status_, 0, out, capacity, length);
}

/* ---- Texts of codes, in UTF-8 ---- */

#ifdef ESC11_WITH_TEXTS
/** The texts of a code. Line ends separate several causes or remedies. `printed` is the code as the manual writes it;
 * `number` is the second number that the manual gives the code, or -1. */
typedef struct esc11_code_text {
    int64_t code;
    int64_t number;
    const char *printed;
    const char *name;
    const char *label;
    const char *problem;
    const char *causes;
    const char *remedies;
} esc11_code_text;

/** The texts of a code of esc11_alarm_code, or NULL if the code is unknown. */
static inline const esc11_code_text *esc11_alarm_code_text(int64_t code)
{
    static const esc11_code_text texts[] = {
        {INT64_C(1), (-INT64_C(1)), "OVER LOAD", "overload", "\350\277\207\350\264\237\350\215\267", "The motor is overloaded.", "Something is wrong with how the gripper is used\nThe motor is faulty\nWrong parameters\nThe power supply or its cable is too weak\nToo much friction in the mechanism", "Lower the load of the mechanism.\nLower the acceleration parameter.\nSet the parameter of the carried weight to a fitting value.\nIf its winding resistance is too low, or it is unusually heavy to turn by hand, replace the motor unit.\nInitialize the parameters, for the right type of the mechanism.\nCheck the capacity of the power supply and increase it where it is too low.\nCheck whether the moving parts are heavy and adjust them."},
        {INT64_C(2), (-INT64_C(1)), "OVER CURRENT", "overcurrent", "\350\277\207\347\224\265\346\265\201", "The motor takes too much current.", "The motor cable has a short circuit\nThe motor is faulty\nThe controller is faulty\nWrong parameters", "Check the motor cable's conductors; if something is wrong, replace the motor unit.\nReplace the motor if it is shorted inside.\nMeasure the resistance between the motor terminals of phase A, and of phase B. If it is below the limit, an output transistor is broken: replace the controller.\nInitialize the parameters, for the right type of the mechanism."},
        {INT64_C(3), (-INT64_C(1)), "MACHINE REFERENCE OVER", "machine_reference_over", "\350\266\205\350\277\207\345\237\272\345\207\206\345\200\274", "The position of the encoder's Z phase differs from the initial one.", "The gripper body was replaced\nThe home position is on the closing side and the fingers were replaced\nThe encoder's Z phase is broken or faulty", "Initialize the parameters.\nInitialize the parameters.\nSet the home position to the opening side.\nReplace the gripper body."},
        {INT64_C(4), (-INT64_C(1)), "POWER SUPPLY VOLTAGE LOW", "supply_voltage_low", "\347\224\265\346\272\220\347\224\265\345\216\213\344\270\213\351\231\215", "The supply voltage has fallen to 80 % of the rated one.", "The power supply or its cable is too weak", "Check the capacity of the power supply and increase it where it is too low. Homing, starting, accelerating and braking take the most power."},
        {INT64_C(5), (-INT64_C(1)), "DATA NOT WRITE", "data_not_written", "\346\225\260\346\215\256\345\206\231\345\205\245\344\270\215\350\211\257", "Data cannot be written to the ROM.", "The ROM is worn out or faulty", "Replace the controller."},
        {INT64_C(6), (-INT64_C(1)), "P.E. COUNTER OVER", "position_deviation_over", "\344\275\215\347\275\256\345\201\217\345\267\256\350\277\207\345\244\247", "The position deviates too far from the commanded one.", "The mechanism is blocked\nThe motor cable is broken or wrongly wired\nWrong parameters", "Check whether the moving parts are blocked.\nCheck the wiring of the motor and of the encoder signals.\nInitialize the parameters, for the right type of the mechanism."},
        {INT64_C(7), (-INT64_C(1)), "PNT DATA DESTROY", "point_data_destroyed", "\347\202\271\346\225\260\346\215\256\344\270\215\350\211\257", "The points are damaged.", "The feedback circuit is faulty\nThe power was switched off while data were written\nNoise damaged the data", "Check the surroundings for sources of noise.\nSwitch the power on and check the points.\nIf some are wrong, correct them.\nIf all are wrong, delete all points and load them again.\nIf none is wrong, write any one of them again."},
        {INT64_C(8), (-INT64_C(1)), "PRM DATA DESTROY", "parameter_data_destroyed", "\345\217\202\346\225\260\344\270\215\350\211\257", "The parameters are damaged.", "The feedback circuit is faulty\nThe power was switched off while data were written\nNoise damaged the data", "Check the surroundings for sources of noise.\nSwitch the power on and initialize the parameters."},
        {INT64_C(9), (-INT64_C(1)), "SYSTEM FAULT1", "system_fault_1", "\347\263\273\347\273\237\345\274\202\345\270\2701", "The program of the M16C processor ran away.", "Noise or the like", "Check the surroundings for sources of noise."},
        {INT64_C(10), (-INT64_C(1)), "FEEDBACK ERROR1", "feedback_error_1", "\345\217\215\351\246\210\351\224\231\350\257\2571", "The motor runs away or has too much force.", "The start-up at power on went wrong, so that excitation and encoder do not match\nA force from outside pushed the fingers beyond a soft limit\nNoise or the like made the encoder count wrongly", "Check the surroundings for sources of noise.\nSwitch the power on again, check that no force acts on the fingers, and home."},
        {INT64_C(11), (-INT64_C(1)), "FEEDBACK ERROR2", "feedback_error_2", "\345\217\215\351\246\210\351\224\231\350\257\2572", "The encoder's signal line is broken.", "The encoder's signal line is broken", "Check the connection of the encoder's signal line."},
        {INT64_C(12), (-INT64_C(1)), "ABNORMAL VOLTAGE", "abnormal_voltage", "\347\224\265\345\216\213\345\274\202\345\270\270", "The voltage is too high.", "Regeneration raises the supply voltage\nThe power supply is set wrongly", "Lower the load of the mechanism.\nCheck the supply voltage."},
        {INT64_C(13), (-INT64_C(1)), "SYSTEM FAULT2", "system_fault_2", "\347\263\273\347\273\237\345\274\202\345\270\2702", "The program of the H8S processor ran away.", "Noise or the like", "Check the surroundings for sources of noise."},
        {INT64_C(14), (-INT64_C(1)), "FEEDBACK ERROR3", "feedback_error_3", "\345\217\215\351\246\210\351\224\231\350\257\2573", "The motor cable is broken or wrongly connected, or the motor is overloaded.", "The motor cable is broken or wrongly connected", "Check the connection of the motor cable."},
        {INT64_C(32), (-INT64_C(1)), "SOFT LIMIT OVER", "soft_limit_exceeded", "\350\266\205\350\277\207\350\275\257\351\231\220\344\275\215", "A soft limit is exceeded.", "A position beyond the soft limits was given when jogging, teaching directly or playing back", "Set the soft limits anew."},
        {INT64_C(33), (-INT64_C(1)), "PULSE OVERFLOW", "pulse_overflow", "\350\204\211\345\206\262\346\272\242\345\207\272", "Too many pulses have piled up.", "It moved otherwise than the set mode of operation allows", "Set acceleration and deceleration anew.\nSet the highest speed anew.\nSet the load anew.\nSet the load of the regeneration anew."},
        {INT64_C(34), (-INT64_C(1)), "", "io_logic_error", "I/O\351\200\273\350\276\221\351\224\231\350\257\257", "The parallel inputs got a wrong combination.", "An input other than the interlock came on during operation", "Check the input signals."},
        {INT64_C(35), (-INT64_C(1)), "", "homing_incomplete", "\345\216\237\347\202\271\346\234\252\345\256\214\346\210\220", "A move was commanded before homing was complete.", "Homing has not been carried out", "Home."},
        {INT64_C(36), (-INT64_C(1)), "", "servo_off", "\344\274\272\346\234\215OFF", "A move was commanded while the servo was off.", "The servo had not been switched on", "Switch the servo on."},
        {INT64_C(37), (-INT64_C(1)), "", "interlock", "\350\201\224\351\224\201", "A move was commanded while the interlock held.", "The interlock was not released", "Release the interlock: its input on releases it."},
        {INT64_C(38), (-INT64_C(1)), "", "no_point", "\346\227\240\347\202\271", "The point that was named has no data, so nothing could be carried out.", "A point without data was named", "Check which point is named."},
        {INT64_C(39), (-INT64_C(1)), "", "operating", "\350\277\220\350\241\214\344\270\255", "A command to start came during operation.", "A command to start was given during operation", "Check the input signals."},
        {INT64_C(40), (-INT64_C(1)), "", "processing", "\345\244\204\347\220\206\344\270\255", "A command came while data were being written.", "A command was given while data were being written", "Send the command when the signal BUSY is off."},
        {INT64_C(41), (-INT64_C(1)), "", "home_not_found", "\346\227\240\345\216\237\347\202\271", "The Z phase cannot be found.", "The actuator type is wrong\nThe signal line of the Z phase is broken", "Initialize the parameters.\nCheck the conductors of the signal line."},
        {INT64_C(48), (-INT64_C(1)), "", "network_communication_error", "\347\275\221\347\273\234\351\200\232\344\277\241\351\224\231\350\257\257", "Wrong checksum, wrong parity, timeout or overflow.", "The checksum is computed wrongly or the parity is set wrongly\nNoise or a cable that is too long\nMore data than the rules allow were sent\nCommands were sent one upon the other", "Correct the program.\nCheck the parity setting.\nCheck the surroundings for noise and choose the length of the cable anew.\nCheck the command.\nCheck that the controller has responded."},
        {INT64_C(49), (-INT64_C(1)), "", "communication_command_error", "\351\200\232\344\277\241\346\214\207\344\273\244\351\224\231\350\257\257", "A command outside the rules was received, or the length of its data is wrong.", "A command outside the rules was received\nThe length of the data is wrong", "Check the command.\nCheck the length of the data."},
        {INT64_C(50), (-INT64_C(1)), "", "data_error", "\346\225\260\346\215\256\351\224\231\350\257\257", "Data are beyond the range of their input.", "Wrong data", "Check the data."},
        {INT64_C(51), (-INT64_C(1)), "", "unknown_actuator_type", "\346\227\240\346\211\247\350\241\214\345\231\250\344\273\243\347\240\201", "The actuator type that was given for the initialization is wrong.", "A type that does not exist was given", "Check the actuator type."},
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

/* ---- Values out of range ---- */

/** Whether alarm_history_entry.minutes is outside of its stated range. */
static inline bool esc11_alarm_history_entry_minutes_is_out_of_range(uint8_t value)
{
    return !(value <= 60u);
}

/** Whether point.number is outside of its stated range. */
static inline bool esc11_point_number_is_out_of_range(uint8_t value)
{
    return !(value >= 1u && value <= 31u);
}

/** Whether point.distance is outside of its stated range. */
static inline bool esc11_point_distance_is_out_of_range(int32_t value)
{
    return !(value >= (-134217727) && value <= 134217727);
}

/** Whether point.speed is outside of its stated range. */
static inline bool esc11_point_speed_is_out_of_range(uint8_t value)
{
    return !(value <= 100u);
}

/** Whether point.force is outside of its stated range. */
static inline bool esc11_point_force_is_out_of_range(uint8_t value)
{
    return !(value <= 100u);
}

/** Whether point.zone_limit_1 is outside of its stated range. */
static inline bool esc11_point_zone_limit_1_is_out_of_range(int32_t value)
{
    return !(value >= (-134217727) && value <= 134217727);
}

/** Whether point.zone_limit_2 is outside of its stated range. */
static inline bool esc11_point_zone_limit_2_is_out_of_range(int32_t value)
{
    return !(value >= (-134217727) && value <= 134217727);
}

/** Whether temporary_point.distance is outside of its stated range. */
static inline bool esc11_temporary_point_distance_is_out_of_range(int32_t value)
{
    return !(value >= (-134217727) && value <= 134217727);
}

/** Whether temporary_point.speed is outside of its stated range. */
static inline bool esc11_temporary_point_speed_is_out_of_range(uint8_t value)
{
    return !(value <= 100u);
}

/** Whether temporary_point.force is outside of its stated range. */
static inline bool esc11_temporary_point_force_is_out_of_range(uint8_t value)
{
    return !(value <= 100u);
}

/** Whether temporary_point.zone_limit_1 is outside of its stated range. */
static inline bool esc11_temporary_point_zone_limit_1_is_out_of_range(int32_t value)
{
    return !(value >= (-134217727) && value <= 134217727);
}

/** Whether temporary_point.zone_limit_2 is outside of its stated range. */
static inline bool esc11_temporary_point_zone_limit_2_is_out_of_range(int32_t value)
{
    return !(value >= (-134217727) && value <= 134217727);
}

/** Whether read_points_request.first_point is outside of its stated range. */
static inline bool esc11_read_points_request_first_point_is_out_of_range(uint8_t value)
{
    return !(value >= 1u && value <= 31u);
}

/** Whether write_parameter_request.parameter_number is outside of its stated range. */
static inline bool esc11_write_parameter_request_parameter_number_is_out_of_range(uint8_t value)
{
    return !(value <= 31u);
}

/** Whether clear_points_request.first_point is outside of its stated range. */
static inline bool esc11_clear_points_request_first_point_is_out_of_range(uint8_t value)
{
    return !(value >= 1u && value <= 31u);
}

/** Whether clear_points_request.point_count is outside of its stated range. */
static inline bool esc11_clear_points_request_point_count_is_out_of_range(uint8_t value)
{
    return !(value >= 1u && value <= 31u);
}

/** Whether move_positive_distance_request.distance is outside of its stated range. */
static inline bool esc11_move_positive_distance_request_distance_is_out_of_range(uint8_t value)
{
    return !(value >= 1u);
}

/** Whether move_positive_distance_request.speed is outside of its stated range. */
static inline bool esc11_move_positive_distance_request_speed_is_out_of_range(uint8_t value)
{
    return !(value >= 1u && value <= 100u);
}

/** Whether move_positive_distance_request.force is outside of its stated range. */
static inline bool esc11_move_positive_distance_request_force_is_out_of_range(uint8_t value)
{
    return !(value <= 100u);
}

/** Whether move_negative_distance_request.distance is outside of its stated range. */
static inline bool esc11_move_negative_distance_request_distance_is_out_of_range(uint8_t value)
{
    return !(value >= 1u);
}

/** Whether move_negative_distance_request.speed is outside of its stated range. */
static inline bool esc11_move_negative_distance_request_speed_is_out_of_range(uint8_t value)
{
    return !(value >= 1u && value <= 100u);
}

/** Whether move_negative_distance_request.force is outside of its stated range. */
static inline bool esc11_move_negative_distance_request_force_is_out_of_range(uint8_t value)
{
    return !(value <= 100u);
}

/** Whether move_open_request.speed is outside of its stated range. */
static inline bool esc11_move_open_request_speed_is_out_of_range(uint8_t value)
{
    return !(value >= 1u && value <= 100u);
}

/** Whether move_close_request.speed is outside of its stated range. */
static inline bool esc11_move_close_request_speed_is_out_of_range(uint8_t value)
{
    return !(value >= 1u && value <= 100u);
}

/** Whether move_relative_request.distance is outside of its stated range. */
static inline bool esc11_move_relative_request_distance_is_out_of_range(int32_t value)
{
    return !(value >= (-134217727) && value <= 134217727);
}

/** Whether move_relative_request.speed is outside of its stated range. */
static inline bool esc11_move_relative_request_speed_is_out_of_range(uint8_t value)
{
    return !(value <= 100u);
}

/** Whether move_absolute_request.position is outside of its stated range. */
static inline bool esc11_move_absolute_request_position_is_out_of_range(int32_t value)
{
    return !(value >= (-134217727) && value <= 134217727);
}

/** Whether move_absolute_request.speed is outside of its stated range. */
static inline bool esc11_move_absolute_request_speed_is_out_of_range(uint8_t value)
{
    return !(value <= 100u);
}

/** Whether move_to_point_request.point_number is outside of its stated range. */
static inline bool esc11_move_to_point_request_point_number_is_out_of_range(uint8_t value)
{
    return !(value >= 1u && value <= 31u);
}

/** Whether move_to_point_request.speed is outside of its stated range. */
static inline bool esc11_move_to_point_request_speed_is_out_of_range(uint8_t value)
{
    return !(value <= 100u);
}

/** Whether grip_open_request.speed is outside of its stated range. */
static inline bool esc11_grip_open_request_speed_is_out_of_range(uint8_t value)
{
    return !(value <= 100u);
}

/** Whether grip_open_request.force is outside of its stated range. */
static inline bool esc11_grip_open_request_force_is_out_of_range(uint8_t value)
{
    return !(value <= 100u);
}

/** Whether grip_close_request.speed is outside of its stated range. */
static inline bool esc11_grip_close_request_speed_is_out_of_range(uint8_t value)
{
    return !(value <= 100u);
}

/** Whether grip_close_request.force is outside of its stated range. */
static inline bool esc11_grip_close_request_force_is_out_of_range(uint8_t value)
{
    return !(value <= 100u);
}

/** Whether grip_relative_request.distance is outside of its stated range. */
static inline bool esc11_grip_relative_request_distance_is_out_of_range(int32_t value)
{
    return !(value >= (-134217727) && value <= 134217727);
}

/** Whether grip_relative_request.speed is outside of its stated range. */
static inline bool esc11_grip_relative_request_speed_is_out_of_range(uint8_t value)
{
    return !(value <= 100u);
}

/** Whether grip_relative_request.force is outside of its stated range. */
static inline bool esc11_grip_relative_request_force_is_out_of_range(uint8_t value)
{
    return !(value <= 100u);
}

/** Whether grip_absolute_request.position is outside of its stated range. */
static inline bool esc11_grip_absolute_request_position_is_out_of_range(int32_t value)
{
    return !(value >= (-134217727) && value <= 134217727);
}

/** Whether grip_absolute_request.speed is outside of its stated range. */
static inline bool esc11_grip_absolute_request_speed_is_out_of_range(uint8_t value)
{
    return !(value <= 100u);
}

/** Whether grip_absolute_request.force is outside of its stated range. */
static inline bool esc11_grip_absolute_request_force_is_out_of_range(uint8_t value)
{
    return !(value <= 100u);
}

/** Whether grip_open_with_zone_request.zone_limit_1 is outside of its stated range. */
static inline bool esc11_grip_open_with_zone_request_zone_limit_1_is_out_of_range(int32_t value)
{
    return !(value >= (-134217727) && value <= 134217727);
}

/** Whether grip_open_with_zone_request.zone_limit_2 is outside of its stated range. */
static inline bool esc11_grip_open_with_zone_request_zone_limit_2_is_out_of_range(int32_t value)
{
    return !(value >= (-134217727) && value <= 134217727);
}

/** Whether grip_open_with_zone_request.speed is outside of its stated range. */
static inline bool esc11_grip_open_with_zone_request_speed_is_out_of_range(uint8_t value)
{
    return !(value <= 100u);
}

/** Whether grip_open_with_zone_request.force is outside of its stated range. */
static inline bool esc11_grip_open_with_zone_request_force_is_out_of_range(uint8_t value)
{
    return !(value <= 100u);
}

/** Whether grip_close_with_zone_request.zone_limit_1 is outside of its stated range. */
static inline bool esc11_grip_close_with_zone_request_zone_limit_1_is_out_of_range(int32_t value)
{
    return !(value >= (-134217727) && value <= 134217727);
}

/** Whether grip_close_with_zone_request.zone_limit_2 is outside of its stated range. */
static inline bool esc11_grip_close_with_zone_request_zone_limit_2_is_out_of_range(int32_t value)
{
    return !(value >= (-134217727) && value <= 134217727);
}

/** Whether grip_close_with_zone_request.speed is outside of its stated range. */
static inline bool esc11_grip_close_with_zone_request_speed_is_out_of_range(uint8_t value)
{
    return !(value <= 100u);
}

/** Whether grip_close_with_zone_request.force is outside of its stated range. */
static inline bool esc11_grip_close_with_zone_request_force_is_out_of_range(uint8_t value)
{
    return !(value <= 100u);
}

/** Whether read_current_position_response.position is outside of its stated range. */
static inline bool esc11_read_current_position_response_position_is_out_of_range(int32_t value)
{
    return !(value >= (-134217727) && value <= 134217727);
}

/** Whether read_current_point_number_response.point_number is outside of its stated range. */
static inline bool esc11_read_current_point_number_response_point_number_is_out_of_range(uint8_t value)
{
    return !(value >= 1u && value <= 31u);
}

/** Whether read_parameter_request.parameter_number is outside of its stated range. */
static inline bool esc11_read_parameter_request_parameter_number_is_out_of_range(uint8_t value)
{
    return !(value <= 31u);
}

/** Whether read_point_request.point_number is outside of its stated range. */
static inline bool esc11_read_point_request_point_number_is_out_of_range(uint8_t value)
{
    return !(value >= 1u && value <= 31u);
}

/** Whether read_accumulated_time_response.minutes is outside of its stated range. */
static inline bool esc11_read_accumulated_time_response_minutes_is_out_of_range(uint8_t value)
{
    return !(value <= 60u);
}

/** Whether parameters.positive_soft_limit is outside of its stated range. */
static inline bool esc11_par_parameters_positive_soft_limit_is_out_of_range(uint16_t value)
{
    return !(value <= 9999u);
}

/** Whether parameters.negative_soft_limit is outside of its stated range. */
static inline bool esc11_par_parameters_negative_soft_limit_is_out_of_range(int16_t value)
{
    return !(value >= (-9999) && value <= 0);
}

/** Whether parameters.stroke is outside of its stated range. */
static inline bool esc11_par_parameters_stroke_is_out_of_range(uint16_t value)
{
    return !(value <= 9999u);
}

/** Whether parameters.homing_speed is outside of its stated range. */
static inline bool esc11_par_parameters_homing_speed_is_out_of_range(uint16_t value)
{
    return !(value >= 1u && value <= 50u);
}

/** Whether parameters.home_offset is outside of its stated range. */
static inline bool esc11_par_parameters_home_offset_is_out_of_range(int16_t value)
{
    return !(value >= (-9999) && value <= 9999);
}

/** Whether parameters.acceleration is outside of its stated range. */
static inline bool esc11_par_parameters_acceleration_is_out_of_range(uint16_t value)
{
    return !(value >= 1u && value <= 100u);
}

/** Whether parameters.maximum_program_speed is outside of its stated range. */
static inline bool esc11_par_parameters_maximum_program_speed_is_out_of_range(uint16_t value)
{
    return !(value >= 1u && value <= 100u);
}

/** Whether parameters.gripping_speed is outside of its stated range. */
static inline bool esc11_par_parameters_gripping_speed_is_out_of_range(uint16_t value)
{
    return !(value >= 1u && value <= 100u);
}

/** Whether parameters.constant_speed_distance is outside of its stated range. */
static inline bool esc11_par_parameters_constant_speed_distance_is_out_of_range(uint16_t value)
{
    return !(value >= 1u && value <= 9999u);
}

/** Whether parameters.limit_width is outside of its stated range. */
static inline bool esc11_par_parameters_limit_width_is_out_of_range(uint16_t value)
{
    return !(value >= 1u && value <= 9999u);
}

/** Whether parameters.positioning_complete_pulses is outside of its stated range. */
static inline bool esc11_par_parameters_positioning_complete_pulses_is_out_of_range(uint16_t value)
{
    return !(value >= 1u && value <= 4000u);
}

#endif
