## [m, ref, tab] = gsmbp_case (NAME): a reference case of tests/data: m = ne_read of its spec.json
## (if asked for), ref = its reference.json, tab = its reference.csv, one column vector a field
## (absent columns: empty struct).

function [m, ref, tab] = gsmbp_case (name)
  here = fileparts (mfilename ("fullpath"));
  addpath (fullfile (here, "independent"));
  folder = fullfile (here, "..", "data", name);
  m = [];
  ## 17a has none
  if (isargout (1) && ! isempty (strfind (fileread (fullfile (folder, "spec.json")), '"bodies"')))
    m = ne_read (fullfile (folder, "spec.json"));
  end
  ref = jsondecode (fileread (fullfile (folder, "reference.json")), "makeValidName", false);
  tab = struct ();
  table = fullfile (folder, "reference.csv");
  if (exist (table, "file"))
    lines = strsplit (strtrim (fileread (table)), "\n");
    names = strsplit (lines{1}, ",");
    values = str2double (vertcat (cellfun (@(line) strsplit (line, ","), lines(2:end), ...
                                    "UniformOutput", false){:}));
    for k = 1:numel (names)
      tab.(names{k}) = values(:, k);
    end
  end
end
