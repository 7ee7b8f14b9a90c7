## [jobs, made] = speed_rivals (s, peers, cap): the rivals on system S, as jobs for driver.c, from the environment that rivals/setup made in PEERS.
##
## made: struct array with who, mode, word, cpu (seconds of derivation), operations (mul add div sqrt trig), compile (seconds, of all its words);
## No rival for loops. cpu = Inf where the CAP in seconds was not enough. SymPy gets no chain longer than one of its kind that it failed on.

function [jobs, made] = speed_rivals (s, peers, cap)
  persistent given_up = struct ();
  n = s.n;
  jobs = speed_job ();
  made = struct ("who", {}, "mode", {}, "word", {}, "cpu", {}, "operations", {}, "compile", {});
  if (s.loop)
    return;
  end
  here = fileparts (mfilename ("fullpath"));
  python = sprintf ("PYTHONHASHSEED=0 '%s' -W ignore '%s'", fullfile (peers, "venv", "bin", "python"), fullfile (fileparts (here), "rivals", "sympy_kane.py"));
  kind = regexprep (s.name, '\d.*', "");
  for one = {"casadi", sprintf("'%s'", fullfile (peers, "casadi")); "sympy", python}'
    who = one{1};
    for mode = {"lit", "num"}
      m = mode{1};
      folder = fullfile (s.folder, [who "_" m]);
      [~, ~] = mkdir (folder);
      limit = Inf;
      if (isfield (given_up, [who kind m]))
        limit = given_up.([who kind m]);
      end
      if (n >= limit)
        continue;
      end
      [~, text, status] = speed_cpu (sprintf ("ulimit -t %d; %s '%s' %s '%s' 2>'%s/log'", cap, one{2}, s.model, m, folder, folder));
      if (status != 0)
        given_up.([who kind m]) = n;
      end
      words = regexp (text, '^(id|fd|mm) ([^\n]*)$', "tokens", "lineanchors");
      library = fullfile (folder, "rival.so");
      compile = 0;
      if (! isempty (words))
        sources = sprintf (" '%s'", cellfun (@(w) fullfile (folder, [w{1} ".c"]), words, "UniformOutput", false){:}, fullfile (folder, "par.c"));
        compile = speed_cpu (sprintf ("gcc -O3 -march=native -fno-semantic-interposition -shared -fPIC %s -o '%s' -lm -Wl,-Bsymbolic", sources, library));
      end
      for w = words
        numbers = str2num (w{1}{2});
        made(end+1) = struct ("who", who, "mode", m, "word", w{1}{1}, "cpu", numbers(1), "operations", numbers(2:6), "compile", compile);
        jobs(end+1) = speed_job (who, m, w{1}{1}, library, "-", w{1}{1}, {n, n^2}{1 + strcmp(w{1}{1}, "mm")});
      end
      for w = setdiff ({"id", "fd", "mm"}, cellfun (@(w) w{1}, words, "UniformOutput", false))
        made(end+1) = struct ("who", who, "mode", m, "word", w{1}, "cpu", Inf, "operations", NaN (1, 5), "compile", 0);
      end
    end
  end
  for one = {"pinocchio", "pinocchio", "id", "id"; "pinocchio", "pinocchio", "fd", "fd"; "pinocchio_local", "pinocchio", "fd", "fd_local"; "pinocchio_mass", "pinocchio", "fd", "fd_mass"
             "pinocchio", "pinocchio", "mm", "mm"; "mujoco", "mujoco", "id", "id"; "mujoco", "mujoco", "fd", "fd"; "mujoco_lean", "mujoco", "id", "id_lean"; "mujoco_lean", "mujoco", "fd", "fd_lean"}'
    jobs(end+1) = speed_job (one{1}, "num", one{3}, fullfile (peers, [one{2} ".so"]), s.model, one{4}, {n, n^2}{1 + strcmp(one{3}, "mm")});
  end
end
