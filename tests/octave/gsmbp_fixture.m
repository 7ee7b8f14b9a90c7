## m = gsmbp_fixture (NAME, ...): the model of tests/scenes/NAME.mac, derived by the test runner and compiled once; options as of gsmbp_build.

function m = gsmbp_fixture (name, varargin)
  m = gsmbp_build (name, "directory", fullfile (getenv ("GSMBP_TEST_DIR"), "fortran_out"), varargin{:});
end
