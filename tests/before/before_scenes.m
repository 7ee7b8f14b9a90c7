## scenes = before_scenes (root, pattern)
## List the scenes of tests/scenes and examples in the folder ROOT whose names hold PATTERN: a row
## of structs with name (those of the examples begin with "examples/"), file and folder, where the
## derived scene is.

function scenes = before_scenes (root, pattern)
  work = getenv ("GSMBP_TEST_DIR");
  of_tests = glob (fullfile (root, "tests", "scenes", "*.mac"));
  of_examples = glob (fullfile (root, "examples", "*", "*.mac"));
  scenes = [listed("", of_tests, fullfile (work, "fortran_out")), ...
            listed("examples/", of_examples, fullfile (work, "examples"))];
  scenes = scenes(! cellfun (@isempty, strfind ({scenes.name}, pattern)) | isempty (pattern));
end

function scenes = listed (before, files, folder)
  [~, names] = cellfun (@fileparts, files', "UniformOutput", false);
  scenes = struct ("name", strcat (before, names), "file", names, "folder", folder);
end
