/* The types of 32 bits where int has 16: gcc for this machine takes int for them whatever its width. */
#undef __INT32_TYPE__
#undef __UINT32_TYPE__
#define __INT32_TYPE__ long
#define __UINT32_TYPE__ unsigned long
