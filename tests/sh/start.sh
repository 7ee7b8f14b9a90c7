# How a run starts, in C (share/engine/host): a particle on a circle against closed forms, under the
# sanitizers; make test-whole: in quad precision, too.
. tests/tools/check.sh
work_folder
headers_in_cplusplus host/start.h host/failure.h
for kind in sane $(whole && echo quad); do
  engine_program $kind "$work/$kind" tests/c/host/start.c
  told $? "the program compiles, $kind" "$report"
  to_the_end "$work/$kind"
done
