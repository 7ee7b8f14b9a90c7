/* How a Cortex-M4F starts: its table of vectors, the unit for numbers of single precision switched
 * on; then main, whose output goes to QEMU by semihosting. */
#include <stdint.h>
#include <stdio.h>
#include <unistd.h>

extern void initialise_monitor_handles (void);
extern int main (void);
void reset (void);

void
reset (void)
{
  *(volatile uint32_t *)0xE000ED88 |= UINT32_C (0xF) << 20; /* CPACR */
  initialise_monitor_handles ();
  int status = main ();
  fflush (stdout);
  _exit (status);
}

/* the end of the stack, and where it begins */
const uintptr_t vectors[16] __attribute__ ((section (".vectors"), used))
    = { 0x20100000, (uintptr_t)reset };
