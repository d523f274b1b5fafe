/*
 * CK10 (unknown), in any of its versions
 *
 * Includes the header of the only version. You may define CK10_SELECT to rely on that version:
 *
 *     -DCK10_SELECT=CK10_SELECT_V1
 *
 * You can also include the header of a version directly. CK10_SELECT_LATEST is the newest version that was known when
 * this header was generated.
 *
 * CK10_SELECT_V1: ck10_v1.h, identity fdc1e9665defc19d
 *
 * Generated; do not edit. Identity: fdc1e9665defc19d
 */
#define CK10_SELECT_V1 1
#define CK10_SELECT_LATEST CK10_SELECT_V1

#ifndef CK10_SELECT
#include "ck10_v1.h"
#elif CK10_SELECT + 0 == CK10_SELECT_V1
#include "ck10_v1.h"
#else
#error "CK10_SELECT is not a known version; define it as one of CK10_SELECT_V1 or CK10_SELECT_LATEST"
#endif
