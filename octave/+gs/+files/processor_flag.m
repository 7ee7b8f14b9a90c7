## option = gs.files.processor_flag ()
## The option of the compilers for the processor that the code is to run on: this one, or the one
## that the environment variable GSMBP_MARCH names ("x86-64-v3").

function option = processor_flag ()
  name = getenv ("GSMBP_MARCH");
  if (isempty (name))
    name = "native";
  endif
  if (isempty (regexp (name, '^[\w.+-]+$', "once")))   # it goes to a shell
    error (["gsmbp_build: GSMBP_MARCH: expected the name of a processor for option -march of " ...
            "the compiler, such as x86-64-v3; found \"%s\"; unsetenv (\"GSMBP_MARCH\") " ...
            "compiles for this processor"], name);
  endif
  option = [" -march=" name];
endfunction
