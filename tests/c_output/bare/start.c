/*
 * Runs a self-test where there is neither an operating system's library nor string.h: on a Cortex-M by semihosting,
 * under Linux by its system calls. SELFTEST is the function; the program says what fails and exits with 0 or 1.
 */
#include <stddef.h>
#include <stdint.h>

unsigned long SELFTEST(void (*tell)(const char *what));
void start(void);

/* What a compiler calls by itself, whoever links. A loop that copies must not become a call of the function it is in. */
#define PLAIN __attribute__((used, optimize("no-tree-loop-distribute-patterns")))
void *memcpy(void *to, const void *from, size_t size);
void *memset(void *what, int byte, size_t size);
int memcmp(const void *left, const void *right, size_t size);

PLAIN void *memcpy(void *to, const void *from, size_t size)
{
    while (size-- > 0) {
        ((unsigned char *)to)[size] = ((const unsigned char *)from)[size];
    }
    return to;
}

PLAIN void *memset(void *what, int byte, size_t size)
{
    while (size-- > 0) {
        ((unsigned char *)what)[size] = (unsigned char)byte;
    }
    return what;
}

PLAIN int memcmp(const void *left, const void *right, size_t size)
{
    const unsigned char *one = left, *other = right;
    for (; size > 0; size--, one++, other++) {
        if (*one != *other) {
            return *one < *other ? -1 : 1;
        }
    }
    return 0;
}

#if defined(__arm__)

static int32_t semihosting(int32_t operation, const void *argument)
{
    register int32_t r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

static void print(const char *text)
{
    (void)semihosting(4, text);
}

static void leave(int32_t code)
{
    const int32_t argument[2] = {0x20026, code};
    (void)semihosting(0x20, argument);
    for (;;) {
    }
}

static void fault(void)
{
    print("a fault: an unaligned access, or an instruction that there is not\n");
    leave(2);
}

extern uint32_t stack_end[];
__attribute__((section(".vectors"), used)) static void (*const vectors[])(void) = {
    (void (*)(void))(uintptr_t)stack_end, start, fault, fault, fault, fault, fault,
};

/* CCR.UNALIGN_TRP, in force after the barrier. */
static void enter(void)
{
    *(volatile uint32_t *)0xE000ED14u |= 1u << 3;
    __asm__ volatile("isb 0xf" : : : "memory");
}

#elif defined(__m68k__)

static long call(long number, long first, long second, long third)
{
    register long d0 __asm__("d0") = number;
    register long d1 __asm__("d1") = first;
    register long d2 __asm__("d2") = second;
    register long d3 __asm__("d3") = third;
    __asm__ volatile("trap #0" : "+d"(d0) : "d"(d1), "d"(d2), "d"(d3) : "memory");
    return d0;
}
#define WRITE 4
#define EXIT 1

#elif defined(__aarch64__)

static long call(long number, long first, long second, long third)
{
    register long x8 __asm__("x8") = number;
    register long x0 __asm__("x0") = first;
    register long x1 __asm__("x1") = second;
    register long x2 __asm__("x2") = third;
    __asm__ volatile("svc #0" : "+r"(x0) : "r"(x8), "r"(x1), "r"(x2) : "memory");
    return x0;
}
#define WRITE 64
#define EXIT 93

#endif

#ifdef WRITE
static void enter(void)
{
}

static void print(const char *text)
{
    long size = 0;
    while (text[size] != '\0') {
        size++;
    }
    (void)call(WRITE, 1, (long)text, size);
}

static void leave(int32_t code)
{
    (void)call(EXIT, code, 0, 0);
    for (;;) {
    }
}
#endif

static void tell(const char *what)
{
    print("failed: ");
    print(what);
    print("\n");
}

void start(void)
{
    enter();
#ifdef UNALIGNED_ON_PURPOSE
    {
        static uint8_t bytes[8];
        volatile uintptr_t address = (uintptr_t)bytes + 1;
        *(volatile uint32_t *)address = 1;
    }
#endif
    leave(SELFTEST(tell) == 0 ? 0 : 1);
}
