/*
 * E1/E2 PROFINET (HIWIN), in any of its versions
 *
 * Selects the header of a version. Define HIWIN_E_SELECT before you include this header, or on the command line:
 *
 *     -DHIWIN_E_SELECT=HIWIN_E_SELECT_V2_14_4
 *
 * You can also include the header of a version directly. HIWIN_E_SELECT_LATEST is the newest version that was known when
 * this header was generated.
 *
 * HIWIN_E_SELECT_BEFORE_2_8_16: hiwin_e_before_2_8_16.h, identity e42b002a6b3263ab
 * HIWIN_E_SELECT_V2_8_16: hiwin_e_v2_8_16.h, identity 33a2db0dc06a9ca3
 * HIWIN_E_SELECT_BEFORE_3_12_5: hiwin_e_v2_8_16.h, identity 33a2db0dc06a9ca3
 * HIWIN_E_SELECT_V2_12_5: hiwin_e_v2_12_5.h, identity 7ecec5e2d7d7950c
 * HIWIN_E_SELECT_V3_12_5: hiwin_e_v2_12_5.h, identity 7ecec5e2d7d7950c
 * HIWIN_E_SELECT_BEFORE_4_14_4: hiwin_e_v2_12_5.h, identity 7ecec5e2d7d7950c
 * HIWIN_E_SELECT_V2_14_4: hiwin_e_v2_14_4.h, identity 9bc9d8915a5c154a
 * HIWIN_E_SELECT_V3_14_4: hiwin_e_v2_14_4.h, identity 9bc9d8915a5c154a
 * HIWIN_E_SELECT_V4_14_4: hiwin_e_v2_14_4.h, identity 9bc9d8915a5c154a
 *
 * Generated; do not edit. Identity: 9bc9d8915a5c154a
 */
#define HIWIN_E_SELECT_BEFORE_2_8_16 1
#define HIWIN_E_SELECT_V2_8_16 2
#define HIWIN_E_SELECT_BEFORE_3_12_5 3
#define HIWIN_E_SELECT_V2_12_5 4
#define HIWIN_E_SELECT_V3_12_5 5
#define HIWIN_E_SELECT_BEFORE_4_14_4 6
#define HIWIN_E_SELECT_V2_14_4 7
#define HIWIN_E_SELECT_V3_14_4 8
#define HIWIN_E_SELECT_V4_14_4 9
#define HIWIN_E_SELECT_LATEST HIWIN_E_SELECT_V2_14_4

#ifndef HIWIN_E_SELECT
#error "define HIWIN_E_SELECT as one of HIWIN_E_SELECT_BEFORE_2_8_16, HIWIN_E_SELECT_V2_8_16, HIWIN_E_SELECT_BEFORE_3_12_5, HIWIN_E_SELECT_V2_12_5, HIWIN_E_SELECT_V3_12_5, HIWIN_E_SELECT_BEFORE_4_14_4, HIWIN_E_SELECT_V2_14_4, HIWIN_E_SELECT_V3_14_4, HIWIN_E_SELECT_V4_14_4 or HIWIN_E_SELECT_LATEST"
#elif HIWIN_E_SELECT + 0 == HIWIN_E_SELECT_BEFORE_2_8_16
#include "hiwin_e_before_2_8_16.h"
#elif HIWIN_E_SELECT + 0 == HIWIN_E_SELECT_V2_8_16
#include "hiwin_e_v2_8_16.h"
#elif HIWIN_E_SELECT + 0 == HIWIN_E_SELECT_BEFORE_3_12_5
#include "hiwin_e_v2_8_16.h"
#elif HIWIN_E_SELECT + 0 == HIWIN_E_SELECT_V2_12_5
#include "hiwin_e_v2_12_5.h"
#elif HIWIN_E_SELECT + 0 == HIWIN_E_SELECT_V3_12_5
#include "hiwin_e_v2_12_5.h"
#elif HIWIN_E_SELECT + 0 == HIWIN_E_SELECT_BEFORE_4_14_4
#include "hiwin_e_v2_12_5.h"
#elif HIWIN_E_SELECT + 0 == HIWIN_E_SELECT_V2_14_4
#include "hiwin_e_v2_14_4.h"
#elif HIWIN_E_SELECT + 0 == HIWIN_E_SELECT_V3_14_4
#include "hiwin_e_v2_14_4.h"
#elif HIWIN_E_SELECT + 0 == HIWIN_E_SELECT_V4_14_4
#include "hiwin_e_v2_14_4.h"
#else
#error "HIWIN_E_SELECT is not a known version; define it as one of HIWIN_E_SELECT_BEFORE_2_8_16, HIWIN_E_SELECT_V2_8_16, HIWIN_E_SELECT_BEFORE_3_12_5, HIWIN_E_SELECT_V2_12_5, HIWIN_E_SELECT_V3_12_5, HIWIN_E_SELECT_BEFORE_4_14_4, HIWIN_E_SELECT_V2_14_4, HIWIN_E_SELECT_V3_14_4, HIWIN_E_SELECT_V4_14_4 or HIWIN_E_SELECT_LATEST"
#endif
