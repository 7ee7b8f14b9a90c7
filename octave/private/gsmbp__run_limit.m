## value = gsmbp__run_limit (name)
## Return a limit of runs (share/c/gsmbp/limits.h).

function value = gsmbp__run_limit (name)
  persistent limits = [gsmbp__run_table("GS_LIMITS")(:,1), ...
                       num2cell(str2double (gsmbp__run_table ("GS_LIMITS")(:,2)))]'(:)';
  value = struct (limits{:}).(name);
endfunction
