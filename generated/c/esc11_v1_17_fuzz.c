/*
 * Fuzzes esc11_v1_17.h: ESC11-B, version 1.17
 * Identity: 499facc7f5252c73
 *
 * Generated; do not edit. For libFuzzer, and for AFL++ by afl-clang-fast:
 *
 *     clang -g -O1 -fsanitize=fuzzer,address,undefined,float-cast-overflow esc11_v1_17_fuzz.c && ./a.out
 *
 * The first two bytes of an input select a function, the others are its input. The target stops
 * - when a function reads or writes out of bounds, which the sanitizers detect;
 * - when encoding what was decoded gives other bytes, apart from reserved ones and those after the end of a text;
 * - when opening a frame that was closed gives another body, or closing a frame that was opened gives other bytes.
 */
#include "esc11_v1_17.h"

#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { LARGEST = 1024, CHOICES = 137 };

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
        if (decode(data, size, &value) != ESC11_OK) { \
            break; \
        } \
        if (encode(&value, out, sizeof out, &length) == ESC11_ERR_OUT_OF_RANGE) { \
            break; \
        } \
        hold(encode(&value, out, sizeof out, &length) == ESC11_OK && length == size); \
        hold(!(exact) || memcmp(out, data, size) == 0); \
        hold(decode(out, length, &second) == ESC11_OK); \
        hold(encode(&second, again, sizeof again, &length) == ESC11_OK && length == size); \
        hold(memcmp(out, again, size) == 0); \
        room = (uint8_t *)malloc(size); \
        if (room != NULL && size > 0) { \
            hold(encode(&value, room, size, &length) == ESC11_OK && memcmp(room, out, size) == 0); \
            hold(encode(&value, room, size - 1, &beyond) == ESC11_ERR_CAPACITY); \
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
        if (decode(data, size) != ESC11_OK) { \
            break; \
        } \
        hold(encode(out, sizeof out, &length) == ESC11_OK && length == size); \
        hold(!(exact) || memcmp(out, data, size) == 0); \
    } while (0)

/* The value of a register or a parameter. */
#define VALUE(type, decode, encode, held, length) \
    do { \
        type value; \
        uint8_t out[length] = {0}; \
        if (size < (length) || decode(data, &value) != ESC11_OK || encode(value, out) == ESC11_ERR_OUT_OF_RANGE) { \
            break; \
        } \
        hold(encode(value, out) == ESC11_OK && memcmp(out, data, held) == 0); \
    } while (0)

static void frame_0(const uint8_t *data, size_t size)
{
    static uint8_t out[4 * LARGEST];
    esc11_serial_request_frame opened;
    size_t length = 0;
    memset(&opened, 0, sizeof opened);
    if (esc11_serial_request_open(data, size, &opened) != ESC11_OK) {
        return;
    }
    hold(opened.body >= data && opened.body + opened.body_length <= data + size);
    memcpy(out + 3, opened.body, opened.body_length);
    if (esc11_serial_request_close(opened.unit_address, opened.code, opened.body_length, out, sizeof out, &length) == ESC11_OK) {
        hold(length == size && memcmp(out, data, size) == 0);
    }
}

static void frame_1(const uint8_t *data, size_t size)
{
    enum { GIVEN = 2 };
    static uint8_t out[4 * LARGEST];
    esc11_serial_request_frame opened;
    size_t length = 0;
    esc11_codec_status status;
    memset(&opened, 0, sizeof opened);
    if (size < GIVEN) {
        return;
    }
    memcpy(out + 3, data + GIVEN, size - GIVEN);
    if (esc11_serial_request_close(data[0], data[1], size - GIVEN, out, sizeof out, &length) != ESC11_OK) {
        return;
    }
    status = esc11_serial_request_open(out, length, &opened);
    if (status == ESC11_ERR_UNKNOWN_CODE) {
        return;
    }
    hold(status == ESC11_OK);
    hold(opened.unit_address == data[0]);
    hold(opened.code == data[1]);
    hold(opened.body_length == size - GIVEN);
    hold(opened.body != NULL && memcmp(opened.body, data + GIVEN, size - GIVEN) == 0);
}

