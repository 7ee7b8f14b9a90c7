## back = without_mpi ()
## Programs of sweeps are built without MPI, as on a machine that has none, until BACK is cleared.

function back = without_mpi ()
  before = getenv ("MPI");
  setenv ("MPI", "no");
  back = onCleanup (@() setenv ("MPI", before));
end
