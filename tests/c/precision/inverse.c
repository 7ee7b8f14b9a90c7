/* The inverse dynamics of the PUMA 560 (tests/bench/systems/puma6.mac, C for any precision) at 16
 * states. Where REFERENCE is defined it prints the generalized forces; else it compares its own
 * with these, the numbers of reference.h, and prints the largest difference in units of 1e-9 of the
 * largest one, or -1 where a routine failed. */
#include <stdio.h>

#include "gsmbp/functions.h"
#include "puma6.h"

enum { STATES = 16, N = PUMA6_NU };

#ifndef REFERENCE
static const gs_real reference[STATES * N] = {
#include "reference.h"
};
#endif

#ifdef __AVR__ /* no operating system: characters to the serial port, the end is sleep */
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>

static int
serial (char c, FILE *to)
{
  (void)to;
  while (! (UCSR0A & (1 << UDRE0)))
    ;
  UDR0 = (unsigned char)c;
  return 0;
}

static void
begin (void)
{
  static FILE port = FDEV_SETUP_STREAM (serial, NULL, _FDEV_SETUP_WRITE);
  UCSR0B = 1 << TXEN0;
  stdout = &port;
}

static void
end (void)
{
  cli ();
  sleep_mode ();
}
#else
#define begin() ((void)0)
#define end() ((void)0)
#endif

/* a number between -2 and 2 that is the same in all precisions */
static gs_real
dyadic (int k)
{
  return (gs_real)(k * 37 % 64 - 32) / 16;
}

/* the generalized forces of all states; 0: all is well */
static int
inverse_dynamics (gs_real *tau)
{
  puma6_parameters parameters;
  gs_real cst[PUMA6_NCST], q[N], u[N], ud[N], v[1] = { 0 };
  puma6_par (&parameters);
  if (puma6_pre (&parameters, cst) != 0)
    return -1;
  for (int state = 0; state < STATES; state++)
    {
      for (int i = 0; i < N; i++)
        {
          q[i] = dyadic (1 + state + 5 * i);
          u[i] = dyadic (2 + 3 * state + 7 * i);
          ud[i] = dyadic (3 + 5 * state + 11 * i);
        }
      puma6_inv (0, q, u, ud, v, cst, tau + N * state);
    }
  return gs_not_finite (STATES * N, tau) == 0 ? 0 : -1;
}

int
main (void)
{
  gs_real tau[STATES * N];
  long worst = inverse_dynamics (tau);
#ifdef REFERENCE
  if (worst != 0)
    return 1;
  for (int i = 0; i < STATES * N; i++)
    printf ("GS_R (%.17e),\n", (double)tau[i]);
#else
  gs_real most = 0, off = 0;
  begin ();
  for (int i = 0; i < STATES * N; i++)
    {
      gs_real d = tau[i] - reference[i], size = reference[i];
      d = d < 0 ? -d : d;
      size = size < 0 ? -size : size;
      off = d > off ? d : off;
      most = size > most ? size : most;
    }
  if (worst == 0)
    worst = (long)(off / most * GS_R (1e9));
  printf ("%ld\n", worst);
  end ();
#endif
  return 0;
}
