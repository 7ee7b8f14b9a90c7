## [jobs, made] = speed_rivals (s, peers, cap): the rivals on system S, as jobs for driver.c, from
## the environment that rivals/setup made in PEERS.
##
## made: struct array with who, mode, word, cpu (seconds of derivation), operations (mul add div
## sqrt trig), compile (seconds, of all its words); cpu = Inf where CAP seconds were not enough. A
## chain longer than one of its kind that was stopped is not tried. No rival for loops.

function [jobs, made] = speed_rivals (s, peers, cap)
  persistent stopped = struct ();
  jobs = speed_job ();
  made = struct ("who", {}, "mode", {}, "word", {}, "cpu", {}, "operations", {}, "compile", {});
  if (s.loop)
    return;
  end
  script = fullfile (fileparts (fileparts (mfilename ("fullpath"))), "rivals", "sympy_kane.py");
  casadi = sprintf ("'%s'", fullfile (peers, "casadi"));
  sympy = sprintf ("PYTHONHASHSEED=0 '%s' -W ignore '%s'", ...
                   fullfile (peers, "venv", "bin", "python"), script);
  for one = {"casadi", casadi, "lit"; "casadi", casadi, "num"; "sympy", sympy, "lit"; "sympy", ...
             sympy, "num"}'
    chain = [one{1} one{3} regexprep(s.name, '\d.*', "")];
    if (isfield (stopped, chain) && s.n >= stopped.(chain))
      continue;
    end
    [more, of_it, complete] = derived (s, one{:}, cap);
    jobs = [jobs, more];
    made = [made, of_it];
    if (! complete)
      stopped.(chain) = s.n;
    end
  end
  for one = ...
      {"pinocchio", "pinocchio", "id", "id"; "pinocchio", "pinocchio", "fd", "fd"; ...
       "pinocchio_local", "pinocchio", "fd", "fd_local"
             "pinocchio_mass", "pinocchio", "fd", "fd_mass"; "pinocchio", "pinocchio", "mm", "mm"
             "pinocchio", "pinocchio", "jac", "jac"
             "mujoco", "mujoco", "id", "id"; "mujoco", "mujoco", "fd", "fd"; "mujoco_lean", ...
                 "mujoco", "id", "id_lean"; "mujoco_lean", "mujoco", "fd", "fd_lean"}'
    jobs(end+1) = speed_job (one{1}, "num", one{3}, fullfile (peers, [one{2} ".so"]), s.model, ...
                             one{4}, outputs (s, one{3}));
  end
end

## a rival that writes C code: COMMAND model mode folder prints for each word: CPU seconds, mul,
## add, div, sqrt, trig
function [jobs, made, complete] = derived (s, who, command, mode, cap)
  jobs = speed_job ();
  made = struct ("who", {}, "mode", {}, "word", {}, "cpu", {}, "operations", {}, "compile", {});
  folder = fullfile (s.folder, [who "_" mode]);
  [~, ~] = mkdir (folder);
  [~, text, status] = speed_cpu (sprintf ("ulimit -t %d; %s '%s' %s '%s' 2>'%s/log'", cap, ...
                                   command, s.model, mode, folder, folder));
  complete = status == 0;
  words = regexp (text, '^(id|fd|mm|jac) ([^\n]*)$', "tokens", "lineanchors");
  library = fullfile (folder, "rival.so");
  if (! isempty (words))
    sources = sprintf (" '%s'", ...
                       cellfun (@(w) fullfile (folder, [w{1} ".c"]), words, "UniformOutput", ...
                                false){:}, fullfile (folder, "par.c"));
    compile = speed_cpu (sprintf (["gcc -O3 -march=native -fno-semantic-interposition -shared " ...
                                   "-fPIC %s -o " ...
                                   "'%s' -lm -Wl,-Bsymbolic"], sources, library));
  end
  for w = words
    numbers = str2num (w{1}{2});
    made(end+1) = struct ("who", who, "mode", mode, "word", w{1}{1}, "cpu", numbers(1), ...
                          "operations", numbers(2:6), "compile", compile);
    jobs(end+1) = speed_job (who, mode, w{1}{1}, library, "-", w{1}{1}, outputs (s, w{1}{1}));
  end
  for w = setdiff ({"id", "fd", "mm", "jac"}, {made.word})
    made(end+1) = struct ("who", who, "mode", mode, "word", w{1}, "cpu", Inf, "operations", ...
                          NaN (1, 5), "compile", 0);
  end
end

function k = outputs (s, word)
  k = s.n ^ (1 + any (strcmp (word, {"mm", "jac"}))) * (1 + strcmp (word, "jac"));
end
