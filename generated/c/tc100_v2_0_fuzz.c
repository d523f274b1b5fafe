/*
 * Fuzzes tc100_v2_0.h: TC100, version 2.0
 * Identity: 8f5fd7b11e77b14b
 *
 * Generated; do not edit. For libFuzzer, and for AFL++ by afl-clang-fast:
 *
 *     clang -g -O1 -fsanitize=fuzzer,address,undefined,float-cast-overflow tc100_v2_0_fuzz.c && ./a.out
 *
 * The first two bytes of an input select a function, the others are its input. The target stops
 * - when a function reads or writes out of bounds, which the sanitizers detect;
 * - when encoding what was decoded gives other bytes, apart from reserved ones and those after the end of a text;
 * - when opening a frame that was closed gives another body, or closing a frame that was opened gives other bytes.
 */
#include "tc100_v2_0.h"

#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { LARGEST = 1024, CHOICES = 129 };

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
        if (decode(data, size, &value) != TC100_OK) { \
            break; \
        } \
        if (encode(&value, out, sizeof out, &length) == TC100_ERR_OUT_OF_RANGE) { \
            break; \
        } \
        hold(encode(&value, out, sizeof out, &length) == TC100_OK && length == size); \
        hold(!(exact) || memcmp(out, data, size) == 0); \
        hold(decode(out, length, &second) == TC100_OK); \
        hold(encode(&second, again, sizeof again, &length) == TC100_OK && length == size); \
        hold(memcmp(out, again, size) == 0); \
        room = (uint8_t *)malloc(size); \
        if (room != NULL && size > 0) { \
            hold(encode(&value, room, size, &length) == TC100_OK && memcmp(room, out, size) == 0); \
            hold(encode(&value, room, size - 1, &beyond) == TC100_ERR_CAPACITY); \
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

/* The value of a register or a parameter. */
#define VALUE(type, decode, encode, held, length) \
    do { \
        type value; \
        uint8_t out[length] = {0}; \
        if (size < (length) || decode(data, &value) != TC100_OK || encode(value, out) == TC100_ERR_OUT_OF_RANGE) { \
            break; \
        } \
        hold(encode(value, out) == TC100_OK && memcmp(out, data, held) == 0); \
    } while (0)

/* The text or the bytes of a register or a parameter. A text ends at its first zero. */
#define ARRAY(declared, decode, encode, exact, length) \
    do { \
        declared, second[sizeof value]; \
        uint8_t out[length] = {0}, again[length] = {0}; \
        if (size < (length) || decode(data, value) != TC100_OK) { \
            break; \
        } \
        hold(encode(value, out) == TC100_OK && (!(exact) || memcmp(out, data, sizeof out) == 0)); \
        hold(decode(out, second) == TC100_OK && encode(second, again) == TC100_OK && memcmp(out, again, sizeof out) == 0); \
    } while (0)

/* A constant: what is encoded can be decoded, and so can anything else that the device answers. */
#define CONSTANT(type, decode, encode, length) \
    do { \
        type value; \
        uint8_t out[length] = {0}; \
        hold(encode(out) == TC100_OK && decode(out, &value) == TC100_OK); \
        hold(size < (length) || decode(data, &value) != TC100_ERR_WRONG_CONST); \
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
        hold(decode(data, &value) == TC100_OK); \
        if ((type)(argument)value == value) { \
            hold(encode((argument)value, out) != TC100_OK || memcmp(out, data, held) == 0); \
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
        if (at(first, &one) == TC100_OK && at(second, &other) == TC100_OK) { \
            hold((first == second) == (one == other)); \
        } \
    } while (0)

static void frame_0(const uint8_t *data, size_t size)
{
    static uint8_t out[4 * LARGEST];
    tc100_rtu_request_frame opened;
    size_t length = 0;
    memset(&opened, 0, sizeof opened);
    if (tc100_rtu_request_open(data, size, &opened) != TC100_OK) {
        return;
    }
    hold(opened.body >= data && opened.body + opened.body_length <= data + size);
    memcpy(out + 2, opened.body, opened.body_length);
    if (tc100_rtu_request_close(opened.unit_address, opened.code, opened.body_length, out, sizeof out, &length) == TC100_OK) {
        hold(length == size && memcmp(out, data, size) == 0);
    }
}

static void frame_1(const uint8_t *data, size_t size)
{
    enum { GIVEN = 2 };
    static uint8_t out[4 * LARGEST];
    tc100_rtu_request_frame opened;
    size_t length = 0;
    tc100_codec_status status;
    memset(&opened, 0, sizeof opened);
    if (size < GIVEN) {
        return;
    }
    memcpy(out + 2, data + GIVEN, size - GIVEN);
    if (tc100_rtu_request_close(data[0], data[1], size - GIVEN, out, sizeof out, &length) != TC100_OK) {
        return;
    }
    status = tc100_rtu_request_open(out, length, &opened);
    if (status == TC100_ERR_UNKNOWN_CODE) {
        return;
    }
    hold(status == TC100_OK);
    hold(opened.unit_address == data[0]);
    hold(opened.code == data[1]);
    hold(opened.body_length == size - GIVEN);
    hold(opened.body != NULL && memcmp(opened.body, data + GIVEN, size - GIVEN) == 0);
}

static void frame_2(const uint8_t *data, size_t size)
{
    static uint8_t out[4 * LARGEST];
    tc100_rtu_response_frame opened;
    size_t length = 0;
    memset(&opened, 0, sizeof opened);
    if (tc100_rtu_response_open(data, size, &opened) != TC100_OK) {
        return;
    }
    hold(opened.body >= data && opened.body + opened.body_length <= data + size);
    memcpy(out + 2, opened.body, opened.body_length);
    if (tc100_rtu_response_close(opened.unit_address, opened.code | (opened.error ? 128u : 0u), opened.body_length, out, sizeof out, &length) == TC100_OK) {
        hold(length == size && memcmp(out, data, size) == 0);
    }
}

static void frame_3(const uint8_t *data, size_t size)
{
    enum { GIVEN = 2 };
    static uint8_t out[4 * LARGEST];
    tc100_rtu_response_frame opened;
    size_t length = 0;
    tc100_codec_status status;
    memset(&opened, 0, sizeof opened);
    if (size < GIVEN) {
        return;
    }
    memcpy(out + 2, data + GIVEN, size - GIVEN);
    if (tc100_rtu_response_close(data[0], data[1], size - GIVEN, out, sizeof out, &length) != TC100_OK) {
        return;
    }
    status = tc100_rtu_response_open(out, length, &opened);
    if (status == TC100_ERR_UNKNOWN_CODE) {
        return;
    }
    hold(status == TC100_OK);
    hold(opened.unit_address == data[0]);
    hold(opened.code == (data[1] & 127u));
    hold(opened.body_length == size - GIVEN);
    hold(opened.body != NULL && memcmp(opened.body, data + GIVEN, size - GIVEN) == 0);
}

static void frame_4(const uint8_t *data, size_t size)
{
    static uint8_t buffer[2 * LARGEST];
    static uint8_t out[4 * LARGEST];
    tc100_ascii_request_frame opened;
    size_t length = 0;
    memset(&opened, 0, sizeof opened);
    if (tc100_ascii_request_open(data, size, buffer, sizeof buffer, &opened) != TC100_OK) {
        return;
    }
    hold(opened.body >= buffer && opened.body + opened.body_length <= buffer + sizeof buffer);
    memcpy(out + 2, opened.body, opened.body_length);
    if (tc100_ascii_request_close(opened.unit_address, opened.code, opened.body_length, out, sizeof out, &length) == TC100_OK) {
        hold(length == size);
    }
}

static void frame_5(const uint8_t *data, size_t size)
{
    enum { GIVEN = 2 };
    static uint8_t buffer[2 * LARGEST];
    static uint8_t out[4 * LARGEST];
    tc100_ascii_request_frame opened;
    size_t length = 0;
    tc100_codec_status status;
    memset(&opened, 0, sizeof opened);
    if (size < GIVEN) {
        return;
    }
    memcpy(out + 2, data + GIVEN, size - GIVEN);
    if (tc100_ascii_request_close(data[0], data[1], size - GIVEN, out, sizeof out, &length) != TC100_OK) {
        return;
    }
    status = tc100_ascii_request_open(out, length, buffer, sizeof buffer, &opened);
    if (status == TC100_ERR_UNKNOWN_CODE) {
        return;
    }
    hold(status == TC100_OK);
    hold(opened.unit_address == data[0]);
    hold(opened.code == data[1]);
    hold(opened.body_length == size - GIVEN);
    hold(opened.body != NULL && memcmp(opened.body, data + GIVEN, size - GIVEN) == 0);
}

static void frame_6(const uint8_t *data, size_t size)
{
    static uint8_t buffer[2 * LARGEST];
    static uint8_t out[4 * LARGEST];
    tc100_ascii_response_frame opened;
    size_t length = 0;
    memset(&opened, 0, sizeof opened);
    if (tc100_ascii_response_open(data, size, buffer, sizeof buffer, &opened) != TC100_OK) {
        return;
    }
    hold(opened.body >= buffer && opened.body + opened.body_length <= buffer + sizeof buffer);
    memcpy(out + 2, opened.body, opened.body_length);
    if (tc100_ascii_response_close(opened.unit_address, opened.code | (opened.error ? 128u : 0u), opened.body_length, out, sizeof out, &length) == TC100_OK) {
        hold(length == size);
    }
}

static void frame_7(const uint8_t *data, size_t size)
{
    enum { GIVEN = 2 };
    static uint8_t buffer[2 * LARGEST];
    static uint8_t out[4 * LARGEST];
    tc100_ascii_response_frame opened;
    size_t length = 0;
    tc100_codec_status status;
    memset(&opened, 0, sizeof opened);
    if (size < GIVEN) {
        return;
    }
    memcpy(out + 2, data + GIVEN, size - GIVEN);
    if (tc100_ascii_response_close(data[0], data[1], size - GIVEN, out, sizeof out, &length) != TC100_OK) {
        return;
    }
    status = tc100_ascii_response_open(out, length, buffer, sizeof buffer, &opened);
    if (status == TC100_ERR_UNKNOWN_CODE) {
        return;
    }
    hold(status == TC100_OK);
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
        RECORD(tc100_exception, tc100_exception_decode, tc100_exception_encode, TC100_EXCEPTION_SIZE, 1);
        break;
    case 9:
        PACKED(tc100_exception, tc100_exception_unpack, tc100_exception_pack, TC100_EXCEPTION_SIZE);
        break;
    case 10:
        RECORD(tc100_point, tc100_point_decode, tc100_point_encode, TC100_POINT_SIZE, 0);
        break;
    case 11:
        PACKED(tc100_point, tc100_point_unpack, tc100_point_pack, TC100_POINT_SIZE);
        break;
    case 12:
        RECORD(tc100_read_registers_request, tc100_read_registers_request_decode, tc100_read_registers_request_encode, TC100_READ_REGISTERS_REQUEST_SIZE, 1);
        break;
    case 13:
        PACKED(tc100_read_registers_request, tc100_read_registers_request_unpack, tc100_read_registers_request_pack, TC100_READ_REGISTERS_REQUEST_SIZE);
        break;
    case 14:
        RECORD(tc100_read_registers_response, tc100_read_registers_response_decode, tc100_read_registers_response_encode, TC100_READ_REGISTERS_RESPONSE_SIZE, 1);
        break;
    case 15:
        RECORD(tc100_write_register_request, tc100_write_register_request_decode, tc100_write_register_request_encode, TC100_WRITE_REGISTER_REQUEST_SIZE, 1);
        break;
    case 16:
        PACKED(tc100_write_register_request, tc100_write_register_request_unpack, tc100_write_register_request_pack, TC100_WRITE_REGISTER_REQUEST_SIZE);
        break;
    case 17:
        RECORD(tc100_write_register_response, tc100_write_register_response_decode, tc100_write_register_response_encode, TC100_WRITE_REGISTER_RESPONSE_SIZE, 1);
        break;
    case 18:
        PACKED(tc100_write_register_response, tc100_write_register_response_unpack, tc100_write_register_response_pack, TC100_WRITE_REGISTER_RESPONSE_SIZE);
        break;
    case 19:
        RECORD(tc100_write_registers_request, tc100_write_registers_request_decode, tc100_write_registers_request_encode, TC100_WRITE_REGISTERS_REQUEST_SIZE, 1);
        break;
    case 20:
        RECORD(tc100_write_registers_response, tc100_write_registers_response_decode, tc100_write_registers_response_encode, TC100_WRITE_REGISTERS_RESPONSE_SIZE, 1);
        break;
    case 21:
        PACKED(tc100_write_registers_response, tc100_write_registers_response_unpack, tc100_write_registers_response_pack, TC100_WRITE_REGISTERS_RESPONSE_SIZE);
        break;
    case 22:
        VALUE(uint16_t, tc100_reg_jog_positive_input_decode, tc100_reg_jog_positive_input_encode, 2u, 2u);
        break;
    case 23:
        VALUE(uint16_t, tc100_reg_jog_negative_input_decode, tc100_reg_jog_negative_input_encode, 2u, 2u);
        break;
    case 24:
        VALUE(uint16_t, tc100_reg_manual_mode_input_decode, tc100_reg_manual_mode_input_encode, 2u, 2u);
        break;
    case 25:
        VALUE(uint16_t, tc100_reg_teach_input_decode, tc100_reg_teach_input_encode, 2u, 2u);
        break;
    case 26:
        VALUE(uint16_t, tc100_reg_lock_input_decode, tc100_reg_lock_input_encode, 2u, 2u);
        break;
    case 27:
        VALUE(uint16_t, tc100_reg_point_select_bit_4_input_decode, tc100_reg_point_select_bit_4_input_encode, 2u, 2u);
        break;
    case 28:
        VALUE(uint16_t, tc100_reg_point_select_bit_5_input_decode, tc100_reg_point_select_bit_5_input_encode, 2u, 2u);
        break;
    case 29:
        VALUE(uint16_t, tc100_reg_point_select_bit_6_input_decode, tc100_reg_point_select_bit_6_input_encode, 2u, 2u);
        break;
    case 30:
        VALUE(uint16_t, tc100_reg_homing_sensor_input_decode, tc100_reg_homing_sensor_input_encode, 2u, 2u);
        break;
    case 31:
        VALUE(uint16_t, tc100_reg_brake_input_decode, tc100_reg_brake_input_encode, 2u, 2u);
        break;
    case 32:
        VALUE(uint16_t, tc100_reg_full_count_input_decode, tc100_reg_full_count_input_encode, 2u, 2u);
        break;
    case 33:
        VALUE(uint16_t, tc100_reg_in_position_output_decode, tc100_reg_in_position_output_encode, 2u, 2u);
        break;
    case 34:
        VALUE(uint16_t, tc100_reg_alarm_output_decode, tc100_reg_alarm_output_encode, 2u, 2u);
        break;
    case 35:
        VALUE(uint16_t, tc100_reg_ready_output_decode, tc100_reg_ready_output_encode, 2u, 2u);
        break;
    case 36:
        VALUE(uint16_t, tc100_reg_moving_output_decode, tc100_reg_moving_output_encode, 2u, 2u);
        break;
    case 37:
        VALUE(uint16_t, tc100_reg_servo_on_output_decode, tc100_reg_servo_on_output_encode, 2u, 2u);
        break;
    case 38:
        VALUE(uint16_t, tc100_reg_point_select_bit_0_output_decode, tc100_reg_point_select_bit_0_output_encode, 2u, 2u);
        break;
    case 39:
        VALUE(uint16_t, tc100_reg_point_select_bit_1_output_decode, tc100_reg_point_select_bit_1_output_encode, 2u, 2u);
        break;
    case 40:
        VALUE(uint16_t, tc100_reg_point_select_bit_2_output_decode, tc100_reg_point_select_bit_2_output_encode, 2u, 2u);
        break;
    case 41:
        VALUE(uint16_t, tc100_reg_point_select_bit_3_output_decode, tc100_reg_point_select_bit_3_output_encode, 2u, 2u);
        break;
    case 42:
        VALUE(uint16_t, tc100_reg_point_select_bit_4_output_decode, tc100_reg_point_select_bit_4_output_encode, 2u, 2u);
        break;
    case 43:
        VALUE(uint16_t, tc100_reg_point_select_bit_5_output_decode, tc100_reg_point_select_bit_5_output_encode, 2u, 2u);
        break;
    case 44:
        VALUE(uint16_t, tc100_reg_point_select_bit_6_output_decode, tc100_reg_point_select_bit_6_output_encode, 2u, 2u);
        break;
    case 45:
        VALUE(uint16_t, tc100_reg_torque_limit_output_decode, tc100_reg_torque_limit_output_encode, 2u, 2u);
        break;
    case 46:
        VALUE(uint16_t, tc100_reg_error_bit_0_output_decode, tc100_reg_error_bit_0_output_encode, 2u, 2u);
        break;
    case 47:
        VALUE(uint16_t, tc100_reg_error_bit_1_output_decode, tc100_reg_error_bit_1_output_encode, 2u, 2u);
        break;
    case 48:
        VALUE(uint16_t, tc100_reg_error_bit_2_output_decode, tc100_reg_error_bit_2_output_encode, 2u, 2u);
        break;
    case 49:
        VALUE(uint16_t, tc100_reg_error_bit_3_output_decode, tc100_reg_error_bit_3_output_encode, 2u, 2u);
        break;
    case 50:
        VALUE(uint16_t, tc100_reg_zone_output_decode, tc100_reg_zone_output_encode, 2u, 2u);
        break;
    case 51:
        VALUE(uint16_t, tc100_reg_near_output_decode, tc100_reg_near_output_encode, 2u, 2u);
        break;
    case 52:
        VALUE(uint16_t, tc100_reg_soft_limit_output_decode, tc100_reg_soft_limit_output_encode, 2u, 2u);
        break;
    case 53:
        VALUE(int32_t, tc100_reg_relative_distance_decode, tc100_reg_relative_distance_encode, 4u, 4u);
        break;
    case 54:
        VALUE(int32_t, tc100_reg_absolute_position_decode, tc100_reg_absolute_position_encode, 4u, 4u);
        break;
    case 55:
        VALUE(tc100_torque_search_direction, tc100_reg_torque_search_direction_decode, tc100_reg_torque_search_direction_encode, 2u, 2u);
        break;
    case 56:
        VALUE(int32_t, tc100_reg_preset_position_decode, tc100_reg_preset_position_encode, 4u, 4u);
        break;
    case 57:
        VALUE(tc100_servo_command, tc100_reg_servo_decode, tc100_reg_servo_encode, 2u, 2u);
        break;
    case 58:
        VALUE(uint16_t, tc100_reg_motion_speed_decode, tc100_reg_motion_speed_encode, 2u, 2u);
        break;
    case 59:
        TRIGGER(uint16_t, tc100_motion_command, tc100_reg_motion_command_decode, tc100_reg_motion_command_encode, 2u, 2u);
        break;
    case 60:
        VALUE(uint16_t, tc100_reg_simulated_inputs_decode, tc100_reg_simulated_inputs_encode, 2u, 2u);
        break;
    case 61:
        VALUE(bool, tc100_reg_simulated_input_decode, tc100_reg_simulated_input_encode, 2u, 2u);
        break;
    case 62:
        TRIGGER(uint16_t, tc100_parameter_storage, tc100_reg_parameter_storage_decode, tc100_reg_parameter_storage_encode, 2u, 2u);
        break;
    case 63:
        CONSTANT(uint64_t, tc100_reg_write_enable_key_decode, tc100_reg_write_enable_key_encode, 8u);
        break;
    case 64:
        VALUE(uint32_t, tc100_reg_full_count_limit_decode, tc100_reg_full_count_limit_encode, 4u, 4u);
        break;
    case 65:
        VALUE(uint16_t, tc100_reg_in_position_zone_decode, tc100_reg_in_position_zone_encode, 2u, 2u);
        break;
    case 66:
        VALUE(uint16_t, tc100_reg_electronic_gear_numerator_decode, tc100_reg_electronic_gear_numerator_encode, 2u, 2u);
        break;
    case 67:
        VALUE(uint16_t, tc100_reg_electronic_gear_denominator_decode, tc100_reg_electronic_gear_denominator_encode, 2u, 2u);
        break;
    case 68:
        VALUE(tc100_rotation_direction, tc100_reg_pulse_rotation_direction_decode, tc100_reg_pulse_rotation_direction_encode, 2u, 2u);
        break;
    case 69:
        VALUE(tc100_pulse_input_form, tc100_reg_pulse_input_form_decode, tc100_reg_pulse_input_form_encode, 2u, 2u);
        break;
    case 70:
        VALUE(uint16_t, tc100_reg_near_zone_decode, tc100_reg_near_zone_encode, 2u, 2u);
        break;
    case 71:
        VALUE(uint16_t, tc100_reg_push_torque_positive_decode, tc100_reg_push_torque_positive_encode, 2u, 2u);
        break;
    case 72:
        VALUE(uint16_t, tc100_reg_push_torque_negative_decode, tc100_reg_push_torque_negative_encode, 2u, 2u);
        break;
    case 73:
        VALUE(uint16_t, tc100_reg_torque_limit_time_decode, tc100_reg_torque_limit_time_encode, 2u, 2u);
        break;
    case 74:
        VALUE(bool, tc100_reg_position_correction_speed_limit_enabled_decode, tc100_reg_position_correction_speed_limit_enabled_encode, 2u, 2u);
        break;
    case 75:
        VALUE(uint16_t, tc100_reg_position_correction_speed_limit_decode, tc100_reg_position_correction_speed_limit_encode, 2u, 2u);
        break;
    case 76:
        VALUE(uint16_t, tc100_reg_maximum_torque_decode, tc100_reg_maximum_torque_encode, 2u, 2u);
        break;
    case 77:
        VALUE(uint16_t, tc100_reg_full_torque_time_decode, tc100_reg_full_torque_time_encode, 2u, 2u);
        break;
    case 78:
        VALUE(tc100_control_mode, tc100_reg_control_mode_decode, tc100_reg_control_mode_encode, 2u, 2u);
        break;
    case 79:
        VALUE(tc100_servo_command, tc100_reg_servo_at_power_on_decode, tc100_reg_servo_at_power_on_encode, 2u, 2u);
        break;
    case 80:
        VALUE(bool, tc100_reg_homing_required_decode, tc100_reg_homing_required_encode, 2u, 2u);
        break;
    case 81:
        VALUE(bool, tc100_reg_total_revolutions_enabled_decode, tc100_reg_total_revolutions_enabled_encode, 2u, 2u);
        break;
    case 82:
        VALUE(uint32_t, tc100_reg_start_speed_decode, tc100_reg_start_speed_encode, 4u, 4u);
        break;
    case 83:
        VALUE(uint32_t, tc100_reg_maximum_speed_decode, tc100_reg_maximum_speed_encode, 4u, 4u);
        break;
    case 84:
        VALUE(uint16_t, tc100_reg_acceleration_time_decode, tc100_reg_acceleration_time_encode, 2u, 2u);
        break;
    case 85:
        VALUE(uint16_t, tc100_reg_deceleration_time_decode, tc100_reg_deceleration_time_encode, 2u, 2u);
        break;
    case 86:
        VALUE(uint32_t, tc100_reg_torque_limit_press_distance_decode, tc100_reg_torque_limit_press_distance_encode, 4u, 4u);
        break;
    case 87:
        VALUE(tc100_moving_state_rule, tc100_reg_moving_state_rule_decode, tc100_reg_moving_state_rule_encode, 2u, 2u);
        break;
    case 88:
        VALUE(uint16_t, tc100_reg_jog_speed_decode, tc100_reg_jog_speed_encode, 2u, 2u);
        break;
    case 89:
        VALUE(uint32_t, tc100_reg_jog_distance_decode, tc100_reg_jog_distance_encode, 4u, 4u);
        break;
    case 90:
        VALUE(uint16_t, tc100_reg_jog_wait_time_decode, tc100_reg_jog_wait_time_encode, 2u, 2u);
        break;
    case 91:
        VALUE(int32_t, tc100_reg_soft_limit_positive_decode, tc100_reg_soft_limit_positive_encode, 4u, 4u);
        break;
    case 92:
        VALUE(int32_t, tc100_reg_soft_limit_negative_decode, tc100_reg_soft_limit_negative_encode, 4u, 4u);
        break;
    case 93:
        VALUE(tc100_homing_mode, tc100_reg_homing_mode_decode, tc100_reg_homing_mode_encode, 2u, 2u);
        break;
    case 94:
        VALUE(uint16_t, tc100_reg_homing_speed_decode, tc100_reg_homing_speed_encode, 2u, 2u);
        break;
    case 95:
        VALUE(int32_t, tc100_reg_homing_offset_decode, tc100_reg_homing_offset_encode, 4u, 4u);
        break;
    case 96:
        VALUE(uint16_t, tc100_reg_homing_offset_speed_decode, tc100_reg_homing_offset_speed_encode, 2u, 2u);
        break;
    case 97:
        VALUE(int32_t, tc100_reg_homing_position_decode, tc100_reg_homing_position_encode, 4u, 4u);
        break;
    case 98:
        VALUE(uint16_t, tc100_reg_homing_torque_limit_decode, tc100_reg_homing_torque_limit_encode, 2u, 2u);
        break;
    case 99:
        VALUE(int32_t, tc100_reg_homing_z_phase_offset_decode, tc100_reg_homing_z_phase_offset_encode, 4u, 4u);
        break;
    case 100:
        VALUE(uint16_t, tc100_reg_homing_torque_limit_time_decode, tc100_reg_homing_torque_limit_time_encode, 2u, 2u);
        break;
    case 101:
        VALUE(uint16_t, tc100_reg_homing_z_phase_speed_1_decode, tc100_reg_homing_z_phase_speed_1_encode, 2u, 2u);
        break;
    case 102:
        VALUE(uint16_t, tc100_reg_homing_z_phase_speed_2_decode, tc100_reg_homing_z_phase_speed_2_encode, 2u, 2u);
        break;
    case 103:
        VALUE(tc100_baud_rate, tc100_reg_baud_rate_decode, tc100_reg_baud_rate_encode, 2u, 2u);
        break;
    case 104:
        VALUE(tc100_data_bits, tc100_reg_data_bits_decode, tc100_reg_data_bits_encode, 2u, 2u);
        break;
    case 105:
        VALUE(tc100_parity, tc100_reg_parity_decode, tc100_reg_parity_encode, 2u, 2u);
        break;
    case 106:
        VALUE(bool, tc100_reg_broadcast_enabled_decode, tc100_reg_broadcast_enabled_encode, 2u, 2u);
        break;
    case 107:
        VALUE(tc100_protocol, tc100_reg_protocol_decode, tc100_reg_protocol_encode, 2u, 2u);
        break;
    case 108:
        VALUE(tc100_action_status, tc100_reg_action_status_decode, tc100_reg_action_status_encode, 2u, 2u);
        break;
    case 109:
        VALUE(bool, tc100_reg_in_position_decode, tc100_reg_in_position_encode, 2u, 2u);
        break;
    case 110:
        VALUE(bool, tc100_reg_torque_limit_reached_decode, tc100_reg_torque_limit_reached_encode, 2u, 2u);
        break;
    case 111:
        VALUE(uint16_t, tc100_reg_alarm_decode, tc100_reg_alarm_encode, 2u, 2u);
        break;
    case 112:
        VALUE(int16_t, tc100_reg_motor_speed_decode, tc100_reg_motor_speed_encode, 2u, 2u);
        break;
    case 113:
        VALUE(int16_t, tc100_reg_motor_current_decode, tc100_reg_motor_current_encode, 2u, 2u);
        break;
    case 114:
        VALUE(int32_t, tc100_reg_command_position_decode, tc100_reg_command_position_encode, 4u, 4u);
        break;
    case 115:
        VALUE(int32_t, tc100_reg_encoder_position_decode, tc100_reg_encoder_position_encode, 4u, 4u);
        break;
    case 116:
        VALUE(bool, tc100_reg_servo_on_decode, tc100_reg_servo_on_encode, 2u, 2u);
        break;
    case 117:
        VALUE(uint16_t, tc100_reg_fault_decode, tc100_reg_fault_encode, 2u, 2u);
        break;
    case 118:
        VALUE(int16_t, tc100_reg_executed_point_decode, tc100_reg_executed_point_encode, 2u, 2u);
        break;
    case 119:
        VALUE(uint16_t, tc100_reg_output_states_decode, tc100_reg_output_states_encode, 2u, 2u);
        break;
    case 120:
        VALUE(bool, tc100_reg_output_state_decode, tc100_reg_output_state_encode, 2u, 2u);
        break;
    case 121:
        VALUE(uint16_t, tc100_reg_input_states_decode, tc100_reg_input_states_encode, 2u, 2u);
        break;
    case 122:
        VALUE(bool, tc100_reg_input_state_decode, tc100_reg_input_state_encode, 2u, 2u);
        break;
    case 123:
        VALUE(bool, tc100_reg_z_phase_state_decode, tc100_reg_z_phase_state_encode, 2u, 2u);
        break;
    case 124:
        VALUE(uint16_t, tc100_reg_alarm_history_decode, tc100_reg_alarm_history_encode, 2u, 2u);
        break;
    case 125:
        ARRAY(char value[33], tc100_reg_motor_type_decode, tc100_reg_motor_type_encode, 0, 32u);
        break;
    case 126:
        ARRAY(char value[33], tc100_reg_controller_type_decode, tc100_reg_controller_type_encode, 0, 32u);
        break;
    case 127:
        VALUE(uint16_t, tc100_reg_firmware_version_decode, tc100_reg_firmware_version_encode, 2u, 2u);
        break;
    case 128:
        ADDRESS(uint16_t, tc100_table_points_at);
        break;
    default:
        break;
    }
    return 0;
}
