## m = example_model (NAME): the model of examples/NAME, as `make examples` builds it.

function m = example_model (name)
  root = fullfile (fileparts (mfilename ("fullpath")), "..", "..");
  [status, text] = system (sprintf ("make --no-print-directory -C '%s' fortran_out/%s.f", root, ...
                                    name));
  gsmbp_check (["examples/" name " is derived"], status == 0);
  if (status != 0)
    error ("%s", text);
  end
  m = gsmbp_build (name);
end
