## [seconds, text, status] = speed_cpu (command): processor seconds of a shell command and what it
## wrote; without status asked for, failing is an error.

function [seconds, text, status] = speed_cpu (command)
  [status, text] = system (sprintf ("{ %s\n} 2>&1; code=$?; times; exit $code", command));
  if (status != 0 && nargout < 3)
    error ("bench: %s\n%s", command, text);
  end
  spent = regexp (text, '(\d+)m([\d.]+)s\s+(\d+)m([\d.]+)s\s*$', "tokens"){1};
  seconds = [60 1 60 1] * str2double (spent)(:);
  text = regexprep (text, '(\d+m[\d.]+s\s*){4}$', "");
end
