# A sweep that is killed at three instants and goes on (make test-sweep: at 30)
exec tests/tools/sweep_kills 3 1
