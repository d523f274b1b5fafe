"""The scenes of test_blocks_against_models.py that fail today, by test, with the item that mends them."""

from __future__ import annotations

EXPECTED: dict[str, tuple[str, tuple[str, ...]]] = {
    "a_block_that_reads_recovers_while_it_is_enabled": (
        "1.9",
        (
            "ck10",
            "esc11",
            "hiwin-e 111",
            "hiwin-e 9",
            "tc100",
        ),
    ),
    "a_gripper_is_not_done_at_a_place_that_it_cannot_reach": (
        "1.4",
        (
            "command error",
            "number alone",
        ),
    ),
    "a_gripper_without_a_home_is_not_done": (
        "1.4",
        (
            "command error",
            "number alone",
        ),
    ),
    "a_halt_gives_the_axis_to_the_next_move": (
        "1.8",
        (
            "ck10",
            "esc11",
            "hiwin-e 111",
            "hiwin-e 9",
            "tc100",
        ),
    ),
    "a_jog_does_not_run_away_when_its_successor_is_refused": (
        "1.2",
        (
            "-ck10",
            "-esc11",
            "-tc100",
            "aborted-ck10",
            "aborted-esc11",
            "aborted-tc100",
        ),
    ),
    "a_jog_has_two_directions_and_is_busy_until_it_stands": (
        "1.8",
        (
            "ck10",
            "esc11",
            "hiwin-e 111",
            "hiwin-e 9",
            "tc100",
        ),
    ),
    "a_jog_that_is_aborted_stops": (
        "1.2",
        (
            "hiwin-e 111",
            "hiwin-e 9",
        ),
    ),
    "a_move_does_not_abort_a_stop": (
        "1.8",
        (
            "ck10",
            "esc11",
            "hiwin-e 111",
            "hiwin-e 9",
            "tc100",
        ),
    ),
    "a_position_of_another_station_is_never_valid": (
        "1.1",
        (
            "ck10",
            "tc100",
        ),
    ),
    "a_stop_is_done_when_the_axis_stands": (
        "1.8",
        (
            "hiwin-e 111",
            "hiwin-e 9",
        ),
    ),
    "a_successor_that_is_refused_leaves_somebody_responsible": (
        "1.6",
        (
            "ck10",
            "esc11",
            "tc100",
        ),
    ),
    "an_edge_while_it_is_busy_is_taken_or_refused": (
        "1.6 and 1.9",
        (
            "ck10",
            "esc11",
            "hiwin-e 111",
            "hiwin-e 9",
            "tc100",
        ),
    ),
    "an_invalid_telegram_swallows_no_stop": (
        "1.3",
        (
            "0-power_off-hiwin-e 111",
            "0-power_off-hiwin-e 9",
            "0-quick_stop-hiwin-e 111",
            "0-quick_stop-hiwin-e 9",
            "0-stop-hiwin-e 111",
            "0-stop-hiwin-e 9",
            "1-power_off-hiwin-e 111",
            "1-power_off-hiwin-e 9",
            "1-quick_stop-hiwin-e 9",
            "1-stop-hiwin-e 111",
            "1-stop-hiwin-e 9",
            "2-power_off-hiwin-e 111",
            "2-power_off-hiwin-e 9",
            "2-quick_stop-hiwin-e 9",
            "2-stop-hiwin-e 111",
            "2-stop-hiwin-e 9",
        ),
    ),
    "nothing_moves_while_a_stop_is_asked_for": (
        "1.8",
        (
            "absolute-ck10",
            "absolute-esc11",
            "absolute-hiwin-e 111",
            "absolute-hiwin-e 9",
            "absolute-tc100",
            "home-ck10",
            "home-esc11",
            "home-hiwin-e 111",
            "home-hiwin-e 9",
            "home-tc100",
            "jog-ck10",
            "jog-esc11",
            "jog-hiwin-e 111",
            "jog-hiwin-e 9",
            "jog-tc100",
            "relative-ck10",
            "relative-esc11",
            "relative-hiwin-e 111",
            "relative-hiwin-e 9",
            "relative-tc100",
        ),
    ),
    "the_servo_is_on_at_the_first_try_after_a_quick_stop": (
        "1.5",
        (
            "hiwin-e 102",
            "hiwin-e 111",
            "hiwin-e 3",
            "hiwin-e 9",
        ),
    ),
    "what_begins_late_is_not_done_early": (
        "1.4",
        (
            "absolute-0.38-ck10",
            "absolute-0.38-esc11",
            "absolute-1.0-ck10",
            "absolute-1.0-esc11",
            "absolute-1.0-tc100",
            "home-0.38-tc100",
            "home-1.0-tc100",
            "relative-0.38-ck10",
            "relative-0.38-hiwin-e 111",
            "relative-0.38-hiwin-e 9",
            "relative-1.0-ck10",
            "relative-1.0-esc11",
            "relative-1.0-hiwin-e 111",
            "relative-1.0-hiwin-e 9",
            "relative-1.0-tc100",
        ),
    ),
    "what_is_stopped_from_outside_is_not_done": (
        "1.4",
        (
            "absolute-ck10",
            "absolute-esc11",
            "absolute-tc100",
            "relative-ck10",
            "relative-esc11",
            "relative-tc100",
        ),
    ),
    "who_is_aborted_stops_the_axis": (
        "1.2 and 1.6",
        (
            "ck10",
            "esc11",
            "hiwin-e 111",
            "hiwin-e 9",
            "tc100",
        ),
    ),
}
