# Values of parameters, good, bad and at the edges: Octave, Python, an FMU and the emitted C refuse
# the same ones, by the same rule (tests/data/value_checks/cases.txt), all by the routine CHK.
. tests/tools/check.sh
root=$PWD
data=$PWD/tests/data/value_checks
work_folder
python=/usr/bin/python3
sed 's/ *|.*//' "$data/cases.txt" >"$work/expected"

share/make/maxima "$work/log" "load(\"$root/gsmbp/gsmbp.mac\")\$
  load(\"$data/value_checks.mac\")\$
  gsmbp_fortran(scene, [rhs], directory = \"$work/fortran\")\$
  gsmbp_package(scene, c, [rhs], directory = \"$work/c\")\$
  gsmbp_package(scene, python, [rhs], directory = \"$work/python\")\$
  gsmbp_fmu(scene, directory = \"$work/fmu\")\$
  gsmbp_fortran(scene, [rhs], directory = \"$work/bare\",
    without = [check, start])\$" \
  >"$report" 2>&1
told $? 'the scene as Fortran, C, a module of Python, FMUs' "$report"

# agrees WHO: whether the lines of $work/WHO are those that are expected
agrees() {
  diff "$work/expected" "$work/$1" >"$report" 2>&1
  told $? "$(wc -l <"$work/expected") sets of values: $1 refuses the bad ones, by their rule" \
    "$report"
}

cat >"$work/cases.m" <<'END'
addpath (fullfile (pwd (), "octave"));
warning ("off", "gsmbp:negative");
m = gsmbp_build ("value_checks", "directory", fullfile (getenv ("WORK"), "fortran"));
out = fopen (fullfile (getenv ("WORK"), "octave"), "w");
for line = strsplit (strtrim (fileread (getenv ("CASES"))), "\n")
  pairs = regexp (strsplit (line{1}, "|"){2}, '(\S+)=(\S+)', "tokens");
  values = cell2struct (cellfun (@(p) str2double (p{2}), pairs(:), "UniformOutput", false), ...
                        cellfun (@(p) p{1}, pairs(:), "UniformOutput", false), 1);
  said = "ok";
  try
    gsmbp_set (m, values);
  catch e
    said = regexprep (e.message, {'^gsmbp_set: value_checks: ', '; found: .*'}, "");
  end_try_catch
  fprintf (out, "%s\n", said);
endfor
bare = gsmbp_build ("value_checks", "directory", fullfile (getenv ("WORK"), "bare"));
assert (bare.initial, m.initial);
fail ('gsmbp_set (bare, "mc", 3)', "emitted without the subroutine CHK.* derive it again");
j = gsmbp_set (m, "s0", 3, "p", 4);
assert (j.initial(1), 1.75);
END
CASES=$data/cases.txt WORK=$work octave-cli -qf "$work/cases.m" >"$report" 2>&1
told $? 'Octave: without CHK other values are refused; a start made of parameters' "$report"
agrees octave

cat >"$work/cases.c" <<'END'
#include "value_checks.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const struct { const char *name; size_t at; } members[] = { MEMBERS };

int
main (int argc, char **argv)
{
  value_checks_parameters p;
  double r[RULES];
  int k;
  value_checks_par (&p);
  for (int i = 1; i < argc; i++)
    for (size_t j = 0; j < sizeof members / sizeof *members; j++)
      {
        size_t n = strlen (members[j].name);
        if (strncmp (argv[i], members[j].name, n) == 0 && argv[i][n] == '=')
          *(double *)((char *)&p + members[j].at) = strtod (argv[i] + n + 1, 0);
      }
  int info = value_checks_chk (&p, r, &k);
  printf ("%d %d\n", info, k);
  return 0;
}
END
cat >"$work/cases_c.py" <<'END'
import json, re, subprocess, sys
work, cases = sys.argv[1:]
table = json.load(open(work + '/c/value_checks.json'))
struct = re.search(r'typedef struct[^{]*\{(.*?)\} value_checks_parameters;',
                   open(work + '/c/value_checks.h').read(), re.S).group(1)
own = re.findall(r'double (\w+);', struct)
members = ', '.join('{ "%s", offsetof (value_checks_parameters, %s) }' % (p['name'], c)
                    for p, c in zip(table['parameters'], own))
source = open(work + '/cases.c').read().replace('MEMBERS', members).replace(
    'RULES', str(len(table['rules']))).replace('#include <stdio.h>',
                                               '#include <stddef.h>\n#include <stdio.h>')
open(work + '/cases.c', 'w').write(source)
subprocess.run('gcc -std=c99 -pedantic -Wall -Wextra -Werror -ffunction-sections -Wl,--gc-sections '
               '-I{0}/c -I{0}/c/runtime -o {0}/cases {0}/cases.c {0}/c/value_checks.c '
               '{0}/c/runtime/*/*.c {0}/c/runtime/*/*/*.c -lm'.format(work), shell=True, check=True)
with open(work + '/C', 'w') as out:
    for line in open(cases):
        info, k = map(int, subprocess.run(
            [work + '/cases', *line.split('|')[1].split()], capture_output=True, text=True,
            check=True).stdout.split())
        rule = table['rules'][k - 1]
        print('ok' if info == 0 else rule['broken'] if info == 1 else
              rule['place'] + ' must be real and finite', file=out)
END
$python "$work/cases_c.py" "$work" "$data/cases.txt" >"$report" 2>&1
told $? 'the emitted C, compiled without a warning' "$report"
agrees C

cat >"$work/cases.py" <<'END'
import re, sys, warnings
warnings.simplefilter('ignore')
import value_checks as s
with open(sys.argv[1] + '/Python', 'w') as out:
    for line in open(sys.argv[2]):
        values = {n: float(x) for n, x in re.findall(r'(\S+)=(\S+)', line.split('|')[1])}
        said = 'ok'
        try:
            s.Model(**values)
        except ValueError as e:
            said = re.sub('^value_checks: |; found: .*', '', str(e))
        print(said, file=out)
assert s.Model(s0=3, p=4).initial[0] == 1.75
END
(cd "$work/python" && sed -i 's/-O2/-O0/' setup.py &&
  $python setup.py -q build_py -d built) >"$report" 2>&1
PYTHONPATH=$work/python/built $python "$work/cases.py" "$work" "$data/cases.txt" >>"$report" 2>&1
told $? 'Python: a start made of parameters' "$report"
agrees Python

cat >"$work/cases_fmu.py" <<'END'
import json, re, sys
sys.path.insert(0, 'tests/fmu')
out, cases, table = sys.argv.pop(), sys.argv.pop(), sys.argv.pop()
from instance import Instance, log
# what is never negative has that bound in the description of the FMU
rules = json.load(open(table))['rules']
bounds = {rule['parameters'][0]: rule['broken'] for rule in reversed(rules)
          if len(rule['parameters']) == 1 and rule['rule'] in ('nonnegative', 'positive')}


def sentence():
    for text in log:
        bound = re.search(r'(\w+): expected a number from 0 to', text)
        rule = re.search('parameters: (.*)', text)
        if bound or rule:
            return bounds[bound.group(1)] if bound else rule.group(1)
    return 'ok'


with open(out, 'w') as told:
    for line in open(cases):
        del log[:]
        values = {n: float(x) for n, x in re.findall(r'(\S+)=(\S+)', line.split('|')[1])}
        try:
            Instance(True, values)
        except SystemExit as e:
            print(e)
        print(sentence(), file=told)
END
unzip -q -o "$work/fmu/value_checks_fmi2.fmu" -d "$work/unpacked" >"$report" 2>&1
$python "$work/cases_fmu.py" value_checks "$work/unpacked" 2 \
  "$work/c/value_checks.json" "$data/cases.txt" "$work/FMU" >>"$report" 2>&1
told $? 'the FMU' "$report"
agrees FMU
