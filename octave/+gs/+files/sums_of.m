## sums = gs.files.sums_of (files)
## Sums of the contents of FILES (cell array of names).  A file is read again only where it is
## another one than when this session read it: by number, size and times, which tell nothing of a
## file that was changed in the last seconds before.

function sums = sums_of (files)
  persistent names marks known
  if (isempty (names))
    names = known = cell (0, 1);
    marks = zeros (5, 0);
  endif
  mark = marks_of (files);
  [there, place] = ismember (files, names);
  same = there;
  same(there) = all (marks(:,place(there)) == mark(:,there), 1);
  sums = cell (size (files));
  sums(same) = known(place(same));
  sums(! same) = cellfun (@(file) hash ("md5", fileread (file)), files(! same), ...
                          "UniformOutput", false);
  place(! there) = numel (names) + (1:sum (! there));
  names(place) = files;
  marks(:,place) = mark;
  known(place) = sums;
endfunction

## [number; disk; size; times] of each, no numbers where the file is new or not there
function mark = marks_of (files)
  mark = NaN (5, numel (files));
  s = cellfun (@stat, files, "UniformOutput", false);
  there = ! cellfun ("isempty", s);
  s = [s{there}];
  if (! isempty (s))
    mark(:,there) = [[s.ino]; [s.dev]; [s.size]; [s.mtime]; [s.ctime]];
    mark(:, any (mark(4:5,:) > time () - 3, 1)) = NaN;
  endif
endfunction
