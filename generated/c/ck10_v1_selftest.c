/*
 * Tests ck10_v1.h: CK10, version 1
 * Identity: fdc1e9665defc19d
 *
 * Generated; do not edit. Compile and run it: it exits with 0 if every test passes. On a machine without an operating system
 * compile it with -ffreestanding; then it has no main, and you call ck10_selftest yourself.
 */
#define CK10_WITH_TEXTS
#include "ck10_v1.h"

#if !defined(__STDC_HOSTED__) || __STDC_HOSTED__
#include <stdio.h>
#define HOSTED
#endif

/* Calls `tell` for each test that fails, and returns their number. */
unsigned long ck10_selftest(void (*tell)(const char *what));

static unsigned long passed, failed;
static void (*told)(const char *name);

static void expect(bool holds, const char *name)
{
    if (holds) {
        passed++;
    } else {
        failed++;
        told(name);
    }
}

static bool same_bytes(const void *left, const void *right, size_t size)
{
    const uint8_t *one = (const uint8_t *)left, *other = (const uint8_t *)right;
    size_t offset;
    for (offset = 0; offset < size; offset++) {
        if (one[offset] != other[offset]) {
            return false;
        }
    }
    return true;
}

static bool same_text(const char *left, const char *right)
{
    size_t offset;
    for (offset = 0; left[offset] == right[offset]; offset++) {
        if (left[offset] == '\0') {
            return true;
        }
    }
    return false;
}

/* Copies by volatile accesses: the compiler cannot know what is copied, so the code that follows runs when the test does. */
static void copy(void *to, const void *from, size_t size)
{
    volatile uint8_t *target = (uint8_t *)to;
    size_t offset;
    for (offset = 0; offset < size; offset++) {
        target[offset] = ((const uint8_t *)from)[offset];
    }
}

static void clear(void *data, size_t size)
{
    size_t offset;
    for (offset = 0; offset < size; offset++) {
        ((uint8_t *)data)[offset] = 0;
    }
}

static void test_0(void)
{
    expect(CK10_MOTION_STATUS_ERROR_MASK == 0x00000001u, "CK10_MOTION_STATUS_ERROR_MASK");
    expect(ck10_motion_status_error(0x00000001u) == true, "ck10_motion_status_error");
    expect(ck10_motion_status_error((uint32_t)~0x00000001u) == false, "ck10_motion_status_error");
    expect(CK10_MOTION_STATUS_POSITIVE_HARD_LIMIT_MASK == 0x00000002u, "CK10_MOTION_STATUS_POSITIVE_HARD_LIMIT_MASK");
    expect(ck10_motion_status_positive_hard_limit(0x00000002u) == true, "ck10_motion_status_positive_hard_limit");
    expect(ck10_motion_status_positive_hard_limit((uint32_t)~0x00000002u) == false, "ck10_motion_status_positive_hard_limit");
    expect(CK10_MOTION_STATUS_NEGATIVE_HARD_LIMIT_MASK == 0x00000004u, "CK10_MOTION_STATUS_NEGATIVE_HARD_LIMIT_MASK");
    expect(ck10_motion_status_negative_hard_limit(0x00000004u) == true, "ck10_motion_status_negative_hard_limit");
    expect(ck10_motion_status_negative_hard_limit((uint32_t)~0x00000004u) == false, "ck10_motion_status_negative_hard_limit");
    expect(CK10_MOTION_STATUS_POSITIVE_SOFT_LIMIT_MASK == 0x00000008u, "CK10_MOTION_STATUS_POSITIVE_SOFT_LIMIT_MASK");
    expect(ck10_motion_status_positive_soft_limit(0x00000008u) == true, "ck10_motion_status_positive_soft_limit");
    expect(ck10_motion_status_positive_soft_limit((uint32_t)~0x00000008u) == false, "ck10_motion_status_positive_soft_limit");
    expect(CK10_MOTION_STATUS_NEGATIVE_SOFT_LIMIT_MASK == 0x00000010u, "CK10_MOTION_STATUS_NEGATIVE_SOFT_LIMIT_MASK");
    expect(ck10_motion_status_negative_soft_limit(0x00000010u) == true, "ck10_motion_status_negative_soft_limit");
    expect(ck10_motion_status_negative_soft_limit((uint32_t)~0x00000010u) == false, "ck10_motion_status_negative_soft_limit");
    expect(CK10_MOTION_STATUS_POSITION_OVERFLOW_MASK == 0x00000080u, "CK10_MOTION_STATUS_POSITION_OVERFLOW_MASK");
    expect(ck10_motion_status_position_overflow(0x00000080u) == true, "ck10_motion_status_position_overflow");
    expect(ck10_motion_status_position_overflow((uint32_t)~0x00000080u) == false, "ck10_motion_status_position_overflow");
    expect(CK10_MOTION_STATUS_OVERCURRENT_MASK == 0x00000100u, "CK10_MOTION_STATUS_OVERCURRENT_MASK");
    expect(ck10_motion_status_overcurrent(0x00000100u) == true, "ck10_motion_status_overcurrent");
    expect(ck10_motion_status_overcurrent((uint32_t)~0x00000100u) == false, "ck10_motion_status_overcurrent");
    expect(CK10_MOTION_STATUS_OVERSPEED_MASK == 0x00000200u, "CK10_MOTION_STATUS_OVERSPEED_MASK");
    expect(ck10_motion_status_overspeed(0x00000200u) == true, "ck10_motion_status_overspeed");
    expect(ck10_motion_status_overspeed((uint32_t)~0x00000200u) == false, "ck10_motion_status_overspeed");
    expect(CK10_MOTION_STATUS_POSITION_TRACKING_MASK == 0x00000400u, "CK10_MOTION_STATUS_POSITION_TRACKING_MASK");
    expect(ck10_motion_status_position_tracking(0x00000400u) == true, "ck10_motion_status_position_tracking");
    expect(ck10_motion_status_position_tracking((uint32_t)~0x00000400u) == false, "ck10_motion_status_position_tracking");
    expect(CK10_MOTION_STATUS_OVERLOAD_MASK == 0x00000800u, "CK10_MOTION_STATUS_OVERLOAD_MASK");
    expect(ck10_motion_status_overload(0x00000800u) == true, "ck10_motion_status_overload");
    expect(ck10_motion_status_overload((uint32_t)~0x00000800u) == false, "ck10_motion_status_overload");
    expect(CK10_MOTION_STATUS_OVERHEAT_MASK == 0x00001000u, "CK10_MOTION_STATUS_OVERHEAT_MASK");
    expect(ck10_motion_status_overheat(0x00001000u) == true, "ck10_motion_status_overheat");
    expect(ck10_motion_status_overheat((uint32_t)~0x00001000u) == false, "ck10_motion_status_overheat");
    expect(CK10_MOTION_STATUS_BACK_EMF_MASK == 0x00002000u, "CK10_MOTION_STATUS_BACK_EMF_MASK");
    expect(ck10_motion_status_back_emf(0x00002000u) == true, "ck10_motion_status_back_emf");
    expect(ck10_motion_status_back_emf((uint32_t)~0x00002000u) == false, "ck10_motion_status_back_emf");
    expect(CK10_MOTION_STATUS_IN_POSITION_ERROR_MASK == 0x00008000u, "CK10_MOTION_STATUS_IN_POSITION_ERROR_MASK");
    expect(ck10_motion_status_in_position_error(0x00008000u) == true, "ck10_motion_status_in_position_error");
    expect(ck10_motion_status_in_position_error((uint32_t)~0x00008000u) == false, "ck10_motion_status_in_position_error");
    expect(CK10_MOTION_STATUS_EMERGENCY_STOP_MASK == 0x00010000u, "CK10_MOTION_STATUS_EMERGENCY_STOP_MASK");
    expect(ck10_motion_status_emergency_stop(0x00010000u) == true, "ck10_motion_status_emergency_stop");
    expect(ck10_motion_status_emergency_stop((uint32_t)~0x00010000u) == false, "ck10_motion_status_emergency_stop");
    expect(CK10_MOTION_STATUS_SLOW_STOP_MASK == 0x00020000u, "CK10_MOTION_STATUS_SLOW_STOP_MASK");
    expect(ck10_motion_status_slow_stop(0x00020000u) == true, "ck10_motion_status_slow_stop");
    expect(ck10_motion_status_slow_stop((uint32_t)~0x00020000u) == false, "ck10_motion_status_slow_stop");
    expect(CK10_MOTION_STATUS_HOMING_MASK == 0x00040000u, "CK10_MOTION_STATUS_HOMING_MASK");
    expect(ck10_motion_status_homing(0x00040000u) == true, "ck10_motion_status_homing");
    expect(ck10_motion_status_homing((uint32_t)~0x00040000u) == false, "ck10_motion_status_homing");
    expect(CK10_MOTION_STATUS_IN_POSITION_MASK == 0x00080000u, "CK10_MOTION_STATUS_IN_POSITION_MASK");
    expect(ck10_motion_status_in_position(0x00080000u) == true, "ck10_motion_status_in_position");
    expect(ck10_motion_status_in_position((uint32_t)~0x00080000u) == false, "ck10_motion_status_in_position");
    expect(CK10_MOTION_STATUS_SERVO_ON_MASK == 0x00100000u, "CK10_MOTION_STATUS_SERVO_ON_MASK");
    expect(ck10_motion_status_servo_on(0x00100000u) == true, "ck10_motion_status_servo_on");
    expect(ck10_motion_status_servo_on((uint32_t)~0x00100000u) == false, "ck10_motion_status_servo_on");
    expect(CK10_MOTION_STATUS_ALARM_RESET_MASK == 0x00200000u, "CK10_MOTION_STATUS_ALARM_RESET_MASK");
    expect(ck10_motion_status_alarm_reset(0x00200000u) == true, "ck10_motion_status_alarm_reset");
    expect(ck10_motion_status_alarm_reset((uint32_t)~0x00200000u) == false, "ck10_motion_status_alarm_reset");
    expect(CK10_MOTION_STATUS_POINT_TABLE_STOPPED_MASK == 0x00400000u, "CK10_MOTION_STATUS_POINT_TABLE_STOPPED_MASK");
    expect(ck10_motion_status_point_table_stopped(0x00400000u) == true, "ck10_motion_status_point_table_stopped");
    expect(ck10_motion_status_point_table_stopped((uint32_t)~0x00400000u) == false, "ck10_motion_status_point_table_stopped");
    expect(CK10_MOTION_STATUS_ORIGIN_SENSOR_MASK == 0x00800000u, "CK10_MOTION_STATUS_ORIGIN_SENSOR_MASK");
    expect(ck10_motion_status_origin_sensor(0x00800000u) == true, "ck10_motion_status_origin_sensor");
    expect(ck10_motion_status_origin_sensor((uint32_t)~0x00800000u) == false, "ck10_motion_status_origin_sensor");
    expect(CK10_MOTION_STATUS_Z_PULSE_MASK == 0x01000000u, "CK10_MOTION_STATUS_Z_PULSE_MASK");
    expect(ck10_motion_status_z_pulse(0x01000000u) == true, "ck10_motion_status_z_pulse");
    expect(ck10_motion_status_z_pulse((uint32_t)~0x01000000u) == false, "ck10_motion_status_z_pulse");
    expect(CK10_MOTION_STATUS_HOMING_COMPLETE_MASK == 0x02000000u, "CK10_MOTION_STATUS_HOMING_COMPLETE_MASK");
    expect(ck10_motion_status_homing_complete(0x02000000u) == true, "ck10_motion_status_homing_complete");
    expect(ck10_motion_status_homing_complete((uint32_t)~0x02000000u) == false, "ck10_motion_status_homing_complete");
    expect(CK10_MOTION_STATUS_DIRECTION_MASK == 0x04000000u, "CK10_MOTION_STATUS_DIRECTION_MASK");
    expect(ck10_motion_status_direction(0x04000000u) == true, "ck10_motion_status_direction");
    expect(ck10_motion_status_direction((uint32_t)~0x04000000u) == false, "ck10_motion_status_direction");
    expect(CK10_MOTION_STATUS_MOVING_MASK == 0x08000000u, "CK10_MOTION_STATUS_MOVING_MASK");
    expect(ck10_motion_status_moving(0x08000000u) == true, "ck10_motion_status_moving");
    expect(ck10_motion_status_moving((uint32_t)~0x08000000u) == false, "ck10_motion_status_moving");
    expect(CK10_MOTION_STATUS_ACCELERATING_MASK == 0x20000000u, "CK10_MOTION_STATUS_ACCELERATING_MASK");
    expect(ck10_motion_status_accelerating(0x20000000u) == true, "ck10_motion_status_accelerating");
    expect(ck10_motion_status_accelerating((uint32_t)~0x20000000u) == false, "ck10_motion_status_accelerating");
    expect(CK10_MOTION_STATUS_DECELERATING_MASK == 0x40000000u, "CK10_MOTION_STATUS_DECELERATING_MASK");
    expect(ck10_motion_status_decelerating(0x40000000u) == true, "ck10_motion_status_decelerating");
    expect(ck10_motion_status_decelerating((uint32_t)~0x40000000u) == false, "ck10_motion_status_decelerating");
    expect(CK10_MOTION_STATUS_CONSTANT_SPEED_MASK == 0x80000000u, "CK10_MOTION_STATUS_CONSTANT_SPEED_MASK");
    expect(ck10_motion_status_constant_speed(0x80000000u) == true, "ck10_motion_status_constant_speed");
    expect(ck10_motion_status_constant_speed((uint32_t)~0x80000000u) == false, "ck10_motion_status_constant_speed");
    expect(CK10_INPUT_SIGNALS_POSITIVE_LIMIT_MASK == 0x00000001u, "CK10_INPUT_SIGNALS_POSITIVE_LIMIT_MASK");
    expect(ck10_input_signals_positive_limit(0x00000001u) == true, "ck10_input_signals_positive_limit");
    expect(ck10_input_signals_positive_limit((uint32_t)~0x00000001u) == false, "ck10_input_signals_positive_limit");
    expect(CK10_INPUT_SIGNALS_NEGATIVE_LIMIT_MASK == 0x00000002u, "CK10_INPUT_SIGNALS_NEGATIVE_LIMIT_MASK");
    expect(ck10_input_signals_negative_limit(0x00000002u) == true, "ck10_input_signals_negative_limit");
    expect(ck10_input_signals_negative_limit((uint32_t)~0x00000002u) == false, "ck10_input_signals_negative_limit");
    expect(CK10_INPUT_SIGNALS_ORIGIN_MASK == 0x00000004u, "CK10_INPUT_SIGNALS_ORIGIN_MASK");
    expect(ck10_input_signals_origin(0x00000004u) == true, "ck10_input_signals_origin");
    expect(ck10_input_signals_origin((uint32_t)~0x00000004u) == false, "ck10_input_signals_origin");
    expect(CK10_INPUT_SIGNALS_CLEAR_POSITION_MASK == 0x00000008u, "CK10_INPUT_SIGNALS_CLEAR_POSITION_MASK");
    expect(ck10_input_signals_clear_position(0x00000008u) == true, "ck10_input_signals_clear_position");
    expect(ck10_input_signals_clear_position((uint32_t)~0x00000008u) == false, "ck10_input_signals_clear_position");
    expect(CK10_INPUT_SIGNALS_POINT_ADDRESS_0_MASK == 0x00000010u, "CK10_INPUT_SIGNALS_POINT_ADDRESS_0_MASK");
    expect(ck10_input_signals_point_address_0(0x00000010u) == true, "ck10_input_signals_point_address_0");
    expect(ck10_input_signals_point_address_0((uint32_t)~0x00000010u) == false, "ck10_input_signals_point_address_0");
    expect(CK10_INPUT_SIGNALS_POINT_ADDRESS_1_MASK == 0x00000020u, "CK10_INPUT_SIGNALS_POINT_ADDRESS_1_MASK");
    expect(ck10_input_signals_point_address_1(0x00000020u) == true, "ck10_input_signals_point_address_1");
    expect(ck10_input_signals_point_address_1((uint32_t)~0x00000020u) == false, "ck10_input_signals_point_address_1");
    expect(CK10_INPUT_SIGNALS_POINT_ADDRESS_2_MASK == 0x00000040u, "CK10_INPUT_SIGNALS_POINT_ADDRESS_2_MASK");
    expect(ck10_input_signals_point_address_2(0x00000040u) == true, "ck10_input_signals_point_address_2");
    expect(ck10_input_signals_point_address_2((uint32_t)~0x00000040u) == false, "ck10_input_signals_point_address_2");
    expect(CK10_INPUT_SIGNALS_POINT_ADDRESS_3_MASK == 0x00000080u, "CK10_INPUT_SIGNALS_POINT_ADDRESS_3_MASK");
    expect(ck10_input_signals_point_address_3(0x00000080u) == true, "ck10_input_signals_point_address_3");
    expect(ck10_input_signals_point_address_3((uint32_t)~0x00000080u) == false, "ck10_input_signals_point_address_3");
    expect(CK10_INPUT_SIGNALS_POINT_ADDRESS_4_MASK == 0x00000100u, "CK10_INPUT_SIGNALS_POINT_ADDRESS_4_MASK");
    expect(ck10_input_signals_point_address_4(0x00000100u) == true, "ck10_input_signals_point_address_4");
    expect(ck10_input_signals_point_address_4((uint32_t)~0x00000100u) == false, "ck10_input_signals_point_address_4");
    expect(CK10_INPUT_SIGNALS_POINT_ADDRESS_5_OR_USER_6_MASK == 0x00000200u, "CK10_INPUT_SIGNALS_POINT_ADDRESS_5_OR_USER_6_MASK");
    expect(ck10_input_signals_point_address_5_or_user_6(0x00000200u) == true, "ck10_input_signals_point_address_5_or_user_6");
    expect(ck10_input_signals_point_address_5_or_user_6((uint32_t)~0x00000200u) == false, "ck10_input_signals_point_address_5_or_user_6");
    expect(CK10_INPUT_SIGNALS_POINT_ADDRESS_6_OR_USER_7_MASK == 0x00000400u, "CK10_INPUT_SIGNALS_POINT_ADDRESS_6_OR_USER_7_MASK");
    expect(ck10_input_signals_point_address_6_or_user_7(0x00000400u) == true, "ck10_input_signals_point_address_6_or_user_7");
    expect(ck10_input_signals_point_address_6_or_user_7((uint32_t)~0x00000400u) == false, "ck10_input_signals_point_address_6_or_user_7");
    expect(CK10_INPUT_SIGNALS_POINT_ADDRESS_7_OR_USER_8_MASK == 0x00000800u, "CK10_INPUT_SIGNALS_POINT_ADDRESS_7_OR_USER_8_MASK");
    expect(ck10_input_signals_point_address_7_or_user_8(0x00000800u) == true, "ck10_input_signals_point_address_7_or_user_8");
    expect(ck10_input_signals_point_address_7_or_user_8((uint32_t)~0x00000800u) == false, "ck10_input_signals_point_address_7_or_user_8");
    expect(CK10_INPUT_SIGNALS_START_POINT_TABLE_MASK == 0x00001000u, "CK10_INPUT_SIGNALS_START_POINT_TABLE_MASK");
    expect(ck10_input_signals_start_point_table(0x00001000u) == true, "ck10_input_signals_start_point_table");
    expect(ck10_input_signals_start_point_table((uint32_t)~0x00001000u) == false, "ck10_input_signals_start_point_table");
    expect(CK10_INPUT_SIGNALS_STOP_MASK == 0x00002000u, "CK10_INPUT_SIGNALS_STOP_MASK");
    expect(ck10_input_signals_stop(0x00002000u) == true, "ck10_input_signals_stop");
    expect(ck10_input_signals_stop((uint32_t)~0x00002000u) == false, "ck10_input_signals_stop");
    expect(CK10_INPUT_SIGNALS_JOG_POSITIVE_MASK == 0x00004000u, "CK10_INPUT_SIGNALS_JOG_POSITIVE_MASK");
    expect(ck10_input_signals_jog_positive(0x00004000u) == true, "ck10_input_signals_jog_positive");
    expect(ck10_input_signals_jog_positive((uint32_t)~0x00004000u) == false, "ck10_input_signals_jog_positive");
    expect(CK10_INPUT_SIGNALS_JOG_NEGATIVE_MASK == 0x00008000u, "CK10_INPUT_SIGNALS_JOG_NEGATIVE_MASK");
    expect(ck10_input_signals_jog_negative(0x00008000u) == true, "ck10_input_signals_jog_negative");
    expect(ck10_input_signals_jog_negative((uint32_t)~0x00008000u) == false, "ck10_input_signals_jog_negative");
    expect(CK10_INPUT_SIGNALS_RESET_ALARM_MASK == 0x00010000u, "CK10_INPUT_SIGNALS_RESET_ALARM_MASK");
    expect(ck10_input_signals_reset_alarm(0x00010000u) == true, "ck10_input_signals_reset_alarm");
    expect(ck10_input_signals_reset_alarm((uint32_t)~0x00010000u) == false, "ck10_input_signals_reset_alarm");
    expect(CK10_INPUT_SIGNALS_SERVO_ON_MASK == 0x00020000u, "CK10_INPUT_SIGNALS_SERVO_ON_MASK");
    expect(ck10_input_signals_servo_on(0x00020000u) == true, "ck10_input_signals_servo_on");
    expect(ck10_input_signals_servo_on((uint32_t)~0x00020000u) == false, "ck10_input_signals_servo_on");
    expect(CK10_INPUT_SIGNALS_START_HOMING_MASK == 0x00080000u, "CK10_INPUT_SIGNALS_START_HOMING_MASK");
    expect(ck10_input_signals_start_homing(0x00080000u) == true, "ck10_input_signals_start_homing");
    expect(ck10_input_signals_start_homing((uint32_t)~0x00080000u) == false, "ck10_input_signals_start_homing");
    expect(CK10_INPUT_SIGNALS_EMERGENCY_STOP_MASK == 0x00200000u, "CK10_INPUT_SIGNALS_EMERGENCY_STOP_MASK");
    expect(ck10_input_signals_emergency_stop(0x00200000u) == true, "ck10_input_signals_emergency_stop");
    expect(ck10_input_signals_emergency_stop((uint32_t)~0x00200000u) == false, "ck10_input_signals_emergency_stop");
    expect(CK10_INPUT_SIGNALS_JUMP_0_MASK == 0x00400000u, "CK10_INPUT_SIGNALS_JUMP_0_MASK");
    expect(ck10_input_signals_jump_0(0x00400000u) == true, "ck10_input_signals_jump_0");
    expect(ck10_input_signals_jump_0((uint32_t)~0x00400000u) == false, "ck10_input_signals_jump_0");
    expect(CK10_INPUT_SIGNALS_JUMP_1_MASK == 0x00800000u, "CK10_INPUT_SIGNALS_JUMP_1_MASK");
    expect(ck10_input_signals_jump_1(0x00800000u) == true, "ck10_input_signals_jump_1");
    expect(ck10_input_signals_jump_1((uint32_t)~0x00800000u) == false, "ck10_input_signals_jump_1");
    expect(CK10_INPUT_SIGNALS_JUMP_2_MASK == 0x01000000u, "CK10_INPUT_SIGNALS_JUMP_2_MASK");
    expect(ck10_input_signals_jump_2(0x01000000u) == true, "ck10_input_signals_jump_2");
    expect(ck10_input_signals_jump_2((uint32_t)~0x01000000u) == false, "ck10_input_signals_jump_2");
    expect(CK10_INPUT_SIGNALS_START_JUMP_MASK == 0x02000000u, "CK10_INPUT_SIGNALS_START_JUMP_MASK");
    expect(ck10_input_signals_start_jump(0x02000000u) == true, "ck10_input_signals_start_jump");
    expect(ck10_input_signals_start_jump((uint32_t)~0x02000000u) == false, "ck10_input_signals_start_jump");
    expect(CK10_INPUT_SIGNALS_USER_0_MASK == 0x04000000u, "CK10_INPUT_SIGNALS_USER_0_MASK");
    expect(ck10_input_signals_user_0(0x04000000u) == true, "ck10_input_signals_user_0");
    expect(ck10_input_signals_user_0((uint32_t)~0x04000000u) == false, "ck10_input_signals_user_0");
    expect(CK10_INPUT_SIGNALS_USER_1_MASK == 0x08000000u, "CK10_INPUT_SIGNALS_USER_1_MASK");
    expect(ck10_input_signals_user_1(0x08000000u) == true, "ck10_input_signals_user_1");
    expect(ck10_input_signals_user_1((uint32_t)~0x08000000u) == false, "ck10_input_signals_user_1");
    expect(CK10_INPUT_SIGNALS_USER_2_MASK == 0x10000000u, "CK10_INPUT_SIGNALS_USER_2_MASK");
    expect(ck10_input_signals_user_2(0x10000000u) == true, "ck10_input_signals_user_2");
    expect(ck10_input_signals_user_2((uint32_t)~0x10000000u) == false, "ck10_input_signals_user_2");
    expect(CK10_INPUT_SIGNALS_USER_3_MASK == 0x20000000u, "CK10_INPUT_SIGNALS_USER_3_MASK");
    expect(ck10_input_signals_user_3(0x20000000u) == true, "ck10_input_signals_user_3");
    expect(ck10_input_signals_user_3((uint32_t)~0x20000000u) == false, "ck10_input_signals_user_3");
    expect(CK10_INPUT_SIGNALS_USER_4_MASK == 0x40000000u, "CK10_INPUT_SIGNALS_USER_4_MASK");
    expect(ck10_input_signals_user_4(0x40000000u) == true, "ck10_input_signals_user_4");
    expect(ck10_input_signals_user_4((uint32_t)~0x40000000u) == false, "ck10_input_signals_user_4");
    expect(CK10_INPUT_SIGNALS_USER_5_MASK == 0x80000000u, "CK10_INPUT_SIGNALS_USER_5_MASK");
    expect(ck10_input_signals_user_5(0x80000000u) == true, "ck10_input_signals_user_5");
    expect(ck10_input_signals_user_5((uint32_t)~0x80000000u) == false, "ck10_input_signals_user_5");
    expect(CK10_OUTPUT_SIGNALS_COMPARE_OUTPUT_MASK == 0x00000001u, "CK10_OUTPUT_SIGNALS_COMPARE_OUTPUT_MASK");
    expect(ck10_output_signals_compare_output(0x00000001u) == true, "ck10_output_signals_compare_output");
    expect(ck10_output_signals_compare_output((uint32_t)~0x00000001u) == false, "ck10_output_signals_compare_output");
    expect(CK10_OUTPUT_SIGNALS_IN_POSITION_MASK == 0x00000002u, "CK10_OUTPUT_SIGNALS_IN_POSITION_MASK");
    expect(ck10_output_signals_in_position(0x00000002u) == true, "ck10_output_signals_in_position");
    expect(ck10_output_signals_in_position((uint32_t)~0x00000002u) == false, "ck10_output_signals_in_position");
    expect(CK10_OUTPUT_SIGNALS_ALARM_MASK == 0x00000004u, "CK10_OUTPUT_SIGNALS_ALARM_MASK");
    expect(ck10_output_signals_alarm(0x00000004u) == true, "ck10_output_signals_alarm");
    expect(ck10_output_signals_alarm((uint32_t)~0x00000004u) == false, "ck10_output_signals_alarm");
    expect(CK10_OUTPUT_SIGNALS_MOVING_MASK == 0x00000008u, "CK10_OUTPUT_SIGNALS_MOVING_MASK");
    expect(ck10_output_signals_moving(0x00000008u) == true, "ck10_output_signals_moving");
    expect(ck10_output_signals_moving((uint32_t)~0x00000008u) == false, "ck10_output_signals_moving");
    expect(CK10_OUTPUT_SIGNALS_ACCELERATING_OR_DECELERATING_MASK == 0x00000010u, "CK10_OUTPUT_SIGNALS_ACCELERATING_OR_DECELERATING_MASK");
    expect(ck10_output_signals_accelerating_or_decelerating(0x00000010u) == true, "ck10_output_signals_accelerating_or_decelerating");
    expect(ck10_output_signals_accelerating_or_decelerating((uint32_t)~0x00000010u) == false, "ck10_output_signals_accelerating_or_decelerating");
    expect(CK10_OUTPUT_SIGNALS_ACKNOWLEDGE_MASK == 0x00000020u, "CK10_OUTPUT_SIGNALS_ACKNOWLEDGE_MASK");
    expect(ck10_output_signals_acknowledge(0x00000020u) == true, "ck10_output_signals_acknowledge");
    expect(ck10_output_signals_acknowledge((uint32_t)~0x00000020u) == false, "ck10_output_signals_acknowledge");
    expect(CK10_OUTPUT_SIGNALS_END_MASK == 0x00000040u, "CK10_OUTPUT_SIGNALS_END_MASK");
    expect(ck10_output_signals_end(0x00000040u) == true, "ck10_output_signals_end");
    expect(ck10_output_signals_end((uint32_t)~0x00000040u) == false, "ck10_output_signals_end");
    expect(CK10_OUTPUT_SIGNALS_ALARM_BLINK_MASK == 0x00000080u, "CK10_OUTPUT_SIGNALS_ALARM_BLINK_MASK");
    expect(ck10_output_signals_alarm_blink(0x00000080u) == true, "ck10_output_signals_alarm_blink");
    expect(ck10_output_signals_alarm_blink((uint32_t)~0x00000080u) == false, "ck10_output_signals_alarm_blink");
    expect(CK10_OUTPUT_SIGNALS_HOMING_COMPLETE_MASK == 0x00000100u, "CK10_OUTPUT_SIGNALS_HOMING_COMPLETE_MASK");
    expect(ck10_output_signals_homing_complete(0x00000100u) == true, "ck10_output_signals_homing_complete");
    expect(ck10_output_signals_homing_complete((uint32_t)~0x00000100u) == false, "ck10_output_signals_homing_complete");
    expect(CK10_OUTPUT_SIGNALS_SERVO_READY_MASK == 0x00000200u, "CK10_OUTPUT_SIGNALS_SERVO_READY_MASK");
    expect(ck10_output_signals_servo_ready(0x00000200u) == true, "ck10_output_signals_servo_ready");
    expect(ck10_output_signals_servo_ready((uint32_t)~0x00000200u) == false, "ck10_output_signals_servo_ready");
    expect(CK10_OUTPUT_SIGNALS_POINT_OUTPUT_0_MASK == 0x00001000u, "CK10_OUTPUT_SIGNALS_POINT_OUTPUT_0_MASK");
    expect(ck10_output_signals_point_output_0(0x00001000u) == true, "ck10_output_signals_point_output_0");
    expect(ck10_output_signals_point_output_0((uint32_t)~0x00001000u) == false, "ck10_output_signals_point_output_0");
    expect(CK10_OUTPUT_SIGNALS_POINT_OUTPUT_1_MASK == 0x00002000u, "CK10_OUTPUT_SIGNALS_POINT_OUTPUT_1_MASK");
    expect(ck10_output_signals_point_output_1(0x00002000u) == true, "ck10_output_signals_point_output_1");
    expect(ck10_output_signals_point_output_1((uint32_t)~0x00002000u) == false, "ck10_output_signals_point_output_1");
    expect(CK10_OUTPUT_SIGNALS_POINT_OUTPUT_2_MASK == 0x00004000u, "CK10_OUTPUT_SIGNALS_POINT_OUTPUT_2_MASK");
    expect(ck10_output_signals_point_output_2(0x00004000u) == true, "ck10_output_signals_point_output_2");
    expect(ck10_output_signals_point_output_2((uint32_t)~0x00004000u) == false, "ck10_output_signals_point_output_2");
    expect(CK10_OUTPUT_SIGNALS_USER_0_MASK == 0x00008000u, "CK10_OUTPUT_SIGNALS_USER_0_MASK");
    expect(ck10_output_signals_user_0(0x00008000u) == true, "ck10_output_signals_user_0");
    expect(ck10_output_signals_user_0((uint32_t)~0x00008000u) == false, "ck10_output_signals_user_0");
    expect(CK10_OUTPUT_SIGNALS_USER_1_MASK == 0x00010000u, "CK10_OUTPUT_SIGNALS_USER_1_MASK");
    expect(ck10_output_signals_user_1(0x00010000u) == true, "ck10_output_signals_user_1");
    expect(ck10_output_signals_user_1((uint32_t)~0x00010000u) == false, "ck10_output_signals_user_1");
    expect(CK10_OUTPUT_SIGNALS_USER_2_MASK == 0x00020000u, "CK10_OUTPUT_SIGNALS_USER_2_MASK");
    expect(ck10_output_signals_user_2(0x00020000u) == true, "ck10_output_signals_user_2");
    expect(ck10_output_signals_user_2((uint32_t)~0x00020000u) == false, "ck10_output_signals_user_2");
    expect(CK10_OUTPUT_SIGNALS_USER_3_MASK == 0x00040000u, "CK10_OUTPUT_SIGNALS_USER_3_MASK");
    expect(ck10_output_signals_user_3(0x00040000u) == true, "ck10_output_signals_user_3");
    expect(ck10_output_signals_user_3((uint32_t)~0x00040000u) == false, "ck10_output_signals_user_3");
    expect(CK10_OUTPUT_SIGNALS_USER_4_MASK == 0x00080000u, "CK10_OUTPUT_SIGNALS_USER_4_MASK");
    expect(ck10_output_signals_user_4(0x00080000u) == true, "ck10_output_signals_user_4");
    expect(ck10_output_signals_user_4((uint32_t)~0x00080000u) == false, "ck10_output_signals_user_4");
    expect(CK10_OUTPUT_SIGNALS_USER_5_MASK == 0x00100000u, "CK10_OUTPUT_SIGNALS_USER_5_MASK");
    expect(ck10_output_signals_user_5(0x00100000u) == true, "ck10_output_signals_user_5");
    expect(ck10_output_signals_user_5((uint32_t)~0x00100000u) == false, "ck10_output_signals_user_5");
    expect(CK10_OUTPUT_SIGNALS_USER_6_MASK == 0x00200000u, "CK10_OUTPUT_SIGNALS_USER_6_MASK");
    expect(ck10_output_signals_user_6(0x00200000u) == true, "ck10_output_signals_user_6");
    expect(ck10_output_signals_user_6((uint32_t)~0x00200000u) == false, "ck10_output_signals_user_6");
    expect(CK10_OUTPUT_SIGNALS_USER_7_MASK == 0x00400000u, "CK10_OUTPUT_SIGNALS_USER_7_MASK");
    expect(ck10_output_signals_user_7(0x00400000u) == true, "ck10_output_signals_user_7");
    expect(ck10_output_signals_user_7((uint32_t)~0x00400000u) == false, "ck10_output_signals_user_7");
    expect(CK10_OUTPUT_SIGNALS_USER_8_MASK == 0x00800000u, "CK10_OUTPUT_SIGNALS_USER_8_MASK");
    expect(ck10_output_signals_user_8(0x00800000u) == true, "ck10_output_signals_user_8");
    expect(ck10_output_signals_user_8((uint32_t)~0x00800000u) == false, "ck10_output_signals_user_8");
    expect(CK10_USER_INPUTS_USER_0_MASK == 0x0001u, "CK10_USER_INPUTS_USER_0_MASK");
    expect(ck10_user_inputs_user_0(0x0001u) == true, "ck10_user_inputs_user_0");
    expect(ck10_user_inputs_user_0((uint16_t)~0x0001u) == false, "ck10_user_inputs_user_0");
    expect(CK10_USER_INPUTS_USER_1_MASK == 0x0002u, "CK10_USER_INPUTS_USER_1_MASK");
    expect(ck10_user_inputs_user_1(0x0002u) == true, "ck10_user_inputs_user_1");
    expect(ck10_user_inputs_user_1((uint16_t)~0x0002u) == false, "ck10_user_inputs_user_1");
    expect(CK10_USER_INPUTS_USER_2_MASK == 0x0004u, "CK10_USER_INPUTS_USER_2_MASK");
    expect(ck10_user_inputs_user_2(0x0004u) == true, "ck10_user_inputs_user_2");
    expect(ck10_user_inputs_user_2((uint16_t)~0x0004u) == false, "ck10_user_inputs_user_2");
    expect(CK10_USER_INPUTS_USER_3_MASK == 0x0008u, "CK10_USER_INPUTS_USER_3_MASK");
    expect(ck10_user_inputs_user_3(0x0008u) == true, "ck10_user_inputs_user_3");
    expect(ck10_user_inputs_user_3((uint16_t)~0x0008u) == false, "ck10_user_inputs_user_3");
    expect(CK10_USER_INPUTS_USER_4_MASK == 0x0010u, "CK10_USER_INPUTS_USER_4_MASK");
    expect(ck10_user_inputs_user_4(0x0010u) == true, "ck10_user_inputs_user_4");
    expect(ck10_user_inputs_user_4((uint16_t)~0x0010u) == false, "ck10_user_inputs_user_4");
    expect(CK10_USER_INPUTS_USER_5_MASK == 0x0020u, "CK10_USER_INPUTS_USER_5_MASK");
    expect(ck10_user_inputs_user_5(0x0020u) == true, "ck10_user_inputs_user_5");
    expect(ck10_user_inputs_user_5((uint16_t)~0x0020u) == false, "ck10_user_inputs_user_5");
    expect(CK10_USER_INPUTS_USER_6_MASK == 0x0040u, "CK10_USER_INPUTS_USER_6_MASK");
    expect(ck10_user_inputs_user_6(0x0040u) == true, "ck10_user_inputs_user_6");
    expect(ck10_user_inputs_user_6((uint16_t)~0x0040u) == false, "ck10_user_inputs_user_6");
    expect(CK10_USER_INPUTS_USER_7_MASK == 0x0080u, "CK10_USER_INPUTS_USER_7_MASK");
    expect(ck10_user_inputs_user_7(0x0080u) == true, "ck10_user_inputs_user_7");
    expect(ck10_user_inputs_user_7((uint16_t)~0x0080u) == false, "ck10_user_inputs_user_7");
    expect(CK10_USER_INPUTS_USER_8_MASK == 0x0100u, "CK10_USER_INPUTS_USER_8_MASK");
    expect(ck10_user_inputs_user_8(0x0100u) == true, "ck10_user_inputs_user_8");
    expect(ck10_user_inputs_user_8((uint16_t)~0x0100u) == false, "ck10_user_inputs_user_8");
    expect(CK10_USER_OUTPUTS_USER_0_MASK == 0x0001u, "CK10_USER_OUTPUTS_USER_0_MASK");
    expect(ck10_user_outputs_user_0(0x0001u) == true, "ck10_user_outputs_user_0");
    expect(ck10_user_outputs_user_0((uint16_t)~0x0001u) == false, "ck10_user_outputs_user_0");
    expect(CK10_USER_OUTPUTS_USER_1_MASK == 0x0002u, "CK10_USER_OUTPUTS_USER_1_MASK");
    expect(ck10_user_outputs_user_1(0x0002u) == true, "ck10_user_outputs_user_1");
    expect(ck10_user_outputs_user_1((uint16_t)~0x0002u) == false, "ck10_user_outputs_user_1");
    expect(CK10_USER_OUTPUTS_USER_2_MASK == 0x0004u, "CK10_USER_OUTPUTS_USER_2_MASK");
    expect(ck10_user_outputs_user_2(0x0004u) == true, "ck10_user_outputs_user_2");
    expect(ck10_user_outputs_user_2((uint16_t)~0x0004u) == false, "ck10_user_outputs_user_2");
    expect(CK10_USER_OUTPUTS_USER_3_MASK == 0x0008u, "CK10_USER_OUTPUTS_USER_3_MASK");
    expect(ck10_user_outputs_user_3(0x0008u) == true, "ck10_user_outputs_user_3");
    expect(ck10_user_outputs_user_3((uint16_t)~0x0008u) == false, "ck10_user_outputs_user_3");
    expect(CK10_USER_OUTPUTS_USER_4_MASK == 0x0010u, "CK10_USER_OUTPUTS_USER_4_MASK");
    expect(ck10_user_outputs_user_4(0x0010u) == true, "ck10_user_outputs_user_4");
    expect(ck10_user_outputs_user_4((uint16_t)~0x0010u) == false, "ck10_user_outputs_user_4");
    expect(CK10_USER_OUTPUTS_USER_5_MASK == 0x0020u, "CK10_USER_OUTPUTS_USER_5_MASK");
    expect(ck10_user_outputs_user_5(0x0020u) == true, "ck10_user_outputs_user_5");
    expect(ck10_user_outputs_user_5((uint16_t)~0x0020u) == false, "ck10_user_outputs_user_5");
    expect(CK10_USER_OUTPUTS_USER_6_MASK == 0x0040u, "CK10_USER_OUTPUTS_USER_6_MASK");
    expect(ck10_user_outputs_user_6(0x0040u) == true, "ck10_user_outputs_user_6");
    expect(ck10_user_outputs_user_6((uint16_t)~0x0040u) == false, "ck10_user_outputs_user_6");
    expect(CK10_USER_OUTPUTS_USER_7_MASK == 0x0080u, "CK10_USER_OUTPUTS_USER_7_MASK");
    expect(ck10_user_outputs_user_7(0x0080u) == true, "ck10_user_outputs_user_7");
    expect(ck10_user_outputs_user_7((uint16_t)~0x0080u) == false, "ck10_user_outputs_user_7");
    expect(CK10_USER_OUTPUTS_USER_8_MASK == 0x0100u, "CK10_USER_OUTPUTS_USER_8_MASK");
    expect(ck10_user_outputs_user_8(0x0100u) == true, "ck10_user_outputs_user_8");
    expect(ck10_user_outputs_user_8((uint16_t)~0x0100u) == false, "ck10_user_outputs_user_8");
    expect(CK10_POINT_OUTPUT_SETTING_POINT_OUTPUT_0_MASK == 0x0001u, "CK10_POINT_OUTPUT_SETTING_POINT_OUTPUT_0_MASK");
    expect(ck10_point_output_setting_point_output_0(0x0001u) == true, "ck10_point_output_setting_point_output_0");
    expect(ck10_point_output_setting_point_output_0((uint16_t)~0x0001u) == false, "ck10_point_output_setting_point_output_0");
    expect(CK10_POINT_OUTPUT_SETTING_POINT_OUTPUT_1_MASK == 0x0002u, "CK10_POINT_OUTPUT_SETTING_POINT_OUTPUT_1_MASK");
    expect(ck10_point_output_setting_point_output_1(0x0002u) == true, "ck10_point_output_setting_point_output_1");
    expect(ck10_point_output_setting_point_output_1((uint16_t)~0x0002u) == false, "ck10_point_output_setting_point_output_1");
    expect(CK10_POINT_OUTPUT_SETTING_POINT_OUTPUT_2_MASK == 0x0004u, "CK10_POINT_OUTPUT_SETTING_POINT_OUTPUT_2_MASK");
    expect(ck10_point_output_setting_point_output_2(0x0004u) == true, "ck10_point_output_setting_point_output_2");
    expect(ck10_point_output_setting_point_output_2((uint16_t)~0x0004u) == false, "ck10_point_output_setting_point_output_2");
    expect(CK10_POINT_OUTPUT_SETTING_MOMENT_MASK == 0x0018u, "CK10_POINT_OUTPUT_SETTING_MOMENT_MASK");
    expect(ck10_point_output_setting_moment(0x0018u) == 3u, "ck10_point_output_setting_moment");
    expect(ck10_point_output_setting_moment((uint16_t)~0x0018u) == 0, "ck10_point_output_setting_moment");
}

static void test_1(void)
{
    expect(ck10_push_status_known(INT64_C(0)) == true, "ck10_push_status_known");
    expect(ck10_push_status_known(INT64_C(1)) == true, "ck10_push_status_known");
    expect(ck10_push_status_known(INT64_C(2)) == true, "ck10_push_status_known");
    expect(ck10_push_status_known(INT64_C(3)) == true, "ck10_push_status_known");
    expect(ck10_push_status_known(INT64_C(4)) == false, "ck10_push_status_known");
    expect(ck10_move_kind_known(INT64_C(1)) == true, "ck10_move_kind_known");
    expect(ck10_move_kind_known(INT64_C(2)) == true, "ck10_move_kind_known");
    expect(ck10_move_kind_known(INT64_C(3)) == false, "ck10_move_kind_known");
    expect(ck10_jog_direction_known(INT64_C(0)) == true, "ck10_jog_direction_known");
    expect(ck10_jog_direction_known(INT64_C(1)) == true, "ck10_jog_direction_known");
    expect(ck10_jog_direction_known(INT64_C(2)) == false, "ck10_jog_direction_known");
    expect(ck10_push_mode_known(INT64_C(0)) == true, "ck10_push_mode_known");
    expect(ck10_push_mode_known(INT64_C(1)) == true, "ck10_push_mode_known");
    expect(ck10_push_mode_known(INT64_C(2)) == false, "ck10_push_mode_known");
    expect(ck10_stop_kind_known(INT64_C(0)) == true, "ck10_stop_kind_known");
    expect(ck10_stop_kind_known(INT64_C(1)) == true, "ck10_stop_kind_known");
    expect(ck10_stop_kind_known(INT64_C(2)) == false, "ck10_stop_kind_known");
    expect(ck10_point_table_command_known(INT64_C(1)) == true, "ck10_point_table_command_known");
    expect(ck10_point_table_command_known(INT64_C(2)) == true, "ck10_point_table_command_known");
    expect(ck10_point_table_command_known(INT64_C(3)) == true, "ck10_point_table_command_known");
    expect(ck10_point_table_command_known(INT64_C(4)) == false, "ck10_point_table_command_known");
    expect(ck10_soft_limit_stop_known(INT64_C(0)) == true, "ck10_soft_limit_stop_known");
    expect(ck10_soft_limit_stop_known(INT64_C(1)) == true, "ck10_soft_limit_stop_known");
    expect(ck10_soft_limit_stop_known(INT64_C(2)) == true, "ck10_soft_limit_stop_known");
    expect(ck10_soft_limit_stop_known(INT64_C(3)) == false, "ck10_soft_limit_stop_known");
    expect(ck10_hard_limit_stop_known(INT64_C(0)) == true, "ck10_hard_limit_stop_known");
    expect(ck10_hard_limit_stop_known(INT64_C(1)) == true, "ck10_hard_limit_stop_known");
    expect(ck10_hard_limit_stop_known(INT64_C(2)) == false, "ck10_hard_limit_stop_known");
    expect(ck10_homing_method_known(INT64_C(0)) == true, "ck10_homing_method_known");
    expect(ck10_homing_method_known(INT64_C(1)) == true, "ck10_homing_method_known");
    expect(ck10_homing_method_known(INT64_C(2)) == true, "ck10_homing_method_known");
    expect(ck10_homing_method_known(INT64_C(3)) == true, "ck10_homing_method_known");
    expect(ck10_homing_method_known(INT64_C(4)) == true, "ck10_homing_method_known");
    expect(ck10_homing_method_known(INT64_C(5)) == true, "ck10_homing_method_known");
    expect(ck10_homing_method_known(INT64_C(6)) == true, "ck10_homing_method_known");
    expect(ck10_homing_method_known(INT64_C(7)) == true, "ck10_homing_method_known");
    expect(ck10_homing_method_known(INT64_C(8)) == false, "ck10_homing_method_known");
    expect(ck10_rotation_known(INT64_C(0)) == true, "ck10_rotation_known");
    expect(ck10_rotation_known(INT64_C(1)) == true, "ck10_rotation_known");
    expect(ck10_rotation_known(INT64_C(2)) == false, "ck10_rotation_known");
    expect(ck10_emergency_stop_mode_known(INT64_C(0)) == true, "ck10_emergency_stop_mode_known");
    expect(ck10_emergency_stop_mode_known(INT64_C(1)) == true, "ck10_emergency_stop_mode_known");
    expect(ck10_emergency_stop_mode_known(INT64_C(2)) == true, "ck10_emergency_stop_mode_known");
    expect(ck10_emergency_stop_mode_known(INT64_C(3)) == true, "ck10_emergency_stop_mode_known");
    expect(ck10_emergency_stop_mode_known(INT64_C(4)) == true, "ck10_emergency_stop_mode_known");
    expect(ck10_emergency_stop_mode_known(INT64_C(5)) == false, "ck10_emergency_stop_mode_known");
    expect(ck10_emergency_brake_mode_known(INT64_C(0)) == true, "ck10_emergency_brake_mode_known");
    expect(ck10_emergency_brake_mode_known(INT64_C(1)) == true, "ck10_emergency_brake_mode_known");
    expect(ck10_emergency_brake_mode_known(INT64_C(2)) == false, "ck10_emergency_brake_mode_known");
    expect(ck10_operation_mode_known(INT64_C(0)) == true, "ck10_operation_mode_known");
    expect(ck10_operation_mode_known(INT64_C(1)) == true, "ck10_operation_mode_known");
    expect(ck10_operation_mode_known(INT64_C(2)) == true, "ck10_operation_mode_known");
    expect(ck10_operation_mode_known(INT64_C(3)) == true, "ck10_operation_mode_known");
    expect(ck10_operation_mode_known(INT64_C(4)) == true, "ck10_operation_mode_known");
    expect(ck10_operation_mode_known(INT64_C(5)) == true, "ck10_operation_mode_known");
    expect(ck10_operation_mode_known(INT64_C(6)) == false, "ck10_operation_mode_known");
    expect(ck10_switch_function_known(INT64_C(0)) == true, "ck10_switch_function_known");
    expect(ck10_switch_function_known(INT64_C(1)) == true, "ck10_switch_function_known");
    expect(ck10_switch_function_known(INT64_C(2)) == false, "ck10_switch_function_known");
    expect(ck10_baud_rate_known(INT64_C(0)) == true, "ck10_baud_rate_known");
    expect(ck10_baud_rate_known(INT64_C(1)) == true, "ck10_baud_rate_known");
    expect(ck10_baud_rate_known(INT64_C(2)) == true, "ck10_baud_rate_known");
    expect(ck10_baud_rate_known(INT64_C(3)) == true, "ck10_baud_rate_known");
    expect(ck10_baud_rate_known(INT64_C(4)) == true, "ck10_baud_rate_known");
    expect(ck10_baud_rate_known(INT64_C(5)) == false, "ck10_baud_rate_known");
    expect(ck10_enabled_known(INT64_C(0)) == true, "ck10_enabled_known");
    expect(ck10_enabled_known(INT64_C(1)) == true, "ck10_enabled_known");
    expect(ck10_enabled_known(INT64_C(2)) == false, "ck10_enabled_known");
    expect(ck10_polarity_known(INT64_C(0)) == true, "ck10_polarity_known");
    expect(ck10_polarity_known(INT64_C(1)) == true, "ck10_polarity_known");
    expect(ck10_polarity_known(INT64_C(2)) == false, "ck10_polarity_known");
    expect(ck10_point_command_known(INT64_C(0)) == true, "ck10_point_command_known");
    expect(ck10_point_command_known(INT64_C(1)) == true, "ck10_point_command_known");
    expect(ck10_point_command_known(INT64_C(2)) == true, "ck10_point_command_known");
    expect(ck10_point_command_known(INT64_C(3)) == true, "ck10_point_command_known");
    expect(ck10_point_command_known(INT64_C(4)) == true, "ck10_point_command_known");
    expect(ck10_point_command_known(INT64_C(5)) == true, "ck10_point_command_known");
    expect(ck10_point_command_known(INT64_C(6)) == true, "ck10_point_command_known");
    expect(ck10_point_command_known(INT64_C(7)) == true, "ck10_point_command_known");
    expect(ck10_point_command_known(INT64_C(8)) == true, "ck10_point_command_known");
    expect(ck10_point_command_known(INT64_C(9)) == true, "ck10_point_command_known");
    expect(ck10_point_command_known(INT64_C(10)) == true, "ck10_point_command_known");
    expect(ck10_point_command_known(INT64_C(11)) == true, "ck10_point_command_known");
    expect(ck10_point_command_known(INT64_C(12)) == false, "ck10_point_command_known");
    expect(ck10_output_moment_known(INT64_C(0)) == true, "ck10_output_moment_known");
    expect(ck10_output_moment_known(INT64_C(1)) == true, "ck10_output_moment_known");
    expect(ck10_output_moment_known(INT64_C(2)) == true, "ck10_output_moment_known");
    expect(ck10_output_moment_known(INT64_C(3)) == false, "ck10_output_moment_known");
    expect(ck10_check_in_position_known(INT64_C(0)) == true, "ck10_check_in_position_known");
    expect(ck10_check_in_position_known(INT64_C(1)) == true, "ck10_check_in_position_known");
    expect(ck10_check_in_position_known(INT64_C(2)) == false, "ck10_check_in_position_known");
}

static void test_2(void)
{
    expect(ck10_exception_code_text(INT64_C(1)) != NULL && ck10_exception_code_text(INT64_C(1))->number == (-INT64_C(1)) && same_text(ck10_exception_code_text(INT64_C(1))->name, "illegal_function") && same_text(ck10_exception_code_text(INT64_C(1))->printed, ""), "ck10_exception_code_text");
    expect(ck10_exception_code_text(INT64_C(2)) != NULL && ck10_exception_code_text(INT64_C(2))->number == (-INT64_C(1)) && same_text(ck10_exception_code_text(INT64_C(2))->name, "illegal_data_address") && same_text(ck10_exception_code_text(INT64_C(2))->printed, ""), "ck10_exception_code_text");
    expect(ck10_exception_code_text(INT64_C(3)) != NULL && ck10_exception_code_text(INT64_C(3))->number == (-INT64_C(1)) && same_text(ck10_exception_code_text(INT64_C(3))->name, "illegal_data_value") && same_text(ck10_exception_code_text(INT64_C(3))->printed, ""), "ck10_exception_code_text");
    expect(ck10_exception_code_text(INT64_C(4)) != NULL && ck10_exception_code_text(INT64_C(4))->number == (-INT64_C(1)) && same_text(ck10_exception_code_text(INT64_C(4))->name, "device_failure") && same_text(ck10_exception_code_text(INT64_C(4))->printed, ""), "ck10_exception_code_text");
    expect(ck10_exception_code_text(INT64_C(0)) == NULL, "ck10_exception_code_text");
    expect(ck10_alarm_code_text(INT64_C(0)) != NULL && ck10_alarm_code_text(INT64_C(0))->number == (-INT64_C(1)) && same_text(ck10_alarm_code_text(INT64_C(0))->name, "no_alarm") && same_text(ck10_alarm_code_text(INT64_C(0))->printed, ""), "ck10_alarm_code_text");
    expect(ck10_alarm_code_text(INT64_C(1)) != NULL && ck10_alarm_code_text(INT64_C(1))->number == (-INT64_C(1)) && same_text(ck10_alarm_code_text(INT64_C(1))->name, "overcurrent") && same_text(ck10_alarm_code_text(INT64_C(1))->printed, ""), "ck10_alarm_code_text");
    expect(ck10_alarm_code_text(INT64_C(2)) != NULL && ck10_alarm_code_text(INT64_C(2))->number == (-INT64_C(1)) && same_text(ck10_alarm_code_text(INT64_C(2))->name, "overspeed") && same_text(ck10_alarm_code_text(INT64_C(2))->printed, ""), "ck10_alarm_code_text");
    expect(ck10_alarm_code_text(INT64_C(3)) != NULL && ck10_alarm_code_text(INT64_C(3))->number == (-INT64_C(1)) && same_text(ck10_alarm_code_text(INT64_C(3))->name, "position_tracking") && same_text(ck10_alarm_code_text(INT64_C(3))->printed, ""), "ck10_alarm_code_text");
    expect(ck10_alarm_code_text(INT64_C(4)) != NULL && ck10_alarm_code_text(INT64_C(4))->number == (-INT64_C(1)) && same_text(ck10_alarm_code_text(INT64_C(4))->name, "overload") && same_text(ck10_alarm_code_text(INT64_C(4))->printed, ""), "ck10_alarm_code_text");
    expect(ck10_alarm_code_text(INT64_C(5)) != NULL && ck10_alarm_code_text(INT64_C(5))->number == (-INT64_C(1)) && same_text(ck10_alarm_code_text(INT64_C(5))->name, "overheat") && same_text(ck10_alarm_code_text(INT64_C(5))->printed, ""), "ck10_alarm_code_text");
    expect(ck10_alarm_code_text(INT64_C(6)) != NULL && ck10_alarm_code_text(INT64_C(6))->number == (-INT64_C(1)) && same_text(ck10_alarm_code_text(INT64_C(6))->name, "back_emf") && same_text(ck10_alarm_code_text(INT64_C(6))->printed, ""), "ck10_alarm_code_text");
    expect(ck10_alarm_code_text(INT64_C(7)) != NULL && ck10_alarm_code_text(INT64_C(7))->number == (-INT64_C(1)) && same_text(ck10_alarm_code_text(INT64_C(7))->name, "motor_connection") && same_text(ck10_alarm_code_text(INT64_C(7))->printed, ""), "ck10_alarm_code_text");
    expect(ck10_alarm_code_text(INT64_C(8)) != NULL && ck10_alarm_code_text(INT64_C(8))->number == (-INT64_C(1)) && same_text(ck10_alarm_code_text(INT64_C(8))->name, "encoder_connection") && same_text(ck10_alarm_code_text(INT64_C(8))->printed, ""), "ck10_alarm_code_text");
    expect(ck10_alarm_code_text(INT64_C(10)) != NULL && ck10_alarm_code_text(INT64_C(10))->number == (-INT64_C(1)) && same_text(ck10_alarm_code_text(INT64_C(10))->name, "in_position_error") && same_text(ck10_alarm_code_text(INT64_C(10))->printed, ""), "ck10_alarm_code_text");
    expect(ck10_alarm_code_text(INT64_C(12)) != NULL && ck10_alarm_code_text(INT64_C(12))->number == (-INT64_C(1)) && same_text(ck10_alarm_code_text(INT64_C(12))->name, "memory") && same_text(ck10_alarm_code_text(INT64_C(12))->printed, ""), "ck10_alarm_code_text");
    expect(ck10_alarm_code_text(INT64_C(15)) != NULL && ck10_alarm_code_text(INT64_C(15))->number == (-INT64_C(1)) && same_text(ck10_alarm_code_text(INT64_C(15))->name, "position_overflow") && same_text(ck10_alarm_code_text(INT64_C(15))->printed, ""), "ck10_alarm_code_text");
    expect(ck10_alarm_code_text(INT64_C(9)) == NULL, "ck10_alarm_code_text");
}

static void test_3(void)
{
    expect(CK10_READ_REGISTERS_CODE == 3u, "CK10_READ_REGISTERS_CODE");
    expect(CK10_WRITE_REGISTER_CODE == 6u, "CK10_WRITE_REGISTER_CODE");
    expect(CK10_WRITE_REGISTERS_CODE == 16u, "CK10_WRITE_REGISTERS_CODE");
    expect(CK10_REPORT_SERVER_ID_CODE == 17u, "CK10_REPORT_SERVER_ID_CODE");
}

static void test_4(void)
{
    expect(CK10_REG_AXIS_START_SPEED_ADDRESS == 2000u, "CK10_REG_AXIS_START_SPEED_ADDRESS");
    expect(CK10_REG_AXIS_ACCELERATION_TIME_ADDRESS == 2002u, "CK10_REG_AXIS_ACCELERATION_TIME_ADDRESS");
    expect(CK10_REG_AXIS_DECELERATION_TIME_ADDRESS == 2003u, "CK10_REG_AXIS_DECELERATION_TIME_ADDRESS");
    expect(CK10_REG_AXIS_MOVE_SPEED_ADDRESS == 2004u, "CK10_REG_AXIS_MOVE_SPEED_ADDRESS");
    expect(CK10_REG_TARGET_POSITION_OR_DISTANCE_ADDRESS == 2006u, "CK10_REG_TARGET_POSITION_OR_DISTANCE_ADDRESS");
    expect(CK10_REG_START_MOVE_ADDRESS == 2008u, "CK10_REG_START_MOVE_ADDRESS");
    expect(CK10_REG_AXIS_JOG_ACCELERATION_TIME_ADDRESS == 2009u, "CK10_REG_AXIS_JOG_ACCELERATION_TIME_ADDRESS");
    expect(CK10_REG_AXIS_JOG_START_SPEED_ADDRESS == 2010u, "CK10_REG_AXIS_JOG_START_SPEED_ADDRESS");
    expect(CK10_REG_AXIS_JOG_SPEED_ADDRESS == 2012u, "CK10_REG_AXIS_JOG_SPEED_ADDRESS");
    expect(CK10_REG_JOG_DIRECTION_ADDRESS == 2014u, "CK10_REG_JOG_DIRECTION_ADDRESS");
    expect(CK10_REG_START_JOG_ADDRESS == 2015u, "CK10_REG_START_JOG_ADDRESS");
    expect(CK10_REG_PUSH_START_SPEED_ADDRESS == 2016u, "CK10_REG_PUSH_START_SPEED_ADDRESS");
    expect(CK10_REG_PUSH_MOVE_SPEED_ADDRESS == 2018u, "CK10_REG_PUSH_MOVE_SPEED_ADDRESS");
    expect(CK10_REG_PUSH_ACCELERATION_TIME_ADDRESS == 2020u, "CK10_REG_PUSH_ACCELERATION_TIME_ADDRESS");
    expect(CK10_REG_PUSH_DECELERATION_TIME_ADDRESS == 2021u, "CK10_REG_PUSH_DECELERATION_TIME_ADDRESS");
    expect(CK10_REG_PUSH_MODE_ADDRESS == 2022u, "CK10_REG_PUSH_MODE_ADDRESS");
    expect(CK10_REG_PUSH_TORQUE_RATIO_ADDRESS == 2023u, "CK10_REG_PUSH_TORQUE_RATIO_ADDRESS");
    expect(CK10_REG_PUSH_SPEED_ADDRESS == 2024u, "CK10_REG_PUSH_SPEED_ADDRESS");
    expect(CK10_REG_PUSH_START_POSITION_ADDRESS == 2026u, "CK10_REG_PUSH_START_POSITION_ADDRESS");
    expect(CK10_REG_PUSH_END_POSITION_ADDRESS == 2028u, "CK10_REG_PUSH_END_POSITION_ADDRESS");
    expect(CK10_REG_START_PUSH_MOTION_ADDRESS == 2030u, "CK10_REG_START_PUSH_MOTION_ADDRESS");
    expect(CK10_REG_START_HOMING_ADDRESS == 2031u, "CK10_REG_START_HOMING_ADDRESS");
    expect(CK10_REG_STOP_ADDRESS == 2032u, "CK10_REG_STOP_ADDRESS");
    expect(CK10_REG_SERVO_ADDRESS == 2033u, "CK10_REG_SERVO_ADDRESS");
    expect(CK10_REG_CLEAR_POSITION_ADDRESS == 2034u, "CK10_REG_CLEAR_POSITION_ADDRESS");
    expect(CK10_REG_RESET_ALARM_ADDRESS == 2035u, "CK10_REG_RESET_ALARM_ADDRESS");
    expect(CK10_REG_SAVE_POINT_TABLE_ADDRESS == 2037u, "CK10_REG_SAVE_POINT_TABLE_ADDRESS");
    expect(CK10_REG_START_POINT_ADDRESS == 2038u, "CK10_REG_START_POINT_ADDRESS");
    expect(CK10_REG_RUN_POINT_TABLE_ADDRESS == 2039u, "CK10_REG_RUN_POINT_TABLE_ADDRESS");
    expect(CK10_REG_SAVE_ALL_PARAMETERS_ADDRESS == 2036u, "CK10_REG_SAVE_ALL_PARAMETERS_ADDRESS");
    expect(CK10_REG_COMPARE_START_POSITION_ADDRESS == 2040u, "CK10_REG_COMPARE_START_POSITION_ADDRESS");
    expect(CK10_REG_COMPARE_PERIOD_ADDRESS == 2042u, "CK10_REG_COMPARE_PERIOD_ADDRESS");
    expect(CK10_REG_COMPARE_PULSE_WIDTH_ADDRESS == 2044u, "CK10_REG_COMPARE_PULSE_WIDTH_ADDRESS");
    expect(CK10_REG_COMPARE_ENABLE_ADDRESS == 2045u, "CK10_REG_COMPARE_ENABLE_ADDRESS");
    expect(CK10_REG_COMPARE_ACTIVE_ADDRESS == 2046u, "CK10_REG_COMPARE_ACTIVE_ADDRESS");
    expect(CK10_REG_MODEL_ID_ADDRESS == 2100u, "CK10_REG_MODEL_ID_ADDRESS");
    expect(CK10_REG_HARDWARE_TYPE_ADDRESS == 2102u, "CK10_REG_HARDWARE_TYPE_ADDRESS");
    expect(CK10_REG_FIRMWARE_VERSION_ADDRESS == 2103u, "CK10_REG_FIRMWARE_VERSION_ADDRESS");
    expect(CK10_REG_POWER_CYCLES_ADDRESS == 2104u, "CK10_REG_POWER_CYCLES_ADDRESS");
    expect(CK10_REG_TURNS_TOTAL_ADDRESS == 2106u, "CK10_REG_TURNS_TOTAL_ADDRESS");
    expect(CK10_REG_TURNS_SINCE_POWER_ON_ADDRESS == 2110u, "CK10_REG_TURNS_SINCE_POWER_ON_ADDRESS");
    expect(CK10_REG_RESOLUTION_ADDRESS == 5000u, "CK10_REG_RESOLUTION_ADDRESS");
    expect(CK10_REG_MAXIMUM_SPEED_ADDRESS == 5002u, "CK10_REG_MAXIMUM_SPEED_ADDRESS");
    expect(CK10_REG_START_SPEED_ADDRESS == 5004u, "CK10_REG_START_SPEED_ADDRESS");
    expect(CK10_REG_ACCELERATION_TIME_ADDRESS == 5006u, "CK10_REG_ACCELERATION_TIME_ADDRESS");
    expect(CK10_REG_DECELERATION_TIME_ADDRESS == 5008u, "CK10_REG_DECELERATION_TIME_ADDRESS");
    expect(CK10_REG_RESERVED_5_ADDRESS == 5010u, "CK10_REG_RESERVED_5_ADDRESS");
    expect(CK10_REG_JOG_SPEED_ADDRESS == 5012u, "CK10_REG_JOG_SPEED_ADDRESS");
    expect(CK10_REG_JOG_START_SPEED_ADDRESS == 5014u, "CK10_REG_JOG_START_SPEED_ADDRESS");
    expect(CK10_REG_JOG_ACCELERATION_TIME_ADDRESS == 5016u, "CK10_REG_JOG_ACCELERATION_TIME_ADDRESS");
    expect(CK10_REG_POSITIVE_SOFT_LIMIT_ADDRESS == 5018u, "CK10_REG_POSITIVE_SOFT_LIMIT_ADDRESS");
    expect(CK10_REG_NEGATIVE_SOFT_LIMIT_ADDRESS == 5020u, "CK10_REG_NEGATIVE_SOFT_LIMIT_ADDRESS");
    expect(CK10_REG_SOFT_LIMIT_STOP_ADDRESS == 5022u, "CK10_REG_SOFT_LIMIT_STOP_ADDRESS");
    expect(CK10_REG_HARD_LIMIT_STOP_ADDRESS == 5024u, "CK10_REG_HARD_LIMIT_STOP_ADDRESS");
    expect(CK10_REG_RESERVED_13_ADDRESS == 5026u, "CK10_REG_RESERVED_13_ADDRESS");
    expect(CK10_REG_HOMING_SPEED_ADDRESS == 5028u, "CK10_REG_HOMING_SPEED_ADDRESS");
    expect(CK10_REG_HOMING_SEARCH_SPEED_ADDRESS == 5030u, "CK10_REG_HOMING_SEARCH_SPEED_ADDRESS");
    expect(CK10_REG_HOMING_ACCELERATION_TIME_ADDRESS == 5032u, "CK10_REG_HOMING_ACCELERATION_TIME_ADDRESS");
    expect(CK10_REG_HOMING_METHOD_ADDRESS == 5034u, "CK10_REG_HOMING_METHOD_ADDRESS");
    expect(CK10_REG_HOMING_DIRECTION_ADDRESS == 5036u, "CK10_REG_HOMING_DIRECTION_ADDRESS");
    expect(CK10_REG_HOMING_OFFSET_ADDRESS == 5038u, "CK10_REG_HOMING_OFFSET_ADDRESS");
    expect(CK10_REG_ORIGIN_POSITION_ADDRESS == 5040u, "CK10_REG_ORIGIN_POSITION_ADDRESS");
    expect(CK10_REG_RESERVED_21_ADDRESS == 5042u, "CK10_REG_RESERVED_21_ADDRESS");
    expect(CK10_REG_POSITION_LOOP_GAIN_ADDRESS == 5044u, "CK10_REG_POSITION_LOOP_GAIN_ADDRESS");
    expect(CK10_REG_IN_POSITION_RANGE_ADDRESS == 5046u, "CK10_REG_IN_POSITION_RANGE_ADDRESS");
    expect(CK10_REG_TRACKING_LIMIT_ADDRESS == 5048u, "CK10_REG_TRACKING_LIMIT_ADDRESS");
    expect(CK10_REG_MOTOR_DIRECTION_ADDRESS == 5050u, "CK10_REG_MOTOR_DIRECTION_ADDRESS");
    expect(CK10_REG_RESERVED_26_ADDRESS == 5052u, "CK10_REG_RESERVED_26_ADDRESS");
    expect(CK10_REG_HOMING_TORQUE_RATIO_ADDRESS == 5054u, "CK10_REG_HOMING_TORQUE_RATIO_ADDRESS");
    expect(CK10_REG_POSITION_OVERFLOW_LIMIT_ADDRESS == 5056u, "CK10_REG_POSITION_OVERFLOW_LIMIT_ADDRESS");
    expect(CK10_REG_RESERVED_29_ADDRESS == 5058u, "CK10_REG_RESERVED_29_ADDRESS");
    expect(CK10_REG_RUN_CURRENT_ADDRESS == 5060u, "CK10_REG_RUN_CURRENT_ADDRESS");
    expect(CK10_REG_BOOST_CURRENT_ADDRESS == 5062u, "CK10_REG_BOOST_CURRENT_ADDRESS");
    expect(CK10_REG_STOP_CURRENT_ADDRESS == 5064u, "CK10_REG_STOP_CURRENT_ADDRESS");
    expect(CK10_REG_EMERGENCY_STOP_MODE_ADDRESS == 5066u, "CK10_REG_EMERGENCY_STOP_MODE_ADDRESS");
    expect(CK10_REG_EMERGENCY_BRAKE_MODE_ADDRESS == 5068u, "CK10_REG_EMERGENCY_BRAKE_MODE_ADDRESS");
    expect(CK10_REG_OPERATION_MODE_ADDRESS == 5070u, "CK10_REG_OPERATION_MODE_ADDRESS");
    expect(CK10_REG_SWITCH_FUNCTION_ADDRESS == 5072u, "CK10_REG_SWITCH_FUNCTION_ADDRESS");
    expect(CK10_REG_BAUD_RATE_ADDRESS == 5074u, "CK10_REG_BAUD_RATE_ADDRESS");
    expect(CK10_REG_SAVE_POSITION_ADDRESS == 5076u, "CK10_REG_SAVE_POSITION_ADDRESS");
    expect(CK10_REG_SHOW_MOTOR_NUMBER_ADDRESS == 5078u, "CK10_REG_SHOW_MOTOR_NUMBER_ADDRESS");
    expect(CK10_REG_ASSIGNMENT_FLAGS_ADDRESS == 5080u, "CK10_REG_ASSIGNMENT_FLAGS_ADDRESS");
    expect(CK10_REG_INPUT_1_FUNCTION_ADDRESS == 5082u, "CK10_REG_INPUT_1_FUNCTION_ADDRESS");
    expect(CK10_REG_INPUT_2_FUNCTION_ADDRESS == 5084u, "CK10_REG_INPUT_2_FUNCTION_ADDRESS");
    expect(CK10_REG_INPUT_3_FUNCTION_ADDRESS == 5086u, "CK10_REG_INPUT_3_FUNCTION_ADDRESS");
    expect(CK10_REG_INPUT_4_FUNCTION_ADDRESS == 5088u, "CK10_REG_INPUT_4_FUNCTION_ADDRESS");
    expect(CK10_REG_INPUT_5_FUNCTION_ADDRESS == 5090u, "CK10_REG_INPUT_5_FUNCTION_ADDRESS");
    expect(CK10_REG_INPUT_6_FUNCTION_ADDRESS == 5092u, "CK10_REG_INPUT_6_FUNCTION_ADDRESS");
    expect(CK10_REG_INPUT_7_FUNCTION_ADDRESS == 5094u, "CK10_REG_INPUT_7_FUNCTION_ADDRESS");
    expect(CK10_REG_INPUT_8_FUNCTION_ADDRESS == 5096u, "CK10_REG_INPUT_8_FUNCTION_ADDRESS");
    expect(CK10_REG_INPUT_9_FUNCTION_ADDRESS == 5098u, "CK10_REG_INPUT_9_FUNCTION_ADDRESS");
    expect(CK10_REG_INPUT_10_FUNCTION_ADDRESS == 5100u, "CK10_REG_INPUT_10_FUNCTION_ADDRESS");
    expect(CK10_REG_INPUT_11_FUNCTION_ADDRESS == 5102u, "CK10_REG_INPUT_11_FUNCTION_ADDRESS");
    expect(CK10_REG_INPUT_12_FUNCTION_ADDRESS == 5104u, "CK10_REG_INPUT_12_FUNCTION_ADDRESS");
    expect(CK10_REG_OUTPUT_1_FUNCTION_ADDRESS == 5106u, "CK10_REG_OUTPUT_1_FUNCTION_ADDRESS");
    expect(CK10_REG_OUTPUT_2_FUNCTION_ADDRESS == 5108u, "CK10_REG_OUTPUT_2_FUNCTION_ADDRESS");
    expect(CK10_REG_OUTPUT_3_FUNCTION_ADDRESS == 5110u, "CK10_REG_OUTPUT_3_FUNCTION_ADDRESS");
    expect(CK10_REG_OUTPUT_4_FUNCTION_ADDRESS == 5112u, "CK10_REG_OUTPUT_4_FUNCTION_ADDRESS");
    expect(CK10_REG_OUTPUT_5_FUNCTION_ADDRESS == 5114u, "CK10_REG_OUTPUT_5_FUNCTION_ADDRESS");
    expect(CK10_REG_OUTPUT_6_FUNCTION_ADDRESS == 5116u, "CK10_REG_OUTPUT_6_FUNCTION_ADDRESS");
    expect(CK10_REG_OUTPUT_7_FUNCTION_ADDRESS == 5118u, "CK10_REG_OUTPUT_7_FUNCTION_ADDRESS");
    expect(CK10_REG_OUTPUT_8_FUNCTION_ADDRESS == 5120u, "CK10_REG_OUTPUT_8_FUNCTION_ADDRESS");
    expect(CK10_REG_OUTPUT_9_FUNCTION_ADDRESS == 5122u, "CK10_REG_OUTPUT_9_FUNCTION_ADDRESS");
    expect(CK10_REG_OUTPUT_10_FUNCTION_ADDRESS == 5124u, "CK10_REG_OUTPUT_10_FUNCTION_ADDRESS");
    expect(CK10_REG_INPUT_1_POLARITY_ADDRESS == 5126u, "CK10_REG_INPUT_1_POLARITY_ADDRESS");
    expect(CK10_REG_INPUT_2_POLARITY_ADDRESS == 5128u, "CK10_REG_INPUT_2_POLARITY_ADDRESS");
    expect(CK10_REG_INPUT_3_POLARITY_ADDRESS == 5130u, "CK10_REG_INPUT_3_POLARITY_ADDRESS");
    expect(CK10_REG_INPUT_4_POLARITY_ADDRESS == 5132u, "CK10_REG_INPUT_4_POLARITY_ADDRESS");
    expect(CK10_REG_INPUT_5_POLARITY_ADDRESS == 5134u, "CK10_REG_INPUT_5_POLARITY_ADDRESS");
    expect(CK10_REG_INPUT_6_POLARITY_ADDRESS == 5136u, "CK10_REG_INPUT_6_POLARITY_ADDRESS");
    expect(CK10_REG_INPUT_7_POLARITY_ADDRESS == 5138u, "CK10_REG_INPUT_7_POLARITY_ADDRESS");
    expect(CK10_REG_INPUT_8_POLARITY_ADDRESS == 5140u, "CK10_REG_INPUT_8_POLARITY_ADDRESS");
    expect(CK10_REG_INPUT_9_POLARITY_ADDRESS == 5142u, "CK10_REG_INPUT_9_POLARITY_ADDRESS");
    expect(CK10_REG_INPUT_10_POLARITY_ADDRESS == 5144u, "CK10_REG_INPUT_10_POLARITY_ADDRESS");
    expect(CK10_REG_INPUT_11_POLARITY_ADDRESS == 5146u, "CK10_REG_INPUT_11_POLARITY_ADDRESS");
    expect(CK10_REG_INPUT_12_POLARITY_ADDRESS == 5148u, "CK10_REG_INPUT_12_POLARITY_ADDRESS");
    expect(CK10_REG_OUTPUT_1_POLARITY_ADDRESS == 5150u, "CK10_REG_OUTPUT_1_POLARITY_ADDRESS");
    expect(CK10_REG_OUTPUT_2_POLARITY_ADDRESS == 5152u, "CK10_REG_OUTPUT_2_POLARITY_ADDRESS");
    expect(CK10_REG_OUTPUT_3_POLARITY_ADDRESS == 5154u, "CK10_REG_OUTPUT_3_POLARITY_ADDRESS");
    expect(CK10_REG_OUTPUT_4_POLARITY_ADDRESS == 5156u, "CK10_REG_OUTPUT_4_POLARITY_ADDRESS");
    expect(CK10_REG_OUTPUT_5_POLARITY_ADDRESS == 5158u, "CK10_REG_OUTPUT_5_POLARITY_ADDRESS");
    expect(CK10_REG_OUTPUT_6_POLARITY_ADDRESS == 5160u, "CK10_REG_OUTPUT_6_POLARITY_ADDRESS");
    expect(CK10_REG_OUTPUT_7_POLARITY_ADDRESS == 5162u, "CK10_REG_OUTPUT_7_POLARITY_ADDRESS");
    expect(CK10_REG_OUTPUT_8_POLARITY_ADDRESS == 5164u, "CK10_REG_OUTPUT_8_POLARITY_ADDRESS");
    expect(CK10_REG_OUTPUT_9_POLARITY_ADDRESS == 5166u, "CK10_REG_OUTPUT_9_POLARITY_ADDRESS");
    expect(CK10_REG_OUTPUT_10_POLARITY_ADDRESS == 5168u, "CK10_REG_OUTPUT_10_POLARITY_ADDRESS");
    expect(CK10_REG_FLASH_RESOLUTION_ADDRESS == 5200u, "CK10_REG_FLASH_RESOLUTION_ADDRESS");
    expect(CK10_REG_FLASH_MAXIMUM_SPEED_ADDRESS == 5202u, "CK10_REG_FLASH_MAXIMUM_SPEED_ADDRESS");
    expect(CK10_REG_FLASH_START_SPEED_ADDRESS == 5204u, "CK10_REG_FLASH_START_SPEED_ADDRESS");
    expect(CK10_REG_FLASH_ACCELERATION_TIME_ADDRESS == 5206u, "CK10_REG_FLASH_ACCELERATION_TIME_ADDRESS");
    expect(CK10_REG_FLASH_DECELERATION_TIME_ADDRESS == 5208u, "CK10_REG_FLASH_DECELERATION_TIME_ADDRESS");
    expect(CK10_REG_FLASH_RESERVED_5_ADDRESS == 5210u, "CK10_REG_FLASH_RESERVED_5_ADDRESS");
    expect(CK10_REG_FLASH_JOG_SPEED_ADDRESS == 5212u, "CK10_REG_FLASH_JOG_SPEED_ADDRESS");
    expect(CK10_REG_FLASH_JOG_START_SPEED_ADDRESS == 5214u, "CK10_REG_FLASH_JOG_START_SPEED_ADDRESS");
    expect(CK10_REG_FLASH_JOG_ACCELERATION_TIME_ADDRESS == 5216u, "CK10_REG_FLASH_JOG_ACCELERATION_TIME_ADDRESS");
    expect(CK10_REG_FLASH_POSITIVE_SOFT_LIMIT_ADDRESS == 5218u, "CK10_REG_FLASH_POSITIVE_SOFT_LIMIT_ADDRESS");
    expect(CK10_REG_FLASH_NEGATIVE_SOFT_LIMIT_ADDRESS == 5220u, "CK10_REG_FLASH_NEGATIVE_SOFT_LIMIT_ADDRESS");
    expect(CK10_REG_FLASH_SOFT_LIMIT_STOP_ADDRESS == 5222u, "CK10_REG_FLASH_SOFT_LIMIT_STOP_ADDRESS");
    expect(CK10_REG_FLASH_HARD_LIMIT_STOP_ADDRESS == 5224u, "CK10_REG_FLASH_HARD_LIMIT_STOP_ADDRESS");
    expect(CK10_REG_FLASH_RESERVED_13_ADDRESS == 5226u, "CK10_REG_FLASH_RESERVED_13_ADDRESS");
    expect(CK10_REG_FLASH_HOMING_SPEED_ADDRESS == 5228u, "CK10_REG_FLASH_HOMING_SPEED_ADDRESS");
    expect(CK10_REG_FLASH_HOMING_SEARCH_SPEED_ADDRESS == 5230u, "CK10_REG_FLASH_HOMING_SEARCH_SPEED_ADDRESS");
    expect(CK10_REG_FLASH_HOMING_ACCELERATION_TIME_ADDRESS == 5232u, "CK10_REG_FLASH_HOMING_ACCELERATION_TIME_ADDRESS");
    expect(CK10_REG_FLASH_HOMING_METHOD_ADDRESS == 5234u, "CK10_REG_FLASH_HOMING_METHOD_ADDRESS");
    expect(CK10_REG_FLASH_HOMING_DIRECTION_ADDRESS == 5236u, "CK10_REG_FLASH_HOMING_DIRECTION_ADDRESS");
    expect(CK10_REG_FLASH_HOMING_OFFSET_ADDRESS == 5238u, "CK10_REG_FLASH_HOMING_OFFSET_ADDRESS");
    expect(CK10_REG_FLASH_ORIGIN_POSITION_ADDRESS == 5240u, "CK10_REG_FLASH_ORIGIN_POSITION_ADDRESS");
    expect(CK10_REG_FLASH_RESERVED_21_ADDRESS == 5242u, "CK10_REG_FLASH_RESERVED_21_ADDRESS");
    expect(CK10_REG_FLASH_POSITION_LOOP_GAIN_ADDRESS == 5244u, "CK10_REG_FLASH_POSITION_LOOP_GAIN_ADDRESS");
    expect(CK10_REG_FLASH_IN_POSITION_RANGE_ADDRESS == 5246u, "CK10_REG_FLASH_IN_POSITION_RANGE_ADDRESS");
    expect(CK10_REG_FLASH_TRACKING_LIMIT_ADDRESS == 5248u, "CK10_REG_FLASH_TRACKING_LIMIT_ADDRESS");
    expect(CK10_REG_FLASH_MOTOR_DIRECTION_ADDRESS == 5250u, "CK10_REG_FLASH_MOTOR_DIRECTION_ADDRESS");
    expect(CK10_REG_FLASH_RESERVED_26_ADDRESS == 5252u, "CK10_REG_FLASH_RESERVED_26_ADDRESS");
    expect(CK10_REG_FLASH_HOMING_TORQUE_RATIO_ADDRESS == 5254u, "CK10_REG_FLASH_HOMING_TORQUE_RATIO_ADDRESS");
    expect(CK10_REG_FLASH_POSITION_OVERFLOW_LIMIT_ADDRESS == 5256u, "CK10_REG_FLASH_POSITION_OVERFLOW_LIMIT_ADDRESS");
    expect(CK10_REG_FLASH_RESERVED_29_ADDRESS == 5258u, "CK10_REG_FLASH_RESERVED_29_ADDRESS");
    expect(CK10_REG_FLASH_RUN_CURRENT_ADDRESS == 5260u, "CK10_REG_FLASH_RUN_CURRENT_ADDRESS");
    expect(CK10_REG_FLASH_BOOST_CURRENT_ADDRESS == 5262u, "CK10_REG_FLASH_BOOST_CURRENT_ADDRESS");
    expect(CK10_REG_FLASH_STOP_CURRENT_ADDRESS == 5264u, "CK10_REG_FLASH_STOP_CURRENT_ADDRESS");
    expect(CK10_REG_FLASH_EMERGENCY_STOP_MODE_ADDRESS == 5266u, "CK10_REG_FLASH_EMERGENCY_STOP_MODE_ADDRESS");
    expect(CK10_REG_FLASH_EMERGENCY_BRAKE_MODE_ADDRESS == 5268u, "CK10_REG_FLASH_EMERGENCY_BRAKE_MODE_ADDRESS");
    expect(CK10_REG_FLASH_OPERATION_MODE_ADDRESS == 5270u, "CK10_REG_FLASH_OPERATION_MODE_ADDRESS");
    expect(CK10_REG_FLASH_SWITCH_FUNCTION_ADDRESS == 5272u, "CK10_REG_FLASH_SWITCH_FUNCTION_ADDRESS");
    expect(CK10_REG_FLASH_BAUD_RATE_ADDRESS == 5274u, "CK10_REG_FLASH_BAUD_RATE_ADDRESS");
    expect(CK10_REG_FLASH_SAVE_POSITION_ADDRESS == 5276u, "CK10_REG_FLASH_SAVE_POSITION_ADDRESS");
    expect(CK10_REG_FLASH_SHOW_MOTOR_NUMBER_ADDRESS == 5278u, "CK10_REG_FLASH_SHOW_MOTOR_NUMBER_ADDRESS");
    expect(CK10_REG_FLASH_ASSIGNMENT_FLAGS_ADDRESS == 5280u, "CK10_REG_FLASH_ASSIGNMENT_FLAGS_ADDRESS");
    expect(CK10_REG_FLASH_INPUT_1_FUNCTION_ADDRESS == 5282u, "CK10_REG_FLASH_INPUT_1_FUNCTION_ADDRESS");
    expect(CK10_REG_FLASH_INPUT_2_FUNCTION_ADDRESS == 5284u, "CK10_REG_FLASH_INPUT_2_FUNCTION_ADDRESS");
    expect(CK10_REG_FLASH_INPUT_3_FUNCTION_ADDRESS == 5286u, "CK10_REG_FLASH_INPUT_3_FUNCTION_ADDRESS");
    expect(CK10_REG_FLASH_INPUT_4_FUNCTION_ADDRESS == 5288u, "CK10_REG_FLASH_INPUT_4_FUNCTION_ADDRESS");
    expect(CK10_REG_FLASH_INPUT_5_FUNCTION_ADDRESS == 5290u, "CK10_REG_FLASH_INPUT_5_FUNCTION_ADDRESS");
    expect(CK10_REG_FLASH_INPUT_6_FUNCTION_ADDRESS == 5292u, "CK10_REG_FLASH_INPUT_6_FUNCTION_ADDRESS");
    expect(CK10_REG_FLASH_INPUT_7_FUNCTION_ADDRESS == 5294u, "CK10_REG_FLASH_INPUT_7_FUNCTION_ADDRESS");
    expect(CK10_REG_FLASH_INPUT_8_FUNCTION_ADDRESS == 5296u, "CK10_REG_FLASH_INPUT_8_FUNCTION_ADDRESS");
    expect(CK10_REG_FLASH_INPUT_9_FUNCTION_ADDRESS == 5298u, "CK10_REG_FLASH_INPUT_9_FUNCTION_ADDRESS");
    expect(CK10_REG_FLASH_INPUT_10_FUNCTION_ADDRESS == 5300u, "CK10_REG_FLASH_INPUT_10_FUNCTION_ADDRESS");
    expect(CK10_REG_FLASH_INPUT_11_FUNCTION_ADDRESS == 5302u, "CK10_REG_FLASH_INPUT_11_FUNCTION_ADDRESS");
    expect(CK10_REG_FLASH_INPUT_12_FUNCTION_ADDRESS == 5304u, "CK10_REG_FLASH_INPUT_12_FUNCTION_ADDRESS");
    expect(CK10_REG_FLASH_OUTPUT_1_FUNCTION_ADDRESS == 5306u, "CK10_REG_FLASH_OUTPUT_1_FUNCTION_ADDRESS");
    expect(CK10_REG_FLASH_OUTPUT_2_FUNCTION_ADDRESS == 5308u, "CK10_REG_FLASH_OUTPUT_2_FUNCTION_ADDRESS");
    expect(CK10_REG_FLASH_OUTPUT_3_FUNCTION_ADDRESS == 5310u, "CK10_REG_FLASH_OUTPUT_3_FUNCTION_ADDRESS");
    expect(CK10_REG_FLASH_OUTPUT_4_FUNCTION_ADDRESS == 5312u, "CK10_REG_FLASH_OUTPUT_4_FUNCTION_ADDRESS");
    expect(CK10_REG_FLASH_OUTPUT_5_FUNCTION_ADDRESS == 5314u, "CK10_REG_FLASH_OUTPUT_5_FUNCTION_ADDRESS");
    expect(CK10_REG_FLASH_OUTPUT_6_FUNCTION_ADDRESS == 5316u, "CK10_REG_FLASH_OUTPUT_6_FUNCTION_ADDRESS");
    expect(CK10_REG_FLASH_OUTPUT_7_FUNCTION_ADDRESS == 5318u, "CK10_REG_FLASH_OUTPUT_7_FUNCTION_ADDRESS");
    expect(CK10_REG_FLASH_OUTPUT_8_FUNCTION_ADDRESS == 5320u, "CK10_REG_FLASH_OUTPUT_8_FUNCTION_ADDRESS");
    expect(CK10_REG_FLASH_OUTPUT_9_FUNCTION_ADDRESS == 5322u, "CK10_REG_FLASH_OUTPUT_9_FUNCTION_ADDRESS");
    expect(CK10_REG_FLASH_OUTPUT_10_FUNCTION_ADDRESS == 5324u, "CK10_REG_FLASH_OUTPUT_10_FUNCTION_ADDRESS");
    expect(CK10_REG_FLASH_INPUT_1_POLARITY_ADDRESS == 5326u, "CK10_REG_FLASH_INPUT_1_POLARITY_ADDRESS");
    expect(CK10_REG_FLASH_INPUT_2_POLARITY_ADDRESS == 5328u, "CK10_REG_FLASH_INPUT_2_POLARITY_ADDRESS");
    expect(CK10_REG_FLASH_INPUT_3_POLARITY_ADDRESS == 5330u, "CK10_REG_FLASH_INPUT_3_POLARITY_ADDRESS");
    expect(CK10_REG_FLASH_INPUT_4_POLARITY_ADDRESS == 5332u, "CK10_REG_FLASH_INPUT_4_POLARITY_ADDRESS");
    expect(CK10_REG_FLASH_INPUT_5_POLARITY_ADDRESS == 5334u, "CK10_REG_FLASH_INPUT_5_POLARITY_ADDRESS");
    expect(CK10_REG_FLASH_INPUT_6_POLARITY_ADDRESS == 5336u, "CK10_REG_FLASH_INPUT_6_POLARITY_ADDRESS");
    expect(CK10_REG_FLASH_INPUT_7_POLARITY_ADDRESS == 5338u, "CK10_REG_FLASH_INPUT_7_POLARITY_ADDRESS");
    expect(CK10_REG_FLASH_INPUT_8_POLARITY_ADDRESS == 5340u, "CK10_REG_FLASH_INPUT_8_POLARITY_ADDRESS");
    expect(CK10_REG_FLASH_INPUT_9_POLARITY_ADDRESS == 5342u, "CK10_REG_FLASH_INPUT_9_POLARITY_ADDRESS");
    expect(CK10_REG_FLASH_INPUT_10_POLARITY_ADDRESS == 5344u, "CK10_REG_FLASH_INPUT_10_POLARITY_ADDRESS");
    expect(CK10_REG_FLASH_INPUT_11_POLARITY_ADDRESS == 5346u, "CK10_REG_FLASH_INPUT_11_POLARITY_ADDRESS");
    expect(CK10_REG_FLASH_INPUT_12_POLARITY_ADDRESS == 5348u, "CK10_REG_FLASH_INPUT_12_POLARITY_ADDRESS");
    expect(CK10_REG_FLASH_OUTPUT_1_POLARITY_ADDRESS == 5350u, "CK10_REG_FLASH_OUTPUT_1_POLARITY_ADDRESS");
    expect(CK10_REG_FLASH_OUTPUT_2_POLARITY_ADDRESS == 5352u, "CK10_REG_FLASH_OUTPUT_2_POLARITY_ADDRESS");
    expect(CK10_REG_FLASH_OUTPUT_3_POLARITY_ADDRESS == 5354u, "CK10_REG_FLASH_OUTPUT_3_POLARITY_ADDRESS");
    expect(CK10_REG_FLASH_OUTPUT_4_POLARITY_ADDRESS == 5356u, "CK10_REG_FLASH_OUTPUT_4_POLARITY_ADDRESS");
    expect(CK10_REG_FLASH_OUTPUT_5_POLARITY_ADDRESS == 5358u, "CK10_REG_FLASH_OUTPUT_5_POLARITY_ADDRESS");
    expect(CK10_REG_FLASH_OUTPUT_6_POLARITY_ADDRESS == 5360u, "CK10_REG_FLASH_OUTPUT_6_POLARITY_ADDRESS");
    expect(CK10_REG_FLASH_OUTPUT_7_POLARITY_ADDRESS == 5362u, "CK10_REG_FLASH_OUTPUT_7_POLARITY_ADDRESS");
    expect(CK10_REG_FLASH_OUTPUT_8_POLARITY_ADDRESS == 5364u, "CK10_REG_FLASH_OUTPUT_8_POLARITY_ADDRESS");
    expect(CK10_REG_FLASH_OUTPUT_9_POLARITY_ADDRESS == 5366u, "CK10_REG_FLASH_OUTPUT_9_POLARITY_ADDRESS");
    expect(CK10_REG_FLASH_OUTPUT_10_POLARITY_ADDRESS == 5368u, "CK10_REG_FLASH_OUTPUT_10_POLARITY_ADDRESS");
    expect(CK10_REG_MOTION_STATUS_ADDRESS == 1000u, "CK10_REG_MOTION_STATUS_ADDRESS");
    expect(CK10_REG_ACTUAL_POSITION_ADDRESS == 1002u, "CK10_REG_ACTUAL_POSITION_ADDRESS");
    expect(CK10_REG_COMMAND_POSITION_ADDRESS == 1004u, "CK10_REG_COMMAND_POSITION_ADDRESS");
    expect(CK10_REG_SPEED_ADDRESS == 1006u, "CK10_REG_SPEED_ADDRESS");
    expect(CK10_REG_POSITION_ERROR_ADDRESS == 1008u, "CK10_REG_POSITION_ERROR_ADDRESS");
    expect(CK10_REG_INPUTS_ADDRESS == 1010u, "CK10_REG_INPUTS_ADDRESS");
    expect(CK10_REG_OUTPUTS_ADDRESS == 1012u, "CK10_REG_OUTPUTS_ADDRESS");
    expect(CK10_REG_CURRENT_POINT_ADDRESS == 1014u, "CK10_REG_CURRENT_POINT_ADDRESS");
    expect(CK10_REG_POINT_TABLE_RUNNING_ADDRESS == 1015u, "CK10_REG_POINT_TABLE_RUNNING_ADDRESS");
    expect(CK10_REG_PUSH_STATUS_ADDRESS == 1016u, "CK10_REG_PUSH_STATUS_ADDRESS");
    expect(CK10_REG_CURRENT_ALARM_ADDRESS == 1017u, "CK10_REG_CURRENT_ALARM_ADDRESS");
    expect(CK10_REG_MOTOR_ID_ADDRESS == 1018u, "CK10_REG_MOTOR_ID_ADDRESS");
    expect(CK10_REG_USER_INPUTS_ADDRESS == 1030u, "CK10_REG_USER_INPUTS_ADDRESS");
    expect(CK10_REG_USER_INPUT_0_ADDRESS == 1031u, "CK10_REG_USER_INPUT_0_ADDRESS");
    expect(CK10_REG_USER_INPUT_1_ADDRESS == 1032u, "CK10_REG_USER_INPUT_1_ADDRESS");
    expect(CK10_REG_USER_INPUT_2_ADDRESS == 1033u, "CK10_REG_USER_INPUT_2_ADDRESS");
    expect(CK10_REG_USER_INPUT_3_ADDRESS == 1034u, "CK10_REG_USER_INPUT_3_ADDRESS");
    expect(CK10_REG_USER_INPUT_4_ADDRESS == 1035u, "CK10_REG_USER_INPUT_4_ADDRESS");
    expect(CK10_REG_USER_INPUT_5_ADDRESS == 1036u, "CK10_REG_USER_INPUT_5_ADDRESS");
    expect(CK10_REG_USER_INPUT_6_ADDRESS == 1037u, "CK10_REG_USER_INPUT_6_ADDRESS");
    expect(CK10_REG_USER_INPUT_7_ADDRESS == 1038u, "CK10_REG_USER_INPUT_7_ADDRESS");
    expect(CK10_REG_USER_INPUT_8_ADDRESS == 1039u, "CK10_REG_USER_INPUT_8_ADDRESS");
    expect(CK10_REG_USER_OUTPUTS_ADDRESS == 1040u, "CK10_REG_USER_OUTPUTS_ADDRESS");
    expect(CK10_REG_USER_OUTPUT_0_ADDRESS == 1041u, "CK10_REG_USER_OUTPUT_0_ADDRESS");
    expect(CK10_REG_USER_OUTPUT_1_ADDRESS == 1042u, "CK10_REG_USER_OUTPUT_1_ADDRESS");
    expect(CK10_REG_USER_OUTPUT_2_ADDRESS == 1043u, "CK10_REG_USER_OUTPUT_2_ADDRESS");
    expect(CK10_REG_USER_OUTPUT_3_ADDRESS == 1044u, "CK10_REG_USER_OUTPUT_3_ADDRESS");
    expect(CK10_REG_USER_OUTPUT_4_ADDRESS == 1045u, "CK10_REG_USER_OUTPUT_4_ADDRESS");
    expect(CK10_REG_USER_OUTPUT_5_ADDRESS == 1046u, "CK10_REG_USER_OUTPUT_5_ADDRESS");
    expect(CK10_REG_USER_OUTPUT_6_ADDRESS == 1047u, "CK10_REG_USER_OUTPUT_6_ADDRESS");
    expect(CK10_REG_USER_OUTPUT_7_ADDRESS == 1048u, "CK10_REG_USER_OUTPUT_7_ADDRESS");
    expect(CK10_REG_USER_OUTPUT_8_ADDRESS == 1049u, "CK10_REG_USER_OUTPUT_8_ADDRESS");
    expect(CK10_REG_CLEAR_ALARM_HISTORY_ADDRESS == 1059u, "CK10_REG_CLEAR_ALARM_HISTORY_ADDRESS");
    expect(CK10_REG_ALARM_HISTORY_ADDRESS == 1060u, "CK10_REG_ALARM_HISTORY_ADDRESS");
    {
        uint16_t address = 0;
        expect(ck10_table_points_at(127u, &address) == CK10_OK, "ck10_table_points_at last");
        expect(address == 14064u, "ck10_table_points_at last address");
        expect(ck10_table_points_at(128u, &address) == CK10_ERR_OUT_OF_RANGE, "ck10_table_points_at beyond");
        (void)address;
    }
    {
        uint16_t address = 0;
        expect(ck10_table_flash_points_at(127u, &address) == CK10_OK, "ck10_table_flash_points_at last");
        expect(address == 24064u, "ck10_table_flash_points_at last address");
        expect(ck10_table_flash_points_at(128u, &address) == CK10_ERR_OUT_OF_RANGE, "ck10_table_flash_points_at beyond");
        (void)address;
    }
}

static void test_5(void)
{
    static const uint8_t wanted[] = {0xFF};
    uint8_t bytes[CK10_EXCEPTION_SIZE];
    ck10_exception in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.exception_code = 255u;
    copy(&in, &in, sizeof in);
    expect(ck10_exception_encode(&in, bytes, sizeof bytes, &length) == CK10_OK, "exception.exception_code encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "exception.exception_code bytes");
    expect(ck10_exception_decode(bytes, length, &out) == CK10_OK, "exception.exception_code decodes");
    expect(out.exception_code == 255u, "exception.exception_code: exception_code");
    expect(ck10_exception_encode(&in, bytes, sizeof wanted - 1, &length) == CK10_ERR_CAPACITY, "exception.exception_code short");
    expect(ck10_exception_decode(wanted, sizeof wanted - 1, &out) != CK10_OK, "exception.exception_code cut");
}

static void test_6(void)
{
    static const uint8_t wanted[] = {0x7F, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x00, 0x01, 0x00, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x14, 0x00, 0x00, 0x00, 0x01, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[CK10_POINT_SIZE];
    ck10_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.position = 2147483647;
    in.low_speed = 1u;
    in.high_speed = 1u;
    in.acceleration_time = 1u;
    in.deceleration_time = 1u;
    in.command = 0u;
    in.waiting_time = 0u;
    in.jump_point = 0u;
    in.jump_point_of_input_0 = 0u;
    in.jump_point_of_input_1 = 0u;
    in.jump_point_of_input_2 = 0u;
    in.loop_count = 0u;
    in.loop_jump_point = 0u;
    in.output_setting = 0u;
    in.clear_loop_counter_of = 0u;
    in.check_in_position = 0u;
    in.trigger_position = (-2147483647 - 1);
    in.trigger_time = 0u;
    in.push_torque_ratio = 20u;
    in.push_speed = 1u;
    in.push_position = (-2147483647 - 1);
    in.push_mode = 0u;
    copy(&in, &in, sizeof in);
    expect(ck10_point_encode(&in, bytes, sizeof bytes, &length) == CK10_OK, "point.position encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.position bytes");
    expect(ck10_point_decode(bytes, length, &out) == CK10_OK, "point.position decodes");
    expect(out.position == 2147483647, "point.position: position");
    expect(out.low_speed == 1u, "point.position: low_speed");
    expect(out.high_speed == 1u, "point.position: high_speed");
    expect(out.acceleration_time == 1u, "point.position: acceleration_time");
    expect(out.deceleration_time == 1u, "point.position: deceleration_time");
    expect(out.command == 0u, "point.position: command");
    expect(out.waiting_time == 0u, "point.position: waiting_time");
    expect(out.jump_point == 0u, "point.position: jump_point");
    expect(out.jump_point_of_input_0 == 0u, "point.position: jump_point_of_input_0");
    expect(out.jump_point_of_input_1 == 0u, "point.position: jump_point_of_input_1");
    expect(out.jump_point_of_input_2 == 0u, "point.position: jump_point_of_input_2");
    expect(out.loop_count == 0u, "point.position: loop_count");
    expect(out.loop_jump_point == 0u, "point.position: loop_jump_point");
    expect(out.output_setting == 0u, "point.position: output_setting");
    expect(out.clear_loop_counter_of == 0u, "point.position: clear_loop_counter_of");
    expect(out.check_in_position == 0u, "point.position: check_in_position");
    expect(out.trigger_position == (-2147483647 - 1), "point.position: trigger_position");
    expect(out.trigger_time == 0u, "point.position: trigger_time");
    expect(out.push_torque_ratio == 20u, "point.position: push_torque_ratio");
    expect(out.push_speed == 1u, "point.position: push_speed");
    expect(out.push_position == (-2147483647 - 1), "point.position: push_position");
    expect(out.push_mode == 0u, "point.position: push_mode");
    expect(ck10_point_encode(&in, bytes, sizeof wanted - 1, &length) == CK10_ERR_CAPACITY, "point.position short");
    expect(ck10_point_decode(wanted, sizeof wanted - 1, &out) != CK10_OK, "point.position cut");
}

static void test_7(void)
{
    static const uint8_t wanted[] = {0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x88, 0xB8, 0x00, 0x00, 0x00, 0x01, 0x00, 0x01, 0x00, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x14, 0x00, 0x00, 0x00, 0x01, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[CK10_POINT_SIZE];
    ck10_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.position = (-2147483647 - 1);
    in.low_speed = 35000u;
    in.high_speed = 1u;
    in.acceleration_time = 1u;
    in.deceleration_time = 1u;
    in.command = 0u;
    in.waiting_time = 0u;
    in.jump_point = 0u;
    in.jump_point_of_input_0 = 0u;
    in.jump_point_of_input_1 = 0u;
    in.jump_point_of_input_2 = 0u;
    in.loop_count = 0u;
    in.loop_jump_point = 0u;
    in.output_setting = 0u;
    in.clear_loop_counter_of = 0u;
    in.check_in_position = 0u;
    in.trigger_position = (-2147483647 - 1);
    in.trigger_time = 0u;
    in.push_torque_ratio = 20u;
    in.push_speed = 1u;
    in.push_position = (-2147483647 - 1);
    in.push_mode = 0u;
    copy(&in, &in, sizeof in);
    expect(ck10_point_encode(&in, bytes, sizeof bytes, &length) == CK10_OK, "point.low_speed encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.low_speed bytes");
    expect(ck10_point_decode(bytes, length, &out) == CK10_OK, "point.low_speed decodes");
    expect(out.position == (-2147483647 - 1), "point.low_speed: position");
    expect(out.low_speed == 35000u, "point.low_speed: low_speed");
    expect(out.high_speed == 1u, "point.low_speed: high_speed");
    expect(out.acceleration_time == 1u, "point.low_speed: acceleration_time");
    expect(out.deceleration_time == 1u, "point.low_speed: deceleration_time");
    expect(out.command == 0u, "point.low_speed: command");
    expect(out.waiting_time == 0u, "point.low_speed: waiting_time");
    expect(out.jump_point == 0u, "point.low_speed: jump_point");
    expect(out.jump_point_of_input_0 == 0u, "point.low_speed: jump_point_of_input_0");
    expect(out.jump_point_of_input_1 == 0u, "point.low_speed: jump_point_of_input_1");
    expect(out.jump_point_of_input_2 == 0u, "point.low_speed: jump_point_of_input_2");
    expect(out.loop_count == 0u, "point.low_speed: loop_count");
    expect(out.loop_jump_point == 0u, "point.low_speed: loop_jump_point");
    expect(out.output_setting == 0u, "point.low_speed: output_setting");
    expect(out.clear_loop_counter_of == 0u, "point.low_speed: clear_loop_counter_of");
    expect(out.check_in_position == 0u, "point.low_speed: check_in_position");
    expect(out.trigger_position == (-2147483647 - 1), "point.low_speed: trigger_position");
    expect(out.trigger_time == 0u, "point.low_speed: trigger_time");
    expect(out.push_torque_ratio == 20u, "point.low_speed: push_torque_ratio");
    expect(out.push_speed == 1u, "point.low_speed: push_speed");
    expect(out.push_position == (-2147483647 - 1), "point.low_speed: push_position");
    expect(out.push_mode == 0u, "point.low_speed: push_mode");
    expect(ck10_point_encode(&in, bytes, sizeof wanted - 1, &length) == CK10_ERR_CAPACITY, "point.low_speed short");
    expect(ck10_point_decode(wanted, sizeof wanted - 1, &out) != CK10_OK, "point.low_speed cut");
}

static void test_8(void)
{
    static const uint8_t wanted[] = {0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x07, 0xA1, 0x20, 0x00, 0x01, 0x00, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x14, 0x00, 0x00, 0x00, 0x01, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[CK10_POINT_SIZE];
    ck10_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.position = (-2147483647 - 1);
    in.low_speed = 1u;
    in.high_speed = 500000u;
    in.acceleration_time = 1u;
    in.deceleration_time = 1u;
    in.command = 0u;
    in.waiting_time = 0u;
    in.jump_point = 0u;
    in.jump_point_of_input_0 = 0u;
    in.jump_point_of_input_1 = 0u;
    in.jump_point_of_input_2 = 0u;
    in.loop_count = 0u;
    in.loop_jump_point = 0u;
    in.output_setting = 0u;
    in.clear_loop_counter_of = 0u;
    in.check_in_position = 0u;
    in.trigger_position = (-2147483647 - 1);
    in.trigger_time = 0u;
    in.push_torque_ratio = 20u;
    in.push_speed = 1u;
    in.push_position = (-2147483647 - 1);
    in.push_mode = 0u;
    copy(&in, &in, sizeof in);
    expect(ck10_point_encode(&in, bytes, sizeof bytes, &length) == CK10_OK, "point.high_speed encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.high_speed bytes");
    expect(ck10_point_decode(bytes, length, &out) == CK10_OK, "point.high_speed decodes");
    expect(out.position == (-2147483647 - 1), "point.high_speed: position");
    expect(out.low_speed == 1u, "point.high_speed: low_speed");
    expect(out.high_speed == 500000u, "point.high_speed: high_speed");
    expect(out.acceleration_time == 1u, "point.high_speed: acceleration_time");
    expect(out.deceleration_time == 1u, "point.high_speed: deceleration_time");
    expect(out.command == 0u, "point.high_speed: command");
    expect(out.waiting_time == 0u, "point.high_speed: waiting_time");
    expect(out.jump_point == 0u, "point.high_speed: jump_point");
    expect(out.jump_point_of_input_0 == 0u, "point.high_speed: jump_point_of_input_0");
    expect(out.jump_point_of_input_1 == 0u, "point.high_speed: jump_point_of_input_1");
    expect(out.jump_point_of_input_2 == 0u, "point.high_speed: jump_point_of_input_2");
    expect(out.loop_count == 0u, "point.high_speed: loop_count");
    expect(out.loop_jump_point == 0u, "point.high_speed: loop_jump_point");
    expect(out.output_setting == 0u, "point.high_speed: output_setting");
    expect(out.clear_loop_counter_of == 0u, "point.high_speed: clear_loop_counter_of");
    expect(out.check_in_position == 0u, "point.high_speed: check_in_position");
    expect(out.trigger_position == (-2147483647 - 1), "point.high_speed: trigger_position");
    expect(out.trigger_time == 0u, "point.high_speed: trigger_time");
    expect(out.push_torque_ratio == 20u, "point.high_speed: push_torque_ratio");
    expect(out.push_speed == 1u, "point.high_speed: push_speed");
    expect(out.push_position == (-2147483647 - 1), "point.high_speed: push_position");
    expect(out.push_mode == 0u, "point.high_speed: push_mode");
    expect(ck10_point_encode(&in, bytes, sizeof wanted - 1, &length) == CK10_ERR_CAPACITY, "point.high_speed short");
    expect(ck10_point_decode(wanted, sizeof wanted - 1, &out) != CK10_OK, "point.high_speed cut");
}

static void test_9(void)
{
    static const uint8_t wanted[] = {0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x27, 0x0F, 0x00, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x14, 0x00, 0x00, 0x00, 0x01, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[CK10_POINT_SIZE];
    ck10_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.position = (-2147483647 - 1);
    in.low_speed = 1u;
    in.high_speed = 1u;
    in.acceleration_time = 9999u;
    in.deceleration_time = 1u;
    in.command = 0u;
    in.waiting_time = 0u;
    in.jump_point = 0u;
    in.jump_point_of_input_0 = 0u;
    in.jump_point_of_input_1 = 0u;
    in.jump_point_of_input_2 = 0u;
    in.loop_count = 0u;
    in.loop_jump_point = 0u;
    in.output_setting = 0u;
    in.clear_loop_counter_of = 0u;
    in.check_in_position = 0u;
    in.trigger_position = (-2147483647 - 1);
    in.trigger_time = 0u;
    in.push_torque_ratio = 20u;
    in.push_speed = 1u;
    in.push_position = (-2147483647 - 1);
    in.push_mode = 0u;
    copy(&in, &in, sizeof in);
    expect(ck10_point_encode(&in, bytes, sizeof bytes, &length) == CK10_OK, "point.acceleration_time encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.acceleration_time bytes");
    expect(ck10_point_decode(bytes, length, &out) == CK10_OK, "point.acceleration_time decodes");
    expect(out.position == (-2147483647 - 1), "point.acceleration_time: position");
    expect(out.low_speed == 1u, "point.acceleration_time: low_speed");
    expect(out.high_speed == 1u, "point.acceleration_time: high_speed");
    expect(out.acceleration_time == 9999u, "point.acceleration_time: acceleration_time");
    expect(out.deceleration_time == 1u, "point.acceleration_time: deceleration_time");
    expect(out.command == 0u, "point.acceleration_time: command");
    expect(out.waiting_time == 0u, "point.acceleration_time: waiting_time");
    expect(out.jump_point == 0u, "point.acceleration_time: jump_point");
    expect(out.jump_point_of_input_0 == 0u, "point.acceleration_time: jump_point_of_input_0");
    expect(out.jump_point_of_input_1 == 0u, "point.acceleration_time: jump_point_of_input_1");
    expect(out.jump_point_of_input_2 == 0u, "point.acceleration_time: jump_point_of_input_2");
    expect(out.loop_count == 0u, "point.acceleration_time: loop_count");
    expect(out.loop_jump_point == 0u, "point.acceleration_time: loop_jump_point");
    expect(out.output_setting == 0u, "point.acceleration_time: output_setting");
    expect(out.clear_loop_counter_of == 0u, "point.acceleration_time: clear_loop_counter_of");
    expect(out.check_in_position == 0u, "point.acceleration_time: check_in_position");
    expect(out.trigger_position == (-2147483647 - 1), "point.acceleration_time: trigger_position");
    expect(out.trigger_time == 0u, "point.acceleration_time: trigger_time");
    expect(out.push_torque_ratio == 20u, "point.acceleration_time: push_torque_ratio");
    expect(out.push_speed == 1u, "point.acceleration_time: push_speed");
    expect(out.push_position == (-2147483647 - 1), "point.acceleration_time: push_position");
    expect(out.push_mode == 0u, "point.acceleration_time: push_mode");
    expect(ck10_point_encode(&in, bytes, sizeof wanted - 1, &length) == CK10_ERR_CAPACITY, "point.acceleration_time short");
    expect(ck10_point_decode(wanted, sizeof wanted - 1, &out) != CK10_OK, "point.acceleration_time cut");
}

static void test_10(void)
{
    static const uint8_t wanted[] = {0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x00, 0x01, 0x27, 0x0F, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x14, 0x00, 0x00, 0x00, 0x01, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[CK10_POINT_SIZE];
    ck10_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.position = (-2147483647 - 1);
    in.low_speed = 1u;
    in.high_speed = 1u;
    in.acceleration_time = 1u;
    in.deceleration_time = 9999u;
    in.command = 0u;
    in.waiting_time = 0u;
    in.jump_point = 0u;
    in.jump_point_of_input_0 = 0u;
    in.jump_point_of_input_1 = 0u;
    in.jump_point_of_input_2 = 0u;
    in.loop_count = 0u;
    in.loop_jump_point = 0u;
    in.output_setting = 0u;
    in.clear_loop_counter_of = 0u;
    in.check_in_position = 0u;
    in.trigger_position = (-2147483647 - 1);
    in.trigger_time = 0u;
    in.push_torque_ratio = 20u;
    in.push_speed = 1u;
    in.push_position = (-2147483647 - 1);
    in.push_mode = 0u;
    copy(&in, &in, sizeof in);
    expect(ck10_point_encode(&in, bytes, sizeof bytes, &length) == CK10_OK, "point.deceleration_time encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.deceleration_time bytes");
    expect(ck10_point_decode(bytes, length, &out) == CK10_OK, "point.deceleration_time decodes");
    expect(out.position == (-2147483647 - 1), "point.deceleration_time: position");
    expect(out.low_speed == 1u, "point.deceleration_time: low_speed");
    expect(out.high_speed == 1u, "point.deceleration_time: high_speed");
    expect(out.acceleration_time == 1u, "point.deceleration_time: acceleration_time");
    expect(out.deceleration_time == 9999u, "point.deceleration_time: deceleration_time");
    expect(out.command == 0u, "point.deceleration_time: command");
    expect(out.waiting_time == 0u, "point.deceleration_time: waiting_time");
    expect(out.jump_point == 0u, "point.deceleration_time: jump_point");
    expect(out.jump_point_of_input_0 == 0u, "point.deceleration_time: jump_point_of_input_0");
    expect(out.jump_point_of_input_1 == 0u, "point.deceleration_time: jump_point_of_input_1");
    expect(out.jump_point_of_input_2 == 0u, "point.deceleration_time: jump_point_of_input_2");
    expect(out.loop_count == 0u, "point.deceleration_time: loop_count");
    expect(out.loop_jump_point == 0u, "point.deceleration_time: loop_jump_point");
    expect(out.output_setting == 0u, "point.deceleration_time: output_setting");
    expect(out.clear_loop_counter_of == 0u, "point.deceleration_time: clear_loop_counter_of");
    expect(out.check_in_position == 0u, "point.deceleration_time: check_in_position");
    expect(out.trigger_position == (-2147483647 - 1), "point.deceleration_time: trigger_position");
    expect(out.trigger_time == 0u, "point.deceleration_time: trigger_time");
    expect(out.push_torque_ratio == 20u, "point.deceleration_time: push_torque_ratio");
    expect(out.push_speed == 1u, "point.deceleration_time: push_speed");
    expect(out.push_position == (-2147483647 - 1), "point.deceleration_time: push_position");
    expect(out.push_mode == 0u, "point.deceleration_time: push_mode");
    expect(ck10_point_encode(&in, bytes, sizeof wanted - 1, &length) == CK10_ERR_CAPACITY, "point.deceleration_time short");
    expect(ck10_point_decode(wanted, sizeof wanted - 1, &out) != CK10_OK, "point.deceleration_time cut");
}

static void test_11(void)
{
    static const uint8_t wanted[] = {0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x00, 0x01, 0x00, 0x01, 0x00, 0x0B, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x14, 0x00, 0x00, 0x00, 0x01, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[CK10_POINT_SIZE];
    ck10_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.position = (-2147483647 - 1);
    in.low_speed = 1u;
    in.high_speed = 1u;
    in.acceleration_time = 1u;
    in.deceleration_time = 1u;
    in.command = 11u;
    in.waiting_time = 0u;
    in.jump_point = 0u;
    in.jump_point_of_input_0 = 0u;
    in.jump_point_of_input_1 = 0u;
    in.jump_point_of_input_2 = 0u;
    in.loop_count = 0u;
    in.loop_jump_point = 0u;
    in.output_setting = 0u;
    in.clear_loop_counter_of = 0u;
    in.check_in_position = 0u;
    in.trigger_position = (-2147483647 - 1);
    in.trigger_time = 0u;
    in.push_torque_ratio = 20u;
    in.push_speed = 1u;
    in.push_position = (-2147483647 - 1);
    in.push_mode = 0u;
    copy(&in, &in, sizeof in);
    expect(ck10_point_encode(&in, bytes, sizeof bytes, &length) == CK10_OK, "point.command encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.command bytes");
    expect(ck10_point_decode(bytes, length, &out) == CK10_OK, "point.command decodes");
    expect(out.position == (-2147483647 - 1), "point.command: position");
    expect(out.low_speed == 1u, "point.command: low_speed");
    expect(out.high_speed == 1u, "point.command: high_speed");
    expect(out.acceleration_time == 1u, "point.command: acceleration_time");
    expect(out.deceleration_time == 1u, "point.command: deceleration_time");
    expect(out.command == 11u, "point.command: command");
    expect(out.waiting_time == 0u, "point.command: waiting_time");
    expect(out.jump_point == 0u, "point.command: jump_point");
    expect(out.jump_point_of_input_0 == 0u, "point.command: jump_point_of_input_0");
    expect(out.jump_point_of_input_1 == 0u, "point.command: jump_point_of_input_1");
    expect(out.jump_point_of_input_2 == 0u, "point.command: jump_point_of_input_2");
    expect(out.loop_count == 0u, "point.command: loop_count");
    expect(out.loop_jump_point == 0u, "point.command: loop_jump_point");
    expect(out.output_setting == 0u, "point.command: output_setting");
    expect(out.clear_loop_counter_of == 0u, "point.command: clear_loop_counter_of");
    expect(out.check_in_position == 0u, "point.command: check_in_position");
    expect(out.trigger_position == (-2147483647 - 1), "point.command: trigger_position");
    expect(out.trigger_time == 0u, "point.command: trigger_time");
    expect(out.push_torque_ratio == 20u, "point.command: push_torque_ratio");
    expect(out.push_speed == 1u, "point.command: push_speed");
    expect(out.push_position == (-2147483647 - 1), "point.command: push_position");
    expect(out.push_mode == 0u, "point.command: push_mode");
    expect(ck10_point_encode(&in, bytes, sizeof wanted - 1, &length) == CK10_ERR_CAPACITY, "point.command short");
    expect(ck10_point_decode(wanted, sizeof wanted - 1, &out) != CK10_OK, "point.command cut");
}

static void test_12(void)
{
    static const uint8_t wanted[] = {0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x00, 0x01, 0x00, 0x01, 0x00, 0x00, 0xEA, 0x60, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x14, 0x00, 0x00, 0x00, 0x01, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[CK10_POINT_SIZE];
    ck10_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.position = (-2147483647 - 1);
    in.low_speed = 1u;
    in.high_speed = 1u;
    in.acceleration_time = 1u;
    in.deceleration_time = 1u;
    in.command = 0u;
    in.waiting_time = 60000u;
    in.jump_point = 0u;
    in.jump_point_of_input_0 = 0u;
    in.jump_point_of_input_1 = 0u;
    in.jump_point_of_input_2 = 0u;
    in.loop_count = 0u;
    in.loop_jump_point = 0u;
    in.output_setting = 0u;
    in.clear_loop_counter_of = 0u;
    in.check_in_position = 0u;
    in.trigger_position = (-2147483647 - 1);
    in.trigger_time = 0u;
    in.push_torque_ratio = 20u;
    in.push_speed = 1u;
    in.push_position = (-2147483647 - 1);
    in.push_mode = 0u;
    copy(&in, &in, sizeof in);
    expect(ck10_point_encode(&in, bytes, sizeof bytes, &length) == CK10_OK, "point.waiting_time encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.waiting_time bytes");
    expect(ck10_point_decode(bytes, length, &out) == CK10_OK, "point.waiting_time decodes");
    expect(out.position == (-2147483647 - 1), "point.waiting_time: position");
    expect(out.low_speed == 1u, "point.waiting_time: low_speed");
    expect(out.high_speed == 1u, "point.waiting_time: high_speed");
    expect(out.acceleration_time == 1u, "point.waiting_time: acceleration_time");
    expect(out.deceleration_time == 1u, "point.waiting_time: deceleration_time");
    expect(out.command == 0u, "point.waiting_time: command");
    expect(out.waiting_time == 60000u, "point.waiting_time: waiting_time");
    expect(out.jump_point == 0u, "point.waiting_time: jump_point");
    expect(out.jump_point_of_input_0 == 0u, "point.waiting_time: jump_point_of_input_0");
    expect(out.jump_point_of_input_1 == 0u, "point.waiting_time: jump_point_of_input_1");
    expect(out.jump_point_of_input_2 == 0u, "point.waiting_time: jump_point_of_input_2");
    expect(out.loop_count == 0u, "point.waiting_time: loop_count");
    expect(out.loop_jump_point == 0u, "point.waiting_time: loop_jump_point");
    expect(out.output_setting == 0u, "point.waiting_time: output_setting");
    expect(out.clear_loop_counter_of == 0u, "point.waiting_time: clear_loop_counter_of");
    expect(out.check_in_position == 0u, "point.waiting_time: check_in_position");
    expect(out.trigger_position == (-2147483647 - 1), "point.waiting_time: trigger_position");
    expect(out.trigger_time == 0u, "point.waiting_time: trigger_time");
    expect(out.push_torque_ratio == 20u, "point.waiting_time: push_torque_ratio");
    expect(out.push_speed == 1u, "point.waiting_time: push_speed");
    expect(out.push_position == (-2147483647 - 1), "point.waiting_time: push_position");
    expect(out.push_mode == 0u, "point.waiting_time: push_mode");
    expect(ck10_point_encode(&in, bytes, sizeof wanted - 1, &length) == CK10_ERR_CAPACITY, "point.waiting_time short");
    expect(ck10_point_decode(wanted, sizeof wanted - 1, &out) != CK10_OK, "point.waiting_time cut");
}

static void test_13(void)
{
    static const uint8_t wanted[] = {0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x00, 0x01, 0x00, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x27, 0x8F, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x14, 0x00, 0x00, 0x00, 0x01, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[CK10_POINT_SIZE];
    ck10_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.position = (-2147483647 - 1);
    in.low_speed = 1u;
    in.high_speed = 1u;
    in.acceleration_time = 1u;
    in.deceleration_time = 1u;
    in.command = 0u;
    in.waiting_time = 0u;
    in.jump_point = 10127u;
    in.jump_point_of_input_0 = 0u;
    in.jump_point_of_input_1 = 0u;
    in.jump_point_of_input_2 = 0u;
    in.loop_count = 0u;
    in.loop_jump_point = 0u;
    in.output_setting = 0u;
    in.clear_loop_counter_of = 0u;
    in.check_in_position = 0u;
    in.trigger_position = (-2147483647 - 1);
    in.trigger_time = 0u;
    in.push_torque_ratio = 20u;
    in.push_speed = 1u;
    in.push_position = (-2147483647 - 1);
    in.push_mode = 0u;
    copy(&in, &in, sizeof in);
    expect(ck10_point_encode(&in, bytes, sizeof bytes, &length) == CK10_OK, "point.jump_point encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.jump_point bytes");
    expect(ck10_point_decode(bytes, length, &out) == CK10_OK, "point.jump_point decodes");
    expect(out.position == (-2147483647 - 1), "point.jump_point: position");
    expect(out.low_speed == 1u, "point.jump_point: low_speed");
    expect(out.high_speed == 1u, "point.jump_point: high_speed");
    expect(out.acceleration_time == 1u, "point.jump_point: acceleration_time");
    expect(out.deceleration_time == 1u, "point.jump_point: deceleration_time");
    expect(out.command == 0u, "point.jump_point: command");
    expect(out.waiting_time == 0u, "point.jump_point: waiting_time");
    expect(out.jump_point == 10127u, "point.jump_point: jump_point");
    expect(out.jump_point_of_input_0 == 0u, "point.jump_point: jump_point_of_input_0");
    expect(out.jump_point_of_input_1 == 0u, "point.jump_point: jump_point_of_input_1");
    expect(out.jump_point_of_input_2 == 0u, "point.jump_point: jump_point_of_input_2");
    expect(out.loop_count == 0u, "point.jump_point: loop_count");
    expect(out.loop_jump_point == 0u, "point.jump_point: loop_jump_point");
    expect(out.output_setting == 0u, "point.jump_point: output_setting");
    expect(out.clear_loop_counter_of == 0u, "point.jump_point: clear_loop_counter_of");
    expect(out.check_in_position == 0u, "point.jump_point: check_in_position");
    expect(out.trigger_position == (-2147483647 - 1), "point.jump_point: trigger_position");
    expect(out.trigger_time == 0u, "point.jump_point: trigger_time");
    expect(out.push_torque_ratio == 20u, "point.jump_point: push_torque_ratio");
    expect(out.push_speed == 1u, "point.jump_point: push_speed");
    expect(out.push_position == (-2147483647 - 1), "point.jump_point: push_position");
    expect(out.push_mode == 0u, "point.jump_point: push_mode");
    expect(ck10_point_encode(&in, bytes, sizeof wanted - 1, &length) == CK10_ERR_CAPACITY, "point.jump_point short");
    expect(ck10_point_decode(wanted, sizeof wanted - 1, &out) != CK10_OK, "point.jump_point cut");
}

static void test_14(void)
{
    static const uint8_t wanted[] = {0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x00, 0x01, 0x00, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x27, 0x8F, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x14, 0x00, 0x00, 0x00, 0x01, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[CK10_POINT_SIZE];
    ck10_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.position = (-2147483647 - 1);
    in.low_speed = 1u;
    in.high_speed = 1u;
    in.acceleration_time = 1u;
    in.deceleration_time = 1u;
    in.command = 0u;
    in.waiting_time = 0u;
    in.jump_point = 0u;
    in.jump_point_of_input_0 = 10127u;
    in.jump_point_of_input_1 = 0u;
    in.jump_point_of_input_2 = 0u;
    in.loop_count = 0u;
    in.loop_jump_point = 0u;
    in.output_setting = 0u;
    in.clear_loop_counter_of = 0u;
    in.check_in_position = 0u;
    in.trigger_position = (-2147483647 - 1);
    in.trigger_time = 0u;
    in.push_torque_ratio = 20u;
    in.push_speed = 1u;
    in.push_position = (-2147483647 - 1);
    in.push_mode = 0u;
    copy(&in, &in, sizeof in);
    expect(ck10_point_encode(&in, bytes, sizeof bytes, &length) == CK10_OK, "point.jump_point_of_input_0 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.jump_point_of_input_0 bytes");
    expect(ck10_point_decode(bytes, length, &out) == CK10_OK, "point.jump_point_of_input_0 decodes");
    expect(out.position == (-2147483647 - 1), "point.jump_point_of_input_0: position");
    expect(out.low_speed == 1u, "point.jump_point_of_input_0: low_speed");
    expect(out.high_speed == 1u, "point.jump_point_of_input_0: high_speed");
    expect(out.acceleration_time == 1u, "point.jump_point_of_input_0: acceleration_time");
    expect(out.deceleration_time == 1u, "point.jump_point_of_input_0: deceleration_time");
    expect(out.command == 0u, "point.jump_point_of_input_0: command");
    expect(out.waiting_time == 0u, "point.jump_point_of_input_0: waiting_time");
    expect(out.jump_point == 0u, "point.jump_point_of_input_0: jump_point");
    expect(out.jump_point_of_input_0 == 10127u, "point.jump_point_of_input_0: jump_point_of_input_0");
    expect(out.jump_point_of_input_1 == 0u, "point.jump_point_of_input_0: jump_point_of_input_1");
    expect(out.jump_point_of_input_2 == 0u, "point.jump_point_of_input_0: jump_point_of_input_2");
    expect(out.loop_count == 0u, "point.jump_point_of_input_0: loop_count");
    expect(out.loop_jump_point == 0u, "point.jump_point_of_input_0: loop_jump_point");
    expect(out.output_setting == 0u, "point.jump_point_of_input_0: output_setting");
    expect(out.clear_loop_counter_of == 0u, "point.jump_point_of_input_0: clear_loop_counter_of");
    expect(out.check_in_position == 0u, "point.jump_point_of_input_0: check_in_position");
    expect(out.trigger_position == (-2147483647 - 1), "point.jump_point_of_input_0: trigger_position");
    expect(out.trigger_time == 0u, "point.jump_point_of_input_0: trigger_time");
    expect(out.push_torque_ratio == 20u, "point.jump_point_of_input_0: push_torque_ratio");
    expect(out.push_speed == 1u, "point.jump_point_of_input_0: push_speed");
    expect(out.push_position == (-2147483647 - 1), "point.jump_point_of_input_0: push_position");
    expect(out.push_mode == 0u, "point.jump_point_of_input_0: push_mode");
    expect(ck10_point_encode(&in, bytes, sizeof wanted - 1, &length) == CK10_ERR_CAPACITY, "point.jump_point_of_input_0 short");
    expect(ck10_point_decode(wanted, sizeof wanted - 1, &out) != CK10_OK, "point.jump_point_of_input_0 cut");
}

static void test_15(void)
{
    static const uint8_t wanted[] = {0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x00, 0x01, 0x00, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x27, 0x8F, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x14, 0x00, 0x00, 0x00, 0x01, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[CK10_POINT_SIZE];
    ck10_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.position = (-2147483647 - 1);
    in.low_speed = 1u;
    in.high_speed = 1u;
    in.acceleration_time = 1u;
    in.deceleration_time = 1u;
    in.command = 0u;
    in.waiting_time = 0u;
    in.jump_point = 0u;
    in.jump_point_of_input_0 = 0u;
    in.jump_point_of_input_1 = 10127u;
    in.jump_point_of_input_2 = 0u;
    in.loop_count = 0u;
    in.loop_jump_point = 0u;
    in.output_setting = 0u;
    in.clear_loop_counter_of = 0u;
    in.check_in_position = 0u;
    in.trigger_position = (-2147483647 - 1);
    in.trigger_time = 0u;
    in.push_torque_ratio = 20u;
    in.push_speed = 1u;
    in.push_position = (-2147483647 - 1);
    in.push_mode = 0u;
    copy(&in, &in, sizeof in);
    expect(ck10_point_encode(&in, bytes, sizeof bytes, &length) == CK10_OK, "point.jump_point_of_input_1 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.jump_point_of_input_1 bytes");
    expect(ck10_point_decode(bytes, length, &out) == CK10_OK, "point.jump_point_of_input_1 decodes");
    expect(out.position == (-2147483647 - 1), "point.jump_point_of_input_1: position");
    expect(out.low_speed == 1u, "point.jump_point_of_input_1: low_speed");
    expect(out.high_speed == 1u, "point.jump_point_of_input_1: high_speed");
    expect(out.acceleration_time == 1u, "point.jump_point_of_input_1: acceleration_time");
    expect(out.deceleration_time == 1u, "point.jump_point_of_input_1: deceleration_time");
    expect(out.command == 0u, "point.jump_point_of_input_1: command");
    expect(out.waiting_time == 0u, "point.jump_point_of_input_1: waiting_time");
    expect(out.jump_point == 0u, "point.jump_point_of_input_1: jump_point");
    expect(out.jump_point_of_input_0 == 0u, "point.jump_point_of_input_1: jump_point_of_input_0");
    expect(out.jump_point_of_input_1 == 10127u, "point.jump_point_of_input_1: jump_point_of_input_1");
    expect(out.jump_point_of_input_2 == 0u, "point.jump_point_of_input_1: jump_point_of_input_2");
    expect(out.loop_count == 0u, "point.jump_point_of_input_1: loop_count");
    expect(out.loop_jump_point == 0u, "point.jump_point_of_input_1: loop_jump_point");
    expect(out.output_setting == 0u, "point.jump_point_of_input_1: output_setting");
    expect(out.clear_loop_counter_of == 0u, "point.jump_point_of_input_1: clear_loop_counter_of");
    expect(out.check_in_position == 0u, "point.jump_point_of_input_1: check_in_position");
    expect(out.trigger_position == (-2147483647 - 1), "point.jump_point_of_input_1: trigger_position");
    expect(out.trigger_time == 0u, "point.jump_point_of_input_1: trigger_time");
    expect(out.push_torque_ratio == 20u, "point.jump_point_of_input_1: push_torque_ratio");
    expect(out.push_speed == 1u, "point.jump_point_of_input_1: push_speed");
    expect(out.push_position == (-2147483647 - 1), "point.jump_point_of_input_1: push_position");
    expect(out.push_mode == 0u, "point.jump_point_of_input_1: push_mode");
    expect(ck10_point_encode(&in, bytes, sizeof wanted - 1, &length) == CK10_ERR_CAPACITY, "point.jump_point_of_input_1 short");
    expect(ck10_point_decode(wanted, sizeof wanted - 1, &out) != CK10_OK, "point.jump_point_of_input_1 cut");
}

static void test_16(void)
{
    static const uint8_t wanted[] = {0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x00, 0x01, 0x00, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x27, 0x8F, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x14, 0x00, 0x00, 0x00, 0x01, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[CK10_POINT_SIZE];
    ck10_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.position = (-2147483647 - 1);
    in.low_speed = 1u;
    in.high_speed = 1u;
    in.acceleration_time = 1u;
    in.deceleration_time = 1u;
    in.command = 0u;
    in.waiting_time = 0u;
    in.jump_point = 0u;
    in.jump_point_of_input_0 = 0u;
    in.jump_point_of_input_1 = 0u;
    in.jump_point_of_input_2 = 10127u;
    in.loop_count = 0u;
    in.loop_jump_point = 0u;
    in.output_setting = 0u;
    in.clear_loop_counter_of = 0u;
    in.check_in_position = 0u;
    in.trigger_position = (-2147483647 - 1);
    in.trigger_time = 0u;
    in.push_torque_ratio = 20u;
    in.push_speed = 1u;
    in.push_position = (-2147483647 - 1);
    in.push_mode = 0u;
    copy(&in, &in, sizeof in);
    expect(ck10_point_encode(&in, bytes, sizeof bytes, &length) == CK10_OK, "point.jump_point_of_input_2 encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.jump_point_of_input_2 bytes");
    expect(ck10_point_decode(bytes, length, &out) == CK10_OK, "point.jump_point_of_input_2 decodes");
    expect(out.position == (-2147483647 - 1), "point.jump_point_of_input_2: position");
    expect(out.low_speed == 1u, "point.jump_point_of_input_2: low_speed");
    expect(out.high_speed == 1u, "point.jump_point_of_input_2: high_speed");
    expect(out.acceleration_time == 1u, "point.jump_point_of_input_2: acceleration_time");
    expect(out.deceleration_time == 1u, "point.jump_point_of_input_2: deceleration_time");
    expect(out.command == 0u, "point.jump_point_of_input_2: command");
    expect(out.waiting_time == 0u, "point.jump_point_of_input_2: waiting_time");
    expect(out.jump_point == 0u, "point.jump_point_of_input_2: jump_point");
    expect(out.jump_point_of_input_0 == 0u, "point.jump_point_of_input_2: jump_point_of_input_0");
    expect(out.jump_point_of_input_1 == 0u, "point.jump_point_of_input_2: jump_point_of_input_1");
    expect(out.jump_point_of_input_2 == 10127u, "point.jump_point_of_input_2: jump_point_of_input_2");
    expect(out.loop_count == 0u, "point.jump_point_of_input_2: loop_count");
    expect(out.loop_jump_point == 0u, "point.jump_point_of_input_2: loop_jump_point");
    expect(out.output_setting == 0u, "point.jump_point_of_input_2: output_setting");
    expect(out.clear_loop_counter_of == 0u, "point.jump_point_of_input_2: clear_loop_counter_of");
    expect(out.check_in_position == 0u, "point.jump_point_of_input_2: check_in_position");
    expect(out.trigger_position == (-2147483647 - 1), "point.jump_point_of_input_2: trigger_position");
    expect(out.trigger_time == 0u, "point.jump_point_of_input_2: trigger_time");
    expect(out.push_torque_ratio == 20u, "point.jump_point_of_input_2: push_torque_ratio");
    expect(out.push_speed == 1u, "point.jump_point_of_input_2: push_speed");
    expect(out.push_position == (-2147483647 - 1), "point.jump_point_of_input_2: push_position");
    expect(out.push_mode == 0u, "point.jump_point_of_input_2: push_mode");
    expect(ck10_point_encode(&in, bytes, sizeof wanted - 1, &length) == CK10_ERR_CAPACITY, "point.jump_point_of_input_2 short");
    expect(ck10_point_decode(wanted, sizeof wanted - 1, &out) != CK10_OK, "point.jump_point_of_input_2 cut");
}

static void test_17(void)
{
    static const uint8_t wanted[] = {0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x00, 0x01, 0x00, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x64, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x14, 0x00, 0x00, 0x00, 0x01, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[CK10_POINT_SIZE];
    ck10_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.position = (-2147483647 - 1);
    in.low_speed = 1u;
    in.high_speed = 1u;
    in.acceleration_time = 1u;
    in.deceleration_time = 1u;
    in.command = 0u;
    in.waiting_time = 0u;
    in.jump_point = 0u;
    in.jump_point_of_input_0 = 0u;
    in.jump_point_of_input_1 = 0u;
    in.jump_point_of_input_2 = 0u;
    in.loop_count = 100u;
    in.loop_jump_point = 0u;
    in.output_setting = 0u;
    in.clear_loop_counter_of = 0u;
    in.check_in_position = 0u;
    in.trigger_position = (-2147483647 - 1);
    in.trigger_time = 0u;
    in.push_torque_ratio = 20u;
    in.push_speed = 1u;
    in.push_position = (-2147483647 - 1);
    in.push_mode = 0u;
    copy(&in, &in, sizeof in);
    expect(ck10_point_encode(&in, bytes, sizeof bytes, &length) == CK10_OK, "point.loop_count encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.loop_count bytes");
    expect(ck10_point_decode(bytes, length, &out) == CK10_OK, "point.loop_count decodes");
    expect(out.position == (-2147483647 - 1), "point.loop_count: position");
    expect(out.low_speed == 1u, "point.loop_count: low_speed");
    expect(out.high_speed == 1u, "point.loop_count: high_speed");
    expect(out.acceleration_time == 1u, "point.loop_count: acceleration_time");
    expect(out.deceleration_time == 1u, "point.loop_count: deceleration_time");
    expect(out.command == 0u, "point.loop_count: command");
    expect(out.waiting_time == 0u, "point.loop_count: waiting_time");
    expect(out.jump_point == 0u, "point.loop_count: jump_point");
    expect(out.jump_point_of_input_0 == 0u, "point.loop_count: jump_point_of_input_0");
    expect(out.jump_point_of_input_1 == 0u, "point.loop_count: jump_point_of_input_1");
    expect(out.jump_point_of_input_2 == 0u, "point.loop_count: jump_point_of_input_2");
    expect(out.loop_count == 100u, "point.loop_count: loop_count");
    expect(out.loop_jump_point == 0u, "point.loop_count: loop_jump_point");
    expect(out.output_setting == 0u, "point.loop_count: output_setting");
    expect(out.clear_loop_counter_of == 0u, "point.loop_count: clear_loop_counter_of");
    expect(out.check_in_position == 0u, "point.loop_count: check_in_position");
    expect(out.trigger_position == (-2147483647 - 1), "point.loop_count: trigger_position");
    expect(out.trigger_time == 0u, "point.loop_count: trigger_time");
    expect(out.push_torque_ratio == 20u, "point.loop_count: push_torque_ratio");
    expect(out.push_speed == 1u, "point.loop_count: push_speed");
    expect(out.push_position == (-2147483647 - 1), "point.loop_count: push_position");
    expect(out.push_mode == 0u, "point.loop_count: push_mode");
    expect(ck10_point_encode(&in, bytes, sizeof wanted - 1, &length) == CK10_ERR_CAPACITY, "point.loop_count short");
    expect(ck10_point_decode(wanted, sizeof wanted - 1, &out) != CK10_OK, "point.loop_count cut");
}

static void test_18(void)
{
    static const uint8_t wanted[] = {0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x00, 0x01, 0x00, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x27, 0x8F, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x14, 0x00, 0x00, 0x00, 0x01, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[CK10_POINT_SIZE];
    ck10_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.position = (-2147483647 - 1);
    in.low_speed = 1u;
    in.high_speed = 1u;
    in.acceleration_time = 1u;
    in.deceleration_time = 1u;
    in.command = 0u;
    in.waiting_time = 0u;
    in.jump_point = 0u;
    in.jump_point_of_input_0 = 0u;
    in.jump_point_of_input_1 = 0u;
    in.jump_point_of_input_2 = 0u;
    in.loop_count = 0u;
    in.loop_jump_point = 10127u;
    in.output_setting = 0u;
    in.clear_loop_counter_of = 0u;
    in.check_in_position = 0u;
    in.trigger_position = (-2147483647 - 1);
    in.trigger_time = 0u;
    in.push_torque_ratio = 20u;
    in.push_speed = 1u;
    in.push_position = (-2147483647 - 1);
    in.push_mode = 0u;
    copy(&in, &in, sizeof in);
    expect(ck10_point_encode(&in, bytes, sizeof bytes, &length) == CK10_OK, "point.loop_jump_point encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.loop_jump_point bytes");
    expect(ck10_point_decode(bytes, length, &out) == CK10_OK, "point.loop_jump_point decodes");
    expect(out.position == (-2147483647 - 1), "point.loop_jump_point: position");
    expect(out.low_speed == 1u, "point.loop_jump_point: low_speed");
    expect(out.high_speed == 1u, "point.loop_jump_point: high_speed");
    expect(out.acceleration_time == 1u, "point.loop_jump_point: acceleration_time");
    expect(out.deceleration_time == 1u, "point.loop_jump_point: deceleration_time");
    expect(out.command == 0u, "point.loop_jump_point: command");
    expect(out.waiting_time == 0u, "point.loop_jump_point: waiting_time");
    expect(out.jump_point == 0u, "point.loop_jump_point: jump_point");
    expect(out.jump_point_of_input_0 == 0u, "point.loop_jump_point: jump_point_of_input_0");
    expect(out.jump_point_of_input_1 == 0u, "point.loop_jump_point: jump_point_of_input_1");
    expect(out.jump_point_of_input_2 == 0u, "point.loop_jump_point: jump_point_of_input_2");
    expect(out.loop_count == 0u, "point.loop_jump_point: loop_count");
    expect(out.loop_jump_point == 10127u, "point.loop_jump_point: loop_jump_point");
    expect(out.output_setting == 0u, "point.loop_jump_point: output_setting");
    expect(out.clear_loop_counter_of == 0u, "point.loop_jump_point: clear_loop_counter_of");
    expect(out.check_in_position == 0u, "point.loop_jump_point: check_in_position");
    expect(out.trigger_position == (-2147483647 - 1), "point.loop_jump_point: trigger_position");
    expect(out.trigger_time == 0u, "point.loop_jump_point: trigger_time");
    expect(out.push_torque_ratio == 20u, "point.loop_jump_point: push_torque_ratio");
    expect(out.push_speed == 1u, "point.loop_jump_point: push_speed");
    expect(out.push_position == (-2147483647 - 1), "point.loop_jump_point: push_position");
    expect(out.push_mode == 0u, "point.loop_jump_point: push_mode");
    expect(ck10_point_encode(&in, bytes, sizeof wanted - 1, &length) == CK10_ERR_CAPACITY, "point.loop_jump_point short");
    expect(ck10_point_decode(wanted, sizeof wanted - 1, &out) != CK10_OK, "point.loop_jump_point cut");
}

static void test_19(void)
{
    static const uint8_t wanted[] = {0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x00, 0x01, 0x00, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x17, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x14, 0x00, 0x00, 0x00, 0x01, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[CK10_POINT_SIZE];
    ck10_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.position = (-2147483647 - 1);
    in.low_speed = 1u;
    in.high_speed = 1u;
    in.acceleration_time = 1u;
    in.deceleration_time = 1u;
    in.command = 0u;
    in.waiting_time = 0u;
    in.jump_point = 0u;
    in.jump_point_of_input_0 = 0u;
    in.jump_point_of_input_1 = 0u;
    in.jump_point_of_input_2 = 0u;
    in.loop_count = 0u;
    in.loop_jump_point = 0u;
    in.output_setting = 23u;
    in.clear_loop_counter_of = 0u;
    in.check_in_position = 0u;
    in.trigger_position = (-2147483647 - 1);
    in.trigger_time = 0u;
    in.push_torque_ratio = 20u;
    in.push_speed = 1u;
    in.push_position = (-2147483647 - 1);
    in.push_mode = 0u;
    copy(&in, &in, sizeof in);
    expect(ck10_point_encode(&in, bytes, sizeof bytes, &length) == CK10_OK, "point.output_setting encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.output_setting bytes");
    expect(ck10_point_decode(bytes, length, &out) == CK10_OK, "point.output_setting decodes");
    expect(out.position == (-2147483647 - 1), "point.output_setting: position");
    expect(out.low_speed == 1u, "point.output_setting: low_speed");
    expect(out.high_speed == 1u, "point.output_setting: high_speed");
    expect(out.acceleration_time == 1u, "point.output_setting: acceleration_time");
    expect(out.deceleration_time == 1u, "point.output_setting: deceleration_time");
    expect(out.command == 0u, "point.output_setting: command");
    expect(out.waiting_time == 0u, "point.output_setting: waiting_time");
    expect(out.jump_point == 0u, "point.output_setting: jump_point");
    expect(out.jump_point_of_input_0 == 0u, "point.output_setting: jump_point_of_input_0");
    expect(out.jump_point_of_input_1 == 0u, "point.output_setting: jump_point_of_input_1");
    expect(out.jump_point_of_input_2 == 0u, "point.output_setting: jump_point_of_input_2");
    expect(out.loop_count == 0u, "point.output_setting: loop_count");
    expect(out.loop_jump_point == 0u, "point.output_setting: loop_jump_point");
    expect(out.output_setting == 23u, "point.output_setting: output_setting");
    expect(out.clear_loop_counter_of == 0u, "point.output_setting: clear_loop_counter_of");
    expect(out.check_in_position == 0u, "point.output_setting: check_in_position");
    expect(out.trigger_position == (-2147483647 - 1), "point.output_setting: trigger_position");
    expect(out.trigger_time == 0u, "point.output_setting: trigger_time");
    expect(out.push_torque_ratio == 20u, "point.output_setting: push_torque_ratio");
    expect(out.push_speed == 1u, "point.output_setting: push_speed");
    expect(out.push_position == (-2147483647 - 1), "point.output_setting: push_position");
    expect(out.push_mode == 0u, "point.output_setting: push_mode");
    expect(ck10_point_encode(&in, bytes, sizeof wanted - 1, &length) == CK10_ERR_CAPACITY, "point.output_setting short");
    expect(ck10_point_decode(wanted, sizeof wanted - 1, &out) != CK10_OK, "point.output_setting cut");
}

static void test_20(void)
{
    static const uint8_t wanted[] = {0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x00, 0x01, 0x00, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x7F, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x14, 0x00, 0x00, 0x00, 0x01, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[CK10_POINT_SIZE];
    ck10_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.position = (-2147483647 - 1);
    in.low_speed = 1u;
    in.high_speed = 1u;
    in.acceleration_time = 1u;
    in.deceleration_time = 1u;
    in.command = 0u;
    in.waiting_time = 0u;
    in.jump_point = 0u;
    in.jump_point_of_input_0 = 0u;
    in.jump_point_of_input_1 = 0u;
    in.jump_point_of_input_2 = 0u;
    in.loop_count = 0u;
    in.loop_jump_point = 0u;
    in.output_setting = 0u;
    in.clear_loop_counter_of = 127u;
    in.check_in_position = 0u;
    in.trigger_position = (-2147483647 - 1);
    in.trigger_time = 0u;
    in.push_torque_ratio = 20u;
    in.push_speed = 1u;
    in.push_position = (-2147483647 - 1);
    in.push_mode = 0u;
    copy(&in, &in, sizeof in);
    expect(ck10_point_encode(&in, bytes, sizeof bytes, &length) == CK10_OK, "point.clear_loop_counter_of encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.clear_loop_counter_of bytes");
    expect(ck10_point_decode(bytes, length, &out) == CK10_OK, "point.clear_loop_counter_of decodes");
    expect(out.position == (-2147483647 - 1), "point.clear_loop_counter_of: position");
    expect(out.low_speed == 1u, "point.clear_loop_counter_of: low_speed");
    expect(out.high_speed == 1u, "point.clear_loop_counter_of: high_speed");
    expect(out.acceleration_time == 1u, "point.clear_loop_counter_of: acceleration_time");
    expect(out.deceleration_time == 1u, "point.clear_loop_counter_of: deceleration_time");
    expect(out.command == 0u, "point.clear_loop_counter_of: command");
    expect(out.waiting_time == 0u, "point.clear_loop_counter_of: waiting_time");
    expect(out.jump_point == 0u, "point.clear_loop_counter_of: jump_point");
    expect(out.jump_point_of_input_0 == 0u, "point.clear_loop_counter_of: jump_point_of_input_0");
    expect(out.jump_point_of_input_1 == 0u, "point.clear_loop_counter_of: jump_point_of_input_1");
    expect(out.jump_point_of_input_2 == 0u, "point.clear_loop_counter_of: jump_point_of_input_2");
    expect(out.loop_count == 0u, "point.clear_loop_counter_of: loop_count");
    expect(out.loop_jump_point == 0u, "point.clear_loop_counter_of: loop_jump_point");
    expect(out.output_setting == 0u, "point.clear_loop_counter_of: output_setting");
    expect(out.clear_loop_counter_of == 127u, "point.clear_loop_counter_of: clear_loop_counter_of");
    expect(out.check_in_position == 0u, "point.clear_loop_counter_of: check_in_position");
    expect(out.trigger_position == (-2147483647 - 1), "point.clear_loop_counter_of: trigger_position");
    expect(out.trigger_time == 0u, "point.clear_loop_counter_of: trigger_time");
    expect(out.push_torque_ratio == 20u, "point.clear_loop_counter_of: push_torque_ratio");
    expect(out.push_speed == 1u, "point.clear_loop_counter_of: push_speed");
    expect(out.push_position == (-2147483647 - 1), "point.clear_loop_counter_of: push_position");
    expect(out.push_mode == 0u, "point.clear_loop_counter_of: push_mode");
    expect(ck10_point_encode(&in, bytes, sizeof wanted - 1, &length) == CK10_ERR_CAPACITY, "point.clear_loop_counter_of short");
    expect(ck10_point_decode(wanted, sizeof wanted - 1, &out) != CK10_OK, "point.clear_loop_counter_of cut");
}

static void test_21(void)
{
    static const uint8_t wanted[] = {0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x00, 0x01, 0x00, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x14, 0x00, 0x00, 0x00, 0x01, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[CK10_POINT_SIZE];
    ck10_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.position = (-2147483647 - 1);
    in.low_speed = 1u;
    in.high_speed = 1u;
    in.acceleration_time = 1u;
    in.deceleration_time = 1u;
    in.command = 0u;
    in.waiting_time = 0u;
    in.jump_point = 0u;
    in.jump_point_of_input_0 = 0u;
    in.jump_point_of_input_1 = 0u;
    in.jump_point_of_input_2 = 0u;
    in.loop_count = 0u;
    in.loop_jump_point = 0u;
    in.output_setting = 0u;
    in.clear_loop_counter_of = 0u;
    in.check_in_position = 1u;
    in.trigger_position = (-2147483647 - 1);
    in.trigger_time = 0u;
    in.push_torque_ratio = 20u;
    in.push_speed = 1u;
    in.push_position = (-2147483647 - 1);
    in.push_mode = 0u;
    copy(&in, &in, sizeof in);
    expect(ck10_point_encode(&in, bytes, sizeof bytes, &length) == CK10_OK, "point.check_in_position encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.check_in_position bytes");
    expect(ck10_point_decode(bytes, length, &out) == CK10_OK, "point.check_in_position decodes");
    expect(out.position == (-2147483647 - 1), "point.check_in_position: position");
    expect(out.low_speed == 1u, "point.check_in_position: low_speed");
    expect(out.high_speed == 1u, "point.check_in_position: high_speed");
    expect(out.acceleration_time == 1u, "point.check_in_position: acceleration_time");
    expect(out.deceleration_time == 1u, "point.check_in_position: deceleration_time");
    expect(out.command == 0u, "point.check_in_position: command");
    expect(out.waiting_time == 0u, "point.check_in_position: waiting_time");
    expect(out.jump_point == 0u, "point.check_in_position: jump_point");
    expect(out.jump_point_of_input_0 == 0u, "point.check_in_position: jump_point_of_input_0");
    expect(out.jump_point_of_input_1 == 0u, "point.check_in_position: jump_point_of_input_1");
    expect(out.jump_point_of_input_2 == 0u, "point.check_in_position: jump_point_of_input_2");
    expect(out.loop_count == 0u, "point.check_in_position: loop_count");
    expect(out.loop_jump_point == 0u, "point.check_in_position: loop_jump_point");
    expect(out.output_setting == 0u, "point.check_in_position: output_setting");
    expect(out.clear_loop_counter_of == 0u, "point.check_in_position: clear_loop_counter_of");
    expect(out.check_in_position == 1u, "point.check_in_position: check_in_position");
    expect(out.trigger_position == (-2147483647 - 1), "point.check_in_position: trigger_position");
    expect(out.trigger_time == 0u, "point.check_in_position: trigger_time");
    expect(out.push_torque_ratio == 20u, "point.check_in_position: push_torque_ratio");
    expect(out.push_speed == 1u, "point.check_in_position: push_speed");
    expect(out.push_position == (-2147483647 - 1), "point.check_in_position: push_position");
    expect(out.push_mode == 0u, "point.check_in_position: push_mode");
    expect(ck10_point_encode(&in, bytes, sizeof wanted - 1, &length) == CK10_ERR_CAPACITY, "point.check_in_position short");
    expect(ck10_point_decode(wanted, sizeof wanted - 1, &out) != CK10_OK, "point.check_in_position cut");
}

static void test_22(void)
{
    static const uint8_t wanted[] = {0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x00, 0x01, 0x00, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x14, 0x00, 0x00, 0x00, 0x01, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[CK10_POINT_SIZE];
    ck10_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.position = (-2147483647 - 1);
    in.low_speed = 1u;
    in.high_speed = 1u;
    in.acceleration_time = 1u;
    in.deceleration_time = 1u;
    in.command = 0u;
    in.waiting_time = 0u;
    in.jump_point = 0u;
    in.jump_point_of_input_0 = 0u;
    in.jump_point_of_input_1 = 0u;
    in.jump_point_of_input_2 = 0u;
    in.loop_count = 0u;
    in.loop_jump_point = 0u;
    in.output_setting = 0u;
    in.clear_loop_counter_of = 0u;
    in.check_in_position = 0u;
    in.trigger_position = 2147483647;
    in.trigger_time = 0u;
    in.push_torque_ratio = 20u;
    in.push_speed = 1u;
    in.push_position = (-2147483647 - 1);
    in.push_mode = 0u;
    copy(&in, &in, sizeof in);
    expect(ck10_point_encode(&in, bytes, sizeof bytes, &length) == CK10_OK, "point.trigger_position encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.trigger_position bytes");
    expect(ck10_point_decode(bytes, length, &out) == CK10_OK, "point.trigger_position decodes");
    expect(out.position == (-2147483647 - 1), "point.trigger_position: position");
    expect(out.low_speed == 1u, "point.trigger_position: low_speed");
    expect(out.high_speed == 1u, "point.trigger_position: high_speed");
    expect(out.acceleration_time == 1u, "point.trigger_position: acceleration_time");
    expect(out.deceleration_time == 1u, "point.trigger_position: deceleration_time");
    expect(out.command == 0u, "point.trigger_position: command");
    expect(out.waiting_time == 0u, "point.trigger_position: waiting_time");
    expect(out.jump_point == 0u, "point.trigger_position: jump_point");
    expect(out.jump_point_of_input_0 == 0u, "point.trigger_position: jump_point_of_input_0");
    expect(out.jump_point_of_input_1 == 0u, "point.trigger_position: jump_point_of_input_1");
    expect(out.jump_point_of_input_2 == 0u, "point.trigger_position: jump_point_of_input_2");
    expect(out.loop_count == 0u, "point.trigger_position: loop_count");
    expect(out.loop_jump_point == 0u, "point.trigger_position: loop_jump_point");
    expect(out.output_setting == 0u, "point.trigger_position: output_setting");
    expect(out.clear_loop_counter_of == 0u, "point.trigger_position: clear_loop_counter_of");
    expect(out.check_in_position == 0u, "point.trigger_position: check_in_position");
    expect(out.trigger_position == 2147483647, "point.trigger_position: trigger_position");
    expect(out.trigger_time == 0u, "point.trigger_position: trigger_time");
    expect(out.push_torque_ratio == 20u, "point.trigger_position: push_torque_ratio");
    expect(out.push_speed == 1u, "point.trigger_position: push_speed");
    expect(out.push_position == (-2147483647 - 1), "point.trigger_position: push_position");
    expect(out.push_mode == 0u, "point.trigger_position: push_mode");
    expect(ck10_point_encode(&in, bytes, sizeof wanted - 1, &length) == CK10_ERR_CAPACITY, "point.trigger_position short");
    expect(ck10_point_decode(wanted, sizeof wanted - 1, &out) != CK10_OK, "point.trigger_position cut");
}

static void test_23(void)
{
    static const uint8_t wanted[] = {0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x00, 0x01, 0x00, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x00, 0x14, 0x00, 0x00, 0x00, 0x01, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[CK10_POINT_SIZE];
    ck10_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.position = (-2147483647 - 1);
    in.low_speed = 1u;
    in.high_speed = 1u;
    in.acceleration_time = 1u;
    in.deceleration_time = 1u;
    in.command = 0u;
    in.waiting_time = 0u;
    in.jump_point = 0u;
    in.jump_point_of_input_0 = 0u;
    in.jump_point_of_input_1 = 0u;
    in.jump_point_of_input_2 = 0u;
    in.loop_count = 0u;
    in.loop_jump_point = 0u;
    in.output_setting = 0u;
    in.clear_loop_counter_of = 0u;
    in.check_in_position = 0u;
    in.trigger_position = (-2147483647 - 1);
    in.trigger_time = 65535u;
    in.push_torque_ratio = 20u;
    in.push_speed = 1u;
    in.push_position = (-2147483647 - 1);
    in.push_mode = 0u;
    copy(&in, &in, sizeof in);
    expect(ck10_point_encode(&in, bytes, sizeof bytes, &length) == CK10_OK, "point.trigger_time encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.trigger_time bytes");
    expect(ck10_point_decode(bytes, length, &out) == CK10_OK, "point.trigger_time decodes");
    expect(out.position == (-2147483647 - 1), "point.trigger_time: position");
    expect(out.low_speed == 1u, "point.trigger_time: low_speed");
    expect(out.high_speed == 1u, "point.trigger_time: high_speed");
    expect(out.acceleration_time == 1u, "point.trigger_time: acceleration_time");
    expect(out.deceleration_time == 1u, "point.trigger_time: deceleration_time");
    expect(out.command == 0u, "point.trigger_time: command");
    expect(out.waiting_time == 0u, "point.trigger_time: waiting_time");
    expect(out.jump_point == 0u, "point.trigger_time: jump_point");
    expect(out.jump_point_of_input_0 == 0u, "point.trigger_time: jump_point_of_input_0");
    expect(out.jump_point_of_input_1 == 0u, "point.trigger_time: jump_point_of_input_1");
    expect(out.jump_point_of_input_2 == 0u, "point.trigger_time: jump_point_of_input_2");
    expect(out.loop_count == 0u, "point.trigger_time: loop_count");
    expect(out.loop_jump_point == 0u, "point.trigger_time: loop_jump_point");
    expect(out.output_setting == 0u, "point.trigger_time: output_setting");
    expect(out.clear_loop_counter_of == 0u, "point.trigger_time: clear_loop_counter_of");
    expect(out.check_in_position == 0u, "point.trigger_time: check_in_position");
    expect(out.trigger_position == (-2147483647 - 1), "point.trigger_time: trigger_position");
    expect(out.trigger_time == 65535u, "point.trigger_time: trigger_time");
    expect(out.push_torque_ratio == 20u, "point.trigger_time: push_torque_ratio");
    expect(out.push_speed == 1u, "point.trigger_time: push_speed");
    expect(out.push_position == (-2147483647 - 1), "point.trigger_time: push_position");
    expect(out.push_mode == 0u, "point.trigger_time: push_mode");
    expect(ck10_point_encode(&in, bytes, sizeof wanted - 1, &length) == CK10_ERR_CAPACITY, "point.trigger_time short");
    expect(ck10_point_decode(wanted, sizeof wanted - 1, &out) != CK10_OK, "point.trigger_time cut");
}

static void test_24(void)
{
    static const uint8_t wanted[] = {0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x00, 0x01, 0x00, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x5A, 0x00, 0x00, 0x00, 0x01, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[CK10_POINT_SIZE];
    ck10_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.position = (-2147483647 - 1);
    in.low_speed = 1u;
    in.high_speed = 1u;
    in.acceleration_time = 1u;
    in.deceleration_time = 1u;
    in.command = 0u;
    in.waiting_time = 0u;
    in.jump_point = 0u;
    in.jump_point_of_input_0 = 0u;
    in.jump_point_of_input_1 = 0u;
    in.jump_point_of_input_2 = 0u;
    in.loop_count = 0u;
    in.loop_jump_point = 0u;
    in.output_setting = 0u;
    in.clear_loop_counter_of = 0u;
    in.check_in_position = 0u;
    in.trigger_position = (-2147483647 - 1);
    in.trigger_time = 0u;
    in.push_torque_ratio = 90u;
    in.push_speed = 1u;
    in.push_position = (-2147483647 - 1);
    in.push_mode = 0u;
    copy(&in, &in, sizeof in);
    expect(ck10_point_encode(&in, bytes, sizeof bytes, &length) == CK10_OK, "point.push_torque_ratio encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.push_torque_ratio bytes");
    expect(ck10_point_decode(bytes, length, &out) == CK10_OK, "point.push_torque_ratio decodes");
    expect(out.position == (-2147483647 - 1), "point.push_torque_ratio: position");
    expect(out.low_speed == 1u, "point.push_torque_ratio: low_speed");
    expect(out.high_speed == 1u, "point.push_torque_ratio: high_speed");
    expect(out.acceleration_time == 1u, "point.push_torque_ratio: acceleration_time");
    expect(out.deceleration_time == 1u, "point.push_torque_ratio: deceleration_time");
    expect(out.command == 0u, "point.push_torque_ratio: command");
    expect(out.waiting_time == 0u, "point.push_torque_ratio: waiting_time");
    expect(out.jump_point == 0u, "point.push_torque_ratio: jump_point");
    expect(out.jump_point_of_input_0 == 0u, "point.push_torque_ratio: jump_point_of_input_0");
    expect(out.jump_point_of_input_1 == 0u, "point.push_torque_ratio: jump_point_of_input_1");
    expect(out.jump_point_of_input_2 == 0u, "point.push_torque_ratio: jump_point_of_input_2");
    expect(out.loop_count == 0u, "point.push_torque_ratio: loop_count");
    expect(out.loop_jump_point == 0u, "point.push_torque_ratio: loop_jump_point");
    expect(out.output_setting == 0u, "point.push_torque_ratio: output_setting");
    expect(out.clear_loop_counter_of == 0u, "point.push_torque_ratio: clear_loop_counter_of");
    expect(out.check_in_position == 0u, "point.push_torque_ratio: check_in_position");
    expect(out.trigger_position == (-2147483647 - 1), "point.push_torque_ratio: trigger_position");
    expect(out.trigger_time == 0u, "point.push_torque_ratio: trigger_time");
    expect(out.push_torque_ratio == 90u, "point.push_torque_ratio: push_torque_ratio");
    expect(out.push_speed == 1u, "point.push_torque_ratio: push_speed");
    expect(out.push_position == (-2147483647 - 1), "point.push_torque_ratio: push_position");
    expect(out.push_mode == 0u, "point.push_torque_ratio: push_mode");
    expect(ck10_point_encode(&in, bytes, sizeof wanted - 1, &length) == CK10_ERR_CAPACITY, "point.push_torque_ratio short");
    expect(ck10_point_decode(wanted, sizeof wanted - 1, &out) != CK10_OK, "point.push_torque_ratio cut");
}

static void test_25(void)
{
    static const uint8_t wanted[] = {0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x00, 0x01, 0x00, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x14, 0x00, 0x00, 0x82, 0x35, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[CK10_POINT_SIZE];
    ck10_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.position = (-2147483647 - 1);
    in.low_speed = 1u;
    in.high_speed = 1u;
    in.acceleration_time = 1u;
    in.deceleration_time = 1u;
    in.command = 0u;
    in.waiting_time = 0u;
    in.jump_point = 0u;
    in.jump_point_of_input_0 = 0u;
    in.jump_point_of_input_1 = 0u;
    in.jump_point_of_input_2 = 0u;
    in.loop_count = 0u;
    in.loop_jump_point = 0u;
    in.output_setting = 0u;
    in.clear_loop_counter_of = 0u;
    in.check_in_position = 0u;
    in.trigger_position = (-2147483647 - 1);
    in.trigger_time = 0u;
    in.push_torque_ratio = 20u;
    in.push_speed = 33333u;
    in.push_position = (-2147483647 - 1);
    in.push_mode = 0u;
    copy(&in, &in, sizeof in);
    expect(ck10_point_encode(&in, bytes, sizeof bytes, &length) == CK10_OK, "point.push_speed encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.push_speed bytes");
    expect(ck10_point_decode(bytes, length, &out) == CK10_OK, "point.push_speed decodes");
    expect(out.position == (-2147483647 - 1), "point.push_speed: position");
    expect(out.low_speed == 1u, "point.push_speed: low_speed");
    expect(out.high_speed == 1u, "point.push_speed: high_speed");
    expect(out.acceleration_time == 1u, "point.push_speed: acceleration_time");
    expect(out.deceleration_time == 1u, "point.push_speed: deceleration_time");
    expect(out.command == 0u, "point.push_speed: command");
    expect(out.waiting_time == 0u, "point.push_speed: waiting_time");
    expect(out.jump_point == 0u, "point.push_speed: jump_point");
    expect(out.jump_point_of_input_0 == 0u, "point.push_speed: jump_point_of_input_0");
    expect(out.jump_point_of_input_1 == 0u, "point.push_speed: jump_point_of_input_1");
    expect(out.jump_point_of_input_2 == 0u, "point.push_speed: jump_point_of_input_2");
    expect(out.loop_count == 0u, "point.push_speed: loop_count");
    expect(out.loop_jump_point == 0u, "point.push_speed: loop_jump_point");
    expect(out.output_setting == 0u, "point.push_speed: output_setting");
    expect(out.clear_loop_counter_of == 0u, "point.push_speed: clear_loop_counter_of");
    expect(out.check_in_position == 0u, "point.push_speed: check_in_position");
    expect(out.trigger_position == (-2147483647 - 1), "point.push_speed: trigger_position");
    expect(out.trigger_time == 0u, "point.push_speed: trigger_time");
    expect(out.push_torque_ratio == 20u, "point.push_speed: push_torque_ratio");
    expect(out.push_speed == 33333u, "point.push_speed: push_speed");
    expect(out.push_position == (-2147483647 - 1), "point.push_speed: push_position");
    expect(out.push_mode == 0u, "point.push_speed: push_mode");
    expect(ck10_point_encode(&in, bytes, sizeof wanted - 1, &length) == CK10_ERR_CAPACITY, "point.push_speed short");
    expect(ck10_point_decode(wanted, sizeof wanted - 1, &out) != CK10_OK, "point.push_speed cut");
}

static void test_26(void)
{
    static const uint8_t wanted[] = {0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x00, 0x01, 0x00, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x14, 0x00, 0x00, 0x00, 0x01, 0x7F, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[CK10_POINT_SIZE];
    ck10_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.position = (-2147483647 - 1);
    in.low_speed = 1u;
    in.high_speed = 1u;
    in.acceleration_time = 1u;
    in.deceleration_time = 1u;
    in.command = 0u;
    in.waiting_time = 0u;
    in.jump_point = 0u;
    in.jump_point_of_input_0 = 0u;
    in.jump_point_of_input_1 = 0u;
    in.jump_point_of_input_2 = 0u;
    in.loop_count = 0u;
    in.loop_jump_point = 0u;
    in.output_setting = 0u;
    in.clear_loop_counter_of = 0u;
    in.check_in_position = 0u;
    in.trigger_position = (-2147483647 - 1);
    in.trigger_time = 0u;
    in.push_torque_ratio = 20u;
    in.push_speed = 1u;
    in.push_position = 2147483647;
    in.push_mode = 0u;
    copy(&in, &in, sizeof in);
    expect(ck10_point_encode(&in, bytes, sizeof bytes, &length) == CK10_OK, "point.push_position encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.push_position bytes");
    expect(ck10_point_decode(bytes, length, &out) == CK10_OK, "point.push_position decodes");
    expect(out.position == (-2147483647 - 1), "point.push_position: position");
    expect(out.low_speed == 1u, "point.push_position: low_speed");
    expect(out.high_speed == 1u, "point.push_position: high_speed");
    expect(out.acceleration_time == 1u, "point.push_position: acceleration_time");
    expect(out.deceleration_time == 1u, "point.push_position: deceleration_time");
    expect(out.command == 0u, "point.push_position: command");
    expect(out.waiting_time == 0u, "point.push_position: waiting_time");
    expect(out.jump_point == 0u, "point.push_position: jump_point");
    expect(out.jump_point_of_input_0 == 0u, "point.push_position: jump_point_of_input_0");
    expect(out.jump_point_of_input_1 == 0u, "point.push_position: jump_point_of_input_1");
    expect(out.jump_point_of_input_2 == 0u, "point.push_position: jump_point_of_input_2");
    expect(out.loop_count == 0u, "point.push_position: loop_count");
    expect(out.loop_jump_point == 0u, "point.push_position: loop_jump_point");
    expect(out.output_setting == 0u, "point.push_position: output_setting");
    expect(out.clear_loop_counter_of == 0u, "point.push_position: clear_loop_counter_of");
    expect(out.check_in_position == 0u, "point.push_position: check_in_position");
    expect(out.trigger_position == (-2147483647 - 1), "point.push_position: trigger_position");
    expect(out.trigger_time == 0u, "point.push_position: trigger_time");
    expect(out.push_torque_ratio == 20u, "point.push_position: push_torque_ratio");
    expect(out.push_speed == 1u, "point.push_position: push_speed");
    expect(out.push_position == 2147483647, "point.push_position: push_position");
    expect(out.push_mode == 0u, "point.push_position: push_mode");
    expect(ck10_point_encode(&in, bytes, sizeof wanted - 1, &length) == CK10_ERR_CAPACITY, "point.push_position short");
    expect(ck10_point_decode(wanted, sizeof wanted - 1, &out) != CK10_OK, "point.push_position cut");
}

static void test_27(void)
{
    static const uint8_t wanted[] = {0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x00, 0x01, 0x00, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x14, 0x00, 0x00, 0x00, 0x01, 0x80, 0x00, 0x00, 0x00, 0x27, 0x10, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    uint8_t bytes[CK10_POINT_SIZE];
    ck10_point in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.position = (-2147483647 - 1);
    in.low_speed = 1u;
    in.high_speed = 1u;
    in.acceleration_time = 1u;
    in.deceleration_time = 1u;
    in.command = 0u;
    in.waiting_time = 0u;
    in.jump_point = 0u;
    in.jump_point_of_input_0 = 0u;
    in.jump_point_of_input_1 = 0u;
    in.jump_point_of_input_2 = 0u;
    in.loop_count = 0u;
    in.loop_jump_point = 0u;
    in.output_setting = 0u;
    in.clear_loop_counter_of = 0u;
    in.check_in_position = 0u;
    in.trigger_position = (-2147483647 - 1);
    in.trigger_time = 0u;
    in.push_torque_ratio = 20u;
    in.push_speed = 1u;
    in.push_position = (-2147483647 - 1);
    in.push_mode = 10000u;
    copy(&in, &in, sizeof in);
    expect(ck10_point_encode(&in, bytes, sizeof bytes, &length) == CK10_OK, "point.push_mode encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "point.push_mode bytes");
    expect(ck10_point_decode(bytes, length, &out) == CK10_OK, "point.push_mode decodes");
    expect(out.position == (-2147483647 - 1), "point.push_mode: position");
    expect(out.low_speed == 1u, "point.push_mode: low_speed");
    expect(out.high_speed == 1u, "point.push_mode: high_speed");
    expect(out.acceleration_time == 1u, "point.push_mode: acceleration_time");
    expect(out.deceleration_time == 1u, "point.push_mode: deceleration_time");
    expect(out.command == 0u, "point.push_mode: command");
    expect(out.waiting_time == 0u, "point.push_mode: waiting_time");
    expect(out.jump_point == 0u, "point.push_mode: jump_point");
    expect(out.jump_point_of_input_0 == 0u, "point.push_mode: jump_point_of_input_0");
    expect(out.jump_point_of_input_1 == 0u, "point.push_mode: jump_point_of_input_1");
    expect(out.jump_point_of_input_2 == 0u, "point.push_mode: jump_point_of_input_2");
    expect(out.loop_count == 0u, "point.push_mode: loop_count");
    expect(out.loop_jump_point == 0u, "point.push_mode: loop_jump_point");
    expect(out.output_setting == 0u, "point.push_mode: output_setting");
    expect(out.clear_loop_counter_of == 0u, "point.push_mode: clear_loop_counter_of");
    expect(out.check_in_position == 0u, "point.push_mode: check_in_position");
    expect(out.trigger_position == (-2147483647 - 1), "point.push_mode: trigger_position");
    expect(out.trigger_time == 0u, "point.push_mode: trigger_time");
    expect(out.push_torque_ratio == 20u, "point.push_mode: push_torque_ratio");
    expect(out.push_speed == 1u, "point.push_mode: push_speed");
    expect(out.push_position == (-2147483647 - 1), "point.push_mode: push_position");
    expect(out.push_mode == 10000u, "point.push_mode: push_mode");
    expect(ck10_point_encode(&in, bytes, sizeof wanted - 1, &length) == CK10_ERR_CAPACITY, "point.push_mode short");
    expect(ck10_point_decode(wanted, sizeof wanted - 1, &out) != CK10_OK, "point.push_mode cut");
}

static void test_28(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF, 0x00, 0x01};
    uint8_t bytes[CK10_READ_REGISTERS_REQUEST_SIZE];
    ck10_read_registers_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.address = 65535u;
    in.word_count = 1u;
    copy(&in, &in, sizeof in);
    expect(ck10_read_registers_request_encode(&in, bytes, sizeof bytes, &length) == CK10_OK, "read_registers_request.address encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_registers_request.address bytes");
    expect(ck10_read_registers_request_decode(bytes, length, &out) == CK10_OK, "read_registers_request.address decodes");
    expect(out.address == 65535u, "read_registers_request.address: address");
    expect(out.word_count == 1u, "read_registers_request.address: word_count");
    expect(ck10_read_registers_request_encode(&in, bytes, sizeof wanted - 1, &length) == CK10_ERR_CAPACITY, "read_registers_request.address short");
    expect(ck10_read_registers_request_decode(wanted, sizeof wanted - 1, &out) != CK10_OK, "read_registers_request.address cut");
}

static void test_29(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x00, 0x7D};
    uint8_t bytes[CK10_READ_REGISTERS_REQUEST_SIZE];
    ck10_read_registers_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.address = 0u;
    in.word_count = 125u;
    copy(&in, &in, sizeof in);
    expect(ck10_read_registers_request_encode(&in, bytes, sizeof bytes, &length) == CK10_OK, "read_registers_request.word_count encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_registers_request.word_count bytes");
    expect(ck10_read_registers_request_decode(bytes, length, &out) == CK10_OK, "read_registers_request.word_count decodes");
    expect(out.address == 0u, "read_registers_request.word_count: address");
    expect(out.word_count == 125u, "read_registers_request.word_count: word_count");
    expect(ck10_read_registers_request_encode(&in, bytes, sizeof wanted - 1, &length) == CK10_ERR_CAPACITY, "read_registers_request.word_count short");
    expect(ck10_read_registers_request_decode(wanted, sizeof wanted - 1, &out) != CK10_OK, "read_registers_request.word_count cut");
}

static void test_30(void)
{
    static const uint8_t wanted[] = {0x02, 0xFF, 0xFF};
    uint8_t bytes[CK10_READ_REGISTERS_RESPONSE_SIZE];
    ck10_read_registers_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.values_count = 1u;
    in.values[0] = 65535u;
    copy(&in, &in, sizeof in);
    expect(ck10_read_registers_response_encode(&in, bytes, sizeof bytes, &length) == CK10_OK, "read_registers_response.values encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "read_registers_response.values bytes");
    expect(ck10_read_registers_response_decode(bytes, length, &out) == CK10_OK, "read_registers_response.values decodes");
    expect(out.values_count == 1u, "read_registers_response.values: values count");
    expect(out.values[0] == 65535u, "read_registers_response.values: values");
    expect(ck10_read_registers_response_encode(&in, bytes, sizeof wanted - 1, &length) == CK10_ERR_CAPACITY, "read_registers_response.values short");
    expect(ck10_read_registers_response_decode(wanted, sizeof wanted - 1, &out) != CK10_OK, "read_registers_response.values cut");
}

static void test_31(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF, 0x00, 0x00};
    uint8_t bytes[CK10_WRITE_REGISTER_REQUEST_SIZE];
    ck10_write_register_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.address = 65535u;
    in.value = 0u;
    copy(&in, &in, sizeof in);
    expect(ck10_write_register_request_encode(&in, bytes, sizeof bytes, &length) == CK10_OK, "write_register_request.address encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_register_request.address bytes");
    expect(ck10_write_register_request_decode(bytes, length, &out) == CK10_OK, "write_register_request.address decodes");
    expect(out.address == 65535u, "write_register_request.address: address");
    expect(out.value == 0u, "write_register_request.address: value");
    expect(ck10_write_register_request_encode(&in, bytes, sizeof wanted - 1, &length) == CK10_ERR_CAPACITY, "write_register_request.address short");
    expect(ck10_write_register_request_decode(wanted, sizeof wanted - 1, &out) != CK10_OK, "write_register_request.address cut");
}

static void test_32(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0xFF, 0xFF};
    uint8_t bytes[CK10_WRITE_REGISTER_REQUEST_SIZE];
    ck10_write_register_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.address = 0u;
    in.value = 65535u;
    copy(&in, &in, sizeof in);
    expect(ck10_write_register_request_encode(&in, bytes, sizeof bytes, &length) == CK10_OK, "write_register_request.value encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_register_request.value bytes");
    expect(ck10_write_register_request_decode(bytes, length, &out) == CK10_OK, "write_register_request.value decodes");
    expect(out.address == 0u, "write_register_request.value: address");
    expect(out.value == 65535u, "write_register_request.value: value");
    expect(ck10_write_register_request_encode(&in, bytes, sizeof wanted - 1, &length) == CK10_ERR_CAPACITY, "write_register_request.value short");
    expect(ck10_write_register_request_decode(wanted, sizeof wanted - 1, &out) != CK10_OK, "write_register_request.value cut");
}

static void test_33(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF, 0x00, 0x00};
    uint8_t bytes[CK10_WRITE_REGISTER_RESPONSE_SIZE];
    ck10_write_register_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.address = 65535u;
    in.value = 0u;
    copy(&in, &in, sizeof in);
    expect(ck10_write_register_response_encode(&in, bytes, sizeof bytes, &length) == CK10_OK, "write_register_response.address encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_register_response.address bytes");
    expect(ck10_write_register_response_decode(bytes, length, &out) == CK10_OK, "write_register_response.address decodes");
    expect(out.address == 65535u, "write_register_response.address: address");
    expect(out.value == 0u, "write_register_response.address: value");
    expect(ck10_write_register_response_encode(&in, bytes, sizeof wanted - 1, &length) == CK10_ERR_CAPACITY, "write_register_response.address short");
    expect(ck10_write_register_response_decode(wanted, sizeof wanted - 1, &out) != CK10_OK, "write_register_response.address cut");
}

static void test_34(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0xFF, 0xFF};
    uint8_t bytes[CK10_WRITE_REGISTER_RESPONSE_SIZE];
    ck10_write_register_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.address = 0u;
    in.value = 65535u;
    copy(&in, &in, sizeof in);
    expect(ck10_write_register_response_encode(&in, bytes, sizeof bytes, &length) == CK10_OK, "write_register_response.value encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_register_response.value bytes");
    expect(ck10_write_register_response_decode(bytes, length, &out) == CK10_OK, "write_register_response.value decodes");
    expect(out.address == 0u, "write_register_response.value: address");
    expect(out.value == 65535u, "write_register_response.value: value");
    expect(ck10_write_register_response_encode(&in, bytes, sizeof wanted - 1, &length) == CK10_ERR_CAPACITY, "write_register_response.value short");
    expect(ck10_write_register_response_decode(wanted, sizeof wanted - 1, &out) != CK10_OK, "write_register_response.value cut");
}

static void test_35(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF, 0x00, 0x01, 0x02, 0x00, 0x00};
    uint8_t bytes[CK10_WRITE_REGISTERS_REQUEST_SIZE];
    ck10_write_registers_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.address = 65535u;
    in.values_count = 1u;
    in.values[0] = 0u;
    copy(&in, &in, sizeof in);
    expect(ck10_write_registers_request_encode(&in, bytes, sizeof bytes, &length) == CK10_OK, "write_registers_request.address encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_registers_request.address bytes");
    expect(ck10_write_registers_request_decode(bytes, length, &out) == CK10_OK, "write_registers_request.address decodes");
    expect(out.address == 65535u, "write_registers_request.address: address");
    expect(out.values_count == 1u, "write_registers_request.address: values count");
    expect(out.values[0] == 0u, "write_registers_request.address: values");
    expect(ck10_write_registers_request_encode(&in, bytes, sizeof wanted - 1, &length) == CK10_ERR_CAPACITY, "write_registers_request.address short");
    expect(ck10_write_registers_request_decode(wanted, sizeof wanted - 1, &out) != CK10_OK, "write_registers_request.address cut");
}

static void test_36(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0x00, 0x01, 0x02, 0xFF, 0xFF};
    uint8_t bytes[CK10_WRITE_REGISTERS_REQUEST_SIZE];
    ck10_write_registers_request in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.address = 0u;
    in.values_count = 1u;
    in.values[0] = 65535u;
    copy(&in, &in, sizeof in);
    expect(ck10_write_registers_request_encode(&in, bytes, sizeof bytes, &length) == CK10_OK, "write_registers_request.values encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_registers_request.values bytes");
    expect(ck10_write_registers_request_decode(bytes, length, &out) == CK10_OK, "write_registers_request.values decodes");
    expect(out.address == 0u, "write_registers_request.values: address");
    expect(out.values_count == 1u, "write_registers_request.values: values count");
    expect(out.values[0] == 65535u, "write_registers_request.values: values");
    expect(ck10_write_registers_request_encode(&in, bytes, sizeof wanted - 1, &length) == CK10_ERR_CAPACITY, "write_registers_request.values short");
    expect(ck10_write_registers_request_decode(wanted, sizeof wanted - 1, &out) != CK10_OK, "write_registers_request.values cut");
}

static void test_37(void)
{
    static const uint8_t wanted[] = {0xFF, 0xFF, 0x00, 0x00};
    uint8_t bytes[CK10_WRITE_REGISTERS_RESPONSE_SIZE];
    ck10_write_registers_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.address = 65535u;
    in.word_count = 0u;
    copy(&in, &in, sizeof in);
    expect(ck10_write_registers_response_encode(&in, bytes, sizeof bytes, &length) == CK10_OK, "write_registers_response.address encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_registers_response.address bytes");
    expect(ck10_write_registers_response_decode(bytes, length, &out) == CK10_OK, "write_registers_response.address decodes");
    expect(out.address == 65535u, "write_registers_response.address: address");
    expect(out.word_count == 0u, "write_registers_response.address: word_count");
    expect(ck10_write_registers_response_encode(&in, bytes, sizeof wanted - 1, &length) == CK10_ERR_CAPACITY, "write_registers_response.address short");
    expect(ck10_write_registers_response_decode(wanted, sizeof wanted - 1, &out) != CK10_OK, "write_registers_response.address cut");
}

static void test_38(void)
{
    static const uint8_t wanted[] = {0x00, 0x00, 0xFF, 0xFF};
    uint8_t bytes[CK10_WRITE_REGISTERS_RESPONSE_SIZE];
    ck10_write_registers_response in, out;
    size_t length = 0;
    clear(bytes, sizeof bytes);
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    in.address = 0u;
    in.word_count = 65535u;
    copy(&in, &in, sizeof in);
    expect(ck10_write_registers_response_encode(&in, bytes, sizeof bytes, &length) == CK10_OK, "write_registers_response.word_count encodes");
    expect(length == sizeof wanted && same_bytes(bytes, wanted, length), "write_registers_response.word_count bytes");
    expect(ck10_write_registers_response_decode(bytes, length, &out) == CK10_OK, "write_registers_response.word_count decodes");
    expect(out.address == 0u, "write_registers_response.word_count: address");
    expect(out.word_count == 65535u, "write_registers_response.word_count: word_count");
    expect(ck10_write_registers_response_encode(&in, bytes, sizeof wanted - 1, &length) == CK10_ERR_CAPACITY, "write_registers_response.word_count short");
    expect(ck10_write_registers_response_decode(wanted, sizeof wanted - 1, &out) != CK10_OK, "write_registers_response.word_count cut");
}

static void test_39(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_axis_start_speed_encode(in, bytes) == CK10_OK, "axis_start_speed 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "axis_start_speed 0 bytes");
    expect(ck10_reg_axis_start_speed_decode(bytes, &out) == CK10_OK, "axis_start_speed 0");
    expect(out == 0u, "axis_start_speed 0");
    in = 4294967295u;
    expect(ck10_reg_axis_start_speed_encode(in, bytes) == CK10_OK, "axis_start_speed 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "axis_start_speed 4294967295 bytes");
    expect(ck10_reg_axis_start_speed_decode(bytes, &out) == CK10_OK, "axis_start_speed 4294967295");
    expect(out == 4294967295u, "axis_start_speed 4294967295");
}

static void test_40(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(ck10_reg_axis_acceleration_time_encode(in, bytes) == CK10_OK, "axis_acceleration_time 0");
    expect(same_bytes(bytes, "\000\000", 2u), "axis_acceleration_time 0 bytes");
    expect(ck10_reg_axis_acceleration_time_decode(bytes, &out) == CK10_OK, "axis_acceleration_time 0");
    expect(out == 0u, "axis_acceleration_time 0");
    in = 65535u;
    expect(ck10_reg_axis_acceleration_time_encode(in, bytes) == CK10_OK, "axis_acceleration_time 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "axis_acceleration_time 65535 bytes");
    expect(ck10_reg_axis_acceleration_time_decode(bytes, &out) == CK10_OK, "axis_acceleration_time 65535");
    expect(out == 65535u, "axis_acceleration_time 65535");
}

static void test_41(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(ck10_reg_axis_deceleration_time_encode(in, bytes) == CK10_OK, "axis_deceleration_time 0");
    expect(same_bytes(bytes, "\000\000", 2u), "axis_deceleration_time 0 bytes");
    expect(ck10_reg_axis_deceleration_time_decode(bytes, &out) == CK10_OK, "axis_deceleration_time 0");
    expect(out == 0u, "axis_deceleration_time 0");
    in = 65535u;
    expect(ck10_reg_axis_deceleration_time_encode(in, bytes) == CK10_OK, "axis_deceleration_time 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "axis_deceleration_time 65535 bytes");
    expect(ck10_reg_axis_deceleration_time_decode(bytes, &out) == CK10_OK, "axis_deceleration_time 65535");
    expect(out == 65535u, "axis_deceleration_time 65535");
}

static void test_42(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_axis_move_speed_encode(in, bytes) == CK10_OK, "axis_move_speed 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "axis_move_speed 0 bytes");
    expect(ck10_reg_axis_move_speed_decode(bytes, &out) == CK10_OK, "axis_move_speed 0");
    expect(out == 0u, "axis_move_speed 0");
    in = 4294967295u;
    expect(ck10_reg_axis_move_speed_encode(in, bytes) == CK10_OK, "axis_move_speed 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "axis_move_speed 4294967295 bytes");
    expect(ck10_reg_axis_move_speed_decode(bytes, &out) == CK10_OK, "axis_move_speed 4294967295");
    expect(out == 4294967295u, "axis_move_speed 4294967295");
}

static void test_43(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(ck10_reg_target_position_or_distance_encode(in, bytes) == CK10_OK, "target_position_or_distance -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "target_position_or_distance -2147483648 bytes");
    expect(ck10_reg_target_position_or_distance_decode(bytes, &out) == CK10_OK, "target_position_or_distance -2147483648");
    expect(out == (-2147483647 - 1), "target_position_or_distance -2147483648");
    in = 0;
    expect(ck10_reg_target_position_or_distance_encode(in, bytes) == CK10_OK, "target_position_or_distance 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "target_position_or_distance 0 bytes");
    expect(ck10_reg_target_position_or_distance_decode(bytes, &out) == CK10_OK, "target_position_or_distance 0");
    expect(out == 0, "target_position_or_distance 0");
    in = 2147483647;
    expect(ck10_reg_target_position_or_distance_encode(in, bytes) == CK10_OK, "target_position_or_distance 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "target_position_or_distance 2147483647 bytes");
    expect(ck10_reg_target_position_or_distance_decode(bytes, &out) == CK10_OK, "target_position_or_distance 2147483647");
    expect(out == 2147483647, "target_position_or_distance 2147483647");
}

static void test_44(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile ck10_move_kind in = CK10_MOVE_KIND_RELATIVE;
    in = CK10_MOVE_KIND_RELATIVE;
    expect(ck10_reg_start_move_encode(in, bytes) == CK10_OK, "start_move 1");
    expect(same_bytes(bytes, "\000\001", 2u), "start_move 1 bytes");
    expect(ck10_reg_start_move_decode(bytes, &out) == CK10_OK, "start_move 1");
    expect(out == 1u, "start_move 1");
    in = CK10_MOVE_KIND_ABSOLUTE;
    expect(ck10_reg_start_move_encode(in, bytes) == CK10_OK, "start_move 2");
    expect(same_bytes(bytes, "\000\002", 2u), "start_move 2 bytes");
    expect(ck10_reg_start_move_decode(bytes, &out) == CK10_OK, "start_move 2");
    expect(out == 2u, "start_move 2");
}

static void test_45(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(ck10_reg_axis_jog_acceleration_time_encode(in, bytes) == CK10_OK, "axis_jog_acceleration_time 0");
    expect(same_bytes(bytes, "\000\000", 2u), "axis_jog_acceleration_time 0 bytes");
    expect(ck10_reg_axis_jog_acceleration_time_decode(bytes, &out) == CK10_OK, "axis_jog_acceleration_time 0");
    expect(out == 0u, "axis_jog_acceleration_time 0");
    in = 65535u;
    expect(ck10_reg_axis_jog_acceleration_time_encode(in, bytes) == CK10_OK, "axis_jog_acceleration_time 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "axis_jog_acceleration_time 65535 bytes");
    expect(ck10_reg_axis_jog_acceleration_time_decode(bytes, &out) == CK10_OK, "axis_jog_acceleration_time 65535");
    expect(out == 65535u, "axis_jog_acceleration_time 65535");
}

static void test_46(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_axis_jog_start_speed_encode(in, bytes) == CK10_OK, "axis_jog_start_speed 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "axis_jog_start_speed 0 bytes");
    expect(ck10_reg_axis_jog_start_speed_decode(bytes, &out) == CK10_OK, "axis_jog_start_speed 0");
    expect(out == 0u, "axis_jog_start_speed 0");
    in = 4294967295u;
    expect(ck10_reg_axis_jog_start_speed_encode(in, bytes) == CK10_OK, "axis_jog_start_speed 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "axis_jog_start_speed 4294967295 bytes");
    expect(ck10_reg_axis_jog_start_speed_decode(bytes, &out) == CK10_OK, "axis_jog_start_speed 4294967295");
    expect(out == 4294967295u, "axis_jog_start_speed 4294967295");
}

static void test_47(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_axis_jog_speed_encode(in, bytes) == CK10_OK, "axis_jog_speed 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "axis_jog_speed 0 bytes");
    expect(ck10_reg_axis_jog_speed_decode(bytes, &out) == CK10_OK, "axis_jog_speed 0");
    expect(out == 0u, "axis_jog_speed 0");
    in = 4294967295u;
    expect(ck10_reg_axis_jog_speed_encode(in, bytes) == CK10_OK, "axis_jog_speed 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "axis_jog_speed 4294967295 bytes");
    expect(ck10_reg_axis_jog_speed_decode(bytes, &out) == CK10_OK, "axis_jog_speed 4294967295");
    expect(out == 4294967295u, "axis_jog_speed 4294967295");
}

static void test_48(void)
{
    uint8_t bytes[2];
    ck10_jog_direction out = CK10_JOG_DIRECTION_CLOCKWISE;
    volatile ck10_jog_direction in = CK10_JOG_DIRECTION_COUNTERCLOCKWISE;
    in = CK10_JOG_DIRECTION_COUNTERCLOCKWISE;
    expect(ck10_reg_jog_direction_encode(in, bytes) == CK10_OK, "jog_direction 0");
    expect(same_bytes(bytes, "\000\000", 2u), "jog_direction 0 bytes");
    expect(ck10_reg_jog_direction_decode(bytes, &out) == CK10_OK, "jog_direction 0");
    expect(out == CK10_JOG_DIRECTION_COUNTERCLOCKWISE, "jog_direction 0");
    in = CK10_JOG_DIRECTION_CLOCKWISE;
    expect(ck10_reg_jog_direction_encode(in, bytes) == CK10_OK, "jog_direction 1");
    expect(same_bytes(bytes, "\000\001", 2u), "jog_direction 1 bytes");
    expect(ck10_reg_jog_direction_decode(bytes, &out) == CK10_OK, "jog_direction 1");
    expect(out == CK10_JOG_DIRECTION_CLOCKWISE, "jog_direction 1");
}

static void test_49(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    static const uint8_t other[] = {0x00, 0x00};
    expect(ck10_reg_start_jog_encode(bytes) == CK10_OK, "start_jog");
    expect(same_bytes(bytes, "\000\001", 2u), "start_jog bytes");
    expect(ck10_reg_start_jog_decode(bytes, &out) == CK10_OK, "start_jog");
    expect(out == 1u, "start_jog");
    expect(ck10_reg_start_jog_decode(other, &out) == CK10_OK, "start_jog 0");
    expect(out == 0u, "start_jog 0");
}

static void test_50(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_push_start_speed_encode(in, bytes) == CK10_OK, "push_start_speed 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "push_start_speed 0 bytes");
    expect(ck10_reg_push_start_speed_decode(bytes, &out) == CK10_OK, "push_start_speed 0");
    expect(out == 0u, "push_start_speed 0");
    in = 4294967295u;
    expect(ck10_reg_push_start_speed_encode(in, bytes) == CK10_OK, "push_start_speed 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "push_start_speed 4294967295 bytes");
    expect(ck10_reg_push_start_speed_decode(bytes, &out) == CK10_OK, "push_start_speed 4294967295");
    expect(out == 4294967295u, "push_start_speed 4294967295");
}

static void test_51(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_push_move_speed_encode(in, bytes) == CK10_OK, "push_move_speed 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "push_move_speed 0 bytes");
    expect(ck10_reg_push_move_speed_decode(bytes, &out) == CK10_OK, "push_move_speed 0");
    expect(out == 0u, "push_move_speed 0");
    in = 4294967295u;
    expect(ck10_reg_push_move_speed_encode(in, bytes) == CK10_OK, "push_move_speed 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "push_move_speed 4294967295 bytes");
    expect(ck10_reg_push_move_speed_decode(bytes, &out) == CK10_OK, "push_move_speed 4294967295");
    expect(out == 4294967295u, "push_move_speed 4294967295");
}

static void test_52(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(ck10_reg_push_acceleration_time_encode(in, bytes) == CK10_OK, "push_acceleration_time 0");
    expect(same_bytes(bytes, "\000\000", 2u), "push_acceleration_time 0 bytes");
    expect(ck10_reg_push_acceleration_time_decode(bytes, &out) == CK10_OK, "push_acceleration_time 0");
    expect(out == 0u, "push_acceleration_time 0");
    in = 65535u;
    expect(ck10_reg_push_acceleration_time_encode(in, bytes) == CK10_OK, "push_acceleration_time 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "push_acceleration_time 65535 bytes");
    expect(ck10_reg_push_acceleration_time_decode(bytes, &out) == CK10_OK, "push_acceleration_time 65535");
    expect(out == 65535u, "push_acceleration_time 65535");
}

static void test_53(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(ck10_reg_push_deceleration_time_encode(in, bytes) == CK10_OK, "push_deceleration_time 0");
    expect(same_bytes(bytes, "\000\000", 2u), "push_deceleration_time 0 bytes");
    expect(ck10_reg_push_deceleration_time_decode(bytes, &out) == CK10_OK, "push_deceleration_time 0");
    expect(out == 0u, "push_deceleration_time 0");
    in = 65535u;
    expect(ck10_reg_push_deceleration_time_encode(in, bytes) == CK10_OK, "push_deceleration_time 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "push_deceleration_time 65535 bytes");
    expect(ck10_reg_push_deceleration_time_decode(bytes, &out) == CK10_OK, "push_deceleration_time 65535");
    expect(out == 65535u, "push_deceleration_time 65535");
}

static void test_54(void)
{
    uint8_t bytes[2];
    ck10_push_mode out = CK10_PUSH_MODE_GO_ON;
    volatile ck10_push_mode in = CK10_PUSH_MODE_STOP;
    in = CK10_PUSH_MODE_STOP;
    expect(ck10_reg_push_mode_encode(in, bytes) == CK10_OK, "push_mode 0");
    expect(same_bytes(bytes, "\000\000", 2u), "push_mode 0 bytes");
    expect(ck10_reg_push_mode_decode(bytes, &out) == CK10_OK, "push_mode 0");
    expect(out == CK10_PUSH_MODE_STOP, "push_mode 0");
    in = CK10_PUSH_MODE_GO_ON;
    expect(ck10_reg_push_mode_encode(in, bytes) == CK10_OK, "push_mode 1");
    expect(same_bytes(bytes, "\000\001", 2u), "push_mode 1 bytes");
    expect(ck10_reg_push_mode_decode(bytes, &out) == CK10_OK, "push_mode 1");
    expect(out == CK10_PUSH_MODE_GO_ON, "push_mode 1");
}

static void test_55(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(ck10_reg_push_torque_ratio_encode(in, bytes) == CK10_OK, "push_torque_ratio 0");
    expect(same_bytes(bytes, "\000\000", 2u), "push_torque_ratio 0 bytes");
    expect(ck10_reg_push_torque_ratio_decode(bytes, &out) == CK10_OK, "push_torque_ratio 0");
    expect(out == 0u, "push_torque_ratio 0");
    in = 65535u;
    expect(ck10_reg_push_torque_ratio_encode(in, bytes) == CK10_OK, "push_torque_ratio 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "push_torque_ratio 65535 bytes");
    expect(ck10_reg_push_torque_ratio_decode(bytes, &out) == CK10_OK, "push_torque_ratio 65535");
    expect(out == 65535u, "push_torque_ratio 65535");
}

static void test_56(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_push_speed_encode(in, bytes) == CK10_OK, "push_speed 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "push_speed 0 bytes");
    expect(ck10_reg_push_speed_decode(bytes, &out) == CK10_OK, "push_speed 0");
    expect(out == 0u, "push_speed 0");
    in = 4294967295u;
    expect(ck10_reg_push_speed_encode(in, bytes) == CK10_OK, "push_speed 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "push_speed 4294967295 bytes");
    expect(ck10_reg_push_speed_decode(bytes, &out) == CK10_OK, "push_speed 4294967295");
    expect(out == 4294967295u, "push_speed 4294967295");
}

static void test_57(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(ck10_reg_push_start_position_encode(in, bytes) == CK10_OK, "push_start_position -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "push_start_position -2147483648 bytes");
    expect(ck10_reg_push_start_position_decode(bytes, &out) == CK10_OK, "push_start_position -2147483648");
    expect(out == (-2147483647 - 1), "push_start_position -2147483648");
    in = 0;
    expect(ck10_reg_push_start_position_encode(in, bytes) == CK10_OK, "push_start_position 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "push_start_position 0 bytes");
    expect(ck10_reg_push_start_position_decode(bytes, &out) == CK10_OK, "push_start_position 0");
    expect(out == 0, "push_start_position 0");
    in = 2147483647;
    expect(ck10_reg_push_start_position_encode(in, bytes) == CK10_OK, "push_start_position 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "push_start_position 2147483647 bytes");
    expect(ck10_reg_push_start_position_decode(bytes, &out) == CK10_OK, "push_start_position 2147483647");
    expect(out == 2147483647, "push_start_position 2147483647");
}

static void test_58(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(ck10_reg_push_end_position_encode(in, bytes) == CK10_OK, "push_end_position -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "push_end_position -2147483648 bytes");
    expect(ck10_reg_push_end_position_decode(bytes, &out) == CK10_OK, "push_end_position -2147483648");
    expect(out == (-2147483647 - 1), "push_end_position -2147483648");
    in = 0;
    expect(ck10_reg_push_end_position_encode(in, bytes) == CK10_OK, "push_end_position 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "push_end_position 0 bytes");
    expect(ck10_reg_push_end_position_decode(bytes, &out) == CK10_OK, "push_end_position 0");
    expect(out == 0, "push_end_position 0");
    in = 2147483647;
    expect(ck10_reg_push_end_position_encode(in, bytes) == CK10_OK, "push_end_position 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "push_end_position 2147483647 bytes");
    expect(ck10_reg_push_end_position_decode(bytes, &out) == CK10_OK, "push_end_position 2147483647");
    expect(out == 2147483647, "push_end_position 2147483647");
}

static void test_59(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    static const uint8_t other[] = {0x00, 0x00};
    expect(ck10_reg_start_push_motion_encode(bytes) == CK10_OK, "start_push_motion");
    expect(same_bytes(bytes, "\000\001", 2u), "start_push_motion bytes");
    expect(ck10_reg_start_push_motion_decode(bytes, &out) == CK10_OK, "start_push_motion");
    expect(out == 1u, "start_push_motion");
    expect(ck10_reg_start_push_motion_decode(other, &out) == CK10_OK, "start_push_motion 0");
    expect(out == 0u, "start_push_motion 0");
}

static void test_60(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    static const uint8_t other[] = {0x00, 0x00};
    expect(ck10_reg_start_homing_encode(bytes) == CK10_OK, "start_homing");
    expect(same_bytes(bytes, "\000\001", 2u), "start_homing bytes");
    expect(ck10_reg_start_homing_decode(bytes, &out) == CK10_OK, "start_homing");
    expect(out == 1u, "start_homing");
    expect(ck10_reg_start_homing_decode(other, &out) == CK10_OK, "start_homing 0");
    expect(out == 0u, "start_homing 0");
}

static void test_61(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile ck10_stop_kind in = CK10_STOP_KIND_IMMEDIATE;
    in = CK10_STOP_KIND_IMMEDIATE;
    expect(ck10_reg_stop_encode(in, bytes) == CK10_OK, "stop 0");
    expect(same_bytes(bytes, "\000\000", 2u), "stop 0 bytes");
    expect(ck10_reg_stop_decode(bytes, &out) == CK10_OK, "stop 0");
    expect(out == 0u, "stop 0");
    in = CK10_STOP_KIND_DECELERATED;
    expect(ck10_reg_stop_encode(in, bytes) == CK10_OK, "stop 1");
    expect(same_bytes(bytes, "\000\001", 2u), "stop 1 bytes");
    expect(ck10_reg_stop_decode(bytes, &out) == CK10_OK, "stop 1");
    expect(out == 1u, "stop 1");
}

static void test_62(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(ck10_reg_servo_encode(in, bytes) == CK10_OK, "servo 0");
    expect(same_bytes(bytes, "\000\000", 2u), "servo 0 bytes");
    expect(ck10_reg_servo_decode(bytes, &out) == CK10_OK, "servo 0");
    expect(out == 0u, "servo 0");
    in = 65535u;
    expect(ck10_reg_servo_encode(in, bytes) == CK10_OK, "servo 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "servo 65535 bytes");
    expect(ck10_reg_servo_decode(bytes, &out) == CK10_OK, "servo 65535");
    expect(out == 65535u, "servo 65535");
}

static void test_63(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    static const uint8_t other[] = {0x00, 0x00};
    expect(ck10_reg_clear_position_encode(bytes) == CK10_OK, "clear_position");
    expect(same_bytes(bytes, "\000\001", 2u), "clear_position bytes");
    expect(ck10_reg_clear_position_decode(bytes, &out) == CK10_OK, "clear_position");
    expect(out == 1u, "clear_position");
    expect(ck10_reg_clear_position_decode(other, &out) == CK10_OK, "clear_position 0");
    expect(out == 0u, "clear_position 0");
}

static void test_64(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    static const uint8_t other[] = {0x00, 0x00};
    expect(ck10_reg_reset_alarm_encode(bytes) == CK10_OK, "reset_alarm");
    expect(same_bytes(bytes, "\000\001", 2u), "reset_alarm bytes");
    expect(ck10_reg_reset_alarm_decode(bytes, &out) == CK10_OK, "reset_alarm");
    expect(out == 1u, "reset_alarm");
    expect(ck10_reg_reset_alarm_decode(other, &out) == CK10_OK, "reset_alarm 0");
    expect(out == 0u, "reset_alarm 0");
}

static void test_65(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    static const uint8_t other[] = {0x00, 0x00};
    expect(ck10_reg_save_point_table_encode(bytes) == CK10_OK, "save_point_table");
    expect(same_bytes(bytes, "\000\001", 2u), "save_point_table bytes");
    expect(ck10_reg_save_point_table_decode(bytes, &out) == CK10_OK, "save_point_table");
    expect(out == 1u, "save_point_table");
    expect(ck10_reg_save_point_table_decode(other, &out) == CK10_OK, "save_point_table 0");
    expect(out == 0u, "save_point_table 0");
}

static void test_66(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(ck10_reg_start_point_encode(in, bytes) == CK10_OK, "start_point 0");
    expect(same_bytes(bytes, "\000\000", 2u), "start_point 0 bytes");
    expect(ck10_reg_start_point_decode(bytes, &out) == CK10_OK, "start_point 0");
    expect(out == 0u, "start_point 0");
    in = 65535u;
    expect(ck10_reg_start_point_encode(in, bytes) == CK10_OK, "start_point 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "start_point 65535 bytes");
    expect(ck10_reg_start_point_decode(bytes, &out) == CK10_OK, "start_point 65535");
    expect(out == 65535u, "start_point 65535");
}

static void test_67(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile ck10_point_table_command in = CK10_POINT_TABLE_COMMAND_START;
    in = CK10_POINT_TABLE_COMMAND_START;
    expect(ck10_reg_run_point_table_encode(in, bytes) == CK10_OK, "run_point_table 1");
    expect(same_bytes(bytes, "\000\001", 2u), "run_point_table 1 bytes");
    expect(ck10_reg_run_point_table_decode(bytes, &out) == CK10_OK, "run_point_table 1");
    expect(out == 1u, "run_point_table 1");
    in = CK10_POINT_TABLE_COMMAND_START_SINGLE;
    expect(ck10_reg_run_point_table_encode(in, bytes) == CK10_OK, "run_point_table 2");
    expect(same_bytes(bytes, "\000\002", 2u), "run_point_table 2 bytes");
    expect(ck10_reg_run_point_table_decode(bytes, &out) == CK10_OK, "run_point_table 2");
    expect(out == 2u, "run_point_table 2");
    in = CK10_POINT_TABLE_COMMAND_NEXT;
    expect(ck10_reg_run_point_table_encode(in, bytes) == CK10_OK, "run_point_table 3");
    expect(same_bytes(bytes, "\000\003", 2u), "run_point_table 3 bytes");
    expect(ck10_reg_run_point_table_decode(bytes, &out) == CK10_OK, "run_point_table 3");
    expect(out == 3u, "run_point_table 3");
}

static void test_68(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    static const uint8_t other[] = {0x00, 0x00};
    expect(ck10_reg_save_all_parameters_encode(bytes) == CK10_OK, "save_all_parameters");
    expect(same_bytes(bytes, "\000\001", 2u), "save_all_parameters bytes");
    expect(ck10_reg_save_all_parameters_decode(bytes, &out) == CK10_OK, "save_all_parameters");
    expect(out == 1u, "save_all_parameters");
    expect(ck10_reg_save_all_parameters_decode(other, &out) == CK10_OK, "save_all_parameters 0");
    expect(out == 0u, "save_all_parameters 0");
}

static void test_69(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(ck10_reg_compare_start_position_encode(in, bytes) == CK10_OK, "compare_start_position -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "compare_start_position -2147483648 bytes");
    expect(ck10_reg_compare_start_position_decode(bytes, &out) == CK10_OK, "compare_start_position -2147483648");
    expect(out == (-2147483647 - 1), "compare_start_position -2147483648");
    in = 0;
    expect(ck10_reg_compare_start_position_encode(in, bytes) == CK10_OK, "compare_start_position 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "compare_start_position 0 bytes");
    expect(ck10_reg_compare_start_position_decode(bytes, &out) == CK10_OK, "compare_start_position 0");
    expect(out == 0, "compare_start_position 0");
    in = 2147483647;
    expect(ck10_reg_compare_start_position_encode(in, bytes) == CK10_OK, "compare_start_position 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "compare_start_position 2147483647 bytes");
    expect(ck10_reg_compare_start_position_decode(bytes, &out) == CK10_OK, "compare_start_position 2147483647");
    expect(out == 2147483647, "compare_start_position 2147483647");
}

static void test_70(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_compare_period_encode(in, bytes) == CK10_OK, "compare_period 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "compare_period 0 bytes");
    expect(ck10_reg_compare_period_decode(bytes, &out) == CK10_OK, "compare_period 0");
    expect(out == 0u, "compare_period 0");
    in = 4294967295u;
    expect(ck10_reg_compare_period_encode(in, bytes) == CK10_OK, "compare_period 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "compare_period 4294967295 bytes");
    expect(ck10_reg_compare_period_decode(bytes, &out) == CK10_OK, "compare_period 4294967295");
    expect(out == 4294967295u, "compare_period 4294967295");
}

static void test_71(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 1u;
    expect(ck10_reg_compare_pulse_width_encode(in, bytes) == CK10_OK, "compare_pulse_width 1");
    expect(same_bytes(bytes, "\000\001", 2u), "compare_pulse_width 1 bytes");
    expect(ck10_reg_compare_pulse_width_decode(bytes, &out) == CK10_OK, "compare_pulse_width 1");
    expect(out == 1u, "compare_pulse_width 1");
    in = 1000u;
    expect(ck10_reg_compare_pulse_width_encode(in, bytes) == CK10_OK, "compare_pulse_width 1000");
    expect(same_bytes(bytes, "\003\350", 2u), "compare_pulse_width 1000 bytes");
    expect(ck10_reg_compare_pulse_width_decode(bytes, &out) == CK10_OK, "compare_pulse_width 1000");
    expect(out == 1000u, "compare_pulse_width 1000");
}

static void test_72(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    static const uint8_t other[] = {0x00, 0x00, 0x00, 0x00};
    expect(ck10_reg_model_id_encode(bytes) == CK10_OK, "model_id");
    expect(same_bytes(bytes, "\000\000\000\150", 4u), "model_id bytes");
    expect(ck10_reg_model_id_decode(bytes, &out) == CK10_OK, "model_id");
    expect(out == 104u, "model_id");
    expect(ck10_reg_model_id_decode(other, &out) == CK10_OK, "model_id 0");
    expect(out == 0u, "model_id 0");
}

static void test_73(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    static const uint8_t other[] = {0x00, 0x00};
    expect(ck10_reg_hardware_type_encode(bytes) == CK10_OK, "hardware_type");
    expect(same_bytes(bytes, "\000\037", 2u), "hardware_type bytes");
    expect(ck10_reg_hardware_type_decode(bytes, &out) == CK10_OK, "hardware_type");
    expect(out == 31u, "hardware_type");
    expect(ck10_reg_hardware_type_decode(other, &out) == CK10_OK, "hardware_type 0");
    expect(out == 0u, "hardware_type 0");
}

static void test_74(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(ck10_reg_firmware_version_encode(in, bytes) == CK10_OK, "firmware_version 0");
    expect(same_bytes(bytes, "\000\000", 2u), "firmware_version 0 bytes");
    expect(ck10_reg_firmware_version_decode(bytes, &out) == CK10_OK, "firmware_version 0");
    expect(out == 0u, "firmware_version 0");
    in = 65535u;
    expect(ck10_reg_firmware_version_encode(in, bytes) == CK10_OK, "firmware_version 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "firmware_version 65535 bytes");
    expect(ck10_reg_firmware_version_decode(bytes, &out) == CK10_OK, "firmware_version 65535");
    expect(out == 65535u, "firmware_version 65535");
}

static void test_75(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_power_cycles_encode(in, bytes) == CK10_OK, "power_cycles 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "power_cycles 0 bytes");
    expect(ck10_reg_power_cycles_decode(bytes, &out) == CK10_OK, "power_cycles 0");
    expect(out == 0u, "power_cycles 0");
    in = 4294967295u;
    expect(ck10_reg_power_cycles_encode(in, bytes) == CK10_OK, "power_cycles 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "power_cycles 4294967295 bytes");
    expect(ck10_reg_power_cycles_decode(bytes, &out) == CK10_OK, "power_cycles 4294967295");
    expect(out == 4294967295u, "power_cycles 4294967295");
}

static void test_76(void)
{
    uint8_t bytes[8];
    uint64_t out = 0;
    volatile uint64_t in = 0;
    in = UINT64_C(0);
    expect(ck10_reg_turns_total_encode(in, bytes) == CK10_OK, "turns_total 0");
    expect(same_bytes(bytes, "\000\000\000\000\000\000\000\000", 8u), "turns_total 0 bytes");
    expect(ck10_reg_turns_total_decode(bytes, &out) == CK10_OK, "turns_total 0");
    expect(out == UINT64_C(0), "turns_total 0");
    in = UINT64_C(18446744073709551615);
    expect(ck10_reg_turns_total_encode(in, bytes) == CK10_OK, "turns_total 18446744073709551615");
    expect(same_bytes(bytes, "\377\377\377\377\377\377\377\377", 8u), "turns_total 18446744073709551615 bytes");
    expect(ck10_reg_turns_total_decode(bytes, &out) == CK10_OK, "turns_total 18446744073709551615");
    expect(out == UINT64_C(18446744073709551615), "turns_total 18446744073709551615");
}

static void test_77(void)
{
    uint8_t bytes[8];
    uint64_t out = 0;
    volatile uint64_t in = 0;
    in = UINT64_C(0);
    expect(ck10_reg_turns_since_power_on_encode(in, bytes) == CK10_OK, "turns_since_power_on 0");
    expect(same_bytes(bytes, "\000\000\000\000\000\000\000\000", 8u), "turns_since_power_on 0 bytes");
    expect(ck10_reg_turns_since_power_on_decode(bytes, &out) == CK10_OK, "turns_since_power_on 0");
    expect(out == UINT64_C(0), "turns_since_power_on 0");
    in = UINT64_C(18446744073709551615);
    expect(ck10_reg_turns_since_power_on_encode(in, bytes) == CK10_OK, "turns_since_power_on 18446744073709551615");
    expect(same_bytes(bytes, "\377\377\377\377\377\377\377\377", 8u), "turns_since_power_on 18446744073709551615 bytes");
    expect(ck10_reg_turns_since_power_on_decode(bytes, &out) == CK10_OK, "turns_since_power_on 18446744073709551615");
    expect(out == UINT64_C(18446744073709551615), "turns_since_power_on 18446744073709551615");
}

static void test_78(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_resolution_encode(in, bytes) == CK10_OK, "resolution 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "resolution 0 bytes");
    expect(ck10_reg_resolution_decode(bytes, &out) == CK10_OK, "resolution 0");
    expect(out == 0u, "resolution 0");
    in = 50000u;
    expect(ck10_reg_resolution_encode(in, bytes) == CK10_OK, "resolution 50000");
    expect(same_bytes(bytes, "\000\000\303\120", 4u), "resolution 50000 bytes");
    expect(ck10_reg_resolution_decode(bytes, &out) == CK10_OK, "resolution 50000");
    expect(out == 50000u, "resolution 50000");
}

static void test_79(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 1u;
    expect(ck10_reg_maximum_speed_encode(in, bytes) == CK10_OK, "maximum_speed 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "maximum_speed 1 bytes");
    expect(ck10_reg_maximum_speed_decode(bytes, &out) == CK10_OK, "maximum_speed 1");
    expect(out == 1u, "maximum_speed 1");
    in = 800000u;
    expect(ck10_reg_maximum_speed_encode(in, bytes) == CK10_OK, "maximum_speed 800000");
    expect(same_bytes(bytes, "\000\014\065\000", 4u), "maximum_speed 800000 bytes");
    expect(ck10_reg_maximum_speed_decode(bytes, &out) == CK10_OK, "maximum_speed 800000");
    expect(out == 800000u, "maximum_speed 800000");
}

static void test_80(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 1u;
    expect(ck10_reg_start_speed_encode(in, bytes) == CK10_OK, "start_speed 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "start_speed 1 bytes");
    expect(ck10_reg_start_speed_decode(bytes, &out) == CK10_OK, "start_speed 1");
    expect(out == 1u, "start_speed 1");
    in = 35000u;
    expect(ck10_reg_start_speed_encode(in, bytes) == CK10_OK, "start_speed 35000");
    expect(same_bytes(bytes, "\000\000\210\270", 4u), "start_speed 35000 bytes");
    expect(ck10_reg_start_speed_decode(bytes, &out) == CK10_OK, "start_speed 35000");
    expect(out == 35000u, "start_speed 35000");
}

static void test_81(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 1u;
    expect(ck10_reg_acceleration_time_encode(in, bytes) == CK10_OK, "acceleration_time 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "acceleration_time 1 bytes");
    expect(ck10_reg_acceleration_time_decode(bytes, &out) == CK10_OK, "acceleration_time 1");
    expect(out == 1u, "acceleration_time 1");
    in = 9999u;
    expect(ck10_reg_acceleration_time_encode(in, bytes) == CK10_OK, "acceleration_time 9999");
    expect(same_bytes(bytes, "\000\000\047\017", 4u), "acceleration_time 9999 bytes");
    expect(ck10_reg_acceleration_time_decode(bytes, &out) == CK10_OK, "acceleration_time 9999");
    expect(out == 9999u, "acceleration_time 9999");
}

static void test_82(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 1u;
    expect(ck10_reg_deceleration_time_encode(in, bytes) == CK10_OK, "deceleration_time 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "deceleration_time 1 bytes");
    expect(ck10_reg_deceleration_time_decode(bytes, &out) == CK10_OK, "deceleration_time 1");
    expect(out == 1u, "deceleration_time 1");
    in = 9999u;
    expect(ck10_reg_deceleration_time_encode(in, bytes) == CK10_OK, "deceleration_time 9999");
    expect(same_bytes(bytes, "\000\000\047\017", 4u), "deceleration_time 9999 bytes");
    expect(ck10_reg_deceleration_time_decode(bytes, &out) == CK10_OK, "deceleration_time 9999");
    expect(out == 9999u, "deceleration_time 9999");
}

static void test_83(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 100u;
    expect(ck10_reg_reserved_5_encode(in, bytes) == CK10_OK, "reserved_5 100");
    expect(same_bytes(bytes, "\000\000\000\144", 4u), "reserved_5 100 bytes");
    expect(ck10_reg_reserved_5_decode(bytes, &out) == CK10_OK, "reserved_5 100");
    expect(out == 100u, "reserved_5 100");
}

static void test_84(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 1u;
    expect(ck10_reg_jog_speed_encode(in, bytes) == CK10_OK, "jog_speed 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "jog_speed 1 bytes");
    expect(ck10_reg_jog_speed_decode(bytes, &out) == CK10_OK, "jog_speed 1");
    expect(out == 1u, "jog_speed 1");
    in = 800000u;
    expect(ck10_reg_jog_speed_encode(in, bytes) == CK10_OK, "jog_speed 800000");
    expect(same_bytes(bytes, "\000\014\065\000", 4u), "jog_speed 800000 bytes");
    expect(ck10_reg_jog_speed_decode(bytes, &out) == CK10_OK, "jog_speed 800000");
    expect(out == 800000u, "jog_speed 800000");
}

static void test_85(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 1u;
    expect(ck10_reg_jog_start_speed_encode(in, bytes) == CK10_OK, "jog_start_speed 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "jog_start_speed 1 bytes");
    expect(ck10_reg_jog_start_speed_decode(bytes, &out) == CK10_OK, "jog_start_speed 1");
    expect(out == 1u, "jog_start_speed 1");
    in = 35000u;
    expect(ck10_reg_jog_start_speed_encode(in, bytes) == CK10_OK, "jog_start_speed 35000");
    expect(same_bytes(bytes, "\000\000\210\270", 4u), "jog_start_speed 35000 bytes");
    expect(ck10_reg_jog_start_speed_decode(bytes, &out) == CK10_OK, "jog_start_speed 35000");
    expect(out == 35000u, "jog_start_speed 35000");
}

static void test_86(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 1u;
    expect(ck10_reg_jog_acceleration_time_encode(in, bytes) == CK10_OK, "jog_acceleration_time 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "jog_acceleration_time 1 bytes");
    expect(ck10_reg_jog_acceleration_time_decode(bytes, &out) == CK10_OK, "jog_acceleration_time 1");
    expect(out == 1u, "jog_acceleration_time 1");
    in = 9999u;
    expect(ck10_reg_jog_acceleration_time_encode(in, bytes) == CK10_OK, "jog_acceleration_time 9999");
    expect(same_bytes(bytes, "\000\000\047\017", 4u), "jog_acceleration_time 9999 bytes");
    expect(ck10_reg_jog_acceleration_time_decode(bytes, &out) == CK10_OK, "jog_acceleration_time 9999");
    expect(out == 9999u, "jog_acceleration_time 9999");
}

static void test_87(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(ck10_reg_positive_soft_limit_encode(in, bytes) == CK10_OK, "positive_soft_limit -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "positive_soft_limit -2147483648 bytes");
    expect(ck10_reg_positive_soft_limit_decode(bytes, &out) == CK10_OK, "positive_soft_limit -2147483648");
    expect(out == (-2147483647 - 1), "positive_soft_limit -2147483648");
    in = 2147483647;
    expect(ck10_reg_positive_soft_limit_encode(in, bytes) == CK10_OK, "positive_soft_limit 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "positive_soft_limit 2147483647 bytes");
    expect(ck10_reg_positive_soft_limit_decode(bytes, &out) == CK10_OK, "positive_soft_limit 2147483647");
    expect(out == 2147483647, "positive_soft_limit 2147483647");
}

static void test_88(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(ck10_reg_negative_soft_limit_encode(in, bytes) == CK10_OK, "negative_soft_limit -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "negative_soft_limit -2147483648 bytes");
    expect(ck10_reg_negative_soft_limit_decode(bytes, &out) == CK10_OK, "negative_soft_limit -2147483648");
    expect(out == (-2147483647 - 1), "negative_soft_limit -2147483648");
    in = 2147483647;
    expect(ck10_reg_negative_soft_limit_encode(in, bytes) == CK10_OK, "negative_soft_limit 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "negative_soft_limit 2147483647 bytes");
    expect(ck10_reg_negative_soft_limit_decode(bytes, &out) == CK10_OK, "negative_soft_limit 2147483647");
    expect(out == 2147483647, "negative_soft_limit 2147483647");
}

static void test_89(void)
{
    uint8_t bytes[4];
    ck10_soft_limit_stop out = CK10_SOFT_LIMIT_STOP_NONE;
    volatile ck10_soft_limit_stop in = CK10_SOFT_LIMIT_STOP_IMMEDIATE;
    in = CK10_SOFT_LIMIT_STOP_IMMEDIATE;
    expect(ck10_reg_soft_limit_stop_encode(in, bytes) == CK10_OK, "soft_limit_stop 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "soft_limit_stop 0 bytes");
    expect(ck10_reg_soft_limit_stop_decode(bytes, &out) == CK10_OK, "soft_limit_stop 0");
    expect(out == CK10_SOFT_LIMIT_STOP_IMMEDIATE, "soft_limit_stop 0");
    in = CK10_SOFT_LIMIT_STOP_DECELERATED;
    expect(ck10_reg_soft_limit_stop_encode(in, bytes) == CK10_OK, "soft_limit_stop 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "soft_limit_stop 1 bytes");
    expect(ck10_reg_soft_limit_stop_decode(bytes, &out) == CK10_OK, "soft_limit_stop 1");
    expect(out == CK10_SOFT_LIMIT_STOP_DECELERATED, "soft_limit_stop 1");
    in = CK10_SOFT_LIMIT_STOP_NONE;
    expect(ck10_reg_soft_limit_stop_encode(in, bytes) == CK10_OK, "soft_limit_stop 2");
    expect(same_bytes(bytes, "\000\000\000\002", 4u), "soft_limit_stop 2 bytes");
    expect(ck10_reg_soft_limit_stop_decode(bytes, &out) == CK10_OK, "soft_limit_stop 2");
    expect(out == CK10_SOFT_LIMIT_STOP_NONE, "soft_limit_stop 2");
}

static void test_90(void)
{
    uint8_t bytes[4];
    ck10_hard_limit_stop out = CK10_HARD_LIMIT_STOP_DECELERATED;
    volatile ck10_hard_limit_stop in = CK10_HARD_LIMIT_STOP_IMMEDIATE;
    in = CK10_HARD_LIMIT_STOP_IMMEDIATE;
    expect(ck10_reg_hard_limit_stop_encode(in, bytes) == CK10_OK, "hard_limit_stop 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "hard_limit_stop 0 bytes");
    expect(ck10_reg_hard_limit_stop_decode(bytes, &out) == CK10_OK, "hard_limit_stop 0");
    expect(out == CK10_HARD_LIMIT_STOP_IMMEDIATE, "hard_limit_stop 0");
    in = CK10_HARD_LIMIT_STOP_DECELERATED;
    expect(ck10_reg_hard_limit_stop_encode(in, bytes) == CK10_OK, "hard_limit_stop 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "hard_limit_stop 1 bytes");
    expect(ck10_reg_hard_limit_stop_decode(bytes, &out) == CK10_OK, "hard_limit_stop 1");
    expect(out == CK10_HARD_LIMIT_STOP_DECELERATED, "hard_limit_stop 1");
}

static void test_91(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_reserved_13_encode(in, bytes) == CK10_OK, "reserved_13 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "reserved_13 0 bytes");
    expect(ck10_reg_reserved_13_decode(bytes, &out) == CK10_OK, "reserved_13 0");
    expect(out == 0u, "reserved_13 0");
    in = 1u;
    expect(ck10_reg_reserved_13_encode(in, bytes) == CK10_OK, "reserved_13 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "reserved_13 1 bytes");
    expect(ck10_reg_reserved_13_decode(bytes, &out) == CK10_OK, "reserved_13 1");
    expect(out == 1u, "reserved_13 1");
}

static void test_92(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 1u;
    expect(ck10_reg_homing_speed_encode(in, bytes) == CK10_OK, "homing_speed 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "homing_speed 1 bytes");
    expect(ck10_reg_homing_speed_decode(bytes, &out) == CK10_OK, "homing_speed 1");
    expect(out == 1u, "homing_speed 1");
    in = 800000u;
    expect(ck10_reg_homing_speed_encode(in, bytes) == CK10_OK, "homing_speed 800000");
    expect(same_bytes(bytes, "\000\014\065\000", 4u), "homing_speed 800000 bytes");
    expect(ck10_reg_homing_speed_decode(bytes, &out) == CK10_OK, "homing_speed 800000");
    expect(out == 800000u, "homing_speed 800000");
}

static void test_93(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 1u;
    expect(ck10_reg_homing_search_speed_encode(in, bytes) == CK10_OK, "homing_search_speed 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "homing_search_speed 1 bytes");
    expect(ck10_reg_homing_search_speed_decode(bytes, &out) == CK10_OK, "homing_search_speed 1");
    expect(out == 1u, "homing_search_speed 1");
    in = 80000u;
    expect(ck10_reg_homing_search_speed_encode(in, bytes) == CK10_OK, "homing_search_speed 80000");
    expect(same_bytes(bytes, "\000\001\070\200", 4u), "homing_search_speed 80000 bytes");
    expect(ck10_reg_homing_search_speed_decode(bytes, &out) == CK10_OK, "homing_search_speed 80000");
    expect(out == 80000u, "homing_search_speed 80000");
}

static void test_94(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 1u;
    expect(ck10_reg_homing_acceleration_time_encode(in, bytes) == CK10_OK, "homing_acceleration_time 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "homing_acceleration_time 1 bytes");
    expect(ck10_reg_homing_acceleration_time_decode(bytes, &out) == CK10_OK, "homing_acceleration_time 1");
    expect(out == 1u, "homing_acceleration_time 1");
    in = 9999u;
    expect(ck10_reg_homing_acceleration_time_encode(in, bytes) == CK10_OK, "homing_acceleration_time 9999");
    expect(same_bytes(bytes, "\000\000\047\017", 4u), "homing_acceleration_time 9999 bytes");
    expect(ck10_reg_homing_acceleration_time_decode(bytes, &out) == CK10_OK, "homing_acceleration_time 9999");
    expect(out == 9999u, "homing_acceleration_time 9999");
}

static void test_95(void)
{
    uint8_t bytes[4];
    ck10_homing_method out = CK10_HOMING_METHOD_HARD_STOP_AND_Z_PHASE;
    volatile ck10_homing_method in = CK10_HOMING_METHOD_ORIGIN_SENSOR;
    in = CK10_HOMING_METHOD_ORIGIN_SENSOR;
    expect(ck10_reg_homing_method_encode(in, bytes) == CK10_OK, "homing_method 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "homing_method 0 bytes");
    expect(ck10_reg_homing_method_decode(bytes, &out) == CK10_OK, "homing_method 0");
    expect(out == CK10_HOMING_METHOD_ORIGIN_SENSOR, "homing_method 0");
    in = CK10_HOMING_METHOD_ORIGIN_SENSOR_AND_Z_PHASE;
    expect(ck10_reg_homing_method_encode(in, bytes) == CK10_OK, "homing_method 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "homing_method 1 bytes");
    expect(ck10_reg_homing_method_decode(bytes, &out) == CK10_OK, "homing_method 1");
    expect(out == CK10_HOMING_METHOD_ORIGIN_SENSOR_AND_Z_PHASE, "homing_method 1");
    in = CK10_HOMING_METHOD_LIMIT_SENSOR;
    expect(ck10_reg_homing_method_encode(in, bytes) == CK10_OK, "homing_method 2");
    expect(same_bytes(bytes, "\000\000\000\002", 4u), "homing_method 2 bytes");
    expect(ck10_reg_homing_method_decode(bytes, &out) == CK10_OK, "homing_method 2");
    expect(out == CK10_HOMING_METHOD_LIMIT_SENSOR, "homing_method 2");
    in = CK10_HOMING_METHOD_LIMIT_SENSOR_AND_Z_PHASE;
    expect(ck10_reg_homing_method_encode(in, bytes) == CK10_OK, "homing_method 3");
    expect(same_bytes(bytes, "\000\000\000\003", 4u), "homing_method 3 bytes");
    expect(ck10_reg_homing_method_decode(bytes, &out) == CK10_OK, "homing_method 3");
    expect(out == CK10_HOMING_METHOD_LIMIT_SENSOR_AND_Z_PHASE, "homing_method 3");
    in = CK10_HOMING_METHOD_CURRENT_POSITION;
    expect(ck10_reg_homing_method_encode(in, bytes) == CK10_OK, "homing_method 4");
    expect(same_bytes(bytes, "\000\000\000\004", 4u), "homing_method 4 bytes");
    expect(ck10_reg_homing_method_decode(bytes, &out) == CK10_OK, "homing_method 4");
    expect(out == CK10_HOMING_METHOD_CURRENT_POSITION, "homing_method 4");
    in = CK10_HOMING_METHOD_Z_PHASE;
    expect(ck10_reg_homing_method_encode(in, bytes) == CK10_OK, "homing_method 5");
    expect(same_bytes(bytes, "\000\000\000\005", 4u), "homing_method 5 bytes");
    expect(ck10_reg_homing_method_decode(bytes, &out) == CK10_OK, "homing_method 5");
    expect(out == CK10_HOMING_METHOD_Z_PHASE, "homing_method 5");
    in = CK10_HOMING_METHOD_HARD_STOP;
    expect(ck10_reg_homing_method_encode(in, bytes) == CK10_OK, "homing_method 6");
    expect(same_bytes(bytes, "\000\000\000\006", 4u), "homing_method 6 bytes");
    expect(ck10_reg_homing_method_decode(bytes, &out) == CK10_OK, "homing_method 6");
    expect(out == CK10_HOMING_METHOD_HARD_STOP, "homing_method 6");
    in = CK10_HOMING_METHOD_HARD_STOP_AND_Z_PHASE;
    expect(ck10_reg_homing_method_encode(in, bytes) == CK10_OK, "homing_method 7");
    expect(same_bytes(bytes, "\000\000\000\007", 4u), "homing_method 7 bytes");
    expect(ck10_reg_homing_method_decode(bytes, &out) == CK10_OK, "homing_method 7");
    expect(out == CK10_HOMING_METHOD_HARD_STOP_AND_Z_PHASE, "homing_method 7");
}

static void test_96(void)
{
    uint8_t bytes[4];
    ck10_rotation out = CK10_ROTATION_COUNTERCLOCKWISE;
    volatile ck10_rotation in = CK10_ROTATION_CLOCKWISE;
    in = CK10_ROTATION_CLOCKWISE;
    expect(ck10_reg_homing_direction_encode(in, bytes) == CK10_OK, "homing_direction 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "homing_direction 0 bytes");
    expect(ck10_reg_homing_direction_decode(bytes, &out) == CK10_OK, "homing_direction 0");
    expect(out == CK10_ROTATION_CLOCKWISE, "homing_direction 0");
    in = CK10_ROTATION_COUNTERCLOCKWISE;
    expect(ck10_reg_homing_direction_encode(in, bytes) == CK10_OK, "homing_direction 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "homing_direction 1 bytes");
    expect(ck10_reg_homing_direction_decode(bytes, &out) == CK10_OK, "homing_direction 1");
    expect(out == CK10_ROTATION_COUNTERCLOCKWISE, "homing_direction 1");
}

static void test_97(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(ck10_reg_homing_offset_encode(in, bytes) == CK10_OK, "homing_offset -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "homing_offset -2147483648 bytes");
    expect(ck10_reg_homing_offset_decode(bytes, &out) == CK10_OK, "homing_offset -2147483648");
    expect(out == (-2147483647 - 1), "homing_offset -2147483648");
    in = 2147483647;
    expect(ck10_reg_homing_offset_encode(in, bytes) == CK10_OK, "homing_offset 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "homing_offset 2147483647 bytes");
    expect(ck10_reg_homing_offset_decode(bytes, &out) == CK10_OK, "homing_offset 2147483647");
    expect(out == 2147483647, "homing_offset 2147483647");
}

static void test_98(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(ck10_reg_origin_position_encode(in, bytes) == CK10_OK, "origin_position -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "origin_position -2147483648 bytes");
    expect(ck10_reg_origin_position_decode(bytes, &out) == CK10_OK, "origin_position -2147483648");
    expect(out == (-2147483647 - 1), "origin_position -2147483648");
    in = 2147483647;
    expect(ck10_reg_origin_position_encode(in, bytes) == CK10_OK, "origin_position 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "origin_position 2147483647 bytes");
    expect(ck10_reg_origin_position_decode(bytes, &out) == CK10_OK, "origin_position 2147483647");
    expect(out == 2147483647, "origin_position 2147483647");
}

static void test_99(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_reserved_21_encode(in, bytes) == CK10_OK, "reserved_21 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "reserved_21 0 bytes");
    expect(ck10_reg_reserved_21_decode(bytes, &out) == CK10_OK, "reserved_21 0");
    expect(out == 0u, "reserved_21 0");
    in = 1u;
    expect(ck10_reg_reserved_21_encode(in, bytes) == CK10_OK, "reserved_21 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "reserved_21 1 bytes");
    expect(ck10_reg_reserved_21_decode(bytes, &out) == CK10_OK, "reserved_21 1");
    expect(out == 1u, "reserved_21 1");
}

static void test_100(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_position_loop_gain_encode(in, bytes) == CK10_OK, "position_loop_gain 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "position_loop_gain 0 bytes");
    expect(ck10_reg_position_loop_gain_decode(bytes, &out) == CK10_OK, "position_loop_gain 0");
    expect(out == 0u, "position_loop_gain 0");
    in = 63u;
    expect(ck10_reg_position_loop_gain_encode(in, bytes) == CK10_OK, "position_loop_gain 63");
    expect(same_bytes(bytes, "\000\000\000\077", 4u), "position_loop_gain 63 bytes");
    expect(ck10_reg_position_loop_gain_decode(bytes, &out) == CK10_OK, "position_loop_gain 63");
    expect(out == 63u, "position_loop_gain 63");
}

static void test_101(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_in_position_range_encode(in, bytes) == CK10_OK, "in_position_range 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "in_position_range 0 bytes");
    expect(ck10_reg_in_position_range_decode(bytes, &out) == CK10_OK, "in_position_range 0");
    expect(out == 0u, "in_position_range 0");
    in = 127u;
    expect(ck10_reg_in_position_range_encode(in, bytes) == CK10_OK, "in_position_range 127");
    expect(same_bytes(bytes, "\000\000\000\177", 4u), "in_position_range 127 bytes");
    expect(ck10_reg_in_position_range_decode(bytes, &out) == CK10_OK, "in_position_range 127");
    expect(out == 127u, "in_position_range 127");
}

static void test_102(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 1u;
    expect(ck10_reg_tracking_limit_encode(in, bytes) == CK10_OK, "tracking_limit 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "tracking_limit 1 bytes");
    expect(ck10_reg_tracking_limit_decode(bytes, &out) == CK10_OK, "tracking_limit 1");
    expect(out == 1u, "tracking_limit 1");
    in = 134217727u;
    expect(ck10_reg_tracking_limit_encode(in, bytes) == CK10_OK, "tracking_limit 134217727");
    expect(same_bytes(bytes, "\007\377\377\377", 4u), "tracking_limit 134217727 bytes");
    expect(ck10_reg_tracking_limit_decode(bytes, &out) == CK10_OK, "tracking_limit 134217727");
    expect(out == 134217727u, "tracking_limit 134217727");
}

static void test_103(void)
{
    uint8_t bytes[4];
    ck10_rotation out = CK10_ROTATION_COUNTERCLOCKWISE;
    volatile ck10_rotation in = CK10_ROTATION_CLOCKWISE;
    in = CK10_ROTATION_CLOCKWISE;
    expect(ck10_reg_motor_direction_encode(in, bytes) == CK10_OK, "motor_direction 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "motor_direction 0 bytes");
    expect(ck10_reg_motor_direction_decode(bytes, &out) == CK10_OK, "motor_direction 0");
    expect(out == CK10_ROTATION_CLOCKWISE, "motor_direction 0");
    in = CK10_ROTATION_COUNTERCLOCKWISE;
    expect(ck10_reg_motor_direction_encode(in, bytes) == CK10_OK, "motor_direction 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "motor_direction 1 bytes");
    expect(ck10_reg_motor_direction_decode(bytes, &out) == CK10_OK, "motor_direction 1");
    expect(out == CK10_ROTATION_COUNTERCLOCKWISE, "motor_direction 1");
}

static void test_104(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_reserved_26_encode(in, bytes) == CK10_OK, "reserved_26 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "reserved_26 0 bytes");
    expect(ck10_reg_reserved_26_decode(bytes, &out) == CK10_OK, "reserved_26 0");
    expect(out == 0u, "reserved_26 0");
    in = 1u;
    expect(ck10_reg_reserved_26_encode(in, bytes) == CK10_OK, "reserved_26 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "reserved_26 1 bytes");
    expect(ck10_reg_reserved_26_decode(bytes, &out) == CK10_OK, "reserved_26 1");
    expect(out == 1u, "reserved_26 1");
}

static void test_105(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 20u;
    expect(ck10_reg_homing_torque_ratio_encode(in, bytes) == CK10_OK, "homing_torque_ratio 20");
    expect(same_bytes(bytes, "\000\000\000\024", 4u), "homing_torque_ratio 20 bytes");
    expect(ck10_reg_homing_torque_ratio_decode(bytes, &out) == CK10_OK, "homing_torque_ratio 20");
    expect(out == 20u, "homing_torque_ratio 20");
    in = 90u;
    expect(ck10_reg_homing_torque_ratio_encode(in, bytes) == CK10_OK, "homing_torque_ratio 90");
    expect(same_bytes(bytes, "\000\000\000\132", 4u), "homing_torque_ratio 90 bytes");
    expect(ck10_reg_homing_torque_ratio_decode(bytes, &out) == CK10_OK, "homing_torque_ratio 90");
    expect(out == 90u, "homing_torque_ratio 90");
}

static void test_106(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 1u;
    expect(ck10_reg_position_overflow_limit_encode(in, bytes) == CK10_OK, "position_overflow_limit 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "position_overflow_limit 1 bytes");
    expect(ck10_reg_position_overflow_limit_decode(bytes, &out) == CK10_OK, "position_overflow_limit 1");
    expect(out == 1u, "position_overflow_limit 1");
    in = 134217727u;
    expect(ck10_reg_position_overflow_limit_encode(in, bytes) == CK10_OK, "position_overflow_limit 134217727");
    expect(same_bytes(bytes, "\007\377\377\377", 4u), "position_overflow_limit 134217727 bytes");
    expect(ck10_reg_position_overflow_limit_decode(bytes, &out) == CK10_OK, "position_overflow_limit 134217727");
    expect(out == 134217727u, "position_overflow_limit 134217727");
}

static void test_107(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 10u;
    expect(ck10_reg_reserved_29_encode(in, bytes) == CK10_OK, "reserved_29 10");
    expect(same_bytes(bytes, "\000\000\000\012", 4u), "reserved_29 10 bytes");
    expect(ck10_reg_reserved_29_decode(bytes, &out) == CK10_OK, "reserved_29 10");
    expect(out == 10u, "reserved_29 10");
    in = 5000u;
    expect(ck10_reg_reserved_29_encode(in, bytes) == CK10_OK, "reserved_29 5000");
    expect(same_bytes(bytes, "\000\000\023\210", 4u), "reserved_29 5000 bytes");
    expect(ck10_reg_reserved_29_decode(bytes, &out) == CK10_OK, "reserved_29 5000");
    expect(out == 5000u, "reserved_29 5000");
}

static void test_108(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 5u;
    expect(ck10_reg_run_current_encode(in, bytes) == CK10_OK, "run_current 5");
    expect(same_bytes(bytes, "\000\000\000\005", 4u), "run_current 5 bytes");
    expect(ck10_reg_run_current_decode(bytes, &out) == CK10_OK, "run_current 5");
    expect(out == 5u, "run_current 5");
    in = 15u;
    expect(ck10_reg_run_current_encode(in, bytes) == CK10_OK, "run_current 15");
    expect(same_bytes(bytes, "\000\000\000\017", 4u), "run_current 15 bytes");
    expect(ck10_reg_run_current_decode(bytes, &out) == CK10_OK, "run_current 15");
    expect(out == 15u, "run_current 15");
}

static void test_109(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_boost_current_encode(in, bytes) == CK10_OK, "boost_current 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "boost_current 0 bytes");
    expect(ck10_reg_boost_current_decode(bytes, &out) == CK10_OK, "boost_current 0");
    expect(out == 0u, "boost_current 0");
    in = 7u;
    expect(ck10_reg_boost_current_encode(in, bytes) == CK10_OK, "boost_current 7");
    expect(same_bytes(bytes, "\000\000\000\007", 4u), "boost_current 7 bytes");
    expect(ck10_reg_boost_current_decode(bytes, &out) == CK10_OK, "boost_current 7");
    expect(out == 7u, "boost_current 7");
}

static void test_110(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 2u;
    expect(ck10_reg_stop_current_encode(in, bytes) == CK10_OK, "stop_current 2");
    expect(same_bytes(bytes, "\000\000\000\002", 4u), "stop_current 2 bytes");
    expect(ck10_reg_stop_current_decode(bytes, &out) == CK10_OK, "stop_current 2");
    expect(out == 2u, "stop_current 2");
    in = 10u;
    expect(ck10_reg_stop_current_encode(in, bytes) == CK10_OK, "stop_current 10");
    expect(same_bytes(bytes, "\000\000\000\012", 4u), "stop_current 10 bytes");
    expect(ck10_reg_stop_current_decode(bytes, &out) == CK10_OK, "stop_current 10");
    expect(out == 10u, "stop_current 10");
}

static void test_111(void)
{
    uint8_t bytes[4];
    ck10_emergency_stop_mode out = CK10_EMERGENCY_STOP_MODE_SERVO_OFF;
    volatile ck10_emergency_stop_mode in = CK10_EMERGENCY_STOP_MODE_FAST_STOP;
    in = CK10_EMERGENCY_STOP_MODE_FAST_STOP;
    expect(ck10_reg_emergency_stop_mode_encode(in, bytes) == CK10_OK, "emergency_stop_mode 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "emergency_stop_mode 0 bytes");
    expect(ck10_reg_emergency_stop_mode_decode(bytes, &out) == CK10_OK, "emergency_stop_mode 0");
    expect(out == CK10_EMERGENCY_STOP_MODE_FAST_STOP, "emergency_stop_mode 0");
    in = CK10_EMERGENCY_STOP_MODE_FAST_STOP_SERVO_OFF;
    expect(ck10_reg_emergency_stop_mode_encode(in, bytes) == CK10_OK, "emergency_stop_mode 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "emergency_stop_mode 1 bytes");
    expect(ck10_reg_emergency_stop_mode_decode(bytes, &out) == CK10_OK, "emergency_stop_mode 1");
    expect(out == CK10_EMERGENCY_STOP_MODE_FAST_STOP_SERVO_OFF, "emergency_stop_mode 1");
    in = CK10_EMERGENCY_STOP_MODE_DECELERATED_STOP;
    expect(ck10_reg_emergency_stop_mode_encode(in, bytes) == CK10_OK, "emergency_stop_mode 2");
    expect(same_bytes(bytes, "\000\000\000\002", 4u), "emergency_stop_mode 2 bytes");
    expect(ck10_reg_emergency_stop_mode_decode(bytes, &out) == CK10_OK, "emergency_stop_mode 2");
    expect(out == CK10_EMERGENCY_STOP_MODE_DECELERATED_STOP, "emergency_stop_mode 2");
    in = CK10_EMERGENCY_STOP_MODE_DECELERATED_STOP_SERVO_OFF;
    expect(ck10_reg_emergency_stop_mode_encode(in, bytes) == CK10_OK, "emergency_stop_mode 3");
    expect(same_bytes(bytes, "\000\000\000\003", 4u), "emergency_stop_mode 3 bytes");
    expect(ck10_reg_emergency_stop_mode_decode(bytes, &out) == CK10_OK, "emergency_stop_mode 3");
    expect(out == CK10_EMERGENCY_STOP_MODE_DECELERATED_STOP_SERVO_OFF, "emergency_stop_mode 3");
    in = CK10_EMERGENCY_STOP_MODE_SERVO_OFF;
    expect(ck10_reg_emergency_stop_mode_encode(in, bytes) == CK10_OK, "emergency_stop_mode 4");
    expect(same_bytes(bytes, "\000\000\000\004", 4u), "emergency_stop_mode 4 bytes");
    expect(ck10_reg_emergency_stop_mode_decode(bytes, &out) == CK10_OK, "emergency_stop_mode 4");
    expect(out == CK10_EMERGENCY_STOP_MODE_SERVO_OFF, "emergency_stop_mode 4");
}

static void test_112(void)
{
    uint8_t bytes[4];
    ck10_emergency_brake_mode out = CK10_EMERGENCY_BRAKE_MODE_RELEASED;
    volatile ck10_emergency_brake_mode in = CK10_EMERGENCY_BRAKE_MODE_LOCKED;
    in = CK10_EMERGENCY_BRAKE_MODE_LOCKED;
    expect(ck10_reg_emergency_brake_mode_encode(in, bytes) == CK10_OK, "emergency_brake_mode 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "emergency_brake_mode 0 bytes");
    expect(ck10_reg_emergency_brake_mode_decode(bytes, &out) == CK10_OK, "emergency_brake_mode 0");
    expect(out == CK10_EMERGENCY_BRAKE_MODE_LOCKED, "emergency_brake_mode 0");
    in = CK10_EMERGENCY_BRAKE_MODE_RELEASED;
    expect(ck10_reg_emergency_brake_mode_encode(in, bytes) == CK10_OK, "emergency_brake_mode 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "emergency_brake_mode 1 bytes");
    expect(ck10_reg_emergency_brake_mode_decode(bytes, &out) == CK10_OK, "emergency_brake_mode 1");
    expect(out == CK10_EMERGENCY_BRAKE_MODE_RELEASED, "emergency_brake_mode 1");
}

static void test_113(void)
{
    uint8_t bytes[4];
    ck10_operation_mode out = CK10_OPERATION_MODE_MODBUS_ASCII;
    volatile ck10_operation_mode in = CK10_OPERATION_MODE_PULSE_AND_DIRECTION;
    in = CK10_OPERATION_MODE_PULSE_AND_DIRECTION;
    expect(ck10_reg_operation_mode_encode(in, bytes) == CK10_OK, "operation_mode 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "operation_mode 0 bytes");
    expect(ck10_reg_operation_mode_decode(bytes, &out) == CK10_OK, "operation_mode 0");
    expect(out == CK10_OPERATION_MODE_PULSE_AND_DIRECTION, "operation_mode 0");
    in = CK10_OPERATION_MODE_TWO_PULSES;
    expect(ck10_reg_operation_mode_encode(in, bytes) == CK10_OK, "operation_mode 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "operation_mode 1 bytes");
    expect(ck10_reg_operation_mode_decode(bytes, &out) == CK10_OK, "operation_mode 1");
    expect(out == CK10_OPERATION_MODE_TWO_PULSES, "operation_mode 1");
    in = CK10_OPERATION_MODE_QUADRATURE;
    expect(ck10_reg_operation_mode_encode(in, bytes) == CK10_OK, "operation_mode 2");
    expect(same_bytes(bytes, "\000\000\000\002", 4u), "operation_mode 2 bytes");
    expect(ck10_reg_operation_mode_decode(bytes, &out) == CK10_OK, "operation_mode 2");
    expect(out == CK10_OPERATION_MODE_QUADRATURE, "operation_mode 2");
    in = CK10_OPERATION_MODE_PLUS_R;
    expect(ck10_reg_operation_mode_encode(in, bytes) == CK10_OK, "operation_mode 3");
    expect(same_bytes(bytes, "\000\000\000\003", 4u), "operation_mode 3 bytes");
    expect(ck10_reg_operation_mode_decode(bytes, &out) == CK10_OK, "operation_mode 3");
    expect(out == CK10_OPERATION_MODE_PLUS_R, "operation_mode 3");
    in = CK10_OPERATION_MODE_MODBUS_RTU;
    expect(ck10_reg_operation_mode_encode(in, bytes) == CK10_OK, "operation_mode 4");
    expect(same_bytes(bytes, "\000\000\000\004", 4u), "operation_mode 4 bytes");
    expect(ck10_reg_operation_mode_decode(bytes, &out) == CK10_OK, "operation_mode 4");
    expect(out == CK10_OPERATION_MODE_MODBUS_RTU, "operation_mode 4");
    in = CK10_OPERATION_MODE_MODBUS_ASCII;
    expect(ck10_reg_operation_mode_encode(in, bytes) == CK10_OK, "operation_mode 5");
    expect(same_bytes(bytes, "\000\000\000\005", 4u), "operation_mode 5 bytes");
    expect(ck10_reg_operation_mode_decode(bytes, &out) == CK10_OK, "operation_mode 5");
    expect(out == CK10_OPERATION_MODE_MODBUS_ASCII, "operation_mode 5");
}

static void test_114(void)
{
    uint8_t bytes[4];
    ck10_switch_function out = CK10_SWITCH_FUNCTION_RESET_ALARM;
    volatile ck10_switch_function in = CK10_SWITCH_FUNCTION_NONE;
    in = CK10_SWITCH_FUNCTION_NONE;
    expect(ck10_reg_switch_function_encode(in, bytes) == CK10_OK, "switch_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "switch_function 0 bytes");
    expect(ck10_reg_switch_function_decode(bytes, &out) == CK10_OK, "switch_function 0");
    expect(out == CK10_SWITCH_FUNCTION_NONE, "switch_function 0");
    in = CK10_SWITCH_FUNCTION_RESET_ALARM;
    expect(ck10_reg_switch_function_encode(in, bytes) == CK10_OK, "switch_function 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "switch_function 1 bytes");
    expect(ck10_reg_switch_function_decode(bytes, &out) == CK10_OK, "switch_function 1");
    expect(out == CK10_SWITCH_FUNCTION_RESET_ALARM, "switch_function 1");
}

static void test_115(void)
{
    uint8_t bytes[4];
    ck10_baud_rate out = CK10_BAUD_RATE_BAUD_115200;
    volatile ck10_baud_rate in = CK10_BAUD_RATE_BAUD_9600;
    in = CK10_BAUD_RATE_BAUD_9600;
    expect(ck10_reg_baud_rate_encode(in, bytes) == CK10_OK, "baud_rate 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "baud_rate 0 bytes");
    expect(ck10_reg_baud_rate_decode(bytes, &out) == CK10_OK, "baud_rate 0");
    expect(out == CK10_BAUD_RATE_BAUD_9600, "baud_rate 0");
    in = CK10_BAUD_RATE_BAUD_19200;
    expect(ck10_reg_baud_rate_encode(in, bytes) == CK10_OK, "baud_rate 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "baud_rate 1 bytes");
    expect(ck10_reg_baud_rate_decode(bytes, &out) == CK10_OK, "baud_rate 1");
    expect(out == CK10_BAUD_RATE_BAUD_19200, "baud_rate 1");
    in = CK10_BAUD_RATE_BAUD_38400;
    expect(ck10_reg_baud_rate_encode(in, bytes) == CK10_OK, "baud_rate 2");
    expect(same_bytes(bytes, "\000\000\000\002", 4u), "baud_rate 2 bytes");
    expect(ck10_reg_baud_rate_decode(bytes, &out) == CK10_OK, "baud_rate 2");
    expect(out == CK10_BAUD_RATE_BAUD_38400, "baud_rate 2");
    in = CK10_BAUD_RATE_BAUD_57600;
    expect(ck10_reg_baud_rate_encode(in, bytes) == CK10_OK, "baud_rate 3");
    expect(same_bytes(bytes, "\000\000\000\003", 4u), "baud_rate 3 bytes");
    expect(ck10_reg_baud_rate_decode(bytes, &out) == CK10_OK, "baud_rate 3");
    expect(out == CK10_BAUD_RATE_BAUD_57600, "baud_rate 3");
    in = CK10_BAUD_RATE_BAUD_115200;
    expect(ck10_reg_baud_rate_encode(in, bytes) == CK10_OK, "baud_rate 4");
    expect(same_bytes(bytes, "\000\000\000\004", 4u), "baud_rate 4 bytes");
    expect(ck10_reg_baud_rate_decode(bytes, &out) == CK10_OK, "baud_rate 4");
    expect(out == CK10_BAUD_RATE_BAUD_115200, "baud_rate 4");
}

static void test_116(void)
{
    uint8_t bytes[4];
    ck10_enabled out = CK10_ENABLED_ENABLED;
    volatile ck10_enabled in = CK10_ENABLED_DISABLED;
    in = CK10_ENABLED_DISABLED;
    expect(ck10_reg_save_position_encode(in, bytes) == CK10_OK, "save_position 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "save_position 0 bytes");
    expect(ck10_reg_save_position_decode(bytes, &out) == CK10_OK, "save_position 0");
    expect(out == CK10_ENABLED_DISABLED, "save_position 0");
    in = CK10_ENABLED_ENABLED;
    expect(ck10_reg_save_position_encode(in, bytes) == CK10_OK, "save_position 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "save_position 1 bytes");
    expect(ck10_reg_save_position_decode(bytes, &out) == CK10_OK, "save_position 1");
    expect(out == CK10_ENABLED_ENABLED, "save_position 1");
}

static void test_117(void)
{
    uint8_t bytes[4];
    ck10_enabled out = CK10_ENABLED_ENABLED;
    volatile ck10_enabled in = CK10_ENABLED_DISABLED;
    in = CK10_ENABLED_DISABLED;
    expect(ck10_reg_show_motor_number_encode(in, bytes) == CK10_OK, "show_motor_number 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "show_motor_number 0 bytes");
    expect(ck10_reg_show_motor_number_decode(bytes, &out) == CK10_OK, "show_motor_number 0");
    expect(out == CK10_ENABLED_DISABLED, "show_motor_number 0");
    in = CK10_ENABLED_ENABLED;
    expect(ck10_reg_show_motor_number_encode(in, bytes) == CK10_OK, "show_motor_number 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "show_motor_number 1 bytes");
    expect(ck10_reg_show_motor_number_decode(bytes, &out) == CK10_OK, "show_motor_number 1");
    expect(out == CK10_ENABLED_ENABLED, "show_motor_number 1");
}

static void test_118(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_assignment_flags_encode(in, bytes) == CK10_OK, "assignment_flags 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "assignment_flags 0 bytes");
    expect(ck10_reg_assignment_flags_decode(bytes, &out) == CK10_OK, "assignment_flags 0");
    expect(out == 0u, "assignment_flags 0");
    in = 4294967295u;
    expect(ck10_reg_assignment_flags_encode(in, bytes) == CK10_OK, "assignment_flags 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "assignment_flags 4294967295 bytes");
    expect(ck10_reg_assignment_flags_decode(bytes, &out) == CK10_OK, "assignment_flags 4294967295");
    expect(out == 4294967295u, "assignment_flags 4294967295");
}

static void test_119(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_input_1_function_encode(in, bytes) == CK10_OK, "input_1_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "input_1_function 0 bytes");
    expect(ck10_reg_input_1_function_decode(bytes, &out) == CK10_OK, "input_1_function 0");
    expect(out == 0u, "input_1_function 0");
    in = 4294967295u;
    expect(ck10_reg_input_1_function_encode(in, bytes) == CK10_OK, "input_1_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "input_1_function 4294967295 bytes");
    expect(ck10_reg_input_1_function_decode(bytes, &out) == CK10_OK, "input_1_function 4294967295");
    expect(out == 4294967295u, "input_1_function 4294967295");
}

static void test_120(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_input_2_function_encode(in, bytes) == CK10_OK, "input_2_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "input_2_function 0 bytes");
    expect(ck10_reg_input_2_function_decode(bytes, &out) == CK10_OK, "input_2_function 0");
    expect(out == 0u, "input_2_function 0");
    in = 4294967295u;
    expect(ck10_reg_input_2_function_encode(in, bytes) == CK10_OK, "input_2_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "input_2_function 4294967295 bytes");
    expect(ck10_reg_input_2_function_decode(bytes, &out) == CK10_OK, "input_2_function 4294967295");
    expect(out == 4294967295u, "input_2_function 4294967295");
}

static void test_121(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_input_3_function_encode(in, bytes) == CK10_OK, "input_3_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "input_3_function 0 bytes");
    expect(ck10_reg_input_3_function_decode(bytes, &out) == CK10_OK, "input_3_function 0");
    expect(out == 0u, "input_3_function 0");
    in = 4294967295u;
    expect(ck10_reg_input_3_function_encode(in, bytes) == CK10_OK, "input_3_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "input_3_function 4294967295 bytes");
    expect(ck10_reg_input_3_function_decode(bytes, &out) == CK10_OK, "input_3_function 4294967295");
    expect(out == 4294967295u, "input_3_function 4294967295");
}

static void test_122(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_input_4_function_encode(in, bytes) == CK10_OK, "input_4_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "input_4_function 0 bytes");
    expect(ck10_reg_input_4_function_decode(bytes, &out) == CK10_OK, "input_4_function 0");
    expect(out == 0u, "input_4_function 0");
    in = 4294967295u;
    expect(ck10_reg_input_4_function_encode(in, bytes) == CK10_OK, "input_4_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "input_4_function 4294967295 bytes");
    expect(ck10_reg_input_4_function_decode(bytes, &out) == CK10_OK, "input_4_function 4294967295");
    expect(out == 4294967295u, "input_4_function 4294967295");
}

static void test_123(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_input_5_function_encode(in, bytes) == CK10_OK, "input_5_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "input_5_function 0 bytes");
    expect(ck10_reg_input_5_function_decode(bytes, &out) == CK10_OK, "input_5_function 0");
    expect(out == 0u, "input_5_function 0");
    in = 4294967295u;
    expect(ck10_reg_input_5_function_encode(in, bytes) == CK10_OK, "input_5_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "input_5_function 4294967295 bytes");
    expect(ck10_reg_input_5_function_decode(bytes, &out) == CK10_OK, "input_5_function 4294967295");
    expect(out == 4294967295u, "input_5_function 4294967295");
}

static void test_124(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_input_6_function_encode(in, bytes) == CK10_OK, "input_6_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "input_6_function 0 bytes");
    expect(ck10_reg_input_6_function_decode(bytes, &out) == CK10_OK, "input_6_function 0");
    expect(out == 0u, "input_6_function 0");
    in = 4294967295u;
    expect(ck10_reg_input_6_function_encode(in, bytes) == CK10_OK, "input_6_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "input_6_function 4294967295 bytes");
    expect(ck10_reg_input_6_function_decode(bytes, &out) == CK10_OK, "input_6_function 4294967295");
    expect(out == 4294967295u, "input_6_function 4294967295");
}

static void test_125(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_input_7_function_encode(in, bytes) == CK10_OK, "input_7_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "input_7_function 0 bytes");
    expect(ck10_reg_input_7_function_decode(bytes, &out) == CK10_OK, "input_7_function 0");
    expect(out == 0u, "input_7_function 0");
    in = 4294967295u;
    expect(ck10_reg_input_7_function_encode(in, bytes) == CK10_OK, "input_7_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "input_7_function 4294967295 bytes");
    expect(ck10_reg_input_7_function_decode(bytes, &out) == CK10_OK, "input_7_function 4294967295");
    expect(out == 4294967295u, "input_7_function 4294967295");
}

static void test_126(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_input_8_function_encode(in, bytes) == CK10_OK, "input_8_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "input_8_function 0 bytes");
    expect(ck10_reg_input_8_function_decode(bytes, &out) == CK10_OK, "input_8_function 0");
    expect(out == 0u, "input_8_function 0");
    in = 4294967295u;
    expect(ck10_reg_input_8_function_encode(in, bytes) == CK10_OK, "input_8_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "input_8_function 4294967295 bytes");
    expect(ck10_reg_input_8_function_decode(bytes, &out) == CK10_OK, "input_8_function 4294967295");
    expect(out == 4294967295u, "input_8_function 4294967295");
}

static void test_127(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_input_9_function_encode(in, bytes) == CK10_OK, "input_9_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "input_9_function 0 bytes");
    expect(ck10_reg_input_9_function_decode(bytes, &out) == CK10_OK, "input_9_function 0");
    expect(out == 0u, "input_9_function 0");
    in = 4294967295u;
    expect(ck10_reg_input_9_function_encode(in, bytes) == CK10_OK, "input_9_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "input_9_function 4294967295 bytes");
    expect(ck10_reg_input_9_function_decode(bytes, &out) == CK10_OK, "input_9_function 4294967295");
    expect(out == 4294967295u, "input_9_function 4294967295");
}

static void test_128(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_input_10_function_encode(in, bytes) == CK10_OK, "input_10_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "input_10_function 0 bytes");
    expect(ck10_reg_input_10_function_decode(bytes, &out) == CK10_OK, "input_10_function 0");
    expect(out == 0u, "input_10_function 0");
    in = 4294967295u;
    expect(ck10_reg_input_10_function_encode(in, bytes) == CK10_OK, "input_10_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "input_10_function 4294967295 bytes");
    expect(ck10_reg_input_10_function_decode(bytes, &out) == CK10_OK, "input_10_function 4294967295");
    expect(out == 4294967295u, "input_10_function 4294967295");
}

static void test_129(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_input_11_function_encode(in, bytes) == CK10_OK, "input_11_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "input_11_function 0 bytes");
    expect(ck10_reg_input_11_function_decode(bytes, &out) == CK10_OK, "input_11_function 0");
    expect(out == 0u, "input_11_function 0");
    in = 4294967295u;
    expect(ck10_reg_input_11_function_encode(in, bytes) == CK10_OK, "input_11_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "input_11_function 4294967295 bytes");
    expect(ck10_reg_input_11_function_decode(bytes, &out) == CK10_OK, "input_11_function 4294967295");
    expect(out == 4294967295u, "input_11_function 4294967295");
}

static void test_130(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_input_12_function_encode(in, bytes) == CK10_OK, "input_12_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "input_12_function 0 bytes");
    expect(ck10_reg_input_12_function_decode(bytes, &out) == CK10_OK, "input_12_function 0");
    expect(out == 0u, "input_12_function 0");
    in = 4294967295u;
    expect(ck10_reg_input_12_function_encode(in, bytes) == CK10_OK, "input_12_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "input_12_function 4294967295 bytes");
    expect(ck10_reg_input_12_function_decode(bytes, &out) == CK10_OK, "input_12_function 4294967295");
    expect(out == 4294967295u, "input_12_function 4294967295");
}

static void test_131(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_output_1_function_encode(in, bytes) == CK10_OK, "output_1_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "output_1_function 0 bytes");
    expect(ck10_reg_output_1_function_decode(bytes, &out) == CK10_OK, "output_1_function 0");
    expect(out == 0u, "output_1_function 0");
    in = 4294967295u;
    expect(ck10_reg_output_1_function_encode(in, bytes) == CK10_OK, "output_1_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "output_1_function 4294967295 bytes");
    expect(ck10_reg_output_1_function_decode(bytes, &out) == CK10_OK, "output_1_function 4294967295");
    expect(out == 4294967295u, "output_1_function 4294967295");
}

static void test_132(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_output_2_function_encode(in, bytes) == CK10_OK, "output_2_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "output_2_function 0 bytes");
    expect(ck10_reg_output_2_function_decode(bytes, &out) == CK10_OK, "output_2_function 0");
    expect(out == 0u, "output_2_function 0");
    in = 4294967295u;
    expect(ck10_reg_output_2_function_encode(in, bytes) == CK10_OK, "output_2_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "output_2_function 4294967295 bytes");
    expect(ck10_reg_output_2_function_decode(bytes, &out) == CK10_OK, "output_2_function 4294967295");
    expect(out == 4294967295u, "output_2_function 4294967295");
}

static void test_133(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_output_3_function_encode(in, bytes) == CK10_OK, "output_3_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "output_3_function 0 bytes");
    expect(ck10_reg_output_3_function_decode(bytes, &out) == CK10_OK, "output_3_function 0");
    expect(out == 0u, "output_3_function 0");
    in = 4294967295u;
    expect(ck10_reg_output_3_function_encode(in, bytes) == CK10_OK, "output_3_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "output_3_function 4294967295 bytes");
    expect(ck10_reg_output_3_function_decode(bytes, &out) == CK10_OK, "output_3_function 4294967295");
    expect(out == 4294967295u, "output_3_function 4294967295");
}

static void test_134(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_output_4_function_encode(in, bytes) == CK10_OK, "output_4_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "output_4_function 0 bytes");
    expect(ck10_reg_output_4_function_decode(bytes, &out) == CK10_OK, "output_4_function 0");
    expect(out == 0u, "output_4_function 0");
    in = 4294967295u;
    expect(ck10_reg_output_4_function_encode(in, bytes) == CK10_OK, "output_4_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "output_4_function 4294967295 bytes");
    expect(ck10_reg_output_4_function_decode(bytes, &out) == CK10_OK, "output_4_function 4294967295");
    expect(out == 4294967295u, "output_4_function 4294967295");
}

static void test_135(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_output_5_function_encode(in, bytes) == CK10_OK, "output_5_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "output_5_function 0 bytes");
    expect(ck10_reg_output_5_function_decode(bytes, &out) == CK10_OK, "output_5_function 0");
    expect(out == 0u, "output_5_function 0");
    in = 4294967295u;
    expect(ck10_reg_output_5_function_encode(in, bytes) == CK10_OK, "output_5_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "output_5_function 4294967295 bytes");
    expect(ck10_reg_output_5_function_decode(bytes, &out) == CK10_OK, "output_5_function 4294967295");
    expect(out == 4294967295u, "output_5_function 4294967295");
}

static void test_136(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_output_6_function_encode(in, bytes) == CK10_OK, "output_6_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "output_6_function 0 bytes");
    expect(ck10_reg_output_6_function_decode(bytes, &out) == CK10_OK, "output_6_function 0");
    expect(out == 0u, "output_6_function 0");
    in = 4294967295u;
    expect(ck10_reg_output_6_function_encode(in, bytes) == CK10_OK, "output_6_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "output_6_function 4294967295 bytes");
    expect(ck10_reg_output_6_function_decode(bytes, &out) == CK10_OK, "output_6_function 4294967295");
    expect(out == 4294967295u, "output_6_function 4294967295");
}

static void test_137(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_output_7_function_encode(in, bytes) == CK10_OK, "output_7_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "output_7_function 0 bytes");
    expect(ck10_reg_output_7_function_decode(bytes, &out) == CK10_OK, "output_7_function 0");
    expect(out == 0u, "output_7_function 0");
    in = 4294967295u;
    expect(ck10_reg_output_7_function_encode(in, bytes) == CK10_OK, "output_7_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "output_7_function 4294967295 bytes");
    expect(ck10_reg_output_7_function_decode(bytes, &out) == CK10_OK, "output_7_function 4294967295");
    expect(out == 4294967295u, "output_7_function 4294967295");
}

static void test_138(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_output_8_function_encode(in, bytes) == CK10_OK, "output_8_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "output_8_function 0 bytes");
    expect(ck10_reg_output_8_function_decode(bytes, &out) == CK10_OK, "output_8_function 0");
    expect(out == 0u, "output_8_function 0");
    in = 4294967295u;
    expect(ck10_reg_output_8_function_encode(in, bytes) == CK10_OK, "output_8_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "output_8_function 4294967295 bytes");
    expect(ck10_reg_output_8_function_decode(bytes, &out) == CK10_OK, "output_8_function 4294967295");
    expect(out == 4294967295u, "output_8_function 4294967295");
}

static void test_139(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_output_9_function_encode(in, bytes) == CK10_OK, "output_9_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "output_9_function 0 bytes");
    expect(ck10_reg_output_9_function_decode(bytes, &out) == CK10_OK, "output_9_function 0");
    expect(out == 0u, "output_9_function 0");
    in = 4294967295u;
    expect(ck10_reg_output_9_function_encode(in, bytes) == CK10_OK, "output_9_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "output_9_function 4294967295 bytes");
    expect(ck10_reg_output_9_function_decode(bytes, &out) == CK10_OK, "output_9_function 4294967295");
    expect(out == 4294967295u, "output_9_function 4294967295");
}

static void test_140(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_output_10_function_encode(in, bytes) == CK10_OK, "output_10_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "output_10_function 0 bytes");
    expect(ck10_reg_output_10_function_decode(bytes, &out) == CK10_OK, "output_10_function 0");
    expect(out == 0u, "output_10_function 0");
    in = 4294967295u;
    expect(ck10_reg_output_10_function_encode(in, bytes) == CK10_OK, "output_10_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "output_10_function 4294967295 bytes");
    expect(ck10_reg_output_10_function_decode(bytes, &out) == CK10_OK, "output_10_function 4294967295");
    expect(out == 4294967295u, "output_10_function 4294967295");
}

static void test_141(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_input_1_polarity_encode(in, bytes) == CK10_OK, "input_1_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "input_1_polarity 0 bytes");
    expect(ck10_reg_input_1_polarity_decode(bytes, &out) == CK10_OK, "input_1_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "input_1_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_input_1_polarity_encode(in, bytes) == CK10_OK, "input_1_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "input_1_polarity 1 bytes");
    expect(ck10_reg_input_1_polarity_decode(bytes, &out) == CK10_OK, "input_1_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "input_1_polarity 1");
}

static void test_142(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_input_2_polarity_encode(in, bytes) == CK10_OK, "input_2_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "input_2_polarity 0 bytes");
    expect(ck10_reg_input_2_polarity_decode(bytes, &out) == CK10_OK, "input_2_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "input_2_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_input_2_polarity_encode(in, bytes) == CK10_OK, "input_2_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "input_2_polarity 1 bytes");
    expect(ck10_reg_input_2_polarity_decode(bytes, &out) == CK10_OK, "input_2_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "input_2_polarity 1");
}

static void test_143(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_input_3_polarity_encode(in, bytes) == CK10_OK, "input_3_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "input_3_polarity 0 bytes");
    expect(ck10_reg_input_3_polarity_decode(bytes, &out) == CK10_OK, "input_3_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "input_3_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_input_3_polarity_encode(in, bytes) == CK10_OK, "input_3_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "input_3_polarity 1 bytes");
    expect(ck10_reg_input_3_polarity_decode(bytes, &out) == CK10_OK, "input_3_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "input_3_polarity 1");
}

static void test_144(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_input_4_polarity_encode(in, bytes) == CK10_OK, "input_4_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "input_4_polarity 0 bytes");
    expect(ck10_reg_input_4_polarity_decode(bytes, &out) == CK10_OK, "input_4_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "input_4_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_input_4_polarity_encode(in, bytes) == CK10_OK, "input_4_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "input_4_polarity 1 bytes");
    expect(ck10_reg_input_4_polarity_decode(bytes, &out) == CK10_OK, "input_4_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "input_4_polarity 1");
}

static void test_145(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_input_5_polarity_encode(in, bytes) == CK10_OK, "input_5_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "input_5_polarity 0 bytes");
    expect(ck10_reg_input_5_polarity_decode(bytes, &out) == CK10_OK, "input_5_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "input_5_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_input_5_polarity_encode(in, bytes) == CK10_OK, "input_5_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "input_5_polarity 1 bytes");
    expect(ck10_reg_input_5_polarity_decode(bytes, &out) == CK10_OK, "input_5_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "input_5_polarity 1");
}

static void test_146(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_input_6_polarity_encode(in, bytes) == CK10_OK, "input_6_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "input_6_polarity 0 bytes");
    expect(ck10_reg_input_6_polarity_decode(bytes, &out) == CK10_OK, "input_6_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "input_6_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_input_6_polarity_encode(in, bytes) == CK10_OK, "input_6_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "input_6_polarity 1 bytes");
    expect(ck10_reg_input_6_polarity_decode(bytes, &out) == CK10_OK, "input_6_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "input_6_polarity 1");
}

static void test_147(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_input_7_polarity_encode(in, bytes) == CK10_OK, "input_7_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "input_7_polarity 0 bytes");
    expect(ck10_reg_input_7_polarity_decode(bytes, &out) == CK10_OK, "input_7_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "input_7_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_input_7_polarity_encode(in, bytes) == CK10_OK, "input_7_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "input_7_polarity 1 bytes");
    expect(ck10_reg_input_7_polarity_decode(bytes, &out) == CK10_OK, "input_7_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "input_7_polarity 1");
}

static void test_148(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_input_8_polarity_encode(in, bytes) == CK10_OK, "input_8_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "input_8_polarity 0 bytes");
    expect(ck10_reg_input_8_polarity_decode(bytes, &out) == CK10_OK, "input_8_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "input_8_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_input_8_polarity_encode(in, bytes) == CK10_OK, "input_8_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "input_8_polarity 1 bytes");
    expect(ck10_reg_input_8_polarity_decode(bytes, &out) == CK10_OK, "input_8_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "input_8_polarity 1");
}

static void test_149(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_input_9_polarity_encode(in, bytes) == CK10_OK, "input_9_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "input_9_polarity 0 bytes");
    expect(ck10_reg_input_9_polarity_decode(bytes, &out) == CK10_OK, "input_9_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "input_9_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_input_9_polarity_encode(in, bytes) == CK10_OK, "input_9_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "input_9_polarity 1 bytes");
    expect(ck10_reg_input_9_polarity_decode(bytes, &out) == CK10_OK, "input_9_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "input_9_polarity 1");
}

static void test_150(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_input_10_polarity_encode(in, bytes) == CK10_OK, "input_10_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "input_10_polarity 0 bytes");
    expect(ck10_reg_input_10_polarity_decode(bytes, &out) == CK10_OK, "input_10_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "input_10_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_input_10_polarity_encode(in, bytes) == CK10_OK, "input_10_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "input_10_polarity 1 bytes");
    expect(ck10_reg_input_10_polarity_decode(bytes, &out) == CK10_OK, "input_10_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "input_10_polarity 1");
}

static void test_151(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_input_11_polarity_encode(in, bytes) == CK10_OK, "input_11_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "input_11_polarity 0 bytes");
    expect(ck10_reg_input_11_polarity_decode(bytes, &out) == CK10_OK, "input_11_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "input_11_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_input_11_polarity_encode(in, bytes) == CK10_OK, "input_11_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "input_11_polarity 1 bytes");
    expect(ck10_reg_input_11_polarity_decode(bytes, &out) == CK10_OK, "input_11_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "input_11_polarity 1");
}

static void test_152(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_input_12_polarity_encode(in, bytes) == CK10_OK, "input_12_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "input_12_polarity 0 bytes");
    expect(ck10_reg_input_12_polarity_decode(bytes, &out) == CK10_OK, "input_12_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "input_12_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_input_12_polarity_encode(in, bytes) == CK10_OK, "input_12_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "input_12_polarity 1 bytes");
    expect(ck10_reg_input_12_polarity_decode(bytes, &out) == CK10_OK, "input_12_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "input_12_polarity 1");
}

static void test_153(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_output_1_polarity_encode(in, bytes) == CK10_OK, "output_1_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "output_1_polarity 0 bytes");
    expect(ck10_reg_output_1_polarity_decode(bytes, &out) == CK10_OK, "output_1_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "output_1_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_output_1_polarity_encode(in, bytes) == CK10_OK, "output_1_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "output_1_polarity 1 bytes");
    expect(ck10_reg_output_1_polarity_decode(bytes, &out) == CK10_OK, "output_1_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "output_1_polarity 1");
}

static void test_154(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_output_2_polarity_encode(in, bytes) == CK10_OK, "output_2_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "output_2_polarity 0 bytes");
    expect(ck10_reg_output_2_polarity_decode(bytes, &out) == CK10_OK, "output_2_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "output_2_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_output_2_polarity_encode(in, bytes) == CK10_OK, "output_2_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "output_2_polarity 1 bytes");
    expect(ck10_reg_output_2_polarity_decode(bytes, &out) == CK10_OK, "output_2_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "output_2_polarity 1");
}

static void test_155(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_output_3_polarity_encode(in, bytes) == CK10_OK, "output_3_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "output_3_polarity 0 bytes");
    expect(ck10_reg_output_3_polarity_decode(bytes, &out) == CK10_OK, "output_3_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "output_3_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_output_3_polarity_encode(in, bytes) == CK10_OK, "output_3_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "output_3_polarity 1 bytes");
    expect(ck10_reg_output_3_polarity_decode(bytes, &out) == CK10_OK, "output_3_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "output_3_polarity 1");
}

static void test_156(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_output_4_polarity_encode(in, bytes) == CK10_OK, "output_4_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "output_4_polarity 0 bytes");
    expect(ck10_reg_output_4_polarity_decode(bytes, &out) == CK10_OK, "output_4_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "output_4_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_output_4_polarity_encode(in, bytes) == CK10_OK, "output_4_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "output_4_polarity 1 bytes");
    expect(ck10_reg_output_4_polarity_decode(bytes, &out) == CK10_OK, "output_4_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "output_4_polarity 1");
}

static void test_157(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_output_5_polarity_encode(in, bytes) == CK10_OK, "output_5_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "output_5_polarity 0 bytes");
    expect(ck10_reg_output_5_polarity_decode(bytes, &out) == CK10_OK, "output_5_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "output_5_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_output_5_polarity_encode(in, bytes) == CK10_OK, "output_5_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "output_5_polarity 1 bytes");
    expect(ck10_reg_output_5_polarity_decode(bytes, &out) == CK10_OK, "output_5_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "output_5_polarity 1");
}

static void test_158(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_output_6_polarity_encode(in, bytes) == CK10_OK, "output_6_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "output_6_polarity 0 bytes");
    expect(ck10_reg_output_6_polarity_decode(bytes, &out) == CK10_OK, "output_6_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "output_6_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_output_6_polarity_encode(in, bytes) == CK10_OK, "output_6_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "output_6_polarity 1 bytes");
    expect(ck10_reg_output_6_polarity_decode(bytes, &out) == CK10_OK, "output_6_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "output_6_polarity 1");
}

static void test_159(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_output_7_polarity_encode(in, bytes) == CK10_OK, "output_7_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "output_7_polarity 0 bytes");
    expect(ck10_reg_output_7_polarity_decode(bytes, &out) == CK10_OK, "output_7_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "output_7_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_output_7_polarity_encode(in, bytes) == CK10_OK, "output_7_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "output_7_polarity 1 bytes");
    expect(ck10_reg_output_7_polarity_decode(bytes, &out) == CK10_OK, "output_7_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "output_7_polarity 1");
}

static void test_160(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_output_8_polarity_encode(in, bytes) == CK10_OK, "output_8_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "output_8_polarity 0 bytes");
    expect(ck10_reg_output_8_polarity_decode(bytes, &out) == CK10_OK, "output_8_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "output_8_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_output_8_polarity_encode(in, bytes) == CK10_OK, "output_8_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "output_8_polarity 1 bytes");
    expect(ck10_reg_output_8_polarity_decode(bytes, &out) == CK10_OK, "output_8_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "output_8_polarity 1");
}

static void test_161(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_output_9_polarity_encode(in, bytes) == CK10_OK, "output_9_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "output_9_polarity 0 bytes");
    expect(ck10_reg_output_9_polarity_decode(bytes, &out) == CK10_OK, "output_9_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "output_9_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_output_9_polarity_encode(in, bytes) == CK10_OK, "output_9_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "output_9_polarity 1 bytes");
    expect(ck10_reg_output_9_polarity_decode(bytes, &out) == CK10_OK, "output_9_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "output_9_polarity 1");
}

static void test_162(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_output_10_polarity_encode(in, bytes) == CK10_OK, "output_10_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "output_10_polarity 0 bytes");
    expect(ck10_reg_output_10_polarity_decode(bytes, &out) == CK10_OK, "output_10_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "output_10_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_output_10_polarity_encode(in, bytes) == CK10_OK, "output_10_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "output_10_polarity 1 bytes");
    expect(ck10_reg_output_10_polarity_decode(bytes, &out) == CK10_OK, "output_10_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "output_10_polarity 1");
}

static void test_163(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_flash_resolution_encode(in, bytes) == CK10_OK, "flash_resolution 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_resolution 0 bytes");
    expect(ck10_reg_flash_resolution_decode(bytes, &out) == CK10_OK, "flash_resolution 0");
    expect(out == 0u, "flash_resolution 0");
    in = 50000u;
    expect(ck10_reg_flash_resolution_encode(in, bytes) == CK10_OK, "flash_resolution 50000");
    expect(same_bytes(bytes, "\000\000\303\120", 4u), "flash_resolution 50000 bytes");
    expect(ck10_reg_flash_resolution_decode(bytes, &out) == CK10_OK, "flash_resolution 50000");
    expect(out == 50000u, "flash_resolution 50000");
}

static void test_164(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 1u;
    expect(ck10_reg_flash_maximum_speed_encode(in, bytes) == CK10_OK, "flash_maximum_speed 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_maximum_speed 1 bytes");
    expect(ck10_reg_flash_maximum_speed_decode(bytes, &out) == CK10_OK, "flash_maximum_speed 1");
    expect(out == 1u, "flash_maximum_speed 1");
    in = 800000u;
    expect(ck10_reg_flash_maximum_speed_encode(in, bytes) == CK10_OK, "flash_maximum_speed 800000");
    expect(same_bytes(bytes, "\000\014\065\000", 4u), "flash_maximum_speed 800000 bytes");
    expect(ck10_reg_flash_maximum_speed_decode(bytes, &out) == CK10_OK, "flash_maximum_speed 800000");
    expect(out == 800000u, "flash_maximum_speed 800000");
}

static void test_165(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 1u;
    expect(ck10_reg_flash_start_speed_encode(in, bytes) == CK10_OK, "flash_start_speed 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_start_speed 1 bytes");
    expect(ck10_reg_flash_start_speed_decode(bytes, &out) == CK10_OK, "flash_start_speed 1");
    expect(out == 1u, "flash_start_speed 1");
    in = 35000u;
    expect(ck10_reg_flash_start_speed_encode(in, bytes) == CK10_OK, "flash_start_speed 35000");
    expect(same_bytes(bytes, "\000\000\210\270", 4u), "flash_start_speed 35000 bytes");
    expect(ck10_reg_flash_start_speed_decode(bytes, &out) == CK10_OK, "flash_start_speed 35000");
    expect(out == 35000u, "flash_start_speed 35000");
}

static void test_166(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 1u;
    expect(ck10_reg_flash_acceleration_time_encode(in, bytes) == CK10_OK, "flash_acceleration_time 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_acceleration_time 1 bytes");
    expect(ck10_reg_flash_acceleration_time_decode(bytes, &out) == CK10_OK, "flash_acceleration_time 1");
    expect(out == 1u, "flash_acceleration_time 1");
    in = 9999u;
    expect(ck10_reg_flash_acceleration_time_encode(in, bytes) == CK10_OK, "flash_acceleration_time 9999");
    expect(same_bytes(bytes, "\000\000\047\017", 4u), "flash_acceleration_time 9999 bytes");
    expect(ck10_reg_flash_acceleration_time_decode(bytes, &out) == CK10_OK, "flash_acceleration_time 9999");
    expect(out == 9999u, "flash_acceleration_time 9999");
}

static void test_167(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 1u;
    expect(ck10_reg_flash_deceleration_time_encode(in, bytes) == CK10_OK, "flash_deceleration_time 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_deceleration_time 1 bytes");
    expect(ck10_reg_flash_deceleration_time_decode(bytes, &out) == CK10_OK, "flash_deceleration_time 1");
    expect(out == 1u, "flash_deceleration_time 1");
    in = 9999u;
    expect(ck10_reg_flash_deceleration_time_encode(in, bytes) == CK10_OK, "flash_deceleration_time 9999");
    expect(same_bytes(bytes, "\000\000\047\017", 4u), "flash_deceleration_time 9999 bytes");
    expect(ck10_reg_flash_deceleration_time_decode(bytes, &out) == CK10_OK, "flash_deceleration_time 9999");
    expect(out == 9999u, "flash_deceleration_time 9999");
}

static void test_168(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 100u;
    expect(ck10_reg_flash_reserved_5_encode(in, bytes) == CK10_OK, "flash_reserved_5 100");
    expect(same_bytes(bytes, "\000\000\000\144", 4u), "flash_reserved_5 100 bytes");
    expect(ck10_reg_flash_reserved_5_decode(bytes, &out) == CK10_OK, "flash_reserved_5 100");
    expect(out == 100u, "flash_reserved_5 100");
}

static void test_169(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 1u;
    expect(ck10_reg_flash_jog_speed_encode(in, bytes) == CK10_OK, "flash_jog_speed 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_jog_speed 1 bytes");
    expect(ck10_reg_flash_jog_speed_decode(bytes, &out) == CK10_OK, "flash_jog_speed 1");
    expect(out == 1u, "flash_jog_speed 1");
    in = 800000u;
    expect(ck10_reg_flash_jog_speed_encode(in, bytes) == CK10_OK, "flash_jog_speed 800000");
    expect(same_bytes(bytes, "\000\014\065\000", 4u), "flash_jog_speed 800000 bytes");
    expect(ck10_reg_flash_jog_speed_decode(bytes, &out) == CK10_OK, "flash_jog_speed 800000");
    expect(out == 800000u, "flash_jog_speed 800000");
}

static void test_170(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 1u;
    expect(ck10_reg_flash_jog_start_speed_encode(in, bytes) == CK10_OK, "flash_jog_start_speed 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_jog_start_speed 1 bytes");
    expect(ck10_reg_flash_jog_start_speed_decode(bytes, &out) == CK10_OK, "flash_jog_start_speed 1");
    expect(out == 1u, "flash_jog_start_speed 1");
    in = 35000u;
    expect(ck10_reg_flash_jog_start_speed_encode(in, bytes) == CK10_OK, "flash_jog_start_speed 35000");
    expect(same_bytes(bytes, "\000\000\210\270", 4u), "flash_jog_start_speed 35000 bytes");
    expect(ck10_reg_flash_jog_start_speed_decode(bytes, &out) == CK10_OK, "flash_jog_start_speed 35000");
    expect(out == 35000u, "flash_jog_start_speed 35000");
}

static void test_171(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 1u;
    expect(ck10_reg_flash_jog_acceleration_time_encode(in, bytes) == CK10_OK, "flash_jog_acceleration_time 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_jog_acceleration_time 1 bytes");
    expect(ck10_reg_flash_jog_acceleration_time_decode(bytes, &out) == CK10_OK, "flash_jog_acceleration_time 1");
    expect(out == 1u, "flash_jog_acceleration_time 1");
    in = 9999u;
    expect(ck10_reg_flash_jog_acceleration_time_encode(in, bytes) == CK10_OK, "flash_jog_acceleration_time 9999");
    expect(same_bytes(bytes, "\000\000\047\017", 4u), "flash_jog_acceleration_time 9999 bytes");
    expect(ck10_reg_flash_jog_acceleration_time_decode(bytes, &out) == CK10_OK, "flash_jog_acceleration_time 9999");
    expect(out == 9999u, "flash_jog_acceleration_time 9999");
}

static void test_172(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(ck10_reg_flash_positive_soft_limit_encode(in, bytes) == CK10_OK, "flash_positive_soft_limit -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "flash_positive_soft_limit -2147483648 bytes");
    expect(ck10_reg_flash_positive_soft_limit_decode(bytes, &out) == CK10_OK, "flash_positive_soft_limit -2147483648");
    expect(out == (-2147483647 - 1), "flash_positive_soft_limit -2147483648");
    in = 2147483647;
    expect(ck10_reg_flash_positive_soft_limit_encode(in, bytes) == CK10_OK, "flash_positive_soft_limit 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "flash_positive_soft_limit 2147483647 bytes");
    expect(ck10_reg_flash_positive_soft_limit_decode(bytes, &out) == CK10_OK, "flash_positive_soft_limit 2147483647");
    expect(out == 2147483647, "flash_positive_soft_limit 2147483647");
}

static void test_173(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(ck10_reg_flash_negative_soft_limit_encode(in, bytes) == CK10_OK, "flash_negative_soft_limit -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "flash_negative_soft_limit -2147483648 bytes");
    expect(ck10_reg_flash_negative_soft_limit_decode(bytes, &out) == CK10_OK, "flash_negative_soft_limit -2147483648");
    expect(out == (-2147483647 - 1), "flash_negative_soft_limit -2147483648");
    in = 2147483647;
    expect(ck10_reg_flash_negative_soft_limit_encode(in, bytes) == CK10_OK, "flash_negative_soft_limit 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "flash_negative_soft_limit 2147483647 bytes");
    expect(ck10_reg_flash_negative_soft_limit_decode(bytes, &out) == CK10_OK, "flash_negative_soft_limit 2147483647");
    expect(out == 2147483647, "flash_negative_soft_limit 2147483647");
}

static void test_174(void)
{
    uint8_t bytes[4];
    ck10_soft_limit_stop out = CK10_SOFT_LIMIT_STOP_NONE;
    volatile ck10_soft_limit_stop in = CK10_SOFT_LIMIT_STOP_IMMEDIATE;
    in = CK10_SOFT_LIMIT_STOP_IMMEDIATE;
    expect(ck10_reg_flash_soft_limit_stop_encode(in, bytes) == CK10_OK, "flash_soft_limit_stop 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_soft_limit_stop 0 bytes");
    expect(ck10_reg_flash_soft_limit_stop_decode(bytes, &out) == CK10_OK, "flash_soft_limit_stop 0");
    expect(out == CK10_SOFT_LIMIT_STOP_IMMEDIATE, "flash_soft_limit_stop 0");
    in = CK10_SOFT_LIMIT_STOP_DECELERATED;
    expect(ck10_reg_flash_soft_limit_stop_encode(in, bytes) == CK10_OK, "flash_soft_limit_stop 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_soft_limit_stop 1 bytes");
    expect(ck10_reg_flash_soft_limit_stop_decode(bytes, &out) == CK10_OK, "flash_soft_limit_stop 1");
    expect(out == CK10_SOFT_LIMIT_STOP_DECELERATED, "flash_soft_limit_stop 1");
    in = CK10_SOFT_LIMIT_STOP_NONE;
    expect(ck10_reg_flash_soft_limit_stop_encode(in, bytes) == CK10_OK, "flash_soft_limit_stop 2");
    expect(same_bytes(bytes, "\000\000\000\002", 4u), "flash_soft_limit_stop 2 bytes");
    expect(ck10_reg_flash_soft_limit_stop_decode(bytes, &out) == CK10_OK, "flash_soft_limit_stop 2");
    expect(out == CK10_SOFT_LIMIT_STOP_NONE, "flash_soft_limit_stop 2");
}

static void test_175(void)
{
    uint8_t bytes[4];
    ck10_hard_limit_stop out = CK10_HARD_LIMIT_STOP_DECELERATED;
    volatile ck10_hard_limit_stop in = CK10_HARD_LIMIT_STOP_IMMEDIATE;
    in = CK10_HARD_LIMIT_STOP_IMMEDIATE;
    expect(ck10_reg_flash_hard_limit_stop_encode(in, bytes) == CK10_OK, "flash_hard_limit_stop 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_hard_limit_stop 0 bytes");
    expect(ck10_reg_flash_hard_limit_stop_decode(bytes, &out) == CK10_OK, "flash_hard_limit_stop 0");
    expect(out == CK10_HARD_LIMIT_STOP_IMMEDIATE, "flash_hard_limit_stop 0");
    in = CK10_HARD_LIMIT_STOP_DECELERATED;
    expect(ck10_reg_flash_hard_limit_stop_encode(in, bytes) == CK10_OK, "flash_hard_limit_stop 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_hard_limit_stop 1 bytes");
    expect(ck10_reg_flash_hard_limit_stop_decode(bytes, &out) == CK10_OK, "flash_hard_limit_stop 1");
    expect(out == CK10_HARD_LIMIT_STOP_DECELERATED, "flash_hard_limit_stop 1");
}

static void test_176(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_flash_reserved_13_encode(in, bytes) == CK10_OK, "flash_reserved_13 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_reserved_13 0 bytes");
    expect(ck10_reg_flash_reserved_13_decode(bytes, &out) == CK10_OK, "flash_reserved_13 0");
    expect(out == 0u, "flash_reserved_13 0");
    in = 1u;
    expect(ck10_reg_flash_reserved_13_encode(in, bytes) == CK10_OK, "flash_reserved_13 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_reserved_13 1 bytes");
    expect(ck10_reg_flash_reserved_13_decode(bytes, &out) == CK10_OK, "flash_reserved_13 1");
    expect(out == 1u, "flash_reserved_13 1");
}

static void test_177(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 1u;
    expect(ck10_reg_flash_homing_speed_encode(in, bytes) == CK10_OK, "flash_homing_speed 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_homing_speed 1 bytes");
    expect(ck10_reg_flash_homing_speed_decode(bytes, &out) == CK10_OK, "flash_homing_speed 1");
    expect(out == 1u, "flash_homing_speed 1");
    in = 800000u;
    expect(ck10_reg_flash_homing_speed_encode(in, bytes) == CK10_OK, "flash_homing_speed 800000");
    expect(same_bytes(bytes, "\000\014\065\000", 4u), "flash_homing_speed 800000 bytes");
    expect(ck10_reg_flash_homing_speed_decode(bytes, &out) == CK10_OK, "flash_homing_speed 800000");
    expect(out == 800000u, "flash_homing_speed 800000");
}

static void test_178(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 1u;
    expect(ck10_reg_flash_homing_search_speed_encode(in, bytes) == CK10_OK, "flash_homing_search_speed 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_homing_search_speed 1 bytes");
    expect(ck10_reg_flash_homing_search_speed_decode(bytes, &out) == CK10_OK, "flash_homing_search_speed 1");
    expect(out == 1u, "flash_homing_search_speed 1");
    in = 80000u;
    expect(ck10_reg_flash_homing_search_speed_encode(in, bytes) == CK10_OK, "flash_homing_search_speed 80000");
    expect(same_bytes(bytes, "\000\001\070\200", 4u), "flash_homing_search_speed 80000 bytes");
    expect(ck10_reg_flash_homing_search_speed_decode(bytes, &out) == CK10_OK, "flash_homing_search_speed 80000");
    expect(out == 80000u, "flash_homing_search_speed 80000");
}

static void test_179(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 1u;
    expect(ck10_reg_flash_homing_acceleration_time_encode(in, bytes) == CK10_OK, "flash_homing_acceleration_time 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_homing_acceleration_time 1 bytes");
    expect(ck10_reg_flash_homing_acceleration_time_decode(bytes, &out) == CK10_OK, "flash_homing_acceleration_time 1");
    expect(out == 1u, "flash_homing_acceleration_time 1");
    in = 9999u;
    expect(ck10_reg_flash_homing_acceleration_time_encode(in, bytes) == CK10_OK, "flash_homing_acceleration_time 9999");
    expect(same_bytes(bytes, "\000\000\047\017", 4u), "flash_homing_acceleration_time 9999 bytes");
    expect(ck10_reg_flash_homing_acceleration_time_decode(bytes, &out) == CK10_OK, "flash_homing_acceleration_time 9999");
    expect(out == 9999u, "flash_homing_acceleration_time 9999");
}

static void test_180(void)
{
    uint8_t bytes[4];
    ck10_homing_method out = CK10_HOMING_METHOD_HARD_STOP_AND_Z_PHASE;
    volatile ck10_homing_method in = CK10_HOMING_METHOD_ORIGIN_SENSOR;
    in = CK10_HOMING_METHOD_ORIGIN_SENSOR;
    expect(ck10_reg_flash_homing_method_encode(in, bytes) == CK10_OK, "flash_homing_method 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_homing_method 0 bytes");
    expect(ck10_reg_flash_homing_method_decode(bytes, &out) == CK10_OK, "flash_homing_method 0");
    expect(out == CK10_HOMING_METHOD_ORIGIN_SENSOR, "flash_homing_method 0");
    in = CK10_HOMING_METHOD_ORIGIN_SENSOR_AND_Z_PHASE;
    expect(ck10_reg_flash_homing_method_encode(in, bytes) == CK10_OK, "flash_homing_method 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_homing_method 1 bytes");
    expect(ck10_reg_flash_homing_method_decode(bytes, &out) == CK10_OK, "flash_homing_method 1");
    expect(out == CK10_HOMING_METHOD_ORIGIN_SENSOR_AND_Z_PHASE, "flash_homing_method 1");
    in = CK10_HOMING_METHOD_LIMIT_SENSOR;
    expect(ck10_reg_flash_homing_method_encode(in, bytes) == CK10_OK, "flash_homing_method 2");
    expect(same_bytes(bytes, "\000\000\000\002", 4u), "flash_homing_method 2 bytes");
    expect(ck10_reg_flash_homing_method_decode(bytes, &out) == CK10_OK, "flash_homing_method 2");
    expect(out == CK10_HOMING_METHOD_LIMIT_SENSOR, "flash_homing_method 2");
    in = CK10_HOMING_METHOD_LIMIT_SENSOR_AND_Z_PHASE;
    expect(ck10_reg_flash_homing_method_encode(in, bytes) == CK10_OK, "flash_homing_method 3");
    expect(same_bytes(bytes, "\000\000\000\003", 4u), "flash_homing_method 3 bytes");
    expect(ck10_reg_flash_homing_method_decode(bytes, &out) == CK10_OK, "flash_homing_method 3");
    expect(out == CK10_HOMING_METHOD_LIMIT_SENSOR_AND_Z_PHASE, "flash_homing_method 3");
    in = CK10_HOMING_METHOD_CURRENT_POSITION;
    expect(ck10_reg_flash_homing_method_encode(in, bytes) == CK10_OK, "flash_homing_method 4");
    expect(same_bytes(bytes, "\000\000\000\004", 4u), "flash_homing_method 4 bytes");
    expect(ck10_reg_flash_homing_method_decode(bytes, &out) == CK10_OK, "flash_homing_method 4");
    expect(out == CK10_HOMING_METHOD_CURRENT_POSITION, "flash_homing_method 4");
    in = CK10_HOMING_METHOD_Z_PHASE;
    expect(ck10_reg_flash_homing_method_encode(in, bytes) == CK10_OK, "flash_homing_method 5");
    expect(same_bytes(bytes, "\000\000\000\005", 4u), "flash_homing_method 5 bytes");
    expect(ck10_reg_flash_homing_method_decode(bytes, &out) == CK10_OK, "flash_homing_method 5");
    expect(out == CK10_HOMING_METHOD_Z_PHASE, "flash_homing_method 5");
    in = CK10_HOMING_METHOD_HARD_STOP;
    expect(ck10_reg_flash_homing_method_encode(in, bytes) == CK10_OK, "flash_homing_method 6");
    expect(same_bytes(bytes, "\000\000\000\006", 4u), "flash_homing_method 6 bytes");
    expect(ck10_reg_flash_homing_method_decode(bytes, &out) == CK10_OK, "flash_homing_method 6");
    expect(out == CK10_HOMING_METHOD_HARD_STOP, "flash_homing_method 6");
    in = CK10_HOMING_METHOD_HARD_STOP_AND_Z_PHASE;
    expect(ck10_reg_flash_homing_method_encode(in, bytes) == CK10_OK, "flash_homing_method 7");
    expect(same_bytes(bytes, "\000\000\000\007", 4u), "flash_homing_method 7 bytes");
    expect(ck10_reg_flash_homing_method_decode(bytes, &out) == CK10_OK, "flash_homing_method 7");
    expect(out == CK10_HOMING_METHOD_HARD_STOP_AND_Z_PHASE, "flash_homing_method 7");
}

static void test_181(void)
{
    uint8_t bytes[4];
    ck10_rotation out = CK10_ROTATION_COUNTERCLOCKWISE;
    volatile ck10_rotation in = CK10_ROTATION_CLOCKWISE;
    in = CK10_ROTATION_CLOCKWISE;
    expect(ck10_reg_flash_homing_direction_encode(in, bytes) == CK10_OK, "flash_homing_direction 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_homing_direction 0 bytes");
    expect(ck10_reg_flash_homing_direction_decode(bytes, &out) == CK10_OK, "flash_homing_direction 0");
    expect(out == CK10_ROTATION_CLOCKWISE, "flash_homing_direction 0");
    in = CK10_ROTATION_COUNTERCLOCKWISE;
    expect(ck10_reg_flash_homing_direction_encode(in, bytes) == CK10_OK, "flash_homing_direction 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_homing_direction 1 bytes");
    expect(ck10_reg_flash_homing_direction_decode(bytes, &out) == CK10_OK, "flash_homing_direction 1");
    expect(out == CK10_ROTATION_COUNTERCLOCKWISE, "flash_homing_direction 1");
}

static void test_182(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(ck10_reg_flash_homing_offset_encode(in, bytes) == CK10_OK, "flash_homing_offset -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "flash_homing_offset -2147483648 bytes");
    expect(ck10_reg_flash_homing_offset_decode(bytes, &out) == CK10_OK, "flash_homing_offset -2147483648");
    expect(out == (-2147483647 - 1), "flash_homing_offset -2147483648");
    in = 2147483647;
    expect(ck10_reg_flash_homing_offset_encode(in, bytes) == CK10_OK, "flash_homing_offset 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "flash_homing_offset 2147483647 bytes");
    expect(ck10_reg_flash_homing_offset_decode(bytes, &out) == CK10_OK, "flash_homing_offset 2147483647");
    expect(out == 2147483647, "flash_homing_offset 2147483647");
}

static void test_183(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(ck10_reg_flash_origin_position_encode(in, bytes) == CK10_OK, "flash_origin_position -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "flash_origin_position -2147483648 bytes");
    expect(ck10_reg_flash_origin_position_decode(bytes, &out) == CK10_OK, "flash_origin_position -2147483648");
    expect(out == (-2147483647 - 1), "flash_origin_position -2147483648");
    in = 2147483647;
    expect(ck10_reg_flash_origin_position_encode(in, bytes) == CK10_OK, "flash_origin_position 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "flash_origin_position 2147483647 bytes");
    expect(ck10_reg_flash_origin_position_decode(bytes, &out) == CK10_OK, "flash_origin_position 2147483647");
    expect(out == 2147483647, "flash_origin_position 2147483647");
}

static void test_184(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_flash_reserved_21_encode(in, bytes) == CK10_OK, "flash_reserved_21 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_reserved_21 0 bytes");
    expect(ck10_reg_flash_reserved_21_decode(bytes, &out) == CK10_OK, "flash_reserved_21 0");
    expect(out == 0u, "flash_reserved_21 0");
    in = 1u;
    expect(ck10_reg_flash_reserved_21_encode(in, bytes) == CK10_OK, "flash_reserved_21 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_reserved_21 1 bytes");
    expect(ck10_reg_flash_reserved_21_decode(bytes, &out) == CK10_OK, "flash_reserved_21 1");
    expect(out == 1u, "flash_reserved_21 1");
}

static void test_185(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_flash_position_loop_gain_encode(in, bytes) == CK10_OK, "flash_position_loop_gain 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_position_loop_gain 0 bytes");
    expect(ck10_reg_flash_position_loop_gain_decode(bytes, &out) == CK10_OK, "flash_position_loop_gain 0");
    expect(out == 0u, "flash_position_loop_gain 0");
    in = 63u;
    expect(ck10_reg_flash_position_loop_gain_encode(in, bytes) == CK10_OK, "flash_position_loop_gain 63");
    expect(same_bytes(bytes, "\000\000\000\077", 4u), "flash_position_loop_gain 63 bytes");
    expect(ck10_reg_flash_position_loop_gain_decode(bytes, &out) == CK10_OK, "flash_position_loop_gain 63");
    expect(out == 63u, "flash_position_loop_gain 63");
}

static void test_186(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_flash_in_position_range_encode(in, bytes) == CK10_OK, "flash_in_position_range 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_in_position_range 0 bytes");
    expect(ck10_reg_flash_in_position_range_decode(bytes, &out) == CK10_OK, "flash_in_position_range 0");
    expect(out == 0u, "flash_in_position_range 0");
    in = 127u;
    expect(ck10_reg_flash_in_position_range_encode(in, bytes) == CK10_OK, "flash_in_position_range 127");
    expect(same_bytes(bytes, "\000\000\000\177", 4u), "flash_in_position_range 127 bytes");
    expect(ck10_reg_flash_in_position_range_decode(bytes, &out) == CK10_OK, "flash_in_position_range 127");
    expect(out == 127u, "flash_in_position_range 127");
}

static void test_187(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 1u;
    expect(ck10_reg_flash_tracking_limit_encode(in, bytes) == CK10_OK, "flash_tracking_limit 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_tracking_limit 1 bytes");
    expect(ck10_reg_flash_tracking_limit_decode(bytes, &out) == CK10_OK, "flash_tracking_limit 1");
    expect(out == 1u, "flash_tracking_limit 1");
    in = 134217727u;
    expect(ck10_reg_flash_tracking_limit_encode(in, bytes) == CK10_OK, "flash_tracking_limit 134217727");
    expect(same_bytes(bytes, "\007\377\377\377", 4u), "flash_tracking_limit 134217727 bytes");
    expect(ck10_reg_flash_tracking_limit_decode(bytes, &out) == CK10_OK, "flash_tracking_limit 134217727");
    expect(out == 134217727u, "flash_tracking_limit 134217727");
}

static void test_188(void)
{
    uint8_t bytes[4];
    ck10_rotation out = CK10_ROTATION_COUNTERCLOCKWISE;
    volatile ck10_rotation in = CK10_ROTATION_CLOCKWISE;
    in = CK10_ROTATION_CLOCKWISE;
    expect(ck10_reg_flash_motor_direction_encode(in, bytes) == CK10_OK, "flash_motor_direction 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_motor_direction 0 bytes");
    expect(ck10_reg_flash_motor_direction_decode(bytes, &out) == CK10_OK, "flash_motor_direction 0");
    expect(out == CK10_ROTATION_CLOCKWISE, "flash_motor_direction 0");
    in = CK10_ROTATION_COUNTERCLOCKWISE;
    expect(ck10_reg_flash_motor_direction_encode(in, bytes) == CK10_OK, "flash_motor_direction 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_motor_direction 1 bytes");
    expect(ck10_reg_flash_motor_direction_decode(bytes, &out) == CK10_OK, "flash_motor_direction 1");
    expect(out == CK10_ROTATION_COUNTERCLOCKWISE, "flash_motor_direction 1");
}

static void test_189(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_flash_reserved_26_encode(in, bytes) == CK10_OK, "flash_reserved_26 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_reserved_26 0 bytes");
    expect(ck10_reg_flash_reserved_26_decode(bytes, &out) == CK10_OK, "flash_reserved_26 0");
    expect(out == 0u, "flash_reserved_26 0");
    in = 1u;
    expect(ck10_reg_flash_reserved_26_encode(in, bytes) == CK10_OK, "flash_reserved_26 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_reserved_26 1 bytes");
    expect(ck10_reg_flash_reserved_26_decode(bytes, &out) == CK10_OK, "flash_reserved_26 1");
    expect(out == 1u, "flash_reserved_26 1");
}

static void test_190(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 20u;
    expect(ck10_reg_flash_homing_torque_ratio_encode(in, bytes) == CK10_OK, "flash_homing_torque_ratio 20");
    expect(same_bytes(bytes, "\000\000\000\024", 4u), "flash_homing_torque_ratio 20 bytes");
    expect(ck10_reg_flash_homing_torque_ratio_decode(bytes, &out) == CK10_OK, "flash_homing_torque_ratio 20");
    expect(out == 20u, "flash_homing_torque_ratio 20");
    in = 90u;
    expect(ck10_reg_flash_homing_torque_ratio_encode(in, bytes) == CK10_OK, "flash_homing_torque_ratio 90");
    expect(same_bytes(bytes, "\000\000\000\132", 4u), "flash_homing_torque_ratio 90 bytes");
    expect(ck10_reg_flash_homing_torque_ratio_decode(bytes, &out) == CK10_OK, "flash_homing_torque_ratio 90");
    expect(out == 90u, "flash_homing_torque_ratio 90");
}

static void test_191(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 1u;
    expect(ck10_reg_flash_position_overflow_limit_encode(in, bytes) == CK10_OK, "flash_position_overflow_limit 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_position_overflow_limit 1 bytes");
    expect(ck10_reg_flash_position_overflow_limit_decode(bytes, &out) == CK10_OK, "flash_position_overflow_limit 1");
    expect(out == 1u, "flash_position_overflow_limit 1");
    in = 134217727u;
    expect(ck10_reg_flash_position_overflow_limit_encode(in, bytes) == CK10_OK, "flash_position_overflow_limit 134217727");
    expect(same_bytes(bytes, "\007\377\377\377", 4u), "flash_position_overflow_limit 134217727 bytes");
    expect(ck10_reg_flash_position_overflow_limit_decode(bytes, &out) == CK10_OK, "flash_position_overflow_limit 134217727");
    expect(out == 134217727u, "flash_position_overflow_limit 134217727");
}

static void test_192(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 10u;
    expect(ck10_reg_flash_reserved_29_encode(in, bytes) == CK10_OK, "flash_reserved_29 10");
    expect(same_bytes(bytes, "\000\000\000\012", 4u), "flash_reserved_29 10 bytes");
    expect(ck10_reg_flash_reserved_29_decode(bytes, &out) == CK10_OK, "flash_reserved_29 10");
    expect(out == 10u, "flash_reserved_29 10");
    in = 5000u;
    expect(ck10_reg_flash_reserved_29_encode(in, bytes) == CK10_OK, "flash_reserved_29 5000");
    expect(same_bytes(bytes, "\000\000\023\210", 4u), "flash_reserved_29 5000 bytes");
    expect(ck10_reg_flash_reserved_29_decode(bytes, &out) == CK10_OK, "flash_reserved_29 5000");
    expect(out == 5000u, "flash_reserved_29 5000");
}

static void test_193(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 5u;
    expect(ck10_reg_flash_run_current_encode(in, bytes) == CK10_OK, "flash_run_current 5");
    expect(same_bytes(bytes, "\000\000\000\005", 4u), "flash_run_current 5 bytes");
    expect(ck10_reg_flash_run_current_decode(bytes, &out) == CK10_OK, "flash_run_current 5");
    expect(out == 5u, "flash_run_current 5");
    in = 15u;
    expect(ck10_reg_flash_run_current_encode(in, bytes) == CK10_OK, "flash_run_current 15");
    expect(same_bytes(bytes, "\000\000\000\017", 4u), "flash_run_current 15 bytes");
    expect(ck10_reg_flash_run_current_decode(bytes, &out) == CK10_OK, "flash_run_current 15");
    expect(out == 15u, "flash_run_current 15");
}

static void test_194(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_flash_boost_current_encode(in, bytes) == CK10_OK, "flash_boost_current 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_boost_current 0 bytes");
    expect(ck10_reg_flash_boost_current_decode(bytes, &out) == CK10_OK, "flash_boost_current 0");
    expect(out == 0u, "flash_boost_current 0");
    in = 7u;
    expect(ck10_reg_flash_boost_current_encode(in, bytes) == CK10_OK, "flash_boost_current 7");
    expect(same_bytes(bytes, "\000\000\000\007", 4u), "flash_boost_current 7 bytes");
    expect(ck10_reg_flash_boost_current_decode(bytes, &out) == CK10_OK, "flash_boost_current 7");
    expect(out == 7u, "flash_boost_current 7");
}

static void test_195(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 2u;
    expect(ck10_reg_flash_stop_current_encode(in, bytes) == CK10_OK, "flash_stop_current 2");
    expect(same_bytes(bytes, "\000\000\000\002", 4u), "flash_stop_current 2 bytes");
    expect(ck10_reg_flash_stop_current_decode(bytes, &out) == CK10_OK, "flash_stop_current 2");
    expect(out == 2u, "flash_stop_current 2");
    in = 10u;
    expect(ck10_reg_flash_stop_current_encode(in, bytes) == CK10_OK, "flash_stop_current 10");
    expect(same_bytes(bytes, "\000\000\000\012", 4u), "flash_stop_current 10 bytes");
    expect(ck10_reg_flash_stop_current_decode(bytes, &out) == CK10_OK, "flash_stop_current 10");
    expect(out == 10u, "flash_stop_current 10");
}

static void test_196(void)
{
    uint8_t bytes[4];
    ck10_emergency_stop_mode out = CK10_EMERGENCY_STOP_MODE_SERVO_OFF;
    volatile ck10_emergency_stop_mode in = CK10_EMERGENCY_STOP_MODE_FAST_STOP;
    in = CK10_EMERGENCY_STOP_MODE_FAST_STOP;
    expect(ck10_reg_flash_emergency_stop_mode_encode(in, bytes) == CK10_OK, "flash_emergency_stop_mode 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_emergency_stop_mode 0 bytes");
    expect(ck10_reg_flash_emergency_stop_mode_decode(bytes, &out) == CK10_OK, "flash_emergency_stop_mode 0");
    expect(out == CK10_EMERGENCY_STOP_MODE_FAST_STOP, "flash_emergency_stop_mode 0");
    in = CK10_EMERGENCY_STOP_MODE_FAST_STOP_SERVO_OFF;
    expect(ck10_reg_flash_emergency_stop_mode_encode(in, bytes) == CK10_OK, "flash_emergency_stop_mode 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_emergency_stop_mode 1 bytes");
    expect(ck10_reg_flash_emergency_stop_mode_decode(bytes, &out) == CK10_OK, "flash_emergency_stop_mode 1");
    expect(out == CK10_EMERGENCY_STOP_MODE_FAST_STOP_SERVO_OFF, "flash_emergency_stop_mode 1");
    in = CK10_EMERGENCY_STOP_MODE_DECELERATED_STOP;
    expect(ck10_reg_flash_emergency_stop_mode_encode(in, bytes) == CK10_OK, "flash_emergency_stop_mode 2");
    expect(same_bytes(bytes, "\000\000\000\002", 4u), "flash_emergency_stop_mode 2 bytes");
    expect(ck10_reg_flash_emergency_stop_mode_decode(bytes, &out) == CK10_OK, "flash_emergency_stop_mode 2");
    expect(out == CK10_EMERGENCY_STOP_MODE_DECELERATED_STOP, "flash_emergency_stop_mode 2");
    in = CK10_EMERGENCY_STOP_MODE_DECELERATED_STOP_SERVO_OFF;
    expect(ck10_reg_flash_emergency_stop_mode_encode(in, bytes) == CK10_OK, "flash_emergency_stop_mode 3");
    expect(same_bytes(bytes, "\000\000\000\003", 4u), "flash_emergency_stop_mode 3 bytes");
    expect(ck10_reg_flash_emergency_stop_mode_decode(bytes, &out) == CK10_OK, "flash_emergency_stop_mode 3");
    expect(out == CK10_EMERGENCY_STOP_MODE_DECELERATED_STOP_SERVO_OFF, "flash_emergency_stop_mode 3");
    in = CK10_EMERGENCY_STOP_MODE_SERVO_OFF;
    expect(ck10_reg_flash_emergency_stop_mode_encode(in, bytes) == CK10_OK, "flash_emergency_stop_mode 4");
    expect(same_bytes(bytes, "\000\000\000\004", 4u), "flash_emergency_stop_mode 4 bytes");
    expect(ck10_reg_flash_emergency_stop_mode_decode(bytes, &out) == CK10_OK, "flash_emergency_stop_mode 4");
    expect(out == CK10_EMERGENCY_STOP_MODE_SERVO_OFF, "flash_emergency_stop_mode 4");
}

static void test_197(void)
{
    uint8_t bytes[4];
    ck10_emergency_brake_mode out = CK10_EMERGENCY_BRAKE_MODE_RELEASED;
    volatile ck10_emergency_brake_mode in = CK10_EMERGENCY_BRAKE_MODE_LOCKED;
    in = CK10_EMERGENCY_BRAKE_MODE_LOCKED;
    expect(ck10_reg_flash_emergency_brake_mode_encode(in, bytes) == CK10_OK, "flash_emergency_brake_mode 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_emergency_brake_mode 0 bytes");
    expect(ck10_reg_flash_emergency_brake_mode_decode(bytes, &out) == CK10_OK, "flash_emergency_brake_mode 0");
    expect(out == CK10_EMERGENCY_BRAKE_MODE_LOCKED, "flash_emergency_brake_mode 0");
    in = CK10_EMERGENCY_BRAKE_MODE_RELEASED;
    expect(ck10_reg_flash_emergency_brake_mode_encode(in, bytes) == CK10_OK, "flash_emergency_brake_mode 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_emergency_brake_mode 1 bytes");
    expect(ck10_reg_flash_emergency_brake_mode_decode(bytes, &out) == CK10_OK, "flash_emergency_brake_mode 1");
    expect(out == CK10_EMERGENCY_BRAKE_MODE_RELEASED, "flash_emergency_brake_mode 1");
}

static void test_198(void)
{
    uint8_t bytes[4];
    ck10_operation_mode out = CK10_OPERATION_MODE_MODBUS_ASCII;
    volatile ck10_operation_mode in = CK10_OPERATION_MODE_PULSE_AND_DIRECTION;
    in = CK10_OPERATION_MODE_PULSE_AND_DIRECTION;
    expect(ck10_reg_flash_operation_mode_encode(in, bytes) == CK10_OK, "flash_operation_mode 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_operation_mode 0 bytes");
    expect(ck10_reg_flash_operation_mode_decode(bytes, &out) == CK10_OK, "flash_operation_mode 0");
    expect(out == CK10_OPERATION_MODE_PULSE_AND_DIRECTION, "flash_operation_mode 0");
    in = CK10_OPERATION_MODE_TWO_PULSES;
    expect(ck10_reg_flash_operation_mode_encode(in, bytes) == CK10_OK, "flash_operation_mode 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_operation_mode 1 bytes");
    expect(ck10_reg_flash_operation_mode_decode(bytes, &out) == CK10_OK, "flash_operation_mode 1");
    expect(out == CK10_OPERATION_MODE_TWO_PULSES, "flash_operation_mode 1");
    in = CK10_OPERATION_MODE_QUADRATURE;
    expect(ck10_reg_flash_operation_mode_encode(in, bytes) == CK10_OK, "flash_operation_mode 2");
    expect(same_bytes(bytes, "\000\000\000\002", 4u), "flash_operation_mode 2 bytes");
    expect(ck10_reg_flash_operation_mode_decode(bytes, &out) == CK10_OK, "flash_operation_mode 2");
    expect(out == CK10_OPERATION_MODE_QUADRATURE, "flash_operation_mode 2");
    in = CK10_OPERATION_MODE_PLUS_R;
    expect(ck10_reg_flash_operation_mode_encode(in, bytes) == CK10_OK, "flash_operation_mode 3");
    expect(same_bytes(bytes, "\000\000\000\003", 4u), "flash_operation_mode 3 bytes");
    expect(ck10_reg_flash_operation_mode_decode(bytes, &out) == CK10_OK, "flash_operation_mode 3");
    expect(out == CK10_OPERATION_MODE_PLUS_R, "flash_operation_mode 3");
    in = CK10_OPERATION_MODE_MODBUS_RTU;
    expect(ck10_reg_flash_operation_mode_encode(in, bytes) == CK10_OK, "flash_operation_mode 4");
    expect(same_bytes(bytes, "\000\000\000\004", 4u), "flash_operation_mode 4 bytes");
    expect(ck10_reg_flash_operation_mode_decode(bytes, &out) == CK10_OK, "flash_operation_mode 4");
    expect(out == CK10_OPERATION_MODE_MODBUS_RTU, "flash_operation_mode 4");
    in = CK10_OPERATION_MODE_MODBUS_ASCII;
    expect(ck10_reg_flash_operation_mode_encode(in, bytes) == CK10_OK, "flash_operation_mode 5");
    expect(same_bytes(bytes, "\000\000\000\005", 4u), "flash_operation_mode 5 bytes");
    expect(ck10_reg_flash_operation_mode_decode(bytes, &out) == CK10_OK, "flash_operation_mode 5");
    expect(out == CK10_OPERATION_MODE_MODBUS_ASCII, "flash_operation_mode 5");
}

static void test_199(void)
{
    uint8_t bytes[4];
    ck10_switch_function out = CK10_SWITCH_FUNCTION_RESET_ALARM;
    volatile ck10_switch_function in = CK10_SWITCH_FUNCTION_NONE;
    in = CK10_SWITCH_FUNCTION_NONE;
    expect(ck10_reg_flash_switch_function_encode(in, bytes) == CK10_OK, "flash_switch_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_switch_function 0 bytes");
    expect(ck10_reg_flash_switch_function_decode(bytes, &out) == CK10_OK, "flash_switch_function 0");
    expect(out == CK10_SWITCH_FUNCTION_NONE, "flash_switch_function 0");
    in = CK10_SWITCH_FUNCTION_RESET_ALARM;
    expect(ck10_reg_flash_switch_function_encode(in, bytes) == CK10_OK, "flash_switch_function 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_switch_function 1 bytes");
    expect(ck10_reg_flash_switch_function_decode(bytes, &out) == CK10_OK, "flash_switch_function 1");
    expect(out == CK10_SWITCH_FUNCTION_RESET_ALARM, "flash_switch_function 1");
}

static void test_200(void)
{
    uint8_t bytes[4];
    ck10_baud_rate out = CK10_BAUD_RATE_BAUD_115200;
    volatile ck10_baud_rate in = CK10_BAUD_RATE_BAUD_9600;
    in = CK10_BAUD_RATE_BAUD_9600;
    expect(ck10_reg_flash_baud_rate_encode(in, bytes) == CK10_OK, "flash_baud_rate 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_baud_rate 0 bytes");
    expect(ck10_reg_flash_baud_rate_decode(bytes, &out) == CK10_OK, "flash_baud_rate 0");
    expect(out == CK10_BAUD_RATE_BAUD_9600, "flash_baud_rate 0");
    in = CK10_BAUD_RATE_BAUD_19200;
    expect(ck10_reg_flash_baud_rate_encode(in, bytes) == CK10_OK, "flash_baud_rate 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_baud_rate 1 bytes");
    expect(ck10_reg_flash_baud_rate_decode(bytes, &out) == CK10_OK, "flash_baud_rate 1");
    expect(out == CK10_BAUD_RATE_BAUD_19200, "flash_baud_rate 1");
    in = CK10_BAUD_RATE_BAUD_38400;
    expect(ck10_reg_flash_baud_rate_encode(in, bytes) == CK10_OK, "flash_baud_rate 2");
    expect(same_bytes(bytes, "\000\000\000\002", 4u), "flash_baud_rate 2 bytes");
    expect(ck10_reg_flash_baud_rate_decode(bytes, &out) == CK10_OK, "flash_baud_rate 2");
    expect(out == CK10_BAUD_RATE_BAUD_38400, "flash_baud_rate 2");
    in = CK10_BAUD_RATE_BAUD_57600;
    expect(ck10_reg_flash_baud_rate_encode(in, bytes) == CK10_OK, "flash_baud_rate 3");
    expect(same_bytes(bytes, "\000\000\000\003", 4u), "flash_baud_rate 3 bytes");
    expect(ck10_reg_flash_baud_rate_decode(bytes, &out) == CK10_OK, "flash_baud_rate 3");
    expect(out == CK10_BAUD_RATE_BAUD_57600, "flash_baud_rate 3");
    in = CK10_BAUD_RATE_BAUD_115200;
    expect(ck10_reg_flash_baud_rate_encode(in, bytes) == CK10_OK, "flash_baud_rate 4");
    expect(same_bytes(bytes, "\000\000\000\004", 4u), "flash_baud_rate 4 bytes");
    expect(ck10_reg_flash_baud_rate_decode(bytes, &out) == CK10_OK, "flash_baud_rate 4");
    expect(out == CK10_BAUD_RATE_BAUD_115200, "flash_baud_rate 4");
}

static void test_201(void)
{
    uint8_t bytes[4];
    ck10_enabled out = CK10_ENABLED_ENABLED;
    volatile ck10_enabled in = CK10_ENABLED_DISABLED;
    in = CK10_ENABLED_DISABLED;
    expect(ck10_reg_flash_save_position_encode(in, bytes) == CK10_OK, "flash_save_position 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_save_position 0 bytes");
    expect(ck10_reg_flash_save_position_decode(bytes, &out) == CK10_OK, "flash_save_position 0");
    expect(out == CK10_ENABLED_DISABLED, "flash_save_position 0");
    in = CK10_ENABLED_ENABLED;
    expect(ck10_reg_flash_save_position_encode(in, bytes) == CK10_OK, "flash_save_position 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_save_position 1 bytes");
    expect(ck10_reg_flash_save_position_decode(bytes, &out) == CK10_OK, "flash_save_position 1");
    expect(out == CK10_ENABLED_ENABLED, "flash_save_position 1");
}

static void test_202(void)
{
    uint8_t bytes[4];
    ck10_enabled out = CK10_ENABLED_ENABLED;
    volatile ck10_enabled in = CK10_ENABLED_DISABLED;
    in = CK10_ENABLED_DISABLED;
    expect(ck10_reg_flash_show_motor_number_encode(in, bytes) == CK10_OK, "flash_show_motor_number 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_show_motor_number 0 bytes");
    expect(ck10_reg_flash_show_motor_number_decode(bytes, &out) == CK10_OK, "flash_show_motor_number 0");
    expect(out == CK10_ENABLED_DISABLED, "flash_show_motor_number 0");
    in = CK10_ENABLED_ENABLED;
    expect(ck10_reg_flash_show_motor_number_encode(in, bytes) == CK10_OK, "flash_show_motor_number 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_show_motor_number 1 bytes");
    expect(ck10_reg_flash_show_motor_number_decode(bytes, &out) == CK10_OK, "flash_show_motor_number 1");
    expect(out == CK10_ENABLED_ENABLED, "flash_show_motor_number 1");
}

static void test_203(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_flash_assignment_flags_encode(in, bytes) == CK10_OK, "flash_assignment_flags 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_assignment_flags 0 bytes");
    expect(ck10_reg_flash_assignment_flags_decode(bytes, &out) == CK10_OK, "flash_assignment_flags 0");
    expect(out == 0u, "flash_assignment_flags 0");
    in = 4294967295u;
    expect(ck10_reg_flash_assignment_flags_encode(in, bytes) == CK10_OK, "flash_assignment_flags 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "flash_assignment_flags 4294967295 bytes");
    expect(ck10_reg_flash_assignment_flags_decode(bytes, &out) == CK10_OK, "flash_assignment_flags 4294967295");
    expect(out == 4294967295u, "flash_assignment_flags 4294967295");
}

static void test_204(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_flash_input_1_function_encode(in, bytes) == CK10_OK, "flash_input_1_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_input_1_function 0 bytes");
    expect(ck10_reg_flash_input_1_function_decode(bytes, &out) == CK10_OK, "flash_input_1_function 0");
    expect(out == 0u, "flash_input_1_function 0");
    in = 4294967295u;
    expect(ck10_reg_flash_input_1_function_encode(in, bytes) == CK10_OK, "flash_input_1_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "flash_input_1_function 4294967295 bytes");
    expect(ck10_reg_flash_input_1_function_decode(bytes, &out) == CK10_OK, "flash_input_1_function 4294967295");
    expect(out == 4294967295u, "flash_input_1_function 4294967295");
}

static void test_205(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_flash_input_2_function_encode(in, bytes) == CK10_OK, "flash_input_2_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_input_2_function 0 bytes");
    expect(ck10_reg_flash_input_2_function_decode(bytes, &out) == CK10_OK, "flash_input_2_function 0");
    expect(out == 0u, "flash_input_2_function 0");
    in = 4294967295u;
    expect(ck10_reg_flash_input_2_function_encode(in, bytes) == CK10_OK, "flash_input_2_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "flash_input_2_function 4294967295 bytes");
    expect(ck10_reg_flash_input_2_function_decode(bytes, &out) == CK10_OK, "flash_input_2_function 4294967295");
    expect(out == 4294967295u, "flash_input_2_function 4294967295");
}

static void test_206(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_flash_input_3_function_encode(in, bytes) == CK10_OK, "flash_input_3_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_input_3_function 0 bytes");
    expect(ck10_reg_flash_input_3_function_decode(bytes, &out) == CK10_OK, "flash_input_3_function 0");
    expect(out == 0u, "flash_input_3_function 0");
    in = 4294967295u;
    expect(ck10_reg_flash_input_3_function_encode(in, bytes) == CK10_OK, "flash_input_3_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "flash_input_3_function 4294967295 bytes");
    expect(ck10_reg_flash_input_3_function_decode(bytes, &out) == CK10_OK, "flash_input_3_function 4294967295");
    expect(out == 4294967295u, "flash_input_3_function 4294967295");
}

static void test_207(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_flash_input_4_function_encode(in, bytes) == CK10_OK, "flash_input_4_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_input_4_function 0 bytes");
    expect(ck10_reg_flash_input_4_function_decode(bytes, &out) == CK10_OK, "flash_input_4_function 0");
    expect(out == 0u, "flash_input_4_function 0");
    in = 4294967295u;
    expect(ck10_reg_flash_input_4_function_encode(in, bytes) == CK10_OK, "flash_input_4_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "flash_input_4_function 4294967295 bytes");
    expect(ck10_reg_flash_input_4_function_decode(bytes, &out) == CK10_OK, "flash_input_4_function 4294967295");
    expect(out == 4294967295u, "flash_input_4_function 4294967295");
}

static void test_208(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_flash_input_5_function_encode(in, bytes) == CK10_OK, "flash_input_5_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_input_5_function 0 bytes");
    expect(ck10_reg_flash_input_5_function_decode(bytes, &out) == CK10_OK, "flash_input_5_function 0");
    expect(out == 0u, "flash_input_5_function 0");
    in = 4294967295u;
    expect(ck10_reg_flash_input_5_function_encode(in, bytes) == CK10_OK, "flash_input_5_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "flash_input_5_function 4294967295 bytes");
    expect(ck10_reg_flash_input_5_function_decode(bytes, &out) == CK10_OK, "flash_input_5_function 4294967295");
    expect(out == 4294967295u, "flash_input_5_function 4294967295");
}

static void test_209(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_flash_input_6_function_encode(in, bytes) == CK10_OK, "flash_input_6_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_input_6_function 0 bytes");
    expect(ck10_reg_flash_input_6_function_decode(bytes, &out) == CK10_OK, "flash_input_6_function 0");
    expect(out == 0u, "flash_input_6_function 0");
    in = 4294967295u;
    expect(ck10_reg_flash_input_6_function_encode(in, bytes) == CK10_OK, "flash_input_6_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "flash_input_6_function 4294967295 bytes");
    expect(ck10_reg_flash_input_6_function_decode(bytes, &out) == CK10_OK, "flash_input_6_function 4294967295");
    expect(out == 4294967295u, "flash_input_6_function 4294967295");
}

static void test_210(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_flash_input_7_function_encode(in, bytes) == CK10_OK, "flash_input_7_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_input_7_function 0 bytes");
    expect(ck10_reg_flash_input_7_function_decode(bytes, &out) == CK10_OK, "flash_input_7_function 0");
    expect(out == 0u, "flash_input_7_function 0");
    in = 4294967295u;
    expect(ck10_reg_flash_input_7_function_encode(in, bytes) == CK10_OK, "flash_input_7_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "flash_input_7_function 4294967295 bytes");
    expect(ck10_reg_flash_input_7_function_decode(bytes, &out) == CK10_OK, "flash_input_7_function 4294967295");
    expect(out == 4294967295u, "flash_input_7_function 4294967295");
}

static void test_211(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_flash_input_8_function_encode(in, bytes) == CK10_OK, "flash_input_8_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_input_8_function 0 bytes");
    expect(ck10_reg_flash_input_8_function_decode(bytes, &out) == CK10_OK, "flash_input_8_function 0");
    expect(out == 0u, "flash_input_8_function 0");
    in = 4294967295u;
    expect(ck10_reg_flash_input_8_function_encode(in, bytes) == CK10_OK, "flash_input_8_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "flash_input_8_function 4294967295 bytes");
    expect(ck10_reg_flash_input_8_function_decode(bytes, &out) == CK10_OK, "flash_input_8_function 4294967295");
    expect(out == 4294967295u, "flash_input_8_function 4294967295");
}

static void test_212(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_flash_input_9_function_encode(in, bytes) == CK10_OK, "flash_input_9_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_input_9_function 0 bytes");
    expect(ck10_reg_flash_input_9_function_decode(bytes, &out) == CK10_OK, "flash_input_9_function 0");
    expect(out == 0u, "flash_input_9_function 0");
    in = 4294967295u;
    expect(ck10_reg_flash_input_9_function_encode(in, bytes) == CK10_OK, "flash_input_9_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "flash_input_9_function 4294967295 bytes");
    expect(ck10_reg_flash_input_9_function_decode(bytes, &out) == CK10_OK, "flash_input_9_function 4294967295");
    expect(out == 4294967295u, "flash_input_9_function 4294967295");
}

static void test_213(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_flash_input_10_function_encode(in, bytes) == CK10_OK, "flash_input_10_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_input_10_function 0 bytes");
    expect(ck10_reg_flash_input_10_function_decode(bytes, &out) == CK10_OK, "flash_input_10_function 0");
    expect(out == 0u, "flash_input_10_function 0");
    in = 4294967295u;
    expect(ck10_reg_flash_input_10_function_encode(in, bytes) == CK10_OK, "flash_input_10_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "flash_input_10_function 4294967295 bytes");
    expect(ck10_reg_flash_input_10_function_decode(bytes, &out) == CK10_OK, "flash_input_10_function 4294967295");
    expect(out == 4294967295u, "flash_input_10_function 4294967295");
}

static void test_214(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_flash_input_11_function_encode(in, bytes) == CK10_OK, "flash_input_11_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_input_11_function 0 bytes");
    expect(ck10_reg_flash_input_11_function_decode(bytes, &out) == CK10_OK, "flash_input_11_function 0");
    expect(out == 0u, "flash_input_11_function 0");
    in = 4294967295u;
    expect(ck10_reg_flash_input_11_function_encode(in, bytes) == CK10_OK, "flash_input_11_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "flash_input_11_function 4294967295 bytes");
    expect(ck10_reg_flash_input_11_function_decode(bytes, &out) == CK10_OK, "flash_input_11_function 4294967295");
    expect(out == 4294967295u, "flash_input_11_function 4294967295");
}

static void test_215(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_flash_input_12_function_encode(in, bytes) == CK10_OK, "flash_input_12_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_input_12_function 0 bytes");
    expect(ck10_reg_flash_input_12_function_decode(bytes, &out) == CK10_OK, "flash_input_12_function 0");
    expect(out == 0u, "flash_input_12_function 0");
    in = 4294967295u;
    expect(ck10_reg_flash_input_12_function_encode(in, bytes) == CK10_OK, "flash_input_12_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "flash_input_12_function 4294967295 bytes");
    expect(ck10_reg_flash_input_12_function_decode(bytes, &out) == CK10_OK, "flash_input_12_function 4294967295");
    expect(out == 4294967295u, "flash_input_12_function 4294967295");
}

static void test_216(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_flash_output_1_function_encode(in, bytes) == CK10_OK, "flash_output_1_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_output_1_function 0 bytes");
    expect(ck10_reg_flash_output_1_function_decode(bytes, &out) == CK10_OK, "flash_output_1_function 0");
    expect(out == 0u, "flash_output_1_function 0");
    in = 4294967295u;
    expect(ck10_reg_flash_output_1_function_encode(in, bytes) == CK10_OK, "flash_output_1_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "flash_output_1_function 4294967295 bytes");
    expect(ck10_reg_flash_output_1_function_decode(bytes, &out) == CK10_OK, "flash_output_1_function 4294967295");
    expect(out == 4294967295u, "flash_output_1_function 4294967295");
}

static void test_217(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_flash_output_2_function_encode(in, bytes) == CK10_OK, "flash_output_2_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_output_2_function 0 bytes");
    expect(ck10_reg_flash_output_2_function_decode(bytes, &out) == CK10_OK, "flash_output_2_function 0");
    expect(out == 0u, "flash_output_2_function 0");
    in = 4294967295u;
    expect(ck10_reg_flash_output_2_function_encode(in, bytes) == CK10_OK, "flash_output_2_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "flash_output_2_function 4294967295 bytes");
    expect(ck10_reg_flash_output_2_function_decode(bytes, &out) == CK10_OK, "flash_output_2_function 4294967295");
    expect(out == 4294967295u, "flash_output_2_function 4294967295");
}

static void test_218(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_flash_output_3_function_encode(in, bytes) == CK10_OK, "flash_output_3_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_output_3_function 0 bytes");
    expect(ck10_reg_flash_output_3_function_decode(bytes, &out) == CK10_OK, "flash_output_3_function 0");
    expect(out == 0u, "flash_output_3_function 0");
    in = 4294967295u;
    expect(ck10_reg_flash_output_3_function_encode(in, bytes) == CK10_OK, "flash_output_3_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "flash_output_3_function 4294967295 bytes");
    expect(ck10_reg_flash_output_3_function_decode(bytes, &out) == CK10_OK, "flash_output_3_function 4294967295");
    expect(out == 4294967295u, "flash_output_3_function 4294967295");
}

static void test_219(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_flash_output_4_function_encode(in, bytes) == CK10_OK, "flash_output_4_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_output_4_function 0 bytes");
    expect(ck10_reg_flash_output_4_function_decode(bytes, &out) == CK10_OK, "flash_output_4_function 0");
    expect(out == 0u, "flash_output_4_function 0");
    in = 4294967295u;
    expect(ck10_reg_flash_output_4_function_encode(in, bytes) == CK10_OK, "flash_output_4_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "flash_output_4_function 4294967295 bytes");
    expect(ck10_reg_flash_output_4_function_decode(bytes, &out) == CK10_OK, "flash_output_4_function 4294967295");
    expect(out == 4294967295u, "flash_output_4_function 4294967295");
}

static void test_220(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_flash_output_5_function_encode(in, bytes) == CK10_OK, "flash_output_5_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_output_5_function 0 bytes");
    expect(ck10_reg_flash_output_5_function_decode(bytes, &out) == CK10_OK, "flash_output_5_function 0");
    expect(out == 0u, "flash_output_5_function 0");
    in = 4294967295u;
    expect(ck10_reg_flash_output_5_function_encode(in, bytes) == CK10_OK, "flash_output_5_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "flash_output_5_function 4294967295 bytes");
    expect(ck10_reg_flash_output_5_function_decode(bytes, &out) == CK10_OK, "flash_output_5_function 4294967295");
    expect(out == 4294967295u, "flash_output_5_function 4294967295");
}

static void test_221(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_flash_output_6_function_encode(in, bytes) == CK10_OK, "flash_output_6_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_output_6_function 0 bytes");
    expect(ck10_reg_flash_output_6_function_decode(bytes, &out) == CK10_OK, "flash_output_6_function 0");
    expect(out == 0u, "flash_output_6_function 0");
    in = 4294967295u;
    expect(ck10_reg_flash_output_6_function_encode(in, bytes) == CK10_OK, "flash_output_6_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "flash_output_6_function 4294967295 bytes");
    expect(ck10_reg_flash_output_6_function_decode(bytes, &out) == CK10_OK, "flash_output_6_function 4294967295");
    expect(out == 4294967295u, "flash_output_6_function 4294967295");
}

static void test_222(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_flash_output_7_function_encode(in, bytes) == CK10_OK, "flash_output_7_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_output_7_function 0 bytes");
    expect(ck10_reg_flash_output_7_function_decode(bytes, &out) == CK10_OK, "flash_output_7_function 0");
    expect(out == 0u, "flash_output_7_function 0");
    in = 4294967295u;
    expect(ck10_reg_flash_output_7_function_encode(in, bytes) == CK10_OK, "flash_output_7_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "flash_output_7_function 4294967295 bytes");
    expect(ck10_reg_flash_output_7_function_decode(bytes, &out) == CK10_OK, "flash_output_7_function 4294967295");
    expect(out == 4294967295u, "flash_output_7_function 4294967295");
}

static void test_223(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_flash_output_8_function_encode(in, bytes) == CK10_OK, "flash_output_8_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_output_8_function 0 bytes");
    expect(ck10_reg_flash_output_8_function_decode(bytes, &out) == CK10_OK, "flash_output_8_function 0");
    expect(out == 0u, "flash_output_8_function 0");
    in = 4294967295u;
    expect(ck10_reg_flash_output_8_function_encode(in, bytes) == CK10_OK, "flash_output_8_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "flash_output_8_function 4294967295 bytes");
    expect(ck10_reg_flash_output_8_function_decode(bytes, &out) == CK10_OK, "flash_output_8_function 4294967295");
    expect(out == 4294967295u, "flash_output_8_function 4294967295");
}

static void test_224(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_flash_output_9_function_encode(in, bytes) == CK10_OK, "flash_output_9_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_output_9_function 0 bytes");
    expect(ck10_reg_flash_output_9_function_decode(bytes, &out) == CK10_OK, "flash_output_9_function 0");
    expect(out == 0u, "flash_output_9_function 0");
    in = 4294967295u;
    expect(ck10_reg_flash_output_9_function_encode(in, bytes) == CK10_OK, "flash_output_9_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "flash_output_9_function 4294967295 bytes");
    expect(ck10_reg_flash_output_9_function_decode(bytes, &out) == CK10_OK, "flash_output_9_function 4294967295");
    expect(out == 4294967295u, "flash_output_9_function 4294967295");
}

static void test_225(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_flash_output_10_function_encode(in, bytes) == CK10_OK, "flash_output_10_function 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_output_10_function 0 bytes");
    expect(ck10_reg_flash_output_10_function_decode(bytes, &out) == CK10_OK, "flash_output_10_function 0");
    expect(out == 0u, "flash_output_10_function 0");
    in = 4294967295u;
    expect(ck10_reg_flash_output_10_function_encode(in, bytes) == CK10_OK, "flash_output_10_function 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "flash_output_10_function 4294967295 bytes");
    expect(ck10_reg_flash_output_10_function_decode(bytes, &out) == CK10_OK, "flash_output_10_function 4294967295");
    expect(out == 4294967295u, "flash_output_10_function 4294967295");
}

static void test_226(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_flash_input_1_polarity_encode(in, bytes) == CK10_OK, "flash_input_1_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_input_1_polarity 0 bytes");
    expect(ck10_reg_flash_input_1_polarity_decode(bytes, &out) == CK10_OK, "flash_input_1_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "flash_input_1_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_flash_input_1_polarity_encode(in, bytes) == CK10_OK, "flash_input_1_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_input_1_polarity 1 bytes");
    expect(ck10_reg_flash_input_1_polarity_decode(bytes, &out) == CK10_OK, "flash_input_1_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "flash_input_1_polarity 1");
}

static void test_227(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_flash_input_2_polarity_encode(in, bytes) == CK10_OK, "flash_input_2_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_input_2_polarity 0 bytes");
    expect(ck10_reg_flash_input_2_polarity_decode(bytes, &out) == CK10_OK, "flash_input_2_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "flash_input_2_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_flash_input_2_polarity_encode(in, bytes) == CK10_OK, "flash_input_2_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_input_2_polarity 1 bytes");
    expect(ck10_reg_flash_input_2_polarity_decode(bytes, &out) == CK10_OK, "flash_input_2_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "flash_input_2_polarity 1");
}

static void test_228(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_flash_input_3_polarity_encode(in, bytes) == CK10_OK, "flash_input_3_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_input_3_polarity 0 bytes");
    expect(ck10_reg_flash_input_3_polarity_decode(bytes, &out) == CK10_OK, "flash_input_3_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "flash_input_3_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_flash_input_3_polarity_encode(in, bytes) == CK10_OK, "flash_input_3_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_input_3_polarity 1 bytes");
    expect(ck10_reg_flash_input_3_polarity_decode(bytes, &out) == CK10_OK, "flash_input_3_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "flash_input_3_polarity 1");
}

static void test_229(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_flash_input_4_polarity_encode(in, bytes) == CK10_OK, "flash_input_4_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_input_4_polarity 0 bytes");
    expect(ck10_reg_flash_input_4_polarity_decode(bytes, &out) == CK10_OK, "flash_input_4_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "flash_input_4_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_flash_input_4_polarity_encode(in, bytes) == CK10_OK, "flash_input_4_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_input_4_polarity 1 bytes");
    expect(ck10_reg_flash_input_4_polarity_decode(bytes, &out) == CK10_OK, "flash_input_4_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "flash_input_4_polarity 1");
}

static void test_230(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_flash_input_5_polarity_encode(in, bytes) == CK10_OK, "flash_input_5_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_input_5_polarity 0 bytes");
    expect(ck10_reg_flash_input_5_polarity_decode(bytes, &out) == CK10_OK, "flash_input_5_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "flash_input_5_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_flash_input_5_polarity_encode(in, bytes) == CK10_OK, "flash_input_5_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_input_5_polarity 1 bytes");
    expect(ck10_reg_flash_input_5_polarity_decode(bytes, &out) == CK10_OK, "flash_input_5_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "flash_input_5_polarity 1");
}

static void test_231(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_flash_input_6_polarity_encode(in, bytes) == CK10_OK, "flash_input_6_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_input_6_polarity 0 bytes");
    expect(ck10_reg_flash_input_6_polarity_decode(bytes, &out) == CK10_OK, "flash_input_6_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "flash_input_6_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_flash_input_6_polarity_encode(in, bytes) == CK10_OK, "flash_input_6_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_input_6_polarity 1 bytes");
    expect(ck10_reg_flash_input_6_polarity_decode(bytes, &out) == CK10_OK, "flash_input_6_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "flash_input_6_polarity 1");
}

static void test_232(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_flash_input_7_polarity_encode(in, bytes) == CK10_OK, "flash_input_7_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_input_7_polarity 0 bytes");
    expect(ck10_reg_flash_input_7_polarity_decode(bytes, &out) == CK10_OK, "flash_input_7_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "flash_input_7_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_flash_input_7_polarity_encode(in, bytes) == CK10_OK, "flash_input_7_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_input_7_polarity 1 bytes");
    expect(ck10_reg_flash_input_7_polarity_decode(bytes, &out) == CK10_OK, "flash_input_7_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "flash_input_7_polarity 1");
}

static void test_233(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_flash_input_8_polarity_encode(in, bytes) == CK10_OK, "flash_input_8_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_input_8_polarity 0 bytes");
    expect(ck10_reg_flash_input_8_polarity_decode(bytes, &out) == CK10_OK, "flash_input_8_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "flash_input_8_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_flash_input_8_polarity_encode(in, bytes) == CK10_OK, "flash_input_8_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_input_8_polarity 1 bytes");
    expect(ck10_reg_flash_input_8_polarity_decode(bytes, &out) == CK10_OK, "flash_input_8_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "flash_input_8_polarity 1");
}

static void test_234(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_flash_input_9_polarity_encode(in, bytes) == CK10_OK, "flash_input_9_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_input_9_polarity 0 bytes");
    expect(ck10_reg_flash_input_9_polarity_decode(bytes, &out) == CK10_OK, "flash_input_9_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "flash_input_9_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_flash_input_9_polarity_encode(in, bytes) == CK10_OK, "flash_input_9_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_input_9_polarity 1 bytes");
    expect(ck10_reg_flash_input_9_polarity_decode(bytes, &out) == CK10_OK, "flash_input_9_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "flash_input_9_polarity 1");
}

static void test_235(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_flash_input_10_polarity_encode(in, bytes) == CK10_OK, "flash_input_10_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_input_10_polarity 0 bytes");
    expect(ck10_reg_flash_input_10_polarity_decode(bytes, &out) == CK10_OK, "flash_input_10_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "flash_input_10_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_flash_input_10_polarity_encode(in, bytes) == CK10_OK, "flash_input_10_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_input_10_polarity 1 bytes");
    expect(ck10_reg_flash_input_10_polarity_decode(bytes, &out) == CK10_OK, "flash_input_10_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "flash_input_10_polarity 1");
}

static void test_236(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_flash_input_11_polarity_encode(in, bytes) == CK10_OK, "flash_input_11_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_input_11_polarity 0 bytes");
    expect(ck10_reg_flash_input_11_polarity_decode(bytes, &out) == CK10_OK, "flash_input_11_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "flash_input_11_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_flash_input_11_polarity_encode(in, bytes) == CK10_OK, "flash_input_11_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_input_11_polarity 1 bytes");
    expect(ck10_reg_flash_input_11_polarity_decode(bytes, &out) == CK10_OK, "flash_input_11_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "flash_input_11_polarity 1");
}

static void test_237(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_flash_input_12_polarity_encode(in, bytes) == CK10_OK, "flash_input_12_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_input_12_polarity 0 bytes");
    expect(ck10_reg_flash_input_12_polarity_decode(bytes, &out) == CK10_OK, "flash_input_12_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "flash_input_12_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_flash_input_12_polarity_encode(in, bytes) == CK10_OK, "flash_input_12_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_input_12_polarity 1 bytes");
    expect(ck10_reg_flash_input_12_polarity_decode(bytes, &out) == CK10_OK, "flash_input_12_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "flash_input_12_polarity 1");
}

static void test_238(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_flash_output_1_polarity_encode(in, bytes) == CK10_OK, "flash_output_1_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_output_1_polarity 0 bytes");
    expect(ck10_reg_flash_output_1_polarity_decode(bytes, &out) == CK10_OK, "flash_output_1_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "flash_output_1_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_flash_output_1_polarity_encode(in, bytes) == CK10_OK, "flash_output_1_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_output_1_polarity 1 bytes");
    expect(ck10_reg_flash_output_1_polarity_decode(bytes, &out) == CK10_OK, "flash_output_1_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "flash_output_1_polarity 1");
}

static void test_239(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_flash_output_2_polarity_encode(in, bytes) == CK10_OK, "flash_output_2_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_output_2_polarity 0 bytes");
    expect(ck10_reg_flash_output_2_polarity_decode(bytes, &out) == CK10_OK, "flash_output_2_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "flash_output_2_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_flash_output_2_polarity_encode(in, bytes) == CK10_OK, "flash_output_2_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_output_2_polarity 1 bytes");
    expect(ck10_reg_flash_output_2_polarity_decode(bytes, &out) == CK10_OK, "flash_output_2_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "flash_output_2_polarity 1");
}

static void test_240(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_flash_output_3_polarity_encode(in, bytes) == CK10_OK, "flash_output_3_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_output_3_polarity 0 bytes");
    expect(ck10_reg_flash_output_3_polarity_decode(bytes, &out) == CK10_OK, "flash_output_3_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "flash_output_3_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_flash_output_3_polarity_encode(in, bytes) == CK10_OK, "flash_output_3_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_output_3_polarity 1 bytes");
    expect(ck10_reg_flash_output_3_polarity_decode(bytes, &out) == CK10_OK, "flash_output_3_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "flash_output_3_polarity 1");
}

static void test_241(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_flash_output_4_polarity_encode(in, bytes) == CK10_OK, "flash_output_4_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_output_4_polarity 0 bytes");
    expect(ck10_reg_flash_output_4_polarity_decode(bytes, &out) == CK10_OK, "flash_output_4_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "flash_output_4_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_flash_output_4_polarity_encode(in, bytes) == CK10_OK, "flash_output_4_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_output_4_polarity 1 bytes");
    expect(ck10_reg_flash_output_4_polarity_decode(bytes, &out) == CK10_OK, "flash_output_4_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "flash_output_4_polarity 1");
}

static void test_242(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_flash_output_5_polarity_encode(in, bytes) == CK10_OK, "flash_output_5_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_output_5_polarity 0 bytes");
    expect(ck10_reg_flash_output_5_polarity_decode(bytes, &out) == CK10_OK, "flash_output_5_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "flash_output_5_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_flash_output_5_polarity_encode(in, bytes) == CK10_OK, "flash_output_5_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_output_5_polarity 1 bytes");
    expect(ck10_reg_flash_output_5_polarity_decode(bytes, &out) == CK10_OK, "flash_output_5_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "flash_output_5_polarity 1");
}

static void test_243(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_flash_output_6_polarity_encode(in, bytes) == CK10_OK, "flash_output_6_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_output_6_polarity 0 bytes");
    expect(ck10_reg_flash_output_6_polarity_decode(bytes, &out) == CK10_OK, "flash_output_6_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "flash_output_6_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_flash_output_6_polarity_encode(in, bytes) == CK10_OK, "flash_output_6_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_output_6_polarity 1 bytes");
    expect(ck10_reg_flash_output_6_polarity_decode(bytes, &out) == CK10_OK, "flash_output_6_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "flash_output_6_polarity 1");
}

static void test_244(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_flash_output_7_polarity_encode(in, bytes) == CK10_OK, "flash_output_7_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_output_7_polarity 0 bytes");
    expect(ck10_reg_flash_output_7_polarity_decode(bytes, &out) == CK10_OK, "flash_output_7_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "flash_output_7_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_flash_output_7_polarity_encode(in, bytes) == CK10_OK, "flash_output_7_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_output_7_polarity 1 bytes");
    expect(ck10_reg_flash_output_7_polarity_decode(bytes, &out) == CK10_OK, "flash_output_7_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "flash_output_7_polarity 1");
}

static void test_245(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_flash_output_8_polarity_encode(in, bytes) == CK10_OK, "flash_output_8_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_output_8_polarity 0 bytes");
    expect(ck10_reg_flash_output_8_polarity_decode(bytes, &out) == CK10_OK, "flash_output_8_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "flash_output_8_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_flash_output_8_polarity_encode(in, bytes) == CK10_OK, "flash_output_8_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_output_8_polarity 1 bytes");
    expect(ck10_reg_flash_output_8_polarity_decode(bytes, &out) == CK10_OK, "flash_output_8_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "flash_output_8_polarity 1");
}

static void test_246(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_flash_output_9_polarity_encode(in, bytes) == CK10_OK, "flash_output_9_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_output_9_polarity 0 bytes");
    expect(ck10_reg_flash_output_9_polarity_decode(bytes, &out) == CK10_OK, "flash_output_9_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "flash_output_9_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_flash_output_9_polarity_encode(in, bytes) == CK10_OK, "flash_output_9_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_output_9_polarity 1 bytes");
    expect(ck10_reg_flash_output_9_polarity_decode(bytes, &out) == CK10_OK, "flash_output_9_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "flash_output_9_polarity 1");
}

static void test_247(void)
{
    uint8_t bytes[4];
    ck10_polarity out = CK10_POLARITY_INVERTED;
    volatile ck10_polarity in = CK10_POLARITY_NORMAL;
    in = CK10_POLARITY_NORMAL;
    expect(ck10_reg_flash_output_10_polarity_encode(in, bytes) == CK10_OK, "flash_output_10_polarity 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "flash_output_10_polarity 0 bytes");
    expect(ck10_reg_flash_output_10_polarity_decode(bytes, &out) == CK10_OK, "flash_output_10_polarity 0");
    expect(out == CK10_POLARITY_NORMAL, "flash_output_10_polarity 0");
    in = CK10_POLARITY_INVERTED;
    expect(ck10_reg_flash_output_10_polarity_encode(in, bytes) == CK10_OK, "flash_output_10_polarity 1");
    expect(same_bytes(bytes, "\000\000\000\001", 4u), "flash_output_10_polarity 1 bytes");
    expect(ck10_reg_flash_output_10_polarity_decode(bytes, &out) == CK10_OK, "flash_output_10_polarity 1");
    expect(out == CK10_POLARITY_INVERTED, "flash_output_10_polarity 1");
}

static void test_248(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_motion_status_encode(in, bytes) == CK10_OK, "motion_status 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "motion_status 0 bytes");
    expect(ck10_reg_motion_status_decode(bytes, &out) == CK10_OK, "motion_status 0");
    expect(out == 0u, "motion_status 0");
    in = 4294967295u;
    expect(ck10_reg_motion_status_encode(in, bytes) == CK10_OK, "motion_status 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "motion_status 4294967295 bytes");
    expect(ck10_reg_motion_status_decode(bytes, &out) == CK10_OK, "motion_status 4294967295");
    expect(out == 4294967295u, "motion_status 4294967295");
}

static void test_249(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(ck10_reg_actual_position_encode(in, bytes) == CK10_OK, "actual_position -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "actual_position -2147483648 bytes");
    expect(ck10_reg_actual_position_decode(bytes, &out) == CK10_OK, "actual_position -2147483648");
    expect(out == (-2147483647 - 1), "actual_position -2147483648");
    in = 0;
    expect(ck10_reg_actual_position_encode(in, bytes) == CK10_OK, "actual_position 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "actual_position 0 bytes");
    expect(ck10_reg_actual_position_decode(bytes, &out) == CK10_OK, "actual_position 0");
    expect(out == 0, "actual_position 0");
    in = 2147483647;
    expect(ck10_reg_actual_position_encode(in, bytes) == CK10_OK, "actual_position 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "actual_position 2147483647 bytes");
    expect(ck10_reg_actual_position_decode(bytes, &out) == CK10_OK, "actual_position 2147483647");
    expect(out == 2147483647, "actual_position 2147483647");
}

static void test_250(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(ck10_reg_command_position_encode(in, bytes) == CK10_OK, "command_position -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "command_position -2147483648 bytes");
    expect(ck10_reg_command_position_decode(bytes, &out) == CK10_OK, "command_position -2147483648");
    expect(out == (-2147483647 - 1), "command_position -2147483648");
    in = 0;
    expect(ck10_reg_command_position_encode(in, bytes) == CK10_OK, "command_position 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "command_position 0 bytes");
    expect(ck10_reg_command_position_decode(bytes, &out) == CK10_OK, "command_position 0");
    expect(out == 0, "command_position 0");
    in = 2147483647;
    expect(ck10_reg_command_position_encode(in, bytes) == CK10_OK, "command_position 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "command_position 2147483647 bytes");
    expect(ck10_reg_command_position_decode(bytes, &out) == CK10_OK, "command_position 2147483647");
    expect(out == 2147483647, "command_position 2147483647");
}

static void test_251(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(ck10_reg_speed_encode(in, bytes) == CK10_OK, "speed -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "speed -2147483648 bytes");
    expect(ck10_reg_speed_decode(bytes, &out) == CK10_OK, "speed -2147483648");
    expect(out == (-2147483647 - 1), "speed -2147483648");
    in = 0;
    expect(ck10_reg_speed_encode(in, bytes) == CK10_OK, "speed 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "speed 0 bytes");
    expect(ck10_reg_speed_decode(bytes, &out) == CK10_OK, "speed 0");
    expect(out == 0, "speed 0");
    in = 2147483647;
    expect(ck10_reg_speed_encode(in, bytes) == CK10_OK, "speed 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "speed 2147483647 bytes");
    expect(ck10_reg_speed_decode(bytes, &out) == CK10_OK, "speed 2147483647");
    expect(out == 2147483647, "speed 2147483647");
}

static void test_252(void)
{
    uint8_t bytes[4];
    int32_t out = 0;
    volatile int32_t in = 0;
    in = (-2147483647 - 1);
    expect(ck10_reg_position_error_encode(in, bytes) == CK10_OK, "position_error -2147483648");
    expect(same_bytes(bytes, "\200\000\000\000", 4u), "position_error -2147483648 bytes");
    expect(ck10_reg_position_error_decode(bytes, &out) == CK10_OK, "position_error -2147483648");
    expect(out == (-2147483647 - 1), "position_error -2147483648");
    in = 0;
    expect(ck10_reg_position_error_encode(in, bytes) == CK10_OK, "position_error 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "position_error 0 bytes");
    expect(ck10_reg_position_error_decode(bytes, &out) == CK10_OK, "position_error 0");
    expect(out == 0, "position_error 0");
    in = 2147483647;
    expect(ck10_reg_position_error_encode(in, bytes) == CK10_OK, "position_error 2147483647");
    expect(same_bytes(bytes, "\177\377\377\377", 4u), "position_error 2147483647 bytes");
    expect(ck10_reg_position_error_decode(bytes, &out) == CK10_OK, "position_error 2147483647");
    expect(out == 2147483647, "position_error 2147483647");
}

static void test_253(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_inputs_encode(in, bytes) == CK10_OK, "inputs 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "inputs 0 bytes");
    expect(ck10_reg_inputs_decode(bytes, &out) == CK10_OK, "inputs 0");
    expect(out == 0u, "inputs 0");
    in = 4294967295u;
    expect(ck10_reg_inputs_encode(in, bytes) == CK10_OK, "inputs 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "inputs 4294967295 bytes");
    expect(ck10_reg_inputs_decode(bytes, &out) == CK10_OK, "inputs 4294967295");
    expect(out == 4294967295u, "inputs 4294967295");
}

static void test_254(void)
{
    uint8_t bytes[4];
    uint32_t out = 0;
    volatile uint32_t in = 0;
    in = 0u;
    expect(ck10_reg_outputs_encode(in, bytes) == CK10_OK, "outputs 0");
    expect(same_bytes(bytes, "\000\000\000\000", 4u), "outputs 0 bytes");
    expect(ck10_reg_outputs_decode(bytes, &out) == CK10_OK, "outputs 0");
    expect(out == 0u, "outputs 0");
    in = 4294967295u;
    expect(ck10_reg_outputs_encode(in, bytes) == CK10_OK, "outputs 4294967295");
    expect(same_bytes(bytes, "\377\377\377\377", 4u), "outputs 4294967295 bytes");
    expect(ck10_reg_outputs_decode(bytes, &out) == CK10_OK, "outputs 4294967295");
    expect(out == 4294967295u, "outputs 4294967295");
}

static void test_255(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(ck10_reg_current_point_encode(in, bytes) == CK10_OK, "current_point 0");
    expect(same_bytes(bytes, "\000\000", 2u), "current_point 0 bytes");
    expect(ck10_reg_current_point_decode(bytes, &out) == CK10_OK, "current_point 0");
    expect(out == 0u, "current_point 0");
    in = 65535u;
    expect(ck10_reg_current_point_encode(in, bytes) == CK10_OK, "current_point 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "current_point 65535 bytes");
    expect(ck10_reg_current_point_decode(bytes, &out) == CK10_OK, "current_point 65535");
    expect(out == 65535u, "current_point 65535");
}

static void test_256(void)
{
    uint8_t bytes[2];
    ck10_push_status out = CK10_PUSH_STATUS_MISSED;
    volatile ck10_push_status in = CK10_PUSH_STATUS_NO_PUSH;
    in = CK10_PUSH_STATUS_NO_PUSH;
    expect(ck10_reg_push_status_encode(in, bytes) == CK10_OK, "push_status 0");
    expect(same_bytes(bytes, "\000\000", 2u), "push_status 0 bytes");
    expect(ck10_reg_push_status_decode(bytes, &out) == CK10_OK, "push_status 0");
    expect(out == CK10_PUSH_STATUS_NO_PUSH, "push_status 0");
    in = CK10_PUSH_STATUS_PUSHING;
    expect(ck10_reg_push_status_encode(in, bytes) == CK10_OK, "push_status 1");
    expect(same_bytes(bytes, "\000\001", 2u), "push_status 1 bytes");
    expect(ck10_reg_push_status_decode(bytes, &out) == CK10_OK, "push_status 1");
    expect(out == CK10_PUSH_STATUS_PUSHING, "push_status 1");
    in = CK10_PUSH_STATUS_HOLDING;
    expect(ck10_reg_push_status_encode(in, bytes) == CK10_OK, "push_status 2");
    expect(same_bytes(bytes, "\000\002", 2u), "push_status 2 bytes");
    expect(ck10_reg_push_status_decode(bytes, &out) == CK10_OK, "push_status 2");
    expect(out == CK10_PUSH_STATUS_HOLDING, "push_status 2");
    in = CK10_PUSH_STATUS_MISSED;
    expect(ck10_reg_push_status_encode(in, bytes) == CK10_OK, "push_status 3");
    expect(same_bytes(bytes, "\000\003", 2u), "push_status 3 bytes");
    expect(ck10_reg_push_status_decode(bytes, &out) == CK10_OK, "push_status 3");
    expect(out == CK10_PUSH_STATUS_MISSED, "push_status 3");
}

static void test_257(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(ck10_reg_current_alarm_encode(in, bytes) == CK10_OK, "current_alarm 0");
    expect(same_bytes(bytes, "\000\000", 2u), "current_alarm 0 bytes");
    expect(ck10_reg_current_alarm_decode(bytes, &out) == CK10_OK, "current_alarm 0");
    expect(out == 0u, "current_alarm 0");
    in = 65535u;
    expect(ck10_reg_current_alarm_encode(in, bytes) == CK10_OK, "current_alarm 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "current_alarm 65535 bytes");
    expect(ck10_reg_current_alarm_decode(bytes, &out) == CK10_OK, "current_alarm 65535");
    expect(out == 65535u, "current_alarm 65535");
}

static void test_258(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(ck10_reg_motor_id_encode(in, bytes) == CK10_OK, "motor_id 0");
    expect(same_bytes(bytes, "\000\000", 2u), "motor_id 0 bytes");
    expect(ck10_reg_motor_id_decode(bytes, &out) == CK10_OK, "motor_id 0");
    expect(out == 0u, "motor_id 0");
    in = 65535u;
    expect(ck10_reg_motor_id_encode(in, bytes) == CK10_OK, "motor_id 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "motor_id 65535 bytes");
    expect(ck10_reg_motor_id_decode(bytes, &out) == CK10_OK, "motor_id 65535");
    expect(out == 65535u, "motor_id 65535");
}

static void test_259(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(ck10_reg_user_inputs_encode(in, bytes) == CK10_OK, "user_inputs 0");
    expect(same_bytes(bytes, "\000\000", 2u), "user_inputs 0 bytes");
    expect(ck10_reg_user_inputs_decode(bytes, &out) == CK10_OK, "user_inputs 0");
    expect(out == 0u, "user_inputs 0");
    in = 65535u;
    expect(ck10_reg_user_inputs_encode(in, bytes) == CK10_OK, "user_inputs 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "user_inputs 65535 bytes");
    expect(ck10_reg_user_inputs_decode(bytes, &out) == CK10_OK, "user_inputs 65535");
    expect(out == 65535u, "user_inputs 65535");
}

static void test_260(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(ck10_reg_user_outputs_encode(in, bytes) == CK10_OK, "user_outputs 0");
    expect(same_bytes(bytes, "\000\000", 2u), "user_outputs 0 bytes");
    expect(ck10_reg_user_outputs_decode(bytes, &out) == CK10_OK, "user_outputs 0");
    expect(out == 0u, "user_outputs 0");
    in = 65535u;
    expect(ck10_reg_user_outputs_encode(in, bytes) == CK10_OK, "user_outputs 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "user_outputs 65535 bytes");
    expect(ck10_reg_user_outputs_decode(bytes, &out) == CK10_OK, "user_outputs 65535");
    expect(out == 65535u, "user_outputs 65535");
}

static void test_261(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(ck10_reg_user_output_0_encode(in, bytes) == CK10_OK, "user_output_0 0");
    expect(same_bytes(bytes, "\000\000", 2u), "user_output_0 0 bytes");
    expect(ck10_reg_user_output_0_decode(bytes, &out) == CK10_OK, "user_output_0 0");
    expect(out == 0u, "user_output_0 0");
    in = 65535u;
    expect(ck10_reg_user_output_0_encode(in, bytes) == CK10_OK, "user_output_0 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "user_output_0 65535 bytes");
    expect(ck10_reg_user_output_0_decode(bytes, &out) == CK10_OK, "user_output_0 65535");
    expect(out == 65535u, "user_output_0 65535");
}

static void test_262(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(ck10_reg_user_output_1_encode(in, bytes) == CK10_OK, "user_output_1 0");
    expect(same_bytes(bytes, "\000\000", 2u), "user_output_1 0 bytes");
    expect(ck10_reg_user_output_1_decode(bytes, &out) == CK10_OK, "user_output_1 0");
    expect(out == 0u, "user_output_1 0");
    in = 65535u;
    expect(ck10_reg_user_output_1_encode(in, bytes) == CK10_OK, "user_output_1 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "user_output_1 65535 bytes");
    expect(ck10_reg_user_output_1_decode(bytes, &out) == CK10_OK, "user_output_1 65535");
    expect(out == 65535u, "user_output_1 65535");
}

static void test_263(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(ck10_reg_user_output_2_encode(in, bytes) == CK10_OK, "user_output_2 0");
    expect(same_bytes(bytes, "\000\000", 2u), "user_output_2 0 bytes");
    expect(ck10_reg_user_output_2_decode(bytes, &out) == CK10_OK, "user_output_2 0");
    expect(out == 0u, "user_output_2 0");
    in = 65535u;
    expect(ck10_reg_user_output_2_encode(in, bytes) == CK10_OK, "user_output_2 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "user_output_2 65535 bytes");
    expect(ck10_reg_user_output_2_decode(bytes, &out) == CK10_OK, "user_output_2 65535");
    expect(out == 65535u, "user_output_2 65535");
}

static void test_264(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(ck10_reg_user_output_3_encode(in, bytes) == CK10_OK, "user_output_3 0");
    expect(same_bytes(bytes, "\000\000", 2u), "user_output_3 0 bytes");
    expect(ck10_reg_user_output_3_decode(bytes, &out) == CK10_OK, "user_output_3 0");
    expect(out == 0u, "user_output_3 0");
    in = 65535u;
    expect(ck10_reg_user_output_3_encode(in, bytes) == CK10_OK, "user_output_3 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "user_output_3 65535 bytes");
    expect(ck10_reg_user_output_3_decode(bytes, &out) == CK10_OK, "user_output_3 65535");
    expect(out == 65535u, "user_output_3 65535");
}

static void test_265(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(ck10_reg_user_output_4_encode(in, bytes) == CK10_OK, "user_output_4 0");
    expect(same_bytes(bytes, "\000\000", 2u), "user_output_4 0 bytes");
    expect(ck10_reg_user_output_4_decode(bytes, &out) == CK10_OK, "user_output_4 0");
    expect(out == 0u, "user_output_4 0");
    in = 65535u;
    expect(ck10_reg_user_output_4_encode(in, bytes) == CK10_OK, "user_output_4 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "user_output_4 65535 bytes");
    expect(ck10_reg_user_output_4_decode(bytes, &out) == CK10_OK, "user_output_4 65535");
    expect(out == 65535u, "user_output_4 65535");
}

static void test_266(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(ck10_reg_user_output_5_encode(in, bytes) == CK10_OK, "user_output_5 0");
    expect(same_bytes(bytes, "\000\000", 2u), "user_output_5 0 bytes");
    expect(ck10_reg_user_output_5_decode(bytes, &out) == CK10_OK, "user_output_5 0");
    expect(out == 0u, "user_output_5 0");
    in = 65535u;
    expect(ck10_reg_user_output_5_encode(in, bytes) == CK10_OK, "user_output_5 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "user_output_5 65535 bytes");
    expect(ck10_reg_user_output_5_decode(bytes, &out) == CK10_OK, "user_output_5 65535");
    expect(out == 65535u, "user_output_5 65535");
}

static void test_267(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(ck10_reg_user_output_6_encode(in, bytes) == CK10_OK, "user_output_6 0");
    expect(same_bytes(bytes, "\000\000", 2u), "user_output_6 0 bytes");
    expect(ck10_reg_user_output_6_decode(bytes, &out) == CK10_OK, "user_output_6 0");
    expect(out == 0u, "user_output_6 0");
    in = 65535u;
    expect(ck10_reg_user_output_6_encode(in, bytes) == CK10_OK, "user_output_6 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "user_output_6 65535 bytes");
    expect(ck10_reg_user_output_6_decode(bytes, &out) == CK10_OK, "user_output_6 65535");
    expect(out == 65535u, "user_output_6 65535");
}

static void test_268(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(ck10_reg_user_output_7_encode(in, bytes) == CK10_OK, "user_output_7 0");
    expect(same_bytes(bytes, "\000\000", 2u), "user_output_7 0 bytes");
    expect(ck10_reg_user_output_7_decode(bytes, &out) == CK10_OK, "user_output_7 0");
    expect(out == 0u, "user_output_7 0");
    in = 65535u;
    expect(ck10_reg_user_output_7_encode(in, bytes) == CK10_OK, "user_output_7 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "user_output_7 65535 bytes");
    expect(ck10_reg_user_output_7_decode(bytes, &out) == CK10_OK, "user_output_7 65535");
    expect(out == 65535u, "user_output_7 65535");
}

static void test_269(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(ck10_reg_user_output_8_encode(in, bytes) == CK10_OK, "user_output_8 0");
    expect(same_bytes(bytes, "\000\000", 2u), "user_output_8 0 bytes");
    expect(ck10_reg_user_output_8_decode(bytes, &out) == CK10_OK, "user_output_8 0");
    expect(out == 0u, "user_output_8 0");
    in = 65535u;
    expect(ck10_reg_user_output_8_encode(in, bytes) == CK10_OK, "user_output_8 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "user_output_8 65535 bytes");
    expect(ck10_reg_user_output_8_decode(bytes, &out) == CK10_OK, "user_output_8 65535");
    expect(out == 65535u, "user_output_8 65535");
}

static void test_270(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    static const uint8_t other[] = {0x00, 0x00};
    expect(ck10_reg_clear_alarm_history_encode(bytes) == CK10_OK, "clear_alarm_history");
    expect(same_bytes(bytes, "\377\377", 2u), "clear_alarm_history bytes");
    expect(ck10_reg_clear_alarm_history_decode(bytes, &out) == CK10_OK, "clear_alarm_history");
    expect(out == 65535u, "clear_alarm_history");
    expect(ck10_reg_clear_alarm_history_decode(other, &out) == CK10_OK, "clear_alarm_history 0");
    expect(out == 0u, "clear_alarm_history 0");
}

static void test_271(void)
{
    uint8_t bytes[2];
    uint16_t out = 0;
    volatile uint16_t in = 0;
    in = 0u;
    expect(ck10_reg_alarm_history_encode(in, bytes) == CK10_OK, "alarm_history 0");
    expect(same_bytes(bytes, "\000\000", 2u), "alarm_history 0 bytes");
    expect(ck10_reg_alarm_history_decode(bytes, &out) == CK10_OK, "alarm_history 0");
    expect(out == 0u, "alarm_history 0");
    in = 65535u;
    expect(ck10_reg_alarm_history_encode(in, bytes) == CK10_OK, "alarm_history 65535");
    expect(same_bytes(bytes, "\377\377", 2u), "alarm_history 65535 bytes");
    expect(ck10_reg_alarm_history_decode(bytes, &out) == CK10_OK, "alarm_history 65535");
    expect(out == 65535u, "alarm_history 65535");
}

static void test_272(void)
{
    static const uint8_t frame[] = {0x01, 0x11, 0xC0, 0x2C};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example identity-request opens");
    expect(opened.unit_address == 1u, "example identity-request: station");
    expect(opened.code == 17u, "example identity-request: code");
    expect(ck10_report_server_id_request_decode(opened.body, opened.body_length) == CK10_OK, "example identity-request decodes");
    expect(ck10_rtu_encode_report_server_id_request(1u, again, sizeof again, &length) == CK10_OK, "example identity-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example identity-request bytes");
}

static void test_273(void)
{
    static const uint8_t frame[] = {0x01, 0x11, 0x02, 0x68, 0xFF, 0xD2, 0xBC};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example identity-response opens");
    expect(opened.unit_address == 1u, "example identity-response: station");
    expect(opened.code == 17u, "example identity-response: code");
    expect(opened.error == false, "example identity-response: error");
    expect(ck10_report_server_id_response_decode(opened.body, opened.body_length) == CK10_OK, "example identity-response decodes");
    expect(ck10_rtu_encode_report_server_id_response(1u, again, sizeof again, &length) == CK10_OK, "example identity-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example identity-response bytes");
}

static void test_274(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x05, 0x00, 0x00, 0x01, 0x48, 0xC6};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_write_register_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example refused-write-request opens");
    expect(opened.unit_address == 1u, "example refused-write-request: station");
    expect(opened.code == 6u, "example refused-write-request: code");
    expect(ck10_write_register_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example refused-write-request decodes");
    expect(out.address == 1280u, "example refused-write-request: address");
    expect(out.value == 1u, "example refused-write-request: value");
    in.address = 1280u;
    in.value = 1u;
    expect(ck10_rtu_encode_write_register_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example refused-write-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example refused-write-request bytes");
}

static void test_275(void)
{
    static const uint8_t frame[] = {0x01, 0x86, 0x02, 0xC3, 0xA1};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_exception in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example refused-write-response opens");
    expect(opened.unit_address == 1u, "example refused-write-response: station");
    expect(opened.code == 6u, "example refused-write-response: code");
    expect(opened.error == true, "example refused-write-response: error");
    expect(ck10_exception_decode(opened.body, opened.body_length, &out) == CK10_OK, "example refused-write-response decodes");
    expect(out.exception_code == 2u, "example refused-write-response: exception_code");
    in.exception_code = 2u;
    expect(ck10_rtu_encode_exception_response(1u, 6u, &in, again, sizeof again, &length) == CK10_OK, "example refused-write-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example refused-write-response bytes");
}

static void test_276(void)
{
    static const uint8_t frame[] = {0x01, 0x03, 0x03, 0xE8, 0x00, 0x13, 0x84, 0x77};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_read_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-status-request opens");
    expect(opened.unit_address == 1u, "example rtu-status-request: station");
    expect(opened.code == 3u, "example rtu-status-request: code");
    expect(ck10_read_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-status-request decodes");
    expect(out.address == 1000u, "example rtu-status-request: address");
    expect(out.word_count == 19u, "example rtu-status-request: word_count");
    in.address = 1000u;
    in.word_count = 19u;
    expect(ck10_rtu_encode_read_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-status-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-status-request bytes");
}

static void test_277(void)
{
    static const uint8_t frame[] = {0x01, 0x03, 0x26, 0x02, 0x18, 0x00, 0x00, 0xFF, 0xFE, 0x79, 0x5D, 0xFF, 0xFE, 0x79, 0x60, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x03, 0x00, 0x02, 0x00, 0x02, 0x00, 0x00, 0x02, 0x02, 0x00, 0x7F, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x14, 0xB1, 0x13};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_read_registers_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-status-response opens");
    expect(opened.unit_address == 1u, "example rtu-status-response: station");
    expect(opened.code == 3u, "example rtu-status-response: code");
    expect(opened.error == false, "example rtu-status-response: error");
    expect(ck10_read_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-status-response decodes");
    expect(out.values_count == 19u, "example rtu-status-response: values count");
    expect(out.values[0] == 536u, "example rtu-status-response: values");
    expect(out.values[1] == 0u, "example rtu-status-response: values");
    expect(out.values[2] == 65534u, "example rtu-status-response: values");
    expect(out.values[3] == 31069u, "example rtu-status-response: values");
    expect(out.values[4] == 65534u, "example rtu-status-response: values");
    expect(out.values[5] == 31072u, "example rtu-status-response: values");
    expect(out.values[6] == 0u, "example rtu-status-response: values");
    expect(out.values[7] == 0u, "example rtu-status-response: values");
    expect(out.values[8] == 0u, "example rtu-status-response: values");
    expect(out.values[9] == 3u, "example rtu-status-response: values");
    expect(out.values[10] == 2u, "example rtu-status-response: values");
    expect(out.values[11] == 2u, "example rtu-status-response: values");
    expect(out.values[12] == 0u, "example rtu-status-response: values");
    expect(out.values[13] == 514u, "example rtu-status-response: values");
    expect(out.values[14] == 127u, "example rtu-status-response: values");
    expect(out.values[15] == 0u, "example rtu-status-response: values");
    expect(out.values[16] == 0u, "example rtu-status-response: values");
    expect(out.values[17] == 0u, "example rtu-status-response: values");
    expect(out.values[18] == 20u, "example rtu-status-response: values");
    in.values_count = 19u;
    in.values[0] = 536u;
    in.values[1] = 0u;
    in.values[2] = 65534u;
    in.values[3] = 31069u;
    in.values[4] = 65534u;
    in.values[5] = 31072u;
    in.values[6] = 0u;
    in.values[7] = 0u;
    in.values[8] = 0u;
    in.values[9] = 3u;
    in.values[10] = 2u;
    in.values[11] = 2u;
    in.values[12] = 0u;
    in.values[13] = 514u;
    in.values[14] = 127u;
    in.values[15] = 0u;
    in.values[16] = 0u;
    in.values[17] = 0u;
    in.values[18] = 20u;
    expect(ck10_rtu_encode_read_registers_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-status-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-status-response bytes");
}

static void test_278(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x30, 0x33, 0x30, 0x33, 0x45, 0x38, 0x30, 0x30, 0x31, 0x33, 0x46, 0x45, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_request_frame opened;
    ck10_read_registers_request in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-status-request opens");
    expect(opened.unit_address == 1u, "example ascii-status-request: station");
    expect(opened.code == 3u, "example ascii-status-request: code");
    expect(ck10_read_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-status-request decodes");
    expect(out.address == 1000u, "example ascii-status-request: address");
    expect(out.word_count == 19u, "example ascii-status-request: word_count");
    in.address = 1000u;
    in.word_count = 19u;
    expect(ck10_ascii_encode_read_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-status-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-status-request bytes");
}

static void test_279(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x30, 0x33, 0x32, 0x36, 0x30, 0x32, 0x31, 0x38, 0x30, 0x30, 0x30, 0x30, 0x46, 0x46, 0x46, 0x45, 0x37, 0x39, 0x35, 0x44, 0x46, 0x46, 0x46, 0x45, 0x37, 0x39, 0x36, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x33, 0x30, 0x30, 0x30, 0x32, 0x30, 0x30, 0x30, 0x32, 0x30, 0x30, 0x30, 0x30, 0x30, 0x32, 0x30, 0x32, 0x30, 0x30, 0x37, 0x46, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x31, 0x34, 0x37, 0x35, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_response_frame opened;
    ck10_read_registers_response in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_response_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-status-response opens");
    expect(opened.unit_address == 1u, "example ascii-status-response: station");
    expect(opened.code == 3u, "example ascii-status-response: code");
    expect(opened.error == false, "example ascii-status-response: error");
    expect(ck10_read_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-status-response decodes");
    expect(out.values_count == 19u, "example ascii-status-response: values count");
    expect(out.values[0] == 536u, "example ascii-status-response: values");
    expect(out.values[1] == 0u, "example ascii-status-response: values");
    expect(out.values[2] == 65534u, "example ascii-status-response: values");
    expect(out.values[3] == 31069u, "example ascii-status-response: values");
    expect(out.values[4] == 65534u, "example ascii-status-response: values");
    expect(out.values[5] == 31072u, "example ascii-status-response: values");
    expect(out.values[6] == 0u, "example ascii-status-response: values");
    expect(out.values[7] == 0u, "example ascii-status-response: values");
    expect(out.values[8] == 0u, "example ascii-status-response: values");
    expect(out.values[9] == 3u, "example ascii-status-response: values");
    expect(out.values[10] == 2u, "example ascii-status-response: values");
    expect(out.values[11] == 2u, "example ascii-status-response: values");
    expect(out.values[12] == 0u, "example ascii-status-response: values");
    expect(out.values[13] == 514u, "example ascii-status-response: values");
    expect(out.values[14] == 127u, "example ascii-status-response: values");
    expect(out.values[15] == 0u, "example ascii-status-response: values");
    expect(out.values[16] == 0u, "example ascii-status-response: values");
    expect(out.values[17] == 0u, "example ascii-status-response: values");
    expect(out.values[18] == 20u, "example ascii-status-response: values");
    in.values_count = 19u;
    in.values[0] = 536u;
    in.values[1] = 0u;
    in.values[2] = 65534u;
    in.values[3] = 31069u;
    in.values[4] = 65534u;
    in.values[5] = 31072u;
    in.values[6] = 0u;
    in.values[7] = 0u;
    in.values[8] = 0u;
    in.values[9] = 3u;
    in.values[10] = 2u;
    in.values[11] = 2u;
    in.values[12] = 0u;
    in.values[13] = 514u;
    in.values[14] = 127u;
    in.values[15] = 0u;
    in.values[16] = 0u;
    in.values[17] = 0u;
    in.values[18] = 20u;
    expect(ck10_ascii_encode_read_registers_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-status-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-status-response bytes");
}

static void test_280(void)
{
    static const uint8_t frame[] = {0x02, 0x03, 0x03, 0xE8, 0x00, 0x0A, 0x45, 0x8E};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_read_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-moving-request opens");
    expect(opened.unit_address == 2u, "example rtu-moving-request: station");
    expect(opened.code == 3u, "example rtu-moving-request: code");
    expect(ck10_read_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-moving-request decodes");
    expect(out.address == 1000u, "example rtu-moving-request: address");
    expect(out.word_count == 10u, "example rtu-moving-request: word_count");
    in.address = 1000u;
    in.word_count = 10u;
    expect(ck10_rtu_encode_read_registers_request(2u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-moving-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-moving-request bytes");
}

static void test_281(void)
{
    static const uint8_t frame[] = {0x02, 0x03, 0x14, 0x28, 0x10, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0xFF, 0xF3, 0xCB, 0x00, 0xFF, 0xFF, 0xFF, 0xFF, 0xAB, 0x55};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_read_registers_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-moving-response opens");
    expect(opened.unit_address == 2u, "example rtu-moving-response: station");
    expect(opened.code == 3u, "example rtu-moving-response: code");
    expect(opened.error == false, "example rtu-moving-response: error");
    expect(ck10_read_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-moving-response decodes");
    expect(out.values_count == 10u, "example rtu-moving-response: values count");
    expect(out.values[0] == 10256u, "example rtu-moving-response: values");
    expect(out.values[1] == 0u, "example rtu-moving-response: values");
    expect(out.values[2] == 32768u, "example rtu-moving-response: values");
    expect(out.values[3] == 0u, "example rtu-moving-response: values");
    expect(out.values[4] == 32768u, "example rtu-moving-response: values");
    expect(out.values[5] == 0u, "example rtu-moving-response: values");
    expect(out.values[6] == 65523u, "example rtu-moving-response: values");
    expect(out.values[7] == 51968u, "example rtu-moving-response: values");
    expect(out.values[8] == 65535u, "example rtu-moving-response: values");
    expect(out.values[9] == 65535u, "example rtu-moving-response: values");
    in.values_count = 10u;
    in.values[0] = 10256u;
    in.values[1] = 0u;
    in.values[2] = 32768u;
    in.values[3] = 0u;
    in.values[4] = 32768u;
    in.values[5] = 0u;
    in.values[6] = 65523u;
    in.values[7] = 51968u;
    in.values[8] = 65535u;
    in.values[9] = 65535u;
    expect(ck10_rtu_encode_read_registers_response(2u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-moving-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-moving-response bytes");
}

static void test_282(void)
{
    static const uint8_t frame[] = {0x10, 0x03, 0x03, 0xE8, 0x00, 0x02, 0x47, 0x3A};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_read_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-all-flags-request opens");
    expect(opened.unit_address == 16u, "example rtu-all-flags-request: station");
    expect(opened.code == 3u, "example rtu-all-flags-request: code");
    expect(ck10_read_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-all-flags-request decodes");
    expect(out.address == 1000u, "example rtu-all-flags-request: address");
    expect(out.word_count == 2u, "example rtu-all-flags-request: word_count");
    in.address = 1000u;
    in.word_count = 2u;
    expect(ck10_rtu_encode_read_registers_request(16u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-all-flags-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-all-flags-request bytes");
}

static void test_283(void)
{
    static const uint8_t frame[] = {0x10, 0x03, 0x04, 0xEF, 0xFF, 0xBF, 0x9F, 0xCF, 0x8E};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_read_registers_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-all-flags-response opens");
    expect(opened.unit_address == 16u, "example rtu-all-flags-response: station");
    expect(opened.code == 3u, "example rtu-all-flags-response: code");
    expect(opened.error == false, "example rtu-all-flags-response: error");
    expect(ck10_read_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-all-flags-response decodes");
    expect(out.values_count == 2u, "example rtu-all-flags-response: values count");
    expect(out.values[0] == 61439u, "example rtu-all-flags-response: values");
    expect(out.values[1] == 49055u, "example rtu-all-flags-response: values");
    in.values_count = 2u;
    in.values[0] = 61439u;
    in.values[1] = 49055u;
    expect(ck10_rtu_encode_read_registers_response(16u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-all-flags-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-all-flags-response bytes");
}

static void test_284(void)
{
    static const uint8_t frame[] = {0x3A, 0x31, 0x30, 0x30, 0x33, 0x30, 0x33, 0x45, 0x38, 0x30, 0x30, 0x30, 0x32, 0x30, 0x30, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_request_frame opened;
    ck10_read_registers_request in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-all-flags-request opens");
    expect(opened.unit_address == 16u, "example ascii-all-flags-request: station");
    expect(opened.code == 3u, "example ascii-all-flags-request: code");
    expect(ck10_read_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-all-flags-request decodes");
    expect(out.address == 1000u, "example ascii-all-flags-request: address");
    expect(out.word_count == 2u, "example ascii-all-flags-request: word_count");
    in.address = 1000u;
    in.word_count = 2u;
    expect(ck10_ascii_encode_read_registers_request(16u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-all-flags-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-all-flags-request bytes");
}

static void test_285(void)
{
    static const uint8_t frame[] = {0x3A, 0x31, 0x30, 0x30, 0x33, 0x30, 0x34, 0x45, 0x46, 0x46, 0x46, 0x42, 0x46, 0x39, 0x46, 0x39, 0x44, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_response_frame opened;
    ck10_read_registers_response in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_response_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-all-flags-response opens");
    expect(opened.unit_address == 16u, "example ascii-all-flags-response: station");
    expect(opened.code == 3u, "example ascii-all-flags-response: code");
    expect(opened.error == false, "example ascii-all-flags-response: error");
    expect(ck10_read_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-all-flags-response decodes");
    expect(out.values_count == 2u, "example ascii-all-flags-response: values count");
    expect(out.values[0] == 61439u, "example ascii-all-flags-response: values");
    expect(out.values[1] == 49055u, "example ascii-all-flags-response: values");
    in.values_count = 2u;
    in.values[0] = 61439u;
    in.values[1] = 49055u;
    expect(ck10_ascii_encode_read_registers_response(16u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-all-flags-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-all-flags-response bytes");
}

static void test_286(void)
{
    static const uint8_t frame[] = {0x01, 0x03, 0x03, 0xF2, 0x00, 0x04, 0xE5, 0xBE};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_read_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-all-signals-request opens");
    expect(opened.unit_address == 1u, "example rtu-all-signals-request: station");
    expect(opened.code == 3u, "example rtu-all-signals-request: code");
    expect(ck10_read_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-all-signals-request decodes");
    expect(out.address == 1010u, "example rtu-all-signals-request: address");
    expect(out.word_count == 4u, "example rtu-all-signals-request: word_count");
    in.address = 1010u;
    in.word_count = 4u;
    expect(ck10_rtu_encode_read_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-all-signals-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-all-signals-request bytes");
}

static void test_287(void)
{
    static const uint8_t frame[] = {0x01, 0x03, 0x08, 0xFF, 0xEB, 0xFF, 0xFF, 0x00, 0xFF, 0xF3, 0xFF, 0xB5, 0x46};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_read_registers_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-all-signals-response opens");
    expect(opened.unit_address == 1u, "example rtu-all-signals-response: station");
    expect(opened.code == 3u, "example rtu-all-signals-response: code");
    expect(opened.error == false, "example rtu-all-signals-response: error");
    expect(ck10_read_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-all-signals-response decodes");
    expect(out.values_count == 4u, "example rtu-all-signals-response: values count");
    expect(out.values[0] == 65515u, "example rtu-all-signals-response: values");
    expect(out.values[1] == 65535u, "example rtu-all-signals-response: values");
    expect(out.values[2] == 255u, "example rtu-all-signals-response: values");
    expect(out.values[3] == 62463u, "example rtu-all-signals-response: values");
    in.values_count = 4u;
    in.values[0] = 65515u;
    in.values[1] = 65535u;
    in.values[2] = 255u;
    in.values[3] = 62463u;
    expect(ck10_rtu_encode_read_registers_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-all-signals-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-all-signals-response bytes");
}

static void test_288(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x30, 0x33, 0x30, 0x33, 0x46, 0x32, 0x30, 0x30, 0x30, 0x34, 0x30, 0x33, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_request_frame opened;
    ck10_read_registers_request in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-all-signals-request opens");
    expect(opened.unit_address == 1u, "example ascii-all-signals-request: station");
    expect(opened.code == 3u, "example ascii-all-signals-request: code");
    expect(ck10_read_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-all-signals-request decodes");
    expect(out.address == 1010u, "example ascii-all-signals-request: address");
    expect(out.word_count == 4u, "example ascii-all-signals-request: word_count");
    in.address = 1010u;
    in.word_count = 4u;
    expect(ck10_ascii_encode_read_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-all-signals-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-all-signals-request bytes");
}

static void test_289(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x30, 0x33, 0x30, 0x38, 0x46, 0x46, 0x45, 0x42, 0x46, 0x46, 0x46, 0x46, 0x30, 0x30, 0x46, 0x46, 0x46, 0x33, 0x46, 0x46, 0x31, 0x42, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_response_frame opened;
    ck10_read_registers_response in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_response_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-all-signals-response opens");
    expect(opened.unit_address == 1u, "example ascii-all-signals-response: station");
    expect(opened.code == 3u, "example ascii-all-signals-response: code");
    expect(opened.error == false, "example ascii-all-signals-response: error");
    expect(ck10_read_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-all-signals-response decodes");
    expect(out.values_count == 4u, "example ascii-all-signals-response: values count");
    expect(out.values[0] == 65515u, "example ascii-all-signals-response: values");
    expect(out.values[1] == 65535u, "example ascii-all-signals-response: values");
    expect(out.values[2] == 255u, "example ascii-all-signals-response: values");
    expect(out.values[3] == 62463u, "example ascii-all-signals-response: values");
    in.values_count = 4u;
    in.values[0] = 65515u;
    in.values[1] = 65535u;
    in.values[2] = 255u;
    in.values[3] = 62463u;
    expect(ck10_ascii_encode_read_registers_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-all-signals-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-all-signals-response bytes");
}

static void test_290(void)
{
    static const uint8_t frame[] = {0x01, 0x03, 0x04, 0x06, 0x00, 0x14, 0xA4, 0xF4};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_read_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-user-signals-request opens");
    expect(opened.unit_address == 1u, "example rtu-user-signals-request: station");
    expect(opened.code == 3u, "example rtu-user-signals-request: code");
    expect(ck10_read_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-user-signals-request decodes");
    expect(out.address == 1030u, "example rtu-user-signals-request: address");
    expect(out.word_count == 20u, "example rtu-user-signals-request: word_count");
    in.address = 1030u;
    in.word_count = 20u;
    expect(ck10_rtu_encode_read_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-user-signals-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-user-signals-request bytes");
}

static void test_291(void)
{
    static const uint8_t frame[] = {0x01, 0x03, 0x28, 0x01, 0x55, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x01, 0xFF, 0x00, 0x01, 0x00, 0x01, 0x00, 0x01, 0x00, 0x01, 0x00, 0x01, 0x00, 0x01, 0x00, 0x01, 0x00, 0x01, 0x00, 0x01, 0xD3, 0x17};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_read_registers_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-user-signals-response opens");
    expect(opened.unit_address == 1u, "example rtu-user-signals-response: station");
    expect(opened.code == 3u, "example rtu-user-signals-response: code");
    expect(opened.error == false, "example rtu-user-signals-response: error");
    expect(ck10_read_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-user-signals-response decodes");
    expect(out.values_count == 20u, "example rtu-user-signals-response: values count");
    expect(out.values[0] == 341u, "example rtu-user-signals-response: values");
    expect(out.values[1] == 1u, "example rtu-user-signals-response: values");
    expect(out.values[2] == 0u, "example rtu-user-signals-response: values");
    expect(out.values[3] == 1u, "example rtu-user-signals-response: values");
    expect(out.values[4] == 0u, "example rtu-user-signals-response: values");
    expect(out.values[5] == 1u, "example rtu-user-signals-response: values");
    expect(out.values[6] == 0u, "example rtu-user-signals-response: values");
    expect(out.values[7] == 1u, "example rtu-user-signals-response: values");
    expect(out.values[8] == 0u, "example rtu-user-signals-response: values");
    expect(out.values[9] == 1u, "example rtu-user-signals-response: values");
    expect(out.values[10] == 511u, "example rtu-user-signals-response: values");
    expect(out.values[11] == 1u, "example rtu-user-signals-response: values");
    expect(out.values[12] == 1u, "example rtu-user-signals-response: values");
    expect(out.values[13] == 1u, "example rtu-user-signals-response: values");
    expect(out.values[14] == 1u, "example rtu-user-signals-response: values");
    expect(out.values[15] == 1u, "example rtu-user-signals-response: values");
    expect(out.values[16] == 1u, "example rtu-user-signals-response: values");
    expect(out.values[17] == 1u, "example rtu-user-signals-response: values");
    expect(out.values[18] == 1u, "example rtu-user-signals-response: values");
    expect(out.values[19] == 1u, "example rtu-user-signals-response: values");
    in.values_count = 20u;
    in.values[0] = 341u;
    in.values[1] = 1u;
    in.values[2] = 0u;
    in.values[3] = 1u;
    in.values[4] = 0u;
    in.values[5] = 1u;
    in.values[6] = 0u;
    in.values[7] = 1u;
    in.values[8] = 0u;
    in.values[9] = 1u;
    in.values[10] = 511u;
    in.values[11] = 1u;
    in.values[12] = 1u;
    in.values[13] = 1u;
    in.values[14] = 1u;
    in.values[15] = 1u;
    in.values[16] = 1u;
    in.values[17] = 1u;
    in.values[18] = 1u;
    in.values[19] = 1u;
    expect(ck10_rtu_encode_read_registers_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-user-signals-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-user-signals-response bytes");
}

static void test_292(void)
{
    static const uint8_t frame[] = {0x03, 0x03, 0x04, 0x24, 0x00, 0x1E, 0x85, 0x1B};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_read_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-alarm-history-request opens");
    expect(opened.unit_address == 3u, "example rtu-alarm-history-request: station");
    expect(opened.code == 3u, "example rtu-alarm-history-request: code");
    expect(ck10_read_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-alarm-history-request decodes");
    expect(out.address == 1060u, "example rtu-alarm-history-request: address");
    expect(out.word_count == 30u, "example rtu-alarm-history-request: word_count");
    in.address = 1060u;
    in.word_count = 30u;
    expect(ck10_rtu_encode_read_registers_request(3u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-alarm-history-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-alarm-history-request bytes");
}

static void test_293(void)
{
    static const uint8_t frame[] = {0x03, 0x03, 0x3C, 0x00, 0x0F, 0x00, 0x01, 0x00, 0x02, 0x00, 0x03, 0x00, 0x04, 0x00, 0x05, 0x00, 0x06, 0x00, 0x07, 0x00, 0x08, 0x00, 0x0A, 0x00, 0x0C, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x3D, 0x39};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_read_registers_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-alarm-history-response opens");
    expect(opened.unit_address == 3u, "example rtu-alarm-history-response: station");
    expect(opened.code == 3u, "example rtu-alarm-history-response: code");
    expect(opened.error == false, "example rtu-alarm-history-response: error");
    expect(ck10_read_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-alarm-history-response decodes");
    expect(out.values_count == 30u, "example rtu-alarm-history-response: values count");
    expect(out.values[0] == 15u, "example rtu-alarm-history-response: values");
    expect(out.values[1] == 1u, "example rtu-alarm-history-response: values");
    expect(out.values[2] == 2u, "example rtu-alarm-history-response: values");
    expect(out.values[3] == 3u, "example rtu-alarm-history-response: values");
    expect(out.values[4] == 4u, "example rtu-alarm-history-response: values");
    expect(out.values[5] == 5u, "example rtu-alarm-history-response: values");
    expect(out.values[6] == 6u, "example rtu-alarm-history-response: values");
    expect(out.values[7] == 7u, "example rtu-alarm-history-response: values");
    expect(out.values[8] == 8u, "example rtu-alarm-history-response: values");
    expect(out.values[9] == 10u, "example rtu-alarm-history-response: values");
    expect(out.values[10] == 12u, "example rtu-alarm-history-response: values");
    expect(out.values[11] == 0u, "example rtu-alarm-history-response: values");
    expect(out.values[12] == 0u, "example rtu-alarm-history-response: values");
    expect(out.values[13] == 0u, "example rtu-alarm-history-response: values");
    expect(out.values[14] == 0u, "example rtu-alarm-history-response: values");
    expect(out.values[15] == 0u, "example rtu-alarm-history-response: values");
    expect(out.values[16] == 0u, "example rtu-alarm-history-response: values");
    expect(out.values[17] == 0u, "example rtu-alarm-history-response: values");
    expect(out.values[18] == 0u, "example rtu-alarm-history-response: values");
    expect(out.values[19] == 0u, "example rtu-alarm-history-response: values");
    expect(out.values[20] == 0u, "example rtu-alarm-history-response: values");
    expect(out.values[21] == 0u, "example rtu-alarm-history-response: values");
    expect(out.values[22] == 0u, "example rtu-alarm-history-response: values");
    expect(out.values[23] == 0u, "example rtu-alarm-history-response: values");
    expect(out.values[24] == 0u, "example rtu-alarm-history-response: values");
    expect(out.values[25] == 0u, "example rtu-alarm-history-response: values");
    expect(out.values[26] == 0u, "example rtu-alarm-history-response: values");
    expect(out.values[27] == 0u, "example rtu-alarm-history-response: values");
    expect(out.values[28] == 0u, "example rtu-alarm-history-response: values");
    expect(out.values[29] == 0u, "example rtu-alarm-history-response: values");
    in.values_count = 30u;
    in.values[0] = 15u;
    in.values[1] = 1u;
    in.values[2] = 2u;
    in.values[3] = 3u;
    in.values[4] = 4u;
    in.values[5] = 5u;
    in.values[6] = 6u;
    in.values[7] = 7u;
    in.values[8] = 8u;
    in.values[9] = 10u;
    in.values[10] = 12u;
    in.values[11] = 0u;
    in.values[12] = 0u;
    in.values[13] = 0u;
    in.values[14] = 0u;
    in.values[15] = 0u;
    in.values[16] = 0u;
    in.values[17] = 0u;
    in.values[18] = 0u;
    in.values[19] = 0u;
    in.values[20] = 0u;
    in.values[21] = 0u;
    in.values[22] = 0u;
    in.values[23] = 0u;
    in.values[24] = 0u;
    in.values[25] = 0u;
    in.values[26] = 0u;
    in.values[27] = 0u;
    in.values[28] = 0u;
    in.values[29] = 0u;
    expect(ck10_rtu_encode_read_registers_response(3u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-alarm-history-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-alarm-history-response bytes");
}

static void test_294(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x33, 0x30, 0x33, 0x30, 0x34, 0x32, 0x34, 0x30, 0x30, 0x31, 0x45, 0x42, 0x34, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_request_frame opened;
    ck10_read_registers_request in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-alarm-history-request opens");
    expect(opened.unit_address == 3u, "example ascii-alarm-history-request: station");
    expect(opened.code == 3u, "example ascii-alarm-history-request: code");
    expect(ck10_read_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-alarm-history-request decodes");
    expect(out.address == 1060u, "example ascii-alarm-history-request: address");
    expect(out.word_count == 30u, "example ascii-alarm-history-request: word_count");
    in.address = 1060u;
    in.word_count = 30u;
    expect(ck10_ascii_encode_read_registers_request(3u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-alarm-history-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-alarm-history-request bytes");
}

static void test_295(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x33, 0x30, 0x33, 0x33, 0x43, 0x30, 0x30, 0x30, 0x46, 0x30, 0x30, 0x30, 0x31, 0x30, 0x30, 0x30, 0x32, 0x30, 0x30, 0x30, 0x33, 0x30, 0x30, 0x30, 0x34, 0x30, 0x30, 0x30, 0x35, 0x30, 0x30, 0x30, 0x36, 0x30, 0x30, 0x30, 0x37, 0x30, 0x30, 0x30, 0x38, 0x30, 0x30, 0x30, 0x41, 0x30, 0x30, 0x30, 0x43, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x37, 0x35, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_response_frame opened;
    ck10_read_registers_response in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_response_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-alarm-history-response opens");
    expect(opened.unit_address == 3u, "example ascii-alarm-history-response: station");
    expect(opened.code == 3u, "example ascii-alarm-history-response: code");
    expect(opened.error == false, "example ascii-alarm-history-response: error");
    expect(ck10_read_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-alarm-history-response decodes");
    expect(out.values_count == 30u, "example ascii-alarm-history-response: values count");
    expect(out.values[0] == 15u, "example ascii-alarm-history-response: values");
    expect(out.values[1] == 1u, "example ascii-alarm-history-response: values");
    expect(out.values[2] == 2u, "example ascii-alarm-history-response: values");
    expect(out.values[3] == 3u, "example ascii-alarm-history-response: values");
    expect(out.values[4] == 4u, "example ascii-alarm-history-response: values");
    expect(out.values[5] == 5u, "example ascii-alarm-history-response: values");
    expect(out.values[6] == 6u, "example ascii-alarm-history-response: values");
    expect(out.values[7] == 7u, "example ascii-alarm-history-response: values");
    expect(out.values[8] == 8u, "example ascii-alarm-history-response: values");
    expect(out.values[9] == 10u, "example ascii-alarm-history-response: values");
    expect(out.values[10] == 12u, "example ascii-alarm-history-response: values");
    expect(out.values[11] == 0u, "example ascii-alarm-history-response: values");
    expect(out.values[12] == 0u, "example ascii-alarm-history-response: values");
    expect(out.values[13] == 0u, "example ascii-alarm-history-response: values");
    expect(out.values[14] == 0u, "example ascii-alarm-history-response: values");
    expect(out.values[15] == 0u, "example ascii-alarm-history-response: values");
    expect(out.values[16] == 0u, "example ascii-alarm-history-response: values");
    expect(out.values[17] == 0u, "example ascii-alarm-history-response: values");
    expect(out.values[18] == 0u, "example ascii-alarm-history-response: values");
    expect(out.values[19] == 0u, "example ascii-alarm-history-response: values");
    expect(out.values[20] == 0u, "example ascii-alarm-history-response: values");
    expect(out.values[21] == 0u, "example ascii-alarm-history-response: values");
    expect(out.values[22] == 0u, "example ascii-alarm-history-response: values");
    expect(out.values[23] == 0u, "example ascii-alarm-history-response: values");
    expect(out.values[24] == 0u, "example ascii-alarm-history-response: values");
    expect(out.values[25] == 0u, "example ascii-alarm-history-response: values");
    expect(out.values[26] == 0u, "example ascii-alarm-history-response: values");
    expect(out.values[27] == 0u, "example ascii-alarm-history-response: values");
    expect(out.values[28] == 0u, "example ascii-alarm-history-response: values");
    expect(out.values[29] == 0u, "example ascii-alarm-history-response: values");
    in.values_count = 30u;
    in.values[0] = 15u;
    in.values[1] = 1u;
    in.values[2] = 2u;
    in.values[3] = 3u;
    in.values[4] = 4u;
    in.values[5] = 5u;
    in.values[6] = 6u;
    in.values[7] = 7u;
    in.values[8] = 8u;
    in.values[9] = 10u;
    in.values[10] = 12u;
    in.values[11] = 0u;
    in.values[12] = 0u;
    in.values[13] = 0u;
    in.values[14] = 0u;
    in.values[15] = 0u;
    in.values[16] = 0u;
    in.values[17] = 0u;
    in.values[18] = 0u;
    in.values[19] = 0u;
    in.values[20] = 0u;
    in.values[21] = 0u;
    in.values[22] = 0u;
    in.values[23] = 0u;
    in.values[24] = 0u;
    in.values[25] = 0u;
    in.values[26] = 0u;
    in.values[27] = 0u;
    in.values[28] = 0u;
    in.values[29] = 0u;
    expect(ck10_ascii_encode_read_registers_response(3u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-alarm-history-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-alarm-history-response bytes");
}

static void test_296(void)
{
    static const uint8_t frame[] = {0x01, 0x03, 0x08, 0x3A, 0x00, 0x08, 0x66, 0x61};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_read_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-turns-request opens");
    expect(opened.unit_address == 1u, "example rtu-turns-request: station");
    expect(opened.code == 3u, "example rtu-turns-request: code");
    expect(ck10_read_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-turns-request decodes");
    expect(out.address == 2106u, "example rtu-turns-request: address");
    expect(out.word_count == 8u, "example rtu-turns-request: word_count");
    in.address = 2106u;
    in.word_count = 8u;
    expect(ck10_rtu_encode_read_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-turns-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-turns-request bytes");
}

static void test_297(void)
{
    static const uint8_t frame[] = {0x01, 0x03, 0x10, 0x00, 0x00, 0x70, 0x48, 0x86, 0x0D, 0xDF, 0x79, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x76, 0xD0};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_read_registers_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-turns-response opens");
    expect(opened.unit_address == 1u, "example rtu-turns-response: station");
    expect(opened.code == 3u, "example rtu-turns-response: code");
    expect(opened.error == false, "example rtu-turns-response: error");
    expect(ck10_read_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-turns-response decodes");
    expect(out.values_count == 8u, "example rtu-turns-response: values count");
    expect(out.values[0] == 0u, "example rtu-turns-response: values");
    expect(out.values[1] == 28744u, "example rtu-turns-response: values");
    expect(out.values[2] == 34317u, "example rtu-turns-response: values");
    expect(out.values[3] == 57209u, "example rtu-turns-response: values");
    expect(out.values[4] == 32768u, "example rtu-turns-response: values");
    expect(out.values[5] == 0u, "example rtu-turns-response: values");
    expect(out.values[6] == 0u, "example rtu-turns-response: values");
    expect(out.values[7] == 0u, "example rtu-turns-response: values");
    in.values_count = 8u;
    in.values[0] = 0u;
    in.values[1] = 28744u;
    in.values[2] = 34317u;
    in.values[3] = 57209u;
    in.values[4] = 32768u;
    in.values[5] = 0u;
    in.values[6] = 0u;
    in.values[7] = 0u;
    expect(ck10_rtu_encode_read_registers_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-turns-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-turns-response bytes");
}

static void test_298(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x30, 0x33, 0x30, 0x38, 0x33, 0x41, 0x30, 0x30, 0x30, 0x38, 0x42, 0x32, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_request_frame opened;
    ck10_read_registers_request in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-turns-request opens");
    expect(opened.unit_address == 1u, "example ascii-turns-request: station");
    expect(opened.code == 3u, "example ascii-turns-request: code");
    expect(ck10_read_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-turns-request decodes");
    expect(out.address == 2106u, "example ascii-turns-request: address");
    expect(out.word_count == 8u, "example ascii-turns-request: word_count");
    in.address = 2106u;
    in.word_count = 8u;
    expect(ck10_ascii_encode_read_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-turns-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-turns-request bytes");
}

static void test_299(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x30, 0x33, 0x31, 0x30, 0x30, 0x30, 0x30, 0x30, 0x37, 0x30, 0x34, 0x38, 0x38, 0x36, 0x30, 0x44, 0x44, 0x46, 0x37, 0x39, 0x38, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x43, 0x39, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_response_frame opened;
    ck10_read_registers_response in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_response_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-turns-response opens");
    expect(opened.unit_address == 1u, "example ascii-turns-response: station");
    expect(opened.code == 3u, "example ascii-turns-response: code");
    expect(opened.error == false, "example ascii-turns-response: error");
    expect(ck10_read_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-turns-response decodes");
    expect(out.values_count == 8u, "example ascii-turns-response: values count");
    expect(out.values[0] == 0u, "example ascii-turns-response: values");
    expect(out.values[1] == 28744u, "example ascii-turns-response: values");
    expect(out.values[2] == 34317u, "example ascii-turns-response: values");
    expect(out.values[3] == 57209u, "example ascii-turns-response: values");
    expect(out.values[4] == 32768u, "example ascii-turns-response: values");
    expect(out.values[5] == 0u, "example ascii-turns-response: values");
    expect(out.values[6] == 0u, "example ascii-turns-response: values");
    expect(out.values[7] == 0u, "example ascii-turns-response: values");
    in.values_count = 8u;
    in.values[0] = 0u;
    in.values[1] = 28744u;
    in.values[2] = 34317u;
    in.values[3] = 57209u;
    in.values[4] = 32768u;
    in.values[5] = 0u;
    in.values[6] = 0u;
    in.values[7] = 0u;
    expect(ck10_ascii_encode_read_registers_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-turns-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-turns-response bytes");
}

static void test_300(void)
{
    static const uint8_t frame[] = {0x01, 0x03, 0x08, 0x34, 0x00, 0x06, 0x86, 0x66};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_read_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-controller-request opens");
    expect(opened.unit_address == 1u, "example rtu-controller-request: station");
    expect(opened.code == 3u, "example rtu-controller-request: code");
    expect(ck10_read_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-controller-request decodes");
    expect(out.address == 2100u, "example rtu-controller-request: address");
    expect(out.word_count == 6u, "example rtu-controller-request: word_count");
    in.address = 2100u;
    in.word_count = 6u;
    expect(ck10_rtu_encode_read_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-controller-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-controller-request bytes");
}

static void test_301(void)
{
    static const uint8_t frame[] = {0x01, 0x03, 0x0C, 0x00, 0x00, 0x00, 0x68, 0x00, 0x1F, 0x01, 0x05, 0x00, 0x00, 0x12, 0x67, 0x32, 0xE8};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_read_registers_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-controller-response opens");
    expect(opened.unit_address == 1u, "example rtu-controller-response: station");
    expect(opened.code == 3u, "example rtu-controller-response: code");
    expect(opened.error == false, "example rtu-controller-response: error");
    expect(ck10_read_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-controller-response decodes");
    expect(out.values_count == 6u, "example rtu-controller-response: values count");
    expect(out.values[0] == 0u, "example rtu-controller-response: values");
    expect(out.values[1] == 104u, "example rtu-controller-response: values");
    expect(out.values[2] == 31u, "example rtu-controller-response: values");
    expect(out.values[3] == 261u, "example rtu-controller-response: values");
    expect(out.values[4] == 0u, "example rtu-controller-response: values");
    expect(out.values[5] == 4711u, "example rtu-controller-response: values");
    in.values_count = 6u;
    in.values[0] = 0u;
    in.values[1] = 104u;
    in.values[2] = 31u;
    in.values[3] = 261u;
    in.values[4] = 0u;
    in.values[5] = 4711u;
    expect(ck10_rtu_encode_read_registers_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-controller-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-controller-response bytes");
}

static void test_302(void)
{
    static const uint8_t frame[] = {0x01, 0x03, 0x13, 0x88, 0x00, 0x50, 0xC1, 0x58};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_read_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-parameters-request opens");
    expect(opened.unit_address == 1u, "example rtu-parameters-request: station");
    expect(opened.code == 3u, "example rtu-parameters-request: code");
    expect(ck10_read_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-parameters-request decodes");
    expect(out.address == 5000u, "example rtu-parameters-request: address");
    expect(out.word_count == 80u, "example rtu-parameters-request: word_count");
    in.address = 5000u;
    in.word_count = 80u;
    expect(ck10_rtu_encode_read_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-parameters-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-parameters-request bytes");
}

static void test_303(void)
{
    static const uint8_t frame[] = {0x01, 0x03, 0xA0, 0x00, 0x00, 0x00, 0x00, 0x00, 0x07, 0xA1, 0x20, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x64, 0x00, 0x00, 0x00, 0x64, 0x00, 0x00, 0x00, 0x64, 0x00, 0x00, 0x13, 0x88, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x64, 0x7F, 0xFF, 0xFF, 0xFF, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x02, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x13, 0x88, 0x00, 0x00, 0x03, 0xE8, 0x00, 0x00, 0x00, 0x32, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x04, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x09, 0xC4, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x32, 0x00, 0x00, 0x09, 0xC4, 0x00, 0x00, 0x00, 0xC8, 0x00, 0x00, 0x00, 0x0A, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x05, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x03, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x04, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x00, 0x2C, 0x28};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_read_registers_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-parameters-response opens");
    expect(opened.unit_address == 1u, "example rtu-parameters-response: station");
    expect(opened.code == 3u, "example rtu-parameters-response: code");
    expect(opened.error == false, "example rtu-parameters-response: error");
    expect(ck10_read_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-parameters-response decodes");
    expect(out.values_count == 80u, "example rtu-parameters-response: values count");
    expect(out.values[0] == 0u, "example rtu-parameters-response: values");
    expect(out.values[1] == 0u, "example rtu-parameters-response: values");
    expect(out.values[2] == 7u, "example rtu-parameters-response: values");
    expect(out.values[3] == 41248u, "example rtu-parameters-response: values");
    expect(out.values[4] == 0u, "example rtu-parameters-response: values");
    expect(out.values[5] == 1u, "example rtu-parameters-response: values");
    expect(out.values[6] == 0u, "example rtu-parameters-response: values");
    expect(out.values[7] == 100u, "example rtu-parameters-response: values");
    expect(out.values[8] == 0u, "example rtu-parameters-response: values");
    expect(out.values[9] == 100u, "example rtu-parameters-response: values");
    expect(out.values[10] == 0u, "example rtu-parameters-response: values");
    expect(out.values[11] == 100u, "example rtu-parameters-response: values");
    expect(out.values[12] == 0u, "example rtu-parameters-response: values");
    expect(out.values[13] == 5000u, "example rtu-parameters-response: values");
    expect(out.values[14] == 0u, "example rtu-parameters-response: values");
    expect(out.values[15] == 1u, "example rtu-parameters-response: values");
    expect(out.values[16] == 0u, "example rtu-parameters-response: values");
    expect(out.values[17] == 100u, "example rtu-parameters-response: values");
    expect(out.values[18] == 32767u, "example rtu-parameters-response: values");
    expect(out.values[19] == 65535u, "example rtu-parameters-response: values");
    expect(out.values[20] == 32768u, "example rtu-parameters-response: values");
    expect(out.values[21] == 0u, "example rtu-parameters-response: values");
    expect(out.values[22] == 0u, "example rtu-parameters-response: values");
    expect(out.values[23] == 2u, "example rtu-parameters-response: values");
    expect(out.values[24] == 0u, "example rtu-parameters-response: values");
    expect(out.values[25] == 0u, "example rtu-parameters-response: values");
    expect(out.values[26] == 0u, "example rtu-parameters-response: values");
    expect(out.values[27] == 0u, "example rtu-parameters-response: values");
    expect(out.values[28] == 0u, "example rtu-parameters-response: values");
    expect(out.values[29] == 5000u, "example rtu-parameters-response: values");
    expect(out.values[30] == 0u, "example rtu-parameters-response: values");
    expect(out.values[31] == 1000u, "example rtu-parameters-response: values");
    expect(out.values[32] == 0u, "example rtu-parameters-response: values");
    expect(out.values[33] == 50u, "example rtu-parameters-response: values");
    expect(out.values[34] == 0u, "example rtu-parameters-response: values");
    expect(out.values[35] == 0u, "example rtu-parameters-response: values");
    expect(out.values[36] == 0u, "example rtu-parameters-response: values");
    expect(out.values[37] == 0u, "example rtu-parameters-response: values");
    expect(out.values[38] == 0u, "example rtu-parameters-response: values");
    expect(out.values[39] == 0u, "example rtu-parameters-response: values");
    expect(out.values[40] == 0u, "example rtu-parameters-response: values");
    expect(out.values[41] == 0u, "example rtu-parameters-response: values");
    expect(out.values[42] == 0u, "example rtu-parameters-response: values");
    expect(out.values[43] == 0u, "example rtu-parameters-response: values");
    expect(out.values[44] == 0u, "example rtu-parameters-response: values");
    expect(out.values[45] == 4u, "example rtu-parameters-response: values");
    expect(out.values[46] == 0u, "example rtu-parameters-response: values");
    expect(out.values[47] == 0u, "example rtu-parameters-response: values");
    expect(out.values[48] == 0u, "example rtu-parameters-response: values");
    expect(out.values[49] == 2500u, "example rtu-parameters-response: values");
    expect(out.values[50] == 0u, "example rtu-parameters-response: values");
    expect(out.values[51] == 0u, "example rtu-parameters-response: values");
    expect(out.values[52] == 0u, "example rtu-parameters-response: values");
    expect(out.values[53] == 0u, "example rtu-parameters-response: values");
    expect(out.values[54] == 0u, "example rtu-parameters-response: values");
    expect(out.values[55] == 50u, "example rtu-parameters-response: values");
    expect(out.values[56] == 0u, "example rtu-parameters-response: values");
    expect(out.values[57] == 2500u, "example rtu-parameters-response: values");
    expect(out.values[58] == 0u, "example rtu-parameters-response: values");
    expect(out.values[59] == 200u, "example rtu-parameters-response: values");
    expect(out.values[60] == 0u, "example rtu-parameters-response: values");
    expect(out.values[61] == 10u, "example rtu-parameters-response: values");
    expect(out.values[62] == 0u, "example rtu-parameters-response: values");
    expect(out.values[63] == 0u, "example rtu-parameters-response: values");
    expect(out.values[64] == 0u, "example rtu-parameters-response: values");
    expect(out.values[65] == 5u, "example rtu-parameters-response: values");
    expect(out.values[66] == 0u, "example rtu-parameters-response: values");
    expect(out.values[67] == 0u, "example rtu-parameters-response: values");
    expect(out.values[68] == 0u, "example rtu-parameters-response: values");
    expect(out.values[69] == 0u, "example rtu-parameters-response: values");
    expect(out.values[70] == 0u, "example rtu-parameters-response: values");
    expect(out.values[71] == 3u, "example rtu-parameters-response: values");
    expect(out.values[72] == 0u, "example rtu-parameters-response: values");
    expect(out.values[73] == 0u, "example rtu-parameters-response: values");
    expect(out.values[74] == 0u, "example rtu-parameters-response: values");
    expect(out.values[75] == 4u, "example rtu-parameters-response: values");
    expect(out.values[76] == 0u, "example rtu-parameters-response: values");
    expect(out.values[77] == 1u, "example rtu-parameters-response: values");
    expect(out.values[78] == 0u, "example rtu-parameters-response: values");
    expect(out.values[79] == 0u, "example rtu-parameters-response: values");
    in.values_count = 80u;
    in.values[0] = 0u;
    in.values[1] = 0u;
    in.values[2] = 7u;
    in.values[3] = 41248u;
    in.values[4] = 0u;
    in.values[5] = 1u;
    in.values[6] = 0u;
    in.values[7] = 100u;
    in.values[8] = 0u;
    in.values[9] = 100u;
    in.values[10] = 0u;
    in.values[11] = 100u;
    in.values[12] = 0u;
    in.values[13] = 5000u;
    in.values[14] = 0u;
    in.values[15] = 1u;
    in.values[16] = 0u;
    in.values[17] = 100u;
    in.values[18] = 32767u;
    in.values[19] = 65535u;
    in.values[20] = 32768u;
    in.values[21] = 0u;
    in.values[22] = 0u;
    in.values[23] = 2u;
    in.values[24] = 0u;
    in.values[25] = 0u;
    in.values[26] = 0u;
    in.values[27] = 0u;
    in.values[28] = 0u;
    in.values[29] = 5000u;
    in.values[30] = 0u;
    in.values[31] = 1000u;
    in.values[32] = 0u;
    in.values[33] = 50u;
    in.values[34] = 0u;
    in.values[35] = 0u;
    in.values[36] = 0u;
    in.values[37] = 0u;
    in.values[38] = 0u;
    in.values[39] = 0u;
    in.values[40] = 0u;
    in.values[41] = 0u;
    in.values[42] = 0u;
    in.values[43] = 0u;
    in.values[44] = 0u;
    in.values[45] = 4u;
    in.values[46] = 0u;
    in.values[47] = 0u;
    in.values[48] = 0u;
    in.values[49] = 2500u;
    in.values[50] = 0u;
    in.values[51] = 0u;
    in.values[52] = 0u;
    in.values[53] = 0u;
    in.values[54] = 0u;
    in.values[55] = 50u;
    in.values[56] = 0u;
    in.values[57] = 2500u;
    in.values[58] = 0u;
    in.values[59] = 200u;
    in.values[60] = 0u;
    in.values[61] = 10u;
    in.values[62] = 0u;
    in.values[63] = 0u;
    in.values[64] = 0u;
    in.values[65] = 5u;
    in.values[66] = 0u;
    in.values[67] = 0u;
    in.values[68] = 0u;
    in.values[69] = 0u;
    in.values[70] = 0u;
    in.values[71] = 3u;
    in.values[72] = 0u;
    in.values[73] = 0u;
    in.values[74] = 0u;
    in.values[75] = 4u;
    in.values[76] = 0u;
    in.values[77] = 1u;
    in.values[78] = 0u;
    in.values[79] = 0u;
    expect(ck10_rtu_encode_read_registers_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-parameters-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-parameters-response bytes");
}

static void test_304(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x30, 0x33, 0x31, 0x34, 0x35, 0x30, 0x30, 0x30, 0x35, 0x30, 0x34, 0x38, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_request_frame opened;
    ck10_read_registers_request in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-flash-parameters-request opens");
    expect(opened.unit_address == 1u, "example ascii-flash-parameters-request: station");
    expect(opened.code == 3u, "example ascii-flash-parameters-request: code");
    expect(ck10_read_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-flash-parameters-request decodes");
    expect(out.address == 5200u, "example ascii-flash-parameters-request: address");
    expect(out.word_count == 80u, "example ascii-flash-parameters-request: word_count");
    in.address = 5200u;
    in.word_count = 80u;
    expect(ck10_ascii_encode_read_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-flash-parameters-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-flash-parameters-request bytes");
}

static void test_305(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x30, 0x33, 0x41, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x37, 0x41, 0x31, 0x32, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x31, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x36, 0x34, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x36, 0x34, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x36, 0x34, 0x30, 0x30, 0x30, 0x30, 0x31, 0x33, 0x38, 0x38, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x31, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x36, 0x34, 0x37, 0x46, 0x46, 0x46, 0x46, 0x46, 0x46, 0x46, 0x38, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x32, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x31, 0x33, 0x38, 0x38, 0x30, 0x30, 0x30, 0x30, 0x30, 0x33, 0x45, 0x38, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x33, 0x32, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x34, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x39, 0x43, 0x34, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x33, 0x32, 0x30, 0x30, 0x30, 0x30, 0x30, 0x39, 0x43, 0x34, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x43, 0x38, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x41, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x35, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x33, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x34, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x31, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x32, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_response_frame opened;
    ck10_read_registers_response in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_response_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-flash-parameters-response opens");
    expect(opened.unit_address == 1u, "example ascii-flash-parameters-response: station");
    expect(opened.code == 3u, "example ascii-flash-parameters-response: code");
    expect(opened.error == false, "example ascii-flash-parameters-response: error");
    expect(ck10_read_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-flash-parameters-response decodes");
    expect(out.values_count == 80u, "example ascii-flash-parameters-response: values count");
    expect(out.values[0] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[1] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[2] == 7u, "example ascii-flash-parameters-response: values");
    expect(out.values[3] == 41248u, "example ascii-flash-parameters-response: values");
    expect(out.values[4] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[5] == 1u, "example ascii-flash-parameters-response: values");
    expect(out.values[6] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[7] == 100u, "example ascii-flash-parameters-response: values");
    expect(out.values[8] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[9] == 100u, "example ascii-flash-parameters-response: values");
    expect(out.values[10] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[11] == 100u, "example ascii-flash-parameters-response: values");
    expect(out.values[12] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[13] == 5000u, "example ascii-flash-parameters-response: values");
    expect(out.values[14] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[15] == 1u, "example ascii-flash-parameters-response: values");
    expect(out.values[16] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[17] == 100u, "example ascii-flash-parameters-response: values");
    expect(out.values[18] == 32767u, "example ascii-flash-parameters-response: values");
    expect(out.values[19] == 65535u, "example ascii-flash-parameters-response: values");
    expect(out.values[20] == 32768u, "example ascii-flash-parameters-response: values");
    expect(out.values[21] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[22] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[23] == 2u, "example ascii-flash-parameters-response: values");
    expect(out.values[24] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[25] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[26] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[27] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[28] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[29] == 5000u, "example ascii-flash-parameters-response: values");
    expect(out.values[30] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[31] == 1000u, "example ascii-flash-parameters-response: values");
    expect(out.values[32] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[33] == 50u, "example ascii-flash-parameters-response: values");
    expect(out.values[34] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[35] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[36] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[37] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[38] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[39] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[40] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[41] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[42] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[43] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[44] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[45] == 4u, "example ascii-flash-parameters-response: values");
    expect(out.values[46] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[47] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[48] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[49] == 2500u, "example ascii-flash-parameters-response: values");
    expect(out.values[50] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[51] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[52] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[53] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[54] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[55] == 50u, "example ascii-flash-parameters-response: values");
    expect(out.values[56] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[57] == 2500u, "example ascii-flash-parameters-response: values");
    expect(out.values[58] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[59] == 200u, "example ascii-flash-parameters-response: values");
    expect(out.values[60] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[61] == 10u, "example ascii-flash-parameters-response: values");
    expect(out.values[62] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[63] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[64] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[65] == 5u, "example ascii-flash-parameters-response: values");
    expect(out.values[66] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[67] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[68] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[69] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[70] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[71] == 3u, "example ascii-flash-parameters-response: values");
    expect(out.values[72] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[73] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[74] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[75] == 4u, "example ascii-flash-parameters-response: values");
    expect(out.values[76] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[77] == 1u, "example ascii-flash-parameters-response: values");
    expect(out.values[78] == 0u, "example ascii-flash-parameters-response: values");
    expect(out.values[79] == 0u, "example ascii-flash-parameters-response: values");
    in.values_count = 80u;
    in.values[0] = 0u;
    in.values[1] = 0u;
    in.values[2] = 7u;
    in.values[3] = 41248u;
    in.values[4] = 0u;
    in.values[5] = 1u;
    in.values[6] = 0u;
    in.values[7] = 100u;
    in.values[8] = 0u;
    in.values[9] = 100u;
    in.values[10] = 0u;
    in.values[11] = 100u;
    in.values[12] = 0u;
    in.values[13] = 5000u;
    in.values[14] = 0u;
    in.values[15] = 1u;
    in.values[16] = 0u;
    in.values[17] = 100u;
    in.values[18] = 32767u;
    in.values[19] = 65535u;
    in.values[20] = 32768u;
    in.values[21] = 0u;
    in.values[22] = 0u;
    in.values[23] = 2u;
    in.values[24] = 0u;
    in.values[25] = 0u;
    in.values[26] = 0u;
    in.values[27] = 0u;
    in.values[28] = 0u;
    in.values[29] = 5000u;
    in.values[30] = 0u;
    in.values[31] = 1000u;
    in.values[32] = 0u;
    in.values[33] = 50u;
    in.values[34] = 0u;
    in.values[35] = 0u;
    in.values[36] = 0u;
    in.values[37] = 0u;
    in.values[38] = 0u;
    in.values[39] = 0u;
    in.values[40] = 0u;
    in.values[41] = 0u;
    in.values[42] = 0u;
    in.values[43] = 0u;
    in.values[44] = 0u;
    in.values[45] = 4u;
    in.values[46] = 0u;
    in.values[47] = 0u;
    in.values[48] = 0u;
    in.values[49] = 2500u;
    in.values[50] = 0u;
    in.values[51] = 0u;
    in.values[52] = 0u;
    in.values[53] = 0u;
    in.values[54] = 0u;
    in.values[55] = 50u;
    in.values[56] = 0u;
    in.values[57] = 2500u;
    in.values[58] = 0u;
    in.values[59] = 200u;
    in.values[60] = 0u;
    in.values[61] = 10u;
    in.values[62] = 0u;
    in.values[63] = 0u;
    in.values[64] = 0u;
    in.values[65] = 5u;
    in.values[66] = 0u;
    in.values[67] = 0u;
    in.values[68] = 0u;
    in.values[69] = 0u;
    in.values[70] = 0u;
    in.values[71] = 3u;
    in.values[72] = 0u;
    in.values[73] = 0u;
    in.values[74] = 0u;
    in.values[75] = 4u;
    in.values[76] = 0u;
    in.values[77] = 1u;
    in.values[78] = 0u;
    in.values[79] = 0u;
    expect(ck10_ascii_encode_read_registers_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-flash-parameters-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-flash-parameters-response bytes");
}

static void test_306(void)
{
    static const uint8_t frame[] = {0x01, 0x03, 0x13, 0x9A, 0x00, 0x04, 0x60, 0xA2};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_read_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-soft-limits-request opens");
    expect(opened.unit_address == 1u, "example rtu-soft-limits-request: station");
    expect(opened.code == 3u, "example rtu-soft-limits-request: code");
    expect(ck10_read_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-soft-limits-request decodes");
    expect(out.address == 5018u, "example rtu-soft-limits-request: address");
    expect(out.word_count == 4u, "example rtu-soft-limits-request: word_count");
    in.address = 5018u;
    in.word_count = 4u;
    expect(ck10_rtu_encode_read_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-soft-limits-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-soft-limits-request bytes");
}

static void test_307(void)
{
    static const uint8_t frame[] = {0x01, 0x03, 0x08, 0x7F, 0xFF, 0xFF, 0xFF, 0x80, 0x00, 0x00, 0x00, 0xF4, 0x67};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_read_registers_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-soft-limits-response opens");
    expect(opened.unit_address == 1u, "example rtu-soft-limits-response: station");
    expect(opened.code == 3u, "example rtu-soft-limits-response: code");
    expect(opened.error == false, "example rtu-soft-limits-response: error");
    expect(ck10_read_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-soft-limits-response decodes");
    expect(out.values_count == 4u, "example rtu-soft-limits-response: values count");
    expect(out.values[0] == 32767u, "example rtu-soft-limits-response: values");
    expect(out.values[1] == 65535u, "example rtu-soft-limits-response: values");
    expect(out.values[2] == 32768u, "example rtu-soft-limits-response: values");
    expect(out.values[3] == 0u, "example rtu-soft-limits-response: values");
    in.values_count = 4u;
    in.values[0] = 32767u;
    in.values[1] = 65535u;
    in.values[2] = 32768u;
    in.values[3] = 0u;
    expect(ck10_rtu_encode_read_registers_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-soft-limits-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-soft-limits-response bytes");
}

static void test_308(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x30, 0x33, 0x31, 0x33, 0x39, 0x41, 0x30, 0x30, 0x30, 0x34, 0x34, 0x42, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_request_frame opened;
    ck10_read_registers_request in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-soft-limits-request opens");
    expect(opened.unit_address == 1u, "example ascii-soft-limits-request: station");
    expect(opened.code == 3u, "example ascii-soft-limits-request: code");
    expect(ck10_read_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-soft-limits-request decodes");
    expect(out.address == 5018u, "example ascii-soft-limits-request: address");
    expect(out.word_count == 4u, "example ascii-soft-limits-request: word_count");
    in.address = 5018u;
    in.word_count = 4u;
    expect(ck10_ascii_encode_read_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-soft-limits-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-soft-limits-request bytes");
}

static void test_309(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x30, 0x33, 0x30, 0x38, 0x37, 0x46, 0x46, 0x46, 0x46, 0x46, 0x46, 0x46, 0x38, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x46, 0x38, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_response_frame opened;
    ck10_read_registers_response in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_response_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-soft-limits-response opens");
    expect(opened.unit_address == 1u, "example ascii-soft-limits-response: station");
    expect(opened.code == 3u, "example ascii-soft-limits-response: code");
    expect(opened.error == false, "example ascii-soft-limits-response: error");
    expect(ck10_read_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-soft-limits-response decodes");
    expect(out.values_count == 4u, "example ascii-soft-limits-response: values count");
    expect(out.values[0] == 32767u, "example ascii-soft-limits-response: values");
    expect(out.values[1] == 65535u, "example ascii-soft-limits-response: values");
    expect(out.values[2] == 32768u, "example ascii-soft-limits-response: values");
    expect(out.values[3] == 0u, "example ascii-soft-limits-response: values");
    in.values_count = 4u;
    in.values[0] = 32767u;
    in.values[1] = 65535u;
    in.values[2] = 32768u;
    in.values[3] = 0u;
    expect(ck10_ascii_encode_read_registers_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-soft-limits-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-soft-limits-response bytes");
}

static void test_310(void)
{
    static const uint8_t frame[] = {0x01, 0x03, 0x14, 0xA2, 0x00, 0x18, 0xE1, 0xD2};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_read_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-flash-assignments-request opens");
    expect(opened.unit_address == 1u, "example rtu-flash-assignments-request: station");
    expect(opened.code == 3u, "example rtu-flash-assignments-request: code");
    expect(ck10_read_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-flash-assignments-request decodes");
    expect(out.address == 5282u, "example rtu-flash-assignments-request: address");
    expect(out.word_count == 24u, "example rtu-flash-assignments-request: word_count");
    in.address = 5282u;
    in.word_count = 24u;
    expect(ck10_rtu_encode_read_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-flash-assignments-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-flash-assignments-request bytes");
}

static void test_311(void)
{
    static const uint8_t frame[] = {0x01, 0x03, 0x30, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x02, 0x00, 0x00, 0x00, 0x04, 0x00, 0x00, 0x00, 0x08, 0x00, 0x00, 0x20, 0x00, 0x00, 0x00, 0x40, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x02, 0x00, 0x00, 0x00, 0x20, 0x00, 0x00, 0x08, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x92, 0xD8};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_read_registers_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-flash-assignments-response opens");
    expect(opened.unit_address == 1u, "example rtu-flash-assignments-response: station");
    expect(opened.code == 3u, "example rtu-flash-assignments-response: code");
    expect(opened.error == false, "example rtu-flash-assignments-response: error");
    expect(ck10_read_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-flash-assignments-response decodes");
    expect(out.values_count == 24u, "example rtu-flash-assignments-response: values count");
    expect(out.values[0] == 0u, "example rtu-flash-assignments-response: values");
    expect(out.values[1] == 1u, "example rtu-flash-assignments-response: values");
    expect(out.values[2] == 0u, "example rtu-flash-assignments-response: values");
    expect(out.values[3] == 2u, "example rtu-flash-assignments-response: values");
    expect(out.values[4] == 0u, "example rtu-flash-assignments-response: values");
    expect(out.values[5] == 4u, "example rtu-flash-assignments-response: values");
    expect(out.values[6] == 0u, "example rtu-flash-assignments-response: values");
    expect(out.values[7] == 8u, "example rtu-flash-assignments-response: values");
    expect(out.values[8] == 0u, "example rtu-flash-assignments-response: values");
    expect(out.values[9] == 8192u, "example rtu-flash-assignments-response: values");
    expect(out.values[10] == 0u, "example rtu-flash-assignments-response: values");
    expect(out.values[11] == 16384u, "example rtu-flash-assignments-response: values");
    expect(out.values[12] == 0u, "example rtu-flash-assignments-response: values");
    expect(out.values[13] == 32768u, "example rtu-flash-assignments-response: values");
    expect(out.values[14] == 1u, "example rtu-flash-assignments-response: values");
    expect(out.values[15] == 0u, "example rtu-flash-assignments-response: values");
    expect(out.values[16] == 2u, "example rtu-flash-assignments-response: values");
    expect(out.values[17] == 0u, "example rtu-flash-assignments-response: values");
    expect(out.values[18] == 32u, "example rtu-flash-assignments-response: values");
    expect(out.values[19] == 0u, "example rtu-flash-assignments-response: values");
    expect(out.values[20] == 2048u, "example rtu-flash-assignments-response: values");
    expect(out.values[21] == 0u, "example rtu-flash-assignments-response: values");
    expect(out.values[22] == 32768u, "example rtu-flash-assignments-response: values");
    expect(out.values[23] == 0u, "example rtu-flash-assignments-response: values");
    in.values_count = 24u;
    in.values[0] = 0u;
    in.values[1] = 1u;
    in.values[2] = 0u;
    in.values[3] = 2u;
    in.values[4] = 0u;
    in.values[5] = 4u;
    in.values[6] = 0u;
    in.values[7] = 8u;
    in.values[8] = 0u;
    in.values[9] = 8192u;
    in.values[10] = 0u;
    in.values[11] = 16384u;
    in.values[12] = 0u;
    in.values[13] = 32768u;
    in.values[14] = 1u;
    in.values[15] = 0u;
    in.values[16] = 2u;
    in.values[17] = 0u;
    in.values[18] = 32u;
    in.values[19] = 0u;
    in.values[20] = 2048u;
    in.values[21] = 0u;
    in.values[22] = 32768u;
    in.values[23] = 0u;
    expect(ck10_rtu_encode_read_registers_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-flash-assignments-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-flash-assignments-response bytes");
}

static void test_312(void)
{
    static const uint8_t frame[] = {0x01, 0x03, 0x27, 0x30, 0x00, 0x20, 0x4E, 0xA9};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_read_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-point-1-request opens");
    expect(opened.unit_address == 1u, "example rtu-point-1-request: station");
    expect(opened.code == 3u, "example rtu-point-1-request: code");
    expect(ck10_read_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-point-1-request decodes");
    expect(out.address == 10032u, "example rtu-point-1-request: address");
    expect(out.word_count == 32u, "example rtu-point-1-request: word_count");
    in.address = 10032u;
    in.word_count = 32u;
    expect(ck10_rtu_encode_read_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-point-1-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-point-1-request bytes");
}

static void test_313(void)
{
    static const uint8_t frame[] = {0x01, 0x03, 0x40, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x07, 0xA1, 0x20, 0x27, 0x0F, 0x27, 0x0F, 0x00, 0x03, 0xEA, 0x60, 0x00, 0x00, 0x27, 0x8F, 0xFF, 0xFF, 0x00, 0x7F, 0x00, 0x00, 0x00, 0x64, 0x00, 0x7F, 0x00, 0x17, 0xFF, 0xFF, 0x00, 0x01, 0x80, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x00, 0x5A, 0x00, 0x00, 0x82, 0x35, 0x7F, 0xFF, 0xFF, 0xFF, 0x27, 0x10, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x95, 0xE8};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_read_registers_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-point-1-response opens");
    expect(opened.unit_address == 1u, "example rtu-point-1-response: station");
    expect(opened.code == 3u, "example rtu-point-1-response: code");
    expect(opened.error == false, "example rtu-point-1-response: error");
    expect(ck10_read_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-point-1-response decodes");
    expect(out.values_count == 32u, "example rtu-point-1-response: values count");
    expect(out.values[0] == 32768u, "example rtu-point-1-response: values");
    expect(out.values[1] == 0u, "example rtu-point-1-response: values");
    expect(out.values[2] == 0u, "example rtu-point-1-response: values");
    expect(out.values[3] == 1u, "example rtu-point-1-response: values");
    expect(out.values[4] == 7u, "example rtu-point-1-response: values");
    expect(out.values[5] == 41248u, "example rtu-point-1-response: values");
    expect(out.values[6] == 9999u, "example rtu-point-1-response: values");
    expect(out.values[7] == 9999u, "example rtu-point-1-response: values");
    expect(out.values[8] == 3u, "example rtu-point-1-response: values");
    expect(out.values[9] == 60000u, "example rtu-point-1-response: values");
    expect(out.values[10] == 0u, "example rtu-point-1-response: values");
    expect(out.values[11] == 10127u, "example rtu-point-1-response: values");
    expect(out.values[12] == 65535u, "example rtu-point-1-response: values");
    expect(out.values[13] == 127u, "example rtu-point-1-response: values");
    expect(out.values[14] == 0u, "example rtu-point-1-response: values");
    expect(out.values[15] == 100u, "example rtu-point-1-response: values");
    expect(out.values[16] == 127u, "example rtu-point-1-response: values");
    expect(out.values[17] == 23u, "example rtu-point-1-response: values");
    expect(out.values[18] == 65535u, "example rtu-point-1-response: values");
    expect(out.values[19] == 1u, "example rtu-point-1-response: values");
    expect(out.values[20] == 32768u, "example rtu-point-1-response: values");
    expect(out.values[21] == 0u, "example rtu-point-1-response: values");
    expect(out.values[22] == 65535u, "example rtu-point-1-response: values");
    expect(out.values[23] == 90u, "example rtu-point-1-response: values");
    expect(out.values[24] == 0u, "example rtu-point-1-response: values");
    expect(out.values[25] == 33333u, "example rtu-point-1-response: values");
    expect(out.values[26] == 32767u, "example rtu-point-1-response: values");
    expect(out.values[27] == 65535u, "example rtu-point-1-response: values");
    expect(out.values[28] == 10000u, "example rtu-point-1-response: values");
    expect(out.values[29] == 0u, "example rtu-point-1-response: values");
    expect(out.values[30] == 0u, "example rtu-point-1-response: values");
    expect(out.values[31] == 0u, "example rtu-point-1-response: values");
    in.values_count = 32u;
    in.values[0] = 32768u;
    in.values[1] = 0u;
    in.values[2] = 0u;
    in.values[3] = 1u;
    in.values[4] = 7u;
    in.values[5] = 41248u;
    in.values[6] = 9999u;
    in.values[7] = 9999u;
    in.values[8] = 3u;
    in.values[9] = 60000u;
    in.values[10] = 0u;
    in.values[11] = 10127u;
    in.values[12] = 65535u;
    in.values[13] = 127u;
    in.values[14] = 0u;
    in.values[15] = 100u;
    in.values[16] = 127u;
    in.values[17] = 23u;
    in.values[18] = 65535u;
    in.values[19] = 1u;
    in.values[20] = 32768u;
    in.values[21] = 0u;
    in.values[22] = 65535u;
    in.values[23] = 90u;
    in.values[24] = 0u;
    in.values[25] = 33333u;
    in.values[26] = 32767u;
    in.values[27] = 65535u;
    in.values[28] = 10000u;
    in.values[29] = 0u;
    in.values[30] = 0u;
    in.values[31] = 0u;
    expect(ck10_rtu_encode_read_registers_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-point-1-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-point-1-response bytes");
}

static void test_314(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x30, 0x33, 0x32, 0x37, 0x33, 0x30, 0x30, 0x30, 0x32, 0x30, 0x38, 0x35, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_request_frame opened;
    ck10_read_registers_request in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-point-1-request opens");
    expect(opened.unit_address == 1u, "example ascii-point-1-request: station");
    expect(opened.code == 3u, "example ascii-point-1-request: code");
    expect(ck10_read_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-point-1-request decodes");
    expect(out.address == 10032u, "example ascii-point-1-request: address");
    expect(out.word_count == 32u, "example ascii-point-1-request: word_count");
    in.address = 10032u;
    in.word_count = 32u;
    expect(ck10_ascii_encode_read_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-point-1-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-point-1-request bytes");
}

static void test_315(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x30, 0x33, 0x34, 0x30, 0x38, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x31, 0x30, 0x30, 0x30, 0x37, 0x41, 0x31, 0x32, 0x30, 0x32, 0x37, 0x30, 0x46, 0x32, 0x37, 0x30, 0x46, 0x30, 0x30, 0x30, 0x33, 0x45, 0x41, 0x36, 0x30, 0x30, 0x30, 0x30, 0x30, 0x32, 0x37, 0x38, 0x46, 0x46, 0x46, 0x46, 0x46, 0x30, 0x30, 0x37, 0x46, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x36, 0x34, 0x30, 0x30, 0x37, 0x46, 0x30, 0x30, 0x31, 0x37, 0x46, 0x46, 0x46, 0x46, 0x30, 0x30, 0x30, 0x31, 0x38, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x46, 0x46, 0x46, 0x46, 0x30, 0x30, 0x35, 0x41, 0x30, 0x30, 0x30, 0x30, 0x38, 0x32, 0x33, 0x35, 0x37, 0x46, 0x46, 0x46, 0x46, 0x46, 0x46, 0x46, 0x32, 0x37, 0x31, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x34, 0x43, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_response_frame opened;
    ck10_read_registers_response in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_response_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-point-1-response opens");
    expect(opened.unit_address == 1u, "example ascii-point-1-response: station");
    expect(opened.code == 3u, "example ascii-point-1-response: code");
    expect(opened.error == false, "example ascii-point-1-response: error");
    expect(ck10_read_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-point-1-response decodes");
    expect(out.values_count == 32u, "example ascii-point-1-response: values count");
    expect(out.values[0] == 32768u, "example ascii-point-1-response: values");
    expect(out.values[1] == 0u, "example ascii-point-1-response: values");
    expect(out.values[2] == 0u, "example ascii-point-1-response: values");
    expect(out.values[3] == 1u, "example ascii-point-1-response: values");
    expect(out.values[4] == 7u, "example ascii-point-1-response: values");
    expect(out.values[5] == 41248u, "example ascii-point-1-response: values");
    expect(out.values[6] == 9999u, "example ascii-point-1-response: values");
    expect(out.values[7] == 9999u, "example ascii-point-1-response: values");
    expect(out.values[8] == 3u, "example ascii-point-1-response: values");
    expect(out.values[9] == 60000u, "example ascii-point-1-response: values");
    expect(out.values[10] == 0u, "example ascii-point-1-response: values");
    expect(out.values[11] == 10127u, "example ascii-point-1-response: values");
    expect(out.values[12] == 65535u, "example ascii-point-1-response: values");
    expect(out.values[13] == 127u, "example ascii-point-1-response: values");
    expect(out.values[14] == 0u, "example ascii-point-1-response: values");
    expect(out.values[15] == 100u, "example ascii-point-1-response: values");
    expect(out.values[16] == 127u, "example ascii-point-1-response: values");
    expect(out.values[17] == 23u, "example ascii-point-1-response: values");
    expect(out.values[18] == 65535u, "example ascii-point-1-response: values");
    expect(out.values[19] == 1u, "example ascii-point-1-response: values");
    expect(out.values[20] == 32768u, "example ascii-point-1-response: values");
    expect(out.values[21] == 0u, "example ascii-point-1-response: values");
    expect(out.values[22] == 65535u, "example ascii-point-1-response: values");
    expect(out.values[23] == 90u, "example ascii-point-1-response: values");
    expect(out.values[24] == 0u, "example ascii-point-1-response: values");
    expect(out.values[25] == 33333u, "example ascii-point-1-response: values");
    expect(out.values[26] == 32767u, "example ascii-point-1-response: values");
    expect(out.values[27] == 65535u, "example ascii-point-1-response: values");
    expect(out.values[28] == 10000u, "example ascii-point-1-response: values");
    expect(out.values[29] == 0u, "example ascii-point-1-response: values");
    expect(out.values[30] == 0u, "example ascii-point-1-response: values");
    expect(out.values[31] == 0u, "example ascii-point-1-response: values");
    in.values_count = 32u;
    in.values[0] = 32768u;
    in.values[1] = 0u;
    in.values[2] = 0u;
    in.values[3] = 1u;
    in.values[4] = 7u;
    in.values[5] = 41248u;
    in.values[6] = 9999u;
    in.values[7] = 9999u;
    in.values[8] = 3u;
    in.values[9] = 60000u;
    in.values[10] = 0u;
    in.values[11] = 10127u;
    in.values[12] = 65535u;
    in.values[13] = 127u;
    in.values[14] = 0u;
    in.values[15] = 100u;
    in.values[16] = 127u;
    in.values[17] = 23u;
    in.values[18] = 65535u;
    in.values[19] = 1u;
    in.values[20] = 32768u;
    in.values[21] = 0u;
    in.values[22] = 65535u;
    in.values[23] = 90u;
    in.values[24] = 0u;
    in.values[25] = 33333u;
    in.values[26] = 32767u;
    in.values[27] = 65535u;
    in.values[28] = 10000u;
    in.values[29] = 0u;
    in.values[30] = 0u;
    in.values[31] = 0u;
    expect(ck10_ascii_encode_read_registers_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-point-1-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-point-1-response bytes");
}

static void test_316(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x30, 0x33, 0x33, 0x36, 0x46, 0x30, 0x30, 0x30, 0x32, 0x30, 0x42, 0x36, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_request_frame opened;
    ck10_read_registers_request in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-point-127-request opens");
    expect(opened.unit_address == 1u, "example ascii-point-127-request: station");
    expect(opened.code == 3u, "example ascii-point-127-request: code");
    expect(ck10_read_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-point-127-request decodes");
    expect(out.address == 14064u, "example ascii-point-127-request: address");
    expect(out.word_count == 32u, "example ascii-point-127-request: word_count");
    in.address = 14064u;
    in.word_count = 32u;
    expect(ck10_ascii_encode_read_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-point-127-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-point-127-request bytes");
}

static void test_317(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x30, 0x33, 0x34, 0x30, 0x37, 0x46, 0x46, 0x46, 0x46, 0x46, 0x46, 0x46, 0x30, 0x30, 0x30, 0x30, 0x38, 0x38, 0x42, 0x38, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x31, 0x30, 0x30, 0x30, 0x31, 0x30, 0x30, 0x30, 0x31, 0x46, 0x46, 0x46, 0x46, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x46, 0x46, 0x46, 0x46, 0x46, 0x46, 0x46, 0x46, 0x46, 0x46, 0x46, 0x46, 0x46, 0x46, 0x46, 0x46, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x37, 0x46, 0x30, 0x30, 0x30, 0x30, 0x37, 0x46, 0x46, 0x46, 0x46, 0x46, 0x46, 0x46, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x31, 0x34, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x31, 0x38, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x37, 0x37, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_response_frame opened;
    ck10_read_registers_response in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_response_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-point-127-response opens");
    expect(opened.unit_address == 1u, "example ascii-point-127-response: station");
    expect(opened.code == 3u, "example ascii-point-127-response: code");
    expect(opened.error == false, "example ascii-point-127-response: error");
    expect(ck10_read_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-point-127-response decodes");
    expect(out.values_count == 32u, "example ascii-point-127-response: values count");
    expect(out.values[0] == 32767u, "example ascii-point-127-response: values");
    expect(out.values[1] == 65535u, "example ascii-point-127-response: values");
    expect(out.values[2] == 0u, "example ascii-point-127-response: values");
    expect(out.values[3] == 35000u, "example ascii-point-127-response: values");
    expect(out.values[4] == 0u, "example ascii-point-127-response: values");
    expect(out.values[5] == 1u, "example ascii-point-127-response: values");
    expect(out.values[6] == 1u, "example ascii-point-127-response: values");
    expect(out.values[7] == 1u, "example ascii-point-127-response: values");
    expect(out.values[8] == 65535u, "example ascii-point-127-response: values");
    expect(out.values[9] == 0u, "example ascii-point-127-response: values");
    expect(out.values[10] == 0u, "example ascii-point-127-response: values");
    expect(out.values[11] == 65535u, "example ascii-point-127-response: values");
    expect(out.values[12] == 65535u, "example ascii-point-127-response: values");
    expect(out.values[13] == 65535u, "example ascii-point-127-response: values");
    expect(out.values[14] == 65535u, "example ascii-point-127-response: values");
    expect(out.values[15] == 0u, "example ascii-point-127-response: values");
    expect(out.values[16] == 0u, "example ascii-point-127-response: values");
    expect(out.values[17] == 0u, "example ascii-point-127-response: values");
    expect(out.values[18] == 127u, "example ascii-point-127-response: values");
    expect(out.values[19] == 0u, "example ascii-point-127-response: values");
    expect(out.values[20] == 32767u, "example ascii-point-127-response: values");
    expect(out.values[21] == 65535u, "example ascii-point-127-response: values");
    expect(out.values[22] == 0u, "example ascii-point-127-response: values");
    expect(out.values[23] == 20u, "example ascii-point-127-response: values");
    expect(out.values[24] == 0u, "example ascii-point-127-response: values");
    expect(out.values[25] == 1u, "example ascii-point-127-response: values");
    expect(out.values[26] == 32768u, "example ascii-point-127-response: values");
    expect(out.values[27] == 0u, "example ascii-point-127-response: values");
    expect(out.values[28] == 0u, "example ascii-point-127-response: values");
    expect(out.values[29] == 0u, "example ascii-point-127-response: values");
    expect(out.values[30] == 0u, "example ascii-point-127-response: values");
    expect(out.values[31] == 0u, "example ascii-point-127-response: values");
    in.values_count = 32u;
    in.values[0] = 32767u;
    in.values[1] = 65535u;
    in.values[2] = 0u;
    in.values[3] = 35000u;
    in.values[4] = 0u;
    in.values[5] = 1u;
    in.values[6] = 1u;
    in.values[7] = 1u;
    in.values[8] = 65535u;
    in.values[9] = 0u;
    in.values[10] = 0u;
    in.values[11] = 65535u;
    in.values[12] = 65535u;
    in.values[13] = 65535u;
    in.values[14] = 65535u;
    in.values[15] = 0u;
    in.values[16] = 0u;
    in.values[17] = 0u;
    in.values[18] = 127u;
    in.values[19] = 0u;
    in.values[20] = 32767u;
    in.values[21] = 65535u;
    in.values[22] = 0u;
    in.values[23] = 20u;
    in.values[24] = 0u;
    in.values[25] = 1u;
    in.values[26] = 32768u;
    in.values[27] = 0u;
    in.values[28] = 0u;
    in.values[29] = 0u;
    in.values[30] = 0u;
    in.values[31] = 0u;
    expect(ck10_ascii_encode_read_registers_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-point-127-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-point-127-response bytes");
}

static void test_318(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x30, 0x33, 0x34, 0x45, 0x32, 0x30, 0x30, 0x30, 0x32, 0x30, 0x36, 0x45, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_request_frame opened;
    ck10_read_registers_request in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-flash-point-0-request opens");
    expect(opened.unit_address == 1u, "example ascii-flash-point-0-request: station");
    expect(opened.code == 3u, "example ascii-flash-point-0-request: code");
    expect(ck10_read_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-flash-point-0-request decodes");
    expect(out.address == 20000u, "example ascii-flash-point-0-request: address");
    expect(out.word_count == 32u, "example ascii-flash-point-0-request: word_count");
    in.address = 20000u;
    in.word_count = 32u;
    expect(ck10_ascii_encode_read_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-flash-point-0-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-flash-point-0-request bytes");
}

static void test_319(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x30, 0x33, 0x34, 0x30, 0x38, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x31, 0x30, 0x30, 0x30, 0x37, 0x41, 0x31, 0x32, 0x30, 0x32, 0x37, 0x30, 0x46, 0x32, 0x37, 0x30, 0x46, 0x30, 0x30, 0x30, 0x33, 0x45, 0x41, 0x36, 0x30, 0x30, 0x30, 0x30, 0x30, 0x32, 0x37, 0x38, 0x46, 0x46, 0x46, 0x46, 0x46, 0x30, 0x30, 0x37, 0x46, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x36, 0x34, 0x30, 0x30, 0x37, 0x46, 0x30, 0x30, 0x31, 0x37, 0x46, 0x46, 0x46, 0x46, 0x30, 0x30, 0x30, 0x31, 0x38, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x46, 0x46, 0x46, 0x46, 0x30, 0x30, 0x35, 0x41, 0x30, 0x30, 0x30, 0x30, 0x38, 0x32, 0x33, 0x35, 0x37, 0x46, 0x46, 0x46, 0x46, 0x46, 0x46, 0x46, 0x32, 0x37, 0x31, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x34, 0x43, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_response_frame opened;
    ck10_read_registers_response in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_response_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-flash-point-0-response opens");
    expect(opened.unit_address == 1u, "example ascii-flash-point-0-response: station");
    expect(opened.code == 3u, "example ascii-flash-point-0-response: code");
    expect(opened.error == false, "example ascii-flash-point-0-response: error");
    expect(ck10_read_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-flash-point-0-response decodes");
    expect(out.values_count == 32u, "example ascii-flash-point-0-response: values count");
    expect(out.values[0] == 32768u, "example ascii-flash-point-0-response: values");
    expect(out.values[1] == 0u, "example ascii-flash-point-0-response: values");
    expect(out.values[2] == 0u, "example ascii-flash-point-0-response: values");
    expect(out.values[3] == 1u, "example ascii-flash-point-0-response: values");
    expect(out.values[4] == 7u, "example ascii-flash-point-0-response: values");
    expect(out.values[5] == 41248u, "example ascii-flash-point-0-response: values");
    expect(out.values[6] == 9999u, "example ascii-flash-point-0-response: values");
    expect(out.values[7] == 9999u, "example ascii-flash-point-0-response: values");
    expect(out.values[8] == 3u, "example ascii-flash-point-0-response: values");
    expect(out.values[9] == 60000u, "example ascii-flash-point-0-response: values");
    expect(out.values[10] == 0u, "example ascii-flash-point-0-response: values");
    expect(out.values[11] == 10127u, "example ascii-flash-point-0-response: values");
    expect(out.values[12] == 65535u, "example ascii-flash-point-0-response: values");
    expect(out.values[13] == 127u, "example ascii-flash-point-0-response: values");
    expect(out.values[14] == 0u, "example ascii-flash-point-0-response: values");
    expect(out.values[15] == 100u, "example ascii-flash-point-0-response: values");
    expect(out.values[16] == 127u, "example ascii-flash-point-0-response: values");
    expect(out.values[17] == 23u, "example ascii-flash-point-0-response: values");
    expect(out.values[18] == 65535u, "example ascii-flash-point-0-response: values");
    expect(out.values[19] == 1u, "example ascii-flash-point-0-response: values");
    expect(out.values[20] == 32768u, "example ascii-flash-point-0-response: values");
    expect(out.values[21] == 0u, "example ascii-flash-point-0-response: values");
    expect(out.values[22] == 65535u, "example ascii-flash-point-0-response: values");
    expect(out.values[23] == 90u, "example ascii-flash-point-0-response: values");
    expect(out.values[24] == 0u, "example ascii-flash-point-0-response: values");
    expect(out.values[25] == 33333u, "example ascii-flash-point-0-response: values");
    expect(out.values[26] == 32767u, "example ascii-flash-point-0-response: values");
    expect(out.values[27] == 65535u, "example ascii-flash-point-0-response: values");
    expect(out.values[28] == 10000u, "example ascii-flash-point-0-response: values");
    expect(out.values[29] == 0u, "example ascii-flash-point-0-response: values");
    expect(out.values[30] == 0u, "example ascii-flash-point-0-response: values");
    expect(out.values[31] == 0u, "example ascii-flash-point-0-response: values");
    in.values_count = 32u;
    in.values[0] = 32768u;
    in.values[1] = 0u;
    in.values[2] = 0u;
    in.values[3] = 1u;
    in.values[4] = 7u;
    in.values[5] = 41248u;
    in.values[6] = 9999u;
    in.values[7] = 9999u;
    in.values[8] = 3u;
    in.values[9] = 60000u;
    in.values[10] = 0u;
    in.values[11] = 10127u;
    in.values[12] = 65535u;
    in.values[13] = 127u;
    in.values[14] = 0u;
    in.values[15] = 100u;
    in.values[16] = 127u;
    in.values[17] = 23u;
    in.values[18] = 65535u;
    in.values[19] = 1u;
    in.values[20] = 32768u;
    in.values[21] = 0u;
    in.values[22] = 65535u;
    in.values[23] = 90u;
    in.values[24] = 0u;
    in.values[25] = 33333u;
    in.values[26] = 32767u;
    in.values[27] = 65535u;
    in.values[28] = 10000u;
    in.values[29] = 0u;
    in.values[30] = 0u;
    in.values[31] = 0u;
    expect(ck10_ascii_encode_read_registers_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-flash-point-0-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-flash-point-0-response bytes");
}

static void test_320(void)
{
    static const uint8_t frame[] = {0x01, 0x03, 0x5E, 0x00, 0x00, 0x20, 0x57, 0xFA};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_read_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-flash-point-127-request opens");
    expect(opened.unit_address == 1u, "example rtu-flash-point-127-request: station");
    expect(opened.code == 3u, "example rtu-flash-point-127-request: code");
    expect(ck10_read_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-flash-point-127-request decodes");
    expect(out.address == 24064u, "example rtu-flash-point-127-request: address");
    expect(out.word_count == 32u, "example rtu-flash-point-127-request: word_count");
    in.address = 24064u;
    in.word_count = 32u;
    expect(ck10_rtu_encode_read_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-flash-point-127-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-flash-point-127-request bytes");
}

static void test_321(void)
{
    static const uint8_t frame[] = {0x01, 0x03, 0x40, 0x7F, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x88, 0xB8, 0x00, 0x00, 0x00, 0x01, 0x00, 0x01, 0x00, 0x01, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x7F, 0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x14, 0x00, 0x00, 0x00, 0x01, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x4C, 0x02};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_read_registers_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-flash-point-127-response opens");
    expect(opened.unit_address == 1u, "example rtu-flash-point-127-response: station");
    expect(opened.code == 3u, "example rtu-flash-point-127-response: code");
    expect(opened.error == false, "example rtu-flash-point-127-response: error");
    expect(ck10_read_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-flash-point-127-response decodes");
    expect(out.values_count == 32u, "example rtu-flash-point-127-response: values count");
    expect(out.values[0] == 32767u, "example rtu-flash-point-127-response: values");
    expect(out.values[1] == 65535u, "example rtu-flash-point-127-response: values");
    expect(out.values[2] == 0u, "example rtu-flash-point-127-response: values");
    expect(out.values[3] == 35000u, "example rtu-flash-point-127-response: values");
    expect(out.values[4] == 0u, "example rtu-flash-point-127-response: values");
    expect(out.values[5] == 1u, "example rtu-flash-point-127-response: values");
    expect(out.values[6] == 1u, "example rtu-flash-point-127-response: values");
    expect(out.values[7] == 1u, "example rtu-flash-point-127-response: values");
    expect(out.values[8] == 65535u, "example rtu-flash-point-127-response: values");
    expect(out.values[9] == 0u, "example rtu-flash-point-127-response: values");
    expect(out.values[10] == 0u, "example rtu-flash-point-127-response: values");
    expect(out.values[11] == 65535u, "example rtu-flash-point-127-response: values");
    expect(out.values[12] == 65535u, "example rtu-flash-point-127-response: values");
    expect(out.values[13] == 65535u, "example rtu-flash-point-127-response: values");
    expect(out.values[14] == 65535u, "example rtu-flash-point-127-response: values");
    expect(out.values[15] == 0u, "example rtu-flash-point-127-response: values");
    expect(out.values[16] == 0u, "example rtu-flash-point-127-response: values");
    expect(out.values[17] == 0u, "example rtu-flash-point-127-response: values");
    expect(out.values[18] == 127u, "example rtu-flash-point-127-response: values");
    expect(out.values[19] == 0u, "example rtu-flash-point-127-response: values");
    expect(out.values[20] == 32767u, "example rtu-flash-point-127-response: values");
    expect(out.values[21] == 65535u, "example rtu-flash-point-127-response: values");
    expect(out.values[22] == 0u, "example rtu-flash-point-127-response: values");
    expect(out.values[23] == 20u, "example rtu-flash-point-127-response: values");
    expect(out.values[24] == 0u, "example rtu-flash-point-127-response: values");
    expect(out.values[25] == 1u, "example rtu-flash-point-127-response: values");
    expect(out.values[26] == 32768u, "example rtu-flash-point-127-response: values");
    expect(out.values[27] == 0u, "example rtu-flash-point-127-response: values");
    expect(out.values[28] == 0u, "example rtu-flash-point-127-response: values");
    expect(out.values[29] == 0u, "example rtu-flash-point-127-response: values");
    expect(out.values[30] == 0u, "example rtu-flash-point-127-response: values");
    expect(out.values[31] == 0u, "example rtu-flash-point-127-response: values");
    in.values_count = 32u;
    in.values[0] = 32767u;
    in.values[1] = 65535u;
    in.values[2] = 0u;
    in.values[3] = 35000u;
    in.values[4] = 0u;
    in.values[5] = 1u;
    in.values[6] = 1u;
    in.values[7] = 1u;
    in.values[8] = 65535u;
    in.values[9] = 0u;
    in.values[10] = 0u;
    in.values[11] = 65535u;
    in.values[12] = 65535u;
    in.values[13] = 65535u;
    in.values[14] = 65535u;
    in.values[15] = 0u;
    in.values[16] = 0u;
    in.values[17] = 0u;
    in.values[18] = 127u;
    in.values[19] = 0u;
    in.values[20] = 32767u;
    in.values[21] = 65535u;
    in.values[22] = 0u;
    in.values[23] = 20u;
    in.values[24] = 0u;
    in.values[25] = 1u;
    in.values[26] = 32768u;
    in.values[27] = 0u;
    in.values[28] = 0u;
    in.values[29] = 0u;
    in.values[30] = 0u;
    in.values[31] = 0u;
    expect(ck10_rtu_encode_read_registers_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-flash-point-127-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-flash-point-127-response bytes");
}

static void test_322(void)
{
    static const uint8_t frame[] = {0x3A, 0x31, 0x30, 0x31, 0x31, 0x44, 0x46, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_request_frame opened;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-identity-request opens");
    expect(opened.unit_address == 16u, "example ascii-identity-request: station");
    expect(opened.code == 17u, "example ascii-identity-request: code");
    expect(ck10_report_server_id_request_decode(opened.body, opened.body_length) == CK10_OK, "example ascii-identity-request decodes");
    expect(ck10_ascii_encode_report_server_id_request(16u, again, sizeof again, &length) == CK10_OK, "example ascii-identity-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-identity-request bytes");
}

static void test_323(void)
{
    static const uint8_t frame[] = {0x3A, 0x31, 0x30, 0x31, 0x31, 0x30, 0x32, 0x36, 0x38, 0x46, 0x46, 0x37, 0x36, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_response_frame opened;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_response_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-identity-response opens");
    expect(opened.unit_address == 16u, "example ascii-identity-response: station");
    expect(opened.code == 17u, "example ascii-identity-response: code");
    expect(opened.error == false, "example ascii-identity-response: error");
    expect(ck10_report_server_id_response_decode(opened.body, opened.body_length) == CK10_OK, "example ascii-identity-response decodes");
    expect(ck10_ascii_encode_report_server_id_response(16u, again, sizeof again, &length) == CK10_OK, "example ascii-identity-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-identity-response bytes");
}

static void test_324(void)
{
    static const uint8_t frame[] = {0x01, 0x04, 0x03, 0xE8, 0x00, 0x02, 0xF1, 0xBB};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_ERR_UNKNOWN_CODE, "example rtu-unknown-function-request");
}

static void test_325(void)
{
    static const uint8_t frame[] = {0x01, 0x84, 0x01, 0x82, 0xC0};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_exception in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-unknown-function-response opens");
    expect(opened.unit_address == 1u, "example rtu-unknown-function-response: station");
    expect(opened.code == 4u, "example rtu-unknown-function-response: code");
    expect(opened.error == true, "example rtu-unknown-function-response: error");
    expect(ck10_exception_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-unknown-function-response decodes");
    expect(out.exception_code == 1u, "example rtu-unknown-function-response: exception_code");
    in.exception_code = 1u;
    expect(ck10_rtu_encode_exception_response(1u, 4u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-unknown-function-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-unknown-function-response bytes");
}

static void test_326(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x30, 0x34, 0x30, 0x33, 0x45, 0x38, 0x30, 0x30, 0x30, 0x32, 0x30, 0x45, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_request_frame opened;
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_ERR_UNKNOWN_CODE, "example ascii-unknown-function-request");
}

static void test_327(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x38, 0x34, 0x30, 0x31, 0x37, 0x41, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_response_frame opened;
    ck10_exception in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_response_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-unknown-function-response opens");
    expect(opened.unit_address == 1u, "example ascii-unknown-function-response: station");
    expect(opened.code == 4u, "example ascii-unknown-function-response: code");
    expect(opened.error == true, "example ascii-unknown-function-response: error");
    expect(ck10_exception_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-unknown-function-response decodes");
    expect(out.exception_code == 1u, "example ascii-unknown-function-response: exception_code");
    in.exception_code = 1u;
    expect(ck10_ascii_encode_exception_response(1u, 4u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-unknown-function-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-unknown-function-response bytes");
}

static void test_328(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x03, 0xEA, 0x00, 0x02, 0x04, 0x00, 0x00, 0x00, 0x00, 0x69, 0x68};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-write-read-only-request opens");
    expect(opened.unit_address == 1u, "example rtu-write-read-only-request: station");
    expect(opened.code == 16u, "example rtu-write-read-only-request: code");
    expect(ck10_write_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-write-read-only-request decodes");
    expect(out.address == 1002u, "example rtu-write-read-only-request: address");
    expect(out.values_count == 2u, "example rtu-write-read-only-request: values count");
    expect(out.values[0] == 0u, "example rtu-write-read-only-request: values");
    expect(out.values[1] == 0u, "example rtu-write-read-only-request: values");
    in.address = 1002u;
    in.values_count = 2u;
    in.values[0] = 0u;
    in.values[1] = 0u;
    expect(ck10_rtu_encode_write_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-write-read-only-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-write-read-only-request bytes");
}

static void test_329(void)
{
    static const uint8_t frame[] = {0x01, 0x90, 0x02, 0xCD, 0xC1};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_exception in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-write-read-only-response opens");
    expect(opened.unit_address == 1u, "example rtu-write-read-only-response: station");
    expect(opened.code == 16u, "example rtu-write-read-only-response: code");
    expect(opened.error == true, "example rtu-write-read-only-response: error");
    expect(ck10_exception_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-write-read-only-response decodes");
    expect(out.exception_code == 2u, "example rtu-write-read-only-response: exception_code");
    in.exception_code = 2u;
    expect(ck10_rtu_encode_exception_response(1u, 16u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-write-read-only-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-write-read-only-response bytes");
}

static void test_330(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x13, 0xAA, 0x00, 0x02, 0x04, 0x00, 0x00, 0x00, 0x08, 0xA1, 0x5E};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-value-refused-request opens");
    expect(opened.unit_address == 1u, "example rtu-value-refused-request: station");
    expect(opened.code == 16u, "example rtu-value-refused-request: code");
    expect(ck10_write_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-value-refused-request decodes");
    expect(out.address == 5034u, "example rtu-value-refused-request: address");
    expect(out.values_count == 2u, "example rtu-value-refused-request: values count");
    expect(out.values[0] == 0u, "example rtu-value-refused-request: values");
    expect(out.values[1] == 8u, "example rtu-value-refused-request: values");
    in.address = 5034u;
    in.values_count = 2u;
    in.values[0] = 0u;
    in.values[1] = 8u;
    expect(ck10_rtu_encode_write_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-value-refused-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-value-refused-request bytes");
}

static void test_331(void)
{
    static const uint8_t frame[] = {0x01, 0x90, 0x03, 0x0C, 0x01};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_exception in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-value-refused-response opens");
    expect(opened.unit_address == 1u, "example rtu-value-refused-response: station");
    expect(opened.code == 16u, "example rtu-value-refused-response: code");
    expect(opened.error == true, "example rtu-value-refused-response: error");
    expect(ck10_exception_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-value-refused-response decodes");
    expect(out.exception_code == 3u, "example rtu-value-refused-response: exception_code");
    in.exception_code = 3u;
    expect(ck10_rtu_encode_exception_response(1u, 16u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-value-refused-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-value-refused-response bytes");
}

static void test_332(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x07, 0xD8, 0x00, 0x02, 0x89, 0x44};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_write_register_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-device-failure-request opens");
    expect(opened.unit_address == 1u, "example rtu-device-failure-request: station");
    expect(opened.code == 6u, "example rtu-device-failure-request: code");
    expect(ck10_write_register_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-device-failure-request decodes");
    expect(out.address == 2008u, "example rtu-device-failure-request: address");
    expect(out.value == 2u, "example rtu-device-failure-request: value");
    in.address = 2008u;
    in.value = 2u;
    expect(ck10_rtu_encode_write_register_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-device-failure-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-device-failure-request bytes");
}

static void test_333(void)
{
    static const uint8_t frame[] = {0x01, 0x86, 0x04, 0x43, 0xA3};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_exception in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-device-failure-response opens");
    expect(opened.unit_address == 1u, "example rtu-device-failure-response: station");
    expect(opened.code == 6u, "example rtu-device-failure-response: code");
    expect(opened.error == true, "example rtu-device-failure-response: error");
    expect(ck10_exception_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-device-failure-response decodes");
    expect(out.exception_code == 4u, "example rtu-device-failure-response: exception_code");
    in.exception_code = 4u;
    expect(ck10_rtu_encode_exception_response(1u, 6u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-device-failure-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-device-failure-response bytes");
}

static void test_334(void)
{
    static const uint8_t frame[] = {0x01, 0x03, 0x60, 0x00, 0x00, 0x01, 0x9A, 0x0A};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_read_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-read-nothing-request opens");
    expect(opened.unit_address == 1u, "example rtu-read-nothing-request: station");
    expect(opened.code == 3u, "example rtu-read-nothing-request: code");
    expect(ck10_read_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-read-nothing-request decodes");
    expect(out.address == 24576u, "example rtu-read-nothing-request: address");
    expect(out.word_count == 1u, "example rtu-read-nothing-request: word_count");
    in.address = 24576u;
    in.word_count = 1u;
    expect(ck10_rtu_encode_read_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-read-nothing-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-read-nothing-request bytes");
}

static void test_335(void)
{
    static const uint8_t frame[] = {0x01, 0x83, 0x02, 0xC0, 0xF1};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_exception in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-read-nothing-response opens");
    expect(opened.unit_address == 1u, "example rtu-read-nothing-response: station");
    expect(opened.code == 3u, "example rtu-read-nothing-response: code");
    expect(opened.error == true, "example rtu-read-nothing-response: error");
    expect(ck10_exception_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-read-nothing-response decodes");
    expect(out.exception_code == 2u, "example rtu-read-nothing-response: exception_code");
    in.exception_code = 2u;
    expect(ck10_rtu_encode_exception_response(1u, 3u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-read-nothing-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-read-nothing-response bytes");
}

static void test_336(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x31, 0x30, 0x30, 0x33, 0x45, 0x41, 0x30, 0x30, 0x30, 0x32, 0x30, 0x34, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x46, 0x43, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_request_frame opened;
    ck10_write_registers_request in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-write-read-only-request opens");
    expect(opened.unit_address == 1u, "example ascii-write-read-only-request: station");
    expect(opened.code == 16u, "example ascii-write-read-only-request: code");
    expect(ck10_write_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-write-read-only-request decodes");
    expect(out.address == 1002u, "example ascii-write-read-only-request: address");
    expect(out.values_count == 2u, "example ascii-write-read-only-request: values count");
    expect(out.values[0] == 0u, "example ascii-write-read-only-request: values");
    expect(out.values[1] == 0u, "example ascii-write-read-only-request: values");
    in.address = 1002u;
    in.values_count = 2u;
    in.values[0] = 0u;
    in.values[1] = 0u;
    expect(ck10_ascii_encode_write_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-write-read-only-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-write-read-only-request bytes");
}

static void test_337(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x39, 0x30, 0x30, 0x32, 0x36, 0x44, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_response_frame opened;
    ck10_exception in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_response_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-write-read-only-response opens");
    expect(opened.unit_address == 1u, "example ascii-write-read-only-response: station");
    expect(opened.code == 16u, "example ascii-write-read-only-response: code");
    expect(opened.error == true, "example ascii-write-read-only-response: error");
    expect(ck10_exception_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-write-read-only-response decodes");
    expect(out.exception_code == 2u, "example ascii-write-read-only-response: exception_code");
    in.exception_code = 2u;
    expect(ck10_ascii_encode_exception_response(1u, 16u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-write-read-only-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-write-read-only-response bytes");
}

static void test_338(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x31, 0x30, 0x31, 0x33, 0x41, 0x41, 0x30, 0x30, 0x30, 0x32, 0x30, 0x34, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x38, 0x32, 0x34, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_request_frame opened;
    ck10_write_registers_request in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-value-refused-request opens");
    expect(opened.unit_address == 1u, "example ascii-value-refused-request: station");
    expect(opened.code == 16u, "example ascii-value-refused-request: code");
    expect(ck10_write_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-value-refused-request decodes");
    expect(out.address == 5034u, "example ascii-value-refused-request: address");
    expect(out.values_count == 2u, "example ascii-value-refused-request: values count");
    expect(out.values[0] == 0u, "example ascii-value-refused-request: values");
    expect(out.values[1] == 8u, "example ascii-value-refused-request: values");
    in.address = 5034u;
    in.values_count = 2u;
    in.values[0] = 0u;
    in.values[1] = 8u;
    expect(ck10_ascii_encode_write_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-value-refused-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-value-refused-request bytes");
}

static void test_339(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x39, 0x30, 0x30, 0x33, 0x36, 0x43, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_response_frame opened;
    ck10_exception in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_response_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-value-refused-response opens");
    expect(opened.unit_address == 1u, "example ascii-value-refused-response: station");
    expect(opened.code == 16u, "example ascii-value-refused-response: code");
    expect(opened.error == true, "example ascii-value-refused-response: error");
    expect(ck10_exception_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-value-refused-response decodes");
    expect(out.exception_code == 3u, "example ascii-value-refused-response: exception_code");
    in.exception_code = 3u;
    expect(ck10_ascii_encode_exception_response(1u, 16u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-value-refused-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-value-refused-response bytes");
}

static void test_340(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x30, 0x36, 0x30, 0x37, 0x44, 0x38, 0x30, 0x30, 0x30, 0x32, 0x31, 0x38, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_request_frame opened;
    ck10_write_register_request in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-device-failure-request opens");
    expect(opened.unit_address == 1u, "example ascii-device-failure-request: station");
    expect(opened.code == 6u, "example ascii-device-failure-request: code");
    expect(ck10_write_register_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-device-failure-request decodes");
    expect(out.address == 2008u, "example ascii-device-failure-request: address");
    expect(out.value == 2u, "example ascii-device-failure-request: value");
    in.address = 2008u;
    in.value = 2u;
    expect(ck10_ascii_encode_write_register_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-device-failure-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-device-failure-request bytes");
}

static void test_341(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x38, 0x36, 0x30, 0x34, 0x37, 0x35, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_response_frame opened;
    ck10_exception in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_response_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-device-failure-response opens");
    expect(opened.unit_address == 1u, "example ascii-device-failure-response: station");
    expect(opened.code == 6u, "example ascii-device-failure-response: code");
    expect(opened.error == true, "example ascii-device-failure-response: error");
    expect(ck10_exception_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-device-failure-response decodes");
    expect(out.exception_code == 4u, "example ascii-device-failure-response: exception_code");
    in.exception_code = 4u;
    expect(ck10_ascii_encode_exception_response(1u, 6u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-device-failure-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-device-failure-response bytes");
}

static void test_342(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x30, 0x33, 0x36, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x31, 0x39, 0x42, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_request_frame opened;
    ck10_read_registers_request in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-read-nothing-request opens");
    expect(opened.unit_address == 1u, "example ascii-read-nothing-request: station");
    expect(opened.code == 3u, "example ascii-read-nothing-request: code");
    expect(ck10_read_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-read-nothing-request decodes");
    expect(out.address == 24576u, "example ascii-read-nothing-request: address");
    expect(out.word_count == 1u, "example ascii-read-nothing-request: word_count");
    in.address = 24576u;
    in.word_count = 1u;
    expect(ck10_ascii_encode_read_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-read-nothing-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-read-nothing-request bytes");
}

static void test_343(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x38, 0x33, 0x30, 0x32, 0x37, 0x41, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_response_frame opened;
    ck10_exception in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_response_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-read-nothing-response opens");
    expect(opened.unit_address == 1u, "example ascii-read-nothing-response: station");
    expect(opened.code == 3u, "example ascii-read-nothing-response: code");
    expect(opened.error == true, "example ascii-read-nothing-response: error");
    expect(ck10_exception_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-read-nothing-response decodes");
    expect(out.exception_code == 2u, "example ascii-read-nothing-response: exception_code");
    in.exception_code = 2u;
    expect(ck10_ascii_encode_exception_response(1u, 3u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-read-nothing-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-read-nothing-response bytes");
}

static void test_344(void)
{
    static const uint8_t frame[] = {0x01, 0x91, 0x04, 0x4C, 0x53};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_exception in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-identity-refused opens");
    expect(opened.unit_address == 1u, "example rtu-identity-refused: station");
    expect(opened.code == 17u, "example rtu-identity-refused: code");
    expect(opened.error == true, "example rtu-identity-refused: error");
    expect(ck10_exception_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-identity-refused decodes");
    expect(out.exception_code == 4u, "example rtu-identity-refused: exception_code");
    in.exception_code = 4u;
    expect(ck10_rtu_encode_exception_response(1u, 17u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-identity-refused encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-identity-refused bytes");
}

static void test_345(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x27, 0x30, 0x00, 0x20, 0x40, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x07, 0xA1, 0x20, 0x27, 0x0F, 0x27, 0x0F, 0x00, 0x03, 0xEA, 0x60, 0x00, 0x00, 0x27, 0x8F, 0xFF, 0xFF, 0x00, 0x7F, 0x00, 0x00, 0x00, 0x64, 0x00, 0x7F, 0x00, 0x17, 0xFF, 0xFF, 0x00, 0x01, 0x80, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x00, 0x5A, 0x00, 0x00, 0x82, 0x35, 0x7F, 0xFF, 0xFF, 0xFF, 0x27, 0x10, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x71, 0x66};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-point-1-write-request opens");
    expect(opened.unit_address == 1u, "example rtu-point-1-write-request: station");
    expect(opened.code == 16u, "example rtu-point-1-write-request: code");
    expect(ck10_write_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-point-1-write-request decodes");
    expect(out.address == 10032u, "example rtu-point-1-write-request: address");
    expect(out.values_count == 32u, "example rtu-point-1-write-request: values count");
    expect(out.values[0] == 32768u, "example rtu-point-1-write-request: values");
    expect(out.values[1] == 0u, "example rtu-point-1-write-request: values");
    expect(out.values[2] == 0u, "example rtu-point-1-write-request: values");
    expect(out.values[3] == 1u, "example rtu-point-1-write-request: values");
    expect(out.values[4] == 7u, "example rtu-point-1-write-request: values");
    expect(out.values[5] == 41248u, "example rtu-point-1-write-request: values");
    expect(out.values[6] == 9999u, "example rtu-point-1-write-request: values");
    expect(out.values[7] == 9999u, "example rtu-point-1-write-request: values");
    expect(out.values[8] == 3u, "example rtu-point-1-write-request: values");
    expect(out.values[9] == 60000u, "example rtu-point-1-write-request: values");
    expect(out.values[10] == 0u, "example rtu-point-1-write-request: values");
    expect(out.values[11] == 10127u, "example rtu-point-1-write-request: values");
    expect(out.values[12] == 65535u, "example rtu-point-1-write-request: values");
    expect(out.values[13] == 127u, "example rtu-point-1-write-request: values");
    expect(out.values[14] == 0u, "example rtu-point-1-write-request: values");
    expect(out.values[15] == 100u, "example rtu-point-1-write-request: values");
    expect(out.values[16] == 127u, "example rtu-point-1-write-request: values");
    expect(out.values[17] == 23u, "example rtu-point-1-write-request: values");
    expect(out.values[18] == 65535u, "example rtu-point-1-write-request: values");
    expect(out.values[19] == 1u, "example rtu-point-1-write-request: values");
    expect(out.values[20] == 32768u, "example rtu-point-1-write-request: values");
    expect(out.values[21] == 0u, "example rtu-point-1-write-request: values");
    expect(out.values[22] == 65535u, "example rtu-point-1-write-request: values");
    expect(out.values[23] == 90u, "example rtu-point-1-write-request: values");
    expect(out.values[24] == 0u, "example rtu-point-1-write-request: values");
    expect(out.values[25] == 33333u, "example rtu-point-1-write-request: values");
    expect(out.values[26] == 32767u, "example rtu-point-1-write-request: values");
    expect(out.values[27] == 65535u, "example rtu-point-1-write-request: values");
    expect(out.values[28] == 10000u, "example rtu-point-1-write-request: values");
    expect(out.values[29] == 0u, "example rtu-point-1-write-request: values");
    expect(out.values[30] == 0u, "example rtu-point-1-write-request: values");
    expect(out.values[31] == 0u, "example rtu-point-1-write-request: values");
    in.address = 10032u;
    in.values_count = 32u;
    in.values[0] = 32768u;
    in.values[1] = 0u;
    in.values[2] = 0u;
    in.values[3] = 1u;
    in.values[4] = 7u;
    in.values[5] = 41248u;
    in.values[6] = 9999u;
    in.values[7] = 9999u;
    in.values[8] = 3u;
    in.values[9] = 60000u;
    in.values[10] = 0u;
    in.values[11] = 10127u;
    in.values[12] = 65535u;
    in.values[13] = 127u;
    in.values[14] = 0u;
    in.values[15] = 100u;
    in.values[16] = 127u;
    in.values[17] = 23u;
    in.values[18] = 65535u;
    in.values[19] = 1u;
    in.values[20] = 32768u;
    in.values[21] = 0u;
    in.values[22] = 65535u;
    in.values[23] = 90u;
    in.values[24] = 0u;
    in.values[25] = 33333u;
    in.values[26] = 32767u;
    in.values[27] = 65535u;
    in.values[28] = 10000u;
    in.values[29] = 0u;
    in.values[30] = 0u;
    in.values[31] = 0u;
    expect(ck10_rtu_encode_write_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-point-1-write-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-point-1-write-request bytes");
}

static void test_346(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x27, 0x30, 0x00, 0x20, 0xCB, 0x6A};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_write_registers_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-point-1-write-response opens");
    expect(opened.unit_address == 1u, "example rtu-point-1-write-response: station");
    expect(opened.code == 16u, "example rtu-point-1-write-response: code");
    expect(opened.error == false, "example rtu-point-1-write-response: error");
    expect(ck10_write_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-point-1-write-response decodes");
    expect(out.address == 10032u, "example rtu-point-1-write-response: address");
    expect(out.word_count == 32u, "example rtu-point-1-write-response: word_count");
    in.address = 10032u;
    in.word_count = 32u;
    expect(ck10_rtu_encode_write_registers_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-point-1-write-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-point-1-write-response bytes");
}

static void test_347(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x31, 0x30, 0x32, 0x37, 0x33, 0x30, 0x30, 0x30, 0x32, 0x30, 0x34, 0x30, 0x38, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x31, 0x30, 0x30, 0x30, 0x37, 0x41, 0x31, 0x32, 0x30, 0x32, 0x37, 0x30, 0x46, 0x32, 0x37, 0x30, 0x46, 0x30, 0x30, 0x30, 0x33, 0x45, 0x41, 0x36, 0x30, 0x30, 0x30, 0x30, 0x30, 0x32, 0x37, 0x38, 0x46, 0x46, 0x46, 0x46, 0x46, 0x30, 0x30, 0x37, 0x46, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x36, 0x34, 0x30, 0x30, 0x37, 0x46, 0x30, 0x30, 0x31, 0x37, 0x46, 0x46, 0x46, 0x46, 0x30, 0x30, 0x30, 0x31, 0x38, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x46, 0x46, 0x46, 0x46, 0x30, 0x30, 0x35, 0x41, 0x30, 0x30, 0x30, 0x30, 0x38, 0x32, 0x33, 0x35, 0x37, 0x46, 0x46, 0x46, 0x46, 0x46, 0x46, 0x46, 0x32, 0x37, 0x31, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x43, 0x38, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_request_frame opened;
    ck10_write_registers_request in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-point-1-write-request opens");
    expect(opened.unit_address == 1u, "example ascii-point-1-write-request: station");
    expect(opened.code == 16u, "example ascii-point-1-write-request: code");
    expect(ck10_write_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-point-1-write-request decodes");
    expect(out.address == 10032u, "example ascii-point-1-write-request: address");
    expect(out.values_count == 32u, "example ascii-point-1-write-request: values count");
    expect(out.values[0] == 32768u, "example ascii-point-1-write-request: values");
    expect(out.values[1] == 0u, "example ascii-point-1-write-request: values");
    expect(out.values[2] == 0u, "example ascii-point-1-write-request: values");
    expect(out.values[3] == 1u, "example ascii-point-1-write-request: values");
    expect(out.values[4] == 7u, "example ascii-point-1-write-request: values");
    expect(out.values[5] == 41248u, "example ascii-point-1-write-request: values");
    expect(out.values[6] == 9999u, "example ascii-point-1-write-request: values");
    expect(out.values[7] == 9999u, "example ascii-point-1-write-request: values");
    expect(out.values[8] == 3u, "example ascii-point-1-write-request: values");
    expect(out.values[9] == 60000u, "example ascii-point-1-write-request: values");
    expect(out.values[10] == 0u, "example ascii-point-1-write-request: values");
    expect(out.values[11] == 10127u, "example ascii-point-1-write-request: values");
    expect(out.values[12] == 65535u, "example ascii-point-1-write-request: values");
    expect(out.values[13] == 127u, "example ascii-point-1-write-request: values");
    expect(out.values[14] == 0u, "example ascii-point-1-write-request: values");
    expect(out.values[15] == 100u, "example ascii-point-1-write-request: values");
    expect(out.values[16] == 127u, "example ascii-point-1-write-request: values");
    expect(out.values[17] == 23u, "example ascii-point-1-write-request: values");
    expect(out.values[18] == 65535u, "example ascii-point-1-write-request: values");
    expect(out.values[19] == 1u, "example ascii-point-1-write-request: values");
    expect(out.values[20] == 32768u, "example ascii-point-1-write-request: values");
    expect(out.values[21] == 0u, "example ascii-point-1-write-request: values");
    expect(out.values[22] == 65535u, "example ascii-point-1-write-request: values");
    expect(out.values[23] == 90u, "example ascii-point-1-write-request: values");
    expect(out.values[24] == 0u, "example ascii-point-1-write-request: values");
    expect(out.values[25] == 33333u, "example ascii-point-1-write-request: values");
    expect(out.values[26] == 32767u, "example ascii-point-1-write-request: values");
    expect(out.values[27] == 65535u, "example ascii-point-1-write-request: values");
    expect(out.values[28] == 10000u, "example ascii-point-1-write-request: values");
    expect(out.values[29] == 0u, "example ascii-point-1-write-request: values");
    expect(out.values[30] == 0u, "example ascii-point-1-write-request: values");
    expect(out.values[31] == 0u, "example ascii-point-1-write-request: values");
    in.address = 10032u;
    in.values_count = 32u;
    in.values[0] = 32768u;
    in.values[1] = 0u;
    in.values[2] = 0u;
    in.values[3] = 1u;
    in.values[4] = 7u;
    in.values[5] = 41248u;
    in.values[6] = 9999u;
    in.values[7] = 9999u;
    in.values[8] = 3u;
    in.values[9] = 60000u;
    in.values[10] = 0u;
    in.values[11] = 10127u;
    in.values[12] = 65535u;
    in.values[13] = 127u;
    in.values[14] = 0u;
    in.values[15] = 100u;
    in.values[16] = 127u;
    in.values[17] = 23u;
    in.values[18] = 65535u;
    in.values[19] = 1u;
    in.values[20] = 32768u;
    in.values[21] = 0u;
    in.values[22] = 65535u;
    in.values[23] = 90u;
    in.values[24] = 0u;
    in.values[25] = 33333u;
    in.values[26] = 32767u;
    in.values[27] = 65535u;
    in.values[28] = 10000u;
    in.values[29] = 0u;
    in.values[30] = 0u;
    in.values[31] = 0u;
    expect(ck10_ascii_encode_write_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-point-1-write-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-point-1-write-request bytes");
}

static void test_348(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x31, 0x30, 0x32, 0x37, 0x33, 0x30, 0x30, 0x30, 0x32, 0x30, 0x37, 0x38, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_response_frame opened;
    ck10_write_registers_response in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_response_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-point-1-write-response opens");
    expect(opened.unit_address == 1u, "example ascii-point-1-write-response: station");
    expect(opened.code == 16u, "example ascii-point-1-write-response: code");
    expect(opened.error == false, "example ascii-point-1-write-response: error");
    expect(ck10_write_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-point-1-write-response decodes");
    expect(out.address == 10032u, "example ascii-point-1-write-response: address");
    expect(out.word_count == 32u, "example ascii-point-1-write-response: word_count");
    in.address = 10032u;
    in.word_count = 32u;
    expect(ck10_ascii_encode_write_registers_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-point-1-write-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-point-1-write-response bytes");
}

static void test_349(void)
{
    static const uint8_t frame[] = {0x10, 0x10, 0x36, 0xF0, 0x00, 0x20, 0x40, 0x7F, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x88, 0xB8, 0x00, 0x00, 0x00, 0x01, 0x00, 0x01, 0x00, 0x01, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x7F, 0x00, 0x00, 0x7F, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x14, 0x00, 0x00, 0x00, 0x01, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xDA, 0xEC};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-point-127-write-request opens");
    expect(opened.unit_address == 16u, "example rtu-point-127-write-request: station");
    expect(opened.code == 16u, "example rtu-point-127-write-request: code");
    expect(ck10_write_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-point-127-write-request decodes");
    expect(out.address == 14064u, "example rtu-point-127-write-request: address");
    expect(out.values_count == 32u, "example rtu-point-127-write-request: values count");
    expect(out.values[0] == 32767u, "example rtu-point-127-write-request: values");
    expect(out.values[1] == 65535u, "example rtu-point-127-write-request: values");
    expect(out.values[2] == 0u, "example rtu-point-127-write-request: values");
    expect(out.values[3] == 35000u, "example rtu-point-127-write-request: values");
    expect(out.values[4] == 0u, "example rtu-point-127-write-request: values");
    expect(out.values[5] == 1u, "example rtu-point-127-write-request: values");
    expect(out.values[6] == 1u, "example rtu-point-127-write-request: values");
    expect(out.values[7] == 1u, "example rtu-point-127-write-request: values");
    expect(out.values[8] == 65535u, "example rtu-point-127-write-request: values");
    expect(out.values[9] == 0u, "example rtu-point-127-write-request: values");
    expect(out.values[10] == 0u, "example rtu-point-127-write-request: values");
    expect(out.values[11] == 65535u, "example rtu-point-127-write-request: values");
    expect(out.values[12] == 65535u, "example rtu-point-127-write-request: values");
    expect(out.values[13] == 65535u, "example rtu-point-127-write-request: values");
    expect(out.values[14] == 65535u, "example rtu-point-127-write-request: values");
    expect(out.values[15] == 0u, "example rtu-point-127-write-request: values");
    expect(out.values[16] == 0u, "example rtu-point-127-write-request: values");
    expect(out.values[17] == 0u, "example rtu-point-127-write-request: values");
    expect(out.values[18] == 127u, "example rtu-point-127-write-request: values");
    expect(out.values[19] == 0u, "example rtu-point-127-write-request: values");
    expect(out.values[20] == 32767u, "example rtu-point-127-write-request: values");
    expect(out.values[21] == 65535u, "example rtu-point-127-write-request: values");
    expect(out.values[22] == 0u, "example rtu-point-127-write-request: values");
    expect(out.values[23] == 20u, "example rtu-point-127-write-request: values");
    expect(out.values[24] == 0u, "example rtu-point-127-write-request: values");
    expect(out.values[25] == 1u, "example rtu-point-127-write-request: values");
    expect(out.values[26] == 32768u, "example rtu-point-127-write-request: values");
    expect(out.values[27] == 0u, "example rtu-point-127-write-request: values");
    expect(out.values[28] == 0u, "example rtu-point-127-write-request: values");
    expect(out.values[29] == 0u, "example rtu-point-127-write-request: values");
    expect(out.values[30] == 0u, "example rtu-point-127-write-request: values");
    expect(out.values[31] == 0u, "example rtu-point-127-write-request: values");
    in.address = 14064u;
    in.values_count = 32u;
    in.values[0] = 32767u;
    in.values[1] = 65535u;
    in.values[2] = 0u;
    in.values[3] = 35000u;
    in.values[4] = 0u;
    in.values[5] = 1u;
    in.values[6] = 1u;
    in.values[7] = 1u;
    in.values[8] = 65535u;
    in.values[9] = 0u;
    in.values[10] = 0u;
    in.values[11] = 65535u;
    in.values[12] = 65535u;
    in.values[13] = 65535u;
    in.values[14] = 65535u;
    in.values[15] = 0u;
    in.values[16] = 0u;
    in.values[17] = 0u;
    in.values[18] = 127u;
    in.values[19] = 0u;
    in.values[20] = 32767u;
    in.values[21] = 65535u;
    in.values[22] = 0u;
    in.values[23] = 20u;
    in.values[24] = 0u;
    in.values[25] = 1u;
    in.values[26] = 32768u;
    in.values[27] = 0u;
    in.values[28] = 0u;
    in.values[29] = 0u;
    in.values[30] = 0u;
    in.values[31] = 0u;
    expect(ck10_rtu_encode_write_registers_request(16u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-point-127-write-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-point-127-write-request bytes");
}

static void test_350(void)
{
    static const uint8_t frame[] = {0x10, 0x10, 0x36, 0xF0, 0x00, 0x20, 0xCD, 0x2B};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_write_registers_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-point-127-write-response opens");
    expect(opened.unit_address == 16u, "example rtu-point-127-write-response: station");
    expect(opened.code == 16u, "example rtu-point-127-write-response: code");
    expect(opened.error == false, "example rtu-point-127-write-response: error");
    expect(ck10_write_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-point-127-write-response decodes");
    expect(out.address == 14064u, "example rtu-point-127-write-response: address");
    expect(out.word_count == 32u, "example rtu-point-127-write-response: word_count");
    in.address = 14064u;
    in.word_count = 32u;
    expect(ck10_rtu_encode_write_registers_response(16u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-point-127-write-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-point-127-write-response bytes");
}

static void test_351(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x07, 0xD6, 0x00, 0x02, 0x04, 0xFF, 0xFF, 0xFF, 0xFF, 0x59, 0x7D};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-target-request opens");
    expect(opened.unit_address == 1u, "example rtu-target-request: station");
    expect(opened.code == 16u, "example rtu-target-request: code");
    expect(ck10_write_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-target-request decodes");
    expect(out.address == 2006u, "example rtu-target-request: address");
    expect(out.values_count == 2u, "example rtu-target-request: values count");
    expect(out.values[0] == 65535u, "example rtu-target-request: values");
    expect(out.values[1] == 65535u, "example rtu-target-request: values");
    in.address = 2006u;
    in.values_count = 2u;
    in.values[0] = 65535u;
    in.values[1] = 65535u;
    expect(ck10_rtu_encode_write_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-target-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-target-request bytes");
}

static void test_352(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x07, 0xD6, 0x00, 0x02, 0xA1, 0x44};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_write_registers_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-target-response opens");
    expect(opened.unit_address == 1u, "example rtu-target-response: station");
    expect(opened.code == 16u, "example rtu-target-response: code");
    expect(opened.error == false, "example rtu-target-response: error");
    expect(ck10_write_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-target-response decodes");
    expect(out.address == 2006u, "example rtu-target-response: address");
    expect(out.word_count == 2u, "example rtu-target-response: word_count");
    in.address = 2006u;
    in.word_count = 2u;
    expect(ck10_rtu_encode_write_registers_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-target-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-target-response bytes");
}

static void test_353(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x31, 0x30, 0x30, 0x37, 0x44, 0x36, 0x30, 0x30, 0x30, 0x32, 0x30, 0x34, 0x46, 0x46, 0x46, 0x46, 0x46, 0x46, 0x46, 0x46, 0x31, 0x30, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_request_frame opened;
    ck10_write_registers_request in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-target-request opens");
    expect(opened.unit_address == 1u, "example ascii-target-request: station");
    expect(opened.code == 16u, "example ascii-target-request: code");
    expect(ck10_write_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-target-request decodes");
    expect(out.address == 2006u, "example ascii-target-request: address");
    expect(out.values_count == 2u, "example ascii-target-request: values count");
    expect(out.values[0] == 65535u, "example ascii-target-request: values");
    expect(out.values[1] == 65535u, "example ascii-target-request: values");
    in.address = 2006u;
    in.values_count = 2u;
    in.values[0] = 65535u;
    in.values[1] = 65535u;
    expect(ck10_ascii_encode_write_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-target-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-target-request bytes");
}

static void test_354(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x31, 0x30, 0x30, 0x37, 0x44, 0x36, 0x30, 0x30, 0x30, 0x32, 0x31, 0x30, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_response_frame opened;
    ck10_write_registers_response in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_response_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-target-response opens");
    expect(opened.unit_address == 1u, "example ascii-target-response: station");
    expect(opened.code == 16u, "example ascii-target-response: code");
    expect(opened.error == false, "example ascii-target-response: error");
    expect(ck10_write_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-target-response decodes");
    expect(out.address == 2006u, "example ascii-target-response: address");
    expect(out.word_count == 2u, "example ascii-target-response: word_count");
    in.address = 2006u;
    in.word_count = 2u;
    expect(ck10_ascii_encode_write_registers_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-target-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-target-response bytes");
}

static void test_355(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x07, 0xD0, 0x00, 0x09, 0x12, 0x00, 0x00, 0x88, 0xB8, 0x27, 0x0F, 0x00, 0x01, 0x00, 0x0C, 0x35, 0x00, 0x80, 0x00, 0x00, 0x00, 0x00, 0x02, 0xD4, 0xC1};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-move-request opens");
    expect(opened.unit_address == 1u, "example rtu-move-request: station");
    expect(opened.code == 16u, "example rtu-move-request: code");
    expect(ck10_write_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-move-request decodes");
    expect(out.address == 2000u, "example rtu-move-request: address");
    expect(out.values_count == 9u, "example rtu-move-request: values count");
    expect(out.values[0] == 0u, "example rtu-move-request: values");
    expect(out.values[1] == 35000u, "example rtu-move-request: values");
    expect(out.values[2] == 9999u, "example rtu-move-request: values");
    expect(out.values[3] == 1u, "example rtu-move-request: values");
    expect(out.values[4] == 12u, "example rtu-move-request: values");
    expect(out.values[5] == 13568u, "example rtu-move-request: values");
    expect(out.values[6] == 32768u, "example rtu-move-request: values");
    expect(out.values[7] == 0u, "example rtu-move-request: values");
    expect(out.values[8] == 2u, "example rtu-move-request: values");
    in.address = 2000u;
    in.values_count = 9u;
    in.values[0] = 0u;
    in.values[1] = 35000u;
    in.values[2] = 9999u;
    in.values[3] = 1u;
    in.values[4] = 12u;
    in.values[5] = 13568u;
    in.values[6] = 32768u;
    in.values[7] = 0u;
    in.values[8] = 2u;
    expect(ck10_rtu_encode_write_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-move-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-move-request bytes");
}

static void test_356(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x07, 0xD0, 0x00, 0x09, 0x00, 0x82};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_write_registers_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-move-response opens");
    expect(opened.unit_address == 1u, "example rtu-move-response: station");
    expect(opened.code == 16u, "example rtu-move-response: code");
    expect(opened.error == false, "example rtu-move-response: error");
    expect(ck10_write_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-move-response decodes");
    expect(out.address == 2000u, "example rtu-move-response: address");
    expect(out.word_count == 9u, "example rtu-move-response: word_count");
    in.address = 2000u;
    in.word_count = 9u;
    expect(ck10_rtu_encode_write_registers_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-move-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-move-response bytes");
}

static void test_357(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x31, 0x30, 0x30, 0x37, 0x45, 0x30, 0x30, 0x30, 0x30, 0x46, 0x31, 0x45, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x31, 0x30, 0x30, 0x30, 0x30, 0x38, 0x32, 0x33, 0x35, 0x32, 0x37, 0x30, 0x46, 0x32, 0x37, 0x30, 0x46, 0x30, 0x30, 0x30, 0x31, 0x30, 0x30, 0x35, 0x41, 0x30, 0x30, 0x30, 0x30, 0x38, 0x32, 0x33, 0x35, 0x46, 0x46, 0x46, 0x46, 0x46, 0x43, 0x31, 0x38, 0x30, 0x30, 0x30, 0x30, 0x30, 0x33, 0x45, 0x38, 0x30, 0x30, 0x30, 0x31, 0x41, 0x37, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_request_frame opened;
    ck10_write_registers_request in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-push-request opens");
    expect(opened.unit_address == 1u, "example ascii-push-request: station");
    expect(opened.code == 16u, "example ascii-push-request: code");
    expect(ck10_write_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-push-request decodes");
    expect(out.address == 2016u, "example ascii-push-request: address");
    expect(out.values_count == 15u, "example ascii-push-request: values count");
    expect(out.values[0] == 0u, "example ascii-push-request: values");
    expect(out.values[1] == 1u, "example ascii-push-request: values");
    expect(out.values[2] == 0u, "example ascii-push-request: values");
    expect(out.values[3] == 33333u, "example ascii-push-request: values");
    expect(out.values[4] == 9999u, "example ascii-push-request: values");
    expect(out.values[5] == 9999u, "example ascii-push-request: values");
    expect(out.values[6] == 1u, "example ascii-push-request: values");
    expect(out.values[7] == 90u, "example ascii-push-request: values");
    expect(out.values[8] == 0u, "example ascii-push-request: values");
    expect(out.values[9] == 33333u, "example ascii-push-request: values");
    expect(out.values[10] == 65535u, "example ascii-push-request: values");
    expect(out.values[11] == 64536u, "example ascii-push-request: values");
    expect(out.values[12] == 0u, "example ascii-push-request: values");
    expect(out.values[13] == 1000u, "example ascii-push-request: values");
    expect(out.values[14] == 1u, "example ascii-push-request: values");
    in.address = 2016u;
    in.values_count = 15u;
    in.values[0] = 0u;
    in.values[1] = 1u;
    in.values[2] = 0u;
    in.values[3] = 33333u;
    in.values[4] = 9999u;
    in.values[5] = 9999u;
    in.values[6] = 1u;
    in.values[7] = 90u;
    in.values[8] = 0u;
    in.values[9] = 33333u;
    in.values[10] = 65535u;
    in.values[11] = 64536u;
    in.values[12] = 0u;
    in.values[13] = 1000u;
    in.values[14] = 1u;
    expect(ck10_ascii_encode_write_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-push-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-push-request bytes");
}

static void test_358(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x31, 0x30, 0x30, 0x37, 0x45, 0x30, 0x30, 0x30, 0x30, 0x46, 0x46, 0x39, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_response_frame opened;
    ck10_write_registers_response in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_response_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-push-response opens");
    expect(opened.unit_address == 1u, "example ascii-push-response: station");
    expect(opened.code == 16u, "example ascii-push-response: code");
    expect(opened.error == false, "example ascii-push-response: error");
    expect(ck10_write_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-push-response decodes");
    expect(out.address == 2016u, "example ascii-push-response: address");
    expect(out.word_count == 15u, "example ascii-push-response: word_count");
    in.address = 2016u;
    in.word_count = 15u;
    expect(ck10_ascii_encode_write_registers_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-push-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-push-response bytes");
}

static void test_359(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x07, 0xF8, 0x00, 0x06, 0x0C, 0xFF, 0xFF, 0xFC, 0x18, 0x00, 0x00, 0x07, 0xD0, 0x03, 0xE8, 0x00, 0x01, 0x71, 0x4F};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-compare-request opens");
    expect(opened.unit_address == 1u, "example rtu-compare-request: station");
    expect(opened.code == 16u, "example rtu-compare-request: code");
    expect(ck10_write_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-compare-request decodes");
    expect(out.address == 2040u, "example rtu-compare-request: address");
    expect(out.values_count == 6u, "example rtu-compare-request: values count");
    expect(out.values[0] == 65535u, "example rtu-compare-request: values");
    expect(out.values[1] == 64536u, "example rtu-compare-request: values");
    expect(out.values[2] == 0u, "example rtu-compare-request: values");
    expect(out.values[3] == 2000u, "example rtu-compare-request: values");
    expect(out.values[4] == 1000u, "example rtu-compare-request: values");
    expect(out.values[5] == 1u, "example rtu-compare-request: values");
    in.address = 2040u;
    in.values_count = 6u;
    in.values[0] = 65535u;
    in.values[1] = 64536u;
    in.values[2] = 0u;
    in.values[3] = 2000u;
    in.values[4] = 1000u;
    in.values[5] = 1u;
    expect(ck10_rtu_encode_write_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-compare-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-compare-request bytes");
}

static void test_360(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x07, 0xF8, 0x00, 0x06, 0xC0, 0x8E};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_write_registers_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-compare-response opens");
    expect(opened.unit_address == 1u, "example rtu-compare-response: station");
    expect(opened.code == 16u, "example rtu-compare-response: code");
    expect(opened.error == false, "example rtu-compare-response: error");
    expect(ck10_write_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-compare-response decodes");
    expect(out.address == 2040u, "example rtu-compare-response: address");
    expect(out.word_count == 6u, "example rtu-compare-response: word_count");
    in.address = 2040u;
    in.word_count = 6u;
    expect(ck10_rtu_encode_write_registers_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-compare-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-compare-response bytes");
}

static void test_361(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x13, 0xAE, 0x00, 0x02, 0x04, 0x80, 0x00, 0x00, 0x00, 0x88, 0xAB};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-homing-offset-request opens");
    expect(opened.unit_address == 1u, "example rtu-homing-offset-request: station");
    expect(opened.code == 16u, "example rtu-homing-offset-request: code");
    expect(ck10_write_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-homing-offset-request decodes");
    expect(out.address == 5038u, "example rtu-homing-offset-request: address");
    expect(out.values_count == 2u, "example rtu-homing-offset-request: values count");
    expect(out.values[0] == 32768u, "example rtu-homing-offset-request: values");
    expect(out.values[1] == 0u, "example rtu-homing-offset-request: values");
    in.address = 5038u;
    in.values_count = 2u;
    in.values[0] = 32768u;
    in.values[1] = 0u;
    expect(ck10_rtu_encode_write_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-homing-offset-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-homing-offset-request bytes");
}

static void test_362(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x13, 0xAE, 0x00, 0x02, 0x24, 0xAD};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_write_registers_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-homing-offset-response opens");
    expect(opened.unit_address == 1u, "example rtu-homing-offset-response: station");
    expect(opened.code == 16u, "example rtu-homing-offset-response: code");
    expect(opened.error == false, "example rtu-homing-offset-response: error");
    expect(ck10_write_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-homing-offset-response decodes");
    expect(out.address == 5038u, "example rtu-homing-offset-response: address");
    expect(out.word_count == 2u, "example rtu-homing-offset-response: word_count");
    in.address = 5038u;
    in.word_count = 2u;
    expect(ck10_rtu_encode_write_registers_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-homing-offset-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-homing-offset-response bytes");
}

static void test_363(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x31, 0x30, 0x31, 0x33, 0x41, 0x45, 0x30, 0x30, 0x30, 0x32, 0x30, 0x34, 0x38, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x41, 0x38, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_request_frame opened;
    ck10_write_registers_request in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-homing-offset-request opens");
    expect(opened.unit_address == 1u, "example ascii-homing-offset-request: station");
    expect(opened.code == 16u, "example ascii-homing-offset-request: code");
    expect(ck10_write_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-homing-offset-request decodes");
    expect(out.address == 5038u, "example ascii-homing-offset-request: address");
    expect(out.values_count == 2u, "example ascii-homing-offset-request: values count");
    expect(out.values[0] == 32768u, "example ascii-homing-offset-request: values");
    expect(out.values[1] == 0u, "example ascii-homing-offset-request: values");
    in.address = 5038u;
    in.values_count = 2u;
    in.values[0] = 32768u;
    in.values[1] = 0u;
    expect(ck10_ascii_encode_write_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-homing-offset-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-homing-offset-request bytes");
}

static void test_364(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x31, 0x30, 0x31, 0x33, 0x41, 0x45, 0x30, 0x30, 0x30, 0x32, 0x32, 0x43, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_response_frame opened;
    ck10_write_registers_response in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_response_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-homing-offset-response opens");
    expect(opened.unit_address == 1u, "example ascii-homing-offset-response: station");
    expect(opened.code == 16u, "example ascii-homing-offset-response: code");
    expect(opened.error == false, "example ascii-homing-offset-response: error");
    expect(ck10_write_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-homing-offset-response decodes");
    expect(out.address == 5038u, "example ascii-homing-offset-response: address");
    expect(out.word_count == 2u, "example ascii-homing-offset-response: word_count");
    in.address = 5038u;
    in.word_count = 2u;
    expect(ck10_ascii_encode_write_registers_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-homing-offset-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-homing-offset-response bytes");
}

static void test_365(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x13, 0xB8, 0x00, 0x02, 0x04, 0x07, 0xFF, 0xFF, 0xFF, 0x10, 0xB9};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-tracking-limit-request opens");
    expect(opened.unit_address == 1u, "example rtu-tracking-limit-request: station");
    expect(opened.code == 16u, "example rtu-tracking-limit-request: code");
    expect(ck10_write_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-tracking-limit-request decodes");
    expect(out.address == 5048u, "example rtu-tracking-limit-request: address");
    expect(out.values_count == 2u, "example rtu-tracking-limit-request: values count");
    expect(out.values[0] == 2047u, "example rtu-tracking-limit-request: values");
    expect(out.values[1] == 65535u, "example rtu-tracking-limit-request: values");
    in.address = 5048u;
    in.values_count = 2u;
    in.values[0] = 2047u;
    in.values[1] = 65535u;
    expect(ck10_rtu_encode_write_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-tracking-limit-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-tracking-limit-request bytes");
}

static void test_366(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x13, 0xB8, 0x00, 0x02, 0xC5, 0x69};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_write_registers_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-tracking-limit-response opens");
    expect(opened.unit_address == 1u, "example rtu-tracking-limit-response: station");
    expect(opened.code == 16u, "example rtu-tracking-limit-response: code");
    expect(opened.error == false, "example rtu-tracking-limit-response: error");
    expect(ck10_write_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-tracking-limit-response decodes");
    expect(out.address == 5048u, "example rtu-tracking-limit-response: address");
    expect(out.word_count == 2u, "example rtu-tracking-limit-response: word_count");
    in.address = 5048u;
    in.word_count = 2u;
    expect(ck10_rtu_encode_write_registers_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-tracking-limit-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-tracking-limit-response bytes");
}

static void test_367(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x31, 0x30, 0x31, 0x33, 0x44, 0x41, 0x30, 0x30, 0x30, 0x32, 0x30, 0x34, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x32, 0x46, 0x41, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_request_frame opened;
    ck10_write_registers_request in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-input-1-function-request opens");
    expect(opened.unit_address == 1u, "example ascii-input-1-function-request: station");
    expect(opened.code == 16u, "example ascii-input-1-function-request: code");
    expect(ck10_write_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-input-1-function-request decodes");
    expect(out.address == 5082u, "example ascii-input-1-function-request: address");
    expect(out.values_count == 2u, "example ascii-input-1-function-request: values count");
    expect(out.values[0] == 0u, "example ascii-input-1-function-request: values");
    expect(out.values[1] == 2u, "example ascii-input-1-function-request: values");
    in.address = 5082u;
    in.values_count = 2u;
    in.values[0] = 0u;
    in.values[1] = 2u;
    expect(ck10_ascii_encode_write_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-input-1-function-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-input-1-function-request bytes");
}

static void test_368(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x31, 0x30, 0x31, 0x33, 0x44, 0x41, 0x30, 0x30, 0x30, 0x32, 0x30, 0x30, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_response_frame opened;
    ck10_write_registers_response in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_response_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-input-1-function-response opens");
    expect(opened.unit_address == 1u, "example ascii-input-1-function-response: station");
    expect(opened.code == 16u, "example ascii-input-1-function-response: code");
    expect(opened.error == false, "example ascii-input-1-function-response: error");
    expect(ck10_write_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-input-1-function-response decodes");
    expect(out.address == 5082u, "example ascii-input-1-function-response: address");
    expect(out.word_count == 2u, "example ascii-input-1-function-response: word_count");
    in.address = 5082u;
    in.word_count = 2u;
    expect(ck10_ascii_encode_write_registers_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-input-1-function-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-input-1-function-response bytes");
}

static void test_369(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x13, 0xDC, 0x00, 0x02, 0x04, 0x08, 0x00, 0x00, 0x00, 0x25, 0xF6};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-input-2-function-request opens");
    expect(opened.unit_address == 1u, "example rtu-input-2-function-request: station");
    expect(opened.code == 16u, "example rtu-input-2-function-request: code");
    expect(ck10_write_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-input-2-function-request decodes");
    expect(out.address == 5084u, "example rtu-input-2-function-request: address");
    expect(out.values_count == 2u, "example rtu-input-2-function-request: values count");
    expect(out.values[0] == 2048u, "example rtu-input-2-function-request: values");
    expect(out.values[1] == 0u, "example rtu-input-2-function-request: values");
    in.address = 5084u;
    in.values_count = 2u;
    in.values[0] = 2048u;
    in.values[1] = 0u;
    expect(ck10_rtu_encode_write_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-input-2-function-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-input-2-function-request bytes");
}

static void test_370(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x13, 0xDC, 0x00, 0x02, 0x84, 0xB6};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_write_registers_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-input-2-function-response opens");
    expect(opened.unit_address == 1u, "example rtu-input-2-function-response: station");
    expect(opened.code == 16u, "example rtu-input-2-function-response: code");
    expect(opened.error == false, "example rtu-input-2-function-response: error");
    expect(ck10_write_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-input-2-function-response decodes");
    expect(out.address == 5084u, "example rtu-input-2-function-response: address");
    expect(out.word_count == 2u, "example rtu-input-2-function-response: word_count");
    in.address = 5084u;
    in.word_count = 2u;
    expect(ck10_rtu_encode_write_registers_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-input-2-function-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-input-2-function-response bytes");
}

static void test_371(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x13, 0xF2, 0x00, 0x02, 0x04, 0x00, 0x08, 0x00, 0x00, 0x25, 0xC0};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-output-1-function-request opens");
    expect(opened.unit_address == 1u, "example rtu-output-1-function-request: station");
    expect(opened.code == 16u, "example rtu-output-1-function-request: code");
    expect(ck10_write_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-output-1-function-request decodes");
    expect(out.address == 5106u, "example rtu-output-1-function-request: address");
    expect(out.values_count == 2u, "example rtu-output-1-function-request: values count");
    expect(out.values[0] == 8u, "example rtu-output-1-function-request: values");
    expect(out.values[1] == 0u, "example rtu-output-1-function-request: values");
    in.address = 5106u;
    in.values_count = 2u;
    in.values[0] = 8u;
    in.values[1] = 0u;
    expect(ck10_rtu_encode_write_registers_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-output-1-function-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-output-1-function-request bytes");
}

static void test_372(void)
{
    static const uint8_t frame[] = {0x01, 0x10, 0x13, 0xF2, 0x00, 0x02, 0xE4, 0xBF};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_write_registers_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-output-1-function-response opens");
    expect(opened.unit_address == 1u, "example rtu-output-1-function-response: station");
    expect(opened.code == 16u, "example rtu-output-1-function-response: code");
    expect(opened.error == false, "example rtu-output-1-function-response: error");
    expect(ck10_write_registers_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-output-1-function-response decodes");
    expect(out.address == 5106u, "example rtu-output-1-function-response: address");
    expect(out.word_count == 2u, "example rtu-output-1-function-response: word_count");
    in.address = 5106u;
    in.word_count = 2u;
    expect(ck10_rtu_encode_write_registers_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-output-1-function-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-output-1-function-response bytes");
}

static void test_373(void)
{
    static const uint8_t frame[] = {0x00, 0x10, 0x13, 0xDA, 0x00, 0x02, 0x04, 0x00, 0x00, 0x00, 0x02, 0x22, 0x81};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_write_registers_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-all-input-1-function-request opens");
    expect(opened.unit_address == 0u, "example rtu-all-input-1-function-request: station");
    expect(opened.code == 16u, "example rtu-all-input-1-function-request: code");
    expect(ck10_write_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-all-input-1-function-request decodes");
    expect(out.address == 5082u, "example rtu-all-input-1-function-request: address");
    expect(out.values_count == 2u, "example rtu-all-input-1-function-request: values count");
    expect(out.values[0] == 0u, "example rtu-all-input-1-function-request: values");
    expect(out.values[1] == 2u, "example rtu-all-input-1-function-request: values");
    in.address = 5082u;
    in.values_count = 2u;
    in.values[0] = 0u;
    in.values[1] = 2u;
    expect(ck10_rtu_encode_write_registers_request(0u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-all-input-1-function-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-all-input-1-function-request bytes");
}

static void test_374(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x30, 0x31, 0x30, 0x31, 0x33, 0x44, 0x41, 0x30, 0x30, 0x30, 0x32, 0x30, 0x34, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x32, 0x46, 0x42, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_request_frame opened;
    ck10_write_registers_request in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-all-input-1-function-request opens");
    expect(opened.unit_address == 0u, "example ascii-all-input-1-function-request: station");
    expect(opened.code == 16u, "example ascii-all-input-1-function-request: code");
    expect(ck10_write_registers_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-all-input-1-function-request decodes");
    expect(out.address == 5082u, "example ascii-all-input-1-function-request: address");
    expect(out.values_count == 2u, "example ascii-all-input-1-function-request: values count");
    expect(out.values[0] == 0u, "example ascii-all-input-1-function-request: values");
    expect(out.values[1] == 2u, "example ascii-all-input-1-function-request: values");
    in.address = 5082u;
    in.values_count = 2u;
    in.values[0] = 0u;
    in.values[1] = 2u;
    expect(ck10_ascii_encode_write_registers_request(0u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-all-input-1-function-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-all-input-1-function-request bytes");
}

static void test_375(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x07, 0xD8, 0x00, 0x02, 0x89, 0x44};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_write_register_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-start-move-request opens");
    expect(opened.unit_address == 1u, "example rtu-start-move-request: station");
    expect(opened.code == 6u, "example rtu-start-move-request: code");
    expect(ck10_write_register_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-start-move-request decodes");
    expect(out.address == 2008u, "example rtu-start-move-request: address");
    expect(out.value == 2u, "example rtu-start-move-request: value");
    in.address = 2008u;
    in.value = 2u;
    expect(ck10_rtu_encode_write_register_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-start-move-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-start-move-request bytes");
}

static void test_376(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x07, 0xD8, 0x00, 0x02, 0x89, 0x44};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_write_register_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-start-move-response opens");
    expect(opened.unit_address == 1u, "example rtu-start-move-response: station");
    expect(opened.code == 6u, "example rtu-start-move-response: code");
    expect(opened.error == false, "example rtu-start-move-response: error");
    expect(ck10_write_register_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-start-move-response decodes");
    expect(out.address == 2008u, "example rtu-start-move-response: address");
    expect(out.value == 2u, "example rtu-start-move-response: value");
    in.address = 2008u;
    in.value = 2u;
    expect(ck10_rtu_encode_write_register_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-start-move-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-start-move-response bytes");
}

static void test_377(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x30, 0x36, 0x30, 0x37, 0x44, 0x38, 0x30, 0x30, 0x30, 0x32, 0x31, 0x38, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_request_frame opened;
    ck10_write_register_request in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-start-move-request opens");
    expect(opened.unit_address == 1u, "example ascii-start-move-request: station");
    expect(opened.code == 6u, "example ascii-start-move-request: code");
    expect(ck10_write_register_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-start-move-request decodes");
    expect(out.address == 2008u, "example ascii-start-move-request: address");
    expect(out.value == 2u, "example ascii-start-move-request: value");
    in.address = 2008u;
    in.value = 2u;
    expect(ck10_ascii_encode_write_register_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-start-move-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-start-move-request bytes");
}

static void test_378(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x30, 0x36, 0x30, 0x37, 0x44, 0x38, 0x30, 0x30, 0x30, 0x32, 0x31, 0x38, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_response_frame opened;
    ck10_write_register_response in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_response_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-start-move-response opens");
    expect(opened.unit_address == 1u, "example ascii-start-move-response: station");
    expect(opened.code == 6u, "example ascii-start-move-response: code");
    expect(opened.error == false, "example ascii-start-move-response: error");
    expect(ck10_write_register_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-start-move-response decodes");
    expect(out.address == 2008u, "example ascii-start-move-response: address");
    expect(out.value == 2u, "example ascii-start-move-response: value");
    in.address = 2008u;
    in.value = 2u;
    expect(ck10_ascii_encode_write_register_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-start-move-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-start-move-response bytes");
}

static void test_379(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x30, 0x36, 0x30, 0x37, 0x46, 0x37, 0x30, 0x30, 0x30, 0x31, 0x46, 0x41, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_request_frame opened;
    ck10_write_register_request in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-start-point-table-request opens");
    expect(opened.unit_address == 1u, "example ascii-start-point-table-request: station");
    expect(opened.code == 6u, "example ascii-start-point-table-request: code");
    expect(ck10_write_register_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-start-point-table-request decodes");
    expect(out.address == 2039u, "example ascii-start-point-table-request: address");
    expect(out.value == 1u, "example ascii-start-point-table-request: value");
    in.address = 2039u;
    in.value = 1u;
    expect(ck10_ascii_encode_write_register_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-start-point-table-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-start-point-table-request bytes");
}

static void test_380(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x30, 0x36, 0x30, 0x37, 0x46, 0x37, 0x30, 0x30, 0x30, 0x31, 0x46, 0x41, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_response_frame opened;
    ck10_write_register_response in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_response_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-start-point-table-response opens");
    expect(opened.unit_address == 1u, "example ascii-start-point-table-response: station");
    expect(opened.code == 6u, "example ascii-start-point-table-response: code");
    expect(opened.error == false, "example ascii-start-point-table-response: error");
    expect(ck10_write_register_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-start-point-table-response decodes");
    expect(out.address == 2039u, "example ascii-start-point-table-response: address");
    expect(out.value == 1u, "example ascii-start-point-table-response: value");
    in.address = 2039u;
    in.value = 1u;
    expect(ck10_ascii_encode_write_register_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-start-point-table-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-start-point-table-response bytes");
}

static void test_381(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x07, 0xF1, 0x00, 0x01, 0x18, 0x8D};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_write_register_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-servo-on-request opens");
    expect(opened.unit_address == 1u, "example rtu-servo-on-request: station");
    expect(opened.code == 6u, "example rtu-servo-on-request: code");
    expect(ck10_write_register_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-servo-on-request decodes");
    expect(out.address == 2033u, "example rtu-servo-on-request: address");
    expect(out.value == 1u, "example rtu-servo-on-request: value");
    in.address = 2033u;
    in.value = 1u;
    expect(ck10_rtu_encode_write_register_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-servo-on-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-servo-on-request bytes");
}

static void test_382(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x07, 0xF1, 0x00, 0x01, 0x18, 0x8D};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_write_register_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-servo-on-response opens");
    expect(opened.unit_address == 1u, "example rtu-servo-on-response: station");
    expect(opened.code == 6u, "example rtu-servo-on-response: code");
    expect(opened.error == false, "example rtu-servo-on-response: error");
    expect(ck10_write_register_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-servo-on-response decodes");
    expect(out.address == 2033u, "example rtu-servo-on-response: address");
    expect(out.value == 1u, "example rtu-servo-on-response: value");
    in.address = 2033u;
    in.value = 1u;
    expect(ck10_rtu_encode_write_register_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-servo-on-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-servo-on-response bytes");
}

static void test_383(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x04, 0x10, 0x01, 0xFF, 0xC8, 0xEF};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_write_register_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-user-outputs-request opens");
    expect(opened.unit_address == 1u, "example rtu-user-outputs-request: station");
    expect(opened.code == 6u, "example rtu-user-outputs-request: code");
    expect(ck10_write_register_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-user-outputs-request decodes");
    expect(out.address == 1040u, "example rtu-user-outputs-request: address");
    expect(out.value == 511u, "example rtu-user-outputs-request: value");
    in.address = 1040u;
    in.value = 511u;
    expect(ck10_rtu_encode_write_register_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-user-outputs-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-user-outputs-request bytes");
}

static void test_384(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x04, 0x10, 0x01, 0xFF, 0xC8, 0xEF};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_write_register_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-user-outputs-response opens");
    expect(opened.unit_address == 1u, "example rtu-user-outputs-response: station");
    expect(opened.code == 6u, "example rtu-user-outputs-response: code");
    expect(opened.error == false, "example rtu-user-outputs-response: error");
    expect(ck10_write_register_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-user-outputs-response decodes");
    expect(out.address == 1040u, "example rtu-user-outputs-response: address");
    expect(out.value == 511u, "example rtu-user-outputs-response: value");
    in.address = 1040u;
    in.value = 511u;
    expect(ck10_rtu_encode_write_register_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-user-outputs-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-user-outputs-response bytes");
}

static void test_385(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x07, 0xF4, 0x00, 0x01, 0x08, 0x8C};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_write_register_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-save-parameters-request opens");
    expect(opened.unit_address == 1u, "example rtu-save-parameters-request: station");
    expect(opened.code == 6u, "example rtu-save-parameters-request: code");
    expect(ck10_write_register_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-save-parameters-request decodes");
    expect(out.address == 2036u, "example rtu-save-parameters-request: address");
    expect(out.value == 1u, "example rtu-save-parameters-request: value");
    in.address = 2036u;
    in.value = 1u;
    expect(ck10_rtu_encode_write_register_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-save-parameters-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-save-parameters-request bytes");
}

static void test_386(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x07, 0xF4, 0x00, 0x01, 0x08, 0x8C};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_write_register_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-save-parameters-response opens");
    expect(opened.unit_address == 1u, "example rtu-save-parameters-response: station");
    expect(opened.code == 6u, "example rtu-save-parameters-response: code");
    expect(opened.error == false, "example rtu-save-parameters-response: error");
    expect(ck10_write_register_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-save-parameters-response decodes");
    expect(out.address == 2036u, "example rtu-save-parameters-response: address");
    expect(out.value == 1u, "example rtu-save-parameters-response: value");
    in.address = 2036u;
    in.value = 1u;
    expect(ck10_rtu_encode_write_register_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-save-parameters-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-save-parameters-response bytes");
}

static void test_387(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x30, 0x36, 0x30, 0x37, 0x46, 0x35, 0x30, 0x30, 0x30, 0x31, 0x46, 0x43, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_request_frame opened;
    ck10_write_register_request in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-save-point-table-request opens");
    expect(opened.unit_address == 1u, "example ascii-save-point-table-request: station");
    expect(opened.code == 6u, "example ascii-save-point-table-request: code");
    expect(ck10_write_register_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-save-point-table-request decodes");
    expect(out.address == 2037u, "example ascii-save-point-table-request: address");
    expect(out.value == 1u, "example ascii-save-point-table-request: value");
    in.address = 2037u;
    in.value = 1u;
    expect(ck10_ascii_encode_write_register_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-save-point-table-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-save-point-table-request bytes");
}

static void test_388(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x30, 0x36, 0x30, 0x37, 0x46, 0x35, 0x30, 0x30, 0x30, 0x31, 0x46, 0x43, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_response_frame opened;
    ck10_write_register_response in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_response_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-save-point-table-response opens");
    expect(opened.unit_address == 1u, "example ascii-save-point-table-response: station");
    expect(opened.code == 6u, "example ascii-save-point-table-response: code");
    expect(opened.error == false, "example ascii-save-point-table-response: error");
    expect(ck10_write_register_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-save-point-table-response decodes");
    expect(out.address == 2037u, "example ascii-save-point-table-response: address");
    expect(out.value == 1u, "example ascii-save-point-table-response: value");
    in.address = 2037u;
    in.value = 1u;
    expect(ck10_ascii_encode_write_register_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-save-point-table-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-save-point-table-response bytes");
}

static void test_389(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x04, 0x23, 0xFF, 0xFF, 0x78, 0x80};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_write_register_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-clear-alarm-history-request opens");
    expect(opened.unit_address == 1u, "example rtu-clear-alarm-history-request: station");
    expect(opened.code == 6u, "example rtu-clear-alarm-history-request: code");
    expect(ck10_write_register_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-clear-alarm-history-request decodes");
    expect(out.address == 1059u, "example rtu-clear-alarm-history-request: address");
    expect(out.value == 65535u, "example rtu-clear-alarm-history-request: value");
    in.address = 1059u;
    in.value = 65535u;
    expect(ck10_rtu_encode_write_register_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-clear-alarm-history-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-clear-alarm-history-request bytes");
}

static void test_390(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x04, 0x23, 0xFF, 0xFF, 0x78, 0x80};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_write_register_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-clear-alarm-history-response opens");
    expect(opened.unit_address == 1u, "example rtu-clear-alarm-history-response: station");
    expect(opened.code == 6u, "example rtu-clear-alarm-history-response: code");
    expect(opened.error == false, "example rtu-clear-alarm-history-response: error");
    expect(ck10_write_register_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-clear-alarm-history-response decodes");
    expect(out.address == 1059u, "example rtu-clear-alarm-history-response: address");
    expect(out.value == 65535u, "example rtu-clear-alarm-history-response: value");
    in.address = 1059u;
    in.value = 65535u;
    expect(ck10_rtu_encode_write_register_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-clear-alarm-history-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-clear-alarm-history-response bytes");
}

static void test_391(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x30, 0x36, 0x30, 0x34, 0x32, 0x33, 0x46, 0x46, 0x46, 0x46, 0x44, 0x34, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_request_frame opened;
    ck10_write_register_request in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-clear-alarm-history-request opens");
    expect(opened.unit_address == 1u, "example ascii-clear-alarm-history-request: station");
    expect(opened.code == 6u, "example ascii-clear-alarm-history-request: code");
    expect(ck10_write_register_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-clear-alarm-history-request decodes");
    expect(out.address == 1059u, "example ascii-clear-alarm-history-request: address");
    expect(out.value == 65535u, "example ascii-clear-alarm-history-request: value");
    in.address = 1059u;
    in.value = 65535u;
    expect(ck10_ascii_encode_write_register_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-clear-alarm-history-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-clear-alarm-history-request bytes");
}

static void test_392(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x30, 0x36, 0x30, 0x34, 0x32, 0x33, 0x46, 0x46, 0x46, 0x46, 0x44, 0x34, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_response_frame opened;
    ck10_write_register_response in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_response_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-clear-alarm-history-response opens");
    expect(opened.unit_address == 1u, "example ascii-clear-alarm-history-response: station");
    expect(opened.code == 6u, "example ascii-clear-alarm-history-response: code");
    expect(opened.error == false, "example ascii-clear-alarm-history-response: error");
    expect(ck10_write_register_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-clear-alarm-history-response decodes");
    expect(out.address == 1059u, "example ascii-clear-alarm-history-response: address");
    expect(out.value == 65535u, "example ascii-clear-alarm-history-response: value");
    in.address = 1059u;
    in.value = 65535u;
    expect(ck10_ascii_encode_write_register_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-clear-alarm-history-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-clear-alarm-history-response bytes");
}

static void test_393(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x27, 0x21, 0x00, 0x01, 0x12, 0xB4};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_write_register_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-output-at-start-request opens");
    expect(opened.unit_address == 1u, "example rtu-output-at-start-request: station");
    expect(opened.code == 6u, "example rtu-output-at-start-request: code");
    expect(ck10_write_register_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-output-at-start-request decodes");
    expect(out.address == 10017u, "example rtu-output-at-start-request: address");
    expect(out.value == 1u, "example rtu-output-at-start-request: value");
    in.address = 10017u;
    in.value = 1u;
    expect(ck10_rtu_encode_write_register_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-output-at-start-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-output-at-start-request bytes");
}

static void test_394(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x27, 0x21, 0x00, 0x01, 0x12, 0xB4};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_write_register_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-output-at-start-response opens");
    expect(opened.unit_address == 1u, "example rtu-output-at-start-response: station");
    expect(opened.code == 6u, "example rtu-output-at-start-response: code");
    expect(opened.error == false, "example rtu-output-at-start-response: error");
    expect(ck10_write_register_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-output-at-start-response decodes");
    expect(out.address == 10017u, "example rtu-output-at-start-response: address");
    expect(out.value == 1u, "example rtu-output-at-start-response: value");
    in.address = 10017u;
    in.value = 1u;
    expect(ck10_rtu_encode_write_register_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-output-at-start-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-output-at-start-response bytes");
}

static void test_395(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x27, 0x21, 0x00, 0x0F, 0x93, 0x70};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_write_register_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-output-at-end-request opens");
    expect(opened.unit_address == 1u, "example rtu-output-at-end-request: station");
    expect(opened.code == 6u, "example rtu-output-at-end-request: code");
    expect(ck10_write_register_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-output-at-end-request decodes");
    expect(out.address == 10017u, "example rtu-output-at-end-request: address");
    expect(out.value == 15u, "example rtu-output-at-end-request: value");
    in.address = 10017u;
    in.value = 15u;
    expect(ck10_rtu_encode_write_register_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-output-at-end-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-output-at-end-request bytes");
}

static void test_396(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x27, 0x21, 0x00, 0x0F, 0x93, 0x70};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_write_register_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-output-at-end-response opens");
    expect(opened.unit_address == 1u, "example rtu-output-at-end-response: station");
    expect(opened.code == 6u, "example rtu-output-at-end-response: code");
    expect(opened.error == false, "example rtu-output-at-end-response: error");
    expect(ck10_write_register_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-output-at-end-response decodes");
    expect(out.address == 10017u, "example rtu-output-at-end-response: address");
    expect(out.value == 15u, "example rtu-output-at-end-response: value");
    in.address = 10017u;
    in.value = 15u;
    expect(ck10_rtu_encode_write_register_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-output-at-end-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-output-at-end-response bytes");
}

static void test_397(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x30, 0x36, 0x32, 0x37, 0x32, 0x31, 0x30, 0x30, 0x31, 0x31, 0x41, 0x30, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_request_frame opened;
    ck10_write_register_request in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-output-at-trigger-request opens");
    expect(opened.unit_address == 1u, "example ascii-output-at-trigger-request: station");
    expect(opened.code == 6u, "example ascii-output-at-trigger-request: code");
    expect(ck10_write_register_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-output-at-trigger-request decodes");
    expect(out.address == 10017u, "example ascii-output-at-trigger-request: address");
    expect(out.value == 17u, "example ascii-output-at-trigger-request: value");
    in.address = 10017u;
    in.value = 17u;
    expect(ck10_ascii_encode_write_register_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-output-at-trigger-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-output-at-trigger-request bytes");
}

static void test_398(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x30, 0x36, 0x32, 0x37, 0x32, 0x31, 0x30, 0x30, 0x31, 0x31, 0x41, 0x30, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_response_frame opened;
    ck10_write_register_response in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_response_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-output-at-trigger-response opens");
    expect(opened.unit_address == 1u, "example ascii-output-at-trigger-response: station");
    expect(opened.code == 6u, "example ascii-output-at-trigger-response: code");
    expect(opened.error == false, "example ascii-output-at-trigger-response: error");
    expect(ck10_write_register_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-output-at-trigger-response decodes");
    expect(out.address == 10017u, "example ascii-output-at-trigger-response: address");
    expect(out.value == 17u, "example ascii-output-at-trigger-response: value");
    in.address = 10017u;
    in.value = 17u;
    expect(ck10_ascii_encode_write_register_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-output-at-trigger-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-output-at-trigger-response bytes");
}

static void test_399(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x27, 0x1B, 0xFF, 0xFF, 0xF2, 0xC9};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_write_register_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-jump-ignored-request opens");
    expect(opened.unit_address == 1u, "example rtu-jump-ignored-request: station");
    expect(opened.code == 6u, "example rtu-jump-ignored-request: code");
    expect(ck10_write_register_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-jump-ignored-request decodes");
    expect(out.address == 10011u, "example rtu-jump-ignored-request: address");
    expect(out.value == 65535u, "example rtu-jump-ignored-request: value");
    in.address = 10011u;
    in.value = 65535u;
    expect(ck10_rtu_encode_write_register_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-jump-ignored-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-jump-ignored-request bytes");
}

static void test_400(void)
{
    static const uint8_t frame[] = {0x01, 0x06, 0x27, 0x1B, 0xFF, 0xFF, 0xF2, 0xC9};
    uint8_t received[sizeof frame];
    ck10_rtu_response_frame opened;
    ck10_write_register_response in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_response_open(received, sizeof received, &opened) == CK10_OK, "example rtu-jump-ignored-response opens");
    expect(opened.unit_address == 1u, "example rtu-jump-ignored-response: station");
    expect(opened.code == 6u, "example rtu-jump-ignored-response: code");
    expect(opened.error == false, "example rtu-jump-ignored-response: error");
    expect(ck10_write_register_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-jump-ignored-response decodes");
    expect(out.address == 10011u, "example rtu-jump-ignored-response: address");
    expect(out.value == 65535u, "example rtu-jump-ignored-response: value");
    in.address = 10011u;
    in.value = 65535u;
    expect(ck10_rtu_encode_write_register_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-jump-ignored-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-jump-ignored-response bytes");
}

static void test_401(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x30, 0x36, 0x32, 0x37, 0x31, 0x42, 0x32, 0x37, 0x38, 0x46, 0x30, 0x31, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_request_frame opened;
    ck10_write_register_request in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-jump-waiting-request opens");
    expect(opened.unit_address == 1u, "example ascii-jump-waiting-request: station");
    expect(opened.code == 6u, "example ascii-jump-waiting-request: code");
    expect(ck10_write_register_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-jump-waiting-request decodes");
    expect(out.address == 10011u, "example ascii-jump-waiting-request: address");
    expect(out.value == 10127u, "example ascii-jump-waiting-request: value");
    in.address = 10011u;
    in.value = 10127u;
    expect(ck10_ascii_encode_write_register_request(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-jump-waiting-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-jump-waiting-request bytes");
}

static void test_402(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x31, 0x30, 0x36, 0x32, 0x37, 0x31, 0x42, 0x32, 0x37, 0x38, 0x46, 0x30, 0x31, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_response_frame opened;
    ck10_write_register_response in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_response_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-jump-waiting-response opens");
    expect(opened.unit_address == 1u, "example ascii-jump-waiting-response: station");
    expect(opened.code == 6u, "example ascii-jump-waiting-response: code");
    expect(opened.error == false, "example ascii-jump-waiting-response: error");
    expect(ck10_write_register_response_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-jump-waiting-response decodes");
    expect(out.address == 10011u, "example ascii-jump-waiting-response: address");
    expect(out.value == 10127u, "example ascii-jump-waiting-response: value");
    in.address = 10011u;
    in.value = 10127u;
    expect(ck10_ascii_encode_write_register_response(1u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-jump-waiting-response encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-jump-waiting-response bytes");
}

static void test_403(void)
{
    static const uint8_t frame[] = {0x00, 0x06, 0x07, 0xF0, 0x00, 0x00, 0x89, 0x5C};
    uint8_t received[sizeof frame];
    ck10_rtu_request_frame opened;
    ck10_write_register_request in, out;
    uint8_t again[sizeof frame + 0];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_rtu_request_open(received, sizeof received, &opened) == CK10_OK, "example rtu-stop-all-request opens");
    expect(opened.unit_address == 0u, "example rtu-stop-all-request: station");
    expect(opened.code == 6u, "example rtu-stop-all-request: code");
    expect(ck10_write_register_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example rtu-stop-all-request decodes");
    expect(out.address == 2032u, "example rtu-stop-all-request: address");
    expect(out.value == 0u, "example rtu-stop-all-request: value");
    in.address = 2032u;
    in.value = 0u;
    expect(ck10_rtu_encode_write_register_request(0u, &in, again, sizeof again, &length) == CK10_OK, "example rtu-stop-all-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example rtu-stop-all-request bytes");
}

static void test_404(void)
{
    static const uint8_t frame[] = {0x3A, 0x30, 0x30, 0x30, 0x36, 0x30, 0x37, 0x46, 0x30, 0x30, 0x30, 0x30, 0x30, 0x30, 0x33, 0x0D, 0x0A};
    uint8_t received[sizeof frame];
    uint8_t buffer[sizeof frame];
    ck10_ascii_request_frame opened;
    ck10_write_register_request in, out;
    uint8_t again[sizeof frame + 3];
    size_t length = 0;
    clear(&in, sizeof in);
    clear(&out, sizeof out);
    copy(received, frame, sizeof frame);
    clear(&opened, sizeof opened);
    expect(ck10_ascii_request_open(received, sizeof received, buffer, sizeof buffer, &opened) == CK10_OK, "example ascii-stop-all-request opens");
    expect(opened.unit_address == 0u, "example ascii-stop-all-request: station");
    expect(opened.code == 6u, "example ascii-stop-all-request: code");
    expect(ck10_write_register_request_decode(opened.body, opened.body_length, &out) == CK10_OK, "example ascii-stop-all-request decodes");
    expect(out.address == 2032u, "example ascii-stop-all-request: address");
    expect(out.value == 0u, "example ascii-stop-all-request: value");
    in.address = 2032u;
    in.value = 0u;
    expect(ck10_ascii_encode_write_register_request(0u, &in, again, sizeof again, &length) == CK10_OK, "example ascii-stop-all-request encodes");
    expect(length == sizeof frame && same_bytes(again, frame, length), "example ascii-stop-all-request bytes");
}

static void test_405(void)
{
    expect(ck10_point_command_is_absent(CK10_POINT_COMMAND_ABSENT_IGNORED) == true, "ck10_point_command_is_absent ignored");
    expect(ck10_point_command_is_absent(0u) == false, "ck10_point_command_is_absent 0");
    expect(ck10_point_command_is_absent(1u) == false, "ck10_point_command_is_absent 1");
    expect(ck10_point_command_is_absent(65534u) == false, "ck10_point_command_is_absent 65534");
}

static void test_406(void)
{
    expect(ck10_point_jump_point_is_absent(CK10_POINT_JUMP_POINT_ABSENT_IGNORED) == true, "ck10_point_jump_point_is_absent ignored");
    expect(ck10_point_jump_point_is_absent(0u) == false, "ck10_point_jump_point_is_absent 0");
    expect(ck10_point_jump_point_is_absent(1u) == false, "ck10_point_jump_point_is_absent 1");
    expect(ck10_point_jump_point_is_absent(65534u) == false, "ck10_point_jump_point_is_absent 65534");
}

static void test_407(void)
{
    expect(ck10_point_jump_point_of_input_0_is_absent(CK10_POINT_JUMP_POINT_OF_INPUT_0_ABSENT_IGNORED) == true, "ck10_point_jump_point_of_input_0_is_absent ignored");
    expect(ck10_point_jump_point_of_input_0_is_absent(0u) == false, "ck10_point_jump_point_of_input_0_is_absent 0");
    expect(ck10_point_jump_point_of_input_0_is_absent(1u) == false, "ck10_point_jump_point_of_input_0_is_absent 1");
    expect(ck10_point_jump_point_of_input_0_is_absent(65534u) == false, "ck10_point_jump_point_of_input_0_is_absent 65534");
}

static void test_408(void)
{
    expect(ck10_point_jump_point_of_input_1_is_absent(CK10_POINT_JUMP_POINT_OF_INPUT_1_ABSENT_IGNORED) == true, "ck10_point_jump_point_of_input_1_is_absent ignored");
    expect(ck10_point_jump_point_of_input_1_is_absent(0u) == false, "ck10_point_jump_point_of_input_1_is_absent 0");
    expect(ck10_point_jump_point_of_input_1_is_absent(1u) == false, "ck10_point_jump_point_of_input_1_is_absent 1");
    expect(ck10_point_jump_point_of_input_1_is_absent(65534u) == false, "ck10_point_jump_point_of_input_1_is_absent 65534");
}

static void test_409(void)
{
    expect(ck10_point_jump_point_of_input_2_is_absent(CK10_POINT_JUMP_POINT_OF_INPUT_2_ABSENT_IGNORED) == true, "ck10_point_jump_point_of_input_2_is_absent ignored");
    expect(ck10_point_jump_point_of_input_2_is_absent(0u) == false, "ck10_point_jump_point_of_input_2_is_absent 0");
    expect(ck10_point_jump_point_of_input_2_is_absent(1u) == false, "ck10_point_jump_point_of_input_2_is_absent 1");
    expect(ck10_point_jump_point_of_input_2_is_absent(65534u) == false, "ck10_point_jump_point_of_input_2_is_absent 65534");
}

static void test_410(void)
{
    expect(ck10_point_clear_loop_counter_of_is_absent(CK10_POINT_CLEAR_LOOP_COUNTER_OF_ABSENT_IGNORED) == true, "ck10_point_clear_loop_counter_of_is_absent ignored");
    expect(ck10_point_clear_loop_counter_of_is_absent(0u) == false, "ck10_point_clear_loop_counter_of_is_absent 0");
    expect(ck10_point_clear_loop_counter_of_is_absent(1u) == false, "ck10_point_clear_loop_counter_of_is_absent 1");
    expect(ck10_point_clear_loop_counter_of_is_absent(65534u) == false, "ck10_point_clear_loop_counter_of_is_absent 65534");
}

static void test_411(void)
{
    expect(ck10_point_push_mode_is_absent(CK10_POINT_PUSH_MODE_ABSENT_STOP_MODE) == true, "ck10_point_push_mode_is_absent stop_mode");
    expect(ck10_point_push_mode_is_absent(1u) == false, "ck10_point_push_mode_is_absent 1");
}

static void test_412(void)
{
    expect(ck10_point_low_speed_is_out_of_range(0u) == true, "ck10_point_low_speed_is_out_of_range 0");
    expect(ck10_point_low_speed_is_out_of_range(1u) == false, "ck10_point_low_speed_is_out_of_range 1");
    expect(ck10_point_low_speed_is_out_of_range(2u) == false, "ck10_point_low_speed_is_out_of_range 2");
    expect(ck10_point_low_speed_is_out_of_range(34999u) == false, "ck10_point_low_speed_is_out_of_range 34999");
    expect(ck10_point_low_speed_is_out_of_range(35000u) == false, "ck10_point_low_speed_is_out_of_range 35000");
    expect(ck10_point_low_speed_is_out_of_range(35001u) == true, "ck10_point_low_speed_is_out_of_range 35001");
}

static void test_413(void)
{
    expect(ck10_point_high_speed_is_out_of_range(0u) == true, "ck10_point_high_speed_is_out_of_range 0");
    expect(ck10_point_high_speed_is_out_of_range(1u) == false, "ck10_point_high_speed_is_out_of_range 1");
    expect(ck10_point_high_speed_is_out_of_range(2u) == false, "ck10_point_high_speed_is_out_of_range 2");
    expect(ck10_point_high_speed_is_out_of_range(499999u) == false, "ck10_point_high_speed_is_out_of_range 499999");
    expect(ck10_point_high_speed_is_out_of_range(500000u) == false, "ck10_point_high_speed_is_out_of_range 500000");
    expect(ck10_point_high_speed_is_out_of_range(500001u) == true, "ck10_point_high_speed_is_out_of_range 500001");
}

static void test_414(void)
{
    expect(ck10_point_acceleration_time_is_out_of_range(0u) == true, "ck10_point_acceleration_time_is_out_of_range 0");
    expect(ck10_point_acceleration_time_is_out_of_range(1u) == false, "ck10_point_acceleration_time_is_out_of_range 1");
    expect(ck10_point_acceleration_time_is_out_of_range(2u) == false, "ck10_point_acceleration_time_is_out_of_range 2");
    expect(ck10_point_acceleration_time_is_out_of_range(9998u) == false, "ck10_point_acceleration_time_is_out_of_range 9998");
    expect(ck10_point_acceleration_time_is_out_of_range(9999u) == false, "ck10_point_acceleration_time_is_out_of_range 9999");
    expect(ck10_point_acceleration_time_is_out_of_range(10000u) == true, "ck10_point_acceleration_time_is_out_of_range 10000");
}

static void test_415(void)
{
    expect(ck10_point_deceleration_time_is_out_of_range(0u) == true, "ck10_point_deceleration_time_is_out_of_range 0");
    expect(ck10_point_deceleration_time_is_out_of_range(1u) == false, "ck10_point_deceleration_time_is_out_of_range 1");
    expect(ck10_point_deceleration_time_is_out_of_range(2u) == false, "ck10_point_deceleration_time_is_out_of_range 2");
    expect(ck10_point_deceleration_time_is_out_of_range(9998u) == false, "ck10_point_deceleration_time_is_out_of_range 9998");
    expect(ck10_point_deceleration_time_is_out_of_range(9999u) == false, "ck10_point_deceleration_time_is_out_of_range 9999");
    expect(ck10_point_deceleration_time_is_out_of_range(10000u) == true, "ck10_point_deceleration_time_is_out_of_range 10000");
}

static void test_416(void)
{
    expect(ck10_point_waiting_time_is_out_of_range(0u) == false, "ck10_point_waiting_time_is_out_of_range 0");
    expect(ck10_point_waiting_time_is_out_of_range(1u) == false, "ck10_point_waiting_time_is_out_of_range 1");
    expect(ck10_point_waiting_time_is_out_of_range(59999u) == false, "ck10_point_waiting_time_is_out_of_range 59999");
    expect(ck10_point_waiting_time_is_out_of_range(60000u) == false, "ck10_point_waiting_time_is_out_of_range 60000");
    expect(ck10_point_waiting_time_is_out_of_range(60001u) == true, "ck10_point_waiting_time_is_out_of_range 60001");
}

static void test_417(void)
{
    expect(ck10_point_jump_point_is_out_of_range(0u) == false, "ck10_point_jump_point_is_out_of_range 0");
    expect(ck10_point_jump_point_is_out_of_range(1u) == false, "ck10_point_jump_point_is_out_of_range 1");
    expect(ck10_point_jump_point_is_out_of_range(126u) == false, "ck10_point_jump_point_is_out_of_range 126");
    expect(ck10_point_jump_point_is_out_of_range(127u) == false, "ck10_point_jump_point_is_out_of_range 127");
    expect(ck10_point_jump_point_is_out_of_range(128u) == true, "ck10_point_jump_point_is_out_of_range 128");
    expect(ck10_point_jump_point_is_out_of_range(9999u) == true, "ck10_point_jump_point_is_out_of_range 9999");
    expect(ck10_point_jump_point_is_out_of_range(10000u) == false, "ck10_point_jump_point_is_out_of_range 10000");
    expect(ck10_point_jump_point_is_out_of_range(10001u) == false, "ck10_point_jump_point_is_out_of_range 10001");
    expect(ck10_point_jump_point_is_out_of_range(10126u) == false, "ck10_point_jump_point_is_out_of_range 10126");
    expect(ck10_point_jump_point_is_out_of_range(10127u) == false, "ck10_point_jump_point_is_out_of_range 10127");
    expect(ck10_point_jump_point_is_out_of_range(10128u) == true, "ck10_point_jump_point_is_out_of_range 10128");
    expect(ck10_point_jump_point_is_out_of_range(65534u) == true, "ck10_point_jump_point_is_out_of_range 65534");
    expect(ck10_point_jump_point_is_out_of_range(65535u) == false, "ck10_point_jump_point_is_out_of_range 65535");
}

static void test_418(void)
{
    expect(ck10_point_jump_point_of_input_0_is_out_of_range(0u) == false, "ck10_point_jump_point_of_input_0_is_out_of_range 0");
    expect(ck10_point_jump_point_of_input_0_is_out_of_range(1u) == false, "ck10_point_jump_point_of_input_0_is_out_of_range 1");
    expect(ck10_point_jump_point_of_input_0_is_out_of_range(126u) == false, "ck10_point_jump_point_of_input_0_is_out_of_range 126");
    expect(ck10_point_jump_point_of_input_0_is_out_of_range(127u) == false, "ck10_point_jump_point_of_input_0_is_out_of_range 127");
    expect(ck10_point_jump_point_of_input_0_is_out_of_range(128u) == true, "ck10_point_jump_point_of_input_0_is_out_of_range 128");
    expect(ck10_point_jump_point_of_input_0_is_out_of_range(9999u) == true, "ck10_point_jump_point_of_input_0_is_out_of_range 9999");
    expect(ck10_point_jump_point_of_input_0_is_out_of_range(10000u) == false, "ck10_point_jump_point_of_input_0_is_out_of_range 10000");
    expect(ck10_point_jump_point_of_input_0_is_out_of_range(10001u) == false, "ck10_point_jump_point_of_input_0_is_out_of_range 10001");
    expect(ck10_point_jump_point_of_input_0_is_out_of_range(10126u) == false, "ck10_point_jump_point_of_input_0_is_out_of_range 10126");
    expect(ck10_point_jump_point_of_input_0_is_out_of_range(10127u) == false, "ck10_point_jump_point_of_input_0_is_out_of_range 10127");
    expect(ck10_point_jump_point_of_input_0_is_out_of_range(10128u) == true, "ck10_point_jump_point_of_input_0_is_out_of_range 10128");
    expect(ck10_point_jump_point_of_input_0_is_out_of_range(65534u) == true, "ck10_point_jump_point_of_input_0_is_out_of_range 65534");
    expect(ck10_point_jump_point_of_input_0_is_out_of_range(65535u) == false, "ck10_point_jump_point_of_input_0_is_out_of_range 65535");
}

static void test_419(void)
{
    expect(ck10_point_jump_point_of_input_1_is_out_of_range(0u) == false, "ck10_point_jump_point_of_input_1_is_out_of_range 0");
    expect(ck10_point_jump_point_of_input_1_is_out_of_range(1u) == false, "ck10_point_jump_point_of_input_1_is_out_of_range 1");
    expect(ck10_point_jump_point_of_input_1_is_out_of_range(126u) == false, "ck10_point_jump_point_of_input_1_is_out_of_range 126");
    expect(ck10_point_jump_point_of_input_1_is_out_of_range(127u) == false, "ck10_point_jump_point_of_input_1_is_out_of_range 127");
    expect(ck10_point_jump_point_of_input_1_is_out_of_range(128u) == true, "ck10_point_jump_point_of_input_1_is_out_of_range 128");
    expect(ck10_point_jump_point_of_input_1_is_out_of_range(9999u) == true, "ck10_point_jump_point_of_input_1_is_out_of_range 9999");
    expect(ck10_point_jump_point_of_input_1_is_out_of_range(10000u) == false, "ck10_point_jump_point_of_input_1_is_out_of_range 10000");
    expect(ck10_point_jump_point_of_input_1_is_out_of_range(10001u) == false, "ck10_point_jump_point_of_input_1_is_out_of_range 10001");
    expect(ck10_point_jump_point_of_input_1_is_out_of_range(10126u) == false, "ck10_point_jump_point_of_input_1_is_out_of_range 10126");
    expect(ck10_point_jump_point_of_input_1_is_out_of_range(10127u) == false, "ck10_point_jump_point_of_input_1_is_out_of_range 10127");
    expect(ck10_point_jump_point_of_input_1_is_out_of_range(10128u) == true, "ck10_point_jump_point_of_input_1_is_out_of_range 10128");
    expect(ck10_point_jump_point_of_input_1_is_out_of_range(65534u) == true, "ck10_point_jump_point_of_input_1_is_out_of_range 65534");
    expect(ck10_point_jump_point_of_input_1_is_out_of_range(65535u) == false, "ck10_point_jump_point_of_input_1_is_out_of_range 65535");
}

static void test_420(void)
{
    expect(ck10_point_jump_point_of_input_2_is_out_of_range(0u) == false, "ck10_point_jump_point_of_input_2_is_out_of_range 0");
    expect(ck10_point_jump_point_of_input_2_is_out_of_range(1u) == false, "ck10_point_jump_point_of_input_2_is_out_of_range 1");
    expect(ck10_point_jump_point_of_input_2_is_out_of_range(126u) == false, "ck10_point_jump_point_of_input_2_is_out_of_range 126");
    expect(ck10_point_jump_point_of_input_2_is_out_of_range(127u) == false, "ck10_point_jump_point_of_input_2_is_out_of_range 127");
    expect(ck10_point_jump_point_of_input_2_is_out_of_range(128u) == true, "ck10_point_jump_point_of_input_2_is_out_of_range 128");
    expect(ck10_point_jump_point_of_input_2_is_out_of_range(9999u) == true, "ck10_point_jump_point_of_input_2_is_out_of_range 9999");
    expect(ck10_point_jump_point_of_input_2_is_out_of_range(10000u) == false, "ck10_point_jump_point_of_input_2_is_out_of_range 10000");
    expect(ck10_point_jump_point_of_input_2_is_out_of_range(10001u) == false, "ck10_point_jump_point_of_input_2_is_out_of_range 10001");
    expect(ck10_point_jump_point_of_input_2_is_out_of_range(10126u) == false, "ck10_point_jump_point_of_input_2_is_out_of_range 10126");
    expect(ck10_point_jump_point_of_input_2_is_out_of_range(10127u) == false, "ck10_point_jump_point_of_input_2_is_out_of_range 10127");
    expect(ck10_point_jump_point_of_input_2_is_out_of_range(10128u) == true, "ck10_point_jump_point_of_input_2_is_out_of_range 10128");
    expect(ck10_point_jump_point_of_input_2_is_out_of_range(65534u) == true, "ck10_point_jump_point_of_input_2_is_out_of_range 65534");
    expect(ck10_point_jump_point_of_input_2_is_out_of_range(65535u) == false, "ck10_point_jump_point_of_input_2_is_out_of_range 65535");
}

static void test_421(void)
{
    expect(ck10_point_loop_count_is_out_of_range(0u) == false, "ck10_point_loop_count_is_out_of_range 0");
    expect(ck10_point_loop_count_is_out_of_range(1u) == false, "ck10_point_loop_count_is_out_of_range 1");
    expect(ck10_point_loop_count_is_out_of_range(99u) == false, "ck10_point_loop_count_is_out_of_range 99");
    expect(ck10_point_loop_count_is_out_of_range(100u) == false, "ck10_point_loop_count_is_out_of_range 100");
    expect(ck10_point_loop_count_is_out_of_range(101u) == true, "ck10_point_loop_count_is_out_of_range 101");
}

static void test_422(void)
{
    expect(ck10_point_loop_jump_point_is_out_of_range(0u) == false, "ck10_point_loop_jump_point_is_out_of_range 0");
    expect(ck10_point_loop_jump_point_is_out_of_range(1u) == false, "ck10_point_loop_jump_point_is_out_of_range 1");
    expect(ck10_point_loop_jump_point_is_out_of_range(126u) == false, "ck10_point_loop_jump_point_is_out_of_range 126");
    expect(ck10_point_loop_jump_point_is_out_of_range(127u) == false, "ck10_point_loop_jump_point_is_out_of_range 127");
    expect(ck10_point_loop_jump_point_is_out_of_range(128u) == true, "ck10_point_loop_jump_point_is_out_of_range 128");
    expect(ck10_point_loop_jump_point_is_out_of_range(9999u) == true, "ck10_point_loop_jump_point_is_out_of_range 9999");
    expect(ck10_point_loop_jump_point_is_out_of_range(10000u) == false, "ck10_point_loop_jump_point_is_out_of_range 10000");
    expect(ck10_point_loop_jump_point_is_out_of_range(10001u) == false, "ck10_point_loop_jump_point_is_out_of_range 10001");
    expect(ck10_point_loop_jump_point_is_out_of_range(10126u) == false, "ck10_point_loop_jump_point_is_out_of_range 10126");
    expect(ck10_point_loop_jump_point_is_out_of_range(10127u) == false, "ck10_point_loop_jump_point_is_out_of_range 10127");
    expect(ck10_point_loop_jump_point_is_out_of_range(10128u) == true, "ck10_point_loop_jump_point_is_out_of_range 10128");
}

static void test_423(void)
{
    expect(ck10_point_output_setting_is_out_of_range(0u) == false, "ck10_point_output_setting_is_out_of_range 0");
    expect(ck10_point_output_setting_is_out_of_range(1u) == false, "ck10_point_output_setting_is_out_of_range 1");
    expect(ck10_point_output_setting_is_out_of_range(22u) == false, "ck10_point_output_setting_is_out_of_range 22");
    expect(ck10_point_output_setting_is_out_of_range(23u) == false, "ck10_point_output_setting_is_out_of_range 23");
    expect(ck10_point_output_setting_is_out_of_range(24u) == true, "ck10_point_output_setting_is_out_of_range 24");
}

static void test_424(void)
{
    expect(ck10_point_clear_loop_counter_of_is_out_of_range(0u) == false, "ck10_point_clear_loop_counter_of_is_out_of_range 0");
    expect(ck10_point_clear_loop_counter_of_is_out_of_range(1u) == false, "ck10_point_clear_loop_counter_of_is_out_of_range 1");
    expect(ck10_point_clear_loop_counter_of_is_out_of_range(126u) == false, "ck10_point_clear_loop_counter_of_is_out_of_range 126");
    expect(ck10_point_clear_loop_counter_of_is_out_of_range(127u) == false, "ck10_point_clear_loop_counter_of_is_out_of_range 127");
    expect(ck10_point_clear_loop_counter_of_is_out_of_range(128u) == true, "ck10_point_clear_loop_counter_of_is_out_of_range 128");
    expect(ck10_point_clear_loop_counter_of_is_out_of_range(65534u) == true, "ck10_point_clear_loop_counter_of_is_out_of_range 65534");
    expect(ck10_point_clear_loop_counter_of_is_out_of_range(65535u) == false, "ck10_point_clear_loop_counter_of_is_out_of_range 65535");
}

static void test_425(void)
{
    expect(ck10_point_push_torque_ratio_is_out_of_range(19u) == true, "ck10_point_push_torque_ratio_is_out_of_range 19");
    expect(ck10_point_push_torque_ratio_is_out_of_range(20u) == false, "ck10_point_push_torque_ratio_is_out_of_range 20");
    expect(ck10_point_push_torque_ratio_is_out_of_range(21u) == false, "ck10_point_push_torque_ratio_is_out_of_range 21");
    expect(ck10_point_push_torque_ratio_is_out_of_range(89u) == false, "ck10_point_push_torque_ratio_is_out_of_range 89");
    expect(ck10_point_push_torque_ratio_is_out_of_range(90u) == false, "ck10_point_push_torque_ratio_is_out_of_range 90");
    expect(ck10_point_push_torque_ratio_is_out_of_range(91u) == true, "ck10_point_push_torque_ratio_is_out_of_range 91");
}

static void test_426(void)
{
    expect(ck10_point_push_speed_is_out_of_range(0u) == true, "ck10_point_push_speed_is_out_of_range 0");
    expect(ck10_point_push_speed_is_out_of_range(1u) == false, "ck10_point_push_speed_is_out_of_range 1");
    expect(ck10_point_push_speed_is_out_of_range(2u) == false, "ck10_point_push_speed_is_out_of_range 2");
    expect(ck10_point_push_speed_is_out_of_range(33332u) == false, "ck10_point_push_speed_is_out_of_range 33332");
    expect(ck10_point_push_speed_is_out_of_range(33333u) == false, "ck10_point_push_speed_is_out_of_range 33333");
    expect(ck10_point_push_speed_is_out_of_range(33334u) == true, "ck10_point_push_speed_is_out_of_range 33334");
}

static void test_427(void)
{
    expect(ck10_point_push_mode_is_out_of_range(0u) == false, "ck10_point_push_mode_is_out_of_range 0");
    expect(ck10_point_push_mode_is_out_of_range(1u) == false, "ck10_point_push_mode_is_out_of_range 1");
    expect(ck10_point_push_mode_is_out_of_range(9999u) == false, "ck10_point_push_mode_is_out_of_range 9999");
    expect(ck10_point_push_mode_is_out_of_range(10000u) == false, "ck10_point_push_mode_is_out_of_range 10000");
    expect(ck10_point_push_mode_is_out_of_range(10001u) == true, "ck10_point_push_mode_is_out_of_range 10001");
}

static void test_428(void)
{
    expect(ck10_read_registers_request_word_count_is_out_of_range(0u) == true, "ck10_read_registers_request_word_count_is_out_of_range 0");
    expect(ck10_read_registers_request_word_count_is_out_of_range(1u) == false, "ck10_read_registers_request_word_count_is_out_of_range 1");
    expect(ck10_read_registers_request_word_count_is_out_of_range(2u) == false, "ck10_read_registers_request_word_count_is_out_of_range 2");
    expect(ck10_read_registers_request_word_count_is_out_of_range(124u) == false, "ck10_read_registers_request_word_count_is_out_of_range 124");
    expect(ck10_read_registers_request_word_count_is_out_of_range(125u) == false, "ck10_read_registers_request_word_count_is_out_of_range 125");
    expect(ck10_read_registers_request_word_count_is_out_of_range(126u) == true, "ck10_read_registers_request_word_count_is_out_of_range 126");
}

static void test_429(void)
{
    expect(ck10_write_registers_request_word_count_is_out_of_range(0u) == true, "ck10_write_registers_request_word_count_is_out_of_range 0");
    expect(ck10_write_registers_request_word_count_is_out_of_range(1u) == false, "ck10_write_registers_request_word_count_is_out_of_range 1");
    expect(ck10_write_registers_request_word_count_is_out_of_range(2u) == false, "ck10_write_registers_request_word_count_is_out_of_range 2");
    expect(ck10_write_registers_request_word_count_is_out_of_range(122u) == false, "ck10_write_registers_request_word_count_is_out_of_range 122");
    expect(ck10_write_registers_request_word_count_is_out_of_range(123u) == false, "ck10_write_registers_request_word_count_is_out_of_range 123");
    expect(ck10_write_registers_request_word_count_is_out_of_range(124u) == true, "ck10_write_registers_request_word_count_is_out_of_range 124");
}

static void test_430(void)
{
    expect(ck10_reg_compare_pulse_width_is_out_of_range(0u) == true, "ck10_reg_compare_pulse_width_is_out_of_range 0");
    expect(ck10_reg_compare_pulse_width_is_out_of_range(1u) == false, "ck10_reg_compare_pulse_width_is_out_of_range 1");
    expect(ck10_reg_compare_pulse_width_is_out_of_range(2u) == false, "ck10_reg_compare_pulse_width_is_out_of_range 2");
    expect(ck10_reg_compare_pulse_width_is_out_of_range(999u) == false, "ck10_reg_compare_pulse_width_is_out_of_range 999");
    expect(ck10_reg_compare_pulse_width_is_out_of_range(1000u) == false, "ck10_reg_compare_pulse_width_is_out_of_range 1000");
    expect(ck10_reg_compare_pulse_width_is_out_of_range(1001u) == true, "ck10_reg_compare_pulse_width_is_out_of_range 1001");
}

static void test_431(void)
{
    expect(ck10_reg_resolution_is_out_of_range(0u) == false, "ck10_reg_resolution_is_out_of_range 0");
    expect(ck10_reg_resolution_is_out_of_range(1u) == false, "ck10_reg_resolution_is_out_of_range 1");
    expect(ck10_reg_resolution_is_out_of_range(49999u) == false, "ck10_reg_resolution_is_out_of_range 49999");
    expect(ck10_reg_resolution_is_out_of_range(50000u) == false, "ck10_reg_resolution_is_out_of_range 50000");
    expect(ck10_reg_resolution_is_out_of_range(50001u) == true, "ck10_reg_resolution_is_out_of_range 50001");
}

static void test_432(void)
{
    expect(ck10_reg_maximum_speed_is_out_of_range(0u) == true, "ck10_reg_maximum_speed_is_out_of_range 0");
    expect(ck10_reg_maximum_speed_is_out_of_range(1u) == false, "ck10_reg_maximum_speed_is_out_of_range 1");
    expect(ck10_reg_maximum_speed_is_out_of_range(2u) == false, "ck10_reg_maximum_speed_is_out_of_range 2");
    expect(ck10_reg_maximum_speed_is_out_of_range(799999u) == false, "ck10_reg_maximum_speed_is_out_of_range 799999");
    expect(ck10_reg_maximum_speed_is_out_of_range(800000u) == false, "ck10_reg_maximum_speed_is_out_of_range 800000");
    expect(ck10_reg_maximum_speed_is_out_of_range(800001u) == true, "ck10_reg_maximum_speed_is_out_of_range 800001");
}

static void test_433(void)
{
    expect(ck10_reg_start_speed_is_out_of_range(0u) == true, "ck10_reg_start_speed_is_out_of_range 0");
    expect(ck10_reg_start_speed_is_out_of_range(1u) == false, "ck10_reg_start_speed_is_out_of_range 1");
    expect(ck10_reg_start_speed_is_out_of_range(2u) == false, "ck10_reg_start_speed_is_out_of_range 2");
    expect(ck10_reg_start_speed_is_out_of_range(34999u) == false, "ck10_reg_start_speed_is_out_of_range 34999");
    expect(ck10_reg_start_speed_is_out_of_range(35000u) == false, "ck10_reg_start_speed_is_out_of_range 35000");
    expect(ck10_reg_start_speed_is_out_of_range(35001u) == true, "ck10_reg_start_speed_is_out_of_range 35001");
}

static void test_434(void)
{
    expect(ck10_reg_acceleration_time_is_out_of_range(0u) == true, "ck10_reg_acceleration_time_is_out_of_range 0");
    expect(ck10_reg_acceleration_time_is_out_of_range(1u) == false, "ck10_reg_acceleration_time_is_out_of_range 1");
    expect(ck10_reg_acceleration_time_is_out_of_range(2u) == false, "ck10_reg_acceleration_time_is_out_of_range 2");
    expect(ck10_reg_acceleration_time_is_out_of_range(9998u) == false, "ck10_reg_acceleration_time_is_out_of_range 9998");
    expect(ck10_reg_acceleration_time_is_out_of_range(9999u) == false, "ck10_reg_acceleration_time_is_out_of_range 9999");
    expect(ck10_reg_acceleration_time_is_out_of_range(10000u) == true, "ck10_reg_acceleration_time_is_out_of_range 10000");
}

static void test_435(void)
{
    expect(ck10_reg_deceleration_time_is_out_of_range(0u) == true, "ck10_reg_deceleration_time_is_out_of_range 0");
    expect(ck10_reg_deceleration_time_is_out_of_range(1u) == false, "ck10_reg_deceleration_time_is_out_of_range 1");
    expect(ck10_reg_deceleration_time_is_out_of_range(2u) == false, "ck10_reg_deceleration_time_is_out_of_range 2");
    expect(ck10_reg_deceleration_time_is_out_of_range(9998u) == false, "ck10_reg_deceleration_time_is_out_of_range 9998");
    expect(ck10_reg_deceleration_time_is_out_of_range(9999u) == false, "ck10_reg_deceleration_time_is_out_of_range 9999");
    expect(ck10_reg_deceleration_time_is_out_of_range(10000u) == true, "ck10_reg_deceleration_time_is_out_of_range 10000");
}

static void test_436(void)
{
    expect(ck10_reg_jog_speed_is_out_of_range(0u) == true, "ck10_reg_jog_speed_is_out_of_range 0");
    expect(ck10_reg_jog_speed_is_out_of_range(1u) == false, "ck10_reg_jog_speed_is_out_of_range 1");
    expect(ck10_reg_jog_speed_is_out_of_range(2u) == false, "ck10_reg_jog_speed_is_out_of_range 2");
    expect(ck10_reg_jog_speed_is_out_of_range(799999u) == false, "ck10_reg_jog_speed_is_out_of_range 799999");
    expect(ck10_reg_jog_speed_is_out_of_range(800000u) == false, "ck10_reg_jog_speed_is_out_of_range 800000");
    expect(ck10_reg_jog_speed_is_out_of_range(800001u) == true, "ck10_reg_jog_speed_is_out_of_range 800001");
}

static void test_437(void)
{
    expect(ck10_reg_jog_start_speed_is_out_of_range(0u) == true, "ck10_reg_jog_start_speed_is_out_of_range 0");
    expect(ck10_reg_jog_start_speed_is_out_of_range(1u) == false, "ck10_reg_jog_start_speed_is_out_of_range 1");
    expect(ck10_reg_jog_start_speed_is_out_of_range(2u) == false, "ck10_reg_jog_start_speed_is_out_of_range 2");
    expect(ck10_reg_jog_start_speed_is_out_of_range(34999u) == false, "ck10_reg_jog_start_speed_is_out_of_range 34999");
    expect(ck10_reg_jog_start_speed_is_out_of_range(35000u) == false, "ck10_reg_jog_start_speed_is_out_of_range 35000");
    expect(ck10_reg_jog_start_speed_is_out_of_range(35001u) == true, "ck10_reg_jog_start_speed_is_out_of_range 35001");
}

static void test_438(void)
{
    expect(ck10_reg_jog_acceleration_time_is_out_of_range(0u) == true, "ck10_reg_jog_acceleration_time_is_out_of_range 0");
    expect(ck10_reg_jog_acceleration_time_is_out_of_range(1u) == false, "ck10_reg_jog_acceleration_time_is_out_of_range 1");
    expect(ck10_reg_jog_acceleration_time_is_out_of_range(2u) == false, "ck10_reg_jog_acceleration_time_is_out_of_range 2");
    expect(ck10_reg_jog_acceleration_time_is_out_of_range(9998u) == false, "ck10_reg_jog_acceleration_time_is_out_of_range 9998");
    expect(ck10_reg_jog_acceleration_time_is_out_of_range(9999u) == false, "ck10_reg_jog_acceleration_time_is_out_of_range 9999");
    expect(ck10_reg_jog_acceleration_time_is_out_of_range(10000u) == true, "ck10_reg_jog_acceleration_time_is_out_of_range 10000");
}

static void test_439(void)
{
    expect(ck10_reg_homing_speed_is_out_of_range(0u) == true, "ck10_reg_homing_speed_is_out_of_range 0");
    expect(ck10_reg_homing_speed_is_out_of_range(1u) == false, "ck10_reg_homing_speed_is_out_of_range 1");
    expect(ck10_reg_homing_speed_is_out_of_range(2u) == false, "ck10_reg_homing_speed_is_out_of_range 2");
    expect(ck10_reg_homing_speed_is_out_of_range(799999u) == false, "ck10_reg_homing_speed_is_out_of_range 799999");
    expect(ck10_reg_homing_speed_is_out_of_range(800000u) == false, "ck10_reg_homing_speed_is_out_of_range 800000");
    expect(ck10_reg_homing_speed_is_out_of_range(800001u) == true, "ck10_reg_homing_speed_is_out_of_range 800001");
}

static void test_440(void)
{
    expect(ck10_reg_homing_search_speed_is_out_of_range(0u) == true, "ck10_reg_homing_search_speed_is_out_of_range 0");
    expect(ck10_reg_homing_search_speed_is_out_of_range(1u) == false, "ck10_reg_homing_search_speed_is_out_of_range 1");
    expect(ck10_reg_homing_search_speed_is_out_of_range(2u) == false, "ck10_reg_homing_search_speed_is_out_of_range 2");
    expect(ck10_reg_homing_search_speed_is_out_of_range(79999u) == false, "ck10_reg_homing_search_speed_is_out_of_range 79999");
    expect(ck10_reg_homing_search_speed_is_out_of_range(80000u) == false, "ck10_reg_homing_search_speed_is_out_of_range 80000");
    expect(ck10_reg_homing_search_speed_is_out_of_range(80001u) == true, "ck10_reg_homing_search_speed_is_out_of_range 80001");
}

static void test_441(void)
{
    expect(ck10_reg_homing_acceleration_time_is_out_of_range(0u) == true, "ck10_reg_homing_acceleration_time_is_out_of_range 0");
    expect(ck10_reg_homing_acceleration_time_is_out_of_range(1u) == false, "ck10_reg_homing_acceleration_time_is_out_of_range 1");
    expect(ck10_reg_homing_acceleration_time_is_out_of_range(2u) == false, "ck10_reg_homing_acceleration_time_is_out_of_range 2");
    expect(ck10_reg_homing_acceleration_time_is_out_of_range(9998u) == false, "ck10_reg_homing_acceleration_time_is_out_of_range 9998");
    expect(ck10_reg_homing_acceleration_time_is_out_of_range(9999u) == false, "ck10_reg_homing_acceleration_time_is_out_of_range 9999");
    expect(ck10_reg_homing_acceleration_time_is_out_of_range(10000u) == true, "ck10_reg_homing_acceleration_time_is_out_of_range 10000");
}

static void test_442(void)
{
    expect(ck10_reg_position_loop_gain_is_out_of_range(0u) == false, "ck10_reg_position_loop_gain_is_out_of_range 0");
    expect(ck10_reg_position_loop_gain_is_out_of_range(1u) == false, "ck10_reg_position_loop_gain_is_out_of_range 1");
    expect(ck10_reg_position_loop_gain_is_out_of_range(62u) == false, "ck10_reg_position_loop_gain_is_out_of_range 62");
    expect(ck10_reg_position_loop_gain_is_out_of_range(63u) == false, "ck10_reg_position_loop_gain_is_out_of_range 63");
    expect(ck10_reg_position_loop_gain_is_out_of_range(64u) == true, "ck10_reg_position_loop_gain_is_out_of_range 64");
}

static void test_443(void)
{
    expect(ck10_reg_in_position_range_is_out_of_range(0u) == false, "ck10_reg_in_position_range_is_out_of_range 0");
    expect(ck10_reg_in_position_range_is_out_of_range(1u) == false, "ck10_reg_in_position_range_is_out_of_range 1");
    expect(ck10_reg_in_position_range_is_out_of_range(126u) == false, "ck10_reg_in_position_range_is_out_of_range 126");
    expect(ck10_reg_in_position_range_is_out_of_range(127u) == false, "ck10_reg_in_position_range_is_out_of_range 127");
    expect(ck10_reg_in_position_range_is_out_of_range(128u) == true, "ck10_reg_in_position_range_is_out_of_range 128");
}

static void test_444(void)
{
    expect(ck10_reg_tracking_limit_is_out_of_range(0u) == true, "ck10_reg_tracking_limit_is_out_of_range 0");
    expect(ck10_reg_tracking_limit_is_out_of_range(1u) == false, "ck10_reg_tracking_limit_is_out_of_range 1");
    expect(ck10_reg_tracking_limit_is_out_of_range(2u) == false, "ck10_reg_tracking_limit_is_out_of_range 2");
    expect(ck10_reg_tracking_limit_is_out_of_range(134217726u) == false, "ck10_reg_tracking_limit_is_out_of_range 134217726");
    expect(ck10_reg_tracking_limit_is_out_of_range(134217727u) == false, "ck10_reg_tracking_limit_is_out_of_range 134217727");
    expect(ck10_reg_tracking_limit_is_out_of_range(134217728u) == true, "ck10_reg_tracking_limit_is_out_of_range 134217728");
}

static void test_445(void)
{
    expect(ck10_reg_homing_torque_ratio_is_out_of_range(19u) == true, "ck10_reg_homing_torque_ratio_is_out_of_range 19");
    expect(ck10_reg_homing_torque_ratio_is_out_of_range(20u) == false, "ck10_reg_homing_torque_ratio_is_out_of_range 20");
    expect(ck10_reg_homing_torque_ratio_is_out_of_range(21u) == false, "ck10_reg_homing_torque_ratio_is_out_of_range 21");
    expect(ck10_reg_homing_torque_ratio_is_out_of_range(89u) == false, "ck10_reg_homing_torque_ratio_is_out_of_range 89");
    expect(ck10_reg_homing_torque_ratio_is_out_of_range(90u) == false, "ck10_reg_homing_torque_ratio_is_out_of_range 90");
    expect(ck10_reg_homing_torque_ratio_is_out_of_range(91u) == true, "ck10_reg_homing_torque_ratio_is_out_of_range 91");
}

static void test_446(void)
{
    expect(ck10_reg_position_overflow_limit_is_out_of_range(0u) == true, "ck10_reg_position_overflow_limit_is_out_of_range 0");
    expect(ck10_reg_position_overflow_limit_is_out_of_range(1u) == false, "ck10_reg_position_overflow_limit_is_out_of_range 1");
    expect(ck10_reg_position_overflow_limit_is_out_of_range(2u) == false, "ck10_reg_position_overflow_limit_is_out_of_range 2");
    expect(ck10_reg_position_overflow_limit_is_out_of_range(134217726u) == false, "ck10_reg_position_overflow_limit_is_out_of_range 134217726");
    expect(ck10_reg_position_overflow_limit_is_out_of_range(134217727u) == false, "ck10_reg_position_overflow_limit_is_out_of_range 134217727");
    expect(ck10_reg_position_overflow_limit_is_out_of_range(134217728u) == true, "ck10_reg_position_overflow_limit_is_out_of_range 134217728");
}

static void test_447(void)
{
    expect(ck10_reg_run_current_is_out_of_range(4u) == true, "ck10_reg_run_current_is_out_of_range 4");
    expect(ck10_reg_run_current_is_out_of_range(5u) == false, "ck10_reg_run_current_is_out_of_range 5");
    expect(ck10_reg_run_current_is_out_of_range(6u) == false, "ck10_reg_run_current_is_out_of_range 6");
    expect(ck10_reg_run_current_is_out_of_range(14u) == false, "ck10_reg_run_current_is_out_of_range 14");
    expect(ck10_reg_run_current_is_out_of_range(15u) == false, "ck10_reg_run_current_is_out_of_range 15");
    expect(ck10_reg_run_current_is_out_of_range(16u) == true, "ck10_reg_run_current_is_out_of_range 16");
}

static void test_448(void)
{
    expect(ck10_reg_boost_current_is_out_of_range(0u) == false, "ck10_reg_boost_current_is_out_of_range 0");
    expect(ck10_reg_boost_current_is_out_of_range(1u) == false, "ck10_reg_boost_current_is_out_of_range 1");
    expect(ck10_reg_boost_current_is_out_of_range(6u) == false, "ck10_reg_boost_current_is_out_of_range 6");
    expect(ck10_reg_boost_current_is_out_of_range(7u) == false, "ck10_reg_boost_current_is_out_of_range 7");
    expect(ck10_reg_boost_current_is_out_of_range(8u) == true, "ck10_reg_boost_current_is_out_of_range 8");
}

static void test_449(void)
{
    expect(ck10_reg_stop_current_is_out_of_range(1u) == true, "ck10_reg_stop_current_is_out_of_range 1");
    expect(ck10_reg_stop_current_is_out_of_range(2u) == false, "ck10_reg_stop_current_is_out_of_range 2");
    expect(ck10_reg_stop_current_is_out_of_range(3u) == false, "ck10_reg_stop_current_is_out_of_range 3");
    expect(ck10_reg_stop_current_is_out_of_range(9u) == false, "ck10_reg_stop_current_is_out_of_range 9");
    expect(ck10_reg_stop_current_is_out_of_range(10u) == false, "ck10_reg_stop_current_is_out_of_range 10");
    expect(ck10_reg_stop_current_is_out_of_range(11u) == true, "ck10_reg_stop_current_is_out_of_range 11");
}

static void test_450(void)
{
    expect(ck10_reg_flash_resolution_is_out_of_range(0u) == false, "ck10_reg_flash_resolution_is_out_of_range 0");
    expect(ck10_reg_flash_resolution_is_out_of_range(1u) == false, "ck10_reg_flash_resolution_is_out_of_range 1");
    expect(ck10_reg_flash_resolution_is_out_of_range(49999u) == false, "ck10_reg_flash_resolution_is_out_of_range 49999");
    expect(ck10_reg_flash_resolution_is_out_of_range(50000u) == false, "ck10_reg_flash_resolution_is_out_of_range 50000");
    expect(ck10_reg_flash_resolution_is_out_of_range(50001u) == true, "ck10_reg_flash_resolution_is_out_of_range 50001");
}

static void test_451(void)
{
    expect(ck10_reg_flash_maximum_speed_is_out_of_range(0u) == true, "ck10_reg_flash_maximum_speed_is_out_of_range 0");
    expect(ck10_reg_flash_maximum_speed_is_out_of_range(1u) == false, "ck10_reg_flash_maximum_speed_is_out_of_range 1");
    expect(ck10_reg_flash_maximum_speed_is_out_of_range(2u) == false, "ck10_reg_flash_maximum_speed_is_out_of_range 2");
    expect(ck10_reg_flash_maximum_speed_is_out_of_range(799999u) == false, "ck10_reg_flash_maximum_speed_is_out_of_range 799999");
    expect(ck10_reg_flash_maximum_speed_is_out_of_range(800000u) == false, "ck10_reg_flash_maximum_speed_is_out_of_range 800000");
    expect(ck10_reg_flash_maximum_speed_is_out_of_range(800001u) == true, "ck10_reg_flash_maximum_speed_is_out_of_range 800001");
}

static void test_452(void)
{
    expect(ck10_reg_flash_start_speed_is_out_of_range(0u) == true, "ck10_reg_flash_start_speed_is_out_of_range 0");
    expect(ck10_reg_flash_start_speed_is_out_of_range(1u) == false, "ck10_reg_flash_start_speed_is_out_of_range 1");
    expect(ck10_reg_flash_start_speed_is_out_of_range(2u) == false, "ck10_reg_flash_start_speed_is_out_of_range 2");
    expect(ck10_reg_flash_start_speed_is_out_of_range(34999u) == false, "ck10_reg_flash_start_speed_is_out_of_range 34999");
    expect(ck10_reg_flash_start_speed_is_out_of_range(35000u) == false, "ck10_reg_flash_start_speed_is_out_of_range 35000");
    expect(ck10_reg_flash_start_speed_is_out_of_range(35001u) == true, "ck10_reg_flash_start_speed_is_out_of_range 35001");
}

static void test_453(void)
{
    expect(ck10_reg_flash_acceleration_time_is_out_of_range(0u) == true, "ck10_reg_flash_acceleration_time_is_out_of_range 0");
    expect(ck10_reg_flash_acceleration_time_is_out_of_range(1u) == false, "ck10_reg_flash_acceleration_time_is_out_of_range 1");
    expect(ck10_reg_flash_acceleration_time_is_out_of_range(2u) == false, "ck10_reg_flash_acceleration_time_is_out_of_range 2");
    expect(ck10_reg_flash_acceleration_time_is_out_of_range(9998u) == false, "ck10_reg_flash_acceleration_time_is_out_of_range 9998");
    expect(ck10_reg_flash_acceleration_time_is_out_of_range(9999u) == false, "ck10_reg_flash_acceleration_time_is_out_of_range 9999");
    expect(ck10_reg_flash_acceleration_time_is_out_of_range(10000u) == true, "ck10_reg_flash_acceleration_time_is_out_of_range 10000");
}

static void test_454(void)
{
    expect(ck10_reg_flash_deceleration_time_is_out_of_range(0u) == true, "ck10_reg_flash_deceleration_time_is_out_of_range 0");
    expect(ck10_reg_flash_deceleration_time_is_out_of_range(1u) == false, "ck10_reg_flash_deceleration_time_is_out_of_range 1");
    expect(ck10_reg_flash_deceleration_time_is_out_of_range(2u) == false, "ck10_reg_flash_deceleration_time_is_out_of_range 2");
    expect(ck10_reg_flash_deceleration_time_is_out_of_range(9998u) == false, "ck10_reg_flash_deceleration_time_is_out_of_range 9998");
    expect(ck10_reg_flash_deceleration_time_is_out_of_range(9999u) == false, "ck10_reg_flash_deceleration_time_is_out_of_range 9999");
    expect(ck10_reg_flash_deceleration_time_is_out_of_range(10000u) == true, "ck10_reg_flash_deceleration_time_is_out_of_range 10000");
}

static void test_455(void)
{
    expect(ck10_reg_flash_jog_speed_is_out_of_range(0u) == true, "ck10_reg_flash_jog_speed_is_out_of_range 0");
    expect(ck10_reg_flash_jog_speed_is_out_of_range(1u) == false, "ck10_reg_flash_jog_speed_is_out_of_range 1");
    expect(ck10_reg_flash_jog_speed_is_out_of_range(2u) == false, "ck10_reg_flash_jog_speed_is_out_of_range 2");
    expect(ck10_reg_flash_jog_speed_is_out_of_range(799999u) == false, "ck10_reg_flash_jog_speed_is_out_of_range 799999");
    expect(ck10_reg_flash_jog_speed_is_out_of_range(800000u) == false, "ck10_reg_flash_jog_speed_is_out_of_range 800000");
    expect(ck10_reg_flash_jog_speed_is_out_of_range(800001u) == true, "ck10_reg_flash_jog_speed_is_out_of_range 800001");
}

static void test_456(void)
{
    expect(ck10_reg_flash_jog_start_speed_is_out_of_range(0u) == true, "ck10_reg_flash_jog_start_speed_is_out_of_range 0");
    expect(ck10_reg_flash_jog_start_speed_is_out_of_range(1u) == false, "ck10_reg_flash_jog_start_speed_is_out_of_range 1");
    expect(ck10_reg_flash_jog_start_speed_is_out_of_range(2u) == false, "ck10_reg_flash_jog_start_speed_is_out_of_range 2");
    expect(ck10_reg_flash_jog_start_speed_is_out_of_range(34999u) == false, "ck10_reg_flash_jog_start_speed_is_out_of_range 34999");
    expect(ck10_reg_flash_jog_start_speed_is_out_of_range(35000u) == false, "ck10_reg_flash_jog_start_speed_is_out_of_range 35000");
    expect(ck10_reg_flash_jog_start_speed_is_out_of_range(35001u) == true, "ck10_reg_flash_jog_start_speed_is_out_of_range 35001");
}

static void test_457(void)
{
    expect(ck10_reg_flash_jog_acceleration_time_is_out_of_range(0u) == true, "ck10_reg_flash_jog_acceleration_time_is_out_of_range 0");
    expect(ck10_reg_flash_jog_acceleration_time_is_out_of_range(1u) == false, "ck10_reg_flash_jog_acceleration_time_is_out_of_range 1");
    expect(ck10_reg_flash_jog_acceleration_time_is_out_of_range(2u) == false, "ck10_reg_flash_jog_acceleration_time_is_out_of_range 2");
    expect(ck10_reg_flash_jog_acceleration_time_is_out_of_range(9998u) == false, "ck10_reg_flash_jog_acceleration_time_is_out_of_range 9998");
    expect(ck10_reg_flash_jog_acceleration_time_is_out_of_range(9999u) == false, "ck10_reg_flash_jog_acceleration_time_is_out_of_range 9999");
    expect(ck10_reg_flash_jog_acceleration_time_is_out_of_range(10000u) == true, "ck10_reg_flash_jog_acceleration_time_is_out_of_range 10000");
}

static void test_458(void)
{
    expect(ck10_reg_flash_homing_speed_is_out_of_range(0u) == true, "ck10_reg_flash_homing_speed_is_out_of_range 0");
    expect(ck10_reg_flash_homing_speed_is_out_of_range(1u) == false, "ck10_reg_flash_homing_speed_is_out_of_range 1");
    expect(ck10_reg_flash_homing_speed_is_out_of_range(2u) == false, "ck10_reg_flash_homing_speed_is_out_of_range 2");
    expect(ck10_reg_flash_homing_speed_is_out_of_range(799999u) == false, "ck10_reg_flash_homing_speed_is_out_of_range 799999");
    expect(ck10_reg_flash_homing_speed_is_out_of_range(800000u) == false, "ck10_reg_flash_homing_speed_is_out_of_range 800000");
    expect(ck10_reg_flash_homing_speed_is_out_of_range(800001u) == true, "ck10_reg_flash_homing_speed_is_out_of_range 800001");
}

static void test_459(void)
{
    expect(ck10_reg_flash_homing_search_speed_is_out_of_range(0u) == true, "ck10_reg_flash_homing_search_speed_is_out_of_range 0");
    expect(ck10_reg_flash_homing_search_speed_is_out_of_range(1u) == false, "ck10_reg_flash_homing_search_speed_is_out_of_range 1");
    expect(ck10_reg_flash_homing_search_speed_is_out_of_range(2u) == false, "ck10_reg_flash_homing_search_speed_is_out_of_range 2");
    expect(ck10_reg_flash_homing_search_speed_is_out_of_range(79999u) == false, "ck10_reg_flash_homing_search_speed_is_out_of_range 79999");
    expect(ck10_reg_flash_homing_search_speed_is_out_of_range(80000u) == false, "ck10_reg_flash_homing_search_speed_is_out_of_range 80000");
    expect(ck10_reg_flash_homing_search_speed_is_out_of_range(80001u) == true, "ck10_reg_flash_homing_search_speed_is_out_of_range 80001");
}

static void test_460(void)
{
    expect(ck10_reg_flash_homing_acceleration_time_is_out_of_range(0u) == true, "ck10_reg_flash_homing_acceleration_time_is_out_of_range 0");
    expect(ck10_reg_flash_homing_acceleration_time_is_out_of_range(1u) == false, "ck10_reg_flash_homing_acceleration_time_is_out_of_range 1");
    expect(ck10_reg_flash_homing_acceleration_time_is_out_of_range(2u) == false, "ck10_reg_flash_homing_acceleration_time_is_out_of_range 2");
    expect(ck10_reg_flash_homing_acceleration_time_is_out_of_range(9998u) == false, "ck10_reg_flash_homing_acceleration_time_is_out_of_range 9998");
    expect(ck10_reg_flash_homing_acceleration_time_is_out_of_range(9999u) == false, "ck10_reg_flash_homing_acceleration_time_is_out_of_range 9999");
    expect(ck10_reg_flash_homing_acceleration_time_is_out_of_range(10000u) == true, "ck10_reg_flash_homing_acceleration_time_is_out_of_range 10000");
}

static void test_461(void)
{
    expect(ck10_reg_flash_position_loop_gain_is_out_of_range(0u) == false, "ck10_reg_flash_position_loop_gain_is_out_of_range 0");
    expect(ck10_reg_flash_position_loop_gain_is_out_of_range(1u) == false, "ck10_reg_flash_position_loop_gain_is_out_of_range 1");
    expect(ck10_reg_flash_position_loop_gain_is_out_of_range(62u) == false, "ck10_reg_flash_position_loop_gain_is_out_of_range 62");
    expect(ck10_reg_flash_position_loop_gain_is_out_of_range(63u) == false, "ck10_reg_flash_position_loop_gain_is_out_of_range 63");
    expect(ck10_reg_flash_position_loop_gain_is_out_of_range(64u) == true, "ck10_reg_flash_position_loop_gain_is_out_of_range 64");
}

static void test_462(void)
{
    expect(ck10_reg_flash_in_position_range_is_out_of_range(0u) == false, "ck10_reg_flash_in_position_range_is_out_of_range 0");
    expect(ck10_reg_flash_in_position_range_is_out_of_range(1u) == false, "ck10_reg_flash_in_position_range_is_out_of_range 1");
    expect(ck10_reg_flash_in_position_range_is_out_of_range(126u) == false, "ck10_reg_flash_in_position_range_is_out_of_range 126");
    expect(ck10_reg_flash_in_position_range_is_out_of_range(127u) == false, "ck10_reg_flash_in_position_range_is_out_of_range 127");
    expect(ck10_reg_flash_in_position_range_is_out_of_range(128u) == true, "ck10_reg_flash_in_position_range_is_out_of_range 128");
}

static void test_463(void)
{
    expect(ck10_reg_flash_tracking_limit_is_out_of_range(0u) == true, "ck10_reg_flash_tracking_limit_is_out_of_range 0");
    expect(ck10_reg_flash_tracking_limit_is_out_of_range(1u) == false, "ck10_reg_flash_tracking_limit_is_out_of_range 1");
    expect(ck10_reg_flash_tracking_limit_is_out_of_range(2u) == false, "ck10_reg_flash_tracking_limit_is_out_of_range 2");
    expect(ck10_reg_flash_tracking_limit_is_out_of_range(134217726u) == false, "ck10_reg_flash_tracking_limit_is_out_of_range 134217726");
    expect(ck10_reg_flash_tracking_limit_is_out_of_range(134217727u) == false, "ck10_reg_flash_tracking_limit_is_out_of_range 134217727");
    expect(ck10_reg_flash_tracking_limit_is_out_of_range(134217728u) == true, "ck10_reg_flash_tracking_limit_is_out_of_range 134217728");
}

static void test_464(void)
{
    expect(ck10_reg_flash_homing_torque_ratio_is_out_of_range(19u) == true, "ck10_reg_flash_homing_torque_ratio_is_out_of_range 19");
    expect(ck10_reg_flash_homing_torque_ratio_is_out_of_range(20u) == false, "ck10_reg_flash_homing_torque_ratio_is_out_of_range 20");
    expect(ck10_reg_flash_homing_torque_ratio_is_out_of_range(21u) == false, "ck10_reg_flash_homing_torque_ratio_is_out_of_range 21");
    expect(ck10_reg_flash_homing_torque_ratio_is_out_of_range(89u) == false, "ck10_reg_flash_homing_torque_ratio_is_out_of_range 89");
    expect(ck10_reg_flash_homing_torque_ratio_is_out_of_range(90u) == false, "ck10_reg_flash_homing_torque_ratio_is_out_of_range 90");
    expect(ck10_reg_flash_homing_torque_ratio_is_out_of_range(91u) == true, "ck10_reg_flash_homing_torque_ratio_is_out_of_range 91");
}

static void test_465(void)
{
    expect(ck10_reg_flash_position_overflow_limit_is_out_of_range(0u) == true, "ck10_reg_flash_position_overflow_limit_is_out_of_range 0");
    expect(ck10_reg_flash_position_overflow_limit_is_out_of_range(1u) == false, "ck10_reg_flash_position_overflow_limit_is_out_of_range 1");
    expect(ck10_reg_flash_position_overflow_limit_is_out_of_range(2u) == false, "ck10_reg_flash_position_overflow_limit_is_out_of_range 2");
    expect(ck10_reg_flash_position_overflow_limit_is_out_of_range(134217726u) == false, "ck10_reg_flash_position_overflow_limit_is_out_of_range 134217726");
    expect(ck10_reg_flash_position_overflow_limit_is_out_of_range(134217727u) == false, "ck10_reg_flash_position_overflow_limit_is_out_of_range 134217727");
    expect(ck10_reg_flash_position_overflow_limit_is_out_of_range(134217728u) == true, "ck10_reg_flash_position_overflow_limit_is_out_of_range 134217728");
}

static void test_466(void)
{
    expect(ck10_reg_flash_run_current_is_out_of_range(4u) == true, "ck10_reg_flash_run_current_is_out_of_range 4");
    expect(ck10_reg_flash_run_current_is_out_of_range(5u) == false, "ck10_reg_flash_run_current_is_out_of_range 5");
    expect(ck10_reg_flash_run_current_is_out_of_range(6u) == false, "ck10_reg_flash_run_current_is_out_of_range 6");
    expect(ck10_reg_flash_run_current_is_out_of_range(14u) == false, "ck10_reg_flash_run_current_is_out_of_range 14");
    expect(ck10_reg_flash_run_current_is_out_of_range(15u) == false, "ck10_reg_flash_run_current_is_out_of_range 15");
    expect(ck10_reg_flash_run_current_is_out_of_range(16u) == true, "ck10_reg_flash_run_current_is_out_of_range 16");
}

static void test_467(void)
{
    expect(ck10_reg_flash_boost_current_is_out_of_range(0u) == false, "ck10_reg_flash_boost_current_is_out_of_range 0");
    expect(ck10_reg_flash_boost_current_is_out_of_range(1u) == false, "ck10_reg_flash_boost_current_is_out_of_range 1");
    expect(ck10_reg_flash_boost_current_is_out_of_range(6u) == false, "ck10_reg_flash_boost_current_is_out_of_range 6");
    expect(ck10_reg_flash_boost_current_is_out_of_range(7u) == false, "ck10_reg_flash_boost_current_is_out_of_range 7");
    expect(ck10_reg_flash_boost_current_is_out_of_range(8u) == true, "ck10_reg_flash_boost_current_is_out_of_range 8");
}

static void test_468(void)
{
    expect(ck10_reg_flash_stop_current_is_out_of_range(1u) == true, "ck10_reg_flash_stop_current_is_out_of_range 1");
    expect(ck10_reg_flash_stop_current_is_out_of_range(2u) == false, "ck10_reg_flash_stop_current_is_out_of_range 2");
    expect(ck10_reg_flash_stop_current_is_out_of_range(3u) == false, "ck10_reg_flash_stop_current_is_out_of_range 3");
    expect(ck10_reg_flash_stop_current_is_out_of_range(9u) == false, "ck10_reg_flash_stop_current_is_out_of_range 9");
    expect(ck10_reg_flash_stop_current_is_out_of_range(10u) == false, "ck10_reg_flash_stop_current_is_out_of_range 10");
    expect(ck10_reg_flash_stop_current_is_out_of_range(11u) == true, "ck10_reg_flash_stop_current_is_out_of_range 11");
}

unsigned long ck10_selftest(void (*tell)(const char *what))
{
    (void)same_bytes;
    (void)same_text;
    (void)copy;
    (void)clear;
    told = tell;
    passed = 0;
    failed = 0;
    test_0();
    test_1();
    test_2();
    test_3();
    test_4();
    test_5();
    test_6();
    test_7();
    test_8();
    test_9();
    test_10();
    test_11();
    test_12();
    test_13();
    test_14();
    test_15();
    test_16();
    test_17();
    test_18();
    test_19();
    test_20();
    test_21();
    test_22();
    test_23();
    test_24();
    test_25();
    test_26();
    test_27();
    test_28();
    test_29();
    test_30();
    test_31();
    test_32();
    test_33();
    test_34();
    test_35();
    test_36();
    test_37();
    test_38();
    test_39();
    test_40();
    test_41();
    test_42();
    test_43();
    test_44();
    test_45();
    test_46();
    test_47();
    test_48();
    test_49();
    test_50();
    test_51();
    test_52();
    test_53();
    test_54();
    test_55();
    test_56();
    test_57();
    test_58();
    test_59();
    test_60();
    test_61();
    test_62();
    test_63();
    test_64();
    test_65();
    test_66();
    test_67();
    test_68();
    test_69();
    test_70();
    test_71();
    test_72();
    test_73();
    test_74();
    test_75();
    test_76();
    test_77();
    test_78();
    test_79();
    test_80();
    test_81();
    test_82();
    test_83();
    test_84();
    test_85();
    test_86();
    test_87();
    test_88();
    test_89();
    test_90();
    test_91();
    test_92();
    test_93();
    test_94();
    test_95();
    test_96();
    test_97();
    test_98();
    test_99();
    test_100();
    test_101();
    test_102();
    test_103();
    test_104();
    test_105();
    test_106();
    test_107();
    test_108();
    test_109();
    test_110();
    test_111();
    test_112();
    test_113();
    test_114();
    test_115();
    test_116();
    test_117();
    test_118();
    test_119();
    test_120();
    test_121();
    test_122();
    test_123();
    test_124();
    test_125();
    test_126();
    test_127();
    test_128();
    test_129();
    test_130();
    test_131();
    test_132();
    test_133();
    test_134();
    test_135();
    test_136();
    test_137();
    test_138();
    test_139();
    test_140();
    test_141();
    test_142();
    test_143();
    test_144();
    test_145();
    test_146();
    test_147();
    test_148();
    test_149();
    test_150();
    test_151();
    test_152();
    test_153();
    test_154();
    test_155();
    test_156();
    test_157();
    test_158();
    test_159();
    test_160();
    test_161();
    test_162();
    test_163();
    test_164();
    test_165();
    test_166();
    test_167();
    test_168();
    test_169();
    test_170();
    test_171();
    test_172();
    test_173();
    test_174();
    test_175();
    test_176();
    test_177();
    test_178();
    test_179();
    test_180();
    test_181();
    test_182();
    test_183();
    test_184();
    test_185();
    test_186();
    test_187();
    test_188();
    test_189();
    test_190();
    test_191();
    test_192();
    test_193();
    test_194();
    test_195();
    test_196();
    test_197();
    test_198();
    test_199();
    test_200();
    test_201();
    test_202();
    test_203();
    test_204();
    test_205();
    test_206();
    test_207();
    test_208();
    test_209();
    test_210();
    test_211();
    test_212();
    test_213();
    test_214();
    test_215();
    test_216();
    test_217();
    test_218();
    test_219();
    test_220();
    test_221();
    test_222();
    test_223();
    test_224();
    test_225();
    test_226();
    test_227();
    test_228();
    test_229();
    test_230();
    test_231();
    test_232();
    test_233();
    test_234();
    test_235();
    test_236();
    test_237();
    test_238();
    test_239();
    test_240();
    test_241();
    test_242();
    test_243();
    test_244();
    test_245();
    test_246();
    test_247();
    test_248();
    test_249();
    test_250();
    test_251();
    test_252();
    test_253();
    test_254();
    test_255();
    test_256();
    test_257();
    test_258();
    test_259();
    test_260();
    test_261();
    test_262();
    test_263();
    test_264();
    test_265();
    test_266();
    test_267();
    test_268();
    test_269();
    test_270();
    test_271();
    test_272();
    test_273();
    test_274();
    test_275();
    test_276();
    test_277();
    test_278();
    test_279();
    test_280();
    test_281();
    test_282();
    test_283();
    test_284();
    test_285();
    test_286();
    test_287();
    test_288();
    test_289();
    test_290();
    test_291();
    test_292();
    test_293();
    test_294();
    test_295();
    test_296();
    test_297();
    test_298();
    test_299();
    test_300();
    test_301();
    test_302();
    test_303();
    test_304();
    test_305();
    test_306();
    test_307();
    test_308();
    test_309();
    test_310();
    test_311();
    test_312();
    test_313();
    test_314();
    test_315();
    test_316();
    test_317();
    test_318();
    test_319();
    test_320();
    test_321();
    test_322();
    test_323();
    test_324();
    test_325();
    test_326();
    test_327();
    test_328();
    test_329();
    test_330();
    test_331();
    test_332();
    test_333();
    test_334();
    test_335();
    test_336();
    test_337();
    test_338();
    test_339();
    test_340();
    test_341();
    test_342();
    test_343();
    test_344();
    test_345();
    test_346();
    test_347();
    test_348();
    test_349();
    test_350();
    test_351();
    test_352();
    test_353();
    test_354();
    test_355();
    test_356();
    test_357();
    test_358();
    test_359();
    test_360();
    test_361();
    test_362();
    test_363();
    test_364();
    test_365();
    test_366();
    test_367();
    test_368();
    test_369();
    test_370();
    test_371();
    test_372();
    test_373();
    test_374();
    test_375();
    test_376();
    test_377();
    test_378();
    test_379();
    test_380();
    test_381();
    test_382();
    test_383();
    test_384();
    test_385();
    test_386();
    test_387();
    test_388();
    test_389();
    test_390();
    test_391();
    test_392();
    test_393();
    test_394();
    test_395();
    test_396();
    test_397();
    test_398();
    test_399();
    test_400();
    test_401();
    test_402();
    test_403();
    test_404();
    test_405();
    test_406();
    test_407();
    test_408();
    test_409();
    test_410();
    test_411();
    test_412();
    test_413();
    test_414();
    test_415();
    test_416();
    test_417();
    test_418();
    test_419();
    test_420();
    test_421();
    test_422();
    test_423();
    test_424();
    test_425();
    test_426();
    test_427();
    test_428();
    test_429();
    test_430();
    test_431();
    test_432();
    test_433();
    test_434();
    test_435();
    test_436();
    test_437();
    test_438();
    test_439();
    test_440();
    test_441();
    test_442();
    test_443();
    test_444();
    test_445();
    test_446();
    test_447();
    test_448();
    test_449();
    test_450();
    test_451();
    test_452();
    test_453();
    test_454();
    test_455();
    test_456();
    test_457();
    test_458();
    test_459();
    test_460();
    test_461();
    test_462();
    test_463();
    test_464();
    test_465();
    test_466();
    test_467();
    test_468();
    return failed;
}

#ifdef HOSTED
static void print(const char *what)
{
    printf("failed: %s\n", what);
}

int main(void)
{
    (void)ck10_selftest(print);
    printf("%lu passed, %lu failed\n", passed, failed);
    return failed ? 1 : 0;
}
#endif
