## m = gsmbp_hand (NAME, OPTIONS): a model written by hand by the contract of the emitted Fortran
## (the files beside this one), for tests: motor_pendulum, hand_crank, hand_fourbar.  Its modules go
## below GSMBP_TEST_DIR, or where that is not set into a folder that ends with the session.

function m = gsmbp_hand (name, varargin)
  folder = getenv ("GSMBP_TEST_DIR");
  if (isempty (folder))
    folder = session_folder ();
  endif
  m = gsmbp_build (name, "directory", fileparts (mfilename ("fullpath")), "build", ...
                   fullfile (folder, "fortran_out", "build"), varargin{:});
endfunction

## at the end of the session there are only built-in functions
function folder = session_folder ()
  persistent path guard
  if (isempty (path))
    path = tempname ();
    guard = onCleanup (@() {confirm_recursive_rmdir(false), rmdir(path, "s")});
  endif
  folder = path;
endfunction
