## text = gs.sweep.read_description (who, option, file)
## What the finished table of a sweep in FILE says of itself (gs.sweep.describe_sweep); an error of
## WHO about its OPTION where it is no such table.

function text = read_description (who, option, file)
  text = "";
  try
    w = load ("-hdf5", file);
    text = sprintf ("%s\n", cellstr (w.description){:});
  catch
    error ("%s: option %s: %s is no table of a sweep", who, option, file);
  end_try_catch
endfunction
