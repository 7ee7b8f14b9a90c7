## m = gsmbp_fixture (NAME, ...): the model of tests/scenes/NAME.mac, derived (by the test runner,
## or here) and compiled once; options as of gsmbp_build.

function m = gsmbp_fixture (name, varargin)
  folder = fullfile (getenv ("GSMBP_TEST_DIR"), "fortran_out");
  if (! exist (fullfile (folder, [name ".json"]), "file"))
    scenes = fullfile (fileparts (fileparts (mfilename ("fullpath"))), "scenes");
    gsmbp_derive (fullfile (scenes, [name ".mac"]), folder);
  end
  m = gsmbp_build (name, "directory", folder, varargin{:});
end
