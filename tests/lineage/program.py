#!/usr/bin/env python3
"""program.py FOLDER NAME: of the scene that FOLDER/NAME.json describes, a program in Fortran alone
(NAME_main.f) and one in C that answers the same (NAME_main.c): the efforts of INV at a state made
of its start, and two runs of constant inputs from the start on the constraints. program.py FOLDER
NAME answers: whether FOLDER/NAME.fortran and FOLDER/NAME.c_says are alike, or the scene is refused
for what it has; a line `ok` or `not ok`."""
import json
import os
import sys

SPAN, OUTPUTS, TOLERANCE = 0.02, 5, 1e-12   # of the runs [s]; of rk4 steps of 1e-3 s
MOST = 20000      # steps: scenes that are stiffer end there, both
APART = 1e-8      # two runs beside each other: those of stiff beams by 2e-9
RANK_LOST = 10    # the INFO by which the driver refuses a singular position
REFUSED = {1: 'ports that stick or hit stops', 2: 'events of the user', 3: 'sampled devices'}

FORTRAN = """\
      PROGRAM MAIN
      IMPLICIT NONE
      INTEGER            NQ, NU, NX, NV, NT, NB
      PARAMETER          ( NQ = {nq}, NU = {nu}, NX = {nx}, NV = {nv},
     $                     NT = {nt}, NB = {nb} )
      INTEGER            SIZ(12), ISTAT(6), INFO, I, K
      DOUBLE PRECISION   PAR({npar}), CST({ncst}), X(NX), Q(NQ+1),
     $                   U(NU+1), UD(NU+1), V(NV+1), TAU(NU+1),
     $                   TB(NB+1), TOUT(NT), ATOL(NX), XOUT(NX,NT),
     $                   W(16*NX+NV), T, RES
      EXTERNAL           {name}_RHS
      EXTERNAL           {prj}
      EXTERNAL           INP, GSRUN8, GSRUN4
C
      CALL {name}_PAR( PAR )
      CALL {name}_PRE( PAR, CST, INFO )
      CALL {name}_SIZ( SIZ )
      PRINT *, 'pre', INFO
      CALL START( X )
{inverse}
{switches}
{project}
      DO 40 I = 1, NX
         ATOL(I) = {tolerance}
   40 CONTINUE
      DO 50 K = 1, NT
         TOUT(K) = {span}D0*DBLE( K - 1 )/DBLE( NT - 1 )
   50 CONTINUE
      CALL GSRUN8( {name}_RHS,
     $             {prj},
     $             INP, SIZ, CST, NB, TB, NT, TOUT, X, {tolerance}, ATOL,
     $             {most}, T, XOUT, W, ISTAT, INFO )
      CALL SAY( 'dp853', NX, INFO, ISTAT, XOUT )
      CALL START( X )
{project}
      CALL GSRUN4( {name}_RHS,
     $             {prj},
     $             INP, SIZ, CST, NB, TB, NT, TOUT, X, {step}, T, XOUT,
     $             W, ISTAT, INFO )
      CALL SAY( 'rk4', NX, INFO, ISTAT, XOUT )
      END
      SUBROUTINE SAY( METHOD, NX, INFO, ISTAT, XOUT )
      IMPLICIT NONE
      CHARACTER*(*)      METHOD
      INTEGER            NX, INFO, ISTAT(6), I, K
      DOUBLE PRECISION   XOUT(NX,*)
      PRINT *, METHOD, INFO, ISTAT(4), ISTAT(6)
      DO 70 K = 1, ISTAT(6)
         DO 60 I = 1, NX
            PRINT '(A,1X,ES24.16)', METHOD//'_x', XOUT(I,K)
   60    CONTINUE
   70 CONTINUE
      END
      SUBROUTINE START( X )
      IMPLICIT NONE
      DOUBLE PRECISION   X(*)
{start}
      END
      SUBROUTINE INP( T, X, V )
      IMPLICIT NONE
      INTEGER            I
      DOUBLE PRECISION   T, X(*), V(*)
      DO 10 I = 1, {nv}
         V(I) = 0.1D0*DBLE( I )
   10 CONTINUE
      END
"""

