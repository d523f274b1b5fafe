/*
 * Fuzzes ck10_v1.h: CK10, version 1
 * Identity: fdc1e9665defc19d
 *
 * Generated; do not edit. For libFuzzer, and for AFL++ by afl-clang-fast:
 *
 *     clang -g -O1 -fsanitize=fuzzer,address,undefined,float-cast-overflow ck10_v1_fuzz.c && ./a.out
 *
 * The first two bytes of an input select a function, the others are its input. The target stops
 * - when a function reads or writes out of bounds, which the sanitizers detect;
 * - when encoding what was decoded gives other bytes, apart from reserved ones and those after the end of a text;
 * - when opening a frame that was closed gives another body, or closing a frame that was opened gives other bytes.
 */
#include "ck10_v1.h"

#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { LARGEST = 1024, CHOICES = 271 };

static void hold(bool so)
{
    if (!so) {
        abort();
    }
}

/* Decodes and encodes twice, then encodes into a buffer of the exact size, and into one that is a byte too small. */
#define RECORD(type, decode, encode, most, exact) \
    do { \
        type value, second; \
        uint8_t out[most] = {0}, again[most] = {0}; \
        uint8_t *room; \
        size_t length = 0, beyond = 0; \
        memset(&value, 0, sizeof value); \
        memset(&second, 0, sizeof second); \
        if (decode(data, size, &value) != CK10_OK) { \
            break; \
        } \
        if (encode(&value, out, sizeof out, &length) == CK10_ERR_OUT_OF_RANGE) { \
            break; \
        } \
        hold(encode(&value, out, sizeof out, &length) == CK10_OK && length == size); \
        hold(!(exact) || memcmp(out, data, size) == 0); \
        hold(decode(out, length, &second) == CK10_OK); \
        hold(encode(&second, again, sizeof again, &length) == CK10_OK && length == size); \
        hold(memcmp(out, again, size) == 0); \
        room = (uint8_t *)malloc(size); \
        if (room != NULL && size > 0) { \
            hold(encode(&value, room, size, &length) == CK10_OK && memcmp(room, out, size) == 0); \
            hold(encode(&value, room, size - 1, &beyond) == CK10_ERR_CAPACITY); \
        } \
        free(room); \
    } while (0)

/* Unpacks any bytes and packs them, twice: the second time changes nothing. */
#define PACKED(type, unpack, pack, length) \
    do { \
        type value; \
        uint8_t out[length] = {0}, again[length] = {0}; \
        if (size < (length)) { \
            break; \
        } \
        memset(&value, 0, sizeof value); \
        unpack(data, &value); \
        pack(&value, out); \
        unpack(out, &value); \
        pack(&value, again); \
        hold(memcmp(out, again, sizeof out) == 0); \
    } while (0)

/* A record without values, which has only one form. */
#define FIXED(decode, encode, most, exact) \
    do { \
        uint8_t out[(most) + 1u] = {0}; \
        size_t length = 0; \
        if (decode(data, size) != CK10_OK) { \
            break; \
        } \
        hold(encode(out, sizeof out, &length) == CK10_OK && length == size); \
        hold(!(exact) || memcmp(out, data, size) == 0); \
    } while (0)

/* The value of a register or a parameter. */
#define VALUE(type, decode, encode, held, length) \
    do { \
        type value; \
        uint8_t out[length] = {0}; \
        if (size < (length) || decode(data, &value) != CK10_OK || encode(value, out) == CK10_ERR_OUT_OF_RANGE) { \
            break; \
        } \
        hold(encode(value, out) == CK10_OK && memcmp(out, data, held) == 0); \
    } while (0)

/* A constant: what is encoded can be decoded, and so can anything else that the device answers. */
#define CONSTANT(type, decode, encode, length) \
    do { \
        type value; \
        uint8_t out[length] = {0}; \
        hold(encode(out) == CK10_OK && decode(out, &value) == CK10_OK); \
        hold(size < (length) || decode(data, &value) != CK10_ERR_WRONG_CONST); \
    } while (0)

/* A trigger: the device may answer anything, and whatever can be encoded is decoded to the same. `argument` is the type
 * of the value to encode: an enum, which need not hold every answer. */
#define TRIGGER(type, argument, decode, encode, held, length) \
    do { \
        type value; \
        uint8_t out[length] = {0}; \
        if (size < (length)) { \
            break; \
        } \
        hold(decode(data, &value) == CK10_OK); \
        if ((type)(argument)value == value) { \
            hold(encode((argument)value, out) != CK10_OK || memcmp(out, data, held) == 0); \
        } \
    } while (0)

/* An address or a number that is computed from another: two different ones that are accepted give different results. */
#define ADDRESS(type, at) \
    do { \
        type one = 0, other = 0; \
        uint32_t first, second; \
        if (size < 8) { \
            break; \
        } \
        first = data[0] | (uint32_t)data[1] << 8 | (uint32_t)data[2] << 16 | (uint32_t)data[3] << 24; \
        second = data[4] | (uint32_t)data[5] << 8 | (uint32_t)data[6] << 16 | (uint32_t)data[7] << 24; \
        if (at(first, &one) == CK10_OK && at(second, &other) == CK10_OK) { \
            hold((first == second) == (one == other)); \
        } \
    } while (0)

static void frame_0(const uint8_t *data, size_t size)
{
    static uint8_t out[4 * LARGEST];
    ck10_rtu_request_frame opened;
    size_t length = 0;
    memset(&opened, 0, sizeof opened);
    if (ck10_rtu_request_open(data, size, &opened) != CK10_OK) {
        return;
    }
    hold(opened.body >= data && opened.body + opened.body_length <= data + size);
    memcpy(out + 2, opened.body, opened.body_length);
    if (ck10_rtu_request_close(opened.unit_address, opened.code, opened.body_length, out, sizeof out, &length) == CK10_OK) {
        hold(length == size && memcmp(out, data, size) == 0);
    }
}

static void frame_1(const uint8_t *data, size_t size)
{
    enum { GIVEN = 2 };
    static uint8_t out[4 * LARGEST];
    ck10_rtu_request_frame opened;
    size_t length = 0;
    ck10_codec_status status;
    memset(&opened, 0, sizeof opened);
    if (size < GIVEN) {
        return;
    }
    memcpy(out + 2, data + GIVEN, size - GIVEN);
    if (ck10_rtu_request_close(data[0], data[1], size - GIVEN, out, sizeof out, &length) != CK10_OK) {
        return;
    }
    status = ck10_rtu_request_open(out, length, &opened);
    if (status == CK10_ERR_UNKNOWN_CODE) {
        return;
    }
    hold(status == CK10_OK);
    hold(opened.unit_address == data[0]);
    hold(opened.code == data[1]);
    hold(opened.body_length == size - GIVEN);
    hold(opened.body != NULL && memcmp(opened.body, data + GIVEN, size - GIVEN) == 0);
}

