## m = gsmbp_hand (NAME, OPTIONS): a model written by hand by the contract of the emitted Fortran
## (tests/octave/fixture): motor_pendulum, hand_crank, hand_fourbar.

function m = gsmbp_hand (name, varargin)
  here = fileparts (mfilename ("fullpath"));
  folder = getenv ("GSMBP_TEST_DIR");
  if (isempty (folder))
    folder = fileparts (fileparts (here));
  end
  m = gsmbp_build (name, "directory", fullfile (here, "fixture"), "build", ...
                   fullfile (folder, "fortran_out", "build"), varargin{:});
end
