# A whole run in C (share/engine/host/run), and one that its host continues step by step: an
# oscillator against closed forms by all methods, and every refusal, under the sanitizers; make
# test-whole: in quad precision, too. Unknowns that are taken out of a program before it is solved.
. tests/tools/check.sh
work_folder
headers_in_cplusplus host/run/stepped.h
for kind in sane $(whole && echo quad); do
  for program in run stepped; do
    engine_program $kind "$work/$program" tests/c/host/$program.c
    told $? "the program $program compiles, $kind" "$report"
    to_the_end "$work/$program"
  done
done
engine_program sane "$work/eliminate" tests/c/host/eliminate.c \
  share/engine/host/collocation/eliminate*.c
told $? 'the program eliminate compiles' "$report"
to_the_end "$work/eliminate"
