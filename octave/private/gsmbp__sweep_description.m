## text = gsmbp__sweep_description (who, option, file)
## What the finished table of a sweep in FILE says of itself (gsmbp__sweep_told); an error of WHO
## about its OPTION where it is no such table.

function text = gsmbp__sweep_description (who, option, file)
  text = "";
  try
    w = load ("-hdf5", file);
    text = sprintf ("%s\n", cellstr (w.description){:});
  catch
    error ("%s: option %s: %s is no table of a sweep", who, option, file);
  end_try_catch
endfunction
