/*
 * TC100 (TOYO), in any of its versions
 *
 * Selects the header of a version. Define TC100_SELECT before you include this header, or on the command line:
 *
 *     -DTC100_SELECT=TC100_SELECT_V2_0
 *
 * You can also include the header of a version directly. TC100_SELECT_LATEST is the newest version that was known when
 * this header was generated.
 *
 * TC100_SELECT_BEFORE_2_0: tc100_before_2_0.h, identity b1a30ddf3d283d0f
 * TC100_SELECT_V2_0: tc100_v2_0.h, identity 8f5fd7b11e77b14b
 *
 * Generated; do not edit. Identity: 8f5fd7b11e77b14b
 */
#define TC100_SELECT_BEFORE_2_0 1
#define TC100_SELECT_V2_0 2
#define TC100_SELECT_LATEST TC100_SELECT_V2_0

#ifndef TC100_SELECT
#error "define TC100_SELECT as one of TC100_SELECT_BEFORE_2_0, TC100_SELECT_V2_0 or TC100_SELECT_LATEST"
#elif TC100_SELECT + 0 == TC100_SELECT_BEFORE_2_0
#include "tc100_before_2_0.h"
#elif TC100_SELECT + 0 == TC100_SELECT_V2_0
#include "tc100_v2_0.h"
#else
#error "TC100_SELECT is not a known version; define it as one of TC100_SELECT_BEFORE_2_0, TC100_SELECT_V2_0 or TC100_SELECT_LATEST"
#endif
