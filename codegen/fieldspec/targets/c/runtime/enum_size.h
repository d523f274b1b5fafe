#ifdef __GNUC__
/** An enum has 16 bits, even where the compiler makes enums as short as they can be: a cast of 256 does not become 0. */
#define DEVICE_ENUM_16 __attribute__((__mode__(__HI__)))
#else
#define DEVICE_ENUM_16
#endif
