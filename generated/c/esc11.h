/*
 * ESC11-B (TAIYO), in any of its versions
 *
 * Selects the header of a version. Define ESC11_SELECT before you include this header, or on the command line:
 *
 *     -DESC11_SELECT=ESC11_SELECT_V1_17
 *
 * You can also include the header of a version directly. ESC11_SELECT_LATEST is the newest version that was known when
 * this header was generated.
 *
 * ESC11_SELECT_BEFORE_1_17: esc11_before_1_17.h, identity f08caf3c2960958b
 * ESC11_SELECT_V1_17: esc11_v1_17.h, identity 499facc7f5252c73
 *
 * Generated; do not edit. Identity: 499facc7f5252c73
 */
#define ESC11_SELECT_BEFORE_1_17 1
#define ESC11_SELECT_V1_17 2
#define ESC11_SELECT_LATEST ESC11_SELECT_V1_17

#ifndef ESC11_SELECT
#error "define ESC11_SELECT as one of ESC11_SELECT_BEFORE_1_17, ESC11_SELECT_V1_17 or ESC11_SELECT_LATEST"
#elif ESC11_SELECT + 0 == ESC11_SELECT_BEFORE_1_17
#include "esc11_before_1_17.h"
#elif ESC11_SELECT + 0 == ESC11_SELECT_V1_17
#include "esc11_v1_17.h"
#else
#error "ESC11_SELECT is not a known version; define it as one of ESC11_SELECT_BEFORE_1_17, ESC11_SELECT_V1_17 or ESC11_SELECT_LATEST"
#endif
