# A sweep that is killed at instants by chance and goes on (make test-sweep: at 30 instants)
exec tests/tools/sweep_kills 3 "$(($(date +%s) / 86400))"