C = """\
#include "{file}.h"
#include "gsmbp/integrate.h"
#include "gsmbp/plan.h"
#include <stdio.h>
#include <stdlib.h>
enum {{ NQ = {nq}, NU = {nu}, NX = {nx}, NV = {nv}, NT = {nt} }};
int
main (void)
{{
  const gs_scene *s = &{prefix}_scene;
  {prefix}_parameters par;
  double *cst = calloc ({ncst} + 1, sizeof *cst);
  double x0[] = {{ {x0} }}, v[NV + 1], q[NQ + 1], u[NU + 1], ud[NU + 1], tau[NU + 1];
  double times[NT], atol[NX], ropt[3] = {{ 0.001, {tolerance}, 0 }}, res = 0;
  double *x = calloc (NX * NT, sizeof *x), *vout = calloc ((NV + 1) * NT, sizeof *vout);
  int info;
  {prefix}_par (&par);
  info = {prefix}_pre (&par, cst);
  printf ("pre %d\\n", info);
  for (int k = 0; k < NV; k++)
    v[k] = 0.1 * (k + 1);
  for (int k = 0; k < NQ; k++)
    q[k] = x0[k] + 0.1;
  for (int k = 0; k < NU; k++)
    u[k] = x0[NQ + k] + 0.2 * (k + 1), ud[k] = 1 - 0.3 * (k + 1);
  (void) q, (void) u, (void) ud, (void) tau, (void) res, (void) s;
  {inverse}
  {project}
  for (int method = 8; method >= 4; method -= 4)
  {{
    const char *name = method == 8 ? "dp853" : "rk4";
    int iopt[6] = {{ method, {way}, 0, method == 8 ? {most} : 0, 0, 0 }};
    const gs_plan plan = {{ .s = s, .nx = NX, .constants = v, .on_the_way = 8,
                           .events = 1000 }};
    int *ip = calloc (gs_wholes (&plan), sizeof *ip);
    double *rp = calloc (gs_reals (&plan) + NV + 8, sizeof *rp);
    gs_integration run = {{ .nx = NX, .x0 = x0, .nt = NT, .tout = times, .iopt = iopt, .ropt = ropt,
                   .atol = atol, .ip = ip, .rp = rp, .cst = cst, .xout = x, .ldx = NX,
                   .vout = vout, .ldv = NV > 1 ? NV : 1 }};
    for (int k = 0; k < NT; k++)
      times[k] = {span} * k / (NT - 1);
    for (int k = 0; k < NX; k++)
      atol[k] = {tolerance};
    gs_lay (&plan, ip, rp);
    run.lw = gs_room (s, NX, 0);
    run.w = calloc (run.lw, sizeof *run.w);
    info = gs_integrate (s, &run);
    printf ("%s %d 0 %d\\n", name, info, run.istat[GS_N_OUTPUTS]);
    for (int k = 0; k < NX * run.istat[GS_N_OUTPUTS]; k++)
      printf ("%s_x %.16e\\n", name, x[k]);
  }}
  return 0;
}}
"""


def described(folder, name):
    """what the programs have of a scene"""
    with open(os.path.join(folder, name + '.json')) as f:
        scene = json.load(f)
    with open(os.path.join(folder, name + '.h')) as f:
        text = f.read()
    size = scene['dimensions']
    routines = [routine['name'] for routine in scene['subroutines']]
    title = routines[0][:-len('_PAR')]
    has = {routine[len(title) + 1:] for routine in routines}
    stated = {event['kind'] == 'event' for event in scene['events'] or []}
    return {
        'name': title, 'file': name, 'has': has, 'x0': scene['initial'],
        'prefix': text.split('extern const gs_scene ')[1].split('_scene;')[0],
        'nq': size['nq'], 'nu': size['nu'], 'nx': size['nx'], 'nv': size['nv'],
        'nb': size.get('nsw', 0), 'nt': OUTPUTS, 'npar': max(1, size['npar']),
        'ncst': max(1, size['ncst']), 'span': repr(SPAN), 'most': MOST,
        'way': 2 if 'PRJ' in has else 1,
        'refusal': 1 if False in stated else 2 if True in stated else 3 if size['nctl'] else 0}


