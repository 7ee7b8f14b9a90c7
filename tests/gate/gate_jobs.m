## gate_jobs (scenes, folder)
## Write into FOLDER the runs of tests/gate: for each of the SCENES (before_scenes) NAME.dp853 and
## NAME.rk4, what the run time gets from gsmbp_simulate, lines "WORD COUNT NUMBERS"; "quad" is the
## last state of the same run in quad precision, by dp853 with a tolerance of 1e-18. The
## compilers and their options are in the file flags.

function gate_jobs (scenes, folder)
  write_flags (folder);
  for scene = scenes
    [m, given] = before_model (scene);
    exact = before_model (scene, "precision", "quad");
    runs = before_plan (m, given);
    for run = runs(ismember ({runs.name}, {"dp853 -", "rk4 -"}))
      write_job (m, exact, run, fullfile (folder, [scene.file "." run.method]));
    end
  end
end

function write_job (m, exact, run, file)
  times = 0:0.01:0.5;
  options = run.problem;
  if (m.sizes.nlam > 0)
    options = [{"start", "project"}, options];
  end
  a = arguments_of (m, run.x0, times, [options, {"method", run.method}]);
  method = {"method", "rk4"};   # the same steps
  if (strcmp (run.method, "dp853"))
    method = {"rtol", 1e-18, "atol", 1e-20 * m.nominal};
  end
  job = m.module ("job", a{:});
  first = m.module ("prepare", a{:});
  job.x0 = first.x;
  q = gsmbp_simulate (exact, job.x0, times, options{:}, method{:});
  job = [[fieldnames(job), struct2cell(job)]; {"tout", times; "quad", q.x(end,:)
                                               "nominal", m.nominal}]';
  f = fopen (file, "w");
  for field = job
    fprintf (f, "%s %d", field{1}, numel (field{2}));
    fprintf (f, " %.17g", field{2});
    fprintf (f, "\n");
  end
  fclose (f);
end

## what gsmbp_simulate calls the module with
function a = arguments_of (m, x0, times, options)
  global gate_arguments
  module = m.module;
  m.module = @(varargin) forwarded (module, varargin{:});
  gsmbp_simulate (m, x0, times, options{:});
  a = gate_arguments;
end

function varargout = forwarded (module, varargin)
  global gate_arguments
  if (strcmp (varargin{1}, "run"))
    gate_arguments = varargin(2:end);
  end
  [varargout{1:nargout}] = module (varargin{:});
end

function write_flags (folder)
  [scene, common, c] = gs.model.fortran_flags ("double");
  words = {"fc", gs.files.mkoctfile_word("F77"); "cc", gs.files.mkoctfile_word("CC"); "scene", scene
           "common", common; "c", c}';
  f = fopen (fullfile (folder, "flags"), "w");
  fprintf (f, "%s %s\n", words{:});
  fclose (f);
end
