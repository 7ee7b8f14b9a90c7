## text = gs.sweep.job_text (records)
## The bytes of a job (glue/sweep_files.h).  RECORDS: a row for each, name and value: a text, or
## numbers, column by column.

function text = job_text (records)
  text = "";
  for k = 1:rows (records)
    [name, x] = records{k,:};
    if (ischar (x))
      text = [text, sprintf("%s s %d\n", name, numel (x)), x(:)', "\n"];
    else
      text = [text, sprintf("%s d %d\n", name, numel (x)), ...
              char(typecast (double (x(:)'), "uint8")), "\n"];
    endif
  endfor
  text = [text, sprintf("end s 0\n\n")];
endfunction
