## Modules by their contents, whatever the times of their files say; builds of one folder wait for
## each other; what killed ones left is swept.

function test_builds ()
  folder = tempname ();
  mkdir (folder);
  copyfile (fullfile (fileparts (which ("gsmbp_hand")), "motor_pendulum.*"), folder);
  shared = fileparts (fileparts (fileparts (gsmbp_hand ("motor_pendulum").file)));
  build = @() gsmbp_build ("motor_pendulum", "directory", folder, "build", shared);
  unwind_protect
    by_contents (build, fullfile (folder, "motor_pendulum.f"));
    in_turn (build);
    folders (folder);
  unwind_protect_cleanup
    confirm_recursive_rmdir (false, "local");
    rmdir (folder, "s");
  end_unwind_protect
end

function by_contents (build, source)
  m = build ();
  first = stat (m.file);
  system (sprintf ("touch -d '1 hour' '%s'", source));
  gsmbp_check ("a source that says the same is not compiled again", ...
               stat (build ().file).ino == first.ino);
  text = fileread (source);
  put (source, strrep (text, "PAR(1) = 9.81D0", "PAR(1) = 1.62D0"));
  system (sprintf ("touch -d '2000-01-01' '%s'", source));
  gsmbp_check ("one that says something else is, whatever its time", build ().par.g == 1.62);
  put (source, text);
  gsmbp_check ("and back", build ().par.g == 9.81);
  m = build ();
  delete (m.file);   # this session has it loaded
  put (m.file, "cut short");
  gsmbp_check ("a module that is not what was built is built again", ...
               stat (build ().file).size == first.size);
end

function in_turn (build)
  m = build ();
  here = fileparts (m.file);
  mkdir (fullfile (here, ".new-1-1"));
  put (fullfile (here, ".new-1-1", "scene_f.o"), "left by a build that was killed");
  file = @(name) fullfile (m.directory, name);
  system (sprintf (["flock '%s' sh -c 'until [ -e %s ]; do sleep 0.05; done; touch %s' " ...
                   ">/dev/null 2>&1 &"], ...
                   fullfile (here, "lock"), file ("let_go"), file ("free")));
  pause (0.5);
  build ();
  gsmbp_check ("what is there waits for nobody", isempty (stat (file ("free"))));
  delete (m.file);
  system (sprintf ("(sleep 1; touch %s) >/dev/null 2>&1 &", file ("let_go")));
  build ();
  gsmbp_check ("a build waits for another", ! isempty (stat (file ("free"))));
  gsmbp_check ("what a killed build left is swept", ...
               isempty (glob (fullfile (here, ".new-*"))));
  child = sprintf (["addpath (\"%s\"); gsmbp_build (\"motor_pendulum\", \"directory\", \"%s\", " ...
                    "\"build\", \"%s\");"], fileparts (which ("gsmbp_build")), m.directory, ...
                   fileparts (fileparts (here)));
  delete (m.file);
  [in, out, pid] = popen2 ("octave-cli", {"-qf", "--eval", child});
  build ();
  built = stat (m.file).ino;
  [~, status] = waitpid (pid);
  gsmbp_check ("two at once: both are well", status == 0 && build ().par.g == 9.81);
  gsmbp_check ("and one of them compiled", stat (m.file).ino == built);
end

## two sessions make the same new folders
function folders (folder)
  here = fileparts (fileparts (which ("gsmbp_build")));
  make = sprintf (["addpath (\"%s/octave\"); while (isempty (stat (\"%s/go\"))), end, " ...
                   "for k = 1:200, gs.files.make_folder (\"x\", " ...
                   "sprintf (\"%s/%%d/a/b/c\", k)); end, exit (0)"], here, folder, folder);
  for k = 1:2
    [~, ~, pid(k)] = popen2 ("octave-cli", {"-qf", "--eval", make});
  end
  pause (1);
  put (fullfile (folder, "go"), "");
  [~, status] = arrayfun (@waitpid, pid);
  gsmbp_check ("two at once make the same folders", ! any (status));
end

function put (file, text)
  f = fopen (file, "w");
  fputs (f, text);
  fclose (f);
end
