## e = speed_errors (s, jobs, kinds, count): relative errors (2-norm) of the torques, accelerations
## and Jacobians of the jobs against the quad build.
##
## e: struct array with kind (of the states), who, mode, word, median, worst. who = "newton_euler":
## the quad build itself against newton_euler.c, on fewer states where the system is large.

function e = speed_errors (s, jobs, kinds, count)
  jobs = jobs(ismember ({jobs.word}, {"id", "fd", "jac"}));
  check = jobs(strcmp ({jobs.mode}, "quad"));
  jobs = jobs([find(strcmp ({jobs.mode}, "quad")), find(! strcmp ({jobs.mode}, "quad"))]);
  library = newton_euler (fileparts (s.folder));
  for word = {"id", "fd"}(! s.loop & [1 1])
    check(end+1) = speed_job ("newton_euler", "quad", word{1}, library, s.model, word{1}, 2 * s.n);
  end
  e = struct ("kind", {}, "who", {}, "mode", {}, "word", {}, "median", {}, "worst", {});
  for kind = kinds
    X = speed_states (s, kind{1}, count);
    e = [e, compared(kind{1}, jobs, speed_run (s, X, jobs, "values"), s.n), ...
         compared(kind{1}, check, speed_run (s, X(:,:,1:ceil (count / s.n^2)), check, "values"), ...
                  s.n)];
  end
end

## the first jobs, the quad builds of ours, are the truth: as much again behind the numbers is what
## is left of them; of JAC the rivals have the rows of the accelerations alone
function e = compared (kind, jobs, values, n)
  e = struct ("kind", {}, "who", {}, "mode", {}, "word", {}, "median", {}, "worst", {});
  truth = strcmp ({jobs.who}, "gsmbp") & strcmp ({jobs.mode}, "quad");
  for k = find (! truth)
    exact = values{find (truth & strcmp ({jobs.word}, jobs(k).word), 1)};
    m = rows (exact) / 2;
    rest = exact(m+1:end,:);
    exact = exact(1:m,:);
    if (rows (values{k}) < m)
      here = reshape (1:m, 2 * n, 2 * n)(n+1:end,:)(:);
      [exact, rest] = deal (exact(here,:), rest(here,:));
    end
    d = values{k}(1:rows (exact),:) - exact - rest;
    if (strcmp (jobs(k).mode, "quad"))
      d = values{k}(1:m,:) - exact + (values{k}(m+1:end,:) - rest);
    end
    r = norm (d, "columns") ./ norm (exact, "columns");
    e(end+1) = struct ("kind", kind, "who", jobs(k).who, "mode", jobs(k).mode, "word", ...
                       jobs(k).word, "median", median (r), "worst", max (r));
  end
end

function library = newton_euler (folder)
  source = fullfile (fileparts (mfilename ("fullpath")), "newton_euler.c");
  library = fullfile (folder, "newton_euler.so");
  if (! exist (library, "file") || stat (library).mtime < stat (source).mtime)
    speed_cpu (sprintf ("gcc -O2 -shared -fPIC '%s' -o '%s' -lquadmath", source, library));
  end
end
