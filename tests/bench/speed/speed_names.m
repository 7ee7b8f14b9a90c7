## names = speed_names (bench): the systems of the folder systems/ of BENCH, or those of
## BENCH_SYSTEMS; by family and size, the hard ones last.

function names = speed_names (bench)
  names = strsplit (strtrim (getenv ("BENCH_SYSTEMS")));
  if (! isempty (names{1}))
    return;
  end
  [~, names] = cellfun (@fileparts, glob (fullfile (bench, "systems", "*.mac"))', ...
                        "UniformOutput", false);
  names = names(! strncmp (names, "ladder", 6));    # of the bench of the loops
  [~, order] = sort (cellfun (@key, names, "UniformOutput", false));
  names = names(order);
end

## arms, general chains, planar chains, others, hard ones
function text = key (name)
  kind = regexp (name, '^[a-z]+', "match", "once");
  family = [find(strcmp (kind, {"puma", "spat", "pend"})), 4](1);
  if (any (name == "_"))
    family = 5;
  end
  text = sprintf ("%d%s%03d%s", family, kind, ...
                  str2double (["0" regexp(name, '\d+', "match", "once")]), name);
end
