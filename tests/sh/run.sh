# A whole run in C (share/engine/host/run): an oscillator against closed forms by all methods, and
# every refusal, under the sanitizers; in quad precision, too.
. tests/tools/check.sh
work_folder
headers_in_cplusplus host/run/run.h
for kind in sane quad; do
  engine_program $kind "$work/$kind" tests/c/host/run.c
  told $? "the program compiles, $kind" "$report"
  to_the_end "$work/$kind"
done