def fortran(about):
    """the program in Fortran"""
    name, has = about['name'], about['has']
    start = '\n'.join('      X(%d) = %.17gD0' % (k + 1, x) if 'e' not in '%.17g' % x else
                      '      X(%d) = %s' % (k + 1, ('%.17g' % x).replace('e', 'D'))
                      for k, x in enumerate(about['x0']))
    inverse = '' if 'INV' not in has else f"""\
      CALL INP( 0.0D0, X, V )
      DO 10 I = 1, NQ
         Q(I) = X(I) + 0.1D0
   10 CONTINUE
      DO 20 I = 1, NU
         U(I) = X(NQ+I) + 0.2D0*DBLE( I )
         UD(I) = 1.0D0 - 0.3D0*DBLE( I )
   20 CONTINUE
      CALL {name}_INV(
     $   0.0D0, Q, U, UD, V, CST, TAU )
      DO 30 I = 1, NU
         PRINT '(A,1X,ES24.16)', 'tau', TAU(I)
   30 CONTINUE"""
    switches = '' if about['nb'] == 0 else f'      CALL {name}_SWI( CST, TB )'
    project = '' if 'PRJ' not in has else f'      CALL {name}_PRJ( 0.0D0, X, CST, RES, INFO )'
    text = FORTRAN.format(**about, start=start, inverse=inverse, switches=switches,
                          project=project, prj=name + '_PRJ' if 'PRJ' in has else 'GSNON',
                          tolerance=('%g' % TOLERANCE).replace('e', 'D'), step='1.0D-3')
    return '\n'.join(line for line in text.splitlines() if line) + '\n'


def in_c(about):
    """the program in C"""
    prefix, has = about['prefix'], about['has']
    inverse = '' if 'INV' not in has else f"""{prefix}_inv (0, q, u, ud, v, cst, tau);
  for (int k = 0; k < NU; k++)
    printf ("tau %.16e\\n", tau[k]);"""
    project = '' if 'PRJ' not in has else f'{prefix}_prj (0, x0, cst, &res);'
    return C.format(**{**about, 'x0': ', '.join('%.17g' % x for x in about['x0'])},
                    inverse=inverse, project=project, tolerance='%g' % TOLERANCE)


def numbers(lines, word):
    return [float(line.split()[1]) for line in lines if line.split()[0] == word]


def distance(a, b):
    """of two lists, beside the largest number of the second, at least 1; NaN are alike"""
    if len(a) != len(b):
        return float('inf')
    size = max([1] + [abs(y) for y in b if abs(y) < float('inf')])
    off = [abs(x - y) / size for x, y in zip(a, b) if x != y and (x == x or y == y)]
    return max([0] + [d if d == d else float('inf') for d in off])


def wrong_run(about, method, said, other):
    """what is wrong in a run: '' if nothing is"""
    info, cause = next([int(word) for word in line.split()[1:3]]
                       for line in said if line.split()[0] == method)
    info_c = next(int(line.split()[1]) for line in other if line.split()[0] == method)
    if about['refusal']:
        return '' if info == about['refusal'] else 'INFO %d' % about['refusal'], 'INFO %d' % info
    if info != 0 and info_c != 0 or info == RANK_LOST:
        return '', 'INFO %d, C %d' % (info, info_c)
    off = distance(numbers(said, method + '_x'), numbers(other, method + '_x'))
    return ('' if info == info_c and off <= APART else 'INFO %d, %g' % (info_c, APART),
            'INFO %d, %d, %.0e from C' % (info, cause, off))


def verdict(about, folder):
    """what was expected, or '', and what was found"""
    said, other = ([line for line in open(os.path.join(folder, about['file'] + ending)).read()
                    .splitlines() if line.strip()] for ending in ('.fortran', '.c_says'))
    if not (said and other and said[-1].split()[0].startswith('rk4')):
        return 'both programs at their end', 'less'
    off = distance(numbers(said, 'tau'), numbers(other, 'tau'))
    rows = [('' if off <= 1e-11 else '1e-11', 'INV %.0e from C' % off)]
    if about['refusal']:
        rows += [('', 'refused for its ' + REFUSED[about['refusal']])]
    rows += [wrong_run(about, method, said, other) for method in ('dp853', 'rk4')]
    bad = [row for row in rows if row[0]]
    return bad[0] if bad else ('', ', '.join(found for _, found in rows))


def main():
    folder, name = sys.argv[1:3]
    about = described(folder, name)
    if sys.argv[3:] == ['answers']:
        expected, found = verdict(about, folder)
        print('not ok %s: expected %s, found %s' % (name, expected, found) if expected else
              'ok %s: %s' % (name, found))
        return
    for ending, text in ('_main.f', fortran(about)), ('_main.c', in_c(about)):
        with open(os.path.join(folder, name + ending), 'w') as f:
            f.write(text)


if __name__ == '__main__':
    main()