static void frame_2(const uint8_t *data, size_t size)
{
    static uint8_t out[4 * LARGEST];
    ck10_rtu_response_frame opened;
    size_t length = 0;
    memset(&opened, 0, sizeof opened);
    if (ck10_rtu_response_open(data, size, &opened) != CK10_OK) {
        return;
    }
    hold(opened.body >= data && opened.body + opened.body_length <= data + size);
    memcpy(out + 2, opened.body, opened.body_length);
    if (ck10_rtu_response_close(opened.unit_address, opened.code | (opened.error ? 128u : 0u), opened.body_length, out, sizeof out, &length) == CK10_OK) {
        hold(length == size && memcmp(out, data, size) == 0);
    }
}

static void frame_3(const uint8_t *data, size_t size)
{
    enum { GIVEN = 2 };
    static uint8_t out[4 * LARGEST];
    ck10_rtu_response_frame opened;
    size_t length = 0;
    ck10_codec_status status;
    memset(&opened, 0, sizeof opened);
    if (size < GIVEN) {
        return;
    }
    memcpy(out + 2, data + GIVEN, size - GIVEN);
    if (ck10_rtu_response_close(data[0], data[1], size - GIVEN, out, sizeof out, &length) != CK10_OK) {
        return;
    }
    status = ck10_rtu_response_open(out, length, &opened);
    if (status == CK10_ERR_UNKNOWN_CODE) {
        return;
    }
    hold(status == CK10_OK);
    hold(opened.unit_address == data[0]);
    hold(opened.code == (data[1] & 127u));
    hold(opened.body_length == size - GIVEN);
    hold(opened.body != NULL && memcmp(opened.body, data + GIVEN, size - GIVEN) == 0);
}

static void frame_4(const uint8_t *data, size_t size)
{
    static uint8_t buffer[2 * LARGEST];
    static uint8_t out[4 * LARGEST];
    ck10_ascii_request_frame opened;
    size_t length = 0;
    memset(&opened, 0, sizeof opened);
    if (ck10_ascii_request_open(data, size, buffer, sizeof buffer, &opened) != CK10_OK) {
        return;
    }
    hold(opened.body >= buffer && opened.body + opened.body_length <= buffer + sizeof buffer);
    memcpy(out + 2, opened.body, opened.body_length);
    if (ck10_ascii_request_close(opened.unit_address, opened.code, opened.body_length, out, sizeof out, &length) == CK10_OK) {
        hold(length == size);
    }
}

static void frame_5(const uint8_t *data, size_t size)
{
    enum { GIVEN = 2 };
    static uint8_t buffer[2 * LARGEST];
    static uint8_t out[4 * LARGEST];
    ck10_ascii_request_frame opened;
    size_t length = 0;
    ck10_codec_status status;
    memset(&opened, 0, sizeof opened);
    if (size < GIVEN) {
        return;
    }
    memcpy(out + 2, data + GIVEN, size - GIVEN);
    if (ck10_ascii_request_close(data[0], data[1], size - GIVEN, out, sizeof out, &length) != CK10_OK) {
        return;
    }
    status = ck10_ascii_request_open(out, length, buffer, sizeof buffer, &opened);
    if (status == CK10_ERR_UNKNOWN_CODE) {
        return;
    }
    hold(status == CK10_OK);
    hold(opened.unit_address == data[0]);
    hold(opened.code == data[1]);
    hold(opened.body_length == size - GIVEN);
    hold(opened.body != NULL && memcmp(opened.body, data + GIVEN, size - GIVEN) == 0);
}

static void frame_6(const uint8_t *data, size_t size)
{
    static uint8_t buffer[2 * LARGEST];
    static uint8_t out[4 * LARGEST];
    ck10_ascii_response_frame opened;
    size_t length = 0;
    memset(&opened, 0, sizeof opened);
    if (ck10_ascii_response_open(data, size, buffer, sizeof buffer, &opened) != CK10_OK) {
        return;
    }
    hold(opened.body >= buffer && opened.body + opened.body_length <= buffer + sizeof buffer);
    memcpy(out + 2, opened.body, opened.body_length);
    if (ck10_ascii_response_close(opened.unit_address, opened.code | (opened.error ? 128u : 0u), opened.body_length, out, sizeof out, &length) == CK10_OK) {
        hold(length == size);
    }
}