static void frame_2(const uint8_t *data, size_t size)
{
    static uint8_t out[4 * LARGEST];
    esc11_serial_response_frame opened;
    size_t length = 0;
    memset(&opened, 0, sizeof opened);
    if (esc11_serial_response_open(data, size, &opened) != ESC11_OK) {
        return;
    }
    hold(opened.body >= data && opened.body + opened.body_length <= data + size);
    memcpy(out + 3, opened.body, opened.body_length);
    if (esc11_serial_response_close(opened.unit_address, opened.status, opened.body_length, out, sizeof out, &length) == ESC11_OK) {
        hold(length == size && memcmp(out, data, size) == 0);
    }
}

static void frame_3(const uint8_t *data, size_t size)
{
    enum { GIVEN = 2 };
    static uint8_t out[4 * LARGEST];
    esc11_serial_response_frame opened;
    size_t length = 0;
    esc11_codec_status status;
    memset(&opened, 0, sizeof opened);
    if (size < GIVEN) {
        return;
    }
    memcpy(out + 3, data + GIVEN, size - GIVEN);
    if (esc11_serial_response_close(data[0], data[1], size - GIVEN, out, sizeof out, &length) != ESC11_OK) {
        return;
    }
    status = esc11_serial_response_open(out, length, &opened);
    hold(status == ESC11_OK);
    hold(opened.unit_address == data[0]);
    hold(opened.status == data[1]);
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
        RECORD(esc11_alarm_history_entry, esc11_alarm_history_entry_decode, esc11_alarm_history_entry_encode, ESC11_ALARM_HISTORY_ENTRY_SIZE, 1);
        break;
    case 5:
        PACKED(esc11_alarm_history_entry, esc11_alarm_history_entry_unpack, esc11_alarm_history_entry_pack, ESC11_ALARM_HISTORY_ENTRY_SIZE);
        break;
    case 6:
        RECORD(esc11_point, esc11_point_decode, esc11_point_encode, ESC11_POINT_SIZE, 1);
        break;
    case 7:
        PACKED(esc11_point, esc11_point_unpack, esc11_point_pack, ESC11_POINT_SIZE);
        break;
    case 8:
        RECORD(esc11_temporary_point, esc11_temporary_point_decode, esc11_temporary_point_encode, ESC11_TEMPORARY_POINT_SIZE, 1);
        break;
    case 9:
        PACKED(esc11_temporary_point, esc11_temporary_point_unpack, esc11_temporary_point_pack, ESC11_TEMPORARY_POINT_SIZE);
        break;
    case 10:
        RECORD(esc11_read_points_request, esc11_read_points_request_decode, esc11_read_points_request_encode, ESC11_READ_POINTS_REQUEST_SIZE, 1);
        break;
    case 11:
        PACKED(esc11_read_points_request, esc11_read_points_request_unpack, esc11_read_points_request_pack, ESC11_READ_POINTS_REQUEST_SIZE);
        break;
    case 12:
        RECORD(esc11_read_points_response, esc11_read_points_response_decode, esc11_read_points_response_encode, ESC11_READ_POINTS_RESPONSE_SIZE, 1);
        break;
    case 13:
        FIXED(esc11_read_parameters_request_decode, esc11_read_parameters_request_encode, ESC11_READ_PARAMETERS_REQUEST_SIZE, 1);
        break;
    case 14:
        RECORD(esc11_read_parameters_response, esc11_read_parameters_response_decode, esc11_read_parameters_response_encode, ESC11_READ_PARAMETERS_RESPONSE_SIZE, 1);
        break;
    case 15:
        PACKED(esc11_read_parameters_response, esc11_read_parameters_response_unpack, esc11_read_parameters_response_pack, ESC11_READ_PARAMETERS_RESPONSE_SIZE);
        break;
    case 16:
        FIXED(esc11_read_io_status_request_decode, esc11_read_io_status_request_encode, ESC11_READ_IO_STATUS_REQUEST_SIZE, 1);
        break;
    case 17:
        RECORD(esc11_read_io_status_response, esc11_read_io_status_response_decode, esc11_read_io_status_response_encode, ESC11_READ_IO_STATUS_RESPONSE_SIZE, 1);
        break;
    case 18:
        PACKED(esc11_read_io_status_response, esc11_read_io_status_response_unpack, esc11_read_io_status_response_pack, ESC11_READ_IO_STATUS_RESPONSE_SIZE);
        break;
    case 19:
        FIXED(esc11_read_alarm_history_request_decode, esc11_read_alarm_history_request_encode, ESC11_READ_ALARM_HISTORY_REQUEST_SIZE, 1);
        break;
    case 20:
        RECORD(esc11_read_alarm_history_response, esc11_read_alarm_history_response_decode, esc11_read_alarm_history_response_encode, ESC11_READ_ALARM_HISTORY_RESPONSE_SIZE, 1);
        break;
    case 21:
        RECORD(esc11_write_points_request, esc11_write_points_request_decode, esc11_write_points_request_encode, ESC11_WRITE_POINTS_REQUEST_SIZE, 1);
        break;
    case 22:
        FIXED(esc11_write_points_response_decode, esc11_write_points_response_encode, ESC11_WRITE_POINTS_RESPONSE_SIZE, 1);
        break;
    case 23:
        RECORD(esc11_write_parameters_request, esc11_write_parameters_request_decode, esc11_write_parameters_request_encode, ESC11_WRITE_PARAMETERS_REQUEST_SIZE, 1);
        break;
    case 24:
        PACKED(esc11_write_parameters_request, esc11_write_parameters_request_unpack, esc11_write_parameters_request_pack, ESC11_WRITE_PARAMETERS_REQUEST_SIZE);
        break;
    case 25:
        FIXED(esc11_write_parameters_response_decode, esc11_write_parameters_response_encode, ESC11_WRITE_PARAMETERS_RESPONSE_SIZE, 1);
        break;
    case 26:
        RECORD(esc11_write_parameter_request, esc11_write_parameter_request_decode, esc11_write_parameter_request_encode, ESC11_WRITE_PARAMETER_REQUEST_SIZE, 1);
        break;
    case 27:
        PACKED(esc11_write_parameter_request, esc11_write_parameter_request_unpack, esc11_write_parameter_request_pack, ESC11_WRITE_PARAMETER_REQUEST_SIZE);
        break;
    case 28:
        FIXED(esc11_write_parameter_response_decode, esc11_write_parameter_response_encode, ESC11_WRITE_PARAMETER_RESPONSE_SIZE, 1);
        break;
    case 29:
        RECORD(esc11_write_temporary_point_request, esc11_write_temporary_point_request_decode, esc11_write_temporary_point_request_encode, ESC11_WRITE_TEMPORARY_POINT_REQUEST_SIZE, 1);
        break;
    case 30:
        PACKED(esc11_write_temporary_point_request, esc11_write_temporary_point_request_unpack, esc11_write_temporary_point_request_pack, ESC11_WRITE_TEMPORARY_POINT_REQUEST_SIZE);
        break;
    case 31:
        FIXED(esc11_write_temporary_point_response_decode, esc11_write_temporary_point_response_encode, ESC11_WRITE_TEMPORARY_POINT_RESPONSE_SIZE, 1);
        break;
    case 32:
        RECORD(esc11_clear_points_request, esc11_clear_points_request_decode, esc11_clear_points_request_encode, ESC11_CLEAR_POINTS_REQUEST_SIZE, 1);
        break;
    case 33:
        PACKED(esc11_clear_points_request, esc11_clear_points_request_unpack, esc11_clear_points_request_pack, ESC11_CLEAR_POINTS_REQUEST_SIZE);
        break;
    case 34:
        FIXED(esc11_clear_points_response_decode, esc11_clear_points_response_encode, ESC11_CLEAR_POINTS_RESPONSE_SIZE, 1);
        break;
    case 35:
        FIXED(esc11_initialize_points_request_decode, esc11_initialize_points_request_encode, ESC11_INITIALIZE_POINTS_REQUEST_SIZE, 1);
        break;
    case 36:
        FIXED(esc11_initialize_points_response_decode, esc11_initialize_points_response_encode, ESC11_INITIALIZE_POINTS_RESPONSE_SIZE, 1);
        break;
    case 37:
        RECORD(esc11_initialize_parameters_request, esc11_initialize_parameters_request_decode, esc11_initialize_parameters_request_encode, ESC11_INITIALIZE_PARAMETERS_REQUEST_SIZE, 1);
        break;
    case 38:
        PACKED(esc11_initialize_parameters_request, esc11_initialize_parameters_request_unpack, esc11_initialize_parameters_request_pack, ESC11_INITIALIZE_PARAMETERS_REQUEST_SIZE);
        break;
    case 39:
        FIXED(esc11_initialize_parameters_response_decode, esc11_initialize_parameters_response_encode, ESC11_INITIALIZE_PARAMETERS_RESPONSE_SIZE, 1);
        break;
    case 40:
        FIXED(esc11_clear_alarm_history_request_decode, esc11_clear_alarm_history_request_encode, ESC11_CLEAR_ALARM_HISTORY_REQUEST_SIZE, 1);
        break;
    case 41:
        FIXED(esc11_clear_alarm_history_response_decode, esc11_clear_alarm_history_response_encode, ESC11_CLEAR_ALARM_HISTORY_RESPONSE_SIZE, 1);
        break;
    case 42:
        FIXED(esc11_clear_accumulated_time_request_decode, esc11_clear_accumulated_time_request_encode, ESC11_CLEAR_ACCUMULATED_TIME_REQUEST_SIZE, 1);
        break;
    case 43:
        FIXED(esc11_clear_accumulated_time_response_decode, esc11_clear_accumulated_time_response_encode, ESC11_CLEAR_ACCUMULATED_TIME_RESPONSE_SIZE, 1);
        break;
    case 44:
        FIXED(esc11_stop_request_decode, esc11_stop_request_encode, ESC11_STOP_REQUEST_SIZE, 1);
        break;
    case 45:
        FIXED(esc11_stop_response_decode, esc11_stop_response_encode, ESC11_STOP_RESPONSE_SIZE, 1);
        break;
    case 46:
        FIXED(esc11_start_homing_request_decode, esc11_start_homing_request_encode, ESC11_START_HOMING_REQUEST_SIZE, 1);
        break;
    case 47:
        FIXED(esc11_start_homing_response_decode, esc11_start_homing_response_encode, ESC11_START_HOMING_RESPONSE_SIZE, 1);
        break;
    case 48:
        RECORD(esc11_move_positive_distance_request, esc11_move_positive_distance_request_decode, esc11_move_positive_distance_request_encode, ESC11_MOVE_POSITIVE_DISTANCE_REQUEST_SIZE, 1);
        break;
    case 49:
        PACKED(esc11_move_positive_distance_request, esc11_move_positive_distance_request_unpack, esc11_move_positive_distance_request_pack, ESC11_MOVE_POSITIVE_DISTANCE_REQUEST_SIZE);
        break;
    case 50:
        FIXED(esc11_move_positive_distance_response_decode, esc11_move_positive_distance_response_encode, ESC11_MOVE_POSITIVE_DISTANCE_RESPONSE_SIZE, 1);
        break;
    case 51:
        RECORD(esc11_move_negative_distance_request, esc11_move_negative_distance_request_decode, esc11_move_negative_distance_request_encode, ESC11_MOVE_NEGATIVE_DISTANCE_REQUEST_SIZE, 1);
        break;
    case 52:
        PACKED(esc11_move_negative_distance_request, esc11_move_negative_distance_request_unpack, esc11_move_negative_distance_request_pack, ESC11_MOVE_NEGATIVE_DISTANCE_REQUEST_SIZE);
        break;
    case 53:
        FIXED(esc11_move_negative_distance_response_decode, esc11_move_negative_distance_response_encode, ESC11_MOVE_NEGATIVE_DISTANCE_RESPONSE_SIZE, 1);
        break;
    case 54:
        RECORD(esc11_move_open_request, esc11_move_open_request_decode, esc11_move_open_request_encode, ESC11_MOVE_OPEN_REQUEST_SIZE, 1);
        break;
    case 55:
        PACKED(esc11_move_open_request, esc11_move_open_request_unpack, esc11_move_open_request_pack, ESC11_MOVE_OPEN_REQUEST_SIZE);
        break;
    case 56:
        FIXED(esc11_move_open_response_decode, esc11_move_open_response_encode, ESC11_MOVE_OPEN_RESPONSE_SIZE, 1);
        break;
    case 57:
        RECORD(esc11_move_close_request, esc11_move_close_request_decode, esc11_move_close_request_encode, ESC11_MOVE_CLOSE_REQUEST_SIZE, 1);
        break;
    case 58:
        PACKED(esc11_move_close_request, esc11_move_close_request_unpack, esc11_move_close_request_pack, ESC11_MOVE_CLOSE_REQUEST_SIZE);
        break;
    case 59:
        FIXED(esc11_move_close_response_decode, esc11_move_close_response_encode, ESC11_MOVE_CLOSE_RESPONSE_SIZE, 1);
        break;
    case 60:
        RECORD(esc11_move_relative_request, esc11_move_relative_request_decode, esc11_move_relative_request_encode, ESC11_MOVE_RELATIVE_REQUEST_SIZE, 1);
        break;
    case 61:
        PACKED(esc11_move_relative_request, esc11_move_relative_request_unpack, esc11_move_relative_request_pack, ESC11_MOVE_RELATIVE_REQUEST_SIZE);
        break;
    case 62:
        FIXED(esc11_move_relative_response_decode, esc11_move_relative_response_encode, ESC11_MOVE_RELATIVE_RESPONSE_SIZE, 1);
        break;
    case 63:
        RECORD(esc11_move_absolute_request, esc11_move_absolute_request_decode, esc11_move_absolute_request_encode, ESC11_MOVE_ABSOLUTE_REQUEST_SIZE, 1);
        break;
    case 64:
        PACKED(esc11_move_absolute_request, esc11_move_absolute_request_unpack, esc11_move_absolute_request_pack, ESC11_MOVE_ABSOLUTE_REQUEST_SIZE);
        break;
    case 65:
        FIXED(esc11_move_absolute_response_decode, esc11_move_absolute_response_encode, ESC11_MOVE_ABSOLUTE_RESPONSE_SIZE, 1);
        break;
    case 66:
        RECORD(esc11_move_to_point_request, esc11_move_to_point_request_decode, esc11_move_to_point_request_encode, ESC11_MOVE_TO_POINT_REQUEST_SIZE, 1);
        break;
    case 67:
        PACKED(esc11_move_to_point_request, esc11_move_to_point_request_unpack, esc11_move_to_point_request_pack, ESC11_MOVE_TO_POINT_REQUEST_SIZE);
        break;
    case 68:
        FIXED(esc11_move_to_point_response_decode, esc11_move_to_point_response_encode, ESC11_MOVE_TO_POINT_RESPONSE_SIZE, 1);
        break;
    case 69:
        RECORD(esc11_grip_open_request, esc11_grip_open_request_decode, esc11_grip_open_request_encode, ESC11_GRIP_OPEN_REQUEST_SIZE, 1);
        break;
    case 70:
        PACKED(esc11_grip_open_request, esc11_grip_open_request_unpack, esc11_grip_open_request_pack, ESC11_GRIP_OPEN_REQUEST_SIZE);
        break;
    case 71:
        FIXED(esc11_grip_open_response_decode, esc11_grip_open_response_encode, ESC11_GRIP_OPEN_RESPONSE_SIZE, 1);
        break;
    case 72:
        RECORD(esc11_grip_close_request, esc11_grip_close_request_decode, esc11_grip_close_request_encode, ESC11_GRIP_CLOSE_REQUEST_SIZE, 1);
        break;
    case 73:
        PACKED(esc11_grip_close_request, esc11_grip_close_request_unpack, esc11_grip_close_request_pack, ESC11_GRIP_CLOSE_REQUEST_SIZE);
        break;
    case 74:
        FIXED(esc11_grip_close_response_decode, esc11_grip_close_response_encode, ESC11_GRIP_CLOSE_RESPONSE_SIZE, 1);
        break;
    case 75:
        RECORD(esc11_grip_relative_request, esc11_grip_relative_request_decode, esc11_grip_relative_request_encode, ESC11_GRIP_RELATIVE_REQUEST_SIZE, 1);
        break;
    case 76:
        PACKED(esc11_grip_relative_request, esc11_grip_relative_request_unpack, esc11_grip_relative_request_pack, ESC11_GRIP_RELATIVE_REQUEST_SIZE);
        break;
    case 77:
        FIXED(esc11_grip_relative_response_decode, esc11_grip_relative_response_encode, ESC11_GRIP_RELATIVE_RESPONSE_SIZE, 1);
        break;
    case 78:
        RECORD(esc11_grip_absolute_request, esc11_grip_absolute_request_decode, esc11_grip_absolute_request_encode, ESC11_GRIP_ABSOLUTE_REQUEST_SIZE, 1);
        break;
    case 79:
        PACKED(esc11_grip_absolute_request, esc11_grip_absolute_request_unpack, esc11_grip_absolute_request_pack, ESC11_GRIP_ABSOLUTE_REQUEST_SIZE);
        break;
    case 80:
        FIXED(esc11_grip_absolute_response_decode, esc11_grip_absolute_response_encode, ESC11_GRIP_ABSOLUTE_RESPONSE_SIZE, 1);
        break;
    case 81:
        RECORD(esc11_grip_open_with_zone_request, esc11_grip_open_with_zone_request_decode, esc11_grip_open_with_zone_request_encode, ESC11_GRIP_OPEN_WITH_ZONE_REQUEST_SIZE, 1);
        break;
    case 82:
        PACKED(esc11_grip_open_with_zone_request, esc11_grip_open_with_zone_request_unpack, esc11_grip_open_with_zone_request_pack, ESC11_GRIP_OPEN_WITH_ZONE_REQUEST_SIZE);
        break;
    case 83:
        FIXED(esc11_grip_open_with_zone_response_decode, esc11_grip_open_with_zone_response_encode, ESC11_GRIP_OPEN_WITH_ZONE_RESPONSE_SIZE, 1);
        break;
    case 84:
        RECORD(esc11_grip_close_with_zone_request, esc11_grip_close_with_zone_request_decode, esc11_grip_close_with_zone_request_encode, ESC11_GRIP_CLOSE_WITH_ZONE_REQUEST_SIZE, 1);
        break;
    case 85:
        PACKED(esc11_grip_close_with_zone_request, esc11_grip_close_with_zone_request_unpack, esc11_grip_close_with_zone_request_pack, ESC11_GRIP_CLOSE_WITH_ZONE_REQUEST_SIZE);
        break;
    case 86:
        FIXED(esc11_grip_close_with_zone_response_decode, esc11_grip_close_with_zone_response_encode, ESC11_GRIP_CLOSE_WITH_ZONE_RESPONSE_SIZE, 1);
        break;
    case 87:
        FIXED(esc11_no_operation_request_decode, esc11_no_operation_request_encode, ESC11_NO_OPERATION_REQUEST_SIZE, 1);
        break;
    case 88:
        FIXED(esc11_no_operation_response_decode, esc11_no_operation_response_encode, ESC11_NO_OPERATION_RESPONSE_SIZE, 1);
        break;
    case 89:
        RECORD(esc11_set_motor_excitation_request, esc11_set_motor_excitation_request_decode, esc11_set_motor_excitation_request_encode, ESC11_SET_MOTOR_EXCITATION_REQUEST_SIZE, 1);
        break;
    case 90:
        PACKED(esc11_set_motor_excitation_request, esc11_set_motor_excitation_request_unpack, esc11_set_motor_excitation_request_pack, ESC11_SET_MOTOR_EXCITATION_REQUEST_SIZE);
        break;
    case 91:
        FIXED(esc11_set_motor_excitation_response_decode, esc11_set_motor_excitation_response_encode, ESC11_SET_MOTOR_EXCITATION_RESPONSE_SIZE, 1);
        break;
    case 92:
        FIXED(esc11_read_version_request_decode, esc11_read_version_request_encode, ESC11_READ_VERSION_REQUEST_SIZE, 1);
        break;
    case 93:
        RECORD(esc11_read_version_response, esc11_read_version_response_decode, esc11_read_version_response_encode, ESC11_READ_VERSION_RESPONSE_SIZE, 0);
        break;
    case 94:
        PACKED(esc11_read_version_response, esc11_read_version_response_unpack, esc11_read_version_response_pack, ESC11_READ_VERSION_RESPONSE_SIZE);
        break;
    case 95:
        FIXED(esc11_read_current_position_request_decode, esc11_read_current_position_request_encode, ESC11_READ_CURRENT_POSITION_REQUEST_SIZE, 1);
        break;
    case 96:
        RECORD(esc11_read_current_position_response, esc11_read_current_position_response_decode, esc11_read_current_position_response_encode, ESC11_READ_CURRENT_POSITION_RESPONSE_SIZE, 1);
        break;
    case 97:
        PACKED(esc11_read_current_position_response, esc11_read_current_position_response_unpack, esc11_read_current_position_response_pack, ESC11_READ_CURRENT_POSITION_RESPONSE_SIZE);
        break;
    case 98:
        FIXED(esc11_read_current_point_number_request_decode, esc11_read_current_point_number_request_encode, ESC11_READ_CURRENT_POINT_NUMBER_REQUEST_SIZE, 1);
        break;
    case 99:
        RECORD(esc11_read_current_point_number_response, esc11_read_current_point_number_response_decode, esc11_read_current_point_number_response_encode, ESC11_READ_CURRENT_POINT_NUMBER_RESPONSE_SIZE, 1);
        break;
    case 100:
        PACKED(esc11_read_current_point_number_response, esc11_read_current_point_number_response_unpack, esc11_read_current_point_number_response_pack, ESC11_READ_CURRENT_POINT_NUMBER_RESPONSE_SIZE);
        break;
    case 101:
        RECORD(esc11_read_parameter_request, esc11_read_parameter_request_decode, esc11_read_parameter_request_encode, ESC11_READ_PARAMETER_REQUEST_SIZE, 1);
        break;
    case 102:
        PACKED(esc11_read_parameter_request, esc11_read_parameter_request_unpack, esc11_read_parameter_request_pack, ESC11_READ_PARAMETER_REQUEST_SIZE);
        break;
    case 103:
        RECORD(esc11_read_parameter_response, esc11_read_parameter_response_decode, esc11_read_parameter_response_encode, ESC11_READ_PARAMETER_RESPONSE_SIZE, 1);
        break;
    case 104:
        PACKED(esc11_read_parameter_response, esc11_read_parameter_response_unpack, esc11_read_parameter_response_pack, ESC11_READ_PARAMETER_RESPONSE_SIZE);
        break;
    case 105:
        RECORD(esc11_read_point_request, esc11_read_point_request_decode, esc11_read_point_request_encode, ESC11_READ_POINT_REQUEST_SIZE, 1);
        break;
    case 106:
        PACKED(esc11_read_point_request, esc11_read_point_request_unpack, esc11_read_point_request_pack, ESC11_READ_POINT_REQUEST_SIZE);
        break;
    case 107:
        RECORD(esc11_read_point_response, esc11_read_point_response_decode, esc11_read_point_response_encode, ESC11_READ_POINT_RESPONSE_SIZE, 1);
        break;
    case 108:
        PACKED(esc11_read_point_response, esc11_read_point_response_unpack, esc11_read_point_response_pack, ESC11_READ_POINT_RESPONSE_SIZE);
        break;
    case 109:
        FIXED(esc11_read_homing_state_request_decode, esc11_read_homing_state_request_encode, ESC11_READ_HOMING_STATE_REQUEST_SIZE, 1);
        break;
    case 110:
        RECORD(esc11_read_homing_state_response, esc11_read_homing_state_response_decode, esc11_read_homing_state_response_encode, ESC11_READ_HOMING_STATE_RESPONSE_SIZE, 1);
        break;
    case 111:
        PACKED(esc11_read_homing_state_response, esc11_read_homing_state_response_unpack, esc11_read_homing_state_response_pack, ESC11_READ_HOMING_STATE_RESPONSE_SIZE);
        break;
    case 112:
        FIXED(esc11_read_motor_excitation_request_decode, esc11_read_motor_excitation_request_encode, ESC11_READ_MOTOR_EXCITATION_REQUEST_SIZE, 1);
        break;
    case 113:
        RECORD(esc11_read_motor_excitation_response, esc11_read_motor_excitation_response_decode, esc11_read_motor_excitation_response_encode, ESC11_READ_MOTOR_EXCITATION_RESPONSE_SIZE, 1);
        break;
    case 114:
        PACKED(esc11_read_motor_excitation_response, esc11_read_motor_excitation_response_unpack, esc11_read_motor_excitation_response_pack, ESC11_READ_MOTOR_EXCITATION_RESPONSE_SIZE);
        break;
    case 115:
        FIXED(esc11_read_alarm_code_request_decode, esc11_read_alarm_code_request_encode, ESC11_READ_ALARM_CODE_REQUEST_SIZE, 1);
        break;
    case 116:
        RECORD(esc11_read_alarm_code_response, esc11_read_alarm_code_response_decode, esc11_read_alarm_code_response_encode, ESC11_READ_ALARM_CODE_RESPONSE_SIZE, 1);
        break;
    case 117:
        PACKED(esc11_read_alarm_code_response, esc11_read_alarm_code_response_unpack, esc11_read_alarm_code_response_pack, ESC11_READ_ALARM_CODE_RESPONSE_SIZE);
        break;
    case 118:
        FIXED(esc11_read_accumulated_time_request_decode, esc11_read_accumulated_time_request_encode, ESC11_READ_ACCUMULATED_TIME_REQUEST_SIZE, 1);
        break;
    case 119:
        RECORD(esc11_read_accumulated_time_response, esc11_read_accumulated_time_response_decode, esc11_read_accumulated_time_response_encode, ESC11_READ_ACCUMULATED_TIME_RESPONSE_SIZE, 1);
        break;
    case 120:
        PACKED(esc11_read_accumulated_time_response, esc11_read_accumulated_time_response_unpack, esc11_read_accumulated_time_response_pack, ESC11_READ_ACCUMULATED_TIME_RESPONSE_SIZE);
        break;
    case 121:
        FIXED(esc11_reset_alarm_request_decode, esc11_reset_alarm_request_encode, ESC11_RESET_ALARM_REQUEST_SIZE, 1);
        break;
    case 122:
        FIXED(esc11_reset_alarm_response_decode, esc11_reset_alarm_response_encode, ESC11_RESET_ALARM_RESPONSE_SIZE, 1);
        break;
    case 123:
        VALUE(uint16_t, esc11_par_parameters_actuator_type_decode, esc11_par_parameters_actuator_type_encode, 2u, 2u);
        break;
    case 124:
        VALUE(uint16_t, esc11_par_parameters_positive_soft_limit_decode, esc11_par_parameters_positive_soft_limit_encode, 2u, 2u);
        break;
    case 125:
        VALUE(int16_t, esc11_par_parameters_negative_soft_limit_decode, esc11_par_parameters_negative_soft_limit_encode, 2u, 2u);
        break;
    case 126:
        VALUE(uint16_t, esc11_par_parameters_stroke_decode, esc11_par_parameters_stroke_encode, 2u, 2u);
        break;
    case 127:
        VALUE(esc11_homing_direction, esc11_par_parameters_homing_direction_decode, esc11_par_parameters_homing_direction_encode, 2u, 2u);
        break;
    case 128:
        VALUE(uint16_t, esc11_par_parameters_homing_speed_decode, esc11_par_parameters_homing_speed_encode, 2u, 2u);
        break;
    case 129:
        VALUE(int16_t, esc11_par_parameters_home_offset_decode, esc11_par_parameters_home_offset_encode, 2u, 2u);
        break;
    case 130:
        VALUE(uint16_t, esc11_par_parameters_acceleration_decode, esc11_par_parameters_acceleration_encode, 2u, 2u);
        break;
    case 131:
        VALUE(uint16_t, esc11_par_parameters_maximum_program_speed_decode, esc11_par_parameters_maximum_program_speed_encode, 2u, 2u);
        break;
    case 132:
        VALUE(uint16_t, esc11_par_parameters_gripping_speed_decode, esc11_par_parameters_gripping_speed_encode, 2u, 2u);
        break;
    case 133:
        VALUE(uint16_t, esc11_par_parameters_constant_speed_distance_decode, esc11_par_parameters_constant_speed_distance_encode, 2u, 2u);
        break;
    case 134:
        VALUE(uint16_t, esc11_par_parameters_limit_width_decode, esc11_par_parameters_limit_width_encode, 2u, 2u);
        break;
    case 135:
        VALUE(uint16_t, esc11_par_parameters_positioning_complete_pulses_decode, esc11_par_parameters_positioning_complete_pulses_encode, 2u, 2u);
        break;
    case 136:
        VALUE(esc11_homing_method, esc11_par_parameters_homing_method_decode, esc11_par_parameters_homing_method_encode, 2u, 2u);
        break;
    default:
        break;
    }
    return 0;
}