static void frame_7(const uint8_t *data, size_t size)
{
    enum { GIVEN = 2 };
    static uint8_t buffer[2 * LARGEST];
    static uint8_t out[4 * LARGEST];
    ck10_ascii_response_frame opened;
    size_t length = 0;
    ck10_codec_status status;
    memset(&opened, 0, sizeof opened);
    if (size < GIVEN) {
        return;
    }
    memcpy(out + 2, data + GIVEN, size - GIVEN);
    if (ck10_ascii_response_close(data[0], data[1], size - GIVEN, out, sizeof out, &length) != CK10_OK) {
        return;
    }
    status = ck10_ascii_response_open(out, length, buffer, sizeof buffer, &opened);
    if (status == CK10_ERR_UNKNOWN_CODE) {
        return;
    }
    hold(status == CK10_OK);
    hold(opened.unit_address == data[0]);
    hold(opened.code == (data[1] & 127u));
    hold(opened.body_length == size - GIVEN);
    hold(opened.body != NULL && memcmp(opened.body, data + GIVEN, size - GIVEN) == 0);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    unsigned choice;
    if (size < 2 || size > LARGEST) {
        return 0;
    }
    choice = (data[0] | (unsigned)data[1] << 8) % CHOICES;
    data += 2;
    size -= 2;
    switch (choice) {
    case 0:
        frame_0(data, size);
        break;
    case 1:
        frame_1(data, size);
        break;
    case 2:
        frame_2(data, size);
        break;
    case 3:
        frame_3(data, size);
        break;
    case 4:
        frame_4(data, size);
        break;
    case 5:
        frame_5(data, size);
        break;
    case 6:
        frame_6(data, size);
        break;
    case 7:
        frame_7(data, size);
        break;
    case 8:
        RECORD(ck10_exception, ck10_exception_decode, ck10_exception_encode, CK10_EXCEPTION_SIZE, 1);
        break;
    case 9:
        PACKED(ck10_exception, ck10_exception_unpack, ck10_exception_pack, CK10_EXCEPTION_SIZE);
        break;
    case 10:
        RECORD(ck10_point, ck10_point_decode, ck10_point_encode, CK10_POINT_SIZE, 0);
        break;
    case 11:
        PACKED(ck10_point, ck10_point_unpack, ck10_point_pack, CK10_POINT_SIZE);
        break;
    case 12:
        RECORD(ck10_read_registers_request, ck10_read_registers_request_decode, ck10_read_registers_request_encode, CK10_READ_REGISTERS_REQUEST_SIZE, 1);
        break;
    case 13:
        PACKED(ck10_read_registers_request, ck10_read_registers_request_unpack, ck10_read_registers_request_pack, CK10_READ_REGISTERS_REQUEST_SIZE);
        break;
    case 14:
        RECORD(ck10_read_registers_response, ck10_read_registers_response_decode, ck10_read_registers_response_encode, CK10_READ_REGISTERS_RESPONSE_SIZE, 1);
        break;
    case 15:
        RECORD(ck10_write_register_request, ck10_write_register_request_decode, ck10_write_register_request_encode, CK10_WRITE_REGISTER_REQUEST_SIZE, 1);
        break;
    case 16:
        PACKED(ck10_write_register_request, ck10_write_register_request_unpack, ck10_write_register_request_pack, CK10_WRITE_REGISTER_REQUEST_SIZE);
        break;
    case 17:
        RECORD(ck10_write_register_response, ck10_write_register_response_decode, ck10_write_register_response_encode, CK10_WRITE_REGISTER_RESPONSE_SIZE, 1);
        break;
    case 18:
        PACKED(ck10_write_register_response, ck10_write_register_response_unpack, ck10_write_register_response_pack, CK10_WRITE_REGISTER_RESPONSE_SIZE);
        break;
    case 19:
        RECORD(ck10_write_registers_request, ck10_write_registers_request_decode, ck10_write_registers_request_encode, CK10_WRITE_REGISTERS_REQUEST_SIZE, 1);
        break;
    case 20:
        RECORD(ck10_write_registers_response, ck10_write_registers_response_decode, ck10_write_registers_response_encode, CK10_WRITE_REGISTERS_RESPONSE_SIZE, 1);
        break;
    case 21:
        PACKED(ck10_write_registers_response, ck10_write_registers_response_unpack, ck10_write_registers_response_pack, CK10_WRITE_REGISTERS_RESPONSE_SIZE);
        break;
    case 22:
        FIXED(ck10_report_server_id_request_decode, ck10_report_server_id_request_encode, CK10_REPORT_SERVER_ID_REQUEST_SIZE, 1);
        break;
    case 23:
        FIXED(ck10_report_server_id_response_decode, ck10_report_server_id_response_encode, CK10_REPORT_SERVER_ID_RESPONSE_SIZE, 1);
        break;
    case 24:
        VALUE(uint32_t, ck10_reg_axis_start_speed_decode, ck10_reg_axis_start_speed_encode, 4u, 4u);
        break;
    case 25:
        VALUE(uint16_t, ck10_reg_axis_acceleration_time_decode, ck10_reg_axis_acceleration_time_encode, 2u, 2u);
        break;
    case 26:
        VALUE(uint16_t, ck10_reg_axis_deceleration_time_decode, ck10_reg_axis_deceleration_time_encode, 2u, 2u);
        break;
    case 27:
        VALUE(uint32_t, ck10_reg_axis_move_speed_decode, ck10_reg_axis_move_speed_encode, 4u, 4u);
        break;
    case 28:
        VALUE(int32_t, ck10_reg_target_position_or_distance_decode, ck10_reg_target_position_or_distance_encode, 4u, 4u);
        break;
    case 29:
        TRIGGER(uint16_t, ck10_move_kind, ck10_reg_start_move_decode, ck10_reg_start_move_encode, 2u, 2u);
        break;
    case 30:
        VALUE(uint16_t, ck10_reg_axis_jog_acceleration_time_decode, ck10_reg_axis_jog_acceleration_time_encode, 2u, 2u);
        break;
    case 31:
        VALUE(uint32_t, ck10_reg_axis_jog_start_speed_decode, ck10_reg_axis_jog_start_speed_encode, 4u, 4u);
        break;
    case 32:
        VALUE(uint32_t, ck10_reg_axis_jog_speed_decode, ck10_reg_axis_jog_speed_encode, 4u, 4u);
        break;
    case 33:
        VALUE(ck10_jog_direction, ck10_reg_jog_direction_decode, ck10_reg_jog_direction_encode, 2u, 2u);
        break;
    case 34:
        CONSTANT(uint16_t, ck10_reg_start_jog_decode, ck10_reg_start_jog_encode, 2u);
        break;
    case 35:
        VALUE(uint32_t, ck10_reg_push_start_speed_decode, ck10_reg_push_start_speed_encode, 4u, 4u);
        break;
    case 36:
        VALUE(uint32_t, ck10_reg_push_move_speed_decode, ck10_reg_push_move_speed_encode, 4u, 4u);
        break;
    case 37:
        VALUE(uint16_t, ck10_reg_push_acceleration_time_decode, ck10_reg_push_acceleration_time_encode, 2u, 2u);
        break;
    case 38:
        VALUE(uint16_t, ck10_reg_push_deceleration_time_decode, ck10_reg_push_deceleration_time_encode, 2u, 2u);
        break;
    case 39:
        VALUE(ck10_push_mode, ck10_reg_push_mode_decode, ck10_reg_push_mode_encode, 2u, 2u);
        break;
    case 40:
        VALUE(uint16_t, ck10_reg_push_torque_ratio_decode, ck10_reg_push_torque_ratio_encode, 2u, 2u);
        break;
    case 41:
        VALUE(uint32_t, ck10_reg_push_speed_decode, ck10_reg_push_speed_encode, 4u, 4u);
        break;
    case 42:
        VALUE(int32_t, ck10_reg_push_start_position_decode, ck10_reg_push_start_position_encode, 4u, 4u);
        break;
    case 43:
        VALUE(int32_t, ck10_reg_push_end_position_decode, ck10_reg_push_end_position_encode, 4u, 4u);
        break;
    case 44:
        CONSTANT(uint16_t, ck10_reg_start_push_motion_decode, ck10_reg_start_push_motion_encode, 2u);
        break;
    case 45:
        CONSTANT(uint16_t, ck10_reg_start_homing_decode, ck10_reg_start_homing_encode, 2u);
        break;
    case 46:
        TRIGGER(uint16_t, ck10_stop_kind, ck10_reg_stop_decode, ck10_reg_stop_encode, 2u, 2u);
        break;
    case 47:
        VALUE(uint16_t, ck10_reg_servo_decode, ck10_reg_servo_encode, 2u, 2u);
        break;
    case 48:
        CONSTANT(uint16_t, ck10_reg_clear_position_decode, ck10_reg_clear_position_encode, 2u);
        break;
    case 49:
        CONSTANT(uint16_t, ck10_reg_reset_alarm_decode, ck10_reg_reset_alarm_encode, 2u);
        break;
    case 50:
        CONSTANT(uint16_t, ck10_reg_save_point_table_decode, ck10_reg_save_point_table_encode, 2u);
        break;
    case 51:
        VALUE(uint16_t, ck10_reg_start_point_decode, ck10_reg_start_point_encode, 2u, 2u);
        break;
    case 52:
        TRIGGER(uint16_t, ck10_point_table_command, ck10_reg_run_point_table_decode, ck10_reg_run_point_table_encode, 2u, 2u);
        break;
    case 53:
        CONSTANT(uint16_t, ck10_reg_save_all_parameters_decode, ck10_reg_save_all_parameters_encode, 2u);
        break;
    case 54:
        VALUE(int32_t, ck10_reg_compare_start_position_decode, ck10_reg_compare_start_position_encode, 4u, 4u);
        break;
    case 55:
        VALUE(uint32_t, ck10_reg_compare_period_decode, ck10_reg_compare_period_encode, 4u, 4u);
        break;
    case 56:
        VALUE(uint16_t, ck10_reg_compare_pulse_width_decode, ck10_reg_compare_pulse_width_encode, 2u, 2u);
        break;
    case 57:
        VALUE(bool, ck10_reg_compare_enable_decode, ck10_reg_compare_enable_encode, 2u, 2u);
        break;
    case 58:
        VALUE(bool, ck10_reg_compare_active_decode, ck10_reg_compare_active_encode, 2u, 2u);
        break;
    case 59:
        CONSTANT(uint32_t, ck10_reg_model_id_decode, ck10_reg_model_id_encode, 4u);
        break;
    case 60:
        CONSTANT(uint16_t, ck10_reg_hardware_type_decode, ck10_reg_hardware_type_encode, 2u);
        break;
    case 61:
        VALUE(uint16_t, ck10_reg_firmware_version_decode, ck10_reg_firmware_version_encode, 2u, 2u);
        break;
    case 62:
        VALUE(uint32_t, ck10_reg_power_cycles_decode, ck10_reg_power_cycles_encode, 4u, 4u);
        break;
    case 63:
        VALUE(uint64_t, ck10_reg_turns_total_decode, ck10_reg_turns_total_encode, 8u, 8u);
        break;
    case 64:
        VALUE(uint64_t, ck10_reg_turns_since_power_on_decode, ck10_reg_turns_since_power_on_encode, 8u, 8u);
        break;
    case 65:
        VALUE(uint32_t, ck10_reg_resolution_decode, ck10_reg_resolution_encode, 4u, 4u);
        break;
    case 66:
        VALUE(uint32_t, ck10_reg_maximum_speed_decode, ck10_reg_maximum_speed_encode, 4u, 4u);
        break;
    case 67:
        VALUE(uint32_t, ck10_reg_start_speed_decode, ck10_reg_start_speed_encode, 4u, 4u);
        break;
    case 68:
        VALUE(uint32_t, ck10_reg_acceleration_time_decode, ck10_reg_acceleration_time_encode, 4u, 4u);
        break;
    case 69:
        VALUE(uint32_t, ck10_reg_deceleration_time_decode, ck10_reg_deceleration_time_encode, 4u, 4u);
        break;
    case 70:
        VALUE(uint32_t, ck10_reg_reserved_5_decode, ck10_reg_reserved_5_encode, 4u, 4u);
        break;
    case 71:
        VALUE(uint32_t, ck10_reg_jog_speed_decode, ck10_reg_jog_speed_encode, 4u, 4u);
        break;
    case 72:
        VALUE(uint32_t, ck10_reg_jog_start_speed_decode, ck10_reg_jog_start_speed_encode, 4u, 4u);
        break;
    case 73:
        VALUE(uint32_t, ck10_reg_jog_acceleration_time_decode, ck10_reg_jog_acceleration_time_encode, 4u, 4u);
        break;
    case 74:
        VALUE(int32_t, ck10_reg_positive_soft_limit_decode, ck10_reg_positive_soft_limit_encode, 4u, 4u);
        break;
    case 75:
        VALUE(int32_t, ck10_reg_negative_soft_limit_decode, ck10_reg_negative_soft_limit_encode, 4u, 4u);
        break;
    case 76:
        VALUE(ck10_soft_limit_stop, ck10_reg_soft_limit_stop_decode, ck10_reg_soft_limit_stop_encode, 4u, 4u);
        break;
    case 77:
        VALUE(ck10_hard_limit_stop, ck10_reg_hard_limit_stop_decode, ck10_reg_hard_limit_stop_encode, 4u, 4u);
        break;
    case 78:
        VALUE(uint32_t, ck10_reg_reserved_13_decode, ck10_reg_reserved_13_encode, 4u, 4u);
        break;
    case 79:
        VALUE(uint32_t, ck10_reg_homing_speed_decode, ck10_reg_homing_speed_encode, 4u, 4u);
        break;
    case 80:
        VALUE(uint32_t, ck10_reg_homing_search_speed_decode, ck10_reg_homing_search_speed_encode, 4u, 4u);
        break;
    case 81:
        VALUE(uint32_t, ck10_reg_homing_acceleration_time_decode, ck10_reg_homing_acceleration_time_encode, 4u, 4u);
        break;
    case 82:
        VALUE(ck10_homing_method, ck10_reg_homing_method_decode, ck10_reg_homing_method_encode, 4u, 4u);
        break;
    case 83:
        VALUE(ck10_rotation, ck10_reg_homing_direction_decode, ck10_reg_homing_direction_encode, 4u, 4u);
        break;
    case 84:
        VALUE(int32_t, ck10_reg_homing_offset_decode, ck10_reg_homing_offset_encode, 4u, 4u);
        break;
    case 85:
        VALUE(int32_t, ck10_reg_origin_position_decode, ck10_reg_origin_position_encode, 4u, 4u);
        break;
    case 86:
        VALUE(uint32_t, ck10_reg_reserved_21_decode, ck10_reg_reserved_21_encode, 4u, 4u);
        break;
    case 87:
        VALUE(uint32_t, ck10_reg_position_loop_gain_decode, ck10_reg_position_loop_gain_encode, 4u, 4u);
        break;
    case 88:
        VALUE(uint32_t, ck10_reg_in_position_range_decode, ck10_reg_in_position_range_encode, 4u, 4u);
        break;
    case 89:
        VALUE(uint32_t, ck10_reg_tracking_limit_decode, ck10_reg_tracking_limit_encode, 4u, 4u);
        break;
    case 90:
        VALUE(ck10_rotation, ck10_reg_motor_direction_decode, ck10_reg_motor_direction_encode, 4u, 4u);
        break;
    case 91:
        VALUE(uint32_t, ck10_reg_reserved_26_decode, ck10_reg_reserved_26_encode, 4u, 4u);
        break;
    case 92:
        VALUE(uint32_t, ck10_reg_homing_torque_ratio_decode, ck10_reg_homing_torque_ratio_encode, 4u, 4u);
        break;
    case 93:
        VALUE(uint32_t, ck10_reg_position_overflow_limit_decode, ck10_reg_position_overflow_limit_encode, 4u, 4u);
        break;
    case 94:
        VALUE(uint32_t, ck10_reg_reserved_29_decode, ck10_reg_reserved_29_encode, 4u, 4u);
        break;
    case 95:
        VALUE(uint32_t, ck10_reg_run_current_decode, ck10_reg_run_current_encode, 4u, 4u);
        break;
    case 96:
        VALUE(uint32_t, ck10_reg_boost_current_decode, ck10_reg_boost_current_encode, 4u, 4u);
        break;
    case 97:
        VALUE(uint32_t, ck10_reg_stop_current_decode, ck10_reg_stop_current_encode, 4u, 4u);
        break;
    case 98:
        VALUE(ck10_emergency_stop_mode, ck10_reg_emergency_stop_mode_decode, ck10_reg_emergency_stop_mode_encode, 4u, 4u);
        break;
    case 99:
        VALUE(ck10_emergency_brake_mode, ck10_reg_emergency_brake_mode_decode, ck10_reg_emergency_brake_mode_encode, 4u, 4u);
        break;
    case 100:
        VALUE(ck10_operation_mode, ck10_reg_operation_mode_decode, ck10_reg_operation_mode_encode, 4u, 4u);
        break;
    case 101:
        VALUE(ck10_switch_function, ck10_reg_switch_function_decode, ck10_reg_switch_function_encode, 4u, 4u);
        break;
    case 102:
        VALUE(ck10_baud_rate, ck10_reg_baud_rate_decode, ck10_reg_baud_rate_encode, 4u, 4u);
        break;
    case 103:
        VALUE(ck10_enabled, ck10_reg_save_position_decode, ck10_reg_save_position_encode, 4u, 4u);
        break;
    case 104:
        VALUE(ck10_enabled, ck10_reg_show_motor_number_decode, ck10_reg_show_motor_number_encode, 4u, 4u);
        break;
    case 105:
        VALUE(uint32_t, ck10_reg_assignment_flags_decode, ck10_reg_assignment_flags_encode, 4u, 4u);
        break;
    case 106:
        VALUE(uint32_t, ck10_reg_input_1_function_decode, ck10_reg_input_1_function_encode, 4u, 4u);
        break;
    case 107:
        VALUE(uint32_t, ck10_reg_input_2_function_decode, ck10_reg_input_2_function_encode, 4u, 4u);
        break;
    case 108:
        VALUE(uint32_t, ck10_reg_input_3_function_decode, ck10_reg_input_3_function_encode, 4u, 4u);
        break;
    case 109:
        VALUE(uint32_t, ck10_reg_input_4_function_decode, ck10_reg_input_4_function_encode, 4u, 4u);
        break;
    case 110:
        VALUE(uint32_t, ck10_reg_input_5_function_decode, ck10_reg_input_5_function_encode, 4u, 4u);
        break;
    case 111:
        VALUE(uint32_t, ck10_reg_input_6_function_decode, ck10_reg_input_6_function_encode, 4u, 4u);
        break;
    case 112:
        VALUE(uint32_t, ck10_reg_input_7_function_decode, ck10_reg_input_7_function_encode, 4u, 4u);
        break;
    case 113:
        VALUE(uint32_t, ck10_reg_input_8_function_decode, ck10_reg_input_8_function_encode, 4u, 4u);
        break;
    case 114:
        VALUE(uint32_t, ck10_reg_input_9_function_decode, ck10_reg_input_9_function_encode, 4u, 4u);
        break;
    case 115:
        VALUE(uint32_t, ck10_reg_input_10_function_decode, ck10_reg_input_10_function_encode, 4u, 4u);
        break;
    case 116:
        VALUE(uint32_t, ck10_reg_input_11_function_decode, ck10_reg_input_11_function_encode, 4u, 4u);
        break;
    case 117:
        VALUE(uint32_t, ck10_reg_input_12_function_decode, ck10_reg_input_12_function_encode, 4u, 4u);
        break;
    case 118:
        VALUE(uint32_t, ck10_reg_output_1_function_decode, ck10_reg_output_1_function_encode, 4u, 4u);
        break;
    case 119:
        VALUE(uint32_t, ck10_reg_output_2_function_decode, ck10_reg_output_2_function_encode, 4u, 4u);
        break;
    case 120:
        VALUE(uint32_t, ck10_reg_output_3_function_decode, ck10_reg_output_3_function_encode, 4u, 4u);
        break;
    case 121:
        VALUE(uint32_t, ck10_reg_output_4_function_decode, ck10_reg_output_4_function_encode, 4u, 4u);
        break;
    case 122:
        VALUE(uint32_t, ck10_reg_output_5_function_decode, ck10_reg_output_5_function_encode, 4u, 4u);
        break;
    case 123:
        VALUE(uint32_t, ck10_reg_output_6_function_decode, ck10_reg_output_6_function_encode, 4u, 4u);
        break;
    case 124:
        VALUE(uint32_t, ck10_reg_output_7_function_decode, ck10_reg_output_7_function_encode, 4u, 4u);
        break;
    case 125:
        VALUE(uint32_t, ck10_reg_output_8_function_decode, ck10_reg_output_8_function_encode, 4u, 4u);
        break;
    case 126:
        VALUE(uint32_t, ck10_reg_output_9_function_decode, ck10_reg_output_9_function_encode, 4u, 4u);
        break;
    case 127:
        VALUE(uint32_t, ck10_reg_output_10_function_decode, ck10_reg_output_10_function_encode, 4u, 4u);
        break;
    case 128:
        VALUE(ck10_polarity, ck10_reg_input_1_polarity_decode, ck10_reg_input_1_polarity_encode, 4u, 4u);
        break;
    case 129:
        VALUE(ck10_polarity, ck10_reg_input_2_polarity_decode, ck10_reg_input_2_polarity_encode, 4u, 4u);
        break;
    case 130:
        VALUE(ck10_polarity, ck10_reg_input_3_polarity_decode, ck10_reg_input_3_polarity_encode, 4u, 4u);
        break;
    case 131:
        VALUE(ck10_polarity, ck10_reg_input_4_polarity_decode, ck10_reg_input_4_polarity_encode, 4u, 4u);
        break;
    case 132:
        VALUE(ck10_polarity, ck10_reg_input_5_polarity_decode, ck10_reg_input_5_polarity_encode, 4u, 4u);
        break;
    case 133:
        VALUE(ck10_polarity, ck10_reg_input_6_polarity_decode, ck10_reg_input_6_polarity_encode, 4u, 4u);
        break;
    case 134:
        VALUE(ck10_polarity, ck10_reg_input_7_polarity_decode, ck10_reg_input_7_polarity_encode, 4u, 4u);
        break;
    case 135:
        VALUE(ck10_polarity, ck10_reg_input_8_polarity_decode, ck10_reg_input_8_polarity_encode, 4u, 4u);
        break;
    case 136:
        VALUE(ck10_polarity, ck10_reg_input_9_polarity_decode, ck10_reg_input_9_polarity_encode, 4u, 4u);
        break;
    case 137:
        VALUE(ck10_polarity, ck10_reg_input_10_polarity_decode, ck10_reg_input_10_polarity_encode, 4u, 4u);
        break;
    case 138:
        VALUE(ck10_polarity, ck10_reg_input_11_polarity_decode, ck10_reg_input_11_polarity_encode, 4u, 4u);
        break;
    case 139:
        VALUE(ck10_polarity, ck10_reg_input_12_polarity_decode, ck10_reg_input_12_polarity_encode, 4u, 4u);
        break;
    case 140:
        VALUE(ck10_polarity, ck10_reg_output_1_polarity_decode, ck10_reg_output_1_polarity_encode, 4u, 4u);
        break;
    case 141:
        VALUE(ck10_polarity, ck10_reg_output_2_polarity_decode, ck10_reg_output_2_polarity_encode, 4u, 4u);
        break;
    case 142:
        VALUE(ck10_polarity, ck10_reg_output_3_polarity_decode, ck10_reg_output_3_polarity_encode, 4u, 4u);
        break;
    case 143:
        VALUE(ck10_polarity, ck10_reg_output_4_polarity_decode, ck10_reg_output_4_polarity_encode, 4u, 4u);
        break;
    case 144:
        VALUE(ck10_polarity, ck10_reg_output_5_polarity_decode, ck10_reg_output_5_polarity_encode, 4u, 4u);
        break;
    case 145:
        VALUE(ck10_polarity, ck10_reg_output_6_polarity_decode, ck10_reg_output_6_polarity_encode, 4u, 4u);
        break;
    case 146:
        VALUE(ck10_polarity, ck10_reg_output_7_polarity_decode, ck10_reg_output_7_polarity_encode, 4u, 4u);
        break;
    case 147:
        VALUE(ck10_polarity, ck10_reg_output_8_polarity_decode, ck10_reg_output_8_polarity_encode, 4u, 4u);
        break;
    case 148:
        VALUE(ck10_polarity, ck10_reg_output_9_polarity_decode, ck10_reg_output_9_polarity_encode, 4u, 4u);
        break;
    case 149:
        VALUE(ck10_polarity, ck10_reg_output_10_polarity_decode, ck10_reg_output_10_polarity_encode, 4u, 4u);
        break;
    case 150:
        VALUE(uint32_t, ck10_reg_flash_resolution_decode, ck10_reg_flash_resolution_encode, 4u, 4u);
        break;
    case 151:
        VALUE(uint32_t, ck10_reg_flash_maximum_speed_decode, ck10_reg_flash_maximum_speed_encode, 4u, 4u);
        break;
    case 152:
        VALUE(uint32_t, ck10_reg_flash_start_speed_decode, ck10_reg_flash_start_speed_encode, 4u, 4u);
        break;
    case 153:
        VALUE(uint32_t, ck10_reg_flash_acceleration_time_decode, ck10_reg_flash_acceleration_time_encode, 4u, 4u);
        break;
    case 154:
        VALUE(uint32_t, ck10_reg_flash_deceleration_time_decode, ck10_reg_flash_deceleration_time_encode, 4u, 4u);
        break;
    case 155:
        VALUE(uint32_t, ck10_reg_flash_reserved_5_decode, ck10_reg_flash_reserved_5_encode, 4u, 4u);
        break;
    case 156:
        VALUE(uint32_t, ck10_reg_flash_jog_speed_decode, ck10_reg_flash_jog_speed_encode, 4u, 4u);
        break;
    case 157:
        VALUE(uint32_t, ck10_reg_flash_jog_start_speed_decode, ck10_reg_flash_jog_start_speed_encode, 4u, 4u);
        break;
    case 158:
        VALUE(uint32_t, ck10_reg_flash_jog_acceleration_time_decode, ck10_reg_flash_jog_acceleration_time_encode, 4u, 4u);
        break;
    case 159:
        VALUE(int32_t, ck10_reg_flash_positive_soft_limit_decode, ck10_reg_flash_positive_soft_limit_encode, 4u, 4u);
        break;
    case 160:
        VALUE(int32_t, ck10_reg_flash_negative_soft_limit_decode, ck10_reg_flash_negative_soft_limit_encode, 4u, 4u);
        break;
    case 161:
        VALUE(ck10_soft_limit_stop, ck10_reg_flash_soft_limit_stop_decode, ck10_reg_flash_soft_limit_stop_encode, 4u, 4u);
        break;
    case 162:
        VALUE(ck10_hard_limit_stop, ck10_reg_flash_hard_limit_stop_decode, ck10_reg_flash_hard_limit_stop_encode, 4u, 4u);
        break;
    case 163:
        VALUE(uint32_t, ck10_reg_flash_reserved_13_decode, ck10_reg_flash_reserved_13_encode, 4u, 4u);
        break;
    case 164:
        VALUE(uint32_t, ck10_reg_flash_homing_speed_decode, ck10_reg_flash_homing_speed_encode, 4u, 4u);
        break;
    case 165:
        VALUE(uint32_t, ck10_reg_flash_homing_search_speed_decode, ck10_reg_flash_homing_search_speed_encode, 4u, 4u);
        break;
    case 166:
        VALUE(uint32_t, ck10_reg_flash_homing_acceleration_time_decode, ck10_reg_flash_homing_acceleration_time_encode, 4u, 4u);
        break;
    case 167:
        VALUE(ck10_homing_method, ck10_reg_flash_homing_method_decode, ck10_reg_flash_homing_method_encode, 4u, 4u);
        break;
    case 168:
        VALUE(ck10_rotation, ck10_reg_flash_homing_direction_decode, ck10_reg_flash_homing_direction_encode, 4u, 4u);
        break;
    case 169:
        VALUE(int32_t, ck10_reg_flash_homing_offset_decode, ck10_reg_flash_homing_offset_encode, 4u, 4u);
        break;
    case 170:
        VALUE(int32_t, ck10_reg_flash_origin_position_decode, ck10_reg_flash_origin_position_encode, 4u, 4u);
        break;
    case 171:
        VALUE(uint32_t, ck10_reg_flash_reserved_21_decode, ck10_reg_flash_reserved_21_encode, 4u, 4u);
        break;
    case 172:
        VALUE(uint32_t, ck10_reg_flash_position_loop_gain_decode, ck10_reg_flash_position_loop_gain_encode, 4u, 4u);
        break;
    case 173:
        VALUE(uint32_t, ck10_reg_flash_in_position_range_decode, ck10_reg_flash_in_position_range_encode, 4u, 4u);
        break;
    case 174:
        VALUE(uint32_t, ck10_reg_flash_tracking_limit_decode, ck10_reg_flash_tracking_limit_encode, 4u, 4u);
        break;
    case 175:
        VALUE(ck10_rotation, ck10_reg_flash_motor_direction_decode, ck10_reg_flash_motor_direction_encode, 4u, 4u);
        break;
    case 176:
        VALUE(uint32_t, ck10_reg_flash_reserved_26_decode, ck10_reg_flash_reserved_26_encode, 4u, 4u);
        break;
    case 177:
        VALUE(uint32_t, ck10_reg_flash_homing_torque_ratio_decode, ck10_reg_flash_homing_torque_ratio_encode, 4u, 4u);
        break;
    case 178:
        VALUE(uint32_t, ck10_reg_flash_position_overflow_limit_decode, ck10_reg_flash_position_overflow_limit_encode, 4u, 4u);
        break;
    case 179:
        VALUE(uint32_t, ck10_reg_flash_reserved_29_decode, ck10_reg_flash_reserved_29_encode, 4u, 4u);
        break;
    case 180:
        VALUE(uint32_t, ck10_reg_flash_run_current_decode, ck10_reg_flash_run_current_encode, 4u, 4u);
        break;
    case 181:
        VALUE(uint32_t, ck10_reg_flash_boost_current_decode, ck10_reg_flash_boost_current_encode, 4u, 4u);
        break;
    case 182:
        VALUE(uint32_t, ck10_reg_flash_stop_current_decode, ck10_reg_flash_stop_current_encode, 4u, 4u);
        break;
    case 183:
        VALUE(ck10_emergency_stop_mode, ck10_reg_flash_emergency_stop_mode_decode, ck10_reg_flash_emergency_stop_mode_encode, 4u, 4u);
        break;
    case 184:
        VALUE(ck10_emergency_brake_mode, ck10_reg_flash_emergency_brake_mode_decode, ck10_reg_flash_emergency_brake_mode_encode, 4u, 4u);
        break;
    case 185:
        VALUE(ck10_operation_mode, ck10_reg_flash_operation_mode_decode, ck10_reg_flash_operation_mode_encode, 4u, 4u);
        break;
    case 186:
        VALUE(ck10_switch_function, ck10_reg_flash_switch_function_decode, ck10_reg_flash_switch_function_encode, 4u, 4u);
        break;
    case 187:
        VALUE(ck10_baud_rate, ck10_reg_flash_baud_rate_decode, ck10_reg_flash_baud_rate_encode, 4u, 4u);
        break;
    case 188:
        VALUE(ck10_enabled, ck10_reg_flash_save_position_decode, ck10_reg_flash_save_position_encode, 4u, 4u);
        break;
    case 189:
        VALUE(ck10_enabled, ck10_reg_flash_show_motor_number_decode, ck10_reg_flash_show_motor_number_encode, 4u, 4u);
        break;
    case 190:
        VALUE(uint32_t, ck10_reg_flash_assignment_flags_decode, ck10_reg_flash_assignment_flags_encode, 4u, 4u);
        break;
    case 191:
        VALUE(uint32_t, ck10_reg_flash_input_1_function_decode, ck10_reg_flash_input_1_function_encode, 4u, 4u);
        break;
    case 192:
        VALUE(uint32_t, ck10_reg_flash_input_2_function_decode, ck10_reg_flash_input_2_function_encode, 4u, 4u);
        break;
    case 193:
        VALUE(uint32_t, ck10_reg_flash_input_3_function_decode, ck10_reg_flash_input_3_function_encode, 4u, 4u);
        break;
    case 194:
        VALUE(uint32_t, ck10_reg_flash_input_4_function_decode, ck10_reg_flash_input_4_function_encode, 4u, 4u);
        break;
    case 195:
        VALUE(uint32_t, ck10_reg_flash_input_5_function_decode, ck10_reg_flash_input_5_function_encode, 4u, 4u);
        break;
    case 196:
        VALUE(uint32_t, ck10_reg_flash_input_6_function_decode, ck10_reg_flash_input_6_function_encode, 4u, 4u);
        break;
    case 197:
        VALUE(uint32_t, ck10_reg_flash_input_7_function_decode, ck10_reg_flash_input_7_function_encode, 4u, 4u);
        break;
    case 198:
        VALUE(uint32_t, ck10_reg_flash_input_8_function_decode, ck10_reg_flash_input_8_function_encode, 4u, 4u);
        break;
    case 199:
        VALUE(uint32_t, ck10_reg_flash_input_9_function_decode, ck10_reg_flash_input_9_function_encode, 4u, 4u);
        break;
    case 200:
        VALUE(uint32_t, ck10_reg_flash_input_10_function_decode, ck10_reg_flash_input_10_function_encode, 4u, 4u);
        break;
    case 201:
        VALUE(uint32_t, ck10_reg_flash_input_11_function_decode, ck10_reg_flash_input_11_function_encode, 4u, 4u);
        break;
    case 202:
        VALUE(uint32_t, ck10_reg_flash_input_12_function_decode, ck10_reg_flash_input_12_function_encode, 4u, 4u);
        break;
    case 203:
        VALUE(uint32_t, ck10_reg_flash_output_1_function_decode, ck10_reg_flash_output_1_function_encode, 4u, 4u);
        break;
    case 204:
        VALUE(uint32_t, ck10_reg_flash_output_2_function_decode, ck10_reg_flash_output_2_function_encode, 4u, 4u);
        break;
    case 205:
        VALUE(uint32_t, ck10_reg_flash_output_3_function_decode, ck10_reg_flash_output_3_function_encode, 4u, 4u);
        break;
    case 206:
        VALUE(uint32_t, ck10_reg_flash_output_4_function_decode, ck10_reg_flash_output_4_function_encode, 4u, 4u);
        break;
    case 207:
        VALUE(uint32_t, ck10_reg_flash_output_5_function_decode, ck10_reg_flash_output_5_function_encode, 4u, 4u);
        break;
    case 208:
        VALUE(uint32_t, ck10_reg_flash_output_6_function_decode, ck10_reg_flash_output_6_function_encode, 4u, 4u);
        break;
    case 209:
        VALUE(uint32_t, ck10_reg_flash_output_7_function_decode, ck10_reg_flash_output_7_function_encode, 4u, 4u);
        break;
    case 210:
        VALUE(uint32_t, ck10_reg_flash_output_8_function_decode, ck10_reg_flash_output_8_function_encode, 4u, 4u);
        break;
    case 211:
        VALUE(uint32_t, ck10_reg_flash_output_9_function_decode, ck10_reg_flash_output_9_function_encode, 4u, 4u);
        break;
    case 212:
        VALUE(uint32_t, ck10_reg_flash_output_10_function_decode, ck10_reg_flash_output_10_function_encode, 4u, 4u);
        break;
    case 213:
        VALUE(ck10_polarity, ck10_reg_flash_input_1_polarity_decode, ck10_reg_flash_input_1_polarity_encode, 4u, 4u);
        break;
    case 214:
        VALUE(ck10_polarity, ck10_reg_flash_input_2_polarity_decode, ck10_reg_flash_input_2_polarity_encode, 4u, 4u);
        break;
    case 215:
        VALUE(ck10_polarity, ck10_reg_flash_input_3_polarity_decode, ck10_reg_flash_input_3_polarity_encode, 4u, 4u);
        break;
    case 216:
        VALUE(ck10_polarity, ck10_reg_flash_input_4_polarity_decode, ck10_reg_flash_input_4_polarity_encode, 4u, 4u);
        break;
    case 217:
        VALUE(ck10_polarity, ck10_reg_flash_input_5_polarity_decode, ck10_reg_flash_input_5_polarity_encode, 4u, 4u);
        break;
    case 218:
        VALUE(ck10_polarity, ck10_reg_flash_input_6_polarity_decode, ck10_reg_flash_input_6_polarity_encode, 4u, 4u);
        break;
    case 219:
        VALUE(ck10_polarity, ck10_reg_flash_input_7_polarity_decode, ck10_reg_flash_input_7_polarity_encode, 4u, 4u);
        break;
    case 220:
        VALUE(ck10_polarity, ck10_reg_flash_input_8_polarity_decode, ck10_reg_flash_input_8_polarity_encode, 4u, 4u);
        break;
    case 221:
        VALUE(ck10_polarity, ck10_reg_flash_input_9_polarity_decode, ck10_reg_flash_input_9_polarity_encode, 4u, 4u);
        break;
    case 222:
        VALUE(ck10_polarity, ck10_reg_flash_input_10_polarity_decode, ck10_reg_flash_input_10_polarity_encode, 4u, 4u);
        break;
    case 223:
        VALUE(ck10_polarity, ck10_reg_flash_input_11_polarity_decode, ck10_reg_flash_input_11_polarity_encode, 4u, 4u);
        break;
    case 224:
        VALUE(ck10_polarity, ck10_reg_flash_input_12_polarity_decode, ck10_reg_flash_input_12_polarity_encode, 4u, 4u);
        break;
    case 225:
        VALUE(ck10_polarity, ck10_reg_flash_output_1_polarity_decode, ck10_reg_flash_output_1_polarity_encode, 4u, 4u);
        break;
    case 226:
        VALUE(ck10_polarity, ck10_reg_flash_output_2_polarity_decode, ck10_reg_flash_output_2_polarity_encode, 4u, 4u);
        break;
    case 227:
        VALUE(ck10_polarity, ck10_reg_flash_output_3_polarity_decode, ck10_reg_flash_output_3_polarity_encode, 4u, 4u);
        break;
    case 228:
        VALUE(ck10_polarity, ck10_reg_flash_output_4_polarity_decode, ck10_reg_flash_output_4_polarity_encode, 4u, 4u);
        break;
    case 229:
        VALUE(ck10_polarity, ck10_reg_flash_output_5_polarity_decode, ck10_reg_flash_output_5_polarity_encode, 4u, 4u);
        break;
    case 230:
        VALUE(ck10_polarity, ck10_reg_flash_output_6_polarity_decode, ck10_reg_flash_output_6_polarity_encode, 4u, 4u);
        break;
    case 231:
        VALUE(ck10_polarity, ck10_reg_flash_output_7_polarity_decode, ck10_reg_flash_output_7_polarity_encode, 4u, 4u);
        break;
    case 232:
        VALUE(ck10_polarity, ck10_reg_flash_output_8_polarity_decode, ck10_reg_flash_output_8_polarity_encode, 4u, 4u);
        break;
    case 233:
        VALUE(ck10_polarity, ck10_reg_flash_output_9_polarity_decode, ck10_reg_flash_output_9_polarity_encode, 4u, 4u);
        break;
    case 234:
        VALUE(ck10_polarity, ck10_reg_flash_output_10_polarity_decode, ck10_reg_flash_output_10_polarity_encode, 4u, 4u);
        break;
    case 235:
        VALUE(uint32_t, ck10_reg_motion_status_decode, ck10_reg_motion_status_encode, 4u, 4u);
        break;
    case 236:
        VALUE(int32_t, ck10_reg_actual_position_decode, ck10_reg_actual_position_encode, 4u, 4u);
        break;
    case 237:
        VALUE(int32_t, ck10_reg_command_position_decode, ck10_reg_command_position_encode, 4u, 4u);
        break;
    case 238:
        VALUE(int32_t, ck10_reg_speed_decode, ck10_reg_speed_encode, 4u, 4u);
        break;
    case 239:
        VALUE(int32_t, ck10_reg_position_error_decode, ck10_reg_position_error_encode, 4u, 4u);
        break;
    case 240:
        VALUE(uint32_t, ck10_reg_inputs_decode, ck10_reg_inputs_encode, 4u, 4u);
        break;
    case 241:
        VALUE(uint32_t, ck10_reg_outputs_decode, ck10_reg_outputs_encode, 4u, 4u);
        break;
    case 242:
        VALUE(uint16_t, ck10_reg_current_point_decode, ck10_reg_current_point_encode, 2u, 2u);
        break;
    case 243:
        VALUE(bool, ck10_reg_point_table_running_decode, ck10_reg_point_table_running_encode, 2u, 2u);
        break;
    case 244:
        VALUE(ck10_push_status, ck10_reg_push_status_decode, ck10_reg_push_status_encode, 2u, 2u);
        break;
    case 245:
        VALUE(uint16_t, ck10_reg_current_alarm_decode, ck10_reg_current_alarm_encode, 2u, 2u);
        break;
    case 246:
        VALUE(uint16_t, ck10_reg_motor_id_decode, ck10_reg_motor_id_encode, 2u, 2u);
        break;
    case 247:
        VALUE(uint16_t, ck10_reg_user_inputs_decode, ck10_reg_user_inputs_encode, 2u, 2u);
        break;
    case 248:
        VALUE(bool, ck10_reg_user_input_0_decode, ck10_reg_user_input_0_encode, 2u, 2u);
        break;
    case 249:
        VALUE(bool, ck10_reg_user_input_1_decode, ck10_reg_user_input_1_encode, 2u, 2u);
        break;
    case 250:
        VALUE(bool, ck10_reg_user_input_2_decode, ck10_reg_user_input_2_encode, 2u, 2u);
        break;
    case 251:
        VALUE(bool, ck10_reg_user_input_3_decode, ck10_reg_user_input_3_encode, 2u, 2u);
        break;
    case 252:
        VALUE(bool, ck10_reg_user_input_4_decode, ck10_reg_user_input_4_encode, 2u, 2u);
        break;
    case 253:
        VALUE(bool, ck10_reg_user_input_5_decode, ck10_reg_user_input_5_encode, 2u, 2u);
        break;
    case 254:
        VALUE(bool, ck10_reg_user_input_6_decode, ck10_reg_user_input_6_encode, 2u, 2u);
        break;
    case 255:
        VALUE(bool, ck10_reg_user_input_7_decode, ck10_reg_user_input_7_encode, 2u, 2u);
        break;
    case 256:
        VALUE(bool, ck10_reg_user_input_8_decode, ck10_reg_user_input_8_encode, 2u, 2u);
        break;
    case 257:
        VALUE(uint16_t, ck10_reg_user_outputs_decode, ck10_reg_user_outputs_encode, 2u, 2u);
        break;
    case 258:
        VALUE(uint16_t, ck10_reg_user_output_0_decode, ck10_reg_user_output_0_encode, 2u, 2u);
        break;
    case 259:
        VALUE(uint16_t, ck10_reg_user_output_1_decode, ck10_reg_user_output_1_encode, 2u, 2u);
        break;
    case 260:
        VALUE(uint16_t, ck10_reg_user_output_2_decode, ck10_reg_user_output_2_encode, 2u, 2u);
        break;
    case 261:
        VALUE(uint16_t, ck10_reg_user_output_3_decode, ck10_reg_user_output_3_encode, 2u, 2u);
        break;
    case 262:
        VALUE(uint16_t, ck10_reg_user_output_4_decode, ck10_reg_user_output_4_encode, 2u, 2u);
        break;
    case 263:
        VALUE(uint16_t, ck10_reg_user_output_5_decode, ck10_reg_user_output_5_encode, 2u, 2u);
        break;
    case 264:
        VALUE(uint16_t, ck10_reg_user_output_6_decode, ck10_reg_user_output_6_encode, 2u, 2u);
        break;
    case 265:
        VALUE(uint16_t, ck10_reg_user_output_7_decode, ck10_reg_user_output_7_encode, 2u, 2u);
        break;
    case 266:
        VALUE(uint16_t, ck10_reg_user_output_8_decode, ck10_reg_user_output_8_encode, 2u, 2u);
        break;
    case 267:
        CONSTANT(uint16_t, ck10_reg_clear_alarm_history_decode, ck10_reg_clear_alarm_history_encode, 2u);
        break;
    case 268:
        VALUE(uint16_t, ck10_reg_alarm_history_decode, ck10_reg_alarm_history_encode, 2u, 2u);
        break;
    case 269:
        ADDRESS(uint16_t, ck10_table_points_at);
        break;
    case 270:
        ADDRESS(uint16_t, ck10_table_flash_points_at);
        break;
    default:
        break;
    }
    return 0;
}
